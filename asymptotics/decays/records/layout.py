"""How a text table is laid out: separator, decimal mark, header, and the line at which the numbers begin.

Every pair of a separator and a decimal mark is tried on the first lines; the one that makes the most cells numbers, in
rows of one width, is taken.  Two that do so equally and read different numbers are not chosen between: InputError asks.

>>> found = layout_of(["Messung 3", "", "Zeit (s);Winkel", "s;deg", "0,0;1,5", "0,1;1,25", "0,2;1,0"], "a.csv")
>>> found.separator, found.decimal, found.header, found.start
(';', ',', ('Zeit (s)', 'Winkel [deg]'), 4)
"""

import csv
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from asymptotics.decays.records.cells import MISSING, is_grouped, is_stamp, number
from asymptotics.decays.records.units import is_unit, suffix
from asymptotics.errors import InputError

WHITE = " "
_SEPARATORS = ("\t", ";", "|", ",", WHITE)
"""The signs that are no decimal marks first: of equal readings the first wins, by a millionth of the score."""
_COMMENT = re.compile(r"\s*(?:#|%|//|!)\s?")
_HEADER_WORD = re.compile(r"[^\s(\[]+(?:\s*[(\[][^)\]]*[)\]])?")


@dataclass(frozen=True)
class Layout:
    """``separator``: a character, or a space for any white space; ``header``: the names (empty: none); ``start``: the
    line of the first numbers, from 0; ``thousands``: whether commas (points) group thousands."""

    separator: str
    decimal: str
    header: tuple[str, ...]
    start: int
    width: int
    thousands: bool = False

    def cells(self, line: str) -> list[str]:
        """The cells of a line."""
        return split(line, self.separator)


def split(line: str, separator: str) -> list[str]:
    """The cells of one line, quotes obeyed, without the white space around them."""
    if separator == WHITE:
        return line.split()
    if '"' not in line:
        return [cell.strip() for cell in line.strip(" ").split(separator)]
    return [cell.strip() for cell in next(csv.reader([line], delimiter=separator, skipinitialspace=True), [])]


def is_comment(line: str) -> bool:
    """A line that is blank, or a remark: from its first sign on."""
    return not line.strip() or bool(_COMMENT.match(line))


def layout_of(lines: Sequence[str], name: str, *, decimal: str | None = None, skip: int = 0) -> Layout:
    """The layout that the first lines show; InputError if they hold no table, or two readings are possible."""
    # Excel announces the separator in a first line, sep=;.
    separator = next((s for s in (_announced(line) for line in lines[:3]) if s), None)
    tried = [
        found
        for mark in ((decimal,) if decimal else (".", ","))
        for s in ((separator,) if separator else _SEPARATORS)
        if (found := _tried(lines, s, mark, skip)) is not None
    ]
    if not tried:
        filled = any(line.strip() for line in lines)
        reason = f"{name}: no rows of two numbers in {len(lines)} lines" if filled else f"{name} is empty"
        raise InputError("FILE", reason, "a table with a row for each moment, perhaps with a header")
    # The score counts rows of one width, so that a wrong separator, which cuts some rows and not others, loses.
    best = max(tried, key=lambda found: found[0])
    _require_one_reading(best, tried, lines, name)
    _, layout = best
    header, unclear = _header(lines[skip : layout.start], layout)
    # Names that do not fit the cells are a sign that a decimal comma was taken for a separator.
    if unclear:
        reason = f"{name}, row {layout.start}: {unclear} names above rows of {layout.width} cells"
        raise InputError("FILE", reason, "as many names as cells; or --columns t=1,x=2 with --skip, or --decimal ,")
    return Layout(layout.separator, layout.decimal, header, layout.start, layout.width, layout.thousands)


def _announced(line: str) -> str | None:
    found = re.fullmatch(r'"?sep=(.)"?\s*', line.lstrip("\ufeff"), re.IGNORECASE)
    return found[1] if found else None


def _tried(lines: Sequence[str], separator: str, decimal: str, skip: int) -> tuple[float, Layout] | None:
    """(how many cells are numbers, less those that are not; the layout), or None."""
    rows = {
        i: split(line, separator)
        for i, line in enumerate(lines)
        if i >= skip and (separator in line or separator == WHITE) and not is_comment(line)
    }
    good: dict[int, float] = {i: q for i, cells in rows.items() if (q := _quality(cells, decimal)) is not None}
    if not good:
        return None
    # The usual number of cells: a footer or a preamble may have others.
    width = Counter(len(rows[i]) for i in good).most_common(1)[0][0]
    chosen = [i for i in good if len(rows[i]) == width]
    share = sum(good[i] for i in chosen) / len(chosen)
    grouped = any(is_grouped(cell, decimal) for i in chosen for cell in rows[i])
    order = 1 - 1e-6 * _SEPARATORS.index(separator) if separator in _SEPARATORS else 1
    # At equal merit a reading without groups of thousands wins. The factors only break ties: ``_require_one_reading``
    # asks about scores as near as 0.998.
    score = len(chosen) * share * order * (0.999 if grouped else 1)
    return score, Layout(separator, decimal, (), _first(rows, chosen, width, decimal), width, grouped)


