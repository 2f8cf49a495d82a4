"""Exact motion with quadratic damping (alpha = 2) from rest: Lambert W from turning point to turning point, certified.

Smith 2012: u = gamma x, gamma = b/m, p = 2|u| at a turning point.  On the half-swing from p to q = F(p) the place is
2u = p - (p+q)(1 - cos chi)/2 with the speed w = gamma |v|/omega_0 from the first integral, t = p - 2u,

    2 w^2 = (1+p)(1 - e^(-t)) - t,      omega_0 (time since p) = elapsed(p, q, chi), increasing in chi.

chi is enclosed between two numbers at which ``elapsed`` is certainly below and certainly above the time asked for.

>>> from asymptotics.law import Law
>>> unit = Oscillator(Law({"2": "1"}))
>>> quadratic_motion(unit, "2", 15).x
'-0.0320021521515164'
"""

from flint import arb

from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.law import Oscillator
from asymptotics.motions.certify import certified_point, time_of
from asymptotics.motions.point import MotionPoint
from asymptotics.motions.state_route import StateRoute, alone, require_alone
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimals import bits_for
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number
from asymptotics.running.budget import tick
from asymptotics.turning.quadratic_duration import duration, elapsed, node_count
from asymptotics.turning.quadratic_map import next_amplitude

METHOD = "exact: quadratic damping, Lambert W and quadrature, certified balls"
# Limits of work: quadratures, one for each half-swing, and nodes of one of them.
MAX_HALF_SWINGS = 20_000
MAX_NODES = 600


def quadratic_motion(oscillator: Oscillator, t: Number, digits: int = 30) -> MotionPoint:
    """x and v at the time t >= 0 from rest at x0, all digits correctly rounded.

    InputError for another law, v0 != 0 or t < 0; LimitError for more than ``MAX_HALF_SWINGS``.
    """
    moment = time_of(t)
    oscillator = require_alone(oscillator, 2, "quadratic damping")
    if oscillator.v0 < 0 or oscillator.v0 > 0:
        raise InputError("v0", f"{oscillator.v0}: the certified motion starts at a turning point", "0")
    with ctx.workprec(64):
        swings = float((moment.ball() * oscillator.omega_0() / arb.pi()).mid())
    if swings > MAX_HALF_SWINGS:
        raise LimitError("time", f"{swings:.0f} half-swings are too many", f"at most {MAX_HALF_SWINGS}")
    if not moment > 0:
        return certified_point(lambda: (oscillator.x0, arb(0)), digits, METHOD)
    return certified_point(lambda: _place(oscillator, moment.ball()), digits, METHOD)


def _is_feasible(oscillator: Oscillator, digits: int) -> bool:
    """Whether p = 2|u| is of ordinary size: there the quadrature is a matter of seconds and W loses no digits."""
    with ctx.workprec(64):
        gamma = oscillator.law.terms[0].b.ball() / oscillator.mass.ball()
        p = 2 * gamma * abs(oscillator.x0.ball())
        # A small p asks for twice its bits in W and the quadrature, a large one for many nodes: other routes serve
        # there.
        return bool(p < 1e9) and bool(p > 1e-3) and node_count(float(p.mid()) + 1, bits_for(digits, 48)) <= MAX_NODES


def _place(oscillator: Oscillator, t: arb) -> tuple[arb, arb]:
    gamma, omega = oscillator.law.terms[0].b.ball() / oscillator.mass.ball(), oscillator.omega_0()
    side, p, left = (-1 if oscillator.x0 < 0 else 1), 2 * gamma * abs(oscillator.x0.ball()), t * omega
    while True:
        tick("the half-swings")
        q = next_amplitude(p)
        T = duration(p, q)
        if left < T:
            break
        if not left > T:
            raise UndecidedError("the half-swing of this time is undecided")
        side, p, left = -side, q, left - T
    s = (p + q) * (1 - _angle(p, q, left).cos()) / 2
    square = (-(1 + p) * (-s).expm1() - s) / 2
    return side * (p - s) / (2 * gamma), -side * square.nonnegative_part().sqrt() * omega / gamma


def _angle(p: arb, q: arb, time: arb) -> arb:
    """The chi with elapsed(p, q, chi) = time, enclosed: Newton's method, bisection when it leaves its bracket."""
    low, high = arb(0), arb.pi().mid()
    # elapsed has a slope of about 1 in chi: the place is known to the time's own radius and 24 bits less than the
    # precision, an eighth of which Newton's method leaves.
    middle, tolerance = (high / 2).mid(), upper(arb(2) ** (-ctx.prec + 24) + 16 * time.rad())
    for _ in range(200):
        tick("the place on the half-swing")
        miss = (elapsed(p, q, middle) - time).mid()
        if abs(miss) <= tolerance / 8:
            break
        low, high = (middle, high) if miss < 0 else (low, middle)
        guess = (middle - miss / _slope(p, q, middle)).mid()
        middle = guess if low < guess and guess < high else ((low + high) / 2).mid()
    # elapsed increases with chi: certainly below at one end and certainly above at the other encloses the place.
    if not (elapsed(p, q, middle - tolerance) < time and elapsed(p, q, middle + tolerance) > time):
        raise UndecidedError("the place on the half-swing was not enclosed")
    return arb(middle, tolerance)


def _slope(p: arb, q: arb, chi: arb) -> arb:
    """d elapsed/d chi = sin(chi) (p+q)/(4 w), for Newton's method only."""
    s = (p + q) * (1 - chi.cos()) / 2
    w = ((-(1 + p) * (-s).expm1() - s) / 2).mid()
    return (chi.sin() * (p + q) / (4 * abs(w).sqrt())).mid()


def _state(oscillator: Oscillator, t: ExactReal, digits: int, static: Number | None) -> MotionPoint | None:
    bare = alone(oscillator, 2)
    if bare is None or static is not None or not bare.v0.is_zero or not _is_feasible(bare, digits):
        return None
    return quadratic_motion(bare, t, digits)


ROUTE = StateRoute(("quadratic",), _state)
