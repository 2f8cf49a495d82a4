"""Programs with little memory: where the address space is limited, a child works, and its end is put into words.

Libraries meet memory that is not there in ways that no handler of Python sees: FLINT aborts, OpenBLAS ends the process
or waits for threads that cannot be started, imports fail halfway with any error.  Under ``ulimit -v`` the work is
therefore done by a child with one thread for linear algebra.  What it says is held back until it has ended:
an end for want of memory is one line and exit code 2, whatever was printed on the way.  SIGTERM and Ctrl-C end it.
"""

import os
import signal
import sys
import tempfile
from collections.abc import Callable
from contextlib import suppress
from importlib import import_module
from threading import active_count
from typing import IO

# What the interpreter and its libraries say when memory is refused; with a status that is not 0 one of them is enough.
# A sign too many puts another failure into the wrong words, it hides none: the exit code is not 0 either way.
SIGNS = (b"MemoryError", b"not enough memory", b"OpenBLAS", b"FLINT", b"allocat", b"map segment", b"pthread_create",
         b"start new thread", b"ImportError", b"SystemError", b"shared object", b"jemalloc")  # fmt: skip
NO_MEMORY = "there is not enough memory (accepted: a lower order, fewer digits or points, a larger ulimit -v)"
_ENOUGH = 4 << 30  # bytes of address space beyond which a limit is nothing to prepare for
_GRACE = 200  # hundredths of a second that a child has to end after a signal


def is_little() -> bool:
    """Whether the address space of this process is limited, and a child can be started safely."""
    # A fork copies locks that other threads hold, and the child would wait for them for ever.
    if not hasattr(os, "fork") or active_count() > 1:
        return False
    resource = import_module("resource")  # not on every system
    limit = resource.getrlimit(resource.RLIMIT_AS)[0]
    return bool(limit != resource.RLIM_INFINITY and limit < _ENOUGH)


def in_child(body: Callable[[], int], complain: Callable[[str], None], name: str, wanting: int) -> int:
    """The exit code of ``body``, run in a child; ``wanting`` and one line where it ends for want of memory."""
    # Files, not pipes: whoever reads a pipe must read while the child writes, and needs memory for it.
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
        pid = os.fork()
        if not pid:
            _child(body, out.fileno(), err.fileno())
        try:
            status = os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])
        except BaseException:
            _end(pid)
            raise
        answer, told = (_content(file) for file in (out, err))
    died = status in (-signal.SIGABRT, -signal.SIGSEGV, -signal.SIGBUS, 130, 143)  # nobody has interrupted it
    if died or status and any(sign in told for sign in SIGNS):
        complain(f"{name}: {NO_MEMORY}")
        return wanting
    for stream, text in ((sys.stdout, answer), (sys.stderr, told)):
        if stream is not None:
            stream.write(text.decode(errors="backslashreplace"))
    return status if status >= 0 else 128 - status


def _content(file: IO[bytes]) -> bytes:
    file.seek(0)
    return file.read()


def _child(body: Callable[[], int], out: int, err: int) -> None:
    os.dup2(out, 1)
    os.dup2(err, 2)
    # Each thread of OpenBLAS reserves buffers of its own, out of an address space that is short already.  Set before
    # NumPy is loaded, which happens in ``body``.
    os.environ |= {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}
    code = 70
    try:
        code = body()
    except MemoryError:
        os.write(2, b"MemoryError")
    finally:
        # Not sys.exit: what is to be done at exit, and the buffers of the parent, belong to the parent.
        os._exit(code)


def _end(pid: int) -> None:
    """A signal came: the child is told, and ended if it does not listen."""
    with suppress(ProcessLookupError, ChildProcessError):
        os.kill(pid, signal.SIGTERM)
        for _ in range(_GRACE):
            if os.waitpid(pid, os.WNOHANG)[0]:
                return
            signal.sigtimedwait((), 0.01)
        os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)
