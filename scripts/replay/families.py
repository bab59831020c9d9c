"""Infinitely many pairs of five positions: common parts of the four determinants of order three.

A circlepoint (x, y, h) has a center where the 4 x 3 matrix of the conditions, linear in x, y, h, has a
rank below three. So a family is a common factor of its minors (all of them zero: the plane), or a point
at which the rank is below two. What is left when the factor is divided out holds the isolated pairs.
"""

from flint import Ordering, fmpq, fmpq_mpoly_ctx, fmpz

from outside.dialytic import conditions

CONTEXT = fmpq_mpoly_ctx.get(("x", "y", "h"), Ordering.lex)
X, Y, H = CONTEXT.gens()
ORDER = {3: [(3, 0), (2, 1), (1, 2), (0, 3), (2, 0), (1, 1), (0, 2), (1, 0), (0, 1), (0, 0)],
         2: [(2, 0), (1, 1), (0, 2), (1, 0), (0, 1), (0, 0)],
         1: [(1, 0), (0, 1), (0, 0)]}


def forms(positions):
    """The conditions as linear forms in x, y, h."""
    return [[a * X + b * Y + c * H for a, b, c in row] for row in conditions(positions)]


def determinant(rows):
    (a, b, c), (d, e, f), (g, h, i) = rows
    return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)


def minors(matrix):
    return [determinant([row for k, row in enumerate(matrix) if k != left]) for left in range(4)]


def primitive(numbers):
    """Primitive integers, the first that is not zero positive."""
    numbers = [fmpq(n) for n in numbers]
    common = fmpz(1)
    for n in numbers:
        common = common.lcm(n.q)
    whole = [(n * common).p for n in numbers]
    content = fmpz(0)
    for n in whole:
        content = content.gcd(n)
    if content == 0:
        return whole
    first = next(n for n in whole if n != 0)
    return [n / (content if first > 0 else -content) for n in map(fmpq, whole)]


def coefficients(polynomial, degree):
    """Of x^degree and so on down to 1, as an answer lists them."""
    table = {tuple(map(int, key)): value for key, value in polynomial.to_dict().items()}
    return primitive([table.get((i, j, degree - i - j), fmpq(0)) for i, j in ORDER[degree]])


def common_part(positions):
    """The common factor of the minors without that of the line at infinity, and the minors without it; None if all vanish."""
    all_minors = [m for m in minors(forms(positions)) if not m.is_zero()]
    if not all_minors:
        return None, []
    g = all_minors[0]
    for m in all_minors[1:]:
        g = g.gcd(m)
    while g.total_degree() > 0 and divmod(g, H)[1].is_zero():
        g = divmod(g, H)[0]
    return g, [divmod(m, g)[0] for m in all_minors]


def resting_points(positions):
    """Rational circlepoints with more than one center: all 2 x 2 minors of the conditions vanish."""
    from .isolated import finite_points

    rows = forms(positions)
    small = []
    for a in range(4):
        for b in range(a):
            for i, j in ((0, 1), (0, 2), (1, 2)):
                m = rows[a][i] * rows[b][j] - rows[a][j] * rows[b][i]
                if not m.is_zero():
                    small.append(m)
    return [tuple(fmpq(c[0]) for c in (x, y)) for field, x, y in finite_points(small) if field.modulus.degree() == 1]
