"""The command sweep: its contract, its refusals (one line, exit 2, nothing half-written), and what it leaves behind."""

import json

from asymptotics.ask.axes import read_axes
from asymptotics.shell.main import main
from asymptotics.sweeps.export import read_rows
from tests.each import each


def call(capsys, *arguments):
    code = main(["sweep", *map(str, arguments)])
    return code, *capsys.readouterr()


def refused(capsys, *arguments):
    """The one line of a refusal."""
    code, out, err = call(capsys, *arguments)
    assert (code, out) == (2, "")
    assert err.count("\n") == 1
    return err


def test_the_contract(capsys, tmp_path):
    command = ["turning-points", "--alpha", "0:2:1", "--epsilon", "1/10:3/10:1/10", "--count", 2, "--times",
               "--digits", 20, "--store", tmp_path / "s", "--workers", 1, "--json"]  # fmt: skip
    code, out, _ = call(capsys, *command)
    found = json.loads(out)
    assert (code, found["points"], found["reused"], found["failed"]) == (0, 9, 0, 0)
    again = json.loads(call(capsys, *command, "--export", tmp_path / "r.csv")[1])
    assert (again["points"], again["reused"], again["computed"]) == (9, 9, 0)
    rows = list(read_rows(tmp_path / "r.csv"))
    order = [(str(row["alpha"]), str(row["epsilon"])) for row in rows]
    assert order == [(alpha, epsilon) for alpha in "012" for epsilon in ("1/10", "1/5", "3/10")]
    assert str(rows[1]["points.1.x"]) == "-3/5"  # alpha = 0: 1 - 2 epsilon, exactly


def test_equal_numbers_are_one_point_however_they_are_written(capsys, tmp_path):
    call(capsys, "moment", "--p", "1/2", "--store", tmp_path, "--workers", 1)
    found = json.loads(call(capsys, "moment", "--p", "0.5,0.50,5e-1", "--store", tmp_path, "--workers", 1, "--json")[1])
    assert (found["points"], found["reused"]) == (1, 1)


def test_a_failed_point_ends_nothing(capsys, tmp_path):
    command = ["moment", "--p", "-2:2:1", "--store", tmp_path, "--workers", 1, "--json"]
    code, out, _ = call(capsys, *command)
    found = json.loads(out)
    assert (code, found["points"], found["failed"]) == (0, 5, 2)
    assert found["failures"][0]["point"] == {"p": "-2"}


def test_a_list_of_points(capsys, tmp_path):
    (tmp_path / "points.csv").write_text("p,digits\n1/2,10\n3,5\n")
    code, out, _ = call(capsys, "moment", "--list", tmp_path / "points.csv", "--store", tmp_path / "s", "--workers", 1,
                        "--json", "--export", tmp_path / "a.csv")  # fmt: skip
    assert (code, json.loads(out)["points"]) == (0, 2)
    assert [row["digits"] for row in read_rows(tmp_path / "a.csv")] == [10, 5]


def test_sums_of_laws_are_axes(capsys):
    axes = read_axes("turning-points", ["--law", "0:1/20", "--law", "3/2:0:1/5:1/10", "--count", "2", "--times"])
    assert axes == {"law.1": ("0:1/20",), "law.2": ("3/2:0", "3/2:1/10", "3/2:1/5"), "count": ("2",), "times": ("",)}
    assert read_axes("turning-points", ["--law", "2:1/10,1/5"]) == {"law": ("2:1/10", "2:1/5")}


@each(
    "arguments",
    [
        ["nothing", "--p", "1"],
        ["moment"],
        ["moment", "--p"],
        ["moment", "--p", "a"],
        ["moment", "--p", "1:2"],
        ["moment", "--p", "0:1:1e-12"],
        ["moment", "--q", "1"],
        ["moment", "--p", "1", "--json=3"],
        ["moment", "--p", "1", "--plot", "a.svg"],
        ["moment", "--p", "1", "--workers", "0"],
        ["moment", "--p", "1", "--export", "r.xlsx"],
        ["moment", "--p", "1", "--export", "no/such/folder/r.csv"],
        ["moment", "--list", "missing.csv"],
        ["turning-points", "--law", "2", "--count", "2"],
        ["turning-points", "--alpha", "2", "--epsilon", "1"],
    ],
)
def test_bad_input_is_refused_before_anything_is_written(capsys, tmp_path, monkeypatch, arguments):
    monkeypatch.chdir(tmp_path)
    refused(capsys, *arguments, "--store", "s")
    assert list(tmp_path.iterdir()) == []


def test_a_missing_store_is_refused(capsys):
    assert "--store" in refused(capsys, "moment", "--p", "1")


def test_a_grid_that_is_too_large_is_refused_with_the_estimate(capsys, tmp_path):
    axis = "1:2:1/1000"
    error = refused(capsys, "turning-points", "--alpha", axis, "--epsilon", axis, "--count", "2:1000:1",
                    "--digits", "1:1000:1", "--store", tmp_path / "s")  # fmt: skip
    assert "10^12" in error.replace("*10^11", "10^12")
    assert "days" in error


def test_a_list_with_a_text_in_a_cell_is_refused(capsys, tmp_path):
    for text in ("p\nhello\n", "p,q\n1\n", "q\n1\n", "p\n1:2:1\n", ""):
        (tmp_path / "points.csv").write_text(text)
        refused(capsys, "moment", "--list", tmp_path / "points.csv", "--store", tmp_path / "s")
        assert not (tmp_path / "s").exists()
