"""Expanding (3.25) from (3.24) with python-flint: the resultant of two conics in ten letters, by powers of x."""

from flint import Ordering, fmpz_mpoly_ctx

from . import run

LETTERS = "a b c d e f g h k l".split()


def main():
    _, _, answers = run.arguments()
    ring = fmpz_mpoly_ctx.get(["x", *LETTERS], Ordering.lex)
    x, a, b, c, d, e, f, g, h, k, l = ring.gens()  # noqa: E741
    conics = a * x + b, c * x**2 + d * x + e, f * x + g, h * x**2 + k * x + l

    def solve():
        p, q, u, v = conics
        return (q - v) ** 2 + (p - u) * (p * v - u * q)

    run.say("expansion", run.quickest(solve))
    if answers:
        parts = [[] for _ in range(5)]
        for powers, coefficient in solve().to_dict().items():
            term = [str(coefficient), *(f"{letter}^{n}" for letter, n in zip(LETTERS, powers[1:]) if n)]
            parts[powers[0]].append("*".join(term))
        run.answer("expansion", [" + ".join(part) for part in parts])


if __name__ == "__main__":
    main()
