"""The numbers below a header, block by block: memory grows with the columns that are used, not with the file.

Each block of lines goes to pandas; a column that is not all numbers to it is read cell by cell (``cells``).  A row that
cannot be read is kept as missing and counted: ``Unread`` says how many, which is the first, and what stands there.
"""

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice
from typing import Any

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.records.cells import MISSING, number
from asymptotics.decays.records.layout import Layout
from asymptotics.decays.records.lines import WHITE, is_comment, split
from asymptotics.decays.records.stamps import is_stamp, seconds_of_stamp
from asymptotics.present.counts import many
from asymptotics.running.budget import tick

Array = NDArray[np.float64]
_BLOCK = 200_000
"""Lines that are in memory together.  A choice: it bounds the memory of a block, and changes no number."""
_CELL = "\x1f"
"""The separator of units in ASCII: in no table of numbers, so that quoted cells may hold any other sign."""


@dataclass
class Unread:
    """Cells that are no numbers, by row of the table; ``first``: (row, column, text) of the first one."""

    rows: list[int] = field(default_factory=list)
    first: tuple[int, int, str] | None = None

    def add(self, row: int, column: int, cell: str) -> None:
        """A cell that cannot be read."""
        self.rows.append(row)
        if self.first is None or row < self.first[0]:
            self.first = (row, column, cell)


@dataclass(frozen=True)
class Body:
    """Columns by their place, the line of each row (from 1), and what could not be read."""

    columns: dict[int, Array]
    lines: NDArray[np.int64]
    unread: Unread


def read_body(lines: Iterable[str], layout: Layout, wanted: Sequence[int], stamps: Mapping[int, str]) -> Body:
    """The wanted columns of all lines from ``layout.start`` on; ``stamps``: those of times of day, with the order of
    their dates."""
    unread, found, numbers = Unread(), [], []
    stream = enumerate(lines, start=1)
    for _ in islice(stream, layout.start):
        pass
    count = 0
    while block := list(islice(stream, _BLOCK)):
        # The test of the first sign spares the regular expression for the many lines that begin with a digit.
        kept = [(i, line) for i, line in block if line and not (line[0] in " #%/!\t" and is_comment(line))]
        if not kept:
            continue
        table = _block([line for _, line in kept], layout, wanted, unread, count)
        found.append([_numbers(table[c], c, layout, unread, count, stamps.get(c)) for c in wanted])
        numbers.append(np.array([i for i, _ in kept], dtype=np.int64))
        count += len(kept)
        tick(f"the reading of row {count}")
    if not found:
        return Body({c: np.array([]) for c in wanted}, np.array([], dtype=np.int64), unread)
    columns = {c: np.concatenate([piece[k] for piece in found]) for k, c in enumerate(wanted)}
    return Body(columns, np.concatenate(numbers), unread)


def _block(lines: list[str], layout: Layout, wanted: Sequence[int], unread: Unread, before: int) -> Any:
    import pandas  # noqa: PLC0415 (an extra: only tables need it)

    separator = layout.separator
    # Quotes may hide separators: such blocks are cut by ``split``, the others by pandas.
    if any('"' in line for line in lines):
        lines = [_CELL.join(split(line, separator)) for line in lines]
        separator = _CELL
    for i, line in enumerate(lines):
        cells = len(line.split()) if separator == WHITE else line.count(separator) + 1
        if cells > layout.width and separator != WHITE:  # rows may end with separators
            lines[i] = line = line.rstrip(" " + separator)
            cells = line.count(separator) + 1
        # A row of another width becomes a row without numbers, so that rows keep their places in the file.
        if cells > layout.width:
            unread.add(before + i, wanted[0], many(cells, "cell"))
            lines[i] = _blank(layout.width, separator)
        # A row may be short where nothing is wanted of its end.
        elif cells < layout.width and cells <= max(wanted):
            unread.add(before + i, wanted[0], line.strip())
            lines[i] = _blank(layout.width, separator)
    return pandas.read_csv(
        io.StringIO("\n".join(lines) + "\n"),
        sep=r"\s+" if separator == WHITE else separator,
        header=None,
        names=list(range(layout.width)),
        usecols=sorted(wanted),
        index_col=False,
        decimal=layout.decimal,
        # All quotes have been obeyed above; the words for missing values are ours alone.
        quoting=csv.QUOTE_NONE,
        skip_blank_lines=False,
        skipinitialspace=True,
        keep_default_na=False,
        na_values=list(MISSING),
        low_memory=False,
    )


def _blank(width: int, separator: str) -> str:
    return " ".join(["nan"] * width) if separator == WHITE else separator.join(["nan"] * width)


def _numbers(column: Any, place: int, layout: Layout, unread: Unread, before: int, stamp: str | None) -> Array:
    # pandas has read every cell as a number; otherwise each is read strictly, and the first that is none is told.
    if column.dtype.kind in "fiu" and stamp is None:
        return np.asarray(column.to_numpy(dtype=float))
    found = np.full(len(column), np.nan)
    for i, cell in enumerate(column.tolist()):
        if not isinstance(cell, str):
            if isinstance(cell, bool):
                unread.add(before + i, place, str(cell))
            # nan is the only number that differs from itself.
            elif cell is not None and cell == cell:
                found[i] = float(cell)
            continue
        value = (
            seconds_of_stamp(cell, stamp)
            if stamp is not None and is_stamp(cell)
            else number(cell, layout.mark(place), thousands=layout.thousands)
        )
        if value is None:
            unread.add(before + i, place, cell.strip())
        else:
            found[i] = value
    return found
