"""Files in the layouts of common exporters, written here from the descriptions of their formats: the right numbers.

Every layout holds the same motion, x = exp(-t/20) cos 3t, and each must be read as that, with its unit, and told.
"""

import gzip
import io
import struct
import zipfile
from itertools import product

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.records.sources import How
from asymptotics.decays.records.table import read_table
from asymptotics.errors import InputError, LimitError

T = np.arange(0, 12, 0.02)
X = np.exp(-T / 20) * np.cos(3 * T)


def rows(separator, mark=".", form="{:.6f}", end="", extra=()):
    """The motion as lines of text, with constant cells behind."""
    lines = []
    for t, x in zip(T, X):
        cells = [form.format(t), form.format(x), *extra]
        lines.append(separator.join(c.replace(".", mark) if c not in extra else c for c in cells) + end)
    return "\n".join(lines) + "\n"


LABVIEW = """LabVIEW Measurement\t
Writer_Version\t2
Reader_Version\t2
Separator\tTab
Decimal_Separator\t.
Date\t2024/03/01
Time\t11:02:03.5
***End_of_Header***\t

Channels\t1
Samples\t600
X_Dimension\tTime
***End_of_Header***
X_Value\tAngle (rad)\tComment
"""
CASSY = """MIN=0\tMAX=12
SCALE=1
DEC=6
DEF="t / s"\t"phi / rad"
t / s\tphi / rad
"""
MOKU = """% Moku:Go Data Logger
% Acquired 2024-03-01 T 11:02:03 +0000
% Time (s), Input 1 Displacement (mm)
"""
OPENFAST = """
Predictions were generated on 01-Mar-2024 with a program in the layout of its text tables.

Description from the input file: free decay

Time\tRoll\tWave1Elev
(s)\t(deg)\t(m)
"""
ORCAFLEX = """OrcaFlex 11.4a
Period: Whole simulation

Time\tRotation 1
(s)\t(deg)
"""
LAYOUTS = {  # name: (text, unit, options)
    "phyphox csv": ('"Time (s)","Angle (rad)"\n' + rows(",", form="{:.9E}"), "rad", {}),
    "phyphox csv, decimal comma": ('"Time (s)";"Angle (\u00b0)"\n' + rows(";", ",", "{:.9E}"), "deg", {}),
    "Tracker": ("mass A\t\t\nt\tx\ty\n" + rows("\t", form="{:.3E}", extra=("1.0",)), "", {"columns": "t=t,x=x"}),
    "Tracker, several points": (
        "\tmass_A\t\nt\tx\tx\n" + rows("\t", form="{:.5E}", extra=("2.0",)),
        "",
        {"columns": "t=1,x=2"},
    ),
    "Vernier": ("Latest: Time (s),Latest: Position (m)\n" + rows(","), "m", {}),
    "Logger Pro text": (
        "Vernier Format 2\nUntitled 3/1/2024 11:02:03 .\nRun 1\nTime\tPosition\nt\tx\ns\tm\n\n" + rows("\t"),
        "m",
        {},
    ),
    "PASCO": ('Time (s) Run #1,"Angle (rad) Run #1"\n' + rows(","), "rad", {}),
    "PASCO, semicolons": ('"Zeit (s) Lauf #1";"Winkel (rad) Lauf #1"\n' + rows(";", ","), "rad", {}),
    "CASSY": (CASSY + rows("\t"), "rad", {}),
    "LabVIEW lvm": (LABVIEW + rows("\t"), "rad", {}),
    "LabVIEW lvm without times": (
        LABVIEW.replace("X_Dimension", "X0\t0.0000000000000000E+0\nDelta_X\t0.020000\nX_Dimension").replace(
            "Separator\tTab", "Separator\tTab\nX_Columns\tNo"
        )
        + "".join(f"\t{x:.6f}\n" for x in X),
        "rad",
        {},
    ),
    "OpenFAST": (OPENFAST + rows("\t", extra=("0.0",)), "deg", {"columns": "t=Time,x=Roll"}),
    "OrcaFlex": (ORCAFLEX + rows("\t"), "deg", {}),
    "OrcaFlex, spreadsheet": ('"Time (s)","Vessel1 Rotation 1 (deg)"\n' + rows(","), "deg", {}),
    "CASSY Lab 2": ("CASSY Lab 2\nt / s;alpha / \u00b0\n" + rows(";", ","), "deg", {}),
    "Tracker, two points beside each other": (
        "multi:,,,,,\nmass_A,,,mass_B,,\nt,x,y,t,x,y\n" + rows(",", extra=("0.1", "0.0", "0.3", "0.4")),
        "",
        {"columns": "t=1,x=2"},
    ),
    "x before t": ("x (m),t (s)\n" + "".join(f"{x:.6f},{t:.6f}\n" for t, x in zip(T, X)), "m", {}),
    "comments of MATLAB": ("% made today\n% t x\n" + rows(" "), "", {}),
    "aligned columns": ("  Time (s)   Roll (deg)\n" + rows("   "), "deg", {}),
    "Moku": (MOKU + rows(", "), "mm", {}),
    "numpy.savetxt": ("# t x\n" + rows(" ", form="{:.18e}"), "", {}),
    "no names": (rows(" "), "", {}),
    "Excel's German CSV": ("sep=;\nZeit t / s;Weg x / cm\n" + rows(";", ","), "cm", {}),
    "quoted decimal commas": (
        '"t / s","x / cm"\n' + rows('","', ",").replace("\n", '"\n"')[:-1].join(['"', ""]),
        "cm",
        {},
    ),
    "pipes": ("| t (s) | x (m) |\n" + "".join(f"| {t:.6f} | {x:.6f} |\n" for t, x in zip(T, X)), "m", {}),
    "Fortran": ("t x\n" + rows("  ", form="{:.6E}").replace("E", "D"), "", {}),
    "a comma behind each row": ("t,x,\n" + rows(",", end=","), "", {}),
}


