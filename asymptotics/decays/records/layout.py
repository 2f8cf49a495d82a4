"""How a text table is laid out: separator, decimal mark, header, and the line at which the numbers begin.

Every pair of a separator and a decimal mark is tried on the first lines; the one that makes the most cells numbers, in
rows of one width, is taken.  Two that do so equally and read different numbers are not chosen between: InputError asks.

>>> found = layout_of(["Messung 3", "", "Zeit (s);Winkel", "s;deg", "0,0;1,5", "0,1;1,25", "0,2;1,0"], "a.csv")
>>> found.separator, found.decimal, found.header, found.start
(';', ',', ('Zeit (s)', 'Winkel [deg]'), 4)
"""

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from asymptotics.decays.records.cells import MISSING, is_grouped, number
from asymptotics.decays.records.header import header_of
from asymptotics.decays.records.lines import WHITE, is_comment, split
from asymptotics.decays.records.one_column import one_column
from asymptotics.decays.records.stamps import is_stamp
from asymptotics.errors import InputError
from asymptotics.present.counts import many

_UNGROUPED = re.compile(r"[+-]?\d{4,}")
_SEPARATORS = ("\t", ";", "|", ",", WHITE)
"""The signs that are no decimal marks first: of equal readings the first wins, by a millionth of the score."""


@dataclass(frozen=True)
class Layout:
    """``separator``: a character, or a space for any white space; ``header``: the names (empty: none); ``start``: the
    line of the first numbers, from 0; ``thousands``: whether commas (points) group thousands; ``others``: columns
    whose decimal mark is the other one."""

    separator: str
    decimal: str
    header: tuple[str, ...]
    start: int
    width: int
    thousands: bool = False
    others: frozenset[int] = frozenset()

    def mark(self, place: int) -> str:
        """The decimal mark of a column."""
        return self.decimal if place not in self.others else "," if self.decimal == "." else "."

    def cells(self, line: str) -> list[str]:
        """The cells of a line."""
        return split(line, self.separator)


def layout_of(lines: Sequence[str], name: str, *, decimal: str | None = None, skip: int = 0) -> Layout:
    """The layout that the first lines show; InputError if they hold no table, or two readings are possible."""
    # Excel announces the separator in a first line, sep=;.
    separator = next((s for s in (_announced(line) for line in lines[:3]) if s), None)
    cut = {s: _rows(lines, s, skip) for s in ((separator,) if separator else _SEPARATORS)}
    tried = [
        found
        for mark in ((decimal,) if decimal else (".", ","))
        for s, rows in cut.items()
        if (found := _tried(rows, s, mark)) is not None
    ]
    single = one_column(lines, decimal, skip)
    most = max((score for score, _ in tried), default=0)
    if single and (single.rows > 2 * most or (single.decimal == "," and single.sure and single.rows > 0.9 * most)):
        return Layout("\t", single.decimal, single.header, single.start, 1)
    if not tried:
        filled = any(line.strip() for line in lines)
        reason = f"{name}: no rows of two numbers in {many(len(lines), 'line')}" if filled else f"{name} is empty"
        raise InputError("FILE", reason, "a table with a row for each moment, perhaps with a header")
    # The score counts rows of one width, so that a wrong separator, which cuts some rows and not others, loses.
    best = max(tried, key=lambda found: found[0])
    layout = _with_marks(_one_reading(best, tried, lines, name), lines)
    header, unclear = header_of(lines[skip : layout.start], layout.separator, layout.decimal, layout.width)
    # Names that do not fit the cells are a sign that a decimal comma was taken for a separator.
    if unclear:
        reason = f"{name}, row {layout.start}: {unclear} names above rows of {layout.width} cells"
        raise InputError("FILE", reason, "as many names as cells; or --columns t=1,x=2 with --skip, or --decimal ,")
    return replace(layout, header=header)


def _announced(line: str) -> str | None:
    found = re.fullmatch(r'"?sep=(.)"?\s*', line.lstrip("\ufeff"), re.IGNORECASE)
    return found[1] if found else None


def _rows(lines: Sequence[str], separator: str, skip: int) -> dict[int, list[str]]:
    """The cells of the lines in which the separator stands."""
    return {
        i: split(line, separator)
        for i, line in enumerate(lines)
        if i >= skip and (separator in line or separator == WHITE) and not is_comment(line)
    }


