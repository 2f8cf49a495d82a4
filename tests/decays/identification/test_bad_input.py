"""Data that cannot be used: one line that names row and column, exit code 2; and answers that state a defect."""

import csv
import json

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.errors import InputError, LimitError
from asymptotics.shell.main import main
from tests.each import each

POINTS = "\n".join(f"{n},{(-0.9) ** n:.6f}" for n in range(12))


def record(seconds=60.0, rate=100, x=None):
    t = np.arange(0, seconds, 1 / rate)
    x = np.exp(-0.03 * t) * np.cos(3 * t) if x is None else x(t)
    return "t,x\n" + "\n".join(f"{a:.4f},{b:.6f}" for a, b in zip(t, x))


BAD = {
    "empty": ("", "empty"),
    "header only": ("n,x\n", "no rows of two numbers"),
    "short": ("n,x\n0,1\n", "has 1 turning point"),
    "one column": (
        "n\n0\n1\n2\n",
        "no rows of two numbers in 4 lines",
    ),
    "unknown time": (record().replace("t,x", "t_days,x"), "row 1, column t_days: 'days' is no unit of time"),
    "two units": ("amplitude_deg,decrement_mm\n1,0.1\n2,0.3\n", "deg does not fit the column decrement_mm"),
    "text cell": (
        "n,x\n0,1\n1,oops\n",
        "1 turning point; 1 row that cannot be read left out, the first is row 3: 'oops' in the column x",
    ),
    "text below a comment": (
        "# a\n\nn,x\n0,1\n1,n/a\n2,oops\n",
        "1 turning point; 1 row that cannot be read left out, the first is row 6: 'oops'",
    ),
    "not increasing below a gap": ("n,x\n0,1\n1,n/a\n2,0.9\n1,-0.8\n3,-0.7\n", "row 5, column n: 1 after 2"),
    "no header": ("0,1\n1,oops\n", "has no column x among column 1"),
    "mixed decimal marks": (
        "n;x\n0;1,0\n1;-0.9\n2;0,8\n3;-0.7\n4;.5\n",
        "is not a number, and so in 2 of 5 rows (accepted: numbers; or say --decimal",
    ),
    "one number or another": (
        "n;x\n0;1.250\n1;-1.125\n2;1.105\n",
        "row 2: '1.250' may be 1.25 or 1250 (accepted: --decimal",
    ),
    "an unknown measure of speed": ("t,v\n0,1\n1,2\n2,3\n", "3 rows"),
    "too short an acceleration": ("t,ax (m/s^2)\n0,1\n1,2\n2,3\n", "3 rows"),
    "two positions": ("t,x,theta\n0,1,2\n1,2,2\n2,3,1\n", "x may be any of 'x', 'theta' (accepted: --columns t=1,x=2"),
    "three names above four cells": ("t,x\n0,00,1,25\n0,01,1,24\n0,02,1,22\n", "row 1: 2 names above rows of 4 cells"),
    "infinite": ("n,x\n0,1\n1,-inf\n", "1 turning point; 1 row"),
    "not whole": ("n,x\n0,1\n1.5,-0.9\n2,0.8\n3,-0.7\n", "row 3, column n"),
    "not increasing": ("n,x\n0,1\n2,0.9\n1,-0.8\n3,-0.7\n", "row 4, column n"),
    "constant": ("n,x\n" + "\n".join(f"{n},{(-1) ** n}" for n in range(9)), "column x: all values"),
    "signs": ("n,x\n" + "\n".join(f"{n},{0.9**n * (1 if n < 6 else -1)}" for n in range(12)), "signs do not alternate"),
    "unclear columns": ("a,b\n1,2\n2,3\n", "--kind"),
    "negative amplitude": ("amplitude,decrement\n1,0.1\n-0.5,0.1\n0.3,0.1\n", "row 3, column amplitude"),
    "a digit as wide as the motion": (
        "amplitude,decrement,resolution\n1,0.3,0.05\n0.1,0.19,0.05\n",
        "row 3, column resolution: 0.05 leaves no limit in this row",
    ),
    "non-monotone time": (
        "t,x\n" + "\n".join(f"{i if i != 70 else 3},{np.cos(i / 9)}" for i in range(200)),
        "row 72, column t",
    ),
    "constant record": ("t,x\n" + "\n".join(f"{i},3" for i in range(200)), "all values are 3"),
    "short record": ("t,x\n0,1\n1,0\n2,-1\n", "3 rows"),
    "clipped": (record(x=lambda t: np.clip(np.exp(-0.01 * t) * np.cos(3 * t), -0.05, 0.05)), "clipped"),
    "too coarse": (record(rate=1), "samples"),
    "no motion but noise": (record(x=lambda t: np.random.default_rng(0).standard_normal(len(t))), "(accepted: "),
    "ragged": (
        "n,x\n0,1\n1,-0.9,5\n",
        "1 turning point; 1 row that cannot be read left out, the first is row 3: '3 cells'",
    ),
}


