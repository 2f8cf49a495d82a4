"""D significant digits, correctly rounded in all of them and proved to be.

The table maker's dilemma, met by Ziv's strategy (ACM Trans. Math. Software 17, 1991): more precision until both ends of
an enclosure round alike.

A ball is read as the exact dyadic interval it is; a decimal is printed only when both ends round to it.  Until then the
precision is doubled, up to a limit, where the failure is reported as such.  Ties go to the even digit.

>>> from flint import arb
>>> certified_decimal(lambda: arb(2).sqrt(), 20)
'1.4142135623730950488'
>>> rational_decimal(Fraction(2, 3), 5), rational_decimal(Fraction(-1, 80), 3), rational_decimal(Fraction(10**30), 3)
('0.66667', '-0.0125', '1.00e30')
>>> certified_decimal(lambda: arb(2).sqrt() ** 2, 5, max_bits=4000)        # exactly 2, but a ball cannot know
'2.0000'
>>> certified_decimal(lambda: (arb(2).sqrt() ** 2 - 2), 5, max_bits=4000)  # zero has no first significant digit
Traceback (most recent call last):
    ...
asymptotics.errors.UndecidedError: no certified 5 digits at 4000 bits: the enclosure is [+/- ...]
"""

from collections.abc import Callable
from fractions import Fraction
from math import floor, log2

from flint import arb, fmpz

from asymptotics.errors import LimitError
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.integers import require_integer
from asymptotics.numbers.precision import TooWideError, at_growing_precision

BITS_PER_DIGIT = log2(10)
# A million bits hold 315,652 digits. What is not decided there (a tie, a zero that no ball tells) is refused, so that
# half or twice as much moves the refusal and no digit.
MAX_BITS = 1 << 20
MAX_DIGITS = 300_000  # what MAX_BITS can hold
MAX_EXPONENT = 1 << 24  # beyond it the decimal expansion alone would fill the memory


def bits_for(digits: int, guard: int = 32) -> int:
    """Working precision in bits for ``digits`` decimal digits and a guard."""
    # The guard is a matter of speed: an enclosure that it does not cover is refused and asked for again at more bits.
    return int(digits * BITS_PER_DIGIT) + guard


def certified_decimal(evaluate: Callable[[], arb | ExactReal], digits: int, *, max_bits: int = MAX_BITS) -> str:
    """The number that ``evaluate`` encloses at the current precision, to ``digits`` significant digits.

    ``evaluate`` is called at growing precision until the rounding is decided.  Raises UndecidedError at ``max_bits``;
    a rational number that lies on a tie between two decimals is told only where it is given as an exact number.
    """
    require_integer(digits, "digits", 1, MAX_DIGITS)

    def attempt(_bits: int) -> str:
        found = evaluate()
        text = decimal_of(found, digits)
        if text is None:
            raise TooWideError("the enclosure is " + (found if isinstance(found, arb) else found.ball()).str(5))
        return text

    return at_growing_precision(attempt, digits, bits_for(digits), max_bits=max_bits)


def decimal_of(value: arb | ExactReal, digits: int) -> str | None:
    """The rounding of a ball, or of an exact number, whose ties and zeros no ball could tell.

    >>> tie = Fraction(1, 80)
    >>> decimal_of(ExactReal(tie), 2), decimal_of(ExactReal(tie).ball(), 2), decimal_of(ExactReal(0), 2)
    ('0.012', None, '0')
    """
    if isinstance(value, arb):
        return decimal_of_ball(value, digits)
    return rational_decimal(value.rational, digits) if value.is_rational else decimal_of_ball(value.ball(), digits)


