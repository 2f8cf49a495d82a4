"""Turning points of any index for one law with alpha > 1: a certified head of the orbit, then one jump.

The head is iterated by the series of the quarter-swing (``half_swings.finite``) until the local strength is small; the
Abel function (``abel``) leads from its last point to any later one, and the series on from there.  Where delta is too
large for the series at the start, another certified route has to lead the way.

>>> from asymptotics.numbers.exact import parse_real
>>> with ctx.workprec(100):
...     point = next(far_points(parse_real("3", "--alpha"), arb(1) / 50, [Point(0, arb(0), arb(0))], 10**12))
>>> point.n, point.amplitude.str(12), point.tau.str(15)
(1000000000000, '[4.60658865957e-6 +/- ...]', '[3141592653589.80 +/- ...]')
"""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import chain, islice
from math import ceil, log2

from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.half_swings.finite import FiniteQuarter, finite_quarter, series_reach
from asymptotics.half_swings.finite_majorant import widest
from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.abel import FOLLOWING, AbelFunction, abel_function

HEAD = 300
"""Half-swings iterated before the jump, and one more for each bit."""
LEAD_ORDER = 56
"""The order of the series at which they take over."""
MAX_TERMS = 40


@dataclass(frozen=True)
class Point:
    """Turning point n: ln A_n (A in units of x0) and the time, as balls."""

    n: int
    log: arb
    tau: arb

    @property
    def amplitude(self) -> arb:
        """A_n = |x_n|/x0."""
        return self.log.exp()


def series_points(quarter: FiniteQuarter, epsilon: arb, here: Point) -> Iterator[Point]:
    """Turning points from ``here`` on, as far as the series of ``quarter`` reach."""
    tau = here.tau
    for n, (x, e, time) in enumerate(quarter.orbit([epsilon], here.log.mid(), arb(here.log.rad())), start=here.n):
        yield Point(n, x + arb(0, e), tau)
        tau += time


def far_points(alpha: ExactReal, epsilon: arb, lead: Iterable[Point], start: int) -> Iterator[Point]:
    """Turning points ``start``, start + 1, … at the current precision.

    ``lead``: turning points from a known one on, as many as are asked for; taken until the series reach on from there.
    UndecidedError if delta never becomes small enough for the Abel function (alpha next to 1).
    """
    bits = ctx.prec - 16
    lead, within = iter(lead), series_reach(alpha, bits, LEAD_ORDER)
    here = next(p for p in lead if p.n >= start or _delta(alpha, epsilon, p) < within)
    if here.n >= start:
        return chain([here], lead)
    quarter = finite_quarter([alpha], [_delta(alpha, epsilon, here)], bits)
    steps = min(start - here.n, HEAD + bits)
    last = next(islice(series_points(quarter, epsilon, here), steps, None))
    if last.n < start:
        last = _jump(alpha, epsilon, last, start)
    tail = finite_quarter([alpha], [_delta(alpha, epsilon, last)], bits)
    return series_points(tail, epsilon, last)


def _jump(alpha: ExactReal, epsilon: arb, here: Point, start: int) -> Point:
    delta, weight = _delta(alpha, epsilon, here), alpha.ball() - 1
    abel = _suited(alpha, delta)
    reached = abel.advance(delta, start - here.n)
    return Point(start, here.log + (reached / delta).log() / weight, here.tau + abel.time_between(delta, reached))


def _suited(alpha: ExactReal, delta: arb) -> AbelFunction:
    """As many terms as make the defect as small as the precision; a float chooses, the bound decides."""
    reach = 0.7 * float(widest([alpha.ball()], [arb(1)], whole=True).radii[0])
    x = float(delta) / reach
    if not x < 0.6:
        raise UndecidedError(f"delta = {float(delta):.3g} is still too large for the Abel function of alpha = {alpha}")
    terms = max(4, ceil(((ctx.prec + 16) / -log2(x) - FOLLOWING) / 2) + 1)
    if terms > MAX_TERMS:
        raise UndecidedError(f"the Abel function of alpha = {alpha} needs {terms} terms at delta = {float(delta):.3g}")
    return abel_function(alpha, terms)


def _delta(alpha: ExactReal, epsilon: arb, here: Point) -> arb:
    return epsilon * ((alpha.ball() - 1) * here.log).exp()
