"""Which way to the turning points start … start + count - 1 of one law: by pieces, by interpolation, or by one jump.

* **By pieces** (``swing.passage``): any strength, tens of milliseconds for each half-swing.
* **Interpolation** in the amplitude (``swing.panels``): some dozens of half-swings by pieces, then some hundredths of a
  millisecond each; any law, where the local strengths are small enough for the majorant.
* **Jump** (``far``): one law with alpha > 1 and a far start, at a cost that does not grow with it.

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

from asymptotics.costs import half_swing_seconds, interpolation_seconds, jump_seconds, stiff_seconds
from asymptotics.half_swings.finite import ROUTE
from asymptotics.law import Law
from asymptotics.swing.damping import Damping
from asymptotics.swing.linear import ROUTE as CLOSED
from asymptotics.swing.panels import ROUTE as INTERPOLATED
from asymptotics.swing.panels import Panels, panels_of
from asymptotics.swing.passage import INTEGRATED
from asymptotics.swing.sequence import Turning, sequence
from asymptotics.swing.taylor import GUARD
from asymptotics.turning.far import Point, far_points

FAR = 200_000
"""A start beyond which one jump is cheaper than all half-swings, even by interpolation."""
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

    @classmethod
    def of(cls, law: Law, start: int, count: int, bits: int) -> "Plan":
        """The cheapest way that is known, by estimates (measured once, good to a factor of about three)."""
        jump = len(law.terms) == 1 and bool(law.terms[0].velocity > 1) and start > FAR
        steps = _LEAD if jump else start + count
        pieces = panels_of(law, bits).pieces(steps)
        apart = sum(not (t.velocity.is_rational and t.velocity.rational.denominator <= 20) for t in law.terms)
        seconds = half_swing_seconds(pieces + 1, bits, len(law.terms), apart) + interpolation_seconds(steps)
        seconds += stiff_seconds(panels_of(law, bits).sizes, bits)
        return cls(law, start, count, jump, 0 < pieces < steps, seconds + (jump_seconds(bits) if jump else 0.0))

    @property
    def method(self) -> str:
        """The routes by name."""
        if self.jump:
            return f"local expansions, {ROUTE} and Abel function"
        if panels_of(self.law, 64).closed:
            return CLOSED
        return f"{INTEGRATED}, {INTERPOLATED}" if self.interpolates else INTEGRATED

    def turnings(self) -> Iterator[Turning]:
        """Turning points at the current precision, from 0 or (after a jump) from ``start`` on."""
        with ctx.workprec(ctx.prec + GUARD):
            damping = Damping.of_law(self.law)
        panels = panels_of(self.law, ctx.prec) if self.interpolates else None
        if not self.jump:
            return sequence(damping, panels=panels, count=self.start + self.count)
        return self._jumped(damping, panels)

    def _jumped(self, damping: Damping, panels: Panels | None) -> Iterator[Turning]:
        term = self.law.terms[0]
        lead = map(_point, sequence(damping, panels=panels, count=_LEAD))
        return map(_turning, far_points(term.velocity, term.strength.ball(), lead, self.start))


def _point(here: Turning) -> Point:
    return Point(here.n, arb(here.amplitude, here.amplitude_error).log(), here.tau)


def _turning(point: Point) -> Turning:
    amplitude, tau = point.amplitude, point.tau
    side = -1 if point.n % 2 else 1
    return Turning(point.n, side, amplitude.mid(), tau.mid(), arb(amplitude.rad()), arb(tau.rad()))
