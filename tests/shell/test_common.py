"""The options that all commands share: each command has one or says why not, and the docs have the same table."""

import csv
import json
import subprocess
import sys
from pathlib import Path

import pytest

from asymptotics.ask.answers import COMMON
from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.made_by import mark
from asymptotics.shell.main import main
from tests.every_question import options_of

DOCS = Path(__file__).parents[2] / "docs"
PAGE = DOCS / "command_line.md"
sys.path.insert(0, str(DOCS / "extensions"))

from common_options import MARK, SHOWN, tables  # noqa: E402 (a module of the docs)


def lacks(command):
    return loaded(command).offers.lacks


@pytest.mark.parametrize("command", sorted(QUESTIONS))
def test_each_common_option_is_there_or_says_why_not(command, capsys):
    has = {o[2:] for o in options_of(command)} & set(COMMON)
    assert has | set(lacks(command)) >= set(COMMON)
    assert not has & set(lacks(command))
    assert {"json", "quiet"} <= has
    for option in lacks(command):
        assert main([command, f"--{option}"]) == 2
        out, err = capsys.readouterr()
        assert (out, err.count("\n")) == ("", 1)
        assert f"argument --{option}: not in this command: {lacks(command)[option]}" in err


def test_the_docs_have_the_table_and_the_reasons():
    page = tables()
    assert MARK in PAGE.read_text(encoding="utf-8")
    for command in QUESTIONS:
        absent = lacks(command)
        row = " | ".join("–" if option in absent else "yes" for option in SHOWN)
        assert f"| `{command}` | {row} |" in page, command
        for reason in absent.values():
            assert reason in page, (command, reason)


def call(capsys, *line: object) -> str:
    assert main([*map(str, line)]) == 0
    return capsys.readouterr().out


def test_series_as_latex_and_as_a_table(capsys, tmp_path):
    half = ("half-swing", "--alpha", 2, "--order", 3, "--digits", 8)
    assert call(capsys, *half, "--latex").startswith(r"L = -\frac{4}{3} \delta + \frac{8}{9} \delta^{2}")
    target = tmp_path / "rows.csv"
    call(capsys, *half, "--csv", target)
    rows = list(csv.DictReader(target.read_text().splitlines()))
    found = json.loads(call(capsys, *half, "--json"))
    assert {r["k"]: r["exact"] for r in rows if r["series"] == "L"} == {
        k: c["exact"] for k, c in found["log_ratio"].items()
    }
    sums = call(capsys, "half-swing", "--law", 1, "--law", 2, "--order", 2, "--latex")
    assert r"F_{2} = \delta_{2} - \frac{\pi}{2} \delta_{1} \delta_{2} - \frac{4}{3} \delta_{2}^{2}" in sums
    at = ("half-swing", "--alpha", "3/2", "--delta", "1/5", "--digits", 6)
    assert call(capsys, *at, "--latex") == "A'/A = 0.763337,\\quad L = -0.270055,\\quad T = 3.15854\n"
    call(capsys, *at, "--csv", target)
    head, ratio = target.read_text().splitlines()[:2]
    low, high = map(float, ratio.split(",")[2:4])
    assert (head, ratio[:14]) == (
        "quantity,value,low,high,code [half-swing --alpha=3/2 --digits=6 --delta=1/5]",
        "A'/A,0.763337,",
    )
    assert low <= 0.7633373962099577 <= high < low + 1e-9
    cycle = ("limit-cycle", "--law", "1:-1", "--law", "1,2:1", "--order", 2)
    assert call(capsys, *cycle, "--latex").startswith(r"A = 2 + \frac{1}{96} \mu^{2} \\")
    call(capsys, *cycle, "--csv", target)
    assert "amplitude,2,0.0104166666666666666666666666667,1/96" in target.read_text()


def test_numbers_as_latex_and_as_a_table(capsys, tmp_path):
    assert call(capsys, "moment", "--p", 2, "--latex") == "M_{2} = \\frac{1}{2}\n"
    assert call(capsys, "smith", "c", "--n", 5, "--i", 2, "--latex") == "C_{2}^{5} = -\\frac{104}{105}\n"
    polynomial = r"f_{5}(w) = \frac{1}{5} - \frac{104}{105} w^{2} + \frac{128}{315} w^{4}"
    target = tmp_path / "rows.csv"
    assert call(capsys, "smith", "f", "--n", 5, "--latex", "--csv", target) == polynomial + "\n"
    lines = ["n,i,C,code [smith f --n=5]", *(f"{row},{mark()}" for row in ("5,0,1/5", "5,2,-104/105", "5,4,128/315"))]
    assert target.read_text().splitlines() == lines
    assert main(["smith", "g", "--i", "2", "--csv", str(target)]) == 2
    capsys.readouterr()
    table = ("table", "moments", "--alpha", 1, "--digits", 5)
    assert call(capsys, *table, "--latex") == call(capsys, *table, "--format", "latex")
    call(capsys, *table, "--csv", target)
    written = target.read_text()
    call(capsys, *table, "--format", "csv", "--output", target)
    assert written == target.read_text()
    for clash in (("--csv", target, "--latex"), ("--csv", target, "--output", target), ("--latex", "--format", "csv")):
        assert main([*map(str, table), *map(str, clash)]) == 2
        assert capsys.readouterr().err.count("\n") == 1


