"""Whole numbers as they are typed or handed in: counts, orders, digits, in a range or refused by name."""

import re
from fractions import Fraction
from operator import index

from asymptotics.errors import InputError, shown

_INTEGER = re.compile(r"[+-]?\d{1,40}\Z", re.ASCII)
# An exponent of two digits: 1e400 is no way to write a count.
_DECIMAL = re.compile(r"[+-]?\d{1,60}(?:\.\d{0,60})?(?:[eE][+-]?\d{1,2})?", re.ASCII)


def require_integer(value: object, argument: str, low: int, high: int) -> int:
    """The one contract for counts, orders, starts and digits: an int in [low, high], or InputError by name.

    >>> require_integer(True, "digits", 1, 100)
    Traceback (most recent call last):
        ...
    asymptotics.errors.InputError: argument digits: True is a bool, not an integer (accepted: ... from 1 to 100)
    """
    accepted = f"an integer from {low} to {high}"
    try:
        number = index(value)  # type: ignore[arg-type]
    except TypeError:
        raise InputError(argument, f"{shown(value)} is not an integer", accepted) from None
    if isinstance(value, bool):
        raise InputError(argument, f"{value} is a bool, not an integer", accepted)
    if not low <= number <= high:
        raise InputError(argument, f"{_shown_integer(number)} is out of range", accepted)
    return number


def _shown_integer(number: int) -> str:
    """An integer of any size: Python refuses to print one of more than 4300 digits."""
    return str(number) if abs(number) < 10**40 else f"an integer of {number.bit_length()} bits"


def parse_integer(text: str, argument: str, low: int, high: int) -> int:
    """Read an integer in [low, high], also as ``numpy.savetxt`` writes it; InputError names ``argument`` otherwise.

    >>> parse_integer("12", "--n", 1, 100), parse_integer("1.200000000000000000e+01", "--n", 1, 100)
    (12, 12)
    """
    accepted = f"an integer from {low} to {high}"
    number = text.strip()
    whole = bool(_INTEGER.match(number))
    value = int(number) if whole else 0
    if not whole and _DECIMAL.fullmatch(number):
        written = Fraction(number)
        whole, value = written.denominator == 1, written.numerator
    if not whole:
        raise InputError(argument, f"{shown_text(text)} is not an integer", accepted)
    if not low <= value <= high:
        raise InputError(argument, f"{value} is out of range", accepted)
    return value


def shown_text(text: str) -> str:
    """The offending text for a one-line message: quoted, and cut if long."""
    return repr(text if len(text) <= 60 else text[:57] + "...")
