"""Writes tests/data/ball_values.txt: values that an independent ball arithmetic computed.

Usage: python3 scripts/ball_values.py [seed]
Needs python-flint (pip install python-flint). Arguments are exact rationals; each line is

    function;argument[;argument];value;radius

where the true value is within radius of value. The same seed and version write the same file.
"""

import pathlib
import random
import sys

import flint
from flint import arb, ctx, fmpq, fmpz

DIGITS = 60
FUNCTIONS = "sqrt sin cos tan asin acos atan".split()


def rational(rng, spread=40):
    """A random fraction of random magnitude, 10^-spread to 10^spread."""
    numerator = rng.randint(-(10**6), 10**6) or 1
    denominator = rng.randint(1, 10**6)
    power = rng.choice([0, 0, 0, rng.randint(-spread, spread)])
    q = fmpq(numerator, denominator)
    ten = fmpz(10) ** abs(power)
    return q * ten if power >= 0 else q / ten


def within_one(rng):
    """A random fraction in (-1, 1), sometimes close to an end."""
    near = fmpq(1, 10 ** rng.randint(1, 30)) if rng.random() < 0.3 else fmpq(rng.randint(0, 999), 1000)
    q = 1 - near
    return -q if rng.random() < 0.5 else q


def text(q):
    return f"{q.p}/{q.q}"


def decimal(ball):
    """Value and radius as decimals: arb's own output of 60 digits, error included."""
    shown = ball.str(DIGITS, more=True)
    if "+/-" not in shown:
        return shown, "0"
    value, radius = shown.strip("[]").split(" +/- ")
    return value, radius


def line(name, arguments, ball):
    value, radius = decimal(ball)
    return ";".join([name, *map(text, arguments), value, radius])


def lines(rng):
    for name in FUNCTIONS:
        for _ in range(40):
            q = within_one(rng) if name in ("asin", "acos") else rational(rng)
            if name == "sqrt":
                q = abs(q)
            yield line(name, [q], getattr(arb(q), name)())
    for _ in range(60):
        y, x = rational(rng), rational(rng)
        yield line("atan2", [y, x], arb.atan2(arb(y), arb(x)))
    for _ in range(60):
        degrees = rational(rng, 12)
        turned = arb(degrees / 180)
        yield line("cos_degrees", [degrees], turned.cos_pi())
        yield line("sin_degrees", [degrees], turned.sin_pi())


def main():
    seed = int(sys.argv[1]) if len(sys.argv) > 1 else 1888
    ctx.prec = 600
    target = pathlib.Path(__file__).parent.parent / "tests" / "data" / "ball_values.txt"
    target.parent.mkdir(parents=True, exist_ok=True)
    header = f"# scripts/ball_values.py, seed {seed}, python-flint {flint.__version__}"
    target.write_text("\n".join([header, *lines(random.Random(seed)), ""]))


if __name__ == "__main__":
    main()
