"""A slider-crank with equal links, and the four-bar with a symmetrical curve that replaces it (Tesar, chapter IV)."""

from mpmath import mp, mpf

from ..evaluate import Angle, NoValue
from .coupler import center_of_path
from .draw import cis, dot, mirrored, radians, turn


def circles_meet(p, r, q, s):
    """Both points at the distance r from p and s from q."""
    d = abs(q - p)
    along = (d * d + r * r - s * s) / (2 * d)
    if abs(along) >= r:
        raise NoValue("circles that do not meet")
    up = mp.sqrt(r * r - along * along)
    u = (q - p) / d
    return p + u * (along + 1j * up), p + u * (along - 1j * up)


def axis_of_symmetry(o_a, o_b, a, b, d):
    """The direction of the line through O_a that carries the curve of D into itself, from one place and its image.

    With B mirrored in the fixed link the coupler has two places; that with D as far from O_a gives the image."""
    mirror = mirrored(b, o_b, o_a - o_b)
    for pin in circles_meet(o_a, abs(a - o_a), mirror, abs(b - a)):
        image = pin + (d - a) / (b - a) * (mirror - pin)
        if abs(abs(image - o_a) - abs(d - o_a)) < mpf(10) ** -40 and abs(image - d) > mpf(10) ** -10:
            return mp.sqrt((image - o_a) * (d - o_a))
    raise NoValue("no image")


def symmetrical_alternate(rng):
    k = mpf(rng.randint(40, 300)) / 101
    ray_a = radians(rng, 0.2, 2.9)
    a = k * mp.sin(ray_a) / (k + 1) * cis(ray_a)
    o_a = center_of_path(a)
    arm = abs(a - o_a)
    first, second = circles_meet(a, arm, mpf(1) / 2 * 1j, mpf(1) / 2)
    d, other = (first, second) if rng.random() < 0.5 else (second, first)
    epsilon = mpf(rng.randint(100, 3000)) / 1000
    b = a + (d - a) * cis(-epsilon)
    o_b = center_of_path(b)
    axis = axis_of_symmetry(o_a, o_b, a, b, d)
    ray_b = mp.arg(b)
    symbols = {"k": k, "alpha_a": Angle(ray_a), "alpha_b": Angle(ray_b), "alpha_d": Angle(mp.arg(d)), "alpha_d'": Angle(mp.arg(other))}
    symbols |= {"PA": abs(a), "PB": abs(b), "PD": abs(d), "PO_a": abs(o_a), "PO_b": dot(cis(ray_b), o_b)}
    symbols |= {"R": arm, "M": abs(d - a), "S": abs(b - a), "N": abs(d - b), "O_bB": dot(cis(ray_b), o_b - b)}
    symbols |= {"epsilon": Angle(epsilon), "Phi": turn(d - a, a - o_a), "phi": turn(o_b - o_a, a - o_a)}
    # Lines have angles modulo a half turn.
    return symbols | {"turn": Angle(mp.arg(d / axis), mp.pi)}


SCENES = {"tesar1964/symmetrical-alternate": symmetrical_alternate}
