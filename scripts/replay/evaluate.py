"""What a formula says of numbers, with some seventy decimal digits: true, false or not to be told."""

import itertools

from mpmath import mp, mpc, mpf, pi

from .formula import read

mp.dps = 70
EQUAL, DIFFERENT = mpf(10) ** -40, mpf(10) ** -20


class NoValue(Exception):
    """A division by zero, or the root of a negative number."""


class Unknown(Exception):
    """A symbol that the scene does not have, or what does not go together."""


class Angle:
    """An angle in radians, any of those that differ by full turns, or by half turns for that of a line."""

    def __init__(self, radians, period=2 * pi):
        self.radians, self.period = mpf(radians), +period


class Line(tuple):
    """A, B, C of A x + B y + C = 0."""


class Many(list):
    """A set."""


def near(a, b):
    """Whether two numbers are equal; None where that cannot be told."""
    difference, size = abs(a - b), max(abs(a), abs(b), 1)
    return True if difference < EQUAL * size else False if difference > DIFFERENT * size else None


def both(values):
    values = list(values)
    return False if False in values else None if None in values else True


def either(values):
    values = list(values)
    return True if True in values else None if None in values else False


def contrary(truth):
    return None if truth is None else not truth


def same_angle(a, b, period=None):
    period = period or min(a.period, b.period)
    turns = (a.radians - b.radians) / period
    rest = turns - mp.nint(turns)
    return near(rest * period, 0)


def same(a, b):
    if isinstance(a, Many) or isinstance(b, Many):
        a, b = (x if isinstance(x, Many) else [x] for x in (a, b))
        return both(either(same(x, y) for y in q) for p, q in ((a, b), (b, a)) for x in p)
    if isinstance(a, Line) and isinstance(b, Line):
        return proportional(a, b)
    if isinstance(a, list) and isinstance(b, list):
        return len(a) == len(b) and both(same(x, y) for x, y in zip(a, b))
    if isinstance(a, Angle) or isinstance(b, Angle):
        a, b = (x if isinstance(x, Angle) else Angle(0) if near(x, 0) else None for x in (a, b))
        if a is None or b is None:
            raise Unknown("a number against an angle")
        return same_angle(a, b)
    return near(a, b)


def proportional(a, b):
    if len(a) != len(b):
        raise Unknown("lists of different length")
    size_a, size_b = (max(abs(x) for x in list_) or 1 for list_ in (a, b))
    a, b = [x / size_a for x in a], [x / size_b for x in b]
    return both(near(a[i] * b[j], a[j] * b[i]) for i, j in itertools.combinations(range(len(a)), 2))


def number(x):
    if isinstance(x, mpc):
        if near(x.imag, 0):
            return x.real
        raise Unknown("a complex number where a real one was expected")
    if isinstance(x, (Angle, list)):
        raise Unknown(f"{type(x).__name__} where a number was expected")
    return x


def angle(x):
    if isinstance(x, Angle):
        return x.radians
    raise Unknown("a number where an angle was expected")


def root(x):
    x = number(x)
    if x < 0:
        if near(x, 0):
            return mpf(0)
        raise NoValue("a root of a negative number")
    return mp.sqrt(x)


def inverse(function, x):
    x = number(x)
    if abs(x) > 1:
        raise NoValue("no real angle")
    return Angle(function(x))


def line(p, q):
    p, q = mpc(p), mpc(q)
    return Line((p.imag - q.imag, q.real - p.real, p.real * q.imag - q.real * p.imag))


def meet(l, m):
    w = l[0] * m[1] - l[1] * m[0]
    return mpc(quotient(l[1] * m[2] - l[2] * m[1], w), quotient(l[2] * m[0] - l[0] * m[2], w))


def quotient(a, b):
    if near(b, 0):
        raise NoValue("a division by zero")
    return a / b


def determinant(rows):
    return mp.det(mp.matrix(rows))


def norm(l):
    return mp.sqrt(l[0] ** 2 + l[1] ** 2)


def concyclic(*points):
    p, *rest = map(mpc, points)
    size = max(abs(z - p) for z in rest)
    rest = [(z - p) / size for z in rest]
    rows = [[abs(z) ** 2, z.real, z.imag] for z in rest]
    return both(near(determinant([rows[0], rows[1], row]), 0) for row in rows[2:])


def collinear(p, q, *rest):
    size = max(abs(mpc(q) - p), *(abs(mpc(r) - p) for r in rest))
    return both(near((mpc(q - p) / size * mp.conj(mpc(r - p) / size)).imag, 0) for r in rest)


def similar(a, b):
    base, image = a[1] - a[0], b[1] - b[0]
    return both(near((p - a[0]) / base, (q - b[0]) / image) for p, q in zip(a[2:], b[2:]))


