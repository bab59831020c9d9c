"""Burmester pairs of five rational positions with PARI, compiled from GP: not certified.

The resultant of the two conics by the same formulas as with the others, exact; its roots to so many digits by
polroots; y, X and Y from each.
"""

from cypari import pari

from . import run

SOLVE = """
pairs(v, n) = {
  my(r(i) = my(c = v[4*i+1], s = v[4*i+2], a = v[4*i+3], b = v[4*i+4]);
            [-2*a, -2*b, -2*c, 2*s, a^2 + b^2, 2*(a*c + b*s), 2*(b*c - a*s)],
     m = matrix(4, 7), base = r(0));
  for(i = 1, 4, m[i,] = r(i) - base);
  my(f = -matsolve(m[,1..4], m[,5..7]),
     X = f[1,], Y = f[2,], P = f[3,], Q = f[4,],
     a = Y[3], b = Pol([X[3] + Y[2], Y[1] - P[3]]), c = Pol([X[2], X[1] - P[2], -P[1]]),
     e = X[3], g = Pol([X[2] - Y[3], X[1] - Q[3]]), h = Pol([-Y[2], -Y[1] - Q[2], -Q[1]]),
     u = a*h - e*c, w = a*g - e*b, z = polroots(u^2 - w*(b*h - g*c)));
  apply(x -> my(y = -subst(u, 'x, x)/subst(w, 'x, x)); [x, y, X[1] + X[2]*x + X[3]*y, Y[1] + Y[2]*x + Y[3]*y], z)
}
"""


def main():
    row, lines, answers = run.arguments()
    digits = int(row.partition("-")[2])
    pari.set_real_precision(digits + 9)
    pari.allocatemem(2**26, 2**28, silent=True)
    pari(" ".join(SOLVE.split("\n")))
    solve = pari("pairs")
    problems = [pari("[" + ",".join(line) + "]") for line in lines]

    def as_text(found):
        """Real and upper pairs, as decimals."""
        real = [z for z in found if z[0].imag() == 0]
        above = [z for z in found if z[0].imag() > 0]
        texts = [[str(pari(part).real()).replace(" ", "") for part in z] for z in real]
        texts += [[[str(f(pari(part))).replace(" ", "") for f in (lambda w: w.real(), lambda w: w.imag())] for part in z] for z in above]
        return [len(real), texts]

    run.each("pairs", problems, lambda problem: solve(problem, digits), as_text, answers)


if __name__ == "__main__":
    main()
