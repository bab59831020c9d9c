"""Compares `burmester solve` for five positions with a second solver, on problems from a seed.

Usage: python3 scripts/five_positions_outside.py [--seed N] [--digits N] [--write FILE] [--command PATH]

Needs python-flint and the release build of the command. The second solver (outside/dialytic.py) eliminates
in another way and with other software: a determinant of order twelve, exact factors over Q, FLINT's
certified roots; in degrees and radians the same in Arb's balls. Compared are all counts, every pair
(both enclosures must meet, and be as narrow as promised), the pairs at infinity, the eliminant, and
that the pairs which a problem was made from are among those found. Ends with status 1 if anything
differs. With --write the problems are only written, one a line.
"""

import argparse
import json
import pathlib
import random
import subprocess
import sys
import time

import flint
from flint import arb, ctx

from outside.compare import Disagreement, compared, rational
from outside.dialytic import Family, Undecided, solve_balls, solve_exact
from outside.problems import KINDS, problems

ROOT = pathlib.Path(__file__).parent.parent


def enclosed(position):
    """Cosine, sine, x, y of a position whose angle is in degrees or radians."""
    (unit, angle), = position["angle"].items()
    size = arb(rational(angle))
    angle = size * arb.pi() / 180 if unit == "degrees" else size
    return angle.cos(), angle.sin(), arb(rational(position["x"])), arb(rational(position["y"]))


def is_sharp(pairs, digits):
    def sharp(number):
        return number.rad() <= 0 or number.rad() * arb(10) ** (digits + 10) < abs(number).upper() or number.contains(0)

    # A number that is zero may stay a ball around it: it must be small against the others.
    for pair in pairs:
        largest = max(abs(value).upper() for value in pair.points)
        for value in pair.points:
            for part in (value.real, value.imag):
                if not part.rad() * arb(10) ** (digits + 15) < largest and largest > 0:
                    return False
    return True


def second(problem, exact, digits):
    """Pairs and eliminant of the second solver, sharper than those of the command."""
    bits = 600
    while bits <= 20000:
        ctx.prec = bits
        try:
            if exact is not None:
                pairs, eliminant = solve_exact(exact, bits)
            else:
                pairs, eliminant = solve_balls([enclosed(p) for p in problem["positions"]])
            if is_sharp(pairs, digits):
                return pairs, eliminant
        except Undecided:
            pass
        bits *= 2
    raise Undecided


def checked(problem, exact, known, answer, digits):
    """`agree`, `undecided` or what differs, and the worst radius."""
    if "undecided" in answer and any(name in answer["undecided"] for name in ("pairs", "infinity", "family", "counts")):
        return "undecided", 0.0
    try:
        pairs, eliminant = second(problem, exact, digits)
        worst = compared(answer, pairs, eliminant, known, digits)
        return ("agree" if worst <= 1 else f"radius {worst:.3g} times what is promised"), worst
    except Family:
        return ("agree" if answer["family"] else "a family that the command does not see"), 0.0
    except Undecided:
        return "undecided by the second solver", 0.0
    except Disagreement as error:
        return str(error), 0.0


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--seed", type=int, default=1888)
    arguments.add_argument("--digits", type=int, default=40)
    arguments.add_argument("--write", metavar="FILE", help="write the problems of kinds with rational positions that are not degenerate")
    arguments.add_argument("--command", default=str(ROOT / "target/release/burmester"))
    chosen = arguments.parse_args()
    made = list(problems(random.Random(chosen.seed)))
    if chosen.write:
        ordinary = [problem for kind, problem, _, _ in made if kind in ("random, tan_half", "one pair chosen")]
        pathlib.Path(chosen.write).write_text("".join(json.dumps(problem) + "\n" for problem in ordinary[:200]))
        return 0
    lines = "".join(json.dumps(problem) + "\n" for _, problem, _, _ in made)
    start = time.perf_counter()
    run = subprocess.run([chosen.command, "solve", "--lines", "--digits", str(chosen.digits)], input=lines, capture_output=True, text=True)
    spent = time.perf_counter() - start
    answers = [json.loads(line) for line in run.stdout.splitlines()]
    if run.returncode != 0 or len(answers) != len(made):
        sys.exit(f"the command gave {len(answers)} answers to {len(made)} problems, status {run.returncode}: {run.stderr}")
    table = {kind: [0, 0, 0, 0, 0.0] for kind in KINDS}
    for (kind, problem, exact, known), answer in zip(made, answers):
        verdict, worst = checked(problem, exact, known, answer, chosen.digits)
        row = table[kind]
        row[0] += 1
        row[1 if verdict == "agree" else 3 if verdict.startswith("undecided") else 2] += 1
        row[4] = max(row[4], worst)
        if verdict != "agree":
            print(f"{problem['id']}: {verdict}\n  {json.dumps(problem)}", file=sys.stderr)
    print(f"python-flint {flint.__version__} (FLINT {flint.__FLINT_VERSION__}), seed {chosen.seed}, {chosen.digits} digits, the command took {spent:.1f} s\n")
    print("| kind | problems | agree | differ | undecided | worst radius, part of what is promised |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    rows = [*table.items(), ("all", [sum(row[k] for row in table.values()) for k in range(4)] + [max(row[4] for row in table.values())])]
    for kind, (count, agree, differ, undecided, worst) in rows:
        print(f"| {kind} | {count} | {agree} | {differ} | {undecided} | {worst:.2f} |")
    return 1 if rows[-1][1][2] else 0


if __name__ == "__main__":
    sys.exit(main())
