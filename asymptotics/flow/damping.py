"""The law in balls, on a half-swing: the speed w >= 0, the displacement y from the centre that dry friction shifts.

N is nondecreasing, a monotone operator with the Coulomb term, so that the flow is nonexpansive (Brezis 1973).

    y' = -w,    w' = y - N(w),    N(w) = sum_i epsilon_i w^alpha_i over alpha_i > 0          (units: amplitude, tau)

Strengths and exponents are enclosures at the precision current when the ``Damping`` is made; the doubles beside them
choose sizes and never enter a bound.  The rest position of the flow is y = 0, and its linear term is kept exactly.

>>> from fractions import Fraction
>>> from flint import ctx
>>> with ctx.workprec(60):
...     law = Damping.of([(arb(1) / 10, ExactReal(Fraction(3, 2))), (arb(1) / 50, ExactReal(Fraction(0)))])
...     law.resistance(arb(4)).str(10), law.friction.str(5)
('[0.8000000000 +/- ...]', '[0.020000 +/- ...]')
"""

from dataclasses import dataclass
from math import inf
from typing import ClassVar

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import dyadic, in_doubles, size_of, upper
from asymptotics.law import Law
from asymptotics.numbers.context import cached_property
from asymptotics.numbers.exact import ExactReal

__all__ = ["Damping", "dyadic", "in_doubles", "size_of", "upper"]


@dataclass(frozen=True)
class Damping:
    """Strengths epsilon_i > 0 and exponents alpha_i > 0 of N(w); ``friction`` is the strength of the term alpha = 0."""

    friction: arb
    strengths: tuple[arb, ...]
    alphas: tuple[ExactReal, ...]
    exponents: tuple[arb, ...]
    rate: ClassVar[None] = None
    linear: ClassVar[int] = 1
    entire: ClassVar[bool] = False
    nonexpansive: ClassVar[bool] = True
    kinked: ClassVar[bool] = False
    viscous: ClassVar[arb] = arb(0)

    @classmethod
    def of(cls, terms: list[tuple[arb, ExactReal]]) -> "Damping":
        """From (epsilon_i, alpha_i), at the current precision.

        Terms of strength exactly 0 are dropped, and those of one exponent are one term.  UndecidedError for a strength that is not told from 0.
        """
        # A ball about 0 is neither a term nor none: without it the least exponent, and with it how the motion ends, is
        # not known.  The caller raises the precision.
        if any(e.contains(0) and not e == 0 for e, _ in terms):
            raise UndecidedError("a strength is not told from 0 at this precision")
        # Exponents are exact numbers >= 0, so the comparison decides: several terms of exponent 0 are one dry friction.
        friction = sum((e for e, a in terms if not a > 0), arb(0))
        # The series of the half-swing are filed by exponent: of two terms with one exponent they would keep one.
        moving: dict[ExactReal, arb] = {}
        for e, a in terms:
            if a > 0 and e != 0:
                moving[a] = moving[a] + e if a in moving else e
        return cls(friction, tuple(moving.values()), tuple(moving), tuple(a.ball() for a in moving))

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
    def sublinear(self) -> bool:
        """Whether some exponent is below 1."""
        return any(a < 1 for a in self.alphas)

    @cached_property
    def leading(self) -> int:
        """Which exponent is the least, decided exactly: no double may choose what then counts as exact."""
        return min(range(len(self.alphas)), key=self.alphas.__getitem__)

    @cached_property
    def least(self) -> float:
        """The least exponent above 0, in doubles, for choosing sizes; infinity without one."""
        return min((a for _, a in self.sizes), default=inf)

    @cached_property
    def least_power(self) -> arb | None:
        """The least of 1 and every alpha_i, as of which N(w)/w^a is nondecreasing; None with dry friction."""
        # With dry friction the displacement counts from a centre that moves from one half-swing to the next, and the
        # derivation ``ratio-growth`` has u from X = 0.
        if self.grips:
            return None
        return self.exponents[self.leading] if self.sublinear else arb(1)

    def terms(self, w: arb) -> list[arb]:
        """epsilon_i w^alpha_i for w > 0."""
        ln_w = w.log()
        return [e * (a * ln_w).exp() for e, a in zip(self.strengths, self.exponents)]

    def resistance(self, w: arb) -> arb:
        """N(w) for w >= 0."""
        return sum(self.terms(w), arb(0)) if w != 0 else arb(0)

    @property
    def grips(self) -> bool:
        """Whether there is dry friction."""
        return bool(self.friction > 0)

    def restoring(self, y: arb) -> arb:
        """At rest the acceleration is the displacement y."""
        return y

    def drag(self, _y: arb, w: arb) -> arb:
        """N(w) for w >= 0 (a ball: at its upper end)."""
        # N is nondecreasing, so its value at the upper end bounds it on the whole ball.
        top = w.upper()
        return self.resistance(top) if top > 0 else arb(0)

    def slopes(self, _y: arb, _w: arb) -> tuple[arb, arb]:
        """G_u = 1, and G_w <= 0, which counts as 0."""
        # -N'(w) is unbounded below at w = 0 where an exponent is below 1; only an upper bound of it is ever used.
        return arb(1), arb(0)

    def strongest(self, u: arb, w: arb) -> arb:
        """|u| and all losses together."""
        return upper(abs(u) + self.friction + self.drag(u, w))

    def restoring_powers(self, _side: int) -> list[tuple[arb, int]]:
        """None: the force at rest is y."""
        return []

    def loss_powers(self, _side: int) -> list[tuple[arb, int, arb]]:
        """Each law adds -epsilon_i w^alpha_i at every place: (-epsilon_i, 0, alpha_i)."""
        return [(-e, 0, a) for e, a in zip(self.strengths, self.exponents)]

    def largest(self, _y: arb, _dy: arb, w: arb, dw: arb) -> arb:
        """A bound of |N| on the complex disc |W - w| <= dw < w."""
        # dw < w keeps W in the right half-plane, where |W^alpha| = |W|^alpha <= (w + dw)^alpha (derivation
        # ``taylor-residual``).
        return upper(self.resistance(w + dw))
