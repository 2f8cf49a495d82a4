"""What runs in a worker, and the executors: in this process, a pool of processes, or a Dask cluster.

A task takes and returns text: no number has to survive a pickle, and a worker need not share a disk with the driver.
An error of one point becomes the record of that point; only the death of the worker itself is felt outside.

>>> from fractions import Fraction
>>> outcomes, seconds = run_batch(lambda point: {"half": str(Fraction(point["x"]) / 2)}, [{"x": "3"}, {"x": "1/0"}])
>>> [o.record for o in outcomes]
['{"result":{"half":"3/2"}}', '{"failed":"ZeroDivisionError: Fraction(1, 0)"}']
"""

import json
import multiprocessing
import os
import re
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from concurrent.futures import Executor, Future, ProcessPoolExecutor
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from importlib import import_module
from multiprocessing.process import BaseProcess
from time import perf_counter
from typing import Any

from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.made_by import mark
from asymptotics.sweeps.grid import Point
from asymptotics.sweeps.shard import canonical

Task = Callable[[Point], dict[str, Any]]
_ANSWER = 10  # seconds that a scheduler may take to answer
_PATIENCE = 20  # seconds that workers may take to join a scheduler
_REASON = 300  # characters of a reason that are kept


@dataclass(frozen=True)
class PointOutcome:
    """What came of a point: its record in JSON; ``lasting`` if a second try would end in the same way."""

    record: str
    reason: str = ""
    lasting: bool = True

    @property
    def failed(self) -> bool:
        """Whether there is a reason instead of a result."""
        return bool(self.reason)


class OtherCodeError(InputError):
    """A worker whose code or libraries are not the driver's: its results would be filed as those of this code."""


def run_batch(task: Task, batch: list[Point], code: str | None = None) -> tuple[list[PointOutcome], float]:
    """The outcomes of some points, in order, and the seconds they took; this is what a worker is asked to do.

    ``code``: the driver's ``made_by.mark``; OtherCodeError where this worker's is another one.
    """
    if code is not None and code != mark():
        raise OtherCodeError("executor", f"a worker runs other code ({mark()}, here {code})", "workers of this code")
    # Without the time in a queue: the pace of the batches is that of the work.
    start = perf_counter()
    return [_run(task, point) for point in batch], perf_counter() - start


def _run(task: Task, point: Point) -> PointOutcome:
    try:
        # Written here, in the worker: a result that is no JSON fails as its point, not as the sweep.
        return PointOutcome(json.dumps({"result": task(point)}, ensure_ascii=False, separators=(",", ":")))
    # A time that was over says more of the machine than of the point; any other limit is one of the point.
    except LimitError as error:
        return _failed(str(error), lasting=error.argument != "max_seconds")
    # The point is refused or undecided, by a message that names the reason.
    except (InputError, UndecidedError) as error:
        return _failed(str(error))
    except (MemoryError, OSError) as error:  # of the machine, not of the point: worth another try some day
        return _failed(f"{type(error).__name__}: {error}", lasting=False)
    # One point must not end a sweep of millions; a fault of the task is no property of the point either.
    except Exception as error:  # noqa: BLE001
        return _failed(f"{type(error).__name__}: {error}", lasting=False)


def _failed(reason: str, *, lasting: bool = True) -> PointOutcome:
    line = " ".join(reason.split())[:_REASON]
    return PointOutcome(canonical({"failed": line}), line, lasting)


class SerialExecutor(Executor):
    """Runs each call at once, in this process."""

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> "Future[Any]":
        """A future that is done."""
        future: Future[Any] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as error:  # noqa: BLE001  (an executor keeps what was raised for the one who asks)
            future.set_exception(error)
        return future


@dataclass(frozen=True)
class Crew:
    """An executor, and how many calls it can run at a time."""

    executor: Executor
    slots: int


@contextmanager
def one_process() -> Iterator[Crew]:
    """No pool: the driver does the work."""
    yield Crew(SerialExecutor(), 1)


_GRACE = 2.0
"""Seconds given to a worker with nothing left to do before it is ended."""


@contextmanager
def process_pool(workers: int) -> Iterator[Crew]:
    """A pool of processes that are fresh, die with this one, and leave Ctrl-C to it."""
    method = "forkserver" if sys.platform == "linux" else "spawn"  # a fork would copy locks held by other threads
    context = multiprocessing.get_context(method)
    # Children of whoever called us are not ours to end.
    before = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(workers, mp_context=context, initializer=_attend_to_parent)
    # An error, or Ctrl-C: nothing that workers do is waited for.  After the last point each may end by itself.
    patience = 0.0
    try:
        yield Crew(pool, workers)
        patience = _GRACE
    finally:
        # Waiting for the pool itself can last for ever: a worker that was killed may have held the lock of the queue.
        pool.shutdown(wait=False, cancel_futures=True)
        for process in set(multiprocessing.active_children()) - before:
            process.join(patience)
            if process.is_alive():
                process.kill()


def _attend_to_parent() -> None:
    """A worker whose driver was killed would wait for ever: it ends instead."""
    # Ctrl-C goes to the whole group of processes: the driver answers it, workers are ended by it.
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    parent = multiprocessing.parent_process()
    if parent is not None:
        threading.Thread(target=_end_after, args=(parent,), daemon=True).start()


def _end_after(parent: BaseProcess) -> None:
    parent.join()
    os._exit(1)


# What Dask calls a scheduler: a protocol, a host or a bracketed IPv6 address, a port.
_ADDRESS = re.compile(r"(tcp|tls|ws|wss|ucx)://[^\s/:]+:\d{1,5}|(tcp|tls)://\[[0-9a-fA-F:.]+\]:\d{1,5}")


@contextmanager
def dask_executor(address: str, workers: int | None) -> Iterator[Crew]:
    """An executor on the Dask scheduler at ``address`` (tcp://...), or on a cluster of its own for ``local``.

    InputError if it is no address, if Dask is not installed or if nothing answers there.  Any other word is refused
    before Dask is loaded: it tried each for seconds, and failed on some by an assertion of its own.
    """
    if address != "local" and not _ADDRESS.fullmatch(address):
        raise InputError("dask", f"{address[:80]!r} is no address of a scheduler", "local, or tcp://host:port")
    dask = _distributed()
    with ExitStack() as stack:
        try:
            scheduler: Any = address
            if address == "local":
                count = workers or os.cpu_count() or 1
                scheduler = stack.enter_context(dask.LocalCluster(count, threads_per_worker=1, dashboard_address=None))
            client = stack.enter_context(dask.Client(scheduler, timeout=_ANSWER))
        except (OSError, ValueError) as error:
            reason, accepted = f"no scheduler answers at {address[:80]!r}", "local, or a running one: tcp://host:port"
            raise InputError("dask", reason, accepted) from error
        try:
            client.wait_for_workers(1, timeout=_PATIENCE)
        except OSError as error:
            reason = f"no worker has joined {address[:80]!r} in {_PATIENCE} s"
            raise InputError("dask", reason, "a scheduler whose workers are there: start them first") from error
        slots = sum(client.ncores().values())
        # pure=False: two calls of one batch are two calls; Dask would hand back the first one's result.
        yield Crew(client.get_executor(pure=False), slots or 1)


def _distributed() -> Any:
    try:
        return import_module("distributed")  # an extra, and slow to import
    except ModuleNotFoundError as error:  # any other ImportError is a fault, or want of memory
        accepted = "an installation with the extra cluster: pip install '.[cluster]' in a clone"
        raise InputError("dask", "Dask is not installed", accepted) from error
