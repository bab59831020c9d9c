"""An answer of the command beside that of the second solver."""

from flint import arb, fmpq


class Disagreement(Exception):
    pass


def rational(text):
    """The exact value of an integer, fraction or decimal."""
    if "/" in text:
        p, q = text.split("/")
        return fmpq(int(p), int(q))
    mantissa, _, power = text.partition("e")
    whole, _, part = mantissa.partition(".")
    value = fmpq(int(whole + part), 10 ** len(part))
    power = int(power or 0)
    return value * 10**power if power >= 0 else value / fmpq(10) ** -power


class Enclosure:
    def __init__(self, number):
        self.exact = "exact" in number
        self.value = rational(number["exact"] if self.exact else number["value"])
        self.radius = fmpq(0) if self.exact else rational(number["radius"])

    def meets(self, ball):
        """Whether a ball of the second solver has a point in common with the enclosure."""
        return (abs(ball - arb(self.value)) - arb(self.radius)).lower() <= 0


def parts(pair, name):
    point = pair[name]
    if point is None:
        raise Disagreement("an answer without a point")
    numbers = []
    for coordinate in point:
        numbers.append([Enclosure(coordinate[key]) for key in ("re", "im")] if "re" in coordinate else [Enclosure(coordinate)])
    return numbers


def worst_radius(points, digits):
    """The largest radius as a part of what is allowed: 10^-digits of the value or of the point's largest coordinate."""
    worst = 0.0
    for numbers in points:
        flat = [number for coordinate in numbers for number in coordinate]
        largest = max(abs(number.value) + number.radius for number in flat)
        for number in flat:
            if number.radius != 0:
                ratio = number.radius * fmpq(10) ** digits / largest
                worst = max(worst, float(ratio.p) / float(ratio.q) if ratio < 10**6 else 1e6)
    return worst


def same(points, pair):
    """Whether enclosures of circlepoint and center hold a pair of the second solver."""
    flat = [coordinate for numbers in points for coordinate in numbers]
    for coordinate, value in zip(flat, pair.points):
        ball = [value.real, value.imag]
        for enclosure, part in zip(coordinate if len(coordinate) == 2 else coordinate[:1], ball):
            if not enclosure.meets(part):
                return False
    return True


def parallel(direction, x, y):
    """Whether enclosures of a direction hold that of (x, y), with the sign of the normal form."""
    a, b = (Enclosure(number) for number in direction)
    low = [arb(e.value, e.radius) for e in (a, b)]
    first = next(e.value for e in (a, b) if e.value != 0)
    return (low[0] * y.real - low[1] * x.real).contains(0) and first > 0


def matched(shown, pairs, what):
    left = list(pairs)
    for points, multiplicity in shown:
        fitting = [pair for pair in left if same(points, pair)]
        if len(fitting) != 1:
            raise Disagreement(f"{what}: {len(fitting)} of the other solver's pairs fit")
        if fitting[0].multiplicity != multiplicity:
            raise Disagreement(f"{what}: multiplicity {multiplicity}, not {fitting[0].multiplicity}")
        left.remove(fitting[0])
    if left:
        raise Disagreement(f"{what}: {len(left)} missing")


def compared(answer, pairs, eliminant, known, digits):
    """The worst radius; Disagreement where anything differs."""
    listed = {}
    for name in ("pairs", "complex_pairs"):
        listed[name] = [([parts(pair, "circlepoint"), parts(pair, "center")], pair["multiplicity"]) for pair in answer[name]]
    finite = [pair for pair in pairs if pair.kind == "finite"]
    matched(listed["pairs"], [pair for pair in finite if pair.real], "real pairs")
    matched(listed["complex_pairs"], [pair for pair in finite if not pair.real], "complex pairs")
    far = [pair for pair in pairs if pair.kind != "finite"]
    at_infinity(answer["at_infinity"], far)
    counts = {
        "real": sum(pair.multiplicity for pair in finite if pair.real),
        "complex": sum(pair.multiplicity for pair in finite if not pair.real),
        "at_infinity": sum(pair.multiplicity for pair in far),
    }
    if answer["counts"] != counts:
        raise Disagreement(f"counts {answer['counts']}, not {counts}")
    if answer["family"] is not None:
        raise Disagreement(f"a family: {answer['family']}")
    if eliminant is not None and answer["eliminant"] != [str(c) for c in eliminant]:
        raise Disagreement("another eliminant")
    for z, m in known:
        flat = [[arb(q) for q in (*z, *m)]]
        if not any(all(e[0].meets(q) for e, q in zip([c for numbers in points for c in numbers], flat[0])) for points, _ in listed["pairs"]):
            raise Disagreement("the pair that the positions were made from is missing")
    worst = [worst_radius(points, digits) for name in listed for points, _ in listed[name]]
    return max(worst, default=0.0)


def at_infinity(shown, pairs):
    left = list(pairs)
    expected = sum(pair.multiplicity for pair in pairs)
    if len(shown) != expected:
        raise Disagreement(f"{len(shown)} pairs at infinity, not {expected}")
    for one in shown:
        fitting = [pair for pair in left if pair.kind == one["kind"] and far_pair(one, pair)]
        if not fitting:
            raise Disagreement(f"at infinity: {one}")


def far_pair(one, pair):
    if one["kind"] == "isotropic":
        return True
    x, y, u, v = pair.points
    if one["kind"] == "center":
        finite, direction = (x, y), (u, v)
        name = "circlepoint"
    else:
        finite, direction = (u, v), (x, y)
        name = "center"
    there = all(Enclosure(e).meets(q.real) for e, q in zip(one[name], finite))
    return there and parallel(one["direction"], *direction)
