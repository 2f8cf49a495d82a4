"""Near misses of the layouts: what looks like one of them and must be read otherwise, told, or asked."""

import io
import json

import numpy as np
import pandas as pd
import pytest

from asymptotics.decays.identification.sources import load
from asymptotics.decays.records.sources import How
from asymptotics.decays.records.table import read_table
from asymptotics.errors import InputError, LimitError
from tests.decays.records.layouts import PEAKS, TURNS, N, T, V, rows

COUNT = np.arange(len(TURNS))
POINTS = {"n": COUNT, "t": TURNS, "x": PEAKS}


def table(text, **how):
    return read_table(io.StringIO(text), how=How(**how))


def named(name, text):
    """An open file with a name."""
    stream = io.StringIO(text)
    stream.name = name
    return stream


def test_errors_weigh_the_turning_points_beside_which_they_stand():
    dt, dx = 1e-3 * (1 + COUNT), 1e-2 / (1 + COUNT)
    found = read_table({"n": COUNT, "t": TURNS, "dt": dt, "x": PEAKS, "dx": dx})
    assert found.columns["sigma_t"].tolist() == dt.tolist() and found.columns["sigma_x"].tolist() == dx.tolist()
    assert "errors from 'dx', 'dt'" in found.notes[-1] and "not used" not in found.notes[0]


def test_a_step_is_no_error():
    # Alone dt is the step of the clock; beside a dx, too, where it is what t changes by.
    steps = np.diff(TURNS, prepend=TURNS[0] - 1.0)
    assert "sigma_t" not in read_table(POINTS | {"dt": 0 * TURNS + 0.01}).columns
    found = read_table(POINTS | {"dt": steps, "dx": 0 * TURNS + 0.01})
    assert "sigma_t" not in found.columns and "sigma_x" in found.columns
    # What the size of x falls by is a decrement.
    lost = -np.diff(np.abs(PEAKS), append=0.9 * np.abs(PEAKS[-1]))
    assert "sigma_x" not in read_table(POINTS | {"dx": lost}).columns
    # A place called dx has no x beside it.
    assert read_table({"t": T, "dx": N}).columns["x"].tolist() == N.tolist()


def test_a_force_is_the_motion_only_where_there_is_no_other():
    assert read_table({"t": T, "force (N)": 3 * N}).columns["x"][0] == 3 * N[0]
    assert read_table({"t": T, "force (N)": 3 * N, "ch 1": N}).columns["x"][0] == N[0]
    with pytest.raises(InputError, match=r"read as time: 't'; x: 'x'; more swings in 'force'"):
        load({"t": T, "force": N, "x": 0 * T})


def test_a_tension_or_a_mode_of_another_axis_is_no_other_oscillator():
    mode = 0.5 * np.exp(-T / 25) * np.cos(9.3 * T)
    for other in (0.4 * N**2, mode):
        names = ("ax (m/s^2)", "ay (m/s^2)")
        assert "a: 'ax" in read_table({"t": T, names[0]: N, names[1]: other}).notes[0]
    # The double frequency of a height beside its place, and another oscillator.
    assert "x: 'cm 1" in read_table({"t": T, "cm 1": N, "cm 2": 0.4 * N**2}).notes[0]
    with pytest.raises(InputError, match="x may be any of"):
        read_table({"t": T, "cm 1": N, "cm 2": mode})


@pytest.mark.parametrize(
    ("cells", "steps"),
    [
        (["31/01/2024 23:59:59", "01/02/2024 00:00:01"], 2.0),
        (["01/31/2024 23:59:59", "02/01/2024 00:00:01"], 2.0),
        (["01/02/2024 23:59:59", "02/02/2024 00:00:01"], 2.0),
        (["2/29/2024 11:59:59 PM", "3/1/2024 12:00:01 AM"], 2.0),
        (["23:59:59,5", "00:00:00,5"], 1.0),
        (["11:59:59:500", "12:00:00:500"], 1.0),
    ],
)
def test_dates_are_read_in_the_order_that_fits(cells, steps):
    found = table("time;x\n" + "".join(f"{cell};{k}\n" for k, cell in enumerate(cells)))
    assert np.diff(found.columns["t"]).tolist() == [steps]


