"""Numbers that bound and numbers that choose: upper bounds in 53 bits, and doubles for sizes, which bound nothing.

>>> from flint import arb
>>> upper(arb(-3, 0.5)).str(5), round(size_of(arb(10) ** -400), 1)
('[3.5000 +/- ...]', -1328.8)
"""

from collections.abc import Iterable
from math import log2

from flint import arb

from asymptotics.errors import LimitError
from asymptotics.numbers.context import ctx

# 1/alpha and multiples of it are formed in doubles, which end at 1.8e308.  A smaller exponent is refused by name; no
# bound rests on the value.
_LEAST = 1e-300
_AS_CHEAP = 128  # bits
_SMALL, _LARGE = 1e-300, 1e300  # where a double has all its bits


def in_doubles(exponents: Iterable[arb]) -> tuple[float, ...]:
    """Exponents above 0, for choosing sizes; LimitError for one so small that its inverse would leave the doubles."""
    found = tuple(float(a.mid()) for a in exponents)
    if not all(a >= _LEAST for a in found):
        raise LimitError("alpha", "an exponent is above 0, but too small for a double", "0, or 1e-300 and above")
    return found


def size_of(x: arb) -> float:
    """log2 |midpoint|, also far outside the range of doubles; -inf for 0."""
    # The midpoint as a double, where it has one; elsewhere the mantissa is a whole number of any length: its
    # logarithm Python takes without a double.
    near = abs(float(x))
    if _SMALL < near < _LARGE:
        return log2(near)
    mantissa, exponent = x.mid().man_exp()
    return log2(abs(int(mantissa))) + int(exponent) if mantissa != 0 else float("-inf")


def dyadic(size: float) -> arb:
    """A dyadic number near 2^size, exact at any precision.

    >>> dyadic(-1.0), dyadic(-2000.5) == 0
    (0.500000000000000, False)
    """
    # The share of 2^size that a double holds is split off, so that the power of two may be of any size.  A factor of 53
    # bits times a power of two is exact, at whatever precision it is used later.
    whole = int(size // 1)
    with ctx.workprec(53):
        return arb(2.0 ** (size - whole)) * arb((1, whole), 0)


def upper(x: arb) -> arb:
    """An exact upper bound of |x|, short: errors are added in 53 bits."""
    # Upwards, as every bound here enters sums and products with plus signs only.  53 bits lose 2^-53 of the bound for
    # each operation, and keep additions as cheap as those of doubles; two words of a working precision are as cheap.
    if ctx.prec <= _AS_CHEAP:
        return abs(x).upper()
    with ctx.workprec(53):
        return abs(x).upper()
