"""``python -m benchmarks.weakened [PART ...]``: bounds are halved or dropped, one at a time, and their test must fail.

Two lists.  ``benchmarks/weakened_bounds.json`` was written by hand: the file, the bound in words, the line and what it
is weakened to, and the test that notices.  ``benchmarks/bound_sites.json`` answers for the places that
``benchmarks.bound_sites`` finds in the syntax trees: the test that notices each, or the reason why none can.  Each is
planted in a copy of the project in ``build/weakened`` and its test is run, in as many ``--processes`` as there are
cores.  Outcomes are written down one by one: what was stopped goes on where it was, as long as no tracked file
changes.  ``PART`` selects by a part of the file's name; ``--search`` looks among the tests of the room for one that
notices the places that neither list answers for.
"""

import argparse
import ast
import hashlib
import json
import os
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from queue import Queue

from tqdm import tqdm

from benchmarks.bound_sites import Site, sites
from benchmarks.mutants import FORGET, PYTEST, copy_of_the_project
from benchmarks.table import Table

ROOT = Path(__file__).parents[1]
LIST = Path(__file__).with_name("weakened_bounds.json")
SITES = Path(__file__).with_name("bound_sites.json")
BUILD = ROOT / "build" / "weakened"
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
    def key(self) -> str:
        """What tells it from every other."""
        return f"{self.file}: {self.line} -> {self.weaker}"

    @property
    def room(self) -> str:
        """The directory below ``asymptotics``."""
        return Path(self.file).parts[1].removesuffix(".py")

    def planted(self, source: str) -> str:
        """The source of the file with the weaker line."""
        return source.replace(self.line, self.weaker)


@dataclass(frozen=True)
class Answered:
    """A place that was found, with the ``test`` that fails when it is weakened, or the reason why none can."""

    site: Site
    test: str = ""
    equivalent: str = ""

    key = property(lambda self: self.site.key)
    file = property(lambda self: self.site.file)
    bound = property(lambda self: f"{self.site.kind} in {self.site.function}")
    line = property(lambda self: self.site.text)
    weaker = property(lambda self: self.site.weaker)
    room = property(lambda self: Path(self.site.file).parts[1].removesuffix(".py"))

    def planted(self, source: str) -> str:
        """The source of the file with this place weakened."""
        return self.site.planted(source)


def listed() -> list[Weakened]:
    """The list written by hand."""
    return [Weakened(**entry) for entry in json.loads(LIST.read_text())]


def answered() -> list[Answered]:
    """The places found in the code for which ``bound_sites.json`` answers."""
    answers = json.loads(SITES.read_text())["answers"]
    return [Answered(site, **answers[site.key]) for site in sites() if site.key in answers]


def unanswered() -> list[Site]:
    """The places found in the code for which neither list answers: no line of the one holds it, no key of the other."""
    spans: dict[str, list[tuple[int, int]]] = {}
    for w in listed():
        start = (ROOT / w.file).read_text().index(w.line)
        spans.setdefault(w.file, []).append((start, start + len(w.line)))
    answers = json.loads(SITES.read_text())["answers"]

    def is_listed(site: Site) -> bool:
        end = site.start + len(site.text)
        return any(site.start < stop and start < end for start, stop in spans.get(site.file, ()))

    return [site for site in sites() if site.key not in answers and not is_listed(site)]


