"""Turning points of any index where every alpha > 1: a certified head of the orbit, then one jump.

*One law.*  The head leads until the local strength is small; the Abel function (``abel``) leads from its last point to
any later one.

*Sums.*  The head leads until delta of the least exponent is small; the integral of the slow flow (``abel_flow``) leads
on.  ``planned`` weighs terms, whose coefficients cost, against the length of the head.

>>> from asymptotics.numbers.exact import parse_real
>>> with ctx.workprec(100):
...     start = TurningState(0, 1, arb(1) / 1000, arb(0), arb(0), arb(0))
...     there = jumped(parse_real("3", "--alpha"), arb(50), start, 10**12)
>>> there.n, there.x.str(12), there.tau.str(15)
(1000000000000, '[9.21317728013e-8 +/- ...]', '[3141592653589.79 +/- ...]')
"""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from math import ceil, log2

from flint import arb

from asymptotics.costs import flow_seconds, interpolation_seconds
from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.finite_majorant import widest
from asymptotics.expansions.moments.certified import moment
from asymptotics.flow.sequence import sequence
from asymptotics.flow.turning import TurningState
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.exact import ExactReal
from asymptotics.return_map.panels import panels_of
from asymptotics.return_map.sequence import Interpolated
from asymptotics.turning.abel import FOLLOWING, AbelFunction, abel_function
from asymptotics.turning.abel_flow import FOLLOWING as FLOW_FOLLOWING
from asymptotics.turning.abel_flow import abel_flow
from asymptotics.turning.enclosing import EnclosedMotion, damping_of, first_of
from asymptotics.turning.table import PointsRequest

HEAD = 300
"""Half-swings of the head of one law, and one more for each bit: delta is then so small that few terms will do."""
# A limit of work: more terms are too dear, and a strength that needs them is refused as too large.
MAX_TERMS = 40
# Terms and the share of the reach that a plan for sums looks at: estimates, whose defect is bounded afterwards.  The
# point 10^9 of two laws costs the same within a fifth with 6 to 12 terms, and with half the reach
# (``benchmarks/constants.json``).
_MOST_TERMS, _REACH = 9, 0.4
_NEAR, _WITHIN = 0.6, 0.5  # delta in units of the reach: where a jump may begin, and where a head ends at the latest
_SPARE = 24  # bits that the steps of a head may lose, which a jump does not
_SLOW = 3  # interpolation in ln A, in units of that in A


@dataclass(frozen=True)
class FarPlan:
    """A sum's jump: ``terms`` of the flow from delta_1 = ``delta`` on, after a head of about ``head`` half-swings."""

    terms: int
    delta: float
    head: int
    seconds: float


def with_a_head(
    request: PointsRequest, head: int, far: Callable[[Iterator[TurningState]], TurningState]
) -> EnclosedMotion:
    """The motion as far as turning point ``start``, which ``far`` finds from a head, and half-swing by half-swing on.

    The head is interpolated as is worth while for ``head`` half-swings.
    """
    damping, panels = damping_of(request), panels_of(request.law, ctx.prec)

    def after(first: TurningState) -> Iterator[TurningState]:
        there = far(sequence(Interpolated(damping, panels, first.n + head), first))
        return sequence(Interpolated(damping, panels, there.n + request.count), there)

    return EnclosedMotion(lambda: first_of(request, damping), after)


def planned(alphas: Sequence[ExactReal], bits: int, start: int) -> FarPlan:
    """The cheapest plan for ``bits`` bits of the point ``start``; estimates that choose and claim nothing."""
    with ctx.workprec(64):
        least = min(a.ball() for a in alphas)
        # By how much 1/delta_1 grows in a half-swing, at least.
        gain = float((least - 1) * arb.pi() * moment(least + 1))
    options = []
    for terms in range(2, _MOST_TERMS + 1):
        # The sum of the defects, about (delta/reach)^(2K-1), counts against Psi = start: relative to it 2^-bits is
        # wanted.
        delta = _REACH * 2.0 ** ((log2(start) + _SPARE - bits) / (2 * terms - 1))
        head = min(1 / (gain * delta), 1e30) if delta > 0 else 1e30
        order = 2 * (terms + FLOW_FOLLOWING) - 1
        seconds = flow_seconds(order, len(alphas), bits) + _SLOW * interpolation_seconds(head)
        options.append(FarPlan(terms, delta, ceil(head), seconds))
    return min(options, key=lambda option: option.seconds)


