"""Errors of Python calls name Python's arguments; two arrays are a record; an array where one number is asked."""

import ast
import re
from pathlib import Path

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.errors import InputError

SHELL = re.compile(r"(?<![\w-])--[a-z]|\bFILE\b|\bNAME\b|`asymptotics ")
OSC = asy.Oscillator({2: "1/10"})
T, X = np.arange(0, 30, 0.1), np.exp(-0.05 * np.arange(0, 30, 0.1)) * np.cos(np.arange(0, 30, 0.1))
WRONG = {  # each failed before: FILE, NAME, --bound, --columns, --alpha A, --law A:E in what Python is told
    "a file that is not there": lambda: asy.identify("nowhere.csv"),
    "columns that are not clear": lambda: asy.identify({"a": T, "b": X}),
    "a header without a key": lambda: asy.compare({"a": [1], "b": [2]}, {2: 1}),
    "no such file": lambda: asy.compare("nowhere.csv", {2: 1}),
    "no law for coefficients": lambda: asy.compare({"k": [1]}, table="half-swing"),
    "one law of two": lambda: asy.table("two-law-times", law={2: 1}),
    "no such table": lambda: asy.table("smith2012.tabel1"),
    "nothing to compare with": lambda: asy.compare({"n": [0, 1], "x": [1, -0.5]}),
    "an order too high": lambda: asy.half_swing("symbolic", order=99),
    "an option of another command": lambda: asy.sweep_command("moment", {"x": "1"}, "nowhere"),
}


@pytest.mark.parametrize("name", WRONG)
def test_an_error_of_python_names_no_word_of_the_shell(name):
    with pytest.raises(InputError) as caught:
        WRONG[name]()
    assert not SHELL.search(str(caught.value)), str(caught.value)


def test_what_is_missing_is_named_as_python_has_it():
    """It was "argument alpha: is missing", which `compare` refuses without a table."""
    with pytest.raises(InputError, match=r"argument law: is missing \(accepted: a mapping"):
        WRONG["nothing to compare with"]()
    with pytest.raises(InputError, match="argument kind: 'none such' is unknown .*decrement, damping"):
        asy.identify({"n": [0, 1], "x": [1, -0.5]}, kind="none such")


@pytest.mark.parametrize("name", QUESTIONS)
def test_the_words_of_the_shell_become_those_of_python(name):
    made = loaded(name)
    told = made.in_python(InputError("--max-seconds", "--no-such-thing is typed", "--digits D with --max-seconds S"))
    assert str(told) == "argument max_seconds: no_such_thing is typed (accepted: digits D with max_seconds S)"
    untouched = InputError("law", "x--y is no word, 2 --", "-1 to 3")
    assert made.in_python(untouched) is untouched


def test_no_room_beside_the_questions_names_an_option():
    """Walk: whoever is called from Python without a question must not speak as the shell."""
    # Rooms whose errors pass through a question, which translates them.
    asked = {"ask", "shell", "decays", "sweeps", "tables", "present"}
    found = []
    for path in sorted(Path(asy.__file__).parent.rglob("*.py")):
        if path.relative_to(Path(asy.__file__).parent).parts[0] in asked:
            continue
        text = path.read_text()
        for node in ast.walk(ast.parse(text)) if "InputError(" in text or "LimitError(" in text else ():
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") in ("InputError", "LimitError"):
                texts = [n.value for n in ast.walk(node) if isinstance(n, ast.Constant) and isinstance(n.value, str)]
                found += [f"{path.name}:{node.lineno}: {text}" for text in texts if SHELL.search(text)]
    assert found == []


def test_two_arrays_are_a_record():
    found = asy.identify(T, X, laws=["1", "2"])
    assert found == asy.identify((T, X), laws=["1", "2"]) == asy.identify(T.tolist(), list(X), laws=["1", "2"])
    assert found == asy.identify((T.tolist(), X.tolist()), laws=["1", "2"])  # "a list is no data"
    assert not any("the float" in note for note in found.notes)  # a note for each sample


@pytest.mark.parametrize(
    ("data", "x", "argument"),
    [("a.csv", X, "data"), (T, "a.csv", "x"), ({"t": T}, X, "data"), (T, np.eye(3), "x"), (T, ["a", "b"], "x")],
)
def test_what_is_no_column_beside_another_is_refused_by_name(data, x, argument):
    with pytest.raises(InputError) as caught:
        asy.identify(data, x)
    assert caught.value.argument == argument


MANY = {
    "sample": (
        lambda t: asy.motion(OSC).at(t),
        lambda t: asy.reference(OSC).at(t),
        lambda t: asy.solution(OSC).at(t),
        lambda t: asy.solution({1: "1/10", 2: "1/20"}).at(t),
        lambda t: asy.waveforms("5/2").at(t),
    ),
    "amplitudes": (
        lambda t: asy.envelope(OSC).amplitude(t),
        lambda t: asy.envelope(asy.Oscillator({2: "1/10"}, spring={3: "1/5"})).amplitude(t),
    ),
    "phases": (
        lambda t: asy.envelope(OSC).phase(t),
        lambda t: asy.envelope(asy.Oscillator({2: "1/10"}, spring={3: "1/5"})).phase(t),
    ),
    "columns": (lambda t: asy.envelope(OSC).at_order(t),),
}


@pytest.mark.parametrize(("many", "call"), [(many, call) for many, calls in MANY.items() for call in calls])
def test_an_array_of_times_is_told_where_it_belongs(many, call):
    import pandas  # noqa: PLC0415 (the extra of identify)

    for times in ([0.0, 1.0], np.array([0.0]), pandas.Series([0.0, 1.0])):
        with pytest.raises(InputError, match=rf"for many: \.{many}\("):
            call(times)
