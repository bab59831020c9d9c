"""The centerpoint curve by the sides of a pole quadrilateral O12 O23 O34 O14 (Filemon 1973)."""

from mpmath import mp, mpc, mpf

from ..evaluate import Angle, Many, NoValue
from .draw import cis, crossing, dot, length, number, point, polynomial, radians


def sight(p, poles):
    """Zero where P sees O12 O23 and O14 O34 under one angle, modulo a half turn."""
    o12, o23, o34, o14 = poles
    return ((o23 - p) * mp.conj(o12 - p) * mp.conj((o34 - p) * mp.conj(o14 - p))).imag


def oblique_axes(rng):
    p, phi, zeta, eta, r = point(rng), radians(rng), number(rng), number(rng), length(rng)
    axis = cis(phi)
    o12, o23, o14 = mpc(zeta), mpc(zeta + r), eta * axis
    # The ray from P under the same angle against that to O14.
    o34 = crossing(p, (o14 - p) * (o23 - p) / (o12 - p), 0, axis)
    long = dot(axis, o34) - eta
    if long <= 0:
        raise NoValue("R points backwards")
    assert abs(sight(p, (o12, o23, o34, o14))) < mpf(10) ** -40
    oblique = p.imag / mp.sin(phi)
    symbols = {"O_1": mpc(0), "O_12": o12, "O_14": o14, "phi": Angle(phi), "r": r, "R": long, "zeta_0": zeta, "eta_0": eta}
    symbols |= {"x": p.real, "y": p.imag, "eta": oblique, "zeta": p.real - oblique * mp.cos(phi)}
    return symbols | {"G_1": dot(o14 - p, o34 - p), "g_1": dot(o12 - p, o23 - p)}


def on_line(poles, origin, u, v, p):
    """Coefficients 1, t, t^2, t^3 of the sight at origin + t (u + p v)."""
    at = [mpf(x) for x in (-1, 0, 1, 2)]
    return polynomial([sight(origin + t * (u + p * v), poles) for t in at], at)


def sums(poles, origin, u, v):
    """p + 1/p for the tangents from a point of the curve: roots of an equation that reads the same backwards."""

    def discriminant(p):
        _, one, two, three = on_line(poles, origin, u, v, p)
        return two**2 - 4 * one * three

    at = [mpf(x) for x in (-2, -1, 1, 2, 3)]
    e, d, c, b, a = polynomial([discriminant(p) for p in at], at)
    assert abs(e - a) + abs(d - b) < mpf(10) ** -35 * (abs(a) + abs(b)), "the equation does not read the same backwards"
    root = b * b - 4 * a * (c - 2 * a)
    # Small negative values belong to a double root; those are not drawn here.
    if root < 0:
        raise NoValue("complex sums")
    return sorted(((-b + s * mp.sqrt(root)) / (2 * a) for s in (1, -1)), reverse=True)


class Quadrilateral:
    def __init__(self, poles):
        self.poles = poles
        o12, o23, o34, o14 = poles
        self.u, self.v = (o23 - o12) / abs(o23 - o12), (o34 - o14) / abs(o34 - o14)
        self.origin = crossing(o12, self.u, o14, self.v)
        self.r, self.h, self.long, self.c = abs(o23 - o12), abs(o34 - o23), abs(o34 - o14), abs(o14 - o12)
        # Figure 7 faces O1 with h and O2 with R.
        if self.c >= self.h or self.r >= self.long:
            raise NoValue("not named as in figure 7")
        self.sums = sums(poles, self.origin, self.u, self.v)

    def symbols(self):
        o12, _, _, o14 = self.poles
        out = {"phi": Angle(mp.arg(self.v / self.u)), "r": self.r, "h": self.h, "R": self.long, "c": self.c}
        out |= {"zeta_0": dot(self.u, o12 - self.origin), "eta_0": dot(self.v, o14 - self.origin)}
        return out | {"f_1": self.sums[0], "f_2": self.sums[1]}

    def beside(self):
        """f_1' and f_2', for O2 where the other two sides meet."""
        o12, o23, o34, o14 = self.poles
        u, v = (o14 - o12) / self.c, (o34 - o23) / self.h
        first, second = sums(self.poles, crossing(o12, u, o23, v), u, v)
        return {"f_1'": first, "f_2'": second}


