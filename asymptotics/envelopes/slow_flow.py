"""Amplitude and phase as functions of time: the truncated slow equations, solved as they stand.

The slow equations are those of averaging (Bogoliubov and Mitropolsky, Asymptotic Methods in the Theory of Non-linear
Oscillations, 1961); nothing is neglected in solving them, and nothing is claimed of how near they are to the motion.

With A = e^(-s) every monomial delta^n is an exponential in s, so that the equations at order N,

    ds/d tau = p = sum_n p_n epsilon^n e^(-a_n s),     d phi/d tau = Omega(s),    a_n = sum_i n_i (alpha_i - 1),

are quadratures: tau = int ds/p, phi = int Omega/p ds.  Order 1 is the averaged law (Lancaster 2020, (8), (13)).

* For ``digits``: Gauss-Legendre quadrature in balls (``acb.integral``) and Newton's method for s(tau).
* For arrays: (tau, s, phi) on knots uniform in s, and cubic Hermite interpolation in tau between them (the slopes are
  known), in doubles.

If some alpha < 1, the averaged amplitude vanishes at a finite *extinction time*; the true motion sticks or creeps
instead.  A law that loses its sign (p <= 0) has no meaning there: InputError asks for another order.

>>> law = SlowLaw(ExponentialSum(((arb("0.5"), arb(1)),)), ExponentialSum(()))         # dA/d tau = -A^2/2
>>> s, phi = law.solve(arb(2), arb(0))
>>> (-s).exp().str(10, radius=False), float(law.table(0.0, 2.0).at(2.0)[0])
('0.5000000000', 0.693147180...)
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import inf
from typing import Any, Protocol

import numpy as np
from flint import acb, arb

from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.expansions.half_swings.grading import Grading, may_vanish
from asymptotics.numbers.context import cached_property, ctx
from asymptotics.numbers.integral import integral
from asymptotics.series import Series

# Cubic Hermite interpolation errs by h^4/384 max |f''''| between knots h apart. Twice as many would take twice the
# time; no digit that is claimed comes from the table.
_KNOTS = 2048
_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(10)
_STEADY = 0.99
"""The next step in s may be twice as long when p falls by no more than this factor."""
# A limit of time: a march that is longer is refused by name.
_MAX_PANELS = 100_000
_FAINTEST = 60.0
"""s beyond which the amplitude counts as extinct in doubles (e^-60 of the start)."""


@dataclass(frozen=True)
class ExponentialSum:
    """The function sum_j c_j e^(-a_j s) of s."""

    terms: tuple[tuple[arb, arb], ...]

    @classmethod
    def of(cls, series: Series, epsilons: tuple[arb, ...], grading: Grading, order: int) -> "ExponentialSum":
        """A series in delta_i = epsilon_i e^(-(alpha_i - 1) s), through degree ``order``.

        A ball around 0 counts as 0: those are the zeros by theorem (dry friction has p = (2/pi) delta and no more), and
        near an extinction delta would blow their rounding up.
        """
        terms = []
        for key, c in series.coefficients.items():
            absent = may_vanish(c) or any(e == 0 for e, n in zip(epsilons, key) if n)
            if 0 < sum(key) <= order and not absent:
                for e, n in zip(epsilons, key):
                    c = c * e**n
                # Midpoints alone: what is made of these sums is heuristic
                # (``motions.truncation``), and a radius would only look like a proof.
                terms.append((arb(c).mid(), arb(grading.weight(key)).mid()))
        return cls(tuple(terms))

    def __call__(self, s: Any) -> Any:
        """At a ball, real or complex."""
        return sum((c * (-(a * s)).exp() for c, a in self.terms), s * 0)

    @cached_property
    def _doubles(self) -> tuple[Any, Any]:
        return np.array([[float(c)] for c, _ in self.terms]), np.array([[float(a)] for _, a in self.terms])

    def array(self, s: Any) -> Any:
        """At an array of doubles."""
        if not self.terms:
            return np.zeros_like(s)
        c, a = self._doubles
        with np.errstate(over="ignore"):
            return (c * np.exp(-a * np.ravel(s)[None, :])).sum(axis=0).reshape(np.shape(s))


class Rate(Protocol):
    """A function of s, at balls and at arrays; ``terms``: (strength, power of the amplitude) of its time scales."""

    @property
    def terms(self) -> tuple[tuple[arb, arb], ...]:
        """Nothing for a rate that is 0."""

    def __call__(self, s: Any) -> Any:
        """At a ball, real or complex."""

    def array(self, s: Any) -> Any:
        """At an array of doubles."""


@dataclass(frozen=True)
class SlowTable:
    """(s, phi) at the knots of tau, with the slopes; ``extinction``: the time at which A = 0, inf if there is none."""

    tau: Any
    s: Any
    phi: Any
    ds: Any
    dphi: Any
    extinction: float

    def at(self, tau: Any) -> tuple[Any, Any]:
        """(s, phi) at an array of times inside the table, by cubic Hermite interpolation."""
        i = np.clip(np.searchsorted(self.tau, tau, side="right") - 1, 0, len(self.tau) - 2)
        h = self.tau[i + 1] - self.tau[i]
        x = (tau - self.tau[i]) / h
        y = 1 - x
        left, right, rise, fall = y * y * (1 + 2 * x), x * x * (1 + 2 * y), h * x * y * y, -h * x * x * y
        s, phi = (
            f[i] * left + f[i + 1] * right + g[i] * rise + g[i + 1] * fall
            for f, g in ((self.s, self.ds), (self.phi, self.dphi))
        )
        return s, phi

    def halved(self) -> "SlowTable":
        """The same with every second knot: errors of interpolation, h^4/384 max |f^(4)|, that are four times as large.

        At the place x of a cell they are 4 (1 - x/2)^2/(1 - x)^2 times those of the table, or the mirror image of that.
        """
        kept = np.unique([*range(0, len(self.tau), 2), len(self.tau) - 1])
        tau, s, phi, ds, dphi = (row[kept] for row in (self.tau, self.s, self.phi, self.ds, self.dphi))
        return SlowTable(tau, s, phi, ds, dphi, self.extinction)


@dataclass(frozen=True)
class SlowLaw:
    """ds/d tau = p(s), d phi/d tau = Omega(s)."""

    p: Rate
    Omega: Rate

    def table(self, start: float, tau_max: float) -> SlowTable:
        """Knots from s = ``start`` until tau reaches ``tau_max`` or the amplitude is extinct; doubles."""
        if not self.p.terms:
            knots = np.array([0.0, max(tau_max, 1.0)])
            rate = knots * 0 + float(self.Omega.array(np.array(start)))
            return SlowTable(knots, knots * 0 + start, rate * knots, knots * 0, rate, inf)
        stop, extinction = self._reach(start, max(tau_max, 1e-300))  # at least one step: no panel without a width
        s = np.linspace(start, stop, _KNOTS + 1)
        tau = np.concatenate([[0.0], np.cumsum(self._panels(s, lambda _: 1.0))])
        phi = np.concatenate([[0.0], np.cumsum(self._panels(s, self.Omega.array))])
        apart = np.concatenate([[True], np.diff(tau) > 0])  # towards the extinction the knots fall together in doubles
        s, tau, phi = s[apart], tau[apart], phi[apart]
        return SlowTable(tau, s, phi, self.p.array(s), self.Omega.array(s), extinction)

    def _panels(self, s: Any, numerator: Callable[[Any], Any]) -> Any:
        """int numerator/p over each interval of s, ten Gauss nodes."""
        half = np.diff(s) / 2
        at = (s[:-1] + half)[:, None] + half[:, None] * _NODES[None, :]
        values = self.p.array(at)
        if not np.all(values > 0):
            raise _lost_sign()
        with np.errstate(invalid="ignore"):
            found = half * (numerator(at) / values * _WEIGHTS[None, :]).sum(axis=1)
        if np.any(np.isnan(found)):  # infinity over infinity: both rates have left the doubles
            raise _lost_sign()
        return found

    def _reach(self, start: float, tau_max: float) -> tuple[float, float]:
        """(s at the end of the table, extinction time): march in s with steps that shrink p by little."""
        s, tau = start, 0.0
        rates = [float(a) for _, a in self.p.terms]
        if not any(rates):  # alpha = 1 alone: p is constant
            return start + max(tau_max, 1.0) * float(self.p.array(np.array(start))), inf
        # A falling power of the amplitude: p grows with s, and A = 0 is reached in a finite time.
        ends = min(rates) < 0
        # A quarter of the shortest scale of p in s, and 5 at most:
        # on e^(s/4) ten Gauss nodes are right to the last bit.
        step = 0.25 / max(max(map(abs, rates)), 0.05)
        for _ in range(_MAX_PANELS):
            if tau >= tau_max:
                return s, inf
            if ends and s > start + _FAINTEST:
                return s, tau + self._rest(s, step)
            tau += float(self._panels(np.array([s, s + step]), lambda _: 1.0)[0])
            now, then = (float(self.p.array(np.array(at))) for at in (s, s + step))
            # Where only the slowest loss is left p is nearly constant:
            # longer steps, or a long time would take 100,000 of them.
            s, step = s + step, 2 * step if not ends and _STEADY < then / now <= 1 else step
        raise LimitError("time", f"{tau_max:.3g}/omega_0 is too long for the amplitude law", "a shorter time")

    def _rest(self, s: float, step: float) -> float:
        """int_s^inf dr/p, p growing exponentially."""
        rest = 0.0
        while True:
            more = float(self._panels(np.array([s, s + step]), lambda _: 1.0)[0])
            rest, s = rest + more, s + step
            # Until a panel adds less than the last bit; p grows exponentially, so that 10^4 is far behind that.
            if more <= 1e-17 * rest or s > 1e4:
                return rest

    def solve(self, tau: arb, start: arb) -> tuple[arb, arb] | None:
        """(s, phi) at the time ``tau`` from s = ``start`` at the current precision, or None beyond the extinction."""
        if tau == 0 or not self.p.terms:  # no loss: the amplitude stays, and springs turn the phase steadily
            return start, (self.Omega(start) * tau).mid()
        table = self.table(float(start), float(tau))
        if float(tau) >= table.extinction:
            return None
        s = arb(float(table.at(np.array([float(tau)]))[0][0]))
        # The table gives a few digits, Newton's method doubles them each time; four more for a table that gave fewer.
        for _ in range(ctx.prec.bit_length() + 4):
            miss = self._integral(lambda _: acb(1), start, s) - tau
            step = (miss * self.p(s)).mid()
            s = (s - step).mid()
            # Half the bits are right before this step, all of them after it.
            if abs(step) < arb(2) ** (-ctx.prec // 2 - 4) * (1 + abs(s)):
                return s, self._integral(self.Omega, start, s).mid()
        raise UndecidedError("the amplitude at that time was not found by Newton's method")

    def _integral(self, numerator: Callable[[acb], acb], low: arb, high: arb) -> arb:
        if not (self.p(low) > 0 and self.p(high) > 0):
            raise _lost_sign()

        def integrand(r: acb, _analytic: bool) -> acb:
            value: acb = numerator(r) / self.p(r)
            return value

        found = integral(integrand, low, high, "an integral along the slow flow")
        if not found.is_finite():
            raise UndecidedError("the time integral of the amplitude law did not converge")
        # As above: heuristic, the radius is dropped on purpose.
        return found.mid()


def _lost_sign() -> InputError:
    reason = "the amplitude law of this order loses its sign before that time: delta is too large for it"
    return InputError("order", reason, "order 1, weaker damping, or the reference motion")
