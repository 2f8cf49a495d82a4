"""2F1(1, a; a+1; z), the time integral of two laws, to 50 and 1000 digits: seconds a call, certified beside others.

Only the balls know the error of what they return.  Where z < 0, as in every time integral, a rational a = p/q needs q
logarithms; elsewhere the ball function must be told that c - a - b = 0, or it is thousands of times slower.
"""

from fractions import Fraction

from flint import arb

from asymptotics.envelopes.certified import F
from asymptotics.numbers.context import ctx
from benchmarks.peers import ask
from benchmarks.table import Table, best_time, seconds_text

PEERS = ("mpmath", "gmpy2", "cypari")
MPMATH = """
import mpmath
mpmath.mp.dps = digits
a, z = mpmath.mpf(5) / 3, mpmath.mpf(p) / q
seconds, value = best(lambda: mpmath.hyp2f1(1, a, a + 1, z))
answer = {"seconds": seconds}
"""
PARI = """
from cypari import pari
pari.set_real_precision(digits)
call = pari(f"(n) -> for (i = 1, n, hypergeom([1, 5/3], 8/3, {p}/{q} + 0.))")
seconds, _ = best(lambda: call(5))
answer = {"seconds": seconds / 5}
"""
POINTS = ((3, 10), (9, 10), (-1, 1), (-50, 1))


def ball(p: int, q: int, digits: int) -> arb:
    """The value at z = p/q as a ball of at least ``digits`` digits."""
    with ctx.workprec(int(3.33 * digits) + 30):
        if p < 0:
            return F(Fraction(5, 3), arb(p) / q)
        a = arb(5) / 3
        return (arb(p) / q).hypgeom_2f1(arb(1), a, a + 1, abc=True)


def run(size: int = 1000) -> Table:
    """Four points z at 50 and ``size`` digits."""
    rows = []
    for digits in sorted({min(50, size), size}):
        for p, q in POINTS:
            first = best_time(lambda p=p, q=q, digits=digits: ball(p, q, digits))
            where = f"z = {p}/{q}, {digits} digits"
            rows.append((f"{where}, balls", seconds_text(first), "1.0"))
            for name, code in (("mpmath with gmpy2", MPMATH), ("PARI", PARI)):
                seconds = ask(code, p=p, q=q, digits=digits)["seconds"]
                ratio = "-" if seconds is None or not 0 < seconds < 1e9 else f"{seconds / first:.2g}"
                rows.append((f"{where}, {name}", seconds_text(seconds), ratio))
    return Table("2F1(1, 5/3; 8/3; z)", ("what", "seconds", "ratio"), tuple(rows))
