"""``python -m benchmarks.weakened [PART ...]``: bounds are halved or dropped, one at a time, and their test must fail.

``benchmarks/weakened_bounds.json`` lists them: the file, the bound in words, the line and what it is weakened to, and
the test that notices.  Each is planted in a copy of the project in ``build/weakened`` and its test is run.  What no
test can notice has a reason in the place of the test.  ``PART`` selects by a part of the file's name.
"""

import argparse
import json
import os
import subprocess
import sys
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

from benchmarks.mutants import PYTEST, copy_of_the_project
from benchmarks.table import Table

ROOT = Path(__file__).parents[1]
LIST = Path(__file__).with_name("weakened_bounds.json")
SECONDS = 300


@dataclass(frozen=True)
class Weakened:
    """``line`` of ``file`` becomes ``weaker``; ``test`` fails, or ``equivalent`` says why none can."""

    file: str
    bound: str
    line: str
    weaker: str
    test: str = ""
    equivalent: str = ""

    @property
    def room(self) -> str:
        """The directory below ``asymptotics``."""
        return Path(self.file).parts[1].removesuffix(".py")


def listed() -> list[Weakened]:
    """All of the list."""
    return [Weakened(**entry) for entry in json.loads(LIST.read_text())]


def main(argv: list[str] | None = None) -> int:
    """Plant the selected ones; 0 if each is noticed, else 1."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.weakened", description=__doc__)
    parser.add_argument("parts", nargs="*", help="parts of file names, such as wells/ or abel (default: all)")
    parts = parser.parse_args(argv).parts
    chosen = [w for w in listed() if not parts or any(part in w.file for part in parts)]
    folder = copy_of_the_project(ROOT / "build" / "weakened")
    outcomes = [(w, outcome_of(w, folder)) for w in chosen]
    print(table(outcomes).text())
    alive = [w for w, outcome in outcomes if outcome == "survived"]
    for w in alive:
        print(f"\n{w.file}: {w.bound}\n  - {w.line}\n  + {w.weaker}", file=sys.stderr)
    return int(bool(alive))


def outcome_of(w: Weakened, folder: Path) -> str:
    """noticed, survived, or equivalent."""
    if w.equivalent:
        return "equivalent"
    return "noticed" if is_noticed(w, folder) else "survived"


def is_noticed(w: Weakened, folder: Path) -> bool:
    """Whether the test fails with the weaker line, and not for want of a test."""
    path = folder / w.file
    text = path.read_text()
    path.write_text(text.replace(w.line, w.weaker))
    command = [sys.executable, "-m", "pytest", "-q", "-x", *PYTEST, w.test]
    environment = {**os.environ, "PYTHONPATH": str(folder), "PYTHONDONTWRITEBYTECODE": "1"}
    try:
        code = subprocess.run(command, cwd=folder, env=environment, capture_output=True, timeout=SECONDS).returncode
    except subprocess.TimeoutExpired:
        code = 1
    finally:
        path.write_text(text)
    return code == 1


def table(outcomes: Sequence[tuple[Weakened, str]]) -> Table:
    """A row for each room."""
    counts = Counter((w.room, outcome) for w, outcome in outcomes)
    rooms = sorted({w.room for w, _ in outcomes})
    outcome = ("noticed", "equivalent", "survived")
    rows = tuple((room, *(str(counts[room, name]) for name in outcome)) for room in rooms)
    return Table("Bounds that were weakened", ("room", *outcome), rows)


if __name__ == "__main__":
    sys.exit(main())
