"""The printed output of 1964: linkage, three accuracies, the table of 47 rows; and the figures of that program."""

import re
import tomllib
from fractions import Fraction

from mpmath import mp, mpf

from .corpora import ROOT
from .geometry import Linkage
from .machine import arithmetic
from .program import Exact, Program
from .sisters import ball_burmester, burmester_points, evans

EMULATIONS = 100
NUMBER = re.compile(r"([+-]?)\s*(\d*)\.?(\d*)(?:,\s*(-?\.?\d+))?$")


def printed_number(text):
    """Value and unit of the last digit; a comma stands before a power of ten."""
    sign, whole, part, power = NUMBER.match(text.strip()).groups()
    scale = Fraction(10) ** int((power or "0").replace(".", ""))
    unit = scale / 10 ** len(part)
    size = int((whole + part) or 0) * unit
    return (-size if sign == "-" else size), unit


def as_mpf(q):
    return mpf(q.numerator) / q.denominator


def verdict(text, exact, bound):
    """By what the printed digits differ from the exact value of the program's steps."""
    value, unit = map(as_mpf, printed_number(text))
    if abs(value - exact) <= unit / 2:
        return "reproduced"
    if abs(value - exact) < unit and abs(value) <= abs(exact) and value * exact >= 0:
        return "truncated"
    # What is left of a value that was led astray is cut once more in print.
    return "noise" if bound and abs(value - exact) <= bound + unit else "contradicted"


class Results:
    """All that is printed of one linkage, by the program in exact arithmetic, and how far rounding can lead."""

    def __init__(self, alpha_a, alpha_b, rows, seed):
        self.exact = self.quantities(Program(Exact(), alpha_a, alpha_b), rows)
        self.bounds = {key: mpf(0) for key in self.exact}
        for k in range(EMULATIONS if seed is not None else 0):
            emulated = self.quantities(Program(arithmetic(f"{seed} {k}"), alpha_a, alpha_b), rows)
            for key, value in emulated.items():
                self.bounds[key] = max(self.bounds[key], abs(mpf(float(value)) - self.exact[key]))

    @staticmethod
    def quantities(program, rows):
        out = {("design", name): x for name, x in program.design().items()}
        for k, level in enumerate(program.levels(), 1):
            out |= {(f"level {k}", name): x for name, x in level.items()}
        for z in rows:
            out |= {(f"row {z}", name): x for name, x in program.table_row(z).items()}
        return out


def tesar():
    return tomllib.loads((ROOT / "data/papers/tesar1964.toml").read_text())


def cells(paper):
    """(id, key of the quantity, sign, printed, expected verdict) of the whole output."""
    for statement in paper["statement"]:
        if statement.get("example") == "representative":
            yield statement["id"], ("design", statement["quantity"]), 1, statement["printed"], statement["expected"]
    for table in paper["number_table"]:
        other = {cell: group["expected"] for group in table["other"] for cell in group["cells"]}
        for row in table["rows"]:
            (name, place), = row["given"].items()
            place = f"level {place}" if name == "level" else f"row {place}"
            for column, printed in zip(table["columns"], row["printed"]):
                cell = f"{row['row']}/{column['column']}"
                quantity = column["quantity"]
                yield f"{table['id']}/{cell}", (place, quantity.lstrip("-")), -1 if quantity[0] == "-" else 1, printed, other.get(cell, table["expected"])


def same_places(results, given):
    """The rows of the program against circles that meet; the largest difference of travel and deviation."""
    linkage = Linkage(given["alpha_a"], given["alpha_b"])
    worst = mpf(0)
    for places, sign in ((linkage.places(77), 1), (linkage.places(-153), -1)):
        for k, (u, v) in enumerate(places):
            key = f"row {sign * k}"
            if (key, "u") in results.exact:
                worst = max(worst, abs(abs(results.exact[key, "u"]) - abs(u)), abs(abs(results.exact[key, "v"]) - abs(v)))
    return worst


def figure(given):
    """The results under a figure of the program itself."""
    return summary(Program(Exact(), *(text.removesuffix(" deg") for text in (given["alpha_a"], given["alpha_b"]))))


def alternate(first, second):
    """Those of a linkage with two of the points A, B, C as pins."""

    def results(given):
        rays = [mpf(given[name].removesuffix(" deg")) * mp.pi / 180 for name in ("alpha_a", "alpha_b", "alpha_d")]
        points = ball_burmester(*rays)
        ray = mp.arg(points["C"]) * 180 / mp.pi % 180
        return summary(burmester_points(points[first], points[second], points["D"])) | {"alpha_c": ray}

    return results


def rolling(given):
    """Those of Evans's linkages."""
    omega = mpf(given["omega"].removesuffix(" deg")) * mp.pi / 180
    rho, k = (as_mpf(Fraction(given[name])) for name in ("rho", "k"))
    return summary(evans(omega, rho, k))


def summary(program):
    """Both sides of the design position together."""
    results = Results.quantities(program, [])
    out = {name: x for (place, name), x in results.items() if place == "design"}
    out["phi_0"] = out.pop("phi")
    for k, (p, q) in enumerate(program.levels_of_deviation, 1):
        level = {name: x for (place, name), x in results.items() if place == f"level {k}"}
        out |= {f"n_{k}": mpf(q) / p, f"L_{k}": level["length"], f"phi_{k}": level["phi_L"] - level["phi_R"]}
        out[f"psi_{k}"] = mp.nint(abs(level["psi_L"]) + abs(level["psi_R"]))
        out |= {f"gamma_{pin}{k}": min(level[f"gamma_{pin}L"], level[f"gamma_{pin}R"]) for pin in "ab"}
    return out


def run(report, seed):
    paper = tesar()
    given = paper["example"]["representative"]["given"]
    rows = [int(row["given"]["Z"]) for table in paper["number_table"] for row in table["rows"] if "Z" in row["given"]]
    results = Results(given["alpha_a"], given["alpha_b"], rows, seed)
    for name, key, sign, printed, expected in cells(paper):
        found = verdict(printed, sign * results.exact[key], results.bounds[key])
        report(name, None if found == expected else f"{found}, not {expected}: {printed} for {results.exact[key]}")
    report("tesar1964/output by circles that meet", None if same_places(results, given) < mpf(10) ** -30 else "other places")
