"""The unit in every cell of a column is that of the column; a cell in another one is named."""

import numpy as np
import pandas as pd
import pytest

import asymptotics as asy
from asymptotics.decays.records.table import read_table
from asymptotics.errors import InputError


def swing(row):
    t = 0.05 * row
    return t, 5 * np.exp(-0.1 * t) * np.cos(6 * t)


@pytest.mark.parametrize(
    ("header", "row"),
    [
        ("t,x", "{0:.2f} s,{1:.4f} cm"), ("Zeit;Winkel", "{0:.2f}s;{1:.4f}cm"), ("", "{0:.2f} s,{1:.4f} cm"),
        ("t\tx", "{0:.2f} sec\t{1:.4f} cm"), ("t,x (cm)", '"{0:.2f} s","{1:.4f} cm"'), ("t|x", "{0:.2f} s|{1:.4f} cm"),
    ],
)  # fmt: skip
def test_the_unit_in_every_cell_is_that_of_the_column(tmp_path, header, row):
    """Failed before: no rows of two numbers."""
    path = tmp_path / "run.txt"
    path.write_text("\n".join([*([header] if header else []), *(row.format(*swing(i)) for i in range(60))]))
    found = read_table(path)
    assert (found.kind, found.unit, found.clock) == ("record", "cm", "s")
    assert found.columns["x"] == pytest.approx([swing(i)[1] for i in range(60)], abs=1e-4)
    path.write_text(path.read_text().replace(".", ","))
    if row.format(1, 1).count(",") == 0:
        assert read_table(path).columns["x"] == pytest.approx(found.columns["x"])


@pytest.mark.parametrize("odd", ["29 mm", "2.9"])
def test_a_cell_in_another_unit_is_named_with_its_row(tmp_path, odd):
    path = tmp_path / "run.csv"
    rows = [f"{swing(i)[0]:.2f} s,{swing(i)[1]:.3f} cm" for i in range(30)]
    rows[20] = f"1.0 s,{odd}"
    path.write_text("\n".join(["t,x", *rows]))
    with pytest.raises(InputError, match=rf"run.csv, row 22: '{odd}' where the cells above are in cm"):
        read_table(path)
    path.write_text("\n".join(["t,x (mm)", *rows]))
    with pytest.raises(InputError, match="the cells of 'x .mm.' are in cm"):
        read_table(path)


def test_tables_of_damping_hear_them_too(tmp_path):
    path = tmp_path / "table.csv"
    path.write_text("A;zeta\n10 cm;1.20 %\n20 cm;1.41 %\n40 cm;1.78 %\n80 cm;2.61 %\n")
    right = asy.damping_law({"A": [0.1, 0.2, 0.4, 0.8], "zeta": [0.012, 0.0141, 0.0178, 0.0261]}, laws="1+2")
    found = asy.damping_law(path, laws="1+2")
    assert [s.estimate for s in found.laws[0].strengths] == pytest.approx([s.estimate for s in right.laws[0].strengths])


def test_a_frame_and_a_mapping_have_units_in_their_cells_too():
    """Failed before: '5.000 cm' is not a number."""
    rows = [swing(i) for i in range(60)]
    cells = {"t": [f"{t:.2f} s" for t, _ in rows], "x": [f"{x:.4f} cm" for _, x in rows]}
    for data in (cells, pd.DataFrame(cells)):
        found = read_table(data)
        assert (found.kind, found.unit, found.clock) == ("record", "cm", "s")
        assert found.columns["x"] == pytest.approx([x for _, x in rows], abs=1e-4)
    odd = {**cells, "x": [*cells["x"][:-1], "29 mm"]}
    with pytest.raises(InputError, match="the data, row 59: '29 mm' where the cells above are in cm"):
        read_table(odd)
    with pytest.raises(InputError, match=r"the data: the cells of 'x \(mm\)' are in cm"):
        read_table({"t": cells["t"], "x (mm)": cells["x"]})
