"""Turning points for any alpha >= 0 and any sum of laws: exact where there is a closed form, else to high precision.

``turning_points`` chooses: one law with alpha = 0, 1 or 2 has its certified route; every other law is integrated half-
swing by half-swing (``swing``) at two working precisions, and a table is given only if both agree in all its digits.
That is strong evidence, not a proof: ``certified`` is then False.

``ended`` names the last turning point if the sequence has ended before or at the last number asked for:

``sticks``      dry friction holds the mass there;
``creeps``      some alpha < 1: the mass approaches its place of rest without passing it (derivation ``creep``);
``overdamped``  linear damping with epsilon >= 2.

For alpha > 1 alone the sequence never ends, however strong the damping (derivation ``no-overdamping``).

>>> table = turning_points(Law({"3/2": "1/10"}), 2, 20, times=True)
>>> table.points[1], table.certified
(TurningPoint(n=1, x='-0.87019329198866231436', tau='3.1460821722171718997'), False)
>>> half = turning_points(Law({"1/2": "1"}), 4, 10)
>>> [p.x for p in half.points], half.ended
(['1.000000000'], {'n': 0, 'reason': 'creeps'})
"""

from collections.abc import Callable
from typing import Any

from flint import arb, ctx

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.law import Law
from asymptotics.numbers.decimals import bits_for, decimal_of_ball
from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.coulomb import coulomb_turning_points
from asymptotics.turning.linear import linear_turning_points
from asymptotics.turning.local_expansion import Damping
from asymptotics.turning.quadratic import TurningPoint, TurningPoints, quadratic_turning_points
from asymptotics.turning.swing import orbit

MAX_SECONDS = 600
MAX_HEURISTIC_DIGITS = 1000
_TRIES = 4

Rows = list[tuple[arb, arb]]


def turning_points(
    law: Law,
    count: int,
    digits: int = 30,
    *,
    start: int = 0,
    times: bool = False,
    progress: Callable[[int], None] = lambda done: None,
) -> TurningPoints:
    """Turning points n = start ... start + count - 1 as far as they exist, for the strengths epsilon_i of ``law``.

    ``progress`` is called with the number of points finished.  Raises InputError for a negative strength, LimitError
    for more work than the stated limits, UndecidedError if the two precisions do not agree.
    """
    law = Law.read(law)
    law.require_dissipative("a sequence of turning points to rest")
    law.require_pure("this sequence of turning points")
    acting = [t for t in law.terms if t.strength.sign > 0] or [law.terms[0]]
    epsilon = acting[0].strength
    if len(acting) == 1 and acting[0].velocity.is_rational and isinstance(epsilon, ExactReal):
        alpha = acting[0].velocity.rational
        if alpha == 0:
            return coulomb_turning_points(epsilon, count, digits, start=start, times=times)
        if alpha == 1:
            return linear_turning_points(epsilon, count, digits, start=start, times=times)
        if alpha == 2:
            return quadratic_turning_points(epsilon, count, digits, start=start, times=times, progress=progress)
    return _integrated(Law.from_terms(acting), count, digits, start, times, progress)


def _integrated(
    law: Law, count: int, digits: int, start: int, times: bool, progress: Callable[[int], None]
) -> TurningPoints:
    _require_size(law, start + count, digits)
    bits, step = bits_for(digits, 40), bits_for(digits // 4, 40)
    previous, ended = _run(law, start + count, bits, lambda done: None)
    for _ in range(_TRIES):
        bits += step
        rows, ended = _run(law, start + count, bits, progress)
        if len(rows) == len(previous) and all(_agree(a, b, digits) for a, b in zip(rows, previous)):
            points = tuple(_point(n, rows[n], digits, times) for n in range(start, min(start + count, len(rows))))
            columns = zip(*((t.velocity, t.strength) for t in law.terms))
            alpha, epsilon = (",".join(map(str, column)) for column in columns)
            method = f"half-swing by half-swing, agreement of {bits - step} and {bits} bits"
            return TurningPoints(alpha, epsilon, digits, points, method, False, ended)
        previous = rows
    raise UndecidedError(f"{bits - step} and {bits} bits do not agree in {digits} digits")


def _run(
    law: Law, last: int, bits: int, progress: Callable[[int], None]
) -> tuple[Rows, dict[str, Any] | None]:
    """(x_n, tau_n) for n < last, and how the sequence ended if there is no turning point n = last."""
    with ctx.workprec(bits):
        damping = Damping.of([(t.strength.ball(), t.velocity) for t in law.terms])
        rows = [(arb(1), arb(0))]
        for piece in orbit(damping, arb(1), arb(0)):
            if piece.trapped is not None:
                return rows, {"n": len(rows) - 1, "reason": piece.trapped}
            if piece.turning is not None and piece.end is not None:
                if len(rows) == last:
                    return rows, None
                rows.append((piece.turning, piece.end))
                progress(len(rows))
    return rows, None


def _agree(a: tuple[arb, arb], b: tuple[arb, arb], digits: int) -> bool:
    close = arb(10) ** -(digits + 2)
    return all(bool(abs(p - q) <= abs(p) * close) for p, q in zip(a, b))


def _point(n: int, row: tuple[arb, arb], digits: int, times: bool) -> TurningPoint:
    x, tau = (decimal_of_ball(value.mid(), digits) for value in row)
    return TurningPoint(n, str(x), str(tau) if times else None)


def estimated_seconds(law: Law, last: int, digits: int) -> float:
    """The expected time, from measurements at 30 and 60 digits; good to a factor of about three."""
    bits = bits_for(digits, 40)
    apart = 1 + 5 * sum(not (t.velocity.is_rational and t.velocity.rational.denominator <= 20) for t in law.terms)
    seconds: float = 2.5 * (last + 1) * 0.04 * (bits / 150) ** 2.5 * apart * len(law.terms)
    return seconds


def _require_size(law: Law, last: int, digits: int) -> None:
    if digits > MAX_HEURISTIC_DIGITS:
        reason = f"{digits} digits are too many for a law without a closed form"
        raise LimitError("--digits", reason, f"at most {MAX_HEURISTIC_DIGITS} digits")
    seconds = estimated_seconds(law, last, digits)
    if seconds > MAX_SECONDS:
        reason = f"{last} half-swings with {digits} digits would take about {seconds:.0f} s"
        raise LimitError("--count", reason, f"work of at most {MAX_SECONDS} s: fewer points or fewer digits")
