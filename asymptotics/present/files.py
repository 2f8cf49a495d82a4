"""Files appear whole or not at all.

>>> import tempfile
>>> folder = Path(tempfile.mkdtemp())
>>> write_atomically(folder / "a.txt", "whole")
>>> (folder / "a.txt").read_text()
'whole'
>>> require_writable(folder / "a.txt", "--report")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument --report: cannot write to ...: ... (accepted: a folder that can be written)
"""

import os
import tempfile
from pathlib import Path

from asymptotics.errors import InputError


def write_atomically(path: Path, content: str | bytes) -> None:
    """Write a file under a temporary name in its own folder, then rename it."""
    data = content.encode() if isinstance(content, str) else content
    handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(data)
        os.chmod(temporary, 0o644)  # noqa: PTH101 (mkstemp gives a name, and keeps it private to the user)
        Path(temporary).replace(path)
    except BaseException:
        Path(temporary).unlink(missing_ok=True)
        raise


def require_writable(folder: Path, argument: str) -> None:
    """Create ``folder`` and prove that a file can be written there; InputError otherwise, before any work is done."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=folder):
            pass
    except OSError as error:
        reason = f"cannot write to {folder}: {error.strerror}"
        raise InputError(argument, reason, "a folder that can be written") from error
