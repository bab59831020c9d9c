"""Writes data/problems/degenerate-five-positions.jsonl: five positions of every degenerate kind.

Usage: python3 scripts/degenerate_five_positions.py [--check]

Each is built from what it is about, with the answer that follows from its construction and the reasoning.
With --check nothing is written: the answers are compared with the solver of outside/dialytic.py, where
pairs are isolated, and the file with what would be written. Needs python-flint (tried with 0.9.0).
"""

import json
import pathlib
import sys

from flint import fmpq

from outside.dialytic import Family, conditions, solve_exact
from outside.problems import (carried, configurations, conj, inverted, minus, mirrored, over, plus, shown, text, times, turn)

FILE = pathlib.Path(__file__).parent.parent / "data/problems/degenerate-five-positions.jsonl"


def q(value):
    return fmpq(*map(int, value.split("/"))) if isinstance(value, str) else fmpq(value)


def p(x, y):
    return q(x), q(y)


TURNS = [turn(q(t)) for t in (0, "1/2", "1/3", -2, "3/2")]
CRANKS = [turn(q(t)) for t in ("1/4", -1, 2, "-1/3", 5)]
ONE = p(1, 0)


def placed(turns, places):
    return [(*r, *t) for r, t in zip(turns, places)]


def point_at(z, places, turns=TURNS):
    return [carried(r, z, place) for r, place in zip(turns, places)]


def circle(m, radius, cranks=CRANKS):
    return [plus(m, (radius * c, radius * s)) for c, s in cranks]


def coupler(joints, z=p(1, 2), spin=turn(q("2/3"))):
    """Positions of a coupler by places of A and B, the moving plane turned against them; z is where A is in it."""
    (a, b), *_ = joints
    w = plus(z, times(spin, minus(b, a)))
    return [carried(over(minus(b1, a1), minus(w, z)), z, a1) for a1, b1 in joints], w


def circumcenter(a, b, c):
    u, v = minus(b, a), minus(c, a)
    d = 2 * (u[0] * v[1] - u[1] * v[0])
    m, n = u[0] ** 2 + u[1] ** 2, v[0] ** 2 + v[1] ** 2
    return plus(a, ((v[1] * m - u[1] * n) / d, (u[0] * n - v[0] * m) / d))


def in_moving(position, m):
    """Where a point of the fixed plane is in the moving one."""
    return times(conj(position[:2]), minus(m, position[2:]))


LIST = []

# What a program that fails a kind does wrong, in the words of data/problems/flags.json.
FLAGS = {
    "equal positions": ["equal-positions"],
    "translations": ["parallel-positions"],
    "parallel positions": ["parallel-positions"],
    "two angles only": ["parallel-positions"],
    "opposite angles": ["half-turn"],
    "common pole": ["coincident-poles"],
    "resting point": ["coincident-poles"],
    "line of circlepoints": ["coincident-poles"],
    "pair on a pole": ["coincident-poles"],
    "multiple pair": ["multiple-pair"],
    "source linkage": ["real-linkage"],
    "equal coordinates": ["equal-coordinates"],
    "symmetric positions": ["symmetric"],
}

# Numbers of real and complex pairs, which no construction gives: the second solver counts them.
REAL = {
    "pair-on-a-pole": (2, 2),
    "double": (4, 0),
    "slider": (1, 2),
    "slider-and-inverted-slider": (2, 0),
    "isotropic": (2, 0),
    "antiparallelogram": (2, 2),
    "kite": (2, 0),
    "slider-crank": (3, 0),
    "circlepoints-of-one-x": (4, 0),
    "centers-of-one-X": (4, 0),
    "pair-at-the-origins": (2, 2),
    "symmetric": (2, 2),
    "mirrored-in-lines": (2, 2),
    "half-turn": (2, 2),
    "four-real-pairs": (4, 0),
    "two-real-pairs": (2, 2),
    "no-real-pair": (0, 4),
}


