"""The command line under arguments from a grammar, half of it nonsense: an answer or one line, never a traceback.

Cheap requests only (small orders, few digits): what a request may cost has tests of its own.
"""

import json
import os
import re
import subprocess
import sys
from itertools import takewhile
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from asymptotics.shell.main import main

ROOT = Path(__file__).parents[2]
EXAMPLES = 300 if os.environ.get("HYPOTHESIS_PROFILE") == "nightly" else 12  # at length in `make test-thorough`
GOOD = st.sampled_from(["0", "1", "2", "3/2", "0.1", "1/10", "5/2", "sqrt(2)", "1e-3", "7"])
ODD = st.sampled_from(
    ["", "-1", "-0", "0/0", "1/0", "1e400", "1e-400", "1e-300", "1e300", "nan", "inf", "-inf", "1_000", "0x10", "1,5",
     "2:", ":2", "2:3:4", "--", "-", "\x1b[31m", "é", "1 ", "sqrt(-1)", "sqrt(sqrt(2))", "9" * 1200, "symbolic",
     "__import__('os').abort()", "lambda: 0", "True", "None", "3.0", "+2", "²", "١"]
)  # fmt: skip
NUMBER = st.one_of(GOOD, GOOD, ODD)
SMALL = st.one_of(st.sampled_from(["1", "2", "3"]), st.sampled_from(["0", "-1", "1.5", "x", "", "10" * 30]))


def _line(command: str, *options: st.SearchStrategy[list[str]]) -> st.SearchStrategy[list[str]]:
    return st.tuples(*options).map(lambda parts: [command, *(word for part in parts for word in part)])


def _option(name: str, values: st.SearchStrategy[str], *, needed: bool = True) -> st.SearchStrategy[list[str]]:
    given_ = values.map(lambda value: [name, value])
    return st.one_of(given_, given_, given_, st.just([])) if needed else st.one_of(given_, st.just([]), st.just([]))


def _flag(*names: str) -> st.SearchStrategy[list[str]]:
    return st.sampled_from([[], [], [], *([name] for name in names), ["--no-such-option"]])


LAW = st.one_of(
    st.tuples(NUMBER, NUMBER).map(lambda pair: ["--alpha", pair[0], "--epsilon", pair[1]]),
    st.lists(st.tuples(NUMBER, NUMBER), min_size=1, max_size=2).map(
        lambda pairs: [word for a, e in pairs for word in ("--law", f"{a}:{e}")]
    ),
)
DAMPED = LAW.map(lambda words: ["--damping" if word == "--epsilon" else word for word in words])
DIGITS = _option("--digits", SMALL)
JSON = _flag("--json")
SPRING = st.one_of(st.just("pendulum"), st.tuples(NUMBER, NUMBER).map(":".join))
WORDS = st.lists(st.one_of(ODD, st.sampled_from(["smith2012", "smith2012:43", "Lambert", "nosuch"])), max_size=2)
LINES = {
    "moment": _line("moment", _option("--p", NUMBER), DIGITS, JSON),
    "expand": _line("expand", LAW, _option("--order", SMALL), DIGITS, _flag("--exact", "--latex"), JSON),
    "half-swing": _line("half-swing", LAW, _option("--order", SMALL), DIGITS, JSON),
    "turning-points": _line("turning-points", LAW, _option("--count", SMALL), _option("--start", SMALL, needed=False),
                            DIGITS, _flag("--times"), st.just(["--max-seconds", "2"]), JSON),
    "motion": _line("motion", DAMPED, _option("--x0", NUMBER), _option("--v0", NUMBER, needed=False),
                    _option("--mass", NUMBER, needed=False), _option("--stiffness", NUMBER, needed=False),
                    _option("--time", NUMBER), st.sampled_from([["--order", "1"], ["--order", "0"]]), DIGITS, JSON),
    "envelope": _line("envelope", LAW, _option("--time", NUMBER), DIGITS, _flag("--latex", "--squaring"), JSON),
    "multiple-scales": _line("multiple-scales", st.tuples(NUMBER).map(lambda a: ["--alpha", *a]),
                             st.just(["--order", "1"]), _flag("--latex"), JSON),
    "smith": _line("smith", st.sampled_from([["f"], ["c"], ["g"], ["h"], ["r"], []]),
                   _option("--n", SMALL, needed=False), _option("--i", SMALL, needed=False),
                   _option("--w", NUMBER, needed=False), JSON),
    "limit-cycle": _line("limit-cycle", LAW, _option("--order", SMALL), _option("--mu", NUMBER, needed=False),
                         DIGITS, st.just(["--max-seconds", "1"]), JSON),
    "springs": _line("expand", LAW, _option("--spring", SPRING), _option("--order", SMALL), DIGITS, JSON),
    "reference": _line("motion", DAMPED, _option("--x0", NUMBER), _option("--time", NUMBER),
                       _option("--spring", SPRING, needed=False), st.just(["--reference", "--max-seconds", "1"]),
                       DIGITS, JSON),
    "papers": _line("papers", WORDS, _flag("--latex"), JSON),
    "derive": _line("derive", st.one_of(WORDS, st.just(["q-log-q"])), _flag("--latex"), JSON),
    "table": _line("table", st.sampled_from([["smith2012.table1"], ["nope"], [], ["--list"]]), DIGITS, JSON),
}  # fmt: skip


