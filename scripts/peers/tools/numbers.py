"""Numbers of a problem and balls, as text: "m e r f" in hexadecimal is m 2^e +- r 2^f, p/q exact."""

from flint import acb, arb, fmpq


def rational(text):
    p, _, q = text.partition("/")
    return fmpq(int(p), int(q or 1))


def power(text):
    return int(text, 16)


def written(x):
    if isinstance(x, acb):
        return [written(x.real), written(x.imag)]
    x = arb(x)
    (m, e), (r, f) = x.mid().man_exp(), x.rad().man_exp()
    return f"{int(m):x} {int(e):x} {int(r):x} {int(f):x}"


def ball(text):
    if isinstance(text, list):
        return acb(ball(text[0]), ball(text[1]))
    if "/" in text:
        return arb(rational(text))
    m, e, r, f = map(power, text.split())
    return arb((m, e), (r, f))