def check(table, tolerance=2e-3):
    assert table.kind == "record"
    np.testing.assert_allclose(table.columns["t"], T, atol=tolerance)
    np.testing.assert_allclose(table.columns["x"], X, atol=tolerance)
    assert table.notes[0].startswith("time: ")


WRITTEN = [("utf-8", "\n"), ("utf-16", "\r\n")]
ENCODINGS = ("utf-8", "utf-8-sig", "utf-16", "latin-1")
WRITTEN += [
    pytest.param(*pair, marks=pytest.mark.slow) for pair in product(ENCODINGS, ("\n", "\r\n")) if pair not in WRITTEN
]


@pytest.mark.parametrize("name", LAYOUTS)
@pytest.mark.parametrize(("encoding", "ends"), WRITTEN)
def test_the_layouts_of_exporters_are_read_in_every_encoding(name, encoding, ends, tmp_path):
    text, unit, options = LAYOUTS[name]
    path = tmp_path / "record.txt"
    path.write_bytes(text.replace("\n", ends).encode(encoding))
    table = read_table(path, how=How(**options))
    check(table)
    assert table.unit == unit


def test_packed_files_open_files_frames_and_arrays_are_read(tmp_path):
    text = LAYOUTS["Vernier"][0].encode()
    (tmp_path / "a.csv.gz").write_bytes(gzip.compress(text))
    with zipfile.ZipFile(tmp_path / "a.zip", "w") as archive:
        archive.writestr("Raw Data.csv", text)
        archive.writestr("meta/device.csv", "property,value\n")
    np.savez(tmp_path / "a.npz", t=T, theta=X)
    np.save(tmp_path / "a.npy", np.column_stack([T, X]))
    from scipy.io import savemat  # noqa: PLC0415

    savemat(tmp_path / "a.mat", {"t": T, "x": X})
    import pandas  # noqa: PLC0415

    frame = pandas.DataFrame({"time": T, "x": X})
    frame.to_parquet(tmp_path / "a.parquet")
    for name in ("a.csv.gz", "a.zip", "a.npz", "a.npy", "a.mat", "a.parquet"):
        check(read_table(tmp_path / name), 1e-6)
    for source in (frame, {"t": T, "x": X}, io.StringIO(text.decode()), io.BytesIO(text)):
        check(read_table(source), 1e-6)
    assert asy.identify((T, X), laws=["1"]).law("1").law.epsilon[0].estimate == pytest.approx(1 / 30, rel=1e-3)


