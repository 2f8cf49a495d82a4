"""Reading measured data from CSV files or tables, with pandas; every complaint names the row and the column.

Rows are counted as in the file: the header is row 1.  Kinds and their columns (contract of the command line):

``record``          ``t,x``                              a sampled motion
``turning-points``  ``n,x[,tau]``                        positions (or amplitudes) and perhaps times
``decrement``       ``amplitude,decrement[,resolution]`` of half-swings, as printed in tables

Columns may carry a unit after an underscore or in brackets, as in ``t_ms``, ``phi_rad`` and ``x [mm]``.
"""

import csv
import io
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from asymptotics.errors import InputError, LimitError, require_choice, shown
from asymptotics.identification.coefficients import Array

KINDS = ("record", "turning-points", "decrement")
UNITS = {"m": 1.0, "cm": 0.01, "mm": 0.001, "rad": 1.0, "deg": float(np.pi / 180)}
"""Units of x, with their size in m or rad."""
_SECONDS = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "min": 60.0, "h": 3600.0}
"""Units of time, with their size in s: a column such as t_ms is turned into seconds."""
_LENGTHS = ("m", "cm", "mm")
MAX_BYTES = 2_000_000_000
MAX_SIZE = 1e60
_COLUMNS = {"record": ("t", "x"), "turning-points": ("n", "x"), "decrement": ("amplitude", "decrement")}
_OPTIONAL = {"record": (), "turning-points": ("tau",), "decrement": ("resolution",)}
_OTHER_NAMES = {"t": ("time", "tau"), "x": ("phi", "position", "angle"), "tau": ("t", "time"), "n": ("index",)}

Table = dict[str, Array]


def read_table(source: Any, kind: str | None, unit: str) -> tuple[str, Table, str]:
    """(kind, columns, unit) from a path, a data frame or a mapping of columns; InputError says where and why not."""
    if kind is not None:
        require_choice(kind, "kind", KINDS)
    if not isinstance(unit, str) or unit:
        require_choice(unit, "unit", UNITS)
    frame, name, first_row = _frame(source)
    found = kind or _kind_of(list(frame.columns), name)
    places = _places(list(frame.columns), found, name)
    table = {column: _numbers(frame[given], column, name, first_row) for column, given in places.items()}
    for column in ("t", "tau"):
        if column in table:
            table[column] = table[column] * _SECONDS.get(_suffix(places[column]), 1.0)
    return found, table, _unit_of(str(places.get("x", "")), unit, name)


def _frame(source: Any) -> tuple[Any, str, int]:
    import pandas  # noqa: PLC0415 (an extra: only identification reads tables)

    if isinstance(source, pandas.DataFrame):
        return source, "the data", 0
    if isinstance(source, Mapping):
        return _from_mapping(source, pandas), "the data", 0
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
    named = not all(_is_number(cell) for cell in next(csv.reader(io.StringIO(head))))
    try:
        frame = pandas.read_csv(
            path,
            header=0 if named else None,
            comment="#",
            skipinitialspace=True,
            encoding="utf-8-sig",
            low_memory=False,
        )
    except (pandas.errors.ParserError, pandas.errors.EmptyDataError, UnicodeDecodeError, ValueError) as error:
        raise InputError("FILE", f"{name}: {' '.join(str(error).split())}", "a CSV file with commas") from error
    frame.columns = [str(c).strip() for c in frame.columns] if named else [f"column {i + 1}" for i in frame.columns]
    return frame, name, 2 if named else 1


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


def _suffix(column: str) -> str:
    """The unit in a column's name: after its last underscore, or in brackets."""
    found = re.fullmatch(r".*[\[(]\s*(\w+)\s*[\])]", column) or re.fullmatch(r".*_(\w+)", column)
    return found.group(1) if found else ""


def _base(column: str) -> str:
    return re.split(r"[_ \[(]", column, maxsplit=1)[0].strip().lower()


def _kind_of(columns: list[str], name: str) -> str:
    bases = {_base(c) for c in columns}
    if {"amplitude", "decrement"} <= bases:
        return "decrement"
    if "n" in bases:
        return "turning-points"
    if bases & {"t", "time", "tau"}:
        return "record"
    shown = ", ".join(columns[:5])
    raise InputError("kind", f"{name} has the columns {shown[:60]}: what they are is not clear", ", ".join(KINDS))


def _places(columns: list[str], kind: str, name: str) -> dict[str, str]:
    """Which column of the file is which; without names they are taken in order."""
    wanted, optional = _COLUMNS[kind], _OPTIONAL[kind]
    accepted = ",".join(wanted) + "".join(f"[,{c}]" for c in optional)
    if len(columns) < len(wanted):
        reason = f"{name} has {len(columns)} column" + ("" if len(columns) == 1 else "s")
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


def _numbers(values: Any, column: str, name: str, first_row: int) -> Array:
    import pandas  # noqa: PLC0415 (as above)

    numeric = pandas.to_numeric(values, errors="coerce")
    text = np.flatnonzero((numeric.isna() & values.notna()).to_numpy())
    if len(text):
        cell = str(values.iloc[text[0]])
        reason = f"{name}, row {text[0] + first_row}, column {column}: {cell[:30]!r} is not a number"
        raise InputError("FILE", reason, "numbers")
    found = numeric.to_numpy(dtype=float)
    with np.errstate(invalid="ignore"):
        wild = np.flatnonzero((np.abs(found) > MAX_SIZE) | ((np.abs(found) < 1 / MAX_SIZE) & (found != 0)))
    if len(wild):
        reason = f"{name}, row {wild[0] + first_row}, column {column}: {found[wild[0]]:g} is out of range"
        raise InputError(
            "FILE", reason, f"0, and absolute values from {1 / MAX_SIZE:g} to {MAX_SIZE:g}: change the unit"
        )
    return np.asarray(found)


def _unit_of(column: str, unit: str, name: str) -> str:
    named = _suffix(column)
    if named not in UNITS:
        return unit
    if unit and (unit in _LENGTHS) != (named in _LENGTHS):
        raise InputError("unit", f"{unit} does not fit the column {column} of {name}", named)
    if unit and unit != named:
        raise InputError("unit", f"{unit} contradicts the column {column} of {name}", f"{named}, or no --unit")
    return named


def require_increasing(values: Array, column: str, name: str, first_row: int = 2) -> None:
    """InputError with the row at which ``values`` does not increase."""
    wrong = np.flatnonzero(np.diff(values) <= 0)
    if len(wrong):
        row = wrong[0] + 1
        reason = f"{name}, row {row + first_row}, column {column}: {values[row]:g} after {values[row - 1]:g}"
        raise InputError("FILE", reason, "increasing values")
