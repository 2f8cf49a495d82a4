"""Turning points for any alpha >= 0 and any sum of laws, certified: every digit is correctly rounded and proved to be.

``turning_points`` chooses: one law with alpha = 0, 1 or 2 has its closed form or its Lambert W map; every other law is
enclosed half-swing by half-swing (``swing``, beside springs ``wells``).  ``method`` names the route.

``ended`` names the last turning point if the sequence has ended before or at the last number asked for:

``sticks``      dry friction holds the mass there;
``creeps``      some alpha < 1: the mass approaches its place of rest without passing it (derivation ``creep``);
``overdamped``  linear damping with epsilon >= 2;
``rotates``, ``escapes``  the start has the energy to leave the well, and does.

For alpha > 1 alone the sequence never ends, however strong the damping (derivation ``no-overdamping``).

>>> table = turning_points(Law({"3/2": "1/10"}), 2, 20, times=True)
>>> table.points[1], table.certified
(TurningPoint(n=1, x='-0.87019329198866231436', tau='3.1460821722171718997'), True)
>>> half = turning_points(Law({"1/2": "1"}), 4, 10)
>>> [p.x for p in half.points], half.ended
(['1.000000000'], {'n': 0, 'reason': 'creeps'})
"""

from collections.abc import Callable
from typing import Any

from flint import ctx

from asymptotics.budget import DEFAULT_SECONDS, budget, require_seconds, tick
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.law import Law
from asymptotics.numbers.decimals import bits_for, decimal_of_ball
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.swing.lingering import lost_bits, require_brief
from asymptotics.swing.sequence import Turning
from asymptotics.turning.any_well import well_turning_points
from asymptotics.turning.coulomb import coulomb_turning_points
from asymptotics.turning.drag_exact import drag_serves, drag_turning_points
from asymptotics.turning.kicked import kicked_turning_points
from asymptotics.turning.linear import linear_turning_points
from asymptotics.turning.quadratic import TurningPoint, TurningPoints, quadratic_serves, quadratic_turning_points
from asymptotics.turning.routes import FAR, Plan

MAX_GENERAL_DIGITS = 1000
_TRIES = 6
_SPARE = 20  # bits beyond the digits: one value in thousands is too near a tie for them, and is tried again

Progress = Callable[[int], None]


def turning_points(
    law: Law,
    count: int,
    digits: int = 30,
    *,
    start: int = 0,
    times: bool = False,
    x0: Number = 1,
    v0: Number = 0,
    max_seconds: float = DEFAULT_SECONDS,
    progress: Progress = lambda done: None,
) -> TurningPoints:
    """Turning points n = start ... start + count - 1 as far as they exist, for the strengths epsilon_i of ``law``.

    With springs or losses that depend on the place the start is at ``x0`` in the units of the strengths: quadratic drag
    and dry friction from rest by their closed primitive (``drag_exact``), everything else by ``any_well``.
    With ``v0`` (dimensionless, as ``x0``) the start is in motion: n = 0 is the first turning point, see ``kicked``.
    ``progress`` is called with the number of points finished.  Raises InputError for a negative strength, LimitError
    for more work than the stated limits or ``max_seconds``, UndecidedError where balls cannot tell how it goes on.
    """

    def finished(done: int) -> None:
        tick(f"turning point {done} of {count}")
        progress(done)

    law = Law.read(law)
    law.require_dissipative("a sequence of turning points to rest")
    place, speed = exact_number(x0, "x0"), exact_number(v0, "v0")
    if not law.is_pure:
        with budget(max_seconds):
            if drag_serves(law) and not times and speed.is_zero:
                return drag_turning_points(law, place, count, digits, start=start, progress=finished)
            return well_turning_points(law, place, speed, count, digits, start=start, times=times, progress=finished)
    acting = [t for t in law.terms if t.strength.sign > 0] or [law.terms[0]]
    epsilon, velocity = acting[0].strength, acting[0].velocity
    if speed.is_zero and str(place) != "1":
        raise InputError("x0", f"{x0}: from rest the unit of length is |x0|, X(0) = 1", "1, or a start with v0")
    with budget(max_seconds):
        if not speed.is_zero:
            return kicked_turning_points(Law.from_terms(acting), place, speed, count, digits, start=start, times=times)
        if len(acting) == 1 and velocity.is_rational and isinstance(epsilon, ExactReal):
            alpha = velocity.rational
            if alpha == 0:
                return coulomb_turning_points(epsilon, count, digits, start=start, times=times)
            if alpha == 1:
                return linear_turning_points(epsilon, count, digits, start=start, times=times)
            if alpha == 2 and quadratic_serves(epsilon):
                return quadratic_turning_points(epsilon, count, digits, start=start, times=times, progress=finished)
        return _enclosed(Law.from_terms(acting), count, digits, start, times, progress)


def _enclosed(law: Law, count: int, digits: int, start: int, times: bool, progress: Progress) -> TurningPoints:
    if digits > MAX_GENERAL_DIGITS:
        reason = f"{digits} digits are too many for a law without a closed form"
        raise LimitError("digits", reason, f"at most {MAX_GENERAL_DIGITS} digits")
    bits = bits_for(digits, _SPARE) + 2 * (min(start, FAR) + count).bit_length()
    require_brief(law, start + count, digits, bits)
    bits += lost_bits(law)
    plan = Plan.of(law, start, count, bits)
    require_seconds(plan.seconds, f"{start + count} half-swings with {digits} digits")
    reason = ""
    for _ in range(_TRIES):
        try:
            points, ended, lacking = _pass(plan, count, digits, start, times, bits, progress)
        except UndecidedError as undecided:
            lacking, reason = bits, f": {undecided}"
        if not lacking:
            columns = zip(*((t.velocity, t.strength) for t in law.terms))
            alpha, epsilon = (",".join(map(str, column)) for column in columns)
            method = f"half-swing by half-swing, {plan.method} in balls of {bits} bits"
            return TurningPoints(alpha, epsilon, digits, tuple(points), method, True, ended)
        bits += max(lacking, digits)
    raise UndecidedError(f"no certified {digits} digits at {bits} bits{reason}")


def _pass(
    plan: Plan, count: int, digits: int, start: int, times: bool, bits: int, progress: Progress
) -> tuple[list[TurningPoint], dict[str, Any] | None, int]:
    """The points, how they end, and how many bits were lacking (0 if none) at the first that could not be rounded."""
    points: list[TurningPoint] = []
    with ctx.workprec(bits):
        for here in plan.turnings():
            tick(f"turning point {here.n}")
            if here.n >= start:
                point = _rounded(here, digits, times)
                if point is None:
                    return points, None, 40 + max(0, bits_for(digits, 8) - here.x.rel_accuracy_bits())
                points.append(point)
                progress(len(points))
            if here.ended is not None:
                return points, {"n": here.n, "reason": here.ended}, 0
            if here.n == start + count - 1:
                break
    return points, None, 0


def _rounded(here: Turning, digits: int, times: bool) -> TurningPoint | None:
    x = decimal_of_ball(here.x, digits)
    tau = decimal_of_ball(here.tau, digits) if times else None
    return None if x is None or (times and tau is None) else TurningPoint(here.n, x, tau)
