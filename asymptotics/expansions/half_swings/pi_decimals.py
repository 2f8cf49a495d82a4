"""Numbers of Q[pi, 1/pi] as coefficients: the decimal, correctly rounded, beside the exact form.

>>> from asymptotics.expansions.half_swings.pi_ring import PI
>>> exact_coefficient(4 / (3 * PI), 12), exact_coefficient(2, 3)
(Coefficient(value='0.424413181578', expression=4/(3*pi)), Coefficient(value='2.00', expression=2))
"""

from typing import Any

from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.numbers.decimals import certified_decimal, rational_decimal
from asymptotics.numbers.rationals import to_fraction
from asymptotics.numbers.value import Coefficient


def pi_number(c: Any) -> PiNumber:
    """A rational (int or fmpq), or a number of the ring, as a number of the ring."""
    return c if isinstance(c, PiNumber) else PiNumber.rational(c)


def exact_decimal(number: PiNumber, digits: int) -> str:
    """Rationals by integer arithmetic, which also decides ties; anything with pi is irrational and never ties."""
    if number.is_rational:
        return rational_decimal(to_fraction(number.as_rational()), digits)
    return certified_decimal(number.ball, digits)


def exact_coefficient(c: Any, digits: int) -> Coefficient:
    """The decimal and the exact form of a rational or of a number of the ring."""
    number = pi_number(c)
    return Coefficient(exact_decimal(number, digits), number.closed())
