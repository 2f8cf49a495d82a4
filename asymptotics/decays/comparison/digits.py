"""How right a value is.

The number of right digits is -log10 |given - value|/|value|, never below 0, and 0 for a value of the wrong sign.  It is
never above what the certified value itself has.  A digit counts as wrong when the value, rounded to it, is not within
half a unit of it.

>>> right_digits(Fraction("0.4107"), Fraction("0.41071968606103944670"), 20)
'4.32'
>>> right_digits(Fraction("-0.5"), Fraction("0.5"), 20), right_digits(Fraction("0.5"), Fraction("0.5"), 20)
('0.00', '20.00')
>>> marked("0.41072111", Fraction("0.41071968606103944670")), marked("-1.25e-3", Fraction("-0.00125004"))
('0.41072[111]', '-1.25e-3')
"""

import re
from dataclasses import dataclass
from fractions import Fraction
from math import floor, log10

from asymptotics.numbers.double_error import DoubleError
from asymptotics.present.counts import many

_NUMBER = re.compile(r"(?P<sign>[+-]?)(?P<digits>[\d.]+)(?P<rest>.*)\Z", re.DOTALL)
_NEAR, _LOG_2 = 1e-9, log10(2)
"""Logarithms nearer than this to a whole number are decided in integers: a double has them to 1e-16 of their size,
which is less than this for numbers of a million digits."""

Ratio = tuple[int, int]
"""A numerator and a positive denominator, not in lowest terms: a common divisor costs more than all the rest."""


@dataclass(frozen=True, slots=True)
class JudgedValue:
    """One value judged: its right ``digits``, its relative ``error``, and its wrong digits ``marked``."""

    digits: str
    error: str
    marked: str


def judged(text: str, given: Fraction, value: Fraction, known: int, double: DoubleError | None = None) -> JudgedValue:
    """The right digits, the relative error (two digits; 1 beside a value 0) and the text with its wrong digits marked.

    ``double``: of a double the error that it may have, within which no digit is wrong.

    >>> judged("0.41072111", Fraction("0.41072111"), Fraction("0.41071968606103944670"), 20)
    JudgedValue(digits='5.46', error='3.5e-06', marked='0.41072[111]')
    >>> judged("0.30000000000000004", Fraction("0.30000000000000004"), Fraction("0.3"), 20).marked
    '0.3000000000000000[4]'
    >>> double = DoubleError(Fraction("2.3e-16"), relative=True)
    >>> judged("0.30000000000000004", Fraction("0.30000000000000004"), Fraction("0.3"), 20, double).marked
    '0.30000000000000004'
    """
    error = _difference(given, value)
    # An error of 0 has no logarithm: the value is right to all digits that are known.
    if error[0] == 0:
        return JudgedValue(f"{known:.2f}", "0", text.strip())
    log, size = _log10(error), _log10(_size(value)) if value else 0.0
    right = double is not None and double.allows(given, value)
    marks = text.strip() if right else _marked(text, given, error, log)
    return JudgedValue(_digits(given, value, known, log, size), _error(value, log, size), marks)


def right_digits(given: Fraction, value: Fraction, known: int) -> str:
    """-log10 of the relative error with two decimals, between 0 and ``known``, the digits that ``value`` has."""
    return judged("", given, value, known).digits


def marked(given: str, value: Fraction) -> str:
    """What was given, with the digits that are wrong in brackets."""
    if not _NUMBER.match(given.strip()):
        return given.strip()
    return judged(given, Fraction(given), value, 0).marked


def significant(text: str) -> int:
    """The number of significant digits written."""
    found = _NUMBER.match(text.strip())
    return _written(found) if found else 0


def _written(found: re.Match[str]) -> int:
    return len(found["digits"].replace(".", "").lstrip("0"))


def _digits(given: Fraction, value: Fraction, known: int, log: float, size: float) -> str:
    """From log10 of the error and of the value."""
    if given.numerator * value.numerator <= 0:  # the wrong sign, or one of the two is 0
        return "0.00"
    return f"{min(max(size - log, 0.0), float(known)):.2f}"


def _error(value: Fraction, log: float, size: float) -> str:
    if not value:
        return "1.0e+00"
    # An error of exactly a power of ten may have a logarithm just below it; where it does lie below, two digits are the
    # same.
    exponent = floor(log - size + 1e-12)
    tens = round(10 ** (log - size - exponent + 1))
    # 9.96 rounds to two digits as 10.
    return f"{tens // 10}.{tens % 10}e{exponent:+03d}" if tens < 100 else f"1.0e{exponent + 1:+03d}"


def _marked(given: str, number: Fraction, error: Ratio, log: float) -> str:
    text = given.strip()
    found = _NUMBER.match(text)
    if not found:
        return text
    written = _written(found)
    wanted, shown = _right_places(number, error, log, written), ""
    # All digits that are written are right: nothing is marked.
    if wanted == written:
        return text
    seen, started = 0, False
    for place, letter in enumerate(found["digits"]):
        # Zeros at the front, and the point, are no significant digits.
        started = started or letter not in "0."
        if seen == wanted and started and letter != ".":
            shown = found["digits"][:place] + "[" + found["digits"][place:] + "]"
            break
        seen += started and letter != "."
    return found["sign"] + (shown or found["digits"]) + found["rest"]


def _right_places(given: Fraction, error: Ratio, log: float, written: int) -> int:
    """How many of the digits written are right: the error, > 0, is within half a unit of the last of them."""
    if not given:
        return 0
    # With k right digits half a unit of the last is 10^(top + 1 - k)/2: the largest k for which the error is not above
    # it.
    top = _floor_log10(_size(given))
    exact = top - log - _LOG_2 + 1
    right = floor(exact)
    if abs(exact - round(exact)) < _NEAR:  # a double cannot tell
        right = round(exact)
        # Twice the error against a power of ten, in integers: a value on the very tie counts as right.
        right -= not _at_most((2 * error[0], error[1]), top + 1 - right)
    return min(max(right, 0), written)


def _difference(a: Fraction, b: Fraction) -> Ratio:
    """The distance |a - b| as an exact ratio, not reduced."""
    return abs(a.numerator * b.denominator - b.numerator * a.denominator), a.denominator * b.denominator


def _size(q: Fraction) -> Ratio:
    return abs(q.numerator), q.denominator


def _log10(q: Ratio) -> float:
    """log10 of a positive rational of any size."""
    return log10(q[0]) - log10(q[1])


def _floor_log10(q: Ratio) -> int:
    log = _log10(q)
    if abs(log - round(log)) > _NEAR:
        return floor(log)
    return round(log) - (not _at_least(q, round(log)))


def _at_most(q: Ratio, power: int) -> bool:
    """Whether q <= 10^power, decided in integers."""
    up, down = _powers(power)
    return q[0] * down <= q[1] * up


def _at_least(q: Ratio, power: int) -> bool:
    """Whether q >= 10^power, decided in integers."""
    up, down = _powers(power)
    return q[0] * down >= q[1] * up


def _powers(power: int) -> Ratio:
    """10^power as a quotient of integers."""
    tens: int = 10 ** abs(power)
    return (tens, 1) if power >= 0 else (1, tens)


def right_in_words(right: int, values: int) -> str:
    """How many values are right in every digit.

    >>> right_in_words(0, 1), right_in_words(5, 6)
    ('0 of 1 value is right in every digit written', '5 of 6 values are right in every digit written')
    """
    return f"{right} of {many(values, 'value')} {'is' if values == 1 else 'are'} right in every digit written"
