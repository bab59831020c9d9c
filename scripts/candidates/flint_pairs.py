"""Five rational positions by python-flint, as a careful user of it would: certified balls, 30 digits.

The solver is scripts/peers/tools/five_positions_flint.py. It does not do pairs at infinity or infinitely many.

Installed with `pip install python-flint`; tried with Python 3.11.7, python-flint 0.9.0.
"""

import pathlib
import sys

sys.path.insert(1, str(pathlib.Path(__file__).resolve().parent.parent))

from flint import arb, ctx, fmpq
from peers.tools import five_positions_flint as peer

from protocol import Skipped, serve

DIGITS = 30


def rational(value):
    """Also decimals."""
    text, _, exponent = str(value).lower().partition("e")
    text, _, denominator = text.partition("/")
    whole, _, decimals = text.partition(".")
    power = int(exponent or 0) - len(decimals)
    scale = fmpq(10) ** power if power >= 0 else 1 / fmpq(10) ** -power
    return fmpq(int(whole + decimals), int(denominator or 1)) * scale


sharp = peer.is_sharp


def is_sharp(found, digits):
    """Gives up where more bits do not help: pairs of one x, multiple pairs."""
    if not sharp(found, digits) and ctx.prec > 2000:
        raise ValueError("pairs that this elimination does not tell apart")
    return sharp(found, digits)


peer.is_sharp = is_sharp


def position(entry):
    """Cosine, sine, x, y."""
    angle = entry["angle"]
    if "cos" in angle:
        c, s = rational(angle["cos"]), rational(angle["sin"])
    else:
        t = rational(angle["tan_half"])
        c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    return c, s, rational(entry["x"]), rational(entry["y"])


def shown(ball):
    return ball.mid().str(DIGITS + 5, radius=False)


def point(parts, conjugate=False):
    if isinstance(parts[0], arb):
        return [shown(z) for z in parts]
    return [{"re": shown(z.real), "im": shown(-z.imag if conjugate else z.imag)} for z in parts]


def pair(parts, conjugate=False):
    return {"circlepoint": point(parts[:2], conjugate), "center": point(parts[2:], conjugate)}


def solve(problem):
    if problem["problem"] != "five-positions":
        raise Skipped("five positions only")
    entries = problem["positions"]
    if not all("angle" in e and ("cos" in e["angle"] or "tan_half" in e["angle"]) for e in entries):
        raise Skipped("rational cosines and sines only")
    try:
        real, found = peer.solved([position(e) for e in entries], DIGITS)
    except (ValueError, ZeroDivisionError) as error:
        raise Skipped(str(error)) from None
    above = [pair(parts, c) for parts in found[real:] for c in (False, True)]
    answer = {"pairs": [pair(parts) for parts in found[:real]], "complex_pairs": above}
    # Of fewer than four some are multiple; which ones is not known.
    if real + len(above) == 4:
        answer["counts"] = {"real": real, "complex": len(above)}
    return answer


serve(solve)
