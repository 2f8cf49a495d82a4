"""SI units in every command that has them, and files of expand and turning-points, as a user types them."""

import csv
import math
import re
from fractions import Fraction

import pytest

from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.curves.solve import solution
from asymptotics.law import Oscillator
from asymptotics.made_by import mark
from asymptotics.shell.main import main
from tests.every_question import example, options_of, without_law
from tests.shell.answers import answer, run

SI = "--alpha 2 --damping 1/10 --mass 3/2 --stiffness 30"
EPSILON = "--alpha 2 --epsilon 1/75"  # b omega_0^2 x0/k of SI with x0 = 1/5: (1/10) 20 (1/5)/30
OMEGA, LENGTH = math.sqrt(20), 1 / 5
SCALES = {"m": LENGTH, "s": 1 / OMEGA, "m/s": LENGTH * OMEGA, "N": 6, "J": 30 * LENGTH**2, "N s/m": 1.5 * OMEGA,
          "rad/s": OMEGA}  # fmt: skip
UNITS = {"--mass", "--x0", "--csv", "--digits"}
MOVING = [name for name in QUESTIONS if options_of(name).keys() >= UNITS and not loaded(name).offers.reads]


def table(words, path):
    """The columns of a table: (name, unit, texts)."""
    assert main([*words, "--csv", str(path), "--quiet"]) == 0
    head, *rows = csv.reader(path.read_text().splitlines())
    names = [re.fullmatch(r"([^[]*?)(?: \[(.*)\])?", name).groups() for name in head[:-1]]
    return [(name, unit, [row[i] for row in rows]) for i, (name, unit) in enumerate(names)]


def number(text):
    """A cell as a number, or as it is."""
    try:
        return float(Fraction(text))
    except ValueError:
        return text


@pytest.mark.parametrize(("name", "side"), [*((name, "") for name in MOVING), ("turning-points", "-")])
def test_a_table_in_si_is_the_one_without_units_scaled(name, side, tmp_path, capsys):
    words = [*without_law(example(name, tmp_path)), *(["--points=3"] if "--points" in options_of(name) else [])]
    words += ["--times"] if "--times" in options_of(name) else []
    words += ["--digits", "15"]
    scaled = [*words]
    for option, scale in (("--time", lambda t: f"sqrt({t}/20)"), ("--amplitudes", lambda a: f"{a}/5")):
        if option in words:  # they are 1, whose square it is
            words[words.index(option) + 1], scaled[words.index(option) + 1] = "1", scale(1)
    bare = table([*words, *EPSILON.split()], tmp_path / "bare.csv")
    si = table([*scaled, *SI.split(), "--x0", f"{side}1/5"], tmp_path / "si.csv")
    assert len(bare) == len(si) and any(unit for _, unit, _ in si) and not any(unit in SCALES for _, unit, _ in bare)
    for (_, _, relative), (name, unit, physical) in zip(bare, si, strict=True):
        scale = SCALES.get(unit, 1) * (-1 if side and name in ("x", "v") else 1)
        for one, other in zip(map(number, relative), map(number, physical), strict=True):
            assert other == (pytest.approx(one * scale, rel=1e-9, abs=1e-13) if isinstance(one, float) else one)


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
