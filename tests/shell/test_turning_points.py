"""The command turning-points: any law, and in what x is told."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

import asymptotics as asy
from asymptotics.ask.questions.turning_points import _points as ask
from asymptotics.law_given import Given
from asymptotics.shell.main import main
from tests.shell.answers import answer, run


@pytest.mark.parametrize(
    ("line", "unit", "first"),
    [
        ("--law 2:1/10", "x0", "1.0000"), ("--law 2:1/10 --spring pendulum --x0 2.9", "rad", "2.9000"),
        ("--law 2:1/10 --spring 3:1/2 --x0 2", "strengths", "2.0000"),
        ("--law 2:1/10 --stiffness 2 --x0 3", "m", "3.0000"),
        ("--law 1,2:1/10 --x0 2", "strengths", "2.0000"), ("--law 2:1/10 --v0 1", "x0", "1.3995"),
        ("--law 2:1/10 --spring pendulum --v0 1", "rad", "1.5050"),
        ("--law 2:1/20 --x0 -2 --v0 1", "strengths", "1.9476"),
    ],
)  # fmt: skip
def test_turning_points_say_in_what_x_is_told(capsys, line, unit, first):
    assert main(["turning-points", *line.split(), "--count", "2", "--digits", "5", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert (data["x_unit"], data["points"][0]["x"]) == (unit, first)
    assert main(["turning-points", *line.split(), "--count", "2", "--digits", "5"]) == 0
    head = capsys.readouterr().out.splitlines()[0]
    assert ("rad" in head, "strengths" in head) == (unit == "rad", unit == "strengths")


@pytest.mark.parametrize(
    ("oscillator", "unit", "latex"),
    [
        ({"law": {2: "1/20"}, "x0": -2}, "units of the strengths", r"x_n\ \text{(units of the strengths)}"),
        ({"law": {2: "1/20"}, "x0": -2, "v0": 1}, "units of the strengths", r"x_n\ \text{(units of the strengths)}"),
        ({"law": {2: "1/20"}, "x0": -2, "spring": "pendulum"}, "rad", r"x_n/\mathrm{rad}"),
    ],
)
def test_picture_page_and_formula_tell_the_unit_of_x(oscillator, unit, latex):
    """Not that of the start, which is -2 itself."""
    given = dict(oscillator)
    moving = asy.Oscillator(given.pop("law"), **given)
    found = ask(Given(moving), 2, digits=8, start=0, times=False)
    assert found.plot().get_ylabel() == f"|x| ({unit})"
    assert f"x [{unit}]" in found._repr_html_() and latex in found._formula()
    assert f"place of turning point n, in {unit}" in found._repr_latex_() and "of the start" not in found._repr_latex_()
    assert unit in found.points[0]._repr_html_()
    if "v0" in oscillator:
        assert "turning point 0 has the amplitude 1.9475547, at " in found._repr_html_()


def test_a_start_in_motion_has_the_places_of_its_motion(capsys):
    """The same in m = 1 kg and k = 1 N/m, where the route has another unit; and it has a certificate."""
    line = "turning-points --law 2:1/20 --law 0:1/50 --x0 -2 --v0 1 --count 4 --digits 15 --times"
    bare, si = answer(capsys, line), answer(capsys, f"{line} --mass 1")
    assert [(p["x"], p["tau"]) for p in bare["points"]] == [(p["x"], p["t"]) for p in si["points"]]
    assert bare["first"]["amplitude"] == bare["points"][0]["x"]


def test_both_frames_tell_the_end_in_the_same_sentence(capsys):
    for line, end in (
        ("--law 0:1/5 --x0 1", "ended: turning point 2 is the last: the motion sticks there"),
        ("--law 2:1/10 --spring pendulum --v0 3", "the motion goes over the top and rotates"),
    ):
        for units in ("", " --mass 1"):
            assert end in run(capsys, f"turning-points {line}{units} --count 4 --digits 4")[1]


def test_its_own_file_without_units_is_read_back(capsys, tmp_path):
    path = tmp_path / "points.csv"
    for start in ("--x0 -2", "--x0 -2 --v0 1"):
        assert run(capsys, f"turning-points --law 2:1/20 {start} --count 3 --times --csv {path}")[0] == 0
        for said in ("", f" --law 2:1/20 {start}"):
            code, out, _ = run(capsys, f"compare {path}{said}")
            assert code == 0 and "6 of 6 values are right in every digit" in out
        code, _, err = run(capsys, f"compare {path} --law 2:1/20 {start} --stiffness 2")
        assert code == 2 and "units of the strengths" in err  # m of a true spring are none


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
    ):
        code, _, err = run(capsys, f"{line} {more} --certificate p.json")
        assert code == 2 and argument in err and err.count("\n") == 1
    assert run(capsys, f"{line} --certificate points.txt")[0] == 2
