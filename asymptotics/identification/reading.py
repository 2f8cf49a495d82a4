"""Reading measured data from CSV files or tables, with pandas; every complaint names the row and the column.

Rows are counted as an editor counts the lines of the file.  Kinds and their columns (contract of the command line):

``record``          ``t,x``                              a sampled motion
``turning-points``  ``n,x[,tau]``                        positions (or amplitudes) and perhaps times
``decrement``       ``amplitude,decrement[,resolution]`` of half-swings, as printed in tables

Columns may carry a unit after an underscore or in brackets (``column_units``).  Cells that are empty, or hold one of
the words for a missing value (nan, NA, n/a, null), are missing: their rows are left out, and the answer says how many
and which is the first.  Any other text is refused.
"""

import csv
import io
import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from asymptotics.errors import InputError, LimitError, require_choice, shown
from asymptotics.identification.coefficients import Array
from asymptotics.identification.column_units import UNITS, seconds, unit_of
from asymptotics.identification.rows import Rows

KINDS = ("record", "turning-points", "decrement")
MAX_BYTES = 2_000_000_000
MAX_SIZE = 1e60
_COLUMNS = {"record": ("t", "x"), "turning-points": ("n", "x"), "decrement": ("amplitude", "decrement")}
_OPTIONAL = {"record": (), "turning-points": ("tau",), "decrement": ("resolution",)}
_OTHER_NAMES = {"t": ("time", "tau"), "x": ("phi", "position", "angle"), "tau": ("t", "time"), "n": ("index",)}

_SEPARATORS = ",;\t"


@dataclass(frozen=True)
class Table:
    """Columns of equal length, by their names in the contract; ``unit``: of x; ``rows``: where they stand."""

    kind: str
    columns: dict[str, Array]
    unit: str
    rows: Rows

    def whole(self) -> tuple["Table", tuple[str, ...]]:
        """The rows in which no cell is missing, and a note that says which are not."""
        keep = ~np.any([np.isnan(values) for values in self.columns.values()], axis=0)
        if keep.all():
            return self, ()
        first, missing = int(np.argmin(keep)), int((~keep).sum())
        many = "1 row" if missing == 1 else f"{missing} rows"
        note = f"{many} with a missing cell (empty, nan, n/a) left out, the first is row {self.rows.row(first)}"
        columns = {name: values[keep] for name, values in self.columns.items()}
        return Table(self.kind, columns, self.unit, self.rows.kept(keep)), (note,)


def read_table(source: Any, kind: str | None, unit: str) -> Table:
    """The table in a path, a data frame or a mapping of columns; InputError says where and why not."""
    if kind is not None:
        require_choice(kind, "kind", KINDS)
    if not isinstance(unit, str) or unit:
        require_choice(unit, "unit", UNITS)
    frame, rows = _frame(source)
    header = list(map(str, frame.columns))
    if len(set(header)) < len(header):
        raise InputError("FILE", f"{rows.name}: two columns have one name", "columns with different names")
    found = kind or _kind_of(header, rows.name)
    places = _places(header, found, rows.name)
    frame.columns = header
    table = {column: _numbers(frame[given], column, rows) for column, given in places.items()}
    for column in ("t", "tau"):
        if column in table:
            table[column] = table[column] * seconds(places[column], rows.name)
    measured = [places[c] for c in ("x", "amplitude", "decrement", "resolution") if c in places]
    return Table(found, table, unit_of(measured, unit, rows.name), rows)


def _frame(source: Any) -> tuple[Any, Rows]:
    try:
        import pandas  # noqa: PLC0415 (an extra: only identification reads tables)
    except ImportError as error:
        accepted = "an installation with the extra identify: pip install 'power-law-oscillator[identify]'"
        raise InputError("data", "tables are read by pandas, which is not installed", accepted) from error
    if isinstance(source, pandas.DataFrame):
        return source.copy(deep=False), Rows("the data")
    if isinstance(source, Mapping):
        return _from_mapping(source, pandas), Rows("the data")
    if not isinstance(source, str | Path):
        raise InputError("data", f"{shown(source)} is no data", "a CSV file, a data frame, a mapping of columns")
    path = Path(source)
    name = path.name
    try:
        if path.stat().st_size > MAX_BYTES:
            raise LimitError("FILE", f"{name} has {path.stat().st_size} bytes", f"at most {MAX_BYTES} bytes")
        with path.open(encoding="utf-8-sig") as stream:
            head = next((line for line in stream if line.strip() and not line.startswith("#")), "")
    except OSError as error:
        raise InputError("FILE", f"cannot read {source}: {error.strerror}", "a CSV file") from error
    except UnicodeDecodeError as error:
        raise InputError("FILE", f"{name} is not text", "a CSV file in UTF-8") from error
    except ValueError as error:  # NUL, or a letter that no file name has
        raise InputError("FILE", f"{name!r} is no file name", "a CSV file") from error
    if not head:
        raise InputError("FILE", f"{name} is empty", "a CSV file with a header and data")
    separator = next((s for s in _SEPARATORS if s in head), ",")
    named = not all(_is_number(cell) for cell in next(csv.reader(io.StringIO(head), delimiter=separator)))
    try:
        frame = pandas.read_csv(
            path,
            sep=separator,
            header=0 if named else None,
            comment="#",
            skipinitialspace=True,
            encoding="utf-8-sig",
            low_memory=False,
        )
    except (pandas.errors.ParserError, pandas.errors.EmptyDataError, UnicodeDecodeError, ValueError) as error:
        raise InputError("FILE", f"{name}: {' '.join(str(error).split())}", "a CSV file with commas") from error
    frame.columns = [str(c).strip() for c in frame.columns] if named else [f"column {i + 1}" for i in frame.columns]
    return frame, Rows(name, path, named)


