"""Five positions in doubles with numpy: a batch of problems as arrays, and one problem after the other.

The steps are those of kernels/five_positions_f64.cpp; the roots of the quartic are eigenvalues of its companion
matrix, improved by Newton's method, in the batch Ferrari's formula in complex arithmetic instead.
"""

import numpy as np

from . import run


def forms_of(positions):
    """X, Y, p, q as linear forms, an array [problem, form, coefficient]."""
    c, s, a, b = np.moveaxis(positions, -1, 0)
    rows = np.stack([-2 * a, -2 * b, -2 * c, 2 * s, a * a + b * b, 2 * (a * c + b * s), 2 * (b * c - a * s)], -1)
    rows = rows[..., 1:, :] - rows[..., :1, :]
    return -np.linalg.solve(rows[..., :4], rows[..., 4:])


def eliminated(forms):
    """The quartic, lowest first, and y = -first/second."""
    (x0, x1, x2), (y0, y1, y2), (p0, p1, p2), (q0, q1, q2) = np.moveaxis(forms, (-2, -1), (0, 1))
    a, b0, b1, c0, c1, c2 = y2, y0 - p2, x2 + y1, -p0, x0 - p1, x1
    e, f0, f1, g0, g1, g2 = x2, x0 - q2, x1 - y2, -q0, -y0 - q1, -y1
    first = u0, u1, u2 = a * g0 - e * c0, a * g1 - e * c1, a * g2 - e * c2
    second = v0, v1 = a * f0 - e * b0, a * f1 - e * b1
    w0, w1 = b0 * g0 - f0 * c0, b0 * g1 + b1 * g0 - f0 * c1 - f1 * c0
    w2, w3 = b0 * g2 + b1 * g1 - f0 * c2 - f1 * c1, b1 * g2 - f1 * c2
    quartic = (
        u0 * u0 - v0 * w0,
        2 * u0 * u1 - v0 * w1 - v1 * w0,
        u1 * u1 + 2 * u0 * u2 - v0 * w2 - v1 * w1,
        2 * u1 * u2 - v0 * w3 - v1 * w2,
        u2 * u2 - v1 * w3,
    )
    return quartic, first, second


def all_roots(quartic):
    """Ferrari's formula, for all problems at once: an array [root, problem]."""
    e, d, c, b = (k / quartic[4] for k in quartic[:4])
    p, q = c - 0.375 * b * b, d - 0.5 * b * c + 0.125 * b * b * b
    r = e - 0.25 * b * d + b * b * c / 16 - 3 * b * b * b * b / 256
    s, t = -(p * p + 12 * r) / 3, -(2 * p * p * p - 72 * p * r + 27 * q * q) / 27
    under = np.sqrt(t * t / 4 + s * s * s / 27 + 0j)
    cube = np.where(t < 0, -t / 2 + under, -t / 2 - under)
    k = cube ** (1 / 3)
    w = np.sqrt(k - s / (3 * k) - 2 * p / 3)
    u = q / w
    inner, outer = np.sqrt(-w * w - 2 * p - 2 * u), np.sqrt(-w * w - 2 * p + 2 * u)
    return np.stack([w + inner, w - inner, -w + outer, -w - outer]) / 2 - b / 4


def improved(quartic, z):
    e, d, c, b, a = quartic
    for _ in range(2):
        z = z - ((((a * z + b) * z + c) * z + d) * z + e) / (((4 * a * z + 3 * b) * z + 2 * c) * z + d)
    return z


def lifted(forms, first, second, x):
    (x0, x1, x2), (y0, y1, y2) = np.moveaxis(forms[..., :2, :], (-2, -1), (0, 1))
    y = -((first[2] * x + first[1]) * x + first[0]) / (second[1] * x + second[0])
    return x, y, x0 + x1 * x + x2 * y, y0 + y1 * x + y2 * y


def batch(positions):
    """x, y, X, Y as an array [coordinate, root, problem]."""
    forms = forms_of(positions)
    quartic, first, second = eliminated(forms)
    return np.stack(lifted(forms, first, second, improved(quartic, all_roots(quartic))))


def single(positions):
    forms = forms_of(positions)
    quartic, first, second = eliminated(forms)
    return np.stack(lifted(forms, first, second, improved(quartic, np.roots(quartic[::-1]))))


def as_pairs(pairs):
    """Real and upper pairs of an array [coordinate, root]."""
    pairs = [[complex(z) for z in pair] for pair in pairs.T]
    real = lambda pair: abs(pair[0].imag) < 1e-9 * abs(pair[0])  # noqa: E731
    kept = [[z.real + 0j for z in pair] if real(pair) else pair for pair in pairs if real(pair) or pair[0].imag > 0]
    return [[[z.real, z.imag] for z in pair] for pair in kept]


def main():
    _, lines, answers = run.arguments()
    floats = [[float(p) / float(q or 1) for p, _, q in (word.partition("/") for word in line)] for line in lines]
    problems = np.array(floats).reshape(-1, 5, 4)
    run.say("many", run.quickest(lambda: batch(problems)) / len(problems))
    for pairs in np.moveaxis(batch(problems), -1, 0) if answers else ():
        run.answer("many", as_pairs(pairs))
    run.each("one", list(problems), single, as_pairs, answers)


if __name__ == "__main__":
    main()
