"""The names above the numbers of a text table, with the row of units and the row of groups.

>>> header_of(["Messung 3", "Zeit (s);Winkel", "s;deg"], ";", ",", 2)
(('Zeit (s)', 'Winkel [deg]'), 0)
>>> header_of(["t x", "--- ---"], " ", ".", 2), header_of(["a remark", "t,x,y"], ",", ".", 2)
((('t', 'x'), 0), ((), 3))
"""

import re
from collections.abc import Sequence

from asymptotics.decays.records.cells import number
from asymptotics.decays.records.lines import COMMENT, WHITE, split
from asymptotics.decays.records.units import is_unit, suffix

_HEADER_WORD = re.compile(r"[^\s(\[]+(?:\s*[(\[][^)\]]*[)\]])?")
_RULE = re.compile(r"[\s#%|+:,;]*(?:[-=_~*]{2,}[\s|+:,;]*)+")
"""A line of dashes, such as people and Markdown draw under a header."""


def header_of(above: Sequence[str], separator: str, decimal: str, width: int) -> tuple[tuple[str, ...], int]:
    """The names in the lines above the numbers; none, and how many there are, where they are not one for each cell."""
    lines = [line for line in above if line.strip() and not _RULE.fullmatch(line)]
    if not lines:
        return (), 0
    names, remark = _names(lines[-1], separator, width)
    if glued := unglued(names, decimal, width):
        return glued, 0
    units: list[str] = []
    if len(names) == width and all(is_unit(cell) for cell in names) and len(lines) > 1:
        units = names
        lines = lines[:-1]
        names, remark = _names(lines[-1], separator, width)
    if len(names) != width or not any(names):
        return (), 0 if remark or len(names) < 2 else len(names)
    # Numbers above the numbers are a row that was skipped, no names.
    if all(number(cell, decimal) is not None for cell in names):
        return (), 0
    # Names that repeat have the run or the sensor in the row above them.
    if len(set(names)) < len(names) and len(lines) > 1:
        names = _grouped(_names(lines[-2], separator, width)[0], names)
    if units:
        units = [unit.strip("[]() ") for unit in units]
        names = [f"{n} [{u}]" if u and not suffix(n) else n for n, u in zip(names, units)]
    return tuple(names), 0


def _names(line: str, separator: str, width: int) -> tuple[list[str], bool]:
    remark = COMMENT.match(line)
    text = line[remark.end() :] if remark else line
    if separator == WHITE:
        # Names with spaces in a table of white space: by wide gaps, by brackets, by words; the first that fits the
        # width.
        for names in (re.split(r"\t|\s{2,}|,\s*|;\s*", text.strip()), _HEADER_WORD.findall(text), text.split()):
            if len(names) == width:
                return [n.strip() for n in names], bool(remark)
        return text.split(), bool(remark)
    names = split(text, separator)
    # Some exporters head a table of tabs with names between commas.
    if len(names) < width and separator != ",":
        other = split(text, ",")
        names = other if len(other) == width else names
    while len(names) > width and not names[-1]:
        names.pop()
    # A column of remarks that is empty in every row looked at.
    if len(names) == width + 1 and names[-1].lower() in ("comment", "comments", "remarks", "notes"):
        names.pop()
    if len(names) == width - 1:  # rows that end with a separator
        names.append("")
    return names, bool(remark)


def _grouped(groups: Sequence[str], names: Sequence[str]) -> list[str]:
    """Names that stand twice, with the name of the group above them (which stands at its first column)."""
    filled, last = [], ""
    for place in range(len(names)):
        last = (groups[place] if place < len(groups) else "") or last
        filled.append(last)
    return [f"{group}: {n}" if group and names.count(n) > 1 else n for group, n in zip(filled, names)]


def unglued(cells: Sequence[str], decimal: str, width: int) -> tuple[str, ...]:
    """The names of a line that has the first row behind them, for want of an end of line; empty for another line.

    >>> [unglued(cells, ".", 2) for cells in (["t", "x (m)0.0", "1.5"], ["t", "x", "0.0", "1.5"], ["t", "x"])]
    [('t', 'x (m)'), ('t', 'x'), ()]
    """
    last, behind = cells[width - 1 : width], cells[width:]
    if len(cells) not in (2 * width - 1, 2 * width) or any(number(c, decimal) is None for c in behind):
        return ()
    if any(number(c, decimal) is not None for c in cells[:width]):
        return ()
    if len(cells) == 2 * width:
        return tuple(cells[:width])
    # The first place from which on the cell is a number.
    cut = next((k for k in range(1, len(last[0])) if number(last[0][k:], decimal) is not None), None)
    return () if cut is None else (*cells[: width - 1], last[0][:cut].strip())


def names_in_rows(columns: Sequence[Sequence[str]], known: Sequence[bool]) -> tuple[str, ...]:
    """Names of columns without a header: one text that stands before each number is its name, one behind it its unit.

    ``known``: which columns hold numbers; the others have no name.

    >>> names_in_rows([["time:"] * 3, ["0", "1", "2"], ["ms,"] * 3, ["1.5", "1.0", "0.5"]], [False, True, False, True])
    ('', 'time [ms]', '', 'column 4')
    """
    one = [cells[0].strip(" ,;") if len({*cells}) == 1 and not k else "" for cells, k in zip(columns, known)]
    names = []
    for place, holds in enumerate(known):
        before, after = (one[p] if 0 <= p < len(one) else "" for p in (place - 1, place + 1))
        named = before.endswith((":", "="))
        name = before.rstrip(" :=") if named else f"column {place + 1}"
        # Behind a name and a number even an unknown word is a unit: a clock in ticks is not one in seconds.
        unit = after if after and not after.endswith((":", "=")) and (named or is_unit(after)) else ""
        names.append((f"{name} [{unit}]" if unit else name) if holds else "")
    return tuple(names)
