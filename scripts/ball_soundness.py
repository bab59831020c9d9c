#!/usr/bin/env python3
"""Millions of random computations on balls, compared with a second library (python-flint).

    python3 scripts/ball_soundness.py [--operations 10000000] [--seed 1888] [--jobs 2]

Our side is examples/ball_calculator.rs, the other FLINT's arb. A computation starts from balls; for a
point of each the exact course of the computation is enclosed by arb at a precision that is raised until
it is plain whether the result lies in our ball. Kinds of computation:

    single      one operation; radii from 0 to far above the midpoint, exponents to ±4000
    turning     sin, cos, tan around multiples of π/2, asin and acos around ±1, sqrt around 0
    cut         atan2 around the negative x axis and the origin
    cancel      sums and differences of nearly the same number, products of their quotients
    expression  four to twelve operations in a row

Counted are the operations whose result could be compared. Status 1 if one result misses, 2 if something is missing.
"""

import argparse
import concurrent.futures
import collections
import pathlib
import random
import subprocess
import sys
import time

try:
    import flint
    from flint import arb, ctx, fmpz
except ImportError:
    print("python-flint is missing: pip install python-flint", file=sys.stderr)
    sys.exit(2)

ROOT = pathlib.Path(__file__).resolve().parents[1]
CALCULATOR = ROOT / "target/release/examples/ball_calculator"
CHUNK = 50_000
PRECISIONS = [256, 1024, 4096, 16384]

UNARY = {"neg": lambda x: -x, "sqrt": arb.sqrt, "sin": arb.sin, "cos": arb.cos, "tan": arb.tan,
         "asin": arb.asin, "acos": arb.acos, "atan": arb.atan}
BINARY = {"add": lambda x, y: x + y, "sub": lambda x, y: x - y, "mul": lambda x, y: x * y,
          "div": lambda x, y: x / y, "atan2": lambda y, x: arb.atan2(y, x)}
ARITHMETIC = ["add", "sub", "mul", "div"]
# Numerators over 2^64 of π/2, which turning points are multiples of.
HALF_PI = 28976077338029890953


class Dyadic:
    """m·2^e, exactly."""

    __slots__ = ("m", "e")

    def __init__(self, m, e):
        self.m, self.e = m, e

    def shown(self):
        return f"{self.m:x},{self.e}"

    def plus(self, other):
        if self.m == 0:
            return other
        if other.m == 0:
            return self
        low = min(self.e, other.e)
        return Dyadic((self.m << (self.e - low)) + (other.m << (other.e - low)), low)

    def arb(self):
        return arb((fmpz(self.m), fmpz(self.e)))


def exponent(rng):
    kind = rng.random()
    return rng.randint(-4000, 4000) if kind < 0.08 else rng.randint(-120, 120) if kind < 0.4 else rng.randint(-24, 6)


def number(rng):
    if rng.random() < 0.04:
        return Dyadic(rng.randint(-3, 3), 0)
    return Dyadic(rng.choice((-1, 1)) * rng.getrandbits(rng.choice((8, 20, 53))), exponent(rng) - 20)


def radius(rng, mid):
    kind = rng.random()
    if kind < 0.25 or mid.m == 0 and kind < 0.5:
        return Dyadic(0, 0)
    top = mid.m.bit_length() + mid.e
    if kind < 0.85:
        return Dyadic(1 + rng.getrandbits(12), top - 12 - rng.randint(-1, 140))
    return Dyadic(1 + rng.getrandbits(12), exponent(rng))


def ball(rng, mid):
    """The word for the calculator, and a point in the ball."""
    bits = rng.choice((2, 10, 24, 53, 64, 100, 128, 200))
    r = radius(rng, mid)
    part = rng.choice((-64, 64, 0, rng.randint(-64, 64)))
    return f"{mid.shown()},{r.shown()},{bits}", mid.plus(Dyadic(r.m * part, r.e - 6))


def single(rng):
    name = rng.choice((*ARITHMETIC, *ARITHMETIC, *UNARY))
    first = ball(rng, number(rng))
    return [first, name] if name in UNARY else [first, ball(rng, number(rng)), name]


def turning(rng):
    name = rng.choice(("sin", "cos", "tan", "asin", "acos", "sqrt"))
    if name in ("sin", "cos", "tan"):
        mid = Dyadic(HALF_PI * rng.randint(-9, 9), -64)
    else:
        mid = Dyadic(0 if name == "sqrt" else rng.choice((-1, 1)), 0)
    return [ball(rng, mid.plus(Dyadic(rng.randint(-9, 9), -rng.randint(2, 80)))), name]


def cut(rng):
    tiny = lambda: Dyadic(rng.randint(-9, 9), -rng.randint(0, 90))
    x = tiny() if rng.random() < 0.4 else Dyadic(-rng.getrandbits(20), exponent(rng) - 20)
    return [ball(rng, tiny()), ball(rng, x), "atan2"]


def cancel(rng):
    mid = number(rng)
    near = mid.plus(Dyadic(rng.randint(-9, 9) * (mid.m or 1), mid.e - rng.randint(4, 120)))
    words = [ball(rng, mid), ball(rng, near), "sub"]
    if rng.random() < 0.5:
        words += [ball(rng, mid), "div", ball(rng, number(rng)), "add", ball(rng, mid), "mul"]
    return words


