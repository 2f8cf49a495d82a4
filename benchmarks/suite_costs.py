"""``python -m benchmarks.suite_costs``: which tests are dear and run nothing that cheaper ones do not run.

The fast tests run once under coverage with one context for each test (the module is a plugin of pytest then), a part of
the files in each of ``--processes``, and their processor time is taken.  No alarm is set meanwhile, as one that rings
inside the recorder of coverage never lets go of its lock; the tests of alarms are left out, and stay.  From the dearest
down, a test moves to ``make test-thorough`` if

* each line of the project that it runs is run by at least ``WITNESSES`` tests that stay,
* no list of weakened bounds names it, and another case of the same function stays, or it costs more than ``LONE``,
* it runs in this process: what another process runs is not seen, hence not judged,
* it is none of ``CONTENT``: statements and derivations are what is tested, whatever lines they share,

until the tests that stay cost no more than ``--seconds``.  Their names are added to ``tests/thorough.txt`` (``--anew``:
what stands there is measured and chosen again), and ``tests/conftest.py`` marks them as slow.  That the tests that stay
notice as many planted faults as before is asked by ``benchmarks.mutants`` and ``benchmarks.weakened``, not assumed.
"""

import argparse
import json
import os
import resource
import signal
import subprocess
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]
THOROUGH = ROOT / "tests" / "thorough.txt"
BUILD = ROOT / "build" / "suite"
WITNESSES = 1
DEAR, LONE = 0.1, 0.5
"""Seconds of the processor, under coverage: below the first nothing moves, below the second no function whole."""
CONTENT = ("tests/derivations/", "tests/paper_checks/test_every_statement")
ALARMED = {f"tests/{name}.py" for name in ("test_public_time", "test_budget", "test_time_limits", "shell/test_papers")}
SOURCES = "asymptotics,derivations,paper_checks"


@dataclass(frozen=True)
class Cost:
    """Seconds of the processor of one test, here and in its children, and the lines it runs."""

    name: str
    own: float
    children: float
    lines: frozenset[tuple[str, int]]

    @property
    def seconds(self) -> float:
        """All of it."""
        return self.own + self.children

    @property
    def function(self) -> str:
        """The test without its parameters."""
        return self.name.split("[")[0]


def pytest_configure() -> None:
    """No alarms."""
    signal.setitimer = lambda *_: (0.0, 0.0)  # type: ignore[assignment,misc]


def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    """The tests of this process's files: every ``of``-th one, from ``part`` on."""
    part, of = map(int, os.environ["SUITE_PART"].split("/"))
    files = sorted({item.nodeid.split("::")[0] for item in items} - ALARMED)
    mine = set(files[part::of])
    left_out = [item for item in items if item.nodeid.split("::")[0] not in mine]
    config.hook.pytest_deselected(items=left_out)
    items[:] = [item for item in items if item.nodeid.split("::")[0] in mine]


