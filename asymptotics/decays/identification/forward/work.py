"""Work with an end that is the same on every machine: counted, not timed; what is not finished by then is left.

A verdict may take as much work as an ordinary core does in a minute (in a tenth of ``max_seconds``, where that is
more), counted by the arrays that are computed.  So the same data have the same verdict on a machine that is busy, and
on one that is idle; the time of the request is ten times as long by default, and a limit for what no count foresees.

>>> def endless():
...     while True:
...         counted(1000)
>>> Work(limit=1e6).within(endless, "not finished")
'not finished'
>>> ALL.within(lambda: "no limit", "not finished")
'no limit'
"""

from collections.abc import Callable
from contextvars import ContextVar
from dataclasses import dataclass
from math import inf
from time import monotonic
from typing import TypeVar

from asymptotics.errors import LimitError
from asymptotics.running.budget import budget, seconds_given, seconds_left, tick

T = TypeVar("T")
PATIENCE = 600
"""The time of a request that names none: on a machine that is ten times as slow as the count supposes."""
RATE = 1e6
"""Units of work in a second of an ordinary core: one is about a microsecond.  Measured, good to a factor of about
two."""
_RESERVE, _LEAST = 0.2, 2.0
"""Kept of the time for judging and telling: a fifth, and 2 seconds at least, if that is not more than half of it."""


@dataclass
class Work:
    """So many units of work, of which some are ``done``; and when it must end in any case."""

    limit: float = inf
    deadline: float = inf
    done: float = 0.0

    @classmethod
    def of_a_verdict(cls, share: float = 1.0) -> "Work":
        """That of one verdict; ``share``: of the time in force but for a reserve, in which what is known is told."""
        left = seconds_left()
        seconds = share * max(left - max(_RESERVE * left, min(_LEAST, left / 2)), 0.0) if left < inf else inf
        return cls(RATE * max(PATIENCE, seconds_given()) / 10, monotonic() + seconds)

    def within(self, work: Callable[[], T], otherwise: T) -> T:
        """What ``work`` gives in what is left; ``otherwise`` where that is not enough.

        Only inside is the work limited, and the time shorter than the caller's: who stands between two pieces of work
        is not stopped.
        """
        if self.limit == inf and self.deadline == inf:
            return work()
        left = self.deadline - monotonic()
        if left <= 0 or self.done >= self.limit:
            return otherwise
        outer = _current.set(self)
        try:
            with budget(left):
                # Raises at once where the caller's own time is over, before work begins.
                tick()
                return work()
        except LimitError:
            return otherwise
        finally:
            _current.reset(outer)


ALL = Work()
"""No limit but the caller's."""
_current: ContextVar[Work | None] = ContextVar("work", default=None)


def counted(units: float) -> None:
    """So many units more; LimitError where the work in force is done."""
    current = _current.get()
    if current is None:
        return
    current.done += units
    if current.done > current.limit:
        raise LimitError("max_seconds", "the work of a verdict is done", "a larger limit, or fewer laws")
