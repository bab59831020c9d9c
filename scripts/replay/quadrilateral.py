"""The quadrilaterals of opposite poles: shape, sides, the longest against the shortest."""

from flint import arb, fmpq

ORDERS = (("12", "23", "34", "14"), ("12", "24", "34", "13"), ("14", "24", "23", "13"))


def sign(number):
    if isinstance(number, arb):
        return 1 if number > 0 else -1 if number < 0 else 0
    return (number > 0) - (number < 0)


def shape(points):
    if any(p is None for p in points):
        return "degenerate"
    turns = []
    for k in range(4):
        (a, b), (c, d), (e, f) = (points[(k + m) % 4] for m in range(3))
        turns.append(sign((c - a) * (f - b) - (d - b) * (e - a)))
    if 0 in turns:
        return "degenerate"
    return {4: "convex", 2: "concave", 0: "crossed"}[abs(sum(turns))]


def squares(points):
    """Squared sides; None where a vertex is not finite."""
    out = []
    for p, q in zip(points, points[1:] + points[:1]):
        out.append(None if p is None or q is None else (p[0] - q[0]) ** 2 + (p[1] - q[1]) ** 2)
    return out


def comparison(squared):
    """U against Z, and whether the shortest and the longest side are neighbours."""
    if any(s is None for s in squared):
        return None, None
    exact = all(isinstance(s, fmpq) for s in squared)
    least, most = (pick(squared, better) for better in (lambda a, b: a < b, lambda a, b: a > b))
    same = (lambda a, b: a == b) if exact else (lambda a, b: a.overlaps(b))
    shortest = [k for k, s in enumerate(squared) if same(s, least)]
    longest = [k for k, s in enumerate(squared) if same(s, most)]
    ways = {"adjacent" if (i - j) % 2 else "opposite" for i in shortest for j in longest if i != j}
    sides = [arb(s).sqrt() for s in squared]
    difference = 2 * (arb(least).sqrt() + arb(most).sqrt()) - sum(sides, arb(0))
    relation = {1: ">", -1: "<", 0: "="}[sign(difference)]
    return relation, "both" if len(ways) == 2 else next(iter(ways))


def pick(numbers, better):
    best = numbers[0]
    for n in numbers[1:]:
        if better(n, best):
            best = n
    return best
