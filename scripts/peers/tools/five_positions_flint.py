"""Burmester pairs of five rational positions with python-flint: what a careful user of it would write.

Each problem is solved from its rational numbers to all pairs, real and complex, as certified balls of so many
digits, the number of real ones proven.

The steps: FLINT's fraction-free elimination of an integer matrix, two conics, their resultant; starting
values in floats; Newton's method with a precision that doubles, its last step on balls, which proves one
root in each; four disjoint balls hold all roots. Where the floats do not suffice, FLINT isolates the roots.
"""

import cmath
from math import gcd

from flint import acb, acb_poly, arb, arb_poly, ctx, fmpz_mat, fmpz_poly

from . import run
from .numbers import rational, written

# Bits that starting values in floats are trusted with before that is proven.
FLOAT_BITS = 44
POWERS = [arb(2) ** -k for k in range(FLOAT_BITS + 1)]


def integral(c, s, x, y):
    """The coefficients of X, Y, p, q and 1, x, y in a position, times an integer, and this integer."""
    n, m = int(c.q.lcm(s.q)), int(x.q.lcm(y.q))
    c, s, a, b = (int(q.p) * (k // int(q.q)) for q, k in ((c, n), (s, n), (x, m), (y, m)))
    return [-2 * a * n * m, -2 * b * n * m, -2 * c * m * m, 2 * s * m * m,
            (a * a + b * b) * n, 2 * (a * c + b * s) * m, 2 * (b * c - a * s) * m], 2 * n * m * m


def linear_forms(positions):
    """d and integer linear forms in 1, x, y that are d X, d Y, d p, d q, where p + iq = z conj(M)."""
    (base, unit), *others = [integral(*p) for p in positions]
    table = [[e * unit - f * k for e, f in zip(row, base)] for row, k in others]
    reduced, d, rank = fmpz_mat([[e // g for e in row] for row in table for g in [gcd(*row)]]).rref()
    if rank < 4 or reduced[3, 3] == 0:
        raise ValueError("the conditions cannot be solved for the center")
    return d, [[-int(e) for e in row[4:]] for row in reduced.tolist()]


def eliminated(forms, d):
    """The resultant, lowest first, and y = -first/second; all by integers."""
    (x0, x1, x2), (y0, y1, y2), (p0, p1, p2), (q0, q1, q2) = forms
    # x X + y Y = p and y X - x Y = q as quadratic equations in y: a y^2 + b y + c, e y^2 + f y + g.
    a, b0, b1, c0, c1, c2 = y2, y0 - p2, x2 + y1, -p0, x0 - p1, x1
    e, f0, f1, g0, g1, g2 = x2, x0 - q2, x1 - y2, -q0, -y0 - q1, -y1
    first = u0, u1, u2 = a * g0 - e * c0, a * g1 - e * c1, a * g2 - e * c2
    second = v0, v1 = a * f0 - e * b0, a * f1 - e * b1
    w0, w1 = b0 * g0 - f0 * c0, b0 * g1 + b1 * g0 - f0 * c1 - f1 * c0
    w2, w3 = b0 * g2 + b1 * g1 - f0 * c2 - f1 * c1, b1 * g2 - f1 * c2
    quartic = [
        u0 * u0 - v0 * w0,
        2 * u0 * u1 - v0 * w1 - v1 * w0,
        u1 * u1 + 2 * u0 * u2 - v0 * w2 - v1 * w1,
        2 * u1 * u2 - v0 * w3 - v1 * w2,
        u2 * u2 - v1 * w3,
    ]
    return quartic, first, second


def approximate(quartic):
    """Starting values for all roots, by Ferrari's formula and Newton's method."""
    shift = max(0, max(c.bit_length() for c in quartic) - 900)
    e, d, c, b, a = (float(k >> shift) for k in quartic)
    b, c, d, e = b / a, c / a, d / a, e / a
    p, q = c - 0.375 * b * b, d - 0.5 * b * c + 0.125 * b**3
    r = e - 0.25 * b * d + b * b * c / 16 - 3 * b**4 / 256
    # The resolvent w^3 + 2 p w^2 + (p^2 - 4 r) w - q^2.
    s, t = -(p * p + 12 * r) / 3, -(2 * p**3 - 72 * p * r + 27 * q * q) / 27
    root = cmath.sqrt(t * t / 4 + s**3 / 27)
    cube = -t / 2 + root if abs(-t / 2 + root) > abs(-t / 2 - root) else -t / 2 - root
    k = cube ** (1 / 3)
    w = cmath.sqrt((k - s / (3 * k) if k else 0) - 2 * p / 3)
    u = q / w
    inner, outer = cmath.sqrt(-w * w - 2 * p - 2 * u), cmath.sqrt(-w * w - 2 * p + 2 * u)
    roots = [-b / 4 + z / 2 for z in (w + inner, w - inner, -w + outer, -w - outer)]
    for _ in range(2):
        roots = [
            z - ((((z + b) * z + c) * z + d) * z + e) / (((4 * z + 3 * b) * z + 2 * c) * z + d)
            for z in roots
        ]
    return roots


def refined(kind, quartic, slope, z, bits):
    """A ball with exactly one root near z, of about so many bits; None where that cannot be proven."""
    half = bits // 2 + 4
    steps = []
    while half > FLOAT_BITS:
        steps.append(half)
        half = half // 2 + 4
    for precision in reversed(steps):
        ctx.prec = precision + 12
        z = (z - quartic(z) / slope(z)).mid()
    ctx.prec = bits
    error = arb(0, abs(z).upper() * POWERS[min(bits // 2, FLOAT_BITS)] if not steps else abs(z).upper() * arb(2) ** -(bits // 2))
    around = z + error if kind is arb else acb(z.real + error, z.imag + error)
    image = z - quartic(z) / slope(around)
    if kind is arb:
        return image if around.contains_interior(image) else None
    inside = around.real.contains_interior(image.real) and around.imag.contains_interior(image.imag)
    return image if inside else None


def proven(quartic, bits):
    """Real roots, and one of each couple; None where floats do not lead to four proven ones."""
    try:
        near = approximate(quartic)
    except (OverflowError, ZeroDivisionError):
        return None
    ctx.prec = bits
    whole = fmpz_poly(quartic)
    slope = whole.derivative()
    real, above = [], []
    for z in near:
        if abs(z.imag) < 1e-9 * abs(z):
            real.append(z.real)
        elif z.imag > 0:
            above.append(z)
    if len(real) + 2 * len(above) != 4:
        return None
    if real:
        f, g = arb_poly(whole), arb_poly(slope)
        real = [refined(arb, f, g, arb(z), bits) for z in real]
    if above:
        ctx.prec = bits
        f, g = acb_poly(whole), acb_poly(slope)
        above = [refined(acb, f, g, acb(z.real, z.imag), bits) for z in above]
    if None in real or None in above:
        return None
    apart = all(not x.overlaps(y) for roots in (real, above) for i, x in enumerate(roots) for y in roots[:i])
    return (real, above) if apart and all(z.imag > 0 for z in above) else None


def isolated(quartic, bits):
    """The same by FLINT's isolation."""
    ctx.prec = bits
    roots = [acb(root) for root, _ in fmpz_poly(quartic).complex_roots()]
    return [z.real for z in roots if z.imag == 0], [z for z in roots if z.imag > 0]


# More for a problem of few digits are not tried.
MOST_BITS = 10_000


def solved(positions, digits):
    """The number of real pairs, and all pairs as x, y, X, Y; of each couple of conjugate ones the first."""
    d, forms = linear_forms(positions)
    quartic, first, second = eliminated(forms, d)
    if quartic[4] == 0:
        raise ValueError("a pair at infinity, or infinitely many")
    bits = int(digits * 3.3219281) + 32
    while True:
        real, above = proven(quartic, bits) or isolated(quartic, bits)
        ctx.prec = bits
        pairs = [lifted(x, first, second, forms, d) for x in real + above]
        if all(is_sharp(pair, digits) for pair in pairs):
            return len(real), pairs
        bits += bits // 2
        if bits > MOST_BITS + 50 * digits:
            raise ValueError("a coordinate that cancels altogether")


def lifted(x, first, second, forms, d):
    (u0, u1, u2), (v0, v1) = first, second
    y = ((u2 * x + u1) * x + u0) / -(v1 * x + v0)
    (x0, x1, x2), (y0, y1, y2), *_ = forms
    return [x, y, (x1 * x + x2 * y + x0) / d, (y1 * x + y2 * y + y0) / d]


def is_sharp(pair, digits):
    """Whether every number is known to so many digits of its own or of its point's largest coordinate."""
    bits = digits * 3.3219281
    if all(z.rel_accuracy_bits() > bits + 1 for z in pair) and isinstance(pair[0], arb):
        return True
    unit = arb(10) ** -digits
    for point in (pair[:2], pair[2:]):
        parts = [part for z in point for part in ((z,) if isinstance(z, arb) else (z.real, z.imag))]
        size = max(abs(part).lower() for part in parts) * unit
        if not all(part.rad() < size for part in parts):
            return False
    return True


def main():
    row, lines, answers = run.arguments()
    digits = int(row.partition("-")[2])
    problems = [grouped([rational(word) for word in line]) for line in lines]

    def as_text(found):
        real, pairs = found
        return [real, [[written(z) for z in pair] for pair in pairs]]

    run.each("pairs", problems, lambda problem: solved(problem, digits), as_text, answers)


def grouped(numbers):
    """Cosine, sine, x, y of every position."""
    return [numbers[i : i + 4] for i in range(0, len(numbers), 4)]


if __name__ == "__main__":
    main()
