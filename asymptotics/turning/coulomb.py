"""Turning points for dry friction (alpha = 0), exactly: each half-swing costs 2 epsilon, until the mass sticks.

X'' + X + epsilon sign(X') = 0 is a harmonic motion about +-epsilon on each half-swing (Lelas 2024, section 2), so

    x_n = (-1)^n (1 - 2 n epsilon),    tau_n = n pi,    n = 0, 1, ..., N,

and the mass sticks at the first turning point with 1 - 2 N epsilon <= epsilon, off centre in general: the restoring
force is there at most the friction.  x_N may lie on the side it came from (1 - 2 N epsilon < 0).

>>> from asymptotics.numbers import parse_real
>>> table = coulomb_turning_points(parse_real("3/10", "epsilon"), 5, 10, times=True)
>>> [(p.n, p.x, p.tau) for p in table.points], table.ended
([(0, '1.000000000', '0'), (1, '-0.4000000000', '3.141592654'), (2, '-0.2000000000', '6.283185307')],
 {'n': 2, 'reason': 'sticks'})
"""

from fractions import Fraction

from flint import arb

from asymptotics.errors import InputError
from asymptotics.numbers.decimals import certified_decimal, rational_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.swing.ends import STICKS
from asymptotics.turning.quadratic import TurningPoint, TurningPoints, require_counts


def last_turning_point(epsilon: ExactReal) -> int:
    """N: the smallest n >= 0 with (2 n + 1) epsilon >= 1, decided exactly; InputError unless epsilon > 0.

    >>> last_turning_point(ExactReal(Fraction(1, 3))), last_turning_point(ExactReal(Fraction(33, 100)))
    (1, 2)
    """
    if not epsilon > 0:
        raise InputError("epsilon", f"{epsilon} never brings the mass to rest", "a positive number")
    low, high = -1, 1
    while _moves_on(epsilon, high):
        low, high = high, 2 * high
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if _moves_on(epsilon, middle) else (low, middle)
    return high


def _moves_on(epsilon: ExactReal, n: int) -> bool:
    """(2 n + 1) epsilon < 1."""
    return n < 0 or epsilon < Fraction(1, 2 * n + 1)


def coulomb_turning_points(
    epsilon: ExactReal, count: int, digits: int = 30, *, start: int = 0, times: bool = False
) -> TurningPoints:
    """Turning points n = start ... start + count - 1 as far as they exist; all digits are correctly rounded."""
    require_counts(count, digits, start)
    last = last_turning_point(epsilon)
    points = []
    for n in range(start, min(start + count, last + 1)):
        points.append(TurningPoint(n, _place(epsilon, n, digits), _time(n, digits) if times else None))
    ended = {"n": last, "reason": STICKS} if start + count > last else None
    return TurningPoints("0", str(epsilon), digits, tuple(points), "closed form, exact", True, ended)


def _place(epsilon: ExactReal, n: int, digits: int) -> str:
    if epsilon.is_rational:
        return rational_decimal((-1) ** n * (1 - 2 * n * epsilon.rational), digits)
    return certified_decimal(lambda: (1 - 2 * n * epsilon.ball()) * (-1) ** n, digits)


def _time(n: int, digits: int) -> str:
    return certified_decimal(lambda: arb.pi() * n, digits) if n else "0"
