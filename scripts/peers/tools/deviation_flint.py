"""Travel and deviation of one linkage at 360 angles as certified balls with python-flint."""

from flint import acb, arb, ctx, fmpq

from . import run
from .numbers import rational, written


def places(linkage, turns):
    k, a, b, d, m, g, c, low, high, side = linkage
    found = []
    for e in turns:
        n = m - (g * e).real
        half = 1 / (2 * n)
        w = acb((n + c) * half, ((n - low) * (high - n)).sqrt() * half * side)
        found.append(k + a * e + (b - d * e) * w)
    return found


def main():
    row, lines, answers = run.arguments()
    ctx.prec = int(row.partition("-")[2]) * 10 // 3 + 2
    turns = [acb(arb.cos_pi_fmpq(fmpq(i, 180)), arb.sin_pi_fmpq(fmpq(i, 180))) for i in range(360)]
    problems = []
    for line in lines:
        n = [arb(rational(word)) for word in line]
        z = [acb(n[i], n[i + 1]) for i in (0, 2, 4, 6, 9)]
        problems.append((*z[:4], n[8], z[4], *n[11:]))

    def as_text(found):
        return [[written(z.real) for z in found], [written(z.imag) for z in found]]

    run.each("places", problems, lambda problem: places(problem, turns), as_text, answers)


if __name__ == "__main__":
    main()
