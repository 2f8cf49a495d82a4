"""Route "abel-series": one power of the velocity with alpha > 1, far from the start, by the Abel function of its map.

Psi(F) = Psi + 1 counts half-swings (Abel's equation): after a certified head of some hundred half-swings one evaluation
of Psi and one Newton step lead to any later turning point (``jump``, ``abel``).
"""

from collections.abc import Iterator
from itertools import islice

from asymptotics.costs import jump_seconds
from asymptotics.flow.turning import TurningState
from asymptotics.numbers.context import ctx
from asymptotics.return_map.panels import panels_of
from asymptotics.turning.enclosing import EnclosedMotion, bits_of, enclosed
from asymptotics.turning.jump import HEAD, head_of, jumped, with_a_head
from asymptotics.turning.result import TurningPoints
from asymptotics.turning.route import Route
from asymptotics.turning.routes.interpolated import mapped_in_words
from asymptotics.turning.routes.stepping import require_moderate, swing_seconds
from asymptotics.turning.table import PointsRequest, Progress


def serves(request: PointsRequest) -> float | None:
    """The seconds; None unless one alpha > 1 acts alone, and the start lies beyond the head."""
    law = request.law
    if not law.is_pure or len(law.terms) > 1 or not law.alphas[0] > 1:
        return None
    bits = bits_of(request)
    # No head is shorter, and its length takes a majorant.
    if request.start <= HEAD + bits or request.start <= (head := head_of(law.alphas[0], bits)):
        return None
    pieces = panels_of(law, bits).pieces(head)
    return swing_seconds(request, head + request.count, pieces) + jump_seconds(bits)


def points(request: PointsRequest, progress: Progress = lambda done: None) -> TurningPoints:
    """The turning points, which never end; LimitError for the sizes, UndecidedError where delta stays too large."""
    require_moderate(request, serves(request) or 0.0)
    alpha, epsilon = request.law.alphas[0], request.law.terms[0].strength

    def orbit() -> EnclosedMotion:
        head = head_of(alpha, ctx.prec)

        def far(lead: Iterator[TurningState]) -> TurningState:
            # A head of a fixed length, after which delta < 1/(g n) is proved (``head_of``).
            here = next(islice(lead, min(head, request.start), None))
            return jumped(alpha, epsilon.ball(), here, request.start)

        return with_a_head(request, head, far)

    return enclosed(
        request, orbit, lambda bits: mapped_in_words(request, " and Abel function"), bits_of(request), progress
    )


ROUTE = Route(
    "abel-series",
    "one power of the velocity with alpha > 1, a start beyond some hundred half-swings",
    "a certified head, then one jump by the Abel function of the return map",
    serves,
    points,
)