def test_spreadsheets_are_read_and_several_sheets_are_asked_for(tmp_path):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("openpyxl")
    frame = pandas.DataFrame({"Time (s)": T, "Angle (rad)": X})
    frame.to_excel(tmp_path / "one.xlsx", index=False)
    check(read_table(tmp_path / "one.xlsx"), 1e-9)
    with pandas.ExcelWriter(tmp_path / "two.xlsx") as book:
        frame.to_excel(book, sheet_name="run 1", index=False)
        frame.to_excel(book, sheet_name="run 2", index=False)
    with pytest.raises(InputError, match="2 sheets with numbers: run 1, run 2 .*--sheet NAME"):
        read_table(tmp_path / "two.xlsx")
    check(read_table(tmp_path / "two.xlsx", how=How(sheet="run 2")), 1e-9)


def biff2(header, columns):
    """An .xls workbook of one sheet in the oldest of its formats: BOF, a LABEL for each name, NUMBERs, EOF."""
    record = lambda kind, body: struct.pack("<HH", kind, len(body)) + body  # noqa: E731
    cells = [record(4, struct.pack("<HH3xB", 0, j, len(n)) + n.encode("latin-1")) for j, n in enumerate(header)]
    cells += [
        record(3, struct.pack("<HH3xd", i, j, v)) for i, row in enumerate(zip(*columns), 1) for j, v in enumerate(row)
    ]
    return b"".join([record(9, struct.pack("<HH", 7, 16)), *cells, record(10, b"")])


@pytest.mark.filterwarnings("ignore:The xlrd engine is deprecated")  # of pandas 3: pandas 4 will want calamine
def test_old_spreadsheets_as_phyphox_writes_them_are_read(tmp_path):
    pytest.importorskip("xlrd")
    path = tmp_path / "phone.xls"
    path.write_bytes(biff2(["Time (s)", "Angle (rad)"], [T, X]))
    table = read_table(path)
    check(table, 1e-12)
    assert table.unit == "rad"


@pytest.mark.parametrize("unit", ["V", "%", "counts"])
def test_units_of_nothing_are_taken_as_they_are_and_told(unit, tmp_path):
    path = tmp_path / "a.csv"
    path.write_text(f"t (s),x ({unit})\n" + rows(","))
    table = read_table(path)
    check(table)
    assert table.unit == "" and f"strengths refer to 1 {unit}" in table.notes[1]


