"""The answers and the errata of `data/`, recomputed from the data files alone, in another system.

Every part derives its own result and compares; nothing asks the library or the command. The files read are
data/problems, data/answers and data/papers. Ends with status 1 if anything disagrees, 2 if something that is
needed is missing. Needs python-flint and mpmath.
"""

import argparse
import platform
import sys
import time

import flint
import mpmath

from . import (alternates, centerpoint, curvature, errata, examples, five_positions, focal, mixed, selftest, table,
               tangents, three_positions)

PARTS = {
    "five positions": lambda report, seed: five_positions.run(report),
    "both curves of four positions": lambda report, seed: centerpoint.run(report),
    "poles and three positions": lambda report, seed: three_positions.run(report),
    "positions that came together": lambda report, seed: mixed.run(report),
    "curvature in one position": lambda report, seed: curvature.run(report),
    "alternates of slider-cranks": lambda report, seed: alternates.run(report),
    "focal mechanisms and Hart's": lambda report, seed: focal.run(report),
    "errata of equations and claims": lambda report, seed: all_errata(report, seed),
    "lines that hold, in the same scenes": lambda report, seed: errata.run(report, "holds", seed, known_only=True),
    "lines that hold under a condition, likewise": lambda report, seed: errata.run(report, "holds-if", seed, known_only=True),
    "tables of 1973": tangents.run,
    "output and table of 1964": table.run,
    "numbers of examples and figures": lambda report, seed: examples.run(report),
}


def all_errata(report, seed):
    errata.run(report, "fails", seed)
    examples.run(report, errata_only=True)


class Count:
    """Collects what a part reports: None for agreement, a text for anything else."""

    def __init__(self):
        self.agree, self.disagree, self.left = 0, [], []

    def __call__(self, name, verdict):
        if verdict is None:
            self.agree += 1
        elif verdict.startswith(("not replayed", "undecided")):
            self.left.append((name, verdict))
        else:
            self.disagree.append((name, verdict))

    def cases(self):
        return self.agree + len(self.disagree) + len(self.left)


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="python3 scripts/replay", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--part", action="append", metavar="WORDS", help="only parts whose name has these words; may be repeated")
    parser.add_argument("--seed", type=int, default=1964, help="of the configurations and of the emulated rounding (%(default)s)")
    parser.add_argument("--self-test", action="store_true", help="plant wrong data and see that every part notices them")
    parser.add_argument("--list", action="store_true", help="name every case that is not replayed, with the reason")
    chosen = parser.parse_args(arguments)
    if chosen.self_test:
        return selftest.main(chosen.seed)
    names = [name for name in PARTS if not chosen.part or any(words in name for words in chosen.part)]
    if not names:
        parser.error(f"no such part; there are: {', '.join(PARTS)}")
    return replayed(names, chosen.seed, chosen.list)


def replayed(names, seed, listed):
    print(f"python-flint {flint.__version__} (FLINT {flint.__FLINT_VERSION__}), mpmath {mpmath.__version__}, Python {platform.python_version()}, seed {seed}\n")
    print("| part | cases | agree | disagree | not replayed | seconds |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    total, start = Count(), time.perf_counter()
    for name in names:
        count, since = Count(), time.perf_counter()
        PARTS[name](count, seed)
        row(name, count, time.perf_counter() - since)
        total.agree += count.agree
        total.disagree += count.disagree
        total.left += count.left
    row("all", total, time.perf_counter() - start)
    for name, verdict in total.disagree:
        print(f"{name}: {verdict}", file=sys.stderr)
    if listed:
        print()
        for name, verdict in total.left:
            print(f"{name}: {verdict}")
    return 1 if total.disagree else 0


def row(name, count, seconds):
    print(f"| {name} | {count.cases()} | {count.agree} | {len(count.disagree)} | {len(count.left)} | {seconds:.1f} |", flush=True)
