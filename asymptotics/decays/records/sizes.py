"""What a file claims to hold, asked before it is read: a packed file of a few kilobytes may claim more than any memory.

A sheet holds all cells of the rectangle to its farthest one, an array what its header says.  LimitError above the
limits, which are refusals of files that no experiment writes; what is damaged is told by whoever reads it.

>>> import tempfile
>>> path = Path(tempfile.mkdtemp()) / "sheet.xlsx"
>>> with zipfile.ZipFile(path, "w") as book:
...     book.writestr("xl/worksheets/sheet1.xml", '<row r="1"><c r="A1"/></row><row r="9"><c r="AB9"/></row>')
>>> cells_of_sheet(path)
252
"""

import io
import re
import struct
import zipfile
import zlib
from collections.abc import Iterable, Iterator
from math import prod
from pathlib import Path
from typing import IO, Any
from xml.etree import ElementTree

import numpy as np

from asymptotics.decays.records.text import MAX_BYTES
from asymptotics.errors import LimitError

MAX_CELLS = 20_000_000
"""A sheet is held as Python objects, tens of bytes a cell: beyond this it would take the memory of a small machine."""
MAX_VALUES = 100_000_000
"""Numbers of all arrays of a file together, 0.8 GB as doubles: as many as a text file of the largest size holds."""
_PLACE = re.compile(rb"""\br=["']([A-Z]{0,3})([0-9]{1,9})["']""")
_CHUNK, _OVERLAP = 1 << 20, 64  # bytes of a sheet in memory, and those that are looked at twice: a place is shorter
_TABLE = "{urn:oasis:names:tc:opendocument:xmlns:table:1.0}"


def require_few_values(shapes: Iterable[tuple[int, ...]], name: str) -> None:
    """LimitError if arrays of these shapes hold more than ``MAX_VALUES`` together."""
    count = sum(prod(map(int, shape)) for shape in shapes)
    if count > MAX_VALUES:
        raise LimitError("FILE", f"{name} claims {count:.3g} values", f"at most {MAX_VALUES}")


def require_small_sheet(path: Path) -> None:
    """LimitError for a spreadsheet with too many cells or bytes; an old one (OLE) has at most 65536 rows of 256."""
    cells = cells_of_sheet(path) if zipfile.is_zipfile(path) else 0
    if cells > MAX_CELLS:
        accepted = f"at most {MAX_CELLS}: without what stands far from the table, or the table as CSV"
        raise LimitError("FILE", f"{path.name} has a sheet of {cells} cells, empty ones between its farthest", accepted)


def cells_of_sheet(path: Path) -> int:
    """The cells of the largest sheet, from the places that stand in it, without building it."""
    with zipfile.ZipFile(path) as archive:
        if sum(member.file_size for member in archive.infolist()) > MAX_BYTES:
            raise LimitError(
                "FILE", f"{path.name} unpacks to more than {MAX_BYTES} bytes", f"at most {MAX_BYTES} bytes"
            )
        names = archive.namelist()
        if "content.xml" in names:  # OpenDocument
            with archive.open("content.xml") as stream:
                return _repeated(stream)
        sheets = [name for name in names if name.startswith("xl/worksheets/") and name.endswith(".xml")]
        return max((_rectangle(archive, name) for name in sheets), default=0)


def _rectangle(archive: zipfile.ZipFile, name: str) -> int:
    """Rows times columns of a sheet of Excel: where each row and cell stands is written beside it."""
    rows = columns = 0
    with archive.open(name) as stream:
        before = b""
        while chunk := stream.read(_CHUNK):
            for letters, number in _PLACE.findall(before + chunk):
                rows, columns = max(rows, int(number)), max(columns, _column(letters))
            before = chunk[-_OVERLAP:]
    return rows * max(columns, 1)


def _column(letters: bytes) -> int:
    """A is 1, Z is 26, AA is 27."""
    found = 0
    for letter in letters:
        found = 26 * found + letter - 64
    return found


