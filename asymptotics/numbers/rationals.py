"""Fraction <-> fmpq and ball -> exact rational bounds: the part of the bridge that needs no SymPy.

>>> to_fmpq(Fraction(1, 3)), to_fraction(fmpq(1, 3))
(1/3, Fraction(1, 3))
>>> low, high = bounds(arb(2).sqrt())
>>> low**2 < 2 < high**2
True
"""

from decimal import Decimal
from fractions import Fraction

from flint import arb, fmpq, fmpz


def decimal_fraction(text: str) -> Fraction:
    """A decimal of any length, exactly: where Python reads an integer itself it stops at 4300 digits.

    >>> decimal_fraction("-1.5e-3"), decimal_fraction("1" * 5000) % 100
    (Fraction(-3, 2000), Fraction(11, 1))
    """
    # The constructor of Decimal keeps every digit, whatever the context of decimals is.
    return Fraction(Decimal(text))


def to_fmpq(q: Fraction | int) -> fmpq:
    """Fraction or int -> fmpq, exactly."""
    return fmpq(q.numerator, q.denominator)


def to_fraction(q: fmpq) -> Fraction:
    """fmpq -> Fraction, exactly."""
    return Fraction(int(q.p), int(q.q))


def bounds(x: arb) -> tuple[Fraction, Fraction]:
    """The exact rational end points of a finite ball; ValueError if it is not finite."""
    if not x.is_finite():
        raise ValueError(f"the ball {x.str(5)} has no finite bounds")
    # Middle and radius are integers times powers of 2, and so are the ends: nothing is rounded here.
    (middle, shift), (radius, radius_shift) = x.mid().man_exp(), x.rad().man_exp()
    m, r = _dyadic(middle, shift), _dyadic(radius, radius_shift)
    return m - r, m + r


def _dyadic(mantissa: fmpz, exponent: fmpz) -> Fraction:
    m, e = int(mantissa), int(exponent)
    return Fraction(m << e) if e >= 0 else Fraction(m, 1 << -e)
