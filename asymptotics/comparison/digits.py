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
from math import log10

_NUMBER = re.compile(r"(?P<sign>[+-]?)(?P<digits>[\d.]+)(?P<rest>.*)\Z", re.DOTALL)


def right_digits(given: Fraction, value: Fraction, known: int) -> str:
    """-log10 of the relative error with two decimals, between 0 and ``known``, the digits that ``value`` has."""
    if given == value:
        return f"{known:.2f}"
    if given * value <= 0:  # the wrong sign, or one of the two is 0
        return "0.00"
    return f"{min(max(-_log10(relative_error(given, value)), 0.0), float(known)):.2f}"


def relative_error(given: Fraction, value: Fraction) -> Fraction:
    """|given - value|/|value|; 1 for a value that is 0 while the given one is not."""
    if given == value:
        return Fraction(0)
    return abs(given - value) / abs(value) if value else Fraction(1)


def short(error: Fraction) -> str:
    """An error to two digits: 3.4e-09."""
    if error == 0:
        return "0"
    exponent = _floor_log10(error)
    tens = round(error / Fraction(10) ** (exponent - 1))
    if tens == 100:
        tens, exponent = 10, exponent + 1
    return f"{tens // 10}.{tens % 10}e{exponent:+03d}"


def significant(text: str) -> int:
    """The number of significant digits written."""
    found = _NUMBER.match(text.strip())
    return len(found["digits"].replace(".", "").lstrip("0")) if found else 0


def marked(given: str, value: Fraction) -> str:
    """What was given, with the digits that are wrong in brackets."""
    text = given.strip()
    found = _NUMBER.match(text)
    if not found:
        return text
    wanted, number = _right_places(Fraction(text), value, significant(text)), ""
    seen, started = 0, False
    for place, letter in enumerate(found["digits"]):
        started = started or letter not in "0."
        if seen == wanted and started and letter != ".":
            number = found["digits"][:place] + "[" + found["digits"][place:] + "]"
            break
        seen += started and letter != "."
    return found["sign"] + (number or found["digits"]) + found["rest"]


def _right_places(given: Fraction, value: Fraction, written: int) -> int:
    """How many of the digits written are right: the error is within half a unit of the last of them."""
    error = abs(given - value)
    if error == 0 or not given:
        return written if error == 0 else 0
    top = _floor_log10(abs(given))
    right = 0
    while right < written and 2 * error <= Fraction(10) ** (top - right):
        right += 1
    return right


def _log10(q: Fraction) -> float:
    """log10 of a positive rational of any size."""
    shift = q.numerator.bit_length() - q.denominator.bit_length()
    scaled = q / (Fraction(2) ** shift)
    return log10(scaled) + shift * log10(2)


def _floor_log10(q: Fraction) -> int:
    guess = int(_log10(q)) - 1
    while Fraction(10) ** (guess + 1) <= q:
        guess += 1
    return guess
