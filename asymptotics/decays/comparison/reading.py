"""A CSV file of somebody's values: which column is what, in which unit; what cannot be used is refused by line.

Quantities: ``n`` (turning point) or ``tau``/``t`` (time) is the key of a row; ``x``, ``v``, ``tau``, ``t`` and
``amplitude`` (= |x| at a turning point) are values; at times, ``amplitude`` and ``phase`` without x are an envelope.
tau = omega_0 t and X = x/x0 have no unit; with an oscillator in SI, t is in s, x in m and v in m/s; without one
m = k = x0 = 1, and t is tau.  A header may carry units, ``x [m]``; lines that start with # are comments.

>>> columns_of(["n", "x"], None), columns_of(["step", "pos"], "n,x"), columns_of(["k", "x", "time"], "n=k,tau=time")
({'n': 0, 'x': 1}, {'n': 0, 'x': 1}, {'n': 0, 'tau': 2})
"""

import csv
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import inf
from pathlib import Path
from typing import Any

from asymptotics.decays.comparison.units import in_si, parted, power_of
from asymptotics.decays.records.columns import quantity as measured
from asymptotics.errors import InputError, LimitError, shown
from asymptotics.frames import BARE, Frame
from asymptotics.numbers.exact import parse_printed
from asymptotics.numbers.policy import exact_number
from asymptotics.present.counts import many

Columns = Mapping[str, Any]

QUANTITIES = ("n", "tau", "t", "x", "v", "amplitude", "phase")
UNITS = {"t": "s", "x": "m", "amplitude": "m", "v": "m/s", "phase": "rad"}
_MEANT = {"time": "t", "position": "x", "velocity": "v", "n": "n", "amplitude": "amplitude"}
MAX_ROWS = 1_000_000
"""Each row is an exact number and a certified one: more of them would take the memory and the day."""


@dataclass(frozen=True)
class Sheet:
    """The cells of a file: ``columns`` says which is what, ``lines`` are the line numbers of the rows.

    ``numbers`` are the columns that hold numbers, exactly; ``converted``: which were in another unit than SI.
    """

    columns: dict[str, int]
    lines: tuple[int, ...]
    rows: tuple[tuple[str, ...], ...]
    numbers: dict[str, tuple[Fraction, ...]]
    converted: tuple[str, ...] = ()

    def column(self, name: str) -> list[str]:
        """The cells of a column, as text."""
        place = self.columns[name]
        return [row[place].strip() for row in self.rows]

    def only(self, places: Sequence[int]) -> "Sheet":
        """The rows at these places."""
        numbers = {name: tuple(column[i] for i in places) for name, column in self.numbers.items()}
        lines, rows = tuple(self.lines[i] for i in places), tuple(self.rows[i] for i in places)
        return Sheet(self.columns, lines, rows, numbers, self.converted)

    def in_si(self, powers: Mapping[str, int], units: Mapping[str, str]) -> "Sheet":
        """The columns times these powers of ten, digit by digit; ``units``: what they were in."""
        rows = [list(row) for row in self.rows]
        for name, power in powers.items():
            place = self.columns[name]
            for row in rows:
                row[place] = in_si(row[place], power)
        numbers = {n: tuple(v * Fraction(10) ** powers.get(n, 0) for v in c) for n, c in self.numbers.items()}
        converted = tuple(f"{name} in {units[name]}" for name in powers)
        return Sheet(self.columns, self.lines, tuple(map(tuple, rows)), numbers, converted)


def read_sheet(
    path: Path | Columns,
    mapping: str | None,
    known: tuple[str, ...] = QUANTITIES,
    *,
    frame: Frame = BARE,
    lengths: tuple[str, ...] = (),
    words: tuple[str, ...] = (),
) -> Sheet:
    """Read a CSV file, or columns by name; InputError for what is neither, a column that is missing, units that differ.

    ``lengths``: other names of the unit of x.  The cells of the columns that are used are proved to be numbers here,
    except those of ``words``, so that nothing is computed for a bad file.
    """
    rows, header = rows_of_file(path) if isinstance(path, Path) else _rows_of(path)
    place_of = "FILE line" if isinstance(path, Path) else "row"
    if not rows:
        raise InputError("FILE", f"{path} has no rows of values", "a CSV file with a header")
    names, units = _names(header, known) if header else ([f"column {i + 1}" for i in range(len(rows[0][1]))], {})
    mapping, said = _without_units(mapping, known)
    if header is None and mapping is None:
        accepted = f"--columns, such as n,x,tau (known: {', '.join(known)})"
        raise InputError("FILE", f"{path} has no header", accepted)
    # A column without content is no key; one that is named by --columns must be there.
    filled = [name if _holds(rows, place) else "" for place, name in enumerate(names)] if mapping is None else names
    # In the order of the file, so that messages follow it.
    columns = dict(sorted(columns_of(filled, mapping, known).items(), key=lambda pair: pair[1]))
    # Tables have units of their own, which their description says.
    powers = {}
    if not words:
        named = {name: said.get(name, "") or units.get(place, "") for name, place in columns.items()}
        other = next((name for name, place in columns.items() if units.get(place, named[name]) != named[name]), None)
        if other is not None:
            raise InputError("columns", f"{other} in {named[other]} contradicts the header", units[columns[other]])
        powers = _require_units(named, frame, lengths)
    wanted = max(columns.values())
    for line, cells in rows:
        if len(cells) <= wanted:
            raise InputError("FILE", f"line {line} has {many(len(cells), 'cell')}", f"{wanted + 1} cells in each row")
    numbers = {
        # Exact, not doubles: a value of 100 digits is judged by all of them.
        name: tuple(parse_printed(cells[place], f"{place_of} {line}") for line, cells in rows)
        for name, place in columns.items()
        if name not in words
    }
    sheet = Sheet(columns, tuple(line for line, _ in rows), tuple(tuple(cells) for _, cells in rows), numbers)
    powers = {name: power for name, power in powers.items() if power}
    return sheet.in_si(powers, named) if powers else sheet