def decimal_of_ball(ball: arb, digits: int) -> str | None:
    """The common rounding of all numbers in the ball to ``digits`` significant digits, or None if there is none.

    >>> decimal_of_ball(arb(1) / 3, 10), decimal_of_ball(arb(1) / 3, 100)
    ('0.3333333333', None)
    """
    require_integer(digits, "digits", 1, MAX_DIGITS)
    if not ball.is_finite():
        return None
    (middle, shift), (radius, radius_shift) = ball.mid().man_exp(), ball.rad().man_exp()
    # |middle| < 2^(shift + its length) and radius >= 2^(radius_shift + its length - 1): here the radius is the larger.
    if radius and (not middle or int(radius_shift) + radius.bit_length() > int(shift) + middle.bit_length()):
        return None  # the ball contains 0
    if middle and abs(int(shift)) > MAX_EXPONENT:
        accepted = f"magnitudes from 2^-{MAX_EXPONENT} to 2^{MAX_EXPONENT}"
        raise LimitError("magnitude", f"the result is near 2^{int(shift)}", accepted)
    # An exact ball is one dyadic number, whose rounding is decided on a tie as well.
    if radius == 0:
        return _format(*_round_dyadic(middle, int(shift), digits), digits)
    # The radius is below 2^(radius_shift + its length), which is at most the one put in its place: the interval grows.
    if radius_shift < -2 * MAX_EXPONENT:  # its ends alone would fill the memory: a wider ball will do
        radius, radius_shift = fmpz(1), fmpz(radius.bit_length() - 2 * MAX_EXPONENT)
    low_shift = min(int(shift), int(radius_shift))
    middle, radius = middle << (int(shift) - low_shift), radius << (int(radius_shift) - low_shift)
    # Rounding to nearest is monotone: where both ends round to
    # one decimal, so does every number between them (Ziv's test).
    low, high = (_round_dyadic(end, low_shift, digits) for end in (middle - radius, middle + radius))
    return _format(*low, digits) if low == high else None


def rational_decimal(q: Fraction, digits: int) -> str:
    """A rational number correctly rounded to ``digits`` significant digits; InputError for digits < 1."""
    require_integer(digits, "digits", 1, MAX_DIGITS)
    return _format(*_round_quotient(fmpz(q.numerator), fmpz(q.denominator), digits), digits)


def directed_decimal(q: Fraction, digits: int, side: int) -> str:
    """A decimal of ``digits`` significant digits next to q that is >= q (``side`` = 1) or <= q (``side`` = -1).

    >>> directed_decimal(Fraction(1, 3), 2, 1), directed_decimal(Fraction(1, 3), 2, -1)
    ('0.34', '0.33')
    """
    require_integer(digits, "digits", 1, MAX_DIGITS)
    # The nearest decimal is off by half a unit at most: where it lies on the wrong side one unit more is enough.
    n, exponent = _round_quotient(fmpz(q.numerator), fmpz(q.denominator), digits)
    shown = Fraction(int(n)) * Fraction(10) ** exponent
    return _format(n + (side if (shown - q) * side < 0 else 0), exponent, digits)


def _round_dyadic(mantissa: fmpz, shift: int, digits: int) -> tuple[fmpz, int]:
    if shift >= 0:
        return _round_quotient(mantissa << shift, fmpz(1), digits)
    return _round_quotient(mantissa, fmpz(1) << -shift, digits)


def _round_quotient(p: fmpz, q: fmpz, digits: int) -> tuple[fmpz, int]:
    """(n, k) with 10^(digits-1) <= |n| < 10^digits and n 10^k the rounding of p/q, ties to even; (0, 0) for zero."""
    if p == 0:
        return fmpz(0), 0
    sign, p = (-1, -p) if p < 0 else (1, p)
    # A little below log10(p/q) in doubles, so that this start is never above the exponent that is sought, and the first
    # one that leaves no more than the wanted digits is the right one.
    above, below = log2(int(p)), log2(int(q))
    exponent = floor((above - below - 1e-14 * (1 + above + below)) / BITS_PER_DIGIT) - digits + 1
    while True:  # mostly once, at most a few times
        scale = fmpz(10) ** abs(exponent)
        top, bottom = (p, q * scale) if exponent >= 0 else (p * scale, q)
        n, rest = divmod(top, bottom)
        # Half to even. Where this makes n = 10^digits the next
        # exponent begins again with the quotient: never two roundings.
        n += int(2 * rest > bottom or (2 * rest == bottom and n % 2 == 1))
        if n < fmpz(10) ** digits:
            return sign * n, exponent
        exponent += 1


def _format(n: fmpz, exponent: int, digits: int) -> str:
    """Positional notation for 1e-6 <= |x| < 10^digits, scientific otherwise."""
    if n == 0:
        return "0"
    sign, text = ("-" if n < 0 else ""), str(abs(n))
    point = len(text) + exponent  # the decimal point stands before text[point]
    if 0 < point <= digits:
        return sign + text[:point] + ("." + text[point:] if text[point:] else "")
    if -6 < point <= 0:
        return sign + "0." + "0" * -point + text
    return sign + text[0] + ("." + text[1:] if text[1:] else "") + f"e{point - 1}"
