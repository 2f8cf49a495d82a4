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

from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.shell.main import main
from tests.every_question import example, options_of, without_law

ROOT = Path(__file__).parents[2]
EXAMPLES = 300 if os.environ.get("HYPOTHESIS_PROFILE") == "nightly" else 12  # at length in `make test-thorough`
GOOD = st.sampled_from(["0", "1", "2", "3/2", "0.1", "1/10", "5/2", "sqrt(2)", "1e-3", "7"])
ODD_WORDS = (
    "", "-1", "-0", "0/0", "1/0", "1e400", "1e-400", "1e-300", "1e300", "nan", "inf", "-inf", "1_000", "0x10", "1,5",
    "2:", ":2", "2:3:4", "--", "-", "\x1b[31m", "é", "1 ", "sqrt(-1)", "sqrt(sqrt(2))", "9" * 1200, "symbolic",
    "__import__('os').abort()", "lambda: 0", "True", "None", "3.0", "+2", "+1", "²", "١",
)  # fmt: skip
ODD = st.sampled_from(ODD_WORDS)
NUMBER = st.one_of(GOOD, ODD)
SMALL = st.one_of(st.sampled_from(["1", "2", "3"]), st.sampled_from(["0", "-1", "1.5", "x", "", "10" * 30]))


LAW = st.one_of(
    st.tuples(NUMBER, NUMBER).map(lambda pair: ["--alpha", pair[0], "--epsilon", pair[1]]),
    st.lists(st.tuples(NUMBER, NUMBER), min_size=1, max_size=2).map(
        lambda pairs: [word for a, e in pairs for word in ("--law", f"{a}:{e}")]
    ),
)
SHAPE = st.one_of(st.just("pendulum"), st.tuples(NUMBER, NUMBER).map(":".join), ODD)
WORDS = st.one_of(ODD, st.sampled_from(["smith2012", "smith2012:43", "Lambert", "nosuch", "q-log-q"]))
DEAR = {"max-seconds", "workers", "check"}  # what a request may cost


def value_of(option: str, told: dict) -> st.SearchStrategy[str]:
    """What may be typed behind an option, by its kind."""
    if option in ("law", "spring"):
        return SHAPE
    if "enum" in told:
        return st.one_of(st.sampled_from(told["enum"]), ODD)
    return SMALL if told["type"] == "integer" else NUMBER


@st.composite
def line(draw: st.DrawFn, name: str, words: list[str]) -> list[str]:
    """The example of a command, often with another law, and up to three options more."""
    options = loaded(name).schema()["properties"]
    if {"law", "epsilon"} <= options.keys() and draw(st.booleans()):
        words = [*without_law(words), *draw(LAW)]
    if not any(word.startswith("--") for word in words) and draw(st.booleans()):
        words = [name, *draw(st.lists(WORDS, max_size=2))]
    for option in draw(st.lists(st.sampled_from(sorted(options.keys() - DEAR)), max_size=3)):
        told = options[option].get("items", options[option])
        words = [*words, f"--{option}", *([] if told.get("type") == "boolean" else [draw(value_of(option, told))])]
    more = draw(st.sampled_from([[], [], ["--json"], ["--json"], ["--latex"], ["--no-such-option"]]))
    return [*words, *(["--max-seconds", "1"] if "max-seconds" in options else []), *more]


@pytest.mark.parametrize("command", QUESTIONS)
def test_any_arguments_give_an_answer_or_one_line(command, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    words = example(command, tmp_path)

    @settings(
        max_examples=EXAMPLES, deadline=None, database=None, derandomize=EXAMPLES < 100,
        suppress_health_check=list(HealthCheck),
    )  # fmt: skip
    @given(line(command, words))
    def check(arguments: list[str]) -> None:
        answered_or_refused(arguments, capsys)

    check()


def answered_or_refused(arguments: list[str], capsys) -> None:
    code = main(arguments)
    out, err = capsys.readouterr()
    if code == 0:
        assert out
        if "--json" in takewhile("--".__ne__, arguments):  # behind -- it is a word that is looked for
            json.loads(out, parse_float=_no_floats)
        assert arguments[0] == "papers" or not re.search(r"\b(nan|inf)\b", out.lower())  # it repeats the query
    else:
        assert code in (1, 2), arguments
        assert out == "" or ("--max-seconds" in err and "cut short: " in out), arguments
        assert err.count("\n") == 1, (arguments, err)
        assert err[:-1].isprintable() and len(err) < 1000, arguments


PLACES = ("--alpha {} --epsilon 1/10", "--alpha 2 --epsilon {}", "--law {}:1/10", "--law 2:{}", "--law 1,{}:1/10",
          "--law 2:1/10 --spring {}:1/10", "--law 2:1/10 --spring 3:{}")  # fmt: skip
OF_LAWS = [name for name in QUESTIONS if {"--law", "--epsilon"} <= options_of(name).keys()]


@pytest.mark.parametrize("place", PLACES)
def test_each_odd_word_in_each_place_of_a_law(place, capsys, tmp_path):
    """Their reader is one; the commands, which take turns, do with it what they do."""
    able = [name for name in OF_LAWS if "--spring" not in place or "--spring" in options_of(name)]
    for n, word in enumerate(ODD_WORDS):
        words = without_law(example(able[(n + PLACES.index(place)) % len(able)], tmp_path))
        law = [part.replace("{}", word) for part in place.split(" ")]
        answered_or_refused([*words, *law, "--max-seconds", "2", "--json"], capsys)


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
    for seed, zone, locale in (("0", "UTC", "C"), ("4711", "Pacific/Kiritimati", "")):
        environment = {**os.environ, "PYTHONHASHSEED": seed, "TZ": zone, "LC_ALL": locale}
        done = subprocess.run(
            [sys.executable, *program.split()], cwd=ROOT, env=environment, capture_output=True, check=True
        )
        outputs.add(done.stdout)
    assert len(outputs) == 1
