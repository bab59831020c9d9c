"""Two and three positions: poles, turns, centers of given points, and the circles of points on lines."""

from flint import arb, ctx, fmpq

from outside.compare import Enclosure, rational

from . import cubic
from .centerpoint import Differs, inverted, list_agrees, number_agrees, point_agrees, poles_agree
from .corpora import cases
from .positions import positions_of


def places(positions, z):
    return [(c * z[0] - s * z[1] + a, s * z[0] + c * z[1] + b) for c, s, a, b in positions]


def equal(p, q):
    return all(n.contains(0) if isinstance(n, arb) else n == 0 for n in (p[0] - q[0], p[1] - q[1]))


def center(positions, z):
    """("finite", center), ("far", direction across the line of the places), or ("undetermined", None)."""
    p, q, r = places(positions, z)
    if equal(p, q) or equal(q, r) or equal(p, r):
        return "undetermined", None
    (a, b), (c, d) = ((q[0] - p[0], q[1] - p[1]), (r[0] - p[0], r[1] - p[1]))
    w = 2 * (a * d - b * c)
    if w == 0:
        return "far", (-b, a)
    first, second = a * a + b * b, c * c + d * d
    x, y = (d * first - b * second) / w, (a * second - c * first) / w
    return "finite", ((p[0] + x, p[1] + y), x * x + y * y)


def on_a_line(positions):
    """a (x^2 + y^2) + b x + c y + d, which is zero where the three places of (x, y) lie on one line."""
    base, *others = positions
    (p, q), (s, u) = (((f[0] - base[0], f[1] - base[1]), (f[2] - base[2], f[3] - base[3])) for f in others)

    def times(f, g):
        """conj(f) g"""
        return f[0] * g[0] + f[1] * g[1], f[0] * g[1] - f[1] * g[0]

    k, m = times(p, u), times(q, s)
    return times(p, s)[1], k[1] + m[1], m[0] - k[0], times(q, u)[1]


def circle_agrees(shown, circle, what):
    a, b, c, d = circle
    null = [n.contains(0) if isinstance(n, arb) else n == 0 for n in circle]
    if all(null):
        if shown is not None:
            raise Differs(f"{what} where every point lies on a line")
        return
    list_agrees(shown["coefficients"], circle, what)
    if null[0]:
        if shown["center"] is not None or shown["radius"] is not None:
            raise Differs(f"{what}: a center of a line")
        return
    middle = -b / (2 * a), -c / (2 * a)
    point_agrees(shown["center"], middle, f"{what}: center")
    radius_agrees(shown["radius"], middle[0] ** 2 + middle[1] ** 2 - d / a, what)


def radius_agrees(shown, square, what):
    root = fmpq(0) if isinstance(square, fmpq) and square == 0 else arb(square).sqrt()
    number_agrees(Enclosure(shown), root, fmpq(0), f"{what}: radius")


def pairs_agree(problem, answer, positions):
    asked = [(positions, z, "circlepoint", "center") for z in problem["circlepoints"]]
    asked += [(inverted(positions), z, "center", "circlepoint") for z in problem["centers"]]
    if len(asked) != len(answer["pairs"]):
        raise Differs("the number of pairs")
    for (motion, given, known, wanted), shown in zip(asked, answer["pairs"]):
        z = tuple(map(rational, given))
        if isinstance(motion[0][0], arb):
            z = tuple(map(arb, z))
        point_agrees(shown[known], tuple(map(rational, given)), "the given point")
        sort, found = center(motion, z)
        if sort == "undetermined":
            if shown[wanted] != {"undetermined": True}:
                raise Differs(f"{wanted} of {given}: not determined")
        elif sort == "far":
            if "at_infinity" not in shown[wanted]:
                raise Differs(f"{wanted} of {given}: at infinity")
            list_agrees(shown[wanted]["at_infinity"], found, f"{wanted} of {given}")
        else:
            point_agrees(shown[wanted], found[0], f"{wanted} of {given}")
            radius_agrees(shown["radius"], found[1], f"{wanted} of {given}")


def turns_agree(answer, positions):
    for name, shown in answer.get("turns", {}).items():
        p, q = (positions[int(k) - 1] for k in name)
        cosine, sine = p[0] * q[0] + p[1] * q[1], p[0] * q[1] - p[1] * q[0]
        degrees = arb.atan2(arb(sine), arb(cosine)) * 180 / arb.pi()
        if isinstance(sine, fmpq) and sine == 0:
            degrees = fmpq(0 if cosine > 0 else 180)
        number_agrees(Enclosure(shown["degrees"]), degrees, fmpq(0), f"turn {name}")


def replay(problem, answer):
    if "undecided" in answer:
        return "undecided"
    ctx.prec = cubic.BITS
    positions, exact = positions_of(problem)
    try:
        poles_agree(problem, answer, positions)
        turns_agree(answer, positions)
        if problem["problem"] == "three-positions":
            circle_agrees(answer["points_on_lines"], on_a_line(positions), "the points on lines")
            circle_agrees(answer["centers_of_lines"], on_a_line(inverted(positions)), "the centers of lines")
            pairs_agree(problem, answer, positions)
    except Differs as error:
        return str(error)
    return None


def run(report):
    for kind in ("poles", "three-positions"):
        for problem, answer in cases(kind):
            report(problem["id"], replay(problem, answer))
