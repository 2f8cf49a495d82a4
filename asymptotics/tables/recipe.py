"""How a named table is made: its columns and units, the route to its values, the route that checks them, its cost."""

from collections.abc import Callable
from dataclasses import dataclass

from asymptotics.tables.cells import Rows
from asymptotics.tables.inputs import Inputs


@dataclass(frozen=True)
class Found:
    """Rows, and whether every number in them is proved (exact or in balls)."""

    rows: Rows
    certified: bool


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
