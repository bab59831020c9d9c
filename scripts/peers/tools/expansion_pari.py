"""Expanding (3.25) from (3.24) with PARI: the resultant of two conics in ten letters, by powers of x."""

from cypari import pari

from . import run

SOLVE = """
expansion(p, q, u, v) = (q - v)^2 + (p - u)*(p*v - u*q)
"""


def main():
    _, _, answers = run.arguments()
    pari.allocatemem(2**26, 2**28, silent=True)
    pari("x;")
    conics = [pari(text) for text in ("a*x + b", "c*x^2 + d*x + e", "f*x + g", "h*x^2 + k*x + l")]
    pari(SOLVE.strip())
    by_formula, resultant = pari("expansion"), pari("(p, q, u, v) -> polresultant('y^2 + p*'y + q, 'y^2 + u*'y + v, 'y)")
    seconds = [run.quickest(lambda: solve(*conics)) for solve in (by_formula, resultant)]
    run.say("expansion", min(seconds))
    if answers:
        for solve in (by_formula, resultant):
            found = solve(*conics)
            run.answer("expansion", [str(found.polcoef(i, "x")) for i in range(5)])


if __name__ == "__main__":
    main()
