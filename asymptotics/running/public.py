"""What every public call does: it has a time of its own, ``max_seconds``, and no other thread computes beside it.

The loops of the package ask for the time themselves (``budget.tick``).  Work that does not ask, in SymPy or in a
figure, is stopped by an alarm, a few times a second: no call runs past its time silently.  Where the system has no
alarm, in a thread, or where somebody else has a handler for it, the ticks alone count.

>>> @public
... def patient(*, max_seconds=60):
...     while True:
...         tick("a step")
>>> patient(max_seconds="1/1000")
Traceback (most recent call last):
    ...
asymptotics.errors.LimitError: argument max_seconds: 0.001 s are over at a step (accepted: ...)
"""

import functools
import gc
import signal
from collections.abc import Callable
from contextlib import nullcontext, suppress
from math import inf
from types import FrameType, TracebackType
from typing import Any, ParamSpec, TypeVar, cast

from asymptotics.errors import LimitError
from asymptotics.numbers import context
from asymptotics.numbers.policy import exact_seconds
from asymptotics.running.budget import Unasked, budget, seconds_left, tick
from asymptotics.running.cut_short import is_lost
from asymptotics.running.signature import readable

P = ParamSpec("P")
T = TypeVar("T")
# A call that does not ask runs over its time by about that much, and by what C takes between two steps of Python.
PERIOD = 0.25  # seconds between two rings


def public(function: Callable[P, T]) -> Callable[P, T]:
    """A public call, with a keyword ``max_seconds`` of its own; LimitError when they are over, wherever that is."""
    return cast("Callable[P, T]", _timed(function, alone=True))


def public_beside_others(function: Callable[P, T]) -> Callable[P, T]:
    """The same for a call that hands its work to others, or only loads it: they are alone when they compute."""
    return cast("Callable[P, T]", _timed(function, alone=False))


def _timed(function: Any, *, alone: bool) -> Any:
    default = function.__kwdefaults__["max_seconds"]

    @functools.wraps(function)
    def call(*args: Any, **kwargs: Any) -> Any:
        # What nobody asked for goes on as such: a call inside this one is not held to it where more was asked for.
        asked: Any = kwargs.setdefault("max_seconds", None if default is None else Unasked(default))
        unasked = isinstance(asked, Unasked)
        none = (asked is None and default is None) or (unasked and seconds_left() < inf)  # the caller has a time
        with (
            nullcontext() if none else limited(asked if unasked else exact_seconds(asked)),
            context.alone if alone else nullcontext(),
        ):
            return function(*args, **kwargs)

    timed: Any = call
    timed.__signature__ = readable(function)
    return timed


class limited:  # noqa: N801 (used as a context manager, as ``suppress`` and ``closing`` are)
    """``with limited(seconds, report):`` everything inside has that time together, whether it asks for it or not."""

    def __init__(self, seconds: float, report: Callable[[str], None] | None = None) -> None:
        self.budget = budget(seconds, report)
        self.before: Any = None

    def __enter__(self) -> None:
        self.budget.__enter__()
        # Somebody else's handler stays: pytest's time limits, say, or a server's.
        free = hasattr(signal, "setitimer") and signal.getsignal(signal.SIGALRM) in (signal.SIG_DFL, signal.SIG_IGN)
        if free:
            with suppress(ValueError):  # not the main thread: no signal arrives here
                # The handler first and the timer last: an alarm that met no handler would end the process.
                self.before = signal.signal(signal.SIGALRM, _ring)
                gc.callbacks.append(_collecting)
                signal.setitimer(signal.ITIMER_REAL, PERIOD, PERIOD)

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self.before is not None:
            signal.signal(signal.SIGALRM, signal.SIG_IGN)  # a ring under way would meet the default, which kills
            signal.setitimer(signal.ITIMER_REAL, 0)
            signal.signal(signal.SIGALRM, self.before)
            gc.callbacks.remove(_collecting)
            _collected.clear()
        # _rung tells that an alarm did stop the work; what reaches
        # this place may be another error that a library made of it.
        stopped, broken = self.before is not None and bool(_rung), isinstance(error, Exception)
        if self.before is not None:
            _rung.clear()
        try:
            if stopped and broken and not isinstance(error, LimitError):
                tick()  # a library has made something else of the alarm that stopped it
        finally:
            self.budget.__exit__(kind, error, trace)


_OPENING = {getattr(kind, name).__code__ for kind in (*context.DOORS, limited) for name in ("__enter__", "__exit__")}
_OURS = {"asymptotics", "derivations", "paper_checks"}
_ringing: list[bool] = []
_rung: list[bool] = []
_collected: list[bool] = []


def _collecting(phase: str, _info: dict[str, int]) -> None:
    """Python's call when the collector starts and stops: between the two, what is raised is lost."""
    _collected[:] = [True] if phase == "start" else []


def _ring(number: int, frame: FrameType | None) -> None:
    """A ``tick`` every quarter of a second, until the end: whoever catches the first LimitError gets another.

    A door must not be left half-open: nothing rings while one is opened or closed (who waits there ticks itself), nor
    while the collector runs, which would swallow the error and print it, nor while a library is imported, which would
    stay half-loaded for as long as the process lives.
    """
    # _ringing: neither the look at the stack nor the tick of one alarm is interrupted by the next; on a slow machine
    # alarms inside alarms would fill the stack.
    if _ringing or _collected:
        return
    try:
        _ringing.append(True)
        if not is_lost(frame) and not _opens(frame) and not _imports(frame):
            tick()
    except LimitError:
        _rung.append(True)
        raise
    finally:
        _ringing.clear()


def _opens(frame: FrameType | None) -> bool:
    """Whether a door, or a time limit, is being opened or closed there."""
    while frame is not None:
        if frame.f_code in _OPENING:
            return True
        frame = frame.f_back
    return False


def _imports(frame: FrameType | None) -> bool:
    """Whether a library of others is being imported there: the import stands between the frame and our own code.

    Ours is stopped: a derivation is proved while its module is imported.
    """
    while frame is not None and str(frame.f_globals.get("__name__")).partition(".")[0] not in _OURS:
        if frame.f_code.co_filename == "<frozen importlib._bootstrap>":
            return True
        frame = frame.f_back
    return False
