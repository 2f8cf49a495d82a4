"""A finished sweep as one file: CSV, JSON or Parquet, in the order of the sweep, every cell as text, nothing rounded.

Results are flattened: ``points.1.x`` is the x of the second of ``points``.  The columns are the parameters, then what
the results hold in the order of their first appearance, then ``failed`` (the reason, or empty) and ``code`` (what
computed it, ``made_by.mark``).  Each format names the command and its parameters, CSV in the header of ``code``, so
that ``compare`` can ask again.  The file is the same for the same sweep, whatever order its points were finished in.
Parquet needs the extra parquet.

>>> flat({"x": "1/2", "points": [{"n": 0, "tau": None}], "certified": True})
{'x': '1/2', 'points.0.n': '0', 'points.0.tau': '', 'certified': 'true'}
>>> exact({"x": "0.25", "gauge": "averaging", "points.0.tau": ""})
{'x': Fraction(1, 4), 'gauge': 'averaging', 'points.0.tau': None}
"""

import csv
import io
import json
import shlex
import tempfile
from collections.abc import Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from importlib import import_module
from pathlib import Path
from typing import Any, BinaryIO

import numpy as np

from asymptotics import __version__
from asymptotics.errors import InputError
from asymptotics.made_by import made_by, mark
from asymptotics.numbers.exact import ExactReal, parse_real
from asymptotics.present.files import target_file
from asymptotics.sweeps.grid import Point
from asymptotics.sweeps.shard import verified
from asymptotics.sweeps.store import Store, place

FORMATS = (".csv", ".json", ".parquet")
LAST = ("failed", "code")
REQUEST = b"request"
"""Where the metadata of Parquet says it: sweep, the command and its parameters, as JSON."""
_CHUNK = 10_000  # rows in memory at a time

Exact = Fraction | ExactReal | str | None


def records(command: str, points: Sequence[Point], store: Store) -> Iterator[tuple[Point, dict[str, Any] | None]]:
    """(point, record) in the order of the sweep; None for a point that the store does not hold.

    Memory: nine bytes for each point, and one record at a time.
    """
    # First where each point lies, then one line after the other in the order of the sweep: the store has them in the
    # order in which they were finished.
    buckets, offsets = _index(command, points, store)
    streams: dict[int, BinaryIO] = {}
    try:
        for i, point in enumerate(points):
            if offsets[i] < 0:
                yield point, None
                continue
            bucket = int(buckets[i])
            if bucket not in streams:
                streams[bucket] = store.path(bucket).open("rb")
            stream = streams[bucket]
            stream.seek(int(offsets[i]))
            found = verified(stream.readline())
            yield point, None if found is None else json.loads(found[1])
    finally:
        for stream in streams.values():
            stream.close()


def _index(command: str, points: Sequence[Point], store: Store) -> tuple[np.ndarray, np.ndarray]:
    """The bucket of each point, and the offset of its line there (-1: it has none)."""
    size = len(points)
    buckets = np.fromiter((place(command, p)[0] for p in points), dtype=np.uint8, count=size)
    offsets = np.full(size, -1, dtype=np.int64)
    # One shard at a time is held as a mapping: 1/256 of the keys, more or less.
    for bucket in map(int, np.unique(buckets)):
        where = {key: offset for offset, key, _ in store.read(bucket)}
        for i in map(int, np.flatnonzero(buckets == bucket)):
            offsets[i] = where.get(place(command, points[i])[1], -1)
    return buckets, offsets


def export(path: Path, command: str, points: Sequence[Point], folder: Path) -> int:
    """Write the sweep to ``path`` (.csv, .json or .parquet), whole or not at all; returns the number of rows.

    InputError for another ending, a place that cannot be written, or Parquet without its extra.
    """
    require_format(path)
    store = Store(folder)
    temporary = None
    try:
        with tempfile.NamedTemporaryFile(dir=path.parent, prefix=".export.", delete=False) as stream:
            temporary = Path(stream.name)
            rows = _WRITERS[path.suffix](stream, command, points, store)
        # A temporary file is readable by its owner alone; the rename makes the export appear whole.
        temporary.chmod(0o644)
        temporary.replace(path)
        return rows
    except OSError as error:
        raise InputError("export", f"cannot write {path}: {error.strerror}", "a place that can be written") from error
    finally:
        if temporary is not None and temporary.exists():
            temporary.unlink()


def require_format(path: Path) -> None:
    """InputError unless the file can be written in the format of its ending."""
    if path.suffix not in FORMATS:
        raise InputError("export", f"{path.name} has no known ending", ", ".join(FORMATS))
    if path.suffix == ".parquet":
        parquet_module()
    target_file(path, "export")


def flat(data: Mapping[str, Any], prefix: str = "") -> dict[str, str]:
    """A nested result as one row of text."""
    row: dict[str, str] = {}
    for name, value in data.items():
        if isinstance(value, Mapping):
            row |= flat(value, f"{prefix}{name}.")
        elif isinstance(value, list):
            row |= flat({str(i): item for i, item in enumerate(value)}, f"{prefix}{name}.")
        else:
            row[prefix + name] = "" if value is None else str(value).lower() if isinstance(value, bool) else str(value)
    return row


def beside(point: Mapping[str, str], result: Mapping[str, str]) -> dict[str, str]:
    """A result beside its parameters: what is named as a flag, which has no value, is ``result.`` and that name.

    >>> beside({"alpha": "2", "bound": ""}, {"alpha": "2", "bound": "0.0003", "x": "1"})
    {'alpha': '2', 'result.bound': '0.0003', 'x': '1'}
    """
    return {f"result.{name}" if point.get(name) == "" else name: value for name, value in result.items()}


