"""The command compare: its contract, its units, its refusals."""

import json

import pytest

from asymptotics.shell.main import main


def call(capsys, *arguments):
    code = main(["compare", *map(str, arguments)])
    return code, *capsys.readouterr()


@pytest.fixture
def mine(tmp_path):
    path = tmp_path / "mine.csv"
    path.write_text("n,x,tau\n0,1,0\n1,-0.4107197,3.38\n2,-0.2635711,6.58\n")
    return path


def test_the_contract(capsys, mine):
    code, out, _ = call(capsys, mine, "--alpha", 2, "--epsilon", 1, "--columns", "n,x,tau", "--json")
    found = json.loads(out)
    assert code == 0
    assert found["certified"] is True
    row = found["rows"][2]
    assert [row[k] for k in ("line", "n", "column", "given", "certified", "digits")] == [
        3, 1, "x", "-0.4107197", "-0.41071968606103944670", "7.47"]  # fmt: skip
    assert [r["digits"] for r in found["rows"] if r["n"] == 2 and r["column"] == "x"] == ["0.00"]  # the wrong sign
    assert found["summary"]["values"] == 6


def test_the_text_the_rows_and_the_plot(capsys, mine, tmp_path):
    code, out, _ = call(capsys, mine, "--law", "2:1", "--plot", tmp_path / "lost.svg", "--csv", tmp_path / "rows.csv")
    assert code == 0
    assert "[" in out
    assert "certified: true" in out
    assert (tmp_path / "lost.svg").read_text().startswith("<?xml")
    assert (tmp_path / "rows.csv").read_text().startswith("line,n,column,given,certified,digits")


def test_units(capsys, tmp_path):
    path = tmp_path / "lab.csv"
    path.write_text("t [s],x [m]\n0,0.5\n1,-0.19\n")
    si = ["--mass", 2, "--stiffness", 8, "--x0", "1/2"]
    by_b = json.loads(call(capsys, path, "--alpha", 2, "--damping", "4/10", *si, "--json")[1])
    by_epsilon = json.loads(call(capsys, path, "--alpha", 2, "--epsilon", "1/10", *si, "--json")[1])
    assert by_b["rows"] == by_epsilon["rows"]
    assert by_b["law"] == by_epsilon["law"] == "2 x'' + 8 x + 2/5 x'|x'| = 0, x(0) = 1/2, x'(0) = 0"
    assert by_b["rows"][1]["t"] == "1"


@pytest.mark.parametrize(
    "arguments",
    [
        [],
        ["--alpha", 2],
        ["--alpha", 2, "--epsilon", 1, "--columns", "n,y"],
        ["--alpha", 2, "--epsilon", 1, "--columns", "n=k,x"],
        ["--alpha", 2, "--epsilon", 1, "--plot", "a.bmp"],
        ["--alpha", 2, "--epsilon", 1, "--plot", "no/such/folder.svg"],
        ["--alpha", 2, "--epsilon", 1, "--digits", 0],
        ["--alpha", 2, "--mass", 1],
        ["--alpha", 2, "--damping", 1, "--epsilon", 1, "--mass", 1],
        ["--alpha", 2, "--epsilon", 1, "--mass", 0],
        ["--alpha", "3/2", "--epsilon", 1, "--stiffness", 2],
        ["--alpha", 2, "--epsilon", -1],
    ],
)
def test_bad_input_is_one_line_and_exit_2(capsys, mine, tmp_path, monkeypatch, arguments):
    monkeypatch.chdir(tmp_path)
    code, out, err = call(capsys, mine, *arguments)
    assert (code, out) == (2, "")
    assert err.count("\n") == 1
    assert [p.name for p in tmp_path.iterdir()] == ["mine.csv"]


def test_table_one_of_smith_has_two_wrong_digits(capsys, tmp_path):
    path = tmp_path / "printed.csv"
    printed = ["0.0987650,-0.410720", "0.123863,0.263568", "0.133834,-0.194566", "0.138780,0.154318"]
    rows = [f"{n},{row}\n" for n, row in enumerate([*printed, "0.141589,-0.127908"], start=2)]
    path.write_text("half_cycle,S_hat,u\n" + "".join(rows))
    code, out, _ = call(capsys, path, "--table", "smith2012.table1", "--json")
    found = json.loads(out)
    assert code == 0
    assert [row["given"] for row in found["rows"] if "[" in row["marked"]] == ["0.133834", "0.141589"]
    assert found["rows"][0]["half_cycle"] == "2"
    assert found["certified"] is True


