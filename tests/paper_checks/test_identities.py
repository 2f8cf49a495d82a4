"""How symbolic forms are judged."""

from dataclasses import replace

import pytest
import sympy
from flint import arb

from paper_checks.evidence import recorded
from paper_checks.identities import all_confirmed, below, decided, rounds_to, same, vanishes
from paper_checks.registry import load
from paper_checks.report.pages import apart
from paper_checks.runner import examine
from paper_checks.verdict import Outcome

x = sympy.Symbol("x", positive=True)


@pytest.mark.parametrize(
    ("expression", "outcome"),
    [
        (sympy.exp(2 * x) - sympy.exp(x) ** 2, Outcome.CONFIRMED),
        (sympy.sin(2 * x) - 2 * sympy.sin(x) * sympy.cos(x), Outcome.CONFIRMED),
        (x - x * (1 + sympy.Rational(1, 10**40)), Outcome.REFUTED),
        (sympy.Integer(0), Outcome.CONFIRMED),
        # true, but not reducible by SymPy, and no ball can decide it
        (sympy.LambertW(x) * sympy.exp(sympy.LambertW(x)) - x, Outcome.UNDECIDED),
    ],
)
def test_vanishes(expression, outcome):
    assert vanishes(expression) == outcome


def test_same():
    assert same((x + 1) ** 2, x**2 + 2 * x + 1) == Outcome.CONFIRMED


def test_conjunction_is_the_weakest():
    c, r, u = Outcome.CONFIRMED, Outcome.REFUTED, Outcome.UNDECIDED
    assert (all_confirmed(c, c), all_confirmed(c, u), all_confirmed(u, r)) == (c, u, r)


def test_decided():
    assert (decided(True), decided(False)) == (Outcome.CONFIRMED, Outcome.REFUTED)


def test_what_refutes_is_told_with_both_sides_where_they_differ():
    x, y = sympy.symbols("x alpha'", positive=True)
    with recorded() as marks:
        assert same(2 * x, x * y) == Outcome.REFUTED
        assert rounds_to("0.334", arb(1) / 3) == Outcome.REFUTED and below(arb(2), arb(1)) == Outcome.REFUTED
    first, _, second, third = marks.differences
    assert (first.left, first.right, first.values) == ("2 x", r"\alpha' x", ("1.20000", "0.171429"))
    assert first.where == r"\alpha' = \frac{2}{7}, x = \frac{3}{5}"
    assert (second.left, second.right[:6], third.relation) == ("0.334", "0.3333", "<")
    with recorded() as marks:
        assert same(x, x) == Outcome.CONFIRMED
    assert marks.differences == []


def test_most_near_misses_show_both_sides_and_no_true_form_does():
    statement = load()["lancaster2020:13"]
    found = examine(statement)
    assert found.apart is not None and apart(found.apart)["latex"].count("neq") == 1
    assert examine(replace(statement, near_miss=None)).apart is None