def head_of(alpha: ExactReal, bits: int) -> int:
    """How many half-swings the head of one law has; the Abel function of ``jumped`` serves from its end on.

    1/delta grows by g = (alpha-1) pi M_(alpha+1) at least in each half-swing (derivation ``abel-defect``), whatever the
    start, so delta < 1/(g n) after n of them.
    """
    with ctx.workprec(64):
        gain = (alpha - 1).ball() * arb.pi() * moment(alpha.ball() + 1)
        needed = 1 / (gain * _WITHIN * _reach(alpha))
        return max(HEAD + bits, ceil(float(needed)) + 1)


def head_end(lead: Iterable[TurningState], alpha: ExactReal, epsilon: arb, start: int, within: float) -> TurningState:
    """The first point of ``lead`` with delta = epsilon A^(alpha-1) < within; or ``start``, if it comes before."""
    # delta decides in balls, not the number of half-swings that was planned.
    return next(p for p in lead if p.n >= start or _delta(alpha, epsilon, p) < within)


def jumped(alpha: ExactReal, epsilon: arb, here: TurningState, start: int) -> TurningState:
    """Turning point ``start`` of one law from the point ``here``; UndecidedError where delta is too large."""
    delta, weight = _delta(alpha, epsilon, here), alpha.ball() - 1
    abel = _suited(alpha, delta)
    reached = abel.advance(delta, start - here.n)
    # Through the ratio of the strengths: epsilon cancels, and the amplitude keeps its relative digits.
    log = _log(here) + (reached / delta).log() / weight
    return _arrived(here, start, log, here.tau + abel.time_between(delta, reached))


def jumped_by_flow(
    alphas: Sequence[ExactReal], epsilons: Sequence[arb], terms: int, here: TurningState, start: int
) -> TurningState:
    """Turning point ``start`` of a sum, the least exponent first, from the point ``here``."""
    log, time = abel_flow(alphas, epsilons, terms).advance(_log(here), start - here.n)
    return _arrived(here, start, log, here.tau + time)


def _arrived(here: TurningState, n: int, log: arb, tau: arb) -> TurningState:
    """The point n of the orbit through ``here``, from balls of ln A and of the time."""
    amplitude, side = log.exp(), here.side if (n - here.n) % 2 == 0 else -here.side
    return TurningState(n, side, amplitude.mid(), tau.mid(), arb(amplitude.rad()), arb(tau.rad()))


def _suited(alpha: ExactReal, delta: arb) -> AbelFunction:
    """As many terms as make the defect as small as the precision; a float chooses, the bound decides."""
    # A choice in doubles: (delta/reach)^(2K + FOLLOWING) = 2^-(precision + 16) solved for K.
    x = float(delta) / _reach(alpha)
    if not x < _NEAR:
        raise UndecidedError(f"delta = {float(delta):.3g} is still too large for the Abel function of alpha = {alpha}")
    terms = max(4, ceil(((ctx.prec + 16) / -log2(x) - FOLLOWING) / 2) + 1)
    if terms > MAX_TERMS:
        raise UndecidedError(f"the Abel function of alpha = {alpha} needs {terms} terms at delta = {float(delta):.3g}")
    return abel_function(alpha, terms)


@lru_cache(maxsize=64)
def _reach(alpha: ExactReal) -> float:
    """About the radius of the circle on which the defects are bounded."""
    with ctx.workprec(64):
        # The middle of the shares of ``abel``.
        return 0.7 * float(widest([alpha.ball()], [arb(1)], whole=True).radii[0])


def _delta(alpha: ExactReal, epsilon: arb, here: TurningState) -> arb:
    return epsilon * ((alpha.ball() - 1) * _log(here)).exp()


def _log(here: TurningState) -> arb:
    """ln A of a turning point, with all that is uncertain about it."""
    return arb(here.amplitude, here.amplitude_error).log()
