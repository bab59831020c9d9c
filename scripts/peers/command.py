"""The table "Speed to reach": ours, the best tools and hand-written kernels, on the same problems in one run.

Everything that is needed is built here: a virtual environment with the pinned peers from PyPI (numpy, python-flint,
cypari), the kernels in C and C++ by the machine's compiler, our own runner by cargo. For each row all programs run
alternately, in several rounds, on the same problems, which come from a seed. Their answers must agree; where they do
not, one line says so and the status is 1. Printed is a table of medians over the rounds.

Time is that which the processor spent on the program; still, on a busy machine ratios are more telling than times.

Kernels with balls need FLINT's headers. Debian, Ubuntu: apt install libflint-dev, and with FLINT 2 (Debian 12)
libflint-arb-dev as well; Fedora: dnf install flint-devel; Homebrew: brew install flint. A row whose kernel or peer
cannot be built says so. GMP is built at full speed only where m4 is installed when cargo builds it first.
"""

import argparse
import datetime
import importlib.metadata
import json
import os
import pathlib
import statistics
import subprocess
import sys

from . import build

RUNNER = "ours"


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="python3 scripts/peers", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", nargs="?", choices=["table", "growth"], default="table", help="the table, or how cost grows with digits and problems")
    parser.add_argument("--rows", metavar="WORDS", help="only rows whose name has one of these words, separated by commas")
    parser.add_argument("--rounds", type=int, default=7, help="how often every program runs (%(default)s)")
    parser.add_argument("--seed", type=int, default=1888, help="of the problems (%(default)s)")
    parser.add_argument("--quick", action="store_true", help="two rounds and a tenth of the problems: whether all of it works")
    parser.add_argument("--json", metavar="FILE", help="write what was measured, every round of it")
    chosen = parser.parse_args(arguments)
    try:
        from . import rows
    except ImportError as error:
        print(f"{error.name} could not be installed, and without it no answer can be checked", file=sys.stderr)
        return 2
    if chosen.what == "growth":
        from . import growth

        return growth.run(chosen)
    words = chosen.rows.split(",") if chosen.rows else [""]
    picked = [row for row in rows.ROWS if any(word in row.name for word in words)]
    if not picked:
        parser.error(f"no such row; there are: {', '.join(row.name for row in rows.ROWS)}")
    if chosen.quick:
        chosen.rounds = 2
    try:
        runner = build.runner()
    except build.Unbuilt as error:
        print(f"our own runner is missing: {error}", file=sys.stderr)
        return 2
    return measured(picked, runner, chosen)


def measured(rows, runner, chosen):
    about = surroundings(runner, chosen)
    print("\n".join(f"- {name}: {value}" for name, value in about.items()) + "\n")
    print("| row | ours | best tool | ratio | kernel | ratio | target | met |")
    print("| --- | ---: | ---: | ---: | ---: | ---: | --- | --- |", flush=True)
    record, accuracy, disagreed = [], [], False
    for row in rows:
        result = Measurement(row, runner, chosen)
        for line in row.lines:
            cells, data = result.line(line)
            print(f"| {' | '.join(cells)} |", flush=True)
            record.append(data)
        if result.worst:
            off = ", ".join(f"{name} {off:.1e}" for name, off in result.worst.items())
            accuracy.append(f"- {row.name}, largest error against certified answers: {off}")
        for complaint in result.complaints:
            print(f"{row.name}: {complaint}", file=sys.stderr)
            disagreed = True
    about["load at the end"] = load()
    print("\n" + "\n".join([*accuracy, f"- load at the end: {about['load at the end']}"]))
    if chosen.json:
        pathlib.Path(chosen.json).write_text(json.dumps({"about": about, "rows": record}, indent=1) + "\n")
    return 1 if disagreed else 0


def surroundings(runner, chosen):
    versions = []
    for name in ("numpy", "python-flint", "cypari"):
        try:
            versions.append(f"{name} {importlib.metadata.version(name)}")
        except importlib.metadata.PackageNotFoundError:
            versions.append(f"no {name}")
    import flint

    return {
        "date": datetime.date.today().isoformat(),
        "processor": f"{build.processor()}, {os.cpu_count()} of its threads",
        "load at the start": load(),
        "kernels": f"compiled for {build.instructions()}; {build.arb_version() or 'FLINT is missing'}",
        "GMP and MPFR of ours": build.gmp_of(runner),
        "peers": f"{', '.join(versions)} (FLINT {flint.__FLINT_VERSION__}), Python {sys.version.split()[0]}",
        "rounds": f"{chosen.rounds}, seed {chosen.seed}{', few problems' if chosen.quick else ''}",
    }


def load():
    try:
        return ", ".join(f"{x:.1f}" for x in os.getloadavg())
    except OSError:
        return "unknown"


