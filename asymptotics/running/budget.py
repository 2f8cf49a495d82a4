"""One time budget for a whole request, whatever passes it takes: ``tick`` anywhere in the work.

A loop that may run long calls ``tick("turning point 17 of 1000")`` at least a few times a second; without a budget in
force this costs next to nothing.  Nested budgets: the earliest deadline counts.

>>> with budget(60):
...     tick("a step")
>>> with budget(0):
...     tick("turning point 17 of 1000")
Traceback (most recent call last):
    ...
asymptotics.errors.LimitError: argument max_seconds: 0 s are over at turning point 17 of 1000 (accepted: ...)
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from math import inf
from time import monotonic

from asymptotics.errors import LimitError


class Unasked(int):
    """A limit in seconds that nobody asked for: inside a request it yields to what that was given.

    It is a type, so that the same number is another thing where somebody asked for it.

    >>> with budget(600):
    ...     with budget(Unasked(60)):
    ...         inside = seconds_given()
    ...     inside, allowed(Unasked(60)), allowed(30.0)
    (600, 600, 30.0)
    >>> allowed(Unasked(60))
    60
    """


DEFAULT_SECONDS = Unasked(60)
_ACCEPTED = "a larger limit, a lower order, fewer points, fewer digits or a shorter time"


@dataclass
class _Budget:
    seconds: float
    deadline: float
    report: Callable[[str], None] | None
    stage: str = "the start"


_current: ContextVar[_Budget | None] = ContextVar("budget", default=None)


@contextmanager
def budget(seconds: float = DEFAULT_SECONDS, report: Callable[[str], None] | None = None) -> Iterator[None]:
    """Everything inside has ``seconds`` together; ``report`` is handed what ``tick`` says, to show the progress."""
    outer, own = _current.get(), _Budget(seconds, monotonic() + seconds, report)
    # An inner budget cannot give more time than the outer one has left, and takes none away unless it is asked for.
    keeps = outer is not None and (isinstance(seconds, Unasked) or outer.deadline < own.deadline)
    token = _current.set(outer if keeps else own)
    try:
        yield
    finally:
        _current.reset(token)


def tick(stage: str | None = None) -> None:
    """Report the stage (None: the one before goes on); LimitError when the time is over."""
    current = _current.get()
    if current is None:
        return
    # The stage is kept even where nobody reports it: the error names it.
    current.stage = stage or current.stage
    if current.report is not None:
        current.report(current.stage)
    # A monotonic clock: setting the clock of the machine neither ends nor lengthens a request.
    if monotonic() >= current.deadline:
        raise LimitError("max_seconds", f"{current.seconds:g} s are over at {current.stage}", _ACCEPTED)


def seconds_left() -> float:
    """What is left of the budget in force, infinity without one."""
    current = _current.get()
    return inf if current is None else current.deadline - monotonic()


def seconds_given() -> float:
    """What the budget in force was given, infinity without one: unlike what is left, the same in each run."""
    current = _current.get()
    return inf if current is None else current.seconds


def allowed(limit: float) -> float:
    """A limit of estimated work: what the request in force was given, where that is more and nobody asked for less."""
    given = seconds_given()
    return max(limit, given) if isinstance(limit, Unasked) and given < inf else limit


def require_seconds(estimate: float, work: str) -> None:
    """LimitError at once when an estimate is more than twice what is left: no use in starting."""
    current = _current.get()
    # Estimates are good to a factor of about three (``costs``): what may just fit is tried, and the ticks stop it.
    left = seconds_left()
    if current is not None and estimate > 2 * left:
        # What is left where much of it is gone: the first number is above the second in the words too.
        there = f"{current.seconds:g} s allowed"
        if left < 0.9 * current.seconds:
            there = f"{seconds_told(max(left, 0))} s left of {current.seconds:g}"
        reason = f"{work} would take about {seconds_told(estimate)} s, more than the {there}"
        raise LimitError("max_seconds", reason, _ACCEPTED)


def seconds_told(seconds: float) -> str:
    """Seconds in words, never 0 for a part of one.

    >>> seconds_told(0.3), seconds_told(14.1), seconds_told(7200)
    ('0.3', '14', '7200')
    """
    return f"{seconds:.0f}" if seconds >= 10 else f"{seconds:.2g}"
