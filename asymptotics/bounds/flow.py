"""The truncated equations over any number of half-swings at once: two integrals in balls.

With A_hat = e^(-s), delta_i = epsilon_i e^(-(alpha_i - 1) s) and the coefficients of order N, themselves balls,

    tau(s) = int_0^s dr/p_N(r),        psi(s) = int_0^s (1 + Omega_N)/p_N dr = tau(s) + int_0^s Omega_N/p_N dr,

each enclosed (``numbers.integral``).  s(tau) and s(psi) are found by Newton's method for ln tau against s, which is
concave, and the root is then verified (``numbers.root``), ds/dpsi being p_N/(1 + Omega_N).

>>> from asymptotics.bounds.local import local_bounds
>>> from asymptotics.numbers.exact import parse_real
>>> with ctx.workprec(100):
...     flow = TruncatedFlow.of(local_bounds([parse_real("2", "--alpha")], 3), [arb(1) / 50])
...     s, tau = flow.turning_point(1000)
...     (-s).exp().str(12), tau.str(12)
('[0.0361444887698 +/- ...]', '[3141.60022368 +/- ...]')
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from flint import acb, arb

from asymptotics.bounds.local import LocalBounds
from asymptotics.errors import UndecidedError
from asymptotics.numbers.context import ctx
from asymptotics.numbers.integral import integral
from asymptotics.numbers.root import verified_root
from asymptotics.series import Series

# Newton's method for a concave function takes a few dozen steps from 0; more say that it does not settle.
_STEPS = 200


@dataclass(frozen=True, eq=False)
class TruncatedFlow:
    """p_N and Omega_N along A_hat = e^(-s) from s = 0, psi = 0, tau = 0, for strengths ``epsilons`` at s = 0."""

    p: Series
    Omega: Series
    weights: tuple[arb, ...]
    epsilons: tuple[arb, ...]

    @classmethod
    def of(cls, local: LocalBounds, epsilons: Sequence[arb]) -> "TruncatedFlow":
        """The equations that ``local`` bounds the error of."""
        p, Omega = (f.truncate(local.order) for f in (local.flow.p, local.flow.Omega))
        weights = tuple(a.ball() - 1 for a in local.alphas)
        return cls(p.without_constant(), Omega.without_constant(), weights, tuple(epsilons))

    def time(self, s: arb) -> arb:
        """The time tau at which the amplitude is e^(-s)."""
        return self._integral(lambda _: acb(1), s)

    def phase(self, s: arb) -> arb:
        """The phase psi at which the amplitude is e^(-s)."""
        return self._integral(lambda deltas: 1 + self.Omega.at(deltas), s)

    def turning_point(self, n: int) -> tuple[arb, arb]:
        """Enclosures of s and tau at psi = n pi."""
        if n == 0:
            return arb(0), arb(0)
        s = self._enclosed(n * arb.pi())
        # tau = psi - int Omega/p: the integral is small, so that n pi keeps all of its digits.
        return s, n * arb.pi() - self._integral(lambda deltas: acb(self.Omega.at(deltas)), s)

    def beyond(self, tau: arb) -> arb:
        """An s that is not reached before the time ``tau``."""
        s = self._near(self.time, tau)
        # Newton's s may fall short of the time by its rounding; a little more is checked in balls, as tau grows with s.
        for widening in (1e-9, 1e-6, 1e-3):
            later = (s * (1 + arb(widening))).mid()
            if self.time(later) >= tau:
                return later
        raise UndecidedError("the truncated equations are not enclosed: raise the precision")

    def half_swings(self, tau: arb) -> int:
        """About how many half-swings end before the time ``tau``: the largest integer below psi/pi, or one less."""
        s = self._near(self.time, tau)
        turns = (self.phase(s) / arb.pi()).mid()
        return max(0, int((turns - arb(1) / 1000).floor().str(60, radius=False).split(".")[0]))

    def _enclosed(self, target: arb) -> arb:
        """A ball that holds the s at which psi is ``target``: psi changes on it by more than what is missing."""
        s = self._near(self.phase, target)
        miss = abs(self.phase(s) - target).upper()
        # ds/dpsi is about p, so the root is about miss p away; the verification decides how much wider the ball must
        # be.
        radii = ((widening * miss * self._p(s)).upper() for widening in (2, 8, 64))
        found = verified_root(s, miss, lambda near: self._p(near) / (1 + self.Omega.at(self._deltas(near))), radii)
        if found is None:
            raise UndecidedError("the truncated equations are not enclosed: raise the precision")
        return found

    def _near(self, f: Callable[[arb], arb], target: arb) -> arb:
        """An exact number near the root of f(s) = target, by Newton's method for ln f: no claim."""
        p = self._p(arb(0))
        s = (target * p / (1 + target * p)).mid()
        for _ in range(_STEPS):
            value = f(s).mid()
            # Newton's step for ln f: f'/f = 1/(p f) up to the factor 1 + Omega, which changes the speed of convergence
            # alone.
            step = ((target / value).log() * value * self._p(s)).mid()
            s = (s + step).mid()
            if abs(step) <= arb(2) ** (-ctx.prec // 2) * s:
                return s
        raise UndecidedError("Newton's method along the truncated equations does not settle: raise the precision")

    def _deltas(self, s: acb | arb) -> tuple[acb | arb, ...]:
        return tuple(e * (-w * s).exp() for e, w in zip(self.epsilons, self.weights, strict=True))

    def _p(self, s: arb) -> arb:
        value = arb(self.p.at(self._deltas(s)))
        # The derivative of the time by s is 1/p_N: the amplitude must fall all the way.
        if not value > 0:
            raise UndecidedError("the truncated amplitude equation may lose its sign")
        return value

    def _integral(self, numerator: Callable[[tuple[acb | arb, ...]], acb], s: arb) -> arb:
        def integrand(r: acb, _analytic: bool) -> acb:
            deltas = self._deltas(r)
            value: acb = numerator(deltas) / self.p.at(deltas)
            return value

        found = integral(integrand, arb(0), s, "an integral along the truncated equations")
        if not found.is_finite():
            raise UndecidedError("the truncated equations are not integrated: raise the precision")
        return found
