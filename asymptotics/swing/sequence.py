"""Turning points one after the other, without losing digits: errors of half-swings only add.

From an exact amplitude the next one and the duration are enclosed; the midpoint is the next start.  What the midpoints
drop is carried beside them, by two contractions (derivation ``motions-never-part``), for orbits from amplitudes p and
p~ that both turn, at q and q~:

    |q - q~| <= |p - p~|                               for every law, dry friction included;
    |ln q - ln q~| <= |ln p - ln p~|                   where N(w)/w is nondecreasing (every alpha_i >= 1);
    |T - T~| <= |p - p~| / (q~ - 2 |p - p~| + friction).

So n half-swings at a working precision of d digits and log2(n) bits keep d digits, and memory stays flat.

>>> from fractions import Fraction
>>> from flint import ctx
>>> from itertools import islice
>>> from asymptotics.numbers.exact import ExactReal
>>> with ctx.workprec(100):
...     law = Damping.of([(arb(1) / 2, ExactReal(Fraction(3)))])
...     points = list(islice(sequence(law), 4))
>>> [point.x.str(12) for point in points][1:]
['[-0.673493180351 +/- ...]', '[0.543067542755 +/- ...]', '[-0.467642206192 +/- ...]']
"""

from collections.abc import Iterator
from dataclasses import dataclass

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.swing.course import Turned, course, delay
from asymptotics.swing.damping import Damping
from asymptotics.swing.panels import Panels
from asymptotics.swing.passage import Passage, integrated


@dataclass(frozen=True)
class Turning:
    """Turning point n: the exact ``amplitude`` and ``time`` of the orbit followed, and how far the truth is at most.

    ``ended``: why it is the last one, or None.  ``side`` is the sign of X.
    """

    n: int
    side: int
    amplitude: arb
    time: arb
    amplitude_error: arb
    time_error: arb
    ended: str | None = None

    @property
    def x(self) -> arb:
        """X at the turning point."""
        return self.side * arb(self.amplitude, self.amplitude_error)

    @property
    def tau(self) -> arb:
        """The time of the turning point."""
        return arb(self.time, self.time_error)


def first_turning() -> Turning:
    """X = 1 at rest, at tau = 0."""
    return Turning(0, 1, arb(1), arb(0), arb(0), arb(0))


def first_from(damping: Damping, X: arb, V: arb) -> Turning | str:
    """The first turning point at tau >= 0 from a state with V != 0, or why there is none."""
    if not (V > 0 or V < 0):
        raise UndecidedError("the direction of the first motion is undecided")
    side = -1 if V > 0 else 1
    given = upper(X.rad() + V.rad())
    for piece in course(damping, side * X.mid(), abs(V).mid(), given):
        if piece.trapped is not None:
            return piece.trapped
        if isinstance(piece, Turned):
            return after_landing(piece, side, given)
    raise UndecidedError("the first half-swing has no end")


def after_landing(piece: Turned, side: int, given: arb) -> Turning:
    """Turning point 0 at the end of a course that began in motion, within ``given`` of the truth."""
    time = arb(piece.time.mid(), piece.time.rad() + piece.late(given))
    return Turning(0, -side, piece.turn, time.mid(), upper(piece.miss + given), upper(time.rad()))


def sequence(
    damping: Damping, start: Turning | None = None, *, panels: Panels | None = None, count: int = 0
) -> Iterator[Turning]:
    """Turning points from ``start`` on, at the precision current at each call; the last one says why it ended.

    With ``panels``: by interpolation where ``count`` half-swings repay it.  UndecidedError where the enclosures cannot
    tell whether there is a next one.
    """
    here = first_turning() if start is None else start
    endless = damping.friction == 0 and bool(damping.alphas) and all(a > 1 for a in damping.alphas)
    while True:
        if endless:  # derivation ``no-overdamping``: there is a next one, whether or not anybody asks for it
            yield here
        found = swung(damping, here, panels, count)
        count -= 1
        if found.ended is not None:
            yield Turning(**{**vars(here), "ended": found.ended})
            return
        if not endless:
            yield here
        here = following(damping, here, found)


def swung(damping: Damping, here: Turning, panels: Panels | None, count: int) -> Passage:
    """The half-swing from ``here``, one of ``count`` still to come, by the cheaper route."""
    panel = None if panels is None else panels.serving(here.amplitude, here.amplitude_error, count)
    if panel is not None:
        return panel.passage(here.amplitude, here.amplitude_error)
    return integrated(damping, here.amplitude, here.amplitude_error)


def following(damping: Damping, here: Turning, found: Passage) -> Turning:
    """The next turning point: midpoints, and errors by contraction."""
    assert found.amplitude is not None and found.duration is not None
    q, time = here.amplitude * found.amplitude, here.time + found.duration
    amplitude, clock = q.mid(), time.mid()
    carried = here.amplitude_error
    if damping.superlinear and carried != 0:
        relative = upper(carried / (here.amplitude - carried))
        by_ratio = upper(q * relative.expm1())
        carried = min(carried, by_ratio)
    late = arb(0)
    if here.amplitude_error != 0 and not found.uniform:
        late = delay(amplitude, upper(here.amplitude_error + q.rad()), damping.friction)
    return Turning(
        here.n + 1, -here.side, amplitude, clock, upper(carried + q.rad()), upper(here.time_error + time.rad() + late)
    )
