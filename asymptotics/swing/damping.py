"""The law in balls, on a half-swing: the speed w >= 0, the displacement y from the centre that dry friction shifts.

    y' = -w,    w' = y - N(w),    N(w) = sum_i epsilon_i w^alpha_i over alpha_i > 0          (units: amplitude, tau)

Strengths and exponents are enclosures at the precision current when the ``Damping`` is made; the doubles beside them
choose sizes and never enter a bound.

>>> from fractions import Fraction
>>> with ctx.workprec(60):
...     law = Damping.of([(arb(1) / 10, ExactReal(Fraction(3, 2))), (arb(1) / 50, ExactReal(Fraction(0)))])
...     law.resistance(arb(4)).str(10), law.friction.str(5)
('[0.8000000000 +/- ...]', '[0.020000 +/- ...]')
"""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from math import inf, log2

from flint import arb, ctx

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.law import Law
from asymptotics.numbers.exact import ExactReal


@dataclass(frozen=True)
class Damping:
    """Strengths epsilon_i > 0 and exponents alpha_i > 0 of N(w); ``friction`` is the strength of the term alpha = 0."""

    friction: arb
    strengths: tuple[arb, ...]
    alphas: tuple[ExactReal, ...]
    exponents: tuple[arb, ...]

    @classmethod
    def of(cls, terms: list[tuple[arb, ExactReal]]) -> "Damping":
        """From (epsilon_i, alpha_i), at the current precision; terms of strength exactly 0 are dropped.

        UndecidedError for a strength that is not told from 0.
        """
        if any(e.contains(0) and not e == 0 for e, _ in terms):
            raise UndecidedError("a strength is not told from 0 at this precision")
        friction = sum((e for e, a in terms if not a > 0), arb(0))
        moving = [(e, a) for e, a in terms if a > 0 and e != 0]
        strengths, alphas = (tuple(column) for column in zip(*moving)) if moving else ((), ())
        return cls(friction, strengths, alphas, tuple(a.ball() for a in alphas))

    @classmethod
    def of_law(cls, law: Law) -> "Damping":
        """From a dimensionless law of powers of the velocity (InputError for any other), at the current precision."""
        law.require_pure("this half-swing")
        return cls.of([(t.strength.ball(), t.velocity) for t in law.terms])

    @cached_property
    def sizes(self) -> tuple[tuple[float, float], ...]:
        """(log2 epsilon_i, alpha_i) in doubles, for choosing sizes; LimitError for an exponent that is 0 there."""
        return tuple(zip(map(size_of, self.strengths), in_doubles(self.exponents)))

    @cached_property
    def least(self) -> float:
        """The least exponent above 0, in doubles; infinity without one."""
        return min((a for _, a in self.sizes), default=inf)

    @cached_property
    def superlinear(self) -> bool:
        """Whether N(w)/w is nondecreasing: every alpha_i >= 1, and no dry friction."""
        return self.friction == 0 and all(not a < 1 for a in self.alphas)

    def terms(self, w: arb) -> list[arb]:
        """epsilon_i w^alpha_i for w > 0."""
        ln_w = w.log()
        return [e * (a * ln_w).exp() for e, a in zip(self.strengths, self.exponents)]

    def resistance(self, w: arb) -> arb:
        """N(w) for w >= 0."""
        return sum(self.terms(w), arb(0)) if w != 0 else arb(0)


def in_doubles(exponents: Iterable[arb]) -> tuple[float, ...]:
    """Exponents above 0, for choosing sizes; LimitError for one that is 0 there."""
    found = tuple(float(a.mid()) for a in exponents)
    if not all(a > 0 for a in found):
        raise LimitError("alpha", "an exponent is above 0, but too small for a double", "0, or 1e-300 and above")
    return found


def size_of(x: arb) -> float:
    """log2 |midpoint|, also far outside the range of doubles; -inf for 0."""
    mantissa, exponent = x.mid().man_exp()
    return log2(abs(int(mantissa))) + int(exponent) if mantissa != 0 else float("-inf")


def dyadic(size: float) -> arb:
    """A dyadic number near 2^size, exact at any precision.

    >>> dyadic(-1.0), dyadic(-2000.5) == 0
    (0.500000000000000, False)
    """
    whole = int(size // 1)
    with ctx.workprec(53):
        return arb(2.0 ** (size - whole)) * arb((1, whole), 0)


def upper(x: arb) -> arb:
    """An exact upper bound of |x|, short: errors are added in 53 bits."""
    with ctx.workprec(53):
        return abs(x).upper()
