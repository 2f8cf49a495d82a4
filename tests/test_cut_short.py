"""Rows that are done are kept when the time is over, or at Ctrl-C: printed, written; those of a whole run."""

import json
import signal
import subprocess
import sys
import time
from pkgutil import resolve_name

import pytest

import asymptotics as asy
from asymptotics.errors import LimitError
from asymptotics.running.cut_short import done
from asymptotics.shell.main import main


def OVER():
    return LimitError("max_seconds", "60 s are over at a step", "a larger limit")


SI = "--alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5"
SEQUENCES = {  # a line for each route, and where its points are made
    "--alpha 3/2 --epsilon 1/10": "asymptotics.turning.table.proved_point",
    "--alpha 2 --epsilon 1": "asymptotics.turning.routes.quadratic.proved_point",
    "--alpha 1 --epsilon 1/10 --times": "asymptotics.turning.routes.linear.proved_point",
    "--alpha 0 --epsilon 1/100": "asymptotics.turning.routes.dry.proved_point",
    "--law 2:1/10 --spring pendulum --x0 2": "asymptotics.turning.routes.closed_primitive.proved_point",
    "--law 3/2:1/10 --spring pendulum --x0 2 --times": "asymptotics.turning.table.proved_point",
    f"{SI} --times": "asymptotics.turning.table.proved_point",
    "--alpha 3/2 --epsilon 1/10 --x0 3": "asymptotics.turning.table.proved_point",
    "--alpha 3/2 --epsilon 1/10 --v0 1": "asymptotics.turning.table.proved_point",
}


def stop_at(monkeypatch, place, count, error):
    """From the call number ``count`` on what makes a row raises ``error``: a time that is over stays over."""
    whole, calls = resolve_name(place), []

    def cut(*args, **kwargs):
        calls.append(args)
        if len(calls) >= count:
            raise error()
        return whole(*args, **kwargs)

    monkeypatch.setattr(place, cut)


@pytest.mark.parametrize("line", SEQUENCES)
def test_the_points_that_are_done_are_those_of_a_whole_run(line, capsys, monkeypatch):
    words = ["turning-points", *line.split(), "--count", "5", "--digits", "9", "--json"]
    assert main(words) == 0
    whole = json.loads(capsys.readouterr().out)["points"]
    stop_at(monkeypatch, SEQUENCES[line], 4, OVER)
    assert main(words) == 2
    told = capsys.readouterr()
    found = json.loads(told.out)
    assert found["points"] == whole[:3] != whole and found["certified"] and found["ended"] is None
    assert found["missing"] == "n = 3 ... 4" and "60 s are over" in told.err


def test_an_interrupt_keeps_text_and_file_and_its_exit_code(capsys, monkeypatch, tmp_path):
    stop_at(monkeypatch, "asymptotics.turning.routes.quadratic.proved_point", 3, KeyboardInterrupt)
    target = tmp_path / "points.csv"
    line = f"turning-points --alpha 2 --epsilon 1 --count 5 --digits 6 --csv {target}"
    assert main(line.split()) == 130
    told = capsys.readouterr()
    assert "1.00000\n1  -0.410720" in told.out and "cut short: 2 rows are done; missing: n = 2 ... 4" in told.out
    assert "interrupted" in told.err and target.read_text().count("\n") == 3


def test_nothing_is_printed_where_nothing_is_done(capsys, monkeypatch):
    stop_at(monkeypatch, "asymptotics.turning.routes.quadratic.proved_point", 1, OVER)
    assert main(["turning-points", "--alpha", "2", "--epsilon", "1", "--count", "5"]) == 2
    assert capsys.readouterr().out == ""


TABLES = {
    "smith2012.table1 --rows 5": ("asymptotics.tables.quadratic.decimal_of_ball", 7, 3),
    "turning-points --law 2:1/10 --rows 5": ("asymptotics.turning.routes.quadratic.proved_point", 4, 3),
    "half-periods --alpha 2 --epsilon 1/10,1/2": ("asymptotics.tables.turning.turning_points", 2, 1),
    "normal-form --alpha 1,2,3 --rows 2": ("asymptotics.tables.coefficients.expansion_coefficients", 3, 4),
    "stokes.constants --alpha 0,2": ("asymptotics.tables.stokes.stokes_constants", 2, 1),
    "stops --epsilon 1/10,1/20": ("asymptotics.tables.turning.turning_points", 2, 1),
    "smith2012.c --rows 3": ("asymptotics.tables.quadratic.coefficients", 3, 2),
    "smith2012.f --rows 3": ("asymptotics.tables.quadratic.coefficients", 3, 2),
}


