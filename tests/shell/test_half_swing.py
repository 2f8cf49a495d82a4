"""The command half-swing: the contract of its JSON."""

import sympy
from sympy.parsing import sympy_parser

from tests.shell.answers import answer, run


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
