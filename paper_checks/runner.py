"""Run checks, in this process or in a pool, with progress; results come back in reading order."""

import time
from collections.abc import Callable, Iterable
from concurrent.futures import Executor

from asymptotics.verdict import Outcome
from paper_checks.registry import Entry, Statement, forms, load

Progress = Callable[[str], None]


def examine(entry: Statement) -> Entry:
    """Run the check of one statement on all its forms."""
    start = time.perf_counter()
    check = entry.check
    outcomes = {} if check is None else {name: check(form) for name, form in forms(entry)}
    return Entry(entry, outcomes, time.perf_counter() - start)


def _examine_id(paper: str, key: str) -> tuple[dict[str, Outcome], float]:
    """In a worker: statements travel as ids, their checks are found again in the registry."""
    result = examine(load(paper)[key])
    return result.outcomes, result.seconds


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
