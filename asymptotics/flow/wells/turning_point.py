"""The turning point ahead of a state that certainly turns: no bracketing is needed.

Where s_0 < 0 and w > 0, w' <= s_0(u): the motion turns.  The orbit that ends at a guess u_1 passes the speed w at the
place U(w) (``expansion``), at the distance unit |U(w) - u| from the state: it is followed instead, and the truth turns
near u_1 (``flow.error_propagation``).  The guess decides how good the enclosure is, not whether it holds; it comes from
the secant method (``flow.secant``).

>>> from asymptotics.law import Law
>>> with ctx.workprec(60):
...     force = WellForce.of(Law({"3/2": "1/10"}, spring="pendulum").terms)
...     there = WellExpansion.at(force, arb(-1), arb("0.25"))
...     u, tau = there.state(arb("0.25"))
...     found = arrive(force, u.mid(), arb("0.25"))
>>> abs(found.u0 + 1) <= arb(1e-15)
True
"""

from flint import arb

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.flow.error_propagation import points_forward
from asymptotics.flow.secant import through
from asymptotics.flow.wells.expansion import WellExpansion, reach_at
from asymptotics.flow.wells.force import WellForce
from asymptotics.numbers.context import ctx

_MOST, _LOW = 40, 53


def arrive(force: WellForce, u: arb, w: arb) -> WellExpansion:
    """The expansion at a dyadic guess u_1 of the turning point of the orbit through the exact (u, w > 0)."""
    goal = u.mid()
    with ctx.workprec(_LOW):
        first = without_loss(force, goal, (w * w / 2).mid())
    try:
        # What the guess misses the state by is added as a distance in ``flow.trajectory``, and ``state_gap`` proves
        # that the truth turns.
        return through(lambda u1: WellExpansion.at(force, u1, w), goal, w, goal if first is None else first)
    except LimitError as far:  # at the top of a well the place of a turning point is anywhere
        raise UndecidedError("the turning point ahead was not found: too near a separatrix") from far


def turns_within(force: WellForce, u: arb, w: arb) -> bool:
    """Whether the turning point ahead is near enough for its expansion: a choice, in doubles."""
    with ctx.workprec(_LOW):
        goal = (w * w / 2).mid()
        turn = without_loss(force, u.mid(), goal)
        if turn is None:
            return False
    try:
        reach = reach_at(force, turn)
    except LimitError:  # no plan is cheap enough there
        return False
    # The series of a kinked force must not cross u = 0 on the way.
    smooth = not force.kinked or bool(turn * u > 0)
    return smooth and reach is not None and bool(w < reach) and points_forward(force, turn, u)


def without_loss(force: WellForce, u: arb, square: arb) -> arb | None:
    """Where w^2/2 = ``square`` at u is used up by s_0 alone: Newton's method, a choice."""
    restoring = force.restoring(u).mid()
    if not restoring < 0:
        return None
    turn = (u + square / restoring).mid()
    # Dry friction that knows the place (m >= 1) is left out of the guess.
    held = sum((e for e, m in force.grips if m == 0), arb(0)).mid()
    for _ in range(_MOST):
        restoring = force.restoring(turn).mid()
        if not restoring < 0:
            return None
        left = square + force.potential(u).mid() - force.potential(turn).mid() - held * (u - turn)
        step = (left / restoring).mid()
        turn = (turn + step).mid()
        if not turn < u:
            return None
        # Three digits are enough for the secant method to start from.
        if abs(step) < (u - turn) * arb("0.001"):
            return turn
    return None
