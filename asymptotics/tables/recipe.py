"""How a named table is made: its columns and units, the route to its values, the route that checks them, its cost."""

from collections.abc import Callable
from contextvars import ContextVar
from dataclasses import dataclass

from asymptotics.tables.cells import Rows
from asymptotics.tables.inputs import Inputs


@dataclass(frozen=True)
class Found:
    """Rows, and whether every number in them is proved (exact or in balls)."""

    rows: Rows
    certified: bool


# A context variable and no argument: recipes are plain functions of their inputs, and threads have one each.
_made: ContextVar[list[Rows] | None] = ContextVar("rows", default=None)


def rows_in_progress() -> Rows:
    """Where a recipe puts its rows, one by one: those that are done when it is stopped are kept."""
    rows: Rows = []
    begun_before = _made.get()
    if begun_before is not None:
        begun_before.append(rows)
    return rows


class RowsInProgress:
    """``with RowsInProgress() as progress:`` the rows of every recipe that begins inside; the ``longest`` of them."""

    def __enter__(self) -> "RowsInProgress":
        self.tried: list[Rows] = []
        self.before = _made.set(self.tried)
        return self

    def __exit__(self, *_: object) -> None:
        _made.reset(self.before)

    def longest(self) -> Rows:
        """The rows of the attempt that came farthest."""
        # A recipe runs once for each guard of digits, and begins its rows anew each time.
        return max(self.tried, key=len, default=[])


@dataclass(frozen=True)
class Recipe:
    """``compute(inputs, digits)`` gives the rows; ``keys`` are the columns that say which row it is.

    ``units`` has one entry for each column ("1": no unit, "": text).  ``source`` is the route to the values, ``check``
    the one by which the tests obtain them again, ``cost`` what a default table takes.
    """

    title: str
    columns: tuple[str, ...]
    keys: tuple[str, ...]
    units: tuple[str, ...]
    source: str
    check: str
    cost: str
    compute: Callable[[Inputs, int], Found]
    uses: str = ""  # the options that change it