@pytest.mark.parametrize("written", ["10", "10.0", "1.000000000000000000e+01", "1e1", "20/2"])
def test_a_key_is_a_number_however_it_is_written(capsys, tmp_path, written):
    path = tmp_path / "mine.csv"
    path.write_text(f"half_cycle,S_hat\n2.000e+00,0.098765\n{written},0.145888\n")
    code, out, err = call(capsys, path, "--table", "smith2012.table1", "--json")
    assert (code, err) == (0, "")
    assert [row["marked"] for row in json.loads(out)["rows"]] == ["0.098765", "0.145888"]


def test_a_key_that_counts_is_whole(capsys, tmp_path):
    path = tmp_path / "mine.csv"
    path.write_text("half_cycle,S_hat\n1.05e+00,0.1\n")
    code, out, err = call(capsys, path, "--table", "smith2012.table1")
    assert (code, out) == (2, "")
    assert "no row for 1.05e+00" in err


def test_coefficients_are_found_by_their_names(capsys, tmp_path):
    path = tmp_path / "mine.csv"
    path.write_text("alpha,coefficient,value\n3/2,p_1,0.4576558581\n2,Omega_2,-0.1666\n1.5,Omega_2,-0.2\n")
    code, out, _ = call(capsys, path, "--table", "normal-form", "--alpha", "3/2,2", "--json")
    assert code == 0
    assert [float(row["digits"]) > 9 for row in json.loads(out)["rows"]] == [True, False, False]


@pytest.mark.parametrize(
    ("text", "more"),
    [
        ("half_cycle,u\n0,1\n", []),
        ("half_cycle,u\na,1\n", []),
        ("half_cycle,u\n1,a\n", []),
        ("half_cycle,v\n1,1\n", []),
        ("half_cycle,u\n1,1\n", ["--mass", "2"]),
        ("half_cycle,u\n1,1\n", ["--alpha", "2"]),
        ("u_0,half_cycle,u\n1,1,1\n", []),
        ("half_cycle,u\n1,1\n", ["--epsilon", "1,2"]),
    ],
)
def test_what_a_table_does_not_have_is_refused(capsys, tmp_path, text, more):
    path = tmp_path / "mine.csv"
    path.write_text(text)
    code, out, err = call(capsys, path, "--table", "smith2012.table1", *more)
    assert (code, out) == (2, "")
    assert err.count("\n") == 1


EXPORTS = {
    "turning points": (["turning-points", "--count", "4", "--times"], ["--alpha", "2", "--epsilon", "1/10"]),
    "motion": (["motion", "--time", "9", "--points", "9"], ["--alpha", "2", "--epsilon", "1/10"]),
    "reference": (["motion", "--time", "9", "--points", "9", "--reference"], ["--alpha", "2", "--epsilon", "1/10"]),
    "moments": (["table", "moments", "--alpha", "1/2,2"], []),
    "coefficients": (["table", "normal-form", "--alpha", "3/2", "--rows", "3"], []),
    "points": (["table", "turning-points", "--law", "1:1/20", "--law", "2:1/10", "--rows", "4"], []),
    "bounds": (["table", "error-bounds", "--alpha", "2", "--rows", "2"], []),
    "smith": (["table", "smith2012.table1"], []),
    "expand": (["expand", "--order", "4"], ["--alpha", "3/2"]),
    "half-swing": (["half-swing", "--order", "3"], ["--alpha", "3/2"]),
    "half-swing of a sum": (["half-swing", "--order", "2"], ["--law", "1:1/10", "--law", "2:1/5"]),
    "envelope": (["envelope", "--time", "9", "--points", "9"], ["--alpha", "2", "--epsilon", "1/10"]),
}


