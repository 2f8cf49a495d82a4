"""Files of values that are right, cut, slightly wrong and plainly wrong; what integrators and formulas look like."""

import csv
import io
import sys
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

from asymptotics.decays.comparison import compare_file, truth
from asymptotics.errors import InputError
from asymptotics.law import Law, Oscillator
from asymptotics.law_given import Given, given_of
from asymptotics.shell.main import main
from asymptotics.turning.choose import turning_points

sys.path.insert(0, str(Path(__file__).parent))


import examples

from tests.each import each

EPSILON = 0.1


def compared(tmp_path, data, law):
    examples.write(tmp_path / "mine.csv", *data)
    return compare_file(tmp_path / "mine.csv", Given(Oscillator(law)))


# --- the worked examples


def test_dop853_with_a_naive_v_loses_digits_at_every_turning_point(tmp_path):
    """Two motions never part (|(dx, dv)| does not grow), so what grows was lost there and then: next to v = 0."""
    found = compared(tmp_path, examples.dop853_in_steps(2, 0.5, 16, 321), {2: "1/2"})
    wrong = {name: np.array([float(Fraction(r.given) - Fraction(r.certified)) for r in found.rows if r.column == name])
             for name in "xv"}  # fmt: skip
    tau = np.array([float(row.key) for row in found.rows if row.column == "x"])
    growth = np.diff(np.hypot(wrong["x"], wrong["v"]))
    turns = [float(p.tau) for p in turning_points(Law({2: "1/2"}), 6, 12, times=True).points[1:]]
    near = np.min(np.abs((tau[1:] + tau[:-1])[:, None] / 2 - np.array(turns)), axis=1) < 0.2
    assert near.mean() < 0.13
    assert growth[near].clip(0).sum() > 0.99 * growth.clip(0).sum()
    for turn in turns:
        assert growth[np.abs(tau[1:] - turn) < 0.3].max() > 1e-10
    smooth = compared(tmp_path, examples.dop853_in_steps(1, 0.5, 16, 321), {1: "1/2"})
    assert float(smooth.summary["median_digits"]) > float(found.summary["median_digits"]) + 5
    assert found.summary["look"]["kind"] == "truncation"


def test_the_sign_fixed_on_each_half_swing_keeps_the_digits(tmp_path):
    careful = compared(tmp_path, examples.dop853_by_half_swings(2, 0.5, 16, 41), {2: "1/2"})
    assert float(careful.summary["median_digits"]) > 11.5


def test_rk4_is_truncation_until_its_steps_are_coarse(tmp_path):
    fine = compared(tmp_path, examples.rk4(2, EPSILON, 30, 600), {2: "1/10"})
    finer = compared(tmp_path, examples.rk4(2, EPSILON, 30, 1200), {2: "1/10"})
    coarse = compared(tmp_path, examples.rk4(2, EPSILON, 30, 100), {2: "1/10"})
    assert fine.summary["look"]["kind"] == finer.summary["look"]["kind"] == "truncation"
    assert coarse.summary["look"]["kind"] == "phase drift"
    gained = float(finer.summary["median_digits"]) - float(fine.summary["median_digits"])
    assert gained == pytest.approx(np.log10(2**4), abs=0.25)  # its order is 4


def test_a_first_order_formula_is_phase_drift(tmp_path):
    for alpha, law in ((2, {2: "1/10"}), (1.5, {"3/2": "1/10"})):
        found = compared(tmp_path, examples.first_order(alpha, EPSILON, 30, 301), law)
        assert found.summary["look"]["kind"] == "phase drift"


WRONG = [(2, 0.11, "more"), (2, 0.09, "less"), (2.5, 0.1, "alpha were 2.50")]


@pytest.mark.parametrize(("alpha", "epsilon", "words"), WRONG)
def test_a_wrong_law_is_recognised(tmp_path, alpha, epsilon, words):
    look = compared(tmp_path, examples.rk4(alpha, epsilon, 30, 600), {2: "1/10"}).summary["look"]
    assert look["kind"] == "wrong law"
    assert words in look["reason"]


def test_a_strength_that_is_wrong_by_a_thousandth_is_no_truncation(tmp_path):
    assert compared(tmp_path, examples.rk4(2, 0.1001, 30, 600), {2: "1/10"}).summary["look"]["kind"] == "wrong law"


# --- turning points


