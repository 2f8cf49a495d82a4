"""``python -m benchmarks.mutants [GROUP ...]``: how many planted faults the tests notice, group by group.

mutmut plants one fault at a time (an operator, a constant, an argument) in a copy of the project in ``build/mutants``
and runs the tests that mirror the group.  A seeded sample is taken of all mutants but those that change only a text.

A survivor is listed in ``benchmarks/equivalent_mutants.json`` with the reason why no test can notice it, or shown.

    score = killed / (sampled - equivalent)
"""

import json
import os
import random
import re
import shutil
import subprocess
import sys
import time
from dataclasses import asdict, dataclass
from pathlib import Path

from asymptotics.shell.guarded import emit, run_guarded
from asymptotics.shell.main import Parser
from benchmarks.table import Table

ROOT = Path(__file__).parents[1]
BUILD = ROOT / "build" / "mutants"
EQUIVALENT = Path(__file__).with_name("equivalent_mutants.json")
PYTEST = ("-p", "no:xdist", "-p", "no:cacheprovider", "-m", "not slow")
WANTED = 0.9
FORGET = '''

import functools, gc

CACHES = []


def pytest_collection_finish(session):
    gc.unfreeze()
    found = [o for o in gc.get_objects() if isinstance(o, functools._lru_cache_wrapper)]
    CACHES[:] = [o for o in found if (o.__module__ or "").startswith("asymptotics")]


def pytest_runtest_setup(item):
    """A test that is answered from memory reaches no fault, and mutmut would not even choose it."""
    for cache in CACHES:
        cache.cache_clear()
'''


@dataclass(frozen=True)
class Group:
    """What is mutated, which tests must notice, and which of these cannot run on wrapped functions."""

    sources: tuple[str, ...]
    tests: tuple[str, ...]
    ignored: tuple[str, ...] = ()


BESIDES = {  # tests of other rooms that notice faults of a room
    "motions/invariants": ("tests/curves/test_constants.py",),
    "envelopes": (
        "tests/curves/test_evaluated.py",
        "tests/curves/test_implicit.py",
        "tests/curves/test_proved_curve.py",
        "tests/curves/test_shown_solution.py",
        "tests/curves/test_slow_numbers.py",
        "tests/curves/test_solution.py",
        "tests/curves/test_started.py",
    ),
    "flow/linear_spring": (
        "tests/flow/test_error_propagation_ratios.py",
        "tests/return_map/test_half_swing_map.py",
        "tests/return_map/test_sequence.py",
    ),
    "turning": ("tests/flow/linear_spring/test_near_critical.py",),
    "decays/comparison": ("tests/curves/test_files.py",),
}


def _room(name: str, *ignored: str) -> Group:
    tests = (f"tests/{name}", *BESIDES.get(name, ()), f"asymptotics/{name}")
    return Group((f"asymptotics/{name}",), tests, ignored)


ROOMS = (
    "motions/invariants",
    "expansions/half_swings",
    "expansions/normal_form",
    "flow/linear_spring",
    "flow/slow_manifold",
    "return_map",
    "turning",
    "envelopes",
    "bounds",
    "limit_cycles",
    "decays/comparison",
    "decays/identification",
)
GROUPS = {
    "numbers": _room("numbers", "tests/numbers/test_contract.py"),  # it inspects signatures, which mutmut hides
    "verdict": Group(("paper_checks/verdict.py",), ("tests/paper_checks/test_verdict.py", "paper_checks/verdict.py")),
    "grading": Group(  # the part of half_swings on which every sign rests, with the tests that are quick
        ("asymptotics/expansions/half_swings/grading.py", "asymptotics/expansions/half_swings/quarter.py"),
        (
            "tests/expansions/half_swings/test_grading.py",
            "tests/expansions/half_swings/test_exact.py",
            "asymptotics/expansions/half_swings/grading.py",
        ),
    ),
    **{room.split("/")[-1]: _room(room) for room in ROOMS},
}


@dataclass(frozen=True)
class Survivor:
    """A mutant that no test noticed: where, and the line without and with the fault."""

    function: str
    line: str
    mutated: str


@dataclass(frozen=True)
class Score:
    """What became of the sample of one group; mutants that ran out of time count as killed, untested ones as alive."""

    group: str
    mutants: int
    sampled: int
    killed: int
    equivalent: int
    survivors: tuple[Survivor, ...]
    seconds: float

    @property
    def ratio(self) -> float:
        """killed / (sampled - equivalent)."""
        return self.killed / max(1, self.sampled - self.equivalent)


def main(argv: list[str] | None = None) -> int:
    """Run the groups; 0 if every score is at least ``WANTED``, else 1."""
    return run_guarded("mutants", lambda: _run(argv), last=argv is None)


def _run(argv: list[str] | None) -> int:
    parser = Parser(prog="python -m benchmarks.mutants", description=__doc__)
    parser.add_argument("groups", nargs="*", help=", ".join(GROUPS))
    parser.add_argument("--sample", type=int, default=60, help="mutants of each group (default 60)")
    parser.add_argument("--seconds", type=int, default=240, help="time limit of each group (default 240)")
    parser.add_argument("--seed", type=int, default=0, help="another seed draws another sample (default 0)")
    parser.add_argument("--processes", type=int, default=os.cpu_count() or 1, help="default: as many as cores")
    options = parser.parse_args(argv)
    unknown = sorted(set(options.groups) - set(GROUPS))
    if unknown:
        parser.error(f"no group {unknown[0]!r}: {', '.join(GROUPS)}")
    how = options.sample, options.seed, options.seconds, options.processes
    scores = [measure(name, *how) for name in options.groups or GROUPS]
    (BUILD / "scores.json").write_text(json.dumps([asdict(score) for score in scores], indent=2))
    emit(_table(scores, options.sample, options.seed).text())
    for score in scores:
        for s in score.survivors:
            emit(f"\n{s.function}\n  - {s.line}\n  + {s.mutated}")
    return int(any(score.ratio < WANTED for score in scores))


