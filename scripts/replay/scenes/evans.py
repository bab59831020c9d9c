"""A circle that rolls in one of twice its size (Tesar, chapter V)."""

from mpmath import mpf

from ..evaluate import Angle
from .draw import cis, coordinates, crossing, number, radians


def edge(omega, line):
    """The point of the rolling circle's edge that moves on the line through the origin in this direction."""
    return cis(omega) + cis(2 * line - omega)


def evans(rng):
    omega, beta, alpha = (radians(rng) for _ in range(3))
    rho, k = number(rng), number(rng)
    center, touch = cis(omega), 2 * cis(omega)
    a = center + rho * (edge(omega, beta) - center)
    b, d = edge(omega, mpf(0)), edge(omega, alpha)
    normal = touch - a
    o_a = crossing(0, cis(beta), touch, normal)
    o_b = (b + 2) / 2 + 1j * k
    symbols = {"omega": Angle(omega), "beta": Angle(beta), "alpha": Angle(alpha), "rho": rho, "k": k, "m": normal.imag / normal.real}
    for names, z in ((("U_1", "V_1"), o_a), (("U_2", "V_2"), o_b), (("UP_1", "VP_1"), a), (("U_d", "V_d"), d)):
        symbols |= coordinates(names, z)
    return symbols


def axis(rng):
    beta = radians(rng)
    return {"beta": Angle(beta)} | coordinates(("U", "V"), number(rng) * cis(beta))


SCENES = {"tesar1964/evans": evans, "tesar1964/evans-axis": axis}
