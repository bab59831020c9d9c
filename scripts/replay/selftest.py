"""Wrong data that every part has to notice."""

import copy
import random
import re
import sys

from . import (alternates, centerpoint, curvature, errata, examples, five_positions, focal, mixed, table, tangents,
               three_positions)
from .corpora import cases
from .evaluate import NoValue, Unknown
from .formula import Unreadable
from .scenes.registry import SCENES

SIGN = re.compile(r" ([+-]) ")
SAMPLE = 60
OTHERS = {
    "poles": three_positions.replay,
    "three-positions": three_positions.replay,
    "mixed-positions": mixed.replay,
    "curvature": curvature.replay,
    "focal-mechanism": focal.replay,
    "hart": focal.replay,
}


def bumped(number):
    """Another digit in the twentieth place, or another exact number."""
    if isinstance(number, str):
        return str(int(number) + 1)
    if "exact" in number:
        p, _, q = number["exact"].partition("/")
        return {"exact": str(int(p) + 1) + (f"/{q}" if q else "")}
    text = number["value"]
    place = [k for k, c in enumerate(text.partition("e")[0]) if c.isdigit()][min(20, sum(c.isdigit() for c in text) - 1)]
    return number | {"value": text[:place] + str((int(text[place]) + 1) % 10) + text[place + 1 :]}


