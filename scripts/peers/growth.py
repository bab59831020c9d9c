"""How the cost grows: digits of certified five positions, problems in doubles (ours and the kernels), the chart's grid.

Each series is measured in one run, the programs alternately. Beside the times stands the exponent of the power law
through the last decade, by least squares of the logarithms, and what is expected.
"""

import json
import math
import pathlib
import resource
import subprocess
import sys
import tempfile

from . import build, problems

DIGITS = [100, 300, 1000, 3000, 10_000, 30_000, 100_000]
# Different ones; a longer file repeats them.
DIFFERENT = 500
MANY = [1, 10, 100, 1000, 10_000, 100_000, 1_000_000]
# Degrees between neighbours of the chart, whose linkages are counted.
STEPS = [15, 10, 5, 3, 2, 1]
ROUNDS = 3


def run(chosen):
    from .command import surroundings

    programs = {"ours": build.runner()}
    about = surroundings(programs["ours"], chosen)
    series = [
        {"what": "Five positions, certified: time of a problem", "across": "digits", "kernel": "five_positions_arb.c",
         "cases": [(n, f"five-{n}", 20, "pairs") for n in DIGITS[: 4 if chosen.quick else None]],
         "exponent": 1, "expected": "1, and a little for the logarithm: the multiplication of long numbers by FFT"},
        {"what": "Five positions in doubles: time of all problems", "across": "problems", "kernel": "five_positions_f64.cpp",
         "cases": [(n, "five-f64", n, "many") for n in MANY[: 4 if chosen.quick else None]], "exponent": 1, "expected": "1"},
        {"what": "Chart: time of all linkages on one processor", "across": "linkages", "cases": STEPS[: 4 if chosen.quick else None],
         "exponent": 1, "expected": "1"},
    ]
    for one in series:
        one["measured"] = measured(one, programs, chosen) if "kernel" in one else charts(one["cases"])
        del one["cases"]
        print(f"\n{one['what']}; expected exponent {one['expected']}\n")
        for name, points in one["measured"].items():
            print(f"- {name}: " + (points if isinstance(points, str) else ", ".join(f"{n}: {s:.3g}" for n, s in points["points"])))
            if not isinstance(points, str):
                print(f"  exponent over the last decade {points['exponent']:.2f}")
    if chosen.json:
        pathlib.Path(chosen.json).write_text(json.dumps({"about": about, "series": series}, indent=1) + "\n")
    return 0


def measured(series, programs, chosen):
    programs, found = dict(programs), {}
    try:
        programs["kernel"] = build.kernel(series["kernel"])
    except build.Unbuilt as error:
        found["kernel"] = f"no kernel: {error}"
    pool = build.PLACE / "growth-pool.txt"
    problems.written(problems.five_positions, chosen.seed, DIFFERENT, pool)
    lines = pool.read_text().splitlines(keepends=True)
    points = {name: [] for name in programs}
    for size, row, count, task in series["cases"]:
        file = build.PLACE / "growth.txt"
        file.write_text("".join(lines[i % DIFFERENT] for i in range(count)))
        best = dict.fromkeys(programs, math.inf)
        for _ in range(ROUNDS if size < 10_000 else 1):
            for name, program in programs.items():
                best[name] = min(best[name], seconds_of([program, row, file, "times"], task))
        for name, seconds in best.items():
            points[name].append((size, seconds * (count if task == "many" else 1)))
    return found | {name: {"points": at, "exponent": exponent(at)} for name, at in points.items()}


def charts(steps):
    """Of the whole command, by the linkages of its table."""
    command, points = build.command(), []
    for step in steps:
        best, rows = math.inf, 0
        for _ in range(ROUNDS if step > 5 else 1):
            with tempfile.TemporaryDirectory() as folder:
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                subprocess.run([command, "chart", "--step", str(step), "--threads", "1", "-o", folder], check=True, stdout=subprocess.DEVNULL)
                best = min(best, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
                table = next(pathlib.Path(folder).glob("*.csv")).read_text().splitlines()
            rows = sum(not line.startswith("#") for line in table) - 1
        points.append((rows, best))
    return {"ours": {"points": points, "exponent": exponent(points)}}


def seconds_of(command, task):
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f"{command[0]} ended with status {done.returncode}: {done.stderr.strip()}")
    return next(line["seconds"] for line in map(json.loads, done.stdout.splitlines()) if line.get("task") == task and "seconds" in line)


def exponent(points):
    last = [(math.log(n), math.log(s)) for n, s in points if n * 10 >= points[-1][0]]
    x, y = (sum(part) / len(last) for part in zip(*last))
    return sum((a - x) * (b - y) for a, b in last) / sum((a - x) ** 2 for a, _ in last)
