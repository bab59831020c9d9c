"""Polynomials of which some roots are known: two conics, the cubic of the centers (Tesar, chapter III)."""

from mpmath import mp

from .draw import number


def times(p, q):
    out = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] += a * b
    return out


def plus(p, q, factor=1):
    size = max(len(p), len(q))
    p, q = (list(x) + [0] * (size - len(x)) for x in (p, q))
    return [a + factor * b for a, b in zip(p, q)]


def at(p, x):
    return sum(c * x**k for k, c in enumerate(p))


def resultant(s):
    """Of y^2 + P y + S and y^2 + Q y + T: y = (T - S)/(P - Q) put into the first, without the denominator."""
    p, q = [s["b"], s["a"]], [s["g"], s["f"]]
    low, other = [s["e"], s["d"], s["c"]], [s["l"], s["k"], s["h"]]
    u, v = plus(other, low, -1), plus(p, q, -1)
    return plus(plus(times(u, u), times(times(p, u), v)), times(low, times(v, v)))


def conic(rng, points):
    """Coefficients of y^2 + (a x + b) y + (c x^2 + d x + e) through up to two points."""
    a, b, c, d, e = (number(rng) for _ in range(5))

    def rest(x, y):
        return -(y * y + (a * x + b) * y + c * x * x)

    if len(points) == 2:
        (x, y), (u, v) = points
        d = (rest(x, y) - rest(u, v)) / (x - u)
    if points:
        x, y = points[0]
        e = rest(x, y) - d * x
    return a, b, c, d, e


def conics(rng, points):
    symbols = dict(zip("abcde", conic(rng, points))) | dict(zip("fghkl", conic(rng, points)))
    return symbols


def eliminant(rng):
    symbols = conics(rng, [])
    return symbols | {f"R_{k}": c for k, c in enumerate(resultant(symbols))}


def two_known_roots(rng):
    points = [(number(rng), number(rng)) for _ in range(2)]
    symbols = conics(rng, points)
    quartic = resultant(symbols)
    (x, _), (u, _) = points
    t, z0 = number(rng), number(rng)
    rest = at(quartic, t) / quartic[4] / (t - x) / (t - u)
    # z^2 + E z + F: sum and product of the roots that are left.
    linear = quartic[3] / quartic[4] + x + u
    constant = quartic[0] / quartic[4] / (x * u)
    return symbols | {"x_{o,a}": -x, "x_{o,b}": -u, "z_1": t * z0, "z_0": z0, "rest": rest, "E": linear, "F": constant}


def common_point(rng):
    x, y, z0 = (number(rng) for _ in range(3))
    return conics(rng, [(x, y)]) | {"Z_0": z0, "Z_1": x * z0, "Z_2": y * z0}


def known_center(rng):
    """M_3, M_4, N_3 from three roots of t (Z_1^2 + Z_2^2) - Z_1 Z_3 - Z_2 Z_4, Z_i = M_i + N_i t."""
    m1, m2, n1, n2, n4 = (number(rng) for _ in range(5))
    roots = [number(rng) for _ in range(3)]
    lead = n1**2 + n2**2
    s1, s2 = sum(roots), roots[0] * roots[1] + roots[0] * roots[2] + roots[1] * roots[2]
    n3 = (2 * (m1 * n1 + m2 * n2) - n2 * n4 + lead * s1) / n1
    left = mp.matrix([[n1, n2], [m1, m2]])
    right = mp.matrix([m1**2 + m2**2 - m1 * n3 - m2 * n4 - lead * s2, lead * roots[0] * roots[1] * roots[2]])
    m3, m4 = mp.lu_solve(left, right)
    t, z0 = number(rng), number(rng)
    symbols = {"M_1": m1, "M_2": m2, "M_3": m3, "M_4": m4, "N_1": n1, "N_2": n2, "N_3": n3, "N_4": n4}
    return symbols | {"X_{c,a}": -roots[0], "z_5": t * z0, "z_0": z0, "rest": (t - roots[1]) * (t - roots[2])}


SCENES = {
    "tesar1964/eliminant": eliminant,
    "tesar1964/two-known-roots": two_known_roots,
    "tesar1964/common-point": common_point,
    "tesar1964/known-center": known_center,
}
