"""What every program of the project does about interrupts and about output that cannot be written.

============================  =================================================================
Ctrl-C, SIGTERM, at any time  one line on stderr, exit code 130 or 143; after the answer, nothing
stdout closed, ``| head``     silence: who closes the output does not want it
``> /dev/full``, a full disk  one line on stderr, exit code 2
a letter that the terminal's
encoding does not have        its escape, never a UnicodeEncodeError
memory that is not there      one line on stderr, exit code 2
a fault of the program        two lines that say how to report it, exit code 70
============================  =================================================================

>>> run_guarded("program", lambda: 1)
1
"""

import os
import signal
import sys
import threading
import traceback
from collections.abc import Callable
from contextlib import suppress
from types import FrameType
from typing import Any

from asymptotics.errors import MAX_ACCEPTED, MAX_REASON, printable
from asymptotics.running.cut_short import is_lost
from asymptotics.running.memory import NO_MEMORY, in_child, is_little

_USUAL: dict[int, Any] = {signal.SIGINT: signal.default_int_handler, signal.SIGTERM: signal.SIG_DFL}


REFUSED, FAULT = 2, 70  # the second as EX_SOFTWARE of sysexits
_AGAIN = 0.02  # seconds until a signal that came where it would be lost comes again: a call of the collector is over
TRACEBACK = "ASYMPTOTICS_TRACEBACK"


class OutputError(Exception):
    """The answer could not be written to stdout; ``reason`` is the system's word for why."""

    def __init__(self, error: OSError) -> None:
        super().__init__(error)
        self.gone = isinstance(error, BrokenPipeError)
        self.reason = error.strerror


class Interrupted(KeyboardInterrupt):
    """Not KeyboardInterrupt itself: one that passes through ``exec`` makes the interpreter end as by SIGINT.

    Libraries call ``exec`` while they load (every dataclass does), and CPython remembers the exact type for its exit.
    """


class Interrupts:
    """Which signal came: a library may turn the KeyboardInterrupt inside it into any other exception."""

    def __init__(self) -> None:
        self.seen = 0

    def __call__(self, number: int, frame: FrameType | None) -> None:
        """The handler of SIGINT and SIGTERM: what is being written is taken back on the way out."""
        self.seen = number
        if is_lost(frame):  # it comes again in a moment, and until then nothing has happened
            # Only a signal reaches the main thread, wherever it waits; the timer's own thread could raise nothing
            # there.
            again = threading.Timer(_AGAIN, os.kill, (os.getpid(), number))
            again.daemon = True
            again.start()
            return
        raise Interrupted

    def install(self) -> None:
        """Answer the signals, unless somebody has chosen otherwise (``nohup``, a background job, a test runner)."""
        with suppress(ValueError):  # not the main thread: whoever runs us there handles the signals
            for number, usual in _USUAL.items():
                if signal.getsignal(number) is usual:
                    signal.signal(number, self)

    def remove(self, *, last: bool) -> None:
        """As it was before ``install``; at the ``last`` nothing is left to interrupt, and no signal is answered.

        While it ends, the interpreter gives signals back to the system, whose answer is death without a word, after the
        answer was printed; one that is ignored it leaves alone.
        """
        with suppress(ValueError):
            for number, usual in _USUAL.items():
                if signal.getsignal(number) is self:
                    signal.signal(number, signal.SIG_IGN if last else usual)


def run_guarded(name: str, body: Callable[[], int], *, last: bool = False) -> int:
    """Run ``body`` and return its exit code; interrupts and lost output as in the table of the module.

    ``last``: the process ends with it, as that of a program which was started with its own arguments.
    """
    # Twice guarded: the child answers for the work, this process for the child and for interrupts while it waits.
    if is_little():
        return _guarded(name, lambda: in_child(lambda: _guarded(name, body, True), complain, name, REFUSED), last)
    return _guarded(name, body, last)


def _guarded(name: str, body: Callable[[], int], last: bool) -> int:
    interrupts = Interrupts()
    interrupts.install()
    try:
        for stream in (sys.stdout, sys.stderr):
            reconfigure = getattr(stream, "reconfigure", None)
            if reconfigure is not None:
                # Encodings of terminals and pipes are not ours: a letter that they lack must not end an answer halfway.
                reconfigure(errors="backslashreplace")
        return _finished(name, body)
    except BaseException as error:
        # Once a signal was seen whatever arrives here is its work: libraries turn a KeyboardInterrupt into errors of
        # theirs.
        if not interrupts.seen and not isinstance(error, KeyboardInterrupt):
            return _last_resort(name, error)
        for note in getattr(error, "__notes__", ()):
            complain(f"{name}: {note}")
        complain(f"{name}: interrupted; no file was left half-written")
        _drop_output()
        # The shell's convention for a program that a signal has ended, 130 and 143; the process ends itself, after
        # cleaning.
        return 128 + (interrupts.seen or signal.SIGINT)
    finally:
        interrupts.remove(last=last)


def _finished(name: str, body: Callable[[], int]) -> int:
    """``body``, and what it and argparse have left in the buffer of stdout."""
    try:
        try:
            code = body()
        except SystemExit as leaving:  # argparse leaves so, for --help and for bad options
            code = leaving.code if isinstance(leaving.code, int) else int(leaving.code is not None)
        _flush()
    except OutputError as error:
        _drop_output()
        # ``| head`` has what it wanted: no fault, no line.
        if error.gone:
            return 0
        complain(f"{name}: cannot write the answer: {error.reason}")
        return 2
    return code


def _last_resort(name: str, error: BaseException) -> int:
    """What nobody foresaw: never exit code 1, which means undecided, and never a traceback that was not asked for."""
    # GeneratorExit and their like are of the interpreter and none of our business.
    if not isinstance(error, Exception):
        raise error
    _drop_output()
    if isinstance(error, MemoryError):
        complain(f"{name}: {NO_MEMORY}")
        return REFUSED
    if TRACEBACK in os.environ:
        traceback.print_exception(error)
    told = printable(f"{type(error).__name__}: {error}", MAX_REASON)
    line = printable(" ".join(map(repr, sys.argv[1:])), MAX_ACCEPTED)
    complain(f"{name}: a fault of the program, not of its input: {told}")
    complain(f"{name}: please report these lines and `{name} --version`: arguments {line}; {TRACEBACK}=1 shows where")
    return FAULT


def emit(text: str) -> None:
    """Print to stdout; OutputError when that fails, nothing at all when stdout is closed."""
    if sys.stdout is None:
        return
    try:
        print(text)
    except OSError as error:
        raise OutputError(error) from error
    _flush()


def complain(line: str) -> None:
    """One line to stderr, if anybody listens."""
    with suppress(OSError, ValueError):
        if sys.stderr is not None:
            print(line, file=sys.stderr, flush=True)


def _flush() -> None:
    if sys.stdout is None:
        return
    try:
        sys.stdout.flush()
    except OSError as error:
        raise OutputError(error) from error


def _drop_output() -> None:
    """What is still buffered must not be written at exit, where the failure could no longer be caught."""
    if sys.stdout is not None:
        with suppress(OSError, ValueError):
            sys.stdout.flush()
            return
        sys.stdout = open(os.devnull, "w")  # noqa: PTH123, SIM115 (it lives until the interpreter ends)
