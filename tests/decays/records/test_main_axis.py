"""Three axes of one sensor: the one that swings is taken and said; two that share the swing are asked for."""

import numpy as np
import pytest

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


def test_columns_overrule():
    table = read_table(phone(0.1, 1.0, 0.05), how=How(columns="t=1,v=2"))
    assert np.abs(table.columns["v"]).max() < 0.3


def test_axes_that_share_the_swing_are_asked_for():
    with pytest.raises(InputError, match="v may be any of 'Gyroscope x"):
        read_table(phone(0.7, 1.0, 0.0))
    # What has no line at all carries none, either.
    with pytest.raises(InputError, match="v may be any of"):
        read_table(phone(0.0, 0.0, 0.0))


def test_quantities_of_other_units_are_not_compared():
    with pytest.raises(InputError, match="x may be any of"):
        read_table({"t": T, "angle (deg)": SWING, "place (cm)": 0.01 * SWING})


def test_columns_of_uncertainties_are_not_asked_about():
    names = {"t (seconds)": T, "angle (degrees)": SWING, "uncertainty t (of 60 fps)": 0 * T + 0.008}
    table = read_table(names | {"uncertainty angle (tracker)": 0 * T + 0.1})
    assert table.kind == "record" and "2 other columns not used: 'uncertainty t" in table.notes[0]