def _holds(rows: list[tuple[int, list[str]]], place: int) -> bool:
    """Whether a column has anything in it: an export has columns for what was not asked for."""
    return any(len(cells) <= place or cells[place].strip() for _, cells in rows)


def columns_of(names: list[str], mapping: str | None, known: tuple[str, ...] = QUANTITIES) -> dict[str, int]:
    """Quantity -> place in the file, from the names in its header and what --columns says.

    ``n,x`` are names of the header, or (where the header has other words) the meanings of its columns in their order;
    ``n=k,x=pos`` maps quantities to names; a number is the place of a column, from 1.
    """
    if mapping is None:
        found = {name: names.index(name) for name in known if name in names}
        if len(found) < 2 and known == QUANTITIES:
            # By the words by which every table of measured data is read, where each says one thing.
            meant = [_MEANT.get(measured(name), "") for name in names]
            found = {name: meant.index(name) for name in known if meant.count(name) == 1}
        if len(found) < 2:
            reason = f"its header ({', '.join(names)[:120]}) does not name a key and a value"
            raise InputError("FILE", reason, f"columns {', '.join(known)}, or --columns to say which is what")
        return found
    if not isinstance(mapping, str):
        raise InputError("columns", f"{shown(mapping)} is no text", "n,x  or  tau=time,x=pos")
    pairs = [tuple(part.strip() for part in (item if "=" in item else f"{item}={item}").split("=", 1))
             for item in mapping.split(",")]  # fmt: skip
    for quantity, _ in pairs:
        if quantity not in known:
            raise InputError("columns", f"{quantity!r} is no quantity that can be compared", ", ".join(known))
    if len(pairs) < 2 or len({quantity for quantity, _ in pairs}) < len(pairs):
        raise InputError("columns", "it needs a key and a value, each once", "n,x  or  tau=time,x=pos")
    meanings = [quantity for quantity, _ in pairs]
    # n,x are meanings only where no column has one of the names elsewhere: then they would contradict the header.
    foreign = all(name == quantity or name not in known for name, quantity in zip(names, meanings))
    if "=" not in mapping and len(pairs) == len(names) and foreign:
        return {quantity: place for place, quantity in enumerate(meanings)}
    return {quantity: _place(name, names) for quantity, name in pairs}


def _place(name: str, names: list[str]) -> int:
    if name in names:
        return names.index(name)
    if name.isdigit() and 1 <= int(name) <= len(names):
        return int(name) - 1
    raise InputError("columns", f"the file has no column {name!r}", f"its columns: {', '.join(names)[:200]}")


def _refuse_devices(path: Path) -> None:
    try:
        device = path.is_char_device() or path.is_block_device()
    except (OSError, ValueError):  # to be said when it is opened
        return
    if device:
        raise InputError("FILE", f"{path} is a device", "a CSV file in UTF-8")


def rows_of_file(path: Path) -> tuple[list[tuple[int, list[str]]], list[str] | None]:
    """The rows of values with their line numbers, and the header if there is one."""
    _refuse_devices(path)
    try:
        with path.open(newline="", encoding="utf-8-sig") as stream:
            text = stream.read(4096)  # some lines
            stream.seek(0)
            # The sign that is most frequent in the first lines; decimal commas are refused, cell by cell.
            mark = max(",;\t", key=text.count)
            reader = csv.reader(stream, delimiter=mark, strict=True)
            rows = [(reader.line_num, row) for row in reader if any(row) and not row[0].startswith("#")]
    except (OSError, ValueError, csv.Error) as error:  # ValueError: a name or a text that no encoding has
        reason = error.strerror if isinstance(error, OSError) else "it is not CSV text"
        raise InputError("FILE", f"cannot read {path}: {reason}", "a CSV file in UTF-8") from error
    if len(rows) > MAX_ROWS:
        raise LimitError("FILE", f"{len(rows)} rows are too many", f"at most {MAX_ROWS} in one comparison")
    # A header is a first row without any number.
    if rows and not any(_is_number(cell) for cell in rows[0][1]):
        return rows[1:], rows[0][1]
    return rows, None


