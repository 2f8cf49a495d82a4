"""One number z that a half-swing depends on analytically, and how far: the argument of the return map.

The half-swing from the amplitude A is that from X = 1 with the strengths delta_i = epsilon_i A^(alpha_i - 1): the ratio
of amplitudes q/p and the duration T are functions of the delta_i alone, analytic in every polydisc on which the
majorant of ``expansions.half_swings.finite_majorant`` exists; quarter-swings with all alpha_i >= 1 are where that of
``quarter_majorant`` does.

* If all alpha_i - 1 = g k_i with natural k_i (one law: k = 1; (1, 2): k = 0, 1): z = A^g, delta_i = epsilon_i z^k_i,
  analytic at z = 0 too, where the motion is linear;
* otherwise, and where g is so small that no amplitude brings z = A^g near 0 while a k_i > 1 narrows the disc about 1,
  z = ln A, delta_i = epsilon_i e^(k_i z) with k_i = alpha_i - 1.

On the ellipse with centre c and half axis a along the real line, c - a <= Re z <= c + a and, if c >= 0, |z| <= c + a.
So |delta_i| <= epsilon_i (c + a)^k_i, or epsilon_i times the larger of e^(k_i (c - a)) and e^(k_i (c + a)); on the
polydisc with these radii |q/p - 1| <= e^G - 1, and |T - pi| is at most the excess of the majorant.

>>> terms = [(arb(1) / 20, ExactReal(1)), (arb(1) / 5, ExactReal(2))]
>>> z = Coordinate.of(terms)
>>> z.from_zero, z(arb("0.25")), [k.str(3) for k in z.powers]
(True, 0.250000000000000, ['0', '1.00'])
>>> [d.str(3) for d in z.strengths(arb("0.25"))]
['[0.0500 +/- ...]', '[0.0500 +/- ...]']
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from math import gcd, lcm

from flint import arb

from asymptotics.expansions.half_swings.finite_majorant import Majorant, majorant
from asymptotics.flow.damping import Damping
from asymptotics.numbers.context import cached_property
from asymptotics.numbers.exact import ExactReal
from asymptotics.return_map.quarter_majorant import quarter_majorant

MAX_POWER = 12
"""Larger k_i shrink the disc more than z = 0 is worth."""
_LEAST_ROOT = Fraction(1, 1024)
"""A^g > 1/2 for any amplitude above 10^-300."""


@dataclass(frozen=True, eq=False)
class Coordinate:
    """z = A^``root``, or ln A if that is None; the k_i (``powers``), strengths and exponents of a law, as balls."""

    root: arb | None
    powers: tuple[arb, ...]
    epsilons: tuple[arb, ...]
    alphas: tuple[ExactReal, ...]
    exponents: tuple[arb, ...]

    @classmethod
    def of(cls, terms: Sequence[tuple[arb, ExactReal]]) -> "Coordinate":
        """From (epsilon_i, alpha_i), at the current precision."""
        epsilons, alphas = zip(*terms, strict=True)
        root, powers = _commensurable(alphas)
        found = tuple((a - 1).ball() for a in alphas) if root is None else tuple(map(arb, powers))
        return cls(None if root is None else root.ball(), found, epsilons, alphas, tuple(a.ball() for a in alphas))

    @cached_property
    def from_zero(self) -> bool:
        """Whether z falls to 0 with the amplitude."""
        return self.root is not None and bool(self.root > 0)

    @cached_property
    def is_quartered(self) -> bool:
        """Whether half-swings are put together from quarters: all alpha_i >= 1, and not all are 1."""
        return all(a >= 1 for a in self.alphas) and any(k > 0 for k in self.powers)

    @cached_property
    def is_odd(self) -> bool:
        """Whether z -> -z turns the sign of every strength."""
        return self.root is not None and all(int(float(k)) % 2 for k in self.powers)

    def __call__(self, amplitude: arb) -> arb:
        """z at an amplitude > 0."""
        if self.root is None:
            return amplitude.log()
        return amplitude if self.root == 1 else amplitude**self.root

    def strengths(self, z: arb) -> list[arb]:
        """delta_i at a real ball z."""
        # |e^(k z)| = e^(k Re z) is largest at one end or the other, by the sign of k.
        if self.root is None:
            return [e if k == 0 else e * (k * z).exp() for e, k in zip(self.epsilons, self.powers, strict=True)]
        return [e if k == 0 else e * z**k for e, k in zip(self.epsilons, self.powers, strict=True)]

    def damping(self, z: arb) -> Damping:
        """The law in units of the amplitude, at the current precision."""
        return Damping.of(list(zip(self.strengths(z), self.alphas, strict=True)))

    def unit(self, log_unit: arb) -> arb:
        """What turns z at A into z at u A, from ln u: a factor, or with z = ln A a summand."""
        return log_unit if self.root is None else (self.root * log_unit).exp()

    def bounds(self, centre: arb, half_axis: arb, *, whole: bool = True) -> Majorant | None:
        """The majorant on the ellipse, None where none is proved; ``centre`` >= 0 where z = 0 is included.

        ``whole``: of the half-swing, else of the quarter-swing.
        """
        # |z| <= centre + half axis needs a centre >= 0; then all powers k_i >= 0 are largest there.
        if self.root is not None and not centre >= 0:
            return None
        radii = [d.upper() for d in self.strengths(centre + half_axis)]
        if self.root is None:
            other = [d.upper() for d in self.strengths(centre - half_axis)]
            radii = [a.max(b) for a, b in zip(radii, other, strict=True)]
        if self.is_quartered and not whole:
            return quarter_majorant(self.exponents, radii)
        return majorant(self.exponents, radii, whole=whole)


def _commensurable(alphas: Sequence[ExactReal]) -> tuple[ExactReal | None, list[int]]:
    """(g, k_i) with natural k_i, or None for g."""
    weights = [a - 1 for a in alphas]
    moving = [w for w in weights if not w.is_zero]
    # Linear terms alone do not change with the amplitude.
    if not moving:
        return ExactReal(1), [0 for _ in weights]
    # One weight beside 0, which may be irrational: z = A^g with k = 1.
    if all(w == moving[0] for w in moving):
        return moving[0], [0 if w.is_zero else 1 for w in weights]
    # Weights of both signs would let some strength grow as z falls to 0; irrational ones have no common g in general.
    if len({w.sign for w in moving}) == 1 and all(w.is_rational for w in moving):
        fractions = [w.rational for w in weights]
        step = moving[0].sign * reduce(_common, (abs(f) for f in fractions if f))
        powers = [int(f / step) for f in fractions]
        if max(powers) <= MAX_POWER and abs(step) > _LEAST_ROOT:
            return ExactReal(step), powers
    return None, []


def _common(a: Fraction, b: Fraction) -> Fraction:
    """The largest number that divides both."""
    bottom = lcm(a.denominator, b.denominator)
    return Fraction(gcd(int(a * bottom), int(b * bottom)), bottom)
