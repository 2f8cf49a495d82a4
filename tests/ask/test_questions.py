"""Every question says all that shell, Python, the header of a file and the axes of a sweep need."""

import argparse
import ast
import inspect
import json
from pathlib import Path
from typing import Annotated

import pytest

import asymptotics as asy
from asymptotics.ask.answers import Offers
from asymptotics.ask.axes import read_axes
from asymptotics.ask.kinds import whole
from asymptotics.ask.question import Question, question
from asymptotics.ask.registry import QUESTIONS, loaded, summary
from asymptotics.ask.typed import stated_request
from asymptotics.errors import InputError
from asymptotics.shell.asked import Command
from asymptotics.shell.main import main
from tests import every_question


def example(name):
    """What is asked of it, without its file: a hostile word is met before the file is."""
    return every_question.example(name, Path(), "no-such-file.csv")[1:]


def run(capsys, *words):
    try:
        code = main(list(words))
    except SystemExit as stop:
        code = int(stop.code or 0)
    return code, *capsys.readouterr()


def parsed(question: Question, words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser()
    Command(question).configure(parser)
    return parser.parse_args(words)


@pytest.mark.parametrize("name", QUESTIONS)
def test_a_question_says_all_that_others_need(name):
    question = loaded(name)
    assert question.page and summary(name) and question.example
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


@pytest.mark.parametrize("name", QUESTIONS)
def test_the_words_of_a_header_are_read_back(name):
    question = loaded(name)
    if question.offers.from_rest or not question.in_header:
        return
    try:
        options = parsed(question, example(name))
    except SystemExit:
        return
    words = question.words(options)
    command, point = stated_request(words)
    again = parsed(question, [v if not n else f"--{n.partition('.')[0]}={v}" for n, v in point.items()])
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