def add(name, kind, positions, why, real, imaginary, far=(), family=None, pairs=(), distinct=None, listed=None, eliminant=None):
    """far: kinds of the pairs at infinity; pairs: known ones as circlepoint, center, multiplicity; distinct: how many `pairs` lists."""
    known = [{"circlepoint": list(map(text, z)), "center": list(map(text, m)), "multiplicity": k} for z, m, k in pairs]
    claims = {"counts": {"real": real, "complex": imaginary, "at_infinity": len(far)}, "at_infinity": sorted(far), "family": family, "listed": real if distinct is None else distinct, "pairs": known}
    flags = ["degenerate", *FLAGS.get(kind, [])]
    if family:
        flags.append("family")
    if far:
        flags.append("pair-at-infinity")
    entry = {"id": f"degenerate-five-positions/{name}", "kind": kind, "flags": flags, "note": why, "problem": "five-positions", "positions": listed or [shown(position) for position in positions], "claims": claims}
    LIST.append((entry, positions))


def equal_positions():
    four = placed(TURNS, [p(0, 0), p(3, 1), p(5, -1), p(2, 4)])[:4]
    a, b, c, d = four
    add("two-equal", "equal positions", [a, b, c, d, b], "Two equal positions ask for nothing twice, so four positions are left: every point of their circlepoint curve has a center.", 0, 0, family="circlepoint-cubic")
    add("three-equal", "equal positions", [a, b, c, b, b], "Three different positions are left, and every point has a circle through its three places (a line for the points of one circle).", 0, 0, family="plane")
    add("two-and-two-equal", "equal positions", [a, b, c, b, a], "Two equal couples leave three different positions: every point of the plane.", 0, 0, family="plane")
    add("four-equal", "equal positions", [a, b, b, b, b], "Two different positions: every point, with every center on the bisector of its two places.", 0, 0, family="plane")
    add("all-equal", "equal positions", [b] * 5, "All positions are equal: every point with every center.", 0, 0, family="plane")
    listed = [shown(position) for position in (a, b, c, d)] + [{"x": "0", "y": "0", "angle": {"degrees": "360"}}]
    add("equal-by-a-full-turn", "equal positions", [a, b, c, d, a], "A full turn is no turn: the fifth position is the first, and the circlepoint curve of four is left.", 0, 0, family="circlepoint-cubic", listed=listed)


def translations():
    r = turn(q("1/2"))
    add("translations", "translations", placed([r] * 5, [p(0, 0), p(1, 0), p(0, 1), p(2, 3), p(5, 1)]), "In a translation all points have congruent places. These five lie on no circle and no line: no point has a center, finite or not.", 0, 0)
    add("translations-on-a-circle", "translations", placed([r] * 5, [p(5, 0), p(3, 4), p(-3, 4), p(0, -5), p(4, -3)]), "The places of every point lie on a circle of radius 5.", 0, 0, family="plane")
    add("translations-on-a-line", "translations", placed([r] * 5, [p(0, 0), p(1, 2), p(2, 4), p(-1, -2), p(5, 10)]), "Every point moves along a line of the direction (1, 2): all centers are at infinity across it, no pair is finite.", 0, 0, family="plane")
    add("four-translations-on-a-circle-one-off", "translations", placed([r] * 5, [p(5, 0), p(3, 4), p(-3, 4), p(0, -5), p(4, -2)]), "Four of the five places lie on a circle, the fifth does not: no pair.", 0, 0)
    degrees = [{"x": x, "y": y, "angle": {"degrees": "40"}} for x, y in (("5", "0"), ("3", "4"), ("-3", "4"), ("0", "-5"), ("4", "-3"))]
    add("translations-in-degrees", "translations", None, "All angles are 40 degrees: the positions are translations of each other, on a circle, though the cosine is irrational; every point has a center.", 0, 0, family="plane", listed=degrees)


