"""First-order equivalent damping as balls: one conservative cycle from the turning amplitude 1.

The balance of energy over one cycle, as in Jacobsen's equivalent viscous damping (1930); to first order it is
Melnikov's integral.

The strengths are local, delta_i = epsilon_i A^(d_i-1), so that A = 1.  With V the potential and x = 1 - u^2,

    v^2 = 2 (V(1) - V(x)) = u^2 g(x),      g(x) = 1 + x + sum_j 2 gamma_j/(p_j+1) (1 + x + ... + x^(p_j)),
    closed integral of |x|^m |v|^(alpha-1) v dx = 8 int_0^1 x^m u^(alpha+1) g^(alpha/2) du,

(derivation ``equivalent-damping``), and beside the pendulum 1 + x carries sinc(q (1+x)/2) sinc(q (1-x)/2), q^2 its
local strength.  No truncation: the integrals are ``acb.integral`` of functions that are analytic but at u = 0; beside
the linear spring they are 2 pi <|cos|^m |sin|^(alpha+1)>.

>>> from asymptotics.law import Law
>>> law = Law({2: "1/10"}, spring={3: "1/2"})
>>> found = ConservativeCycle.of(law.terms, [t.strength.ball() for t in law.terms])
>>> found.lost.str(10), found.energy.str(6), found.zeta.str(10)
('[0.3466666667 +/- ...]', '0.625000', '[0.04413897088 +/- ...]')
"""

from collections.abc import Sequence
from dataclasses import dataclass

from flint import acb, arb

from asymptotics.errors import InputError
from asymptotics.expansions.moments.certified import moment
from asymptotics.numbers.context import ctx
from asymptotics.numbers.integral import integral
from asymptotics.terms import Term

_EVALUATIONS_PER_BIT = 400
"""Twice those of an envelope: a fractional power of u is not analytic at the end u = 0, which is bisected away."""


@dataclass(frozen=True)
class Spring:
    """The springs beside x at unit amplitude: (p, gamma) of gamma x|x|^(p-1), and q^2 of the pendulum or None."""

    powers: tuple[tuple[int, arb], ...]
    pendulum: arb | None

    @classmethod
    def of(cls, terms: Sequence[Term], delta: Sequence[arb]) -> "Spring":
        """InputError for a spring that depends on the velocity: its motion has no potential."""
        powers, pendulum = [], None
        for t, d in zip(terms, delta, strict=True):
            if t.sign > 0 and not t.velocity.is_zero:
                raise InputError("spring", f"{t.shape()} depends on the velocity: no potential", "springs c x|x|^(P-1)")
            if t.family:
                pendulum = d
            elif t.sign > 0:
                powers.append((t.position, d))
        return cls(tuple(powers), pendulum)

    @property
    def linear(self) -> bool:
        """Whether x stands alone."""
        return not self.powers and self.pendulum is None

    def potential(self, x: arb) -> arb:
        """V(x) for x >= 0."""
        V = x * x / 2
        if self.pendulum is not None:
            half = self.pendulum.sqrt() * x / 2
            V = V * half.sinc() ** 2
        return V + sum((c * x ** (p + 1) / (p + 1) for p, c in self.powers), arb(0))

    def force(self) -> arb:
        """The restoring force V'(1) at the turning point."""
        first = arb(1) if self.pendulum is None else self.pendulum.sqrt().sinc()
        return first + sum((c for _, c in self.powers), arb(0))

    def stiffness(self, x: acb) -> acb:
        """g(x) = 2 (V(1) - V(x))/(1 - x)."""
        first = 1 + x
        if self.pendulum is not None:
            half = self.pendulum.sqrt() / 2
            # 2 (V(1) - V(x)) of the pendulum is 2 (cos(q x) - cos q)/q^2, a product of two sines, divided by 1 - x.
            first *= (half * (1 + x)).sinc() * (half * (1 - x)).sinc()
        # (1 - x^(p+1))/(1 - x) as a sum of powers: no difference is left that could cancel near x = 1.
        return first + sum(
            (2 * c / (p + 1) * sum((x**j for j in range(p + 1)), acb(0)) for p, c in self.powers), acb(0)
        )


@dataclass(frozen=True)
class ConservativeCycle:
    """V(1), V'(1), what the losses take in one cycle, and the closed integral of v dx: balls.

    ``period`` is the closed integral of dt = dx/v, in 1/omega_0, of this cycle without loss.
    """

    energy: arb
    force: arb
    lost: arb
    action: arb
    spring: Spring

    @classmethod
    def of(cls, terms: Sequence[Term], delta: Sequence[arb]) -> "ConservativeCycle":
        """At these local strengths, which the caller knows to be inside the well."""
        spring = Spring.of(terms, delta)
        lost = sum(
            (d * _cycle(spring, t.position, t.velocity.ball()) for t, d in zip(terms, delta) if t.sign < 0), arb(0)
        )
        return cls(spring.potential(arb(1)), spring.force(), lost, _cycle(spring, 0, arb(1)), spring)

    @property
    def period(self) -> arb:
        """The time of the cycle, in 1/omega_0: 2 pi beside the linear spring."""
        return _cycle(self.spring, 0, arb(-1))

    @property
    def zeta(self) -> arb:
        """The damping ratio Delta E/(4 pi E)."""
        return self.lost / (4 * arb.pi() * self.energy)

    @property
    def quality(self) -> arb:
        """The quality factor 2 pi E/Delta E."""
        return 2 * arb.pi() * self.energy / self.lost

    @property
    def decrement(self) -> arb:
        """Delta E/(A V'(A)): ln(A_n/A_(n+2)) of first order."""
        return self.lost / self.force

    @property
    def coefficient(self) -> arb:
        """c_eq in units of sqrt(k m)."""
        return self.lost / self.action


def _cycle(spring: Spring, m: int, alpha: arb) -> arb:
    """The closed integral of |x|^m |v|^(alpha+1) dt."""
    if spring.linear:
        x, y = arb(m + 1) / 2, alpha / 2 + 1
        return 2 * arb.pi() * moment(alpha + 1) if not m else 2 * x.gamma() * y.gamma() * (x + y).rgamma()
    # None unless the ball is one integer: then powers are products, and an even one leaves polynomials alone.
    whole = alpha.unique_fmpz()

    def integrand(u: acb, analytic: bool) -> acb:
        x = 1 - u * u
        g = spring.stiffness(x)
        if whole is not None and not int(whole) % 2:
            return x**m * u ** (int(whole) + 1) * g ** (int(whole) // 2)
        # The logarithm is analytic where Re g > 0. Elsewhere this says so, and the integrator bisects.
        if analytic and not g.real > 0:
            return acb("nan")
        rise = _power(u, alpha + 1, analytic) if whole is None else u ** (int(whole) + 1)
        return x**m * rise * (g.log(analytic=analytic) * (alpha / 2)).exp()

    limit = _EVALUATIONS_PER_BIT * ctx.prec
    return 8 * integral(integrand, arb(0), arb(1), "an integral over the orbit", evaluations=limit)


def _power(u: acb, exponent: arb, analytic: bool) -> acb:
    """u^exponent, exponent >= 1, on the right half plane; of a ball that holds 0 its size."""
    if u.real > 0:
        return (u.log(analytic=analytic) * exponent).exp()
    if analytic:
        return acb("nan")
    # |u^e| = |u|^e for a real e, on every branch: a square around 0 of the largest size holds the power.
    size = (arb(u.abs_upper()).log() * exponent).exp()
    return acb(arb(0, size), arb(0, size))
