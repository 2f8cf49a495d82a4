"""From balls to a MotionPoint whose digits are all proved, at whatever precision that takes.

>>> certified_point(lambda: (arb.pi(), arb(0)), 5, "a test").to_dict()["error"]
'0.000050'
>>> time_of("-1")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument time: -1 is before the start, ... (accepted: a time >= 0 in seconds)
"""

from collections.abc import Callable
from fractions import Fraction

from flint import arb, ctx

from asymptotics.errors import InputError, UndecidedError
from asymptotics.motions.result import MotionPoint
from asymptotics.numbers.decimals import bits_for, decimal_of_ball, rational_decimal
from asymptotics.numbers.exact import ExactReal, require_integer
from asymptotics.numbers.policy import Number, exact_number

MAX_BITS, MAX_DIGITS = 1 << 16, 10_000


def time_of(t: Number) -> ExactReal:
    """A time as an exact number; InputError for t < 0: the state is given at t = 0, and friction cannot be undone."""
    moment = exact_number(t, "time")
    if moment < 0:
        raise InputError("time", f"{moment} is before the start, where the state is given", "a time >= 0 in seconds")
    return moment


def certified_values(evaluate: Callable[[], tuple[arb, arb]], digits: int) -> tuple[str, str]:
    """Both numbers to ``digits`` digits, correctly rounded; UndecidedError at the last precision."""
    require_integer(digits, "digits", 1, MAX_DIGITS)
    bits = bits_for(digits, 48)
    while bits <= MAX_BITS:
        with ctx.workprec(bits):
            try:
                texts = [decimal_of_ball(value, digits) for value in evaluate()]
                reason = "the enclosure is too wide"
            except UndecidedError as undecided:
                texts, reason = [None], str(undecided)
        if all(text is not None for text in texts):
            return str(texts[0]), str(texts[1])
        bits *= 2
    raise UndecidedError(f"no certified {digits} digits at {bits // 2} bits: {reason}")


def certified_point(evaluate: Callable[[], tuple[arb, arb]], digits: int, method: str) -> MotionPoint:
    """x and v as a MotionPoint; ``error`` is half a unit of the last digit of x."""
    x, v = certified_values(evaluate, digits)
    return MotionPoint(x, v, None, None, None, None, method, half_unit(x, digits), True)


def half_unit(text: str, digits: int) -> str:
    """Half a unit of the last of ``digits`` significant digits.

    >>> half_unit("0.0012300", 5), half_unit("0", 5)
    ('5.0e-8', '0')
    """
    value = abs(Fraction(text))
    if not value:
        return "0"
    exponent = 0
    while value >= 10:
        value, exponent = value / 10, exponent + 1
    while value < 1:
        value, exponent = value * 10, exponent - 1
    return rational_decimal(Fraction(5) * Fraction(10) ** (exponent - digits), 2)
