"""Values given as arrays and data frames are compared as those of a file are, and refused as plainly."""

import numpy as np
import pandas as pd
import pytest

import asymptotics as asy
from asymptotics.decays.comparison.run import Comparison
from tests.worlds import OSCILLATOR

N, X = [0, 1, 2, 3], [1.0, -0.4107197, 0.2635711, -0.194566]


def told(found: Comparison) -> list[tuple[str, ...]]:
    return [(row.key, row.column, row.marked, str(row.certified), row.digits) for row in found.rows]


def test_arrays_frames_and_files_say_the_same(tmp_path):
    file = tmp_path / "mine.csv"
    file.write_text("n,x\n" + "".join(f"{n},{x!r}\n" for n, x in zip(N, X)))
    wanted = told(asy.compare(file, {2: 1}))
    frame = pd.DataFrame({"n": N, "x": X})
    for given in (
        {"n": N, "x": X},
        {"n": np.array(N), "x": np.array(X)},
        {"n": np.array(N, float), "x": [str(x) for x in X]},
        frame,
        frame.astype(float),
    ):
        assert told(asy.compare(given, {2: 1})) == wanted
    assert wanted[2][2] == "0.26357[11]"
    other = told(asy.compare(frame.assign(x=[1.0, -0.42, 0.26, -0.19]), {2: 1}))
    assert other != wanted and "[" in other[1][2]


def test_names_of_columns_and_units():
    osc = OSCILLATOR
    motion = asy.motion(osc, order=3).sample([0.5, 1.0, 1.5])
    found = asy.compare({"time": motion.t, "pos": motion.x}, osc, columns="t=time,x=pos")
    assert found.rows[0].key_name == "t" and float(found.summary["worst_digits"]) > 5
    assert asy.compare(motion.to_dataframe()[["t [s]", "x [m]"]], osc).summary == found.summary


def test_what_is_smaller_than_a_double_is_judged_as_well():
    """Our own turning points at half-swing 30000, 10^-6919: right as they are written, and one digit off is seen."""
    law = asy.Law({1: "1/3"})
    points = [p.x for p in asy.turning_points(law, 2, digits=12, start=30_000).points]
    found = asy.compare({"n": [30_000, 30_001], "x": points}, law)
    assert points[0] == "2.23417402101e-6919" and [row.marked for row in found.rows] == points
    assert found.summary["look"]["reason"].endswith("less than a double holds")
    found = asy.compare({"n": [30_000], "x": ["2.23417402102e-6919"]}, law)
    assert found.rows[0].marked == "2.2341740210[2]e-6919"


def test_a_table_by_its_name():
    given = {"half_cycle": [2, 4], "S_hat": ["0.098765", "0.133834"], "u": ["-0.41072", "-0.194566"]}
    found = asy.compare(given, table="smith2012.table1")
    assert [row.marked for row in found.rows] == ["0.098765", "-0.41072", "0.13383[4]", "-0.194566"]
    half = asy.compare({"half_cycle": [2], "u": ["-0.26"]}, table="smith2012.table1", epsilon="1/2")
    assert half.rows[0].certified != found.rows[1].certified


@pytest.mark.parametrize(
    ("given", "asked", "said"),
    [
        ({"n": [1, 2], "x": [1]}, {}, "differ in length"),
        ({}, {}, "no column"),
        ({"n": 3, "x": 4}, {}, "argument n: a int is no column"),
        ({"n": [0, 1], "x": [1, float("nan")]}, {}, "argument row 2"),
        ({"n": [0, 1.5], "x": [1, 2]}, {}, "argument row 2"),
        ({"n": [0, 1], "x": [1, object()]}, {}, "argument row"),
        ([1, 2], {}, "argument file: a list"),
        ({"n": [0, 1], "x": [1, 2]}, {"alpha": 2}, "argument alpha: there is no table"),
        ({"n": [0, 1], "x": [1, 2]}, {"table": "zzz"}, "no table 'zzz'"),
        ({"n": [0, 1], "x": [1, 2]}, {"table": 3}, "argument table"),
    ],
)
def test_what_is_wrong_is_named(given, asked, said):
    with pytest.raises(asy.InputError, match=said):
        asy.compare(given, None if "table" in asked else {2: 1}, **asked)