class Measurement:
    """All programs of a row, alternately; seconds by program and task, and where answers disagree."""

    def __init__(self, row, runner, chosen):
        self.row, self.missing, self.seconds, self.worst, self.complaints = row, {}, {}, {}, []
        self.file = build.PLACE / f"{row.name}.txt"
        from .problems import written

        written(row.make, chosen.seed, max(2, row.count // 10) if chosen.quick else row.count, self.file)
        programs = {RUNNER: [runner]}
        for module in row.programs():
            programs[module] = [sys.executable, "-B", "-m", f"peers.tools.{module}"]
        if row.kernel:
            try:
                programs["kernel"] = [build.kernel(row.kernel)]
            except build.Unbuilt as error:
                self.missing["kernel"] = str(error)
        answers = {}
        for number in range(chosen.rounds):
            for name, command in programs.items():
                if name not in self.missing:
                    self.run(name, command, answers if number == 0 else None)
        self.compare(answers, programs)

    def run(self, name, command, answers, row_name=None):
        what = "times" if answers is None else "answers"
        call = [*command, row_name or self.row.name, self.file, what]
        done = subprocess.run(call, cwd=build.ROOT / "scripts", capture_output=True, text=True)
        if done.returncode:
            said = (done.stderr.strip().splitlines() or ["nothing"])[-1]
            self.missing[name] = f"status {done.returncode}: {said}"
            if "ModuleNotFoundError" not in said:
                self.complaints.append(f"{name} ended with {self.missing[name]}")
            return
        for line in map(json.loads, done.stdout.splitlines()):
            if "seconds" in line:
                self.seconds.setdefault((name, line["task"]), []).append(line["seconds"])
            else:
                answers.setdefault((name, line["task"]), []).append(line["answer"])

    def compare(self, answers, programs):
        """All answers with those of the reference, which may be a program that is not timed here."""
        from .agree import Disagreement

        module, asked_as = self.row.reference
        if module in programs:
            (wanted,) = [found for (name, _), found in answers.items() if name == module][:1] or [None]
        else:
            extra = {}
            self.run("reference", [sys.executable, "-B", "-m", f"peers.tools.{module}"], extra, asked_as)
            wanted = next((found for found in extra.values()), None)
        if wanted is None:
            self.complaints.append("there is no reference to compare with")
            return
        by_task = {task: found for (name, task), found in answers.items() if name == module}
        for (name, task), found in answers.items():
            loose = any(peer.module == name and peer.loose for line in self.row.lines for peer in line.peers)
            check = self.row.loose_check if loose else self.row.check
            reference = by_task.get(task, wanted)
            reference = reference * len(found) if len(reference) == 1 else reference
            for number, (ours, theirs) in enumerate(zip(found, reference, strict=True), 1):
                try:
                    off = check(ours, theirs)
                    if off is not None:
                        self.worst[name] = max(self.worst.get(name, 0), off)
                except Disagreement as error:
                    self.complaints.append(f"{name}, {task}, problem {number}: {error}")
                    break

    def line(self, line):
        """The cells of a line, and what was measured."""
        median = {key: statistics.median(times) for key, times in self.seconds.items()}
        ours = median.get((RUNNER, line.task))
        tools = {peer.tool: median.get((peer.module, peer.task)) for peer in line.peers}
        kernel = median.get(("kernel", line.kernel)) if line.kernel else None
        sure = [peer.tool for peer in line.peers if not peer.loose and tools[peer.tool]]
        best = min(sure, key=tools.get, default=None)
        others = [f"{tool} {shown(tools[tool])}" for tool in tools if tool != best and tools[tool]]
        others += [f"no {peer.tool}: {self.missing[peer.module]}" for peer in line.peers if peer.module in self.missing]
        said = f"{best} {shown(tools[best])}" if best else "none"
        if others:
            said += f" ({'; '.join(others)})"
        against = {"the kernel": kernel, "seconds": 1.0} | tools
        verdicts = []
        for target in line.targets:
            base = against.get(target.against)
            verdicts.append("unknown" if not (ours and base) else "met" if ours <= target.share * base else "missed")
        alone = median.get(("kernel", f"mpfr {line.kernel}"))
        plain = f" (MPFR alone {shown(alone)})" if alone else ""
        cells = [
            line.title,
            shown(ours) if ours else f"failed: {self.missing.get(RUNNER)}",
            said,
            ratio(ours, tools.get(best)),
            shown(kernel) + plain if kernel else f"no kernel: {self.missing.get('kernel', self.row.no_kernel)}",
            ratio(ours, kernel),
            "; ".join(map(str, line.targets)) or "–",
            "; ".join(verdicts) or "–",
        ]
        rounds = {f"{name}, {task}": times for (name, task), times in self.seconds.items()}
        data = {"row": self.row.name, "line": line.title, "ours": ours, "tools": tools, "kernel": kernel, "target": cells[6],
                "met": cells[7], "doubles are off by": self.worst, "missing": self.missing, "rounds": rounds}
        return cells, data


def shown(seconds):
    for unit, size in (("ns", 1e-9), ("µs", 1e-6), ("ms", 1e-3)):
        if seconds < 999.5 * size:
            return f"{seconds / size:.3g} {unit}"
    return f"{seconds:.3g} s"


def ratio(ours, theirs):
    return f"{ours / theirs:.2f}" if ours and theirs else "–"
