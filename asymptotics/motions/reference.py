"""Reference motion: any alpha >= 0, any sum of laws, any start, any number of digits; every digit is proved.

* One law with alpha = 0 or 1, alpha = 2 from rest, and no damping at all have closed forms or a quadrature.
* Every other law is enclosed half-swing by half-swing (``flow``): the sign of v is fixed inside, the branch point at
  v = 0 is removed by a local expansion, and two motions never part, so the errors of the pieces only add.
* Beside a spring or with losses that depend on the place two motions may part, at a bounded rate (``flow.wells``).

Against a naive |v|, measured: heyoka without an event is wrong in the third digit, mpmath.odefun in the fourth.

>>> from asymptotics.law import Law
>>> drag = Oscillator(Law({"3/2": "1/10"}), mass="3/2", stiffness="30", x0="1/5")
>>> point = reference_motion(drag, "7", 25)
>>> point.x, point.v, point.certified
('0.1638530834465485203993630', '0.08231344544936238811035480', True)
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import pi

from flint import arb

from asymptotics.costs import half_swing_seconds, interpolation_seconds
from asymptotics.errors import InputError
from asymptotics.flow.damping import Damping
from asymptotics.flow.dense import states
from asymptotics.flow.linear_spring.linear import ROUTE as CLOSED_ROUTE
from asymptotics.flow.linear_spring.near_critical import (
    creeping,
    creeping_seconds,
    faded_bits,
    longest_half_swing,
    longest_half_swing_seconds,
    lost_until,
    most_swings,
    turning,
)
from asymptotics.flow.taylor import GUARD
from asymptotics.flow.wells.even_well import EvenWell
from asymptotics.flow.wells.force import WellForce
from asymptotics.flow.wells.force import estimated_seconds as estimated_in_well
from asymptotics.flow.wells.rational_stops import rational_stops
from asymptotics.flow.wells.trapping_regions import require_inside
from asymptotics.frames import frame_of
from asymptotics.law import Oscillator
from asymptotics.motions import coulomb, linear, quadratic
from asymptotics.motions.certify import certified_values, half_unit, time_of
from asymptotics.motions.point import MotionPoint
from asymptotics.motions.state_route import StateRoute
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for, decimal_of_ball
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.integers import require_integer
from asymptotics.numbers.policy import Number
from asymptotics.numbers.precision import TooWideError, at_growing_precision
from asymptotics.return_map.half_swing_map import INTEGRATED
from asymptotics.return_map.half_swing_map import ROUTE as INTERPOLATED
from asymptotics.return_map.panels import panels_of
from asymptotics.return_map.sequence import Interpolated, swings_within
from asymptotics.running.budget import DEFAULT_SECONDS, budget, require_seconds
from asymptotics.running.cut_short import changed

METHOD = f"reference: half-swing by half-swing, {INTEGRATED}, {INTERPOLATED}, in balls"
CLOSED = f"reference: half-swing by half-swing, {CLOSED_ROUTE}, in balls"
IN_WELL = "reference: half-swing by half-swing in the well, local expansions and Taylor steps in balls"
MAX_DIGITS = 1000
_DOUBLINGS = 5

State = tuple[arb, arb]


@dataclass(frozen=True)
class States:
    """Enclosures of x and v in SI units at several times; ``bits``: the precision that gave them."""

    x: tuple[arb, ...]
    v: tuple[arb, ...]
    bits: int


def reference_motion(
    oscillator: Oscillator, t: Number, digits: int = 30, *, static: Number | None = None,
    max_seconds: float = DEFAULT_SECONDS,
) -> MotionPoint:  # fmt: skip
    """x and v at the time t >= 0, correctly rounded; ``static``: a static friction force (alpha = 0).

    InputError for t < 0, anti-damping, a start outside the well or a motion that leaves it, LimitError for more work
    than ``max_seconds``, UndecidedError where balls cannot tell how the motion goes on.
    """
    moment = time_of(t)
    oscillator.law.require_dissipative("reference motion to rest")
    require_integer(digits, "digits", 1, MAX_DIGITS)
    with budget(max_seconds):
        found = (route.state(oscillator, moment, digits, static) for route in ROUTES)
        # The last route serves every law, so there is always one.
        return next(point for point in found if point is not None)


def _by_the_flow(oscillator: Oscillator, t: ExactReal, digits: int, static: Number | None) -> MotionPoint:
    if static is not None:
        raise InputError("static", "it belongs to dry friction alone", "the law alpha = 0, b > 0")
    x, v = _decimals(oscillator, t, digits)
    notes, frame = oscillator.law.notes, frame_of(oscillator)
    return MotionPoint(x, v, None, None, None, None, _method(oscillator), half_unit(x, digits), True, notes, frame)


ROUTES = (coulomb.ROUTE, linear.ROUTE, quadratic.ROUTE, StateRoute(("interpolated", "stepping"), _by_the_flow))
"""What states x(t), in the order in which it is asked: each closed form that serves, else the flow."""


def _method(oscillator: Oscillator) -> str:
    if not oscillator.law.is_pure:
        return IN_WELL
    return CLOSED if panels_of(oscillator.dimensionless, bits_for(1)).closed else METHOD


def reference_states(
    oscillator: Oscillator, times: Sequence[ExactReal], digits: int, *, max_seconds: float = DEFAULT_SECONDS
) -> States:
    """Enclosures of (x, v) at many times in one pass, in the order given.

    Relative to the amplitude at the start they are good to ``digits`` digits; InputError, LimitError, UndecidedError as
    ``reference_motion``.  A pass that is cut short hands over the states that are as good as that, by their places.
    """
    oscillator.law.require_dissipative("reference motion to rest")
    with budget(max_seconds):
        # What a motion next to critical damping loses is carried from the start on, rather than found by doubling.
        bits = bits_for(digits, 28) + _lost(oscillator, times)

        def attempt(bits: int) -> States:
            found = _states(oscillator, times, bits)
            if not _within(oscillator, found, digits):
                raise TooWideError("the enclosures are too wide", lacking=64)
            return States(tuple(x for x, _ in found), tuple(v for _, v in found), bits)

        with changed(lambda found: {i: s for i, s in found.items() if _within(oscillator, [s], digits)} or None):
            return at_growing_precision(attempt, digits, bits, max_bits=bits << _DOUBLINGS)


def _within(oscillator: Oscillator, found: Sequence[State], digits: int) -> bool:
    """Whether all radii are at most 10^-digits, in units of the start's amplitude."""
    with ctx.workprec(64):
        close = arb(10) ** -digits * oscillator.length()
        limits = close, close * oscillator.omega_0()
        return all(bool(c.rad() <= limit) for state in found for c, limit in zip(state, limits, strict=True))


