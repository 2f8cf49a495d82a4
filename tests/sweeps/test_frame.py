"""A sweep in a data frame and a picture: the numbers of the store, in the order of the sweep."""

import math
import sys
from functools import partial

import pytest

import asymptotics as asy
from asymptotics.ask.axes import run_point
from asymptotics.sweeps import Grid, values


@pytest.fixture(scope="module")
def swept(tmp_path_factory):
    grid = Grid({"p": values("0:2:1/2", "p"), "digits": ("6", "12")})
    return asy.sweep(partial(run_point, "moment"), "moment", grid, tmp_path_factory.mktemp("s") / "store", workers=1)


def test_results_are_columns_of_numbers(swept):
    table = swept.to_dataframe()
    assert len(table) == 10 and table["p"].tolist()[2] == 0.5 and table["digits"].tolist()[:2] == [6.0, 12.0]
    truth = [math.gamma((p + 1) / 2) / (math.sqrt(math.pi) * math.gamma(p / 2 + 1)) for p in table["p"]]
    assert table["value"].tolist() == pytest.approx(truth, abs=1e-6) and table["value_digits"][9] == "0.500000000000"
    assert set(table["failed"]) == {""} and table["exact"][2].startswith("gamma(3/4)")
    again = asy.sweep(partial(run_point, "moment"), "moment", swept.grid, swept.store, workers=1)
    assert again.reused == 10 and again.to_dataframe().equals(table)


def test_the_picture_is_a_line_for_each_value_of_the_other_parameters(swept):
    axes = swept.plot()
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("p", "value")
    assert [line.get_label() for line in axes.lines] == ["digits = 6", "digits = 12"]
    assert axes.lines[0].get_xdata().tolist() == [0, 0.5, 1, 1.5, 2] and "moment at 10 points" in axes.get_title()
    sys.modules["matplotlib.pyplot"].close(axes.figure)
    assert "<img" in swept._repr_html_() and "grid" not in swept.to_dict()
    with pytest.raises(asy.InputError, match="argument y: there is no column of numbers 'exact'"):
        swept.picture(y="exact")


def test_truth_values_have_no_digits_beside_them(tmp_path):
    found = asy.sweep(lambda point: {"right": point["n"] == "1", "root": "sqrt(2)"}, "task", Grid({"n": ("1", "2")}),
                      tmp_path / "store", workers=1).to_dataframe()  # fmt: skip
    assert found["right"].tolist() == [True, False] and "right_digits" not in found
    assert found["root_digits"].tolist() == ["sqrt(2)"] * 2
