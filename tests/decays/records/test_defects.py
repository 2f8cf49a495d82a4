"""Layouts x locales x defects: the right numbers, or a refusal that says where and what to do; never another number."""

import re

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import asymptotics as asy
from asymptotics.decays.records.sources import How
from asymptotics.decays.records.table import read_table
from asymptotics.errors import InputError

SEPARATORS = {"tab": "\t", "semicolon": ";", "comma": ",", "pipe": "|", "white": "  "}
HEADERS = ["", "t,x", "Time (s),Angle (deg)", "# t,x", "a preamble\n\nt,x", "k: 1\nt,x\ns,deg"]
FORMS = ["{:.6f}", "{:.4e}", "{:.3f}", "{:g}"]


def written(t, x, separator, mark, header, form):
    cells = [[form.format(v).replace(".", mark) for v in pair] for pair in zip(t, x)]
    names = re.sub(",", separator, header)
    return ([*names.split("\n")] if header else []), [separator.join(pair) for pair in cells]


def spoilt(lines, defect, place, separator):
    """(lines, the rows that remain)"""
    whole = list(range(len(lines)))
    kept = [i for i in whole if i != place]
    cell = lines[place].split(separator)[0]
    if defect == "text":
        return [*lines[:place], cell + separator + "oops", *lines[place + 1 :]], kept
    if defect == "missing":
        return [*lines[:place], cell + separator + "nan", *lines[place + 1 :]], kept
    if defect == "ragged":
        return [*lines[:place], separator.join([cell] * 3), *lines[place + 1 :]], kept
    if defect == "short":
        return [*lines[:place], cell, *lines[place + 1 :]], kept
    if defect == "comment":
        return [*lines[:place], "# a remark 1 2", "", *lines[place:]], whole
    if defect == "footer":
        return [*lines, "", "end of the measurement, 2 marks"], whole
    return lines, whole


@settings(
    max_examples=100, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture], derandomize=True
)
@given(
    separator=st.sampled_from(sorted(SEPARATORS)),
    mark=st.sampled_from([".", ","]),
    header=st.sampled_from(HEADERS),
    form=st.sampled_from(FORMS),
    defect=st.sampled_from(["none", "text", "missing", "ragged", "short", "comment", "footer"]),
    place=st.integers(1, 28),
    scale=st.sampled_from([1e-3, 1.0, 37.0, 5e3]),
    step=st.sampled_from([0.01, 1 / 3, 1.0, 20.0]),
    said=st.booleans(),
)
def test_the_right_numbers_or_a_refusal(tmp_path, separator, mark, header, form, defect, place, scale, step, said):
    t = 0.5 + step * np.arange(30)
    x = scale * np.cos(np.arange(30) * 0.7)
    head, lines = written(t, x, SEPARATORS[separator], mark, header, form)
    t, x = (np.array([float(form.format(v)) for v in values]) for values in (t, x))
    lines, kept = spoilt(lines, defect, place, SEPARATORS[separator])
    path = tmp_path / "a.txt"
    path.write_text("\n".join([*head, *lines]) + "\n")
    try:
        table = read_table(path, "record", how=How(decimal=mark if said else None)).whole()
    except InputError as error:
        assert "accepted:" in str(error)
        ambiguous = mark == "," and separator == "comma"
        thousands = "may be" in str(error) and not said
        assert ambiguous or thousands or _is_short(form, t), f"{error}\n{path.read_text()[:300]}"
        return
    np.testing.assert_allclose(table.columns["t"], t[kept], rtol=1e-12)
    np.testing.assert_allclose(table.columns["x"], x[kept], rtol=1e-12)
    if defect in ("text", "ragged"):
        assert any("cannot be read" in note for note in table.notes)
    if defect in ("text", "ragged", "missing", "short"):
        assert any(f"row {len(head) + place + 1}" in note for note in table.notes), table.notes


def _is_short(form, t):
    """Numbers with so few digits that times repeat (not asked of the reader) are not written by a sane exporter."""
    return len({form.format(v) for v in t}) < len(t)


