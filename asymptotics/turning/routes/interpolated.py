"""Route "interpolated": powers of the velocity beside the linear spring, by the return map of their exponents.

The return map is interpolated in the amplitude (``return_map.panels``): the nodes cost as much as dozens of half-swings
by pieces, or one collocation of the quarter-swing; each half-swing then takes some hundredths of a millisecond, of any
law with the same exponents.  It serves where the local strengths are small enough for the majorant, and is made where
the half-swings repay the nodes; the others are followed by pieces.

>>> from asymptotics.law import Law
>>> law = Law({"3/2": "1/5"})
>>> serves(PointsRequest.read(law, 5, 30)) < 2, serves(PointsRequest.read(law, 5000, 30)) < 60
(True, True)
"""

from asymptotics.flow.linear_spring.near_critical import most_swings
from asymptotics.flow.sequence import sequence
from asymptotics.numbers.context import ctx
from asymptotics.return_map.half_swing_map import INTEGRATED
from asymptotics.return_map.half_swing_map import ROUTE as INTERPOLATED
from asymptotics.return_map.panels import COLLOCATED, panels_of
from asymptotics.return_map.sequence import Interpolated
from asymptotics.turning.enclosing import EnclosedMotion, bits_of, damping_of, enclosed, first_of, in_words
from asymptotics.turning.result import TurningPoints
from asymptotics.turning.route import Route
from asymptotics.turning.routes.stepping import require_moderate, swing_seconds
from asymptotics.turning.table import PointsRequest, Progress


def serves(request: PointsRequest) -> float | None:
    """The seconds with a new map, nodes included; None where a closed form beats it.

    They do not depend on what was asked before, and neither do the words, whatever map is there already.
    """
    if not request.law.is_pure or panels_of(request.law, bits_of(request)).closed:
        return None
    return swing_seconds(request, *_swings_and_pieces(request))


def points(request: PointsRequest, progress: Progress = lambda done: None) -> TurningPoints:
    """The turning points as far as they exist."""
    steps, pieces = _swings_and_pieces(request)
    require_moderate(request, swing_seconds(request, steps, pieces))

    def orbit() -> EnclosedMotion:
        damping, panels = damping_of(request), panels_of(request.law, ctx.prec)
        return EnclosedMotion(
            lambda: first_of(request, damping),
            lambda first: sequence(Interpolated(damping, panels, request.last + 1), first),
        )

    return enclosed(request, orbit, lambda bits: mapped_in_words(request), bits_of(request), progress)


def mapped_in_words(request: PointsRequest, then: str = "") -> str:
    """How half-swings are found that a map may serve: the words are the same whichever of them it does.

    The bits are those of the first attempt, as a map and the pieces may need more of them at different points.
    """
    bits = bits_of(request)
    nodes = [COLLOCATED] if panels_of(request.law, bits).collocated else []
    found = in_words(request, ", ".join((INTEGRATED, *nodes, INTERPOLATED)) + then, bits)
    return found if request.in_motion else f"{found} or more"


def _swings_and_pieces(request: PointsRequest) -> tuple[int, int]:
    """How many half-swings there are, and how many by pieces they are worth."""
    steps = int(min(request.last + 1, most_swings(request.law)))
    return steps, panels_of(request.law, bits_of(request)).pieces(steps)


ROUTE = Route(
    "interpolated",
    "powers of the velocity beside the linear spring, with times",
    f"{INTERPOLATED} of the return map, {INTEGRATED} where no panel serves or pays",
    serves,
    points,
)
