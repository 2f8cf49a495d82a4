"""Every layout of one known motion gives its strength, its clock and its unit, or the question that is declared."""

from pathlib import Path

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.sources import load
from asymptotics.decays.records.table import read_table
from asymptotics.errors import InputError
from tests.decays.records.layouts import EPSILON, OMEGA, PAGE, page, strength
from tests.decays.records.layouts_of_people import TEXTS
from tests.decays.records.layouts_of_programs import FILES

LAYOUTS = TEXTS | FILES
READ = [name for name, layout in LAYOUTS.items() if not layout.asked]
NEEDED = {".xlsx": "openpyxl", ".parquet": "pyarrow", ".h5": "h5py", ".tdms": "nptdms"}


def written(name, folder):
    layout = LAYOUTS[name]
    pytest.importorskip("h5py" if "7.3" in name else NEEDED.get(layout.suffix, "numpy"))
    return layout, layout.write(folder)


@pytest.mark.parametrize("name", READ)
def test_the_strength_comes_back(name, tmp_path):
    layout, path = written(name, tmp_path)
    (seen,) = load(path, how=layout.how)
    assert seen.unit == layout.unit
    # The first order in which 1/A grows evenly is good to the square of what a half-swing loses.
    assert strength(seen) * layout.size == pytest.approx(EPSILON, rel=0.02)
    if seen.has_times:
        assert np.polyfit(seen.n, seen.t, 1)[0] == pytest.approx(np.pi / OMEGA, rel=2e-3)


@pytest.mark.slow
@pytest.mark.parametrize("name", READ)
def test_identify_finds_the_strength(name, tmp_path):
    layout, path = written(name, tmp_path)
    how = layout.how
    found = asy.identify(path, columns=how.columns, laws=["1", "2"], bootstrap=False)
    law = found.law("2").law
    assert law.verdict == "consistent" and law.epsilon[0].estimate * layout.size == pytest.approx(EPSILON, rel=0.01)
    assert found.law("1").law.verdict == "refuted"


@pytest.mark.parametrize("name", [name for name in LAYOUTS if name not in READ])
def test_what_is_not_clear_is_asked(name, tmp_path):
    layout, path = written(name, tmp_path)
    with pytest.raises(InputError, match=layout.asked):
        load(path, how=layout.how)


def test_the_page_says_what_happens():
    for module in NEEDED.values():
        pytest.importorskip(module)
    assert Path(PAGE).read_text(encoding="utf-8") == page(), "python -m tests.decays.records.layouts"


def test_the_only_column_of_dates_is_the_time(tmp_path):
    """Failed before, of a column called date: what is measured is not clear."""
    path = tmp_path / "logged.csv"
    rows = [f"27.11.2026 10:00:{i // 10:02d},{100 * (i % 10):03d};{np.cos(0.6 * i):.4f}" for i in range(200)]
    path.write_text("\n".join(["date;x", *rows]))
    found = read_table(path)
    assert found.kind == "record" and found.columns["t"][-1] - found.columns["t"][0] == pytest.approx(19.9)
