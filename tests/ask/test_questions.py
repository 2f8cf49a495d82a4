"""Every question under hostile values, wherever it is asked: shell, Python, header of a file, axes of a sweep."""

import argparse
import ast
import inspect
import json
import re
import shlex
from dataclasses import replace
from pathlib import Path
from typing import Annotated

import pytest

import asymptotics as asy
from asymptotics.ask.answers import Offers
from asymptotics.ask.axes import read_axes
from asymptotics.ask.kinds import REAL, whole
from asymptotics.ask.question import Question, question
from asymptotics.ask.registry import QUESTIONS, loaded, summary
from asymptotics.ask.typed import stated_request
from asymptotics.errors import InputError
from asymptotics.shell.asked import Command
from asymptotics.shell.main import main

HOSTILE = ("", "x", "nan", "-inf", "1e400", "2.5e", "1,5", "__import__('os')", "\ud800", "²", "-1/0", "9" * 200)
OBJECTS = (None, True, 1j, float("nan"), [], {}, object(), b"1", lambda: 0)
CHEAP = {  # a request that is answered at once; what is asked of it is changed one option at a time
    "stokes": "--alpha 0",
    "moment": "--p 2 --digits 5",
    "limit-cycle": "--law 1:-1 --law 1,2:1 --order 2 --digits 5",
    "response": "--law 2:1/10 --force 1/5 --omega 1 --digits 5",
    "turning-points": "--alpha 2 --epsilon 1/10 --count 1 --digits 5",
    "half-swing": "--alpha 2 --order 1 --digits 5",
    "expand": "--alpha 2 --order 1 --digits 5",
    "smith": "f --n 2",
    "derive": "",
    "papers": "smith2012:43",
    "table": "moments --alpha 1 --digits 5",
    "multiple-scales": "--alpha 3 --order 1",
    "motion": "--alpha 0 --epsilon 1/10 --time 1 --reference --digits 5",
    "solution": "--alpha 3 --order 1",
    "envelope": "--alpha 2 --epsilon 1/10 --digits 5",
    "damping": "--alpha 1 --epsilon 1/10 --digits 5",
    "compare": "no-such-file.csv",
    "identify": "no-such-file.csv",
    "sweep": "moment --p 1 --store no-such-folder",
}
SCALARS = [
    pytest.param(name, asked.option, id=f"{name} {asked.option.name}")
    for name in QUESTIONS
    for asked in loaded(name).asked
    if asked.kind.in_shell and not asked.kind.options and asked.kind.letter and not asked.kind.place
]


def run(capsys, *words):
    try:
        code = main(list(words))
    except SystemExit as stop:
        code = int(stop.code or 0)
    return code, *capsys.readouterr()


def parsed(question: Question, line: str) -> argparse.Namespace:
    parser = argparse.ArgumentParser()
    Command(question).configure(parser)
    return parser.parse_args(shlex.split(line))


@pytest.mark.parametrize("name", QUESTIONS)
def test_a_question_says_all_that_others_need(name):
    question = loaded(name)
    assert question.page and summary(name) and name in CHEAP
    for asked in question.asked:
        assert asked.help, f"{name}: {asked.name} has no line under Parameters"
        assert all(o.help for o in asked.options)
    options = [o.name for o in question.options]
    assert len(options) == len(set(options))
    plain = inspect.signature(question.function).parameters.values()
    assert all(p.annotation is not p.empty for p in plain)


def test_the_summary_is_the_first_line_of_the_file_and_no_file_is_parsed_for_it(monkeypatch):
    """Each command parsed the files of all: 32 ms of the 34 that an answer took."""
    files = {name: Path(inspect.getsourcefile(inspect.unwrap(loaded(name).function))) for name in QUESTIONS}
    lines = {name: ast.get_docstring(ast.parse(p.read_text())).partition("\n")[0] for name, p in files.items()}
    monkeypatch.setattr(ast, "parse", lambda *_, **__: pytest.fail("a file is parsed"))
    assert {name: summary(name) for name in QUESTIONS} == {name: line.rstrip(".") for name, line in lines.items()}


@pytest.mark.parametrize("name", QUESTIONS)
def test_the_schema_is_that_of_the_options(capsys, name):
    code, out, err = run(capsys, name, "--schema")
    schema = json.loads(out)
    assert (code, err, schema["title"], schema["additionalProperties"]) == (0, "", name, False)
    question = loaded(name)
    assert set(schema["properties"]) == {o.name for a in question.asked for o in a.options}
    assert set(schema["required"]) == {o.name for a in question.asked for o in a.options if o.needed}
    for told in schema["properties"].values():
        assert told["description"] and ("enum" in told or told["type"] in ("string", "integer", "boolean", "array"))


