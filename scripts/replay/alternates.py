"""Cranks that replace the slider of a slider-crank in one position: Burmester points B and C beside A and D."""

from mpmath import mp, mpc, mpf

from outside.compare import rational

from .burmester_points import quartic
from .corpora import cases
from .evaluate import Angle, NoValue


def quotient(a, b):
    if abs(b) < mpf(10) ** -40:
        raise NoValue("a division by zero")
    return a / b


def distance(a, b):
    """Infinite where only the denominator vanishes."""
    return mp.inf if abs(b) < mpf(10) ** -40 < abs(a) else quotient(a, b)


def alternates(k, ray_a, ray_d):
    """All distances and rays by name; B is the one with the smaller tangent."""
    sine, tan_a, tan_d = mp.sin(ray_a), mp.tan(ray_a), mp.tan(ray_d)
    pd, po_a, pa = mp.sin(ray_d), k * sine, distance(k * sine, k + 1)
    # m + n t = sin/r at A and at D.
    # sin/PA is (k + 1)/k.
    n = quotient(quotient(k + 1, k) - 1, tan_a - tan_d)
    m = 1 - n * tan_d
    coefficients = quartic(m, n, tan_a, tan_d)
    total = -quotient(coefficients[3], coefficients[4]) - tan_a - tan_d
    product = quotient(coefficients[0], coefficients[4] * tan_a * tan_d)
    square = total**2 - 4 * product
    root = mp.sqrt(mpc(square if abs(square) > mpf(10) ** -50 * (1 + total**2) else 0))
    tangents = [(total - root) / 2, (total + root) / 2]
    out = {"PD": pd, "PO_a": po_a, "PA": pa, "N": distance(1, n), "M": distance(1, m), "tangents": tangents}
    if abs(root.imag) > 0:
        return out
    for name, t in zip("bc", tangents):
        ray = mp.atan(t.real) % mp.pi
        out |= {f"alpha_{name}": Angle(ray), f"P{name.upper()}": distance(mp.sin(ray), m + n * t.real)}
        out[f"PO_{name}"] = distance(mp.sin(ray), m - 1 + n * t.real)
    return out


def degrees(angle):
    """Radians of an angle as problems write it."""
    (unit, text), *rest = angle.items()
    q = rational(text)
    x = mpf(int(q.p)) / int(q.q)
    if unit == "tan_half":
        return 2 * mp.atan(x)
    if unit == "cos":
        s = rational(angle["sin"])
        return mp.atan2(mpf(int(s.p)) / int(s.q), x)
    return x * mp.pi / 180 if unit == "degrees" else x


def meets(number, expected):
    """Whether an enclosure of 50 digits holds a number known to some 60."""
    if "infinite" in number or mp.isinf(expected):
        return "infinite" in number and mp.isinf(expected)
    exact = "exact" in number
    q = rational(number["exact"] if exact else number["value"])
    value = mpf(int(q.p)) / int(q.q)
    return abs(value - expected) <= mpf(10) ** -45 * max(abs(value), 1)


def replay(problem, answer):
    if "undecided" in answer or any(isinstance(v, dict) and "undetermined" in v for v in answer.values()):
        return "not replayed: an undetermined number"
    q = rational(problem["k"])
    try:
        found = alternates(mpf(int(q.p)) / int(q.q), degrees(problem["alpha_a"]), degrees(problem["alpha_d"]))
    except (NoValue, ZeroDivisionError):
        return "not replayed: a ray along tangent or normal"
    for name in ("PD", "PO_a", "PA", "N", "M"):
        if answer[name] is None or not meets(answer[name], found[name]):
            return f"another {name}"
    if answer["PB"] is None:
        first = sorted((mpc_of(answer[f"alpha_{x}"]) for x in "bc"), key=lambda z: z[2])
        mine = sorted(found["tangents"], key=lambda z: z.imag)
        if "alpha_b" in found or not all(meets(re, z.real) and meets(im, z.imag) for (re, im, _), z in zip(first, mine)):
            return "other complex rays"
        return None
    if "alpha_b" not in found:
        return "real rays where they are complex"
    for name in ("PB", "PC", "PO_b", "PO_c"):
        if not meets(answer[name], found[name]):
            return f"another {name}"
    for name in ("alpha_b", "alpha_c"):
        if not meets(answer[name]["degrees"], found[name].radians * 180 / mp.pi):
            return f"another {name}"
    return None


def mpc_of(pair):
    return pair["re"], pair["im"], float(rational(pair["im"].get("value", pair["im"].get("exact"))))


def run(report):
    for problem, answer in cases("slider-crank-alternates"):
        report(problem["id"], replay(problem, answer))