@pytest.mark.parametrize("command", LINES)
def test_any_arguments_give_an_answer_or_one_line(command, capsys):
    @settings(
        max_examples=EXAMPLES, deadline=None, database=None, derandomize=EXAMPLES < 100,
        suppress_health_check=list(HealthCheck),
    )  # fmt: skip
    @given(LINES[command])
    def check(arguments: list[str]) -> None:
        code = main(arguments)
        out, err = capsys.readouterr()
        if code == 0:
            assert out
            if "--json" in takewhile("--".__ne__, arguments):  # behind -- it is a word that is looked for
                json.loads(out, parse_float=_no_floats)
            assert arguments[0] == "papers" or not re.search(r"\b(nan|inf)\b", out.lower())  # it repeats the query
        else:
            assert code in (1, 2), arguments
            assert out == ""
            assert err.count("\n") == 1, (arguments, err)
            assert err[:-1].isprintable() and len(err) < 1000, arguments

    check()


def _no_floats(text: str) -> float:
    raise AssertionError(f"{text} is a JSON float: numbers are strings")


CELL = st.one_of(GOOD, GOOD, ODD, st.sampled_from(["", "n/a", "0.9", "0.85", "-0.8", "0.77"]))
HEADER = st.lists(st.sampled_from(["n", "t", "x", "tau", "t_ms", "x_cm", "amplitude", "time [s]", "", "x"]), max_size=3)
TABLE = st.tuples(HEADER, st.lists(st.lists(CELL, max_size=4), max_size=8)).map(
    lambda table: "\n".join(",".join(row) for row in (table[0], *table[1])).encode("utf-8", "replace")
)
CONTENTS = st.one_of(TABLE, TABLE, st.binary(max_size=60))


@pytest.mark.parametrize("command", [
    "compare {} --alpha 2 --epsilon 1/10 --max-seconds 2", "compare {} --alpha 2 --epsilon 1/10 --columns n,x",
    "identify {} --laws 1 --no-bootstrap --max-seconds 2", "sweep moment --list {} --store {}.store --workers 1",
])  # fmt: skip
def test_any_file_gives_an_answer_or_one_line(command, tmp_path, capsys):
    file = tmp_path / "drawn ü.csv"

    @settings(max_examples=EXAMPLES, deadline=None, database=None, derandomize=EXAMPLES < 100)
    @given(CONTENTS)
    def check(content: bytes) -> None:
        file.write_bytes(content)
        code = main([word.replace("{}", str(file)) for word in command.split()])
        out, err = capsys.readouterr()
        assert code in (0, 1, 2), content
        assert "Traceback" not in out + err
        assert out or err.count("\n") == 1, (content, err)
        assert all(line.isprintable() for line in err.splitlines()), content

    check()


PROGRAMS = [
    "-m paper_checks lelas2024 --id lelas2024:4 --json",
    "-m asymptotics.shell.entry expand --law 1 --law 2 --order 4 --json",
    "-m asymptotics.shell.entry multiple-scales --alpha 3 --order 3 --json",
]


SLOWER = [pytest.param(program, marks=pytest.mark.slow) for program in (PROGRAMS[0], PROGRAMS[2])]


@pytest.mark.parametrize("program", [PROGRAMS[1], *SLOWER])
def test_the_same_bytes_under_hash_seeds_time_zones_and_locales(program):
    outputs = set()
    for seed, zone, locale in (("0", "UTC", "C"), ("1", "Pacific/Kiritimati", "C.UTF-8"), ("4711", "America/Lima", "")):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "TZ": zone, "LC_ALL": locale}
        done = subprocess.run(
            [sys.executable, *program.split()], cwd=ROOT, env=environment, capture_output=True, check=True
        )
        outputs.add(done.stdout)
    assert len(outputs) == 1
