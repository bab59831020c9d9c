"""The problems of every row, from a seed: a line each, of numbers p/q that every program reads."""

import random

from flint import fmpq

from outside.problems import any_turn, dyad, five, four_bar, fraction, point, text, turn

# Of five positions in doubles: how far apart, of their size, the roots of the eliminant must lie.
APART = 1e-3


def five_positions(rng, count):
    """Cosine, sine, x, y of five positions; at random, with a pair that is rational, and of a four-bar."""
    from .tools.five_positions_flint import solved

    while count:
        kind = count % 3
        if kind == 0:
            exact = [(*any_turn(rng), *point(rng)) for _ in range(5)]
        elif kind == 1:
            exact = dyad(rng, point(rng), point(rng), fraction(rng) + 7, five(rng), five(rng))[1]
        else:
            try:
                exact = four_bar(rng)[1]
            except ZeroDivisionError:
                continue
        try:
            real, pairs = solved(exact, 30)
        except (ValueError, ZeroDivisionError):
            continue
        if well_apart(real, pairs):
            count -= 1
            yield [number for position in exact for number in position]


def well_apart(real, pairs):
    """Whether no two pairs are nearly one, so that doubles can count them, and none is nearly at infinity."""
    points = [[complex(z) for z in pair] for pair in pairs]
    points += [[z.conjugate() for z in pair] for pair in points[real:]]
    if max(abs(z) for pair in points for z in pair) > 1e4:
        return False
    apart = [sum(abs(z - w) for z, w in zip(p, q)) / max(map(abs, p + q)) for i, p in enumerate(points) for q in points[:i]]
    return min(apart) > APART


def four_positions(rng, count):
    for _ in range(count):
        yield [number for _ in range(4) for number in (*any_turn(rng), *point(rng))]


def curves(rng, count):
    """Focus, alpha, beta, nu of a focal cubic Re(conj(alpha) z)|z|^2 + beta |z|^2 + Re(conj(nu) z) = 0, z from the
    focus; those with one branch and with two in turn."""
    small = lambda: fmpq(rng.randint(-99, 99), 16)  # noqa: E731
    while count:
        *focus, ax, ay, beta, nx, ny = (small() for _ in range(7))
        mean = beta * beta - 2 * (ax * nx + ay * ny)
        discriminant = mean * mean - 4 * (ax * ax + ay * ay) * (nx * nx + ny * ny)
        wanted = 1 if count % 2 else -1
        if discriminant * wanted > 1 and (ax or ay) and (nx or ny) and mean > 0:
            count -= 1
            yield [*focus, ax, ay, beta, nx, ny]


def linkages(rng, count):
    """The constants of the closed form of travel and deviation, k, a, b, d, m, g, c, (S - T)^2, (S + T)^2, of four-bars
    whose crank turns fully, and 1 or -1 for the side of the triangle."""
    sixteenths = lambda low, high: fmpq(rng.randint(16 * low, 16 * high), 16)  # noqa: E731
    while count:
        base = (sixteenths(2, 6), sixteenths(-2, 2))
        crank = (sixteenths(-1, 1), sixteenths(-1, 1))
        shape = (sixteenths(-2, 2), sixteenths(-2, 2))
        side = rng.choice((1, -1))
        rod, rocker = sixteenths(2, 8), sixteenths(2, 8)
        q, r = (x * x + y * y for x, y in (crank, base))
        # |O_bA| runs from |R - Q| to R + Q, by its squares from m - 2QR to m + 2QR: within the dead centres, and well.
        low, high = (rod - rocker) ** 2, (rod + rocker) ** 2
        if q == 0 or not (q + r - low - 1) ** 2 > 4 * q * r or not (high - 1 - q - r) ** 2 > 4 * q * r:
            continue
        if not low + 1 < q + r < high - 1:
            continue
        towards = turn(fraction(rng, 9, 4))
        times = lambda p, q: (p[0] * q[0] - p[1] * q[1], p[0] * q[1] + p[1] * q[0])  # noqa: E731
        start = times(towards, (sixteenths(-3, 3), sixteenths(-3, 3)))
        a, d = times(towards, crank), times(towards, times(shape, crank))
        b = times(towards, times(shape, base))
        g = times((base[0], -base[1]), crank)
        count -= 1
        yield [*start, *a, *b, *d, q + r, 2 * g[0], 2 * g[1], rod * rod - rocker * rocker, low, high, fmpq(side)]


def operands(rng, count):
    """Two numbers of 128 bits, the second positive."""
    for _ in range(count):
        numbers = (fmpq(rng.getrandbits(128) | 1 << 127, 1 << 127) for _ in range(2))
        yield list(numbers)


def nothing(rng, count):
    yield []


def written(make, seed, count, file):
    rng = random.Random(f"{make.__name__} {seed}")
    file.write_text("".join(" ".join(map(text, line)) + "\n" for line in make(rng, count)))
