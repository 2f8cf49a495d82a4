"""The command turning-points: any law, and in what x is told."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

from asymptotics.shell.main import main
from tests.shell.answers import answer, run


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


def test_a_certificate_is_written_with_its_checker_which_needs_nothing_of_ours(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    line = "turning-points --alpha 3/2 --epsilon 1/10 --count 3 --digits 12 --times"
    code, out, _ = run(capsys, f"{line} --certificate points.json")
    assert (code, out.splitlines()[-2:]) == (0, ["points.json", "check_certificate.py"])
    check = [sys.executable, "-I", "check_certificate.py", "points.json"]
    told = subprocess.run(check, capture_output=True, text=True, check=True).stdout
    assert told.startswith("accepted") and "x = 0.764131218388" in told
    wrong = Path("points.json").read_text().replace("0.764131218388", "0.764131218389")
    Path("points.json").write_text(wrong)
    refused = subprocess.run(check, capture_output=True, text=True, check=False)
    assert (refused.returncode, "refused" in refused.stdout + refused.stderr) == (1, True)
    for more, argument in (
        ("--route help", "--certificate"),
        ("--spring pendulum", "certificate"),
        ("--v0 1", "motion"),
    ):
        code, _, err = run(capsys, f"{line} {more} --certificate p.json")
        assert code == 2 and argument in err and err.count("\n") == 1
    assert run(capsys, f"{line} --certificate points.txt")[0] == 2
