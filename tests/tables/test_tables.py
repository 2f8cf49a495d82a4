"""What holds of every table: formats that lose nothing, provenance, roundings, refusals."""

import csv
import io
import json
import re
import shutil
import subprocess
import sys
from dataclasses import replace
from fractions import Fraction
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from jsonschema import Draft202012Validator

import asymptotics.tables
from asymptotics.errors import InputError, UndecidedError
from asymptotics.numbers.decimals import rational_decimal
from asymptotics.numbers.rounding import MODES, half_unit, rounded_decimal, rounded_rational
from asymptotics.tables.cells import Nearest, round_rows
from asymptotics.tables.certified import CLAIMS
from asymptotics.tables.inputs import Inputs
from asymptotics.tables.provenance import checksum
from asymptotics.tables.registry import build, description, names
from asymptotics.tables.standard_set import standard_set

# Table I as printed (six digits).  The paper's last digits of S_3 and S_5 differ: 0.133834, 0.141589.
TABLE_1 = [("0", "1.00000"), ("0.0987650", "-0.410720"), ("0.123863", "0.263568"), ("0.133833", "-0.194566"),
           ("0.138780", "0.154318"), ("0.141588", "-0.127908")]  # fmt: skip
SCHEMA = json.loads((Path(asymptotics.tables.__file__).parent / "schema.json").read_text())
SLOW = {"turning-points", "half-periods", "normal-form", "half-swing", "error-bounds"}
FEWER = {
    **dict.fromkeys(("error-bounds", "half-periods", "stokes.constants"), Inputs.of(alphas=["2"])),
    "turning-points": Inputs.of(alphas=["1/2", "2"]),
}
CHEAP = [name for name in names() if name not in SLOW]


@pytest.fixture(scope="module")
def tables():
    return {name: build(name, 8, FEWER.get(name)) for name in names()}


def test_table_1_to_six_digits():
    assert [row[1:] for row in build("smith2012.table1", 6).rows] == TABLE_1


def test_more_digits_extend_the_fewer():
    few, many = build("smith2012.table1", 8), build("smith2012.table1", 300)
    for a, b in zip(few.rows[1:], many.rows[1:]):
        assert all(abs(float(x) - float(y)) < 1e-8 for x, y in zip(a, b))
        assert len(b[1]) >= 300


def test_every_table_has_its_description_its_provenance_and_every_format(tables):
    schema = Draft202012Validator(SCHEMA)
    for name, table in tables.items():
        assert all(len(row) == len(table.columns) == len(table.units) for row in table.rows)
        assert set(table.keys) <= set(table.columns)
        assert list(csv.reader(io.StringIO(table.to_csv())))[1:] == [list(row) for row in table.rows]
        assert table.to_latex().count(r"\\") >= len(table.rows) + 1
        assert table._repr_latex_().startswith("$")
        schema.validate(json.loads(table.to_json()))
        assert table.provenance["sha256"] == checksum(table.columns, json.loads(table.to_json())["rows"])
        places = [table.columns.index(key) for key in table.keys]
        assert len({tuple(row[place] for place in places) for row in table.rows}) == len(table.rows)
        found = description(name)
        assert all(found[part] for part in ("title", "columns", "source", "check", "cost"))


def test_a_csv_file_carries_its_checksum(tables):
    lines = tables["moments"].to_csv_file().splitlines()
    stated = next(line.split()[-1] for line in lines if line.startswith("# sha256"))
    rows = list(csv.reader(line for line in lines if not line.startswith("#")))
    assert checksum(rows[0], rows[1:]) == stated
    rows[1][1] = rows[1][1][:-1] + "1"
    assert checksum(rows[0], rows[1:]) != stated


def test_parquet_keeps_strings_and_provenance(tables):
    parquet = pytest.importorskip("pyarrow.parquet", reason="the extra parquet is not installed")
    found = parquet.read_table(io.BytesIO(tables["two-law-times"].to_parquet()))
    assert [tuple(row.values()) for row in found.to_pylist()] == [tuple(row) for row in tables["two-law-times"].rows]
    assert json.loads(found.schema.metadata[b"provenance"]) == tables["two-law-times"].provenance


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="pdflatex is not installed")
def test_latex_tables_compile(tables, tmp_path):
    bodies = "\n\n".join(r"\resizebox{\textwidth}{!}{%" + "\n" + t.to_latex() + "%\n}" for t in tables.values())
    head = r"\documentclass{article}\usepackage{graphicx}\usepackage{amsmath}\begin{document}"
    (tmp_path / "all.tex").write_text(f"{head}\n{bodies}\n" + r"\end{document}")
    command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "all.tex"]
    done = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, done.stdout[-2000:]


def test_latex_has_nothing_that_tex_would_trip_over(tables):
    """Without TeX: braces balance, and outside of math every special character is escaped."""
    for table in tables.values():
        lines = [line for line in table.to_latex().splitlines() if not line.startswith("%")]
        for line in lines:
            assert line.count("{") - line.count(r"\{") == line.count("}") - line.count(r"\}")
            assert line.count("$") % 2 == 0
            text = re.sub(r"\$[^$]*\$|\\[a-zA-Z]+|\\.", "", line)
            assert not set(text) & set("_^#%~"), line


