"""(X, X') at many times in one pass, as enclosures, from any start.

The turning points are followed as in ``sequence``; every half-swing that holds a time asked for is laid out in pieces,
at whose start the error of the turning point in place and time is one distance in the phase plane: within the window
e about a turning point of amplitude a the state moves by at most e (V + a + friction + N(V)), where V = 2 e (a +
friction) bounds the speed as long as N(V) <= a + friction.  An uncertain time is read as its lower end and a width:
from there on the speed grows at most at the rate |X|.

>>> from fractions import Fraction
>>> from flint import ctx
>>> from asymptotics.numbers.exact import ExactReal
>>> with ctx.workprec(90):
...     law = Damping.of([(arb(1) / 10, ExactReal(Fraction(3, 2)))])
...     found = states(law, arb(1), arb(0), [arb(0), arb(9)])
...     [value.str(12) for state in found for value in state]
['[1.00000000000 +/- ...]', '[+/- ...]', '[-0.612550463671 +/- ...]', '[-0.288753570045 +/- ...]']
"""

from collections.abc import Sequence

from flint import arb

from asymptotics.budget import tick
from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.flow.times import exact_sum
from asymptotics.swing.course import Piece, Turned, course
from asymptotics.swing.damping import Damping
from asymptotics.swing.panels import Panels
from asymptotics.swing.passage import of_landing
from asymptotics.swing.sequence import Turning, after_landing, following

State = tuple[arb, arb]


def states(
    damping: Damping, X: arb, V: arb, times: Sequence[arb], hold: arb | None = None, panels: Panels | None = None
) -> list[State]:
    """(X, X') at the ascending times tau >= 0 from the state (X, V) at tau = 0; ``hold``: where the mass sticks.

    With ``panels`` half-swings that hold none of the times are passed by interpolation where it pays.
    UndecidedError where the enclosures cannot tell how the motion goes on.
    """
    wanted = _Wanted(damping, times)
    return _followed(damping, _first(damping, X, V, wanted), wanted, hold, panels)


def states_from(damping: Damping, here: Turning, times: Sequence[arb]) -> list[State]:
    """(X, X') at the ascending times tau >= here.tau, from a known turning point."""
    return _followed(damping, here, _Wanted(damping, times), None)


def _followed(
    damping: Damping, here: Turning, wanted: "_Wanted", hold: arb | None, panels: Panels | None = None
) -> list[State]:
    while not wanted.done:
        tick(f"turning point {here.n}")
        if _sticks(here, damping.friction if hold is None else hold):
            wanted.rest(here.x)
        else:
            here = _swing(damping, here, wanted, panels)
    return wanted.found


class _Wanted:
    """The times still to be answered, and the states found so far; ``widest``: the most that a time is uncertain by."""

    def __init__(self, damping: Damping, times: Sequence[arb]) -> None:
        self.damping = damping
        self.queue = [exact_sum(t.mid(), -t.rad()) for t in times]  # not rounded: a late time has more bits
        self.widest = max((upper(2 * t.rad()) for t in times), default=arb(0))
        self.found: list[State] = []

    @property
    def done(self) -> bool:
        return len(self.found) == len(self.queue)

    @property
    def following(self) -> arb:
        return self.queue[len(self.found)]

    def take(self, piece: Piece, side: int, start: arb, size: arb) -> None:
        """All times up to the end of a piece of the half-swing from ``start``; |X|, |X'| <= ``size`` there."""
        last = exact_sum(start, piece.end)
        if self.done or not self.following <= last:
            return
        wide = upper(size + piece.error)
        blur = arb(0, upper(piece.error + _moved(self.damping, wide, wide, self.widest)))
        while not self.done and self.following <= last:
            y, w = piece.own(exact_sum(self.following, -start))
            self.found.append((side * (y + self.damping.friction + blur), -side * (w + blur)))

    def rest(self, X: arb) -> None:
        """The mass sticks at X for all remaining times."""
        self.found += [(X, arb(0))] * (len(self.queue) - len(self.found))


def _first(damping: Damping, X: arb, V: arb, wanted: _Wanted) -> Turning:
    """The first turning point at tau >= 0; times before it are answered."""
    if V == 0:
        side = 1 if X > 0 else -1
        return Turning(0, side, abs(X).mid(), arb(0), X.rad(), arb(0))
    if not (V > 0 or V < 0):
        raise UndecidedError("the direction of the first motion is undecided")
    side = -1 if V > 0 else 1
    given, size = upper(X.rad() + V.rad()), upper(abs(X) + abs(V))
    for piece in course(damping, side * X.mid(), abs(V).mid(), given):
        wanted.take(piece, side, arb(0), size)
        if isinstance(piece, Turned):
            return after_landing(piece, side, given)
        if wanted.done:
            break
    return Turning(0, side, abs(X).mid(), arb(0), X.rad(), arb(0))


def _swing(damping: Damping, here: Turning, wanted: _Wanted, panels: Panels | None) -> Turning:
    """The next turning point; the half-swing is laid out in pieces only if a time may fall into it."""
    empty = _whole_swings(wanted.following - here.time)
    panel = panels.serving(here.amplitude, here.amplitude_error, empty) if panels is not None and empty > 0 else None
    if panel is not None:
        there = following(damping, here, panel.passage(here.amplitude, here.amplitude_error))
        if there.time < wanted.following:
            return there
    error, size = _distance(damping, here), upper(here.amplitude + here.amplitude_error)
    for count, piece in enumerate(course(damping, here.amplitude, arb(0), error), start=1):
        wanted.take(piece, here.side, here.time, size)
        if wanted.done:
            return here
        if isinstance(piece, Turned):
            return following(damping, here, of_landing(here.amplitude, error, piece, count))
    raise UndecidedError("the half-swing has no end")


def _whole_swings(time: arb) -> int:
    """About how many half-swings end before that time; it only decides how they are made."""
    return int(min(float(time) / 3.2, 1e9))


def _sticks(here: Turning, hold: arb) -> bool:
    if here.amplitude + here.amplitude_error <= hold:
        return True
    if not here.amplitude - here.amplitude_error > hold:
        raise UndecidedError(f"whether dry friction holds the mass at turning point {here.n} is undecided")
    return False


def _distance(damping: Damping, here: Turning) -> arb:
    """How far the true state is at most from the turning point ``here``, at the time ``here``."""
    if here.time_error == 0:
        return here.amplitude_error
    size = upper(here.amplitude + here.amplitude_error + damping.friction)
    speed = upper(2 * here.time_error * size)
    resistance = upper(damping.resistance(speed))
    if not resistance <= size:
        raise UndecidedError(f"the time of turning point {here.n} is too uncertain: raise the precision")
    return upper(here.amplitude_error + here.time_error * (speed + size + resistance))


def _moved(damping: Damping, u: arb, w: arb, width: arb) -> arb:
    """How far the state moves at most within ``width`` from |X| <= u, speed <= w."""
    if width == 0:
        return arb(0)
    size = upper(u + w)
    fastest = upper(w + size * width)
    return upper(width * (size + fastest + damping.friction + damping.resistance(fastest)))
