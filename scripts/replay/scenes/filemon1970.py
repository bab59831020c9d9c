"""Poles and mirror poles of four positions (Filemon 1970)."""

from mpmath import mpc, mpf

from .. import cubic
from ..centerpoint import circlepoint_curve, inverted
from ..evaluate import Angle, Line
from .draw import circumcenter, cis, mirrored, midnormals, point, radians


class Positions:
    """Position 1 is the frame; the others are turns about three poles."""

    def __init__(self, rng):
        self.turns = [mpf(0)] + [radians(rng) for _ in range(3)]
        self.units = [cis(phi) for phi in self.turns]
        poles = [mpc(0)] + [point(rng) for _ in range(3)]
        self.shifts = [o * (1 - u) for o, u in zip(poles, self.units)]
        self.poles, self.mirrors = {}, {}
        for i in range(4):
            for j in range(i + 1, 4):
                z = (self.shifts[j] - self.shifts[i]) / (self.units[i] - self.units[j])
                self.mirrors[i + 1, j + 1] = z
                self.poles[i + 1, j + 1] = self.moved(i, z)

    def moved(self, i, z):
        return self.units[i] * z + self.shifts[i]

    def back(self, i, z):
        return (z - self.shifts[i]) / self.units[i]

    def symbols(self):
        out = {f"O_{i}{j}": z for (i, j), z in self.poles.items()}
        out |= {f"O_{i}{j}'": self.mirrors[i, j] for i, j in ((2, 3), (2, 4), (3, 4))}
        return out | {f"phi_1{j}": Angle(self.turns[j - 1]) for j in (2, 3, 4)}

    def as_numbers(self):
        return [(u.real, u.imag, s.real, s.imag) for u, s in zip(self.units, self.shifts)]


def pole_system(rng):
    return Positions(rng).symbols()


def partners(rng):
    """The circles through the three different places of a pole, and of a mirror pole."""
    p = Positions(rng)
    symbols = p.symbols()
    for (i, j), z in p.mirrors.items():
        others = [k for k in range(4) if k != j - 1]
        symbols[f"Q_{i}{j}"] = circumcenter(*(p.moved(k, z) for k in others))
        symbols[f"Q_{i}{j}'"] = circumcenter(*(p.back(k, p.poles[i, j]) for k in others))
    return symbols


def branches(coefficients):
    """Branches of a circular cubic, by the sign of a discriminant."""
    return 2 if cubic.by_tangents(coefficients) == "two-branches" else 1


def asymptote(positions):
    """The real direction at infinity of the circlepoint curve."""
    a, b, *_ = circlepoint_curve(positions)
    return mpc(b, -a) / abs(mpc(b, -a))


def line_through(p, direction):
    u = direction
    return Line((u.imag, -u.real, u.real * p.imag - u.imag * p.real))


def center_at_infinity(rng):
    """Mirrored in parallel lines through O12 and O14, O23 and O34 become l' and l."""
    p = Positions(rng)
    along = asymptote(inverted(p.as_numbers()))
    first, second = (mirrored(p.poles[k], p.poles[o], along) for k, o in (((2, 3), (1, 2)), ((3, 4), (1, 4))))
    k = midnormals(p.mirrors[2, 3], first, p.mirrors[3, 4], second)
    return p.symbols() | {"O_31": p.poles[1, 3], "l'": first, "l": second, "K": k, "m": line_through(p.poles[1, 4], along)}


def circlepoint_at_infinity(rng):
    p = Positions(rng)
    along = asymptote(p.as_numbers())
    first, second = (mirrored(p.mirrors[k], p.poles[o], along) for k, o in (((2, 3), (1, 2)), ((3, 4), (1, 4))))
    m = midnormals(p.poles[2, 3], first, p.poles[3, 4], second)
    return p.symbols() | {"l'": first, "l": second, "M": m, "k": line_through(p.poles[1, 4], along)}


SCENES = {
    "filemon1970/pole-system": pole_system,
    "filemon1970/partners-of-the-poles": partners,
    "filemon1970/center-at-infinity": center_at_infinity,
    "filemon1970/circlepoint-at-infinity": circlepoint_at_infinity,
}
