"""No test can hang: each has a limit of time, and one that runs into it fails and is named."""

import json
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

import asymptotics as asy
from asymptotics.running.budget import budget

HANGS = "import time\n\ndef test_without_end():\n    while True:\n        time.sleep(0.01)\n"


def test_a_test_without_end_is_ended_and_named(tmp_path):
    (tmp_path / "test_hangs.py").write_text(HANGS)
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "--timeout", "1", "--timeout-method", "thread"]
    run = subprocess.run([*command, "test_hangs.py"], cwd=tmp_path, capture_output=True, text=True, timeout=60)
    assert run.returncode == 1 and "Timeout" in run.stdout and "test_without_end" in run.stdout


def test_the_limit_is_on(request):
    assert 0 < float(request.config.getini("timeout")) <= 300


def unknown(names, collected):
    """The names that no test has, of files that were collected; of others, those without a file."""
    files = {name.split("::")[0] for name in collected}
    there = Path(__file__).parents[1]
    return [
        n
        for n in names
        if n not in collected and (n.split("::")[0] in files or not (there / n.split("::")[0]).exists())
    ]


def test_what_moved_to_the_thorough_tests_exists(request, collected):
    """Failed before: 31 cases had got other names, and were in the quick run again."""
    names = (Path(__file__).with_name("thorough.txt")).read_text().splitlines()
    assert names == sorted({*names})
    if not any("::" in asked for asked in request.config.args):
        assert unknown(names, collected) == []


def test_a_case_with_another_name_is_noticed():
    here = "tests/test_time_limits.py::test_a[{}]"
    assert unknown([here.format(1), here.format(2)], {here.format(1)}) == [here.format(2)]
    assert unknown(["tests/test_none.py::test_a", "tests/test_law.py::test_a"], set()) == ["tests/test_none.py::test_a"]


LISTS = ("weakened_bounds.json", "bound_sites.json")
NEVER_QUICK = {
    f"tests/{name}.py"
    for name in (
        "curves/test_implicit", "decays/identification/judging/test_exact_ratio", "decays/identification/test_coverage",
        "flow/wells/test_random_wells", "motions/test_asymptotic_springs_error", "present/test_figures",
        "properties/test_swings",
    )
}  # fmt: skip
"""Files whose claims have cheaper tests in others."""


def never_quick(names, collected, quick):
    """Of these tests and files those that were collected, and of which no case is quick."""

    def parts(tests):
        return {part for name in tests for part in (name, name.split("[")[0], name.split("::")[0])}

    there, stay = parts(collected), parts(quick)
    return {name for name in names if name in there and name not in stay}


def test_what_notices_a_weakened_bound_and_a_test_of_every_file_stay_in_make_test(request, collected, quick):
    """Whatever else is moved to the thorough tests; which planted faults the cases that stay notice, they ask."""
    lists = [json.loads((Path(__file__).parents[1] / "benchmarks" / name).read_text()) for name in LISTS]
    named = {entry["test"] for entry in [*lists[0], *lists[1]["answers"].values()] if "test" in entry}
    assert len(named) > 300 and never_quick(named, collected, quick) == set()
    if not any("::" in asked for asked in request.config.args):
        files = {name.split("::")[0] for name in collected if name.startswith("tests/")}
        assert never_quick(files, collected, quick) == NEVER_QUICK & files


def test_what_left_make_test_whole_is_noticed():
    every = {"tests/test_a.py::test_a[1]", "tests/test_a.py::test_a[2]", "tests/test_b.py::test_b"}
    asked = {"tests/test_a.py::test_a", "tests/test_a.py::test_a[2]", "tests/test_b.py", "tests/test_c.py"}
    stays = {"tests/test_a.py::test_a[1]"}
    assert never_quick(asked, every, stays) == {"tests/test_a.py::test_a[2]", "tests/test_b.py"}
    assert never_quick(asked, every, every) == set()


@pytest.mark.slow
def test_a_slow_test_has_a_longer_limit(request):
    assert request.node.get_closest_marker("timeout").args[0] > float(request.config.getini("timeout"))


class Item:
    """A collected test, as much of it as the order asks for."""

    def __init__(self, name, slow):
        self.nodeid, self.slow = name, slow

    def get_closest_marker(self, name):
        return self.slow and name == "slow" or None

    def add_marker(self, marker):
        """It has it."""


def test_each_slow_test_has_its_turn_in_one_week_of_four(request, monkeypatch):
    conftest = request.config.pluginmanager.get_plugin(str(Path(__file__).with_name("conftest.py")))
    hook = SimpleNamespace(pytest_deselected=lambda items: None)
    every, turns = [Item(f"tests/test_a.py::test_slow[{n}]", True) for n in range(40)], []
    for week in ("50", "51", "52", "01", "02"):
        monkeypatch.setenv("SHARE", week)
        items = [*every, Item("tests/test_a.py::test_quick", False)]
        conftest.pytest_collection_modifyitems(SimpleNamespace(hook=hook, stash={}), items)
        assert not items[-1].slow
        turns.append({item.nodeid for item in items if item.slow})
    assert set.union(*turns[:4]) == {item.nodeid for item in every} and sum(map(len, turns[:4])) == len(every)
    assert turns[3] != turns[2] and turns[4] == turns[0]


class StartedError(Exception):
    """The work has begun."""


DEAR = {  # more than a minute each, and less than a day
    "turning points": lambda: asy.turning_points({"3/2": 1}, 50_000, digits=200),
    "turning points of 2": lambda: asy.turning_points({2: "1/10"}, 100_000, digits=1000, times=True),
    "half-swing": lambda: asy.half_swing("3/2", order=200, digits=1000),
    "expand": lambda: asy.expand("3/2", order=200, digits=1000),
    "expand, exact": lambda: asy.expand([1, 2, 3, 4], order=14),
    "multiple scales, odd": lambda: asy.multiple_scales([1, 3, 5], order=60),
    "table": lambda: asy.table("turning-points", alpha="3/2", epsilon=1, rows=50_000, digits=200),
    "stokes": lambda: asy.stokes("101/100", digits=60),
    "curve": lambda: asy.reference({"3/2": "1/10"}).sample([0.0, 1e8]),
}


@pytest.mark.parametrize("ask", DEAR.values(), ids=DEAR)
def test_what_is_too_much_for_a_minute_begins_where_more_time_is_given(ask):
    def started(stage):
        raise StartedError(stage)

    with pytest.raises(asy.LimitError):
        ask()
    with pytest.raises(StartedError), budget(1e7, started):
        ask()
