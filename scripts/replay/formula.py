"""A reader of the language of formulas (src/formula/grammar.md), written from its description.

A tree is a tuple: ("number", Fraction), ("name", text), ("pi",), ("i",), ("negative", x), ("+", x, y) and
so on for - * / juxt ^ ± ∓, ("deg", x), ("call", name, [x…]), ("list", […]), ("set", […]), ("sum", body,
name, values), ("ratio", […]), ("chain", first, [(relation, x)…], modulus), ("not", p), ("and"|"or"|"if"|
"iff", p, q), ("for", body, name, values).
"""

import re
from fractions import Fraction

GREEK = dict(zip("αβγδεζηθικλμνξοπρστυφχψω", "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho sigma tau upsilon phi chi psi omega".split()))
GREEK |= dict(zip("ΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩ", "Alpha Beta Gamma Delta Epsilon Zeta Eta Theta Iota Kappa Lambda Mu Nu Xi Omicron Pi Rho Sigma Tau Upsilon Phi Chi Psi Omega".split()))
FUNCTIONS = {
    "sin": 1, "cos": 1, "tan": 1, "tg": 1, "cot": 1, "ctg": 1, "arcsin": 1, "arccos": 1, "arctan": 1, "cis": 1,
    "sqrt": 1, "abs": 1, "sign": 1, "sgn": 1, "min": -1, "max": -1, "re": 1, "im": 1, "conj": 1, "arg": 1,
    "angle": 3, "dist": 2, "line": 2, "meet": 2, "collinear": -1, "concyclic": -1, "perpendicular": 2,
    "parallel": 2, "similar": 2, "det": 1,
}
TRIGONOMETRIC = {"sin", "cos", "tan", "tg", "cot", "ctg"}
KEYWORDS = {"for", "in", "iff", "if", "or", "and", "not", "mod", "where", "assume", "deg"}
SIGNS = {"==": "≡", "!=": "≠", "<=": "≤", ">=": "≥", "><": "≷", "<>": "≶", "+-": "±", "-+": "∓", "−": "-", "·": "*",
         "×": "*", "°": "deg", "⋅": "*"}
RELATIONS = set("=≠<≤>≥≷≶≡~")
WORD = re.compile(
    r"\s*(?:(?P<number>\d+(?:\.\d+)?(?:[eE][+-]?\d+)?)"
    r"|(?P<stem>[A-Za-z]+|[α-ωΑ-Ω])(?P<bar>[\u0304\u0305])?(?:_(?:\{(?P<braced>[^}]*)\}|(?P<index>[A-Za-z0-9α-ω]+)))?(?P<primes>['′’]*)"
    r"|(?P<sign>==|!=|<=|>=|><|<>|\+-|-\+|[-+−±∓*·⋅×/^=≠<≤>≥≷≶≡~:;,()\[\]{}|°])|(?P<end>$))"
)
FOR, IFF, IF, OR, AND, NOT, RELATION, RATIO, SUM, NEGATIVE, PRODUCT, JUXTAPOSED, POWER, ATOM = range(14)
LOGIC = {"and": (AND, NOT), "or": (OR, AND), "if": (IF, OR), "iff": (IFF, IF)}


class Unreadable(Exception):
    pass


def words(text):
    out, at = [], 0
    while True:
        found = WORD.match(text, at)
        if not found:
            raise Unreadable(f"at {text[at:at + 20]!r}")
        at = found.end()
        if found["number"]:
            out.append(("number", found["number"]))
        elif found["stem"]:
            out.append(("name", named(found), bool(found["bar"])))
        elif found["sign"]:
            out.append(("sign", SIGNS.get(found["sign"], found["sign"])))
        else:
            return out + [("end", "")]


def named(found):
    name = GREEK.get(found["stem"], found["stem"])
    index = found["braced"] or found["index"]
    if index:
        index = "".join(GREEK.get(c, c) for c in index)
        name += f"_{index}" if index.isalnum() else "_{" + index + "}"
    return name + "'" * len(found["primes"])


def read(text):
    """(claims, definitions, assumptions)."""
    reader = Reader(words(text))
    claims = reader.separated(";")
    definitions, assumptions = [], []
    if reader.take("where"):
        definitions.append(reader.definition())
        while reader.take(","):
            definitions.append(reader.definition())
    if reader.take("assume"):
        assumptions = reader.separated(",")
    if reader.word[0] != "end":
        raise Unreadable(f"{reader.word} after the end")
    return claims, definitions, assumptions


