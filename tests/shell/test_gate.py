"""What is typed meets one gate; what nobody foresaw ends with exit code 70 and two lines; little memory with one."""

import argparse
import os
import random
import subprocess
import sys
from pathlib import Path

import pytest

from asymptotics.ask.registry import QUESTIONS
from asymptotics.errors import InputError
from asymptotics.shell import main as module
from asymptotics.shell.asked import Command, command_of
from asymptotics.shell.gate import typed, words
from asymptotics.shell.main import main
from asymptotics.sweeps import workers
from tests.test_made_by import LINES

ROOT = Path(__file__).parents[2]
PROGRAM = [sys.executable, "-m", "asymptotics.shell.entry"]
TOKENS = ["--", "1e400", "-1e400", "1e-400", "", "nan", "-", "=", "--json", "1:1e400", "1e400:1", "9" * 1200, "²",
          "\x1b[31m", "0", "-1", "1/0", "1e5", "True", "sqrt(-1)", ":", "1,1e400", "[]", "1e308", "1e-308"]  # fmt: skip
SLOW = set(TOKENS[2:])


def options_of(command):
    parser = argparse.ArgumentParser(add_help=False)
    command_of(command).configure(parser)
    flags = parser._option_string_actions.items()
    return {flag: action for flag, action in flags if flag.startswith("--") and action.help != argparse.SUPPRESS}


TAKING = [(c, flag) for c in QUESTIONS for flag, action in options_of(c).items() if action.nargs != 0]


def judged(arguments, capsys):
    """An answer, or one line and exit code 1 or 2."""
    code = main(arguments)
    out, err = capsys.readouterr()
    assert code in (0, 1, 2), (arguments, err)
    assert "Traceback" not in out + err
    if code:
        # Rows that were done when the time was over are printed before the line.
        assert out == "" or ("--max-seconds" in err and "cut short: " in out), (arguments, out)
        assert err.count("\n") == 1 and err[:-1].isprintable() and len(err) < 1000, (arguments, err)
    return code


def line_of(command, tmp_path):
    data = tmp_path / "data.csv"
    data.write_text("n,x\n" + "".join(f"{n},{(-0.9) ** n}\n" for n in range(8)))
    line = LINES[command].format(data=data, folder=tmp_path).split()
    return [*line, "--max-seconds", "2"] if "--max-seconds" in options_of(command) else line


@pytest.mark.parametrize(("command", "flag"), TAKING)
def test_two_dashes_are_no_value_of_any_option(command, flag, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    line = line_of(command, tmp_path)
    assert main([*line, f"{flag}=--"]) == 2
    assert f"argument {flag}: '--' is no value" in capsys.readouterr().err
    assert judged([*line, flag, "--"], capsys) == 2 or "nargs" in repr(options_of(command)[flag])


@pytest.mark.parametrize(("command", "flag"), TAKING)
def test_a_number_beyond_the_doubles_in_any_option(command, flag, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    judged([*line_of(command, tmp_path), f"{flag}=1e400"], capsys)


@pytest.mark.parametrize("word", sorted({*TOKENS, "host:8786", "tcp://", "tcp://host", "file:///etc:1"} - {"--"}))
def test_what_is_no_address_of_a_scheduler_is_refused_before_dask_is_loaded(word, monkeypatch):
    """Dask tried each for 4 to 18 s, and failed on some words by an assertion of its own."""
    monkeypatch.setattr(workers, "_distributed", lambda: pytest.fail("Dask is loaded"))
    with pytest.raises(InputError, match="is no address of a scheduler"):
        workers.dask_executor(word, None).__enter__()
    for address in ("local", "tcp://127.0.0.1:8786", "tls://[::1]:8786"):
        with pytest.raises(pytest.fail.Exception):
            workers.dask_executor(address, None).__enter__()


@pytest.mark.slow
@pytest.mark.parametrize(("command", "flag"), TAKING)
def test_any_hostile_word_in_any_option(command, flag, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    for token in SLOW:
        judged([*line_of(command, tmp_path), f"{flag}={token}"], capsys)
        if token.startswith("--") or options_of(command)[flag].nargs not in (None, "?"):
            continue
        judged([*line_of(command, tmp_path), flag, token], capsys)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(40))
def test_any_two_options_with_hostile_words(seed, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    chance = random.Random(seed)
    command = chance.choice(sorted(QUESTIONS))
    flags = [flag for name, flag in TAKING if name == command]
    for _ in range(8):
        drawn = [f"{flag}={chance.choice(TOKENS)}" for flag in chance.sample(flags, min(2, len(flags)))]
        judged([*line_of(command, tmp_path), *drawn], capsys)


def test_words_that_are_no_text_are_refused(capsys):
    for bad in ([1], ["moment", None], [b"moment"], [["moment"]], ["moment", "--p", 2]):
        assert judged(bad, capsys) == 2
    assert words(["--a", "-1", "--", "x", "--b=-", "-c"]) == ["--a=-1", "--", "x", "--b=-", "-c"]
    with pytest.raises(InputError, match="argument --some-list: "):
        typed(argparse.Namespace(some_list=[["a"]]))


def test_a_fault_of_the_program_has_an_exit_code_of_its_own(monkeypatch, capsys):
    def broken(self, options):
        raise ZeroDivisionError("a fault\nof ours \x1b[31m" + "!" * 5000)

    monkeypatch.setattr(Command, "run", broken)
    monkeypatch.setattr(sys, "argv", ["asymptotics", "moment", "--p", "1\n"])
    monkeypatch.delenv("ASYMPTOTICS_TRACEBACK", raising=False)
    assert main(["moment", "--p", "1"]) == 70
    out, err = capsys.readouterr()
    first, second = err.splitlines()
    assert out == "" and (first + second).isprintable() and len(err) < 1200
    assert first.startswith(
        "asymptotics: a fault of the program, not of its input: ZeroDivisionError: a fault\\nof ours"
    )
    assert "please report" in second and "'moment' '--p' '1\\n'" in second
    monkeypatch.setenv("ASYMPTOTICS_TRACEBACK", "1")
    assert main(["moment", "--p", "1"]) == 70
    assert "in broken" in capsys.readouterr().err


def test_memory_that_is_not_there_is_one_line(monkeypatch, capsys):
    def hungry(self, options):
        raise MemoryError

    monkeypatch.setattr(Command, "run", hungry)
    assert judged(["moment", "--p", "1"], capsys) == 2


def test_an_integer_that_is_too_long_for_text_is_refused(monkeypatch, capsys):
    monkeypatch.setattr(Command, "run", lambda self, options: str(10**5000))
    assert judged(["moment", "--p", "1"], capsys) == 2


def test_every_program_says_so(tmp_path):
    (tmp_path / "program.py").write_text(
        "import sys\nfrom asymptotics.shell.guarded import run_guarded\nsys.exit(run_guarded('it', lambda: 1 // 0))\n"
    )
    done = subprocess.run(
        [sys.executable, "program.py", "-x"], cwd=tmp_path, env={**os.environ, "PYTHONPATH": str(ROOT)},
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert (done.returncode, done.stderr.count("\n")) == (70, 2) and "Traceback" not in done.stderr


def test_the_exit_codes_are_in_the_docs():
    page = (ROOT / "docs" / "command_line.md").read_text()
    assert "70 for a fault of the program" in page and module.__doc__ is not None and "70" in module.__doc__
