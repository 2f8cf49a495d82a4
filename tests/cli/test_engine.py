"""moment, expand and half-swing: the contract of their JSON, and their refusals."""

import json

import pytest
import sympy
from sympy.parsing import sympy_parser

from asymptotics.cli.main import main


def run(capsys, line: str) -> tuple[int, str, str]:
    try:
        code = main(line.split())
    except SystemExit as stop:
        code = int(stop.code or 0)
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def answer(capsys, line: str) -> dict:
    code, out, err = run(capsys, line + " --json")
    assert code == 0, err
    return json.loads(out)


def test_moment(capsys):
    assert answer(capsys, "moment --p 3 --digits 10")["exact"] == "4/(3*pi)"
    assert answer(capsys, "moment --p 4")["value"].rstrip("0") == "0.375"
    assert answer(capsys, "moment --p -1/2 --digits 6")["value"] == "1.66925"  # 3.625610/(1.772454 * 1.225417)
    assert answer(capsys, "moment --p sqrt(2)")["p"] == "sqrt(2)"


def test_expand(capsys):
    data = answer(capsys, "expand --alpha 3 --order 4 --digits 10 --exact")
    assert (data["alpha"], data["gauge"], data["order"]) == ("3", "turning-point", 4)
    assert set(data["amplitude"]) == {"1", "3"}
    assert set(data["frequency"]) == {"2", "4"}
    assert data["frequency"]["2"] == {"value": "-0.1757812500", "exact": "-45/256"}
    strong = answer(capsys, "expand --alpha 3 --epsilon 1/10 --order 4 --digits 10 --exact")
    assert (data["delta"][0]["value"], strong["delta"][0]["value"]) == ("epsilon A^2", "1/10 A^2")
    assert strong | {"delta": None} == data | {"delta": None}  # the coefficients hold for any strength
    assert answer(capsys, "expand --alpha 3/2 --order 3")["amplitude"]["3"]["exact"] is not None
    assert answer(capsys, "expand --alpha 3/2 --order 5")["amplitude"]["5"]["exact"] is None


def test_expand_a_sum_and_say_what_was_merged(capsys):
    data = answer(capsys, "expand --law 2:1/3 --law 1:1 --law 2:1 --order 2")
    assert data["alpha"] == ["2", "1"]
    assert "merged: alpha = 2" in data["notes"][0]
    assert set(data["frequency"]) == {"2,0", "1,1", "0,2"}


def test_expand_symbolic(capsys):
    data = answer(capsys, "expand --alpha symbolic --order 4")
    assert "I_4(alpha)" in data["frequency"]["4"]["exact"]
    assert data["integrals"]["I_4"]["values"]["1/2"].startswith("0.024213276")
    code, out, _ = run(capsys, "expand --alpha symbolic --order 2 --latex")
    assert code == 0
    assert r"\Gamma" in out


def test_half_swing(capsys):
    data = answer(capsys, "half-swing --alpha 2 --order 3 --digits 10")
    assert data["map"]["2"]["exact"] == "-4/3"  # F = delta - (4/3) delta^2 + ..., delta = u
    assert data["duration"]["0"]["exact"] == "pi"
    assert data["duration"]["2"]["exact"] == "pi/6"
    assert data["V"]["2"]["exact"] == "-4/(3*pi)"
    assert len(answer(capsys, "half-swing --law 1/2 --law 1 --order 2")["map"]) == 2


def test_half_swing_symbolic(capsys):
    """Closed forms in alpha, at alpha = 2 those of the exact engine; I_4 first at fourth order."""
    found = answer(capsys, "half-swing --alpha symbolic --order 4")
    exact = answer(capsys, "half-swing --alpha 2 --order 3 --digits 10")
    alpha = sympy.Symbol("alpha", nonnegative=True)
    for name in ("log_ratio", "map", "duration"):
        for k in set(found[name]) - {"4"}:
            value = sympy_parser.parse_expr(found[name][k]["exact"], {"alpha": alpha}).subs(alpha, 2)
            assert abs(value.evalf(15) - float(exact[name][k]["value"])) < 1e-8
    assert "I_4(alpha)" in found["duration"]["4"]["exact"] and "I_4" not in found["log_ratio"]["4"]["exact"]
    assert r"T_{0} = \pi" in run(capsys, "half-swing --alpha symbolic --order 1 --latex")[1]


