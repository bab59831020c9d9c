"""Focal mechanisms and Hart's straight-line mechanism: F on the bars MPF and NQF with angles that add up to a half turn.

With M in the origin, N at d and the bars along u and v, F = m u - p u w = d + n v + q v w. If A and B on the
bars at a = l m, b = l n keep the distance c in all positions, |p u + q v| = |m u - n v - d| and the closure of MABN
give, coefficient by coefficient of cos(u, v): p q = m n (l - 1) and
p^2 + q^2 = m^2 + n^2 + d^2 + (c^2 - a^2 - b^2 - d^2)/l."""

from flint import arb, ctx, fmpq

from outside.compare import Enclosure, rational

from .centerpoint import Differs, number_agrees
from .corpora import cases


def exact_agrees(answer, expected):
    for name, value in expected.items():
        number_agrees(Enclosure(answer[name]), value, fmpq(0), name)


def hart(problem, answer):
    """m p + n q = 0: no point of the base is equally far from F, and F stays on a line across it."""
    m, n, d, kappa = (rational(problem[name]) for name in ("m", "n", "d", "kappa"))
    p, q = kappa * n, -kappa * m
    ratio = 1 + p * q / (m * n)
    a, b = ratio * m, ratio * n
    square = d * d + a * a + b * b + ratio * (p * p + q * q - m * m - n * n - d * d)
    # |F|^2 - |F - d|^2 does not depend on the angle.
    x = (d * d + m * m + p * p - n * n - q * q) / (2 * d)
    expected = {"m": m, "n": n, "d": d, "p": p, "q": q, "a": a, "b": b, "x": x}
    exact_agrees(answer, expected)
    c = Enclosure(answer["c"])
    if not c.exact or c.value**2 != square or c.value < 0:
        raise Differs("c")
    first, second, third = (Enclosure(number).value for number in answer["line"])
    if second != 0 or first * x + third != 0 or first <= 0:
        raise Differs("the line")


def real_mechanisms(a, b, c, d, rho):
    """Each by its lengths; p = rho b k, q = a k with k^2 = (l - 1)/(rho l^2), l from a quadratic equation."""
    linear = c * c - a * a - b * b - d * d - (rho**2 * b * b + a * a) / rho
    constant = a * a + b * b + (rho**2 * b * b + a * a) / rho
    square = linear**2 - 4 * d * d * constant
    if square < 0:
        return []
    share = rho / (1 + rho)
    found = []
    for sign in (1, -1) if square != 0 else (1,):
        ratio = (-arb(linear) + sign * arb(square).sqrt()) / (2 * arb(d) ** 2)
        k2 = (ratio - 1) / (arb(rho) * ratio**2)
        if k2.contains(0):
            raise Differs("not replayed: a mechanism at the limit")
        if k2 < 0:
            continue
        k = k2.sqrt()
        m, n, p, q = arb(a) / ratio, arb(b) / ratio, arb(rho * b) * k, arb(a) * k

        def distance(first, second, base):
            """From F to the point that divides the base, by both squared distances of F."""
            whole = (1 - arb(share)) * (first**2 + p**2) + arb(share) * (second**2 + q**2) - arb(share * (1 - share)) * arb(base) ** 2
            return whole.sqrt()

        one = {"lambda": ratio, "m": m, "n": n, "p": p, "q": q, "MS": share * d, "AT": share * c}
        found.append(one | {"r": distance(m, n, d), "t": distance(a - m, b - n, c)})
    return sorted(found, key=lambda one: float(one["r"].mid()))


def focal(problem, answer):
    lengths = [rational(problem[name]) for name in ("a", "b", "c", "d", "rho")]
    expected = real_mechanisms(*lengths)
    if answer["count"] != len(expected) or len(answer["mechanisms"]) != len(expected):
        raise Differs(f"{answer['count']} mechanisms, not {len(expected)}")
    left = list(expected)
    for shown in answer["mechanisms"]:
        fitting = [one for one in left if Enclosure(shown["lambda"]).meets(one["lambda"])]
        if len(fitting) != 1:
            raise Differs("lambda")
        left.remove(fitting[0])
        one = dict(fitting[0])
        if (Enclosure(shown["p"]).value > 0) != (one["p"] > 0):
            # Both signs at once: the angle is a half turn more.
            one["p"], one["q"] = -one["p"], -one["q"]
        exact_agrees(shown, one)
    radii = [Enclosure(shown["r"]).value for shown in answer["mechanisms"]]
    if radii != sorted(radii):
        raise Differs("the order by the crank")


def replay(problem, answer):
    if "undecided" in answer:
        return "undecided"
    ctx.prec = 1000
    try:
        (hart if problem["problem"] == "hart" else focal)(problem, answer)
    except Differs as error:
        return str(error)
    return None


def run(report):
    for kind in ("focal-mechanism", "hart"):
        for problem, answer in cases(kind):
            report(problem["id"], replay(problem, answer))
