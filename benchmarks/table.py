"""Timing and tables of benchmarks.

>>> print(Table("sums", ("what", "seconds", "ratio"), with_ratios([("a", 0.5), ("b", 1.0), ("c", None)])).text())
sums
  what  seconds        ratio
  a     0.500          1.0
  b     1.00           2.0
  c     not installed  -
"""

import os
import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from importlib import import_module
from math import isfinite, isinf, isnan
from pathlib import Path
from time import process_time

REPEATS = 3


@dataclass(frozen=True)
class Table:
    """A title, column names, and rows of strings."""

    title: str
    columns: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]

    def text(self) -> str:
        """The table in plain text."""
        lines = [self.columns, *self.rows]
        widths = [max(len(line[j]) for line in lines) for j in range(len(self.columns))]
        body = ["  " + "  ".join(x.ljust(w) for x, w in zip(line, widths, strict=True)).rstrip() for line in lines]
        return "\n".join([self.title, *body])

    def to_dict(self) -> dict[str, object]:
        """JSON-ready: all entries are strings."""
        return {"title": self.title, "columns": list(self.columns), "rows": [list(row) for row in self.rows]}


def measured(name: str, module: str, size: int | None, **more: Path) -> Table:
    """The table of one benchmark; the processor time it took, its own processes included, goes to stderr."""
    # Not in ``__main__``, where a second process would not find it.
    before = os.times()
    table: Table = import_module(module).run(*(() if size is None else (size,)), **more)
    seconds = sum(os.times()[:4]) - sum(before[:4])
    if sys.stderr is not None:  # print would take None for stdout
        print(f"{name}: {seconds:.0f} s", file=sys.stderr, flush=True)
    return table


def best_time(work: Callable[[], object], repeats: int = REPEATS) -> float:
    """The shortest of ``repeats`` runs, in seconds of processor time: others may compute beside us."""
    times = []
    for _ in range(repeats):
        start = process_time()
        work()
        times.append(process_time() - start)
    return min(times)


def with_ratios(timings: Iterable[tuple[str, float | None]]) -> tuple[tuple[str, ...], ...]:
    """Rows (label, seconds, ratio to the first, which must be a number); for the others see `seconds_text`."""
    found = list(timings)
    first = next(seconds for _, seconds in found if seconds is not None)
    return tuple((label, seconds_text(t), f"{t / first:.1f}" if t and isfinite(t) else "-") for label, t in found)


def seconds_text(seconds: float | None) -> str:
    """Three significant digits; None: not installed, nan: failed, infinity: stopped.

    >>> seconds_text(1.23456), seconds_text(None), seconds_text(float("nan")), seconds_text(float("inf"))
    ('1.23', 'not installed', 'failed', 'stopped')
    """
    if seconds is None:
        return "not installed"
    return "failed" if isnan(seconds) else "stopped" if isinf(seconds) else f"{seconds:#.3g}"
