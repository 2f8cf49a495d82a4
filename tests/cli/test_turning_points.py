"""The command turning-points: any law, and in what x is told."""

import json

import pytest

from asymptotics.cli.main import main
from tests.cli.answers import answer, run


@pytest.mark.parametrize(
    ("line", "unit", "first"),
    [
        ("--law 2:1/10", "x0", "1.0000"), ("--law 2:1/10 --spring pendulum --x0 2.9", "rad", "2.9000"),
        ("--law 2:1/10 --spring 3:1/2 --x0 2", "strengths", "2.0000"),
        ("--law 2:1/10 --stiffness 2 --x0 3", "m", "3.0000"),
        ("--law 1,2:1/10 --x0 2", "strengths", "2.0000"), ("--law 2:1/10 --v0 1", "x0", "1.0000"),
        ("--law 2:1/10 --spring pendulum --v0 1", "x0", "1.0000"),
    ],
)  # fmt: skip
def test_turning_points_say_in_what_x_is_told(capsys, line, unit, first):
    assert main(["turning-points", *line.split(), "--count", "2", "--digits", "5", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert (data["x_unit"], data["points"][0]["x"]) == (unit, first)
    assert main(["turning-points", *line.split(), "--count", "2", "--digits", "5"]) == 0
    head = capsys.readouterr().out.splitlines()[0]
    assert ("rad" in head, "strengths" in head) == (unit == "rad", unit == "strengths")


def test_turning_points_of_any_law(capsys):
    data = answer(capsys, "turning-points --law 0:1/20 --law 3/2:1/10 --count 20 --digits 12")
    assert data["certified"] is True and data["ended"] == {"n": 7, "reason": "sticks"} and len(data["points"]) == 8
    assert answer(capsys, "turning-points --alpha 0 --epsilon 3/10 --count 9")["ended"] == {"n": 2, "reason": "sticks"}
    assert answer(capsys, "turning-points --alpha 1 --epsilon 3 --count 2")["ended"]["reason"] == "overdamped"
    assert answer(capsys, "turning-points --alpha 1/2 --epsilon 1 --count 2")["ended"]["reason"] == "creeps"
    timed = answer(capsys, "turning-points --alpha 3/2 --epsilon 1/10 --count 2 --digits 12 --times")
    assert timed["points"][1] == {"n": 1, "x": "-0.870193291989", "tau": "3.14608217222"} and timed["ended"] is None
    assert "the last" in run(capsys, "turning-points --alpha 1/2 --epsilon 1 --count 2")[1]
