"""Where a table comes from: its inputs, the program and its libraries, the commit where known, and a SHA-256.

The SHA-256 is that of the columns and rows as JSON without spaces; ``checksum`` computes it again from any file.

>>> checksum(("n", "x"), [("1", "0.5")])[:16]
'68ee74e1ccbbccd8'
"""

import hashlib
import json
import subprocess
from collections.abc import Iterable, Sequence
from functools import lru_cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Any

PROGRAMS = ("power-law-oscillator", "python-flint", "sympy", "mpmath")


def checksum(columns: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """The SHA-256 of a table's columns and rows."""
    content = json.dumps([list(columns), *map(list, rows)], separators=(",", ":"), ensure_ascii=False)
    return hashlib.sha256(content.encode()).hexdigest()


@lru_cache
def versions() -> dict[str, str]:
    """The versions of this program and of the libraries that compute."""
    found = {}
    for name in PROGRAMS:
        try:
            found[name] = version(name)
        except PackageNotFoundError:
            found[name] = "unknown"
    return found


@lru_cache
def commit() -> str | None:
    """The commit of the checkout this runs from, with "+changes" if it was edited; None outside a checkout."""
    root = Path(__file__).parents[2]
    if not (root / ".git").exists():
        return None
    try:
        head = _git(root, "rev-parse", "HEAD")
        return head + ("+changes" if _git(root, "status", "--porcelain", "--", "asymptotics") else "")
    except (OSError, subprocess.SubprocessError):
        return None


def _git(root: Path, *arguments: str) -> str:
    return subprocess.run(
        ["git", "-C", str(root), *arguments], capture_output=True, text=True, check=True, timeout=10
    ).stdout.strip()


def provenance(inputs: dict[str, Any], source: str, certified: bool, sha256: str) -> dict[str, Any]:
    """Everything a file says about its origin; numbers are strings."""
    return {
        "source": source,
        "certified": certified,
        "inputs": inputs,
        "versions": versions(),
        "commit": commit(),
        "sha256": sha256,
    }
