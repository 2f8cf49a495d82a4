"""Turning points one after the other in a well: what is not followed exactly is carried beside, by contraction.

From an exact amplitude the next one and the time are enclosed (``course``); the midpoint is the next start.  The
place of the true motion, within ``amplitude_error`` of it, is led on by the contraction of ``distance.contracted``:
absolute errors in the square of the speed only add, and under viscous loss they decay as the energy does.  Times add
what ``distance.lateness`` allows.

>>> from itertools import islice
>>> from flint import ctx
>>> from asymptotics.law import Law
>>> with ctx.workprec(100):
...     pendulum = Force.of(Law({1: "1/5"}, spring="pendulum").terms)
...     points = list(islice(sequence(pendulum, rest(arb(2))), 3))
>>> [point.x.str(10) for point in points], points[2].tau.str(10)
(['2.000000000', '[-1.276... +/- ...]', '[0.88... +/- ...]'], '[7.3... +/- ...]')
"""

from collections.abc import Iterator

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.numbers.context import ctx
from asymptotics.swing.ends import STICKS
from asymptotics.swing.sequence import Turning
from asymptotics.wells.course import Landing, course, unit_at
from asymptotics.wells.distance import contracted
from asymptotics.wells.ends import inside, leaves
from asymptotics.wells.force import Force


def rest(X: arb) -> Turning:
    """A start from rest at X != 0, at tau = 0."""
    return Turning(0, 1 if X > 0 else -1, abs(X).mid(), arb(0), X.rad(), arb(0))


def first_from(force: Force, X: arb, V: arb) -> Turning | str:
    """The first turning point at tau >= 0 from a state with V != 0, or why there is none."""
    if not (V > 0 or V < 0):
        raise UndecidedError("the direction of the first motion is undecided")
    side = -1 if V > 0 else 1
    u, w = side * X.mid(), abs(V).mid()
    given = upper(unit_at(force, u, w) * X.rad() + V.rad())
    for piece in course(force, u, w, given):
        if piece.ended is not None:
            return piece.ended
        if isinstance(piece, Landing):
            return after_kick(force, piece, side, given)
    raise UndecidedError("the first half-swing has no end")


def after_kick(force: Force, piece: Landing, side: int, given: arb) -> Turning | str:
    """Turning point 0 after a course that began in motion, within ``given`` of the truth, or how it left the well.

    UndecidedError at its edge.
    """
    late = upper(piece.late(given) + piece.clock.rad())
    here = Turning(0, -side, -piece.turn, piece.clock.mid(), piece.gap(given), late)
    stays = inside(force, arb(here.amplitude, here.amplitude_error))
    if stays is None:
        raise UndecidedError("whether the first turning point lies inside the well is undecided")
    return here if stays else leaves(force)


def sequence(force: Force, start: Turning) -> Iterator[Turning]:
    """Turning points from ``start`` on, at the precision current at each call; the last one says why it ended.

    UndecidedError where the enclosures cannot tell whether there is a next one.
    """
    here = start
    while True:
        following = next_turning(force, here)
        if isinstance(following, str):
            yield Turning(**{**vars(here), "ended": following})
            return
        yield here
        here = following


def next_turning(force: Force, here: Turning) -> Turning | str:
    """The next turning point, or why there is none."""
    return _followed(force, here)[0]


def half_swing(force: Force, p: arb) -> tuple[Turning | str, int]:
    """The turning point after a start from rest at the exact p > 0, or why there is none; how many pieces it took."""
    return _followed(force, rest(p))


def _followed(force: Force, here: Turning) -> tuple[Turning | str, int]:
    if sticks(force, here):
        return STICKS, 0
    given = upper(unit_at(force, here.amplitude, arb(0)) * here.amplitude_error)
    for count, piece in enumerate(course(force, here.amplitude, arb(0), given), start=1):
        if piece.ended is not None:
            return piece.ended, count
        if isinstance(piece, Landing):
            return after_landing(force, here, piece), count
    raise UndecidedError("the half-swing has no end")


def after_landing(force: Force, here: Turning, piece: Landing) -> Turning:
    """The next turning point: midpoints, and errors by contraction.

    A motion that is late at one turning point is as late at the next one: the time's error only adds.
    """
    late = piece.late(upper(piece.unit * here.amplitude_error))
    duration = (piece.clock - late).lower()
    carried = contracted(force, here.amplitude, here.amplitude_error, duration, piece.turn, piece.miss)
    clock = here.time + piece.clock
    error = upper(here.time_error + clock.rad() + late)
    return Turning(here.n + 1, -here.side, -piece.turn, clock.mid(), upper(carried + piece.miss), error)


def sticks(force: Force, here: Turning) -> bool:
    """Whether dry friction holds the mass at a turning point."""
    if not force.grips:
        return False
    with ctx.workprec(max(64, ctx.prec)):
        place = abs(arb(here.amplitude, here.amplitude_error))
        margin = force.rest(place)
        if margin <= 0:
            return True
        if margin > 0 and here.amplitude > 0:
            return False
    raise UndecidedError(f"whether dry friction holds the mass at turning point {here.n} is undecided")
