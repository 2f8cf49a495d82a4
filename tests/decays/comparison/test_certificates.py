"""Certificates of the certified side of a comparison: what stands beside one's own values, in the same units."""

import pytest

import asymptotics as asy
from asymptotics.errors import InputError
from tests.worlds import OSCILLATOR


def claims_of(found):
    return [claim for each in found.certificate().content for claim in each["claims"]]


def right(found, column):
    return [row.certified for row in found.rows if row.column == column]


def test_turning_points_without_units():
    found = asy.compare({"n": [0, 1, 2], "x": [1, -0.4, 0.2], "tau": [0, 3.3, 6.5]}, {2: 1}, digits=9)
    claims = claims_of(found)
    assert [c["x"] for c in claims] == right(found, "x") and [c["t"] for c in claims] == right(found, "tau")


def test_turning_points_in_units_have_no_tau_and_amplitudes_are_places():
    osc = asy.Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="-1/5")
    found = asy.compare({"n": [1, 2], "amplitude": [0.2, 0.2], "t": [0.7, 1.4], "tau": [3, 6]}, osc, digits=9)
    claims = claims_of(found)
    first, second = right(found, "amplitude")
    assert [c["x"] for c in claims] == [first, f"-{second}"] and [c["t"] for c in claims] == right(found, "t")
    assert "tau" in found.certificate().left[0]


def test_a_motion_at_times():
    osc = OSCILLATOR
    found = asy.compare({"t": ["0.5", "1/3"], "x": [0.1, 0.1], "v": [0.1, 0.2]}, osc, digits=9)
    claims = claims_of(found)
    assert [(c["t"], c["x"], c["v"]) for c in claims] == list(zip(["1/2", "1/3"], right(found, "x"), right(found, "v")))
    bare = asy.compare({"tau": ["1/2", 3], "x": [0.1, 0.1]}, {"3/2": "1/10"}, digits=9)
    assert [(c["t"], c["x"], c["v"]) for c in claims_of(bare)] == [
        (t, x, None) for t, x in zip(["1/2", "3"], right(bare, "x"))
    ]


def test_what_is_beyond_the_end_is_not_claimed():
    found = asy.compare({"n": [1, 2, 9], "x": [-0.7, 0.4, 0.1]}, {0: "3/20"}, digits=9)
    assert [c["number"] for c in claims_of(found)] == [1, 2]


def test_a_table_and_an_exported_file_have_that_of_the_result_beside_them(tmp_path):
    table = asy.table("smith2012.table1", digits=6)
    (tmp_path / "mine.csv").write_text(table.to_csv_file())
    found = asy.compare(tmp_path / "mine.csv")
    assert {c["number"]: c["x"] for c in claims_of(found)}.items() >= dict(enumerate(right(found, "u"))).items()


@pytest.mark.parametrize(
    ("columns", "law", "reason"),
    [
        ({"tau": [1, 2], "amplitude": [1, 0.9]}, {2: "1/10"}, "averaged law"),
        ({"n": [1], "x": [-0.8]}, {"sqrt(2)": "1/10"}, "exponent sqrt"),
    ],
)
def test_what_has_none_is_refused_by_name(columns, law, reason):
    with pytest.raises(InputError, match=reason):
        asy.compare(columns, law, digits=9).certificate()


def test_a_comparison_with_other_numbers_has_none():
    series = asy.compare({"alpha": [1], "M_(alpha+1)": [0.5]}, table="moments", alpha=1)
    with pytest.raises(InputError, match="neither turning points nor times"):
        series.certificate()


@pytest.mark.parametrize(("x0", "v0"), [("1", "1/3"), ("-1/2", "-2"), ("0", "1")])
def test_turning_points_of_a_start_in_motion_are_those_of_that_start(x0, v0):
    """They were once those of a start at rest, called certified: the certificate found it out."""
    osc = asy.Oscillator({2: "1/10"}, x0=x0, v0=v0, mass=2)
    found = asy.compare({"n": [0, 1, 2], "x": [1, -0.8, 0.7], "t": [0, 3, 6]}, osc, digits=10)
    points = asy.turning_points(osc, 3, digits=10, times=True).points
    assert (right(found, "x"), right(found, "t")) == ([p.x for p in points], [p.t for p in points])
    assert [c["x"] for c in claims_of(found)] == right(found, "x")


def test_a_start_in_motion_that_never_turns_has_no_such_value():
    found = asy.compare({"n": [0], "x": [1]}, asy.Oscillator({1: 3}, v0="-1/10"), digits=10)
    assert [row.certified for row in found.rows] == [None] and "overdamped" in found.summary["ended"]
    with pytest.raises(InputError, match="no value"):
        found.certificate()