@pytest.mark.parametrize("mark", [".", ","])
def test_the_decimal_mark_is_found_where_something_in_the_file_tells_it(mark):
    other = "," if mark == "." else "."
    german = lambda text: text if mark == "." else text.translate(str.maketrans(".,", ",."))  # noqa: E731
    late = T + 1
    # failed before: 1.000 beside 0.020 was a thousand, and the rows before it were left out
    mixed = table(
        "t;x\n"
        + "".join(f"{f'{t:.3f};'.replace('.', mark)}{f'{20 * x:.2f}'.replace('.', other)}\n" for t, x in zip(T, N))
    )
    assert mixed.columns["t"][:2].tolist() == [0.0, 0.04] and "different decimal marks" in "".join(mixed.notes)
    # A whole number of four digits shows that none are grouped.
    whole = table("t;x\n" + "".join(f"{german(f'{t:.3f}')};{5000 + 1000 * x:.0f}\n" for t, x in zip(late, N)))
    assert whole.columns["t"][:2].tolist() == [1.0, 1.04]
    # Times that rise only in groups of thousands, and places that tell nothing.
    grouped = table(
        "t;x\n" + "".join(f"{german(f'{1000 * t:,.0f}')};{german(f'{30_000 + 2e4 * x:,.0f}')}\n" for t, x in zip(T, N))
    )
    assert grouped.columns["t"][:2].tolist() == [0.0, 40.0] and grouped.columns["t"][30] == 1200.0
    # Nothing tells it.
    with pytest.raises(InputError, match="may be 1 or 1000"):
        table("t;x\n" + "".join(f"{german(f'{t:.3f}')};{german(f'{30 + 20 * x:.3f}')}\n" for t, x in zip(late, N)))


def test_hours_and_minutes_or_minutes_and_seconds_are_asked():
    with pytest.raises(InputError):
        table("time,x\n" + "".join(f"12:{k:02d},{k % 3}\n" for k in range(30)))
    # A clock that falls by an hour starts again, and has not passed midnight.
    found = table("time,x\n" + "".join(f"{h}:00:{k:02d},{k % 3}\n" for h in (13, 12) for k in range(50)))
    assert np.diff(found.columns["t"]).min() == -3600 - 49


def test_a_clock_since_1970_has_its_unit_from_its_size_alone_where_it_has_none():
    since = 1_709_290_790_000 + 1000 * T
    found = read_table({"timestamp": since, "x": N})
    assert np.diff(found.columns["t"])[0] == pytest.approx(0.04) and "'timestamp': ms since 1970" in found.notes
    assert np.diff(read_table({"t (s)": since, "x": N}).columns["t"])[0] == pytest.approx(40)
    assert np.diff(read_table({"t": since, "x": N}, unit="us").columns["t"])[0] == pytest.approx(4e-5, rel=1e-3)
    assert np.diff(read_table({"t": 1e3 * T, "x": N}).columns["t"])[0] == pytest.approx(40)


def test_texts_in_the_rows_are_names_and_units_only_where_they_are():
    odd = table("".join(f"run 7, {t:.2f}, {x:.4f}, note {k}\n" for k, (t, x) in enumerate(zip(T, N))))
    assert odd.unit == "" and "time: 't'" in odd.notes[0]
    with pytest.raises(InputError, match="no unit of time"):
        table("".join(f"time: {t:.2f} kg angle: {x:.4f} deg\n" for t, x in zip(T, N)), columns="t=2,x=5")


def test_a_header_of_an_oscilloscope_without_its_step_is_no_clock():
    broken = "X,CH1,Start,Increment,\nSequence,Volt,-12,soon\n" + rows(list(range(600)), N, end=",,")
    with pytest.raises(InputError):
        table(broken)


