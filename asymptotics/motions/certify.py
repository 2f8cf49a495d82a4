"""From balls to a MotionPoint whose digits are all proved, at whatever precision that takes.

>>> certified_point(lambda: (arb.pi(), arb(0)), 5, "a test").to_dict()["error"]
'0.000050'
>>> time_of("-1")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument time: -1 is before the start, ... (accepted: a time >= 0, ...)
"""

from collections.abc import Callable
from fractions import Fraction

from flint import arb

from asymptotics.errors import InputError
from asymptotics.motions.point import MotionPoint
from asymptotics.numbers.decimals import bits_for, decimal_of, rational_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.integers import require_integer
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.numbers.precision import at_growing_precision
from asymptotics.numbers.rationals import decimal_fraction

# 65536 bits are 19728 digits: a value that is not rounded by then is 0 or next to a tie, and UndecidedError says so.
MAX_BITS, MAX_DIGITS = 1 << 16, 10_000
Pair = tuple[arb | ExactReal, arb | ExactReal]


def time_of(t: Number, name: str = "time") -> ExactReal:
    """A time as an exact number; InputError for t < 0: the state is given at t = 0, and friction cannot be undone."""
    moment = exact_number(t, name)
    if moment < 0:
        raise InputError(
            name,
            f"{moment} is before the start, where the state is given",
            "a time >= 0, in s, of a law alone in 1/omega_0",
        )
    return moment


def certified_values(evaluate: Callable[[], Pair], digits: int) -> tuple[str, str]:
    """Both numbers, balls or exact, to ``digits`` digits, correctly rounded; UndecidedError at the last precision."""
    require_integer(digits, "digits", 1, MAX_DIGITS)

    def attempt(_bits: int) -> tuple[str, str] | None:
        x, v = (decimal_of(value, digits) for value in evaluate())
        return None if x is None or v is None else (x, v)

    return at_growing_precision(attempt, digits, bits_for(digits, 48), max_bits=MAX_BITS)


def certified_point(evaluate: Callable[[], Pair], digits: int, method: str) -> MotionPoint:
    """x and v as a MotionPoint; ``error`` is half a unit of the last digit of x."""
    x, v = certified_values(evaluate, digits)
    return MotionPoint(x, v, None, None, None, None, method, half_unit(x, digits), True)


def half_unit(text: str, digits: int) -> str:
    """Half a unit of the last of ``digits`` significant digits.

    >>> half_unit("0.0012300", 5), half_unit("0", 5)
    ('5.0e-8', '0')
    """
    value = abs(decimal_fraction(text))
    if not value:
        return "0"
    exponent = 0
    while value >= 10:
        value, exponent = value / 10, exponent + 1
    while value < 1:
        value, exponent = value * 10, exponent - 1
    return rational_decimal(Fraction(5) * Fraction(10) ** (exponent - digits), 2)
