"""Every table that names its request: exported, read back, a changed digit found; in every world the command takes.

The files of sweeps are read as CSV, as JSON and as Parquet.
"""

import csv
import io
import json

import pytest

from asymptotics.ask.registry import QUESTIONS, SWEPT, loaded
from asymptotics.errors import LimitError
from asymptotics.shell.main import main
from tests.every_question import example, in_world, options_of, without_order, worlds_of
from tests.test_cut_short import stop_at

OWN = [name for name in QUESTIONS if loaded(name).offers.table and loaded(name).offers.again is not None]
MORE = {  # what an example leaves out
    "half-swing": ["--delta=1/10"], "damping": ["--spring=pendulum", "--unit=deg"], "limit-cycle": ["--mu=1"],
    "turning-points": ["--times", "--v0=1/2"], "envelope": ["--squaring"],
}  # fmt: skip
ESTIMATES = {"solution": "an approximation, and no route certifies it to more digits"}


def line_of(name, folder, world="", more=()):
    """The example of a command, in a world; of a curve four rows."""
    words = in_world(name, folder, world) if world else example(name, folder)
    if name == "motion":
        words = [*without_order(words), "--reference"]  # the series is an estimate
    words = without_order(words) if "--delta=1/10" in more else words
    return [*words, *more, *(["--points=3"] if "--points" in options_of(name) else [])]


SAID = ("a start in motion", "SI", "air and a spring x^3", "a pendulum in air", "a loss that knows the place", "gains")
"""Worlds that take other words in a header."""
FEW = ("", "air and a spring x^3", "a start in motion")  # the others: ``make test-thorough``
ALONE = ("damping", "response", "solution")  # slow; their example and the others' worlds have the same words
CASES = [
    *((name, "", ()) for name in OWN),
    *((name, "", more) for name, more in MORE.items()),
    *((name, world, ()) for name in OWN if name not in ALONE for world in worlds_of(name) if world in SAID),
]


def compared(capsys, path, status=0):
    capsys.readouterr()
    assert main(["compare", str(path), "--json"]) == status, capsys.readouterr().err
    return json.loads(capsys.readouterr().out)


def another_digit(text):
    """The last digit of a number another one, of a double the ninth; in the numerator of a fraction."""
    top, slash, bottom = text.partition("/")
    place = 8 if len(top) > 14 else max(i for i, letter in enumerate(top) if letter.isdigit())
    place += top[place] == "."
    return top[:place] + str((int(top[place]) + 3) % 10) + top[place + 1 :] + slash + bottom


def changed(path, line, column, cell=another_digit):
    """The file with one cell another one; its other lines are as they were."""
    lines = path.read_text().splitlines()
    head = next(csv.reader([text for text in lines if not text.startswith("#")]))
    row, place = (
        next(csv.reader([lines[line - 1]])),
        [name.split(" [")[0] for name in head].index(column.split(" [")[0]),
    )
    row[place] = cell(row[place])
    text = io.StringIO()
    csv.writer(text, lineterminator="").writerow(row)
    lines[line - 1] = text.getvalue()
    path.write_text("\n".join(lines) + "\n")


def changed_json(path, line, column):
    lines = path.read_text().splitlines()
    row = json.loads(lines[line - 1].rstrip(","))
    place, (*outer, last) = row["result"], column.split(".")
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


CHANGED = {"csv": changed, "json": changed_json, "parquet": changed_parquet}


def requires_round_trip(found):
    """All is right, and certified; no row is missing."""
    summary = found["summary"]
    assert found["certified"] is True and "differs" not in summary
    assert summary["all_right"] == summary["values"] == len(found["rows"]) > 0
    assert summary["look"]["kind"] == "rounding"
    assert summary.get("order", {"missing": 0}) in ({"missing": 0, "doubled": 0, "shuffled": 0}, {"missing": 0})


def requires_near_miss(capsys, path, found, change=changed):
    """One digit of one cell is another one: it is found there, and nowhere else."""
    one = next(row for row in reversed(found["rows"]) if row["given"][-1].isdigit())
    change(path, one["line"], one["column"])
    wrong = compared(capsys, path)
    bad = [(row["line"], row["column"]) for row in wrong["rows"] if "[" in row["marked"]]
    assert bad == [(one["line"], one["column"])]
    assert wrong["summary"]["all_right"] == found["summary"]["all_right"] - 1
    if found["law"].split()[0] in (*QUESTIONS, "sweep"):  # judged cell by cell; a decay is looked at as a whole
        assert wrong["summary"]["look"]["kind"] == "undecided"


def some(name, world, more):
    """The case, dear where another world says the same words of another law."""
    marks = () if world in FEW else pytest.mark.slow
    return pytest.param(name, world, more, id=" ".join([name, *more, world]), marks=marks)


