"""The program's rules for other linkages with Burmester points as pins and Ball's point D as output point."""

from mpmath import mp, mpf

from .burmester_points import quartic
from .evaluate import NoValue
from .program import Exact, Program, lesser_angle
from .scenes.coupler import center_of_path
from .scenes.draw import cross
from .scenes.symmetric import circles_meet


COARSE = ((1, 100), (5, 100), (1, 10))


class Sister(Program):
    """Cranks O_aA and O_bB and the output point D, which moves along a direction; all is computed by circles that meet."""

    def __init__(self, pivots, a, b, d, along, levels=Program.levels_of_deviation):
        self.arithmetic, self.levels_of_deviation = Exact(), levels
        self.a, self.b, self.point, self.along = a, b, d, along
        self.o_a, self.o_b = pivots
        base = self.o_b - self.o_a
        self.base = base / abs(base)
        self.q, self.r, self.s, self.t = abs(base), abs(a - self.o_a), abs(b - a), abs(b - self.o_b)
        self.m, self.n = abs(d - a), abs(d - b)
        self.unit = (self.q + self.r + self.s + self.t + (self.m + self.n) / 2) / 5
        self.side = mp.sign(cross(self.o_b - a, b - a))
        self.degree = mp.pi / 180

    def angle(self, z):
        """Of a direction, from the fixed link, in degrees."""
        return mp.arg(z / self.base) / self.degree

    @staticmethod
    def line(angle):
        """From -90 to 90 degrees."""
        return angle - 180 * mp.nint(angle / 180)

    def design(self):
        out = {name: getattr(self, name.lower()) / self.unit for name in "QRSTMN"}
        epsilon = mp.arg((self.point - self.a) / (self.b - self.a)) / self.degree
        # More than -180 degrees and not more than 180.
        epsilon = epsilon if epsilon + 180 > mpf(10) ** -40 else epsilon + 360
        return out | {"unit": self.unit, "epsilon": epsilon, "phi": self.angle(self.a - self.o_a) % 360}

    def row(self, degrees):
        turn = mp.expj(degrees * self.degree)
        a = self.o_a + turn * (self.a - self.o_a)
        try:
            places = circles_meet(a, self.s, self.o_b, self.t)
        except NoValue:
            return None
        b = next(z for z in places if mp.sign(cross(self.o_b - a, z - a)) == self.side)
        moved = a + (self.point - self.a) / (self.b - self.a) * (b - a)
        way = (moved - self.point) / self.along / self.unit
        chi = self.line(self.angle(b - a))
        crank = self.line(self.angle(self.a - self.o_a)) + degrees
        rocker = self.line(self.angle(b - self.o_b))
        psi = mp.arg((b - self.o_b) / (self.b - self.o_b)) / self.degree
        return {"u": way.real, "v": way.imag, "psi": psi, "gamma_a": lesser_angle(crank, chi), "gamma_b": lesser_angle(rocker, chi)}


def burmester_points(a, b, d):
    """Cranks to the centers of their paths, all seen from the pole, the line of D across its ray."""
    return Sister((center_of_path(a), center_of_path(b)), a, b, d, 1j * d / abs(d))


def evans(omega, rho, k):
    """A circle of radius 1 rolls in one of radius 2: B and D of its edge on the two axes, A on BD.

    O_a on the axis of B is as far from A as from the place of A for omega = 0, O_b at the height k above B."""
    center, turned = mp.expj(omega), mp.expj(-omega)
    a, b, d = center + rho * turned, center + turned, center - turned
    first = 1 + rho
    o_a = (abs(a) ** 2 - first**2) / (2 * (a.real - first))
    return Sister((mp.mpc(o_a), b + 1j * k), a, b, d, 1j, COARSE)


def ball_burmester(alpha_a, alpha_b, alpha_d):
    """The points A, B, C, D on their rays: D on the inflection circle, C by the quartic of the Burmester points.

    With m + n tan alpha_d = 1 the conditions of A and B, freed of that of D, have c4 in one number only:
    ((6 - 6 t^2) + n (6 (t - t_d)(1 + t^2) + 24 t + 24 t_d t^2))/t is the same for both."""
    p, q, d = (mp.tan(x) for x in (alpha_a, alpha_b, alpha_d))

    def parts(t):
        return (6 - 6 * t * t) / t, (6 * (t - d) * (1 + t * t) + 24 * t + 24 * d * t * t) / t

    (a0, a1), (b0, b1) = parts(p), parts(q)
    n = (b0 - a0) / (a1 - b1)
    m = 1 - n * d
    coefficients = quartic(m, n, p, q)
    value = sum(c * d**k for k, c in enumerate(coefficients))
    assert abs(value) < mpf(10) ** -40 * max(map(abs, coefficients)) * (1 + d * d) ** 2, "D is no Burmester point"
    c = -coefficients[3] / coefficients[4] - p - q - d
    rays = {"A": alpha_a, "B": alpha_b, "C": mp.atan(c), "D": alpha_d}
    return {name: mp.expj(x) / (m / mp.sin(x) + n / mp.cos(x)) for name, x in rays.items()}
