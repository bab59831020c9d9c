"""10 000 points of a centerpoint curve in doubles with numpy (the mathematics: kernels/curve_f64.cpp)."""

import numpy as np

from . import run

POINTS = 10_000


def prepared(words):
    n = [float(p) / float(q or 1) for p, _, q in (word.partition("/") for word in words)]
    focus, alpha, beta, nu = complex(*n[:2]), complex(*n[2:4]), n[4], complex(*n[5:])
    length, mean = abs(alpha * nu), beta * beta - 2 * (alpha.conjugate() * nu).real
    branches = 2 if mean > 2 * length else 1
    half = POINTS // 2 // branches
    t = np.arange(-half, half, dtype=float)
    turns = (half * half - t * t) / (half * half + t * t), 2 * t * half / (half * half + t * t)
    return (focus, alpha, beta, nu, length, mean, branches), turns


def traced(curve, turns):
    """x, y, w of all points."""
    focus, alpha, beta, nu, length, mean, branches = curve
    cos, sin = turns
    axis = (alpha * nu / length) ** 0.5
    reach = (mean + 2 * length) ** 0.5
    if branches == 1:
        cos = ((mean + 2 * length) / (4 * length)) ** 0.5 * cos
        parts = [(cos, np.sqrt(1 - cos * cos), reach * sin)]
    else:
        root = reach * np.sqrt(1 - 4 * length / (mean + 2 * length) * cos * cos)
        parts = [(cos, sin, root if beta < 0 else -root), (cos, sin, -root if beta < 0 else root)]
    return [on_lines(curve, axis, *part) for part in parts]


def on_lines(curve, axis, cos, sin, root):
    focus, alpha, beta, nu, *_ = curve
    x, y = axis.real * cos - axis.imag * sin, axis.imag * cos + axis.real * sin
    opposite = beta * root <= 0
    r = np.where(opposite, root - beta, 2 * (nu.real * x + nu.imag * y))
    w = np.where(opposite, 2 * (alpha.real * x + alpha.imag * y), -(root + beta))
    return focus.real * w + r * x, focus.imag * w + r * y, w


def main():
    _, lines, answers = run.arguments()

    def as_points(parts):
        return [point for part in parts for point in np.stack(part, -1).tolist()]

    problems = [prepared(line) for line in lines]
    run.each("points", problems, lambda problem: traced(*problem), as_points, answers)


if __name__ == "__main__":
    main()
