"""What is displayed is what is checked: the sides differ in print, and altering either side stops the step."""

import re
from dataclasses import replace
from html import unescape
from importlib import import_module

import pytest
import sympy

from derivations.__main__ import names
from derivations.relations import latex, text
from derivations.steps import Derivation
from paper_checks.quoted import quoted, rounded
from paper_checks.report.words import inline


def equalities(name):
    derivation = import_module("derivations." + name.replace("-", "_")).derivation
    return [step for step in derivation.steps if step.kind == "equality"]


@pytest.mark.parametrize("name", names())
def test_the_sides_differ_in_print(name):
    for step in equalities(name):
        assert text(step.left) != text(step.right), step.reason
        assert latex(step.left) != latex(step.right), step.reason
        assert step.text().count(" = ") == 1, step.reason


WORDS = "alpha|beta|delta|epsilon|kappa|omega|tau|psi|theta|phi|pi"
ASCII = re.compile(rf"\^|->|<=|>=|!=|\bint\b|(?<![\w-])(?:{WORDS})(?![\w-])")


@pytest.mark.parametrize("name", names())
def test_the_report_shows_no_ascii_mathematics_beside_the_formulas(name):
    derivation = import_module("derivations." + name.replace("-", "_")).derivation
    for told in (derivation.title, *(step.reason for step in derivation.steps)):
        assert not ASCII.search(re.sub(r"<[^>]*>", " ", unescape(str(inline(told))))), told


def untied(steps):
    """The decimals in the words of a derivation that no number of the line, or of the line before, rounds to."""
    found, before = [], []
    for step in steps:
        parts = (x for side in (step.left, step.right) if side is not None for x in sympy.preorder_traversal(side))
        numbers = [abs(float(x)) for x in parts if isinstance(x, sympy.Expr) and x.is_number and x.is_real]
        found += [t for t in quoted(step.reason) if not any(rounded(t, x) for x in numbers + before)]
        before = numbers
    return found


@pytest.mark.parametrize("name", names())
def test_a_decimal_in_the_words_is_a_number_of_the_line(name):
    derivation = import_module("derivations." + name.replace("-", "_")).derivation
    assert untied(derivation.steps) == []


def test_a_decimal_that_is_wrong_is_noticed():
    steps = import_module("derivations.lelas_line_end").derivation.steps
    assert untied([replace(step, reason=step.reason.replace("0.0997", "0.0979")) for step in steps]) == ["0.0979"]


def test_sides_that_look_alike_are_refused():
    x = sympy.Symbol("x")
    derivation = Derivation("d", "", source="")
    with pytest.raises(AssertionError, match="printed as 2"):
        derivation.step("nothing shown", sympy.diff(x**2, x), 2 * x)
    with pytest.raises(AssertionError, match="differ by"):
        derivation.step("false", sympy.Derivative(x**3, x), 2 * x)
    derivation.step("shown", sympy.Derivative(x**2, x), 2 * x)
    assert len(derivation.steps) == 1
