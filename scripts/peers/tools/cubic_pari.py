"""The ten coefficients of the centerpoint cubic of four rational positions with PARI, from GP: exact.

The curve of the centers is the circlepoint curve of the inverse motion: the determinant of Re(X - X1), Im(X - X1),
|X|^2 - |X1|^2 for X = r z + t in the three other positions, by its linear entries.
"""

from cypari import pari

from . import run

SOLVE = """
cubic(v) = {
  my(r(i) = my(c = v[4*i+1], s = v[4*i+2], a = v[4*i+3], b = v[4*i+4], p = -a*c - b*s, q = a*s - b*c);
            [c, -s, p, q, p^2 + q^2, -2*a, -2*b],
     base = r(0), f(i) = my(d = r(i) - base);
            [d[1]*'x - d[2]*'y + d[3], d[2]*'x + d[1]*'y + d[4], d[6]*'x + d[7]*'y + d[5]],
     a = f(1), b = f(2), c = f(3),
     g = a[1]*(b[2]*c[3] - b[3]*c[2]) - a[2]*(b[1]*c[3] - b[3]*c[1]) + a[3]*(b[1]*c[2] - b[2]*c[1]));
  g
}
"""
TERMS = [(3, 0), (2, 1), (1, 2), (0, 3), (2, 0), (1, 1), (0, 2), (1, 0), (0, 1), (0, 0)]


def main():
    _, lines, answers = run.arguments()
    pari.allocatemem(2**26, 2**28, silent=True)
    pari(" ".join(SOLVE.split("\n")))
    solve = pari("cubic")
    problems = [pari("[" + ",".join(line) + "]") for line in lines]
    coefficients = lambda g: [str(g.polcoef(i, "x").polcoef(j, "y")) for i, j in TERMS]  # noqa: E731
    run.each("coefficients", problems, solve, coefficients, answers)


if __name__ == "__main__":
    main()
