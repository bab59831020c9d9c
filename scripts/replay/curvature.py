"""One position of a coupler that two links guide: its motion as a power series, and what follows from it."""

from flint import ctx, fmpq, fmpq_mat

from outside.compare import rational

from . import cubic
from .centerpoint import Differs, Form, curve_agrees, list_agrees, point_agrees
from .corpora import cases
from .families import ORDER, determinant
from .mixed import agrees, rows, turned_on


def homogeneous(point):
    if isinstance(point, dict):
        return [rational(n) for n in point["at_infinity"]] + [fmpq(0)]
    return [rational(n) for n in point] + [fmpq(1)]


def value(table, link):
    """The bilinear form of one link."""
    z, m = link
    return sum((m[i] * table[i][j] * z[j] for i in range(3) for j in range(3)), fmpq(0))


def tables(motion):
    angle, x, y = motion
    c, s = turned_on(fmpq(1), fmpq(0), angle)
    return rows(c, s, x, y)


def motion_of(links):
    """Taylor coefficients of the angle and of the shift, so that both links keep their conditions up to t^4.

    Each order brings the same linear equations for its coefficients; the parameter is the angle, or a
    coordinate of the shift where the angle rests."""
    motion = [[fmpq(0), fmpq(0)] for _ in range(3)]
    slopes = []
    for part in range(3):
        motion[part][1] = fmpq(1)
        slopes.append([value(tables(motion)[1], link) for link in links])
        motion[part][1] = fmpq(0)
    (a, d), (b, e), (c, f) = slopes
    speed = [b * f - c * e, c * d - a * f, a * e - b * d]
    lead = next(k for k in range(3) if speed[k] != 0)
    others = [k for k in range(3) if k != lead]
    for part in range(3):
        motion[part][1] = speed[part] / speed[lead]
    matrix = fmpq_mat([[slopes[k][i] for k in others] for i in range(2)])
    for order in (2, 3, 4):
        for part in motion:
            part.append(fmpq(0))
        left = tables(motion)[order]
        found = matrix.solve(fmpq_mat([[-value(left, link)] for link in links]))
        for row, k in enumerate(others):
            motion[k][order] = found[row, 0]
    return motion


def curve(listed, transposed):
    """Points with a center for four positions together, or the centers."""
    forms = []
    for table in listed:
        lines = zip(*table) if transposed else table
        forms.append([Form({(1, 0): line[0], (0, 1): line[1], (0, 0): line[2]}) for line in lines])
    out = determinant(forms).table
    return [out.get(key, fmpq(0)) for key in ORDER[3]]


def inflections(motion):
    """a (x^2 + y^2) + b x + c y + d: velocity and acceleration in one line."""
    angle, x, y = motion
    p, q = (fmpq(0), angle[1]), (x[1], y[1])
    s, u = (-angle[1] ** 2, 2 * angle[2]), (2 * x[2], 2 * y[2])

    def times(f, g):
        return f[0] * g[0] + f[1] * g[1], f[0] * g[1] - f[1] * g[0]

    k, m = times(p, u), times(q, s)
    return times(p, s)[1], k[1] + m[1], m[0] - k[0], times(q, u)[1]


def replay(problem, answer):
    if "undecided" in answer:
        return "undecided"
    ctx.prec = cubic.BITS
    motion = motion_of([(homogeneous(link["circlepoint"]), homogeneous(link["center"])) for link in problem["links"]])
    angle, x, y = motion
    listed = tables(motion)
    try:
        if angle[1] != 0:
            point_agrees(answer["pole"], (-y[1], x[1]), "pole")
            # With the angle as parameter the acceleration of z is J - z.
            point_agrees(answer["inflection_pole"], (2 * x[2], 2 * y[2]), "inflection pole")
        else:
            list_agrees(answer["pole"]["at_infinity"], (-y[1], x[1]), "pole")
            if answer["inflection_pole"] is not None:
                raise Differs("an inflection pole of a translation")
        list_agrees(answer["inflection_circle"], inflections(motion), "inflection circle")
        curve_agrees(answer["circlepoint"], curve(listed[1:4], False), True, "cubic of stationary curvature")
        curve_agrees(answer["centerpoint"], curve(listed[1:4], True), True, "cubic of the centers")
    except Differs as error:
        return str(error)
    return agrees(listed[1:], answer)


def run(report):
    for problem, answer in cases("curvature"):
        report(problem["id"], replay(problem, answer))
