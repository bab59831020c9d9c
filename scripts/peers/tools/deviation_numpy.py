"""Travel and deviation of one linkage at 360 angles in doubles with numpy (the formula: kernels/deviation_f64.cpp)."""

import numpy as np

from . import run

DEGREES = np.radians(np.arange(360))
TURN = np.cos(DEGREES) + 1j * np.sin(DEGREES)


def places(linkage):
    k, a, b, d, m, g, c, low, high, side = linkage
    n = m - (g * TURN).real
    w = (n + c + 1j * side * np.sqrt((n - low) * (high - n))) * (0.5 / n)
    return k + a * TURN + (b - d * TURN) * w


def linkage(words):
    n = [float(p) / float(q or 1) for p, _, q in (word.partition("/") for word in words)]
    z = [complex(n[i], n[i + 1]) for i in (0, 2, 4, 6, 9)]
    return *z[:4], n[8], z[4], *n[11:]


def main():
    _, lines, answers = run.arguments()
    problems = [linkage(words) for words in lines]
    run.say("places", run.quickest(lambda: [places(problem) for problem in problems]) / len(problems))
    for problem in problems if answers else ():
        z = places(problem)
        run.answer("places", [z.real.tolist(), z.imag.tolist()])


if __name__ == "__main__":
    main()
