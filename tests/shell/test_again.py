"""Exports whose header names their request: read back, a changed digit found, a hostile header refused by name."""

import csv
import io
import json

import pytest

from asymptotics.shell.main import main

REQUESTS = {
    "points beside a spring": [
        "turning-points",
        "--alpha=2",
        "--epsilon=1/10",
        "--spring=3:1/5",
        "--count=3",
        "--times",
    ],
    "points of a start in motion": ["turning-points", "--alpha=2", "--epsilon=1/10", "--v0=1/2", "--count=3"],
    "points of a pendulum": ["turning-points", "--law=1:1/50", "--spring=pendulum", "--x0=1", "--count=3"],
    "points in SI": ["turning-points", "--alpha=2", "--damping=1/10", "--mass=2", "--spring=3:2", "--count=3"],
    "expand beside a spring": ["expand", "--alpha=2", "--spring=3:1/5", "--epsilon=1/10", "--order=2"],
    "half-swing beside a spring": ["half-swing", "--alpha=2", "--spring=3:1/5", "--epsilon=1/10", "--order=2"],
    "half-swing at a number": ["half-swing", "--alpha=2", "--delta=1/10"],
    "limit cycle": ["limit-cycle", "--law=1:-1", "--law=1,2:1", "--order=4"],
    "limit cycle at a number": ["limit-cycle", "--law=1:-1", "--law=1,2:1", "--spring=3:1/2", "--mu=1"],
    "stokes": ["stokes", "--alpha=2", "--count=1"],
    "smith": ["smith", "f", "--n=7"],
    "smith, one": ["smith", "c", "--n=31", "--i=10"],
    "damping": ["damping", "--alpha=2", "--epsilon=1/10", "--amplitudes=1/2,1/4"],
    "damping in deg": ["damping", "--law=1:1/50", "--spring=pendulum", "--amplitudes=10,40", "--unit=deg"],
}
SWEEPS = {
    "turning-points": ["--alpha", "2,3", "--epsilon", "1/10", "--count", "2", "--times"],
    "half-swing": ["--alpha", "2,3", "--order", "2"],
    "expand": ["--law", "2", "--spring", "3", "--order", "1,2"],
    "moment": ["--p", "0:1:1/2", "--digits", "20"],
    "smith": ["f", "--n", "3,4"],
    "limit-cycle": ["--law", "1:-1", "--law", "1,2:1", "--mu", "1,2", "--order", "2"],
    "stokes": ["--alpha", "2,3", "--count", "1"],
    "envelope": ["--alpha", "2", "--epsilon", "1/10,1/5", "--time", "3"],
}


@pytest.fixture
def path(tmp_path):
    return tmp_path / "exported.csv"


def compared(capsys, path):
    capsys.readouterr()
    assert main(["compare", str(path), "--json"]) == 0
    return json.loads(capsys.readouterr()[0])


def swept(command, arguments, path):
    folder = str(path.parent / "runs")
    line = ["sweep", command, *arguments, "--store", folder, "--workers", "1", "--quiet", "--export", str(path)]
    assert main(line) == 0


def another_digit(text):
    """The last digit of a number, another one, in the numerator of a fraction."""
    top, slash, bottom = text.partition("/")
    return top[:-1] + str((int(top[-1]) + 3) % 10) + slash + bottom


def changed(path, line, column):
    """The file with the last digit of one cell changed."""
    rows = list(csv.reader(io.StringIO(path.read_text())))
    place = rows[0].index(column)
    rows[line - 1][place] = another_digit(rows[line - 1][place])
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    path.write_text(text.getvalue())


def requires_round_trip_and_near_miss(capsys, path):
    found = compared(capsys, path)
    assert found["certified"] is True
    assert found["summary"]["all_right"] == found["summary"]["values"] == len(found["rows"]) > 0
    assert found["summary"]["look"]["kind"] == "rounding" and "differs" not in found["summary"]
    assert found["summary"]["order"] == {"missing": 0, "doubled": 0, "shuffled": 0}
    one = next(row for row in reversed(found["rows"]) if row["given"][-1] in "0123456789")
    changed(path, one["line"], one["column"])
    wrong = compared(capsys, path)
    bad = [(row["line"], row["column"]) for row in wrong["rows"] if "[" in row["marked"]]
    assert bad == [(one["line"], one["column"])]
    assert wrong["summary"]["look"]["kind"] == "undecided"


@pytest.mark.parametrize("name", REQUESTS)
def test_an_export_is_read_by_the_request_in_its_header_and_a_changed_digit_is_found(capsys, path, name):
    assert main([*REQUESTS[name], "--csv", str(path)]) == 0
    requires_round_trip_and_near_miss(capsys, path)


@pytest.mark.parametrize("command", SWEEPS)
def test_a_sweep_is_read_by_the_parameters_of_its_rows_and_a_changed_digit_is_found(capsys, path, command):
    swept(command, SWEEPS[command], path)
    requires_round_trip_and_near_miss(capsys, path)