def parallel_positions():
    other = turn(q("1/2"))
    places = [p(0, 0), p(3, 1), p(1, 4), p(5, 2), p(-2, 7)]
    z_circles = "For parallel positions |z' - C| is one value only for the circumcenter C of the places of the origin, so that M = z' + C; each other position then asks for z on a circle."
    add("three-parallel", "parallel positions", placed([ONE, ONE, ONE, turn(q("1/3")), other], [p(0, 0), p(1, 0), p(3, 2), p(-4, 0), p(-2, 7)]), z_circles + " Two circles meet in two finite points, here not real, and in the two circular points: the couple that is isotropic.", 0, 2, far=["isotropic"] * 2)
    add("three-and-two-parallel", "two angles only", placed([ONE, ONE, ONE, other, other], places), "Two angles only: Re(r w) is the same for all positions for one direction of w = z conj(M), and with it the pair of two points at infinity satisfies all conditions, counted twice since both conics touch the line of pairs at infinity there. Three parallel positions leave M = z' + C; z is on two circles about one radius each, whose finite meets are not real.", 0, 2, far=["isotropic"] * 2)
    add("half-turns-only", "two angles only", placed([ONE, ONE, ONE, p(-1, 0), p(-1, 0)], places), "All angles are 0 or 180 degrees, two angles only: a pair of two points at infinity, counted twice, and two circles that meet in no real point.", 0, 2, far=["isotropic"] * 2)
    add("four-parallel", "parallel positions", placed([ONE] * 4 + [other], [p(0, 0), p(3, 1), p(1, 4), p(5, 2), p(-2, 7)]), "Four parallel positions whose places lie on no circle and no line: no point of the plane has a center even in these four.", 0, 0)
    add("four-parallel-on-a-circle", "parallel positions", placed([ONE] * 4 + [other], [p(5, 0), p(3, 4), p(-3, 4), p(0, -5), p(-2, 7)]), "M = z + C for the center C = 0 of the circle of the four; the fifth position asks for |r z + t - z| = 5: all points of a circle, one center each.", 0, 0, family="circle")
    add("four-parallel-on-a-line", "parallel positions", placed([ONE] * 4 + [other], [p(0, 0), p(1, 0), p(3, 0), p(-4, 0), p(-2, 7)]), "Every point moves along a line in the first four positions; the fifth is on it for the points of one line: a line of circlepoints, all centers at infinity in one direction. No finite pair.", 0, 0, family="line")


def common_points():
    z = p(1, 2)
    a, b, c = p(0, 0), p(6, 2), p(5, -3)
    add("common-pole", "common pole", point_at(z, [a] * 5), "All displacements are turns about one point: every point moves on a circle about it.", 0, 0, family="plane")
    positions = point_at(z, [a, a, a, a, b])
    add("four-turns-about-a-point", "resting point", positions, "A point rests in four positions, so that its places are two points and every point of their bisector is a center. The resting place A seen from the moving plane has two places as well: every point of the bisector of these has the center A. Line and point, the latter as an isotropic pair of lines, are a cubic of circlepoints.", 0, 0, family="circlepoint-cubic")
    positions = point_at(z, [a, a, a, b, b])
    m4, m5 = in_moving(positions[3], a), in_moving(positions[4], a)
    add("resting-in-three-and-two", "resting point", positions, "A point has two places only, A in three positions and B in two: every point of the bisector of AB is a center. A itself, seen from the moving plane, has three places: their circumcenter has the center A, an isolated pair beside the family. B has four places on no circle.", 1, 0, family="point-with-any-center", pairs=[(circumcenter(z, m4, m5), a, 1)])
    dual = inverted(positions)
    add("center-of-a-line", "line of circlepoints", dual, "The inverse of resting-in-three-and-two: a point of the fixed plane has two places in the moving one, and every point of their bisector has it for a center. Beside it one pair.", 1, 0, family="line", pairs=[(a, circumcenter(z, m4, m5), 1)])
    add("pair-on-a-pole-of-three", "pair on a pole", point_at(z, [a, a, a, b, c]), "A point rests in three positions, where the poles 12, 23, 13 coincide; with two other places it has one circle: an ordinary pair.", 2, 2, pairs=[(z, circumcenter(a, b, c), 1)])
    cranks = [CRANKS[0], *CRANKS[:4]]
    add("pair-on-a-pole", "pair on a pole", point_at(z, circle(p(3, -1), q(4), cranks)), "The circlepoint is the pole of positions 1 and 2: it has one place in both, four places in all, on a circle by construction.", *REAL["pair-on-a-pole"], pairs=[(z, p(3, -1), 1)])