@pytest.mark.parametrize("line", TABLES)
def test_the_rows_of_a_table_that_are_done(line, capsys, monkeypatch):
    words = ["table", *line.split(), "--digits", "6", "--json"]
    assert main(words) == 0
    whole = json.loads(capsys.readouterr().out)
    place, call, rows = TABLES[line]
    stop_at(monkeypatch, place, call, OVER)
    assert main(words) == 2
    found = json.loads(capsys.readouterr().out)
    width = len(whole["columns"])
    assert [row[-width:] for row in found["rows"]] == whole["rows"][:rows] and len(whole["rows"]) > rows
    assert found["certified"] and found["missing"].startswith("what comes after ")


COMPARED = {  # the file, what it is held against; what is cut at which call, how many rows are kept
    "n,x\n0,1\n1,-0.41\n2,0.26\n3,-0.19\n": (
        "--alpha 2 --epsilon 1",
        *("asymptotics.turning.routes.quadratic.proved_point", 4, 3),
    ),
    "n,x,t\n0,0.2,0\n1,-0.1,0.7\n2,0.05,1.4\n": (
        "--alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5",
        *("asymptotics.turning.table.proved_point", 3, 2),
    ),
    "n,x\n5000,0.1\n0,1\n": ("--alpha 2 --epsilon 1", "asymptotics.decays.comparison.truth.turning_points", 2, 1),
    "tau,x,v\n20,0.5,0\n0,1,0\n5,0.2,0.9\n": ("--alpha 3/2 --epsilon 1/10", "asymptotics.flow.dense._swing", 3, 2),
    "tau,x\n1,0.5\n2,-0.3\n3,-0.9\n": (
        "--alpha 0 --epsilon 1/100",
        "asymptotics.decays.comparison.run.turning_points",
        1,
        3,
    ),
    "tau,amplitude,phase\n0,1,0\n1,0.9,0\n2,0.8,0\n": (
        "--alpha 2 --epsilon 1/10",
        *("asymptotics.envelopes.first_order.certified_decimal", 5, 2),
    ),
    "half_cycle,u\n1,0.7\n4,-0.2\n2,-0.41\n": (
        "--table smith2012.table1",
        *("asymptotics.tables.quadratic.decimal_of_ball", 6, 2),
    ),
}


@pytest.mark.parametrize("text", COMPARED)
def test_the_rows_of_a_file_that_are_compared(text, capsys, monkeypatch, tmp_path):
    given, place, call, kept = COMPARED[text]
    path = tmp_path / "mine.csv"
    path.write_text(text)
    words = ["compare", str(path), *given.split(), "--json"]
    assert main(words) == 0
    whole = json.loads(capsys.readouterr().out)
    stop_at(monkeypatch, place, call, KeyboardInterrupt)
    assert main(words) == 130
    found = json.loads(capsys.readouterr().out)
    there = {row["line"] for row in found["rows"]}
    assert len(there) == kept and found["certified"] and found["missing"] == found["summary"]["missing"]
    assert found["rows"] == [row for row in whole["rows"] if row["line"] in there]
    assert found["summary"]["look"]["kind"] == "undecided"


def test_the_rows_of_earlier_laws_are_kept_where_the_next_has_none(capsys, monkeypatch):
    stop_at(monkeypatch, "asymptotics.turning.routes.quadratic.proved_point", 1, OVER)
    words = "table turning-points --alpha 3,2 --epsilon 1/10 --rows 3 --digits 6 --json"
    assert main(words.split()) == 2
    found = json.loads(capsys.readouterr().out)
    assert [row[1] for row in found["rows"]] == ["0", "1", "2"] and "3" in found["rows"][0][0]


def test_amplitudes_and_checks_that_are_done(capsys, monkeypatch):
    stop_at(monkeypatch, "asymptotics.equivalent.at_amplitudes.row_at", 2, OVER)
    line = "damping --alpha 2 --epsilon 1/10 --amplitudes 1,1/2,1/4 --digits 5 --json"
    assert main(line.split()) == 2
    found = json.loads(capsys.readouterr().out)
    assert len(found["rows"]) == 1 and found["missing"] == "amplitudes 1/2,1/4"
    main(["papers", "smith2012:43", "--check"])  # the runner is loaded
    capsys.readouterr()
    stop_at(monkeypatch, "paper_checks.runner.examine", 2, KeyboardInterrupt)
    assert main(["papers", "Lambert", "--check", "--json"]) == 130
    found = json.loads(capsys.readouterr().out)
    assert len(found["outcomes"]) == 1 and "checks, " in found["missing"]


