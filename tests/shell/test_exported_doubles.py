"""Files of doubles say what their columns are good to; ``compare`` marks none of our own, and a planted error."""

import csv
import io
import json
from decimal import Decimal

import pytest

from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.numbers.double_words import stated_errors
from asymptotics.shell.main import main

# Weak laws where the rows are an expansion: it is then the motion, to more than doubles hold.
ASKED = {
    "envelope": [
        "--law=0:0.01 --law=2:0.3 --time=40",  # the issue's own: every phase was marked
        "--alpha=1 --epsilon=1/10 --time=400",
        "--alpha=1/2 --epsilon=1/5 --time=20",  # extinct on the way
        "--alpha=3 --epsilon=1 --time=1e6",
        "--law=1:1/10 --law=3/2:1/20 --law=3:1/7 --time=300",
        "--alpha=3/2 --mass=3/2 --stiffness=30 --damping=1/10 --x0=1/5 --time=50",
        "--law=1:1/20 --law=2:1/10 --v0=1/2 --time=30",
        "--alpha=3/2 --epsilon=1/10 --squaring --time=8",
        "--law=2:1/20 --spring=pendulum --x0=3 --time=10",
        "--law=2:1/20 --spring=3:1/5 --time=20",
    ],
    "motion": [
        "--alpha=2 --epsilon=1e-8 --time=30",
        "--alpha=3/2 --epsilon=1e-9 --time=200 --order=4",
        "--alpha=2 --mass=3/2 --stiffness=30 --damping=1e-9 --x0=1/5 --v0=1/3 --time=20 --order=3",
        "--alpha=2 --epsilon=1/10 --time=20 --reference",
        "--alpha=3/2 --mass=3/2 --stiffness=30 --damping=1/10 --x0=1/5 --time=7 --reference",
        "--alpha=0 --epsilon=1/20 --time=20 --reference",
        "--alpha=1 --epsilon=1/20 --time=1e3 --reference",
        "--alpha=2 --epsilon=1/20 --spring=3:1/5 --time=20 --reference",
    ],
    "solution": [
        "--alpha=2 --epsilon=1e-8 --order=3 --time=50",
        "--alpha=3/2 --epsilon=1e-9 --order=4 --time=50",
        "--alpha=2 --mass=3/2 --stiffness=30 --damping=1e-9 --x0=1/5 --order=3 --time=7",
        "--law=1:1e-10 --law=2:1e-10 --order=3 --time=60",
    ],
}
CURVES = [name for name in QUESTIONS if loaded(name).offers.curve and loaded(name).offers.table]
ASKED |= {name: [loaded(name).example] for name in CURVES if name not in ASKED}
CASES = [(command, asked) for command, each in ASKED.items() for asked in each]


@pytest.fixture
def path(tmp_path):
    return tmp_path / "exported.csv"


def compared(capsys, path, *options):
    capsys.readouterr()
    assert main(["compare", str(path), *options, "--json"]) == 0
    return json.loads(capsys.readouterr()[0])


def marked(found):
    return [(r["line"], r["column"]) for r in found["rows"] if "[" in r["marked"]]


@pytest.mark.parametrize(("command", "asked"), CASES)
def test_nothing_of_an_own_export_is_marked_and_an_error_of_a_few_of_the_stated_ones_is(capsys, path, command, asked):
    assert main([command, *asked.split(), "--points=12", "--csv", str(path)]) == 0
    found = compared(capsys, path)
    assert marked(found) == []
    assert found["summary"]["all_right"] == found["summary"]["values"]
    errors = stated_errors(path)
    judged = {row["column"].split(" [")[0] for row in found["rows"]}
    # A statement that covers everything would be none: only towards an extinction, where the phase runs away and the
    # table of the slow flow is coarse, are fewer than ten digits told.
    for name in judged:
        assert errors[name].size < (2e-8 if "alpha=1/2" in asked else 2e-11), name
    rows = list(csv.reader(io.StringIO(path.read_text())))
    for place, head in enumerate(rows[0]):
        name = head.split(" [")[0]
        if name in judged:
            wrong = [list(row) for row in rows]
            line = 7
            right = next(
                r["certified"] for r in found["rows"] if r["line"] == line and r["column"].split(" [")[0] == name
            )
            size = Decimal(errors[name].size.numerator) / Decimal(errors[name].size.denominator)
            wrong[line - 1][place] = str(
                Decimal(right) + 3 * size * (abs(Decimal(right)) if errors[name].relative else 1)
            )
            text = io.StringIO()
            csv.writer(text, lineterminator="\n").writerows(wrong)
            path.write_text(text.getvalue())
            assert [at for at, _ in marked(compared(capsys, path))] == [line], name


def test_every_command_with_a_curve_is_asked():
    assert set(ASKED) == set(CURVES) >= {"envelope", "motion", "solution"}
