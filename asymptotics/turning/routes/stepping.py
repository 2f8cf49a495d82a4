"""Route "stepping": any loss and any spring of the place, from rest or in motion, certified half-swing by half-swing.

    X'' + V'(X) + sum_i epsilon_i |X|^m_i X'|X'|^(alpha_i-1) = 0,    X(0) = x0, X'(0) = v0,  in the units of the
    strengths.

Every half-swing is enclosed by local expansions and Taylor steps: tens of milliseconds each, at any strength.  Powers
of the velocity beside the linear spring are nonexpansive, two motions never part (``flow.linear_spring``); elsewhere
they part at a rate that is bounded (``flow.wells``).

>>> from asymptotics.law import Law
>>> table = points(PointsRequest.read(Law({"3/2": "1/10"}, spring="pendulum"), 2, 12, times=True, x0=2))
>>> table.points[1].x, table.points[1].tau, table.certified
('-1.53184190291', '3.94540754042', True)
>>> points(PointsRequest.read(Law({"3/2": "1/10"}, spring="pendulum"), 2, 12, x0=0, v0=3)).ended
{'n': -1, 'reason': 'rotates'}
>>> points(PointsRequest.read(Law({"3/2": "1/10"}), 2, 12, x0=0, v0=1)).first
{'amplitude': '0.933516582123', 'tau': '1.53303122970'}
"""

from asymptotics.costs import half_swing_seconds, interpolation_seconds, stiff_seconds
from asymptotics.errors import InputError, LimitError
from asymptotics.flow.linear_spring.linear import ROUTE as CLOSED
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.linear_spring.near_critical import most_swings
from asymptotics.flow.sequence import first_from, sequence
from asymptotics.flow.taylor import GUARD
from asymptotics.flow.turning import TurningState, at_rest
from asymptotics.flow.wells.even_well import EvenWell
from asymptotics.flow.wells.force import WellForce, estimated_seconds
from asymptotics.flow.wells.rational_stops import rational_stops
from asymptotics.flow.wells.trapping_regions import require_inside
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for
from asymptotics.return_map.half_swing_map import INTEGRATED
from asymptotics.return_map.panels import panels_of
from asymptotics.running.budget import require_seconds
from asymptotics.turning.enclosing import EnclosedMotion, bits_of, damping_of, enclosed, first_of, in_words
from asymptotics.turning.result import TurningPoints
from asymptotics.turning.route import Route
from asymptotics.turning.table import PointsRequest, Progress

MAX_DIGITS, MAX_LAST = 1000, 100_000
METHOD = "half-swing by half-swing in the well, local expansions and Taylor steps in balls"
# Bits beyond the digits to begin with, and how often they are doubled: fewer make a second attempt likely, more make
# the first one slower.
_SPARE, _DOUBLINGS = 36, 3


def serves(request: PointsRequest) -> float:
    """The seconds: every request is served."""
    if request.law.is_pure:
        return swing_seconds(request, int(min(request.last + 1, most_swings(request.law))))
    return estimated_seconds(WellForce.of(request.law.terms), request.last + 1, _bits(request))


def swing_seconds(request: PointsRequest, steps: int, pieces: int | None = None) -> float:
    """``steps`` half-swings under powers of the velocity, ``pieces`` of them by pieces and the rest interpolated."""
    law, bits = request.law, bits_of(request)
    apart = sum(not (t.velocity.is_rational and t.velocity.rational.denominator <= 20) for t in law.terms)
    panels = panels_of(law, bits)
    pieces = (0 if panels.closed else steps) if pieces is None else pieces
    seconds = half_swing_seconds(pieces + 1, bits, len(law.terms), apart) + interpolation_seconds(steps)
    return seconds + stiff_seconds(panels.sizes, bits)


def points(request: PointsRequest, progress: Progress = lambda done: None) -> TurningPoints:
    """Turning points as far as they exist; ``ended["n"]`` is -1 if there is none.

    InputError for a start outside the well or a spring that depends on the velocity; LimitError for sizes;
    UndecidedError where balls cannot tell how the motion goes on.
    """
    if request.law.is_pure:
        return _nonexpansive(request, progress)
    return _in_well(request, progress)


def _nonexpansive(request: PointsRequest, progress: Progress) -> TurningPoints:
    require_moderate(request, serves(request))

    def orbit() -> EnclosedMotion:
        damping = damping_of(request)
        return EnclosedMotion(lambda: first_of(request, damping), lambda first: sequence(LinearSpring(damping), first))

    by = CLOSED if panels_of(request.law, 64).closed else INTEGRATED
    return enclosed(request, orbit, lambda bits: in_words(request, by, bits), bits_of(request), progress)


def _in_well(request: PointsRequest, progress: Progress) -> TurningPoints:
    if request.digits > MAX_DIGITS or request.last >= MAX_LAST:
        work = f"{request.digits} digits of {request.last + 1} points"
        raise LimitError("digits", work, f"{MAX_DIGITS} and {MAX_LAST}")
    if request.place.is_zero and not request.in_motion:
        raise InputError("x0", "0 is the place of rest", "a start away from 0, or v0")
    require_seconds(serves(request), f"{request.last + 1} half-swings with {request.digits} digits")

    def orbit() -> EnclosedMotion:
        with ctx.workprec(ctx.prec + GUARD):
            force = WellForce.of(request.law.terms)
        require_inside(force, request.place.ball(), "the start")
        # Rational stops are those from rest at x0.
        well = EvenWell(force, () if request.in_motion else rational_stops(request.law.terms, request.place))

        def first() -> TurningState | str:
            x0, v0 = request.place.ball(), request.speed.ball()
            return first_from(well, x0, v0) if request.in_motion else at_rest(x0)

        return EnclosedMotion(first, lambda start: sequence(well, start))

    return enclosed(request, orbit, lambda bits: METHOD, _bits(request), progress, doublings=_DOUBLINGS)


def require_moderate(request: PointsRequest, seconds: float) -> None:
    """LimitError for more digits or more time than a law without a closed form is given."""
    if request.digits > MAX_DIGITS:
        reason = f"{request.digits} digits are too many for a law without a closed form"
        raise LimitError("digits", reason, f"at most {MAX_DIGITS} digits")
    require_seconds(seconds, f"{request.last + 1} half-swings with {request.digits} digits")


def _bits(request: PointsRequest) -> int:
    return bits_for(request.digits, _SPARE) + 2 * (request.last + 1).bit_length()


ROUTE = Route(
    "stepping",
    "any law, any spring, from rest or in motion, with times",
    f"{INTEGRATED} in balls, half-swing by half-swing",
    serves,
    points,
)
