"""Any four-bar in any position (Tesar, chapter VI)."""

from mpmath import mp, mpc

from ..evaluate import Angle, NoValue
from .draw import cis, coordinates, cross, directed, dot, length, mirrored, point, radians, turn


def input_output(rng):
    q, r, t = (length(rng) for _ in range(3))
    phi, psi = radians(rng), radians(rng)
    o_b = mpc(q, 0)
    a, b = r * cis(phi), o_b + t * cis(psi)
    d = point(rng)
    other = mirrored(b, a, o_b - a)
    symbols = {"Q": q, "R": r, "T": t, "S": abs(b - a), "M": abs(d - a), "phi": Angle(phi), "psi": Angle(psi)}
    symbols |= {"psi'": directed(o_b, other), "chi": directed(a, b), "epsilon": turn(b - a, d - a)}
    return symbols | coordinates(("x_a", "y_a"), a) | coordinates(("x_b", "y_b"), b) | coordinates(("x", "y"), d)


def dead_centres(rng):
    """No link turns fully: the shortest and the longest are together longer than the other two."""
    q, r, s, t = (length(rng) for _ in range(4))
    links = sorted((q, r, s, t))
    if links[0] + links[3] <= links[1] + links[2] or links[3] >= sum(links[:3]):
        raise NoValue("a link turns fully, or the chain does not close")
    reaches = [x for x in (s + t, abs(s - t)) if abs(q - r) < x < q + r]
    if len(reaches) != 1:
        raise NoValue("more dead centres")
    phi = mp.acos((q * q + r * r - reaches[0] ** 2) / (2 * q * r))
    return {"Q": q, "R": r, "S": s, "T": t, "phi_{+}": Angle(phi), "phi_{-}": Angle(-phi)}


def line_angle(u):
    """From -90 to 90 degrees."""
    return mp.atan(u.imag / u.real)


def transmission_angle(rng):
    crank, link = cis(radians(rng)), cis(radians(rng))
    gamma = mp.atan2(abs(cross(crank, link)), abs(dot(crank, link)))
    phi, chi = line_angle(crank), line_angle(link)
    return {"gamma_a": Angle(gamma), "phi'": Angle(phi), "chi'": Angle(chi), "p": Angle(abs(phi)), "q": Angle(abs(chi))}


SCENES = {
    "tesar1964/input-output": input_output,
    "tesar1964/dead-centres-of-a-double-lever": dead_centres,
    "tesar1964/transmission-angle": transmission_angle,
}
