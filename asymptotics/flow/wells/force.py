"""The force on a half-swing in balls: spring, pendulum, dry friction and losses, each with a power of the place.

    G(u, w) = s_0(u) - sum_i epsilon_i |u|^m_i w^alpha_i,    s_0 = spring_force - dry_friction,
    spring_force(u) = u + sum_j c_j u|u|^(p_j-1), with sin(r u)/r in place of u for a pendulum,
    dry_friction(u) = sum epsilon |u|^m over the losses of exponent 0.

Strengths are enclosures at the precision current when the ``WellForce`` is made. On one side of u = 0 everything is a
polynomial or a sine of u: ``restoring_powers`` and ``loss_powers`` give it.

>>> from asymptotics.law import Law
>>> air = WellForce.of(Law({2: "1/10", 0: "1/50"}, spring={3: "1/2"}).terms)
>>> air.acceleration(arb(1), arb(1)).str(5), air.slope(arb(1), arb(0)).str(5)
('[1.3800 +/- ...]', '2.5000')
>>> WellForce.of(Law({1: 1}, spring="pendulum").terms).spring_force(arb(-2)).str(5)
'[-0.90930 +/- ...]'
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import ClassVar

from flint import arb

from asymptotics.costs import well_seconds
from asymptotics.errors import InputError
from asymptotics.flow.balls import upper
from asymptotics.numbers.context import cached_property
from asymptotics.numbers.exact import ExactReal
from asymptotics.terms import Term


@dataclass(frozen=True)
class WellLoss:
    """strength |u|^place w^alpha, alpha > 0."""

    strength: arb
    place: int
    alpha: ExactReal
    exponent: arb


@dataclass(frozen=True)
class WellForce:
    """``rate``: r of a pendulum, else None; ``springs``: (c, p); ``grips``: (epsilon, m) of alpha = 0; ``losses``."""

    rate: arb | None
    springs: tuple[tuple[arb, int], ...]
    grips: tuple[tuple[arb, int], ...]
    losses: tuple[WellLoss, ...]
    linear: ClassVar[int] = 0
    entire: ClassVar[bool] = False
    nonexpansive: ClassVar[bool] = False
    least_power: ClassVar[None] = None

    @classmethod
    def of(cls, terms: Sequence[Term], strengths: Sequence[arb] | None = None) -> "WellForce":
        """The terms of a dimensionless law, at the current precision; ``strengths`` in place of theirs.

        InputError by name for anti-damping and for a spring that depends on the velocity.
        """
        rate, springs, grips, losses = None, [], [], []
        values = [t.strength.ball() for t in terms] if strengths is None else strengths
        for t, e in zip(terms, values, strict=True):
            # A pendulum is a graded family of springs with one strength, r^2 = e; e = 0 is the linear spring.
            if t.family:
                rate = None if e == 0 else e.sqrt()
            elif t.sign > 0 and not t.velocity.is_zero:
                known = "springs C x|x|^(P-1) of the place, or a pendulum; expand takes every force"
                # A spring like x v^2 is even in w and no loss: G would not be monotone in the speed, which
                # ``wells-contract`` needs.
                reason = f"{t.shape()} depends on the velocity: it is not enclosed at finite strength"
                raise InputError("spring", reason, known)
            elif t.sign < 0 and t.strength.sign < 0:
                raise InputError(
                    "strength", f"{t.strength} is negative: anti-damping has no motion to rest", "strengths >= 0"
                )
            elif e != 0:
                if t.sign > 0:
                    springs.append((e, t.position))
                elif t.velocity.is_zero:
                    grips.append((e, t.position))
                else:
                    losses.append(WellLoss(e, t.position, t.velocity, t.velocity.ball()))
        return cls(rate, tuple(springs), tuple(grips), tuple(losses))

    @cached_property
    def kinked(self) -> bool:
        """Whether the force is not one analytic function on both sides of u = 0."""
        # |u|^m is analytic at 0 for even m only, and u|u|^(p-1) for odd p only; dry friction itself (m = 0) is constant
        # on a half-swing.
        odd = any(m % 2 for _, m in self.grips) or any(loss.place % 2 for loss in self.losses)
        return odd or any(p % 2 == 0 for _, p in self.springs)

    @property
    def alphas(self) -> tuple[ExactReal, ...]:
        """The exponents of the losses."""
        return tuple(loss.alpha for loss in self.losses)

    @cached_property
    def viscous(self) -> arb:
        """The strength of the loss epsilon w."""
        none = arb(0)
        return sum((f.strength for f in self.losses if f.place == 0 and not f.alpha < 1 and not f.alpha > 1), none)

    def spring_force(self, u: arb) -> arb:
        """The force V'(u) of the springs."""
        linear = u if self.rate is None else (self.rate * u).sin() / self.rate
        return sum((c * u * abs(u) ** (p - 1) for c, p in self.springs), linear)

    def dry_friction(self, u: arb) -> arb:
        """What dry friction holds at u."""
        return sum((e * abs(u) ** m for e, m in self.grips), arb(0))

    def restoring(self, u: arb) -> arb:
        """s_0(u): the acceleration from rest towards smaller u."""
        return self.spring_force(u) - self.dry_friction(u)

    def drag(self, u: arb, w: arb) -> arb:
        """sum_i epsilon_i |u|^m_i w^alpha_i for w >= 0 (a ball: at its upper end)."""
        w = w.upper()
        if not w > 0 or not self.losses:
            return arb(0)
        ln_w = w.log()
        return sum((f.strength * abs(u) ** f.place * (f.exponent * ln_w).exp() for f in self.losses), arb(0))

    def acceleration(self, u: arb, w: arb) -> arb:
        """G(u, w) at an exact speed w >= 0."""
        return self.restoring(u) - self.drag(u, w)

    def slope(self, u: arb, w: arb) -> arb:
        """A ball with all slopes dG/du for u in a ball and speeds up to |w|, the kinks' one-sided slopes included."""
        total = arb(1) if self.rate is None else (self.rate * u).cos()
        total = sum((c * p * abs(u) ** (p - 1) for c, p in self.springs), total)
        # A ball about 0 gives [-1, 1], with both one-sided slopes.
        side = u.sgn()
        total -= sum((e * m * abs(u) ** (m - 1) * side for e, m in self.grips if m), arb(0))
        top = abs(w).upper()
        if not top > 0:
            return total
        ln_w = top.log()
        for f in self.losses:
            if f.place:
                largest = f.strength * f.place * abs(u) ** (f.place - 1) * (f.exponent * ln_w).exp() * side
                total -= largest.union(arb(0))
        return total

    def slopes(self, u: arb, w: arb) -> tuple[arb, arb]:
        """All dG/du, and 0: losses only grow with the speed."""
        return self.slope(u, w), arb(0)

    def strongest(self, u: arb, w: arb) -> arb:
        """Pull and all losses together."""
        return upper(abs(self.spring_force(u)) + self.dry_friction(u) + self.drag(u, w))

    def potential(self, u: arb) -> arb:
        """V(u) with V(0) = 0."""
        linear = u**2 / 2 if self.rate is None else (1 - (self.rate * u).cos()) / self.rate**2
        return sum((c * abs(u) ** (p + 1) / (p + 1) for c, p in self.springs), linear)

    def restoring_powers(self, side: int) -> list[tuple[arb, int]]:
        """(coefficient, power of u) of s_0 where u has the sign ``side``, without u itself or the sine."""
        return [(c * side ** (p - 1), p) for c, p in self.springs] + [(-e * side**m, m) for e, m in self.grips]

    def loss_powers(self, side: int) -> list[tuple[arb, int, arb]]:
        """(coefficient, power of u, exponent of w) of what a loss adds to w' where u has the sign ``side``."""
        return [(-f.strength * side**f.place, f.place, f.exponent) for f in self.losses]

    def largest_change(self, u: arb, reach: arb) -> arb:
        """sum_(k>=1) |s_0^(k)(u)|/k! reach^k term by term: how far s_0 goes within ``reach``, also for complex u."""
        size = abs(u)
        wide = size + reach
        # (|u| + reach)^n - |u|^n has the absolute values of all Taylor coefficients of u^n but the first; for the sine
        # cosh and sinh have (derivation ``wells-majorant``).
        total = sum((abs(c) * (wide**n - size**n) for c, n in self.restoring_powers(1)), arb(0))
        if self.rate is None:
            return upper(total + reach)
        sine, cosine = (self.rate * size).sin_cos()
        cosh, sinh = (self.rate * reach).cosh(), (self.rate * reach).sinh()
        total += (abs(sine) * (cosh - 1) + abs(cosine) * sinh) / self.rate
        return upper(total)

    def largest(self, u: arb, du: arb, w: arb, dw: arb) -> arb:
        """A bound of |G| on the complex discs |U - u| <= du, |W - w| <= dw < w."""
        # |W^alpha| <= (w + dw)^alpha in the right half-plane, dw < w.
        return upper(abs(self.restoring(u)) + self.largest_change(u, du) + self.drag(abs(u) + du, w + dw))


def estimated_seconds(force: WellForce, swings: float, bits: int) -> float:
    """The expected time, good to a factor of about three for weak damping."""
    # Exponents without a small common denominator make expansions of monomials, which cost more.
    apart = sum(not (a.is_rational and a.rational.denominator <= 20) for a in force.alphas)
    return well_seconds(swings, bits, len(force.losses) + len(force.springs), apart)