def _tried(rows: dict[int, list[str]], separator: str, decimal: str) -> tuple[float, Layout] | None:
    """(how many cells are numbers, less those that are not; the layout), or None."""
    good: dict[int, float] = {i: q for i, cells in rows.items() if (q := _quality(cells, decimal)) is not None}
    if not good:
        return None
    # The usual number of cells: a footer or a preamble may have others.
    width = Counter(len(rows[i]) for i in good).most_common(1)[0][0]
    chosen = [i for i in good if len(rows[i]) == width]
    share = sum(good[i] for i in chosen) / len(chosen)
    grouped = any(is_grouped(cell, decimal) for i in chosen for cell in rows[i])
    order = 1 - 1e-6 * _SEPARATORS.index(separator) if separator in _SEPARATORS else 1
    # At equal merit a reading without groups of thousands wins. The factors only break ties: ``_one_reading``
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
    return cell not in MISSING and (number(cell, decimal, thousands=True) is not None or is_stamp(cell))


def _quality(cells: Sequence[str], decimal: str) -> float | None:
    """The share of numbers among the cells that hold anything, if there are two of them; None for a line of text."""
    filled = [cell for cell in cells if cell not in MISSING]
    if len(cells) < 2:
        return None
    count = sum(_is_number(c, decimal) for c in filled)
    return count / len(filled) if count >= 2 else None


def _one_reading(
    best: tuple[float, Layout], tried: Sequence[tuple[float, Layout]], lines: Sequence[str], name: str
) -> Layout:
    """The best layout, or one with the other mark that what stands in the file decides for; InputError where nothing
    does."""
    score, taken = best
    for other_score, other in tried:
        # Another mark with the same separator and practically the same score: the cells themselves must agree.
        if other.decimal == taken.decimal or other_score < 0.998 * score or other.separator != taken.separator:
            continue
        table = {i: taken.cells(lines[i]) for i in range(taken.start, len(lines)) if not is_comment(lines[i])}
        for i, cells in table.items():
            for cell in cells:
                one, two = (number(cell, d, thousands=True) for d in (taken.decimal, other.decimal))
                if one is None or two is None or one != one or one == two:
                    continue
                decided = _decided(list(table.values()), cell, taken, other)
                if decided is None:
                    reason = f"{name}, row {i + 1}: {cell[:20]!r} may be {one:g} or {two:g}"
                    raise InputError("FILE", reason, "--decimal . or --decimal , (decimal='.' or decimal=',')")
                return decided
    return taken


def _decided(rows: Sequence[Sequence[str]], cell: str, one: Layout, two: Layout) -> Layout | None:
    """Of two readings the one in which more columns rise all along; else, where a number of four digits stands without
    a mark, the one in which the cell has no groups of thousands."""
    rising = [_rising(rows, layout) for layout in (one, two)]
    if rising[0] != rising[1]:
        return one if rising[0] > rising[1] else two
    if any(_UNGROUPED.fullmatch(c) for row in rows for c in row):
        return two if is_grouped(cell, one.decimal) else one
    return None


def _rising(rows: Sequence[Sequence[str]], layout: Layout) -> int:
    columns = zip(*[row for row in rows if len(row) == layout.width])
    read = ([number(c, layout.decimal, thousands=True) for c in column] for column in columns)
    return sum(all(a is not None and b is not None and a < b for a, b in pairwise(values)) for values in read)


def _with_marks(layout: Layout, lines: Sequence[str]) -> Layout:
    """The layout, with the columns that have the other decimal mark: all their cells are numbers with it, and some with
    this one are none."""
    other = "," if layout.decimal == "." else "."
    rows = [layout.cells(line) for line in lines[layout.start :] if not is_comment(line)]
    columns = list(zip(*[row for row in rows if len(row) == layout.width]))
    # A few spoilt cells are no decimal mark.
    found = {
        place
        for place, cells in enumerate(columns)
        if not all(_is_number(c, layout.decimal) or c in MISSING for c in cells)
        and all(number(c, other) is not None for c in cells)
    }
    grouped = any(is_grouped(c, layout.decimal) for k, cells in enumerate(columns) if k not in found for c in cells)
    return replace(layout, others=frozenset(found), thousands=layout.thousands and grouped)
