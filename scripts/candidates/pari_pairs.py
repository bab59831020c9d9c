"""Five positions by PARI: the resultant of two conics, and its roots to 77 digits.

Rational positions are kept exact until the roots are taken; others are real numbers of 77 digits. Nothing
is certified: a root counts as real where its imaginary part is small.

Installed with `pip install cypari` (a wheel that holds PARI; cypari2 would have to be built); tried with
Python 3.11.7, cypari 2.5.7, PARI 2.15.4.
"""

from cypari import pari

from protocol import Skipped, serve

# Of 77 digits.
BITS = 256
pari.set_real_precision(77)
SMALL = pari("1e-40")
x, y = pari("x"), pari("y")


def number(value):
    text, _, exponent = str(value).lower().partition("e")
    whole, _, decimals = text.partition(".")
    return pari(whole + decimals) * pari(10) ** (int(exponent or 0) - len(decimals))


def position(entry):
    """Cosine, sine, x, y."""
    angle = entry["angle"]
    if "cos" in angle:
        c, s = number(angle["cos"]), number(angle["sin"])
    elif "tan_half" in angle:
        t = number(angle["tan_half"])
        c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    else:
        phi = number(angle["degrees"]) * pari("Pi") / 180 if "degrees" in angle else number(angle["radians"])
        c, s = phi.cos(precision=BITS), phi.sin(precision=BITS)
    return c, s, number(entry["x"]), number(entry["y"])


def condition(c, s, a, b):
    return [-2 * a, -2 * b, -2 * c, 2 * s, a * a + b * b + 2 * (a * c + b * s) * x + 2 * (b * c - a * s) * y]


def pairs_of(problem):
    base, *others = [condition(*position(e)) for e in problem["positions"]]
    rows = [[u - v for u, v in zip(row, base)] for row in others]
    matrix = pari.matrix(4, 4, [u for row in rows for u in row[:4]])
    if matrix.matdet() == 0:
        raise Skipped("the conditions cannot be solved for the center")
    solution = matrix.matsolve(pari([-row[4] for row in rows]).mattranspose())
    X, Y, p, q = (solution[k, 0] for k in range(4))
    conics = x * X + y * Y - p, y * X - x * Y - q
    quartic = conics[0].polresultant(conics[1], y)
    if quartic.poldegree(x) < 1:
        raise Skipped("no isolated finite pair")
    exact = quartic.type() == "t_POL" and all(c.type() in ("t_INT", "t_FRAC") for c in quartic.Vec())
    # Of conics in y the remainder is linear in y, and vanishes for the common root.
    first, second = (f.polcoef(2, y) for f in conics)
    line = first * conics[1] - second * conics[0]
    found = []
    for root in (quartic / quartic.gcd(quartic.deriv(x)) if exact else quartic).polroots(precision=BITS):
        slope, rest = line.polcoef(1, y).subst(x, root), line.polcoef(0, y).subst(x, root)
        if abs(slope) <= SMALL * size(line.polcoef(1, y), root):
            raise Skipped("pairs that this elimination does not tell apart")
        other = -rest / slope
        at = [f.subst(x, root).subst(y, other) for f in (X, Y)]
        found.append((root, other, *at))
    return found


def size(polynomial, root):
    """The sum of the absolute values of its terms."""
    return sum(abs(polynomial.polcoef(k, x)) * abs(root) ** k for k in range(2))


def is_real(z):
    return abs(z.imag()) <= abs(z) * SMALL or abs(z) < SMALL


def shown(z):
    """As the protocol has it: PARI writes 3.14 E-30, and 0.E-77 for a zero."""
    return "0" if z == 0 else str(pari("1.") * z).replace(" E", "e")


def solve(problem):
    if problem["problem"] != "five-positions":
        raise Skipped("five positions only")
    if "points" in problem["positions"][0]:
        raise Skipped("positions by their angles only")
    real, above = [], []
    for pair in pairs_of(problem):
        if all(is_real(z) for z in pair):
            x, y, X, Y = (shown(z.real()) for z in pair)
            real.append({"circlepoint": [x, y], "center": [X, Y]})
        else:
            x, y, X, Y = ({"re": shown(z.real()), "im": shown(z.imag())} for z in pair)
            above.append({"circlepoint": [x, y], "center": [X, Y]})
    return {"pairs": real, "complex_pairs": above}


serve(solve)
