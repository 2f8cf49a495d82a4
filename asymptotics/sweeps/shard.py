"""One file of finished points: lines that prove themselves, appended under a lock, as in a write-ahead log.

    KEY CHECKSUM {"task": {"command": ..., "point": ..., "version": ...}, "result": ...}      or "failed": the reason

KEY is the SHA-256 of the task (what is computed, by which version, at which point) and CHECKSUM that of the rest of the
line.  A line that was torn by a kill, cut by a full disk, or damaged later fails its checksum and is as if it had never
been written: its point is computed again.  A line is in the file or it is not, so nothing finished can be lost.

The lock (``flock``) belongs to the open file: the system releases it when a process ends, however it ends.
"""

import hashlib
import json
import os
import re
import stat
from collections.abc import Iterator, Mapping
from importlib import import_module
from pathlib import Path
from typing import Any

from asymptotics.errors import InputError

# Hexadecimal digits of a SHA-256.
_HASH = 64


def canonical(data: Mapping[str, Any]) -> str:
    """JSON with sorted keys and no spaces: the same text for the same data."""
    return json.dumps(data, sort_keys=True, separators=(",", ":"), ensure_ascii=False)


def content_key(task: Mapping[str, Any]) -> str:
    """The SHA-256 of a task in hexadecimal.

    >>> content_key({"b": "1", "a": "2"}) == content_key({"a": "2", "b": "1"})
    True
    """
    return hashlib.sha256(canonical(task).encode()).hexdigest()


def record_of(task: Mapping[str, Any], outcome: str) -> str:
    """The record of a task from what a worker made of it, {"result": ...} or {"failed": reason} in JSON.

    >>> record_of({"command": "half"}, '{"failed":"no"}')
    '{"failed":"no","task":{"command":"half"}}'
    """
    # Text is put beside text: what a worker wrote is not read and written again, which could change how a number
    # stands.
    return f'{outcome[:-1]},"task":{canonical(task)}}}'


def failure(record: str) -> str | None:
    """The reason, if the record is that of a failed point."""
    # By its beginning: records of results may be long, and most are not looked into.
    return str(json.loads(record)["failed"]) if record.startswith('{"failed":') else None


def written(key: str, record: str) -> bytes:
    """The line of a finished point."""
    return f"{key} {_checksum(key, record)} {record}\n".encode()


def verified(line: bytes) -> tuple[str, str] | None:
    """(key, record) of a line that proves itself, else None.

    >>> line = written("00" * 32, '{"result":"1.5"}')
    >>> verified(line) is not None, verified(line[:-9]), verified(line.replace(b"1.5", b"1.4"))
    (True, None, None)
    """
    try:
        text = line.decode()
    except UnicodeDecodeError:
        return None
    if len(text) < 2 * _HASH + 3 or not text.endswith("\n"):
        return None
    key, checksum, record = text[:_HASH], text[_HASH + 1 : 2 * _HASH + 1], text[2 * _HASH + 2 : -1]
    return (key, record) if checksum == _checksum(key, record) else None


def _checksum(key: str, record: str) -> str:
    return hashlib.sha256(f"{key} {record}".encode()).hexdigest()


def believed(line: bytes) -> tuple[str, str] | None:
    """(key, record) of a line that proves itself and stands under the key of its task, else None."""
    found = verified(line)
    if found is None:
        return None
    key, record = found
    # The task stands at the end as the text that its key was made of; a parameter may have this name too.
    tasks = (record[m.end() : -1] for m in re.finditer(',"task":', record))
    return found if any(hashlib.sha256(task.encode()).hexdigest() == key for task in tasks) else None


def lines(path: Path) -> Iterator[tuple[int, str, str]]:
    """(offset, key, record) of every line of a shard that proves itself; nothing if there is no file."""
    if not path.exists():
        return
    # Counted over all lines, torn ones included: it is the place in the file, from which one record is read again.
    offset = 0
    with os.fdopen(_opened(path, os.O_RDONLY), "rb") as stream:
        for line in stream:
            found = believed(line)
            if found is not None:
                yield offset, *found
            offset += len(line)


def _opened(path: Path, how: int) -> int:
    """The handle of a shard, which is a file of its own: nothing is written through a link, no pipe is waited for."""
    # Where a system has no such flag it has no such files, or the link is met by the question below it.
    flags = how | getattr(os, "O_CLOEXEC", 0) | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_NONBLOCK", 0)
    try:
        handle = os.open(path, flags | getattr(os, "O_BINARY", 0), 0o644)
    except OSError as error:
        raise InputError("folder", f"cannot open {path.name}: {error.strerror}", "a store of plain files") from error
    if path.is_symlink() or not stat.S_ISREG(os.fstat(handle).st_mode):
        os.close(handle)
        raise InputError("folder", f"{path.name} is no plain file", "a store of plain files")
    return handle


class LockedShard:
    """A shard that this process alone may write: ``keys`` are the points it holds, ``failed`` the reasons of some."""

    def __init__(self, handle: int, path: Path) -> None:
        self._handle, self._path = handle, path
        self.waiting = 0  # points of this shard that are being computed
        self.keys: set[str] = set()
        self.failed: dict[str, str] = {}
        size = 0
        with path.open("rb") as stream:
            for line in stream:
                size += len(line)
                found = believed(line)
                if found is not None:
                    self._note(*found)
        self._end = size
        # A file that does not end with a line end was cut by a kill: the next record begins on a line of its own, and
        # the torn one stays what it is, a line that does not prove itself.
        self._torn = bool(size) and self._last_byte() != b"\n"

    @classmethod
    def take(cls, path: Path) -> "LockedShard | None":
        """Lock the shard at ``path``, which is created; None while another process has it."""
        # A lock belongs to the open file: a worker that inherited it would hold the lock after this process has ended.
        handle = _opened(path, os.O_RDWR | os.O_CREAT)
        try:
            locks = import_module("fcntl")  # not on every system, and without it the other commands go on
            locks.flock(handle, locks.LOCK_EX | locks.LOCK_NB)
            return cls(handle, path)
        except ModuleNotFoundError as error:
            os.close(handle)
            accepted = "a system with fcntl: Linux, macOS, or Linux in Windows (WSL)"
            raise InputError("folder", "this system has no such locks of files as a store needs", accepted) from error
        except BlockingIOError:
            os.close(handle)
            return None
        except OSError as error:
            os.close(handle)
            raise InputError("folder", f"cannot lock {path.name}: {error.strerror}", "a disk with locks") from error

    def append(self, key: str, record: str) -> None:
        """Add a finished point; on an OSError (a full disk) the file is what it was before."""
        data = (b"\n" if self._torn else b"") + written(key, record)
        try:
            done = 0
            while done < len(data):
                # At its place, not at the end of the file: what a failed write has left behind is overwritten.  A write
                # may be short.
                os.lseek(self._handle, self._end + done, os.SEEK_SET)
                done += os.write(self._handle, data[done:])
        except OSError:
            os.ftruncate(self._handle, self._end)
            raise
        self._end, self._torn = self._end + len(data), False
        self._note(key, record)

    def _last_byte(self) -> bytes:
        os.lseek(self._handle, -1, os.SEEK_END)
        return os.read(self._handle, 1)

    def _note(self, key: str, record: str) -> None:
        self.keys.add(key)
        reason = failure(record)
        if reason is not None:
            self.failed[key] = reason

    def close(self) -> None:
        """Bring the file to the disk and release the lock."""
        # Once for a shard, not for each point: after a kill the system still has what was written; after a loss of
        # power the checksums say which lines have reached the disk.
        os.fsync(self._handle)
        os.close(self._handle)
