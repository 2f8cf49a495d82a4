"""SI units in motion, expand and turning-points, and the files of the last two, as a user types them."""

import csv
import math
import re

import pytest

from asymptotics.curves.solve import solution
from asymptotics.law import Oscillator
from asymptotics.made_by import mark
from tests.shell.answers import answer, run

SI = "--alpha 2 --damping 1/10 --mass 3/2 --stiffness 30"
EPSILON = "--alpha 2 --epsilon 1/75"  # b omega_0^2 x0/k of SI with x0 = 1/5: (1/10) 20 (1/5)/30
OMEGA = math.sqrt(20)


def test_turning_points_in_metres_and_seconds_are_the_dimensionless_ones_scaled(capsys):
    si = answer(capsys, f"turning-points {SI} --x0 -1/5 --count 4 --times --digits 15")
    bare = answer(capsys, f"turning-points {EPSILON} --count 4 --times --digits 15")
    assert (si["units"], si["x_unit"], bare["units"], bare["x_unit"]) == ("SI", "m", None, "x0")
    for metres, relative in zip(si["points"], bare["points"], strict=True):
        assert float(metres["x"]) == pytest.approx(-float(relative["x"]) / 5, rel=1e-13)
        assert float(metres["t"]) == pytest.approx(float(relative["tau"]) / OMEGA, rel=1e-13)


@pytest.mark.parametrize("place", ["1000", "-1000"])
def test_the_routes_are_told_for_the_strength_at_the_start(capsys, place):
    """From x0 = 1000 the law epsilon = 1/10 is that of strength 100 from 1."""
    near, far, same = (
        answer(capsys, f"turning-points --alpha 2 --count 100 --epsilon {e} --route help")["routes"]
        for e in ("1/10", f"1/10 --x0 {place}", "100")
    )
    assert far == same != near


def test_the_place_of_a_pendulum_is_told_in_radians_everywhere(capsys, tmp_path):
    """x_unit of the points, and the columns of the solution, as the motion and the envelope have them."""
    law = "--law 2:1/10 --spring pendulum --mass 2"
    assert answer(capsys, f"turning-points {law} --count 1 --digits 5")["x_unit"] == "rad"
    assert run(capsys, f"solution {law} --order 1 --time 1 --digits 5 --csv {tmp_path}/x.csv --points 2")[0] == 0
    with (tmp_path / "x.csv").open() as file:
        assert next(csv.reader(file))[:4] == ["t [s]", "amplitude [rad]", "phase [rad]", "x [rad]"]
    curve = solution(Oscillator({2: "1/10"}, spring="pendulum"), order=1).plot(until=1)
    assert "(rad)" in curve.get_ylabel()


def test_a_motion_with_epsilon_has_no_units_and_is_the_one_in_si_scaled(capsys):
    bare = answer(capsys, f"motion {EPSILON} --time 7 --digits 12")
    si = answer(capsys, f"motion {SI} --x0 1/5 --time {7 / OMEGA!r} --digits 12")
    assert (bare["units"], si["units"]) == (None, "SI")
    for name, scale in (("x", 5), ("v", 5 / OMEGA), ("amplitude", 5), ("phase", 1)):
        assert float(si[name]) * scale == pytest.approx(float(bare[name]), rel=1e-10), name
    _, out, _ = run(capsys, f"motion {EPSILON} --time 7")
    assert not any(line.endswith((" m", " m/s", " rad")) for line in out.splitlines())


def test_equations_in_si_say_what_delta_is(capsys):
    """delta = b omega_0^2 A/k, both rates carry omega_0, and the coefficients are those without units."""
    si, bare = (answer(capsys, f"expand {law} --order 4") for law in (SI, EPSILON))
    assert (si["units"], bare["units"]) == ("SI", None)
    assert (si["amplitude"], si["frequency"]) == (bare["amplitude"], bare["frequency"])
    assert si["delta"] == [{"name": "delta", "force": "x'|x'|", "value": "(1/10) omega_0^2/k A"}]
    _, out, _ = run(capsys, f"expand {SI} --order 2")
    assert out.splitlines()[1:3] == ["dA/dt = -omega_0 A (p_1 delta)", "dpsi/dt = omega_0 (1 + Omega_2 delta^2)"]


