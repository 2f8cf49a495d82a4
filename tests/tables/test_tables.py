import csv
import io

import pytest

from asymptotics.errors import InputError
from asymptotics.tables import build, names

# Table I as printed (six digits).  The paper's last digits of S_3 and S_5 differ: 0.133834, 0.141589.
TABLE_1 = [("0", "1.00000"), ("0.0987650", "-0.410720"), ("0.123863", "0.263568"), ("0.133833", "-0.194566"),
           ("0.138780", "0.154318"), ("0.141588", "-0.127908")]  # fmt: skip


def test_table_1_to_six_digits():
    assert [row[1:] for row in build("smith2012.table1", 6).rows] == TABLE_1


def test_more_digits_extend_the_fewer():
    few, many = build("smith2012.table1", 8), build("smith2012.table1", 300)
    for a, b in zip(few.rows[1:], many.rows[1:]):
        assert all(abs(float(x) - float(y)) < 1e-8 for x, y in zip(a, b))
        assert len(b[1]) >= 300


def test_all_tables_have_provenance_and_every_format():
    for name in names():
        table = build(name, 5)
        assert table.provenance
        assert all(len(row) == len(table.columns) for row in table.rows)
        assert list(csv.reader(io.StringIO(table.to_csv())))[1:] == [list(row) for row in table.rows]
        assert table.to_latex().count(r"\\") == len(table.rows) + 1
        assert table._repr_latex_().startswith("$")
        assert table.to_dict()["table"] == name


@pytest.mark.parametrize(("name", "digits"), [("nope", 5), ("smith2012.table1", 0), ("smith2012.table1", 10_001)])
def test_bad_requests_are_refused(name, digits):
    with pytest.raises(InputError):
        build(name, digits)