def test_a_swept_motion_is_an_estimate_and_stands_beside_the_certified_motion(capsys, path):
    swept("motion", ["--law", "2:1/10,1/5", "--time", "3"], path)
    found = compared(capsys, path)
    assert {row["column"] for row in found["rows"]} == {"x", "v"} and found["method"].startswith("the certified motion")
    assert all(3 < float(row["digits"]) < 6 for row in found["rows"])  # an expansion of order 3, not itself again


def test_a_series_with_its_bound_stands_beside_the_motion_itself(capsys, path):
    request = ["damping", "--alpha=2", "--epsilon=1/10", "--amplitudes=1/4", "--order=2", "--csv", str(path)]
    assert main(request) == 0
    found = compared(capsys, path)
    own = {r["column"]: r["certified"] for r in found["rows"] if r["part"] == "the motion itself"}
    series = {r["column"]: r for r in found["rows"] if r["part"].startswith("order 2")}
    assert series and all(row["certified"] == own[name] for name, row in series.items())
    assert "bound of zeta log" in found["summary"]["not_compared"]


@pytest.mark.parametrize("start", [["--spring=3:1/5"], ["--v0=1/2"], ["--spring=pendulum", "--x0=3/2", "--v0=1/3"]])
def test_a_motion_beside_a_spring_or_from_a_start_in_motion_is_read(capsys, path, start):
    request = ["motion", "--law=2:1/10", *start, "--time=4", "--points=4", "--reference", "--csv", str(path)]
    assert main(request) == 0
    found = compared(capsys, path)
    assert found["certified"] is True and float(found["summary"]["worst_digits"]) > 15  # doubles
    changed_row = path.read_text().splitlines()
    changed_row[3] = changed_row[3].replace(changed_row[3].split(",")[1][:6], "0.1234", 1)
    path.write_text("\n".join(changed_row) + "\n")
    wrong = compared(capsys, path)["summary"]
    assert float(wrong["worst_digits"]) < 2 and wrong["worst_line"] == 4


def test_rows_missing_doubled_and_shuffled_are_counted_and_a_foreign_row_is_refused(capsys, path):
    assert main(["turning-points", "--alpha=2", "--epsilon=1/10", "--v0=1/2", "--count=4", "--csv", str(path)]) == 0
    head, one, two, three, four = path.read_text().splitlines()
    path.write_text("\n".join([head, two, one, four, four]) + "\n")
    assert compared(capsys, path)["summary"]["order"] == {"missing": 1, "doubled": 1, "shuffled": 1}
    path.write_text("\n".join([head, one, "9" + two[1:]]) + "\n")
    assert main(["compare", str(path)]) == 2
    assert "line 3: its request has no row 9" in capsys.readouterr()[1]


def test_a_changed_closed_form_is_told(capsys, path):
    assert main(["limit-cycle", "--law=1:-1", "--law=1,2:1", "--order=2", "--csv", str(path)]) == 0
    path.write_text(path.read_text().replace(",-2*pi,", ",-3*pi,"))
    told = compared(capsys, path)["summary"]["differs"]
    assert told and all("'-3*pi' is given, and '-2*pi' is right" in line for line in told)


@pytest.mark.parametrize(
    ("header", "named"),
    [
        ("stokes --alpha=2 --csv=/etc/motd", "--csv=/etc/motd"),
        ("stokes --alpha=2 --plot=a.svg", "--plot=a.svg"),
        ("damping --from=/etc/passwd", "--from=/etc/passwd"),
        ("stokes --alpha=2 --help", "--help"),
        ("stokes --alpha=2 --alpha=3", "--alpha twice"),
        ("stokes --alpha=2 more", "more"),
        ("identify /etc/passwd", "identify"),
        ("os.system ls", "os.system"),
        ("smith --help --n=7", "--help"),
        ("sweep identify k", "identify"),
        ("sweep stokes csv", "csv"),
        ("sweep stokes list", "list"),
        ("stokes --alpha=__import__('os')", "__import__"),
    ],
)
def test_a_hostile_header_is_refused_by_name(capsys, path, header, named):
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow(["k", "c_k", "csv", "list", f"code [{header}]"])
    path.write_text(text.getvalue() + "1,0.5,1,2,a\n")
    assert main(["compare", str(path)]) == 2
    out, err = capsys.readouterr()
    assert out == "" and err.count("\n") == 1 and named in err
    assert [p.name for p in path.parent.iterdir()] == ["exported.csv"]


def test_columns_beside_a_request_are_refused_by_name(capsys, path):
    assert main(["stokes", "--alpha=2", "--count=1", "--csv", str(path)]) == 0
    assert main(["compare", str(path), "--columns", "k,c_k"]) == 2
    assert "--columns" in capsys.readouterr()[1]
