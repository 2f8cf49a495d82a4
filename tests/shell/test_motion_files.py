"""The files of motion."""

import csv
import math

import pytest

from tests.shell.answers import run


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


DRY = "motion --law 0:1/10 --mass 1 --stiffness 1 --x0 1 --reference --time 20 --points 200"


def test_a_motion_that_stops_at_0_is_compared_and_told_in_one_line(capsys, tmp_path):
    """1 - 2 n/10 is 0 at n = 5: no amplitude there to be wrong by; its rows at rest have one method, named once."""
    right, wrong = tmp_path / "right.csv", tmp_path / "wrong.csv"
    assert run(capsys, f"{DRY} --csv {right}")[0] == 0
    code, out, _ = run(capsys, f"compare {right}")
    assert code == 0 and "402 of 402 values are right" in out and out.count("exact: dry friction") == 1
    head, *rows = right.read_text().splitlines()
    cells = [row.split(",") for row in rows]
    wrong.write_text("\n".join([head, *(",".join([t, repr(float(x) + 0.01), *more]) for t, x, *more in cells)]) + "\n")
    code, out, err = run(capsys, f"compare {wrong}")
    assert code == 0 and "the errors look like" in out, err


def test_a_file_made_with_a_static_friction_says_so_and_is_not_held_against_the_law_alone(capsys, tmp_path):
    held = tmp_path / "held.csv"
    assert run(capsys, f"{DRY} --static 0.5 --csv {held}")[0] == 0
    assert "--x0=1 --static=0.5 " in held.read_text().splitlines()[0]
    code, out, err = run(capsys, f"compare {held}")
    assert (code, out) == (2, "") and "--static=0.5" in err


def test_a_zero_term_beside_dry_friction_changes_no_row(capsys, tmp_path):
    """Neither with a static friction, which belongs to dry friction alone."""
    texts = []
    for law in ("--law 0:1/10", "--law 0:1/10 --law 2:0"):
        path = tmp_path / "rows.csv"
        assert run(capsys, f"{DRY.replace('--law 0:1/10', law)} --static 0.5 --csv {path}")[0] == 0
        texts.append(path.read_text().splitlines()[1:])
    assert texts[0] == texts[1]
    assert float(texts[0][-1].split(",")[1]) == pytest.approx(-0.4)  # x_3 = -(1 - 6/10), the first within 1/2


def test_a_table_of_an_expansion_says_its_order_and_gauge_and_is_read_back(capsys, tmp_path):
    """Amplitude and phase are those of a gauge and an order; a reference has none."""
    path = tmp_path / "motion.csv"
    line = f"motion --law 2:1/10 --mass 2 --time 7 --points 5 --csv {path}"
    assert run(capsys, f"{line} --order 2 --gauge averaging")[0] == 0
    assert "--order=2 --gauge=averaging" in path.read_text().splitlines()[0]
    code, out, _ = run(capsys, f"compare {path}")
    assert code == 0 and "2 x'' + x + 1/10 x'|x'| = 0" in out and "amplitude (of a gauge and an order)" in out
    assert run(capsys, f"{line} --reference")[0] == 0
    head = path.read_text().splitlines()[0]
    assert "--order" not in head and "--gauge" not in head


def test_a_uniform_bound_has_the_units_of_its_motion(capsys):
    for law, x, v in (("--damping 1/10", "0.00014 m,", "0.0014 m/s for"), ("--epsilon 1/10", "0.00014,", "0.0014 for")):
        told = run(capsys, f"motion --alpha 2 {law} --time 7 --order 2 --bound")[1]
        assert f"|x - x_2| <= {x} |x' - x'_2| <= {v} every t >= 0" in told
