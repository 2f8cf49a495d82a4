"""Turning points of a start in motion: n = 0 is the first turning point at tau >= 0, x in units of its amplitude.

The state (X, X') = (x0, v0) at tau = 0 is followed to its first turning point, of amplitude a at the time t; from there
on x_n = X_n/a and tau_n = time - t.  The strengths stay those of the units given; ``first`` holds a and t.

>>> table = kicked_turning_points(Law({"3/2": "1/10"}), ExactReal(0), ExactReal(1), 2, 12, times=True)
>>> table.first, table.points[1].x
({'amplitude': '0.933516582123', 'tau': '1.53303122970'}, '-0.874169658104')
"""

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from typing import Any

from flint import arb, ctx

from asymptotics.budget import require_seconds, tick
from asymptotics.errors import UndecidedError
from asymptotics.law import Law
from asymptotics.numbers.decimals import bits_for, certified_decimal, decimal_of_ball, rational_decimal
from asymptotics.numbers.exact import ExactReal, square_root
from asymptotics.numbers.rationals import to_fmpq
from asymptotics.swing.damping import Damping
from asymptotics.swing.lingering import lost_bits, require_brief
from asymptotics.swing.sequence import Turning, first_from
from asymptotics.swing.taylor import GUARD
from asymptotics.turning.coulomb import coulomb_turning_points
from asymptotics.turning.quadratic import TurningPoint, TurningPoints
from asymptotics.turning.routes import FAR, Plan

_TRIES = 5


def kicked_turning_points(
    law: Law, x0: ExactReal, v0: ExactReal, count: int, digits: int, *, start: int = 0, times: bool = False
) -> TurningPoints:
    """Turning points n = start ... of the motion from (x0, v0), v0 != 0; ``ended["n"]`` is -1 if there is none at all.

    LimitError and UndecidedError as ``turning_points``.
    """
    exact = _dry(law, x0, v0, count, digits, start, times)
    if exact is not None:
        return exact
    bits = bits_for(digits, 48) + 2 * (min(start, FAR) + count).bit_length()
    require_brief(law, start + count, digits, bits)
    bits += lost_bits(law)
    alpha, epsilon = (",".join(map(str, c)) for c in zip(*((t.velocity, t.strength) for t in law.terms), strict=True))
    plan = Plan.of(law, start, count, bits)
    require_seconds(plan.seconds, f"{start + count} half-swings with {digits} digits")
    method = f"half-swing by half-swing, {plan.method} in balls"
    reason = ""
    for _ in range(_TRIES):
        try:
            found = _pass(law, plan, (x0, v0), count, digits, start, times, bits)
        except UndecidedError as undecided:  # how the motion goes on may show at a higher precision
            found, reason, bits = None, f": {undecided}", 2 * bits
        if found is not None:
            points, ended, named = found
            return TurningPoints(alpha, epsilon, digits, points, method, True, ended, named)
        bits += max(64, bits // 2)
    raise UndecidedError(f"no certified {digits} digits at {bits} bits{reason}")


def _pass(
    law: Law, plan: Plan, at: tuple[ExactReal, ExactReal], count: int, digits: int, start: int, times: bool, bits: int
) -> tuple[tuple[TurningPoint, ...], dict[str, Any] | None, dict[str, str] | None] | None:
    """The points, how they end, and turning point 0 in words; None if one of them cannot be rounded at ``bits``."""
    with ctx.workprec(bits):
        with ctx.workprec(bits + GUARD):
            damping = Damping.of_law(law)
        first = first_from(damping, at[0].ball(), at[1].ball())
        if isinstance(first, str):
            return (), {"n": -1, "reason": first}, None
        found = _points(_until(plan.turnings(first), start + count - 1), first, start, digits, times)
        shown = [decimal_of_ball(value, digits) for value in (_size(first), first.tau)]
    if found is None or None in shown:
        return None
    points, reason = found
    ended = None if reason is None else {"n": reason[0], "reason": reason[1]}
    return points, ended, dict(zip(("amplitude", "tau"), map(str, shown), strict=True))


def _dry(
    law: Law, x0: ExactReal, v0: ExactReal, count: int, digits: int, start: int, times: bool
) -> TurningPoints | None:
    """Dry friction alone, where the radius R of the first half-swing is rational: ties are decided exactly.

    s X = c + R cos theta with c = epsilon, R^2 = (s x0 - c)^2 + v0^2; it turns at theta = pi, at the amplitude R - c.
    """
    c = law.terms[0].strength
    if len(law.terms) > 1 or not law.terms[0].velocity.is_zero or not isinstance(c, ExactReal):
        return None
    if not (c.is_rational and x0.is_rational):
        return None
    y = (-1 if v0 > 0 else 1) * x0.rational - c.rational
    R = square_root(y**2 + v0.coefficient**2 * v0.radicand)
    if not R.is_rational or not R.rational > c.rational:
        return None
    a = R.rational - c.rational
    table = coulomb_turning_points(ExactReal(c.rational / a), count, digits, start=start, times=times)
    points = tuple(replace(p, x=p.x if v0 > 0 else _negated(p.x)) for p in table.points)
    tau = certified_decimal(lambda: arb.pi() - arb.atan2(abs(v0.ball()), arb(to_fmpq(y))), digits)
    first = {"amplitude": rational_decimal(a, digits), "tau": tau}
    return replace(table, epsilon=str(c), points=points, first=first)


def _negated(text: str) -> str:
    return text if Fraction(text) == 0 else text.removeprefix("-") if text.startswith("-") else "-" + text


def _points(
    turnings: Iterator[Turning], first: Turning, start: int, digits: int, times: bool
) -> tuple[tuple[TurningPoint, ...], tuple[int, str] | None] | None:
    """The points and how they end, or None as soon as one cannot be rounded."""
    made = []
    for here in turnings:
        tick(f"turning point {here.n}")
        if here.n >= start:
            at_first = here.n == 0
            x = decimal_of_ball(arb(here.side) if at_first else here.x / _size(first), digits)
            tau = decimal_of_ball(arb(0) if at_first else here.tau - first.tau, digits)
            if x is None or tau is None:
                return None
            made.append(TurningPoint(here.n, x, tau if times else None))
        if here.ended is not None:
            return tuple(made), (here.n, here.ended)
    return tuple(made), None


def _until(points: Iterator[Turning], last: int) -> Iterator[Turning]:
    for here in points:
        yield here
        if here.n >= last:
            return


def _size(here: Turning) -> arb:
    return arb(here.amplitude, here.amplitude_error)
