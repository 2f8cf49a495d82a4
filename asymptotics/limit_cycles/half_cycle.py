"""A half-cycle of a polynomial oscillator is enclosed on the certified flow, with gains as well as losses.

The orbit from the midpoint of the start is laid out in Taylor steps of ``flow``, each from an exact state, through rest
at both ends (``flow.trajectory`` says why they have a loop of their own).  The errors D travel by the rule of
``flow.error_propagation``, with a unit s > 0 of places: along the slow branch of a relaxation oscillation nothing
parts, and only the jump costs digits.  With J = -int G_w d tau,

    |J - int over the polynomials| <= length (|G_uw|/s + |G_ww|) D.

Before the first step ends G > 0 on its box, in the steps between w > 0, on the last box G < 0: w has no other zero on
the way.  The last step ends where the polynomial of w vanishes; there |w| <= omega, and with an acceleration of at most
-g next to it the turning point is omega/g away in time and less than omega times that in u.

>>> from asymptotics.law import Law
>>> with ctx.workprec(80):
...     turn = half_cycle(Law({1: -1, (1, 2): 1}).terms, arb(1), arb(2))
>>> turn.q.str(12), turn.T.str(12)
('[2.00836140871 +/- ...]', '[3.32026115191 +/- ...]')
"""

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb, arb_poly

from asymptotics.flow.balls import dyadic, size_of, upper
from asymptotics.flow.error_propagation import CarriedErrors, distance_growth
from asymptotics.flow.taylor import TaylorStep, sizes
from asymptotics.flow.trajectory import FlowState
from asymptotics.limit_cycles.force import PolynomialForce
from asymptotics.numbers.context import ctx
from asymptotics.running.budget import tick
from asymptotics.terms import Term

MAX_STEPS = 20_000  # 12 s in 80 bits; the cycle of van der Pol takes 21 at mu = 1 and 107 at mu = 20
_FAR = 1e6  # times the start: the orbit goes off, as no cycle near the guess does
_LOW = 53  # bits of bounds: the radius of a ball has 30
_NEWTON = 12  # bisections, then Newton steps: each doubles the 12 bits that the bisections have left
_HALVINGS = 60  # of a step: shorter ones move a state by less than the bounds' own rounding
_ROOM = 4  # by which the distance of two motions may grow on a step: the box is that much wider than what is known


@dataclass(frozen=True)
class HalfCycle:
    """From (A, 0) to (-q, 0): q, the time T, and J = int h_v d tau."""

    q: arb
    T: arb
    J: arb


@dataclass(frozen=True)
class _Here(FlowState):
    """A state on the orbit, with the integral J up to it."""

    J: arb


def half_cycle(terms: Sequence[Term], mu: arb, A: arb) -> HalfCycle | None:
    """The half-swing from (A, 0) in balls; None if an enclosure fails."""
    force = PolynomialForce.of(terms, mu)
    unit = _unit(force, A)
    far = _FAR * abs(A.mid())
    # The orbit of the midpoint is followed; that of any other A of the ball starts at a distance of at most this.
    start = CarriedErrors(arb(0), upper(unit * A.rad()))
    here = _Here(arb(0), A.mid(), arb(0), start, arb(0))
    for k in range(MAX_STEPS):
        tick(f"step {k} around the cycle")
        found = _step(force, unit, here)
        if found is None:
            return None
        step, ends = found
        here = _after(force, unit, here, step)
        # A guess of the start from which the orbit goes off; no cycle passes there.
        if not (here.w < far and abs(here.u) < far):
            return None
        if ends:
            return _to_the_turn(force, unit, here)
    return None


def _unit(force: PolynomialForce, A: arb) -> arb:
    """A power of two near the root of the largest slope of G, the unit of the distance: a choice."""
    size = abs(A.mid())
    # |G|/size at u = w = A in place of the largest slope: any unit gives a bound, a poor one a larger growth factor.
    return dyadic(round(size_of(force.largest(size, arb(0), size, arb(0)) / size) / 2))


