"""Four positions: both curves, the poles and their quadrilaterals, each derived anew."""

from flint import arb, ctx, fmpq

from outside.compare import Enclosure, rational

from . import cubic, quadrilateral
from .corpora import cases
from .families import ORDER, determinant, primitive
from .positions import positions_of

DIGITS = 50


class Differs(Exception):
    pass


def inverted(positions):
    """The fixed plane as the moving one sees it."""
    return [(c, -s, -(c * a + s * b), s * a - c * b) for c, s, a, b in positions]


class Form:
    """A polynomial in x and y by its coefficients; enough for a determinant of linear forms."""

    def __init__(self, table):
        self.table = table

    def __mul__(self, other):
        out = {}
        for (i, j), a in self.table.items():
            for (k, m), b in other.table.items():
                out[i + k, j + m] = out.get((i + k, j + m), 0) + a * b
        return Form(out)

    def __add__(self, other):
        out = dict(self.table)
        for key, b in other.table.items():
            out[key] = out.get(key, 0) + b
        return Form(out)

    def __sub__(self, other):
        return self + Form({key: -b for key, b in other.table.items()})


def circlepoint_curve(positions):
    """The ten coefficients: the three conditions |Z_j - M|^2 = |Z_1 - M|^2, linear in M, depend on each other."""

    def row(position):
        c, s, a, b = position
        return [(-2 * c, 2 * s, -2 * a), (-2 * s, -2 * c, -2 * b), (2 * (a * c + b * s), 2 * (b * c - a * s), a * a + b * b)]

    first, *others = map(row, positions)
    rows = []
    for r in others:
        rows.append([Form({(1, 0): p[0] - q[0], (0, 1): p[1] - q[1], (0, 0): p[2] - q[2]}) for p, q in zip(r, first)])
    table = determinant(rows).table
    return [table.get(key, 0) for key in ORDER[3]]


def pole(p, q, shift=None):
    """The point that both positions share as (moving point, fixed point), or the directions towards it.

    shift is the exact way between two positions of one angle, where that is known otherwise."""
    (c, s, a, b), (e, f, g, h) = p, q
    u, v, (x, y) = c - e, s - f, shift or (g - a, h - b)
    n = u * u + v * v
    if shift or n == 0:
        return ("undetermined", None) if x == 0 and y == 0 else ("far", ((-y * c + x * s, y * s + x * c), (-y, x)))
    z = ((x * u + y * v) / n, (y * u - x * v) / n)
    return "finite", (z, (c * z[0] - s * z[1] + a, s * z[0] + c * z[1] + b))


def shift_between(p, q):
    """From one position of a problem to another one, if both angles are written alike; else None."""
    if "angle" not in p or p["angle"] != q["angle"]:
        return None
    return tuple(rational(q[k]) - rational(p[k]) for k in "xy")


def point_agrees(shown, expected, what):
    if not isinstance(shown, list):
        raise Differs(f"{what}: {shown}, not a finite point")
    values = [Enclosure(n) for n in shown]
    size = max(abs(v.value) + v.radius for v in values)
    for v, e in zip(values, expected):
        number_agrees(v, e, size, what)


def number_agrees(v, e, size, what):
    if isinstance(e, (fmpq, int)) and v.exact:
        if v.value != e:
            raise Differs(what)
        return
    if not v.meets(arb(e)):
        raise Differs(what)
    if v.radius * fmpq(10) ** DIGITS > max(size, abs(v.value)):
        raise Differs(f"{what}: radius")


def list_agrees(shown, expected, what):
    """Primitive integers, or enclosures of which the largest is 1."""
    if all(isinstance(n, fmpq) for n in expected):
        if [fmpq(int(n if isinstance(n, str) else n["exact"])) for n in shown] != [fmpq(n) for n in primitive(expected)]:
            raise Differs(what)
        return
    if all(isinstance(n, str) for n in shown):
        # Numbers that are not rational may be so up to a factor.
        whole = [fmpq(int(n)) for n in shown]
        if whole != [fmpq(n) for n in primitive(whole)] or any(
            not (p * arb(f) - q * arb(e)).contains(0) for p, e in zip(whole, expected) for q, f in zip(whole, expected)
        ):
            raise Differs(what)
        return
    largest = quadrilateral.pick(expected, lambda a, b: abs(a) > abs(b))
    for n, e in zip(shown, expected):
        if isinstance(n, str):
            raise Differs(f"{what}: an integer")
        number_agrees(Enclosure(n), arb(e) / largest, fmpq(1), what)


