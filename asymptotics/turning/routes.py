"""Which way to the turning points start … start + count - 1 of one law: by pieces, by the series, or by one jump.

* **By pieces** (``swing.sequence``): any strength, tens of milliseconds for each half-swing.
* **Series** of the quarter-swing (``half_swings.finite``): a tenth of a millisecond each after the coefficients
  (seconds), as long as delta is small; for alpha > 1 that is so from some point on, for alpha < 1 up to some point.
* **Jump** (``far``): alpha > 1 and a far start, at a cost that does not grow with it.

Estimates choose, and every route is certified: what they give agrees.

>>> from asymptotics.numbers.exact import parse_real
>>> far = Plan.of(Law({"3/2": "1/5"}), 10**9, 1, 200)
>>> far.method, far.seconds < 60
('local expansions, series of the quarter-swing and Abel function', True)
>>> Plan.of(Law({"3/2": "1/5"}), 0, 5, 140).method
'local expansions and Taylor steps'
"""

from collections.abc import Iterator
from dataclasses import dataclass

from flint import arb, ctx

from asymptotics.half_swings.finite import ROUTE, finite_quarter, series_reach
from asymptotics.law import Law
from asymptotics.numbers.exact import ExactReal
from asymptotics.swing.damping import Damping
from asymptotics.swing.passage import INTEGRATED
from asymptotics.swing.sequence import Turning, sequence
from asymptotics.swing.taylor import GUARD
from asymptotics.turning.far import LEAD_ORDER, Point, far_points, series_points

FAR = 3000
"""A start beyond which one jump is cheaper than all half-swings, even by the series."""
_SECONDS = {"piece": 0.035, "series": 1.2e-4, "coefficients": 2.5}


@dataclass(frozen=True)
class Plan:
    """How the points are reached: ``order``, up to which the series are taken (0: not at all), and whether to jump."""

    law: Law
    start: int
    order: int
    jump: bool
    seconds: float

    @classmethod
    def of(cls, law: Law, start: int, count: int, bits: int) -> "Plan":
        """The cheapest way that is known, by estimates (measured once, good to a factor of about three)."""
        steps = start + count
        apart = sum(not (t.velocity.is_rational and t.velocity.rational.denominator <= 20) for t in law.terms)
        piece = _SECONDS["piece"] * (bits / 150) ** 2.2 * (1 + apart) * (0.6 + 0.4 * len(law.terms))
        direct, alpha = piece * (steps + 1), law.terms[0].velocity
        if len(law.terms) > 1 or alpha.is_zero:
            return cls(law, start, 0, False, direct)
        jump = bool(alpha > 1) and start > FAR
        scale = _SECONDS["coefficients"] * (bits / 110) ** 1.2
        order = LEAD_ORDER if jump else min(LEAD_ORDER, 4 * int(13 * (direct / 3 / scale) ** (1 / 3)))
        if order < 12 or direct < 2 * _SECONDS["coefficients"]:
            return cls(law, start, 0, False, direct)
        by_series = scale * (order / 52) ** 3 + _SECONDS["series"] * (FAR if jump else steps)
        lead = piece * cls(law, start, order, jump, 0).lead(bits, 50 if alpha > 1 else steps)
        return cls(law, start, order, jump, 2 * by_series + lead)

    def lead(self, bits: int, most: int) -> int:
        """About how many half-swings go by pieces: until delta is within reach (alpha > 1), or none."""
        term = self.law.terms[0]
        with ctx.workprec(64):
            within, delta = series_reach(term.velocity, bits, self.order), term.strength.ball()
            if delta < within:
                return 0
            gain = 2 * (term.velocity.ball() - 1) if term.velocity > 1 else arb(0)
            return min(most, int(float((1 / within - 1 / delta) / gain)) + 1) if gain > 0 else most

    @property
    def method(self) -> str:
        """The routes by name."""
        if not self.order:
            return INTEGRATED
        return f"local expansions, {ROUTE} and Abel function" if self.jump else f"local expansions and {ROUTE}"

    def turnings(self) -> Iterator[Turning]:
        """Turning points at the current precision, from 0 or (after a jump) from ``start`` on."""
        with ctx.workprec(ctx.prec + GUARD):
            damping = Damping.of_law(self.law)
        if not self.order:
            return sequence(damping)
        term = self.law.terms[0]
        lead = map(_point, sequence(damping))
        if self.jump:
            return map(_turning, far_points(term.velocity, term.strength.ball(), lead, self.start))
        return self._mixed(damping, term.velocity, term.strength.ball())

    def _mixed(self, damping: Damping, alpha: ExactReal, epsilon: arb) -> Iterator[Turning]:
        """By pieces where delta is large, by the series where it is small: it changes sides once at most."""
        bits = ctx.prec - 16
        within, weight = series_reach(alpha, bits, self.order), alpha.ball() - 1
        last: Turning | None = None
        for here in sequence(damping):
            if here.ended is None and _delta(epsilon, weight, here) < within:
                last = here
                break
            yield here
        if last is None:
            return
        largest = _delta(epsilon, weight, last) if alpha > 1 else within
        for point in series_points(finite_quarter([alpha], [largest], bits), epsilon, _point(last)):
            last = _turning(point)
            if not (alpha > 1 or _delta(epsilon, weight, last) < within):
                break
            yield last
        yield from sequence(damping, last)


def _delta(epsilon: arb, weight: arb, here: Turning) -> arb:
    return epsilon * (weight * arb(here.amplitude, here.amplitude_error).log()).exp()


def _point(here: Turning) -> Point:
    return Point(here.n, arb(here.amplitude, here.amplitude_error).log(), here.tau)


def _turning(point: Point) -> Turning:
    amplitude, tau = point.amplitude, point.tau
    side = -1 if point.n % 2 else 1
    return Turning(point.n, side, amplitude.mid(), tau.mid(), arb(amplitude.rad()), arb(tau.rad()))
