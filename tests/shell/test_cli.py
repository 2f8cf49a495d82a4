"""The contract of the command line, run in this process."""

import json
import subprocess
import sys

import pytest

from asymptotics import __version__
from asymptotics.ask.registry import QUESTIONS
from asymptotics.shell.main import main


def run(capsys, *arguments: str) -> tuple[int, str, str]:
    try:
        code = main(list(arguments))
    except SystemExit as stop:
        code = int(stop.code or 0)
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def answer(capsys, *arguments: str) -> dict:
    code, out, _ = run(capsys, *arguments, "--json")
    assert code == 0
    data = json.loads(out)
    assert data["version"] == __version__
    assert data["command"] == arguments[0]
    return data


def test_turning_points(capsys):
    line = "turning-points --alpha 2 --epsilon 1 --count 2 --digits 5 --times"
    data = answer(capsys, *line.split())
    assert data["points"][1] == {"n": 1, "x": "-0.41072", "tau": "3.3810"}  # Table I
    assert data["ended"] is None
    assert data["certified"] is True


def test_tables(capsys):
    assert "smith2012.table1" in answer(capsys, "table", "--list")["tables"]
    assert answer(capsys, "table", "smith2012.table1", "--digits", "5")["rows"][1] == ["2", "0.098765", "-0.41072"]
    _, out, _ = run(capsys, "table", "smith2012.table1", "--format", "latex")
    assert r"\begin{tabular}" in out


@pytest.mark.parametrize("command", QUESTIONS)
def test_every_command_explains_itself(capsys, command):
    code, out, _ = run(capsys, command, "--help")
    assert code == 0
    assert "asymptotics " + command in out
    assert "--json" in out


ERRORS = [
    ("turning-points --alpha 2 --count 3 --epsilon -1", "--epsilon"),
    ("turning-points --alpha 2 --count 3 --epsilon -1/2", "--epsilon"),
    ("turning-points --alpha 2 --count 3 --epsilon nan", "--epsilon"),
    ("turning-points --alpha 2 --count 3 --epsilon 1e999999", "--epsilon"),
    ("turning-points --alpha 2 --count 3 --epsilon 1e9999", "--epsilon"),
    ("turning-points --alpha 3/2 --count 2 --epsilon 1e40 --max-seconds 1", "--max-seconds"),
    ("turning-points --alpha 1 --count 1 --epsilon 1 --start 1000000000000000000000000000000", "magnitude"),
    ("turning-points --alpha 2 --count 3 --epsilon abc", "--epsilon"),
    ("turning-points --alpha 2 --count 3 --epsilon __import__('os')", "--epsilon"),
    ("turning-points --alpha 2 --count 3 --epsilon 1 --digits 0", "--digits"),
    ("turning-points --alpha 2 --count 3 --epsilon 1 --digits 1000000000", "--digits"),
    ("turning-points --alpha 2 --count 0 --epsilon 1", "--count"),
    ("turning-points --alpha 2 --count 3.5 --epsilon 1", "--count"),
    ("turning-points --alpha 2 --count 3 --epsilon 1 --start -1", "--start"),
    ("turning-points --alpha nan --count 3 --epsilon 1", "--alpha"),
    ("turning-points --alpha 2 --count 3", "--epsilon"),
    ("smith f --n -3", "--n"),
    ("smith f --n 0", "--n"),
    ("smith f --n 1000000", "--n"),
    ("smith f", "--n"),
    ("smith c --n 5 --i 5", "--i"),
    ("smith c --n 100000 --i 50001", "--n"),
    ("smith g --i -1", "--i"),
    ("smith r", "--w"),
    ("smith r --w 0", "--w"),
    ("smith r --w 1 --n 3", "--n"),
    ("smith c --n 3 --i 2 --digits 5", "--digits"),
    ("smith f --n 3 --w 1", "--w"),
    ("smith h", "WHAT"),
    ("table nope", "NAME"),
    ("table", "NAME"),
    ("table smith2012.table1 --digits x", "--digits"),
    ("table smith2012.table1 --colour red", "--colour"),
    ("nope", "COMMAND"),
]


@pytest.mark.parametrize(("line", "argument"), ERRORS, ids=[line for line, _ in ERRORS])
def test_bad_input_is_one_line_that_names_the_argument(capsys, line, argument):
    code, out, err = run(capsys, *line.split())
    assert code == 2
    assert out == ""
    assert err.count("\n") == 1
    assert argument in err
    assert "Traceback" not in err


def test_a_wrong_parity_needs_no_work(capsys):
    assert answer(capsys, "smith", "c", "--n", "100000", "--i", "2")["value"] == "0"


@pytest.mark.parametrize(("command", "code"), [("smith f --n 800 | head -1", 0), ("smith f --n 8 > /dev/full", 2)])
def test_a_reader_that_leaves_and_a_full_disk_are_no_tracebacks(command, code):
    line = f"set -o pipefail; '{sys.executable}' -m asymptotics.shell.main {command}"
    done = subprocess.run(["bash", "-c", line], capture_output=True, text=True, check=False)
    assert done.returncode == code
    assert "Traceback" not in done.stderr
