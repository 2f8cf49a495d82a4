"""The slow flow of a pendulum or Duffing oscillator: first order in the loss, exact in the spring, any amplitude.

First-order averaging in the action-angle variables of the conservative oscillator (Sanders, Verhulst and Murdock,
Averaging Methods in Nonlinear Dynamical Systems, 2007).

With s = -ln xi the well gives (``expansions.straightening.wells``)

    ds/d tau = R(s)/Theta(s),      d psi/d tau = 1/Theta(s),      R = sum_i eps_i r_i,

so tau = int Theta/R ds and psi = int ds/R.  Without a loss s stays, and psi = tau/Theta is the exact motion.

*What is neglected.*  U is odd and W even in the losses (theory page ``springs``): in the turning-point gauge
d ln xi/d psi and d tau/d psi have a relative error O(eps^2).  Hence the phase and the time at which an amplitude is
reached are right to O(eps^2) relative, O(eps) absolute, over the whole decay.

*Certified* for these equations.  Integrals by ``acb.integral`` in the mean-value form.  Inversion s(tau) as in
``envelopes.certified``: if D = |tau - tau(s*)| and D sup g <= h over [s*-h, s*+h], g = R/Theta, the solution cannot
leave that interval.  *Extinction* (least weight w = m + alpha - 1 < 0): from xi_S = e^(-S) on, the rest is

    int_S^inf Theta/R ds = X * (a value of Theta/(r_1/(M xi^w) + ...) on [0, xi_S]),      X = xi_S^(-w)/(-w eps M).

>>> law = SlowFlow(Well.pendulum(arb(1)), (Loss(arb("0.1"), arb(2)),), arb(2))
>>> law.time(law.well.xi(arb(1))).str(12), law.amplitude(arb(20)).str(12)
('[11.5076442585 +/- ...]', '[0.734176290210 +/- ...]')
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import acb, arb

from asymptotics.envelopes.slow_flow import SlowLaw, SlowTable
from asymptotics.errors import InputError
from asymptotics.expansions.straightening.wells import Loss, Well
from asymptotics.numbers.context import cached_property, ctx
from asymptotics.numbers.integral import integral
from asymptotics.numbers.precision import TooWideError
from asymptotics.numbers.root import verified_root

# For a first look at the extinction and the first steps of Newton's method, which cost a fraction there.
ROUGH_BITS = 64


@dataclass(frozen=True)
class SlowFlow:
    """The flow of ``losses`` (all of positive strength) in a ``well`` from the turning amplitude ``start``."""

    well: Well
    losses: tuple[Loss, ...]
    start: arb

    @cached_property
    def s_0(self) -> arb:
        """-ln xi at the start."""
        return -self.well.xi(self.start).log()

    def rate(self, s: Any, analytic: bool = False) -> Any:
        """R(s): a ball, a complex ball, or an array."""
        parts = [self.well.loss(x, s, analytic) * _strength(x, s) for x in self.losses]
        return sum(parts[1:], start=parts[0])

    def time(self, xi: arb) -> arb:
        """tau at which xi is reached, 0 < xi <= its start."""
        return self._integral(self._slowness, -xi.log())

    def angle(self, xi: arb) -> arb:
        """psi at which xi is reached: n pi at turning points."""
        return self._integral(lambda s, flag: 1 / self.rate(s, flag), -xi.log())

    def amplitude(self, tau: arb) -> arb:
        """The turning amplitude A(tau); exactly 0 from the extinction time on.

        TooWideError if the balls are too wide, InputError for tau < 0.
        """
        return self.well.amplitude(self.xi(tau)) if self._goes_on(tau) else arb(0)

    def phase(self, tau: arb) -> arb:
        """psi(tau) - tau.  InputError from the extinction on."""
        if tau == 0:
            return arb(0)
        if not self._goes_on(tau):
            raise InputError("time", "the averaged amplitude is 0 and has no phase", "a time before the extinction")
        if not self.losses:
            return tau / arb(self.well.theta(self.s_0)) - tau
        return self.angle(self.xi(tau)) - tau

    def xi(self, tau: arb) -> arb:
        """The amplitude xi at the time tau, before the extinction."""
        if not self.losses or tau == 0:
            return self.well.xi(self.start)
        s = self._inverse(tau)
        if s is None:
            raise TooWideError("the amplitude at that time was not enclosed")
        return (-s).exp()

    def extinction_time(self) -> arb | None:
        """tau at which the averaged amplitude reaches 0 (a loss of weight < 0); None if it never does.

        TooWideError where a ball does not tell whether a weight is < 0, or which of two is the least.
        """
        if not all(x.weight < 0 or x.weight >= 0 for x in self.losses):
            raise TooWideError("a weight is not told from 0")
        if not any(x.weight < 0 for x in self.losses):
            return None
        first = self._least()
        rest = [x for x in self.losses if x is not first]
        gap = min([arb(2), *(x.weight - first.weight for x in rest)], key=lambda x: float(x.mid()))
        # The time behind S goes like e^(w S), and the other losses and the well beside its parabola count there for
        # a share of e^(-gap S): together less than 2^-(prec+8). Any S is right: a smaller one leaves a wider ball.
        S = self.s_0 + ((ctx.prec + 8) * arb(2).log() / (gap - first.weight)).upper()
        xi = (-S).exp()
        X = (first.weight * S).exp() / (-first.weight * first.epsilon * first.mean)
        # All amplitudes behind S. The weight e^(w s) is positive, so that the mean value theorem of integrals takes the
        # rest of the integrand at one of them.
        near = arb(0).union(xi)
        shape = self.well.near_zero(first, near)
        for x in rest:
            ratio = x.epsilon * x.mean / (first.epsilon * first.mean)
            shape += ratio * _power(near, xi, x.weight - first.weight) * self.well.near_zero(x, near)
        head = self._integral(self._slowness, S)
        return head + X * self.well.theta_near_zero(near) / shape

    def _least(self) -> Loss:
        """The loss of least weight, which rules the end: told in balls, as a double would take one for another."""
        for loss in self.losses:
            if all(x is loss or x.weight > loss.weight for x in self.losses):
                return loss
        raise TooWideError("the losses of least weight are not told apart")

    def table(self, tau_max: float) -> SlowTable:
        """(s, psi - tau) on knots of tau in doubles, for arrays."""
        return SlowLaw(_Rate(self), _Turn(self)).table(float(self.s_0.mid()), tau_max)

    def _goes_on(self, tau: arb) -> bool:
        if not tau >= 0:
            raise InputError("time", f"{tau.str(5)} is not certainly >= 0", "a time from the start on")
        with ctx.workprec(ROUGH_BITS):  # decides all but the closest cases at a fraction of the cost
            try:
                end = self.extinction_time()
            except TooWideError:  # of weights that are told apart at more bits
                end = arb("nan")
        if not (end is None or tau < end or tau >= end):
            end = self.extinction_time()
        if end is None or tau < end:
            return True
        if tau >= end:
            return False
        raise TooWideError("the time is too near the extinction of the averaged amplitude")

    def _integral(self, f: Callable[[acb, bool], acb], s: arb) -> arb:
        """int_(s_0)^s f, by the mean-value form at both ends."""
        if not self.losses:
            raise InputError("law", "without a loss the amplitude stays", "a loss")
        # The integrator is given exact ends; what lies between them
        # and the balls of the ends is added by the mean value theorem.
        low, high = self.s_0.mid(), s.mid()
        whole = _between(f, low, high)
        return whole + f(acb(s), False).real * (s - high) - f(acb(self.s_0), False).real * (self.s_0 - low)

    def _slowness(self, s: acb, analytic: bool) -> acb:
        return acb(self.well.theta(s, analytic) / self.rate(s, analytic))

    def _inverse(self, tau: arb) -> arb | None:
        """s(tau) by Newton from the doubles, at a low precision first; then the enclosure of the module docstring."""
        table = self.table(float(tau.mid()))
        s = arb(float(table.at(np.array([float(tau.mid())]))[0][0]))
        # Newton's method forgets the rounding of earlier steps, so these may be made at few bits.
        if ctx.prec > ROUGH_BITS:
            with ctx.workprec(ROUGH_BITS):
                s, _ = self._newton(s, tau.mid())
        s, reached = self._newton(s, tau.mid())
        # Rounded up, and tau is a ball: the distance of the farthest time that it holds.
        distance = abs(tau - reached).upper()
        half = (2 * distance * self._speed(s)).upper()
        # Twice the radius that a constant speed would want, then four times as much each time: the speed may change
        # fast (a pendulum near its top). The first radius that is proved is taken, and none is taken on trust.
        return verified_root(s, distance, self._speed, (4**k * half for k in range(8)))

    def _newton(self, s: arb, target: arb) -> tuple[arb, arb]:
        """A point s near s(target), and tau(s): after the first integral only short ones."""
        # Not before the start, where the well may have ended; a double may choose here, for the root is verified later.
        s = arb(max(s, self.s_0.upper(), key=float)).mid()
        reached = self._integral(self._slowness, s)
        for _ in range(ctx.prec.bit_length() + 2):
            step = ((target - reached) * self._speed(s)).mid()
            # As above, and always an exact number: the next short integral begins where this one ends.
            moved = arb(max(s + step, self.s_0.upper(), key=float)).mid()
            if not moved.is_finite():
                raise TooWideError("the amplitude at that time was not found")
            reached, s = reached + _between(self._slowness, s, moved), moved
            # All bits are right after a step that only changed the second half of them.
            if abs(step) < arb(2) ** (-ctx.prec // 2):
                break
        return s, reached

    def _speed(self, s: arb) -> arb:
        return arb(self.rate(s)) / arb(self.well.theta(s))


def _between(f: Callable[[acb, bool], acb], low: arb, high: arb) -> arb:
    """int f from one exact point to another."""
    return integral(f, low, high, "an integral over the slow flow")


def _strength(loss: Loss, s: Any) -> Any:
    return loss.epsilon if isinstance(s, arb | acb) else float(loss.epsilon.mid())


def _power(near: arb, xi: arb, exponent: arb) -> arb:
    """near^exponent for 0 <= near <= xi and an exponent that is certainly positive."""
    if not exponent > 0:
        raise TooWideError("the exponent of a power next to 0 is not certainly positive")
    return arb(0).union((exponent * xi.log()).exp())


@dataclass(frozen=True)
class _Rate:
    """ds/d tau as the table of ``slow_flow`` reads it."""

    flow: SlowFlow

    @property
    def terms(self) -> tuple[tuple[arb, arb], ...]:
        """(strength, power of the amplitude): the time scales."""
        return tuple((x.epsilon * x.mean, x.weight) for x in self.flow.losses)

    def __call__(self, s: Any) -> Any:
        return self.flow.rate(s) / self.flow.well.theta(s)

    def array(self, s: Any) -> Any:
        """At an array of doubles."""
        return self.flow.rate(s) / self.flow.well.theta(s)


@dataclass(frozen=True)
class _Turn:
    """d (psi - tau)/d tau = 1/Theta - 1."""

    flow: SlowFlow

    @property
    def terms(self) -> tuple[tuple[arb, arb], ...]:
        """Nothing here sets a time scale."""
        return ()

    def __call__(self, s: Any) -> Any:
        return 1 / self.flow.well.theta(s) - 1

    def array(self, s: Any) -> Any:
        """At an array of doubles."""
        return 1 / self.flow.well.theta(s) - 1