@pytest.fixture(scope="module")
def table():
    return turning_points(Law({2: "1/10"}), 12, 40, times=True)


def file_of(tmp_path, header, rows):
    path = tmp_path / "mine.csv"
    path.write_text("\n".join([header, *rows]) + "\n")
    return path


def test_right_values_are_right_in_every_digit(tmp_path, table):
    rows = [f"{p.n},{p.x[:17]},{float(p.tau)!r}" for p in table.points]
    found = compare_file(file_of(tmp_path, "n,x,tau", rows), Given(Oscillator({2: "1/10"})))
    assert found.certified
    assert found.summary["look"]["kind"] == "rounding"
    assert float(found.summary["worst_digits"]) > 13


def test_the_first_wrong_digit_is_marked(tmp_path, table):
    wrong = table.points[3].x[:9] + ("1" if table.points[3].x[9] != "1" else "5") + "00"
    found = compare_file(file_of(tmp_path, "n,x", ["3," + wrong]), Given(Oscillator({2: "1/10"})))
    (row,) = found.rows
    assert row.certified.startswith(table.points[3].x[:20])
    assert row.marked.startswith(table.points[3].x[:8])
    assert "[" in row.marked
    assert 6 < float(row.digits) < 8


def test_a_wrong_sign_has_no_digit_and_an_ended_motion_no_value(tmp_path):
    found = compare_file(file_of(tmp_path, "n,x", ["1,0.4", "2,-0.2", "3,0.1"]), Given(Oscillator({0: "3/10"})))
    assert [(row.digits, row.certified) for row in found.rows] == [
        ("0.00", "-0.40000000000000000000"), ("20.00", "-0.20000000000000000000"), ("0.00", None)]  # fmt: skip
    assert "turning point 2 is the last" in found.summary["ended"]


def test_a_column_that_is_right_as_far_as_it_goes_says_nothing_about_errors(tmp_path, table):
    """Times to two digits, amplitudes 2 % too small: the law is wrong, and the times have not drifted."""
    rows = [f"{p.n},{float(p.x) * 0.98**p.n!r},{float(p.tau):.1f}" for p in table.points]
    look = compare_file(file_of(tmp_path, "n,x,tau", rows), Given(Oscillator({2: "1/10"}))).summary["look"]
    assert look["kind"] == "wrong law"
    rows = [f"{p.n},{float(p.x):.2f},{float(p.tau) * 1.01!r}" for p in table.points]
    look = compare_file(file_of(tmp_path, "n,x,tau", rows), Given(Oscillator({2: "1/10"}))).summary["look"]
    assert look["kind"] == "phase drift"


def test_units_scale_what_is_compared(tmp_path, table):
    """m = 2, k = 8, x0 = 1/2: omega_0 = 2, so x = X/2 and t = tau/2; b = epsilon k/(omega_0^2 x0) = 4 epsilon."""
    p = table.points[2]
    rows = [f"2,{float(p.x) / 2!r},{float(p.tau) / 2!r}"]
    oscillator = Oscillator({2: "4/10"}, mass=2, stiffness=8, x0="1/2")
    found = compare_file(file_of(tmp_path, "n,x [m],t [s]", rows), given_of(oscillator))
    assert all(float(row.digits) > 15 for row in found.rows)
    moment = compare_file(file_of(tmp_path, "t [s],x [m]", ["0,0.5", "1,-0.19"]), given_of(oscillator))
    dimensionless = compare_file(file_of(tmp_path, "tau,x", ["0,1", "2,-0.38"]), Given(Oscillator({2: "1/10"})))
    assert float(moment.rows[1].certified) * 2 == pytest.approx(float(dimensionless.rows[1].certified), rel=1e-15)
    assert moment.rows[1].digits == dimensionless.rows[1].digits


