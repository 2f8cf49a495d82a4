"""The tools this package is measured against, in an environment of their own (``.peers``, made by ``make benchmarks``).

A peer is asked by a few lines of Python that leave ``seconds`` and what they found in ``answer``; the clock runs inside
the peer's process and counts processor time, so that neither side pays for starting an interpreter or for others.

>>> import sys
>>> ask("answer = {'seconds': 0.5, 'right': limit}", limit=30, python=sys.executable)
{'seconds': 0.5, 'right': 30}
>>> ask("raise SystemExit(1)", python=sys.executable), ask("", python="nothing/here")
({'seconds': nan}, {'seconds': None})
"""

import json
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from math import inf, nan
from pathlib import Path
from typing import Any

from asymptotics.errors import InputError

PYTHON = Path(__file__).parents[1] / ".peers" / "bin" / "python"
"""The environment that is asked; ``none`` leaves it out."""
TIMEOUT = 60
IN_PAGES = {
    "kafe2": ("2.11.0", ("docs/how_often_right.md", "docs/tutorials/phone.md", "docs/tutorials/ship.md")),
    "rolldecay-estimators": ("0.6.0", ("docs/how_often_right.md", "docs/tutorials/ship.md")),
}
"""Peers of which pages have numbers, those of tutorials found by hand: in the environment of the lock, with these
versions."""
_IMPORTED = {"rolldecay-estimators": "rolldecayestimators"}
"""Peers that are imported by another name than they are installed by."""
_NOWHERE = Path("no peers")
_WAYS = "`make benchmarks`, which installs them, or --no-peers"
CLOCK = """
import json, sys
from time import process_time
def best(work, repeats=3):
    times = []
    for _ in range(repeats):
        start = process_time(); result = work(); times.append(process_time() - start)
    return min(times), result
globals().update(json.load(sys.stdin))
"""


def ask(code: str, *, python: str | Path = "", timeout: float = TIMEOUT, **arguments: Any) -> dict[str, Any]:
    """Run ``code`` in the peers' environment; ``seconds``: None if it is missing, nan if it fails, inf if too slow."""
    program = str(python or PYTHON)
    if shutil.which(program) is None:
        return {"seconds": None}
    command, told = [program, "-c", CLOCK + code + "\nprint(json.dumps(answer))"], json.dumps(arguments)
    try:
        run = subprocess.run(command, input=told, capture_output=True, text=True, timeout=timeout, check=False)
    except subprocess.TimeoutExpired:
        return {"seconds": inf}
    if run.returncode:
        missing = "ModuleNotFoundError" in run.stderr
        return {"seconds": None if missing else nan}
    return dict(json.loads(run.stdout.splitlines()[-1]))


def versions(*names: str, python: str | Path = "") -> dict[str, str]:
    """The versions of installed distributions, by name; what is not installed is left out.

    >>> import sys
    >>> list(versions("numpy", "no-such-peer", python=sys.executable))
    ['numpy']
    """
    code = """
from importlib.metadata import PackageNotFoundError, version
answer = {"seconds": 0}
for name in names:
    try: answer[name] = version(name)
    except PackageNotFoundError: pass
"""
    found = ask(code, python=python, names=list(names))
    return {name: str(found[name]) for name in names if name in found}


def require(names: Sequence[str]) -> None:
    """InputError, which names each peer that cannot be imported, and why, unless the environment is left out.

    >>> with none():
    ...     require(["no_such_peer"])
    """
    if PYTHON == _NOWHERE:
        return
    if shutil.which(str(PYTHON)) is None:
        raise InputError("--no-peers", f"the peers ({', '.join(names)}) have no environment", _WAYS)
    failed = [f"{name}: {why}" for name in names if (why := _unusable(_IMPORTED.get(name, name))) is not None]
    if failed:
        raise InputError("--no-peers", "missing peers; " + "; ".join(failed), _WAYS)


def _unusable(name: str) -> str | None:
    """The last line of what is said when a peer is imported, None if it is there."""
    run = subprocess.run([str(PYTHON), "-c", f"import {name}"], capture_output=True, text=True, check=False)
    return None if run.returncode == 0 else (run.stderr.strip().splitlines() or ["no message"])[-1]


def use(python: Path) -> None:
    """Ask that environment from now on: what a second process is told by the first."""
    global PYTHON
    PYTHON = python


@contextmanager
def none() -> Iterator[None]:
    """Within it no peer is wanted, and none is asked."""
    global PYTHON
    before, PYTHON = PYTHON, _NOWHERE
    try:
        yield
    finally:
        PYTHON = before