def extreme(best):
    return lambda *x: best(number(v) for v in (x[0] if isinstance(x[0], list) else x))


FUNCTIONS = {
    "sin": lambda x: mp.sin(angle(x)), "cos": lambda x: mp.cos(angle(x)),
    "tan": lambda x: quotient(mp.sin(angle(x)), mp.cos(angle(x))),
    "cot": lambda x: quotient(mp.cos(angle(x)), mp.sin(angle(x))),
    "arcsin": lambda x: inverse(mp.asin, x), "arccos": lambda x: inverse(mp.acos, x),
    "arctan": lambda x: Angle(mp.atan(number(x))), "cis": lambda x: mp.expj(angle(x)),
    "sqrt": root, "abs": abs, "sign": lambda x: mpf(0) if near(number(x), 0) else mp.sign(number(x)),
    "min": extreme(min), "max": extreme(max),
    "re": lambda z: mpc(z).real, "im": lambda z: mpc(z).imag, "conj": lambda z: mp.conj(mpc(z)),
    "arg": lambda z: Angle(mp.arg(z)), "angle": lambda a, b, c: Angle(mp.arg(mpc(c - b) / mpc(a - b))),
    "dist": lambda p, q: abs(p - q), "line": line, "meet": meet, "det": determinant,
}
FUNCTIONS |= {"tg": FUNCTIONS["tan"], "ctg": FUNCTIONS["cot"], "sgn": FUNCTIONS["sign"]}
PREDICATES = {
    "collinear": collinear, "concyclic": concyclic, "similar": similar,
    "perpendicular": lambda l, m: near((l[0] * m[0] + l[1] * m[1]) / norm(l) / norm(m), 0),
    "parallel": lambda l, m: near((l[0] * m[1] - l[1] * m[0]) / norm(l) / norm(m), 0),
}
DIRECT = {"arcsin": mp.sin, "arccos": mp.cos, "arctan": mp.tan}


OPERATORS = set("+-*/±∓")