def _from_mapping(source: Mapping[str, Any], pandas: Any) -> Any:
    try:
        return pandas.DataFrame({str(k): np.asarray(v) for k, v in source.items()})
    except ValueError as error:
        raise InputError("data", str(error), "columns of equal length") from error


def _is_number(cell: str) -> bool:
    try:
        float(cell)
    except ValueError:
        return not cell.strip()
    return True


def _base(column: str) -> str:
    return re.split(r"[_ \[(]", column, maxsplit=1)[0].strip().lower()


def _kind_of(columns: list[str], name: str) -> str:
    bases = {_base(c) for c in columns}
    if len(columns) > 1:
        if {"amplitude", "decrement"} <= bases:
            return "decrement"
        if "n" in bases:
            return "turning-points"
        if bases & {"t", "time", "tau"}:
            return "record"
    listed = ", ".join(columns[:5])
    what = f"{len(columns)} column" + ("" if len(columns) == 1 else "s")
    accepted = ", or ".join(f"{_accepted(kind)} ({kind})" for kind in KINDS)
    if len(columns) > 1:
        accepted += "; or say with --kind what they are"
    raise InputError("FILE", f"{name}, row 1: {what} ({listed[:60]}): what is measured is not clear", accepted)


def _accepted(kind: str) -> str:
    return ",".join(_COLUMNS[kind]) + "".join(f"[,{c}]" for c in _OPTIONAL[kind])


def _places(columns: list[str], kind: str, name: str) -> dict[str, str]:
    """Which column of the file is which; without names they are taken in order."""
    wanted, optional = _COLUMNS[kind], _OPTIONAL[kind]
    accepted = _accepted(kind)
    if len(columns) < len(wanted):
        reason = f"{name}, row 1: {len(columns)} column" + ("" if len(columns) == 1 else "s")
        raise InputError("FILE", reason, f"columns {accepted}")
    if all(c.startswith("column ") for c in columns):
        return dict(zip((*wanted, *optional), columns))
    found: dict[str, str] = {}
    for column in (*wanted, *optional):
        names = (column, *_OTHER_NAMES.get(column, ()))
        match = next((c for n in names for c in columns if _base(c) == n and c not in found.values()), None)
        if match is None and column == "x" and len(columns) == 2:
            match = next(c for c in columns if c not in found.values())
        if match is not None:
            found[column] = match
        elif column in wanted:
            raise InputError("FILE", f"{name} has no column {column}", f"columns {accepted}")
    return found


def _numbers(values: Any, column: str, rows: Rows) -> Array:
    import pandas  # noqa: PLC0415 (as above)

    numeric = pandas.to_numeric(values, errors="coerce")
    text = np.flatnonzero((numeric.isna() & values.notna()).to_numpy())
    if len(text):
        cell = str(values.iloc[text[0]])
        raise InputError("FILE", f"{rows.where(text[0], column)}: {cell[:30]!r} is not a number", "numbers")
    found = numeric.to_numpy(dtype=float)
    with np.errstate(invalid="ignore"):
        wild = np.flatnonzero((np.abs(found) > MAX_SIZE) | ((np.abs(found) < 1 / MAX_SIZE) & (found != 0)))
    if len(wild):
        reason = f"{rows.where(wild[0], column)}: {found[wild[0]]:g} is out of range"
        raise InputError(
            "FILE", reason, f"0, and absolute values from {1 / MAX_SIZE:g} to {MAX_SIZE:g}: change the unit"
        )
    return np.asarray(found)


def require_increasing(values: Array, column: str, rows: Rows) -> None:
    """InputError with the row at which ``values`` does not increase."""
    wrong = np.flatnonzero(np.diff(values) <= 0)
    if len(wrong):
        row = int(wrong[0]) + 1
        reason = f"{rows.where(row, column)}: {values[row]:g} after {values[row - 1]:g}"
        raise InputError("FILE", reason, "increasing values")
