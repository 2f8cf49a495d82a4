"""An exported file beside its own request, made again at more digits: the header says which request that was.

The words of the header reach nothing but the parser of a command from a fixed list, and options from a fixed list.
What no route certifies is not judged: a motion of a sweep is held against the certified motion instead.
"""

import argparse
import csv
import tempfile
from importlib import import_module
from pathlib import Path
from typing import Any

from asymptotics.cli.requests import stated_request
from asymptotics.cli.swept import EXCLUDED, SWEPT, point_options, run_point, takes_no_value, typed_options
from asymptotics.comparison.cells import Cells, compared_cells, longest_of, same
from asymptotics.comparison.reading import rows_of_file
from asymptotics.comparison.run import GUARD, LEAST_DIGITS, Comparison
from asymptotics.cut_short import changed
from asymptotics.errors import InputError, shown
from asymptotics.present.inputs import stated_words
from asymptotics.sweeps.export import flat
from asymptotics.sweeps.grid import Point

_KEYS = ("part", "series", "k", "quantity", "n", "i")
_APART = frozenset(("remark", "bound of zeta", "low", "high"))
_TOLD = frozenset((  # parts of a sweep's results that are bounds, provenance or pictures of numbers
    "latex", "method", "route", "error", "tail", "radius", "digits", "terms", "notes", "enclosures", "certified",
    "low", "high", "units", "x_unit", "what", "files", "gauge", "order", "stable",
))  # fmt: skip
_HIGHEST = {"damping": 100, "stokes": 100, "limit-cycle": 200}
_MOST = 1000
_CERTIFIED = ("exact", "certified")
_EXACT_COMMANDS = ("smith", "moment")  # rational arithmetic; a quotient of Gamma functions in balls
_SERIES = "order "


def asked_again(path: Path) -> bool:
    """Whether the header of a file names its whole request."""
    words = stated_words(path)
    return bool(words) and not words[0].startswith("--") and "=" not in words[0] and len(words) > 1


def is_motion(path: Path) -> bool:
    """Whether its columns are times and places: the certified motion stands beside those, for any spring and start."""
    head = rows_of_file(path)[1] or [""]
    return head[0].split(" [")[0] in ("t", "tau") and any(name.split(" [")[0] == "x" for name in head)


def compare_again(path: Path, digits: int | None) -> Comparison:
    """The file beside its request at ``digits`` (by default four more than its longest value has)."""
    with changed(lambda _: None):  # rows of the request that are done are no rows of a comparison
        return _compared(path, digits)


def _compared(path: Path, digits: int | None) -> Comparison:
    words, (given, head) = stated_words(path), rows_of_file(path)
    if not given or head is None:
        raise InputError("FILE", f"{path} has no rows of values", "a CSV file with a header")
    header = [name.split(" [")[0] if name.startswith("code [") else name for name in head]
    rows = [(line, cells) for line, cells in given]
    wanted = digits or max(LEAST_DIGITS, GUARD + longest_of([(n, cells[:-1]) for n, cells in rows]))
    if words[0] == "sweep":
        command, names = _swept_names(words, header)
        wanted = min(wanted, _HIGHEST.get(command, _MOST))
        return compared_cells(rows, header, _of_sweep(command, names, header, rows, wanted), wanted)
    command, point = stated_request(words)
    wanted = min(wanted, _HIGHEST.get(command, _MOST))
    return compared_cells(rows, header, _of_command(command, point, wanted), wanted)


def told_request(path: Path) -> str:
    """The request of a file, as it stands in its header."""
    return " ".join(word or "''" for word in stated_words(path))[:300]