def _decimals(oscillator: Oscillator, t: ExactReal, digits: int) -> tuple[str, str]:
    """x and v at one time to ``digits`` significant digits, at whatever precision that takes."""
    if t.is_zero:
        return certified_values(lambda: (oscillator.x0, oscillator.v0), digits)
    require_seconds(estimated_seconds(oscillator, t, digits), f"{t} s with {digits} digits")
    bits = bits_for(digits, 56) + _lost(oscillator, (t,))

    def attempt(bits: int) -> tuple[str, str]:
        state = _states(oscillator, (t,), bits)[0]
        x, v = (decimal_of_ball(c, digits) for c in state)
        if x is None or v is None:
            lacking = max(bits_for(digits) - c.rel_accuracy_bits() for c in state)
            raise TooWideError(lacking=min(max(64, lacking + 40), 4 * bits))  # at a zero of x or v much is lacking
        return x, v

    return at_growing_precision(attempt, digits, bits, max_bits=bits << _DOUBLINGS)


def _lost(oscillator: Oscillator, times: Sequence[ExactReal]) -> int:
    """Bits that a motion next to critical damping loses up to the last of the times."""
    if not oscillator.law.is_pure or not times:
        return 0
    return lost_until(oscillator.dimensionless, _tau(oscillator, max(times)))


