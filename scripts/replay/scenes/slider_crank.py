"""Slider-cranks and couplers in two positions (Tesar, chapter IV)."""

from mpmath import mp, mpc, mpf

from ..evaluate import Angle, NoValue
from .draw import cis, coordinates, cross, crossing, directed, dot, length, mirrored, number, point, polynomial, radians, turn


def travel(rng):
    """Pivot in the origin; A to the right of the way from it to D, its mirror image to the left."""
    radius, d = length(rng), point(rng)
    a = radius * cis(radians(rng))
    if cross(d, a) > 0:
        a = mirrored(a, 0, d)
    b = point(rng)
    symbols = {"R": radius, "M": abs(d - a), "S": abs(b - a), "s": d.real, "d": d.imag}
    symbols |= {"omega": directed(0, a), "omega'": directed(0, mirrored(a, 0, d))}
    symbols |= {"beta": directed(a, d), "epsilon": turn(b - a, d - a)}
    for name, z in (("a", a), ("d", d), ("b", b)):
        symbols |= coordinates((f"x_{name}", f"y_{name}"), z)
    return symbols


class Displaced:
    """A coupler in the design position, seen from its pole, and in a second one; D moves across its ray."""

    def __init__(self, ray_d, d, s12, angle):
        self.ray, self.d1 = cis(ray_d), d
        self.d2 = d + s12 * 1j * self.ray
        self.turn = cis(angle)
        self.shift = self.d2 - self.turn * d
        self.pole = self.shift / (1 - self.turn)

    def moved(self, z):
        return self.turn * z + self.shift


def displaced_coupler(rng):
    ray_b, ray_d, theta = (radians(rng) for _ in range(3))
    s12 = number(rng)
    p = Displaced(ray_d, length(rng) * cis(ray_d), s12, radians(rng))
    b1 = number(rng) * cis(ray_b)
    b2 = p.moved(b1)
    o_b = crossing(0, cis(ray_b), (b1 + b2) / 2, 1j * (b2 - b1))
    d12 = (p.d1 + p.d2) / 2
    m = dot(cis(theta), crossing(0, cis(theta), p.pole, d12 - p.pole))
    symbols = {"alpha_b": Angle(ray_b), "alpha_d": Angle(ray_d), "PB": dot(cis(ray_b), b1), "PO_b": dot(cis(ray_b), o_b)}
    symbols |= {"s_12": s12, "theta": Angle(theta), "m": m, "P_12": p.pole, "D_12": d12, "B_12": (b1 + b2) / 2, "O_b": o_b}
    return symbols | coordinates(("U_b2", "V_b2"), b2)


def second_position(rng):
    ray_a, ray_d, omega = (radians(rng) for _ in range(3))
    po_a, s12 = number(rng), number(rng)
    o_a, d1 = po_a * cis(ray_a), number(rng) * cis(ray_d)
    along = 1j * cis(ray_d)
    d2 = d1 + s12 * along
    crank = cis(omega) * along
    p2 = crossing(o_a, crank, d2, cis(ray_d))
    b = point(rng)
    symbols = {"alpha_a": Angle(ray_a), "alpha_d": Angle(ray_d), "PO_a": po_a, "s_12": s12, "s_2": dot(along, d2 - o_a)}
    symbols |= {"omega": Angle(omega)} | coordinates(("x_b", "y_b"), b)
    return symbols | coordinates(("U_b", "V_b"), o_a + b * along) | coordinates(("U_P2", "V_P2"), p2)


def one_intersection(rng):
    """A, B, C, D on the cubic of stationary curvature; the cranks at A, B and C lead from one position to the other.

    With 1/PX = 1/(M sin) + 1/(N cos) and 1/PO = 1/PX - 1/sin, and D on the inflection circle. For the
    displacement z -> tau z + c the pivot of a point is as far from both places where
    |c|^2/(PX PO) + 2 Re(tau u conj c)/PO + 2 (1 - Re tau) - 2 Re(c conj u)/PX = 0, u being its ray;
    with sin and cos by the tangent a polynomial of order four, of which A and D are known roots."""
    ray_a, ray_d = radians(rng, 0.2, 2.9), radians(rng, 0.2, 2.9)
    n = number(rng)
    inverse_m = 1 - mp.tan(ray_d) / n
    a = cis(ray_a) / (inverse_m / mp.sin(ray_a) + 1 / (n * mp.cos(ray_a)))
    d = mp.sin(ray_d) * cis(ray_d)
    o_a = cis(ray_a) / ((inverse_m - 1) / mp.sin(ray_a) + 1 / (n * mp.cos(ray_a)))
    # Turn the crank and let D follow on its line.
    a2 = o_a + cis(mpf(rng.randint(100, 900)) / 1000) * (a - o_a)
    along = 1j * cis(ray_d)
    across = cross(along, a2 - d)
    square = abs(d - a) ** 2 - across**2
    if square <= 0:
        raise NoValue("out of reach")
    way = dot(along, a2 - d)
    s12 = min((way + mp.sqrt(square), way - mp.sqrt(square)), key=abs)
    d2 = d + s12 * along
    tau = (d2 - a2) / (d - a)
    c = d2 - tau * d

    def condition(t):
        """t^2 times the condition, u being (1 + i t) cos and the reciprocals divided by 1/cos."""
        u = mpc(1, t)
        px, po = inverse_m + t / n, inverse_m - 1 + t / n
        return (abs(c) ** 2 * (1 + t * t) * px * po + 2 * (tau * u * mp.conj(c)).real * po * t
                + 2 * (1 - tau.real) * t * t - 2 * (c * mp.conj(u)).real * px * t)

    at = [mpf(x) for x in (-2, -1, 0, 1, 2)]
    quartic = polynomial([condition(t) for t in at], at)
    p, q = mp.tan(ray_a), mp.tan(ray_d)
    total, product = -quartic[3] / quartic[4] - p - q, quartic[0] / quartic[4] / (p * q)
    if total**2 < 4 * product:
        raise NoValue("complex rays")
    roots = [(total + sign * mp.sqrt(total**2 - 4 * product)) / 2 for sign in (1, -1)]
    ray_b, ray_c = (mp.atan(t) for t in roots)
    pb = 1 / (inverse_m / mp.sin(ray_b) + 1 / (n * mp.cos(ray_b)))
    symbols = {"alpha_a": Angle(ray_a), "alpha_b": Angle(ray_b), "alpha_c": Angle(ray_c), "alpha_d": Angle(ray_d)}
    symbols |= {"N": n, "PB": pb, "s_12": s12} | coordinates(("U_b2", "V_b2"), tau * pb * cis(ray_b) + c)
    return symbols | coordinates(("U_12", "V_12"), c / (1 - tau))


SCENES = {
    "tesar1964/travel-of-the-slider": travel,
    "tesar1964/displaced-coupler": displaced_coupler,
    "tesar1964/second-position": second_position,
    "tesar1964/one-intersection": one_intersection,
}
