"""The lines of a text file: packed (gz, zip of one file) or not, in UTF-8, UTF-16 or a Latin code page.

>>> decoding(b"t;x\\n0;1\\n"), decoding("t;x".encode("utf-16")), decoding("Zeit (µs)".encode("latin-1"))
('utf-8-sig', 'utf-16', 'cp1252')
"""

import gzip
import io
import zipfile
from collections.abc import Generator, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, Any

from asymptotics.errors import InputError, LimitError
from asymptotics.present.counts import many

MAX_BYTES = 2_000_000_000
"""Of a file as it lies, of a member of a zip archive by what the archive states, and of what a gzip stream, which
states no size, has given: minutes of reading."""
_HEAD = 1 << 16
"""Bytes that show the encoding."""
_BINARY = {*range(8), *range(14, 27)}
"""Control characters that stand in no text; white space, the escape sign and the separators from 28 on may."""
_MARKS = {b"\xff\xfe": "utf-16", b"\xfe\xff": "utf-16", b"\xef\xbb\xbf": "utf-8-sig"}


class _Limited(gzip.GzipFile):
    """A gzip stream that gives at most ``MAX_BYTES``."""

    def __init__(self, name: str, raw: IO[bytes]) -> None:
        super().__init__(fileobj=raw, mode="rb")
        self.called = name

    def read(self, size: int | None = -1) -> bytes:
        """As of any stream; LimitError beyond the limit."""
        return self._limited(super().read(MAX_BYTES + 1 if size is None or size < 0 else size))

    def read1(self, size: int = -1) -> bytes:
        """As of any stream; LimitError beyond the limit."""
        return self._limited(super().read1(size))

    def _limited(self, data: bytes) -> bytes:
        if self.tell() > MAX_BYTES:
            reason = f"{self.called} unpacks to more than {MAX_BYTES} bytes"
            raise LimitError("FILE", reason, f"at most {MAX_BYTES} bytes")
        return data


@contextmanager
def unpacked(source: Path | bytes, name: str) -> Iterator[IO[bytes]]:
    """The bytes of a file, unpacked; InputError for one that cannot be read, or an archive of several files."""
    try:
        # A device may wait for ever, or never end.
        if isinstance(source, Path) and (source.is_char_device() or source.is_block_device()):
            raise InputError("FILE", f"{source} is a device", "a file of data")
        if isinstance(source, Path) and source.stat().st_size > MAX_BYTES:
            raise LimitError("FILE", f"{name} has {source.stat().st_size} bytes", f"at most {MAX_BYTES} bytes")
        with source.open("rb") if isinstance(source, Path) else io.BytesIO(source) as raw:
            first = raw.read(4)
            raw.seek(0)
            # By the first bytes, for names lie: gzip, and zip but for the formats that are archives themselves.
            if first[:2] == b"\x1f\x8b":
                with _Limited(name, raw) as stream:
                    yield stream  # type: ignore[misc]
            elif first == b"PK\x03\x04" and not name.lower().endswith((".xlsx", ".npz", ".ods")):
                with zipfile.ZipFile(raw) as archive, archive.open(_one_member(archive, name)) as stream:
                    yield stream
            else:
                yield raw
    except OSError as error:
        raise InputError("FILE", f"cannot read {name}: {error.strerror or error}", "a file of data") from error
    except (zipfile.BadZipFile, EOFError) as error:
        raise InputError("FILE", f"{name}: the archive is damaged", "a whole file") from error


def _one_member(archive: zipfile.ZipFile, name: str) -> str:
    members = [item.filename for item in archive.infolist() if not item.is_dir()]
    members = [item for item in members if not item.startswith("__MACOSX")]
    # Phone applications pack remarks about the device beside the data.
    data = [item for item in members if not Path(item).name.startswith(("meta", "device", "time"))]
    if len(data) != 1:
        raise InputError(
            "FILE", f"{name} holds {many(len(members), 'file')}: {', '.join(members)[:100]}", "one of them, unpacked"
        )
    # The size that the archive states, before a byte is unpacked.
    if archive.getinfo(data[0]).file_size > MAX_BYTES:
        raise LimitError("FILE", f"{name} unpacks to more than {MAX_BYTES} bytes", f"at most {MAX_BYTES} bytes")
    return data[0]


def decoding(head: bytes) -> str:
    """The encoding that the first bytes show; what is not UTF-8 is taken as the Latin code page 1252."""
    for mark, encoding in _MARKS.items():
        if head.startswith(mark):
            return encoding
    # UTF-16 without a mark: every second byte of a text in Latin letters is 0, one other letter allowed.
    for encoding, place in (("utf-16-le", 1), ("utf-16-be", 0)):
        if len(head) > 8 and head[place:64:2].count(0) >= len(head[place:64:2]) - 1:
            return encoding
    for cut in range(4 if len(head) == _HEAD else 1):  # a long head may end within a letter
        try:
            head[: len(head) - cut].decode("utf-8")
        except UnicodeDecodeError:
            continue
        return "utf-8-sig"
    return "cp1252"


def lines_of(stream: IO[bytes], name: str) -> Generator[str, None, None]:
    """The lines, without their ends; InputError for what is no text."""
    buffered: Any = stream if hasattr(stream, "peek") else io.BufferedReader(stream)
    head = bytes(buffered.peek(_HEAD)[:_HEAD])
    encoding = decoding(head)
    if "16" not in encoding and set(head) & _BINARY:
        raise InputError("FILE", f"{name} is not text", "a text table (CSV, TSV, ...), xlsx, parquet, npz, npy or mat")
    # A letter that cannot be decoded is replaced: it may stand in a remark, and in a number it is told as unreadable.
    text = io.TextIOWrapper(buffered, encoding=encoding, newline=None, errors="replace")
    try:
        for line in text:
            yield line.rstrip("\n")
    except (UnicodeError, EOFError, OSError) as error:  # a packed file that ends early, half a UTF-16 letter
        raise InputError("FILE", f"{name} is damaged or no text", "a whole text table") from error
    finally:
        text.detach()
