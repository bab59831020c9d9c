"""The five-bar MPFQN and the focal mechanism (Wunderlich 1968)."""

from mpmath import mp, mpc, mpf

from ..evaluate import Angle, NoValue
from .draw import cis, cross, dot, length, number, point, unit


class FiveBar:
    """M in the origin, N at d; F = u (m - p w) = d + v (n + q w): the angles MPF and FQN add up to a half turn."""

    def __init__(self, rng, bars):
        self.m, self.n, self.p, self.q = bars
        self.u, self.v, self.w = (unit(rng) for _ in range(3))
        base = self.u * (self.m - self.p * self.w) - self.v * (self.n + self.q * self.w)
        # The whole is turned so that the base lies on the x-axis.
        self.d = abs(base)
        self.u, self.v = (x * mp.conj(base) / self.d for x in (self.u, self.v))
        self.f = self.u * (self.m - self.p * self.w)

    def rest(self):
        """s, from both squared distances of F, which are linear in the cosine of the angle."""
        part = self.m * self.p
        return part * self.d / (part + self.n * self.q)


def five_bar(rng):
    bars = [length(rng) for _ in range(4)]
    b = FiveBar(rng, bars)
    # S: |F - s|^2 does not depend on the angle; two angles of the chain decide it.
    first, second = ((b.m**2 + b.p**2 - 2 * b.m * b.p * c, b.n**2 + b.q**2 + 2 * b.n * b.q * c) for c in (mpf(0), mpf(1)))
    # (1 - s/d)|z|^2 + (s/d)|z - d|^2 alike for both.
    alpha, beta = first[0] - second[0], first[1] - second[1]
    s = b.d * alpha / (alpha - beta)
    symbols = {"m": b.m, "p": b.p, "q": b.q, "n": b.n, "d": b.d, "M": mpc(0), "N": mpc(b.d), "P": b.m * b.u, "Q": b.d + b.n * b.v}
    symbols |= {"F": b.f, "z": b.f, "phi": Angle(mp.arg(b.u)), "psi": Angle(mp.arg(b.v)), "omega": Angle(mp.arg(b.w))}
    return symbols | {"u": b.u, "v": b.v, "w": b.w, "s": s, "r": abs(b.f - s), "MS": s, "NS": s - b.d}


def completion(rng):
    """p q from the arms, p^2 + q^2 from the bridge |p u + q v| = |PQ| in one position of the four-bar."""
    a, b, ratio = length(rng), length(rng), number(rng)
    u = unit(rng)
    # Now and then a short coupler, for which some ratios are impossible.
    v, n = (unit(rng), point(rng)) if rng.random() < 0.5 else (u * cis(mpf(rng.randint(1, 500)) / 1000), point(rng, 1))
    d = abs(n)
    u, v = (x * mp.conj(n) / d for x in (u, v))
    c = abs(a * u - b * v - d)
    m, k = a / ratio, b / ratio
    # The coefficients of cos(phi - psi) in |m u - k v - d|^2, freed of the closure of the four-bar, are -2 p q.
    product = a * b * (ratio - 1) / ratio**2
    squares = abs(m * u - k * v - d) ** 2 - 2 * product * dot(u, v)
    return {"a": a, "b": b, "c": c, "d": d, "lambda": ratio, "sigma": squares + 2 * product, "delta": squares - 2 * product}


def turns(points):
    return [mp.sign(cross(points[(k + 1) % 4] - points[k], points[(k + 2) % 4] - points[(k + 1) % 4])) for k in range(4)]


def around(points, f):
    total = sum(mp.arg((points[(k + 1) % 4] - f) / (points[k] - f)) for k in range(4))
    return mp.nint(total / (2 * mp.pi))


def any_shape(rng):
    b = FiveBar(rng, [number(rng) for _ in range(4)])
    ratio = 1 + b.p * b.q / (b.m * b.n)
    pivots = mpc(0), mpc(b.d)
    pins = ratio * b.m * b.u, b.d + ratio * b.n * b.v
    polygon = [pivots[0], pins[0], pins[1], pivots[1]]
    s = b.rest()
    signs = turns(polygon)
    symbols = {"M": pivots[0], "A": pins[0], "B": pins[1], "N": pivots[1], "F": b.f, "rho": s / (b.d - s)}
    return symbols | {"W": around(polygon, b.f), "convex": mpf(len(set(signs)) == 1)}


def hart(rng):
    """p = kappa n, q = -kappa m: m p + n q = 0, S is at infinity."""
    m, n, kappa = length(rng), length(rng), length(rng)
    b = FiveBar(rng, [m, n, kappa * n, -kappa * m])
    ratio = 1 + b.p * b.q / (m * n)
    symbols = {"m": m, "n": n, "p": b.p, "q": b.q, "d": b.d, "kappa": kappa, "x": b.f.real, "lambda": ratio}
    return symbols | {"a": ratio * m, "b": ratio * n, "c": abs(b.d + ratio * n * b.v - ratio * m * b.u)}


def revolving_coupler(rng):
    a, b, c, d = (length(rng) for _ in range(4))
    if c >= d:
        raise NoValue("the base is not longer")
    # The sum of the vectors AB and NM in all directions.
    reach = [abs(mpc(d, 0) - c * cis(x)) for x in (0, mp.pi)]
    return {"a": a, "b": b, "c": c, "d": d, "D_1": reach[0], "D_2": reach[1]}


SCENES = {
    "wunderlich1968/five-bar": five_bar,
    "wunderlich1968/completion": completion,
    "wunderlich1968/figure-2-of-any-shape": any_shape,
    "wunderlich1968/hart": hart,
    "wunderlich1968/revolving-coupler": revolving_coupler,
}
