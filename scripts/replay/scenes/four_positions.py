"""Four positions of a plane and a point whose places are on a circle (Tesar, chapter III)."""

from mpmath import mp, mpf

from ..evaluate import Angle, NoValue
from .draw import cis, length, number, point, radians, unit


def circle(symbols, rng, center, radius):
    q0 = number(rng)
    symbols |= {"Q_0": q0, "Q_1": -q0 * center.real, "Q_2": -q0 * center.imag, "Q_3": q0 * (abs(center) ** 2 - radius**2)}


def bound(z, places, turns):
    """Position j carries z to its place; position 0 is the identity."""
    symbols = {"x": z.real, "y": z.imag, "phi_0": Angle(0), "a_0": mpf(0), "b_0": mpf(0)}
    for j, (w, phi) in enumerate(zip(places, turns), 1):
        a = w - cis(phi) * z
        symbols |= {f"phi_{j}": Angle(phi), f"a_{j}": a.real, f"b_{j}": a.imag}
    return symbols


def circlepoint(rng):
    center, radius = point(rng), length(rng)
    z, *places = (center + radius * unit(rng) for _ in range(4))
    symbols = bound(z, places, [radians(rng) for _ in range(3)])
    circle(symbols, rng, center, radius)
    symbols |= {"X": center.real, "Y": center.imag}
    for j, w in enumerate(places, 1):
        symbols |= {f"D_{j}": abs(w) ** 2 - abs(z) ** 2, f"E_{j}": 2 * (w - z).real, f"F_{j}": 2 * (w - z).imag}
    return symbols


def three_places(rng):
    center, radius = point(rng), length(rng)
    places = [center + radius * unit(rng) for _ in range(3)]
    symbols = bound(point(rng), places, [radians(rng) for _ in range(3)])
    circle(symbols, rng, center, radius)
    return symbols


def on_a_line(rng):
    """The moving origin stays on the X-axis and the point z on a circle; the way a follows from the turn."""
    center, z = point(rng, 3), point(rng, 3)
    radius = abs(z - center)
    symbols = {"x": z.real, "y": z.imag}
    d, f = {}, {}
    for j in (1, 2, 3):
        phi = radians(rng)
        w = cis(phi) * z
        square = radius**2 - (w.imag - center.imag) ** 2
        if square <= 0:
            raise NoValue("out of reach")
        a = center.real + rng.choice((1, -1)) * mp.sqrt(square) - w.real
        g, h = 2 * a * mp.cos(phi), 2 * a * mp.sin(phi)
        m, n = 1 - mp.cos(phi), -mp.sin(phi)
        symbols |= {f"phi_{j}": Angle(phi), f"a_{j}": a, f"g_{j}": g, f"h_{j}": h, f"m_{j}": m, f"n_{j}": n}
        # D = a^2 + g x - h y, F = -2 n x - 2 m y as coefficients of 1, x, y.
        d[j], f[j] = (a * a, g, -h), (mpf(0), -2 * n, -2 * m)
    for k in (1, 2, 3):
        i, j = k % 3 + 1, (k + 1) % 3 + 1
        part = product(d[i], f[j]), product(f[i], d[j])
        for name, key in zip("RSTUV", ("xx", "yy", "xy", "y", "x")):
            symbols[f"{name}_{k}"] = (part[0][key] - part[1][key]) / -2
    return symbols


def product(p, q):
    """Of two linear forms in 1, x, y."""
    return {"xx": p[1] * q[1], "yy": p[2] * q[2], "xy": p[1] * q[2] + p[2] * q[1],
            "x": p[0] * q[1] + p[1] * q[0], "y": p[0] * q[2] + p[2] * q[0]}


SCENES = {
    "tesar1964/circlepoint": circlepoint,
    "tesar1964/three-places-on-a-circle": three_places,
    "tesar1964/positions-on-a-line": on_a_line,
}
