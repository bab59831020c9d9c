"""Writes tests/data/univariate_values.txt: roots, resultants and factors by an independent library.

Usage: python3 scripts/univariate_values.py [seed]
Needs python-flint (pip install python-flint). Coefficients are integers, the constant one first.
Lines are

    roots;coefficients;multiplicity re re_radius im im_radius;...
    resultant;coefficients;coefficients;value
    discriminant;coefficients;value
    gcd;coefficients;coefficients;primitive coefficients
    sturm;coefficients;number of different real roots

A root is within the radii of (re, im); all roots are listed, real ones with "im 0 0". The same seed
and version write the same file.
"""

import pathlib
import random
import sys

import flint
from flint import acb, ctx, fmpz_poly

DIGITS = 50


def coefficients(p):
    return " ".join(str(c) for c in p.coeffs())


def product(factors):
    result = fmpz_poly([1])
    for factor in factors:
        result *= factor
    return result


def chebyshev(n):
    a, b = fmpz_poly([1]), fmpz_poly([0, 1])
    for _ in range(n):
        a, b = b, 2 * fmpz_poly([0, 1]) * b - a
    return a


def random_poly(rng, degree, size):
    inner = [rng.randint(-size, size) for _ in range(degree)]
    return fmpz_poly([*inner, rng.randint(1, size)])


def polynomials(rng):
    yield product(fmpz_poly([-k, 1]) for k in range(1, 21))
    yield chebyshev(24)
    yield fmpz_poly([0] * 9 + [1]) + fmpz_poly([-2, 2 * 10**8, -(10**16) // 2])
    yield fmpz_poly([-1] + [0] * 16 + [1])
    for degree in (2, 3, 4, 5, 6, 8, 12, 20, 40):
        yield random_poly(rng, degree, 10**6)
    yield random_poly(rng, 6, 10**200)
    for _ in range(12):
        factors = [random_poly(rng, rng.randint(1, 3), 20) for _ in range(3)]
        yield product(f ** rng.randint(1, 4) for f in factors)


def decimal(ball):
    shown = ball.str(DIGITS, more=True)
    if "+/-" not in shown:
        return f"{shown} 0"
    value, radius = shown.strip("[]").split(" +/- ")
    return f"{value} {radius}"


def roots_line(p):
    cells = []
    for root, multiplicity in p.complex_roots():
        root = acb(root)
        cells.append(f"{multiplicity} {decimal(root.real)} {decimal(root.imag)}")
    return ";".join(["roots", coefficients(p), *cells])


def real_count(p):
    return sum(1 for root, _ in p.complex_roots() if acb(root).imag == 0)


def lines(rng):
    for p in polynomials(rng):
        yield roots_line(p)
        yield f"sturm;{coefficients(p)};{real_count(p)}"
    for _ in range(20):
        p = random_poly(rng, rng.randint(1, 9), 10 ** rng.randint(1, 20))
        q = random_poly(rng, rng.randint(1, 9), 10 ** rng.randint(1, 20))
        yield f"resultant;{coefficients(p)};{coefficients(q)};{p.resultant(q)}"
        yield f"discriminant;{coefficients(p)};{p.discriminant()}"
        common = random_poly(rng, rng.randint(1, 4), 10**6)
        gcd = (p * common).gcd(q * common)
        gcd = gcd / gcd.content()
        yield f"gcd;{coefficients(p * common)};{coefficients(q * common)};{coefficients(fmpz_poly(gcd))}"


def main():
    seed = int(sys.argv[1]) if len(sys.argv) > 1 else 1888
    ctx.prec = 400
    target = pathlib.Path(__file__).parent.parent / "tests" / "data" / "univariate_values.txt"
    target.parent.mkdir(parents=True, exist_ok=True)
    header = f"# scripts/univariate_values.py, seed {seed}, python-flint {flint.__version__}"
    target.write_text("\n".join([header, *lines(random.Random(seed)), ""]))


if __name__ == "__main__":
    main()