REFUSED = (
    ("expand --alpha symbolic --damping 1/10", "--damping"),
    ("expand --alpha symbolic --mass 2", "--mass"),
    ("expand --alpha symbolic --stiffness 2", "--stiffness"),
    ("expand --alpha symbolic --epsilon 1/10", "--epsilon"),
    ("expand --alpha symbolic --csv a.csv", "--csv"),
    (f"expand {SI} --epsilon 1/10", "--epsilon"),
    ("motion --alpha 2 --time 1 --epsilon 1/10 --mass 2", "--epsilon"),
    ("turning-points --alpha 2 --count 2 --epsilon 1 --damping 1", "--epsilon"),
    ("turning-points --alpha 2 --count 2 --epsilon 1 --stiffness 8", "--epsilon"),
    ("turning-points --alpha 2 --count 2 --damping 1 --mass -1", "--mass"),
)


@pytest.mark.parametrize(("line", "named"), REFUSED)
def test_units_that_have_no_meaning_are_refused_by_name(capsys, line, named, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    code, out, err = run(capsys, line)
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert f"argument {named}:" in err
    assert list(tmp_path.iterdir()) == []


def rows_of(path) -> list[list[str]]:
    """Without the last column, which says what code made the file."""
    rows = list(csv.reader(path.read_text().splitlines()))
    assert re.fullmatch(r"code( \[(turning-points )?--.*\])?", rows[0][-1])  # and the oscillator, or the request
    assert [row[-1] for row in rows[1:]] == [mark()] * (len(rows) - 1)
    return [row[:-1] for row in rows]


def test_turning_points_as_a_table_and_a_picture(capsys, tmp_path):
    table, picture = tmp_path / "points.csv", tmp_path / "points.png"
    found = answer(capsys, f"turning-points {SI} --x0 1/5 --count 4 --times --digits 9 --csv {table} --plot {picture}")
    assert found["files"] == [str(picture), str(table)]
    assert rows_of(table) == [["n", "x [m]", "t [s]"], *([str(p["n"]), p["x"], p["t"]] for p in found["points"])]
    assert picture.read_bytes().startswith(b"\x89PNG")
    run(capsys, f"turning-points {EPSILON} --count 2 --digits 9 --csv {table}")
    assert rows_of(table) == [["n", "x", "tau"], ["0", "1.00000000", ""], ["1", "-0.982532218", ""]]
    run(capsys, f"turning-points --law 2:1/10 --spring pendulum --x0 2 --count 2 --csv {table}")
    assert rows_of(table)[0] == ["n", "x [rad]", "tau"]


def test_turning_points_as_latex(capsys):
    code, out, _ = run(capsys, f"turning-points {SI} --x0 1/5 --count 2 --times --digits 9 --latex")
    assert code == 0
    body = r"0 & 0.200000000 & 0 \\ 1 & -0.196506444 & 0.702501925"
    assert out.strip() == rf"\begin{{array}}{{rll}} n & x_n/\mathrm{{m}} & t_n/\mathrm{{s}} \\ {body} \end{{array}}"
    assert run(capsys, f"turning-points {EPSILON} --count 2 --digits 9 --latex")[1].count("&") > 0


def test_the_coefficients_as_a_table(capsys, tmp_path):
    table = tmp_path / "expansion.csv"
    found = answer(capsys, f"expand --law 0:1/10 --law 3/2:1/5 --order 3 --digits 12 --csv {table}")
    head, *rows = rows_of(table)
    assert (head, found["files"]) == (["series", "k", "value", "exact"], [str(table)])
    for series, name in (("p", "amplitude"), ("Omega", "frequency")):
        told = {k: c["value"] for k, c in found[name].items()}
        assert {k: value for which, k, value, _ in rows if which == series} == told
    assert run(capsys, f"expand --alpha 2 --csv {tmp_path / 'no' / 'such.csv'}")[0] == 2
