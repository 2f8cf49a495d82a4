"""The command table: list, formats, files, roundings, refusals."""

import csv
import io
import json

import pytest

from asymptotics.shell.main import main
from tests.each import each


def call(capsys, *arguments):
    code = main(["table", *map(str, arguments)])
    return code, *capsys.readouterr()


def test_the_list_says_columns_routes_and_cost(capsys):
    code, out, _ = call(capsys, "--list", "--json")
    found = json.loads(out)["tables"]
    assert code == 0
    assert len(found) >= 15
    assert all(entry["columns"] and entry["source"] and entry["check"] and entry["cost"] for entry in found.values())
    text = call(capsys, "--list")[1]
    assert "route:" in text
    assert "options: --epsilon --rows" in text


def test_the_contract(capsys):
    code, out, _ = call(capsys, "smith2012.table1", "--epsilon", "1/2,1", "--rows", 3, "--digits", 12, "--json")
    found = json.loads(out)
    assert code == 0
    assert found["columns"] == ["u_0", "half_cycle", "S_hat", "u"]
    assert [row[:2] for row in found["rows"]] == [[u, n] for u in ("1/2", "1") for n in "123"]
    assert found["certified"] is True
    assert found["provenance"]["inputs"]["digits"] == 12


@pytest.mark.parametrize("form", ["text", "csv", "json", "latex", "parquet"])
def test_files_carry_their_origin(capsys, tmp_path, form):
    path = tmp_path / "table"
    code, out, _ = call(capsys, "moments", "--alpha", "0:1:1/2", "--format", form, "--output", path, "--digits", 10)
    assert (code, out) == (0, f"written: {path}\n")
    assert b"sha256" in path.read_bytes()


def test_csv_on_the_terminal_is_plain(capsys):
    out = call(capsys, "stops", "--epsilon", "1/10", "--format", "csv", "--digits", 5)[1]
    rows = list(csv.reader(io.StringIO(out)))
    assert rows == [["epsilon", "N", "x_N", "tau_N"], ["1/10", "5", "0", "15.708"]]


def test_roundings(capsys):
    shown = {}
    for mode in ("nearest", "down", "up", "floor", "ceil", "interval"):
        command = ["smith2012.table1", "--rows", 2, "--digits", 4, "--rounding", mode, "--json"]
        shown[mode] = json.loads(call(capsys, *command)[1])["rows"][1][2]
    assert shown == {"nearest": "-0.4107", "down": "-0.4107", "up": "-0.4108", "floor": "-0.4108", "ceil": "-0.4107",
                     "interval": "[-0.4108, -0.4107]"}  # fmt: skip


@each(
    "arguments",
    [
        [],
        ["nope"],
        ["moments", "--rows", 2],
        ["moments", "--alpha", "a"],
        ["moments", "--alpha", "1:2"],
        ["moments", "--rounding", "sideways"],
        ["moments", "--format", "xlsx"],
        ["moments", "--format", "parquet"],
        ["moments", "--output", "no/such/folder/file"],
        ["turning-points", "--law", "1"],
        ["turning-points", "--law", "1:1", "--alpha", "2"],
        ["turning-points", "--alpha", "2", "--epsilon", "0"],
        ["two-law-times", "--law", "1:1"],
    ],
)
def test_bad_input_is_one_line_and_exit_2(capsys, tmp_path, monkeypatch, arguments):
    monkeypatch.chdir(tmp_path)
    code, out, err = call(capsys, *arguments)
    assert (code, out) == (2, "")
    assert err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("option", ["--plot=a.svg", "--csv=a.csv", "--html=a.html", "--certificate=a.json"])
def test_a_list_of_tables_writes_no_file_and_says_so(capsys, tmp_path, monkeypatch, option):
    """The files of --list were left out without a word."""
    monkeypatch.chdir(tmp_path)
    assert main(["table", "--list", option]) == 2
    assert option.partition("=")[0] in capsys.readouterr().err and not list(tmp_path.iterdir())
