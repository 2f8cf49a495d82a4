"""What this program wrote, given to it again: read where it holds data, else refused with what it is."""

import json

import pytest

import asymptotics as asy
from asymptotics.shell.main import main

ROWS = {
    "identify --csv": "law,verdict,parameter,estimate,low,high,code\n1,consistent,epsilon 1,0.03,0.02,0.04,a\n" * 2,
    "damping --from .*--csv": "law,grade,alpha,low,strength,high,code\n1,good,1,2,3,4,a\n2,bad,2,1,2,3,a\n",
    "damping --csv": "part,amplitude,zeta,Q,code\nfirst order,1,0.02,23.5,a\nfirst order,2,0.04,11.7,a\n",
}


@pytest.mark.parametrize("wrote", ROWS)
@pytest.mark.parametrize("command", ["identify", "damping --from", "compare"])
def test_an_answer_is_no_data_and_says_which_it_is(tmp_path, capsys, wrote, command):
    """Failed before: what is measured is not clear; it has no column A; --alpha is missing."""
    path = tmp_path / "out.csv"
    path.write_text(ROWS[wrote])
    assert main([*command.split(), str(path)]) == 2
    said = capsys.readouterr().err
    assert "is what asymptotics" in said and wrote.split(" .*")[0] in said


def test_a_table_of_somebody_else_under_the_same_names_is_read(tmp_path):
    """Failed before: refused as what damping --csv wrote."""
    path = tmp_path / "mine.csv"
    path.write_text("part,amplitude,zeta\nleft,1,0.01\nleft,2,0.02\nleft,3,0.03\n")
    assert asy.identify(path, kind="damping").best.name == "2"


@pytest.mark.parametrize("command", ["identify", "damping --from", "compare"])
def test_json_of_an_answer_is_no_table(tmp_path, capsys, command):
    path = tmp_path / "out.json"
    path.write_text(json.dumps({"command": "identify", "version": "0.1.0", "laws": [{"law": "1"}, {"law": "2"}]}))
    assert main([*command.split(), str(path)]) == 2
    assert "is the answer of asymptotics identify --json" in capsys.readouterr().err


def test_turning_points_that_were_written_are_read_again(tmp_path, capsys):
    """Failed before: 0 turning points, for the column tau, which was not asked for, is empty."""
    path = tmp_path / "points.csv"
    asked = "turning-points --alpha 2 --epsilon 1/10 --count 12 --csv"
    assert main([*asked.split(), str(path)]) == 0
    found = asy.identify(path, laws=["1", "2"], bootstrap=False)
    assert found.best.law.epsilon[0].estimate == pytest.approx(0.1, rel=1e-3)
