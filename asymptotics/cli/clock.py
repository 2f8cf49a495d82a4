"""The time a request may take: one budget over all its passes, its progress on stderr, and an alarm.

The loops of the package ask for the time themselves (``budget.tick``).  Work that does not ask, in SymPy or in a
figure, is stopped by the alarm, a few times a second: no request runs past its time silently.  Where the system has no
alarm, or a request is run beside others in a thread, the ticks alone count.
"""

import argparse
import signal
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from types import FrameType

from asymptotics.budget import budget, tick
from asymptotics.cli.answer import read_max_seconds
from asymptotics.cli.progress import status_line

_PERIOD = 0.25


@contextmanager
def timed(options: argparse.Namespace) -> Iterator[None]:
    """Everything inside has --max-seconds together; LimitError when they are over, wherever that is."""
    seconds = read_max_seconds(options)
    with status_line(seconds, quiet=getattr(options, "quiet", False)) as show, budget(seconds, show), _alarm():
        yield


@contextmanager
def _alarm() -> Iterator[None]:
    """A ``tick`` every quarter of a second, until the end: whoever catches the first LimitError gets another."""
    if not hasattr(signal, "setitimer"):
        yield
        return
    before = None
    with suppress(ValueError):  # not the main thread: no signal arrives here
        before = signal.signal(signal.SIGALRM, _ring)
        signal.setitimer(signal.ITIMER_REAL, _PERIOD, _PERIOD)
    try:
        yield
    finally:
        if before is not None:
            signal.signal(signal.SIGALRM, signal.SIG_IGN)  # a ring under way would meet the default, which kills
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, before)


def _ring(number: int, frame: FrameType | None) -> None:
    tick()