class Scope:
    def __init__(self, symbols):
        self.symbols = dict(symbols)
        self.running = []
        self.plus = None
        self.alike = None

    def claim(self, tree):
        head = tree[0]
        if head == "group":
            return self.claim(tree[1])
        if head == "not":
            return contrary(self.claim(tree[1]))
        if head in ("and", "or", "if", "iff"):
            p, q = self.claim(tree[1]), self.claim(tree[2])
            if head == "and":
                return both((p, q))
            if head == "or":
                return either((p, q))
            if head == "if":
                return either((p, contrary(q)))
            return None if p is None or q is None else p == q
        if head == "for":
            return both(self.each(tree[2], tree[3], lambda: self.claim(tree[1])))
        if head == "call" and tree[1] in PREDICATES:
            return PREDICATES[tree[1]](*map(self.value, tree[2]))
        if head == "chain":
            return self.chain(tree)
        raise Unknown(f"{head} is no claim")

    def in_all_senses(self, tree):
        """A whole claim with ≷ is three claims, in each of which it has one sense throughout."""
        if not contains(tree, "≷", "≶"):
            return self.claim(tree)
        truths = []
        for self.alike in "><=":
            truths.append(self.claim(tree))
        self.alike = None
        return both(truths)

    def each(self, name, values, part):
        members = self.value(values)
        labels = None
        if all(member[0] == "number" and member[1].denominator == 1 for member in values[1]):
            labels = [str(member[1]) for member in values[1]]
        out = []
        for place, member in enumerate(members):
            before = self.symbols.get(name)
            self.symbols[name] = member
            self.running.append((name, labels, place))
            out.append(part())
            self.running.pop()
            self.symbols[name] = before
        return out

    def chain(self, tree):
        _, left, rest, modulus = tree
        truths = []
        for relation, right in rest:
            truths.append(self.related(relation, left, right, modulus))
            left = right
        return both(truths)

    def related(self, relation, left, right, modulus):
        if relation == "≡":
            a, b = (x if isinstance(x, Angle) else Angle(0) if near(x, 0) else None for x in map(self.value, (left, right)))
            return same_angle(a, b, angle(self.value(modulus)))
        if relation in "=≠":
            truth = self.equal(left, right)
            return truth if relation == "=" else contrary(truth)
        if relation == "~":
            return proportional(self.value(left), self.value(right))
        a, b = number(self.value(left)), number(self.value(right))
        equal = near(a, b)
        if equal is None:
            return None
        if relation in "≷≶":
            relation = self.alike if relation == "≷" else {">": "<", "<": ">", "=": "="}[self.alike]
            if relation == "=":
                return equal
        return {"<": not equal and a < b, "≤": equal or a < b, ">": not equal and a > b, "≥": equal or a > b}[relation]

    def equal(self, left, right):
        if left[0] == right[0] == "ratio":
            return proportional([self.value(x) for x in left[1]], [self.value(x) for x in right[1]])
        for one, other in ((right, left), (left, right)):
            # An angle equals an inverse function where its function has that value.
            if one[0] == "call" and one[1] in DIRECT:
                return same(DIRECT[one[1]](angle(self.value(other))), self.side(one[2][0]))
        return same(self.side(left), self.side(right))

    def side(self, tree):
        if not contains(tree, "±", "∓"):
            return self.value(tree)
        out = Many()
        for self.plus in (True, False):
            out.append(self.value(tree))
        self.plus = None
        return out

    def value(self, tree):
        head = tree[0]
        if head == "group":
            return self.value(tree[1])
        if head == "number":
            return mpf(tree[1].numerator) / tree[1].denominator
        if head == "pi":
            return Angle(pi)
        if head == "i":
            return mpc(0, 1)
        if head == "name":
            name = self.resolved(tree[1])
            if name not in self.symbols:
                raise Unknown(f"the symbol {name}")
            return self.symbols[name]
        if head == "negative":
            x = self.value(tree[1])
            return Angle(-x.radians, x.period) if isinstance(x, Angle) else -x
        if head == "deg":
            return Angle(self.value(tree[1]) * pi / 180)
        if head == "call":
            if tree[1] not in FUNCTIONS:
                raise Unknown(f"{tree[1]} is a claim")
            return FUNCTIONS[tree[1]](*map(self.value, tree[2]))
        if head == "list":
            return [self.value(x) for x in tree[1]]
        if head == "set":
            return Many(self.value(x) for x in tree[1])
        if head == "sum":
            terms = self.each(tree[2], tree[3], lambda: self.value(tree[1]))
            total = mpf(0)
            for term in terms:
                total += term
            return total
        if head == "^":
            return self.power(tree)
        if head not in OPERATORS:
            raise Unknown(f"{head} is no value")
        return self.binary(*tree)

    def power(self, tree):
        base, exponent = self.value(tree[1]), self.value(tree[2])
        twice = 2 * exponent
        if not near(twice, mp.nint(twice)):
            raise Unknown("an exponent that is no half of an integer")
        n = int(mp.nint(twice))
        if n < 0 and near(base, 0):
            raise NoValue("a division by zero")
        return base ** (n // 2) if n % 2 == 0 else root(base) ** n

    def binary(self, operator, left, right):
        if operator in "±∓":
            if self.plus is None:
                raise Unknown("± in the midst of a claim")
            operator = "+" if (operator == "±") == self.plus else "-"
        a, b = self.value(left), self.value(right)
        angles = isinstance(a, Angle) + isinstance(b, Angle)
        if angles == 2 and operator in "+-":
            return Angle(a.radians + b.radians if operator == "+" else a.radians - b.radians, min(a.period, b.period))
        if angles == 1 and operator in "*/":
            if isinstance(a, Angle):
                return Angle(a.radians * number(b) if operator == "*" else a.radians / number(b))
            if operator == "*":
                return Angle(number(a) * b.radians)
        if angles or isinstance(a, list) or isinstance(b, list):
            raise Unknown(f"{operator} between these")
        if operator == "+":
            return a + b
        if operator == "-":
            return a - b
        return a * b if operator == "*" else quotient(a, b)

    def resolved(self, name):
        """The name with the values of the names that run through an index."""
        if not self.running or "_" not in name:
            return name
        primes = len(name) - len(name.rstrip("'"))
        stem, index = name.rstrip("'").split("_", 1)
        parts = [self.label(part) for part in index.strip("{}").split(",")]
        index = ",".join(parts)
        return stem + (f"_{index}" if index.isalnum() else "_{" + index + "}") + "'" * primes

    def label(self, part):
        for name, labels, place in reversed(self.running):
            offset = part[len(name):]
            if part.startswith(name) and (offset == "" or offset[0] in "+-") and labels:
                return labels[(place + int(offset or 0)) % len(labels)]
        return part


def contains(tree, *heads):
    """Whether one of these operators or relations stands somewhere in a tree."""
    if isinstance(tree, (tuple, list)):
        return any(part in heads if isinstance(part, str) else contains(part, *heads) for part in tree)
    return False


def evaluate(text, symbols):
    """Whether all claims hold; None where that cannot be told, or where an assumption does not hold."""
    claims, definitions, assumptions = read(text)
    scope = Scope(symbols)
    for name, tree in definitions:
        scope.symbols[name] = scope.value(tree)
    if assumptions and both(scope.claim(a) for a in assumptions) is not True:
        return None
    return both([scope.in_all_senses(c) for c in claims])
