"""A power of an exact number, exactly, where it is a rational multiple of one root."""

from fractions import Fraction

from asymptotics.numbers.exact import ExactReal, square_root


def exact_power(base: ExactReal, exponent: ExactReal) -> ExactReal | None:
    """base^exponent for base > 0 when it is a rational multiple of one root, else None (not known to be one).

    >>> half = ExactReal(Fraction(1, 2))
    >>> exact_power(ExactReal(Fraction(8)), half), exact_power(half, half / 2)
    (ExactReal('sqrt(8)'), None)
    """
    if base == 1 or exponent.is_zero:
        return ExactReal(Fraction(1))
    # Beyond 1000 an exact power has too many digits to be worth it: None, and the caller goes on with a ball.
    if exponent.is_integer and abs(exponent.rational) <= 1000:
        return base ** int(exponent.rational)
    twice = exponent * 2
    if base.is_rational and twice.is_integer and abs(twice.rational) <= 1000:
        return square_root(base.rational ** int(twice.rational))
    return None
