"""How many digits are right, and which order an error has: assertions whose messages say by how much they fail.  The
order is the slope of the error on a doubly logarithmic scale, read by halving, as in Richardson's extrapolation.

>>> assert_digits("3.1416", "3.14159265358979", 5)
>>> assert_digits(3.1415, "3.14159265358979", 5, "pi")
Traceback (most recent call last):
    ...
AssertionError: pi: 3.1415 has 4.5 right digits, 5 are wanted (certified: 3.14159265358979)
>>> assert_order(lambda epsilon: 3 * epsilon**2, 2)
>>> assert_order(lambda epsilon: 3 * epsilon**2, 3)
Traceback (most recent call last):
    ...
AssertionError: the error has order 2.00, not 3: 0.0012, 0.0003, 7.5e-05 at 1/50, 1/100, 1/200
"""

from collections.abc import Callable, Sequence
from decimal import Decimal
from fractions import Fraction
from math import isfinite, log2, log10
from typing import Any

from asymptotics.errors import InputError, shown
from asymptotics.numbers.rationals import decimal_fraction

MAX_POWER = 100_000
"""Of ten, in a number that is read: further ones would take longer to write out than anybody waits."""
# Small enough that the next order changes the slope by some hundredths, large enough that a double still sees the error
# of a fourth order (10^-9): neither is needed with other strengths or more digits.
STRENGTHS = (Fraction(1, 50), Fraction(1, 100), Fraction(1, 200))


def assert_digits(value: Any, certified: str, digits: int, what: str = "value") -> None:
    """``value`` (float, text, Fraction, Decimal, mpf) agrees with the certified decimal in ``digits`` digits.

    That is |value/certified - 1| <= 10^-digits, or value = 0 where the certified value is 0.  InputError if the
    certified text has no two digits more: its own rounding, half a unit of its last digit, is then at most a twentieth
    of what is allowed.
    """
    if known_digits(certified) < digits + 2 and exactly(certified) != 0:
        raise InputError("digits", f"{digits} digits cannot be told with {certified}", "two fewer than it has")
    right = right_digits(value, certified)
    if right < digits:
        wanted = f"{digits} are wanted (certified: {certified})"
        raise AssertionError(f"{what}: {value} has {max(right, 0.0):.1f} right digits, {wanted}")


def right_digits(value: Any, certified: str) -> float:
    """-log10 |value/certified - 1|: infinite when equal, minus infinity for nan and for anything beside 0.

    >>> right_digits(0.99, "1"), right_digits(float("nan"), "1"), right_digits("1/3", "0.3333")
    (2.0, -inf, 3.9999565683801923)
    """
    try:
        given, truth = exactly(value), exactly(certified)
    except ValueError:
        return float("-inf")
    if given == truth:
        return float("inf")
    if truth == 0:
        return float("-inf")
    error = abs(given / truth - 1)
    # Logarithms of the integers: the fraction as a double would be 0 below 10^-308.
    return log10(error.denominator) - log10(error.numerator)


def exactly(value: Any) -> Fraction:
    """What a float, text, Fraction, Decimal or mpf says, with digits of any number; ValueError for nan, infinities,
    text that is no number, and powers of ten beyond 10^100000.

    >>> exactly(0.1), exactly("1/3"), exactly("0." + "3" * 5000).denominator == 10**5000
    (Fraction(1, 10), Fraction(1, 3), True)
    """
    if type(value) in (int, Fraction):
        return Fraction(value)
    try:
        # By way of text: a float is taken for the shortest decimal that means it, as everywhere (``numbers.policy``).
        number, slash, below = str(value).partition("/")
        if abs(Decimal(number).adjusted()) > MAX_POWER or (slash and not below.isdigit()):
            raise ValueError("out of range, or no number below the line")
        return decimal_fraction(number) / decimal_fraction(below or "1")
    except (ArithmeticError, ValueError) as error:
        raise ValueError(f"{shown(value)} is not a finite number") from error


def known_digits(certified: str) -> int:
    """The number of significant digits of a decimal.

    >>> known_digits("-0.00120"), known_digits("1.50e-7")
    (3, 3)
    """
    mantissa = certified.lower().partition("e")[0].lstrip("+-").replace(".", "")
    return len(mantissa.lstrip("0"))


def assert_order(
    error: Callable[[Fraction], float], order: int, strengths: Sequence[Fraction] = STRENGTHS, slack: float = 0.2
) -> None:
    """``error(strength)`` falls like strength^order as the strength is halved: the last slope is within ``slack``.

    The strengths must be halved from one to the next.  AssertionError also for errors that are 0, negative or not
    finite, from which no order can be read (take more digits or larger strengths).
    """
    if len(strengths) < 2 or any(a != 2 * b for a, b in zip(strengths, strengths[1:])):
        raise InputError("strengths", "they are not halved from one to the next", "e, e/2, e/4, ...")
    errors = [float(error(s)) for s in strengths]
    shown = f"{', '.join(f'{e:.2g}' for e in errors)} at {', '.join(map(str, strengths))}"
    if not all(isfinite(e) and e > 0 for e in errors):
        raise AssertionError(f"no order can be read from the errors {shown}")
    # Of the last two: there the next order counts least.  slack = 0.2 is what it may count: orders are 1 apart.
    slope = log2(errors[-2] / errors[-1])
    if abs(slope - order) > slack:
        raise AssertionError(f"the error has order {slope:.2f}, not {order}: {shown}")
