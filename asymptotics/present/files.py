"""Files appear whole or not at all, and several of them all together or not at all.

>>> import tempfile
>>> folder = Path(tempfile.mkdtemp())
>>> write_all({folder / "a.txt": "whole", folder / "b.txt": "too"})
>>> (folder / "a.txt").read_text()
'whole'
>>> target_file(str(folder), "--csv")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument --csv: ... is a folder (accepted: the name of a file in an existing folder)

*Before the work*: ``target_file`` refuses what is not a regular file (a device, a FIFO, a socket, a folder), a name
that the system does not take, a folder that is missing or cannot be written, a file that is write-protected.
``require_different`` refuses two options that name one file, by whatever links.

*The write*: each content goes to a temporary file in the folder of its target, under a short name of its own (so that
a name of 255 bytes is served), and is synchronised; only when all are complete are they renamed.  A symbolic link is
written through; an existing file keeps its mode and, where the system allows it, its owner; a file that is created
gets what the umask leaves.  If a rename fails, the targets that were replaced before it get their old contents back.
"""

import os
import shutil
import stat
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from secrets import token_hex

from asymptotics.errors import InputError

_ACCEPTED = "the name of a file in an existing folder"
_KINDS = {
    stat.S_IFDIR: "a folder",
    stat.S_IFIFO: "a FIFO",
    stat.S_IFCHR: "a device",
    stat.S_IFBLK: "a device",
    stat.S_IFSOCK: "a socket",
}


def target_file(name: str | Path, argument: str) -> Path:
    """The file to be written, after proving that it can be; InputError otherwise.  Nothing is left behind."""
    if not str(name):
        raise InputError(argument, "the name is empty", _ACCEPTED)
    try:
        path = _real(Path(name))
        _require_regular(path, str(name), argument)
        if not path.parent.is_dir():
            raise InputError(argument, f"there is no folder {path.parent}", _ACCEPTED)
        # Asking the system for permissions would say less than a file that was really made: quotas, read-only disks,
        # names.
        os.close(_created(_beside(path), remove=True))
    except (OSError, ValueError) as error:
        if isinstance(error, InputError):
            raise
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise InputError(argument, f"cannot write {name}: {reason}", _ACCEPTED) from error
    return Path(name)


def require_different(targets: Mapping[str, Path | None]) -> None:
    """InputError if two arguments name the same file, be it through links."""
    seen: dict[Path, str] = {}
    for argument, target in targets.items():
        if target is None:
            continue
        real = _real(target)
        for other, before in seen.items():
            # realpath resolves symbolic links; two names of one file by hard links have only its number in common.
            if real == other or (real.exists() and other.exists() and real.samefile(other)):
                raise InputError(argument, f"{target} is the file of {before} too", "two different files")
        seen[real] = argument


def require_writable(folder: Path, argument: str) -> None:
    """Create ``folder`` and prove that a file can be written there; InputError otherwise, before any work is done."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        os.close(_created(_beside(folder / "any"), remove=True))
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) else str(error)
        raise InputError(argument, f"cannot write to {folder}: {reason}", "a folder that can be written") from error


def write_all(contents: Mapping[Path, str | bytes], argument: str = "FILE") -> None:
    """Write all files or none; InputError names the file that could not be written (a full disk, say)."""
    parts: list[_Part] = []
    try:
        for name, content in contents.items():
            data = content.encode() if isinstance(content, str) else bytes(memoryview(content))
            # All are written before the first is put in place: a full disk leaves everything as it was.
            parts.append(_Part.written(name, data, argument))
        # A rename is the one step that cannot be half done (POSIX): all files are complete and synchronised by now.
        for part in parts:
            part.replace_target()
    except BaseException as error:
        for part in parts:
            part.undo()
        if isinstance(error, OSError):
            reason = f"cannot write {error.filename or 'the file'}: {error.strerror}"
            raise InputError(argument, reason, "a folder with room for the files; none of them was changed") from error
        raise
    try:
        _forget(parts)
    except BaseException:  # an interrupt: everything is in place, only the second names are left
        _forget(parts)
        raise


def _forget(parts: list["_Part"]) -> None:
    """The second names of what was replaced."""
    for part in parts:
        part.old.unlink(missing_ok=True)


def write_atomically(path: Path, content: str | bytes, argument: str = "FILE") -> None:
    """Write one file, whole or not at all; InputError if it cannot be written."""
    write_all({path: content}, argument)


@dataclass(frozen=True)
class _Part:
    """One file on its way: ``new`` is complete, ``old`` holds the file it replaces until all are in place."""

    target: Path
    new: Path
    old: Path
    existed: bool

    @classmethod
    def written(cls, name: Path, data: bytes, argument: str) -> "_Part":
        """The temporary file, complete and synchronised, with the mode and owner of what it will replace."""
        target = _real(name)
        _require_regular(target, str(name), argument)
        part = cls(target, _beside(target), _beside(target), target.exists())
        try:
            with os.fdopen(_created(part.new, remove=False), "wb") as stream:
                stream.write(data)
                stream.flush()
                os.fsync(stream.fileno())
                if part.existed:
                    before = target.stat()
                    # Only root may give a file to somebody else; the owner first, since that clears set-uid bits of the
                    # mode.
                    with suppress(PermissionError):
                        os.fchown(stream.fileno(), before.st_uid, before.st_gid)
                    os.fchmod(stream.fileno(), stat.S_IMODE(before.st_mode))
        except BaseException as error:
            part.new.unlink(missing_ok=True)
            if isinstance(error, OSError):
                error.filename = str(name)
            raise
        return part

    def replace_target(self) -> None:
        """Rename, keeping what is replaced under a second name (a copy where there are no hard links)."""
        if self.existed:
            try:
                self.old.hardlink_to(self.target)
            except OSError:
                self._keep_copy()
        self.new.replace(self.target)

    def _keep_copy(self) -> None:
        try:
            shutil.copy2(self.target, self.old)
        except BaseException:
            self.old.unlink(missing_ok=True)  # half a copy must not be put back
            raise

    def undo(self) -> None:
        """Put the file back that stood there before, or take away what is there."""
        with suppress(OSError):
            if self.old.exists():
                self.old.replace(self.target)
                self.old.unlink(missing_ok=True)  # a rename between two names of one file leaves both
            # The new name is gone, so it was renamed to a target that did not exist: what stands there is ours.
            elif not self.existed and not self.new.exists():
                self.target.unlink(missing_ok=True)
            self.new.unlink(missing_ok=True)


def _real(path: Path) -> Path:
    return Path(os.path.realpath(path))


def _beside(path: Path) -> Path:
    """An unused short name in the same folder."""
    return path.parent / f".asymptotics-{token_hex(8)}"


def _created(path: Path, *, remove: bool) -> int:
    """A file descriptor of a file that did not exist; the umask shapes its mode."""
    # O_EXCL follows no link that somebody has put there, and fails if the name is taken.
    handle = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666)
    if remove:
        path.unlink()
    return handle


def _require_regular(path: Path, name: str, argument: str) -> None:
    try:
        mode = path.stat().st_mode
    except FileNotFoundError:
        return
    if not stat.S_ISREG(mode):
        kind = _KINDS.get(stat.S_IFMT(mode), "not a regular file")
        raise InputError(argument, f"{name} is {kind}", _ACCEPTED)
    if not os.access(path, os.W_OK):
        raise InputError(argument, f"{name} is write-protected", _ACCEPTED)
