"""(X, X') at many times in one pass, as enclosures, from any start.

The turning points are followed as in ``sequence``; every half-swing that holds a time asked for is laid out in pieces,
at whose start the error of the turning point in place and time is one distance: within the window e about a turning
point the speed is at most e S and the place moves by at most e^2 S, S bounding the acceleration there.  An uncertain
time is read as its lower end and a width.

>>> from flint import ctx
>>> from asymptotics.law import Law
>>> from asymptotics.flow.linear_spring.linear_spring import LinearSpring
>>> from asymptotics.flow.damping import Damping
>>> with ctx.workprec(90):
...     flow = LinearSpring(Damping.of_law(Law({"3/2": "1/10"})))
...     found = states(flow, arb(1), arb(0), [arb(0), arb(9)])
...     [value.str(12) for state in found for value in state]
['[1.00000000000 +/- ...]', '[+/- ...]', '[-0.612550463671 +/- ...]', '[-0.288753570045 +/- ...]']
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import islice, takewhile
from typing import NoReturn

from flint import arb

from asymptotics.errors import InputError, UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.flow.sequence import after_arrival, start_in_motion, sticks, turning_after_start
from asymptotics.flow.times import exact_sum
from asymptotics.flow.trajectory import ESCAPES, ROTATES, ArrivedPiece, CertifiedFlow, Piece, half_swing_pieces
from asymptotics.flow.turning import TurningState, at_exact_place, at_rest
from asymptotics.numbers.context import ctx
from asymptotics.running.budget import tick
from asymptotics.running.cut_short import keeping

State = tuple[arb, arb]
# Distances are bounds of a few digits: the radius of a ball has 30 bits, and so few cost nothing.
_LOW = 40


@dataclass(frozen=True)
class KnownPiece(Piece):
    """A piece of a half-swing that is known as a whole: many times cost less than one after the other."""

    def all_at(self, times: Sequence[arb]) -> list[State]:
        """(u, w) of the truth at ascending times (balls) in the piece."""
        raise NotImplementedError


def states(flow: CertifiedFlow, X: arb, V: arb, times: Sequence[arb]) -> list[State]:
    """(X, X') at the ascending times tau >= 0 from the state (X, V) at tau = 0.

    InputError if the motion leaves its well before; UndecidedError where the enclosures cannot tell how it goes on.  An
    error carries the states that were found before it.
    """
    wanted = _Wanted(flow, times)
    with keeping(lambda: wanted.found or None):
        return _followed(flow, _first(flow, X, V, wanted), wanted)


def states_from(flow: CertifiedFlow, here: TurningState, times: Sequence[arb]) -> list[State]:
    """(X, X') at the ascending times tau >= here.tau, from a known turning point."""
    return _followed(flow, here, _Wanted(flow, times))


def _followed(flow: CertifiedFlow, here: TurningState, wanted: "_Wanted") -> list[State]:
    while not wanted.done:
        tick(f"turning point {here.n}")
        if sticks(flow, here):
            wanted.stays(here.x)
        else:
            here = _swing(flow, here, wanted)
    return wanted.found


class _Wanted:
    """The times still to be answered, and the states found so far."""

    def __init__(self, flow: CertifiedFlow, times: Sequence[arb]) -> None:
        self.flow = flow
        # The lower end of a time and its width are exact, so that every comparison of times below is decided.  A late
        # time has more bits than the working precision, which would round it into another half-swing.
        with ctx.workprec(max((t.bits() for t in times), default=ctx.prec) + ctx.prec):
            self.queue = [(low := t.lower(), (t - low).upper()) for t in times]
        self.found: list[State] = []

    @property
    def done(self) -> bool:
        return len(self.found) == len(self.queue)

    @property
    def following(self) -> arb:
        return self.queue[len(self.found)][0]

    def take(self, piece: Piece, side: int, start: arb) -> None:
        """All times up to the end of a piece of the half-swing that begins at ``start``."""
        last, before = exact_sum(start, piece.end), len(self.found)
        due = list(takewhile(lambda window: window[0] <= last, islice(self.queue, before, None)))
        # A trap is no reason to stop, as the motion goes on in it; beyond its well it has no certified course here.
        if due and piece.ended in (ESCAPES, ROTATES):
            _refuse(piece.ended)
        if isinstance(piece, KnownPiece):
            known = piece.all_at([low - start + arb(width / 2, width / 2) for low, width in due])
            self.found += [(side * u, -side * w) for u, w in known]
            return
        for low, width in due:
            # The distance bounds both unit |u - u~| and |w - w~|, so the place has an error of 1/unit of it.  A time
            # may lie before the start by the rounding of ``start``: an expansion bounds the rates on both sides of its
            # turning point.
            place, w = piece.own(exact_sum(low, -start))
            u, w = self.flow.back(place) + arb(0, upper(piece.error / piece.unit)), w + arb(0, piece.error)
            du, dw = _moved(self.flow, u, w, width)
            self.found.append((side * (u + arb(0, du)), -side * (w + arb(0, dw))))

    def stays(self, X: arb) -> None:
        """The mass stays at X for all remaining times."""
        self.found += [(X, arb(0))] * (len(self.queue) - len(self.found))


def _first(flow: CertifiedFlow, X: arb, V: arb, wanted: _Wanted) -> TurningState:
    """The first turning point at tau >= 0; times before it are answered."""
    if V == 0:
        return at_exact_place(at_rest(X), flow.exact(0))
    side, u, w, given = start_in_motion(flow, X, V)
    for piece in half_swing_pieces(flow, u, w, given):
        # Taken before the piece is looked at further: a time inside a last piece that is never completed still has its
        # answer.
        wanted.take(piece, side, arb(0))
        if wanted.done:
            return at_rest(X)
        if isinstance(piece, ArrivedPiece):
            here = turning_after_start(piece, side, given)
            return here if isinstance(here, TurningState) else _refuse(here)
    raise UndecidedError("the first half-swing has no end")


def _refuse(what: str) -> NoReturn:
    reason = f"from this start the motion {what} before that time: it leaves its well"
    raise InputError("v0", reason, "a start that stays inside the well, or an earlier time")


def _swing(flow: CertifiedFlow, here: TurningState, wanted: _Wanted) -> TurningState:
    """The next turning point; the half-swing is laid out in pieces only if a time may fall into it."""
    # The next turning point without pieces, if the next time asked for comes after it; a time within has to be reached
    # along the motion itself.
    leap = flow.leap(here, wanted.following)
    if leap is not None:
        return leap
    there = None
    for piece in half_swing_pieces(flow, here.amplitude, arb(0), _distance(flow, here)):
        wanted.take(piece, here.side, here.time)
        if wanted.done:
            return here
        # Where most of the half-swing is known, so is its end.
        if isinstance(piece, KnownPiece):
            there = flow.leap(here)
        if there is not None and there.time < wanted.following:
            return there
        if isinstance(piece, ArrivedPiece):
            return after_arrival(here, piece) if there is None else there
    raise UndecidedError("the half-swing has no end")


def _distance(flow: CertifiedFlow, here: TurningState) -> arb:
    """How far the true state is at most from the turning point ``here``, at the time ``here``."""
    unit, e = flow.unit(here.amplitude, arb(0)), here.time_error
    with ctx.workprec(_LOW):
        # At the time ``here`` the truth is not quite at rest, as it turned within ``time_error`` of it; how far it
        # moves in that time is part of the distance, and the unit of a place is ``unit`` of a speed.
        du, dw = _moved(flow, arb(here.amplitude, here.amplitude_error), arb(0), e)
        return upper(unit * (here.amplitude_error + du) + dw)


def _moved(flow: CertifiedFlow, u: arb, w: arb, width: arb) -> State:
    """How far place and speed move at most within ``width``, before or after a state in the two balls."""
    if width == 0:
        return arb(0), arb(0)
    with ctx.workprec(_LOW):
        # An a priori enclosure as for Picard's and Lindelof's theorem (Moore, Lohner): in a box of twice the size that
        # the state suggests.  The force of both directions is counted, for times after and before the state.
        first = width * flow.force.strongest(u, abs(w).upper())
        fastest, far = upper(2 * (abs(w) + first)), upper(2 * width * (abs(w) + first))
        for _ in range(40):
            dw = upper(width * flow.force.strongest(u + arb(0, far), fastest))
            du = upper(width * (abs(w).upper() + dw))
            # As long as the motion is in the box it moves no farther than (du, dw), so it cannot leave it within
            # ``width``.  If that is not within the box, a larger one is tried: each is twice what the last one asked
            # for.
            if abs(w) + dw <= fastest and du <= far:
                return du, dw
            fastest, far = upper(2 * (abs(w) + dw)), upper(2 * du)
    raise UndecidedError("a time is too uncertain: raise the precision")