@pytest.mark.parametrize(
    ("line", "argument"),
    [
        ("half-swing --alpha symbolic --order 5", "--order"),
        ("half-swing --alpha symbolic --delta 1/10", "--delta"),
        ("half-swing --alpha symbolic --spring 3", "--spring"),
        ("half-swing --alpha symbolic --epsilon 1/10", "--epsilon"),
        ("moment --p -1", "--p"),
        ("moment --p nan", "--p"),
        ("moment --p 1e6", "--p"),
        ("moment", "--p"),
        ("moment --p 1 --digits 0", "--digits"),
        ("expand", "--alpha"),
        ("expand --alpha -1", "--alpha"),
        ("expand --alpha -1/2", "--alpha"),
        ("expand --alpha inf", "--alpha"),
        ("expand --alpha 1j", "--alpha"),
        ("expand --alpha __import__('os')", "--alpha"),
        ("expand --alpha 2000", "--alpha"),
        ("expand --alpha 2 --law 1:1", "--alpha"),
        ("expand --alpha 2 --epsilon x", "--epsilon"),
        ("expand --law 2:1 --epsilon 1", "--epsilon"),
        ("expand --law 1:x", "--law"),
        ("expand --law -1:1", "--law"),
        ("expand --law 1 --law 2 --law 3 --law 4 --law 5", "--law"),
        ("expand --alpha 2 --order 0", "--order"),
        ("expand --alpha 2 --order 1000000", "--order"),
        ("expand --alpha 3/2 --order 190", "--order"),
        ("expand --alpha 2 --gauge energy", "--gauge"),
        ("expand --alpha 3/2 --exact", "--exact"),
        ("expand --alpha symbolic --order 5", "--order"),
        ("expand --alpha symbolic --order 4 --gauge averaging", "--order"),
        ("expand --alpha 2 --max-seconds 0", "--max-seconds"),
        ("half-swing --alpha 2 --digits 1000000", "--digits"),
        ("half-swing --alpha 2.5.5", "--alpha"),
    ],
)
def test_bad_input_is_one_line_that_names_the_argument(capsys, line, argument):
    code, out, err = run(capsys, line)
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert argument in err


@pytest.mark.parametrize(
    ("line", "unit", "first"),
    [
        ("--law 2:1/10", "x0", "1.0000"), ("--law 2:1/10 --spring pendulum --x0 2.9", "rad", "2.9000"),
        ("--law 2:1/10 --spring 3:1/2 --x0 2", "strengths", "2.0000"),
        ("--law 2:1/10 --stiffness 2 --x0 3", "m", "3.0000"),
        ("--law 1,2:1/10 --x0 2", "strengths", "2.0000"), ("--law 2:1/10 --v0 1", "x0", "1.0000"),
        ("--law 2:1/10 --spring pendulum --v0 1", "x0", "1.0000"),
    ],
)  # fmt: skip
def test_turning_points_say_in_what_x_is_told(capsys, line, unit, first):
    assert main(["turning-points", *line.split(), "--count", "2", "--digits", "5", "--json"]) == 0
    data = json.loads(capsys.readouterr().out)
    assert (data["x_unit"], data["points"][0]["x"]) == (unit, first)
    assert main(["turning-points", *line.split(), "--count", "2", "--digits", "5"]) == 0
    head = capsys.readouterr().out.splitlines()[0]
    assert ("rad" in head, "strengths" in head) == (unit == "rad", unit == "strengths")


@pytest.mark.parametrize("line", [
    "expand --alpha 2 --epsilon {} --order 2", "half-swing --alpha 2 --epsilon {} --order 2",
    "half-swing --law 2:{} --order 2", "multiple-scales --alpha 3 --epsilon {} --order 2",
    "multiple-scales --alpha symbolic --epsilon {}", "multiple-scales --law 1:{} --spring 3:1/9 --order 2",
    "turning-points --alpha 2 --epsilon {} --count 3", "envelope --alpha 2 --epsilon {} --time 3",
    "limit-cycle --law 1:-1 --law 1,2:{}",
])  # fmt: skip
def test_a_strength_has_an_effect(capsys, line):
    answers = []
    for strength in ("1/7", "1/11"):
        assert main([*line.format(strength).split(), "--json"]) == 0
        answers.append(json.loads(capsys.readouterr().out))
    assert answers[0] != answers[1]


def test_a_strength_that_nothing_asks_for_is_refused(capsys):
    assert main(["half-swing", "--alpha", "2", "--epsilon", "1/7", "--delta", "1/5"]) == 2
    assert "--epsilon" in capsys.readouterr().err
