"""Rows that are done are kept when the time is over, or at Ctrl-C: in text and files, from Python, at a signal.

At every look at the clock, of every question: ``tests/ask/test_cut_short.py``.
"""

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


def stop_at(monkeypatch, place, count, error):
    """From the call number ``count`` on what makes a row raises ``error``: a time that is over stays over."""
    whole, calls = resolve_name(place), []

    def cut(*args, **kwargs):
        calls.append(args)
        if len(calls) >= count:
            raise error()
        return whole(*args, **kwargs)

    monkeypatch.setattr(place, cut)


def test_an_interrupt_keeps_text_and_file_and_its_exit_code(capsys, monkeypatch, tmp_path):
    stop_at(monkeypatch, "asymptotics.turning.routes.quadratic.proved_point", 3, KeyboardInterrupt)
    target = tmp_path / "points.csv"
    line = f"turning-points --alpha 2 --epsilon 1 --count 5 --digits 6 --csv {target}"
    assert main(line.split()) == 130
    told = capsys.readouterr()
    assert "1.00000\n1  -0.410720" in told.out and "cut short: 2 rows are done; missing: n = 2 ... 4" in told.out
    assert "interrupted" in told.err and target.read_text().count("\n") == 3


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
