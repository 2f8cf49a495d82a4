"""Values beside a named table: rows are found by the table's own keys, values compared cell by cell.

>>> import tempfile
>>> path = Path(tempfile.mkdtemp()) / "mine.csv"
>>> _ = path.write_text("half_cycle,S_hat,u\\n2,0.098765,-0.41072\\n4,0.133834,-0.194566\\n")
>>> for row in compare_table(path, "smith2012.table1").rows:
...     print(row.key, row.column, row.marked, row.certified, row.digits)
2 S_hat 0.098765 0.098764961172177998811 6.41
2 u -0.41072 -0.41071968606103944670 6.12
4 S_hat 0.13383[4] 0.13383308270665046999 5.16
4 u -0.194566 -0.19456584187398814694 6.09
"""

import csv
import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from asymptotics.decays.comparison.digits import significant
from asymptotics.decays.comparison.quick_look import Look
from asymptotics.decays.comparison.reading import Columns, Sheet, read_sheet
from asymptotics.decays.comparison.run import (
    GUARD,
    LEAST_DIGITS,
    MAX_DIGITS,
    UNJUDGED,
    ComparedValue,
    Comparison,
    row_of,
    short_of,
    summary_of,
)
from asymptotics.errors import InputError
from asymptotics.numbers.exact import parse_real
from asymptotics.present.counts import many
from asymptotics.running.cut_short import changed
from asymptotics.tables.inputs import MAX_ROWS, Inputs
from asymptotics.tables.registry import build, description
from asymptotics.tables.table import Table

Key = tuple[object, ...]
SERIES = ("series", "k", "value")
_GRIDS = {"alpha", "law", "epsilon", "u_0", "A"}  # keys that are no counters


def compare_table(
    path: Path | Columns,
    name: str,
    inputs: Inputs | None = None,
    *,
    columns: str | None = None,
    digits: int | None = None,
) -> Comparison:
    """Compare a file, or columns by name, with the table ``name``; InputError for rows and columns that it lacks."""
    about, left, header = description(name), list[str](), 0
    if isinstance(path, Path) and series_table(path) == name:
        # Columns by name have no header line: the lines of the file are one more.
        (path, left), header = _coefficients(path), 1
    names = tuple(about["columns"])
    # Keys and cells without a unit are words, which need not be numbers.
    words = tuple(c for c, unit in zip(names, about["units"]) if not unit or c in about["keys"])
    sheet = read_sheet(path, columns, names, words=words)
    keys = [column for column in sheet.columns if column in about["keys"]]
    values = [column for column in sheet.columns if column not in words]
    if not keys or not values:
        raise InputError("columns", f"{name} needs a key and a value", f"keys {', '.join(about['keys'])}; {names}")
    given = inputs or Inputs()
    # The table is made as long as the file, which only its keys tell.
    if "rows" in about["uses"] and given.rows is None:
        given = replace(given, rows=min(MAX_ROWS, _counted(sheet, keys)))
    longest = max(significant(cell) for column in values for cell in sheet.column(column))
    wanted = digits or min(MAX_DIGITS, max(LEAST_DIGITS, GUARD + longest))

    def compared(table: Table, sheet: Sheet, look: Callable[[bool], Look]) -> Comparison:
        rows = tuple(replace(row, line=row.line + header) for row in _rows(sheet, table, keys, values, wanted))
        summary = summary_of(rows, look(any("[" in row.marked for row in rows)))
        summary |= {"not_compared": left} if left else {}
        return Comparison(rows, summary, table.certified, table.source, table)

    def so_far(table: Table) -> Comparison | None:
        entries = _entries(table, keys)
        places = [i for i, row in enumerate(_keys_of(sheet, keys)) if _key(row) in entries]
        return short_of(compared(table, sheet.only(places), lambda _: UNJUDGED), sheet.lines) if places else None

    with changed(so_far):
        table = build(name, wanted, given)
    return compared(table, sheet, _look)


def _look(wrong: bool) -> Look:
    reason = "a table is judged value by value" if wrong else "every value is right to the digits written"
    return Look("undecided" if wrong else "rounding", reason)


