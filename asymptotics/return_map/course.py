"""The motion within one half-swing, from its two quarters (``courses``), at any time between their hand-overs.

The half-swing from p to q is the quarter at z and that at z' = -z (q/p)^g, backwards in time from its end: s before
the end the place is -q r cos(theta) and the speed q r sin(theta), r and theta at the time s of that quarter.

At the time s any t of a quarter serves: in d = s - tau(t) the place and the speed move by d times the means of their
rates -w and u - N(w).  On the way u and w are within |d| f of those at t, their means within |d| f/2: as the energy
falls, f = p + N(p) is at least |X'| and |X''| (derivation ``quarter-courses``).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from flint import arb

from asymptotics.flow.balls import upper
from asymptotics.flow.damping import Damping


class TimedQuarter(Protocol):
    """A quarter-swing by a parameter t from -1, its hand-over, to 1, the centre."""

    def time(self, t: arb, /) -> arb:
        """The time since the turning point at an exact t."""

    def near(self, times: Sequence[arb], /) -> list[tuple[arb, arb, arb]]:
        """(r cos theta, r sin theta, the time) at nearly those times, in units of the amplitude at rest."""


@dataclass(frozen=True)
class Course:
    """A half-swing of the ``duration`` from the amplitude ``p`` to ``q``, whose quarters meet at about ``centre``.

    ``begin`` and ``end``: where its quarters begin and end; ``fastest``: of |X'| and |X''| under the ``damping``.
    """

    before: TimedQuarter
    after: TimedQuarter
    p: arb
    q: arb
    duration: arb
    centre: arb
    begin: arb
    end: arb
    damping: Damping
    fastest: arb

    @classmethod
    def of(cls, before: TimedQuarter, after: TimedQuarter, p: arb, q: arb, duration: arb, damping: Damping) -> "Course":
        """What follows from its two quarters."""
        first, last = before.time(arb(-1)).upper(), (duration - after.time(arb(-1))).lower()
        centre, fastest = before.time(arb(1)).mid(), upper(p + damping.resistance(p))
        return cls(before, after, p, q, duration, centre, first, last, damping, fastest)

    def states(self, times: Sequence[arb]) -> list[tuple[arb, arb]]:
        """(place, w) at ascending times (balls) from ``begin`` to ``end``."""
        first = [t for t in times if t.mid() <= self.centre]
        last = [self.duration - t for t in times[len(first) :]]
        return self._near(self.before, 1, first, self.p, self.p) + self._near(self.after, -1, last, -self.q, self.q)

    def _near(
        self, quarter: TimedQuarter, sense: int, times: Sequence[arb], unit: arb, pace: arb
    ) -> list[tuple[arb, arb]]:
        """Where the quarter is near each time, led on to that time; ``sense``: -1 backwards in time."""
        found = []
        for s, (x, y, time) in zip(times, quarter.near([s.mid() for s in times]), strict=True):
            late, u, w = sense * (s - time), unit * x, pace * y
            # How far the means of u and w over the way are from here: half as far as they may be at its end.
            mean = arb(0, upper(late * self.fastest / 2))
            widest = w + 2 * mean
            # Next to rest the speed may vanish on the way; then the largest rate serves.
            slope = u + mean - self.damping.resistance(widest) if widest > 0 else arb(0, self.fastest)
            found.append((u - late * (w + mean), w + late * slope))
        return found
