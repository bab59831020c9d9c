"""Writes scores (JSON files of `burmester score`) as tables between two marks of a page.

Usage: tables.py PAGE PROBLEMS FOLDER
"""

import datetime
import importlib.metadata
import json
import pathlib
import platform
import shutil
import subprocess
import sys

BEGIN, END = "<!-- scores begin -->", "<!-- scores end -->"
ORDER = ["numpy_quartic", "flint_pairs", "pari_pairs", "pylinkage_burmester", "burmester_f64", "newton"]


PACKAGES = ["numpy", "python-flint", "cypari", "pylinkage", "scipy"]


def versions():
    """Of what the candidates use, as far as it is there."""
    found = [f"Python {platform.python_version()}"]
    for package in PACKAGES:
        try:
            found.append(f"{package} {importlib.metadata.version(package)}")
        except importlib.metadata.PackageNotFoundError:
            pass
    if shutil.which("node"):
        version = subprocess.run(["node", "--version"], capture_output=True, text=True).stdout
        found.append("Node " + version.strip().removeprefix("v"))
    return ", ".join(found)


def ratio(part, whole):
    return f"{part}/{whole}" if whole else "–"


def time(seconds):
    return f"{seconds * 1e6:.0f} µs" if seconds < 1e-3 else f"{seconds * 1e3:.1f} ms" if seconds < 1 else f"{seconds:.1f} s"


def row(head, sums):
    facts, degenerate, digits, seconds = (sums[name] for name in ("facts", "degenerate", "digits", "seconds"))
    cells = [
        head,
        sums["problems"],
        sums["skipped"],
        sums["lost"],
        ratio(sums["found"], sums["found"] + sums["missed"]),
        sums["invented"],
        ratio(facts["right"], facts["right"] + facts["wrong"]),
        f"{digits['worst']:.1f}, {digits['median']:.1f}" if digits else "–",
        ratio(degenerate["right"], degenerate["cases"]),
        time(seconds["median"]),
    ]
    return "| " + " | ".join(map(str, cells)) + " |"


def table(first, rows):
    heads = [first, "problems", "skipped", "lost", "found", "invented", "facts", "digits", "degenerate", "time"]
    return ["| " + " | ".join(heads) + " |", "| --- " * len(heads) + "|", *rows]


def main():
    page, problems, folder = pathlib.Path(sys.argv[1]), sys.argv[2], pathlib.Path(sys.argv[3])
    reports = {path.stem: json.loads(path.read_text()) for path in folder.glob("*.json")}
    names = [name for name in ORDER if name in reports] + sorted(set(reports) - set(ORDER))
    today = datetime.date.today().isoformat()
    run = f"`scripts/candidates/score_all.sh` on {today}; problems: `{problems}`. With {versions()}."
    lines = [BEGIN, "", run, ""]
    lines += table("candidate", [row(f"`{name}`", reports[name]["total"]) for name in names])
    for name in names:
        asked = [c for c in reports[name]["by_corpus"] if c["skipped"] < c["problems"]]
        lines += ["", f"### {name}", "", "Without corpora that it declines altogether.", ""]
        lines += table("corpus", [row(c["corpus"], c) for c in asked])
    text = page.read_text()
    before, rest = text.split(BEGIN)
    _, after = rest.split(END)
    page.write_text(before + "\n".join([*lines, "", END]) + after)


if __name__ == "__main__":
    main()
