"""What is typed meets one gate; what nobody foresaw ends with exit code 70 and two lines; little memory with one."""

import argparse
import os
import subprocess
import sys
from pathlib import Path

import pytest

from asymptotics.errors import InputError
from asymptotics.shell import main as module
from asymptotics.shell.asked import Command
from asymptotics.shell.gate import typed, words
from asymptotics.shell.main import main
from asymptotics.sweeps import workers
from tests.ask.test_hostile import ALL, judged
from tests.each import each

ROOT = Path(__file__).parents[2]
PROGRAM = [sys.executable, "-m", "asymptotics.shell.entry"]


@each("word", sorted({*ALL, "host:8786", "tcp://", "tcp://host", "file:///etc:1"} - {"--"}))
def test_what_is_no_address_of_a_scheduler_is_refused_before_dask_is_loaded(word, monkeypatch):
    """Dask tried each for 4 to 18 s, and failed on some words by an assertion of its own."""
    monkeypatch.setattr(workers, "_distributed", lambda: pytest.fail("Dask is loaded"))
    with pytest.raises(InputError, match="is no address of a scheduler"):
        workers.dask_executor(word, None).__enter__()
    for address in ("local", "tcp://127.0.0.1:8786", "tls://[::1]:8786"):
        with pytest.raises(pytest.fail.Exception):
            workers.dask_executor(address, None).__enter__()


def test_words_that_are_no_text_are_refused(capsys):
    for bad in ([1], ["moment", None], [b"moment"], [["moment"]], ["moment", "--p", 2]):
        assert judged(bad, capsys)[0] == 2
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
    assert judged(["moment", "--p", "1"], capsys)[0] == 2


def test_an_integer_that_is_too_long_for_text_is_refused(monkeypatch, capsys):
    monkeypatch.setattr(Command, "run", lambda self, options: str(10**5000))
    assert judged(["moment", "--p", "1"], capsys)[0] == 2


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