@pytest.mark.parametrize("count", [2, 3, 5, 9])
def test_points_of_an_inner_swing_are_no_rows_of_damping(count, capsys, monkeypatch):
    stop_at(monkeypatch, "asymptotics.turning.routes.quadratic.proved_point", count, OVER)
    assert (
        main(["damping", "--alpha", "2", "--epsilon", "1/10", "--amplitudes", "1,1/2,1/4", "--digits", "5", "--json"])
        == 2
    )
    told = capsys.readouterr()
    assert "60 s are over" in told.err and "fault" not in told.err
    rows = json.loads(told.out)["rows"] if told.out else []
    assert [row["amplitude"] for row in rows] == ["1", "1/2", "1/4"][: len(rows)] and len(rows) == (count - 1) // 3


def test_what_a_picture_has_computed_is_no_row_of_the_answer(capsys, monkeypatch, tmp_path):
    """Whatever is drawn may ask for turning points of its own, as the curve of ``damping`` may."""

    def drawn(*_, **__):
        stop_at(monkeypatch, "asymptotics.turning.routes.quadratic.proved_point", 3, OVER)
        return asy.turning_points({2: "1/7"}, 5)

    monkeypatch.setattr("asymptotics.shell.files.pictured", drawn)
    for line in ("damping --alpha 2 --epsilon 1/10", "turning-points --alpha 2 --epsilon 1 --count 2"):
        assert main([*line.split(), "--plot", str(tmp_path / "picture.svg")]) == 2
        told = capsys.readouterr()
        assert told.out == "" and "60 s are over" in told.err and "fault" not in told.err


def test_python_has_them_from_the_error(monkeypatch):
    stop_at(monkeypatch, "asymptotics.turning.table.proved_point", 3, KeyboardInterrupt)
    with pytest.raises(KeyboardInterrupt) as stop:
        asy.turning_points(asy.Oscillator({"3/2": "1/10"}, mass=2, x0=3), 5, digits=9)
    found = done(stop.value)
    assert [p.n for p in found.points] == [0, 1] and found.points[0].x == "3.00000000" and found.unit == "m"


def test_a_real_time_out_keeps_what_is_done():
    with pytest.raises(LimitError) as stop:
        asy.turning_points({"1/2": "1/1000", "3/2": "1/10"}, 40, digits=40, route="stepping", max_seconds="3/2")
    found = done(stop.value)
    if found is None:  # refused by its estimate, on a machine that is as slow as that
        assert "would take about" in str(stop.value)
    else:
        assert 0 < len(found.points) < 40 and found.certified


@pytest.mark.timeout(60)
def test_a_signal_keeps_what_is_done():
    line = "turning-points --law 1/2:1/1000 --law 3/2:1/10 --count 900 --digits 40 --max-seconds 500 --route stepping"
    words = [sys.executable, "-m", "asymptotics", *line.split()]
    with subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as program:
        time.sleep(2.5)
        program.send_signal(signal.SIGTERM)
        out, err = program.communicate()
    assert program.returncode == 143 and err.count("\n") == 1 and "interrupted" in err
    assert out == "" or "cut short: " in out  # nothing is done yet on a machine under load


MOTIONS = {  # which call of what is cut: behind those of the value itself
    "--alpha 3/2 --epsilon 1/10": ("asymptotics.flow.dense._swing", 10, OVER),
    "--law 3/2:1/10 --spring 3:1/5": ("asymptotics.flow.dense._swing", 10, KeyboardInterrupt),
    "--alpha 0 --epsilon 1/100": ("asymptotics.curves.motion_table.reference_motion", 6, OVER),
}


@pytest.mark.parametrize("line", MOTIONS)
def test_the_value_and_the_times_that_are_done(line, capsys, monkeypatch, tmp_path):
    target, place = tmp_path / "motion.csv", MOTIONS[line]
    words = [
        "motion",
        *line.split(),
        *["--time", "20", "--reference", "--digits", "9", "--points", "20", "--json", "--csv"],
        str(target),
    ]
    assert main(words) == 0
    whole, value = target.read_text().splitlines(), json.loads(capsys.readouterr().out)
    target.unlink()
    stop_at(monkeypatch, *place)
    assert main(words) == (2 if place[2] is OVER else 130)
    found, rows = json.loads(capsys.readouterr().out), target.read_text().splitlines()
    assert found["x"] == value["x"] and 2 < len(rows) < len(whole) and rows == whole[: len(rows)]
    assert found["missing"] == f"tau > {rows[-1].split(',')[0]} in {target}"


def test_no_time_is_kept_where_the_value_is_not_done(capsys, monkeypatch, tmp_path):
    target = tmp_path / "motion.csv"
    stop_at(monkeypatch, "asymptotics.flow.dense._swing", 2, OVER)
    assert main(f"motion --alpha 3/2 --epsilon 1/10 --time 20 --reference --csv {target}".split()) == 2
    assert capsys.readouterr().out == "" and not target.exists()
