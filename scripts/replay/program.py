"""The program of 1964 as its listing and its printed results tell it (docs/burroughs-220.md), in any arithmetic.

Numbers are of a type with + - * / and comparison; the elementary functions come with the arithmetic.
"""

LEVELS = ((1, 10000), (1, 100), (5, 100))
MOST_DEGREES = 180


class Exact:
    """mpmath's numbers with many digits."""

    def __init__(self):
        from mpmath import mp, mpf

        self.number, self.sin, self.cos, self.atan, self.sqrt = mpf, mp.sin, mp.cos, mp.atan, mp.sqrt
        self.pi = +mp.pi


def lesser_angle(x, y):
    """Between two lines in degrees, as the program takes it."""
    apart = abs(x - y)
    return apart if not apart > 90 or x * y > 0 else abs(180 - apart)


class Program:
    levels_of_deviation = LEVELS

    def __init__(self, arithmetic, alpha_a, alpha_b):
        self.arithmetic = f = arithmetic
        number = f.number
        self.half = half = f.pi
        self.degree = degree = half / number(180)
        a, b = (number(x) * degree for x in (alpha_a, alpha_b))
        tan_a, tan_b = (f.sin(x) / f.cos(x) for x in (a, b))
        v, w = tan_a + tan_b, tan_a * tan_b
        d = f.atan(-v / (w + 3))
        self.d = d = d + half if d < 0 else d

        def places(angle, tangent):
            sine, cosine = f.sin(angle), f.cos(angle)
            pin = v * (w - 1) * sine / ((w + 3) * tangent + v * w)
            pivot = pin * sine / (sine - pin)
            return (pivot * cosine, pivot * sine), (pin * cosine, pin * sine), pivot, pin

        (u1, v1), (p1, q1), po_a, pa = places(a, tan_a)
        (u2, v2), (p2, q2), po_b, pb = places(b, tan_b)
        sin_d, cos_d = f.sin(d), f.cos(d)
        self.pivot, self.point = (u1, v1), (cos_d * sin_d, sin_d * sin_d)
        uu, vv = u2 - u1, v2 - v1
        self.q, self.s = self.length(uu, vv), self.length(p2 - p1, q2 - q1)
        self.r, self.t = abs(po_a - pa), abs(po_b - pb)
        self.theta = self.positive(self.arctan(vv, uu)[0])
        sine, cosine = f.sin(self.theta), f.cos(self.theta)

        def in_frame(x, y):
            return x * cosine + y * sine, -x * sine + y * cosine

        ax, ay = in_frame(p1 - u1, q1 - v1)
        bx, by = in_frame(p2 - u2, q2 - v2)
        phi, self.phi_line = self.arctan(ay, ax)
        psi, psi_line = self.arctan(by, bx)
        self.phi, self.psi = self.positive(phi), self.positive(psi)
        chi = f.atan((by - ay) / (bx + self.q - ax))
        self.gamma = [lesser_angle(x / degree, chi / degree) for x in (self.phi_line, psi_line)]

        def from_d(distance, angle):
            square = distance * distance + sin_d * sin_d - 2 * (distance * sin_d) * f.cos(angle - d)
            return f.sqrt(abs(square))

        self.n, self.m = from_d(pb, b), from_d(pa, a)
        between = abs(self.s - (self.m + self.n)) < number(1) / number(100000)
        self.epsilon = number(180 if not between and self.m < self.n else 0)
        self.unit = (self.q + self.r + self.s + self.t + (self.m + self.n) / 2) / 5
        self.sign = 1
        la, lb, lc, square = self.closure(self.phi)
        tangent = (la + f.sqrt(square)) / (lb + lc)
        angle = f.atan(tangent) + half if tangent < 0 else f.atan(tangent)
        if not abs(self.psi - 2 * angle) < number(1) / number(1000):
            self.sign = -1

    def length(self, x, y):
        return self.arithmetic.sqrt(x * x + y * y)

    def arctan(self, y, x):
        """With a half turn added where x is negative, and the principal value."""
        line = self.arithmetic.atan(y / x)
        return (line + self.half if x < 0 else line), line

    def positive(self, angle):
        return angle + 2 * self.half if angle < 0 else angle

    def closure(self, phi):
        """A, B, C of (6.21) and the square under the root."""
        q, r, s, t = self.q, self.r, self.s, self.t
        cosine = self.arithmetic.cos(phi)
        la, lb = self.arithmetic.sin(phi), cosine - q / r
        lc = (q * q + r * r + t * t - s * s) / (2 * r * t) - q / t * cosine
        return la, lb, lc, la * la + lb * lb - lc * lc

    def row(self, degrees):
        """Travel, deviation, turn of T, both transmission angles; None where the linkage does not close."""
        f, number = self.arithmetic, self.arithmetic.number
        turn = number(degrees)
        phi = self.phi + self.degree * turn
        la, lb, lc, square = self.closure(phi)
        if square < 0:
            return None
        rocker = 2 * f.atan((la + self.sign * f.sqrt(square)) / (lb + lc))
        psi = rocker - self.psi if rocker > 0 else rocker - self.psi + 2 * self.half
        ax, ay = self.r * f.cos(phi), self.r * f.sin(phi)
        bx, by = self.t * f.cos(rocker) + self.q, self.t * f.sin(rocker)
        coupler, chi = self.arctan(by - ay, bx - ax)
        arm = self.epsilon * self.degree + self.positive(coupler)
        u, v = self.travel(ax + self.m * f.cos(arm), ay + self.m * f.sin(arm))
        quarter = self.half / 2
        line = rocker - self.half if rocker > quarter else rocker + self.half if rocker < -quarter else rocker
        crank = (self.phi_line + turn * self.degree) / self.degree
        chi = chi / self.degree
        return {"u": u, "v": v, "psi": psi / self.degree, "gamma_a": lesser_angle(crank, chi), "gamma_b": lesser_angle(line / self.degree, chi)}

    def travel(self, x, y):
        """Along and across the line, in unit lengths."""
        f = self.arithmetic
        sine, cosine = f.sin(self.theta), f.cos(self.theta)
        us, vs = x * cosine - y * sine + self.pivot[0], x * sine + y * cosine + self.pivot[1]
        sine, cosine = f.sin(self.d), f.cos(self.d)
        along = (self.point[0] - us) * sine + (vs - self.point[1]) * cosine
        across = (self.point[0] - us) * cosine - (vs - self.point[1]) * sine
        return along / self.unit, across / self.unit

    def design(self):
        """What is printed of the linkage."""
        out = {name: getattr(self, name.lower()) / self.unit for name in "QRSTMN"}
        out |= {"alpha_d": self.d / self.degree, "phi": self.phi / self.degree, "psi": self.psi / self.degree}
        return out | {"unit": self.unit, "epsilon": self.epsilon, "gamma_a": self.gamma[0], "gamma_b": self.gamma[1]}

    def ends(self, side):
        """What is recorded for each level on one side: (degrees of the crank, row).

        The first row beyond a level is its end. A row in which the travel has turned back ends all levels
        that are left: travel, deviation and psi are its own, the transmission angles those of the row before,
        and the counter of the crank goes back by one, for the next level by two."""
        start = self.row(0)
        last, counted, saved = dict(start), 0, start["u"]
        heading, records, back, degrees = 0, [], 1, side
        while abs(degrees) <= MOST_DEGREES and len(records) < len(self.levels_of_deviation):
            now = self.row(degrees)
            ended = now is None
            if now is not None:
                if degrees == side:
                    heading = now["u"] - start["u"]
                ended = degrees != counted and heading * (now["u"] - saved) < 0
                if ended:
                    now |= {name: last[name] for name in ("gamma_a", "gamma_b")}
                else:
                    counted, saved = degrees, now["u"]
                now["psi"] = near_by(now["psi"], last["psi"])
                last = now
            if ended:
                degrees -= side * back
                back += 1
                records.append((degrees, dict(last)))
            while len(records) < len(self.levels_of_deviation):
                p, q = self.levels_of_deviation[len(records)]
                if not abs(last["v"]) > self.arithmetic.number(p) / self.arithmetic.number(q):
                    break
                records.append((degrees, dict(last)))
            degrees += side
        return records

    def levels(self):
        """The results of each level: length, deviations, turns and angles at the end L (forwards) and R."""
        out = []
        for (forth, left), (back, right) in zip(self.ends(1), self.ends(-1)):
            one = {"length": abs(left["u"]) + abs(right["u"])}
            for name, degrees, row in (("L", forth, left), ("R", back, right)):
                one |= {f"d_{name}": abs(row["v"]), f"phi_{name}": self.arithmetic.number(degrees), f"psi_{name}": row["psi"],
                        f"gamma_a{name}": row["gamma_a"], f"gamma_b{name}": row["gamma_b"]}
            out.append(one)
        return out

    def table_row(self, z):
        """u, v and the difference quotients over one degree on either side; a row that has turned back was not stored."""
        u_0 = self.row(0)["u"]
        here = self.row(z)

        def neighbour(step):
            other = self.row(z + step)
            turned = step * z > 0 and (here["u"] - u_0) * (other["u"] - here["u"]) < 0
            zero = self.arithmetic.number(0)
            return (zero, zero) if turned else (other["u"] - u_0, other["v"])

        (u_before, v_before), (u_after, v_after) = neighbour(-1), neighbour(1)
        u, v = here["u"] - u_0, here["v"]
        span = u_after - u_before
        bend = (v_after - v) / (u_after - u) - (v - v_before) / (u - u_before)
        return {"u": u, "v": v, "velocity": (v_after - v_before) / span, "acceleration": 2 * (bend / span)}


def near_by(angle, other):
    """Whole turns added until it is near."""
    while angle - other > 180:
        angle = angle - 360
    while angle - other < -180:
        angle = angle + 360
    return angle
