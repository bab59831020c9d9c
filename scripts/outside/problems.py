"""Problems with five positions, kind by kind, from a seed; points are pairs of fractions."""

from flint import fmpq

ZERO, ONE = fmpq(0), fmpq(1)


def plus(p, q):
    return p[0] + q[0], p[1] + q[1]


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def times(p, q):
    return p[0] * q[0] - p[1] * q[1], p[0] * q[1] + p[1] * q[0]


def conj(p):
    return p[0], -p[1]


def over(p, q):
    norm = q[0] * q[0] + q[1] * q[1]
    w = times(p, conj(q))
    return w[0] / norm, w[1] / norm


def turn(t):
    """Cosine and sine of the angle whose half has the tangent t."""
    return (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)


def fraction(rng, most=60, below=12):
    return fmpq(rng.randint(-most, most), rng.randint(1, below))


def point(rng, most=60, below=12):
    return fraction(rng, most, below), fraction(rng, most, below)


def any_turn(rng):
    return turn(fraction(rng, 30, 12))


def carried(r, circlepoint, place):
    """The position with the rotation r in which a point of the moving plane has this place."""
    return (*r, *minus(place, times(r, circlepoint)))


def text(q):
    q = fmpq(q)
    return f"{q.p}" if q.q == 1 else f"{q.p}/{q.q}"


def shown(position):
    c, s, a, b = position
    return {"x": text(a), "y": text(b), "angle": {"cos": text(c), "sin": text(s)}}


def of_turns(rng, size=lambda rng: fraction(rng, 30, 12), reach=lambda rng: point(rng)):
    """Positions by tan_half."""
    listed, exact = [], []
    for _ in range(5):
        t, (a, b) = size(rng), reach(rng)
        listed.append({"x": text(a), "y": text(b), "angle": {"tan_half": text(t)}})
        exact.append((*turn(t), a, b))
    return listed, exact, []


def written(exact, known=()):
    return [shown(p) for p in exact], exact, list(known)


def dyad(rng, z, m, radius, rotations, cranks):
    exact = [carried(r, z, plus(m, (radius * c[0], radius * c[1]))) for r, c in zip(rotations, cranks)]
    return written(exact, [(z, m)])


def five(rng, of=any_turn):
    return [of(rng) for _ in range(5)]


def one_dyad(rng):
    return dyad(rng, point(rng), point(rng), fraction(rng) + 7, five(rng), five(rng))


def mirrored(p, a, b):
    """p mirrored in the line ab."""
    d = minus(b, a)
    return plus(a, times(over(d, conj(d)), conj(minus(p, a))))


def configurations(a0, b0, a, b):
    """Five configurations of one four-bar, by folding it over its diagonals in turn."""
    forward = [(a, b)]
    for k in range(2):
        a1, b1 = forward[-1]
        forward.append((mirrored(a1, a0, b1), b1) if k % 2 == 0 else (a1, mirrored(b1, a1, b0)))
    back = [(a, b)]
    for k in range(2):
        a1, b1 = back[-1]
        back.append((a1, mirrored(b1, a1, b0)) if k % 2 == 0 else (mirrored(a1, a0, b1), b1))
    return [*reversed(back[1:]), *forward]


def of_joints(rng, a0, b0, joints):
    """Positions of a coupler by places of its joints, in a moving frame at random."""
    (a, b), *_ = joints
    z = point(rng)
    w = plus(z, times(any_turn(rng), minus(b, a)))
    exact = [carried(over(minus(b1, a1), minus(w, z)), z, a1) for a1, b1 in joints]
    return written(exact, [(z, a0), (w, b0)])


def small(rng):
    return fraction(rng, 9, 3)


def four_bar(rng):
    a0, b0, a, b = ((small(rng), small(rng)) for _ in range(4))
    return of_joints(rng, a0, b0, configurations(a0, b0, a, b))


def kite(rng):
    """A0A = AB and B0B = B0A0: B is A0 mirrored in the line AB0."""
    a0, b0 = ((small(rng), small(rng)) for _ in range(2))
    radius = small(rng)
    places = [plus(a0, (radius * c, radius * s)) for c, s in five(rng)]
    return of_joints(rng, a0, b0, [(a, mirrored(a0, a, b0)) for a in places])


def near(rng, unit):
    base = (any_turn(rng), point(rng))
    exact = []
    for _ in range(5):
        r = times(base[0], turn(fraction(rng, 30, 12) * unit))
        a, b = point(rng)
        exact.append((*r, base[1][0] + a * unit, base[1][1] + b * unit))
    return written(exact)


