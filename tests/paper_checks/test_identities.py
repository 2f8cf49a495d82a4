"""How symbolic forms are judged."""

import pytest
import sympy

from asymptotics.verdict import Outcome
from paper_checks.identities import all_confirmed, decided, same, vanishes

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
