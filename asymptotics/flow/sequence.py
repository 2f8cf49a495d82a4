"""Turning points one after the other, without losing digits: what is not followed exactly is carried beside.

From an exact amplitude the next one and the time are enclosed (``trajectory``); the midpoint is the next start.  What
the midpoints drop is led on by the contractions of ``error_propagation``: in a nonexpansive flow errors only add, in
any other well absolute errors in the square of the speed do, and under viscous loss they decay as the energy does.
Times add what ``error_propagation.turning_delay`` allows.  So n half-swings at a working precision of d digits and
log2(n) bits keep d digits, and memory stays flat.

>>> from itertools import islice
>>> from flint import ctx
>>> from asymptotics.flow.turning import at_rest
>>> from asymptotics.law import Law
>>> from asymptotics.flow.wells.even_well import EvenWell
>>> with ctx.workprec(100):
...     pendulum = EvenWell.of(Law({1: "1/5"}, spring="pendulum").terms)
...     points = list(islice(sequence(pendulum, at_rest(arb(2))), 3))
>>> [point.x.str(10) for point in points], points[2].tau.str(10)
(['2.000000000', '[-1.276... +/- ...]', '[0.88... +/- ...]'], '[7.3... +/- ...]')
"""

from collections.abc import Iterator
from dataclasses import replace

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.flow.error_propagation import contraction_by_energy
from asymptotics.flow.trajectory import ArrivedPiece, CertifiedFlow, half_swing_pieces
from asymptotics.flow.turning import TurningState, at_exact_place
from asymptotics.numbers.context import ctx

STICKS = "sticks"


def start_in_motion(flow: CertifiedFlow, X: arb, V: arb) -> tuple[int, arb, arb, arb]:
    """(the side, u, w, what is given) of a half-swing from a state in two balls with V != 0."""
    if not (V > 0 or V < 0):
        raise UndecidedError("the direction of the first motion is undecided")
    side = -1 if V > 0 else 1
    u, w = side * X.mid(), abs(V).mid()
    # What the midpoints drop of the two balls, in the distance of the flow: unit |u - u~| + |w - w~| is no less than
    # the root of their squares.
    return side, u, w, upper(upper(flow.unit(u, w) * X.rad()) + V.rad())


def first_from(flow: CertifiedFlow, X: arb, V: arb) -> TurningState | str:
    """The first turning point at tau >= 0 from a state with V != 0, or why there is none."""
    side, u, w, given = start_in_motion(flow, X, V)
    for piece in half_swing_pieces(flow, u, w, given):
        if piece.ended is not None:
            return piece.ended
        if isinstance(piece, ArrivedPiece):
            return turning_after_start(piece, side, given)
    raise UndecidedError("the first half-swing has no end")


def turning_after_start(piece: ArrivedPiece, side: int, given: arb) -> TurningState | str:
    """Turning point 0 after a half-swing that began in motion, within ``given`` of the truth, or how it left the well.

    UndecidedError at its edge.
    """
    # Time runs on its own orbit's clock: the truth turns within ``late`` of it, and the clock is a ball.
    late = upper(piece.late(given) + piece.clock.rad())
    here = TurningState(0, -side, -piece.turn, piece.clock.mid(), piece.gap(given), late)
    # A start in motion may carry the mass beyond the top of its well and back to rest there; asked of every amplitude
    # that the truth may have.
    left = piece.flow.leaves(arb(here.amplitude, here.amplitude_error))
    return here if left is None else left


def sequence(flow: CertifiedFlow, start: TurningState) -> Iterator[TurningState]:
    """Turning points from ``start`` on, at the precision current at each call; the last one says why it ended.

    UndecidedError where the enclosures cannot tell whether there is a next one.
    """
    # Rational places replace their enclosures, so that an exact tie (dry friction that just holds) can be decided.
    here = at_exact_place(start, flow.exact(start.n))
    while True:
        if flow.endless:  # derivation ``no-overdamping``: there is a next one, whether or not anybody asks for it
            yield here
        # Whether this turning point is the last one is known only when the next half-swing has been followed, so the
        # point is held back until then, unless a theorem says that there is a next one.
        following = next_turning(flow, here)
        if isinstance(following, str):
            yield replace(here, ended=following)
            return
        if not flow.endless:
            yield here
        here = following


def next_turning(flow: CertifiedFlow, here: TurningState) -> TurningState | str:
    """The turning point after this one, or why there is none."""
    leap = flow.leap(here)
    return leap if leap is not None else turning_by_pieces(flow, here)[0]


def turning_by_pieces(flow: CertifiedFlow, here: TurningState) -> tuple[TurningState | str, int]:
    """The same by pieces, and how many they were."""
    # Dry friction first: it may hold the mass at a place where a trap or the first piece would be undecided.
    if sticks(flow, here):
        return STICKS, 0
    ended = flow.ended(flow.place(arb(here.amplitude, here.amplitude_error)), arb(0))
    if ended is not None:
        return ended, 0
    for count, piece in enumerate(half_swing_pieces(flow, here.amplitude, arb(0), given_at(flow, here)), start=1):
        if piece.ended is not None:
            return piece.ended, count
        if isinstance(piece, ArrivedPiece):
            return after_arrival(here, piece), count
    raise UndecidedError("the half-swing has no end")


def given_at(flow: CertifiedFlow, here: TurningState) -> arb:
    """The distance that the error of an amplitude is."""
    return upper(flow.unit(here.amplitude, arb(0)) * here.amplitude_error)


def after_arrival(here: TurningState, piece: ArrivedPiece) -> TurningState:
    """The next turning point: midpoints, and errors by contraction.

    A motion that is late at one turning point is as late at the next one: the time's error only adds.
    """
    late = piece.late(given_at(piece.flow, here))
    # The orbit from the exact amplitude turns within ``miss``; the error of the amplitude itself is led on by
    # contraction, which is sharper over a whole half-swing than the distances of its pieces.
    start, turn = (here.amplitude, here.amplitude_error), piece.flow.place(piece.turn)
    carried = contraction_by_energy(piece.flow.force, *start, piece.clock, late, turn, piece.miss)
    clock = here.time + piece.clock
    error = upper(upper(here.time_error + clock.rad()) + late)
    there = TurningState(here.n + 1, -here.side, -piece.turn, clock.mid(), upper(carried + piece.miss), error)
    return at_exact_place(there, piece.flow.exact(there.n))


def sticks(flow: CertifiedFlow, here: TurningState) -> bool:
    """Whether dry friction holds the mass at a turning point."""
    if not flow.force.grips:
        return False
    if here.exact is not None:
        return here.exact[1]
    # At least 64 bits: a short working precision must not make a clear case undecided.
    with ctx.workprec(max(64, ctx.prec)):
        margin = flow.force.restoring(flow.place(abs(arb(here.amplitude, here.amplitude_error))))
        # The spring pulls no more than friction holds: at equality the mass stays, and only an exact place reaches
        # that.
        if margin <= 0:
            return True
        # With an amplitude <= 0 the mass stopped before the centre or at it, because s_0 <= 0 there; s_0 > 0 would
        # contradict that, so such an enclosure says nothing.
        if margin > 0 and here.amplitude > 0:
            return False
    raise UndecidedError(f"whether dry friction holds the mass at turning point {here.n} is undecided")
