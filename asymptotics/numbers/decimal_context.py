"""The door of ``numbers.context`` for mpmath: its precision, and that of its intervals, are the process's as well.

>>> with workdps(30):
...     mpmath.mp.dps
30
"""

from collections.abc import Iterator
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

import mpmath
from mpmath.libmp import from_rational, round_nearest

from asymptotics.numbers.context import Setting, alone
from asymptotics.numbers.exact import ExactReal

# A child that is forked while another thread works sets these back as well.
alone.guarded += [(mpmath.mp, "prec"), (mpmath.iv, "prec")]


@contextmanager
def workdps(digits: int) -> Iterator[None]:
    """``mpmath.workdps``, alone."""
    # Left in the opposite order: the digits are set back first, the lock is released last.
    with alone, mpmath.workdps(digits):
        yield


def intervals(bits: int) -> Setting:
    """``with intervals(bits):`` intervals of mpmath at that many bits."""
    return Setting(mpmath.iv, "prec", bits)


def mpf_of(q: Fraction, digits: int) -> Any:
    """q as a number of mpmath with so many digits."""
    with workdps(digits):
        # As mpmath reads a text, but for the limit of Python: the quotient of two integers, rounded once.
        return mpmath.mp.make_mpf(from_rational(q.numerator, q.denominator, mpmath.mp.prec, round_nearest))


def between(low: Fraction, high: Fraction) -> Any:
    """An interval that holds both numbers, at the precision in force.

    >>> between(Fraction(1, 4), Fraction(1, 2))
    mpi('0.25', '0.5')
    """
    return mpmath.iv.mpf([_of_fraction(low).a, _of_fraction(high).b])


def interval(number: ExactReal) -> Any:
    """An interval that holds an exact number, at the precision in force."""
    q, r, b = (_of_fraction(part) for part in (number.coefficient, number.radicand, number.offset))
    return q * mpmath.iv.sqrt(r) + b


def _of_fraction(q: Fraction) -> Any:
    return mpmath.iv.mpf(q.numerator) / q.denominator
