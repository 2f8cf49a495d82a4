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
from fractions import Fraction
from math import floor, log10

_NUMBER = re.compile(r"(?P<sign>[+-]?)(?P<digits>[\d.]+)(?P<rest>.*)\Z", re.DOTALL)
_NEAR = 1e-9


def right_digits(given: Fraction, value: Fraction, known: int) -> str:
    """-log10 of the relative error with two decimals, between 0 and ``known``, the digits that ``value`` has."""
    if given == value:
        return f"{known:.2f}"
    if given * value <= 0:  # the wrong sign, or one of the two is 0
        return "0.00"
    return f"{min(max(_log10(abs(value)) - _log10(abs(given - value)), 0.0), float(known)):.2f}"


def relative_error(given: Fraction, value: Fraction) -> str:
    """|given - value|/|value| to two digits; 1 for a value that is 0 while the given one is not.

    >>> relative_error(Fraction("1.00123"), Fraction(1)), relative_error(Fraction(2), Fraction(2))
    ('1.2e-03', '0')
    """
    if given == value:
        return "0"
    if not value:
        return "1.0e+00"
    log = _log10(abs(given - value)) - _log10(abs(value))
    exponent = floor(log + 1e-12)
    tens = round(10 ** (log - exponent + 1))
    return f"{tens // 10}.{tens % 10}e{exponent:+03d}" if tens < 100 else f"1.0e{exponent + 1:+03d}"


def significant(text: str) -> int:
    """The number of significant digits written."""
    found = _NUMBER.match(text.strip())
    return len(found["digits"].replace(".", "").lstrip("0")) if found else 0


def marked(given: str, value: Fraction, number: Fraction | None = None) -> str:
    """What was given, with the digits that are wrong in brackets; ``number`` is what it says, if that is known."""
    text = given.strip()
    found = _NUMBER.match(text)
    if not found:
        return text
    written = significant(text)
    wanted, shown = _right_places(Fraction(text) if number is None else number, value, written), ""
    if wanted == written:
        return text
    seen, started = 0, False
    for place, letter in enumerate(found["digits"]):
        started = started or letter not in "0."
        if seen == wanted and started and letter != ".":
            shown = found["digits"][:place] + "[" + found["digits"][place:] + "]"
            break
        seen += started and letter != "."
    return found["sign"] + (shown or found["digits"]) + found["rest"]


def _right_places(given: Fraction, value: Fraction, written: int) -> int:
    """How many of the digits written are right: the error is within half a unit of the last of them."""
    error = abs(given - value)
    if error == 0 or not given:
        return written if error == 0 else 0
    exact = _floor_log10(abs(given)) - _log10(2 * error) + 1
    right = floor(exact)
    if abs(exact - round(exact)) < _NEAR:  # a double cannot tell
        top = _floor_log10(abs(given))
        right = round(exact)
        right -= 2 * error > Fraction(10) ** (top + 1 - right)
    return min(max(right, 0), written)


def _log10(q: Fraction) -> float:
    """log10 of a positive rational of any size."""
    return log10(q.numerator) - log10(q.denominator)


def _floor_log10(q: Fraction) -> int:
    log = _log10(q)
    if abs(log - round(log)) > _NEAR:
        return floor(log)
    return round(log) - (q < Fraction(10) ** round(log))
