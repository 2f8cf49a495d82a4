"""Route "abel-flow": a sum of powers of the velocity, every alpha > 1, far from the start, by the slow flow.

Powers of the amplitude would need logarithms where exponents resonate; the integral of the slow flow does not
(``abel_flow``).  A certified head leads until the local strength is small, the integral to the point asked for, and the
half-swings go on from there.
"""

from collections.abc import Iterator
from operator import attrgetter

from asymptotics.flow.turning import TurningState
from asymptotics.numbers.context import ctx
from asymptotics.return_map.panels import panels_of
from asymptotics.turning.enclosing import EnclosedMotion, bits_of, enclosed
from asymptotics.turning.jump import head_end, jumped_by_flow, planned, with_a_head
from asymptotics.turning.result import TurningPoints
from asymptotics.turning.route import Route
from asymptotics.turning.routes.interpolated import mapped_in_words
from asymptotics.turning.routes.stepping import require_moderate, swing_seconds
from asymptotics.turning.table import PointsRequest, Progress

_LEAST = 1000
"""Starts up to here are no farther than the head of any plan."""


def serves(request: PointsRequest) -> float | None:
    """The seconds; None unless every exponent is above 1, and the start lies beyond the head."""
    law = request.law
    if not law.is_pure or not all(a > 1 for a in law.alphas) or len(law.terms) < 2 or request.start <= _LEAST:
        return None
    return _seconds(request)


def points(request: PointsRequest, progress: Progress = lambda done: None) -> TurningPoints:
    """The turning points, which never end; LimitError for the sizes, UndecidedError where delta stays too large."""
    require_moderate(request, _seconds(request))
    laws = sorted(request.law.terms, key=attrgetter("velocity"))
    alphas = [t.velocity for t in laws]

    def orbit() -> EnclosedMotion:
        plan, epsilons = planned(alphas, ctx.prec, request.start), [t.strength.ball() for t in laws]

        def far(lead: Iterator[TurningState]) -> TurningState:
            # The plan guesses the length of the head; the strength decides where it ends.
            here = head_end(lead, alphas[0], epsilons[0], request.start, plan.delta)
            if here.n >= request.start:
                return here
            return jumped_by_flow(alphas, epsilons, plan.terms, here, request.start)

        return with_a_head(request, plan.head, far)

    words = mapped_in_words(request, " and Abel function by the slow flow")
    return enclosed(request, orbit, lambda bits: words, bits_of(request), progress)


def _seconds(request: PointsRequest) -> float:
    bits = bits_of(request)
    far = planned(request.law.alphas, bits, request.start)
    head = min(far.head, request.start)
    return swing_seconds(request, head + request.count, panels_of(request.law, bits).pieces(head)) + far.seconds


ROUTE = Route(
    "abel-flow",
    "a sum of powers of the velocity, every alpha > 1, a start beyond some thousand half-swings",
    "a certified head, then one jump by the integral of the slow flow",
    serves,
    points,
)