def damaged_pairs(answer):
    """Damages of an answer for five positions, with their names."""

    def copied():
        return copy.deepcopy(answer)

    if answer["pairs"]:
        for name in ("circlepoint", "center"):
            one = copied()
            one["pairs"][0][name][0] = bumped(one["pairs"][0][name][0])
            yield f"a digit of a {name}", one
        one = copied()
        del one["pairs"][0]
        yield "a pair lost", one
        one = copied()
        one["pairs"][0]["multiplicity"] += 1
        yield "a multiplicity", one
        one = copied()
        one["pairs"].append(one["pairs"][0])
        yield "a pair twice", one
    if answer["complex_pairs"]:
        one = copied()
        one["complex_pairs"][0]["circlepoint"][0]["im"] = bumped(one["complex_pairs"][0]["circlepoint"][0]["im"])
        yield "a digit of a complex pair", one
        one = copied()
        del one["complex_pairs"][-1]
        yield "a complex pair lost", one
    if answer["at_infinity"]:
        one = copied()
        del one["at_infinity"][0]
        yield "a pair at infinity lost", one
        if "direction" in answer["at_infinity"][0]:
            one = copied()
            one["at_infinity"][0]["direction"][0] = bumped(one["at_infinity"][0]["direction"][0])
            yield "a direction", one
    if answer["eliminant"]:
        for place in (0, len(answer["eliminant"]) // 2, -1):
            one = copied()
            one["eliminant"][place] = bumped(one["eliminant"][place])
            yield "a coefficient of the eliminant", one
    if answer["family"]:
        one = copied()
        one["family"] = None
        yield "a family lost", one
        if "coefficients" in answer["family"]:
            one = copied()
            one["family"]["coefficients"][1] = bumped(one["family"]["coefficients"][1])
            yield "a coefficient of a family", one
    elif answer["eliminant"] is not None:
        one = copied()
        one["family"] = {"kind": "plane"}
        yield "a family invented", one


def damaged_curves(answer):
    for curve in ("centerpoint", "circlepoint"):
        for part in ("coefficients", "asymptote", "midline"):
            if answer[curve][part] and any(c != "0" for c in answer[curve][part]):
                one = copy.deepcopy(answer)
                one[curve][part][-1] = bumped(one[curve][part][-1])
                yield f"{part} of the {curve} curve", one
        one = copy.deepcopy(answer)
        one[curve]["type"] = "one-branch" if one[curve]["type"] != "one-branch" else "two-branches"
        yield f"type of the {curve} curve", one
        if answer[curve]["focus"]:
            one = copy.deepcopy(answer)
            one[curve]["focus"][0] = bumped(one[curve]["focus"][0])
            yield f"focus of the {curve} curve", one
        one = copy.deepcopy(answer)
        if answer[curve]["nodes"]:
            del one[curve]["nodes"][0]
        else:
            one[curve]["nodes"].append([{"exact": "0"}, {"exact": "0"}])
        yield f"double points of the {curve} curve", one
    for block in ("poles", "image_poles"):
        if isinstance(answer[block]["13"], list):
            one = copy.deepcopy(answer)
            one[block]["13"][1] = bumped(one[block]["13"][1])
            yield f"one of the {block}", one
    for key, words in (("shape", ("convex", "crossed")), ("u_vs_z", ("<", ">"))):
        one = copy.deepcopy(answer)
        one["quadrilaterals"][0][key] = words[one["quadrilaterals"][0][key] == words[0]]
        yield f"{key} of a quadrilateral", one


def damaged_alternates(answer):
    for name in ("PD", "PA", "N", "PB", "PO_c"):
        if answer[name] and ("value" in answer[name] or "exact" in answer[name]):
            one = copy.deepcopy(answer)
            one[name] = bumped(one[name])
            yield name, one


def damaged_numbers(answer):
    """Every number of an answer, wherever it stands, one at a time, but not words and estimates."""
    for path in numbers(answer):
        if path[0] in ("digits", "certificate", "linkages", "fitted_angles", "ball_point", "polodes", "invariants", "R"):
            continue
        if path[-1] in ("sensitivity", "condition", "to_double"):
            continue
        one = copy.deepcopy(answer)
        place = one
        for step in path[:-1]:
            place = place[step]
        place[path[-1]] = bumped(place[path[-1]])
        yield "/".join(map(str, path)), one


def numbers(tree, path=()):
    """The places of all enclosures and integers."""
    if isinstance(tree, dict) and ("exact" in tree or "value" in tree):
        yield path
    elif isinstance(tree, dict):
        for key, part in tree.items():
            if key not in ("id", "problem"):
                yield from numbers(part, (*path, key))
    elif isinstance(tree, list):
        for k, part in enumerate(tree):
            if isinstance(part, str) and part.lstrip("-").isdigit():
                yield (*path, k)
            else:
                yield from numbers(part, (*path, k))


class Tally:
    def __init__(self):
        self.planted, self.missed = 0, []

    def __call__(self, noticed, name):
        self.planted += 1
        if not noticed:
            self.missed.append(name)


def answers(kind, replay, damaged, rng, tally):
    """Damages answers that agree: some of every corpus and all degenerate ones."""
    listed = list(cases(kind))
    plain = [c for c in listed if "degenerate" not in c[0]["id"] or c[0]["id"].startswith("near")]
    chosen = rng.sample(plain, min(SAMPLE, len(plain))) + [c for c in listed if c[0]["id"].startswith("degenerate")]
    for problem, answer in chosen:
        if replay(problem, answer) is None:
            for what, one in damaged(answer):
                tally(replay(problem, one) not in (None, "undecided"), f"{problem['id']}: {what}")


def wrong_formulas(seed, tally, kept):
    """Every sign of every right formula turned round, one at a time; few of them change nothing.

    Each statement must have a change that is noticed."""
    figures = {}
    for statement, scene in errata.statements():
        text = statement.get("correct", statement.get("printed"))
        if scene not in SCENES or not errata.is_formula(statement) or statement["expected"] == "holds-if":
            continue
        if scene not in figures:
            figures[scene] = errata.configurations(scene, seed)
        noticed, changes = 0, 0
        for found in SIGN.finditer(text):
            changed = text[: found.start()] + (" - " if found[1] == "+" else " + ") + text[found.end() :]
            try:
                verdict = errata.judged(changed, figures[scene])
            except (NoValue, Unknown, Unreadable, ZeroDivisionError):
                continue
            changes += 1
            noticed += verdict != "holds"
            kept(verdict != "holds", f"{statement['id']}: {changed}")
        if changes:
            tally(noticed, statement["id"])
        if statement["expected"] == "fails" and "printed" in statement:
            # What is printed wrongly must not pass for right.
            exchanged = {k: v for k, v in statement.items() if k != "correct"} | {"expected": "holds"}
            tally(errata.replay(exchanged, figures[scene]), f"{statement['id']}: taken for right")


def wrong_digits(seed, tally):
    """One printed digit changed in every cell: its verdict must change where the digit is above the noise."""
    paper = table.tesar()
    given = paper["example"]["representative"]["given"]
    rows = [int(row["given"]["Z"]) for block in paper["number_table"] for row in block["rows"] if "Z" in row["given"]]
    results = table.Results(given["alpha_a"], given["alpha_b"], rows, seed)
    for name, key, sign, printed, expected in table.cells(paper):
        if expected == "contradicted":
            continue
        for place in [k for k, c in enumerate(printed.partition(",")[0]) if c.isdigit()]:
            changed = other_digit(printed, place)
            value, unit = table.printed_number(changed)
            step = abs(table.as_mpf(value - table.printed_number(printed)[0]))
            if step > 2 * results.bounds[key] + 3 * table.as_mpf(unit):
                tally(table.verdict(changed, sign * results.exact[key], results.bounds[key]) == "contradicted", f"{name}: {changed}")


def other_digit(text, place):
    return text[:place] + str((int(text[place]) + 5) % 10) + text[place + 1 :]


def wrong_examples(tally):
    """The first digit of every number of an example changed."""

    def changed(statement, symbols):
        verdict = plain(statement, symbols)
        printed = statement["printed"]
        places = [k for k, c in enumerate(printed) if c.isdigit()]
        if verdict is None and statement["expected"] != "contradicted" and "sqrt" not in printed:
            found = plain(statement | {"printed": other_digit(printed, places[0])}, symbols)
            tally(found and not found.startswith("not replayed"), f"{statement['id']}: {printed}")
        return verdict

    plain, examples.number = examples.number, changed
    try:
        examples.run(lambda name, verdict: None)
    finally:
        examples.number = plain


def wrong_cells(seed, tally):
    """In every right cell another word, in every wrong one the right word."""

    def report(name, verdict):
        tally(verdict, name)

    for name, printed, right, wrong in tangents.cells(seed):
        other = right if wrong else {"+": "-", "-": "+"}.get(printed, "2rt" if printed != "2rt" else "2is")
        report(name, None if (other != right) == wrong else "noticed")


def main(seed):
    rng = random.Random(seed)
    tallies = {name: Tally() for name in ("five positions", "curves of four positions", "alternates", "other answers", "formulas", "signs of formulas", "tables of 1973", "printed digits", "numbers of examples")}
    answers("five-positions", five_positions.replay, damaged_pairs, rng, tallies["five positions"])
    answers("centerpoint-curve", centerpoint.replay, damaged_curves, rng, tallies["curves of four positions"])
    for kind, replay in OTHERS.items():
        answers(kind, replay, damaged_numbers, rng, tallies["other answers"])
    answers("slider-crank-alternates", alternates.replay, damaged_alternates, rng, tallies["alternates"])
    wrong_formulas(seed, tallies["formulas"], tallies["signs of formulas"])
    wrong_cells(seed, tallies["tables of 1973"])
    wrong_digits(seed, tallies["printed digits"])
    wrong_examples(tallies["numbers of examples"])
    print("| planted in | wrong data | noticed |\n| --- | ---: | ---: |")
    for name, tally in tallies.items():
        print(f"| {name} | {tally.planted} | {tally.planted - len(tally.missed)} |")
    failed = False
    for name, tally in tallies.items():
        # A sign before what vanishes, or inside a square, changes nothing; all else has to be noticed.
        enough = len(tally.missed) <= (tally.planted // 10 if name == "signs of formulas" else 0)
        failed |= not enough or not tally.planted
        for what in tally.missed:
            print(f"not noticed: {name}: {what}", file=sys.stderr)
    return int(failed)
