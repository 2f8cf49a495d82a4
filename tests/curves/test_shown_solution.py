"""A solution in words and in LaTeX: the text of x is x."""

import shutil
import subprocess

import mpmath
import pytest
import sympy

import asymptotics as asy
from asymptotics.curves.solution import A_0, epsilon, tau


@pytest.mark.parametrize(
    ("law", "order"),
    [("2", 5), ("1", 3), *(pytest.param(*row, marks=pytest.mark.slow) for row in (("2", 4), ("0", 5)))],
)
def test_the_text_of_x_is_x(law, order):
    """Read by SymPy: the number that ``at`` gives, x(0) = 1; from order 5 on A and psi are written once."""
    found = asy.solution({law: "1/10"}, order=order)
    text = found.to_dict()["x"]
    form = sympy.sympify(text, locals={"tau": tau, "epsilon": epsilon})
    assert form.free_symbols <= {tau, epsilon} and form.subs({tau: 0}).subs(epsilon, sympy.Rational(1, 7)) == 1
    with mpmath.workdps(30):
        value = sympy.lambdify([tau, epsilon], form, "mpmath")(mpmath.mpf(7), mpmath.mpf(1) / 10)
        assert abs(value - mpmath.mpf(found.at(7, digits=25).x)) < mpmath.mpf(10) ** -22
    assert text.startswith("Lambda((A, psi)") == (order > 4) and len(text) < 15_000
    named = found.to_dict()["x_by_name"]
    assert set(named) == {"x", "chi", "psi", "delta", "A"} and "delta" in named["x"]


@pytest.mark.parametrize("law", ["2", "3/2", "symbolic", "1", "0"])
def test_latex_is_a_document(law, tmp_path):
    text = asy.solution(law, order=4 if law == "2" else 2).latex(standalone=True)
    assert text.startswith(r"\documentclass") and text.rstrip().endswith(r"\end{document}")
    assert text.count(r"\[") == text.count(r"\]") and A_0 is not None
    if shutil.which("pdflatex") is None:
        pytest.skip("no pdflatex to compile it with")
    (tmp_path / "s.tex").write_text(text)
    done = subprocess.run(
        ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "s.tex"],
        cwd=tmp_path,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout[-800:]