def expression(rng):
    words, height = [], 0
    for _ in range(rng.randint(4, 12)):
        while height < 2:
            words.append(ball(rng, number(rng)))
            height += 1
        name = rng.choice((*ARITHMETIC, *ARITHMETIC, *UNARY, "atan2"))
        words.append(name)
        height -= name in BINARY
        if rng.random() < 0.5:
            words.append(ball(rng, number(rng)))
            height += 1
    return words + [rng.choice(ARITHMETIC) for _ in range(height - 1)]


KINDS = {"single": single, "turning": turning, "cut": cut, "cancel": cancel, "expression": expression}
WEIGHTS = [30, 15, 10, 15, 30]


def true_value(words, bits):
    """arb's enclosure of the value at the points."""
    ctx.prec = bits
    stack = []
    for word in words:
        if isinstance(word, tuple):
            stack.append(word[1].arb())
        elif word in UNARY:
            stack.append(UNARY[word](stack.pop()))
        else:
            second = stack.pop()
            stack.append(BINARY[word](stack.pop(), second))
    return stack.pop()


def is_undefined(words):
    """Whether an operation meets a point where it has no value (an operation that cannot tell is none)."""
    ctx.prec = 2048
    stack = []
    for word in words:
        if isinstance(word, tuple):
            stack.append(word[1].arb())
            continue
        second = stack.pop() if word in BINARY else None
        first = stack.pop()
        if word == "div" and second.contains(0) or word == "atan2" and first.contains(0) and second.contains(0):
            return True
        if word == "sqrt" and (first < 0 or first.contains(0)):
            return True
        if word in ("asin", "acos") and (abs(first) > 1 or abs(first).contains(1)):
            return True
        stack.append(UNARY[word](first) if second is None else BINARY[word](first, second))
    return False


def judged(words, answer):
    """`in`, `escape`, `unknown` (ours says nothing), `undefined` (the point has no value), `open`."""
    if answer == "unknown":
        return "unknown"
    if answer == "none":
        # Said only where the operation has a value nowhere on its ball.
        return "undefined" if is_undefined(words) else "escape"
    m, e, r, s = answer.split(",")
    mid, rad = Dyadic(int(m, 16), int(e)), Dyadic(int(r, 16), int(s))
    low, high = mid.plus(Dyadic(-rad.m, rad.e)), mid.plus(rad)
    for bits in PRECISIONS:
        value = true_value(words, bits)
        if value.is_nan() or not value.is_finite():
            if is_undefined(words):
                return "undefined"
            continue
        # The ends are taken exactly.
        ctx.prec = 200_000
        below, above = value - low.arb(), high.arb() - value
        if below >= 0 and above >= 0:
            return "in"
        if below < 0 or above < 0:
            return "escape"
    return "open"


def chunk(seed):
    rng = random.Random(seed)
    kinds = rng.choices(list(KINDS), WEIGHTS, k=CHUNK // 3)
    problems = [KINDS[kind](rng) for kind in kinds]
    lines = [" ".join(w[0] if isinstance(w, tuple) else w for w in words) for words in problems]
    run = subprocess.run([CALCULATOR], input="\n".join(lines) + "\n", capture_output=True, text=True)
    answers = run.stdout.split()
    if run.returncode or len(answers) != len(lines) or "error" in answers:
        raise SystemExit(f"the calculator failed on seed {seed}: {run.stderr}")
    counts, escapes = collections.Counter(), []
    for kind, words, line, answer in zip(kinds, problems, lines, answers):
        fate = judged(words, answer)
        done = sum(not isinstance(word, tuple) for word in words)
        counts[kind, fate] += done
        if fate == "escape":
            escapes.append((line, answer))
    return counts, escapes


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--operations", type=int, default=10_000_000)
    parser.add_argument("--seed", type=int, default=1888)
    parser.add_argument("--jobs", type=int, default=2)
    given = parser.parse_args()
    built = subprocess.run(["cargo", "build", "--release", "--quiet", "--example", "ball_calculator"], cwd=ROOT)
    if built.returncode:
        return 2
    start, total, counts, escapes = time.monotonic(), 0, collections.Counter(), []
    with concurrent.futures.ProcessPoolExecutor(given.jobs) as pool:
        seeds, running = iter(range(given.seed * 1_000_000, 10**12)), set()
        while total < given.operations and not escapes:
            while len(running) < 2 * given.jobs:
                running.add(pool.submit(chunk, next(seeds)))
            done, running = concurrent.futures.wait(running, return_when="FIRST_COMPLETED")
            for future in done:
                found, wrong = future.result()
                counts += found
                escapes += wrong
            total = sum(number for (_, fate), number in counts.items() if fate in ("in", "escape"))
            if sys.stderr.isatty():
                print(f"\r{total:,} operations", end="", file=sys.stderr)
    fates = ["in", "undefined", "unknown", "open", "escape"]
    print("| computations | " + " | ".join(fates) + " |\n|" + " --- |" * (len(fates) + 1))
    for kind in KINDS:
        print(f"| {kind} | " + " | ".join(f"{counts[kind, fate]:,}" for fate in fates) + " |")
    print(f"\n{total:,} operations compared, seed {given.seed}, python-flint {flint.__version__}, "
          f"{time.monotonic() - start:.0f} s; {len(escapes)} escapes")
    for line, answer in escapes[:5]:
        print(f"escape: {line} -> {answer}")
    return 1 if escapes else 0


if __name__ == "__main__":
    sys.exit(main())
