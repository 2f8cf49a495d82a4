"""Cells of a file beside the same cells at more digits: numbers are judged, words are the same or told.

>>> right = Cells(("k", "value", "exact"), (("1", "0.424413181578", "4/(3*pi)"),), ("k",))
>>> given = [(2, ("1", "0.4244131", "4/(3*pi)"))]
>>> found = compared_cells(given, ("k", "value", "exact"), right, 12)
>>> [(row.key, row.column, row.marked, row.digits) for row in found.rows]
[('1', 'value', '0.424413[1]', '6.72')]
>>> compared_cells([(2, ("1", "0.4244132", "4/(5*pi)"))], ("k", "value", "exact"), right, 12).summary["differs"]
["line 2, exact: '4/(5*pi)' is given, and '4/(3*pi)' is right"]
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from types import MappingProxyType

from asymptotics.decays.comparison.digits import judged, significant
from asymptotics.decays.comparison.quick_look import Look
from asymptotics.decays.comparison.run import UNJUDGED, ComparedValue, Comparison, short_of, summary_of, told_doubles
from asymptotics.errors import InputError, shown
from asymptotics.numbers.double_error import DoubleError
from asymptotics.numbers.exact import parse_printed
from asymptotics.present.counts import many

Key = tuple[str, ...]
_LONG, _LONGEST = 60, 10_000  # characters of a cell in a message; bits of a number that Python prints
_MARKS = {"code", "failed"}
"""Columns of provenance: that they are not compared needs no telling."""


@dataclass(frozen=True)
class Cells:
    """What a request gives: the names of its columns, its rows, and which columns are ``keys``.

    ``not_judged``: columns of bounds, remarks or provenance, of which more digits say nothing.  ``estimates``: keys
    of the rows that no route certifies; their digits are not counted.
    """

    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]
    keys: tuple[str, ...]
    not_judged: frozenset[str] = frozenset()
    estimates: frozenset[Key] = frozenset()
    method: str = "the same request at more digits"


def compared_cells(
    given: Sequence[tuple[int, Sequence[str]]],
    header: Sequence[str],
    right: Cells,
    digits: int,
    *,
    certified: bool = True,
    doubles: Mapping[str, DoubleError] = MappingProxyType({}),
) -> Comparison:
    """Every row with its line, cell by cell; InputError for a row or a column that the request does not give.

    ``certified``: whether the right cells are; ``doubles``: the errors that columns of doubles may have.
    """
    columns = [name for name in header if name not in right.keys and name not in right.not_judged]
    lacking = next((name for name in (*right.keys, *columns) if name not in right.header or name not in header), None)
    if lacking is not None:
        raise InputError("FILE", f"it or its request has no column {shown(lacking)}", ", ".join(right.header)[:400])
    # Rows are found by their keys, for a file may be sorted or cut; a number is one key however it is written.
    truth = {_key(row, right.header, right.keys): row for row in right.rows}
    places, rows, differs, unjudged = [], list[ComparedValue](), list[str](), list[int]()
    order = {key: place for place, key in enumerate(truth)}
    for line, cells in given:
        if len(cells) != len(header):
            raise InputError(
                "FILE", f"line {line} has {many(len(cells), 'cell')}", f"{many(len(header), 'cell')} in each row"
            )
        key = _key(cells, header, right.keys)
        if key not in truth:
            raise InputError(
                "FILE", f"line {line}: its request has no row {', '.join(key)[:80]}", "rows of the request"
            )
        places.append(order[key])
        # No route certifies this row: to count its digits would be a judgement by an estimate.
        if key in right.estimates:
            unjudged.append(line)
            continue
        for name in columns:
            cell, true = cells[header.index(name)].strip(), truth[key][right.header.index(name)].strip()
            number, value = _number(cell), _number(true)
            if number is not None and value is not None:
                may = doubles.get(name.split(" [")[0])
                rows.append(_judged(line, key, name, (cell, number), (true, value), right.keys, digits, may))
            elif cell != true:
                differs.append(f"line {line}, {name}: {cell[:_LONG]!r} is given, and {true[:_LONG]!r} is right")
    if not rows:
        raise InputError("FILE", "none of its values is certified by any route: they are estimates", "certified values")
    wrong = bool(differs) or any("[" in row.marked for row in rows)
    summary = summary_of(rows, _look(wrong)) | {"order": _order(places, len(truth))}
    summary |= {"not_compared": left} if (left := [n for n in header if n in right.not_judged - _MARKS]) else {}
    summary |= {"differs": differs} if differs else {}
    summary |= {"estimates": unjudged} if unjudged else {}
    summary |= told_doubles(doubles, columns)
    return Comparison(tuple(rows), summary, certified, right.method)


def cells_so_far(
    given: Sequence[tuple[int, Sequence[str]]],
    header: Sequence[str],
    right: Cells,
    digits: int,
    doubles: Mapping[str, DoubleError] = MappingProxyType({}),
) -> Comparison | None:
    """The same for work that was cut short: the rows of which the right ones are there; None where none can be judged.

    >>> right = Cells(("k", "value"), (("1", "0.5"),), ("k",))
    >>> found = cells_so_far([(2, ("1", "0.5")), (3, ("2", "0.7"))], ("k", "value"), right, 12)
    >>> len(found.rows), found.summary["missing"], "order" in found.summary
    (1, 'lines 3 ... 3 (1 row)', False)
    """
    there = {_key(row, right.header, right.keys) for row in right.rows}
    done = [(line, row) for line, row in given if len(row) == len(header) and _key(row, header, right.keys) in there]
    if not done or all(_key(row, header, right.keys) in right.estimates for _, row in done):
        return None
    found = compared_cells(done, header, right, digits, doubles=doubles)
    summary = {name: value for name, value in found.summary.items() if name != "order"} | {"look": UNJUDGED.to_dict()}
    told = summary.get("estimates", ())
    return short_of(replace(found, summary=summary), [line for line, _ in given if line not in told])


def longest_of(given: Sequence[tuple[int, Sequence[str]]]) -> int:
    """The most digits that a decimal of the file has."""
    cells = (cell for _, row in given for cell in row if "." in cell and _number(cell) is not None)
    return max(map(significant, cells), default=0)


def _judged(
    line: int,
    key: Key,
    name: str,
    given: tuple[str, Fraction],
    right: tuple[str, Fraction],
    keys: Key,
    digits: int,
    may: DoubleError | None,
) -> ComparedValue:
    """One number.  Fractions and integers are right or wrong as a whole, however long they are."""
    text, number = given
    found = judged(text, number, right[1], digits, may)
    # An exact number has no digits that are nearly right.
    whole = "." not in text and "." not in right[0]
    marked = f"[{text}]" if whole and number != right[1] else found.marked
    # The parts are cut apart again at ", " (``ComparedValue.to_dict``): none may have it inside.
    told = ", ".join(part.replace(", ", " ") for part in key)
    names = ",".join(part or "what" for part in keys)
    return ComparedValue(line, told, name, text, right[0], found.digits, found.error, marked, names)


def _look(wrong: bool) -> Look:
    reason = "an export is judged value by value" if wrong else "every value is right to the digits written"
    return Look("undecided" if wrong else "rounding", reason)


def _order(places: Sequence[int], count: int) -> dict[str, int]:
    """Rows missing, doubled and out of order, by their places in what the request gives."""
    there = set(places)
    shuffled = sum(b < a for a, b in zip(places, places[1:]))
    return {"missing": count - len(there), "doubled": len(places) - len(there), "shuffled": shuffled}


def _key(row: Sequence[str], header: Sequence[str], keys: Key) -> Key:
    return tuple(same(row[header.index(name)].strip()) for name in keys)


def same(cell: str) -> str:
    """A number however it is written, or the text; a number of thousands of digits as it is written."""
    number = _number(cell)
    return cell if number is None or max(map(int.bit_length, number.as_integer_ratio())) > _LONGEST else str(number)


def _number(cell: str) -> Fraction | None:
    try:
        return parse_printed(cell, "cell")
    except InputError:
        return None
