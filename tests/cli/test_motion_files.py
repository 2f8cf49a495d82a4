"""The files of motion."""

import csv
import math

import pytest

from tests.cli.answers import run


def test_motion_draws_and_tabulates_the_reference(capsys, tmp_path):
    target = tmp_path / "r.csv"
    line = f"motion --alpha 0 --damping 3 --stiffness 10 --x0 1 --time 5 --reference --static 5 --csv {target}"
    code, _, err = run(capsys, f"{line} --plot {tmp_path}/r.svg --points 50")
    assert code == 0, err
    rows = list(csv.reader(target.read_text().splitlines()))
    assert len(rows) == 52
    assert float(rows[-1][1]) == pytest.approx(-0.4)  # held at the first turning point, -(1 - 6/10): 4/10 <= 5/10
    assert math.isclose(float(rows[-1][2]), 0, abs_tol=1e-12)
    assert (tmp_path / "r.svg").stat().st_size > 5000
