"""Where a datum stands in its file: complaints name the row as an editor counts it, and the column.

>>> RowPlaces("data.csv").kept(np.array([True, False, True])).where(1, "x")          # data in memory: counted from 0
'data.csv, row 2, column x'
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class RowPlaces:
    """``lines``: the number of each row in its file (None: data in memory, counted from 0)."""

    name: str
    lines: NDArray[np.int64] | None = None

    def kept(self, keep: NDArray[np.bool_] | NDArray[np.intp]) -> "RowPlaces":
        """The rows for which ``keep`` holds, or those whose places it gives."""
        # Flags and places both: a row keeps the number that an editor shows, through every selection.
        chosen: NDArray[np.int64] = np.asarray(np.flatnonzero(keep) if keep.dtype == bool else keep, dtype=np.int64)
        return replace(self, lines=chosen if self.lines is None else self.lines[chosen])

    def row(self, place: int) -> int:
        """The number of a row: in a file lines are counted from 1, with the header, comments and blank lines."""
        return int(place if self.lines is None else self.lines[place])

    def where(self, place: int, column: str) -> str:
        """The row and the column, for a message."""
        return f"{self.name}, row {self.row(place)}, column {column}"
