"""An exported sweep read back as text: the request of its rows, the columns, and each row with its line.

JSON and Parquet say what CSV says in its header: the command that was swept, and which columns are its parameters.
Every cell is text and reaches nothing from here; what is no such file is refused by name, a bad row by its line.

>>> import tempfile
>>> path = Path(tempfile.mkdtemp()) / "moments.json"
>>> head, row = '{"command": "moment", "rows": [', '{"point": {"p": "1"}, "result": {"p": "1", "value": "0.6366"}}'
>>> _ = path.write_text(head + chr(10) + row + chr(10) + "]}")
>>> found = read_exported(path)
>>> found.words, found.header, found.rows
(['sweep', 'moment', 'p'], ['p', 'value', 'failed', 'code'], [(2, ['1', '0.6366', '', ''])])
"""

import json
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from asymptotics.errors import InputError, LimitError, shown
from asymptotics.sweeps.export import LAST, REQUEST, columns_of, flat, parquet_module

SUFFIXES = (".json", ".parquet")
MAX_ROWS = 1_000_000
_ROWS = re.compile(r'"rows"\s*:\s*\[')
# Between two rows: the text has been read as JSON, so that nothing else can stand there.
_BETWEEN = re.compile(r"[\s,]*")
_ACCEPTED = "what asymptotics sweep ... --export has written"


@dataclass(frozen=True)
class Exported:
    """``words``: sweep, the command, its parameters; ``rows``: (line, cells) in the order of ``header``.

    Lines are those of a JSON file; of Parquet, which has none, the numbers of the rows from 1.
    """

    words: list[str]
    header: list[str]
    rows: list[tuple[int, list[str]]]


def read_exported(path: Path) -> Exported:
    """The file of a sweep in JSON or Parquet; InputError for any other, LimitError for too many rows."""
    try:
        return _of_parquet(path) if path.suffix == ".parquet" else _of_json(path)
    except OSError as error:
        raise _refused(f"cannot read {path}: {error.strerror or ' '.join(str(error).split())[:120]}") from error
    except RecursionError as error:
        raise _refused(f"{path} is nested too deeply") from error


def _of_json(path: Path) -> Exported:
    try:
        text = path.read_text(encoding="utf-8")
        data = json.loads(text)
    except ValueError as error:
        raise _refused(f"{path} is not JSON") from error
    command = data.get("command") if isinstance(data, dict) else None
    # The rows are found a second time in the text, for their lines; a file with another list of that name before it is
    # noticed by the count, and refused.
    start = _ROWS.search(text)
    if not isinstance(command, str) or not isinstance(data.get("rows"), list) or start is None:
        answer = isinstance(command, str) and isinstance(data.get("version"), str)
        what = f"is the answer of asymptotics {command} --json" if answer else "is no export of a sweep"
        raise _refused(f"{path} {what}")
    _require_few(len(data["rows"]))
    points, results, lines = list[dict[str, str]](), list[dict[str, str]](), list[int]()
    for line, row in _lines(text, start.end()):
        point, result = (row.get(name) or {} for name in ("point", "result")) if isinstance(row, dict) else (None, None)
        if not isinstance(point, dict) or not isinstance(result, dict) or not all(map(_is_text, point.values())):
            raise _refused(f"line {line} has no point and result")
        points.append(point)
        # Parameters over results of the same name, as the export has them: the request is what was typed.
        results.append({**flat(result), **point, LAST[0]: str(row.get("failed") or "")})
        lines.append(line)
    if len(lines) != len(data["rows"]):
        raise _refused(f"{path} has other lists of rows")
    parameters, header = dict.fromkeys(name for point in points for name in point), columns_of(points, results)
    rows = [(line, [row.get(name, "") for name in header]) for line, row in zip(lines, results)]
    return Exported(["sweep", command, *parameters], header, rows)


def _is_text(value: Any) -> bool:
    return isinstance(value, str)


def _lines(text: str, place: int) -> Iterator[tuple[int, Any]]:
    """Each row of the list that begins at ``place`` of a JSON text, with the line on which it begins."""
    decoder, line, counted = json.JSONDecoder(), 1, 0
    place = _after(text, place)
    while text[place] != "]":
        # Each stretch of text is counted once, or a file of many rows would take the square of its length.
        line, counted = line + text.count("\n", counted, place), place
        row, place = decoder.raw_decode(text, place)
        yield line, row
        place = _after(text, place)


def _after(text: str, place: int) -> int:
    between = _BETWEEN.match(text, place)
    return place if between is None else between.end()


def _of_parquet(path: Path) -> Exported:
    parquet = parquet_module("FILE")[1]
    try:
        with parquet.ParquetFile(path) as file:
            said = _request(file.schema_arrow.metadata or {})
            _require_few(file.metadata.num_rows)
            header = list(file.schema_arrow.names)
            rows = [row for chunk in file.iter_batches() for row in chunk.to_pylist()]
    # What pyarrow raises for damaged and hostile files; InputError is a ValueError, and passes as it is.
    except (ValueError, KeyError, NotImplementedError, MemoryError) as error:
        if isinstance(error, InputError | LimitError):
            raise
        raise _refused(f"{path} is not Parquet: {' '.join(str(error).split())[:120]}") from error
    for number, row in enumerate(rows, start=1):
        if not all(map(_is_text, row.values())):
            raise _refused(f"row {number} has a cell that is no text")
    return Exported(said, header, [(i, [row[name] for name in header]) for i, row in enumerate(rows, start=1)])


def _request(metadata: Mapping[bytes, bytes]) -> list[str]:
    """The words of the request in the metadata of the schema."""
    try:
        said = json.loads(metadata[REQUEST])
    except (KeyError, ValueError) as error:
        raise _refused("its metadata does not name the request (an older export)") from error
    if not isinstance(said, list) or not all(map(_is_text, said)) or said[:1] != ["sweep"] or len(said) < 2:
        raise _refused(f"its metadata says {shown(said)}, which is no request of a sweep")
    return said


def _require_few(count: int) -> None:
    if count > MAX_ROWS:
        raise LimitError("FILE", f"{count} rows are too many", f"at most {MAX_ROWS} in one comparison")


def _refused(reason: str) -> InputError:
    return InputError("FILE", reason, _ACCEPTED)
