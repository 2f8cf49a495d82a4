"""Turning points for linear damping (alpha = 1), in closed form: a geometric sequence, or none if overdamped.

X'' + epsilon X' + X = 0 from rest at X = 1.  For epsilon < 2, with mu = (epsilon/2)/sqrt(1 - epsilon^2/4),

    x_n = (-1)^n exp(-n pi mu),     tau_n = n pi/sqrt(1 - epsilon^2/4).

For epsilon >= 2 (critical damping included) X' has no zero after the start: the mass returns without passing X = 0.

>>> from asymptotics.numbers import parse_real
>>> linear_turning_points(parse_real("1/5", "epsilon"), 2, 12, times=True).points[1]
TurningPoint(n=1, x='-0.729247614288', tau='3.15741941700')
>>> linear_turning_points(parse_real("2", "epsilon"), 2, 12).ended
{'n': 0, 'reason': 'overdamped'}
"""

from flint import arb

from asymptotics.errors import InputError
from asymptotics.numbers.decimals import certified_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.swing.ends import OVERDAMPED
from asymptotics.turning.quadratic import TurningPoint, TurningPoints, require_counts


def linear_turning_points(
    epsilon: ExactReal, count: int, digits: int = 30, *, start: int = 0, times: bool = False
) -> TurningPoints:
    """Turning points n = start ... start + count - 1; all digits are correctly rounded.

    Raises InputError for a negative epsilon.
    """
    require_counts(count, digits, start)
    if epsilon < 0:
        raise InputError("epsilon", f"{epsilon} is negative: the amplitude grows", "a number >= 0")
    oscillates = epsilon < 2
    numbers = range(start, start + count) if oscillates else range(start, min(start + count, 1))
    points = tuple(_point(epsilon, n, digits, times) for n in numbers)
    ended = None if oscillates else {"n": 0, "reason": OVERDAMPED}
    return TurningPoints("1", str(epsilon), digits, points, "closed form, certified", True, ended)


def _point(epsilon: ExactReal, n: int, digits: int, times: bool) -> TurningPoint:
    if n == 0:
        return TurningPoint(0, certified_decimal(lambda: arb(1), digits), "0" if times else None)

    def frequency() -> arb:
        return (1 - (epsilon.ball() / 2) ** 2).sqrt()

    x = certified_decimal(lambda: (-n * arb.pi() * epsilon.ball() / 2 / frequency()).exp() * (-1) ** n, digits)
    tau = certified_decimal(lambda: n * arb.pi() / frequency(), digits) if times else None
    return TurningPoint(n, x, tau)
