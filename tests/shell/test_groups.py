"""Help in groups, and missing arguments named as they are written."""

import argparse

import pytest

from asymptotics.ask.question import GROUPS
from asymptotics.ask.registry import QUESTIONS
from asymptotics.shell.asked import command_of
from asymptotics.shell.main import main


def parser_of(command):
    parser = argparse.ArgumentParser(prog=command)
    command_of(command).configure(parser)
    return parser


def seen(actions):
    return [a for a in actions if a.help != argparse.SUPPRESS]


@pytest.mark.parametrize("command", QUESTIONS)
def test_every_option_stands_under_one_heading(command):
    parser = parser_of(command)
    before = {o for a in seen(parser._actions) for o in a.option_strings}
    assert [a.dest for a in seen(parser._optionals._group_actions) if a.option_strings] == ["help"]
    shown = [o for group in parser._action_groups for a in seen(group._group_actions) for o in a.option_strings]
    assert sorted(shown) == sorted(before)  # each once
    assert parser.format_help().count("\n  --json ") == 1
    titles = [group.title for group in parser._action_groups if group._group_actions]
    assert [t for t in titles if t in GROUPS] == [t for t in GROUPS if t in titles]


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("turning-points --alpha 2", "--count N is missing: how many points"),
        ("moment", "--p P is missing"),
        ("smith", "argument WHAT is missing"),
        ("compare", "argument FILE is missing"),
        ("sweep", "argument COMMAND is missing"),
        ("motion --alpha 2 --time 3", "--epsilon: is missing (accepted: --epsilon E, without units; or --damping B"),
        ("motion --alpha 2 --time 3 --mass 2", "--damping: is missing"),
        ("envelope --alpha 2", "--epsilon: is missing"),
        ("expand", "--alpha A and --epsilon E, or --law A:E"),
    ],
)
def test_what_is_missing_is_named_as_it_is_written(capsys, line, said):
    assert main(line.split()) == 2
    captured = capsys.readouterr()
    assert (captured.out, captured.err.count("\n")) == ("", 1)
    assert said in captured.err and "..." not in captured.err
