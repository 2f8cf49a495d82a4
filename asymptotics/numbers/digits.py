"""What correctly rounded digits say: the number is within half a unit of the last of them.

>>> ends("0.3333"), ends("0")                          # 0 is written for zero itself
((Fraction(1333, 4000), Fraction(6667, 20000)), (Fraction(0, 1), Fraction(0, 1)))
>>> interval_of("0.3333"), ball_of("0.3333").contains(arb(1) / 3)
(mpi('0.33325', '0.33335'), True)
>>> spread("x", ["0.3333", None])["x"], spread("x", ["0.3333"], certified=False)["x_low"]
([0.3333, None], [None])
"""

from collections.abc import Sequence
from fractions import Fraction
from math import inf, nextafter
from typing import Any

from flint import arb, fmpq

from asymptotics.numbers.rationals import decimal_fraction


def ends(text: str) -> tuple[Fraction, Fraction]:
    """Both ends of the interval of the numbers that round to these digits, exactly."""
    value = decimal_fraction(text)
    # "0" is printed for the number 0 alone (``decimals``): it has no last digit, and no half unit to either side.
    if text == "0":
        return value, value
    mantissa, _, exponent = text.partition("e")
    half = Fraction(10) ** (int(exponent or 0) - len(mantissa.partition(".")[2])) / 2
    return value - half, value + half


def interval_of(text: str) -> Any:
    """An mpmath interval that contains the number: the digits, half a unit in the last place either way."""
    from asymptotics.numbers.decimal_context import between, intervals  # noqa: PLC0415 (mpmath, which few ask for)

    # log2(10) < 4 bits a digit. mpmath rounds either end outward, so that fewer bits would be wider and not wrong.
    with intervals(4 * len(text) + 32):
        return between(*ends(text))


def ball_of(text: str) -> arb:
    """The same as a ball of python-flint, at the precision in force."""
    low, high = (arb(fmpq(q.numerator, q.denominator)) for q in ends(text))
    # The ball of both ends, each enclosed, holds what lies between.
    return low.union(high)


def spread(name: str, texts: Sequence[str | None], *, certified: bool = True) -> dict[str, list[Any]]:
    """Columns of a data frame for digits: the doubles, both ends as doubles rounded outwards, all digits as text.

    An estimate (``certified`` False) has no ends.
    """
    known = [ends(text) if certified and text is not None else None for text in texts]
    return {
        name: [None if text is None else float(text) for text in texts],
        f"{name}_low": [None if e is None else outward(e[0], -1) for e in known],
        f"{name}_high": [None if e is None else outward(e[1], 1) for e in known],
        f"{name}_digits": list(texts),
    }


def outward(q: Fraction, side: int) -> float:
    """The double next to q that is <= q (``side`` = -1) or >= q (``side`` = 1).

    >>> outward(Fraction(1, 3), -1) < Fraction(1, 3) < outward(Fraction(1, 3), 1), outward(Fraction(10) ** 400, 1)
    (True, inf)
    """
    try:
        near = float(q)
    except OverflowError:
        # Beyond the doubles the next one outward is infinity; inward it is the largest double.
        return side * inf if side * q > 0 else -side * nextafter(inf, 0.0)
    # The nearest double is off by less than a step, and the comparison is one of fractions: one step passes q.
    return near if (Fraction(near) - q) * side >= 0 else nextafter(near, side * inf)
