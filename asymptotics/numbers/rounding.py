"""Directed roundings: to the nearest decimal, toward or away from zero, down or up the line, or both ends.

========  ===========================================
nearest   the nearest decimal, ties to the even digit
down      toward zero
up        away from zero
floor     not above the value
ceil      not below the value
interval  [floor, ceil]: the value lies between
========  ===========================================

>>> [rounded_rational(Fraction(-2, 3), 3, mode) for mode in MODES]
['-0.667', '-0.666', '-0.667', '-0.667', '-0.666', '[-0.667, -0.666]']

A certified decimal with more digits than are wanted proves that the value lies within half a unit of its last digit; if
all that lies there rounds alike, the rounding is proved, otherwise nothing is said:

>>> rounded_decimal("0.12345", 3, "floor"), rounded_decimal("0.12300", 3, "floor")
('0.123', None)
"""

from fractions import Fraction
from math import ceil, floor, trunc

from flint import fmpz

from asymptotics.errors import require_choice
from asymptotics.numbers.decimals import rational_decimal
from asymptotics.numbers.rationals import decimal_fraction

MODES = ("nearest", "down", "up", "floor", "ceil", "interval")


def require_mode(mode: str) -> None:
    """InputError unless the mode is one of ``MODES``."""
    require_choice(mode, "rounding", MODES)


def rounded_rational(q: Fraction, digits: int, mode: str) -> str:
    """A rational number rounded to ``digits`` significant digits."""
    require_mode(mode)
    if mode == "nearest" or not q:
        return rational_decimal(q, digits)
    if mode == "interval":
        return f"[{rounded_rational(q, digits, 'floor')}, {rounded_rational(q, digits, 'ceil')}]"
    unit = _unit(q, digits)
    away = floor if q < 0 else ceil
    n = {"down": trunc, "up": away, "floor": floor, "ceil": ceil}[mode](q / unit)
    return rational_decimal(n * unit, digits)


def rounded_decimal(text: str, digits: int, mode: str) -> str | None:
    """A correctly rounded decimal to fewer digits, or None if its digits do not decide that rounding."""
    if text == "0":
        return "0"
    value, half = decimal_fraction(text), half_unit(text)
    # Each mode is monotone: where both ends of what the digits allow round alike, so does the number between them.
    ends = {rounded_rational(end, digits, mode) for end in (value - half, value + half)}
    return ends.pop() if len(ends) == 1 else None


def half_unit(text: str) -> Fraction:
    """Half a unit of the last digit that is written.

    >>> half_unit("0.123"), half_unit("1.2e5")
    (Fraction(1, 2000), Fraction(5000, 1))
    """
    mantissa, _, exponent = text.lower().partition("e")
    places = len(mantissa.partition(".")[2]) - int(exponent or 0)
    return Fraction(1, 2) / Fraction(10) ** places


def _unit(q: Fraction, digits: int) -> Fraction:
    """The power of ten that is one unit of the last of ``digits`` significant digits of q."""
    # |q| > 10^(difference of the lengths - 1), so that this start is too small by one at least and the loop stops at
    # the first unit that leaves no more than ``digits`` digits.
    # Lengths by FLINT, since Python writes no integer of more than 4300 digits.
    exponent = len(str(fmpz(abs(q.numerator)))) - len(str(fmpz(q.denominator))) - digits - 1
    unit = Fraction(10) ** exponent
    while abs(q) >= unit * 10**digits:
        unit *= 10
    return unit
