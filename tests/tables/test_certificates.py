"""Certificates of tables: every row that is a turning point or a time is claimed as it is printed, or told as left."""

import json
import subprocess
import sys

import pytest

import asymptotics as asy
from asymptotics.certificates.certificate import CHECKER
from asymptotics.errors import InputError
from asymptotics.tables.registry import build, names

CERTIFIED = ("half-periods", "smith2012.table1", "stops", "turning-points")


def claims_of(certificate):
    return [claim for each in certificate.content for claim in each["claims"]]


@pytest.mark.parametrize("name", [n for n in names() if n not in CERTIFIED])
def test_a_table_of_other_numbers_has_none(name):
    with pytest.raises(InputError, match="neither turning points nor times"):
        build(name, 5).certificate()


def test_rows_of_turning_points_are_claimed_as_printed():
    table = asy.table("turning-points", alpha=["1", "3/2"], epsilon=["1/10", "1/3"], rows=3, digits=9)
    made = table.certificate()
    assert len(made.content) == 4 and made.left == ()
    rows = [(int(n), x, tau) for _, n, x, tau, *_ in table.rows]
    assert [(c["number"], c["x"], c["t"]) for c in claims_of(made)] == rows


def test_the_stop_is_claimed_too():
    made = asy.table("turning-points", law={0: "1/20", "3/2": "1/10"}, rows=20, digits=6).certificate()
    assert made.proved[-1] == "turning point 7: it stays"


def test_half_periods_are_times_of_turning_point_1_and_laws_without_certificate_are_told():
    table = asy.table("half-periods", alpha=["0", "2", "sqrt(2)", "1/2"], epsilon=["1/2", "1"], digits=9)
    made = table.certificate()
    printed = {law: (ratio, T) for law, ratio, T, *_ in table.rows if ratio}
    laws = [",".join(f"{a}:{e}" for a, e in each["law"]) for each in made.content]
    assert laws == ["0:1/2", "2:1/2", "2:1", "1/2:1/2"]
    for law, claim in zip(laws, claims_of(made), strict=True):
        assert claim["t"] == printed[law][1]
        assert claim["x"] == (None if law == "0:1/2" else f"-{printed[law][0]}")
    assert [line.partition(":")[0] for line in made.left] == ["0", "sqrt(2)", "sqrt(2)"]


def test_smith_s_table_from_any_start():
    table = asy.table("smith2012.table1", epsilon=["1/2", "3"], rows=4, digits=9)
    made = table.certificate()
    assert [each["start"] for each in made.content] == [["1/2", "0"], ["3", "0"]]
    assert [claim["x"] for claim in claims_of(made)] == [row[-1] for row in table.rows]
    assert "S_hat" in made.left[-1]


def test_stops_are_claimed_with_their_times():
    table = asy.table("stops", epsilon=["3/20", "3/10"], digits=9)
    turned = [c for c in claims_of(table.certificate()) if c["kind"] == "turning point"]
    assert [(str(c["number"]), c["x"], c["t"]) for c in turned] == [row[1:] for row in table.rows]


def test_other_roundings_and_nothing_but_what_is_left_are_refused():
    with pytest.raises(InputError, match="rounded to the nearest"):
        asy.table("stops", epsilon="3/20", digits=9, rounding="up").certificate()
    with pytest.raises(InputError, match=r"exponent sqrt\(2\)"):
        asy.table("half-periods", alpha="sqrt(2)", epsilon="1/2", digits=5).certificate()


def test_the_file_of_a_table_is_accepted_by_the_page_beside_it_and_a_wrong_row_is_not(tmp_path):
    path = tmp_path / "table.json"
    asy.table("half-periods", alpha=["1", "2"], epsilon="1/2", digits=9).certificate().save(path)
    assert (tmp_path / CHECKER.name).read_text() == CHECKER.read_text()
    ran = [sys.executable, "-I", "-S", CHECKER.name, path.name]
    assert subprocess.run(ran, capture_output=True, text=True, cwd=tmp_path).stdout.startswith("accepted\nx'' + 1 x")
    content = json.loads(path.read_text())
    content[1]["claims"][0]["t"] = content[0]["claims"][0]["t"]
    path.write_text(json.dumps(content))
    assert subprocess.run(ran, capture_output=True, text=True, cwd=tmp_path).stdout.startswith("refused: t = ")


@pytest.mark.parametrize("law", [asy.Law({(1, 2): "1/10"}), asy.Law({2: "1/10"}, spring={3: "1/10"})])
def test_a_law_beside_which_motions_may_part_is_named_whole_and_has_none(law):
    """Its label once left out the place, so that x^2 x' was taken for x'."""
    table = asy.table("turning-points", law=law, rows=2, digits=6)
    assert table.rows[0][0] in ("1,2:1/10", "2:1/10,spring x^3:1/10")
    with pytest.raises(InputError, match="motions may part"):
        table.certificate()


def test_a_table_of_such_a_law_is_compared_by_its_own_head(tmp_path):
    table = asy.table("turning-points", law={(1, 2): "1/10"}, rows=2, digits=6)
    (tmp_path / "mine.csv").write_text(table.to_csv_file())
    assert asy.compare(tmp_path / "mine.csv").summary["all_right"] == 4