def main(argv: list[str] | None = None) -> int:
    """Plant the selected ones; 0 if each is noticed, else 1."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.weakened", description=__doc__)
    parser.add_argument("parts", nargs="*", help="parts of file names, such as flow/wells/ or abel (default: all)")
    parser.add_argument("--search", action="store_true", help="look for tests that notice what no list answers for")
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1, help="default: as many as cores")
    options = parser.parse_args(argv)
    parts = options.parts
    if options.search:
        return search([site for site in unanswered() if not parts or any(part in site.file for part in parts)])
    chosen = [w for w in (*listed(), *answered()) if not parts or any(part in w.file for part in parts)]
    before = os.times()
    found, read = outcomes_of(chosen, options.processes)
    outcomes = list(zip(chosen, found, strict=True))
    print(table(outcomes).text())
    print(how_long(before, os.times(), len(chosen), read, options.processes))
    alive = [w for w, outcome in outcomes if outcome == "survived"]
    for w in alive:
        print(f"\n{w.file}: {w.bound}\n  - {w.line}\n  + {w.weaker}", file=sys.stderr)
    return int(bool(alive))


def how_long(before: os.times_result, after: os.times_result, bounds: int, read: int, processes: int) -> str:
    """The wall time of the run and the processor time of its tests; what an earlier run wrote down took none of it."""
    wall = after.elapsed - before.elapsed
    used = after.children_user + after.children_system - before.children_user - before.children_system
    seconds = f"{wall:,.0f} s of wall time, {used:,.0f} s of processor time"
    earlier = f"; {read:,} of them were written down by an earlier run" if read else ""
    return f"{bounds:,} bounds, {processes} at once: {seconds}{earlier}"


def outcomes_of(chosen: Sequence[Weakened | Answered], processes: int) -> tuple[list[str], int]:
    """The outcome of each, with a copy of the project for each process, and how many were written down before."""
    folders: Queue[Path] = Queue()
    for number in range(processes):
        folders.put(copy_of_the_project(BUILD / str(number)))
    journal = BUILD / f"outcomes-{state_of_the_project(BUILD / '0')}.jsonl"
    written = dict(json.loads(line) for line in journal.read_text().splitlines()) if journal.exists() else {}

    def outcome(w: Weakened | Answered) -> str:
        if w.key in written:
            return written[w.key]
        folder = folders.get()
        try:
            found = outcome_of(w, folder)
        finally:
            folders.put(folder)
        with journal.open("a") as file:  # one short line: written at once
            file.write(json.dumps([w.key, found]) + "\n")
        return found

    with ThreadPoolExecutor(processes) as pool:
        found = list(tqdm(pool.map(outcome, chosen), total=len(chosen), unit="bound", disable=None))
    return found, sum(w.key in written for w in chosen)


def state_of_the_project(folder: Path) -> str:
    """A digest of the copied files."""
    digest = hashlib.sha256()
    for path in sorted(p for p in folder.rglob("*") if p.is_file()):
        digest.update(str(path.relative_to(folder)).encode() + b"\0" + path.read_bytes())
    return digest.hexdigest()[:16]


def outcome_of(w: Weakened | Answered, folder: Path) -> str:
    """noticed, survived, or equivalent."""
    if w.equivalent:
        return "equivalent"
    return "noticed" if is_noticed(w, folder) else "survived"


def is_noticed(w: Weakened | Answered, folder: Path) -> bool:
    """Whether the test fails with the weaker line, or its module (2: what it needs is refused), and not for want of a
    test (4 and 5)."""
    return _run(w, [w.test], folder)[0] in (1, 2)


def _run(w: Weakened | Answered, tests: Sequence[str], folder: Path) -> tuple[int, str]:
    """(exit code, output) of the tests with the weaker line; -1 if they do not end, which notices nothing."""
    path = folder / w.file
    text = path.read_text()
    planted = w.planted(text)
    ast.parse(planted)  # a line that is no Python would be noticed by every test
    path.write_text(planted)
    command = [sys.executable, "-m", "pytest", "-q", "-x", *PYTEST, *tests]
    environment = {**os.environ, "PYTHONPATH": str(folder), "PYTHONDONTWRITEBYTECODE": "1"}
    try:
        run = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, timeout=SECONDS)
        return run.returncode, run.stdout
    except subprocess.TimeoutExpired:
        return -1, ""
    finally:
        path.write_text(text)


def search(places: Sequence[Site]) -> int:
    """A line of JSON for each place: its key and the first test of its room that fails, or null; 0 if none is null.

    The tests that notice something else in the same file come first, then those of the room and the examples.
    """
    folder, silent = copy_of_the_project(ROOT / "build" / "weakened_search"), 0
    with (folder / "tests" / "conftest.py").open("a") as file:
        file.write(FORGET)
    for site in places:
        near = Counter(w.test for w in (*listed(), *answered()) if w.file == site.file and w.test)
        room = Path(site.file).parent.relative_to("asymptotics")
        rooms = [f"tests/{room}", *(["tests/ladders"] if str(room) != "comparison" else []), site.file]
        tests = [*(test for test, _ in near.most_common()), *(t for t in rooms if (folder / t).exists())]
        outside = ["--ignore=tests/ladders/test_weakened.py"]
        code, output = _run(Answered(site), [*tests, *outside], folder)
        failed = re.findall(r"^(?:FAILED|ERROR) ([^\s\[]+)", output, re.MULTILINE)
        found = failed[0] if code == 1 and failed else None
        silent += found is None
        print(json.dumps({site.key: found}), flush=True)
    return int(silent > 0)


def table(outcomes: Sequence[tuple[Weakened | Answered, str]]) -> Table:
    """A row for each room."""
    counts = Counter((w.room, outcome) for w, outcome in outcomes)
    rooms = sorted({w.room for w, _ in outcomes})
    outcome = ("noticed", "equivalent", "survived")
    rows = tuple((room, *(str(counts[room, name]) for name in outcome)) for room in rooms)
    return Table("Bounds that were weakened", ("room", *outcome), rows)


if __name__ == "__main__":
    sys.exit(main())
