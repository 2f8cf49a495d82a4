"""Rows that are missing, doubled or shuffled are counted and told."""

from fractions import Fraction

import pytest

import asymptotics as asy
from asymptotics.decays.comparison.order import order_of, told_order

CASES = [
    ([0, 1, 2, 3], True, (0, 0, 0)),
    ([0, 1, 3, 6], True, (3, 0, 0)),
    ([0, 1, 1, 2], True, (0, 1, 0)),
    ([2, 0, 1, 3], True, (0, 0, 1)),
    (["0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1.2"], False, (2, 0, 0)),
    (["0", "0.1", "0.25", "0.3", "0.9"], False, (0, 0, 0)),  # times without a step miss nothing
]


@pytest.mark.parametrize(("keys", "counted", "wanted"), CASES, ids=str)
def test_rows_are_counted(keys, counted, wanted):
    found = order_of([Fraction(k) for k in keys], counted=counted)
    assert tuple(found.values()) == wanted


def test_a_comparison_says_so_and_a_whole_file_says_nothing(tmp_path):
    points = asy.turning_points({2: "1/10"}, 8, digits=12).points
    rows = {p.n: f"{p.n},{p.x}" for p in points}
    path = tmp_path / "mine.csv"
    path.write_text("n,x\n" + "\n".join(rows[n] for n in (0, 1, 2, 5, 4, 7)) + "\n")
    found = asy.compare(path, {2: "1/10"})
    assert found.summary["order"] == {"missing": 2, "doubled": 0, "shuffled": 1}
    assert "2 rows missing, 1 row out of order" in found._repr_html_()
    path.write_text("n,x\n" + "\n".join(rows.values()) + "\n")
    assert told_order(asy.compare(path, {2: "1/10"}).summary["order"]) == ""
