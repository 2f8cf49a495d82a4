"""The motion within one half-swing, from its two quarters (``courses``), at any time between their hand-overs.

The half-swing from p to q is the quarter at z and that at z' = -z (q/p)^g, backwards in time from its end: s before
the end the place is -q r cos(theta) and the speed q r sin(theta), r and theta at the time s of that quarter.

At the time s any t of a quarter serves: the motion moves by at most |s - tau(t)| times its largest rates from where it
is at t, |X'| <= p and |X''| <= p + N(p), as the energy falls.
"""

from dataclasses import dataclass
from typing import Protocol

from flint import arb

from asymptotics.flow.balls import upper


class TimedQuarter(Protocol):
    """A quarter-swing by a parameter t from -1, its hand-over, to 1, the centre."""

    def near(self, s: arb, /) -> tuple[arb, arb]:
        """An exact t and its time, nearly s, since the turning point."""

    def time(self, t: arb, /) -> arb:
        """The time at an exact t."""

    def state(self, t: arb, /) -> tuple[arb, arb]:
        """(r cos theta, r sin theta) at an exact t, in units of the amplitude at the turning point."""


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

    def state(self, t: arb) -> tuple[arb, arb]:
        """(place, w) at an exact time from ``begin`` to ``end``."""
        if t <= self.centre:
            place, w, off = self._at(self.before, t, self.p)
        else:
            place, w, off = self._at(self.after, self.duration - t, self.q)
            place = -place
        return place + arb(0, off), w + arb(0, off)

    def _at(self, quarter: TimedQuarter, s: arb, unit: arb) -> tuple[arb, arb, arb]:
        """(place, w) near the time s of a quarter, and how far the motion at that time is from there."""
        t, time = quarter.near(s.mid())
        place, w = quarter.state(t)
        return unit * place, unit * w, upper((s - time) * self.fastest)
