"""Every option of every command under words that mean harm, and every parameter of its call: answered or refused.

All words meet each option where its name comes first, few of them the same option of other commands, whose reader is
the same; ``make test-thorough`` lets all meet all.
"""

import random
import re
from dataclasses import replace

import pytest

from asymptotics.ask.kinds import REAL, whole
from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.errors import InputError
from asymptotics.shell import asked as shell
from asymptotics.shell import main as entry
from asymptotics.shell.main import main
from tests.every_question import IN_PYTHON, TAKING, call_of, example, options_of, usual

FEW = ("--", "1e400", "", "x")
SOME = (*FEW, "nan", "-inf", "2.5e", "1,5", "__import__('os')", "\ud800", "²", "-1/0", "9" * 1200)
ALL = (*SOME, "-1e400", "1e-400", "-", "=", "--json", "1:1e400", "1e400:1", "\x1b[31m", "0", "-1", "1e5", "True",
       "sqrt(-1)", ":", "1,1e400", "[]", "1e308", "1e-308")  # fmt: skip
FIRST = {flag: name for name, flag in reversed(TAKING)}
"""An option -> the first command that has it."""
CASES = [(name, flag, SOME if FIRST[flag] == name else FEW) for name, flag in TAKING]


def judged(arguments, capsys):
    """An answer, or one line and exit code 1 or 2."""
    try:
        code = main(arguments)
    except SystemExit as stop:
        code = int(stop.code or 0)
    out, err = capsys.readouterr()
    assert code in (0, 1, 2), (arguments, err)
    assert "Traceback" not in out + err
    if code:
        # Rows that were done when the time was over are printed before the line.
        assert out == "" or ("--max-seconds" in err and "cut short: " in out), (arguments, out)
        assert err.count("\n") == 1 and err[:-1].isprintable() and len(err) < 1000, (arguments, err)
    return code, err


def line_of(name, folder, data=None):
    """Its example, with little time."""
    return [*example(name, folder, data), *(["--max-seconds", "1/2"] if "--max-seconds" in options_of(name) else [])]


def walk(name, flag, words, folder, capsys):
    """The example of a command with one option more, which has each of the words: a refusal names an argument."""
    for word in words:
        # What few words do to a file that is there; the others are met before a file that is not.
        line = line_of(name, folder, None if word in FEW else "no-such-file.csv")
        code, err = judged([*line, f"{flag}={word}"], capsys)
        assert code != 2 or re.search(r"argument (-|[A-Z])", err), (flag, word, err)
        assert word != "--" or (code == 2 and f"argument {flag}: '--' is no value" in err)
    code, _ = judged([*line_of(name, folder), flag, "--"], capsys)
    assert code == 2 or options_of(name)[flag].nargs is not None


@pytest.mark.parametrize(("name", "flag", "words"), CASES, ids=[f"{name} {flag}" for name, flag in TAKING])
def test_hostile_words_are_refused_by_the_name_of_the_option_or_answered(
    name, flag, words, tmp_path, monkeypatch, capsys
):
    monkeypatch.chdir(tmp_path)  # a store of any name is made
    walk(name, flag, words, tmp_path, capsys)


@pytest.mark.slow
@pytest.mark.parametrize(("name", "flag"), TAKING)
def test_any_hostile_word_in_any_option(name, flag, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    walk(name, flag, ALL, tmp_path, capsys)
    for word in ALL:
        if not word.startswith("--") and options_of(name)[flag].nargs in (None, "?"):
            judged([*line_of(name, tmp_path), flag, word], capsys)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(40))
def test_any_two_options_with_hostile_words(seed, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    chance = random.Random(seed)
    name = chance.choice(sorted(QUESTIONS))
    flags = [flag for command, flag in TAKING if command == name]
    for _ in range(8):
        drawn = [f"{flag}={chance.choice(ALL)}" for flag in chance.sample(flags, min(2, len(flags)))]
        judged([*line_of(name, tmp_path), *drawn], capsys)


OBJECTS = (None, True, 1j, float("nan"), [], {}, object(), b"1", lambda: 0)
NO_INTEGERS = (10**40, 2.5, float("nan"), True, None, "x", [], 1j, object())


@pytest.mark.parametrize("name", [n for n in IN_PYTHON if usual(call_of(n)) is not None])
def test_a_hostile_object_is_refused_by_the_name_of_its_parameter(name):
    """And what is no value of its kind is never taken for one: of a flag True is one, of a list an empty one."""
    question, call = loaded(name), call_of(name)
    for asked in question.asked:
        integer = asked.kind.schema.get("type") == "integer"
        values = (*NO_INTEGERS, asked.kind.schema["minimum"] - 1) if integer else OBJECTS
        for value in values:
            if value is asked.default:
                continue
            try:
                call(**{"max_seconds": 2, **usual(call), asked.name: value})
            except InputError as error:
                assert "argument -" not in str(error)
            else:
                none = value in ((), [], {}) or value is None  # what is left out
                assert not integer and (none or (value is True and asked.kind.schema["type"] == "boolean")), (
                    name, asked.name, value
                )  # fmt: skip


def test_a_kind_that_does_not_refuse_is_noticed(capsys, tmp_path, monkeypatch):
    """Near misses: readers that take anything, in the shell and in Python, are seen by the walks above."""
    question = loaded("stokes")
    deaf = replace(question["alpha"], kind=replace(REAL, read=lambda value, name: value))
    with monkeypatch.context() as patch:
        patch.setattr(shell, "loaded", lambda name: replace(question, asked=(deaf, *question.asked[1:])))
        patch.setattr(entry, "_command", entry._command.__wrapped__)  # not the one that was made before
        with pytest.raises(AssertionError):
            walk("stokes", "--alpha", SOME, tmp_path, capsys)
    assert whole(1, 9).read("4", "n") == 4
