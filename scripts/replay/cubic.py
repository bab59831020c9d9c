"""A circular cubic by its ten coefficients: its kind, double points, focus, asymptote and midline."""

from flint import arb, fmpq

from .families import CONTEXT, ORDER, X, Y, H
from .isolated import finite_points

BITS = 2000


def polynomial(coefficients):
    """The homogeneous polynomial of rational coefficients."""
    out = CONTEXT.from_dict({})
    for (i, j), c in zip(ORDER[3], coefficients):
        out += c * X**i * Y**j * H ** (3 - i - j)
    return out


def kind(coefficients):
    """The type, and the finite real double points as numbers or balls."""
    f = polynomial(coefficients)
    if f.is_zero():
        return "every-point", []
    while divmod(f, H)[1].is_zero():
        f = divmod(f, H)[0]
    degree = f.total_degree()
    if degree == 0:
        return None, []
    if degree == 1:
        return "three-lines", []
    nodes = double_points(f)
    if degree == 2:
        a, b, c = (fmpq(f.to_dict().get(key, 0)) for key in ((2, 0, 0), (1, 1, 0), (0, 2, 0)))
        if a == c and b == 0:
            return ("three-lines" if nodes else "line-and-circle"), nodes
        return ("two-lines" if nodes else "hyperbola"), nodes
    factors = [g for g, power in f.factor()[1] for _ in range(power)]
    if len(factors) == 3:
        return "three-lines", nodes
    if len(factors) == 2:
        conic = max(factors, key=lambda g: g.total_degree())
        return ("three-lines" if double_points(conic) else "line-and-circle"), nodes
    if nodes:
        return at_node(f, nodes[0]), nodes
    return by_tangents(coefficients), []


def double_points(f):
    slopes = [f] + [f.derivative(name) for name in ("x", "y", "h")]
    slopes = [s for s in slopes if not s.is_zero()]
    if any(s.is_constant() for s in slopes):
        return []
    found = []
    for field, x, y in finite_points(slopes):
        if field.modulus.degree() == 1:
            found.append((fmpq(x[0]), fmpq(y[0])))
            continue
        for root, real in field.roots(BITS):
            if real:
                found.append(tuple(field.evaluate(v, root, BITS).real for v in (x, y)))
    return found


def at_node(f, node):
    """The sign of the Hessian tells a node from an isolated point."""
    d = value(f, "x", "x", node) * value(f, "y", "y", node) - value(f, "x", "y", node) ** 2
    return "nodal" if d < 0 else "isolated-point" if d > 0 else "cuspidal"


def value(f, p, q, node):
    g = f.derivative(p).derivative(q)
    return sum((c * node[0] ** int(i) * node[1] ** int(j) for (i, j, _), c in g.to_dict().items()), fmpq(0))


def by_tangents(coefficients):
    """One or two branches of a cubic without double point.

    Lines along the real direction at infinity, a x + b y = n u, meet the cubic in two more points, given by
    A w^2 + B w + C = 0; B^2 - 4 A C is a quartic in u. The branches are two where its discriminant is
    positive, one where it is negative."""
    a, b = coefficients[0], coefficients[1]
    n = a * a + b * b
    # x = (a u - b w)/n, y = (b u + a w)/n with scaled u and w: substitute polynomials in u per power of w.
    x = {0: [0, a / n], 1: [-b / n]}
    y = {0: [0, b / n], 1: [a / n]}
    total = {}
    for (i, j), c in zip(ORDER[3], coefficients):
        term = {0: [c]}
        for factor in [x] * i + [y] * j:
            term = product(term, factor)
        for power, p in term.items():
            total[power] = added(total.get(power, []), p)
    assert all(is_null(c) for c in total.get(3, [])), "no circular cubic"
    quadratic, linear, constant = (total.get(k, [0]) for k in (2, 1, 0))
    d = added(times(linear, linear), [-4 * c for c in times(quadratic, constant)])
    d = (d + [0] * 5)[:5]
    sign = quartic_discriminant(d)
    return "two-branches" if sign > 0 else "one-branch" if sign < 0 else "undecided"


def is_null(c):
    if isinstance(c, arb):
        return c.contains(0)
    return c == 0 if isinstance(c, (int, fmpq)) else abs(c) < 1e-30


def times(p, q):
    out = [0] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] = out[i + j] + a * b
    return out


def added(p, q):
    return [(p[k] if k < len(p) else 0) + (q[k] if k < len(q) else 0) for k in range(max(len(p), len(q)))]


def product(p, q):
    out = {}
    for i, a in p.items():
        for j, b in q.items():
            out[i + j] = added(out.get(i + j, []), times(a, b))
    return out


def quartic_discriminant(d):
    """27 disc = 4 I^3 - J^2 by the invariants of the binary quartic."""
    e, d1, c, b, a = d
    i = 12 * a * e - 3 * b * d1 + c * c
    j = 72 * a * c * e + 9 * b * c * d1 - 27 * a * d1 * d1 - 27 * e * b * b - 2 * c**3
    return 4 * i**3 - j * j


def focus(coefficients):
    """Where the tangents at the circular points meet: x + i y = -(q20 - q02 + i q11)/(2 (a + i b))."""
    a, b = coefficients[0], coefficients[1]
    re, im = coefficients[4] - coefficients[6], coefficients[5]
    n = 2 * (a * a + b * b)
    return -(re * a + im * b) / n, -(im * a - re * b) / n


def asymptote(coefficients):
    """The tangent at the real point at infinity, (b, -a)."""
    a, b = coefficients[0], coefficients[1]
    n = a * a + b * b
    q20, q11, q02 = coefficients[4:7]
    return n * a, n * b, q20 * b * b - q11 * a * b + q02 * a * a


def midline(coefficients):
    """Parallel to the asymptote, halfway between it and the focus."""
    p, q, r = asymptote(coefficients)
    x, y = focus(coefficients)
    return p, q, (r - p * x - q * y) / 2
