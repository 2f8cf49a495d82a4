"""A file of one's own beside its own request, asked again at more digits: the header says which request that was.

The words of the header reach nothing but the options of a question that a header may have (``typed``).  What no route
certifies is not judged; of a sweep each row is asked again, and the rows that are done are kept.

>>> rows = [(2, ["2", "0.50000", "1/2", "", ""])]
>>> found = sweep_again("moment", ["p"], ["p", "value", "exact", "failed", "code"], rows, 12)
>>> [(row.key, row.column, row.marked, row.certified) for row in found.rows]
[('2', 'value', '0.50000', '0.500000000000'), ('2', 'exact', '1/2', '1/2')]
"""

import csv
import io
from dataclasses import replace
from pathlib import Path
from typing import Any

from asymptotics.ask.answers import Again
from asymptotics.ask.axes import point_options, takes_no_value
from asymptotics.ask.question import Question
from asymptotics.ask.registry import SWEPT, loaded
from asymptotics.ask.typed import Answered, answered, stated_request
from asymptotics.decays.comparison.cells import Cells, cells_so_far, compared_cells, longest_of, same
from asymptotics.decays.comparison.reading import rows_of_file
from asymptotics.decays.comparison.run import GUARD, LEAST_DIGITS, Comparison
from asymptotics.errors import InputError, shown
from asymptotics.numbers.double_words import stated_errors
from asymptotics.present.counts import many
from asymptotics.present.inputs import stated_words
from asymptotics.running.cut_short import changed
from asymptotics.sweeps.export import flat
from asymptotics.sweeps.exported import SUFFIXES, read_exported

Rows = list[tuple[int, list[str]]]
_TOLD = frozenset((  # parts of a sweep's results that are bounds, provenance or pictures of numbers
    "latex", "method", "route", "error", "tail", "radius", "digits", "terms", "notes", "enclosures", "certified",
    "low", "high", "units", "x_unit", "what", "files", "gauge", "order", "stable",
))  # fmt: skip


def names_its_request(path: Path) -> bool:
    """Whether a file names its whole request: in its header, or as the JSON or Parquet of a sweep."""
    if path.suffix in SUFFIXES:
        return True
    words = stated_words(path)
    # A request begins with the name of a command, not with an option (the header of an oscillator) or name=value.
    return bool(words) and not words[0].startswith("--") and "=" not in words[0] and len(words) > 1


def told_request(path: Path) -> str:
    """The request of a file, as it stands there."""
    words = read_exported(path).words if path.suffix in SUFFIXES else stated_words(path)
    return " ".join(word or "''" for word in words)[:300]


def compare_again(path: Path, digits: int | None) -> Comparison:
    """The file beside its request at ``digits`` (by default four more than its longest value has)."""
    words, header, rows = _read(path)
    if not rows:
        raise InputError("FILE", f"{path} has no rows of values", "a CSV file with a header")
    wanted = digits or max(LEAST_DIGITS, GUARD + longest_of([(n, cells[:-1]) for n, cells in rows]))
    if words[0] == "sweep":
        command, names = _swept_names(words, header)
        return sweep_again(command, names, header, rows, min(wanted, _most_digits(loaded(command), wanted)))
    command, point = stated_request(words)
    asked = loaded(command)
    again = asked.offers.again or Again()
    wanted = min(wanted, _most_digits(asked, wanted))
    if again.compared is not None:
        own: Comparison = again.compared(point, header, rows, wanted, stated_errors(path))
        return own
    # The whole answer is computed first, and compared afterwards.
    with changed(lambda _: None):  # rows of the request that are done are no rows of a comparison
        answer = answered(asked.name, again.at(point, wanted), file=True)
        found = compared_cells(rows, header, _cells_again(answer, again, wanted), wanted)
        return replace(found, side=answer.found)