def poles_agree(problem, answer, positions):
    """Compares all poles; gives the finite ones by name."""
    finite = {}
    for i in range(len(positions)):
        for j in range(i + 1, len(positions)):
            name = f"{i + 1}{j + 1}"
            shift = shift_between(problem["positions"][i], problem["positions"][j])
            sort, points = pole(positions[i], positions[j], shift)
            for block, which in (("poles", 1), ("image_poles", 0)):
                shown = answer[block][name]
                if sort == "undetermined":
                    if shown != {"undetermined": True}:
                        raise Differs(f"{block} {name}")
                elif sort == "far":
                    if "at_infinity" not in shown:
                        raise Differs(f"{block} {name}: {shown}, not at infinity")
                    list_agrees(shown["at_infinity"], points[which], f"{block} {name}")
                else:
                    point_agrees(shown, points[which], f"{block} {name}")
            finite[name] = points[1] if sort == "finite" else None
    return finite


def curve_agrees(shown, coefficients, exact, name):
    null = [c.contains(0) if isinstance(c, arb) else c == 0 for c in coefficients]
    list_agrees(shown["coefficients"], [fmpq(c) for c in coefficients] if exact else coefficients, f"{name} coefficients")
    if exact:
        kind, nodes = cubic.kind([fmpq(c) for c in coefficients])
    else:
        kind, nodes = cubic.by_tangents(coefficients), []
    if shown["type"] != kind:
        raise Differs(f"{name}: {shown['type']}, not {kind}")
    left = list(shown["nodes"])
    if len(left) != len(nodes):
        raise Differs(f"{name}: {len(left)} double points, not {len(nodes)}")
    for node in nodes:
        fitting = [p for p in left if all(Enclosure(n).meets(arb(v)) for n, v in zip(p, node))]
        if len(fitting) != 1:
            raise Differs(f"{name}: double points")
        point_agrees(fitting[0], node, f"{name} double point")
        left.remove(fitting[0])
    if all(null[:4]):
        if any(shown[part] is not None for part in ("focus", "asymptote", "midline")):
            raise Differs(f"{name}: a focus of no cubic")
        return
    point_agrees(shown["focus"], cubic.focus(coefficients), f"{name} focus")
    list_agrees(shown["asymptote"], cubic.asymptote(coefficients), f"{name} asymptote")
    list_agrees(shown["midline"], cubic.midline(coefficients), f"{name} midline")


def quadrilaterals_agree(shown, finite):
    for one, names in zip(shown, quadrilateral.ORDERS):
        points = [finite[n] for n in names]
        squared = quadrilateral.squares(points)
        relation, place = quadrilateral.comparison(squared)
        expected = (list(names), quadrilateral.shape(points), relation, place)
        if (one["vertices"], one["shape"], one["u_vs_z"], one["shortest_and_longest"]) != expected:
            raise Differs(f"quadrilateral {names}: {expected}")
        for side, square in zip(one["sides"], squared):
            if (side is None) != (square is None):
                raise Differs(f"sides of {names}")
            if side is not None:
                number = Enclosure(side)
                root = fmpq(0) if square == 0 else arb(square).sqrt()
                number_agrees(number, root, fmpq(0), f"sides of {names}")


def replay(problem, answer):
    """None where all agrees, else what differs."""
    if "undecided" in answer:
        return "undecided"
    ctx.prec = cubic.BITS
    positions, exact = positions_of(problem)
    try:
        finite = poles_agree(problem, answer, positions)
        curve_agrees(answer["circlepoint"], circlepoint_curve(positions), exact, "circlepoint curve")
        curve_agrees(answer["centerpoint"], circlepoint_curve(inverted(positions)), exact, "centerpoint curve")
        quadrilaterals_agree(answer["quadrilaterals"], finite)
    except Differs as error:
        return str(error)
    return None


def run(report):
    for problem, answer in cases("centerpoint-curve"):
        report(problem["id"], replay(problem, answer))