def _rows_of(given: Columns) -> tuple[list[tuple[int, list[str]]], list[str]]:
    """The same from columns by name: sequences of one length, arrays or a data frame."""
    names = [str(name) for name in given]
    columns = [[cell_of(value, key == "n") for value in _listed(given[name], key)] for name, key in zip(given, names)]
    if not columns or len({len(column) for column in columns}) != 1:
        reason = "it has no column" if not columns else "its columns differ in length"
        raise InputError("FILE", reason, "columns of one length")
    if len(columns[0]) > MAX_ROWS:
        raise LimitError("FILE", f"{len(columns[0])} rows are too many", f"at most {MAX_ROWS} in one comparison")
    return [(i, list(cells)) for i, cells in enumerate(zip(*columns), start=1)], names


def _listed(column: Any, name: str) -> list[Any]:
    found = column.tolist() if hasattr(column, "tolist") else column
    if not isinstance(found, list | tuple):
        raise InputError(name, f"a {type(column).__name__} is no column", "a sequence of numbers")
    return list(found)


def cell_of(value: Any, counts: bool = False) -> str:
    """A number as the text of a cell: doubles by their shortest decimals; ``counts``: 1.0 is the integer 1.

    >>> cell_of(0.1), cell_of(1.0), cell_of(1.0, True), cell_of("3/2"), cell_of(Fraction(1, 3))
    ('0.1', '1.0', '1', '3/2', '1/3')
    """
    if isinstance(value, str):
        return value
    if isinstance(value, float):
        return str(int(value)) if counts and value.is_integer() else repr(value)
    # Every other number as the exact one that it is.
    return str(exact_number(value, "row"))


def _is_number(cell: str) -> bool:
    try:
        parse_printed(cell, "cell")
    except InputError:
        return False
    return True


def _names(header: list[str], known: tuple[str, ...]) -> tuple[list[str], dict[int, str]]:
    """The names of the columns without their units, and the units by place; a known name is whole as it is.

    >>> _names(["M_(alpha+1)", "x [m]"], ("M_(alpha+1)", "x"))
    (['M_(alpha+1)', 'x'], {1: 'm'})
    """
    pairs = [parted(cell, known) for cell in header]
    return [name for name, _ in pairs], {place: unit for place, (_, unit) in enumerate(pairs) if unit}


def _without_units(mapping: str | None, known: tuple[str, ...]) -> tuple[str | None, dict[str, str]]:
    """What --columns says without the units of its names, and these by what each column is.

    >>> _without_units("t (s),x (cm)", QUANTITIES), _without_units("x=x (mm)", QUANTITIES)
    (('t,x', {'t': 's', 'x': 'cm'}), ('x=x', {'x': 'mm'}))
    """
    if not isinstance(mapping, str):
        return mapping, {}
    pieces, units = [], {}
    for item in mapping.split(","):
        pairs = [parted(part, known) for part in item.split("=", 1)]
        pieces.append("=".join(name for name, _ in pairs))
        units[pairs[0][0]] = next((unit for _, unit in pairs if unit), "")
    return ",".join(pieces), {name: unit for name, unit in units.items() if unit}


def _require_units(units: dict[str, str], frame: Frame, lengths: tuple[str, ...]) -> dict[str, int]:
    """The power of ten of each column in m, s, m/s; InputError for a unit that is none."""
    powers = {}
    for name, unit in units.items():
        expected = frame.unit(name) if name in UNITS else ""
        if unit in ("", "1", expected) or (name in ("x", "amplitude") and unit in lengths):
            continue
        power = power_of(name, unit) if frame.x == "m" else None
        if power is not None:
            powers[name] = power
            continue
        accepted = f"{name} [{expected}]" if expected else f"{name} without a unit"
        accepted += ", or in a power of ten of it (cm, mm, ms)" if frame.x == "m" and name in ("t", "x", "v") else ""
        hint = "" if frame or name not in UNITS else "; values in SI need --mass, --stiffness and --x0"
        raise InputError("FILE", f"{name} is in {unit[:40]!r}", accepted + hint)
    return powers


def as_double(text: str) -> float:
    """The number of a cell as a double, infinite beyond their range.

    >>> as_double("3/2"), as_double("-2.5e-3"), as_double("1e400")
    (1.5, -0.0025, inf)
    """
    value = parse_printed(text, "cell")
    try:
        return float(value)
    except OverflowError:
        return inf if value > 0 else -inf
