"""10 000 points of a centerpoint curve as certified balls with python-flint (the mathematics: kernels/curve_f64.cpp)."""

from flint import acb, arb, ctx, fmpq

from . import run
from .numbers import rational, written

POINTS = 10_000


def prepared(words):
    n = [arb(rational(word)) for word in words]
    alpha, nu, beta = acb(n[2], n[3]), acb(n[5], n[6]), n[4]
    product = alpha * nu
    length, mean = abs(product), beta * beta - 2 * (n[2] * n[5] + n[3] * n[6])
    branches = 2 if mean > 2 * length else 1
    half = POINTS // 2 // branches
    sizes = [(t, half * half + t * t) for t in range(-half, half)]
    turns = [(arb(fmpq(half * half - t * t, size)), arb(fmpq(2 * t * half, size))) for t, size in sizes]
    return (n, product, length, mean, branches), turns


def traced(curve, turns):
    (fr, fi, ar, ai, beta, nr, ni), product, length, mean, branches = curve
    z = product + length if product.real > 0 else acb(product.imag, length - product.real)
    z /= abs(z)
    er, ei = z.real, z.imag
    reach, modulus = (mean + 2 * length).sqrt(), 4 * length / (mean + 2 * length)
    kappa = (1 / modulus).sqrt()
    points = []

    def on_line(cos, sin, root):
        x, y = er * cos - ei * sin, er * sin + ei * cos
        if (root > 0 and beta > 0) or (root < 0 and beta < 0):
            r, w = 2 * (nr * x + ni * y), -(root + beta)
        else:
            r, w = root - beta, 2 * (ar * x + ai * y)
        points.append((fr * w + r * x, fi * w + r * y, w))

    if branches == 1:
        for cos, sin in turns:
            cos = kappa * cos
            on_line(cos, (1 - cos * cos).sqrt(), reach * sin)
        return points
    for sign in (1, -1) if beta < 0 else (-1, 1):
        for cos, sin in turns:
            on_line(cos, sin, sign * reach * (1 - modulus * cos * cos).sqrt())
    return points


def main():
    row, lines, answers = run.arguments()
    ctx.prec = int(row.partition("-")[2])
    problems = [prepared(line) for line in lines]
    run.each("points", problems, lambda problem: traced(*problem), lambda points: [list(map(written, p)) for p in points], answers)


if __name__ == "__main__":
    main()