@pytest.mark.parametrize(("name", "option"), SCALARS)
def test_a_hostile_text_is_refused_by_the_name_of_its_option_or_answered(capsys, tmp_path, monkeypatch, name, option):
    monkeypatch.chdir(tmp_path)  # a store of any name is made
    for text in HOSTILE:
        code, out, err = run(capsys, name, *shlex.split(CHEAP[name]), f"--{option.name}={text}", "--max-seconds", "2")
        assert code in (0, 1, 2), (name, text, err)
        if code == 2 and "no-such-file" not in CHEAP[name]:
            assert err.count("\n") == 1 and re.search(r"argument (-|[A-Z])", err), (name, text, err)
            assert out == "" or "cut short" in out


@pytest.mark.parametrize(
    "name", [n for n in QUESTIONS if hasattr(getattr(asy, n.replace("-", "_"), None), "__question__")]
)
def test_a_hostile_object_is_refused_by_the_name_of_its_parameter(name):
    question, call = loaded(name), getattr(asy, name.replace("-", "_"))
    good = question.of_options(parsed(question, CHEAP[name]))
    for asked in question.asked:
        for value in OBJECTS:
            if asked.kind.options or value is asked.default or asked.name == "name" and value is None:
                continue
            given = {**{a.name: good[a.name] for a in question.asked if a.default is inspect.Parameter.empty}}
            if "law" in inspect.signature(call).parameters and any(a.kind.options for a in question.asked):
                given["law"] = {1: -1, (1, 2): 1} if name == "limit-cycle" else {2: "1/10"}
            try:
                call(**{**given, asked.name: value, "max_seconds": 2})
            except InputError as error:
                assert "argument -" not in str(error)


@pytest.mark.parametrize("name", QUESTIONS)
def test_the_words_of_a_header_are_read_back(name):
    question = loaded(name)
    if question.offers.from_rest or not question.in_header:
        return
    try:
        options = parsed(question, CHEAP[name])
    except SystemExit:
        return
    words = question.words(options)
    command, point = stated_request(words)
    again = parsed(question, " ".join(v if not n else f"--{n.partition('.')[0]}={v}" for n, v in point.items()))
    assert command == name and question.words(again) == words
    for stray in ("--csv=a.csv", "--plot=a.svg", "--wrong=1", "--json"):
        with pytest.raises(InputError):
            stated_request([*words, stray])


@pytest.mark.parametrize("name", [n for n in QUESTIONS if loaded(n).swept])
def test_the_axes_of_a_sweep_are_the_parameters(name):
    question = loaded(name)
    for option in (o for a in question.asked for o in a.options if o.letter and not o.place):
        if option.name == "max-seconds":
            continue
        text = {"law": "2:1/10", "spring": "3:1/10", "route": "dry"}.get(option.name) or (option.words or ("1",))[0]
        assert read_axes(name, [f"--{option.name}={text}"])
    for option in question.offers.options():
        with pytest.raises(InputError):
            read_axes(name, [f"--{option.name}=1"])


def test_a_kind_that_does_not_refuse_is_noticed(capsys, tmp_path, monkeypatch):
    """Near misses: a reader that takes anything, and one that names nothing, are seen by the walks above."""
    question = loaded("stokes")
    deaf = replace(question["alpha"], kind=replace(REAL, read=lambda value, name: value))
    monkeypatch.setattr(
        "asymptotics.shell.asked.loaded", lambda name: replace(question, asked=(deaf, *question.asked[1:]))
    )
    with pytest.raises(AssertionError):
        test_a_hostile_text_is_refused_by_the_name_of_its_option_or_answered(
            capsys, tmp_path, monkeypatch, "stokes", deaf.option
        )
    assert whole(1, 9).read("4", "n") == 4


def test_a_parameter_that_no_kind_reads_is_no_declaration():
    """A spring beside a law was lost so: half_swing([2], spring={3: 1}) answered for the linear spring."""
    assert "1,1" in asy.half_swing([2], spring={3: 1}, order=2).U
    assert asy.limit_cycle({1: -1, (1, 2): 1}, spring={3: 1}, mu=1, digits=3).amplitude == {}

    def unread(count: Annotated[int, whole(1, 9)], spring: object = None) -> int:
        """None.

        Parameters
        ----------
        count
            how many
        """
        return count

    with pytest.raises(TypeError, match="no kind reads spring"):
        question(Offers())(unread)
