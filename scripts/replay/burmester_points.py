"""The quartic of the Burmester points of one position, from two of them.

Seen from the pole, with the diameter of the inflection circle as unit, the motion is
z -> e^(i x) z + c2 x^2/2 + c3 x^3/6 + c4 x^4/24 with c2 = i. For a point r u and a center s u on the ray
u = (1 + i t) cos the derivatives of the squared distance vanish up to the fourth if 1/s = 1/r - 1/sin,
1/r = m/sin + n/cos, and 6/(r s) + 2 Re(u (-6 conj c2 + 4 i conj c3 + conj c4))/s - 2 - 2 Re(c4 conj u)/r = 0:
of order four in t. The second condition says c3 = 3 (m - 1) + 3 n i; two points determine c4.
"""

from mpmath import mp, mpc, mpf

from .scenes.draw import polynomial


def quartic(m, n, first, second):
    """Coefficients, lowest first, of which both tangents are roots."""
    c3 = mpc(3 * (m - 1), 3 * n)

    def parts(t):
        """What c4 multiplies, real and imaginary part, and the rest, all times t^2."""
        u, r, s = mpc(1, t), m + n * t, m - 1 + n * t
        known = 6 * r * s * (1 + t * t) + 2 * (u * (6j + 4j * mp.conj(c3))).real * s * t - 2 * t * t
        # 2 Re(u conj c4) (1/s - 1/r), and 1/s - 1/r = -1/sin.
        return -2 * t, -2 * t * t, known

    rows = [parts(t) for t in (first, second)]
    c4 = mp.lu_solve(mp.matrix([row[:2] for row in rows]), mp.matrix([-row[2] for row in rows]))
    at = [mpf(x) for x in (-2, -1, 1, 2, 3)]
    return polynomial([row[2] + row[0] * c4[0] + row[1] * c4[1] for row in map(parts, at)], at)