def _tau(oscillator: Oscillator, t: ExactReal) -> float:
    with ctx.workprec(64):
        return float((t.ball() * oscillator.omega_0()).mid())


def _states(oscillator: Oscillator, times: Sequence[ExactReal], bits: int) -> list[State]:
    """(x, v) in SI units at the times, in their order, at one precision."""
    # The Taylor coefficients are computed with so many bits more: strengths must not be less sharp.
    with ctx.workprec(bits + GUARD):
        law = oscillator.dimensionless
        acting = Damping.of_law(law) if law.is_pure else WellForce.of(law.terms)
        omega, length = oscillator.omega_0(), oscillator.length()
        X, V = oscillator.x0.ball() / length, oscillator.v0.ball() / (omega * length)
        # From rest X is exactly +-1, whatever root the unit of length has.
        if oscillator.v0.is_zero:
            X = arb(1 if oscillator.x0 > 0 else -1)
        taus = [t.ball() * omega for t in times]
    # The flow takes times in ascending order; comparisons of midpoints are exact, and equal ones may stay in any order.
    order = sorted(range(len(times)), key=lambda i: _Ascending(taus[i].mid()))
    with ctx.workprec(bits):
        ascending = [taus[i] for i in order]
        # At t = 0 the answer is the start, without the rounding of two units.
        start = oscillator.x0.ball(), oscillator.v0.ball()

    def scaled(found: Sequence[State]) -> dict[int, State]:
        with ctx.workprec(bits):
            placed = zip(order, found)  # as many as there are: fewer, where the pass was cut short
            return {i: start if times[i].is_zero else (x * length, v * length * omega) for i, (x, v) in placed}

    with ctx.workprec(bits), changed(scaled):
        if isinstance(acting, WellForce):
            require_inside(acting, X, str(oscillator.x0))
            unit = ExactReal(1 if oscillator.x0 > 0 else -1)
            stops = rational_stops(oscillator.dimensionless.terms, unit) if oscillator.v0.is_zero else ()
            found = states(EvenWell(acting, stops), X, V, ascending)
        else:
            panels = panels_of(oscillator.dimensionless, bits)
            found = states(Interpolated(acting, panels, within=swings_within(ascending)), X, V, ascending)
    placed = scaled(found)
    return [placed[i] for i in range(len(times))]


class _Ascending:
    """A sorting key for exact balls."""

    def __init__(self, value: arb) -> None:
        self.value = value

    def __lt__(self, other: "_Ascending") -> bool:
        return bool(self.value < other.value)


def estimated_seconds(oscillator: Oscillator, t: ExactReal, digits: int) -> float:
    """The expected time, good to a factor of about three for weak damping; stiff motions have their own limit."""
    tau, law = _tau(oscillator, t), oscillator.dimensionless
    swings = tau / pi + 1
    if not oscillator.law.is_pure:
        return estimated_in_well(WellForce.of(law.terms), swings, bits_for(digits, 48))
    swings = min(max(1.0, swings - creeping(law) / pi), most_swings(law), turning(law) / pi + 1)
    apart = sum(not (a.is_rational and a.rational.denominator <= 20) for a in oscillator.law.alphas)
    terms, bits = len(oscillator.law.terms), bits_for(digits, 56) + faded_bits(law, tau)
    panels = panels_of(law, bits)
    pieces = panels.pieces(int(min(swings, 1e9)))
    long = longest_half_swing(law) if tau > creeping(law) else 0.0
    slow = longest_half_swing_seconds(law, int(tau / long) + 1, bits, tau) if long else creeping_seconds(law, tau, bits)
    return half_swing_seconds(pieces + 2, bits, terms, apart) + interpolation_seconds(swings) + slow