def test_words_that_are_no_units():
    for name in ("x min", "Height h", "x in", "gain in use"):
        assert read_table({"t": T, name: N}).unit == ""


def test_amplitudes_of_a_lock_in_fall_on_an_even_clock():
    falls = np.exp(-T / 9)
    # Neither one that rises again nor one in metres is an envelope by its name R.
    for name, values in (("R (V)", 1 + 0.5 * np.cos(T)), ("R (m)", falls)):
        assert read_table({"t": T, name: values}).kind == "record"
    assert read_table({"t": T, "R (V)": falls}).kind == "envelope"


def test_turning_points_of_both_sides_are_told_from_few_samples():
    t = np.arange(40) * 1.1  # 1.9 a swing: the signs alternate, and the sizes do not fall
    assert read_table({"t": t, "x": np.exp(-0.01 * t) * np.cos(3 * t)}).kind == "record"
    points = {"t": TURNS, "x": PEAKS}
    assert read_table(points).kind == "turning-points" and read_table(points, kind="record").kind == "record"
    # About a base line one sign is that of amplitudes: it is not guessed.
    with pytest.raises(InputError, match="2.2 a period"):
        load({"t": TURNS, "x": PEAKS + 2})


def test_axes_of_a_sensor_whose_kind_is_said():
    axes = {"t": T, "x": 0.01 * V, "y": 0.3 * V, "z": 0 * T}
    found = read_table(axes, kind="velocity")
    assert found.columns["v"].tolist() == (0.3 * V).tolist()
    assert read_table(axes).kind == "record"
    # What is said knows better than a name; a unit does not lie.
    assert read_table({"t": T, "Acc": N}, kind="record").columns["x"].tolist() == N.tolist()
    with pytest.raises(InputError, match="no column x"):
        read_table({"t": T, "Acc (m/s^2)": N, "Gyro (rad/s)": N}, kind="record")
    # Of two axes in a plane a camera tells the places, whatever the file is called.
    with pytest.raises(InputError, match="x may be any of 'x', 'y'"):
        read_table(named("velocity.csv", "t,x,y\n" + rows(T, N, 0.8 * N)))


def test_json_that_is_no_table(tmp_path, monkeypatch):
    path = tmp_path / "a.json"
    for text in ("{", "[1, 2]", '{"t": [0, 1, 2], "x": [1, 2]}', '"a"', '{"t": ["a", "b"], "x": [true, false]}', "{}"):
        path.write_text(text)
        with pytest.raises(InputError, match="data|FILE"):
            read_table(path)
    path.write_text(json.dumps({"t": [0, 1, 2, 3], "x": [1, None, 0.5, 0.25]}))
    assert np.isnan(read_table(path).columns["x"][1])
    path.write_text(json.dumps({"time": ["23:59:59.5", "00:00:00.5"], "x": [1, 2]}))
    assert np.diff(read_table(path).columns["t"]).tolist() == [1.0]
    monkeypatch.setattr("asymptotics.decays.records.json_columns.MOST_BYTES", 9)
    with pytest.raises(LimitError, match="bytes of JSON"):
        read_table(path)


def test_a_sound_that_is_damaged_is_refused(tmp_path):
    path = tmp_path / "a.wav"
    path.write_bytes(b"RIFF0000WAVE" + bytes(9))
    with pytest.raises(InputError, match="cannot read a.wav"):
        read_table(path)


def test_labels_of_rows_are_no_column():
    frame = pd.DataFrame({"t": T, "x": N})
    assert "not used" not in read_table(frame[frame.t > 1]).notes[0]
    dated = pd.DataFrame({"x": N}, index=pd.to_datetime("2024-03-01") + pd.to_timedelta(T, unit="s"))
    assert np.diff(read_table(dated).columns["t"])[0] == pytest.approx(0.04)