def any_quadrilateral(rng):
    return Quadrilateral([point(rng) for _ in range(4)])


def sides_and_tangents(rng):
    q = any_quadrilateral(rng)
    return q.symbols() | {"D": ((q.long * q.r) ** 2 * (q.sums[0] - q.sums[1])) ** 2}


def slopes_of(f):
    """Both p with p + 1/p = f."""
    root = mp.sqrt(mpc(f * f - 4))
    return Many([(f + root) / 2, (f - root) / 2])


def slopes(rng):
    q = any_quadrilateral(rng)
    first, second = map(slopes_of, q.sums)
    if abs(first[0].imag) > 0:
        raise NoValue("no real tangents")
    return q.symbols() | q.beside() | {"p": first[0].real, "p_{1,2}": first, "p_{3,4}": second}


def real_tangents(sums_):
    """Those that touch beside a double point."""
    return mpf(2 * sum(abs(f) - 2 > mpf(10) ** -30 for f in sums_))


def nodes_at(q):
    """Double points on the lines p = 1 and p = -1 through O1; the sight has no slope there."""
    found = 0
    step = mpf(10) ** -20
    for p in (1, -1):
        _, one, two, three = on_line(q.poles, q.origin, q.u, q.v, mpf(p))
        place = q.origin - two / (2 * three) * (q.u + p * q.v)
        scale = abs(three)
        flat = [abs(sight(place + d, q.poles) - sight(place - d, q.poles)) / (2 * step * scale) < mpf(10) ** -25 for d in (step, 1j * step)]
        found += all(flat) and abs(sight(place, q.poles)) < mpf(10) ** -25 * scale
    return found


def balanced(rng):
    """A quadrilateral in which the shortest and the longest side are as long as the other two."""
    o12, o23, o34 = (point(rng) for _ in range(3))
    r, h = abs(o23 - o12), abs(o34 - o23)
    # O14 on an ellipse or hyperbola about O12 and O34: c - R = r - h, h - r, or c + R = r + h.
    base = abs(o34 - o12)
    long = length(rng)
    c = rng.choice((r + h - long, long + r - h, long + h - r))
    sides = sorted((r, h, long, c))
    if c <= 0 or abs(sides[0] + sides[3] - sides[1] - sides[2]) > mpf(10) ** -40 or not abs(c - long) < base < c + long:
        raise NoValue("no such quadrilateral")
    along = (base**2 + c**2 - long**2) / (2 * base)
    up = rng.choice((1, -1)) * mp.sqrt(c**2 - along**2)
    o14 = o12 + (o34 - o12) / base * mpc(along, up)
    return Quadrilateral([o12, o23, o34, o14])


def any_shape(rng):
    q = balanced(rng) if rng.random() < 0.5 else any_quadrilateral(rng)
    symbols = q.symbols() | q.beside()
    sides = sorted((q.r, q.h, q.long, q.c))
    nodes = nodes_at(q)
    for name in ("phi", "zeta_0", "eta_0"):
        del symbols[name]
    # A cubic without double point has the class 6, and each double point takes two away.
    symbols |= {"N_1": real_tangents(q.sums), "N_2": real_tangents(q.beside().values())}
    return symbols | {"U": sides[0] + sides[3], "Z": sides[1] + sides[2], "nodes": mpf(nodes), "class": mpf(6 - 2 * nodes)}


SCENES = {
    "filemon1973/oblique-axes": oblique_axes,
    "filemon1973/sides-and-tangents": sides_and_tangents,
    "filemon1973/slopes": slopes,
    "filemon1973/any-shape": any_shape,
}