def measure(group: str, sample: int, seed: int, seconds: int, processes: int) -> Score:
    """Plant the sample of one group and run its tests."""
    start = time.monotonic()
    folder = _copy(group)
    _mutmut(folder, ["no mutant has this name"], seconds, processes)  # writes the mutants and runs none
    names = sorted(_outcomes(folder))
    drawn = random.Random(f"{seed} {group}").sample(names, min(len(names), 3 * sample))
    planted = {name: fault for name, fault in _faults(folder, drawn).items() if not _only_text(fault)}
    faults = dict(list(planted.items())[:sample])
    _mutmut(folder, [*faults], seconds, processes)
    codes = {name: code for name, code in _outcomes(folder).items() if name in faults and code is not None}
    if not codes:
        print(f"{group}: no mutant was judged: see {(folder / 'mutmut.log').relative_to(ROOT)}", file=sys.stderr)
    alive = [faults[name] for name, code in codes.items() if code in (0, 33)]  # 33: no test reaches it
    known = json.loads(EQUIVALENT.read_text())
    surviving = tuple(s for s in alive if f"{s.line} -> {s.mutated}" not in known.get(s.function, {}))
    killed, equivalent = len(codes) - len(alive), len(alive) - len(surviving)
    return Score(group, len(names), len(codes), killed, equivalent, surviving, time.monotonic() - start)


def copy_of_the_project(folder: Path) -> Path:
    """The tracked files as they are now, in a new folder."""
    shutil.rmtree(folder, ignore_errors=True)
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True).stdout
    for name in filter(None, listed.split("\0")):
        if (ROOT / name).is_file():
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, folder / name)
    return folder


def _copy(group: str) -> Path:
    """The tracked files under build/mutants/GROUP, with the settings of mutmut for this group."""
    folder = copy_of_the_project(BUILD / group)
    plan = GROUPS[group]
    top = sorted(path.name for path in folder.iterdir() if path.name != "pyproject.toml")
    settings = {
        "source_paths": plan.sources,
        "also_copy": top,
        "pytest_add_cli_args_test_selection": [test for test in plan.tests if (folder / test).exists()],
        "pytest_add_cli_args": [*PYTEST, *(f"--ignore={test}" for test in plan.ignored)],
    }
    lines = [f"{key} = {json.dumps(value)}" for key, value in settings.items()]
    with (folder / "pyproject.toml").open("a") as file:
        file.write("\n".join(["", "[tool.mutmut]", *lines, ""]))
    with (folder / "tests" / "conftest.py").open("a") as file:
        file.write(FORGET)
    return folder


def _mutmut(folder: Path, names: list[str], seconds: int, processes: int) -> None:
    command = [sys.executable, "-m", "mutmut", "run", "--max-children", str(processes), *names]
    try:
        with (folder / "mutmut.log").open("w") as log:
            subprocess.run(command, cwd=folder, stdout=log, stderr=log, timeout=seconds)
    except subprocess.TimeoutExpired:
        print(f"{folder.name}: stopped after {seconds} s; the score is that of the mutants done", file=sys.stderr)


def _outcomes(folder: Path) -> dict[str, int | None]:
    found: dict[str, int | None] = {}
    for path in (folder / "mutants" / "asymptotics").rglob("*.meta"):
        found |= json.loads(path.read_text())["exit_code_by_key"]
    return found


def _faults(folder: Path, names: list[str]) -> dict[str, Survivor]:
    """The changed lines of each mutant; all are asked for in one process, for starting one takes seconds."""
    program = (
        "import sys; from mutmut.mutation.diff_apply import get_diff_for_mutant as diff\n"
        "for name in sys.argv[1:]: print('#mutant', name); print(diff(name))"
    )
    command = [sys.executable, "-c", program, *names]
    shown = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True).stdout
    found = {}
    for part in shown.split("#mutant ")[1:]:
        name, *lines = part.splitlines()
        minus = " ".join(line[1:].strip() for line in lines if line.startswith("-") and not line.startswith("---"))
        plus = " ".join(line[1:].strip() for line in lines if line.startswith("+") and not line.startswith("+++"))
        found[name] = Survivor(name.split("__mutmut_")[0], minus, plus)
    return found


def _only_text(fault: Survivor) -> bool:
    """Whether the fault changes a message, a name in one, or ``strict`` only: that is not what is measured."""
    message = any(word in fault.line for word in ("Error(", "accepted =", "reason =", "description=", "help="))
    same = _without_strict(fault.line) == _without_strict(fault.mutated)  # a check of ours
    return message or same or "XX" in fault.mutated


def _without_strict(line: str) -> str:
    return re.sub(r",\s*(strict=\w+)?\s*\)", ")", line)


def _table(scores: list[Score], sample: int, seed: int) -> Table:
    columns = ("group", "mutants", "sampled", "killed", "equivalent", "score", "seconds")
    counts = [(s.mutants, s.sampled, s.killed, s.equivalent) for s in scores]
    rows = [(s.group, *map(str, n), f"{s.ratio:.0%}", f"{s.seconds:.0f}") for s, n in zip(scores, counts)]
    return Table(f"planted faults, at most {sample} a group, seed {seed}", columns, tuple(rows))


if __name__ == "__main__":
    sys.exit(main())
