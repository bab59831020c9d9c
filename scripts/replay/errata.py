"""Statements of the papers, as printed and as corrected, on configurations of their scenes."""

import random
import tomllib

from .corpora import ROOT
from .evaluate import NoValue, Unknown, evaluate
from .formula import Unreadable
from .scenes.registry import SCENES

CONFIGURATIONS = 24


def statements():
    """(statement, its scene) of all papers, in order."""
    for path in sorted((ROOT / "data/papers").glob("*.toml")):
        paper = tomllib.loads(path.read_text())
        for statement in paper["statement"]:
            yield statement, statement.get("scene")


def configurations(scene, seed, count=CONFIGURATIONS):
    """So many figures of a scene, the same for the same seed."""
    rng = random.Random(f"{seed} {scene}")
    found, tries = [], 0
    while len(found) < count and tries < 400 * count:
        tries += 1
        try:
            found.append(SCENES[scene](rng))
        except (NoValue, ZeroDivisionError):
            continue
    return found


def outcomes(text, figures):
    """How often a formula holds, fails, and cannot be told."""
    counts = {True: 0, False: 0, None: 0}
    for symbols in figures:
        try:
            counts[evaluate(text, symbols)] += 1
        except (NoValue, ZeroDivisionError):
            counts[None] += 1
    return counts


def judged(text, figures):
    """`holds` if true wherever it can be told, `fails` or `holds-if` if false, else `open`."""
    counts = outcomes(text, figures)
    if counts[False]:
        return "holds-if" if counts[True] else "fails"
    return "holds" if counts[True] >= max(1, len(figures) // 3) else "open"


def replay(statement, figures):
    """None where the verdict of the data comes out, else what differs."""
    if "correct" in statement:
        verdict = judged(statement["correct"], figures)
        if verdict != "holds":
            return f"the correct form {verdict}"
    if "printed" in statement:
        if statement["expected"] == "holds-if":
            return under_condition(statement, figures)
        verdict = judged(statement["printed"], figures)
        expected = {"fails": ("fails", "holds-if"), "holds": ("holds",)}
        if verdict not in expected[statement["expected"]]:
            return f"the printed form {verdict}"
    return None


def under_condition(statement, figures):
    """True wherever the condition holds, and false somewhere else, if the scene goes beyond it."""
    within = figures
    if "condition" in statement and "outside" not in statement:
        within = [symbols for symbols in figures if evaluate(statement["condition"], symbols)]
        beyond = [symbols for symbols in figures if not evaluate(statement["condition"], symbols)]
        if not outcomes(statement["printed"], beyond)[False]:
            return "no counterexample beyond the condition"
    verdict = judged(statement["printed"], within)
    return None if verdict == "holds" else f"under its condition the printed form {verdict}"


def is_formula(statement):
    return statement["kind"] != "number" and "checks" not in statement


def run(report, expected, seed, known_only=False):
    """Judges all statements of one verdict; with known_only those of other scenes are left out."""
    figures = {}
    for statement, scene in statements():
        if statement["expected"] != expected or not is_formula(statement):
            continue
        if scene not in SCENES:
            if not known_only and "example" not in statement:
                report(statement["id"], "not replayed: no construction of the scene")
            continue
        if scene not in figures:
            figures[scene] = configurations(scene, seed)
        try:
            report(statement["id"], replay(statement, figures[scene]))
        except (Unknown, Unreadable) as error:
            report(statement["id"], f"not replayed: {error}")
