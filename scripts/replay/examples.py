"""Worked examples with given parameters: their numbers and what is claimed of them."""

import tomllib

from mpmath import mp, mpf

from . import errata, table
from .alternates import alternates
from .corpora import ROOT
from .evaluate import Scope
from .formula import read


def chebyshev(given):
    """Equal rockers MA = NB in the open parallel position, F on the axis of symmetry and PF across MA.

    AB keeps its length where p q = m n (lambda - 1), here p^2 = m a - m^2: then MF^2 = MF . MA."""
    a, c, d = (mpf(given[name]) for name in "acd")
    h1, h2 = mp.sqrt(a**2 - ((d - c) / 2) ** 2), mp.sqrt(a**2 - ((d + c) / 2) ** 2)
    pin = mp.mpc((d - c) / 2, h1)
    # F = (d/2, y): y^2 - h1 y + d^2/4 - d (d - c)/4 = 0.
    root = mp.sqrt(h1**2 - 4 * (d**2 / 4 - d * (d - c) / 4))
    y = min((h1 - root) / 2, (h1 + root) / 2, key=abs)
    f = mp.mpc(d / 2, y)
    m = (mp.conj(f) * pin).real / a
    return {"h_1": h1, "h_2": h2, "m": m, "p": mp.sqrt(abs(f) ** 2 - m**2), "r": abs(y), "a": a, "c": c, "d": d}


def slider_crank(given):
    angles = [mpf(given[name].removesuffix(" deg")) * mp.pi / 180 for name in ("alpha_a", "alpha_d")]
    out = alternates(mpf(given["k"]), *angles)
    return out | {name: out[name].radians * 180 / mp.pi for name in ("alpha_b", "alpha_c")}


FIGURES = {
    ("wunderlich1968", "chebyshev"): chebyshev,
    ("tesar1964", "slider-crank"): slider_crank,
    ("tesar1964", "figure-37"): table.figure,
    ("tesar1964", "figure-39"): table.alternate("A", "B"),
    ("tesar1964", "figure-41"): table.alternate("B", "C"),
    ("tesar1964", "figure-65"): table.rolling,
    ("tesar1964", "figure-67"): table.rolling,
    ("tesar1964", "figure-69"): table.rolling,
    ("tesar1964", "figure-72"): table.figure,
}


def run(report, errata_only=False):
    for (key, name), make in FIGURES.items():
        paper = tomllib.loads((ROOT / f"data/papers/{key}.toml").read_text())
        symbols = make(paper["example"][name]["given"])
        for statement in paper["statement"]:
            if statement.get("example") != name or (errata_only and not is_erratum(statement)):
                continue
            if statement["kind"] == "number":
                if not errata_only:
                    report(statement["id"], number(statement, symbols))
            elif "checks" not in statement:
                if errata_only == is_erratum(statement):
                    report(statement["id"], claim(statement, symbols))


def is_erratum(statement):
    return statement["expected"] == "fails"


def claim(statement, symbols):
    """A formula, or an expression for one quantity."""
    if "quantity" in statement:
        quantity = statement["quantity"]
        statement = statement | {k: f"{quantity} = {statement[k]}" for k in ("printed", "correct") if k in statement}
    return errata.replay(statement, [symbols])


def number(statement, symbols):
    quantity = statement["quantity"]
    if quantity not in symbols:
        return f"not replayed: the quantity {quantity}"
    printed, expected = statement["printed"].removesuffix(" deg"), statement["expected"]
    if expected in ("not-reproducible", "consistent", "noise"):
        # The arithmetic of the machine is emulated for its own linkage only.
        return f"not replayed: {expected}"
    try:
        found = table.verdict(printed, symbols[quantity], mpf(0))
    except AttributeError:
        # An expression means equality.
        (tree,), _, _ = read(printed)
        found = "reproduced" if abs(Scope({}).value(tree) - symbols[quantity]) < mpf(10) ** -40 else "contradicted"
    return None if found == expected else f"{found}, not {expected}: {printed} for {symbols[quantity]}"