def multiple_pairs():
    unit = [turn(q(t)) for t in (0, "1/2", "1/3", -2, 3)]
    add("quadruple", "multiple pair", placed([times(p(-1, 0), times(c, c)) for c in unit], unit), "Each position is the plane mirrored in a line that touches one circle. With r = -c^2, t = c a pair near (0, 0) changes the radius by -Re c(dz + conj dM), which vanishes for dM = -conj dz: two directions, so that the pair counts three times at least. The positions are symmetric in (z, M) and (conj M, conj z), which leaves (0, 0) and moves every pair that is not of the form (z, conj z), of which there are no others: the number is even, and four.", 4, 0, pairs=[(p(0, 0), p(0, 0), 4)], distinct=1)
    c2, g2, c4, g4 = p("4/5", "3/5"), p("3/5", "4/5"), p("-4/5", "3/5"), p("3/5", "4/5")
    turns = [(ONE, ONE), (times(c2, g2), c2), (conj(times(c2, g2)), conj(c2)), (times(c4, g4), c4), (conj(times(c4, g4)), conj(c4))]
    add("triple", "multiple pair", placed([r for r, _ in turns], [c for _, c in turns]), "Positions 2 and 3, 4 and 5 are mirrored in the axis of position 1; (0, 0) is a pair. The sines of r/c are those of c times 4/3, so that a pair across the axis moves without a change of the radius: (0, 0) is multiple. It is simple among the pairs on the axis, the others are couples of mirrored ones: the number is odd, three. The fourth is on the axis.", 4, 0, pairs=[(p(0, 0), p(0, 0), 3)], distinct=2)
    gears, cranks = [CRANKS[1], TURNS[1], TURNS[2], TURNS[4]], CRANKS[:4]

    def products(of):
        return [times(conj(of[i]), of[j])[0] - 1 for i, j in ((1, 2), (2, 0), (0, 1))]

    u, v = products(gears), products(cranks)
    n = [u[i] * v[j] - u[j] * v[i] for i, j in ((1, 2), (2, 0), (0, 1))]
    weights = [n[1] * n[2], n[0] * n[2], n[0] * n[1]]
    total = sum(weights, q(0))
    mean = lambda points: tuple(sum((w * point[k] for w, point in zip(weights, points)), q(0)) / total for k in range(2))
    gears, cranks = [*gears, mean(gears)], [*cranks, mean(cranks)]
    rotations = [times(g, c) for g, c in zip(gears, cranks)]
    z, m = p(1, -2), p(2, 1)
    add("double", "multiple pair", point_at(z, circle(m, q(3), cranks), rotations), "With g = r/c a direction (dz, dM) leaves the radius as it is if Re(g dz) - Re(conj(c) dM) is one value: for four positions there is such a direction. The fifth (g, c) is the other meet of the plane through three of them with both unit circles, and lies on that plane: the direction is one for all five.", *REAL["double"], pairs=[(z, m, 2)], distinct=REAL["double"][0] - 1)


def infinite_pairs():
    line = [plus(p(1, 0), p(3 * k, k)) for k in (0, 1, -2, 4, 7)]
    slider = point_at(p(2, 1), line)
    add("slider", "center at infinity", slider, "The point (2, 1) moves along a line: its center is at infinity.", *REAL["slider"], far=["center"])
    add("inverted-slider", "circlepoint at infinity", inverted(slider), "The inverse of a slider: a line of the moving plane passes through the fixed point (2, 1).", *REAL["slider"], far=["circlepoint"])
    turns = [turn(q(t)) for t in ("1/5", "1/2", "1/3", -2, "3/2")]
    places = [((q(2) - 3 * c) / s, q(0)) for c, s in turns]
    add("slider-and-inverted-slider", "both kinds at infinity", placed(turns, places), "The origin moves along the axis; t is chosen such that the fixed point (0, 3) is on the moving line y = 2 in all positions.", *REAL["slider-and-inverted-slider"], far=["center", "circlepoint"])
    m, w, v, k = p(2, 0), p(1, 1), p(0, 2), p(1, -1)
    rows = []
    for r in TURNS:
        sum_ = plus(plus(times(r, w), times(conj(r), v)), k)
        rows.append((*r, *conj(over(sum_, minus(r, m)))))
    add("isotropic", "isotropic pair", rows, "t is solved from conj(t)(r - 2) = (1 + i) r + 2i conj(r) + 1 - i, the conditions of a pair of the isotropic directions with z = 1, M = 2, conj z = conj M = 0 (taken as independent numbers): such a pair and its conjugate are at infinity.", *REAL["isotropic"], far=["isotropic"] * 2)
    joints = []
    for t in (0, "1/2", "1/3", -2, "3/2"):
        c, s = turn(q(t))
        joints.append(((5 * c, q(0)), (q(0), 5 * s)))
    trammel, _ = coupler(joints, p(0, 0), ONE)
    middle = times(minus(joints[0][1], joints[0][0]), p("1/2", 0))
    add("trammel", "sliders on a circle", trammel, "A and B move along two lines at right angles: so does every point of the circle of the diameter AB, each along a line through the meet of both (Cardan): infinitely many centers at infinity. The middle of AB moves on a circle about the meet, the only finite pair.", 1, 0, family="circle", pairs=[(middle, p(0, 0), 1)])


