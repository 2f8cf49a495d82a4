"""Sweeps exported as JSON and Parquet, read back beside themselves; a large one keeps the rows that are done."""

import json

import pytest

from asymptotics.ask import again
from asymptotics.errors import LimitError
from asymptotics.shell.main import main

SWEEPS = {
    "moment": ["--p", "0:1:1/2", "--digits", "20"],
    "turning-points": ["--alpha", "2,3", "--epsilon", "1/10", "--count", "2", "--times"],
    "expand": ["--law", "2", "--spring", "3", "--order", "1,2"],
    "smith": ["f", "--n", "3,4"],
    "envelope": ["--alpha", "2", "--epsilon", "1/10,1/5", "--time", "3"],
}


def swept(command, path, arguments=None):
    line = ["sweep", command, *(arguments or SWEEPS[command]), "--store", str(path.parent / "runs"), "--workers", "1"]
    assert main([*line, "--quiet", "--export", str(path)]) == 0


def compared(capsys, path, status=0):
    capsys.readouterr()
    assert main(["compare", str(path), "--json"]) == status
    return json.loads(capsys.readouterr()[0])


def another_digit(text):
    top, slash, bottom = text.partition("/")
    return top[:-1] + str((int(top[-1]) + 3) % 10) + slash + bottom


def changed_json(path, line, column):
    """One value of the row on a line of the file, with its last digit changed."""
    lines = path.read_text().splitlines()
    row = json.loads(lines[line - 1].rstrip(","))
    place = row["result"]
    *outer, last = column.split(".")
    for part in outer:
        place = place[int(part)] if isinstance(place, list) else place[part]
    last = int(last) if isinstance(place, list) else last
    place[last] = another_digit(str(place[last]))
    lines[line - 1] = json.dumps(row) + ("," if lines[line - 1].endswith(",") else "")
    path.write_text("\n".join(lines) + "\n")


def changed_parquet(path, number, column):
    parquet = pytest.importorskip("pyarrow.parquet")
    table = parquet.read_table(path)
    rows = table.to_pylist()
    rows[number - 1][column] = another_digit(rows[number - 1][column])
    parquet.write_table(type(table).from_pylist(rows, schema=table.schema), path)


CHANGED = {"json": changed_json, "parquet": changed_parquet}


@pytest.mark.parametrize("suffix", CHANGED)
@pytest.mark.parametrize("command", SWEEPS)
def test_an_export_is_read_back_and_a_changed_digit_is_found(capsys, tmp_path, command, suffix):
    if suffix == "parquet":
        pytest.importorskip("pyarrow", reason="the extra parquet is not installed")
    path = tmp_path / f"swept.{suffix}"
    swept(command, path)
    found = compared(capsys, path)  # failed before: "it is not CSV text"
    assert found["certified"] is True and found["summary"]["order"] == {"missing": 0, "doubled": 0, "shuffled": 0}
    assert found["summary"]["all_right"] == found["summary"]["values"] == len(found["rows"]) > 0
    one = next(row for row in reversed(found["rows"]) if row["given"][-1] in "0123456789")
    CHANGED[suffix](path, one["line"], one["column"])
    wrong = compared(capsys, path)
    assert [(r["line"], r["column"]) for r in wrong["rows"] if "[" in r["marked"]] == [(one["line"], one["column"])]


def test_json_csv_and_parquet_say_the_same(capsys, tmp_path):
    pytest.importorskip("pyarrow", reason="the extra parquet is not installed")
    found = {}
    for suffix in ("csv", "json", "parquet"):
        path = tmp_path / f"swept.{suffix}"
        swept("moment", path)
        found[suffix] = compared(capsys, path)
    rows = {suffix: [{**row, "line": 0} for row in answer["rows"]] for suffix, answer in found.items()}
    assert rows["csv"] == rows["json"] == rows["parquet"]
    lines = {suffix: answer["rows"][0]["line"] for suffix, answer in found.items()}
    assert lines == {"csv": 2, "json": 2, "parquet": 1}  # Parquet has rows, and no lines
    assert found["csv"]["law"] == found["json"]["law"] == found["parquet"]["law"] == "sweep moment p digits"


def test_the_lines_of_a_file_that_was_written_anew_are_found(capsys, tmp_path):
    path = tmp_path / "swept.json"
    swept("moment", path)
    path.write_text(json.dumps(json.loads(path.read_text()), indent=1))
    lines = path.read_text().splitlines()
    found = compared(capsys, path)
    assert found["summary"]["all_right"] == found["summary"]["values"]
    assert all('"point"' in lines[row["line"]] for row in found["rows"])


