"""The command solution."""

import json

import pytest
import sympy

import asymptotics as asy
from asymptotics.ask.questions.solution import solution_at
from asymptotics.curves.solution import epsilon, tau
from asymptotics.shell.main import main


def test_the_command_has_the_keys_of_the_contract(capsys, tmp_path):
    line = ["solution", "--alpha", "2", "--epsilon", "1/10", "--order", "3", "--time", "50", "--bound", "--json"]
    line += ["--csv", str(tmp_path / "x.csv"), "--plot", str(tmp_path / "x.svg"), "--points", "20"]
    assert main(line) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["certified"] is False and found["order"] == 3 and found["valid_until"] == "oo"
    names = {"tau": tau, "epsilon": epsilon}
    values = {tau: sympy.Integer(50), epsilon: sympy.Rational(1, 10)}
    for name in ("amplitude", "phase", "x"):
        form = sympy.sympify(found[name], locals=names)
        assert abs(form.subs(values).evalf(25) - sympy.Float(found[f"{name}_value"], 25)) < 1e-20
        assert form.subs({tau: 0}).subs(epsilon, sympy.Rational(1, 7)) == {"amplitude": 1, "phase": 0, "x": 1}[name]
    true = float(asy.reference({2: "1/10"}).at("50", digits=20).x)
    assert abs(true - float(found["x_value"])) <= float(found["bound"]) < 1e-5
    rows = (tmp_path / "x.csv").read_text().splitlines()
    assert rows[0].startswith("tau,amplitude,phase,x") and len(rows) == 22
    assert float(rows[-1].split(",")[3]) == pytest.approx(float(found["x_value"]), abs=1e-12)
    assert (tmp_path / "x.svg").read_text().startswith("<?xml")


@pytest.mark.slow
def test_the_command_answers_at_order_nine(capsys):
    assert main(["solution", "--alpha", "5/2", "--epsilon", "1/10", "--order", "9", "--time", "7", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    low = asy.solution({"5/2": "1/10"}, order=8).at(7, digits=20).x
    assert 0 < abs(float(found["x_value"]) - float(low)) < 1e-8


@pytest.mark.parametrize("alpha", ["sqrt(3/2)", "sqrt(1/2)", "sqrt(8)"])
def test_an_exponent_that_sympy_writes_another_way_is_served(alpha, capsys):
    # SymPy has sqrt(6)/2, sqrt(2)/2 and 2*sqrt(2), which no option takes.
    assert main(["solution", "--alpha", alpha, "--epsilon", "1/10", "--order", "4", "--time", "1"]) == 0
    assert "not an exact number" not in capsys.readouterr().err


@pytest.mark.parametrize("start", [["--x0", "3"], ["--v0", "1"], ["--x0", "word"]])
def test_a_start_beside_formulas_alone_is_refused(start, capsys):
    """It was neither read nor used."""
    assert main(["solution", "--alpha", "2", *start]) == 2
    out, err = capsys.readouterr()
    assert out == "" and err.startswith(f"asymptotics solution: argument {start[0]}: formulas alone have no start")
    assert main(["solution", "--alpha", "2"]) == 0


def test_the_question_in_python_and_what_it_refuses():
    found = solution_at({2: "1/10"}, 50, bound=True)
    assert found.point == asy.solution({2: "1/10"}).at(50) and found.bound == asy.solution({2: "1/10"}).bound(50)
    assert solution_at("symbolic", order=1).time is None and solution_at("symbolic", order=1).values == {}
    for wrong in ({"law": "2", "time": 1}, {"law": {2: 1}, "bound": True}, {"law": {2: 1}, "time": -1}):
        with pytest.raises(asy.InputError):
            solution_at(**wrong)


def test_a_fragment_is_the_middle_of_the_document(capsys):
    line = ["solution", "--alpha", "2", "--epsilon", "1/10", "--order", "2"]
    texts = {}
    for words in ((), ("--latex",), ("--fragment",), ("--latex", "--fragment")):
        assert main([*line, *words]) == 0
        texts[words] = capsys.readouterr().out
    assert texts[("--fragment",)] == texts["--latex", "--fragment"] != texts[()]
    assert texts[("--fragment",)].strip() in texts[("--latex",)] and "documentclass" not in texts[("--fragment",)]
