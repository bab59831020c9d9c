"""Arithmetic in Q[s]/(f), f irreducible, and polynomials over it; elements are reduced fmpq_poly."""

from flint import acb, ctx, fmpq, fmpq_mat, fmpq_poly


class Field:
    def __init__(self, f):
        self.f = f
        self.modulus = fmpq_poly(f)

    def reduced(self, element):
        return element % self.modulus

    def number(self, q):
        return fmpq_poly([q])

    def generator(self):
        return self.reduced(fmpq_poly([0, 1]))

    def inverse(self, element):
        g, s, _ = element.xgcd(self.modulus)
        return self.reduced(s / g.coeffs()[0])

    def ratio(self, a, b):
        return self.reduced(a * self.inverse(b))

    def characteristic(self, element):
        """A multiple by an integer of the characteristic polynomial of the multiplication by an element."""
        n = self.modulus.degree()
        rows, power = [], self.reduced(element)
        for _ in range(n):
            coefficients = power.coeffs()
            rows.append([coefficients[k] if k < len(coefficients) else fmpq(0) for k in range(n)])
            power = self.reduced(power * fmpq_poly([0, 1]))
        return fmpq_poly(fmpq_mat(rows).charpoly()).numer()

    def roots(self, bits):
        """All roots of f as enclosures, with the word whether they are real; one of a couple after the other."""
        before, ctx.prec = ctx.prec, bits
        try:
            # complex_roots gives real roots with an imaginary part that is exactly zero.
            return [(acb(root), acb(root).imag == 0) for root, _ in self.f.complex_roots()]
        finally:
            ctx.prec = before

    def evaluate(self, element, root, bits):
        """The number that an element is in C."""
        before, ctx.prec = ctx.prec, bits
        try:
            value = acb(0)
            for c in reversed(element.coeffs()):
                value = value * root + c
            return value
        finally:
            ctx.prec = before


def trimmed(p):
    p = list(p)
    while p and p[-1] == 0:
        p.pop()
    return p


def times(field, p, q):
    if not p or not q:
        return []
    out = [fmpq_poly([0])] * (len(p) + len(q) - 1)
    for i, a in enumerate(p):
        for j, b in enumerate(q):
            out[i + j] = out[i + j] + a * b
    return trimmed(field.reduced(c) for c in out)


def plus(p, q, sign=1):
    n = max(len(p), len(q))
    zero = fmpq_poly([0])
    return trimmed((p[k] if k < len(p) else zero) + sign * (q[k] if k < len(q) else zero) for k in range(n))


def minors_in(field, b0, b1):
    """The four minors of order 3 of B0 + u B1, polynomials in u by their coefficients."""
    rows = [[trimmed([x, y]) for x, y in zip(r0, r1)] for r0, r1 in zip(b0, b1)]
    minors = []
    for left_out in range(4):
        p, q, r = (row for k, row in enumerate(rows) if k != left_out)
        det = []
        for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
            inner = plus(times(field, q[j], r[k]), times(field, q[k], r[j]), -1)
            det = plus(det, times(field, p[i], inner))
        minors.append(det)
    return minors


def remainder(field, p, q):
    p = list(p)
    inverse = field.inverse(q[-1])
    while len(p) >= len(q):
        factor = field.reduced(p[-1] * inverse)
        shift = len(p) - len(q)
        for k, c in enumerate(q):
            p[shift + k] = field.reduced(p[shift + k] - factor * c)
        p = trimmed(p)
    return p


def polynomial_gcd(field, polynomials):
    g = []
    for p in polynomials:
        while p:
            g, p = p, (remainder(field, g, p) if g else [])
    return g


def quotient(field, p, q):
    p, out = list(p), []
    inverse = field.inverse(q[-1])
    while len(p) >= len(q):
        factor = field.reduced(p[-1] * inverse)
        out.insert(0, factor)
        shift = len(p) - len(q)
        for k, c in enumerate(q):
            p[shift + k] = field.reduced(p[shift + k] - factor * c)
        p.pop()
    return out


def squarefree(field, p):
    """p without the multiplicities of its roots."""
    derivative = trimmed(k * c for k, c in enumerate(p) if k)
    return quotient(field, p, polynomial_gcd(field, [p, derivative])) if derivative else p


def cross(field, rows):
    """A vector across all rows of a matrix of rank 2; None for a smaller rank."""
    for a in range(4):
        for b in range(a + 1, 4):
            p, q = rows[a], rows[b]
            v = [field.reduced(p[i] * q[j] - p[j] * q[i]) for i, j in ((1, 2), (2, 0), (0, 1))]
            if any(c != 0 for c in v):
                return v
    return None
