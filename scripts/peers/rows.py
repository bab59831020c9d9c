"""The rows of the table "Speed to reach" in DESIGN.md: problems, programs, what is checked, what is to be reached."""

from dataclasses import dataclass, field
from functools import partial

from . import agree, problems


@dataclass
class Peer:
    """A tool with a program for a task; `loose` where it certifies nothing and the others do."""

    tool: str
    module: str
    task: str
    loose: bool = False


@dataclass
class Target:
    """At most `share` of the time of the kernel or of a tool, or at most so many seconds."""

    against: str
    share: float

    def __str__(self):
        if self.against == "seconds":
            return f"at most {1e3 * self.share:g} ms"
        return f"at most {self.share:g} of {self.against}"


@dataclass
class Line:
    """A line of the table: one task of ours beside what does the same."""

    title: str
    task: str
    peers: list
    kernel: str | None
    targets: list = field(default_factory=list)


@dataclass
class Row:
    """What is run together. The reference is a peer's module with the row's name that it is asked by."""

    name: str
    make: object
    count: int
    kernel: str | None
    lines: list
    check: object
    loose_check: object = None
    reference: tuple = ()
    no_kernel: str = "none known"

    def programs(self):
        return sorted({peer.module for line in self.lines for peer in line.peers})


def five_certified(digits, targets):
    peers = [Peer("python-flint", "five_positions_flint", "pairs"), Peer("PARI, not certified", "five_positions_pari", "pairs", loose=True)]
    return Row(
        f"five-{digits}", problems.five_positions, 200, "five_positions_arb.c",
        [Line(f"five positions, full certificate, {digits} digits", "pairs", peers, "pairs", targets)],
        partial(agree.pairs, digits=digits), partial(agree.pairs, digits=digits, certified=False),
        ("five_positions_flint", f"five-{digits}"),
    )


def arithmetic(task):
    return Line(f"balls of 128 bits: {task}", task, [Peer("python-flint", "arithmetic_flint", task)], task)


KERNEL, FLINT, PARI = "the kernel", "python-flint", "PARI"
NEAR_KERNEL = Target(KERNEL, 1.2)

ROWS = [
    five_certified(70, [NEAR_KERNEL]),
    five_certified(100, [Target(FLINT, 0.4), NEAR_KERNEL]),
    five_certified(1000, [Target(FLINT, 0.5), NEAR_KERNEL]),
    Row(
        "five-f64", problems.five_positions, 400, "five_positions_f64.cpp",
        [
            Line("five positions, f64, many problems", "many", [Peer("numpy", "five_positions_numpy", "many")], "many", [NEAR_KERNEL]),
            Line("five positions, f64, one problem", "one", [Peer("numpy", "five_positions_numpy", "one")], "many"),
        ],
        agree.float_pairs, reference=("five_positions_flint", "five-30"),
    ),
    Row(
        "cubic", problems.four_positions, 200, None,
        [Line("ten cubic coefficients, exact", "coefficients", [Peer(PARI, "cubic_pari", "coefficients"), Peer(FLINT, "cubic_flint", "coefficients")],
              None, [Target(PARI, 0.5)])],
        agree.proportional, reference=("cubic_flint", "cubic"),
    ),
    Row(
        "curve-f64", problems.curves, 4, "curve_f64.cpp",
        [Line("centerpoint curve, 10 000 points, f64", "points", [Peer("numpy", "curve_numpy", "points")], "points", [Target("numpy", 1)])],
        agree.float_points, reference=("curve_flint", "curve-256"),
    ),
    Row(
        "curve-256", problems.curves, 4, "curve_arb.c",
        [Line("centerpoint curve, 10 000 points, 256 bits certified", "points", [Peer(FLINT, "curve_flint", "points")], "points", [Target(FLINT, 1)])],
        agree.points, reference=("curve_flint", "curve-256"),
    ),
    Row(
        "deviation-f64", problems.linkages, 20, "deviation_f64.cpp",
        [Line("deviation of one linkage, 360 points, f64", "places", [Peer("numpy", "deviation_numpy", "places")], "places", [Target(KERNEL, 1.1)])],
        agree.float_places, reference=("deviation_flint", "deviation-50"),
    ),
    Row(
        "deviation-50", problems.linkages, 20, "deviation_arb.c",
        [Line("deviation of one linkage, 360 points, 50 digits certified", "places", [Peer(FLINT, "deviation_flint", "places")], "places",
              [Target(KERNEL, 1.2)])],
        agree.places, reference=("deviation_flint", "deviation-50"),
    ),
    Row(
        "expansion", problems.nothing, 1, None,
        [Line("expanding (3.25) from (3.24), exact", "expansion", [Peer(PARI, "expansion_pari", "expansion"), Peer(FLINT, "expansion_flint", "expansion")],
              None, [Target("seconds", 1e-4)])],
        agree.polynomials, reference=("expansion_flint", "expansion"),
    ),
    Row(
        "arithmetic-128", problems.operands, 1000, "arithmetic_arb.c",
        [arithmetic(task) for task in ("add", "mul", "div", "sqrt", "sin+cos", "atan")],
        agree.balls, reference=("arithmetic_flint", "arithmetic-128"),
    ),
]
