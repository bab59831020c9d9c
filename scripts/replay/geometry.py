"""The same linkage without the program: circles that meet, and the branch that is near the last place."""

from mpmath import mp, mpf, pi

from .scenes.coupler import center_of_path, cubic_of
from .scenes.symmetric import circles_meet


class Linkage:
    """Pins on the rays alpha_a and alpha_b, the output point D where both other Burmester points fall together."""

    def __init__(self, alpha_a, alpha_b):
        rays = [mpf(x) * pi / 180 for x in (alpha_a, alpha_b)]
        p, q = map(mp.tan, rays)
        ray_d = mp.atan(-(p + q) / (p * q + 3)) % pi
        inverse_m, inverse_n = cubic_of(p + q, p * q)
        self.a, self.b = (mp.expj(x) / (inverse_m / mp.sin(x) + inverse_n / mp.cos(x)) for x in rays)
        self.d = mp.sin(ray_d) * mp.expj(ray_d)
        self.o_a, self.o_b = center_of_path(self.a), center_of_path(self.b)
        lengths = [abs(x) for x in (self.o_b - self.o_a, self.a - self.o_a, self.b - self.a, self.b - self.o_b)]
        self.unit = (sum(lengths) + (abs(self.d - self.a) + abs(self.d - self.b)) / 2) / 5
        # The path of D is across its ray.
        self.along = 1j * mp.expj(ray_d)

    def places(self, most):
        """(u, v) for whole degrees from 0 to most, of either sign, as long as the linkage closes."""
        out, b = [(mpf(0), mpf(0))], self.b
        step = 1 if most > 0 else -1
        for degrees in range(step, most + step, step):
            a = self.o_a + mp.expj(degrees * pi / 180) * (self.a - self.o_a)
            b = min(circles_meet(a, abs(self.b - self.a), self.o_b, abs(self.b - self.o_b)), key=lambda z: abs(z - b))
            moved = a + (self.d - self.a) / (self.b - self.a) * (b - a)
            way = (moved - self.d) / self.along / self.unit
            out.append((way.real, way.imag))
        return out