def _first(rows: dict[int, list[str]], chosen: Sequence[int], width: int, decimal: str) -> int:
    """The first row of the table: a pair of numbers in a preamble is none, one with a cell missing or spoilt is."""
    known, order = set(chosen), sorted(rows)
    for i in chosen:
        following = order[order.index(i) + 1 :][:4]
        # Half of the next four rows are of the table too, which no line of a preamble has.
        if 2 * sum(j in known for j in following) >= len(following):
            break
    else:
        i = chosen[0]
    # Rows just above with one cell spoilt belong to the table, and are told as unreadable.
    for j in reversed(order[: order.index(i)]):
        if len(rows[j]) != width or not any(_is_number(c, decimal) for c in rows[j]):
            break
        i = j
    return i


def _is_number(cell: str, decimal: str) -> bool:
    return cell not in MISSING and (is_stamp(cell) or number(cell, decimal, thousands=True) is not None)


def _quality(cells: Sequence[str], decimal: str) -> float | None:
    """The share of numbers among the cells that hold anything, if there are two of them; None for a line of text."""
    filled = [cell for cell in cells if cell not in MISSING]
    if len(cells) < 2:
        return None
    count = sum(_is_number(c, decimal) for c in filled)
    return count / len(filled) if count >= 2 else None


def _require_one_reading(
    best: tuple[float, Layout], tried: Sequence[tuple[float, Layout]], lines: Sequence[str], name: str
) -> None:
    score, taken = best
    for other_score, other in tried:
        # Another mark with the same separator and practically the same score: the cells themselves must agree.
        if other.decimal == taken.decimal or other_score < 0.998 * score or other.separator != taken.separator:
            continue
        for i in range(taken.start, len(lines)):
            for cell in [] if is_comment(lines[i]) else taken.cells(lines[i]):
                one, two = (number(cell, d, thousands=True) for d in (taken.decimal, other.decimal))
                if one is not None and two is not None and one == one and one != two:
                    reason = f"{name}, row {i + 1}: {cell[:20]!r} may be {one:g} or {two:g}"
                    raise InputError("FILE", reason, "--decimal . or --decimal , (decimal='.' or decimal=',')")


def _header(above: Sequence[str], layout: Layout) -> tuple[tuple[str, ...], int]:
    """The names above the numbers, with the row of units and the row of groups; and how many there are if too few."""
    lines = [line for line in above if line.strip()]
    if not lines:
        return (), 0
    names, remark = _names(lines[-1], layout)
    units: list[str] = []
    if len(names) == layout.width and all(is_unit(cell) for cell in names) and len(lines) > 1:
        units = names
        lines = lines[:-1]
        names, remark = _names(lines[-1], layout)
    if len(names) != layout.width or not any(names):
        return (), 0 if remark or len(names) < 2 else len(names)
    # Numbers above the numbers are a row that was skipped, no names.
    if all(number(cell, layout.decimal) is not None for cell in names):
        return (), 0
    # Names that repeat have the run or the sensor in the row above them.
    if len(set(names)) < len(names) and len(lines) > 1:
        names = _grouped(_names(lines[-2], layout)[0], names)
    if units:
        units = [unit.strip("[]() ") for unit in units]
        names = [f"{n} [{u}]" if u and not suffix(n) else n for n, u in zip(names, units)]
    return tuple(names), 0


def _names(line: str, layout: Layout) -> tuple[list[str], bool]:
    remark = _COMMENT.match(line)
    text = line[remark.end() :] if remark else line
    if layout.separator == WHITE:
        # Names with spaces in a table of white space: by wide gaps, by brackets, by words; the first that fits the
        # width.
        for names in (re.split(r"\t|\s{2,}|,\s*|;\s*", text.strip()), _HEADER_WORD.findall(text), text.split()):
            if len(names) == layout.width:
                return [n.strip() for n in names], bool(remark)
        return text.split(), bool(remark)
    names = split(text, layout.separator)
    # Some exporters head a table of tabs with names between commas.
    if len(names) < layout.width and layout.separator != ",":
        other = split(text, ",")
        names = other if len(other) == layout.width else names
    while len(names) > layout.width and not names[-1]:
        names.pop()
    # A column of remarks that is empty in every row looked at.
    if len(names) == layout.width + 1 and names[-1].lower() in ("comment", "comments", "remarks", "notes"):
        names.pop()
    if len(names) == layout.width - 1:  # rows that end with a separator
        names.append("")
    return names, bool(remark)


def _grouped(groups: Sequence[str], names: Sequence[str]) -> list[str]:
    """Names that stand twice, with the name of the group above them (which stands at its first column)."""
    filled, last = [], ""
    for place in range(len(names)):
        last = (groups[place] if place < len(groups) else "") or last
        filled.append(last)
    return [f"{group}: {n}" if group and names.count(n) > 1 else n for group, n in zip(filled, names)]
