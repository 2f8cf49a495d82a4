"""The command ``motion``, as a user types it."""

import subprocess
import sys
from fractions import Fraction

import pytest

import asymptotics as asy
from asymptotics.ask.questions.motion import motion_at
from tests.each import each
from tests.shell.answers import answer, run
from tests.worlds import OSCILLATOR

DRAG = "--alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5"


def test_the_contract(capsys):
    data = answer(capsys, f"motion {DRAG} --time 7 --digits 40")
    assert {"x", "v", "amplitude", "phase", "order", "gauge", "method", "error", "command", "version"} <= set(data)
    assert data["order"] == 3 and data["gauge"] == "turning-point"
    assert all(isinstance(data[name], str) for name in ("x", "v", "amplitude", "phase", "error"))
    exact = answer(capsys, f"motion {DRAG} --time 7 --reference")
    assert exact["amplitude"] is None and exact["phase"] is None and exact["order"] is None
    gap = abs(Fraction(data["x"]) - Fraction(exact["x"]))
    assert gap < 2 * Fraction(data["error"]) and gap > Fraction(exact["error"])
    assert exact["x"] == "0.163853083446548520399362953734"  # tests/motions: two precisions, and order 5 within 1e-13


def test_the_rows_of_dry_friction_know_the_static_force_beside_a_law_of_strength_0(capsys, tmp_path):
    line = f"motion --law 0:1/10 --law 2:0 --static 2/5 --time 30 --reference --csv {tmp_path}/a.csv --points 2"
    found = answer(capsys, line)
    last = (tmp_path / "a.csv").read_text().splitlines()[-1].split(",")
    assert (found["x"], last[1]) == ("-0.400000000000000000000000000000", "-0.4")


def test_sums_of_laws_and_one_law_agree(capsys):
    one = answer(capsys, "motion --law 2:1/10 --x0 1 --time 3")
    two = answer(capsys, "motion --alpha 2 --damping 1/10 --x0 1 --time 3")
    merged = answer(capsys, "motion --law 2:1/20 --law 2:1/20 --x0 1 --time 3")
    assert one["x"] == two["x"] == merged["x"] and merged["notes"] == ["equal exponents merged: alpha = 2"]
    more = answer(capsys, "motion --law 2:1/10 --law 0:1/50 --x0 1 --time 3 --order 2")
    assert more["x"] != one["x"] and more["order"] == 2


@pytest.mark.parametrize("law", ["0", "1", "2"])
def test_exact_motion_is_certified(capsys, law):
    data = answer(capsys, f"motion --alpha {law} --damping 1/10 --x0 -1 --time 3 --reference --digits 12")
    assert data["certified"] is True and "exact" in data["method"]


def test_rest_is_an_answer(capsys):
    for choice in ("", " --reference"):
        data = answer(capsys, "motion --alpha 2 --damping 1 --x0 0 --time 5" + choice)
        assert (data["x"], data["v"], data["error"]) == ("0", "0", "0") and "rest" in data["method"]


def test_static_friction_and_extinction(capsys):
    line = "motion --alpha 0 --damping 3 --stiffness 10 --x0 1 --time 5 --digits 5"
    assert answer(capsys, line + " --reference")["x"] == "-0.20000"
    assert answer(capsys, line + " --reference --static 5")["x"] == "-0.40000"
    data = answer(capsys, line)
    assert (data["x"], data["amplitude"]) == ("-0.20000", "0.20000") and "dry friction holds" in data["notes"][0]


def test_files_appear_whole(capsys, tmp_path):
    csv, png, svg = (tmp_path / name for name in ("a.csv", "a.png", "a.svg"))
    data = answer(capsys, f"motion {DRAG} --time 3 --csv {csv} --plot {png}")
    assert data["files"] == [str(png), str(csv)]
    rows = csv.read_text().splitlines()
    assert rows[0].startswith("t [s],x [m],v [m/s],amplitude [m],phase [rad],code [--") and len(rows) == 1002
    assert float(rows[-1].split(",")[1]) == pytest.approx(float(data["x"]), abs=2 * float(data["error"]))
    assert png.read_bytes().startswith(b"\x89PNG")
    line = f"motion --alpha 2 --damping 1/10 --x0 1 --time 2 --reference --csv {csv} --plot {svg} --digits 10"
    exact = answer(capsys, line)
    rows = csv.read_text().splitlines()
    assert rows[0].startswith("t [s],x [m],v [m/s],code [--alpha=2 --damping=1/10 --x0=1 --double-error=") and float(
        rows[-1].split(",")[1]
    ) == pytest.approx(float(exact["x"]), abs=1e-9)
    first = svg.read_bytes()
    assert b"<svg" in first and run(capsys, line)[0] == 0 and svg.read_bytes() == first