def nearly_equal_angles(rng, unit=fmpq(1, 10**6)):
    return of_turns(rng, lambda rng: fmpq(1, 2) + fraction(rng) * unit)


def near_translations(rng):
    return of_turns(rng, lambda rng: fraction(rng) * fmpq(1, 10 ** rng.choice([9, 15])))


def far_pivot(rng):
    """The center 10^6 or 10^9 away, all places of the circlepoint within a few units."""
    radius = fmpq(10 ** rng.choice([6, 9]))
    direction = any_turn(rng)
    cranks = [times(direction, turn(fraction(rng, 30, 12) / radius)) for _ in range(5)]
    z, at = point(rng), point(rng)
    return dyad(rng, z, minus(at, (radius * direction[0], radius * direction[1])), radius, five(rng), cranks)


def inverted(positions):
    """The fixed plane seen from the moving one."""
    exact = []
    for c, s, a, b in positions:
        back = (c, -s)
        x, y = times(back, (a, b))
        exact.append((*back, -x, -y))
    return exact


def far_circlepoint(rng):
    _, exact, known = far_pivot(rng)
    return written(inverted(exact), [(m, z) for z, m in known])


def slider(rng):
    """One point moves along a line."""
    z, at, along = point(rng), point(rng), point(rng)
    exact = []
    for r in five(rng):
        k = fraction(rng)
        exact.append(carried(r, z, plus(at, (k * along[0], k * along[1]))))
    return written(exact)


def inverted_slider(rng):
    return written(inverted(slider(rng)[1]))


def kernel(rows):
    from flint import fmpq_mat

    reduced, rank = fmpq_mat(rows).rref()
    pivots = [next(j for j in range(5) if reduced[i, j] != 0) for i in range(rank)]
    free = [j for j in range(5) if j not in pivots]
    vector = [ZERO] * 5
    vector[free[0]] = ONE
    for i, j in enumerate(pivots):
        vector[j] = -reduced[i, free[0]]
    return vector


def double_turns(rng):
    """Turns of plane and crank of five positions in which one pair counts twice.

    (g, c) with g = r/c of four positions lie on a hyperplane Re(g dz) - Re(conj(c) dM) = k; so does every
    combination of three of them, and one more combination has |g| = |c| = 1."""
    while True:
        cranks = [any_turn(rng) for _ in range(4)]
        gears = [any_turn(rng) for _ in range(4)]
        first = [times(conj(gears[i]), gears[j])[0] - 1 for i, j in ((1, 2), (2, 0), (0, 1))]
        second = [times(conj(cranks[i]), cranks[j])[0] - 1 for i, j in ((1, 2), (2, 0), (0, 1))]
        n = [first[i] * second[j] - first[j] * second[i] for i, j in ((1, 2), (2, 0), (0, 1))]
        weights = [n[1] * n[2], n[0] * n[2], n[0] * n[1]]
        total = sum(weights, ZERO)
        if total == 0 or any(w == 0 for w in weights):
            continue

        def mean(points):
            return tuple(sum((w * p[k] for w, p in zip(weights, points)), ZERO) / total for k in range(2))

        gears.append(mean(gears[:3]))
        cranks.append(mean(cranks[:3]))
        return [times(g, c) for g, c in zip(gears, cranks)], cranks


def double_pair(rng):
    return dyad(rng, point(rng), point(rng), fraction(rng) + 7, *double_turns(rng))


def nearly_double(rng):
    _, exact, _ = double_pair(rng)
    unit = fmpq(1, 10 ** rng.choice([6, 12, 24]))
    c, s, a, b = exact[4]
    exact[4] = (c, s, a + unit * fraction(rng), b + unit * fraction(rng))
    return written(exact)


PYTHAGOREAN = [(3, 4, 5), (5, 12, 13), (8, 15, 17), (7, 24, 25), (20, 21, 29), (12, 35, 37)]


def triple_pair(rng):
    """Positions symmetric to an axis, the gears in one ratio of the sines to the cranks."""
    p, q, n = rng.choice(PYTHAGOREAN)
    sines = [(fmpq(p, n), fmpq(q, n)), (fmpq(q, n), fmpq(p, n))]
    (sin_c, cos_c), (sin_g, cos_g) = sines
    crank, gear = (cos_c, sin_c), (cos_g, sin_g)
    crank2, gear2 = (-cos_c, sin_c), (rng.choice([1, -1]) * cos_g, sin_g)
    turns = [((ONE, ZERO), (ONE, ZERO))]
    for c, g in ((crank, gear), (crank2, gear2)):
        turns += [(times(c, g), c), (conj(times(c, g)), conj(c))]
    spin, other = any_turn(rng), any_turn(rng)
    rotations = [times(spin, times(r, other)) for r, _ in turns]
    cranks = [times(spin, c) for _, c in turns]
    return dyad(rng, point(rng), point(rng), fraction(rng) + 7, rotations, cranks)


