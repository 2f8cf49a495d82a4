"""Which way to the turning points start … start + count - 1 of one law: by pieces, by interpolation, or by one jump.

* **By pieces** (``swing.passage``): any strength, tens of milliseconds for each half-swing.
* **Interpolation** in the amplitude (``swing.panels``): quarter-swings by one collocation (or some dozens of
  half-swings by pieces), then some hundredths of a millisecond each; any law, where the local strengths are small
  enough for the majorant.
* **Jump** (``far``): every alpha > 1 and a far start, at a cost that does not grow with it.

Estimates choose, and every route is certified: what they give agrees.

>>> from asymptotics.numbers.exact import parse_real
>>> far = Plan.of(Law({"3/2": "1/5"}), 10**9, 1, 200)
>>> far.method, far.seconds < 60
('local expansions, series of the quarter-swing and Abel function', True)
>>> Plan.of(Law({"3/2": "1/5", 3: 1}), 10**9, 1, 200).method
'local expansions, Chebyshev interpolation in the amplitude and Abel function by the slow flow'
>>> Plan.of(Law({"3/2": "1/5"}), 0, 5, 140).method
'local expansions and Taylor steps'
"""

from collections.abc import Iterator
from dataclasses import dataclass

from flint import arb, ctx

from asymptotics.costs import half_swing_seconds, interpolation_seconds, jump_seconds, stiff_seconds
from asymptotics.half_swings.finite import ROUTE
from asymptotics.law import Law
from asymptotics.swing.damping import Damping
from asymptotics.swing.linear import ROUTE as CLOSED
from asymptotics.swing.lingering import most_swings
from asymptotics.swing.panels import COLLOCATED, Panels, panels_of
from asymptotics.swing.panels import ROUTE as INTERPOLATED
from asymptotics.swing.passage import INTEGRATED
from asymptotics.swing.sequence import Turning, first_turning, sequence
from asymptotics.swing.taylor import GUARD
from asymptotics.turning.far import Point, far_point_of_sum, far_points, planned

FAR, FAR_SUM = 200_000, 20_000
"""Starts beyond which one jump is cheaper than all half-swings, even by interpolation: one law, and sums."""
_LEAD = 1000


@dataclass(frozen=True)
class Plan:
    """How the points are reached: ``panels`` (None where they do not pay), and whether to ``jump``."""

    law: Law
    start: int
    count: int
    jump: bool
    interpolates: bool
    seconds: float
    bits: int
    lead: int = _LEAD

    @classmethod
    def of(cls, law: Law, start: int, count: int, bits: int) -> "Plan":
        """The cheapest way that is known, by estimates (measured once, good to a factor of about three)."""
        one = len(law.terms) == 1
        jump = all(bool(a > 1) for a in law.alphas) and start > (FAR if one else FAR_SUM)
        steps, jumping, lead = int(min(start + count, most_swings(law))), 0.0, _LEAD
        if jump and one:
            steps, jumping = _LEAD, jump_seconds(bits)
        elif jump:
            far = planned(law.alphas, bits, start)
            steps, jumping, lead = min(far.head, start), far.seconds, far.head
        pieces = panels_of(law, bits).pieces(steps)
        apart = sum(not (t.velocity.is_rational and t.velocity.rational.denominator <= 20) for t in law.terms)
        seconds = half_swing_seconds(pieces + 1, bits, len(law.terms), apart) + interpolation_seconds(steps)
        seconds += stiff_seconds(panels_of(law, bits).sizes, bits) + jumping
        return cls(law, start, count, jump, 0 < pieces < steps, seconds, bits, lead)

    @property
    def method(self) -> str:
        """The routes by name, those of the nodes once they were taken."""
        if self.jump and len(self.law.terms) == 1:
            return f"local expansions, {ROUTE} and Abel function"
        if self.jump:
            return f"local expansions, {INTERPOLATED} and Abel function by the slow flow"
        if panels_of(self.law, 64).closed:
            return CLOSED
        if not self.interpolates:
            return INTEGRATED
        collocated = any(panel.by == COLLOCATED for panel in panels_of(self.law, self.bits).made)
        return ", ".join((INTEGRATED, *([COLLOCATED] if collocated else []), INTERPOLATED))

    def turnings(self, first: Turning | None = None) -> Iterator[Turning]:
        """Turning points at the current precision, from ``first`` (X = 1) or (after a jump) from ``start`` on."""
        with ctx.workprec(ctx.prec + GUARD):
            damping = Damping.of_law(self.law)
        panels = panels_of(self.law, ctx.prec) if self.interpolates or first is not None else None
        here = first_turning() if first is None else first
        if not self.jump:
            return sequence(damping, here, panels=panels, count=self.start + self.count)
        return self._jumped(damping, here, panels)

    def _jumped(self, damping: Damping, first: Turning, panels: Panels | None) -> Iterator[Turning]:
        lead = map(_point, sequence(damping, first, panels=panels, count=self.lead))
        epsilons = [t.strength.ball() for t in self.law.terms]
        if len(epsilons) == 1:
            found = far_points(self.law.alphas[0], epsilons[0], lead, self.start)
            return (_turning(p, first.side) for p in found)
        there = _turning(far_point_of_sum(self.law.alphas, epsilons, lead, self.start), first.side)
        return sequence(damping, there, panels=panels, count=self.count)


def _point(here: Turning) -> Point:
    return Point(here.n, arb(here.amplitude, here.amplitude_error).log(), here.tau)


def _turning(point: Point, first: int) -> Turning:
    """``first``: the side of turning point 0."""
    amplitude, tau = point.amplitude, point.tau
    side = -first if point.n % 2 else first
    return Turning(point.n, side, amplitude.mid(), tau.mid(), arb(amplitude.rad()), arb(tau.rad()))
