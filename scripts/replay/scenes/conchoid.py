"""A line through a fixed point carries a pin at a fixed distance from where it meets an axis (Tesar, chapter V)."""

from mpmath import mp, mpc, mpf

from ..evaluate import Angle
from .draw import cis, coordinates, directed, length, radians, turn


def conchoid(rng):
    r, alpha = length(rng), radians(rng, -1.4, 1.4)
    o_b, d = mpc(0, 1), mpc(mp.tan(alpha), 0)
    a = d + r * (o_b - d) / abs(o_b - d)
    first = mpc(0, r)
    # The point of the V-axis as far from both.
    height = (abs(a) ** 2 - r**2) / (2 * (a.imag - r))
    o_a = mpc(0, height)
    return r, alpha, o_a, o_b, a, d, first


def fixed_link(rng):
    r, alpha, o_a, o_b, a, *_ = conchoid(rng)
    symbols = {"r": r, "alpha": Angle(alpha), "R": abs(a - o_a), "V_1": o_a.imag, "V_2": mpf(1)}
    return symbols | {"Q": abs(o_b - o_a), "theta": directed(o_a, o_b)}


def linkage(rng):
    r, alpha, o_a, o_b, a, d, first = conchoid(rng)
    k, n = length(rng), rng.choice((1, -1))
    b = o_b + n * k * cis(alpha)
    radius = abs(a - o_a)
    any_place = o_a + radius * cis(radians(rng))
    symbols = {"r": r, "alpha": Angle(alpha), "k": k, "n": mpf(n), "R": radius, "V_1": o_a.imag}
    symbols |= {"S": abs(b - a), "M": abs(d - a), "N": abs(d - b), "epsilon": turn(b - a, d - a)}
    for names, z in ((("U", "V"), any_place), (("UP_1", "VP_1"), a), (("UP_2", "VP_2"), b)):
        symbols |= coordinates(names, z)
    return symbols


SCENES = {"tesar1964/conchoidal-linkage": linkage, "tesar1964/conchoidal-fixed-link": fixed_link}