def quadruple_pair(rng):
    """Each position a reflection in a line that touches one circle: r = -c^2."""
    cranks = five(rng)
    rotations = [times((-ONE, ZERO), times(c, c)) for c in cranks]
    spin = any_turn(rng)
    return dyad(rng, point(rng), point(rng), fraction(rng) + 7, [times(r, spin) for r in rotations], cranks)


def half_turns(rng):
    """Half of the angles opposite, the others arbitrary."""
    listed, exact, _ = of_turns(rng)
    for k, (degrees, r) in enumerate([("0", (ONE, ZERO)), ("180", (-ONE, ZERO))]):
        listed[k]["angle"] = {"degrees": degrees}
        exact[k] = (*r, *exact[k][2:])
    return listed, exact, []


def by_points(rng):
    """Two points of the body in each position; the moving plane is the fixed one in the first."""
    _, exact, _ = one_dyad(rng)
    p, q = point(rng), point(rng)
    listed, positions = [], []
    first = exact[0]
    back = conj(first[:2])
    for c, s, a, b in exact:
        r = times((c, s), back)
        position = (*r, *minus((a, b), times(r, first[2:])))
        positions.append(position)
        places = [plus(times(position[:2], corner), position[2:]) for corner in (p, q)]
        listed.append({"points": [[text(x), text(y)] for x, y in places]})
    return listed, positions, []


def scaled(rng):
    unit = fmpq(10) ** rng.choice([30, -30])
    listed, exact, _ = one_dyad(rng)
    return written([(c, s, a * unit, b * unit) for c, s, a, b in exact])


def in_degrees(rng):
    listed = []
    for _ in range(5):
        a, b = point(rng)
        listed.append({"x": text(a), "y": text(b), "angle": {"degrees": f"{rng.randint(-3600, 3600) / 10}"}})
    return listed, None, []


def close_in_degrees(rng):
    listed = []
    for _ in range(5):
        angle = f"40.{rng.randint(0, 999999):06d}"
        a, b = point(rng)
        listed.append({"x": text(a / 100), "y": text(b / 100), "angle": {"degrees": angle}})
    return listed, None, []


def in_radians(rng):
    listed = []
    for _ in range(5):
        a, b = point(rng)
        listed.append({"x": text(a), "y": text(b), "angle": {"radians": f"{rng.randint(-3141, 3141) / 1000}"}})
    return listed, None, []


def two_equal(rng):
    exact = of_turns(rng)[1][:4]
    exact.insert(rng.randint(0, 4), rng.choice(exact))
    return written(exact)


KINDS = {
    "random, tan_half": (of_turns, 130),
    "one pair chosen": (one_dyad, 130),
    "four-bar": (four_bar, 90),
    "kite": (kite, 30),
    "positions 10^-2 apart": (lambda rng: near(rng, fmpq(1, 100)), 80),
    "positions 10^-6 apart": (lambda rng: near(rng, fmpq(1, 10**6)), 80),
    "nearly equal angles": (nearly_equal_angles, 60),
    "near translations": (near_translations, 60),
    "pivot far away": (far_pivot, 60),
    "circlepoint far away": (far_circlepoint, 60),
    "center at infinity": (slider, 50),
    "circlepoint at infinity": (inverted_slider, 50),
    "double pair": (double_pair, 60),
    "nearly double pair": (nearly_double, 60),
    "triple pair": (triple_pair, 20),
    "quadruple pair": (quadruple_pair, 20),
    "half turns": (half_turns, 40),
    "by two points": (by_points, 60),
    "sizes 10^30, 10^-30": (scaled, 40),
    "two equal positions": (two_equal, 20),
    "degrees": (in_degrees, 90),
    "degrees, close": (close_in_degrees, 30),
    "radians": (in_radians, 30),
}


def problems(rng):
    """Problems as JSON objects, each with its exact positions (if rational) and the pairs that it was made from."""
    for kind, (make, count) in KINDS.items():
        for number in range(count):
            while True:
                try:
                    listed, exact, known = make(rng)
                    break
                except ZeroDivisionError:
                    continue
            name = f"{kind} {number + 1}"
            yield kind, {"problem": "five-positions", "id": name, "positions": listed}, exact, known
