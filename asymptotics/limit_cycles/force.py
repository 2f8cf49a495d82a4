"""The force of a polynomial oscillator on its half-swing: springs, losses and gains of whole powers, in balls.

Where it gains energy the flow is not contracting; distances grow by the logarithmic norm (``flow.error_propagation``).

x'' + x + sum_i e_i x^m_i x'^a_i = 0, with u = x and w = -x' from a turning point (A, 0) on:

    u' = -w,    w' = G(u, w) = u + sum_i d_i u^m_i w^a_i,    d_i = e_i (-1)^a_i.

>>> from asymptotics.law import Law
>>> field = PolynomialForce.of(Law({1: -1, (1, 2): 1}).terms, arb(1))
>>> field.at(arb(2), arb(1)), field.slopes(arb(2), arb(1))
(-1.00000000000000, (-3.00000000000000, -3.00000000000000))
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import prod
from typing import ClassVar

from flint import arb

from asymptotics.flow.balls import upper
from asymptotics.terms import Term


@dataclass(frozen=True)
class PolynomialForce:
    """``parts``: (d_i, m_i, a_i).  It is analytic at w = 0, so the flow may start and end at rest."""

    parts: tuple[tuple[arb, int, int], ...]
    rate: ClassVar[None] = None
    linear: ClassVar[int] = 0
    entire: ClassVar[bool] = True
    nonexpansive: ClassVar[bool] = False

    @classmethod
    def of(cls, terms: Sequence[Term], mu: arb) -> "PolynomialForce":
        """Terms that are x^m x'^a, at the current precision; losses and gains are multiplied by ``mu``.

        ArithmeticError for others: |x|^m x'|x'|^(a-1) is a polynomial for even m and odd a only, x|x|^(p-1) |x'|^q for
        odd p and even q.
        """
        powers = [(t, _whole(t)) for t in terms]
        strengths = ((t.strength.ball() * (mu if t.sign < 0 else 1), t.position, a) for t, a in powers)
        # w = -x', so that w' = -x'' = x + sum e x^m (-w)^a.
        return cls(tuple((-e if a % 2 else e, m, a) for e, m, a in strengths))

    def restoring_powers(self, _side: int) -> list[tuple[arb, int]]:
        """(d_i, m_i) of the springs."""
        return [(d, m) for d, m, a in self.parts if not a]

    def loss_powers(self, _side: int) -> list[tuple[arb, int, arb]]:
        """(d_i, m_i, a_i) of what depends on the speed."""
        return [(d, m, arb(a)) for d, m, a in self.parts if a]

    def largest(self, u: arb, du: arb, w: arb, dw: arb) -> arb:
        """A bound of |G| on the complex discs |U - u| <= du, |W - w| <= dw."""
        # Polynomials: their absolute values at the largest |U| and |W| bound them on complex discs of any radius.
        far, fast = abs(u) + du, abs(w) + dw
        return upper(sum((abs(d) * _power(far, m) * _power(fast, a) for d, m, a in self.parts), far))

    def at(self, u: arb, w: arb) -> arb:
        """The acceleration G(u, w)."""
        return sum((d * _power(u, m) * _power(w, a) for d, m, a in self.parts), u)

    def slopes(self, u: arb, w: arb) -> tuple[arb, arb]:
        """The partial derivatives (G_u, G_w)."""
        in_u = sum((d * m * _power(u, m - 1) * _power(w, a) for d, m, a in self.parts if m), arb(1))
        return in_u, sum((d * a * _power(u, m) * _power(w, a - 1) for d, m, a in self.parts if a), arb(0))

    def bends(self, u: arb, w: arb) -> tuple[arb, arb]:
        """The second derivatives (G_uw, G_ww), by which the integral of G_w parts from that of the polynomials."""
        mixed = (d * m * a * _power(u, m - 1) * _power(w, a - 1) for d, m, a in self.parts if m and a)
        twice = (d * a * (a - 1) * _power(u, m) * _power(w, a - 2) for d, m, a in self.parts if a > 1)
        return sum(mixed, arb(0)), sum(twice, arb(0))


def _whole(t: Term) -> int:
    """The power of x' of a term that is a polynomial in x and x'."""
    loss = t.sign < 0
    if not t.velocity.is_integer or int(t.velocity.rational) % 2 != loss or t.position % 2 == loss or t.family:
        raise ArithmeticError(f"{t.shape()} is no polynomial in x and x': its flow is not entire")
    return int(t.velocity.rational)


def _power(x: arb, n: int) -> arb:
    """x^n by products: the power of a ball around 0 is not a number in FLINT."""
    return prod([x] * n, start=arb(1))
