"""Five positions of which some have come together, and coupler motions given by links: the dialytic elimination.

The condition |Z(t) - M|^2 = const is bilinear in (x, y, 1) and (X, Y, 1); its Taylor coefficients take the
place of the differences between positions."""

from flint import ctx, fmpq, fmpq_mat, fmpq_poly

from outside.compare import Disagreement, compared, rational
from outside.dialytic import Family, charts, circular_factor, determinant, lifted

from .corpora import cases
from .families import H, X, Y, minors
from .five_positions import DIGITS, normal_form, sharp, undecided
from .positions import turned


def series_times(p, q):
    """A product, as many terms as both have."""
    return [sum((p[i] * q[k - i] for i in range(k + 1)), fmpq(0)) for k in range(min(len(p), len(q)))]


def turned_on(cosine, sine, angle):
    """Cosine and sine of an angle that changes: angle[0] is passed as cosine and sine."""
    c, s = [cosine], [sine]
    for k in range(1, len(angle)):
        # c' = -s a', s' = c a'.
        c.append(-sum((s[k - j] * j * angle[j] for j in range(1, k + 1)), fmpq(0)) / k)
        s.append(sum((c[k - j] * j * angle[j] for j in range(1, k + 1)), fmpq(0)) / k)
    return c, s


def rows(c, s, a, b):
    """Per power of t the condition's 3 x 3 table: rows for X, Y, 1, columns for x, y, 1."""

    def sum_of(*terms):
        return [sum(parts, fmpq(0)) for parts in zip(*terms)]

    def times(f, p):
        return [f * x for x in p]

    ac, bs, bc, as_ = (series_times(p, q) for p, q in ((a, c), (b, s), (b, c), (a, s)))
    first = sum_of(times(2, ac), times(2, bs))
    second = sum_of(times(2, bc), times(-2, as_))
    third = sum_of(series_times(a, a), series_times(b, b))
    return [
        [[-2 * c[k], 2 * s[k], -2 * a[k]], [-2 * s[k], -2 * c[k], -2 * b[k]], [first[k], second[k], third[k]]]
        for k in range(len(c))
    ]


def conditions(positions):
    """Four tables: differences of different positions, Taylor coefficients of those that came together."""
    out, base = [], None
    for position in positions:
        more = position.get("derivatives", [])
        cosine, sine = turned(position["angle"])
        factorials = [1, 1, 2, 6, 24]

        def taylor(name, first):
            return [first] + [rational(d[name]) / factorials[k] for k, d in enumerate(more, 1)]

        c, s = turned_on(cosine, sine, taylor("angle", fmpq(0)))
        tables = rows(c, s, taylor("x", rational(position["x"])), taylor("y", rational(position["y"])))
        if base is None:
            base = tables[0]
        else:
            out.append([[p - q for p, q in zip(r, z)] for r, z in zip(tables[0], base)])
        out += tables[1:]
    return out


def solved(matrix, bits):
    """All pairs and the eliminant of four bilinear conditions."""
    vanishing = 0
    for chart in charts(1964):
        factor = circular_factor(chart)
        if factor is None:
            continue
        d = fmpq_poly(determinant(matrix, chart, fmpq_mat))
        if d == 0:
            vanishing += 1
            if vanishing == 3:
                raise Family
            continue
        quartic, rest = divmod(d, fmpq_poly(factor))
        if rest == 0 and quartic.degree() == 4 and (answer := lifted(matrix, chart, quartic, bits)):
            return answer


def as_forms(matrix):
    return [[a * X + b * Y + c * H for a, b, c in table] for table in matrix]


def agrees(matrix, answer):
    """None where the pairs of the conditions are those of the answer."""
    if undecided(answer):
        return "undecided"
    try:
        for bits in (600, 2000, 8000):
            ctx.prec = bits
            pairs, eliminant = solved(matrix, bits)
            if sharp(pairs):
                break
        normal_form(answer)
        worst = compared(answer, pairs, eliminant, [], DIGITS)
    except Family:
        everywhere = all(minor.is_zero() for minor in minors(as_forms(matrix)))
        expected = {"kind": "plane"} if everywhere else None
        return "not replayed: a family" if not everywhere else None if answer["family"] == expected else "every point is a circlepoint"
    except Disagreement as error:
        return str(error)
    return None if worst <= 1 else f"radius {worst:.3g} times what is promised"


def replay(problem, answer):
    return agrees(conditions(problem["positions"]), answer)


def run(report):
    for problem, answer in cases("mixed-positions"):
        report(problem["id"], replay(problem, answer))
