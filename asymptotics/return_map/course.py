"""The motion within one half-swing, from its two quarters (``courses``), at any time between their hand-overs.

The half-swing from p to q is the quarter at z and that at z' = -z (q/p)^g, backwards in time from its end: s before
the end the place is -q r cos(theta) and the speed q r sin(theta), r and theta at the time s of that quarter.

At the time s any t of a quarter serves: the motion moves by at most |s - tau(t)| times its largest rates from where it
is at t, |X'| <= p and |X''| <= p + N(p), as the energy falls (derivation ``quarter-courses``).
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

from flint import arb

from asymptotics.flow.balls import upper


class TimedQuarter(Protocol):
    """A quarter-swing by a parameter t from -1, its hand-over, to 1, the centre."""

    def time(self, t: arb, /) -> arb:
        """The time since the turning point at an exact t."""

    def near(self, times: Sequence[arb], /) -> list[tuple[arb, arb, arb]]:
        """(r cos theta, r sin theta, the time) at nearly those times, in units of the amplitude at rest."""


@dataclass(frozen=True)
class Course:
    """A half-swing of the ``duration`` from the amplitude ``p`` to ``q``, whose quarters meet at about ``centre``.

    ``begin`` and ``end``: where its quarters begin and end; ``fastest``: of |X'| and |X''|.
    """

    before: TimedQuarter
    after: TimedQuarter
    p: arb
    q: arb
    duration: arb
    centre: arb
    begin: arb
    end: arb
    fastest: arb

    @classmethod
    def of(cls, before: TimedQuarter, after: TimedQuarter, p: arb, q: arb, duration: arb, rest: arb) -> "Course":
        """``rest``: a bound of N(p)."""
        first, last = before.time(arb(-1)).upper(), (duration - after.time(arb(-1))).lower()
        return cls(before, after, p, q, duration, before.time(arb(1)).mid(), first, last, upper(p + rest))

    def states(self, times: Sequence[arb]) -> list[tuple[arb, arb]]:
        """(place, w) at ascending times (balls) from ``begin`` to ``end``."""
        first = [t for t in times if t.mid() <= self.centre]
        last = [self.duration - t for t in times[len(first) :]]
        return self._near(self.before, first, self.p, self.p) + self._near(self.after, last, -self.q, self.q)

    def _near(self, quarter: TimedQuarter, times: Sequence[arb], unit: arb, pace: arb) -> list[tuple[arb, arb]]:
        """Where the quarter is near each time, and how far the motion at that time is from there."""
        found = []
        for s, (x, y, time) in zip(times, quarter.near([s.mid() for s in times]), strict=True):
            off = arb(0, upper((s - time) * self.fastest))
            found.append((unit * x + off, pace * y + off))
        return found