def test_a_mostly_unreadable_record_is_refused_and_says_where(tmp_path):
    path = tmp_path / "a.csv"
    lines = [f"{i},{'?!' if i % 3 else i}" for i in range(60)]
    path.write_text("t,x\n" + "\n".join(lines))
    with pytest.raises(InputError, match=r"a.csv, row 3: '\?!' in the column x .* in 40 of 60 rows"):
        read_table(path)


def test_marks_for_missing_values_are_told_and_values_like_them_are_kept(tmp_path):
    path = tmp_path / "a.csv"
    path.write_text("t,x\n" + "".join(f"{i / 10},{-999 if i == 7 else i / 7}\n" for i in range(30)))
    table = read_table(path).whole()
    assert len(table.columns["x"]) == 29
    assert "1 value -999 of x taken as missing" in table.notes
    path.write_text("t,x\n" + "".join(f"{i / 10},{-999 if i == 7 else 100 * i}\n" for i in range(30)))
    assert len(read_table(path).whole().columns["x"]) == 30


@pytest.mark.slow
def test_ten_million_rows_in_bounded_memory(tmp_path):
    path = tmp_path / "a.csv"
    block = "".join(f"{i % 1000 / 1000:.6f},{np.cos(i):.6f},{i % 7}\n" for i in range(100_000))
    with path.open("w") as stream:
        stream.write("time,x,status\n")
        for _ in range(100):
            stream.write(block)
    import resource  # noqa: PLC0415
    import time  # noqa: PLC0415

    before, start = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss, time.process_time()
    table = read_table(path)
    grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1024
    assert len(table.columns["x"]) == 10_000_000
    assert time.process_time() - start < 60
    assert grown < 1500, grown


def test_columns_of_several_runs_are_asked_for_with_an_example_that_answers(tmp_path):
    # failed before: the example was --columns t=1, which asks again
    path = tmp_path / "two.csv"
    t = np.arange(0, 20, 0.04)
    rows = zip(t, np.exp(-0.02 * t) * np.cos(5 * t), t, np.exp(-0.02 * t) * np.cos(5 * t))
    head = "Run 1: Time (s),Run 1: Position (m),Run 2: Time (s),Run 2: Position (m)\n"
    path.write_text(head + "\n".join(",".join(f"{v:.6f}" for v in row) for row in rows))
    with pytest.raises(InputError, match="columns t=1,x=2"):
        asy.identify(str(path), laws=["1"])
    assert asy.identify(str(path), laws=["1"], columns="t=1,x=2").law("1").law.verdict == "consistent"


def test_files_of_the_laboratory_are_read_or_ask_for_their_library(tmp_path):
    t = np.arange(0, 30, 0.02)
    x = np.exp(-0.02 * t) * np.cos(5 * t)
    try:
        import h5py  # noqa: PLC0415 (an extra)
        from nptdms import ChannelObject, TdmsWriter  # noqa: PLC0415 (an extra)
    except ImportError:
        for name in ("a.h5", "a.tdms"):
            (tmp_path / name).write_bytes(b"bytes")
            with pytest.raises(InputError, match=r"\.\[laboratory\]"):
                read_table(tmp_path / name)
        return
    with h5py.File(tmp_path / "a.h5", "w") as file:
        file["run/time"], file["run/angle_rad"], file["run/label"] = t, x, "one"
    with TdmsWriter(tmp_path / "a.tdms") as file:
        file.write_segment([ChannelObject("run", "angle (rad)", x, {"wf_increment": 0.02, "wf_start_offset": 0.0})])
    with TdmsWriter(tmp_path / "b.tdms") as file:
        file.write_segment([ChannelObject("run", "time (s)", t), ChannelObject("run", "angle (rad)", x)])
    for name in ("a.h5", "a.tdms", "b.tdms"):
        found = read_table(tmp_path / name)
        assert (found.kind, found.unit) == ("record", "rad")
        assert np.allclose(found.columns["t"], t)
        assert np.array_equal(found.columns["x"], x)
    (tmp_path / "c.h5").write_bytes(b"bytes")
    with pytest.raises(InputError, match="cannot read c.h5"):
        read_table(tmp_path / "c.h5")
