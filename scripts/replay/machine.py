"""Arithmetic with eight decimal digits in which every result is rounded up or down at random.

How far such a computation strays from the exact one bounds what the printed digits can say.
"""

import math
import random

DIGITS = 8



def arithmetic(seed):
    """The operations for a program, with their own generator."""
    rng = random.Random(seed)
    draw = rng.random
    floor, log10 = math.floor, math.log10
    scales = {k: 10.0 ** (DIGITS - 1 - k) for k in range(-40, 40)}

    def rounded(x):
        if x == 0:
            return 0.0
        size = abs(x)
        power = floor(log10(size))
        # log10 may be off by one at powers of ten.
        if size >= 10.0 ** (power + 1):
            power += 1
        scale = scales.get(power)
        if scale is None:
            return x
        scaled = x * scale
        low = floor(scaled)
        near = round(scaled)
        # What is a number of eight digits stays as it is.
        if abs(scaled - near) < 1e-6 and abs(near) < 10**DIGITS * 10:
            return near / scale
        return (low + (draw() < 0.5)) / scale

    class Number:
        __slots__ = ("x",)

        def __init__(self, x):
            self.x = rounded(float(x)) if not isinstance(x, Number) else x.x

        def __add__(self, other):
            return Number(self.x + value(other))

        __radd__ = __add__

        def __sub__(self, other):
            return Number(self.x - value(other))

        def __rsub__(self, other):
            return Number(value(other) - self.x)

        def __mul__(self, other):
            return Number(self.x * value(other))

        __rmul__ = __mul__

        def __truediv__(self, other):
            return Number(self.x / value(other))

        def __rtruediv__(self, other):
            return Number(value(other) / self.x)

        def __neg__(self):
            return exactly(-self.x)

        def __abs__(self):
            return exactly(abs(self.x))

        def __lt__(self, other):
            return self.x < value(other)

        def __gt__(self, other):
            return self.x > value(other)

        def __float__(self):
            return self.x

    def value(other):
        return other.x if isinstance(other, Number) else other

    def exactly(x):
        out = Number.__new__(Number)
        out.x = x
        return out

    class Arithmetic:
        number = Number
        pi = Number(math.pi)

        @staticmethod
        def sin(x):
            return Number(math.sin(x.x))

        @staticmethod
        def cos(x):
            return Number(math.cos(x.x))

        @staticmethod
        def atan(x):
            return Number(math.atan(x.x))

        @staticmethod
        def sqrt(x):
            return Number(math.sqrt(x.x))

    return Arithmetic
