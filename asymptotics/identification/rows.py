"""Where a datum stands in its file: complaints name the row as an editor counts it, and the column.

>>> Rows("data.csv").kept(np.array([True, False, True])).where(1, "x")          # data in memory: counted from 0
'data.csv, row 2, column x'
"""

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Rows:
    """``path``: the file, if there is one; ``named``: whether it has a header; ``index``: which of its rows these are
    (None: all)."""

    name: str
    path: Path | None = None
    named: bool = True
    index: NDArray[np.intp] | None = None

    def kept(self, keep: NDArray[np.bool_]) -> "Rows":
        """The rows for which ``keep`` holds."""
        if keep.all():
            return self
        return replace(self, index=np.flatnonzero(keep) if self.index is None else self.index[keep])

    def row(self, place: int) -> int:
        """The number of a row: in a file lines are counted from 1, with the header, comments and blank lines."""
        wanted = int(place if self.index is None else self.index[place])
        if self.path is None:
            return wanted
        wanted += self.named
        with self.path.open(encoding="utf-8-sig") as stream:
            lines = (i for i, line in enumerate(stream, start=1) if line.strip() and not line.startswith("#"))
            return next((line for k, line in enumerate(lines) if k == wanted), wanted + 1)

    def where(self, place: int, column: str) -> str:
        """The row and the column, for a message."""
        return f"{self.name}, row {self.row(place)}, column {column}"
