"""All Burmester pairs of five positions by dialytic elimination.

The conditions |r_j z + t_j - M|^2 = |r_1 z + t_1 - M|^2, j = 2 .. 5, are bilinear in (x, y, h) and
(X, Y, W), homogeneous coordinates of the circlepoint and of the center: four planes times planes, met by
six points, two of which are always the circular points of both planes. In coordinates
(x, y, h) = p0 + s p1 + u p2 the conditions are A(s, u) v = 0 with a 4 x 3 matrix A that is linear in s
and u. Multiplied by 1, u, u^2 they are twelve equations, linear in v, u v, u^2 v, u^3 v. Their
determinant D(s) has the order 6; the known factor of the circular points divides it, and the four roots
that are left are the pairs, finite or not, each as often as it counts.
"""

import random

from flint import acb, acb_mat, acb_poly, arb, arb_mat, ctx, fmpq, fmpq_mat, fmpq_poly, fmpz_poly

from .field import Field, cross, minors_in, polynomial_gcd, squarefree

SAMPLES = list(range(-3, 4))


def conditions(positions):
    """The 4 x 3 matrix of linear forms, each by its coefficients of x, y, h; positions are (c, s, a, b)."""

    def row(position):
        c, s, a, b = position
        return [
            [-2 * c, 2 * s, -2 * a],
            [-2 * s, -2 * c, -2 * b],
            [2 * (a * c + b * s), 2 * (b * c - a * s), a * a + b * b],
        ]

    first, *others = map(row, positions)
    return [[[p - q for p, q in zip(form, base)] for form, base in zip(r, first)] for r in others]


def at(matrix, point):
    """The matrix of numbers at one point (x, y, h)."""
    return [[sum((f * p for f, p in zip(form, point)), 0 * point[0]) for form in r] for r in matrix]


def charts(seed):
    """Independent vectors p0, p1, p2 of small integers, ever new ones."""
    rng = random.Random(seed)
    while True:
        p = [[fmpq(rng.randint(-9, 9)) for _ in range(3)] for _ in range(3)]
        if fmpq_mat(p).det() != 0:
            yield p


def twelve(b0, b1):
    """The twelve equations as a table."""
    zero = 0 * b0[0][0]
    table = []
    for power in range(3):
        for r0, r1 in zip(b0, b1):
            table.append([zero] * (3 * power) + list(r0) + list(r1) + [zero] * (3 * (2 - power)))
    return table


def circular_factor(chart):
    """The quadratic in s whose roots belong to the circular points; None where s is real there."""
    columns = fmpq_mat(3, 3, [chart[k][i] for i in range(3) for k in range(3)])
    real = columns.solve(fmpq_mat(3, 1, [1, 0, 0]))
    imaginary = columns.solve(fmpq_mat(3, 1, [0, 1, 0]))
    a, b = real[0, 0], imaginary[0, 0]
    c, d = real[1, 0], imaginary[1, 0]
    norm = a * a + b * b
    if norm == 0 or a * d == b * c:
        return None
    # (c + id)/(a + ib)
    re, im = (a * c + b * d) / norm, (a * d - b * c) / norm
    return [re * re + im * im, -2 * re, fmpq(1)]


def vandermonde():
    return fmpq_mat([[fmpq(s) ** k for k in range(len(SAMPLES))] for s in SAMPLES]).inv()


INTERPOLATION = vandermonde()


def determinant(matrix, chart, table_of):
    """The coefficients of D(s), lowest first."""
    p0, p1, p2 = chart
    b1 = at(matrix, p2)
    values = []
    for s in SAMPLES:
        point = [u + s * v for u, v in zip(p0, p1)]
        values.append(table_of(twelve(at(matrix, point), b1)).det())
    return [
        sum((INTERPOLATION[k, i] * value for i, value in enumerate(values)), 0 * values[0])
        for k in range(len(SAMPLES))
    ]


class Family(Exception):
    """The determinant vanishes, or a circlepoint has more than one center."""


class Undecided(Exception):
    """Enclosures cannot tell."""


class Pair:
    """One class of conjugate pairs: exact coordinates in a field, or one pair by enclosures."""

    def __init__(self, multiplicity, kind, real, points, exact=None):
        self.multiplicity, self.kind, self.real, self.points, self.exact = multiplicity, kind, real, points, exact


def solve_exact(positions, bits):
    """Pairs of rational positions, and the eliminant of the finite ones in -x."""
    matrix = conditions(positions)
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
        assert rest == 0, "the circular points are not among the solutions"
        if quartic.degree() != 4:
            continue
        answer = lifted(matrix, chart, quartic, bits)
        if answer is not None:
            return answer


