"""Of several columns the one that swings is taken and said; where two share the swing, it is asked."""

import numpy as np
import pytest

from asymptotics.decays.identification.sources import load
from asymptotics.decays.records.sources import How
from asymptotics.decays.records.table import read_table
from asymptotics.errors import InputError

T = np.arange(0, 30, 0.02)
SWING = np.exp(-0.03 * T) * np.cos(4 * T)
NAMES = [f"Gyroscope {axis} (rad/s)" for axis in "xyz"]


def phone(*shares):
    """A phone's file: a share of the swing on each axis, noise, and a bias."""
    random = np.random.default_rng(0)
    axes = [s * SWING + 0.01 * random.standard_normal(len(T)) + 0.05 for s in shares]
    return {"Time (s)": T, **dict(zip(NAMES, axes))}


def test_the_axis_that_swings_is_taken_and_said():
    table = read_table(phone(0.1, 1.0, 0.05))
    assert table.kind == "velocity" and np.abs(table.columns["v"]).max() > 0.9
    assert "v: 'Gyroscope y (rad/s)'" in table.notes[0] and "carries the oscillation" in table.notes[0]


def test_what_is_made_of_the_axes_is_none():
    data = phone(0.1, 1.0, 0.05)
    size = np.sqrt(sum(data[name] ** 2 for name in NAMES))
    assert "v: 'Gyroscope y (rad/s)'" in read_table(data | {"Absolute (rad/s)": size}).notes[0]


def test_columns_overrule():
    table = read_table(phone(0.1, 1.0, 0.05), how=How(columns="t=1,v=2"))
    assert np.abs(table.columns["v"]).max() < 0.3


def test_axes_that_share_the_swing_are_asked_for():
    with pytest.raises(InputError, match="v may be any of 'Gyroscope x"):
        read_table(phone(0.7, 1.0, 0.0))
    # What has no line at all carries none, either.
    with pytest.raises(InputError, match="v may be any of"):
        read_table(phone(0.0, 0.0, 0.0))


@pytest.mark.parametrize("rows", [40, len(T)])
def test_the_place_that_swings_is_taken_whatever_its_letter(rows):
    # failed before: x was taken in silence, for its name
    noise = 0.01 * np.random.default_rng(1).standard_normal(len(T))
    data = {"t": T[::8][:rows], "x": noise[::8][:rows], "y": SWING[::8][:rows]}
    assert "x: 'y'; 1 other column not used: 'x'" in read_table(data).notes[0]
    with pytest.raises(InputError, match="x may be any of 'x', 'y'"):
        read_table(data | {"x": 0.6 * data["y"]})


def test_of_an_angle_and_a_place_of_one_swing_the_angle_is_taken():
    place = {"t": T, "angle (deg)": SWING, "x (cm)": 30 * np.sin(SWING), "y (cm)": 30 * (1 - np.cos(SWING))}
    table = read_table(place)
    assert table.unit == "deg" and "x: 'angle (deg)'; 2 other columns" in table.notes[0]
    # Near miss: the place swings at a frequency of its own.
    with pytest.raises(InputError, match="x may be any of"):
        read_table({"t": T, "angle (deg)": SWING, "x (cm)": np.exp(-0.03 * T) * np.cos(5 * T)})
    # Only one of two quantities swings at all.
    noise = np.random.default_rng(2).standard_normal(len(T))
    assert read_table({"t": T, "angle (deg)": noise, "x (cm)": SWING}).unit == "cm"


def test_of_a_gyroscope_and_an_accelerometer_no_axis_is_a_place():
    # failed before: gx said nothing, and was taken for the position
    names = ("gx", "gy", "gz", "ax", "ay", "az")
    table = read_table({"t": T, **{name: SWING * (1 if name[1] == "y" else 0.05) for name in names}})
    assert table.kind == "velocity" and "v: 'gy'" in table.notes[0]
    table = read_table({"millis": 1000 * T, "accX": 0.1 * SWING, "accY": SWING})
    assert table.kind == "acceleration" and table.columns["t"][1] == 0.02


def test_the_angle_of_a_tracker_is_taken_beside_its_place():
    data = {
        "t": T,
        "x": np.sin(0.3 * SWING),
        "y": 1 - np.cos(0.3 * SWING),
        "\N{GREEK SMALL LETTER THETA}r": 0.3 * SWING,
    }
    assert "x: '\N{GREEK SMALL LETTER THETA}r'" in read_table(data).notes[0]


def test_a_column_that_never_changes_or_stands_twice_needs_no_question():
    assert read_table({"t": T, "Kanal 1": 0 * T, "Kanal 2": SWING}).columns["x"][0] == 1.0
    assert read_table({"t": T, "Acc 1": SWING, "Acc 2": SWING}).kind == "acceleration"
    assert read_table({"t": T, "angle (deg)": np.degrees(SWING), "angle (rad)": SWING}).unit == "deg"


def test_of_clocks_that_tell_one_time_the_finest_is_taken():
    table = read_table({"Time (s)": np.floor(T), "Elapsed time": T, "x": SWING})
    assert table.columns["t"][1] == 0.02
    # Nanoseconds since 1970 beside seconds, of which one says so.
    stamps = {"time": 1.7e18 + 1e9 * T, "seconds_elapsed": T, "x": SWING}
    assert read_table(stamps).columns["t"][1] == 0.02
    with pytest.raises(InputError, match="t may be any of 'time', 'clock'"):
        read_table({"time": 1.7e18 + 1e9 * T, "clock": T, "x": SWING})
    with pytest.raises(InputError, match="t may be any of"):
        read_table({"time": T, "clock": np.random.default_rng(0).random(len(T)), "x": SWING})


def two(share, late=0.02):
    return {"Time A [s]": T, "Pos A [au]": SWING, "Time B [s]": T + late, "Pos B [au]": share * SWING}


def test_of_two_oscillators_the_one_that_swings_is_taken_with_its_own_time():
    # failed before: "Pos A" was an acceleration, for its last letter, and the other one was taken in silence
    for data, t0 in ((two(0.05), 0.0), ({k: two(0.05)[k] for k in [*two(0)][2:] + [*two(0)][:2]}, 0.0)):
        table = read_table(data)
        assert table.columns["t"][0] == t0 and table.columns["x"][0] == 1.0 and "'Pos A [au]'" in table.notes[0]
    with pytest.raises(InputError, match=r"have a time each .*--columns t=1,x=2; or --columns t=3,x=4"):
        read_table(two(0.8))
    assert read_table(two(0.8), how=How(columns="t=3,x=4")).columns["t"][0] == 0.02


def test_a_refusal_names_the_columns_and_those_that_swing_more():
    data = {"t": T, "x": 0 * T, "Motor": SWING}
    with pytest.raises(InputError, match=r"read as time: 't'; x: 'x'; more swings in 'Motor'"):
        load(data)
    with pytest.raises(InputError) as refused:
        load({"t": T, "x": 0 * T})
    assert "read as" not in str(refused.value)


def test_columns_of_uncertainties_are_not_asked_about():
    names = {"t (seconds)": T, "angle (degrees)": SWING, "uncertainty t (of 60 fps)": 0 * T + 0.008}
    table = read_table(names | {"uncertainty angle (tracker)": 0 * T + 0.1})
    assert table.kind == "record" and table.notes[-1].startswith("errors not used: 'uncertainty t (of 60 fps)', 'unc")