def _step(force: PolynomialForce, unit: arb, here: _Here) -> tuple[TaylorStep, bool] | None:
    """A step on whose box w keeps its sign as the docstring of the module says, and whether it is the last one."""
    scale = upper(unit * abs(here.u) + here.w)
    step = TaylorStep.at(force, here.u, here.w, unit, scale)
    for _ in range(_HALVINGS):
        # The first step starts at w = 0 and leaves it; a later one that ends at w <= 0 is cut at the zero of its
        # polynomial.
        end = None if here.w == 0 or step.state(step.length)[1] > 0 else _root(step)
        last = step if end is None else step.shortened(end)
        u, w = _box(unit, here, last)
        # The growth is taken on a box ``_ROOM`` times wider than the errors: if it is no more than that, the truth
        # stays in the box, by continuity, and the signs of G and w on it are those of the truth.
        pull, steady = force.at(u, w), distance_growth(force, unit, u, w, last.length) <= _ROOM
        # On the last box G < 0: w falls through its one zero, and no other.
        if end is not None and steady and pull < 0:
            return last, True
        if end is None and steady and (pull > 0 if here.w == 0 else w > 0):
            return step, False
        # A shorter step has a smaller box; the polynomials stay as they are.
        step = step.shortened((last.length / 2).mid())
    return None


def _root(step: TaylorStep) -> arb:
    """Where the polynomial of w vanishes, by Newton's method on midpoints: a choice, not a claim."""
    w = arb_poly([c.mid() for c in step.ws])
    slope, low, high = w.derivative(), arb(0), step.length
    for _ in range(_NEWTON):  # bisection first: w falls through 0 once
        middle = ((low + high) / 2).mid()
        low, high = (middle, high) if w(middle) > 0 else (low, middle)
    end = high
    for _ in range(_NEWTON):
        end = (end - w(end) / slope(end)).mid()
    return min(max(end, low), high)


def _box(unit: arb, here: _Here, step: TaylorStep) -> tuple[arb, arb]:
    """Balls that hold (u, w) of the polynomials on the step, and all that is as near to them as the truth stays."""
    with ctx.workprec(_LOW):
        h, room = step.length, upper(_ROOM * here.errors.plus(step.residual).error)
        return tuple(
            arb(c[0].mid(), upper(sizes(c)(h) + c[0].rad() + r)) for c, r in ((step.us, room / unit), (step.ws, room))
        )  # type: ignore[return-value]


def _after(force: PolynomialForce, unit: arb, here: _Here, step: TaylorStep) -> _Here:
    """The state after a step."""
    with ctx.workprec(_LOW):
        # The residual first and then the growth, as along every piece of the flow.
        errors, box = here.errors.plus(step.residual), _box(unit, here, step)
        factor = distance_growth(force, unit, *box, step.length)
        mixed, twice = (abs(c) for c in force.bends(*box))
        errors = errors.times(factor)
        # G_w differs by G_uw du + G_ww dw with |du| <= D/unit and |dw| <= D (mean value theorem on the box).
        parted = upper(step.length * (mixed / unit + twice) * errors.error)
    u, w = step.state(step.length)
    J = here.J - _integral(force, step) + arb(0, parted)
    errors = errors.plus(unit * u.rad() + w.rad())
    return _Here(here.t + step.length, u.mid(), w.mid(), errors, J)


def _integral(force: PolynomialForce, step: TaylorStep) -> arb:
    """int G_w over the polynomials of the step."""
    u, w = arb_poly(list(step.us)), arb_poly(list(step.ws))
    slope = sum((u**m * w ** (a - 1) * (d * a) for d, m, a in force.parts if a), arb_poly([]))
    return slope.integral()(step.length)


def _to_the_turn(force: PolynomialForce, unit: arb, end: _Here) -> HalfCycle | None:
    """What is missing to w = 0: with |w| <= omega and a deceleration of at least g near the end, |dt| <= omega/g."""
    error = end.errors.error
    omega = upper(end.w + arb(0, error))
    # A box for what is left of the way, at most a time of 1/4, in which w only goes on to 0: the next line checks it.
    u, w = end.u + arb(0, upper(error / unit + 4 * omega)), arb(0, 2 * omega)
    g = (-force.at(u, w)).lower()
    if not (g > 4 * omega and g > 0):  # then |dt| < 1/4 and the orbit stays in the box
        return None
    dt = (omega / g).upper()
    more = arb(0, upper(abs(force.slopes(u, w)[1]) * dt))
    place = end.u + arb(0, upper(error / unit + 2 * omega * dt))
    return HalfCycle(-place, end.t + arb(0, dt), end.J + more)
