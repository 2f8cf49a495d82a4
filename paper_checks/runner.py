"""Run checks, in this process or in a pool, with progress; results come back in reading order.

No worker outlives the program: Ctrl-C ends them at once (nobody waits for the checks that are running), and when the
program is killed they notice that their parent is gone.
"""

import multiprocessing
import os
import signal
import threading
import time
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import Executor, ProcessPoolExecutor
from contextlib import contextmanager
from multiprocessing.connection import wait

from paper_checks.evidence import Difference, Marks, recorded
from paper_checks.reader import compared
from paper_checks.registry import Entry, Statement, forms, load
from paper_checks.verdict import Outcome

Progress = Callable[[str], None]


def examine(entry: Statement) -> Entry:
    """Run the check of one statement on all its forms; what evidence it used is noted on the form that it confirms.

    What it has told apart on the near miss, and on no form that it confirms, is what refutes the near miss.
    """
    start, outcomes, marks = time.perf_counter(), {}, {}
    for name, form in forms(entry):
        with recorded() as marks[name]:
            outcomes[name] = entry.check(form)
    confirmed = [marks[name] for name, outcome in outcomes.items() if outcome == Outcome.CONFIRMED]
    usual = [d for found in confirmed for d in found.differences]
    apart = [d for d in marks["near miss"].differences if d not in usual] if "near miss" in marks else []
    used = confirmed[-1] if confirmed else Marks()
    seconds = time.perf_counter() - start
    return Entry(entry, outcomes, seconds, used, apart[-1] if apart else None, compared(entry))


def _examine_id(paper: str, key: str) -> tuple[dict[str, Outcome], float, Marks | None, Difference | None, bool]:
    """In a worker: statements travel as ids, their checks are found again in the registry."""
    result = examine(load(paper)[key])
    return result.outcomes, result.seconds, result.marks, result.apart, result.compared


def examine_all(
    entries: Iterable[Statement], executor: Executor | None = None, progress: Progress = lambda key: None
) -> list[Entry]:
    """Run all checks, on any ``concurrent.futures`` executor if one is given; ``progress`` gets each finished id."""
    entries, results = list(entries), []
    futures = [executor.submit(_examine_id, e.paper, e.id) for e in entries] if executor else None
    for number, entry in enumerate(entries):
        results.append(Entry(entry, *futures[number].result()) if futures else examine(entry))
        progress(entry.id)
    return results


@contextmanager
def worker_pool() -> Iterator[Executor]:
    """One process for each core; on any exception, an interrupt included, they are gone before it goes on."""
    before = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(os.cpu_count(), initializer=_follow_parent)
    try:
        yield pool
    except BaseException:
        for process in set(multiprocessing.active_children()) - before:
            process.kill()
        raise
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _follow_parent() -> None:
    """In a worker: the terminal's Ctrl-C is the parent's business, and its end is the worker's end."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    signal.signal(signal.SIGTERM, signal.SIG_DFL)
    threading.Thread(target=_exit_with_parent, daemon=True).start()


def _exit_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        wait([parent.sentinel])
        os._exit(1)