@pytest.mark.parametrize("name", EXPORTS)
def test_what_the_program_exports_it_reads_with_the_inputs_of_its_head(capsys, tmp_path, name):
    path = tmp_path / "exported.csv"
    making, law = EXPORTS[name]
    assert main([*making, *law, "--csv", str(path)]) == 0
    capsys.readouterr()
    code, out, _ = call(capsys, path, *law, "--json")
    found = json.loads(out)
    assert (code, found["certified"]) == (0, True)
    if name == "motion":  # an expansion of order 3: right to some digits; its amplitude belongs to a gauge
        assert found["summary"]["not_compared"] == ["amplitude", "phase"]
    elif name == "envelope":  # doubles
        assert float(found["summary"]["worst_digits"]) > 13
        assert {row["column"] for row in found["rows"]} == {"amplitude", "phase"}
    else:
        assert float(found["summary"]["worst_digits"]) > 14 or name == "bounds"
        assert found["summary"]["look"]["kind"] == "rounding"


SELF = {
    **{name: (making, law) for name, (making, law) in EXPORTS.items() if law},
    "motion in SI": (
        ["motion", "--time", "3", "--points", "9"],
        ["--alpha", "2", "--damping", "1/10", "--mass", "3/2", "--x0", "1/5"],
    ),
    "points in SI": (["turning-points", "--count", "4"], ["--law", "1:1/50", "--law", "2:1/10", "--stiffness", "30"]),
    "solution": (["solution", "--time", "9", "--points", "9"], ["--alpha", "2", "--epsilon", "1/10"]),
}


@pytest.mark.parametrize("name", SELF)
def test_an_export_says_itself_of_which_oscillator_it_is(capsys, tmp_path, name):
    path = tmp_path / "exported.csv"
    making, law = SELF[name]
    assert main([*making, *law, "--csv", str(path)]) == 0
    capsys.readouterr()
    alone, beside = (json.loads(call(capsys, path, *given, "--json")[1]) for given in ((), law))
    if name == "envelope":  # alone its whole request is asked again, at more digits
        assert alone["law"].startswith("envelope ") and float(alone["summary"]["worst_digits"]) > 13
        return
    assert alone == beside


@pytest.mark.parametrize("name", ["expand", "half-swing", "envelope"])
def test_exports_of_another_law_are_told_apart(capsys, tmp_path, name):
    path = tmp_path / "exported.csv"
    making, law = EXPORTS[name]
    assert main([*making, *law, "--csv", str(path)]) == 0
    capsys.readouterr()
    code, out, _ = call(capsys, path, *["5/2" if text in ("3/2", "2") else text for text in law])
    assert code == 0
    assert "right digits: worst 0." in out or "right digits: worst 1." in out
    assert "every value is right" not in out


def test_coefficients_need_a_law_and_their_lines_are_those_of_the_file(capsys, tmp_path):
    path = tmp_path / "exported.csv"
    assert main(["expand", "--alpha", "2", "--order", "4", "--csv", str(path)]) == 0
    capsys.readouterr()
    assert call(capsys, path)[0] == 0  # the header says the law
    path.write_text(path.read_text().replace("code [--alpha=2]", "code"))
    assert "--alpha" in call(capsys, path)[2]
    lines = path.read_text().splitlines()
    found = json.loads(call(capsys, path, "--alpha", "2", "--json")[1])
    assert [lines[row["line"] - 1].split(",")[2] for row in found["rows"]] == [row["given"] for row in found["rows"]]


def test_a_digit_changed_in_an_exported_table_is_found(capsys, tmp_path):
    path = tmp_path / "exported.csv"
    assert main(["table", "moments", "--alpha", "1/2,2", "--digits", "12", "--csv", str(path)]) == 0
    path.write_text(path.read_text().replace("0.4244", "0.4245"))
    capsys.readouterr()
    assert json.loads(call(capsys, path, "--json")[1])["summary"]["look"]["kind"] == "undecided"


@pytest.mark.parametrize("head", ["--alpha=2 --csv=/etc/motd", "alpha", "--alpha='2", "--help", "--alpha=2 --alpha"])
def test_a_header_that_says_more_than_an_oscillator_says_nothing(capsys, tmp_path, head):
    path = tmp_path / "mine.csv"
    path.write_text(f"n,x,code [{head}]\n0,1,a\n")
    code, out, err = call(capsys, path)
    assert (code, out) == (2, "") and "--alpha" in err


def test_an_export_with_a_spring_is_refused_by_name(capsys, tmp_path):
    path = tmp_path / "mine.csv"
    path.write_text("n,x,code [--alpha=2 --epsilon=1/10 --spring=3:1/5]\n0,1,a\n")
    assert "it is of an oscillator with --spring" in call(capsys, path)[2]
