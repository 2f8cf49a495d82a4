"""Cells with their unit, ``0.04 s;3.21 cm``: the unit goes to the name of the column, the numbers stay.

All cells of such a column have one unit; a cell without it, or with another, is named with its row.

>>> list(with_units_above(["t,x", "0.04 s,3.21 cm", "0.08 s,2.9 cm"], "run.csv"))
['t [s],x [cm]', '0.04,3.21', '0.08,2.9']
>>> list(with_units_above(["0,04 s;3,21 cm", "0,08 s;2,9 cm"], "run.csv"))
['0,04;s;3,21;cm', '0,08;s;2,9;cm']
>>> list(with_units_above(["t,x", "0.04 s,3.21 cm", "0.08 s,29 mm"], "run.csv"))
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument FILE: run.csv, row 3: '29 mm' where the cells above are in cm (accepted: ...
"""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import chain, islice

from asymptotics.decays.records.lines import is_comment, split
from asymptotics.decays.records.units import ACCELERATIONS, SECONDS, SPEEDS, UNITS, standard, suffix
from asymptotics.errors import InputError

_HEAD, ROWS, _MOST = 200, 5, 0.5
"""Lines in which such a row is sought, rows that are looked at, and the share of them that have the unit."""
_SIGNED = r"[+\u2212-]?(?:\d[\d.,]*|[.,]\d+)(?:[eE][+-]?\d+)?"
_CELL = re.compile(rf"(?P<number>{_SIGNED})\s*(?P<unit>[^\d\s.,;|\t+-][^\d;|\t]*)")
_NUMBER = re.compile(_SIGNED)
_KNOWN = {*UNITS, *SECONDS, *SPEEDS, *ACCELERATIONS, "V", "mV", "uV", "%"}
_QUICK = re.compile(r"\d\s*[^\W\d_%\u00b0]|\d\s*[%\u00b0]")


def with_units_above(lines: Iterable[str], name: str) -> Iterator[str]:
    """The lines of a text table, as many as before; InputError for a cell that is in another unit than its column."""
    lines = iter(lines)
    head = list(islice(lines, _HEAD))
    found = next((f for f in (_first(head, s) for s in "\t;|,") if f is not None), None)
    if found is None:
        yield from chain(head, lines)
        return
    separator, start, units = found
    above = _header(head, start, separator)
    for i, line in enumerate(chain(head, lines)):
        if i == above:
            names = named(split(line, separator), units, f"{name}, row {i + 1}")
            yield separator.join(f'"{cell}"' if "," in cell or ";" in cell else cell for cell in names)
        elif i < start or is_comment(line):
            yield line
        else:
            yield _bare(line, separator, units, f"{name}, row {i + 1}", apart=above is None)


def _unit_in(cell: str) -> str:
    """The unit behind the number in a cell, under its usual name; empty without one that is known."""
    found = _CELL.fullmatch(cell.strip())
    unit = standard(found["unit"]) if found else ""
    return unit if unit in _KNOWN else ""


def unit_of(cells: Sequence[str]) -> str:
    """The unit behind the number in the first of these cells, and in most of them; empty without one.

    >>> unit_of(["3.21 cm", "2.9 cm"]), unit_of(["3.21 cm", "29 mm", "2.9"]), unit_of(["a", "b"])
    ('cm', '', '')
    """
    unit = _unit_in(cells[0]) if cells else ""
    return unit if unit and sum(_unit_in(cell) == unit for cell in cells) >= _MOST * len(cells) else ""


def number_before(cell: str, unit: str, where: str) -> str:
    """The number of a cell in this unit, what is neither as it is; InputError for a number in another unit, or in
    none.

    >>> number_before("3.21 cm", "cm", "row 1"), number_before("nan", "cm", "row 2")
    ('3.21', 'nan')
    """
    found = _CELL.fullmatch(cell.strip())
    if found and _unit_in(cell) == unit:
        return found["number"]
    if found or _NUMBER.fullmatch(cell.strip()):
        raise InputError("FILE", f"{where}: {cell[:30]!r} where the cells above are in {unit}", "one unit")
    return cell


def _first(head: Sequence[str], separator: str) -> tuple[str, int, dict[int, str]] | None:
    """The separator, the line of the first row and the units of its columns; None where no column has any."""
    rows = [(i, split(line, separator)) for i, line in enumerate(head) if separator in line and _QUICK.search(line)]
    rows = [(i, cells) for i, cells in rows if not is_comment(head[i]) and len(cells) > 1]
    start = next((i for i, cells in rows if any(map(_unit_in, cells)) and all(map(_is_of_a_row, cells))), None)
    if start is None:
        return None
    cells = split(head[start], separator)
    following = [split(line, separator) for line in head[start : start + ROWS]]
    following = [row for row in following if len(row) == len(cells)]
    units = {}
    for place in range(len(cells)):
        if unit := unit_of([row[place] for row in following]):
            units[place] = unit
    return (separator, start, units) if units and len(following) > 1 else None


def _is_of_a_row(cell: str) -> bool:
    return not cell or bool(_unit_in(cell) or _NUMBER.fullmatch(cell.strip()))


def _header(head: Sequence[str], start: int, separator: str) -> int | None:
    """The line of the names; None for a file without."""
    width = len(split(head[start], separator))
    above = [i for i in range(start) if head[i].strip() and not head[i].lower().startswith("sep=")]
    if not above or len(split(head[above[-1]], separator)) != width:
        return None
    return above[-1]


def named(names: Sequence[str], units: Mapping[int, str], where: str) -> list[str]:
    """The names of columns with the units in their cells; InputError where a name has another one."""
    found = list(names)
    for place, unit in units.items():
        other = suffix(names[place])
        if other and other != unit:
            raise InputError("FILE", f"{where}: the cells of {names[place]!r} are in {unit}", "one unit")
        found[place] = names[place] if other else f"{names[place]} [{unit}]"
    return found


def _bare(line: str, separator: str, units: dict[int, str], where: str, *, apart: bool) -> str:
    """The row without its units, or with them in cells of their own where no names stand above."""
    cells = []
    for place, cell in enumerate(split(line, separator)):
        unit = units.get(place)
        number = number_before(cell, unit, where) if unit and cell else cell
        cells.append(f'"{number}"' if separator in number else number)
        cells += [unit] if unit and apart else []
    return separator.join(cells)
