"""Common points of the plane curves that are left when infinitely many solutions are divided out."""

from flint import fmpq, fmpq_poly, fmpz_poly

from outside.dialytic import conditions
from outside.field import Field, cross, polynomial_gcd, squarefree, trimmed

from .families import CONTEXT, X, Y, H


class NotSeparated(Exception):
    """No shear that was tried gives all points different first coordinates."""


def in_y(curve, field):
    """A curve at h = 1 as a polynomial in y over Q(x)/(f)."""
    table = {}
    for key, value in curve.subs({"h": 1}).to_dict().items():
        i, j = int(key[0]), int(key[1])
        table.setdefault(j, {})[i] = value
    rows = [table.get(j, {}) for j in range(max(table, default=-1) + 1)]
    return trimmed(field.reduced(fmpq_poly([row.get(i, 0) for i in range(max(row, default=0) + 1)])) for row in rows)


def first_coordinates(curves):
    """Irreducible polynomials that hold all x of common points."""
    affine = [p for p in (c.subs({"h": 1}) for c in curves) if not p.is_zero()]
    with_y = [p for p in affine if p.degrees()[1]]
    held = [p for p in affine if not p.degrees()[1]]
    held += [r for k, p in enumerate(with_y) for q in with_y[:k] if not (r := p.resultant(q, "y")).is_zero()]
    g = held[0]
    for p in held[1:]:
        g = g.gcd(p)
    for factor, _ in g.factor()[1]:
        table = {int(key[0]): value for key, value in factor.to_dict().items()}
        yield fmpq_poly([table.get(i, 0) for i in range(max(table) + 1)]).numer()


def finite_points(curves):
    """(field, x, y) for all classes of conjugate common points."""
    if any(c.is_constant() or c.subs({"h": 1}).is_constant() for c in curves):
        return []
    for shear in (0, 1, -2, 3, 5):
        try:
            return sheared(curves, shear)
        except NotSeparated:
            continue
    raise NotSeparated


def sheared(curves, shear):
    curves = [c.compose(X + shear * Y, Y, H, ctx=CONTEXT) for c in curves]
    found = []
    for f in first_coordinates(curves):
        if f.degree() == 0:
            continue
        field = Field(fmpz_poly(f))
        common = polynomial_gcd(field, [p for p in (in_y(c, field) for c in curves) if p])
        if len(common) == 1:
            continue
        common = squarefree(field, common)
        if len(common) != 2:
            raise NotSeparated
        y = field.reduced(-common[0] * field.inverse(common[1]))
        found.append((field, field.reduced(field.generator() + shear * y), y))
    return found


def center(positions, field, x, y):
    """Homogeneous coordinates of the center of a circlepoint; None if it has more than one."""
    rows = [[field.reduced(f[0] * x + f[1] * y + field.number(fmpq(f[2]))) for f in row] for row in conditions(positions)]
    return cross(field, rows)