@pytest.mark.parametrize(("name", "world", "more"), [some(*case) for case in CASES])
def test_an_export_is_read_back_and_a_changed_digit_is_found(name, world, more, capsys, tmp_path):
    path = tmp_path / "exported.csv"
    if code := main([*line_of(name, tmp_path, world, more), "--csv", str(path)]):
        assert code == 2 and world and "argument --law: " in capsys.readouterr().err
        return
    if name in ESTIMATES:
        assert float(compared(capsys, path)["summary"]["worst_digits"]) > 0
        return
    found = compared(capsys, path)
    requires_round_trip(found)
    requires_near_miss(capsys, path, found)


def swept_words(name, folder, world=""):
    """A sweep of the example in two points: its last value, a whole number, and the next one."""
    words = line_of(name, folder, world)
    words = words[: words.index("--points=3")] if "--points=3" in words else words
    at = words.index("--digits") + 1 if "--digits" in words else -1
    words[at] += f",{int(words[at]) + 1}"
    return words


def swept(words, path):
    line = ["sweep", *words, "--store", str(path.parent / "runs"), "--workers", "1", "--quiet"]
    assert main([*line, "--export", str(path)]) == 0


SPRUNG = "air and a spring x^3"
AGAIN = [name for name in SWEPT if name not in ("motion", "response")]  # an estimate; half a second
SPRINGS = [name for name in AGAIN if SPRUNG in worlds_of(name) and name != "limit-cycle"]  # polynomials alone
SWEPT_CASES = [*((name, "") for name in AGAIN), *((name, SPRUNG) for name in SPRINGS)]


@pytest.mark.parametrize(("name", "world"), SWEPT_CASES)
def test_a_sweep_is_read_in_each_of_its_formats_and_a_changed_digit_is_found(name, world, capsys, tmp_path):
    said = {}
    for suffix, change in CHANGED.items():
        if suffix == "parquet":
            pytest.importorskip("pyarrow", reason="the extra parquet is not installed")
        path = tmp_path / f"swept.{suffix}"
        swept(swept_words(name, tmp_path, world), path)
        found = compared(capsys, path)
        requires_round_trip(found)
        said[suffix] = found["law"], [{**row, "line": 0} for row in found["rows"]]
        assert found["rows"][0]["line"] == (1 if suffix == "parquet" else 2)  # it has rows, and no lines
        requires_near_miss(capsys, path, found, change)
    assert said["csv"] == said["json"] == said["parquet"]


def test_a_swept_motion_is_an_estimate_and_stands_beside_the_certified_motion(capsys, tmp_path):
    path = tmp_path / "swept.csv"
    swept(["motion", "--law", "2:1/10,1/5", "--time", "3"], path)
    found = compared(capsys, path)
    assert {row["column"] for row in found["rows"]} == {"x", "v"} and found["method"].startswith("the certified motion")
    assert all(3 < float(row["digits"]) < 6 for row in found["rows"])  # an expansion of order 3, not itself again


def test_a_failed_point_is_no_value_and_lines_are_those_of_a_file_that_was_written_anew(capsys, tmp_path):
    path = tmp_path / "swept.json"
    swept(["turning-points", "--alpha", "2", "--epsilon", "1/10,-1/10", "--count", "2"], path)
    found = compared(capsys, path)
    assert found["summary"]["estimates"] == [3] and {row["line"] for row in found["rows"]} == {2}
    path.write_text(json.dumps(json.loads(path.read_text()), indent=1))
    lines, found = path.read_text().splitlines(), compared(capsys, path)
    assert found["rows"] and all('"point"' in lines[row["line"]] for row in found["rows"])


def OVER():
    return LimitError("max_seconds", "60 s are over at a step", "a larger limit")


@pytest.mark.parametrize("error", [OVER, KeyboardInterrupt])
@pytest.mark.parametrize("suffix", ["csv", "json", "envelope"])
def test_the_rows_that_are_done_are_kept(capsys, tmp_path, monkeypatch, suffix, error):
    path = tmp_path / f"exported.{suffix}"
    place = "curves.large.SpringEnvelope.amplitude" if suffix == "envelope" else "ask.again.answered"
    if suffix == "envelope":
        assert main([*line_of("envelope", tmp_path, SPRUNG, ["--points=5"])[:-1], "--csv", str(path)]) == 0
    else:
        swept(["moment", "--p", "0:5:1", "--digits", "20"], path)
    stop_at(monkeypatch, f"asymptotics.{place}", 4, error)
    found = compared(capsys, path, 2 if error is OVER else 130)
    assert sorted({row["line"] for row in found["rows"]}) == [2, 3, 4] and found["missing"] == "lines 5 ... 7 (3 rows)"
    assert found["summary"]["look"]["kind"] == "undecided" and "order" not in found["summary"]


@pytest.fixture
def path(tmp_path):
    return tmp_path / "exported.csv"


def exported(path, line):
    assert main([*line.split(), "--csv", str(path)]) == 0


