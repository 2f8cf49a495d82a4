"""Ranges and grids: what is none, what is too large, and a million points."""

import pytest
from tasks import sweep

from asymptotics.errors import InputError
from asymptotics.sweeps import Grid, values


@pytest.mark.parametrize("text", ["1:2", "1:2:0", "2:1:1/2", "1:2:3/10", "a", "", "1,,2", "1:2:1:1", "0:1:nan", "1_0"])
def test_what_is_no_range_is_refused(text):
    with pytest.raises(InputError, match="--alpha"):
        values(text, "--alpha")


def test_a_grid_of_10_to_the_12_is_refused_with_its_cost():
    axis = values("1:1000:1", "--a")
    with pytest.raises(InputError, match=r"10\^12 points would take about 1.2e\+04 days"):
        Grid(dict.fromkeys("abcd", axis))
    with pytest.raises(InputError, match="points would take"):
        values("0:1:1e-12", "--alpha")


def test_a_million_points_need_no_million_files_and_little_memory(tmp_path):
    points = Grid({"alpha": values("1:100:1", "a"), "epsilon": values("1:100:1", "e")})
    result = sweep(lambda point: {"x": point["alpha"]}, "square", points, tmp_path, workers=1)
    assert result.computed == 10_000
    assert len(list((tmp_path / "shards").iterdir())) <= 256
    assert float(result.seconds) < 2e-3 * 10_000  # the overhead of a point, here with nothing to compute