def linkages():
    a0, b0, a, b = p(0, 0), p(4, 1), p(1, 2), p(5, 4)
    z = p(1, 2)
    rhombus = [(m, plus(m, p(4, 1))) for m in circle(p(0, 0), q(2))]
    positions, _ = coupler(rhombus)
    add("parallelogram", "source linkage", positions, "The coupler of a parallelogram moves by translations along a circle: every point has a center.", 0, 0, family="plane")
    crossed = [(one, mirrored(other, one, b0)) for one, other in rhombus]
    positions, w = coupler(crossed)
    add("antiparallelogram", "source linkage", positions, "The parallelogram folded over its diagonal AB0. Coupler and base are mirrored in a line that moves; the joints are two pairs, and the others mirror each other.", *REAL["antiparallelogram"], pairs=[(z, a0, 1), (w, b0, 1)])
    kite = [(m, mirrored(p(0, 0), m, p(4, 1))) for m in circle(p(0, 0), q(2))]
    positions, w = coupler(kite)
    add("kite", "source linkage", positions, "A0A = AB and B0B = B0A0: B is A0 mirrored in AB0. The joints are two pairs, the others an isotropic couple.", *REAL["kite"], far=["isotropic"] * 2, pairs=[(z, a0, 1), (w, b0, 1)])
    joints = [(p(3, 4), p(6, 0))]
    for k in range(4):
        joints.append(slider_crank_folded(*joints[-1], k))
    positions, w = coupler(joints)
    add("slider-crank", "source linkage", positions, "A slider-crank whose crank turns about (0, 1), B on the axis: one joint is a pair, the other has its center at infinity.", *REAL["slider-crank"], far=["center"], pairs=[(z, p(0, 1), 1)])
    configured = configurations(a0, b0, a, p(4, 6))
    w = p(1, 7)
    positions = [carried(over(minus(b1, a1), minus(w, z)), z, a1) for a1, b1 in configured]
    add("circlepoints-of-one-x", "equal coordinates", positions, "A four-bar with AB = 5, placed such that both circlepoints have the coordinate x = 1: the eliminant has a double root, the pairs are different.", *REAL["circlepoints-of-one-x"], pairs=[(z, a0, 1), (w, b0, 1)])
    b0 = p(0, 4)
    positions, w = coupler(configurations(a0, b0, a, b))
    add("centers-of-one-X", "equal coordinates", positions, "A four-bar whose pivots have one coordinate X.", *REAL["centers-of-one-X"], pairs=[(z, a0, 1), (w, b0, 1)])
    add("pair-at-the-origins", "equal coordinates", point_at(p(0, 0), circle(p(0, 0), q(3))), "Circlepoint and center are the origins of their planes: a root 0 of the eliminant.", *REAL["pair-at-the-origins"], pairs=[(p(0, 0), p(0, 0), 1)])


def slider_crank_folded(a, b, k):
    """A mirrored in the line from the pivot (0, 1) to B, or B in the perpendicular from A to the axis."""
    return (mirrored(a, p(0, 1), b), b) if k % 2 == 0 else (a, (2 * a[0] - b[0], q(0)))


