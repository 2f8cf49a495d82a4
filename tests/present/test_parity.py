"""The same table from Python and from the shell, and files that pandas reads."""

import json

import pandas as pd
import pytest

import asymptotics as asy
from asymptotics.shell.main import main

TABLES = {
    "turning-points --law 0:1/20 --law 3/2:1/10 --rows 3": {"law": {0: "1/20", "3/2": "1/10"}, "rows": 3},
    "moments --alpha 1/2,2 --rounding interval": {"alpha": ["1/2", 2], "rounding": "interval"},
    "smith2012.table1 --epsilon 1/2 --rows 4": {"epsilon": "1/2", "rows": 4},
}


@pytest.mark.parametrize("line", TABLES)
def test_a_table_is_the_same_from_both(line, capsys):
    assert main(["table", *line.split(), "--digits", "9", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    made = asy.table(line.split()[0], digits=9, **TABLES[line])
    assert found["rows"] == [list(row) for row in made.rows] and found["columns"] == list(made.columns)
    assert made.provenance["inputs"] == found["provenance"]["inputs"]


def test_pandas_reads_a_file_with_its_provenance(tmp_path):
    target = tmp_path / "moments.csv"
    assert main(["table", "moments", "--alpha", "1/2,2", "--digits", "9", "--csv", str(target)]) == 0
    assert target.read_text().startswith("# ") and 'pandas.read_csv(FILE, comment="#")' in target.read_text()
    read = pd.read_csv(target, comment="#")
    made = asy.table("moments", alpha=["1/2", 2], digits=9).to_dataframe()
    assert list(read.columns) == list(asy.table("moments", digits=2).columns)
    assert read["M_(alpha+1)"].tolist() == made["M_(alpha+1)"].tolist()


def test_intervals_are_two_columns_in_files_and_frames(tmp_path):
    made = asy.table("moments", alpha=2, rounding="interval", digits=5)
    head, row = made.to_csv().splitlines()
    assert head.split(",")[1:3] == ["M_(alpha+1)_low", "M_(alpha+1)_high"] and row.split(",")[1:3] == [
        "0.42441",
        "0.42442",
    ]
    table = made.to_dataframe()
    assert (table["M_(alpha+1)_low"][0], table["M_(alpha+1)_high"][0]) == (0.42441, 0.42442)


@pytest.mark.parametrize("bad", [{"rounding": "upward"}, {"rounding": 3}, {"alpha": "x"}, {"law": 3}, {"rows": 0}])
def test_bad_requests_are_refused_by_name(bad):
    with pytest.raises(asy.InputError, match=next(iter(bad))):
        asy.table("turning-points", **bad)


def test_the_rates_without_strengths_take_them_as_an_argument():
    general, known = asy.expand([1, 2], order=2).lambdify(), asy.expand({1: "1/10", 2: "1/20"}, order=2).lambdify()
    assert general(0.5, 0.0, ["1/10", "1/20"]) == known(0.5)
    with pytest.raises(asy.InputError, match="epsilon"):
        general(0.5)
    with pytest.raises(asy.InputError, match="epsilon"):
        asy.expand(2, order=2)(0.5)
