"""Random numbers, points and angles, and small constructions that many scenes share."""

from mpmath import mp, mpc, mpf

from ..evaluate import Angle, NoValue


def number(rng, most=5):
    """Not zero, of either sign."""
    while True:
        p = rng.randint(-100 * most, 100 * most)
        if abs(p) > 20:
            return mpf(p) / 97


def length(rng, least=0.3, most=5):
    return mpf(rng.randint(int(97 * least) + 1, 97 * most)) / 97


def point(rng, most=5):
    return mpc(number(rng, most), number(rng, most))


def radians(rng, low=-3, high=3):
    return mpf(rng.randint(int(low * 1000), int(high * 1000))) / 1000 + mpf(1) / 7919


def cis(radians_):
    return mp.expj(radians_)


def unit(rng):
    return cis(radians(rng))


def dot(p, q):
    return (mp.conj(p) * q).real


def cross(p, q):
    return (mp.conj(p) * q).imag


def crossing(p, u, q, v):
    """Where the lines through p and q in the directions u and v meet."""
    w = cross(u, v)
    if abs(w) < mpf(10) ** -9:
        raise NoValue("parallel lines")
    return p + u * (cross(q - p, v) / w)


def circumcenter(p, q, r):
    return crossing((p + q) / 2, 1j * (q - p), (p + r) / 2, 1j * (r - p))


def mirrored(z, through, direction):
    direction = direction / abs(direction)
    return through + direction**2 * mp.conj(z - through)


def directed(p, q):
    """The angle of the way from p to q."""
    return Angle(mp.arg(q - p))


def turn(u, v):
    """The angle that turns the direction u into v."""
    return Angle(mp.arg(v / u))


def midnormals(a, b, c, d):
    """Where the bisectors of ab and cd meet."""
    return crossing((a + b) / 2, 1j * (b - a), (c + d) / 2, 1j * (d - c))


def coordinates(names, z):
    """{x: Re z, y: Im z} under two names."""
    return dict(zip(names, (z.real, z.imag)))


def polynomial(values, at):
    """Coefficients, lowest first, of the polynomial that has these values."""
    matrix = mp.matrix([[mpf(x) ** k for k in range(len(at))] for x in at])
    return list(mp.lu_solve(matrix, mp.matrix(values)))
