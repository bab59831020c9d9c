"""Five positions of a plane with a known pair, and Bottema's linear unknowns Z (Tesar, chapter III)."""

from mpmath import mp, mpf

from ..evaluate import Angle
from .draw import cis, length, number, point, radians, unit


def positions(rng):
    center, radius = point(rng), length(rng)
    places = [center + radius * unit(rng) for _ in range(5)]
    turns = [mpf(0)] + [radians(rng) for _ in range(4)]
    z = places[0]
    origins = [w - cis(phi) * z for w, phi in zip(places, turns)]
    some = rng.choice(places)
    symbols = {"x": some.real, "y": some.imag, "x_o": z.real, "y_o": z.imag, "x_c": center.real, "y_c": center.imag}
    for j, (w, phi, a) in enumerate(zip(places, turns, origins)):
        back = -cis(-phi) * a
        symbols |= {f"X_{j}": w.real, f"Y_{j}": w.imag, f"phi_{j}": Angle(phi), f"a_{j}": a.real, f"b_{j}": a.imag,
                    f"a_{j}'": back.real, f"b_{j}'": back.imag}
    q0 = number(rng)
    symbols |= {"Q_0": q0, "Q_1": -q0 * center.real, "Q_2": -q0 * center.imag, "Q_3": q0 * (abs(center) ** 2 - radius**2)}
    mixed = z * mp.conj(center)
    symbols |= {"Z_0": q0, "Z_1": -q0 * z.real, "Z_2": -q0 * z.imag, "Z_3": q0 * mixed.real, "Z_4": q0 * mixed.imag,
                "Z_5": -q0 * center.real, "Z_6": -q0 * center.imag, "Z_7": mpf(0)}
    symbols |= {"C_1": -z.real, "C_2": -z.imag, "C_5": -center.real, "C_6": -center.imag}
    return symbols, turns, origins


def pair(rng):
    return positions(rng)[0]


def rows_of(turns, origins):
    """Each position's condition: (1 - cos) Z_3 + sin Z_4 + a Z_5 + b Z_6 + a' Z_1 + b' Z_2 + |a|^2/2 Z_0 = 0."""
    for phi, a in zip(turns[1:], origins[1:]):
        back = -cis(-phi) * a
        yield {3: 1 - mp.cos(phi), 4: mp.sin(phi), 5: a.real, 6: a.imag, 1: back.real, 2: back.imag, 0: abs(a) ** 2 / 2}


def solved(symbols, rows, unknown, given):
    """Minors, determinant, and what multiplies each given Z in the determinant times each unknown one."""
    matrix = mp.matrix([[row[k] for k in unknown] for row in rows])
    size = len(unknown)
    symbols["Delta"] = mp.det(matrix)
    for j in range(size):
        for i in range(size):
            minor = mp.matrix([[matrix[p, q] for q in range(size) if q != i] for p in range(size) if p != j])
            symbols[f"Delta_{{{j + 1},{i + 1}}}"] = mp.det(minor)
    for letter, k in given.items():
        solution = mp.lu_solve(matrix, mp.matrix([-row[k] for row in rows]))
        for i in range(size):
            symbols[f"{letter}_{i + 1}"] = solution[i] * symbols["Delta"]


def five_positions(rng):
    symbols, turns, origins = positions(rng)
    rows = list(rows_of(turns, origins))
    for name in [n for n in symbols if n[:2] in ("C_",)]:
        del symbols[name]
    solved(symbols, rows, (3, 4, 5, 6), {"A": 0, "B": 1, "C": 2})
    symbols |= conics(symbols)
    return symbols


def conics(s):
    """Z_0 Z_3 = Z_1 Z_5 + Z_2 Z_6 and Z_0 Z_4 = Z_2 Z_5 - Z_1 Z_6 as conics in x = Z_1/Z_0, y = Z_2/Z_0."""
    linear = [(s[f"A_{i}"] / s["Delta"], s[f"B_{i}"] / s["Delta"], s[f"C_{i}"] / s["Delta"]) for i in (1, 2, 3, 4)]
    z3, z4, z5, z6 = linear
    # Coefficients of y^2, x y, y, x^2, x, 1.
    first = (z6[2], z5[2] + z6[1], z6[0] - z3[2], z5[1], z5[0] - z3[1], -z3[0])
    second = (z5[2], z5[1] - z6[2], z5[0] - z4[2], -z6[1], -z6[0] - z4[1], -z4[0])
    out = {}
    for names, conic in (("abcde", first), ("fghkl", second)):
        out |= {name: c / conic[0] for name, c in zip(names, conic[1:])}
    return out


def on_a_line(rng):
    turns = [mpf(0)] + [radians(rng) for _ in range(4)]
    origins = [mp.mpc(0)] + [mp.mpc(number(rng), 0) for _ in range(4)]
    symbols = {}
    for j in (1, 2, 3, 4):
        symbols |= {f"phi_{j}": Angle(turns[j]), f"a_{j}": origins[j].real}
    rows = list(rows_of(turns, origins))
    solved(symbols, rows, (1, 2, 3, 4), {"M": 0, "N": 5})
    z0, z5 = number(rng), number(rng)
    symbols |= {"Z_0": z0, "Z_5": z5}
    for i in (1, 2, 3, 4):
        symbols[f"Z_{i}"] = (symbols[f"M_{i}"] * z0 + symbols[f"N_{i}"] * z5) / symbols["Delta"]
    s = symbols
    s["Z_6"] = (z0 * s["Z_3"] - s["Z_1"] * z5) / s["Z_2"]
    s["excess"] = (z0 * s["Z_4"] - s["Z_2"] * z5 + s["Z_1"] * s["Z_6"]) / z0**2
    return symbols


SCENES = {
    "tesar1964/burmester-pair": pair,
    "tesar1964/five-positions": five_positions,
    "tesar1964/five-positions-on-a-line": on_a_line,
}
