"""Five positions: every answer against the dialytic elimination of `outside/`."""

from collections import Counter

from flint import arb, ctx, fmpq, fmpq_poly, fmpz_poly

from outside.compare import Disagreement, Enclosure, compared, matched, parts, rational
from outside.dialytic import Family, Pair, Undecided, solve_balls, solve_exact

from .corpora import cases
from .families import coefficients, common_part, primitive, resting_points
from .isolated import center, finite_points
from .positions import only_translations, positions_of

DIGITS = 50
BITS = 2000
NAMES = {3: "circlepoint-cubic", 2: "circle", 1: "line"}


def sharp(pairs):
    """Whether the second solver's balls are much narrower than the answer's."""
    for pair in pairs:
        largest = max(abs(value).upper() for value in pair.points)
        for value in pair.points:
            for part in (value.real, value.imag):
                if part.rad() != 0 and not part.rad() * arb(10) ** (DIGITS + 10) < largest:
                    return False
    return True


def solved(problem, exact):
    for bits in (500, 1500, 5000, 20000):
        ctx.prec = bits
        positions, _ = positions_of(problem)
        try:
            found = solve_exact(positions, bits) if exact else solve_balls(positions)
        except Undecided:
            continue
        if sharp(found[0]):
            return found
    raise Undecided


def normal_form(answer):
    """Disagreement where an exact direction is not in primitive integers, the first that is not zero positive."""
    for pair in answer["at_infinity"]:
        direction = [Enclosure(number) for number in pair.get("direction", [])]
        if direction and all(number.exact for number in direction):
            if [number.value for number in direction] != list(primitive([number.value for number in direction])):
                raise Disagreement("a direction that is not primitive")


def undecided(answer):
    names = [name.strip() for name in answer.get("undecided", "").split(",")]
    return any(name in ("pairs", "complex_pairs", "at_infinity", "family", "counts", "eliminant") for name in names)


def known_pairs(problem):
    return [
        ([rational(n) for n in pair["circlepoint"]], [rational(n) for n in pair["center"]])
        for pair in problem.get("claims", {}).get("known_pairs", [])
    ]


def replay(problem, answer):
    """None where all agrees, else what differs."""
    if undecided(answer):
        return "undecided"
    _, exact = positions_of(problem)
    try:
        if exact:
            try:
                pairs, eliminant = solved(problem, True)
            except Family:
                return beyond_the_quartic(positions_of(problem)[0], answer)
        elif answer["family"] and only_translations(problem):
            return beyond_the_quartic(only_translations(problem), answer)
        else:
            pairs, eliminant = solved(problem, False)
            if answer["eliminant"] is not None:
                return "an eliminant of positions that are not rational"
        normal_form(answer)
        worst = compared(answer, pairs, eliminant, known_pairs(problem), DIGITS)
    except Disagreement as error:
        return str(error)
    except Undecided:
        return "undecided by the replay"
    return None if worst <= 1 else f"radius {worst:.3g} times what is promised"


def beyond_the_quartic(positions, answer):
    """Families, and positions with two angles only, whose circlepoints at infinity are without number."""
    common, rest = common_part(positions)
    family = answer["family"]
    if common is None:
        if family is None or family["kind"] != "plane":
            return "every point is a circlepoint, and the answer has no such family"
        return directions(positions, family)
    degree = common.total_degree()
    resting = resting_points(positions)
    if degree > 0:
        if family is None or family["kind"] != NAMES[degree]:
            return f"the circlepoints fill a {NAMES[degree]}"
        if [str(c) for c in coefficients(common, degree)] != family["coefficients"]:
            return "other coefficients of the family"
    elif resting:
        if family is None or family["kind"] != "point-with-any-center":
            return "a circlepoint with a line of centers is missing"
        point = [Enclosure(n).value for n in family["circlepoint"]]
        if tuple(point) not in resting:
            return "the circlepoint with many centers is another one"
    elif family is not None:
        return "a family where there is none"
    if answer["eliminant"] is not None and family is not None:
        return "an eliminant beside a family"
    return isolated(positions, rest, common, answer)


def directions(positions, family):
    """On one line the centers of translations are at infinity, across the line."""
    (_, _, x0, y0), *others = positions
    moves = [(x - x0, y - y0) for c, s, x, y in others if (x, y) != (x0, y0)]
    straight = all(p[:2] == positions[0][:2] for p in positions) and moves and all(moves[0][0] * v == moves[0][1] * u for u, v in moves)
    across = primitive([-moves[0][1], moves[0][0]]) if straight and len(moves) > 1 else None
    shown = family.get("center")
    if across is None or len({m for m in moves}) < 3 and shown is None:
        return None if shown is None else "a direction that is none"
    if shown is None or [Enclosure(n).value for n in shown["at_infinity"]] != [fmpq(n) for n in across]:
        return "another direction of the centers"
    return None


def isolated(positions, rest, common, answer):
    """The finite pairs beside a family: points where what is left of all minors vanishes."""
    pairs, product = [], fmpz_poly([1])
    for field, x, y in finite_points(rest):
        far = center(positions, field, x, y)
        if far is None or far[2] == 0 or field.reduced(common_at(common, x, y)) == 0:
            continue
        product *= field.characteristic(-x)
        values = [x, y, field.ratio(far[0], far[2]), field.ratio(far[1], far[2])]
        for root, real in field.roots(BITS):
            pairs.append(Pair(1, "finite", real, [field.evaluate(v, root, BITS) for v in values]))
    try:
        for name, real in (("pairs", True), ("complex_pairs", False)):
            shown = [([parts(p, "circlepoint"), parts(p, "center")], p["multiplicity"]) for p in answer[name]]
            matched(shown, [pair for pair in pairs if pair.real == real], name)
    except Disagreement as error:
        return str(error)
    counts = {name: sum(pair.real == real for pair in pairs) for name, real in (("real", True), ("complex", False))}
    shown = {name: answer["counts"][name] for name in counts}
    if shown != counts:
        return f"counts {shown}, not {counts}"
    return rest_of_two_angles(positions, answer, len(pairs), product) if answer["family"] is None else None


def rest_of_two_angles(positions, answer, finite, product):
    """Three and two parallel positions have a pair of two points at infinity, in one direction of z conj(M), which makes up four.

    Four parallel ones of which no point has a center leave nothing."""
    if sorted(Counter(tuple(map(str, position[:2])) for position in positions).values()) == [2, 3]:
        if [pair["kind"] for pair in answer["at_infinity"]] != ["isotropic"] * (4 - finite):
            return "other pairs at infinity"
        expected = [str(c) for c in primitive(list(reversed(product.coeffs())))]
        return None if answer["eliminant"] == expected else "another eliminant"
    if answer["at_infinity"] or answer["eliminant"] not in (None, ["1"]):
        return "pairs at infinity or an eliminant where nothing is left"
    return None


def common_at(common, x, y):
    """The value of the common factor at h = 1."""
    out = fmpq_poly([0])
    for key, value in common.to_dict().items():
        out += value * x ** int(key[0]) * y ** int(key[1])
    return out


def run(report):
    for problem, answer in cases("five-positions"):
        report(problem["id"], replay(problem, answer))
