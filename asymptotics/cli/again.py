"""An exported file beside its own request, made again at more digits: the header says which request that was.

The words of the header reach nothing but the parser of a command from a fixed list, and options from a fixed list.
"""

import argparse
import csv
import tempfile
from pathlib import Path
from typing import Any

from asymptotics.cli.again_envelope import compared_envelope
from asymptotics.cli.again_law import compared_law
from asymptotics.cli.again_swept import compared_sweep, is_certified, swept_names
from asymptotics.cli.commands import module_of
from asymptotics.cli.requests import stated_request
from asymptotics.cli.swept import typed_options
from asymptotics.comparison.cells import Cells, compared_cells, longest_of
from asymptotics.comparison.reading import rows_of_file
from asymptotics.comparison.run import GUARD, LEAST_DIGITS, Comparison
from asymptotics.cut_short import changed
from asymptotics.errors import InputError
from asymptotics.present.double_errors import stated_errors
from asymptotics.present.inputs import stated_words
from asymptotics.sweeps.exported import SUFFIXES, read_exported
from asymptotics.sweeps.grid import Point

_KEYS = ("part", "series", "k", "quantity", "n", "i")
_APART = frozenset(("remark", "bound of zeta log", "low", "high"))
_MOST = 1000
_SERIES = "order "


def asked_again(path: Path) -> bool:
    """Whether a file names its whole request: in its header, or as the JSON or Parquet of a sweep."""
    if path.suffix in SUFFIXES:
        return True
    words = stated_words(path)
    # A request begins with the name of a command, not with an option (the header of an oscillator) or name=value.
    return bool(words) and not words[0].startswith("--") and "=" not in words[0] and len(words) > 1


def is_motion(path: Path) -> bool:
    """Whether its columns are times and places: the certified motion stands beside those, for any spring and start."""
    head = rows_of_file(path)[1] or [""]
    return head[0].split(" [")[0] in ("t", "tau") and any(name.split(" [")[0] == "x" for name in head)


def compare_again(path: Path, digits: int | None) -> Comparison:
    """The file beside its request at ``digits`` (by default four more than its longest value has).

    Of a sweep and an envelope the rows that are done are kept when the work is cut short.
    """
    words, header, rows = _read(path)
    if not rows:
        raise InputError("FILE", f"{path} has no rows of values", "a CSV file with a header")
    wanted = digits or max(LEAST_DIGITS, GUARD + longest_of([(n, cells[:-1]) for n, cells in rows]))
    if words[0] == "sweep":
        command, names = swept_names(words, header)
        wanted = min(wanted, _most_digits(command))
        return compared_sweep(command, names, header, rows, wanted)
    command, point = stated_request(words)
    if command == "damping-law":
        return compared_law(point, header, rows)
    wanted = min(wanted, _most_digits(command))
    if command == "envelope":
        return compared_envelope(point, header, rows, wanted, stated_errors(path))
    # The commands below compute their whole answer first, and compare it afterwards.
    with changed(lambda _: None):  # rows of the request that are done are no rows of a comparison
        return compared_cells(rows, header, _of_command(command, point, wanted), wanted)


def told_request(path: Path) -> str:
    """The request of a file, as it stands there."""
    words = read_exported(path).words if path.suffix in SUFFIXES else stated_words(path)
    return " ".join(word or "''" for word in words)[:300]


def _read(path: Path) -> tuple[list[str], list[str], list[tuple[int, list[str]]]]:
    """The words of the request, the names of the columns, and the rows with their lines."""
    if path.suffix in SUFFIXES:
        found = read_exported(path)
        return found.words, found.header, found.rows
    rows, head = rows_of_file(path)
    header = [name.split(" [")[0] if name.startswith("code [") else name for name in head or []]
    return stated_words(path), header, rows if header else []


def _most_digits(command: str) -> int:
    """The highest --digits of a command."""
    asked = getattr(module_of(command), "question", None)
    return _MOST if asked is None else int(asked["digits"].kind.schema["maximum"])


def _of_command(command: str, point: Point, digits: int) -> Cells:
    """The file that the command writes when it is asked again."""
    more = point if command == "smith" else {**point, "digits": str(digits)}
    options = typed_options(command, more)
    # By way of a file, since what is to be compared is what the command writes: columns, units, order, marks.
    with tempfile.TemporaryDirectory() as folder:
        options.csv = str(Path(folder) / "again.csv")
        data = _answered(command, options)
        with Path(options.csv).open(newline="", encoding="utf-8") as stream:
            head, *rows = csv.reader(stream)
    header = (*head[:-1], "code")
    # Amplitudes are what a row of ``damping`` is found by, and a value to be judged in other files.
    known = (*_KEYS, "amplitude") if command == "damping" else _KEYS
    keys = tuple(name for name in header if name.split(" [")[0] in known)
    # Bounds, ends of intervals and remarks depend on the digits: they are no values to be right or wrong.
    apart = (_APART & set(header)) | {"code"}
    cells = [tuple(row) for row in rows]
    if command == "damping":
        cells = _damping_of_the_motion(cells, *map(header.index, keys))
    if not is_certified(command, data):
        raise InputError("FILE", "no route certifies what its request gives: estimates", "a file of certified values")
    return Cells(header, tuple(cells), keys, frozenset(apart), method=f"{command} again, at {digits} digits")


def _answered(command: str, options: argparse.Namespace) -> dict[str, Any]:
    data: dict[str, Any] = module_of(command).run(options).data
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