def _read(path: Path) -> tuple[list[str], list[str], Rows]:
    """The words of the request, the names of the columns, and the rows with their lines."""
    if path.suffix in SUFFIXES:
        found = read_exported(path)
        return found.words, found.header, found.rows
    rows, head = rows_of_file(path)
    header = [name.split(" [")[0] if name.startswith("code [") else name for name in head or []]
    return stated_words(path), header, rows if header else []


def _most_digits(asked: Question, otherwise: int) -> int:
    """The highest --digits of a command that has them."""
    known = [a for a in asked.asked if a.name == "digits"]
    return int(known[0].kind.schema["maximum"]) if known else otherwise


def _cells_again(answer: Answered, again: Again, digits: int) -> Cells:
    """The table that the command writes when it is asked again."""
    head, *rows = csv.reader(io.StringIO(answer.csv))
    header = (*head[:-1], "code")
    keys = tuple(name for name in header if name.split(" [")[0] in again.keys)
    if not answer.certified:
        raise InputError("FILE", "no route certifies what its request gives: estimates", "a file of certified values")
    cells = again.rows([tuple(row) for row in rows], header)
    not_judged = frozenset((again.not_judged & set(header)) | {"code"})
    return Cells(header, tuple(cells), keys, not_judged, method=f"{answer.question.name} again, at {digits} digits")


def _swept_names(words: list[str], header: list[str]) -> tuple[str, list[str]]:
    """The command of a sweep and its parameters; InputError, by name, for any other word."""
    command, names = words[1], words[2:]
    if command not in SWEPT:
        raise InputError("FILE", f"its header names no command that is swept: {shown(command)}", ", ".join(SWEPT))
    known = {"" if o.place else o.name for a in loaded(command).asked for o in a.options}
    for name in names:
        if name not in header or name.partition(".")[0] not in known:
            raise InputError("FILE", f"its header names {shown(name)}, no parameter of it", "the columns of parameters")
    return command, names


def sweep_again(command: str, names: list[str], header: list[str], rows: Rows, digits: int) -> Comparison:
    """Each row again; a row that failed, or that no route certifies, holds estimates.

    An error that cuts the work short carries the rows that are done.
    """
    again = loaded(command).offers.again or Again()
    kept = set(again.judged or header)
    not_judged = {n for n in header if n not in names and (n not in kept or set(n.split(".")) & _TOLD or n == "failed")}
    not_judged |= {"code"}
    route = again.route or f"{command} again at each row, at {digits} digits"
    found, unsure = list[tuple[str, ...]](), set[tuple[str, ...]]()

    def right() -> Cells:
        return Cells(tuple(header), tuple(found), tuple(names), frozenset(not_judged), frozenset(unsure), route)

    def so_far() -> Comparison | None:
        return cells_so_far(rows, header, right(), digits)

    with changed(lambda _: so_far(), otherwise=so_far):  # what is done of one row is no row of the comparison
        for line, cells in rows:
            if len(cells) != len(header):
                raise InputError(
                    "FILE", f"line {line} has {many(len(cells), 'cell')}", f"{many(len(header), 'cell')} in each row"
                )
            row = dict(zip(header, cells))
            # A row that failed then may succeed now, for want of time or memory: there is nothing in it to judge.
            given = {name: row[name] for name in names}
            result = _row_again(command, again, given, digits) if not row.get("failed") else None
            if result is None:
                unsure.add(tuple(same(row[name].strip()) for name in names))
            found.append(tuple(row[name] if name in names else (result or {}).get(name, "") for name in header))
    return compared_cells(rows, header, right(), digits)


def _row_again(command: str, again: Again, row: dict[str, str], digits: int) -> dict[str, Any] | None:
    """What the command says at the parameters of a row, flat; None where that is not certified."""
    # Flags stand in empty cells; numbers are proved to be such.
    flags = {name: "" for name in row if name and takes_no_value(command, name.partition(".")[0])}
    point = {**point_options(command, {name: cell for name, cell in row.items() if name not in flags}), **flags}
    answer = answered(command, again.at(point, digits))
    return flat(answer.data) if answer.certified else None