def rows_of(command: str, points: Sequence[Point], store: Store) -> Iterator[dict[str, str]]:
    """The rows of the file, as text."""
    for point, record in records(command, points, store):
        found = record or {"failed": "not in the store"}
        yield {
            **beside(point, flat(found.get("result", {}))),
            **point,
            "failed": found.get("failed", ""),
            "code": mark(),
        }


def columns_of(points: Sequence[Point], rows: Iterable[Mapping[str, str]]) -> list[str]:
    """The names of all columns, which take a pass of their own, since results may differ in what they hold."""
    parameters = dict.fromkeys(name for point in points for name in point)
    results = dict.fromkeys(name for row in rows for name in row)
    return [*parameters, *(name for name in results if name not in {*parameters, *LAST}), *LAST]


def _request(command: str, points: Sequence[Point]) -> list[str]:
    return ["sweep", command, *dict.fromkeys(name for point in points for name in point)]


def _write_csv(stream: Any, command: str, points: Sequence[Point], store: Store) -> int:
    text = io.TextIOWrapper(stream, encoding="utf-8", newline="")
    # Two passes over the store: the columns are known only when every row was seen, and no row is kept meanwhile.
    names = columns_of(points, rows_of(command, points, store))
    writer = csv.DictWriter(text, names, restval="", lineterminator="\n")
    said = f"{LAST[-1]} [{shlex.join(_request(command, points))}]"  # of which request each row is the answer
    csv.writer(text, lineterminator="\n").writerow([*names[:-1], said])
    writer.writerows(rows_of(command, points, store))
    # Or the wrapper would close the stream under the one who has opened it.
    text.detach()
    return len(points)


def _write_json(stream: Any, command: str, points: Sequence[Point], store: Store) -> int:
    head = json.dumps({"command": command, "version": __version__, "made_by": made_by()})
    stream.write((head[:-1] + ', "rows": [').encode())
    for i, (point, record) in enumerate(records(command, points, store)):
        found = record or {"failed": "not in the store"}
        row = {"point": point, "result": found.get("result"), "failed": found.get("failed")}
        stream.write((("," if i else "") + "\n" + json.dumps(row, ensure_ascii=False)).encode())
    stream.write(b"\n]}\n")
    return len(points)


def _write_parquet(stream: Any, command: str, points: Sequence[Point], store: Store) -> int:
    arrow, parquet = parquet_module()
    columns = columns_of(points, rows_of(command, points, store))
    metadata = {"made_by": json.dumps(made_by()), REQUEST: json.dumps(_request(command, points))}
    schema = arrow.schema([(name, arrow.string()) for name in columns], metadata=metadata)
    with parquet.ParquetWriter(stream, schema) as writer:
        chunk: list[dict[str, str]] = []
        for row in rows_of(command, points, store):
            chunk.append({name: row.get(name, "") for name in columns})
            if len(chunk) == _CHUNK:
                writer.write_table(arrow.Table.from_pylist(chunk, schema=schema))
                chunk = []
        writer.write_table(arrow.Table.from_pylist(chunk, schema=schema))
    return len(points)


_WRITERS = {".csv": _write_csv, ".json": _write_json, ".parquet": _write_parquet}


def parquet_module(argument: str = "export") -> tuple[Any, Any]:
    """pyarrow and its Parquet; InputError of this argument without the extra."""
    try:
        return import_module("pyarrow"), import_module("pyarrow.parquet")  # an extra, and slow to import
    except ModuleNotFoundError as error:  # any other ImportError is a fault, or want of memory
        accepted = "an installation with the extra parquet: pip install '.[parquet]' in a clone"
        raise InputError(argument, "Parquet needs pyarrow, which is not installed", accepted) from error


def read_rows(path: Path) -> Iterator[dict[str, Exact]]:
    """The rows of an exported CSV or Parquet file with exact values: Fractions (or roots), None where a cell is empty.

    InputError for another ending or a file that cannot be read.
    """
    try:
        if path.suffix == ".csv":
            with path.open(newline="", encoding="utf-8") as stream:
                reader = csv.DictReader(stream)
                reader.fieldnames = [
                    name.split(" [")[0] if name.startswith("code [") else name for name in reader.fieldnames or ()
                ]
                yield from map(exact, reader)
            return
        if path.suffix == ".parquet":
            with parquet_module()[1].ParquetFile(path) as file:
                for chunk in file.iter_batches(_CHUNK):
                    yield from map(exact, chunk.to_pylist())
            return
    except (OSError, ValueError) as error:
        reason = f"cannot read {path}: {' '.join(str(error).split())[:120]}"
        raise InputError("file", reason, "an exported file") from error
    raise InputError("file", f"{path.name} has no known ending", ".csv or .parquet")


def exact(row: Mapping[str, str]) -> dict[str, Exact]:
    """A row of text with its numbers as Fractions (roots as ExactReal); other text stays, empty cells are None."""
    return {name: _exact(cell) for name, cell in row.items()}


def _exact(cell: str) -> Exact:
    if cell == "":
        return None
    try:
        value = parse_real(cell, "cell")
    except InputError:
        return cell
    # Text that is no number (a gauge, a reason) stays text: a column may hold both.
    return value.rational if value.is_rational else value
