"""The driver of a sweep: hand out points, write down what comes back, survive what can be survived.

Points go out in batches that take about a quarter of a second, so that a point costs little beyond its own work and a
kill costs little beyond a batch.  Results are written as they arrive, by the driver alone; their order on the disk
depends on the workers, what is read from the store does not.  When a worker dies, the points it may have died of are
tried again one at a time, and given up after the second death.

>>> import tempfile
>>> from asymptotics.sweeps.grid import Grid
>>> folder = Path(tempfile.mkdtemp())
>>> def square(point):
...     return {"square": str(int(point["n"]) ** 2)}
>>> sweep(square, "square", Grid({"n": ("1", "2", "3")}), folder, workers=1).computed
3
>>> again = sweep(square, "square", Grid({"n": ("1", "2", "3", "4")}), folder, workers=1)
>>> again.points, again.reused, again.computed, again.failed
(4, 3, 1, 0)
"""

import os
import time
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, wait
from contextlib import AbstractContextManager, ExitStack, nullcontext
from dataclasses import dataclass, field
from itertools import islice
from pathlib import Path
from typing import Any

from asymptotics.errors import InputError, shown
from asymptotics.made_by import mark
from asymptotics.numbers.policy import Number, exact_integer
from asymptotics.present.drawn import Drawn
from asymptotics.present.shown import Page, Rows
from asymptotics.running.public import public_beside_others
from asymptotics.sweeps.callers import caller_mark
from asymptotics.sweeps.frame import columns, draw
from asymptotics.sweeps.grid import Point
from asymptotics.sweeps.plan import Job, SweepPlan, finished
from asymptotics.sweeps.shard import record_of
from asymptotics.sweeps.store import Store, require_usable, task_of
from asymptotics.sweeps.workers import Crew, OtherCodeError, PointOutcome, Task, one_process, process_pool, run_batch

# What a kill loses of each worker; at a millisecond or two for the way of a batch less than a hundredth is overhead.
# Half or double only moves one against the other.
_BATCH_SECONDS = 0.25
_SLOT_SECONDS = 2e-3  # a scheduler needs about a millisecond for a task: batches grow with the slots it has to feed
# For points of microseconds: a batch stays a small message.
MAX_WORKERS = 1024
_MAX_BATCH = 500
_LOOKED_AT = 1000  # points whose type is asked before a store is made
_PAUSE = 0.2  # seconds between two looks at a shard that another driver holds
_DRAWN = 2000  # points of a sweep that a notebook draws by itself
_DEATHS = 2  # lonely deaths of a worker before its point is given up
_REFUSALS = 5  # errors of the system in a row, when batches are handed over, that end a sweep

Progress = Callable[[int, int], None]
OpenCrew = Callable[[], AbstractContextManager[Crew]]


