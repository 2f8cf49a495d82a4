"""(x, v) at many times in one pass, from any start inside a well.

Every half-swing that holds a time asked for is laid out in pieces, at whose start the error of the turning point in
place and time is one distance: within the window e about a turning point the speed is at most e S and the place moves
by at most e^2 S, S bounding |s_0| and the losses there.  An uncertain time is read as its lower end and a width.

>>> from flint import ctx
>>> from asymptotics.law import Law
>>> with ctx.workprec(90):
...     force = Force.of(Law({"3/2": "1/10"}).terms)
...     found = states(force, arb(1), arb(0), [arb(0), arb(9)])
...     [value.str(12) for state in found for value in state]
['[1.00000000000 +/- ...]', '[+/- ...]', '[-0.612550463671 +/- ...]', '[-0.288753570045 +/- ...]']
"""

from collections.abc import Sequence
from typing import NoReturn

from flint import arb

from asymptotics.budget import tick
from asymptotics.errors import InputError, UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.flow.times import exact_sum
from asymptotics.numbers.context import ctx
from asymptotics.swing.sequence import Turning
from asymptotics.wells.course import Landing, Piece, course, unit_at
from asymptotics.wells.ends import ESCAPES, ROTATES
from asymptotics.wells.force import Force
from asymptotics.wells.sequence import after_kick, after_landing, rest, sticks

State = tuple[arb, arb]
_LOW = 40


def states(force: Force, X: arb, V: arb, times: Sequence[arb]) -> list[State]:
    """(X, X') at the ascending times tau >= 0 from the state (X, V) at tau = 0.

    InputError if the motion leaves its well before; UndecidedError where the enclosures cannot tell how it goes on.
    """
    wanted = _Wanted(force, times)
    here = _first(force, X, V, wanted)
    while not wanted.done:
        tick(f"turning point {here.n}")
        if sticks(force, here):
            wanted.rest(here.x)
        else:
            here = _swing(force, here, wanted)
    return wanted.found


class _Wanted:
    """The times still to be answered, and the states found so far."""

    def __init__(self, force: Force, times: Sequence[arb]) -> None:
        self.force = force
        self.queue = [(exact_sum(t.mid(), -t.rad()), upper(2 * t.rad())) for t in times]
        self.found: list[State] = []

    @property
    def done(self) -> bool:
        return len(self.found) == len(self.queue)

    def take(self, piece: Piece, side: int, start: arb) -> None:
        """All times up to the end of a piece of the half-swing that begins at ``start``."""
        last = exact_sum(start, piece.end)
        while not self.done and self.queue[len(self.found)][0] <= last:
            if piece.ended in (ESCAPES, ROTATES):
                _refuse(piece.ended)
            low, width = self.queue[len(self.found)]
            u, w = piece.own(exact_sum(low, -start))
            u, w = u + arb(0, upper(piece.error / piece.unit)), w + arb(0, piece.error)
            du, dw = _moved(self.force, u, w, width)
            self.found.append((side * (u + arb(0, du)), -side * (w + arb(0, dw))))

    def rest(self, X: arb) -> None:
        """The mass stays at X for all remaining times."""
        self.found += [(X, arb(0))] * (len(self.queue) - len(self.found))


def _first(force: Force, X: arb, V: arb, wanted: _Wanted) -> Turning:
    """The first turning point at tau >= 0; times before it are answered."""
    if V == 0:
        return rest(X)
    if not (V > 0 or V < 0):
        raise UndecidedError("the direction of the first motion is undecided")
    side = -1 if V > 0 else 1
    u, w = side * X.mid(), abs(V).mid()
    given = upper(unit_at(force, u, w) * X.rad() + V.rad())
    for piece in course(force, u, w, given):
        wanted.take(piece, side, arb(0))
        if wanted.done:
            return rest(X)
        if isinstance(piece, Landing):
            here = after_kick(force, piece, side, given)
            return here if isinstance(here, Turning) else _refuse(here)
    raise UndecidedError("the first half-swing has no end")


def _refuse(what: str) -> NoReturn:
    reason = f"from this start the motion {what} before that time: it leaves its well"
    raise InputError("v0", reason, "a start that stays inside the well, or an earlier time")


def _swing(force: Force, here: Turning, wanted: _Wanted) -> Turning:
    """The next turning point; times before it are answered."""
    for piece in course(force, here.amplitude, arb(0), _distance(force, here)):
        wanted.take(piece, here.side, here.time)
        if wanted.done:
            return here
        if isinstance(piece, Landing):
            return after_landing(force, here, piece)
    raise UndecidedError("the half-swing has no end")


def _distance(force: Force, here: Turning) -> arb:
    """How far the true state is at most from the turning point ``here``, at the time ``here``."""
    unit, e = unit_at(force, here.amplitude, arb(0)), here.time_error
    with ctx.workprec(_LOW):
        du, dw = _moved(force, arb(here.amplitude, here.amplitude_error), arb(0), e)
        return upper(unit * (here.amplitude_error + du) + dw)


def _moved(force: Force, u: arb, w: arb, width: arb) -> tuple[arb, arb]:
    """How far place and speed move at most within ``width``, before or after a state in the two balls."""
    if width == 0:
        return arb(0), arb(0)
    with ctx.workprec(_LOW):
        fastest, far = upper(2 * abs(w) + width), upper(width)
        for _ in range(40):
            there = u + arb(0, far)
            rate = upper(abs(force.pull(there)) + force.grip(there) + force.drag(there, fastest))
            dw = upper(width * rate)
            du = upper(width * (abs(w).upper() + dw))
            if abs(w) + dw <= fastest and du <= far:
                return du, dw
            fastest, far = upper(2 * (abs(w) + dw)), upper(2 * du)
    raise UndecidedError("a time is too uncertain: raise the precision")
