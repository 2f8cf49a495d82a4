"""The pieces of a motion between its turning points: which series, from where, for how long.

Every half-swing is laid out by itself, from the turning points that are known on both of its sides: one piece that
leaves, one that arrives, and pieces that pass between them, each expanded in its middle.  Times at which a state is
claimed are ends of pieces.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import ceil, log2
from typing import Any

from flint import arb

from asymptotics.certificates.equation import Equation
from asymptotics.certificates.pieces import longest, nearest, piece
from asymptotics.certificates.series import PowerSeries, from_rest, in_motion
from asymptotics.errors import LimitError
from asymptotics.numbers.rationals import to_fmpq
from asymptotics.running.budget import tick

Pieces = Iterator[dict[str, Any]]
MOST = 400
"""Pieces of a half-swing: as many are met where a state is claimed right beside a turning point."""
_MARGIN = 0.9  # of the longest duration: expanded in its middle, a piece is somewhat worse than from its beginning


@dataclass(frozen=True)
class Plan:
    """Coefficients over 2^``bits``, series up to the power ``degree`` of the time, 2^``tolerance`` left out."""

    bits: int
    degree: int
    tolerance: float


@dataclass(frozen=True)
class Landing:
    """A turning point as it is known beforehand: an exact time near it, and its place."""

    time: Fraction
    place: arb

    @property
    def side(self) -> int:
        """The sign of the place."""
        return 1 if self.place > 0 else -1


def swing(
    equation: Equation, plan: Plan, begin: Landing | None, end: Landing | None, cuts: Sequence[Fraction], towards: int
) -> Pieces:
    """The pieces from ``begin`` (None: the start, in motion) to ``end`` (None: to the last of the times ``cuts``).

    ``towards`` is the sign of the speed.
    """
    last: PowerSeries | None = None
    arrival = Fraction(0)
    if end is not None:
        last = from_rest(equation, end.place, -towards, towards, plan.degree)
        before = max([begin.time if begin else Fraction(0), *cuts])
        arrival = _short(longest(last, plan.tolerance), end.time - before)
    if begin is None:
        now, state = Fraction(0), (arb(to_fmpq(equation.x0)), arb(to_fmpq(equation.v0)))
    else:
        first = from_rest(equation, begin.place, towards, towards, plan.degree)
        until = cuts[0] if cuts else end.time - arrival if end else begin.time
        step = _short(longest(first, plan.tolerance), until - begin.time)
        yield piece("leave", first, equation, step, plan.bits)
        now, state = begin.time + step, _state(first, step)
    goals = [*cuts, *([end.time - arrival] if end is not None else [])]
    count = 0
    for goal in goals:
        while now < goal:
            made, now, state = _passed(equation, plan, now, state, goal)
            yield made
            count += 1
            if count > MOST:
                reason = "a time is too near a turning point, or the motion creeps"
                raise LimitError("certificate", f"{reason}: more than {MOST} pieces", "another time, or fewer digits")
    if last is not None:
        yield piece("arrive", last, equation, arrival, plan.bits)


def _short(size: float, most: Fraction) -> Fraction:
    """A number of few bits up to ``size``, or ``most`` where it is no larger; no small remainder is left."""
    if most <= size:
        return most
    size = min(size, 0.7 * float(most))
    bits = 8 - int(log2(size))
    return Fraction(int(size * 2.0**bits), 2**bits) if bits >= 0 else Fraction(int(size))


def _state(series: PowerSeries, s: Fraction) -> tuple[arb, arb]:
    """(P, P') at the time s."""
    time = arb(to_fmpq(s))
    z = time ** arb(to_fmpq(Fraction(1, series.root)))
    place = sum((c * z**n for n, c in series.y.items()), arb(0))
    speed = sum((n * c * z**n for n, c in series.y.items() if n), arb(0)) / (series.root * time)
    return place.mid(), speed.mid()


def _passed(
    equation: Equation, plan: Plan, now: Fraction, state: tuple[arb, arb], goal: Fraction
) -> tuple[dict[str, Any], Fraction, tuple[arb, arb]]:
    """A piece through the motion from a state, its end, and the state there."""
    here = in_motion(equation, *state, plan.degree)
    half = longest(here, plan.tolerance) * _MARGIN
    while True:
        tick("a piece of the certificate")
        left = (goal - now) / 2
        number = ceil(left / Fraction(half))
        # A few pieces of one length, or one as long as it may be.
        step = left if number == 1 else _short(float(left / number) if number < 5 else half, left)
        middle = here.at(arb(to_fmpq(step)))
        centred = in_motion(equation, *middle, plan.degree)
        if longest(centred, plan.tolerance) >= step:
            return piece("pass", centred, equation, step, plan.bits), now + 2 * step, centred.at(arb(to_fmpq(step)))
        half *= 0.7


def landing(time: arb, place: arb, bits: int) -> Landing:
    """A turning point from balls: its time rounded."""
    return Landing(Fraction(nearest(time, bits), 1 << bits), place.mid())
