"""Points of a moving plane in one position, seen from its pole, the inflection circle having the diameter 1."""

from mpmath import mp, mpf

from ..burmester_points import quartic
from ..evaluate import Angle
from .draw import cis, dot, radians


def center_of_path(z):
    """With the turn as time: velocity i z, acceleration -(z - i); the center is |v|^2/(v x a) beside the path."""
    velocity, acceleration = 1j * z, -(z - 1j)
    bend = (mp.conj(velocity) * acceleration).imag
    return z + 1j * velocity * abs(velocity) ** 2 / bend


def ball_double_burmester(rng):
    """Rays of two Burmester points, the other two together on the inflection circle."""
    ray_a, ray_b = radians(rng, 0.1, 3.0), radians(rng, 0.1, 3.0)
    p, q = mp.tan(ray_a), mp.tan(ray_b)
    total, product = p + q, p * q
    ray_d = mp.atan(-total / (product + 3))
    symbols = {"alpha_a": Angle(ray_a), "alpha_b": Angle(ray_b), "alpha_d": Angle(ray_d), "V": total, "W": product}
    inverse_m, inverse_n = cubic_of(total, product)
    t = -total / (product + 3)
    # It is to be a double root of the quartic, on the inflection circle.
    coefficients = quartic(inverse_m, inverse_n, p, q)
    value = sum(c * t**k for k, c in enumerate(coefficients))
    slope = sum(k * c * t ** (k - 1) for k, c in enumerate(coefficients) if k)
    assert max(abs(value), abs(slope), abs(inverse_m + inverse_n * t - 1)) < mpf(10) ** -40 * max(map(abs, coefficients)) * (1 + t * t) ** 2
    for name, ray in (("a", ray_a), ("b", ray_b)):
        r = 1 / (inverse_m / mp.sin(ray) + inverse_n / mp.cos(ray))
        z = r * cis(ray)
        o = center_of_path(z)
        symbols |= {f"P{name.upper()}": r, f"PO_{name}": dot(cis(ray), o), f"O_{name}{name.upper()}": dot(cis(ray), z - o)}
    return symbols


def cubic_of(total, product):
    """1/M and 1/N of the cubic of stationary curvature, 1/r = 1/(M sin) + 1/(N cos)."""
    return product / (product - 1), (product + 3) / (total * (product - 1))


SCENES = {"tesar1964/ball-double-burmester-point": ball_double_burmester}
