"""Whether answers agree: balls overlap, floats keep within a bound, exact numbers are equal.

Each function compares an answer with the reference and returns how far it is off, as a share of what is allowed;
it raises `Disagreement` where it is more.
"""

import re
from itertools import combinations

from flint import Ordering, acb, arb, ctx, fmpq, fmpz_mpoly_ctx

from .tools.numbers import ball

# Of doubles, against the largest coordinate of a pair, the size of a linkage, a point's homogeneous coordinates.
PAIRS, PLACES, POINTS = 1e-6, 1e-12, 1e-12


class Disagreement(Exception):
    pass


def number(text):
    """A ball; decimals of a tool that certifies nothing as their own digits, but for the last ten."""
    if isinstance(text, list):
        return acb(number(text[0]), number(text[1]))
    if "/" in text or (" " in text and "." not in text):
        return ball(text)
    return arb(text.replace(" ", "").replace("E", "e"))


def pairs(answer, reference, digits, certified=True):
    """Five positions: the count of real pairs, and every pair once; certified ones known to so many digits."""
    (real, found), (wanted_real, wanted) = answer, reference
    if real != wanted_real or len(found) != len(wanted):
        raise Disagreement(f"{real} real of {len(found)} pairs, not {wanted_real} of {len(wanted)}")
    ctx.prec = digits * 10 // 3 + 200
    found, wanted = upper(found), upper(wanted)
    for pair in found:
        if certified and not all(sharp(point, digits) for point in (pair[:2], pair[2:])):
            raise Disagreement(f"a pair is not known to {digits} digits")
        size = max(abs(z).upper() for z in pair) * arb(10) ** -(digits - 10)
        room = acb(arb(0, 1), arb(0, 1)) * size if not certified else acb(0)
        fits = [other for other in wanted if all((z + room).overlaps(w) for z, w in zip(pair, other))]
        if len(fits) != 1:
            raise Disagreement(f"a pair overlaps {len(fits)} of the reference")
        wanted.remove(fits[0])


def upper(pairs):
    """Of conjugate pairs that with x above the real axis."""
    pairs = [[acb(number(z)) for z in pair] for pair in pairs]
    return [[z.conjugate() for z in pair] if pair[0].imag < 0 else pair for pair in pairs]


def sharp(point, digits):
    size = max(max(abs(z.real).lower(), abs(z.imag).lower()) for z in point) * arb(10) ** -digits
    return all(part.rad() <= size for z in point for part in (z.real, z.imag))


def float_pairs(answer, reference):
    real, wanted = reference
    if sum(all(im == 0 for _, im in pair) for pair in answer) != real or len(answer) != len(wanted):
        raise Disagreement(f"{len(answer)} pairs, or not {real} of them real")
    wanted = [[complex(z) for z in pair] for pair in upper(wanted)]
    worst = 0
    for pair in answer:
        pair = [complex(re, -im if pair[0][1] < 0 else im) for re, im in pair]
        off = [max(abs(z - w) for z, w in zip(pair, other)) / max(map(abs, other)) for other in wanted]
        nearest = min(off)
        wanted.pop(off.index(nearest))
        worst = max(worst, within(nearest, PAIRS))
    return worst


def within(off, bound):
    if not off <= bound:
        raise Disagreement(f"off by {off:.2g}, more than {bound:.0e}")
    return off


def places(answer, reference):
    ctx.prec = 400
    for ours, theirs in zip(answer, reference, strict=True):
        if not all(ball(x).overlaps(ball(y)) for x, y in zip(ours, theirs, strict=True)):
            raise Disagreement("a place does not overlap that of the reference")


def float_places(answer, reference):
    wanted = [[float(ball(x)) for x in part] for part in reference]
    size = max(abs(x) for part in wanted for x in part)
    return max(within(abs(x - y) / size, PLACES) for a, b in zip(answer, wanted) for x, y in zip(a, b, strict=True))


def points(answer, reference):
    """Homogeneous coordinates are those of one point where all minors can vanish."""
    ctx.prec = 400
    for p, q in zip(answer, reference, strict=True):
        p, q = list(map(ball, p)), list(map(ball, q))
        if not all((p[i] * q[j] - p[j] * q[i]).contains(0) for i, j in combinations(range(3), 2)):
            raise Disagreement("a point does not overlap that of the reference")
        if any(x.rad() > arb(10) ** -60 * max(abs(y).upper() for y in p) for x in p):
            raise Disagreement("a point is not known to 60 digits")


def float_points(answer, reference):
    worst = 0
    for p, q in zip(answer, reference, strict=True):
        q = [float(ball(x)) for x in q]
        size = sum(x * x for x in p) ** 0.5 * sum(x * x for x in q) ** 0.5
        off = max(abs(p[i] * q[j] - p[j] * q[i]) for i, j in combinations(range(3), 2)) / size
        worst = max(worst, within(off, POINTS))
    return worst


def proportional(answer, reference):
    p, q = ([fmpq(*map(int, (text + "/1").split("/")[:2])) for text in numbers] for numbers in (answer, reference))
    k = next(i for i, x in enumerate(q) if x != 0)
    if p[k] == 0 or any(x * q[k] != y * p[k] for x, y in zip(p, q, strict=True)):
        raise Disagreement("the coefficients are not those of one curve")


def polynomials(answer, reference):
    if [polynomial(text) for text in answer] != [polynomial(text) for text in reference]:
        raise Disagreement("the polynomials differ")


def polynomial(text):
    """Terms of a sum of products, `-2 a b^2 + 3*c`."""
    ring = fmpz_mpoly_ctx.get(list("abcdefghkl"), Ordering.lex)
    letters = dict(zip("abcdefghkl", ring.gens()))
    python = re.sub(r"(?<=[\w)]) +(?=[\w(])|(?<=\w)\*(?=\w)", "*", text).replace("^", "**")
    return eval(python, {"__builtins__": {}}, letters)  # noqa: S307: what our own programs print


def balls(answer, reference):
    ctx.prec = 400
    if not all(ball(x).overlaps(ball(y)) for x, y in zip(answer, reference, strict=True)):
        raise Disagreement("the balls do not overlap")
