"""A task of the caller's own: a corrected one is computed again, and its faults are not kept."""

import threading
from functools import partial

import pytest

from asymptotics.errors import InputError
from asymptotics.sweeps import Grid, sweep
from asymptotics.sweeps.callers import caller_mark

FACTOR = 2


def helper(n):
    return FACTOR * n


def doubled(point):
    return {"value": str(helper(int(point["n"])))}


def made(text):
    names = {"__name__": "somewhere"}
    exec(text, names)
    return names["task"]


TEXTS = {
    "as it is": "def task(p): return {'v': p['n'] + '1'}",
    "a constant": "def task(p): return {'v': p['n'] + '2'}",
    "a default": "def task(p, more='1'): return {'v': p['n'] + more}",
    "a helper": "def h(n): return n + '1'\ndef task(p): return {'v': h(p['n'])}",
    "another helper": "def h(n): return n + '2'\ndef task(p): return {'v': h(p['n'])}",
    "a global": "C = '1'\ndef task(p): return {'v': p['n'] + C}",
    "another global": "C = '2'\ndef task(p): return {'v': p['n'] + C}",
    "a cell": "def o():\n    c = '1'\n    def task(p): return {'v': p['n'] + c}\n    return task\ntask = o()",
    "another cell": "def o():\n    c = '2'\n    def task(p): return {'v': p['n'] + c}\n    return task\ntask = o()",
    "inside": "def task(p): return {'v': [q + '1' for q in p['n']]}",
    "other inside": "def task(p): return {'v': [q + '2' for q in p['n']]}",
    "a set": "def task(p): return {'v': p['n'] in {'a', 'b', 'c'}}",
}


def test_other_code_has_another_mark_and_the_same_code_the_same():
    marks = {name: caller_mark(made(text)) for name, text in TEXTS.items()}
    assert len(set(marks.values())) == len(TEXTS) and all(len(mark) == 16 for mark in marks.values())
    assert marks == {name: caller_mark(made(text)) for name, text in TEXTS.items()}
    assert caller_mark(partial(doubled, 1)) != caller_mark(partial(doubled, 2)) != caller_mark(doubled)


def test_a_version_stands_for_the_code():
    one, two = made(TEXTS["a constant"]), made(TEXTS["as it is"])
    assert caller_mark(one, "1") == caller_mark(two, "1") != caller_mark(one, "2")
    assert caller_mark(one, "") == ""
    with pytest.raises(InputError, match="version="):
        caller_mark(partial(doubled, threading.Lock()))


def test_a_task_that_was_corrected_is_computed_again(tmp_path, monkeypatch):
    """Failed before: the old values were served, for the key knew the command and the point alone."""
    points = Grid({"n": ("1", "2")})
    assert sweep(doubled, "doubled", points, tmp_path / "s", workers=1).computed == 2
    assert sweep(doubled, "doubled", points, tmp_path / "s", workers=1).reused == 2
    monkeypatch.setitem(globals(), "FACTOR", 3)
    again = sweep(doubled, "doubled", points, tmp_path / "s", workers=1)
    assert (again.computed, again._table()["value"]) == (2, [3, 6])
    assert again._heading() == "doubled at 2 points"


def test_a_fault_of_the_task_is_tried_again(tmp_path):
    """Failed before: a KeyError, of a file that was not there yet, say, was kept for ever."""
    there = {}

    def looked_up(point):
        return {"value": there[point["n"]]}

    points = Grid({"n": ("1",)})
    first = sweep(looked_up, "looked up", points, tmp_path / "s", workers=1, version="1")
    there["1"] = "found"
    second = sweep(looked_up, "looked up", points, tmp_path / "s", workers=1, version="1")
    assert (first.failed, second.failed, second.computed) == (1, 0, 1)
