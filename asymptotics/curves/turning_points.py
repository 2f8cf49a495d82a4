"""Turning points in units: those of an oscillator in metres (a pendulum in rad) and seconds.

>>> osc = Oscillator({2: "1/10"}, mass="3/2", stiffness=30, x0="1/5")
>>> found = turning_points_in_units(osc, 3, digits=12, times=True)
>>> found.points[1].x, found.points[1].t, found.unit
('-0.196506443629', '0.702501924734', 'm')
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any

from flint import arb

from asymptotics.certificates.certificate import Certificate
from asymptotics.certificates.of_results import of_turning_points
from asymptotics.errors import InputError
from asymptotics.frames import BARE, Frame, frame_of, started_frame
from asymptotics.law import Law, Oscillator
from asymptotics.law_given import Given
from asymptotics.motions.coulomb import exact_turning_points
from asymptotics.motions.state_route import alone
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import BITS_PER_DIGIT, bits_for, decimal_of, decimal_of_ball
from asymptotics.numbers.digits import ball_of
from asymptotics.numbers.exact import ExactReal, square_root
from asymptotics.numbers.policy import Number
from asymptotics.numbers.precision import at_growing_precision
from asymptotics.running.cut_short import changed
from asymptotics.running.public import public
from asymptotics.turning import choose
from asymptotics.turning.result import TurningPoint, TurningPoints
from asymptotics.turning.table import MAX_DIGITS

_SPARE, _DOUBLINGS = 23, 3  # bits: six digits more than are shown, and eight times as many bits at most
"""The unit of length is a factor with an error of its own and may spoil the rounding of a point: six digits more decide
all but one case in a million, a doubling the rest; a tie that no precision decides ends after the third."""
_MOST = (MAX_DIGITS + 10) << _DOUBLINGS
"""Digits of the route: ``MAX_DIGITS`` limits what is asked, not what is computed with."""


@dataclass(frozen=True, repr=False)
class MotionTurningPoints(TurningPoints):
    """Turning points, and the motion that they are of: ``moving``, with m = k = 1 where they have no units."""

    moving: Oscillator = field(kw_only=True)

    @property
    def x_unit(self) -> str:
        """What x counts: m, rad, the start itself (x0), or the length in which the strengths are given (strengths)."""
        return Given(self.moving, frame_of(self.oscillator)).x_unit

    @property
    def frame(self) -> Frame:
        """The units of x and t; without units of the motion x may still have one, the radian or that of the strengths.

        >>> moving = Oscillator({2: 1}, x0=2)
        >>> of_motion(moving, without_units(moving, 1, digits=3)).frame.named("x")
        'x [units of the strengths]'
        """
        return started_frame(self.x_unit) if self.oscillator is None else frame_of(self.oscillator)

    @public
    def certificate(self, *, max_seconds: Number = 60) -> Certificate:
        """A file from which ``check_certificate.py``, a page of standard Python, proves every digit.

        In m and s where the points are.  InputError for what has none: springs, losses that know the place, irrational
        numbers, estimates.
        """
        return of_turning_points(self.moving, replace(self, first=None))


def of_motion(moving: Oscillator, found: TurningPoints) -> MotionTurningPoints:
    """The same points, of the motion of this oscillator."""
    told = MotionTurningPoints(**{f.name: getattr(found, f.name) for f in fields(found) if f.init}, moving=moving)
    frame = told.frame
    return replace(told, points=tuple(replace(p, frame=frame) for p in told.points))


def turning_points_in_units(
    oscillator: Oscillator,
    count: int,
    *,
    digits: int = 30,
    start: int = 0,
    times: bool = False,
    route: str | None = None,
) -> TurningPoints:
    """Turning points of an oscillator in m and s: solved without units, and carried back.

    With v0 != 0 n = 0 is the first turning point after the start, where t counts from.  An error that cuts the work
    short carries the points that were done, in m and s.
    """
    # An oscillator is solved without units, where powers of the velocity have strengths alone, and carried back.
    pure, kick = dimensionless(oscillator)

    def in_si(found: TurningPoints) -> TurningPoints | None:
        points = _in_si(oscillator, found, digits)
        if points is None:
            return None
        return replace(found, digits=digits, points=points, first=None, oscillator=oscillator, dimensionless=found)

    return _carried_over(in_si, pure, count, digits, start, times, route, kick)


def _carried_over(
    carry: Callable[[TurningPoints], TurningPoints | None],
    law: Law, count: int, digits: int, start: int, times: bool, route: str | None, kick: Mapping[str, ExactReal],
) -> TurningPoints:  # fmt: skip
    """The points of a law, carried over to other units; with more digits where a product with the unit is undecided."""

    def attempt(bits: int) -> TurningPoints | None:
        # Points that were done when the time was over are handed out carried over, as the result would have been.
        with changed(carry):
            found = with_notes(law, count, int(bits / BITS_PER_DIGIT), start, times, route=route, most=_MOST, **kick)
        return carry(found)

    # The route proves its own digits, so that ``attempt`` passes on bits as a number of digits.
    bits = bits_for(digits, _SPARE)
    return at_growing_precision(attempt, digits, bits, max_bits=bits << _DOUBLINGS)


def without_units(oscillator: Oscillator, count: int, **rest: Any) -> TurningPoints:
    """From rest at another place than 1, m = k = 1, powers of the velocity alone: as in m and s, but without units."""
    strengths = ",".join(str(t.strength) for t in oscillator.law.terms)

    def bare(found: TurningPoints) -> TurningPoints:
        # m = k = 1: seconds are tau, and metres the unit in which the strengths were given.
        points = tuple(replace(p, frame=BARE) for p in found.points)
        return replace(found, epsilon=strengths, points=points, oscillator=None, dimensionless=None)

    with changed(bare):
        found = turning_points_in_units(oscillator, count, **rest)
    return bare(found)


def started_in_motion(
    oscillator: Oscillator,
    count: int,
    *,
    digits: int = 30,
    start: int = 0,
    times: bool = False,
    route: str | None = None,
) -> TurningPoints:
    """With v0 != 0 and m = k = 1, without units: x in what x0 is in, as at rest; ``first`` tells when n = 0 is.

    >>> found = started_in_motion(Oscillator({2: "1/20"}, x0=-2, v0=1), 2, digits=8)
    >>> [p.x for p in found.points], found.first
    (['1.9475547', '-1.7234527'], {'amplitude': '1.9475547', 'tau': '2.6802912'})
    """
    law, x0, v0 = Law.from_terms(oscillator.law.terms, oscillator.law.notes), oscillator.x0, oscillator.v0

    def undivided(found: TurningPoints) -> TurningPoints | None:
        if found.first is None:  # it never turns
            return replace(found, digits=digits)
        with ctx.workprec(bits_for(found.digits, 64)):
            size = ball_of(found.first["amplitude"])
            points = _carried(oscillator, found, size, arb(1), digits)
            exact = _exact_places(oscillator)(0)
            amplitude = decimal_of(abs(size) if exact is None else abs(exact), digits)
            tau = decimal_of_ball(ball_of(found.first["tau"]), digits)
        if points is None or amplitude is None or tau is None:
            return None
        bare = tuple(replace(p, frame=BARE) for p in points)
        return replace(found, digits=digits, points=bare, first={"amplitude": amplitude, "tau": tau})

    return _carried_over(undivided, law, count, digits, start, times, route, {"x0": x0, "v0": v0})


def with_notes(law: Law, count: int, digits: int, start: int, times: bool, **rest: Any) -> TurningPoints:
    """The points, with the notes of the law; also those that were done when the time was over."""

    def noted(found: TurningPoints) -> TurningPoints:
        return replace(found, notes=law.notes)

    with changed(noted):
        return noted(choose.turning_points(law, count, digits, start=start, times=times, **rest))


def dimensionless(oscillator: Oscillator) -> tuple[Law, dict[str, ExactReal]]:
    """The law without units, and the start (X, X') in units of sqrt(x0^2 + m v0^2/k): nothing for one at rest."""
    x0, v0 = oscillator.x0, oscillator.v0
    if v0.is_zero:
        return oscillator.dimensionless, {}
    # One square root is all that an exact number may hold: with rational data the square of the radius is rational, and
    # place and speed in its unit are a root each.  Other data (a root in the mass) raise ValueError, by InputError.
    try:
        ratio = oscillator.mass / oscillator.stiffness
        square = (x0 * x0 + ratio * v0 * v0).rational
        kick = {"x0": x0 / square_root(square), "v0": v0 * square_root(ratio.rational / square)}
    except ValueError:
        raise InputError("v0", "the unit of length is not a single root", "rational mass, stiffness, x0, v0") from None
    return oscillator.dimensionless, kick


def _in_si(oscillator: Oscillator, found: TurningPoints, digits: int) -> tuple[TurningPoint, ...] | None:
    """The points in m and s; None if the digits known do not decide the rounding."""
    with ctx.workprec(bits_for(found.digits, 64)):
        # With v0 the route counts in amplitudes of turning point 0, whose size has digits of its own: an interval of
        # half a unit of the last of them, as every printed digit is read back.
        length = (
            oscillator.x0.ball() if found.first is None else oscillator.length() * ball_of(found.first["amplitude"])
        )
        return _carried(oscillator, found, length, oscillator.omega_0(), digits)


def _carried(
    oscillator: Oscillator, found: TurningPoints, length: arb, omega: arb, digits: int
) -> tuple[TurningPoint, ...] | None:
    """The points times ``length``, the times by ``omega``, at the current precision; None if a rounding is open."""
    points, exact, frame = [], _exact_places(oscillator), frame_of(oscillator)
    for p in found.points:
        unit = arb(-1 if p.x.startswith("-") else 1)  # of point 0, with its sign
        # Exact places first: a rational x_n may be a tie between two decimals, or 0, and no ball tells either.
        # Otherwise p.x is 1 exactly at n = 0, and elsewhere a ball that its digits leave.
        x = decimal_of(exact(p.n) or (unit if p.n == 0 else ball_of(p.x)) * length, digits)
        t = None if p.time is None else "0" if p.n == 0 else decimal_of_ball(ball_of(p.time) / omega, digits)
        # Not decided: the attempt is made again with more digits, for all points, since each is checked here again.
        if x is None or (t is None and p.time is not None):
            return None
        points.append(TurningPoint(p.n, x, t, found.certified, frame))
    return tuple(points)


def _exact_places(oscillator: Oscillator) -> Callable[[int], ExactReal | None]:
    """n -> x_n in m where it is known exactly: all of them under dry friction alone, else the start at rest."""
    # x_n = (-1)^n (r_0 - 2 n b/k) until it sticks: rational arithmetic if the oscillator's numbers are rational.
    dry = alone(oscillator, 0)
    found = None if dry is None else exact_turning_points(dry)
    if found is not None:
        return found
    start = oscillator.x0 if oscillator.v0.is_zero else None
    return lambda n: start if n == 0 else None