def refused(capsys, path, *more):
    capsys.readouterr()
    assert main(["compare", str(path), *more]) == 2
    return capsys.readouterr().err


def test_rows_missing_doubled_and_shuffled_are_counted_and_a_foreign_row_is_refused(capsys, path):
    exported(path, "turning-points --alpha=2 --epsilon=1/10 --v0=1/2 --count=4")
    head, one, two, _, four = path.read_text().splitlines()
    path.write_text("\n".join([head, two, one, four, four]) + "\n")
    assert compared(capsys, path)["summary"]["order"] == {"missing": 1, "doubled": 1, "shuffled": 1}
    path.write_text("\n".join([head, one, "9" + two[1:]]) + "\n")
    assert "line 3: its request has no row 9" in refused(capsys, path)
    assert "--columns" in refused(capsys, path, "--columns", "n,x")


TABLE = "A,zeta\n0.1,0.0120\n0.2,0.0141\n0.4,0.0178\n0.8,0.0261\n"
FITTED = {  # a table of damping, and what is asked of it
    "resolution": (TABLE, "--resolution 0.0002 --laws 1 2 1+2"),
    "every law": (TABLE, ""),
    "a pendulum in SI, deg": (
        TABLE.replace("A,", "A [deg],").replace("0.1,", "5,").replace("0.2,", "10,"),
        "--resolution 1/5000 --spring pendulum --mass 2 --stiffness 3 --laws 1+2 3/2",
    ),
    "Q with resolutions": (
        "A,Q,resolution\n0.1,41.7,0.5\n0.2,35.5,0.5\n0.4,28.1,0.4\n0.8,19.2,0.3\n",
        "--spring 3:1/5 --laws 0+1 1+2",
    ),
}


@pytest.mark.parametrize("name", FITTED)
def test_a_law_is_fitted_again_from_the_table_in_its_header_and_a_changed_digit_is_found(capsys, path, name):
    table, asked = path.with_name("table.csv"), FITTED[name]
    table.write_text(asked[0])
    exported(path, f"damping --from {table} {asked[1]}")
    table.unlink()  # the header holds its numbers
    found = compared(capsys, path)
    assert found["certified"] is False and "in doubles" in found["method"] and "differs" not in found["summary"]
    assert all(float(row["digits"]) > 12 or float(row["given"]) == 0 for row in found["rows"])
    one = next(row for row in found["rows"] if row["column"] == "strength")
    changed(path, one["line"], "strength", lambda cell: cell[:5] + str((int(cell[5]) + 3) % 10) + cell[6:])
    wrong = compared(capsys, path)["rows"]
    assert [(r["line"], r["column"]) for r in wrong if 0 < float(r["digits"]) < 6] == [(one["line"], "strength")]
    changed(path, 2, "law", lambda cell: "3")
    assert "line 2: its request has no row 3" in refused(capsys, path)


WORDS = {  # a request; one of its words, another one, and what is told
    "limit-cycle --law=1:-1 --law=1,2:1 --order=2": ("-2*pi", "-3*pi", "'-3*pi' is given, and '-2*pi' is right"),
    "envelope --law=0:1/20 --time=40 --points=4": (",nan,", ",0.5,", "line 6, phase: '0.5' is given, and 'nan' is"),
    "damping --from {table} --laws 1 2": (",consistent,", ",certain,", "'certain' is given, and 'consistent' is right"),
}


@pytest.mark.parametrize("line", WORDS)
def test_a_changed_word_is_told(capsys, path, line):
    (table := path.with_name("table.csv")).write_text(TABLE)
    exported(path, line.format(table=table))
    one, other, told = WORDS[line]
    assert "differs" not in compared(capsys, path)["summary"]
    path.write_text(path.read_text().replace(one, other))
    assert any(told in text for text in compared(capsys, path)["summary"]["differs"])


def test_a_series_with_its_bound_stands_beside_the_motion_itself(capsys, path):
    exported(path, "damping --alpha=2 --epsilon=1/10 --amplitudes=1/4 --order=2")
    found = compared(capsys, path)
    own = {r["column"]: r["certified"] for r in found["rows"] if r["part"] == "the motion itself"}
    series = {r["column"]: r for r in found["rows"] if r["part"].startswith("order 2")}
    assert series and all(row["certified"] == own[name] for name, row in series.items())
    assert "bound of zeta log" in found["summary"]["not_compared"]


def test_what_no_route_certifies_and_what_was_not_asked_for_is_refused(capsys, path):
    exported(path, "envelope --alpha=2 --epsilon=1/10 --time=3 --points=3 --order=3")
    assert "no route certifies an envelope of higher order" in refused(capsys, path)
    exported(path, "envelope --alpha=2 --epsilon=1/10 --time=3 --points=3")
    changed(path, 4, "tau", lambda cell: "9" + cell)
    assert "line 4: its request has no row" in refused(capsys, path)