def test_text_for_people(capsys):
    code, out, _ = run(capsys, f"motion {DRAG} --time 7 --digits 6 --gauge averaging --v0 -1/2")
    assert code == 0 and " m/s" in out and "gauge averaging" in out and "certified: false" in out


@each(
    ("line", "argument"),
    [
        ("motion --alpha 2 --damping 1 --x0 1 --time -1", "--time"),
        ("motion --alpha 2 --damping 1 --x0 1 --time nan", "--time"),
        ("motion --alpha 2 --damping 1 --x0 1 --time 1 --mass 0", "--mass"),
        ("motion --alpha 2 --damping 1 --x0 1 --time 1 --stiffness -3", "--stiffness"),
        ("motion --alpha 2 --damping 1 --x0 1kg --time 1", "--x0"),
        ("motion --alpha 2 --damping -1 --x0 1 --time 1", "--damping"),
        ("motion --alpha -1/2 --damping 1 --x0 1 --time 1", "--alpha"),
        ("motion --alpha 2 --x0 1 --time 1", "--damping"),
        ("motion --law 2 --x0 1 --time 1", "--law"),
        ("motion --law 2:1 --alpha 2 --x0 1 --time 1", "--law"),
        ("motion --alpha 2 --damping 1 --x0 1 --time 1 --order 0", "--order"),
        ("motion --alpha 2 --damping 1 --x0 1 --time 1 --order 2 --reference", "--reference"),
        ("motion --alpha 2 --damping 1 --x0 1 --time 1 --gauge energy", "--gauge"),
        ("motion --alpha 0 --damping 1 --x0 1 --time 1 --static 2", "--static"),
        ("motion --alpha 0 --damping 1 --x0 1 --time 1 --static 1/2 --reference", "--static"),
        ("motion --alpha 3/2 --damping 1 --x0 1 --time 1e9 --reference", "--max-seconds"),
        ("motion --alpha 2 --damping 1 --x0 1 --time 1 --plot a.bmp", "--plot"),
        ("motion --alpha 2 --damping 1 --x0 1 --time 1 --csv /proc/none/a.csv", "--csv"),
        ("motion --alpha 2 --damping 1 --x0 1 --time 1 --digits 5000", "--digits"),
        ("turning-points --law 2 --count 3", "--law"),
        ("turning-points --law 2:1 --alpha 2 --epsilon 1 --count 3", "--law"),
        ("turning-points --alpha 3/2 --epsilon 1 --count 3 --digits 2000", "--digits"),
        ("turning-points --law 3/2:1 --law 2:1 --count 90000 --max-seconds 1", "--max-seconds"),
    ],
)
def test_bad_input_is_one_line_that_names_the_argument(capsys, line, argument):
    code, out, err = run(capsys, line)
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert argument in err


def test_a_reference_has_a_certificate_and_an_estimate_has_none(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    line = "motion --law 0:1/50 --law 2:1/10 --v0 1 --time 5/2 --digits 12"
    assert run(capsys, f"{line} --reference --certificate x.json")[0] == 0
    check = [sys.executable, "-I", "check_certificate.py", "x.json"]
    told = subprocess.run(check, capture_output=True, text=True, check=True).stdout
    assert told.startswith("accepted") and "t = 5/2: x = -0.132661303702" in told
    for more, reason in (("--order 2", "estimate"), ("--reference --static 1/5", "static")):
        code, _, err = run(capsys, f"motion --alpha 0 --epsilon 1/10 --time 3 {more} --certificate y.json")
        assert (code, reason in err, err.count("\n")) == (2, True, 1)


def test_the_question_in_python_says_what_the_objects_say():
    osc = OSCILLATOR
    found = motion_at(osc, 7, order=2, digits=9, bound=True)
    assert found.point == asy.motion(osc, order=2).at(7, digits=9)
    assert found.bound == asy.motion(osc, order=2).bound(7, digits=9)
    assert found.uniform_bound == asy.motion(osc, order=2).uniform_bound()
    truth = motion_at(osc, 7, reference=True, digits=9)
    assert truth.point == asy.reference(osc).at(7, digits=9) and truth.curve == asy.reference(osc)
    for wrong in ({"order": 2}, {"gauge": "averaging"}, {"bound": True}, {"best_order": "1/5"}):
        with pytest.raises(asy.InputError):
            motion_at(osc, 7, reference=True, **wrong)
    for wrong in ({"static": 1}, {"digits": 301}, {"order": 13}, {"gauge": "none"}):
        with pytest.raises(asy.InputError):
            motion_at(osc, 7, **wrong)
