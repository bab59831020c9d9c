"""The same with python-flint's integers: the linear entries cleared of denominators, the determinant by hand."""

from math import lcm

from flint import fmpz

from . import run


def solved(words):
    """Up to a factor, in the order x^3, x^2 y, x y^2, y^3, x^2, xy, y^2, x, y, 1."""
    rows = [integral(*words[i : i + 4]) for i in range(0, 16, 4)]
    (base, unit), *others = rows
    entries = []
    for row, k in others:
        c, s, p, q, h, a, b = (x * unit - y * k for x, y in zip(row, base))
        entries.append(((c, s, p), (-s, c, q), (a, b, h)))
    (a1, a2, a3), (b1, b2, b3), (c1, c2, c3) = entries
    total = [0] * 10
    for entry, conic in ((a1, minor(b2, c3, b3, c2)), (a2, minor(b3, c1, b1, c3)), (a3, minor(b1, c2, b2, c1))):
        (x, y, w), (xx, xy, yy, xw, yw, ww) = entry, conic
        parts = (x * xx, x * xy + y * xx, x * yy + y * xy, y * yy, x * xw + w * xx, x * yw + y * xw + w * xy,
                 y * yw + w * yy, x * ww + w * xw, y * ww + w * yw, w * ww)
        total = [t + part for t, part in zip(total, parts)]
    return total


def minor(p, q, r, s):
    """p q - r s of linear forms."""
    (a, b, c), (d, e, f), (g, h, i), (k, m, n) = p, q, r, s
    return (a * d - g * k, a * e + b * d - g * m - h * k, b * e - h * m, a * f + c * d - g * n - i * k,
            b * f + c * e - h * n - i * m, c * f - i * n)


def integral(cos, sin, x, y):
    """c, s, Re and Im of the inverse translation, its square, -2a, -2b, all times an integer, and this integer."""
    n, m = lcm(cos[1], sin[1]), lcm(x[1], y[1])
    c, s, a, b = (fmpz(p * (k // q)) for (p, q), k in ((cos, n), (sin, n), (x, m), (y, m)))
    p, q = -a * c - b * s, a * s - b * c
    return (c * m * m, s * m * m, p * m, q * m, (a * a + b * b) * n, -2 * a * n * m, -2 * b * n * m), n * m * m


def main():
    _, lines, answers = run.arguments()
    parsed = [[(int(p), int(q or 1)) for p, _, q in (word.partition("/") for word in line)] for line in lines]
    run.each("coefficients", parsed, solved, lambda found: list(map(str, found)), answers)


if __name__ == "__main__":
    main()
