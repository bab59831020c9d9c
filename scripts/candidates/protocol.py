"""What every candidate in Python needs: positions in floats, and the loop over lines.

Only the standard library is used. Numbers come as texts ("3", "-5/13", "0.125") or as JSON numbers.
"""

import cmath
import json
import math
import sys
from fractions import Fraction


class Skipped(Exception):
    """The candidate does not do such problems; says why."""


def number(value):
    return float(Fraction(str(value)))


def rotation(angle):
    """The unit complex number of an angle."""
    if "degrees" in angle:
        return cmath.rect(1, math.radians(number(angle["degrees"])))
    if "radians" in angle:
        return cmath.rect(1, number(angle["radians"]))
    if "tan_half" in angle:
        t = number(angle["tan_half"])
        return complex(1 - t * t, 2 * t) / (1 + t * t)
    return complex(number(angle["cos"]), number(angle["sin"]))


def positions(problem):
    """Pairs (r, t) of complex numbers: the moving point z comes to r z + t."""
    entries = problem["positions"]
    if "points" not in entries[0]:
        return [(rotation(e["angle"]), complex(number(e["x"]), number(e["y"]))) for e in entries]
    bodies = [[complex(number(x), number(y)) for x, y in e["points"]] for e in entries]
    a, b = bodies[0]
    turns = [(d - c) / (b - a) for c, d in bodies]
    turns = [r / abs(r) for r in turns]
    # Fitted bodies change their length: it is their middle that is carried over.
    return [(r, (c + d - r * (a + b)) / 2) for r, (c, d) in zip(turns, bodies)]


def serve(solve):
    """Answers every line with solve(problem); what goes wrong is said, and the next line is read."""
    for line in sys.stdin:
        problem = json.loads(line, parse_float=str)
        try:
            # Infinite numbers and NaN are no JSON.
            answer = json.dumps({"result": solve(problem)}, allow_nan=False)
        except Skipped as reason:
            answer = json.dumps({"skipped": str(reason)})
        except Exception as error:
            answer = json.dumps({"error": f"{type(error).__name__}: {error}"})
        # Flushed at once: who asks waits for this line.
        print(answer, flush=True)