def test_a_footer_is_left_out_and_told_and_of_two_clocks_the_one_with_a_unit_is_taken(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("t,x\n" + rows(",") + "end of measurement\nmean: 0.01\n")
    table = read_table(path)
    check(table)
    assert table.notes[1].startswith("2 rows that cannot be read left out, the first is row 602: 'end of measurement'")
    days = "".join(f"2024-03-01 11:02:{t:06.3f},{t:.3f},{x:.6f}\n" for t, x in zip(T, X))
    path.write_text("Date and Time,Time (s) Run #1,Angle (deg) Run #1\n" + days)
    table = read_table(path)
    check(table)
    assert "of 'Date and Time', 'Time (s) Run #1', which tell one time" in table.notes[0]
    check(read_table(path, how=How(columns="t=2,x=3")))
    # Two that do not run alike are asked for.
    days = "".join(f"2024-03-01 11:02:{t:06.3f},{abs(t - 6):.3f},{x:.6f}\n" for t, x in zip(T, X))
    path.write_text("Date and Time,Time (s) Run #1,Angle (deg) Run #1\n" + days)
    with pytest.raises(InputError, match=r"t may be any of 'Date and Time', 'Time \(s\) Run #1' .*--columns t=1,x=3"):
        read_table(path)


def test_dates_and_times_of_day_are_times(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("timestamp;x\n2024-03-01 23:59:59.5;1,5\n2024-03-02 00:00:00.25;2,5\n2024-03-02 00:00:01;0,5\n")
    assert np.diff(read_table(path).columns["t"]) == pytest.approx([0.75, 0.75])
    path.write_text("time,x\n10:00:00.5,1.5\n10:00:01.5,2.5\n10:01:00,0.5\n")
    assert np.diff(read_table(path).columns["t"]) == pytest.approx([1, 58.5])


def test_what_is_measured_is_found_or_asked_for(tmp_path):
    path = tmp_path / "gyro.csv"
    names = "Time (s),Gyroscope x (rad/s),Gyroscope y (rad/s)"
    v = -3 * np.exp(-T / 20) * np.sin(3 * T) - X / 20
    path.write_text(names + "\n" + "".join(f"{t:.6f},{a:.9f},{0.8 * a:.9f}\n" for t, a in zip(T, v)))
    # Both axes carry the swing; beside one that is constant it is not asked (``test_main_axis``).
    with pytest.raises(InputError, match=r"v may be any of 'Gyroscope x \(rad/s\)', 'Gyroscope y .*columns t=1,v=2"):
        asy.identify(path, laws=["1"])
    answer = asy.identify(path, laws=["1"], columns="t=Time,v=Gyroscope x")
    assert answer.units.unit == "rad"
    assert answer.law("1").law.epsilon[0].estimate == pytest.approx(1 / 30, rel=2e-3)
    assert any("samples of the velocity fitted" in note for note in answer.notes)


def test_a_clock_that_starts_again_begins_a_run_and_a_reversed_one_is_turned(tmp_path):
    path = tmp_path / "two.csv"
    text = rows(",")
    path.write_text("t,x\n" + text + text)
    answer = asy.identify(path, laws=["1"])
    assert len(answer.per_run) == 2
    path.write_text("t,x\n" + "\n".join(reversed(text.splitlines())))
    answer = asy.identify(path, laws=["1"])
    assert any("time runs backwards" in note for note in answer.notes)
    assert answer.law("1").law.epsilon[0].estimate == pytest.approx(1 / 30, rel=1e-3)


def test_a_labview_file_whose_header_has_no_step_of_time_is_refused(tmp_path):
    text = LAYOUTS["LabVIEW lvm without times"][0]
    for fault in (text.replace("Delta_X", "Delta"), text.replace("0.020000\nX_Dim", "soon\nX_Dim")):
        (tmp_path / "a.lvm").write_text(fault)
        with pytest.raises(InputError, match="one column, .*--rate HZ"):
            read_table(tmp_path / "a.lvm")


def test_x_alone_leaves_the_kind_to_the_other_columns(tmp_path):
    rows = "\n".join(f"{t:.6f},{x:.6f},{2 * x:.6f}" for t, x in zip(T, X))
    (tmp_path / "a.csv").write_text(f"t,x,y\n{rows}")
    found = read_table(tmp_path / "a.csv", how=How(columns="x=3"))
    assert found.kind == "record" and found.columns["x"] == pytest.approx(2 * X, abs=2e-6)
    (tmp_path / "b.csv").write_text("n,t,x\n" + "\n".join(f"{n},{3 * n},{(-0.9) ** n}" for n in range(9)))
    assert read_table(tmp_path / "b.csv", how=How(columns="x=3")).kind == "turning-points"


def test_what_a_gzip_stream_gives_is_limited(tmp_path, monkeypatch):
    text = LAYOUTS["Vernier"][0].encode()
    (tmp_path / "a.csv.gz").write_bytes(gzip.compress(text))
    monkeypatch.setattr("asymptotics.decays.records.text.MAX_BYTES", len(text))
    check(read_table(tmp_path / "a.csv.gz"), 1e-6)
    monkeypatch.setattr("asymptotics.decays.records.text.MAX_BYTES", len(text) - 1)
    with pytest.raises(LimitError, match="unpacks to more than"):
        read_table(tmp_path / "a.csv.gz")
