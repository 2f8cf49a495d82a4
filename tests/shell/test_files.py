"""Files that are not there are named by their option."""

import pytest

from asymptotics.ask.registry import QUESTIONS
from asymptotics.shell.main import main
from tests.every_question import example, options_of

TAKEN = [
    (command, option)
    for command in QUESTIONS
    for option, action in options_of(command).items()
    if action.metavar in ("FILE", "DIR")
]


def test_every_command_with_a_file_is_walked():
    assert len(TAKEN) > 25 and ("damping", "--from") in TAKEN and ("sweep", "--list") in TAKEN


@pytest.mark.parametrize(("command", "option"), TAKEN)
def test_a_file_that_is_not_there_is_named_by_its_option(command, option, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "mine.csv").write_text("n,x\n0,1\n1,-0.5\n")
    suffix = {"--plot": "svg", "--html": "html"}.get(option, "csv")
    line = example(command, tmp_path, "mine.csv")[1:] if option != "--from" else []
    place = "missing/there" if option != "--store" else "mine.csv"  # a folder is made, but not in the place of a file
    assert main([command, *line, option, f"{place}.{suffix}" if option != "--store" else place]) == 2
    captured = capsys.readouterr()
    assert (captured.out, captured.err.count("\n")) == ("", 1)
    assert f"argument {option}: " in captured.err


@pytest.mark.parametrize("command", ["compare", "identify"])
def test_a_file_without_an_option_is_called_as_in_the_help(command, capsys):
    assert (
        main([command, "missing/there.csv", *(["--alpha", "2", "--epsilon", "1"] if command == "compare" else [])]) == 2
    )
    assert "argument FILE: cannot read" in capsys.readouterr().err
