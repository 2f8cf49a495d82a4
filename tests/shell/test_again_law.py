"""The export of ``damping --from``: its header holds the table, and the same fit is made again from there."""

import csv
import io
import json

import pytest

from asymptotics.shell.main import main

TABLE = "A,zeta\n0.1,0.0120\n0.2,0.0141\n0.4,0.0178\n0.8,0.0261\n"
ASKED = {
    "resolution": (TABLE, ["--resolution", "0.0002", "--laws", "1", "2", "1+2"]),
    "no resolution, every law": (TABLE, []),
    "deg of a pendulum in SI": (
        TABLE.replace("A,", "A [deg],").replace("0.1,", "5,").replace("0.2,", "10,"),
        ["--resolution", "1/5000", "--spring", "pendulum", "--mass", "2", "--stiffness", "3", "--laws", "1+2", "3/2"],
    ),
    "Q with its own resolutions": (
        "A,Q,resolution\n0.1,41.7,0.5\n0.2,35.5,0.5\n0.4,28.1,0.4\n0.8,19.2,0.3\n",
        ["--spring", "3:1/5", "--laws", "0+1", "1+2"],
    ),
}


@pytest.fixture
def path(tmp_path):
    return tmp_path / "law.csv"


def exported(path, name):
    text, options = ASKED[name]
    table = path.parent / "table.csv"
    table.write_text(text)
    assert main(["damping", "--from", str(table), *options, "--csv", str(path)]) == 0
    table.unlink()  # the header holds its numbers


def compared(capsys, path):
    capsys.readouterr()
    assert main(["compare", str(path), "--json"]) == 0
    return json.loads(capsys.readouterr()[0])


def changed(path, line, column, cell):
    rows = list(csv.reader(io.StringIO(path.read_text())))
    rows[line - 1][rows[0].index(column)] = cell
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    path.write_text(text.getvalue())


@pytest.mark.parametrize("name", ASKED)
def test_a_law_is_fitted_again_and_a_changed_digit_is_found(capsys, path, name):
    exported(path, name)
    found = compared(capsys, path)  # failed before: "does not name a key and a value"
    assert found["certified"] is False and "in doubles" in found["method"]
    assert all(float(row["digits"]) > 12 or float(row["given"]) == 0 for row in found["rows"])
    assert found["summary"]["order"] == {"missing": 0, "doubled": 0, "shuffled": 0}
    assert "differs" not in found["summary"]
    one = next(row for row in found["rows"] if row["column"] == "strength")
    digit = one["given"][5]
    changed(path, one["line"], "strength", one["given"][:5] + str((int(digit) + 3) % 10) + one["given"][6:])
    wrong = compared(capsys, path)
    assert [(r["line"], r["column"]) for r in wrong["rows"] if 0 < float(r["digits"]) < 6] == [
        (one["line"], "strength")
    ]


def test_a_changed_grade_is_told(capsys, path):
    exported(path, "resolution")
    changed(path, 2, "grade", "certain")
    assert compared(capsys, path)["summary"]["differs"] == [
        "line 2, grade: 'certain' is given, and 'consistent' is right"
    ]


def test_a_row_of_another_law_is_refused(capsys, path):
    exported(path, "resolution")
    changed(path, 2, "law", "3")
    assert main(["compare", str(path)]) == 2
    assert "line 2: its request has no row 3" in capsys.readouterr()[1]


@pytest.mark.parametrize(
    ("said", "named"),
    [
        ("--from=/etc/passwd", "--from=/etc/passwd"),
        ("--A=1,2,3 --zeta=1,2,3 --csv=/etc/motd", "--csv=/etc/motd"),
        ("--A=__import__('os'),2 --zeta=1,2", "__import__"),
        ("--A=1,2,3 --zeta=0.1,0.2,0.3 --laws=__import__", "__import__"),
        ("--A=1,2,3 --zeta=0.1,0.2,0.3 --laws=1 --spring=os.system", "os.system"),
        ("--A=1,2,3 --A=1,2,3 --zeta=0.1,0.2,0.3", "--A twice"),
        ("--A=1e400,2,3 --zeta=0.1,0.2,0.3 --laws=1", "not positive"),
        ("--zeta=0.1,0.2,0.3 --laws=1", "no column A"),
        ("--A=1,2,3 --zeta=0.1,0.2 --laws=1", "differ in length"),
    ],
)
def test_a_hostile_header_is_refused_by_name(capsys, path, said, named):
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow(["law", "grade", "alpha", "low", "strength", "high",
                                                    f"code [damping-law {said}]"])  # fmt: skip
    path.write_text(text.getvalue() + "1,consistent,1,1,1,1,a\n")
    assert main(["compare", str(path)]) == 2
    out, err = capsys.readouterr()
    assert out == "" and err.count("\n") == 1 and named in err
    assert [p.name for p in path.parent.iterdir()] == ["law.csv"]
