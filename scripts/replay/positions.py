"""Positions of a problem as (cosine, sine, x, y): exact fractions where they are, else balls."""

from flint import arb, fmpq

from outside.compare import rational

QUARTERS = {0: (1, 0), 90: (0, 1), 180: (-1, 0), 270: (0, -1)}


def turned(angle):
    """Cosine and sine; fractions where they are exact."""
    if "cos" in angle:
        return rational(angle["cos"]), rational(angle["sin"])
    if "tan_half" in angle:
        t = rational(angle["tan_half"])
        return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    (unit, text), = angle.items()
    size = rational(text)
    if size == 0:
        return fmpq(1), fmpq(0)
    if unit == "degrees":
        turn = size - 360 * fmpq((size / 360).floor())
        if turn.q == 1 and int(turn.p) in QUARTERS:
            return tuple(map(fmpq, QUARTERS[int(turn.p)]))
        half = arb(turn) / 180
        return half.cos_pi(), half.sin_pi()
    return arb(size).cos(), arb(size).sin()


def between_points(first, place):
    """The position that carries two points of the body from their first place to another one; fitted
    where their distance changes: the angle is that between the lines, the middle goes to the middle."""
    (a, b), (p, q) = ([tuple(map(rational, point)) for point in points] for points in (first, place))
    d, e = (b[0] - a[0], b[1] - a[1]), (q[0] - p[0], q[1] - p[1])
    cosine, sine = d[0] * e[0] + d[1] * e[1], d[0] * e[1] - d[1] * e[0]
    square = d[0] ** 2 + d[1] ** 2
    if square == e[0] ** 2 + e[1] ** 2:
        c, s = cosine / square, sine / square
    else:
        size = arb(cosine**2 + sine**2).sqrt()
        c, s = cosine / size, sine / size
    middle, there = (a[0] + b[0]) / 2, (a[1] + b[1]) / 2
    x, y = (p[0] + q[0]) / 2, (p[1] + q[1]) / 2
    return c, s, x - (c * middle - s * there), y - (s * middle + c * there)


def positions_of(problem):
    """All positions, and whether they are exact; balls for all of them if not."""
    listed = problem["positions"]
    out = []
    for position in listed:
        if "points" in position:
            out.append(between_points(listed[0]["points"], position["points"]))
        else:
            out.append((*turned(position["angle"]), rational(position["x"]), rational(position["y"])))
    exact = all(isinstance(number, fmpq) for position in out for number in position)
    return (out if exact else [tuple(arb(number) for number in position) for position in out]), exact


def only_translations(problem):
    """The positions with one common angle taken as zero, if all angles are written alike; else None."""
    angles = {str(sorted(position["angle"].items())) for position in problem["positions"] if "angle" in position}
    if len(angles) != 1:
        return None
    return [(fmpq(1), fmpq(0), rational(p["x"]), rational(p["y"])) for p in problem["positions"]]