def series_table(path: Path | Columns) -> str | None:
    """The table that holds the coefficients which ``expand --csv`` or ``half-swing --csv`` wrote; None for other files.

    >>> import tempfile
    >>> path = Path(tempfile.mkdtemp()) / "series.csv"
    >>> _ = path.write_text('series,k,value,exact\\np,1,0.4244132,4/(3*pi)\\nOmega,2,-0.1666668,-1/6\\n')
    >>> series_table(path)
    'normal-form'
    >>> [row.marked for row in compare_table(path, "normal-form", Inputs.of(["2"])).rows]
    ['0.4244132', '-0.166666[8]']
    """
    cells = _cells(path) if isinstance(path, Path) else []
    if not cells or tuple(cells[0][:3]) != SERIES:
        return None
    return "normal-form" if cells[-1][0] in ("p", "Omega") else "half-swing"


def _cells(path: Path) -> list[list[str]]:
    """All cells; none where the file cannot be read, which is said when it is read for its values."""
    try:
        return list(csv.reader(path.read_text(encoding="utf-8-sig").splitlines())) if path.is_file() else []
    except (OSError, ValueError, csv.Error):
        return []


def _coefficients(path: Path) -> tuple[Columns, list[str]]:
    """The rows as the table has them, by line; and the series of each force of a sum, which it has not."""
    rows = [(row[0], "_".join(row[:2]), row[2]) for row in _cells(path)[1:] if len(row) > 2]
    kept = [row[1:] for row in rows if "[" not in row[0]]
    left = dict.fromkeys(row[0] for row in rows if "[" in row[0])
    return dict(zip(("coefficient", "value"), map(list, zip(*kept)))), list(left)


def _rows(sheet: Sheet, table: Table, keys: list[str], values: list[str], digits: int) -> tuple[ComparedValue, ...]:
    missing = [key for key in keys + values if key not in table.columns]
    if missing:
        raise InputError("FILE", f"the table has no column {missing[0]!r} here", ", ".join(table.columns))
    found, rows = _entries(table, keys), []
    cells = {column: sheet.column(column) for column in values}
    for place, (line, texts) in enumerate(zip(sheet.lines, _keys_of(sheet, keys))):
        entries = found.get(_key(texts), [])
        # Keys that name two rows would let a value choose the one that fits.
        if len(entries) != 1:
            what = "no row" if not entries else many(len(entries), "row")
            accepted = f"keys that name one row: {', '.join(table.keys)}"
            raise InputError("FILE", f"line {line}: the table has {what} for {', '.join(texts)[:80]}", accepted)
        for column in values:
            right = entries[0][table.columns.index(column)] or None
            key, name = ", ".join(texts), ",".join(keys)
            number = sheet.numbers[column][place]
            rows.append(row_of(line, key, cells[column][place], number, right, column, name, digits))
    return tuple(rows)


def _entries(table: Table, keys: list[str]) -> dict[Key, list[tuple[str, ...]]]:
    """The rows of the table by what the file calls them."""
    found: dict[Key, list[tuple[str, ...]]] = {}
    for entry in table.rows:
        found.setdefault(_key([entry[table.columns.index(key)] for key in keys]), []).append(entry)
    return found


def _keys_of(sheet: Sheet, keys: list[str]) -> list[tuple[str, ...]]:
    return list(zip(*(sheet.column(key) for key in keys)))


def _key(texts: Sequence[str]) -> Key:
    return tuple(map(_same, texts))


def _same(cell: str) -> object:
    """A number however it is written, or the text."""
    try:
        return str(parse_real(cell, "cell"))
    except InputError:
        return cell.strip()


def _counted(sheet: Sheet, keys: list[str]) -> int:
    """How many rows reach as far as the file does: the largest integer in a key that counts, and one more."""
    cells = (cell for key in keys if key not in _GRIDS for cell in sheet.column(key))
    # As a key it is compared: the digits of 1.000e+01 as they are written count neither to 10 nor to 0.
    numbers = (int(digits) for cell in cells for digits in re.findall(r"\d{1,6}", str(_same(cell))))
    return 1 + max(numbers, default=0)
