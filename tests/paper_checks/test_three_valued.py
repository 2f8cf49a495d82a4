"""What SymPy leaves open is never a falsehood: None reaches the verdict as UNDECIDED, in every check."""

import ast
from pathlib import Path

import pytest
import sympy

from paper_checks.forms import guarded
from paper_checks.identities import decided, limit_is, opposite, vanishes
from paper_checks.registry import load
from paper_checks.verdict import Outcome
from tests.sources import tree

FOLDER = Path(__file__).parents[2] / "paper_checks"
FILES = sorted(path for path in FOLDER.rglob("*.py") if path.parent.name != "report")
ENTRIES = load()
OPEN = sympy.Symbol("o", real=True)
C, R, U = Outcome.CONFIRMED, Outcome.REFUTED, Outcome.UNDECIDED


@pytest.mark.parametrize(
    ("facts", "outcome"),
    [
        ((None,), U), ((OPEN.is_positive,), U), ((OPEN > 0,), U), ((True, None), U), ((None, False), R), ((), C),
        ((sympy.true, True), C), ((sympy.false,), R), ((1,), U), ((sympy.Not(OPEN > 0), True), U), ((0,), U),
    ],
)  # fmt: skip
def test_a_fact_is_true_false_or_open(facts, outcome):
    assert decided(*facts) == outcome


def test_the_contrary_of_what_is_open_is_open():
    assert (opposite(C), opposite(R), opposite(U)) == (R, C, U)


def test_a_limit_that_stands_decides_nothing():
    unknown = sympy.Function("h")
    assert limit_is(unknown(OPEN), OPEN, sympy.oo, 0) == U
    assert limit_is(sympy.sin(OPEN), OPEN, sympy.oo, 0) == U


def test_unknown_functions_are_letters():
    f = sympy.Function("f", positive=True)(OPEN)
    assert vanishes(sympy.diff(f, OPEN) - 2 * f) == R
    assert vanishes(sympy.diff(f**2, OPEN) - 2 * f * sympy.diff(f, OPEN)) == C


def truths(tree):
    """Places where a three-valued assumption of SymPy (x.is_positive, x.equals(y)) is used as if it had two values."""
    parents = {child: node for node in ast.walk(tree) for child in ast.iter_child_nodes(node)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "bool":
            yield node
        if isinstance(node, ast.Attribute) and (node.attr.startswith("is_") or node.attr == "equals"):
            above = parents[node]
            while isinstance(above, ast.Starred | ast.GeneratorExp | ast.ListComp):
                above = parents[above]
            handed_over = isinstance(above, ast.Call) and ast.unparse(above.func) in ("decided", "sympy.Not")
            listed = isinstance(above, ast.Assign)  # a list of facts, decided further down
            if not handed_over and not listed:
                yield node


BALLS = {"is_finite", "is_integer", "is_Number", "is_number"}  # of python-flint, of a number, of the tree: two values


def test_no_check_makes_a_truth_of_what_may_be_open():
    for path in FILES:
        found = [n for n in truths(tree(path)) if getattr(n, "attr", "") not in BALLS]
        assert [f"{path.name}, {node.lineno}: {ast.unparse(node)}" for node in found] == []


@pytest.mark.parametrize("wrong", ["bool(x.is_positive)", "x.is_positive is True", "x.is_zero and y", "not x.is_zero"])
def test_the_guard_notices(wrong):
    assert list(truths(ast.parse(f"decided({wrong})")))
    assert not list(truths(ast.parse("decided(x.is_positive, *(y.is_zero for y in z))")))


def test_a_tool_that_gives_up_decides_nothing():
    def check(form):
        if form == 7:
            raise sympy.PolynomialError("no polynomial")
        return C if form == 5 or 1 / (8 - form) else U

    own, foreign = 5, (7, 8)
    assert [guarded(check, [own])(form) for form in (own, *foreign)] == [C, U, R]
    with pytest.raises(sympy.PolynomialError):
        guarded(check, [foreign[0]])(foreign[0])


mm, nn = (sympy.Symbol(letter, integer=True, positive=True) for letter in "mn")
T, K, q = sympy.symbols("T K q", positive=True)
FALSE = {  # forms that once passed
    "lancaster2020:15": [K**3 * T * q, K * T, K * T * q**2, sympy.sqrt(K) * T * q,
                           K * T * q * sympy.Symbol("m", positive=True)],
    "lancaster2020:fig1": [("0.038", "-0.056"), ("0.041", "-0.056"), ("0.042", "-0.055")],
    "lancaster2020:fig3": [
        tuple(factor * curve if place == i else curve for i, curve in enumerate(ENTRIES["lancaster2020:fig3"].printed))
        for place in (0, 1)
        for factor in (sympy.Rational(99, 100), sympy.Rational(101, 100))
    ],
    "lelas2024:claim.no-closed-form": [
        ENTRIES["lelas2024:claim.no-closed-form"].corrected.subs(sympy.ceiling, sympy.floor),
        ENTRIES["lelas2024:claim.no-closed-form"].corrected.replace(sympy.ceiling, lambda n: sympy.Integer(7)),
        ENTRIES["lelas2024:claim.no-closed-form"].corrected.replace(sympy.ceiling, lambda n: sympy.ceiling(n) + 1),
    ],
    "lelas2024:claim.not-analytically-solvable": [sympy.Integer(3), sympy.Symbol("C", positive=True)],
    "smith2012:63": [(mm * nn, ENTRIES["smith2012:63"].corrected[1])],
    "smith2012:57": [sympy.sqrt(sympy.Symbol("x", positive=True)), sympy.Symbol("zz", positive=True)],
}  # fmt: skip


@pytest.mark.parametrize("key", FALSE)
def test_a_false_form_that_once_passed_is_refuted(key):
    for form in FALSE[key]:
        assert ENTRIES[key].check(form) == R, form
