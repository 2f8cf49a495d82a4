"""Turning points by enclosures: an orbit is followed in balls until every digit asked for is decided.

The *first* turning point is the start itself, from rest, or what a start in motion reaches, if it turns at all; the
points *after* it are the route's business.  Both are found anew at each precision.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

from flint import arb

from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.linear_spring.near_critical import lost_bits, require_brief
from asymptotics.flow.sequence import first_from
from asymptotics.flow.taylor import GUARD
from asymptotics.flow.turning import TurningState, at_rest
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for
from asymptotics.numbers.precision import at_growing_precision
from asymptotics.turning.result import TurningPoints
from asymptotics.turning.table import PointsDone, PointsRequest, Progress, named, rounded

MANY = 200_000
"""Half-swings beyond this number are jumped over, and cost no bits."""
_SPARE, _SPARE_IN_MOTION = 20, 48  # bits beyond the digits: one value in thousands is too near a tie for them
_DOUBLINGS = 5


@dataclass(frozen=True)
class EnclosedMotion:
    """A motion at the current precision: ``first`` turning point, or why there is none; the sequence ``after`` it."""

    first: Callable[[], TurningState | str]
    after: Callable[[TurningState], Iterator[TurningState]]


def bits_of(request: PointsRequest) -> int:
    """The working precision to begin with, for powers of the velocity: digits, rounding errors that add, and what a
    half-swing next to critical damping loses."""
    return _without_losses(request) + lost_bits(request.law)


def require_soon(request: PointsRequest) -> None:
    """LimitError at once where a half-swing next to critical damping would last too long, before any route is asked."""
    if request.law.is_pure:
        require_brief(request.law, request.last + 1, request.digits, _without_losses(request))


def _without_losses(request: PointsRequest) -> int:
    spare = _SPARE_IN_MOTION if request.in_motion else _SPARE
    swings = min(request.start, MANY) + request.count
    # Errors of n half-swings add: log2(n) bits for the amplitudes, and as many for the times.
    return bits_for(request.digits, spare) + 2 * swings.bit_length()


def damping_of(request: PointsRequest) -> Damping:
    """The forces of powers of the velocity, a little sharper than the current precision."""
    # The Taylor coefficients are computed with so many bits more; the strengths must not be less sharp.
    with ctx.workprec(ctx.prec + GUARD):
        return Damping.of_law(request.law)


def first_of(request: PointsRequest, damping: Damping) -> TurningState | str:
    """Turning point 0 under powers of the velocity, or why there is none."""
    if not request.in_motion:
        return at_rest(arb(1))
    return first_from(LinearSpring(damping), request.place.ball(), request.speed.ball())


def in_words(request: PointsRequest, by: str, bits: int) -> str:
    """How the points were found."""
    return f"half-swing by half-swing, {by} in balls" + ("" if request.in_motion else f" of {bits} bits")


def enclosed(
    request: PointsRequest,
    orbit: Callable[[], EnclosedMotion],
    method: Callable[[int], str],
    bits: int,
    progress: Progress,
    *,
    doublings: int = _DOUBLINGS,
) -> TurningPoints:
    """The table of the points of ``orbit``, from ``bits`` of working precision on; ``method`` tells how, and the bits.

    UndecidedError where ``doublings`` of the precision do not decide how the motion goes on.
    """

    kept = PointsDone(request)

    def attempt(bits: int) -> TurningPoints:
        # Made anew at each precision: strengths are balls of the precision at which they become balls.
        motion = orbit()
        first = motion.first()
        if isinstance(first, str):
            return request.table((), method(bits), {"n": -1, "reason": first})
        unit = named(request, first) if request.in_motion else None
        start, made = first if request.in_motion else None, kept.begin(lambda: method(bits), unit)
        points, ended = rounded(request, motion.after(first), start, progress, made)
        return request.table(points, method(bits), ended, unit)

    with kept:
        return at_growing_precision(attempt, request.digits, bits, max_bits=bits << doublings)
