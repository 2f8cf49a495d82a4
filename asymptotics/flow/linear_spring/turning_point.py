"""The turning point ahead of a state that certainly turns: no bracketing is needed.

Where y < 0 and w > 0, w' = y - N(w) <= y: the orbit turns.  Let y = Y(w; y_1) be the orbit that ends at y_1 < 0; then

    d/dw (dY/dy_1) = (w/P^2) dY/dy_1,      so dY/dy_1 = exp(integral of w/P^2) >= 1:

orbits with different turning points spread as w grows (derivation ``arrival``).  Hence any guess will do: the turning
point y_1 of the orbit through (y, w) obeys |y_1 - guess| <= |Y(w; guess) - y|.

The guess comes from the secant method (``flow.secant``).  It decides how good the enclosure is, not whether it holds.

>>> from fractions import Fraction
>>> from asymptotics.numbers.exact import ExactReal
>>> with ctx.workprec(60):
...     law = Damping.of([(arb(1) / 10, ExactReal(Fraction(3, 2)))])
...     there = TurningExpansion.at(law, arb(-1), arb("0.25"))
...     y, tau = there.state(arb("0.25"))
...     found = arrive(law, y.mid(), arb("0.25"))
>>> abs(found.y0 + 1) <= arb(1e-15)
True
"""

from flint import arb

from asymptotics.flow.balls import dyadic, size_of
from asymptotics.flow.damping import Damping
from asymptotics.flow.linear_spring.expansion import TurningExpansion, plan_at
from asymptotics.flow.linear_spring.kept_terms import SMALL
from asymptotics.flow.secant import through
from asymptotics.numbers.context import ctx

# The first guess, by the energy without losses, is right to a few bits whatever the precision.
_ROUGH = 53
_INNER = 0.9375  # of |y|, and more than the guess will differ from it


def arrive(damping: Damping, y: arb, w: arb) -> TurningExpansion:
    """The expansion at a dyadic guess y_1 of the turning point of the orbit through (y, w), y < 0 a ball, w > 0 exact,
    within the reach of y_1."""
    goal = y.mid()
    with ctx.workprec(_ROUGH):
        first = (goal - w * w / (2 * abs(goal))).mid()
    # The theorem above bounds the error of any guess by the miss that is left, which ``flow.trajectory`` adds as a
    # distance.
    return through(lambda y1: TurningExpansion.at(damping, y1, w), goal, w, first)


def turns_within(damping: Damping, y: arb, w: arb, error: arb) -> bool:
    """Whether the turning point ahead is near enough for its expansion: a choice, in doubles."""
    if not y < 0:
        return False
    # log2 of (y^2 + w^2)^(1/2), by which the orbit without losses turns: between the larger of the two and half a bit
    # more.
    size = (max(2 * size_of(y), 2 * size_of(w)) + 0.3) / 2  # by the energy
    if damping.sublinear:  # braking may end the motion long before; below 1 the reach shrinks with the amplitude
        size = size_of(y)
    near = bool(w < reach_at(damping, dyadic(size)))
    # Exponents next to 0 get short plans, of one term: what it leaves out falls with w, so the later the better, until
    # the speed is below the error of the state.
    small = damping.least < SMALL and (near or bool(w < error))
    if small and plan_at(damping, y * arb(_INNER), w).short:  # one term: as late as the error allows
        return bool(w < error)
    return near


def reach_at(damping: Damping, y0: arb) -> arb:
    """The hand-over speed at a turning point of that size."""
    return dyadic(plan_at(damping, y0).omega + size_of(y0))