def test_a_failed_point_is_no_value(capsys, tmp_path):
    path = tmp_path / "swept.json"
    swept("turning-points", path, ["--alpha", "2", "--epsilon", "1/10,-1/10", "--count", "2"])
    assert '"failed": "' in path.read_text()
    found = compared(capsys, path)
    assert found["summary"]["estimates"] == [3] and {row["line"] for row in found["rows"]} == {2}


@pytest.mark.parametrize("suffix", ["csv", "json"])
@pytest.mark.parametrize("error", [LimitError("max_seconds", "60 s are over", "a larger limit"), KeyboardInterrupt()])
def test_the_rows_that_are_done_are_kept(capsys, tmp_path, monkeypatch, suffix, error):
    path = tmp_path / f"swept.{suffix}"
    swept("moment", path, ["--p", "0:5:1", "--digits", "20"])
    whole, calls = again.answered, []

    def cut(command, point):
        calls.append(point)
        if len(calls) == 4:
            raise error
        return whole(command, point)

    monkeypatch.setattr(again, "answered", cut)
    capsys.readouterr()
    assert main(["compare", str(path), "--json"]) == (2 if isinstance(error, LimitError) else 130)
    found = json.loads(capsys.readouterr()[0])  # failed before: nothing was printed
    assert sorted({row["line"] for row in found["rows"]}) == [2, 3, 4]
    assert found["missing"] == "lines 5 ... 7 (3 rows)"
    assert found["summary"]["look"]["kind"] == "undecided" and "order" not in found["summary"]


HEAD = '{"command": "moment", "rows": ['
BAD = {
    "[1, 2]": "no export of a sweep",
    '{"rows": [{"point": {}, "result": {}}]}': "no export of a sweep",
    '{"command": "moment", "rows": 3}': "no export of a sweep",
    "{": "is not JSON",
    "[" * 100_000: "",
    HEAD + '\n{"point": {"p": 3}, "result": {"value": "1"}}\n]}': "line 2 has no point and result",
    HEAD + '\n{"point": {"p": "1"}, "result": {"value": "1"}},\n7]}': "line 3 has no point and result",
    HEAD + "]}": "no rows of values",
    '{"x": {"rows": []},\n"command": "moment", "rows": [{"point": {"p": "1"}, "result": {}}]}': "other lists of rows",
    '{"command": "identify", "rows": [{"point": {"k": "1"}, "result": {}}]}': "identify",
    '{"command": "os.system", "rows": [{"point": {"k": "1"}, "result": {}}]}': "os.system",
    HEAD + '{"point": {"csv": "/etc/motd"}, "result": {}}]}': "csv",
    HEAD + '{"point": {"list": "/etc/motd"}, "result": {}}]}': "list",
    HEAD + '{"point": {"p": "__import__(\'os\')"}, "result": {"value": "1"}}]}': "__import__",
    HEAD + '{"point": {"q": "1"}, "result": {"value": "1"}}]}': "names 'q', no parameter of it",
}


@pytest.mark.parametrize("text", BAD)
def test_what_is_no_export_is_refused_by_name(capsys, tmp_path, text):
    path = tmp_path / "bad.json"
    path.write_text(text)
    assert main(["compare", str(path)]) == 2
    out, err = capsys.readouterr()
    assert out == "" and err.count("\n") == 1 and BAD[text] in err and len(err) < 600
    assert [p.name for p in tmp_path.iterdir()] == ["bad.json"]


@pytest.mark.parametrize(
    ("metadata", "cells", "named"),
    [
        ({}, {"p": "1"}, "does not name the request"),
        ({"request": "[1"}, {"p": "1"}, "does not name the request"),
        ({"request": '["turning-points", "--csv=/etc/motd"]'}, {"p": "1"}, "no request of a sweep"),
        ({"request": '["sweep"]'}, {"p": "1"}, "no request of a sweep"),
        ({"request": '["sweep", "identify", "p"]'}, {"p": "1"}, "identify"),
        ({"request": '["sweep", "moment", "csv"]'}, {"csv": "1"}, "csv"),
        ({"request": '["sweep", "moment", "p"]'}, {"p": 1}, "row 1 has a cell that is no text"),
    ],
)
def test_parquet_of_others_is_refused_by_name(capsys, tmp_path, metadata, cells, named):
    arrow = pytest.importorskip("pyarrow", reason="the extra parquet is not installed")
    parquet = pytest.importorskip("pyarrow.parquet")
    path = tmp_path / "bad.parquet"
    table = arrow.Table.from_pylist([{**cells, "value": "1" if isinstance(cells.get("p", ""), str) else 2}])
    parquet.write_table(table.replace_schema_metadata(metadata), path)
    assert main(["compare", str(path)]) == 2
    assert named in capsys.readouterr()[1]
    path.write_bytes(b"PAR1 and nothing more")
    assert main(["compare", str(path)]) == 2
    assert "is not Parquet" in capsys.readouterr()[1]
