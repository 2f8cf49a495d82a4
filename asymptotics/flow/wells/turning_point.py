"""The turning point ahead of a state that certainly turns: no bracketing is needed.

Where s_0 < 0 and w > 0, w' <= s_0(u): the motion turns.  The orbit that ends at a guess u_1 passes the speed w at the
place U(w) (``expansion``), at the distance unit |U(w) - u| from the state: it is followed instead, and the truth
turns near u_1 (``flow.parting``).  The guess decides how good the enclosure is, not whether it holds; it comes from the
secant method in doubled precisions.

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
from asymptotics.flow.balls import size_of
from asymptotics.flow.parting import points_forward
from asymptotics.flow.wells.expansion import WellExpansion, reach_at
from asymptotics.flow.wells.force import WellForce
from asymptotics.numbers.context import ctx

_FIRST, _MOST, _LOW = 53, 40, 53


def arrive(force: WellForce, u: arb, w: arb) -> WellExpansion:
    """The expansion at a dyadic guess u_1 of the turning point of the orbit through the exact (u, w > 0)."""
    try:
        return WellExpansion.at(force, _guess(force, u, w), w)
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
    smooth = not force.kinked or bool(turn * u > 0)
    return smooth and reach is not None and bool(w < reach) and points_forward(force, turn, u)


def without_loss(force: WellForce, u: arb, square: arb) -> arb | None:
    """Where w^2/2 = ``square`` at u is used up by s_0 alone: Newton's method, a choice."""
    restoring = force.restoring(u).mid()
    if not restoring < 0:
        return None
    turn = (u + square / restoring).mid()
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
        if abs(step) < (u - turn) * arb("0.001"):
            return turn
    return None


def _guess(force: WellForce, goal: arb, w: arb) -> arb:
    """u_1 to about the working precision: secants at growing precision, a slope being worth what noise leaves of it."""
    full, bits = ctx.prec, min(_FIRST, ctx.prec)
    with ctx.workprec(bits):
        first = without_loss(force, goal.mid(), (w * w / 2).mid())
        a = goal.mid() if first is None else first
        size = max(size_of(goal), size_of(a))
        miss_a = _miss(force, a, goal, w)
        b = (a - miss_a - abs(a - goal) * arb(2) ** -18).mid()
    slope, worth, noise_a = arb(1), 1.0, size - bits
    for _ in range(_MOST):
        with ctx.workprec(bits):
            miss_b = _miss(force, b, goal, w)
            noise = size - bits
            known = max(size_of(miss_a), size_of(miss_b))
            if miss_b != miss_a and a != b and min(known - max(noise, noise_a), size - known) > worth:
                slope, worth = ((miss_b - miss_a) / (b - a)).mid(), min(known - max(noise, noise_a), size - known)
            following = (b - miss_b / slope).mid()
        reached = size - size_of(miss_b) + worth
        a, b, miss_a, noise_a = b, following, miss_b, noise
        if bits == full and (miss_b == 0 or reached > full):
            break
        bits = int(min(full, max(bits, reached + 25)))
    with ctx.workprec(full + 4):
        return (b + 0).mid()


def _miss(force: WellForce, turn: arb, goal: arb, w: arb) -> arb:
    return (WellExpansion.at(force, turn, w).state(w)[0] - goal).mid()
