"""Route "interpolated": powers of the velocity beside the linear spring, many half-swings.

The return map is interpolated in the amplitude (``return_map.panels``): the nodes cost as much as dozens of half-swings
by pieces, or one collocation of the quarter-swing; each half-swing then takes some hundredths of a millisecond.  It
serves where the local strengths are small enough for the majorant, and pays where the half-swings repay the nodes.

>>> from asymptotics.law import Law
>>> serves(Request.read(Law({"3/2": "1/5"}), 5, 30)) is None, serves(Request.read(Law({"3/2": "1/5"}), 5000, 30)) < 60
(True, True)
"""

from asymptotics.flow.linear_spring.near_critical import most_swings
from asymptotics.flow.sequence import sequence
from asymptotics.numbers.context import ctx
from asymptotics.return_map.half_swing_map import INTEGRATED
from asymptotics.return_map.panels import COLLOCATED, panels_of
from asymptotics.return_map.panels import ROUTE as INTERPOLATED
from asymptotics.return_map.sequence import Interpolated
from asymptotics.turning.enclosing import EnclosedMotion, bits_of, damping_of, enclosed, first_of, in_words
from asymptotics.turning.result import TurningPoints
from asymptotics.turning.route import Route
from asymptotics.turning.routes.stepping import require_moderate, swing_seconds
from asymptotics.turning.table import Progress, Request


def serves(request: Request) -> float | None:
    """The seconds, nodes included; None where panels do not pay from the amplitude 1 on, or a closed form beats them.

    After a start in motion the amplitude is not known beforehand: there the panels themselves weigh what is left.
    """
    if not request.law.is_pure or panels_of(request.law, bits_of(request)).closed:
        return None
    steps, pieces = _worth(request)
    # pieces = steps: no panel pays, and ``stepping`` is the same without panels.
    return swing_seconds(request, steps, pieces) if request.in_motion or 0 < pieces < steps else None


def points(request: Request, progress: Progress = lambda done: None) -> TurningPoints:
    """The turning points as far as they exist."""
    steps, pieces = _worth(request)
    require_moderate(request, swing_seconds(request, steps, pieces))

    def orbit() -> EnclosedMotion:
        damping, panels = damping_of(request), panels_of(request.law, ctx.prec)
        return EnclosedMotion(
            lambda: first_of(request, damping),
            lambda first: sequence(Interpolated(damping, panels, request.last + 1), first),
        )

    def method(bits: int) -> str:
        return in_words(request, nodes_in_words(request, bits) if 0 < pieces < steps else INTEGRATED, bits)

    return enclosed(request, orbit, method, bits_of(request), progress)


def nodes_in_words(request: Request, bits: int) -> str:
    """The routes by name, those of the nodes as they were taken."""
    collocated = any(panel.by == COLLOCATED for panel in panels_of(request.law, bits).made)
    return ", ".join((INTEGRATED, *([COLLOCATED] if collocated else []), INTERPOLATED))


def _worth(request: Request) -> tuple[int, int]:
    """How many half-swings there are, and how many by pieces they are worth."""
    steps = int(min(request.last + 1, most_swings(request.law)))
    return steps, panels_of(request.law, bits_of(request)).pieces(steps)


ROUTE = Route(
    "interpolated",
    "powers of the velocity beside the linear spring, with times, where many half-swings repay the nodes",
    f"{INTERPOLATED} of the return map",
    serves,
    points,
)
