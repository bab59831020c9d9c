"""Five positions the textbook way: eliminate, find the roots of a quartic with numpy, substitute back.

The condition that the point z = x + iy of the moving plane stays at one distance from M = X + iY in
positions 1 and j is linear in X, Y, p, q and 1, x, y, where p + iq = z conj(M). Four of them give X, Y, p
and q as linear functions of x and y; p = xX + yY and q = yX - xY are then two conics in x and y, whose
resultant is a quartic in x.

Installed with `pip install numpy`; tried with Python 3.11.7, numpy 2.4.6.
"""

import numpy as np

from protocol import Skipped, positions, serve


def condition(r, t):
    """Coefficients of X, Y, p, q and of 1, x, y in |rz + t - M|^2."""
    c, s, a, b = r.real, r.imag, t.real, t.imag
    return [-2 * a, -2 * b, -2 * c, 2 * s, a * a + b * b, 2 * (a * c + b * s), 2 * (b * c - a * s)]


def pairs_of(problem):
    rows = np.array([condition(r, t) for r, t in positions(problem)])
    rows = rows[1:] - rows[0]
    forms = np.linalg.solve(rows[:, :4], -rows[:, 4:])
    (x0, x1, x2), (y0, y1, y2), (p0, p1, p2), (q0, q1, q2) = forms
    # Both conics as quadratics in y, their coefficients as polynomials in x, highest first.
    P = np.poly1d
    a, b, c = P([y2]), P([x2 + y1, y0 - p2]), P([x1, x0 - p1, -p0])
    e, f, g = P([x2]), P([x1 - y2, x0 - q2]), P([-y1, -y0 - q1, -q0])
    first, second = a * g - e * c, a * f - e * b
    quartic = first * first - second * (b * g - f * c)
    found = []
    for x in quartic.roots:
        y = -first(x) / second(x)
        X, Y = x0 + x1 * x + x2 * y, y0 + y1 * x + y2 * y
        found.append((x, y, X, Y))
    return found


def solve(problem):
    if problem["problem"] != "five-positions":
        raise Skipped("five positions only")
    real, above = [], []
    for pair in pairs_of(problem):
        if all(abs(z.imag) <= 1e-8 * max(1, abs(z)) for z in pair):
            x, y, X, Y = (float(z.real) for z in pair)
            real.append({"circlepoint": [x, y], "center": [X, Y]})
        else:
            x, y, X, Y = ({"re": float(z.real), "im": float(z.imag)} for z in pair)
            above.append({"circlepoint": [x, y], "center": [X, Y]})
    return {
        "pairs": real,
        "complex_pairs": above,
        "counts": {"real": len(real), "complex": len(above)},
    }


serve(solve)