@dataclass(frozen=True, repr=False)
class SweepResult(Rows, Drawn):
    """What a sweep did: ``points`` asked for, ``reused`` from the store, ``computed`` now, ``failed`` of both.

    ``failures`` has the parameters and the reason of the first twenty, ``notes`` what was mended
    in the store.  ``to_dataframe()`` reads all results from the
    store, ``plot(x=, y=)`` draws one column against another.
    """

    points: int
    reused: int
    computed: int
    failed: int
    failures: tuple[dict[str, Any], ...]
    seconds: str
    store: str
    notes: tuple[str, ...] = field(default=(), compare=False)
    command: str = field(default="", compare=False)
    grid: Sequence[Point] = field(default=(), compare=False, repr=False)

    def _page(self) -> Page:
        title = f"{self.points} points: {self.computed} computed, {self.reused} from the store, {self.failed} failed"
        rows = tuple((str(f["point"]), f["reason"]) for f in self.failures)
        return Page(
            title, (f"in {self.seconds} s, store {self.store}", *self.notes), ("point", "reason") if rows else (), rows
        )

    def _table(self) -> dict[str, list[Any]]:
        return columns(self.command, self.grid, Path(self.store))

    def _heading(self) -> str:
        return f"{self.command.partition(' [')[0]} at {self.points} points"

    def _curve(self, axes: Any, **style: Any) -> None:
        draw(axes, self.grid, self._table(), style)

    def _picture(self) -> str:
        return "" if self.points > _DRAWN else super()._picture()

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready."""
        names = ("points", "reused", "computed", "failed", "failures", "seconds", "store")
        data = {name: getattr(self, name) for name in names} | {"failures": list(self.failures)}
        return data | ({"notes": list(self.notes)} if self.notes else {})


@public_beside_others
def sweep(
    task: Task,
    command: str,
    points: Sequence[Point],
    folder: Path | str,
    *,
    workers: int | None = None,
    executor: Executor | None = None,
    crew: OpenCrew | None = None,
    progress: Progress | None = None,
    version: str | None = None,
    max_seconds: Number | None = None,
) -> SweepResult:
    """Compute a task of one's own at every point that the store in ``folder`` does not hold yet, in processes.

    Whatever ends it, everything that was finished is in the store. A store that can only be read serves a sweep of
    which it holds every point. ``sweep_command`` sweeps a command of this package.

    Parameters
    ----------
    task
        takes a point (a mapping name -> text) and returns JSON-ready data; with a pool it is a function of a module
    command
        the name under which its results are filed
    points
        the points: a ``Grid``, or a sequence of mappings
    folder
        the store: new, empty, or one that a sweep has made
    workers
        processes; by default one for each core, 1 computes in this process
    executor
        any executor of concurrent.futures in the place of ``workers``; it is left open
    crew
        what opens the workers, and opens them again when they break, in the place of both
    progress
        is called with the numbers of points done and asked for
    version
        files the results in the place of the code of the task (``callers``), by which a task that was corrected is
        computed again; "": under ``command`` alone
    max_seconds
        the time the call may take, in s; without a limit unless asked

    Returns
    -------
    SweepResult
        the results in the order of the points, and how many were computed and found

    Raises
    ------
    InputError
        for an unusable store (one of other code among them), a worker of other code, or a full disk

    Examples
    --------
    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     found = sweep(lambda point: int(point["n"]) ** 2, "squares", [{"n": "3"}, {"n": "4"}], folder, workers=1)
    >>> found.computed, found.failed
    (2, 0)
    """
    start = time.perf_counter()
    folder = _folder(folder)
    progress = (lambda done, total: None) if progress is None else progress
    _require_readable(task, command, points, progress)
    _require_workers(executor, crew, version)
    own = caller_mark(task, version)
    command = f"{command} [{own}]" if own else command
    workers = None if workers is None else exact_integer(workers, "workers", 1, MAX_WORKERS)
    require_usable(folder)
    # A finished sweep can be read from a folder of somebody else's, or from an archive.
    if folder.is_dir() and any(folder.iterdir()) and not os.access(folder / "shards", os.W_OK):
        return _result(_read_only(command, points, folder), 0, start)
    count = workers or os.cpu_count() or 1
    if executor is not None:
        # No executor says by a public name how many calls it runs at a time; a wrong number changes how many batches
        # wait in its queue, nothing else.
        given = Crew(executor, getattr(executor, "_max_workers", count))
        opened: OpenCrew = lambda: nullcontext(given)  # noqa: E731
    else:
        opened = crew or (one_process if count == 1 else lambda: process_pool(count))
    with ExitStack() as stack:
        first_crew = stack.enter_context(opened())  # a store is made only when there is somebody to fill it
        driver = _Driver(
            task, SweepPlan(command, points, Store(folder, create=True)), opened, progress, stack, first_crew
        )
        driver.run()
    return _result(driver.plan, driver.computed, start)


def _read_only(command: str, points: Sequence[Point], folder: Path) -> SweepPlan:
    found = finished(command, points, Store(folder))
    if found is None:
        accepted = "a folder that can be written, or a sweep that is finished in it"
        raise InputError("folder", f"{folder} can only be read, and does not hold every point", accepted)
    return found


def _result(plan: SweepPlan, computed: int, start: float) -> SweepResult:
    failures = tuple({"point": point, "reason": reason} for _, point, reason in plan.failures.first)
    seconds = f"{time.perf_counter() - start:.3f}"
    where, points = str(plan.store.folder), plan.points
    notes = ("store.json was lost, and is written again from the shards",) if plan.store.rebuilt else ()
    return SweepResult(
        len(points), plan.reused, computed, plan.failures.count, failures, seconds, where, notes, plan.command, points
    )


def _require_readable(task: Any, command: Any, points: Any, progress: Any) -> None:
    """InputError, before a store is made, for what is no task, name, list of points or report."""
    for name, value in (("task", task), ("progress", progress)):
        if not callable(value):
            raise InputError(name, f"{shown(value)} is no function", "a function")
    if not isinstance(command, str) or not command.isprintable():
        raise InputError("command", f"{shown(command)} is no name", "a text that can be printed")
    if not isinstance(points, Sequence) or isinstance(points, str | bytes):
        raise InputError("points", f"{shown(points)} is no list of points", "a sequence of mappings")
    # Not all of a grid, which may have millions: what is wrong is so from the start, as a rule.
    if not all(isinstance(point, Mapping) for point in islice(points, _LOOKED_AT)):
        raise InputError("points", "one of them is no mapping", "mappings from a name to a value")


def _require_workers(executor: Any, crew: Any, version: Any) -> None:
    """InputError, before anything is computed, for what computes nothing, and for a version that is no text."""
    if executor is not None and not callable(getattr(executor, "submit", None)):
        raise InputError("executor", f"{shown(executor)} takes no calls", "an executor of concurrent.futures")
    if crew is not None and not callable(crew):
        raise InputError("crew", f"{shown(crew)} is no function", "a function that opens a crew")
    if version is not None and not (isinstance(version, str) and version.isprintable()):
        raise InputError("version", f"{shown(version)} is no version", "a text that can be printed")


def _folder(given: Any) -> Path:
    if not isinstance(given, str | Path):
        raise InputError("folder", f"a {type(given).__name__} is no folder", "a path")
    return Path(given)


class _Driver:
    """One run of a sweep."""

    def __init__(
        self, task: Task, plan: SweepPlan, opened: OpenCrew, progress: Progress, stack: ExitStack, crew: Crew
    ) -> None:
        self.task, self.plan, self.opened, self.progress = task, plan, opened, progress
        self.stack, self.crew = stack, crew
        self.computed = 0
        self.jobs = plan.jobs()
        self.flying: dict[Future[Any], list[Job]] = {}
        self.suspects: deque[Job] = deque()  # a worker died with them
        self.batch, self.exhausted = 1, False
        self.broken = False
        self.refusals = 0  # in a row

    def run(self) -> None:
        """Hand out points and take results until nothing is left to compute."""
        try:
            with self.stack:
                while not self.exhausted or self.flying or self.suspects:
                    self._hand_out()
                    self._collect()
                    if self.broken:
                        self._replace_crew()
        # Ctrl-C, a full disk, a worker of other code: what has come back already is written before the error goes on.
        except BaseException:
            self._settle({future for future in self.flying if future.done()}, last=True)
            raise
        finally:
            self.plan.close()

    def _hand_out(self) -> None:
        """Keep twice as many batches under way as there are slots; suspects go alone."""
        # One suspect at a time and nothing else under way: if a worker dies again, this point is what it died of.
        while self.suspects and not self.flying and not self.broken:
            self._submit([self.suspects.popleft()])
        while not (self.exhausted or self.suspects or self.broken) and len(self.flying) < 2 * self.crew.slots:
            found = list(islice(self.jobs, self.batch))
            self.exhausted = not found
            jobs = [job for job in found if job is not None]
            if jobs:
                self._submit(jobs)
            elif found:  # what is left is held by another driver
                # While own results are under way their arrival is what is waited for; otherwise a pause, not a busy
                # loop.
                if not self.flying:
                    time.sleep(_PAUSE)
                return

    def _submit(self, jobs: list[Job]) -> None:
        try:
            future = self.crew.executor.submit(run_batch, self.task, [job.point for job in jobs], mark())
        # OSError: a worker has died while another was being started, whose handles are closed by then.
        except (BrokenExecutor, OSError) as error:
            self.refusals += isinstance(error, OSError)
            if self.refusals == _REFUSALS:
                raise
            self.suspects.extend(jobs)
            self.broken = True
            return
        self.flying[future] = jobs

    def _collect(self) -> None:
        if self.flying:
            self._settle(wait(self.flying, return_when=FIRST_COMPLETED).done)
        self.progress(self.plan.reused + self.computed, len(self.plan.points))

    def _settle(self, done: set[Future[Any]], *, last: bool = False) -> None:
        """Write down what came back; what did not come back is suspect."""
        for future in done:
            jobs, alone = self.flying.pop(future), len(self.flying) == 0
            try:
                outcomes, seconds = future.result()
            # Its results would be filed as those of this code: the sweep ends.
            except OtherCodeError:
                raise
            except (Exception, CancelledError) as error:
                self.broken = self.broken or isinstance(error, BrokenExecutor)
                if not last:
                    self._suspect(jobs, error, alone)
                continue
            self.refusals = 0
            for job, outcome in zip(jobs, outcomes, strict=True):
                self._write(job, outcome)
            self._pace(len(jobs), seconds)

    def _suspect(self, jobs: list[Job], error: BaseException, alone: bool) -> None:
        for job in jobs:
            # Deaths in company prove nothing against a point and are not counted.
            job.tries += alone and len(jobs) == 1
            if job.tries < _DEATHS:
                self.suspects.append(job)
                continue
            reason = f"the worker died of it ({type(error).__name__}: {str(error)[:120]})"
            self.plan.failures.add(job.index, job.point, reason)
            self.computed += 1
            self.plan.release(job.shard)

    def _write(self, job: Job, outcome: PointOutcome) -> None:
        # Want of memory, disk or time is no property of the point: counted and told, and tried again by the next sweep.
        if outcome.lasting:
            try:
                job.shard.append(job.key, record_of(task_of(self.plan.command, job.point), outcome.record))
            except OSError as error:
                reason = f"cannot write to {self.plan.store.folder}: {error.strerror}"
                accepted = "a disk with room: what is finished is safe, and the same command continues"
                raise InputError("folder", reason, accepted) from error
        self.computed += 1
        if outcome.failed:
            self.plan.failures.add(job.index, job.point, outcome.reason)
        self.plan.release(job.shard)

    def _pace(self, size: int, seconds: float) -> None:
        """The next batches take about a quarter of a second (longer on large clusters), and grow at most twofold."""
        pace = max(_BATCH_SECONDS, _SLOT_SECONDS * self.crew.slots)
        # From the last batch alone, since cost varies along a sweep; at most doubled, lest one cheap batch be followed
        # by an hour's.
        wanted = int(pace * size / max(seconds, 1e-6))
        self.batch = max(1, min(wanted, 2 * self.batch, _MAX_BATCH))

    def _replace_crew(self) -> None:
        """A pool that has lost a worker takes no more work: all that was under way is suspect; a fresh one starts."""
        self._settle(wait(self.flying).done)
        self.stack.close()
        self.crew, self.broken = self.stack.enter_context(self.opened()), False
        try:
            # The smallest task there is: a fresh executor that cannot run it will not run the others either, and the
            # loop would go on for ever.
            self.crew.executor.submit(int).result()
        except BrokenExecutor as error:
            accepted = "an executor that works: what is finished is safe in the store"
            raise InputError("executor", f"it broke: {' '.join(str(error).split())[:120]}", accepted) from error
