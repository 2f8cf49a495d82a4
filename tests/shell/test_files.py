"""Files that are not there are named by their option."""

import argparse

import pytest

from asymptotics.ask.registry import QUESTIONS
from asymptotics.shell.asked import command_of
from asymptotics.shell.main import main


def parser_of(command):
    parser = argparse.ArgumentParser(prog=command)
    command_of(command).configure(parser)
    return parser


FILES = {  # what a command needs before it looks at its files; sweep writes nothing before a point is done
    "compare": "mine.csv --alpha 2 --epsilon 1", "damping": "--alpha 2 --epsilon 1",
    "envelope": "--alpha 2 --epsilon 1 --time 1",
    "expand": "--alpha 2", "half-swing": "--alpha 2", "identify": "mine.csv", "limit-cycle": "--law 1:-1 --law 1,2:1",
    "motion": "--alpha 2 --epsilon 1 --time 1", "smith": "f --n 3", "solution": "--alpha 2 --epsilon 1 --time 1",
    "stokes": "--alpha 2", "sweep": "moment --p 1", "table": "moments",
    "turning-points": "--alpha 2 --epsilon 1 --count 2",
}  # fmt: skip
TAKEN = [
    (command, action.option_strings[-1])
    for command in QUESTIONS
    for action in parser_of(command)._actions
    if action.option_strings and action.metavar in ("FILE", "DIR")
]


def test_every_command_with_a_file_is_walked():
    assert {command for command, _ in TAKEN} <= set(FILES) and len(TAKEN) > 25
    assert ("damping", "--from") in TAKEN and ("sweep", "--list") in TAKEN


@pytest.mark.parametrize(("command", "option"), TAKEN)
def test_a_file_that_is_not_there_is_named_by_its_option(command, option, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.csv").write_text("n,x\n0,1\n1,-0.5\n")
    suffix = {"--plot": "svg", "--html": "html"}.get(option, "csv")
    line = FILES[command] if option != "--from" else ""
    line += " --store store" if command == "sweep" and option != "--store" else ""
    place = "missing/there" if option != "--store" else "mine.csv"  # a folder is made, but not in the place of a file
    assert main([command, *line.split(), option, f"{place}.{suffix}" if option != "--store" else place]) == 2
    captured = capsys.readouterr()
    assert (captured.out, captured.err.count("\n")) == ("", 1)
    assert f"argument {option}: " in captured.err


@pytest.mark.parametrize("command", ["compare", "identify"])
def test_a_file_without_an_option_is_called_as_in_the_help(command, capsys):
    assert (
        main([command, "missing/there.csv", *(["--alpha", "2", "--epsilon", "1"] if command == "compare" else [])]) == 2
    )
    assert "argument FILE: cannot read" in capsys.readouterr().err