def test_the_word_certified_is_computed(monkeypatch):
    assert build("half-periods", 8, Inputs.of(alphas=["2"])).certified
    from asymptotics.tables import turning  # noqa: PLC0415  (the module, under its own name)

    real = turning.turning_points

    def doubtful(*args, **more):
        found = real(*args, **more)
        return replace(found, points=tuple(replace(p, certified=False) for p in found.points))

    monkeypatch.setattr(turning, "turning_points", doubtful)
    table = build("half-periods", 8, Inputs.of(alphas=["2"]))
    assert not table.certified
    assert not table.provenance["certified"]
    assert {row[table.columns.index("certified")] for row in table.rows} == {"false"}


@pytest.mark.parametrize("mode", MODES)
@pytest.mark.parametrize("name", CHEAP)
def test_roundings_enclose_the_nearest_value_of_many_more_digits(name, mode):
    near, fine = build(name, 9, rounding=mode), build(name, 40)
    for row, exact in zip(near.rows, fine.rows):
        for text, value in zip(row, exact):
            if text == value or not re.match(r"-?[\d.]+(e-?\d+)?\Z", value):
                continue
            v = Fraction(value)
            low, high = (Fraction(part) for part in (text.strip("[]").split(", ") * 2)[:2])
            unit = abs(v) / 10**7
            assert abs(low - v) <= unit
            assert {"nearest": True, "down": abs(low) <= abs(v), "up": abs(low) >= abs(v), "floor": low <= v,
                    "ceil": low >= v, "interval": low <= v <= high}[mode]  # fmt: skip


@given(st.fractions(), st.integers(1, 20))
def test_directed_roundings_are_the_tightest_decimals(q, digits):
    floor, ceil = (Fraction(rounded_rational(q, digits, mode)) for mode in ("floor", "ceil"))
    assert floor <= q <= ceil
    if floor != ceil:
        assert rational_decimal((floor + ceil) / 2, digits) in {rational_decimal(v, digits) for v in (floor, ceil)}
        assert Fraction(rounded_rational(q, digits, "down")) == (floor if q > 0 else ceil)
        assert Fraction(rounded_rational(q, digits, "up")) == (ceil if q > 0 else floor)
    else:
        assert floor == q


@given(st.fractions(min_value=-1000, max_value=1000), st.integers(1, 12), st.sampled_from(MODES))
def test_a_decimal_decides_only_what_it_proves(q, digits, mode):
    shown = rational_decimal(q, digits + 6)
    found = rounded_decimal(shown, digits, mode)
    half = half_unit(shown) if q else 0
    ends = {rounded_rational(Fraction(shown) + s * half, digits, mode) for s in (-1, 1)}
    assert found == (rounded_rational(q, digits, mode) if len(ends) == 1 else None)


def test_a_value_at_a_decimal_is_never_guessed():
    with pytest.raises(UndecidedError, match="too near"):
        round_rows(lambda digits: [(Nearest("0.5" + "0" * (digits - 1)),)], 3, "floor")


@pytest.mark.parametrize(
    ("name", "digits", "inputs", "rounding"),
    [
        ("nope", 5, {}, "nearest"),
        ("smith2012.table1", 0, {}, "nearest"),
        ("smith2012.table1", 10_001, {}, "nearest"),
        ("smith2012.table1", 5, {"alphas": ["2"]}, "nearest"),
        ("smith2012.table1", 5, {}, "sideways"),
        ("moments", 5, {"rows": 3}, "nearest"),
        ("extinction-times", 5, {"alphas": ["1"]}, "nearest"),
        ("phase-lags", 5, {"alphas": ["1"]}, "nearest"),
        ("smith2012.c", 5, {"rows": 100_000}, "nearest"),
    ],
)
def test_bad_requests_are_refused(name, digits, inputs, rounding):
    with pytest.raises(InputError):
        build(name, digits, Inputs.of(**inputs), rounding)


BAD = [{"alphas": ["-1"]}, {"alphas": ["a"]}, {"epsilons": ["0"]}, {"rows": 0}, {"rows": 10**6}]


@pytest.mark.parametrize("bad", BAD)
def test_bad_inputs_are_refused(bad):
    with pytest.raises(InputError):
        Inputs.of(**bad)


def test_an_empty_pause_of_motion_is_said_and_not_left_out():
    table = build("turning-points", 6, Inputs.of(alphas=["1/2"], epsilons=["1"], rows=4))
    assert [row[table.columns.index("ended")] for row in table.rows] == ["creeps"]


def test_the_standard_set_is_written_whole(tables, tmp_path, monkeypatch):
    monkeypatch.setattr("asymptotics.tables.standard_set.names", lambda: dict.fromkeys(CHEAP, ""))
    monkeypatch.setattr("asymptotics.tables.standard_set.build", lambda name, digits: tables[name])
    made = standard_set(tmp_path / "tables", 8)
    proved = sorted(path.name for path in (tmp_path / "tables").glob("*.certificate.json"))
    assert proved == sorted(f"{t.name}.certificate.json" for t in made if t.name in CLAIMS) != []
    for name in proved:
        ran = [sys.executable, "-I", "-S", "check_certificate.py", name]
        told = subprocess.run(ran, cwd=tmp_path / "tables", capture_output=True, text=True)
        assert told.stdout.startswith("accepted\n"), name
        assert f"]({name})" in (tmp_path / "tables" / "index.md").read_text()
    assert len(list((tmp_path / "tables").iterdir())) == 3 * len(made) + len(proved) + 2
    monkeypatch.setattr("asymptotics.tables.standard_set.build", lambda name, n: build(name, n, FEWER.get(name)))
    again = standard_set(tmp_path / "again", 8)
    for path in (tmp_path / "tables").iterdir():
        assert path.read_bytes() == (tmp_path / "again" / path.name).read_bytes()
    assert [t.rows for t in again] == [t.rows for t in made]