def symmetric():
    couple = [(turn(q("1/2")), p(3, 1)), (turn(q(-2)), p(-1, 4))]
    rows = [(*ONE, *p(5, 0))]
    for r, t in couple:
        rows += [(*r, *t), (*conj(r), *conj(t))]
    add("symmetric", "symmetric positions", rows, "Positions mirrored in an axis: pairs on the axis, or couples of mirrored ones.", *REAL["symmetric"])
    mirrors = []
    for t, s in zip((0, "1/2", "1/3", -2, "3/2"), (0, 3, -2, 5, 1)):
        half = turn(q(t))
        mirrors.append((*times(half, half), *times((q(0), q(s)), half)))
    add("mirrored-in-lines", "symmetric positions", mirrors, "Each position is the plane mirrored in a line (of a symmetric motion): with (z, M) also (conj M, conj z) is a pair.", *REAL["mirrored-in-lines"])
    listed = placed([ONE, p(-1, 0), TURNS[1], TURNS[2], p(0, 1)], [p(0, 0), p(3, 1), p(5, 2), p(-4, 1), p(2, 7)])
    spelled = [shown(position) for position in listed]
    for k, degrees in ((0, "0"), (1, "180"), (4, "90")):
        spelled[k]["angle"] = {"degrees": degrees}
    add("half-turn", "opposite angles", listed, "Positions 1 and 2 differ by a half turn, which has no tangent of the half angle; degrees that are multiples of 90 are exact.", *REAL["half-turn"], listed=spelled)


def numbers_of_real_pairs():
    for name, rows in SEARCHED.items():
        positions = [(*turn(q(t)), q(a), q(b)) for t, a, b in rows]
        add(name, "number of real pairs", positions, f"Chosen for its number of real pairs: {name.replace('-', ' ')}.", *REAL[name])


SEARCHED = {
    "four-real-pairs": [(0, 0, 0), ("-1/3", 3, 0), ("-1/2", -4, 2), (2, -6, 6), (2, 2, 2)],
    "two-real-pairs": [(0, 0, 0), ("-1/2", 3, 6), ("1/3", -2, -5), ("1/4", 6, 1), ("1/4", 4, 0)],
    "no-real-pair": [(0, 0, 0), (2, -1, -3), (2, 6, 1), (-2, -6, 0), (3, 4, -5)],
}


def real_counts(positions):
    pairs, _ = solve_exact(positions, 300)
    finite = [pair for pair in pairs if pair.kind == "finite"]
    real = sum(pair.multiplicity for pair in finite if pair.real)
    return real, sum(pair.multiplicity for pair in finite) - real


def agrees(entry, positions):
    """What the second solver says against an entry; None if it agrees or cannot judge."""
    expected = entry["claims"]
    if positions is None:
        return None
    matrix = conditions(positions)
    for pair in expected["pairs"]:
        x, y = map(q, pair["circlepoint"])
        u, v = map(q, pair["center"])
        for row in matrix:
            if sum((f[0] * x + f[1] * y + f[2]) * w for f, w in zip(row, (u, v, q(1)))) != 0:
                return "a known pair is none"
    try:
        pairs, _ = solve_exact(positions, 300)
    except Family:
        return None if expected["family"] or "infinity" in entry["note"] or not sum(expected["counts"].values()) else "a family"
    counts = {"real": 0, "complex": 0, "at_infinity": 0}
    for pair in pairs:
        counts["at_infinity" if pair.kind != "finite" else "real" if pair.real else "complex"] += pair.multiplicity
    kinds = sorted(pair.kind for pair in pairs if pair.kind != "finite" for _ in range(pair.multiplicity))
    listed = sum(1 for pair in pairs if pair.kind == "finite" and pair.real)
    if expected["family"] or (counts, kinds, listed) != (expected["counts"], expected["at_infinity"], expected["listed"]):
        return f"{counts}, {kinds}, {listed} listed"
    return None


def main():
    for make in (equal_positions, translations, parallel_positions, common_points, multiple_pairs, infinite_pairs, linkages, symmetric, numbers_of_real_pairs):
        make()
    wrong = [(entry["id"], verdict) for entry, positions in LIST if (verdict := agrees(entry, positions))]
    for name, verdict in wrong:
        print(f"{name}: the second solver finds {verdict}")
    lines = "".join(json.dumps(entry) + "\n" for entry, _ in LIST)
    if "--check" in sys.argv:
        wrong += [("file", "differs")] if FILE.read_text() != lines else []
    elif not wrong:
        FILE.parent.mkdir(exist_ok=True)
        FILE.write_text(lines)
    print(f"{len(LIST)} problems, {len(wrong)} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