CORE = """
import sys
sys.modules.update(dict.fromkeys(("matplotlib", "cycler", "pandas", "pyarrow", "iminuit"), None))  # extras
from asymptotics.ask.registry import QUESTIONS
from asymptotics.shell.main import main
codes = [main(line.split()) for line in (
    "envelope --alpha 3/2 --epsilon 1/10 --time 3 --digits 5", "turning-points --alpha 2 --epsilon 1 --count 2",
    "expand --alpha 3/2 --order 2 --digits 5")]
assert codes == [0] * 3 and not [name for name in sys.modules if name.startswith("scipy")]
from asymptotics.shell.asked import command_of
for name in QUESTIONS:
    command_of(name)
assert {"scipy.special", "scipy.stats"} & {*sys.modules} == {"scipy.special"}  # the other takes half a second
sys.exit(main(["turning-points", *"--alpha 2 --epsilon 1 --count 2 --plot".split(), sys.argv[1]]))
"""


def test_the_core_is_enough_for_every_command_and_scipy_waits_until_it_is_used(tmp_path):
    done = subprocess.run([sys.executable, "-c", CORE, tmp_path / "a.svg"], capture_output=True, text=True, check=False)
    assert done.returncode == 2, done.stderr
    assert "argument --plot: a picture needs matplotlib, which is not installed" in done.stderr
    assert done.stderr.count("\n") == 1


def test_one_rule_for_units(capsys, tmp_path):
    """SI with --damping, --mass or --stiffness; otherwise the equation as typed, started at x0: the same numbers."""
    points = "turning-points --law 2:1/10 --count 3 --digits 9 --times --json --x0 3"
    bare, si = (json.loads(call(capsys, *points.split(), *more)) for more in ((), ("--mass", 1)))
    assert (bare["units"], bare["x_unit"], si["units"], si["x_unit"]) == (None, "strengths", "SI", "m")
    assert [(p["x"], p["tau"]) for p in bare["points"]] == [(p["x"], p["t"]) for p in si["points"]]
    for line in ("motion --time 3 --reference", "envelope --time 3"):
        found = [
            json.loads(call(capsys, *line.split(), *law.split(), "--x0", 3, "--digits", 9, "--json"))
            for law in ("--law 2:1/10", "--alpha 2 --epsilon 1/10", "--alpha 2 --damping 1/10")
        ]
        assert [f["units"] for f in found] == [None, None, "SI"]
        assert len({f["amplitude"] if f["amplitude"] else f["x"] for f in found}) == 1
    own = tmp_path / "mine.csv"
    own.write_text("n,x,tau\n" + "\n".join(f"{p['n']},{p['x']},{p['tau']}" for p in bare["points"]))
    held = json.loads(call(capsys, "compare", own, "--law", "2:1/10", "--x0", 3, "--json"))
    assert held["summary"]["all_right"] == held["summary"]["values"] == 6


def test_a_bare_call_helps_and_a_slip_of_the_pen_is_answered_with_the_word_that_was_meant(capsys):
    assert main([]) == 0
    assert "turning-points" in capsys.readouterr().out
    for line, meant in ((["tabel"], "did you mean table?"), (["moment", "--p", "2", "--digit", "3"], "--digits?")):
        assert main(line) == 2
        assert meant in capsys.readouterr().err
    for line, meant in (("--cuont 5", "--count?"), ("--cuont=5", "--count?"), ("", "--count N is missing")):
        assert main(f"turning-points --alpha 2 --epsilon 1 {line}".split()) == 2  # the slip, not what is missing by it
        assert meant in capsys.readouterr().err
    for line in (["zzzz"], ["derive", "--alpha", "2"], ["papers", "--alpha", "2"]):  # once: did you mean --help?
        assert main(line) == 2
        assert "did you mean" not in capsys.readouterr().err
    for line, meant in (
        (["moment", "--alpha", "2"], "`--p`"),
        (["smith", "f", "--alpha", "2"], "`half-swing --alpha`"),
    ):
        assert main(line) == 2
        assert "argument --alpha: not in this command: " in (told := capsys.readouterr().err) and meant in told