class Reader:
    def __init__(self, listed):
        self.listed, self.at, self.bars = listed, 0, 0

    @property
    def word(self):
        return self.listed[self.at]

    def after(self, count):
        return self.listed[min(self.at + count, len(self.listed) - 1)]

    def sees(self, sign, count=0):
        word = self.after(count)
        return word[0] in ("sign", "name") and word[1] == sign

    def take(self, sign):
        found = self.sees(sign)
        self.at += found
        return found

    def need(self, sign):
        if not self.take(sign):
            raise Unreadable(f"{self.word} where {sign} was expected")

    def separated(self, sign):
        out = [self.parse(FOR)]
        while self.take(sign):
            out.append(self.parse(FOR))
        return out

    def definition(self):
        name = self.name()
        self.need("=")
        return name, self.parse(RATIO)

    def name(self):
        kind, text, *_ = self.word
        if kind != "name" or text in KEYWORDS:
            raise Unreadable(f"{self.word} where a name was expected")
        self.at += 1
        return text

    def starts_factor(self, count=0):
        kind, text, *_ = self.after(count)
        if kind == "number":
            return True
        if kind == "name":
            return text not in KEYWORDS
        if text == "(":
            return not self.sees("mod", count + 1)
        return text in ("[", "{") or text == "|" and self.bars == 0

    def fraction_ahead(self):
        whole = [self.after(k)[0] == "number" and self.after(k)[1].isdigit() for k in (0, 2)]
        return all(whole) and self.sees("/", 1) and self.starts_factor(3) and self.after(3)[0] != "number"

    def parse(self, level):
        left = self.prefix(level)
        while True:
            kind, text, *_ = self.word
            if kind == "sign" and text in "+-±∓" and level <= SUM:
                self.at += 1
                left = (text, left, self.parse(NEGATIVE))
            elif kind == "sign" and text in "*/" and level <= PRODUCT:
                self.at += 1
                left = (text, left, self.parse(JUXTAPOSED))
            elif kind == "sign" and text == "^" and level <= POWER:
                self.at += 1
                left = self.power(left, self.parse(POWER))
            elif kind == "sign" and text in RELATIONS and level <= RELATION:
                left = self.chain(left)
            elif kind == "sign" and text == ":" and level <= RATIO:
                parts = [left]
                while self.take(":"):
                    parts.append(self.parse(SUM))
                left = ("ratio", parts)
            elif kind == "name" and text in LOGIC and level <= LOGIC[text][0]:
                self.at += 1
                left = (text, left, self.parse(LOGIC[text][1]))
            elif kind == "name" and text == "for" and level <= FOR:
                left = ("for", left, *self.bound())
            elif level <= JUXTAPOSED and self.starts_factor():
                left = ("*", left, self.parse(POWER))
            else:
                return left

    def bound(self):
        self.need("for")
        name = self.name()
        self.need("in")
        return name, self.parse(ATOM)

    def power(self, base, exponent):
        if base == ("name", "e"):
            angle = without_unit(exponent)
            if angle:
                return ("call", "cis", [angle])
        return ("^", base, exponent)

    def chain(self, first):
        rest = []
        while self.word[0] == "sign" and self.word[1] in RELATIONS:
            relation = self.word[1]
            self.at += 1
            rest.append((relation, self.parse(RATIO)))
        modulus = None
        parenthesis = self.sees("(") and self.sees("mod", 1)
        if parenthesis or self.sees("mod"):
            self.at += 1 + parenthesis
            modulus = self.parse(SUM)
            if parenthesis:
                self.need(")")
        return ("chain", first, rest, modulus)

    def prefix(self, level):
        if self.take("-"):
            return ("negative", self.parse(max(level, PRODUCT)))
        if level <= NOT and self.take("not"):
            return ("not", self.parse(NOT))
        if level <= JUXTAPOSED and self.fraction_ahead():
            p, q = self.word[1], self.after(2)[1]
            self.at += 3
            return ("number", Fraction(int(p), int(q)))
        return self.primary()

    def primary(self):
        kind, text, *rest = self.word
        if kind == "number":
            self.at += 1
            return self.degrees(("number", Fraction(text)))
        if kind == "name" and text not in KEYWORDS:
            return self.quantity(text, rest[0])
        if self.take("("):
            inner = self.inside(")", lambda: self.parse(FOR))
            return self.degrees(("group", inner))
        if self.take("["):
            return ("list", self.members("]"))
        if self.take("{"):
            return ("set", self.members("}"))
        if self.take("|"):
            self.bars += 1
            inner = self.parse(SUM)
            self.bars -= 1
            self.need("|")
            return ("call", "abs", [inner])
        raise Unreadable(f"{self.word} where a quantity was expected")

    def inside(self, closing, part):
        bars, self.bars = self.bars, 0
        inner = part()
        self.need(closing)
        self.bars = bars
        return inner

    def members(self, closing):
        if self.take(closing):
            return []
        return self.inside(closing, lambda: self.separated(","))

    def degrees(self, inner):
        return ("deg", inner) if self.take("deg") else inner

    def quantity(self, name, barred):
        self.at += 1
        if name in FUNCTIONS:
            return self.call(name)
        if name == "sum":
            self.need("(")
            return self.inside(")", lambda: ("sum", self.parse(SUM), *self.bound()))
        plain = {"i": ("i",), "pi": ("pi",)}.get(name, ("name", name))
        return ("call", "conj", [plain]) if barred else plain

    def call(self, name):
        if self.take("^"):
            exponent = self.parse(ATOM)
            return ("^", self.call(name), exponent)
        if self.take("("):
            return ("call", name, self.members(")"))
        if not self.starts_factor():
            raise Unreadable(f"{name} without an argument")
        argument = self.parse(POWER)
        while name in TRIGONOMETRIC and self.bare_factor():
            argument = ("*", argument, self.parse(POWER))
        return ("call", name, [argument])

    def bare_factor(self):
        kind, text, *_ = self.word
        return kind == "number" or kind == "name" and text not in KEYWORDS and text not in FUNCTIONS and text != "sum"


def without_unit(tree):
    """x for the exponent i x."""
    if tree[0] == "group":
        return without_unit(tree[1])
    if tree[0] == "negative":
        inner = without_unit(tree[1])
        return inner and ("negative", inner)
    if tree[0] == "*":
        if tree[1] == ("i",):
            return tree[2]
        if (inner := without_unit(tree[1])) is not None:
            return ("*", inner, tree[2])
        return tree[1] if tree[2] == ("i",) else None
    if tree[0] == "/":
        inner = without_unit(tree[1])
        return inner and ("/", inner, tree[2])
    return None
