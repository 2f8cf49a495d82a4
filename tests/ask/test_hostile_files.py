"""Files that name a request, and mean harm: refused by name in one line, nothing run, read or written besides."""

import csv
import io
import json
import shlex

import pytest

from asymptotics.ask.registry import ANSWERING, loaded
from asymptotics.shell.main import main
from tests.each import each
from tests.every_question import example

ASKED = [name for name in ANSWERING if loaded(name).in_header and name != "damping-law"]
STRAY = ("--csv=/etc/motd", "--plot=a.svg", "--html=a.html", "--from=/etc/passwd", "--help", "--no-such=1",
         "more words", "--json", "--quiet=1", "--max-seconds=9")  # fmt: skip
HARM = ("__import__('os')", "1e400x", "os.system", "")
HEADERS = {
    "identify /etc/passwd": "identify",
    "os.system ls": "os.system",
    "compare a.csv --alpha=2": "compare",
    "sweep identify k": "identify",
    "sweep stokes csv": "csv",
    "sweep stokes list": "list",
    "envelope --law=2:1/10": "--time",
    "envelope --law=2:1/10 --time=3 --slow=1/10": "--slow=1/10",
    "envelope --law=2:1/10 --time=3 --points=1000000000": "--points",
    "envelope --law=2:1/10 --time=3 --squaring=1": "--squaring=1",
    "damping-law --from=/etc/passwd": "--from=/etc/passwd",
    "damping-law --A=1,2,3 --zeta=1,2,3 --csv=/etc/motd": "--csv=/etc/motd",
    "damping-law --A=__import__('os'),2 --zeta=1,2": "__import__",
    "damping-law --A=1,2,3 --zeta=0.1,0.2,0.3 --laws=__import__": "__import__",
    "damping-law --A=1,2,3 --zeta=0.1,0.2,0.3 --laws=1 --spring=os.system": "os.system",
    "damping-law --A=1,2,3 --A=1,2,3 --zeta=0.1,0.2,0.3": "--A twice",
    "damping-law --A=1e400,2,3 --zeta=0.1,0.2,0.3 --laws=1": "not positive",
    "damping-law --zeta=0.1,0.2,0.3 --laws=1": "no column A",
    "damping-law --A=1,2,3 --zeta=0.1,0.2 --laws=1": "differ in length",
}


def refused(capsys, path):
    """One line; and no file besides."""
    capsys.readouterr()
    assert main(["compare", str(path)]) == 2
    out, err = capsys.readouterr()
    assert out == "" and err.count("\n") == 1 and len(err) < 900
    assert [p.name for p in path.parent.iterdir()] == [path.name]
    return err


def stated(path, request, columns=("k", "c_k", "csv", "list"), row="1,0.5,1,2"):
    """A file whose header says a request."""
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerow([*columns, f"code [{request}]"])
    path.write_text(text.getvalue() + row + ",a\n")


@each("header", HEADERS)
def test_a_hostile_header_is_refused_by_name(header, capsys, tmp_path):
    stated(path := tmp_path / "bad.csv", header)
    if header.startswith("damping-law"):
        columns = ("law", "grade", "alpha", "low", "strength", "high")
        stated(path, header, columns, "1,consistent,1,1,1,1")
    assert HEADERS[header] in refused(capsys, path)


@pytest.mark.parametrize("name", ASKED)
def test_no_other_word_of_a_header_is_heard(name, capsys, tmp_path):
    words, question, path = example(name, tmp_path), loaded(name), tmp_path / "bad.csv"
    flags = [o for o in question.header_options if o.letter and not o.place]
    heard = {f"--{option.name}" for option in flags}
    given = [f"{w}={v}" for w, v in zip(words, words[1:]) if w in heard]
    told = [name, *(w for w in words[1:2] if not w.startswith("--")), *given]
    for stray in STRAY:
        stated(path, shlex.join([*told, *stray.split()]))
        err = refused(capsys, path)
        assert stray.split()[0] in err or "more" in err, stray
    for option in flags:
        rest = [w for w in told if not w.startswith(f"--{option.name}=")]
        for harm in HARM:
            stated(path, shlex.join([*rest, f"--{option.name}={harm}"]))
            assert "argument " in refused(capsys, path)
    once = next(w for w in given if not w.startswith("--law"))
    stated(path, shlex.join([*told, once]))
    assert f"{once.partition('=')[0]} twice" in refused(capsys, path)


HEAD = '{"command": "moment", "rows": ['
JSON = {
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


@each("text", JSON)
def test_what_is_no_export_is_refused_by_name(text, capsys, tmp_path):
    path = tmp_path / "bad.json"
    path.write_text(text)
    assert JSON[text] in refused(capsys, path)


PARQUET = (
    ({}, "1", "does not name the request"),
    ({"request": "[1"}, "1", "does not name the request"),
    ({"request": ["turning-points", "--csv=/etc/motd"]}, "1", "no request of a sweep"),
    ({"request": ["sweep"]}, "1", "no request of a sweep"),
    ({"request": ["sweep", "identify", "p"]}, "1", "identify"),
    ({"request": ["sweep", "moment", "csv"]}, "1", "csv"),
    ({"request": ["sweep", "moment", "p"]}, 1, "row 1 has a cell that is no text"),
)


@pytest.mark.parametrize(("metadata", "cell", "named"), PARQUET)
def test_parquet_of_others_is_refused_by_name(metadata, cell, named, capsys, tmp_path):
    arrow = pytest.importorskip("pyarrow", reason="the extra parquet is not installed")
    parquet, path = pytest.importorskip("pyarrow.parquet"), tmp_path / "bad.parquet"
    table = arrow.Table.from_pylist([{"p": cell, "csv": "1", "value": "1" if cell == "1" else 2}])
    said = {name: words if isinstance(words, str) else json.dumps(words) for name, words in metadata.items()}
    parquet.write_table(table.replace_schema_metadata(said), path)
    assert named in refused(capsys, path)
    path.write_bytes(b"PAR1 and nothing more")
    assert "is not Parquet" in refused(capsys, path)
