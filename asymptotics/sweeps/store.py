"""The folder in which the finished points of sweeps lie: a store addressed by content.

    store.json          what this folder is, and the code and libraries whose results it holds (``made_by``)
    shards/0a.points    the points whose bucket is 0a (see ``shard``), in the order in which they were finished

A point is found by the SHA-256 of its task, whatever sweep it was computed for.  Its *bucket* has one hexadecimal digit
from its exponents alone and one from its key: at most 256 files however many points, and points that share the costly
series of an exponent are computed near each other.
"""

import hashlib
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from asymptotics import __version__
from asymptotics.errors import InputError
from asymptotics.made_by import made_by, mark
from asymptotics.present.files import require_writable, write_atomically
from asymptotics.sweeps.grid import Point
from asymptotics.sweeps.shard import LockedShard, content_key, lines

FORMAT = "asymptotics-sweep/1"
ACCEPTED = "a new or empty folder, or one that a sweep of this code has made"


class Store:
    """A store on disk; ``create`` makes the folder if there is none.

    ``rebuilt``: a lost store.json was written again, for the shards hold points of this code; each of them proves
    itself, and is found by a key that names its code.  InputError for a folder that is not a store, is unreadable, or
    holds results of other code or libraries.
    """

    def __init__(self, folder: Path, *, create: bool = False) -> None:
        self.folder, self.rebuilt = folder, False
        about = folder / "store.json"
        try:
            self.rebuilt = create and not about.exists() and _holds_points_of_this_code(folder)
            # Only a folder that is new or empty becomes a store: nobody's other files get shards put among them.
            new = create and not about.exists() and not (folder.exists() and any(folder.iterdir()))
            if new or self.rebuilt:
                require_writable(folder / "shards", "folder")
                write_atomically(
                    about, json.dumps({"format": FORMAT, "version": __version__, "made_by": made_by()}) + "\n"
                )
            found = json.loads(about.read_text())
        except InputError:
            raise
        except (OSError, ValueError) as error:
            reason = error.strerror if isinstance(error, OSError) else "store.json is damaged"
            raise InputError("folder", f"{folder} is not a store: {reason}", ACCEPTED) from error
        self._check(found)

    def _check(self, found: Any) -> None:
        if not isinstance(found, dict) or found.get("format") != FORMAT:
            raise InputError("folder", f"{self.folder} is of another kind or format", ACCEPTED)
        if found.get("version") != __version__:
            reason = f"{self.folder} holds results of version {str(found.get('version'))[:20]}, this is {__version__}"
            raise InputError("folder", reason, ACCEPTED)
        # Other code may be wrong where this is right: its results are refused, not mixed with those of this code.
        other = _difference(found.get("made_by"))
        if other is not None:
            raise InputError("folder", f"{self.folder} holds results of {other}: they are not believed", ACCEPTED)
        if not (self.folder / "shards").is_dir():
            raise InputError("folder", f"{self.folder} has no folder shards", ACCEPTED)

    def path(self, bucket: int) -> Path:
        """The file of a bucket."""
        return self.folder / "shards" / f"{bucket:02x}.points"

    def take(self, bucket: int) -> LockedShard | None:
        """Lock a bucket for writing; None while another process has it."""
        return LockedShard.take(self.path(bucket))

    def read(self, bucket: int) -> Iterator[tuple[int, str, str]]:
        """(offset, key, record) of the intact points of a bucket."""
        return lines(self.path(bucket))


def _difference(found: Any) -> str | None:
    """In what the maker of a store is not this program, for a message; None where it is."""
    here = made_by()
    if not isinstance(found, dict) or not isinstance(found.get("versions"), dict):
        return f"unknown code (this is {mark()})"
    if found.get("code") != here["code"]:
        return f"other code (commit {str(found.get('commit'))[:16]}; this is commit {str(here['commit'])[:16]})"
    names = [name for name, number in here["versions"].items() if found["versions"].get(name) != number]
    changed = [f"{name} {str(found['versions'].get(name))[:20]} (this is {here['versions'][name]})" for name in names]
    return ", ".join(changed) or None


def _holds_points_of_this_code(folder: Path) -> bool:
    """Whether there is a shard with a record of a task of this code, and nothing beside the shards."""
    shards = folder / "shards"
    if not shards.is_dir() or {path.name for path in folder.iterdir()} != {"shards"}:
        return False
    records = (record for path in sorted(shards.glob("[0-9a-f]*.points")) for _, _, record in lines(path))
    return any(json.loads(record)["task"].get("code") == mark() for record in records)


def require_usable(folder: Path) -> None:
    """InputError for a folder that ``Store(folder, create=True)`` would refuse for what is in it; writes nothing."""
    try:
        used = folder.exists() and (not folder.is_dir() or any(folder.iterdir()))
        if used and not (folder.is_dir() and _holds_points_of_this_code(folder)):
            Store(folder)
    except OSError as error:
        raise InputError("folder", f"{folder} is not a store: {error.strerror}", ACCEPTED) from error


def task_of(command: str, point: Point) -> dict[str, Any]:
    """What the key of a point is made of."""
    # With the mark of code and libraries: a point of other code has another key, even in one file.
    return {"command": command, "point": point, "version": __version__, "code": mark()}


def place(command: str, point: Point) -> tuple[int, str]:
    """(bucket, key) of a point.

    >>> a, b = (place("moment", {"p": p}) for p in "12")
    >>> a == place("moment", {"p": "1"}), a == b
    (True, False)
    """
    key = content_key(task_of(command, point))
    # Sixteen classes of exponents, each in sixteen files by the first digit of the key, which is as good as random.
    exponents = " ".join(v.partition(":")[0] for n, v in point.items() if n == "alpha" or n.startswith("law"))
    return 16 * (hashlib.sha256(exponents.encode()).digest()[0] // 16) + int(key[0], 16), key
