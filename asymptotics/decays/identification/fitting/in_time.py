"""Work with an end: what is not finished by then is left, and said to be; no verdict is made of what was cut off.

>>> from asymptotics.running.budget import tick
>>> def endless():
...     while True:
...         tick()
>>> Time.of(0.02).within(endless, "not finished")
'not finished'
>>> ALL.within(lambda: "no limit", "not finished")
'no limit'
"""

from collections.abc import Callable
from dataclasses import dataclass
from math import inf
from time import monotonic
from typing import TypeVar

from asymptotics.errors import LimitError
from asymptotics.running.budget import budget, seconds_left, tick

T = TypeVar("T")
_RESERVE, _LEAST = 0.2, 2.0
"""Kept for judging and telling: a fifth of the time, and 2 seconds at least, if that is not more than half of it.  A
choice: too little of it ends in a request that is cut short, too much leaves more laws untried."""


@dataclass(frozen=True)
class Time:
    """When the work must end."""

    deadline: float = inf

    @classmethod
    def of(cls, seconds: float) -> "Time":
        """So many seconds from now."""
        return cls(monotonic() + seconds)

    @classmethod
    def but_for_the_answer(cls, share: float = 1.0) -> "Time":
        """This share of the time in force but for a reserve, in which what is known is judged and told."""
        left = seconds_left()
        return cls.of(share * max(left - max(_RESERVE * left, min(_LEAST, left / 2)), 0.0)) if left < inf else cls()

    def within(self, work: Callable[[], T], otherwise: T) -> T:
        """What ``work`` gives in what is left; ``otherwise`` where that is not enough.

        Only inside is the time shorter than the caller's: who stands between two pieces of work is not stopped.
        """
        left = self.deadline - monotonic()
        if left == inf:
            return work()
        if left <= 0:
            return otherwise
        try:
            with budget(left):
                # Raises at once where the caller's own time is over, before work begins.
                tick()
                return work()
        except LimitError:
            return otherwise


ALL = Time()
"""No limit but the caller's."""