@pytest.mark.parametrize("case", BAD)
def test_bad_files_end_with_one_line_and_code_2(case, tmp_path, capsys):
    text, expected = BAD[case]
    path = tmp_path / "data.csv"
    path.write_text(text)
    kind = ["--kind", "turning-points"] if case == "no header" else []
    assert main(["identify", str(path), *kind]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.count("\n") == 1
    assert expected in captured.err, captured.err


BAD_OPTIONS = [
    ["--kind", "movie"],
    ["--unit", "kg"],
    ["--laws", "1+1"],
    ["--laws", "-1"],
    ["--laws", "free+1"],
    ["--laws", "1+s3"],
    ["--laws", "__import__('os')"],
    ["--mass", "-1"],
    ["--noise", "0"],
    ["--amplitudes", "3:4"],
    ["--amplitudes", "half"],
    ["--mass", "1", "--stiffness", "1", "--omega0", "1"],
    ["--plot", "picture.bmp"],
    ["--csv", "/dev/null/laws.csv"],
]


@each("options", BAD_OPTIONS)
def test_bad_options_end_with_one_line_and_code_2(options, tmp_path, capsys):
    path = tmp_path / "data.csv"
    path.write_text("n,x\n" + POINTS)
    assert main(["identify", str(path), *options]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.count("\n") == 1
    assert options[0] in captured.err or options[-2] in captured.err


def test_units_that_do_not_fit_are_refused(tmp_path):
    for name, header in (("a.csv", "n,x_deg"), ("b.csv", "n,x_m")):
        (tmp_path / name).write_text(header + "\n" + POINTS)
    with pytest.raises(InputError, match="does not fit"):
        asy.identify(tmp_path / "a.csv", unit="m")
    with pytest.raises(InputError, match="different units"):
        asy.identify([tmp_path / "a.csv", tmp_path / "b.csv"], laws=["1"])


def test_missing_cells_are_left_out_and_said_and_units_are_read_under_their_other_names(tmp_path):
    path = tmp_path / "points.csv"
    path.write_text("n;phi [degrees]\n" + POINTS.replace(",", ";").replace("-0.900000", "n/a", 1))
    answer = asy.identify(path, laws=["1"])
    assert answer.units.unit == "deg"
    assert len(answer.runs[0].n) == 11
    assert "1 row with a missing cell (empty, nan, n/a) left out, the first is row 3" in answer.notes


def test_a_missing_file_and_a_binary_file_are_named(tmp_path, capsys):
    assert main(["identify", str(tmp_path / "nothing.csv")]) == 2
    (tmp_path / "binary.csv").write_bytes(bytes(range(256)))
    assert main(["identify", str(tmp_path / "binary.csv")]) == 2
    assert capsys.readouterr().err.count("\n") == 2


def test_a_growing_decay_is_called_growing():
    x = (-1.05) ** np.arange(30) * (1 + 1e-4 * np.random.default_rng(0).standard_normal(30))
    answer = asy.identify({"n": np.arange(30), "x": x}, laws=["1", "2"])
    assert any("grows" in note for note in answer.notes)
    assert answer.law("1").law.epsilon[0].high < 0


def test_exact_data_give_narrow_intervals_that_hold_the_truth():
    q = np.exp(-np.pi * 0.01 / np.sqrt(1 - 0.01**2))
    answer = asy.identify({"n": np.arange(40), "x": np.round((-q) ** np.arange(40), 8)}, laws=["1", "2", "free"])
    assert answer.law("1").law.epsilon[0].contains(0.02)
    assert answer.law("free").law.alpha.contains(1.0)
    assert answer.law("2").law.verdict == "refuted"


def test_the_laws_as_a_table_and_the_picture_are_written_together(tmp_path, capsys):
    path, table, picture = tmp_path / "data.csv", tmp_path / "laws.csv", tmp_path / "laws.pdf"
    path.write_text("n,x\n" + POINTS)
    line = ["identify", str(path), "--laws", "1", "2", "--no-bootstrap", "--csv", str(table)]
    assert main([*line, "--plot", str(picture), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["files"] == [str(picture), str(table)]
    head, *rows = list(csv.reader(table.read_text().splitlines()))
    names = ["law", "verdict", "parameter", "estimate", "low", "high", "dAICc", "held_out_error", "code"]
    assert head == names and all(float(row[4]) <= float(row[3]) <= float(row[5]) for row in rows)
    assert sorted({row[0] for row in rows}) == ["1", "2", "before any law"]
    assert picture.read_bytes().startswith(b"%PDF")
    assert main([*line[:-1], str(path)]) == 2
    assert path.read_text() == "n,x\n" + POINTS


def test_a_record_of_one_row_is_refused_by_its_count(tmp_path):
    """It has no step of time: the search for a second mode took the mean of nothing."""
    file = tmp_path / "one.csv"
    file.write_text("t,x\n0,0")
    with pytest.raises(asy.InputError, match="1 row with numbers"):
        asy.identify(file, laws=["1"], bootstrap=False)


def test_more_half_swings_than_can_be_computed_are_refused_at_once():
    n = np.array([0, 10**6, 3 * 10**8, 10**9])
    for data in ({"n": n, "x": [1.0, 0.9, 0.5, 0.2]}, Observations.of(n, [1.0, 0.9, 0.5, 0.2])):
        with pytest.raises(LimitError, match=r"1e\+09 half-swings, .* about 500 GB"):
            asy.identify(data)


def test_a_place_in_metres_a_second_is_read_as_the_speed_that_it_is(tmp_path, capsys):
    """The velocity of a linear decay: its rate is the same; as a place in other units it would be one as well."""
    (tmp_path / "data.csv").write_text(record().replace("t,x", "t,x [m/s]"))
    assert main(["identify", str(tmp_path / "data.csv"), "--laws", "1", "2", "--json"]) == 0
    assert any("v: 'x [m/s]'" in note for note in json.loads(capsys.readouterr().out)["notes"])
