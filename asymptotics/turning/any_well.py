"""Turning points beside any spring or pendulum, of any loss, from rest or in motion: certified half-swing by
half-swing.

    X'' + V'(X) + sum_i epsilon_i |X|^m_i X'|X'|^(alpha_i-1) = 0,    X(0) = x0, X'(0) = v0,  in the units of the
    strengths.

From rest x is in those units (rad for a pendulum); after a start in motion n = 0 is the first turning point, and x is
in units of its amplitude, which ``first`` holds with its time.  The room ``wells`` says how it is enclosed.

>>> law = Law({"3/2": "1/10"}, spring="pendulum")
>>> table = well_turning_points(law, ExactReal(2), ExactReal(0), 2, 12, times=True)
>>> table.points[1], table.certified
(TurningPoint(n=1, x='-1.53184190291', tau='3.94540754042'), True)
>>> well_turning_points(law, ExactReal(0), ExactReal(3), 2, 12).ended
{'n': -1, 'reason': 'rotates'}
"""

from collections.abc import Callable, Iterator

from flint import arb, ctx

from asymptotics.budget import require_seconds, tick
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.law import Law
from asymptotics.numbers.decimals import bits_for, decimal_of_ball
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.precision import TooWideError, at_growing_precision
from asymptotics.swing.sequence import Turning
from asymptotics.swing.taylor import GUARD
from asymptotics.turning.quadratic import TurningPoint, TurningPoints
from asymptotics.wells.ends import require_inside
from asymptotics.wells.force import Force, estimated_seconds
from asymptotics.wells.sequence import first_from, rest, sequence

MAX_DIGITS, MAX_LAST = 1000, 100_000
METHOD = "half-swing by half-swing in the well, local expansions and Taylor steps in balls"
_TRIES, _SPARE = 4, 36

Progress = Callable[[int], None]


def well_turning_points(
    law: Law, x0: ExactReal, v0: ExactReal, count: int, digits: int, *, start: int = 0, times: bool = False,
    progress: Progress = lambda done: None,
) -> TurningPoints:  # fmt: skip
    """Turning points n = start ... start + count - 1 as far as they exist; ``ended["n"]`` is -1 if there is none.

    InputError for a start outside the well, anti-damping, or a spring that depends on the velocity; LimitError for
    sizes; UndecidedError where balls cannot tell how the motion goes on.
    """
    if digits > MAX_DIGITS or start + count > MAX_LAST:
        raise LimitError("digits", f"{digits} digits of {start + count} points", f"{MAX_DIGITS} and {MAX_LAST}")
    alpha, epsilon = (",".join(str(getattr(t, n)) for t in law.losses) for n in ("velocity", "strength"))

    def attempt(bits: int) -> TurningPoints | None:
        try:
            return found_at(bits)
        except UndecidedError as undecided:  # how the motion goes on may show at a higher precision
            raise TooWideError(str(undecided)) from undecided

    def found_at(bits: int) -> TurningPoints | None:
        with ctx.workprec(bits + GUARD):
            force = Force.of(law.terms)
        require_inside(force, x0.ball(), str(x0))
        first = rest(x0.ball()) if v0.is_zero else first_from(force, x0.ball(), v0.ball())
        if isinstance(first, str):
            return TurningPoints(alpha, epsilon, digits, (), METHOD, True, {"n": -1, "reason": first})
        kick = None if v0.is_zero else first
        shown = {} if kick is None else _named(kick, digits)
        found = _points(sequence(force, first), kick, start, count, digits, times, progress)
        if found is None or None in shown.values():
            return None
        points, ended = found
        named = {name: str(text) for name, text in shown.items()} or None
        return TurningPoints(alpha, epsilon, digits, points, METHOD, True, ended, named)

    if x0.is_zero and v0.is_zero:
        raise InputError("x0", "0 is the place of rest", "a start away from 0, or v0")
    bits = bits_for(digits, _SPARE) + 2 * (start + count).bit_length()
    seconds = estimated_seconds(Force.of(law.terms), start + count, bits)
    require_seconds(seconds, f"{start + count} half-swings with {digits} digits")
    return at_growing_precision(attempt, digits, bits, max_bits=bits << (_TRIES - 1))


def _points(
    found: Iterator[Turning],
    kick: Turning | None,
    start: int,
    count: int,
    digits: int,
    times: bool,
    progress: Progress,
) -> tuple[tuple[TurningPoint, ...], dict[str, object] | None] | None:
    """The points and how they end, or None as soon as one cannot be rounded."""
    made: list[TurningPoint] = []
    for here in found:
        tick(f"turning point {here.n}")
        if here.n >= start:
            point = _rounded(here, kick, digits, times)
            if point is None:
                return None
            made.append(point)
            progress(len(made))
        if here.ended is not None:
            return tuple(made), {"n": here.n, "reason": here.ended}
        if here.n >= start + count - 1:
            return tuple(made), None
    raise TooWideError("the sequence has no end")


def _rounded(here: Turning, kick: Turning | None, digits: int, times: bool) -> TurningPoint | None:
    x, tau = here.x, here.tau
    if kick is not None:
        x, tau = (arb(here.side), arb(0)) if here.n == 0 else (x / _size(kick), tau - kick.tau)
    shown = decimal_of_ball(x, digits)
    clock = decimal_of_ball(tau, digits) if times else None
    return None if shown is None or (times and clock is None) else TurningPoint(here.n, shown, clock)


def _named(kick: Turning, digits: int) -> dict[str, str | None]:
    return {"amplitude": decimal_of_ball(_size(kick), digits), "tau": decimal_of_ball(kick.tau, digits)}


def _size(here: Turning) -> arb:
    return arb(here.amplitude, here.amplitude_error)
