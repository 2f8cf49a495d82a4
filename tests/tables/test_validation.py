"""mpmath recomputes the reference tables, and a digit that is not its own is named."""

from dataclasses import replace

import pytest

from asymptotics.errors import InputError
from asymptotics.law import Law
from asymptotics.shell.main import main
from asymptotics.tables.inputs import Inputs
from asymptotics.tables.registry import build, names
from asymptotics.tables.standard_set import validated, with_validation
from asymptotics.tables.validation import ROUTES

REFERENCE = ("smith2012.table1", "two-law-times")


def altered(table, place):
    """The table with the last digit of a number of its last row changed."""
    row = list(table.rows[-1])
    row[place] = row[place][:-1] + str((int(row[place][-1]) + 1) % 10)
    return replace(table, rows=(*table.rows[:-1], tuple(row)))


@pytest.mark.parametrize("name", ROUTES)
def test_every_digit_is_that_of_mpmath_and_another_is_noticed(name):
    table = build(name, digits=40)
    found = table.validate()
    numbers = [i for i, column in enumerate(table.columns) if column not in table.keys]
    assert found.equal and found.values == len(table.rows) * len(numbers)
    assert str(found) == f"recomputed by mpmath {found.version} to 60 digits: equal"
    for place in numbers:
        wrong = altered(table, place).validate()
        assert not wrong.equal and f"1 of {wrong.values} differ: row {len(table.rows)}, " in str(wrong)
        assert table.columns[place] in str(wrong)


def test_the_named_references_are_recomputed():
    assert set(REFERENCE) <= set(ROUTES)
    found = build("smith2012.table1", 70, Inputs.of(rows=40, epsilons=["1", "1/7"])).validate()
    assert found.equal and found.digits == 70 and found.values == 160


@pytest.mark.parametrize("law", [{"3/2": 1, 2: 1}, {2: "1/3", 3: 2}, {1: 1, "5/2": 1}, {"1/3": 1, 1: 2}, {3: 1, 2: 1}])
def test_a_pair_of_laws_where_the_third_parameter_is_a_pole_too(law):
    assert build("two-law-times", 30, Inputs(law=Law(law))).validate().equal


@pytest.mark.parametrize("rounding", ["interval", "down", "up"])
def test_other_roundings(rounding):
    table = build("moments", 12, rounding=rounding)
    assert table.validate().equal
    assert not replace(table, rows=(("2", *table.rows[0][1:]),)).validate().equal


def test_json_and_what_has_no_route():
    data = build("phase-lags", 5).validate(20).to_dict()
    assert data["by"].startswith("mpmath ") and data["digits"] == 20 and data["equal"] is True
    first = data["values"][0]
    assert (first["row"], first["column"], first["ours"]) == (1, "lag", "0.11834")
    assert first["mpmath"].startswith("0.11833887925798851570") or first["mpmath"].startswith("0.1183388792579885157")
    with pytest.raises(InputError, match="digits"):
        build("phase-lags", 5).validate(0)
    with pytest.raises(InputError, match="not recomputed by mpmath alone"):
        replace(build("moments", 5), name="stokes.constants").validate()


def test_the_shell_prints_the_numbers_of_mpmath_beside_ours(capsys):
    assert main(["table", "smith2012.table1", "--digits", "9", "--validate"]) == 0
    lines = capsys.readouterr().out.splitlines()
    (row,) = (line.split() for line in lines if line.startswith("4    S_hat"))
    assert row[2] == "0.133833083" and row[3].startswith("0.13383308270665") and len(row[3]) == 62
    assert lines[-1].startswith("recomputed by mpmath ") and lines[-1].endswith(" to 60 digits: equal")


@pytest.mark.parametrize("name", ["moments", "smith2012.f"])
def test_every_reference_table_says_which_route_has_recomputed_it(name):
    table = with_validation(build(name, 8))
    told = validated(table)
    assert f"# validation: {told}\n" in table.to_csv_file() and f"% validation: {told}\n" in table.to_latex() + "\n"
    assert told.startswith("recomputed by mpmath " if name in ROUTES else "not by mpmath alone; the tests obtain it")
    assert set(ROUTES) < set(names())
    wrong = altered(table, 1) if name in ROUTES else table
    assert ("differ" in validated(wrong)) == (name in ROUTES)