@each(
    ("text", "columns", "words"),
    [
        ("", None, "no rows"),
        ("n,x\n", None, "no rows"),
        ("1,2\n", None, "no header"),
        ("n,x\n1,abc\n", None, "not an exact number"),
        ("n,x\n1,nan\n", None, "not an exact number"),
        ("n,x\n1\n", None, "cells"),
        ("n,x\n1.5,2\n", None, "not an integer"),
        ("n,x\n-1,2\n", None, "out of range"),
        ("tau,x\n-1,2\n", None, "before the start"),
        ("n,x\n1,2\n", "n,tau", "no column"),
        ("n,x\n1,2\n", "n,y", "no quantity"),
        ("n,x\n1,2\n", "n,x=9", "no column"),
        ("n,x\n1,2\n", "n", "a key and a value"),
        ("n,x\n1,2\n", "n,n", "a key and a value"),
        ("x,v\n1,2\n", None, "no key"),
        ("n,v\n1,2\n", None, "v is 0"),
        ("n,x [m]\n1,2\n", None, "is in 'm'"),
        ("t [ms],x\n1,2\n", None, "is in 'ms'"),
        ('n,x\n1,"2\n', None, "not CSV"),
    ],
)
def test_what_cannot_be_compared_is_refused(tmp_path, text, columns, words):
    path = tmp_path / "mine.csv"
    path.write_text(text)
    with pytest.raises(InputError, match=words):
        compare_file(path, Given(Oscillator({2: 1})), columns=columns)


def test_a_file_that_is_no_text_is_refused(tmp_path):
    (tmp_path / "a.csv").write_bytes(b"\xff\xfe\x00n,x")
    for path in (tmp_path / "a.csv", tmp_path / "missing.csv", tmp_path, Path("/dev/zero")):
        with pytest.raises(InputError, match="cannot read|device"):
            compare_file(path, Given(Oscillator({2: 1})))


def test_other_separators_comments_and_names(tmp_path):
    path = tmp_path / "mine.csv"
    path.write_text("# by hand\nstep;position;when\n0;1;0\n1;-0.41;3.381\n")
    for columns in ("n,x,tau", "n=step,x=position,tau=when", "n=1,x=2,tau=3"):
        found = compare_file(path, Given(Oscillator({2: 1})), columns=columns)
        assert [(row.line, row.column) for row in found.rows] == [(3, "x"), (3, "tau"), (4, "x"), (4, "tau")]


def test_the_values_themselves_are_not_written_over(tmp_path, capsys):
    path = file_of(tmp_path, "n,x", ["0,1", "1,-0.42"])
    before = path.read_bytes()
    for option in ("--csv", "--plot"):
        assert main(["compare", str(path), "--alpha", "2", "--epsilon", "1", option, str(path)]) == 2
    assert path.read_bytes() == before
    assert "two different files" in capsys.readouterr().err


def test_the_rows_as_csv_and_as_a_picture(tmp_path):
    found = compare_file(file_of(tmp_path, "n,x", ["0,1", "1,-0.42", "2,0.2635"]), Given(Oscillator({2: 1})))
    rows = list(csv.DictReader(io.StringIO(found.to_csv())))
    assert [row["digits"] for row in rows] == [row.digits for row in found.rows]
    assert found.lost_digits()["x"][0] == [0, 1, 2]
    assert found.picture("svg").startswith(b"<?xml")


def test_fractions_in_a_file_are_numbers(tmp_path):
    """-8/9 in the place of x_1, and a time 3/2, in the picture too."""
    points, motion = tmp_path / "points.csv", tmp_path / "motion.csv"
    points.write_text("n,x\n0,1\n1,-8/9\n2,3/4\n")
    motion.write_text("tau,x\n1/2,7/8\n3/2,1/9\n5/2,-1e400\n")
    for file in (points, motion):
        for picture in ([], ["--plot", str(tmp_path / "lost.svg")]):
            assert main(["compare", str(file), "--alpha", "2", "--epsilon", "1/10", "--quiet", *picture]) in (0, 1)


def test_a_record_in_si_may_begin_at_the_start(tmp_path):
    path = tmp_path / "lab.csv"
    path.write_text("t,x\n0,0.2\n0.1,0.18\n")
    found = compare_file(path, given_of(Oscillator({2: "1/10"}, mass="3/2", stiffness=30, x0="1/5")))
    assert found.certified
    assert found.rows[0].digits == "20.00"


def test_the_places_that_are_done_are_collected_once_a_pass(tmp_path, monkeypatch):
    """Asked for every time, 10^5 values took minutes: each look collects all that is there."""
    looks = []
    places = truth._Moments.places
    monkeypatch.setattr(truth._Moments, "places", lambda made: looks.append(1) or places(made))
    rows = [f"{k}/40,1/3" for k in range(200)]
    found = compare_file(file_of(tmp_path, "tau,x", rows), Given(Oscillator({2: "1/10"})))
    assert len(found.rows) == 200
    assert 1 <= len(looks) <= len(truth._GUARDS) + 1
