"""Turning points of any index where every alpha > 1: a certified head of the orbit, then one jump.

*One law.*  The head is iterated by the series of the quarter-swing (``half_swings.finite``) until the local strength is
small; the Abel function (``abel``) leads from its last point to any later one, and the series on from there.  Where
delta is too large for the series at the start, another certified route has to lead the way.

*Sums.*  Another certified route leads until delta of the least exponent is small; the integral of the slow flow
(``abel_flow``) leads on.  ``planned`` weighs terms, whose coefficients cost, against the length of the head.

>>> from asymptotics.numbers.exact import parse_real
>>> with ctx.workprec(100):
...     point = next(far_points(parse_real("3", "--alpha"), arb(1) / 50, [Point(0, arb(0), arb(0))], 10**12))
>>> point.n, point.amplitude.str(12), point.tau.str(15)
(1000000000000, '[4.60658865957e-6 +/- ...]', '[3141592653589.80 +/- ...]')
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import chain, islice
from math import ceil, log2

from flint import arb, ctx

from asymptotics.costs import flow_seconds, interpolation_seconds
from asymptotics.errors import UndecidedError
from asymptotics.half_swings.finite import FiniteQuarter, finite_quarter, series_reach
from asymptotics.half_swings.finite_majorant import widest
from asymptotics.moments.certified import moment
from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.abel import FOLLOWING, AbelFunction, abel_function
from asymptotics.turning.abel_flow import FOLLOWING as FLOW_FOLLOWING
from asymptotics.turning.abel_flow import abel_flow

HEAD = 300
"""Half-swings iterated before the jump, and one more for each bit."""
LEAD_ORDER = 56
"""The order of the series at which they take over."""
MAX_TERMS = 40
_MOST_TERMS, _REACH = 9, 0.4
_SPARE = 24  # bits that the steps of a head may lose, which a jump does not
_SLOW = 3  # interpolation in ln A, in units of that in A


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


@dataclass(frozen=True)
class FarPlan:
    """A sum's jump: ``terms`` of the flow from delta_1 = ``delta`` on, after a head of about ``head`` half-swings."""

    terms: int
    delta: float
    head: int
    seconds: float


def planned(alphas: Sequence[ExactReal], bits: int, start: int) -> FarPlan:
    """The cheapest plan for ``bits`` bits of the point ``start``; estimates that choose and claim nothing."""
    with ctx.workprec(64):
        least = min(a.ball() for a in alphas)
        gain = float((least - 1) * arb.pi() * moment(least + 1))
    options = []
    for terms in range(2, _MOST_TERMS + 1):
        delta = _REACH * 2.0 ** ((log2(start) + _SPARE - bits) / (2 * terms - 1))
        head = min(1 / (gain * delta), 1e30) if delta > 0 else 1e30
        order = 2 * (terms + FLOW_FOLLOWING) - 1
        seconds = flow_seconds(order, len(alphas), bits) + _SLOW * interpolation_seconds(head)
        options.append(FarPlan(terms, delta, ceil(head), seconds))
    return min(options, key=lambda option: option.seconds)


def series_points(quarter: FiniteQuarter, epsilon: arb, here: Point) -> Iterator[Point]:
    """Turning points from ``here`` on, as far as the series of ``quarter`` reach."""
    tau = here.tau
    for n, (x, e, time) in enumerate(quarter.orbit([epsilon], here.log.mid(), arb(here.log.rad())), start=here.n):
        yield Point(n, x + arb(0, e), tau)
        tau += time


def far_points(alpha: ExactReal, epsilon: arb, lead: Iterable[Point], start: int) -> Iterator[Point]:
    """Turning points ``start``, start + 1, … of one law at the current precision.

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


def far_point_of_sum(alphas: Sequence[ExactReal], epsilons: Sequence[arb], lead: Iterable[Point], start: int) -> Point:
    """Turning point ``start`` of a sum at the current precision; ``lead`` as in ``far_points``."""
    laws = sorted(zip(alphas, epsilons, strict=True), key=lambda law: float(law[0].ball()))
    alphas, epsilons = zip(*laws, strict=True)
    plan = planned(alphas, ctx.prec, start)
    here = next(p for p in lead if p.n >= start or _delta(alphas[0], epsilons[0], p) < plan.delta)
    if here.n >= start:
        return here
    log, time = abel_flow(alphas, epsilons, plan.terms).advance(here.log, start - here.n)
    return Point(start, log, here.tau + time)


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
