"""Complex-number synthesis for four positions (Kaufman)."""

from mpmath import mp, mpf

from ..centerpoint import circlepoint_curve
from ..evaluate import Angle, NoValue
from .draw import cis, length, point, radians
from .filemon1970 import branches


def compatibility_triangle(rng):
    base, third, fourth = point(rng), length(rng), length(rng)
    side = abs(base)
    if not abs(third - fourth) < side < third + fourth:
        raise NoValue("no triangle")
    foot = (side**2 + third**2 - fourth**2) / (2 * side)
    # To the right of the base.
    apex = base / side * (foot - 1j * mp.sqrt(third**2 - foot**2))
    turned = apex, base - apex
    image = (mp.conj(apex / base) * base,)
    other = image[0], base - image[0]
    turns = [radians(rng) for _ in range(2)]
    before = [z * cis(-g) for z, g in zip(turned, turns)]
    symbols = {"Delta": base, "mu": Angle(mp.arg(base))}
    for name, was, one, two in zip("34", before, turned, other):
        symbols |= {f"Delta_{name}": was, f"mu_{name}": Angle(mp.arg(was)), f"gamma_{name}": Angle(mp.arg(one / was)),
                    f"gamma_{name}'": Angle(mp.arg(two / was))}
    symbols |= {"theta_3": Angle(abs(mp.arg(apex / base))), "theta_4": Angle(abs(mp.arg((base - apex) / base)))}
    return symbols


def circuits(rng):
    """W (e^(i beta_j) - 1) + Z (e^(i alpha_j) - 1) = delta_j, j = 2, 3, 4, has a solution where a determinant vanishes."""
    turns = [radians(rng) for _ in range(3)]
    ways = [point(rng) for _ in range(3)]
    rows = [(cis(g) - 1, d) for g, d in zip(turns, ways)]

    def minor(p, q):
        return p[0] * q[1] - q[0] * p[1]

    parts = [minor(rows[1], rows[2]), -minor(rows[0], rows[2]), minor(rows[0], rows[1])]
    parts.insert(0, -sum(parts))
    r1, r2, r3, r4 = map(abs, parts)
    flat = 2 * sum(abs(r1 - r2) < x < r1 + r2 for x in (r3 + r4, abs(r3 - r4)))
    positions = [(mpf(1), mpf(0), mpf(0), mpf(0))] + [(mp.cos(g), mp.sin(g), d.real, d.imag) for g, d in zip(turns, ways)]
    symbols = dict(zip(("R_1", "R_2", "R_3", "R_4"), (r1, r2, r3, r4)))
    return symbols | {"N": mpf(flat), "B": mpf(branches(circlepoint_curve(positions)))}


SCENES = {"kaufman/compatibility-triangle": compatibility_triangle, "kaufman/circuits": circuits}
