"""The command multiple-scales, and bad input to it, envelope, motion and smith."""

import pytest
import sympy

from tests.shell.answers import answer, run

BAD = [
    ("envelope --alpha 2 --epsilon 1/5 --mass 2", "--epsilon"),
    ("envelope --alpha 2 --epsilon 1/5 --plot a.svg", "--time"),
    ("envelope --alpha 2 --epsilon 1/5 --time 1 --points 5", "--points"),
    ("envelope --alpha 2 --epsilon 1/5 --time 1 --csv a.csv --points 0", "--points"),
    ("envelope --alpha 2", "--damping"),
    ("envelope --alpha 2 --epsilon -1", "--epsilon"),
    ("envelope --alpha 2 --epsilon 1 --time -1", "--time"),
    ("envelope --law 0:1 --law sqrt(3):1 --latex", "--latex"),
    ("envelope --alpha 2 --epsilon 1 --digits 0", "--digits"),
    ("multiple-scales --alpha 3/2 --order 13", "--order"),
    ("multiple-scales --alpha 3 --order 0", "--order"),
    ("multiple-scales", "--alpha"),
    ("multiple-scales --alpha symbolic --law 2", "--law"),
    ("multiple-scales --law 1,1 --order 3", "--order"),
    ("multiple-scales --law 3/2 --spring 2 --order 4", "--order"),
    ("multiple-scales --alpha 2 --gauge no-first-harmonic", "--gauge"),
    ("multiple-scales --alpha 3 --gauge averaging", "--gauge"),
    ("multiple-scales --law 1 --spring 1/2", "--spring"),
    ("multiple-scales --alpha 2 --map", "--gauge"),
    ("motion --alpha 2 --damping 1 --x0 1 --time 1 --csv no/such/folder/a.csv", "--csv"),
    ("motion --alpha 2 --damping 1 --x0 1 --time 1 --csv a.svg --plot a.svg", "--csv"),
    ("motion --alpha 2 --damping 1 --x0 0 --time 1 --csv a.csv", "--x0"),
    ("smith f --n 7 --i x", "--i"),
    ("smith g --i 2 --n 1", "--n"),
]


def test_the_derivation_of_cubic_damping(capsys):
    found = answer(capsys, "multiple-scales --alpha 3 --order 2")
    a, epsilon = sympy.symbols("a epsilon", positive=True)
    names = {"a": a, "epsilon": epsilon}
    shown = sympy.sympify(found["amplitude_rate"], locals=names)
    assert sympy.expand(shown + sympy.Rational(3, 8) * a**3 * epsilon) == 0
    assert found["gauge"] == "no-first-harmonic"
    assert [one["n"] for one in found["orders"]] == [0, 1, 2]
    assert found["orders"][1]["solvability"] == ["f_1 = -3*a**3/8", "g_1 = 0"]
    assert found["orders"][2]["solvability"][1] == "g_2 = 9*a**4/256"  # the gauge's own second order, 9/256
    text = run(capsys, "multiple-scales --alpha 3 --order 2")[1]
    assert "dpsi/dtau = 9*a**4*epsilon**2/256 + 1" in text


@pytest.mark.parametrize("law", ["--alpha 3/2", "--alpha symbolic", "--law 1 --law 3 --order 3", "--law 1 --law 2"])
def test_the_derivation_in_latex(capsys, law):
    code, out, err = run(capsys, f"multiple-scales {law} --latex")
    assert code == 0, err
    assert out.count(r"\[") == out.count(r"\]") >= 4
    assert out.count(r"\begin{aligned}") == out.count(r"\end{aligned}")


@pytest.mark.parametrize(("line", "argument"), BAD, ids=[line for line, _ in BAD])
def test_bad_input_is_one_line_that_names_the_argument(capsys, tmp_path, monkeypatch, line, argument):
    monkeypatch.chdir(tmp_path)
    code, out, err = run(capsys, line)
    assert (code, out) == (2, "")
    assert err.count("\n") == 1
    assert argument in err
    assert list(tmp_path.iterdir()) == []
