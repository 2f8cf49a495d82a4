"""What made a result: a digest of the code that computes, the commit where known, the versions of the libraries.

A version number names a release; between two releases it says nothing.  The digest is the SHA-256 of every file that
answers come from: code, stored data and page templates of the library, the derivations and the checks of the papers.
It is the same for the same files, in a checkout, an installed wheel or a zip file, so what other code has made is never
taken for what this code would make.  It is computed once in a process, in a few hundredths of a second, and only when
something is written down.

>>> made_by()["code"] == code() and len(code())
64
>>> sorted(versions())
['mpmath', 'numpy', 'power-law-oscillator', 'python-flint', 'scipy', 'sympy']
"""

import hashlib
import json
import subprocess
import sys
from functools import lru_cache
from importlib import import_module
from pathlib import Path
from typing import Any

from asymptotics import __version__

LIBRARIES = {"python-flint": "flint", "sympy": "sympy", "mpmath": "mpmath", "numpy": "numpy", "scipy": "scipy"}
"""The libraries that compute, with the names they are imported by."""
PACKAGES = ("asymptotics", "derivations", "paper_checks")
"""What a wheel carries, side by side."""
READ = (".py", ".json", ".csv", ".html", ".j2", ".css", ".js")
"""The endings of the files that an answer can depend on."""
BUILT_FROM = "built_from.txt"
"""The commit that a wheel or an sdist was built from: written into it by the build hook, absent in a checkout."""


@lru_cache
def code() -> str:
    """The SHA-256 of the sources: of their names and contents, in the order of their names."""
    found = hashlib.sha256()
    for package in PACKAGES:
        for name, content in sorted(_sources(_folder(package), f"{package}/")):
            # With its length before each content no two sets of files give one stream of bytes.
            found.update(f"{name} {len(content)}\n".encode())
            found.update(content)
    return found.hexdigest()


def _folder(package: str) -> Any:
    """Where a package lies: beside this one, in a folder or in a zip file."""
    here = Path(__file__).parent
    return here.parent / package if here.is_dir() else _in_zip(package)


def _sources(folder: Any, prefix: str) -> list[tuple[str, bytes]]:
    found = []
    for entry in folder.iterdir() if folder.is_dir() else ():
        if entry.name.endswith(READ):
            found.append((prefix + entry.name, entry.read_bytes()))
        # Folders of sources have no dot in their names: what else lies about (caches, metadata) is no code.
        elif "." not in entry.name and entry.name != "__pycache__" and entry.is_dir():
            found += _sources(entry, f"{prefix}{entry.name}/")
    return found


def _in_zip(package: str) -> Any:
    return import_module("importlib.resources").files("asymptotics").parent / package  # slower to load, rarely needed


@lru_cache
def versions() -> dict[str, str]:
    """The versions of this program and of the libraries that compute; "unknown" where one is not installed."""
    return {"power-law-oscillator": __version__, **{name: _version(name) for name in LIBRARIES}}


def _version(name: str) -> str:
    # A library that has been loaded knows its version; to read it from the metadata takes longer than all the rest.
    loaded = getattr(sys.modules.get(LIBRARIES[name]), "__version__", None)
    if loaded is not None:
        return str(loaded)
    metadata = import_module("importlib.metadata")  # takes as long as the rest together: only where it is needed
    try:
        return str(metadata.version(name))
    except metadata.PackageNotFoundError:
        return "unknown"


@lru_cache
def commit() -> str | None:
    """The commit of the checkout this runs from, with "+changes" if it was edited, or that of the build; else None."""
    here = Path(__file__).parent
    if not (here.parent / ".git").exists():
        return _built_from()
    try:
        head = _git(here.parent, "rev-parse", "HEAD")
        return head + ("+changes" if _git(here.parent, "status", "--porcelain", "--", *PACKAGES) else "")
    # No git, a checkout of another user, or no answer within ten seconds: not known, and no reason to stop.
    except (OSError, subprocess.SubprocessError):
        return None


def _built_from() -> str | None:
    try:
        return str(_in_zip("asymptotics").joinpath(BUILT_FROM).read_text(encoding="ascii")).strip() or None
    except (OSError, ValueError):
        return None


def _git(root: Path, *arguments: str) -> str:
    return subprocess.run(
        ["git", "-C", str(root), *arguments], capture_output=True, text=True, check=True, timeout=10
    ).stdout.strip()


def made_by() -> dict[str, Any]:
    """All of it, JSON-ready: ``code``, ``commit``, ``versions``."""
    return {"code": code(), "commit": commit(), "versions": versions()}


@lru_cache
def mark() -> str:
    """One word for code and libraries together, where there is room for no more: a key, a column, a picture.

    The commit is not in it: the same code from a checkout and from a wheel makes the same results.
    """
    return "sha256:" + hashlib.sha256(json.dumps([code(), versions()]).encode()).hexdigest()[:16]


def line() -> str:
    """For people, in the head of a file or the foot of a page."""
    libraries = ", ".join(f"{name} {number}" for name, number in versions().items())
    return f"code {code()[:16]}, commit {commit() or 'unknown'}; {libraries}"
