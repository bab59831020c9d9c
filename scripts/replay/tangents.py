"""Filemon's tables of 1973: which tangents there are for which order of the sides, from quadrilaterals drawn at random."""

import random
import tomllib
from collections import Counter

from mpmath import mpf

from .corpora import ROOT
from .evaluate import NoValue
from .scenes.filemon1973 import any_quadrilateral, balanced

EACH = 6
AROUND = ("r", "h", "R", "c")
WORDS = {">": "2rt", "=": "1dp", "<": "2is"}


def sign(x):
    return "=" if abs(x) < mpf(10) ** -30 else ">" if x > 0 else "<"


class Observed:
    """Order of the sides, U against Z, and the signs of f_1^2 - 4, f_2^2 - 4 for O1 and O2."""

    def __init__(self, q):
        sides = {"r": q.r, "h": q.h, "R": q.long, "c": q.c}
        self.order = tuple(sorted(AROUND, key=lambda name: sides[name]))
        ordered = [sides[name] for name in self.order]
        self.balance = sign(ordered[0] + ordered[3] - ordered[1] - ordered[2])
        self.part = f"{self.order[0]} shortest, {self.order[3]} longest"
        self.adjacent = (AROUND.index(self.order[0]) - AROUND.index(self.order[3])) % 2 == 1
        self.steep = q.h > q.long
        self.signs = {"O1": [sign(f * f - 4) for f in q.sums], "O2": [sign(f * f - 4) for f in q.beside().values()]}


def observed(seed):
    """So many of each order of the sides with c < h and r < R, and of U > Z, U = Z and U < Z."""
    rng = random.Random(f"{seed} tangents")
    count, found = Counter(), []
    while len(count) < 18 or min(count.values()) < EACH:
        try:
            one = Observed(balanced(rng) if rng.random() < 0.4 else any_quadrilateral(rng))
        except (NoValue, ZeroDivisionError):
            continue
        if count[one.order, one.balance] < EACH:
            count[one.order, one.balance] += 1
            found.append(one)
    return found


def cell(table, row, column, found):
    """What stands there by right."""
    balance, last = column.split("/")
    here = [one for one in found if one.balance == balance[1]]
    if table["code"] == "cases-of-tangents":
        first, second = row[2], row[5]
        here = [one for one in here if one.steep and one.adjacent == (last == "A")]
        return "+" if any(one.signs["O1"] == [first, second] for one in here) else "-"
    pair, wanted = int(row[1]) - 1, row[2]
    here = [one for one in here if one.part == table["part"]]
    return WORDS[wanted] if any(one.signs[last][pair] == wanted for one in here) else "(blank)"


def cells(seed):
    """(id, printed, by right, whether it is known to be wrong)."""
    found = observed(seed)
    paper = tomllib.loads((ROOT / "data/papers/filemon1973.toml").read_text())
    for table in paper["table"]:
        wrong = {name for group in table.get("wrong", []) for name in group["cells"]}
        for row in table["rows"]:
            for column, printed in zip(table["columns"], row["printed"]):
                name = f"{row['row']}/{column}"
                yield f"{table['id']}/{name}", printed, cell(table, row["row"], column, found), name in wrong


def run(report, seed):
    for name, printed, right, wrong in cells(seed):
        report(name, None if (printed != right) == wrong else f"{printed} printed, {right} by right")