def _of_command(command: str, point: Point, digits: int) -> Cells:
    """The file that the command writes when it is asked again."""
    more = point if command == "smith" else {**point, "digits": str(digits)}
    options = typed_options(command, more)
    with tempfile.TemporaryDirectory() as folder:
        options.csv = str(Path(folder) / "again.csv")
        data = _answered(command, options)
        with Path(options.csv).open(newline="", encoding="utf-8") as stream:
            head, *rows = csv.reader(stream)
    header = (*head[:-1], "code")
    known = (*_KEYS, "amplitude") if command == "damping" else _KEYS
    keys = tuple(name for name in header if name.split(" [")[0] in known)
    apart = (_APART & set(header)) | {"code"}
    cells = [tuple(row) for row in rows]
    if command == "damping":
        cells = _damping_of_the_motion(cells, *map(header.index, keys))
    if not _is_certified(command, data):
        raise InputError("FILE", "no route certifies what its request gives: estimates", "a file of certified values")
    return Cells(header, tuple(cells), keys, frozenset(apart), method=f"{command} again, at {digits} digits")


def _answered(command: str, options: argparse.Namespace) -> dict[str, Any]:
    data: dict[str, Any] = import_module("asymptotics.cli." + command.replace("-", "_")).run(options).data
    return data


def _damping_of_the_motion(rows: list[tuple[str, ...]], part: int, amplitude: int) -> list[tuple[str, ...]]:
    """The rows of a series of order N hold what its bound leaves: right is the motion itself at that amplitude."""
    own = {row[amplitude]: row for row in rows if row[part] == "the motion itself"}
    return [
        (*own[row[amplitude]][:part], row[part], *own[row[amplitude]][part + 1 :])
        if row[part].startswith(_SERIES) and row[amplitude] in own
        else row
        for row in rows
    ]


def _swept_names(words: list[str], header: list[str]) -> tuple[str, list[str]]:
    """The command of a sweep and its parameters; InputError, by name, for any other word."""
    command, names = words[1], words[2:]
    if command not in SWEPT:
        raise InputError("FILE", f"its header names no command that is swept: {shown(command)}", ", ".join(SWEPT))
    for name in names:
        if name not in header or name.partition(".")[0] in EXCLUDED:
            raise InputError("FILE", f"its header names {shown(name)}, no parameter of it", "the columns of parameters")
    return command, names


def _of_sweep(
    command: str, names: list[str], header: list[str], given: list[tuple[int, list[str]]], digits: int
) -> Cells:
    """Each row again, at its own parameters; a row that failed, or that no route certifies, holds estimates."""
    motion = command == "motion"
    kept = {"x", "v"} if motion else set(header)
    apart = {n for n in header if n not in names and (n not in kept or set(n.split(".")) & _TOLD or n == "failed")}
    apart |= {"code"}
    found, unsure = list[tuple[str, ...]](), set[tuple[str, ...]]()
    for line, cells in given:
        if len(cells) != len(header):
            raise InputError("FILE", f"line {line} has {len(cells)} cells", f"{len(header)} cells in each row")
        row = dict(zip(header, cells))
        key = tuple(same(row[name].strip()) for name in names)
        certified = not row.get("failed")
        result: dict[str, str] = {}
        if certified:
            data = run_point(command, _again(command, {name: row[name] for name in names}, digits))
            certified, result = _is_certified(command, data), flat(data)
        if not certified:
            unsure.add(key)
        found.append(tuple(row[name] if name in names else result.get(name, "") for name in header))
    route = "the certified motion at each row" if motion else f"{command} again at each row, at {digits} digits"
    return Cells(tuple(header), tuple(found), tuple(names), frozenset(apart), frozenset(unsure), route)


def _again(command: str, row: dict[str, str], digits: int) -> Point:
    """The point of a row: flags stand in empty cells, numbers are proved to be such."""
    flags = {name: "" for name in row if name and takes_no_value(command, name.partition(".")[0])}
    point = {**point_options(command, {name: cell for name, cell in row.items() if name not in flags}), **flags}
    if command == "motion":
        point = {name: value for name, value in point.items() if name not in ("order", "gauge", "best-order")}
        point["reference"] = ""
    if command == "smith" and point.get("") in ("f", "c", "g"):
        return point
    return {**point, "digits": str(digits)}


def _is_certified(command: str, data: dict[str, Any]) -> bool:
    """What the answer itself says; exact arithmetic is."""
    said = data.get("certified")
    return said is True or (said is None and (data.get("arithmetic") in _CERTIFIED or command in _EXACT_COMMANDS))