def lifted(matrix, chart, quartic, bits):
    """The pairs to the roots of the quartic; None where the chart puts two of them on one line."""
    pairs, eliminant = [], fmpz_poly([1])
    p0, p1, p2 = chart
    for f, multiplicity in quartic.numer().factor()[1]:
        field = Field(f)
        s = field.generator()
        b0 = at(matrix, [field.number(a) + s * field.number(b) for a, b in zip(p0, p1)])
        b0 = [[field.reduced(e) for e in r] for r in b0]
        b1 = [[field.number(e) for e in r] for r in at(matrix, p2)]
        common = squarefree(field, polynomial_gcd(field, minors_in(field, b0, b1)))
        if len(common) != 2:
            return None
        u = field.reduced(-common[0] * field.inverse(common[1]))
        point = [field.reduced(field.number(a) + s * field.number(b) + u * field.number(c)) for a, b, c in zip(p0, p1, p2)]
        rows = [[field.reduced(x + u * y) for x, y in zip(r0, r1)] for r0, r1 in zip(b0, b1)]
        center = cross(field, rows)
        if center is None:
            raise Family
        kind = place(point[2] == 0, center[2] == 0)
        values = [field.ratio(point[0], point[2]), field.ratio(point[1], point[2])] if point[2] != 0 else point[:2]
        values += [field.ratio(center[0], center[2]), field.ratio(center[1], center[2])] if center[2] != 0 else center[:2]
        if kind == "finite":
            eliminant *= field.characteristic(-values[0]) ** multiplicity
        for root, real in field.roots(bits):
            numbers = [field.evaluate(value, root, bits) for value in values]
            shown = kind if kind == "finite" or real else "isotropic"
            if kind == "both":
                shown = "isotropic"
            pairs.append(Pair(multiplicity, shown, real, numbers, (f, values)))
    content = eliminant.content()
    coefficients = [c // content for c in reversed(eliminant.coeffs())]
    if coefficients[0] < 0:
        coefficients = [-c for c in coefficients]
    return pairs, coefficients


def place(far_point, far_center):
    if far_point and far_center:
        return "both"
    if far_center:
        return "center"
    return "circlepoint" if far_point else "finite"


def solve_balls(positions):
    """Pairs of positions known by enclosures, at the precision of ctx."""
    matrix = conditions(positions)
    for chart, _ in zip(charts(1964), range(40)):
        factor = circular_factor(chart)
        if factor is None:
            continue
        chart = [[arb(e) for e in p] for p in chart]
        coefficients = [arb(c) for c in determinant(matrix, chart, arb_mat)]
        q0, q1, _ = factor
        quotient = []
        high = coefficients[:]
        for k in range(4, -1, -1):
            c = high[k + 2]
            quotient.insert(0, c)
            high[k + 1] -= c * q1
            high[k] -= c * q0
        if quotient[4].contains(0):
            continue
        try:
            roots = acb_poly([acb(c) for c in quotient]).roots(arb(2) ** -(ctx.prec // 2))
        except ValueError:
            raise Undecided from None
        if len(roots) != 4:
            raise Undecided
        found = [lifted_ball(matrix, chart, root) for root in roots]
        if any(one is None for one in found):
            continue
        pairs = []
        for root, numbers in zip(roots, found):
            mirror = acb(root.real, -root.imag)
            real = root.imag.contains(0)
            if real and sum(1 for other in roots if mirror.overlaps(other)) != 1:
                raise Undecided
            pairs.append(Pair(1, "finite", real, numbers))
        return pairs, None
    raise Undecided


def lifted_ball(matrix, chart, s):
    """x, y, X, Y from the kernel of the twelve equations, of which eleven are certified independent."""
    p0, p1, p2 = ([acb(e) for e in p] for p in chart)
    exact = [[[acb(e) for e in form] for form in r] for r in matrix]
    point = [u + s * v for u, v in zip(p0, p1)]
    table = twelve(at(exact, point), at(exact, p2))
    # One equation is left out and one unknown of the first block is put to 1.
    for dropped, unit in ((11, 0), (11, 1), (0, 2), (5, 0), (3, 1)):
        rows = [r for k, r in enumerate(table) if k != dropped]
        try:
            kernel = acb_mat([r[:unit] + r[unit + 1 :] for r in rows]).solve(acb_mat([[-r[unit]] for r in rows]))
        except ZeroDivisionError:
            continue
        v = [kernel[k, 0] for k in range(11)]
        v.insert(unit, acb(1))
        u = v[3 + unit]
        x, y, h = (a + u * b for a, b in zip(point, p2))
        if h.contains(0) or v[2].contains(0):
            raise Undecided
        return [x / h, y / h, v[0] / v[2], v[1] / v[2]]
    return None