def _repeated(stream: IO[bytes]) -> int:
    """The same of OpenDocument, where empty and equal rows and cells are written once, with their number."""
    rows = waiting = columns = most = 0
    for _, node in ElementTree.iterparse(stream):
        if node.tag == _TABLE + "table-row":
            filled = _filled(node)
            waiting += _times(node, "rows")
            # Empty rows and cells count only where something stands behind them: every sheet ends with a million.
            rows, waiting = (rows + waiting, 0) if filled else (rows, waiting)
            columns = max(columns, filled)
            node.clear()
        elif node.tag == _TABLE + "table":
            most = max(most, rows * columns)
            rows = waiting = columns = 0
    return most


def _filled(row: ElementTree.Element) -> int:
    """The cells of a row up to the last that holds something."""
    count = last = 0
    for cell in row:
        count += _times(cell, "columns")
        last = count if len(cell) else last
    return last


def _times(node: ElementTree.Element, what: str) -> int:
    text = node.get(f"{_TABLE}number-{what}-repeated", "1")
    return int(text) if text.isascii() and text.isdigit() else 1


def require_small_arrays(path: Path) -> None:
    """LimitError for an npy or npz file whose headers claim too much; ValueError or BadZipFile for a damaged one."""
    if path.suffix.lower() == ".npy":
        with path.open("rb") as stream:
            require_few_values([_shape(stream)], path.name)
        return
    with zipfile.ZipFile(path) as archive:
        require_few_values(list(_shapes(archive)), path.name)


def _shapes(archive: zipfile.ZipFile) -> Iterator[tuple[int, ...]]:
    for member in archive.infolist():
        if member.filename.endswith(".npy"):
            with archive.open(member) as stream:
                yield _shape(stream)
        else:  # no array, and handed over as bytes
            yield (member.file_size,)


def _shape(stream: IO[bytes]) -> tuple[int, ...]:
    """What the header of an array says."""
    version = np.lib.format.read_magic(stream)
    # Version 3 differs from 2 by the encoding of the names of fields, which are not looked at.
    read: Any = np.lib.format.read_array_header_1_0 if version == (1, 0) else np.lib.format.read_array_header_2_0
    shape: tuple[int, ...] = read(stream)[0]
    return shape


def readable_of_mat(data: bytes, name: str) -> list[tuple[str, bool]]:
    """The variables of a MATLAB file and whether they may be read: arrays of numbers, and structs and cells, which may
    hold some."""
    from scipy.io import whosmat  # noqa: PLC0415 (slow to load, for one format)

    found = whosmat(io.BytesIO(data))
    numeric = [shape for _, shape, kind in found if kind.startswith(_NUMBERS)]
    require_few_values(numeric, name)
    if any(kind in _NESTED for _, _, kind in found):
        _require_small_when_unpacked(data, name)
    return [(variable, kind.startswith(_NUMBERS) or kind in _NESTED) for variable, _, kind in found]


def _require_small_when_unpacked(data: bytes, name: str) -> None:
    """LimitError for packed variables of more than ``MAX_BYTES``: a struct does not say how much it holds.

    The file is 128 bytes and a row of (type, size, bytes); type 15 is packed by zlib (MathWorks, MAT-File Level 5).
    """
    order = "<" if data[126:128] == b"IM" else ">"
    place, total = 128, 0
    while place + 8 <= len(data):
        kind, size = struct.unpack_from(f"{order}II", data, place)
        packed = zlib.decompressobj()
        rest = data[place + 8 : place + 8 + size] if kind == _PACKED else b""
        while rest and not packed.eof and total <= MAX_BYTES:
            total += len(packed.decompress(rest, _CHUNK))
            rest = packed.unconsumed_tail
        place += 8 + size
    if total > MAX_BYTES:
        raise LimitError("FILE", f"{name} unpacks to more than {MAX_BYTES} bytes", f"at most {MAX_BYTES} bytes")


_NUMBERS, _NESTED, _PACKED = ("double", "single", "int", "uint", "logical"), ("struct", "cell"), 15
