"""Layouts of real files that were refused or read wrongly: rules, rates, structs, glued headers, bursts, workbooks."""

import io

import numpy as np
import pytest
from scipy.io import savemat

from asymptotics.decays.identification.sources import load
from asymptotics.decays.records import sizes
from asymptotics.decays.records.sources import How
from asymptotics.decays.records.table import read_table
from asymptotics.errors import InputError, LimitError

T = np.arange(0, 12, 0.02)
X = np.exp(-T / 20) * np.cos(3 * T)
LINES = [f"{t:.3f},{x:.6f}" for t, x in zip(T, X)]


def read(text, **how):
    return read_table(io.StringIO(text), how=How(**how))


def check(table, first=0):
    np.testing.assert_allclose(table.columns["t"] - table.columns["t"][0], T[first:] - T[first], atol=1e-9)
    np.testing.assert_allclose(table.columns["x"], X[first:], atol=1e-6)


@pytest.mark.parametrize("rule", ["------", "=====\t====", "|---|---|", "# -------", "+----+-----+"])
def test_a_rule_under_the_header_is_passed(rule):
    table = read("\n".join(["Time (s),Angle (deg)", rule, *LINES]))
    assert table.unit == "deg" and table.columns["t"][1] == 0.02
    check(table)


def test_times_of_day_beside_a_clock_that_stands_still():
    rows = [f"15:50:{t:06.3f}, 812.040, {x:.6f}" for t, x in zip(T, X)]
    check(read("\n".join(["Timestamp, Time_Elapsed(s), Angle(deg)", 40 * "-", *rows])))


@pytest.mark.parametrize(
    "said", ["sample_rate: 50", "# dt = 20 ms", "start, sample_rate, s\n90, 50, 12", "fs [kHz];0,05"]
)
def test_one_column_has_the_clock_that_its_header_says(said):
    table = read("\n".join([said, *(f"{x:.6f}" for x in X)]))
    check(table)
    assert "50 samples a second" in table.notes[1]


def test_one_column_without_a_rate_is_asked_for_it():
    text = "\n".join(f"{x:.6f}".replace(".", ",") for x in X)
    with pytest.raises(InputError, match="one column, 'column 1', and no times .*--rate HZ"):
        read(text)
    check(read(text, rate=50))
    # A rate that is said overrules the times of a file; a rate that is none is refused.
    assert read("\n".join(["t,x", *LINES]), rate=100).columns["t"][1] == 0.01
    for wrong in (0, -1, float("nan"), "fast"):
        with pytest.raises(InputError, match="argument rate"):
            How(rate=wrong)
    # Near miss: a frequency in the header is no rate of samples.
    with pytest.raises(InputError, match="--rate"):
        read("Frequency [Hz]: 50\n" + text)


@pytest.mark.parametrize("glued", ["Time (s),Angle (deg)", "Time (s),Angle (deg),"])
def test_a_header_glued_to_the_first_row_keeps_its_names(glued):
    table = read("\n".join([glued + LINES[0], *LINES[1:]]))
    assert table.unit == "deg"
    check(table, first=1)


def test_structs_of_matlab_are_opened(tmp_path, monkeypatch):
    path = tmp_path / "run.mat"
    savemat(path, {"Fe": {"Out": {"Acc": np.stack([X, 0.1 * X]), "Time": T}, "Note": "a", "Peaks": np.arange(7.0)}})
    table = read_table(path)
    assert table.kind == "acceleration" and "a: 'Acc 1'" in table.notes[0]
    np.testing.assert_allclose(table.columns["a"], X)
    savemat(path, {"run": {"angle": X, "fs": 50.0}})
    check(read_table(path))
    savemat(path, {"run": [{"t": T, "x": X}, {"t": T, "x": 0.9 * X}]})
    with pytest.raises(InputError, match="have a time each"):
        read_table(path)
    # A struct does not say how much it holds: it is counted before it is read.
    savemat(path, {"run": {"x": np.zeros(100_000)}}, do_compression=True)
    monkeypatch.setattr(sizes, "MAX_BYTES", 700_000)
    with pytest.raises(LimitError, match="unpacks to more than"):
        read_table(path)


def test_stamps_of_a_buffer_are_evened_and_told():
    t = np.arange(0, 20, 0.01)
    x = np.exp(-t / 20) * np.cos(3 * t)
    stamps = np.floor(t / 0.1 + 1e-9) * 0.1 + 1e-5 * (np.round(t / 0.01) % 10)
    (seen,) = load({"t": stamps, "x": x})
    assert any("bursts of about 10" in note for note in seen.notes)
    assert np.diff(seen.t) == pytest.approx(np.pi / 3, rel=2e-3)
    # All of a buffer with one stamp: no mean is taken of them.
    (seen,) = load({"t": np.floor(t / 0.1 + 1e-9) * 0.1, "x": x})
    assert np.diff(seen.t) == pytest.approx(np.pi / 3, rel=2e-3)
    # Near miss: a sensor that does sample in bursts shows the values of its stamps.
    (seen,) = load({"t": stamps, "x": np.exp(-stamps / 20) * np.cos(3 * stamps)})
    assert not any("bursts" in note for note in seen.notes)


def test_of_a_workbook_the_sheet_of_samples_is_taken(tmp_path):
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("openpyxl")
    path = tmp_path / "book.xlsx"
    raw, results = pandas.DataFrame({"t (s)": T, "x (m)": X}), pandas.DataFrame({"n": range(9), "A": range(9)})
    with pandas.ExcelWriter(path) as book:
        results.to_excel(book, sheet_name="Results", index=False)
        raw.to_excel(book, sheet_name="Raw", index=False)
    table = read_table(path)
    check(table)
    assert any("the longest, 'Raw'" in note for note in table.notes)
    with pandas.ExcelWriter(path) as book:
        raw.to_excel(book, sheet_name="Run 1", index=False)
        raw.to_excel(book, sheet_name="Run 2", index=False)
    with pytest.raises(InputError, match="2 sheets with numbers"):
        read_table(path)


def test_a_fit_beside_what_was_measured_is_no_second_place():
    """Failed before: a spreadsheet with its own fit was asked which column is x."""
    rows = [f"{line},{x + 1e-3:.6f},-0.001" for line, x in zip(LINES, X)]
    table = read("\n".join(["t (s),x (cm),x_fit (cm),residual (cm)", *rows]))
    check(table)
    check(read("\n".join(["t (s),fitted x (cm)", *LINES])))  # what is alone is taken
