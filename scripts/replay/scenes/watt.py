"""Four-bars with parallel cranks (Tesar, chapter V)."""

from mpmath import mp, mpc, mpf

from ..evaluate import Angle
from .draw import cis, directed, length, number, radians, turn


class Parallel:
    """A crank along the V-axis, the other beside it; all velocities are across and alike.

    With that velocity 1 a point at U has the acceleration -1/R in the line of A, n/T in that of B, and linearly
    between: that is its curvature. Where it vanishes is the V-axis."""

    def __init__(self, rng, size):
        self.r, self.t, self.n, self.size = length(rng), length(rng), rng.choice((1, -1)), size
        if rng.random() < 0.25:
            self.t = self.r
        self.gamma = radians(rng)
        self.slope = (1 / self.r + self.n / self.t) / (size * mp.sin(self.gamma))
        along = 1j * cis(-self.gamma)
        c_from_a = 1 / self.r / self.slope / along.real
        # The origin is on the line of the coupler.
        self.a = -c_from_a * along
        self.b = self.a + size * along
        self.c_from_a = c_from_a

    def symbols(self):
        return {"R": self.r, "T": self.t, "S": self.size, "n": mpf(self.n), "gamma": Angle(self.gamma), "r": self.c_from_a}


def pinned(draw):
    """Parallel open cranks of one length have no inflections."""

    def scene(rng):
        while True:
            try:
                return draw(rng)
            except ZeroDivisionError:
                continue

    return scene


def coupler_point(rng):
    p = Parallel(rng, length(rng))
    u = number(rng)
    return p.symbols() | {"U": u, "V": number(rng), "kappa": -1 / p.r + p.slope * (u - p.a.real)}


def watt(rng):
    p = Parallel(rng, mpf(1))
    k = number(rng)
    d = mpc(0, k)
    o_a, o_b = p.a - 1j * p.r, p.b + 1j * p.n * p.t
    symbols = p.symbols() | {"k": k, "M": abs(d - p.a), "N": abs(d - p.b), "Q": abs(o_b - o_a)}
    del symbols["S"]
    symbols |= {"theta": directed(o_a, o_b), "epsilon": turn(p.b - p.a, d - p.a)}
    for names, z in ((("U_1", "V_1"), o_a), (("U_2", "V_2"), o_b), (("UP_1", "VP_1"), p.a), (("UP_2", "VP_2"), p.b), (("U_d", "V_d"), d)):
        symbols |= dict(zip(names, (z.real, z.imag)))
    return symbols


def at_right_angles(rng):
    """Crossed cranks across the coupler: pivots (0, -R) and (1, T), pins (0, 0) and (1, 0)."""
    r = length(rng)
    t = r if rng.random() < 0.5 else length(rng)
    share = t / (r + t)

    def place(angle):
        """D for a crank turned by this angle; B is the place nearest to (1, 0)."""
        a = -1j * r + 1j * r * mp.expj(angle)
        o_b = mpc(1, t)
        d = abs(o_b - a)
        along = (d * d + 1 - t * t) / (2 * d)
        up = mp.sqrt(1 - along * along)
        u = (o_b - a) / d
        b = a + u * (along - 1j * up)
        return a + share * (b - a)

    jets = [mp.diffs(lambda x, part=part: part(place(x)), mpf(0), 4) for part in (lambda z: z.real, lambda z: z.imag)]
    # The cranks stand across the coupler, so the travel is along it.
    u, v = ([mpf(x) for x in jet] for jet in jets)
    return {"R": r, "T": t} | dict(zip(("v_2", "v_3", "v_4"), along_travel(u, v)))


def along_travel(u, v):
    """d^k v/du^k, k = 2, 3, 4, from the derivatives of both by one parameter, by undetermined coefficients."""
    uu, vv = ([c / mp.factorial(k) for k, c in enumerate(jet)] for jet in (u, v))
    uu[0] = mpf(0)
    powers = [[mpf(1), 0, 0, 0, 0]]
    for _ in range(4):
        last = powers[-1]
        powers.append([sum(last[i] * uu[k - i] for i in range(k + 1)) for k in range(5)])
    out, rest = [], [c for c in vv]
    for k in range(5):
        c = rest[k] / powers[k][k]
        rest = [x - c * y for x, y in zip(rest, powers[k])]
        out.append(c * mp.factorial(k))
    return out[2:]


SCENES = {
    "tesar1964/watt-coupler-point": pinned(coupler_point),
    "tesar1964/watt": pinned(watt),
    "tesar1964/watt-at-right-angles": at_right_angles,
}
