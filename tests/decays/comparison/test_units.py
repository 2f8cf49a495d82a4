"""Columns in cm, mm and ms, and under the names that other readers know, beside certified values in SI."""

import pytest

import asymptotics as asy
from asymptotics.errors import InputError

SPRING = asy.Oscillator({1: "1/10"}, mass=1, stiffness=4, x0="1/20")
T, X = ["0", "0.5", "1"], ["0.0500000", "0.0272801", "-0.0188853"]
CM, MS = ["5.00000", "2.72801", "-1.88853"], ["0", "500", "1000"]


def digits(found):
    return [row.digits for row in found.rows]


@pytest.mark.parametrize(
    ("named", "columns"),
    [
        ({"t": T, "x [cm]": CM}, None), ({"t (s)": T, "x (cm)": CM}, None), ({"t_ms": MS, "x_cm": CM}, None),
        ({"t": T, "x": CM}, "t,x (cm)"), ({"t (s)": T, "x (cm)": CM}, "t (s),x (cm)"),
        ({"Time (ms)": MS, "Position (cm)": CM}, None), ({"t (s)": T, "pos (cm)": CM}, "t=t (s),x=pos (cm)"),
    ],
)  # fmt: skip
def test_units_and_names_are_heard_as_by_every_reader(named, columns):
    """Failed before: x is in 'cm' (accepted: x [m]); 'x (cm)' is no quantity that can be compared."""
    right = asy.compare({"t": T, "x": X}, SPRING)
    found = asy.compare(named, SPRING, columns=columns)
    assert digits(found) == digits(right) and [row.certified for row in found.rows] == [r.certified for r in right.rows]
    assert "x in cm" in found.summary["converted"]
    assert "converted" not in right.summary
    # Near miss: the same numbers as metres.
    assert max(map(float, digits(asy.compare({"t": T, "x": CM}, SPRING)))) < 1


def test_what_is_no_power_of_ten_is_refused_and_so_is_a_contradiction():
    with pytest.raises(InputError, match=r"x is in 'in' .*power of ten"):
        asy.compare({"t": T, "x (in)": X}, SPRING)
    with pytest.raises(InputError, match="x in m contradicts the header"):
        asy.compare({"t": T, "x (cm)": CM}, SPRING, columns="t,x (m)")
    with pytest.raises(InputError, match="x is in 'cm'"):
        asy.compare({"t": T, "x (cm)": CM}, {1: "1/10"})  # without units nothing has one