@pytest.hookimpl(hookwrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    """A context of coverage and a line of the log for each test."""
    from coverage import Coverage  # noqa: PLC0415  the plugin alone needs it

    current = Coverage.current()
    if current is not None:
        current.switch_context(item.nodeid)
    before = _used()
    yield
    own, children = (after - was for after, was in zip(_used(), before, strict=True))
    with (BUILD / "costs.jsonl").open("a") as log:  # one short line: written at once
        log.write(json.dumps([item.nodeid, round(own, 4), round(children, 4)]) + "\n")


def _used() -> tuple[float, float]:
    kinds = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    own, children = (kind.ru_utime + kind.ru_stime for kind in kinds)
    return own, children


def main(argv: list[str] | None = None) -> int:
    """Measure (or read the last measurement), choose, and write the list."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.suite_costs", description=__doc__)
    parser.add_argument("--seconds", type=float, default=300, help="processor time that stays (default 300)")
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1, help="default: as many as cores")
    parser.add_argument("--again", action="store_true", help="choose again from the last measurement")
    parser.add_argument("--anew", action="store_true", help="measure and choose what has moved before, too")
    options = parser.parse_args(argv)
    if options.anew:
        THOROUGH.write_text("")
    before = {*THOROUGH.read_text().splitlines()}
    if not options.again:
        _measure(options.processes)
    costs = [cost for cost in _costs() if cost.name not in before]
    moved = chosen(costs, options.seconds, _named())
    THOROUGH.write_text("".join(f"{name}\n" for name in sorted(before | moved)))
    whole, spared = (sum(c.seconds for c in costs if c.name in names) for names in ({c.name for c in costs}, moved))
    print(f"{len(costs)} tests, {whole:.0f} s of processor time; {len(moved)} moved, {whole - spared:.0f} s stay")
    return 0


def _measure(processes: int) -> None:
    BUILD.mkdir(parents=True, exist_ok=True)
    for old in (BUILD / "costs.jsonl", *BUILD.glob("coverage*")):
        old.unlink(missing_ok=True)
    tests = ["-m", "pytest", "-p", "no:xdist", "-p", "benchmarks.suite_costs", "-m", "not slow", "--timeout", "1200"]
    running = []
    for part in range(processes):
        trace = ["-m", "coverage", "run", f"--source={SOURCES}", f"--data-file={BUILD / f'coverage{part}'}"]
        place = {**os.environ, "SUITE_PART": f"{part}/{processes}"}
        running.append(subprocess.Popen([sys.executable, *trace, *tests], cwd=ROOT, env=place))
    for process in running:
        process.wait()


def _costs() -> Iterator[Cost]:
    from coverage import CoverageData  # noqa: PLC0415  as above

    ran: dict[str, set[tuple[str, int]]] = {}
    for part in sorted(BUILD.glob("coverage*")):
        data = CoverageData(str(part))
        data.read()
        for file in data.measured_files():
            for number, contexts in data.contexts_by_lineno(file).items():
                for context in contexts:
                    ran.setdefault(context, set()).add((file, number))
    for line in (BUILD / "costs.jsonl").read_text().splitlines():
        name, own, children = json.loads(line)
        yield Cost(name, own, children, frozenset(ran.get(name, ())))


def _named() -> set[str]:
    """The tests that notice a weakened bound."""
    texts = [(Path(__file__).with_name(name)).read_text() for name in ("weakened_bounds.json", "bound_sites.json")]
    found = [entry.get("test", "") for entry in json.loads(texts[0])]
    found += [entry.get("test", "") for entry in json.loads(texts[1])["answers"].values()]
    return {*found}


def chosen(costs: list[Cost], seconds: float, named: set[str]) -> set[str]:
    """The names of the tests that move.

    >>> both, one = frozenset({("f", 1), ("f", 2)}), frozenset({("f", 1)})
    >>> tests = [Cost("a[1]", 9, 0, both), Cost("a[2]", 1, 0, both), Cost("b", 0.05, 0, both), Cost("c", 5, 0, one)]
    >>> sorted(chosen(tests, 1, {"c"}))
    ['a[1]', 'a[2]']
    >>> sorted(chosen([*tests, Cost("d", 3, 0, frozenset({("g", 1)}))], 1, {"c"}))             # alone on its line
    ['a[1]', 'a[2]']
    """
    taken = Counter(line for cost in costs for line in cost.lines)
    cases = Counter(cost.function for cost in costs)
    left, moved = sum(cost.seconds for cost in costs), set()
    for cost in sorted(costs, key=lambda c: -c.seconds):
        if left <= seconds or cost.seconds < DEAR:
            break
        alone = cases[cost.function] == 1 and cost.seconds < LONE
        seen = cost.children < 0.2 * cost.seconds and bool(cost.lines)
        if cost.function in named or alone or not seen or cost.name.startswith(CONTENT):
            continue
        if all(taken[line] > WITNESSES for line in cost.lines):
            moved.add(cost.name)
            taken.subtract(cost.lines)
            cases[cost.function] -= 1
            left -= cost.seconds
    return moved


if __name__ == "__main__":
    sys.exit(main())
