"""Route "closed-primitive": quadratic drag and dry friction, beside the linear spring or any other, from rest.

The work on a half-swing is an elementary function (``energy_primitive``), so a turning point is the root of one
equation; its time is not known.  Beside the linear spring with drag alone this is the equation of the Lambert W map,
which is some fifty times faster (``quadratic``).

>>> from asymptotics.law import Law
>>> law = Law({2: "1/5"}, spring="pendulum")
>>> [p.x for p in points(PointsRequest.read(law, 3, 12, x0=2)).points]
['2.00000000000', '-1.20380409635', '0.891896868559']
"""

from collections.abc import Iterator

from flint import arb

from asymptotics.costs import primitive_seconds
from asymptotics.errors import InputError
from asymptotics.flow.wells.rational_stops import rational_stops
from asymptotics.flow.wells.trapping_regions import inside, outside
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.precision import TooWideError, at_growing_precision
from asymptotics.running.budget import require_seconds
from asymptotics.turning.energy_primitive import PrimitiveWell, primitive_serves, swings
from asymptotics.turning.result import TurningPoint, TurningPoints, proved_point
from asymptotics.turning.route import Route
from asymptotics.turning.table import Ended, Points, PointsDone, PointsRequest, Progress

MAX_DIGITS, MAX_LAST = 1000, 100_000
_DOUBLINGS = 5


def serves(request: PointsRequest) -> float | None:
    """The seconds; None for other forces, for times, for a start in motion, and beyond the limits."""
    if not primitive_serves(request.law) or request.times or request.in_motion:
        return None
    if request.digits > MAX_DIGITS or request.last >= MAX_LAST:
        return None
    return primitive_seconds(request.last + 1, _bits(request))


def points(request: PointsRequest, progress: Progress = lambda done: None) -> TurningPoints:
    """The turning points from rest at ``place``, in the units of the strengths.

    InputError for a force other than alpha = 0, 2 and springs of the position, or a start outside the well (V' > 0 from
    0 to x0); LimitError for the time; UndecidedError where balls cannot tell.
    """
    require_seconds(primitive_seconds(request.last + 1, _bits(request)), f"{request.last + 1} half-swings")

    kept = PointsDone(request)

    def attempt(bits: int) -> TurningPoints:
        method = f"primitive of the energy equation in balls of {bits} bits"
        # As the amplitude falls the work on a half-swing is a difference of nearly equal primitives.
        with ctx.workprec(2 * bits):
            made, ended = _rounded(request, bits, progress, kept.begin(lambda: method))
        return request.table(made, method, ended)

    bits = _bits(request)
    with kept:
        return at_growing_precision(attempt, request.digits, bits, max_bits=bits << _DOUBLINGS)


def _bits(request: PointsRequest) -> int:
    return bits_for(request.digits, 48) + 2 * (request.last + 1).bit_length()


def _rounded(request: PointsRequest, bits: int, progress: Progress, made: list[TurningPoint]) -> tuple[Points, Ended]:
    """The points and how they end; TooWideError where one cannot be rounded, or what follows it is undecided."""
    well = PrimitiveWell.of(request.law)
    if request.place.is_zero:
        raise InputError("x0", "0 is the place of rest", "a start at rest away from 0")
    if not inside(well.force, request.place.ball()):  # nor where balls cannot tell: at the very edge of the well
        raise outside(well.force, str(request.place))
    for n, (x, stays) in enumerate(_places(request, well, bits)):
        if n >= request.start:
            point = proved_point(n, x, None, request.digits)
            if stays is None:
                raise TooWideError(f"whether dry friction holds the mass at turning point {n} is undecided")
            made.append(point)
            progress(len(made))
        if stays:
            return tuple(made), {"n": n, "reason": "sticks"}
        if n == request.last:
            return tuple(made), None
    raise TooWideError("the next turning point is not enclosed")


def _places(request: PointsRequest, well: PrimitiveWell, bits: int) -> Iterator[tuple[arb | ExactReal, bool | None]]:
    """The places as exact numbers as long as they are rational, in balls from the last one on."""
    # Exact places first, with their ties; balls take over from the last of them.
    stops = rational_stops(request.law.terms, request.place)
    yield from ((ExactReal(place), stays) for place, stays in stops)
    if stops and stops[-1][1]:
        return
    last = ExactReal(stops[-1][0]) if stops else request.place
    balls = swings(well, last.ball(), bits)
    first = next(balls)
    if not stops:
        yield last, first[1]
    yield from balls


ROUTE = Route(
    "closed-primitive",
    "quadratic drag and dry friction beside any spring of the position, from rest, without times",
    "primitive of the energy equation",
    serves,
    points,
)
