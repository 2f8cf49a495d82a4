"""Sums of Gamma quotients against SymPy: what they are, and how they are written."""

import pickle
from functools import reduce
from operator import add, mul

import pytest
import sympy
from flint import arb, ctx, fmpq
from hypothesis import given
from hypothesis import strategies as st

from asymptotics.numbers.bridge import closed_form_ball, to_sympy
from asymptotics.numbers.gamma_sums import GammaSum, gamma

ARGUMENTS = [fmpq(*q) for q in ((1, 2), (1, 1), (5, 2), (1, 4), (7, 4), (1, 3), (13, 6), (9, 4))]
RATIONALS = st.builds(fmpq, st.integers(-20, 20), st.sampled_from([1, 1, 1, 2, 3, 10]))
POWERS = st.tuples(st.sampled_from(ARGUMENTS), st.integers(-4, 4))
TERMS = st.tuples(RATIONALS, st.lists(POWERS, max_size=3))
SUMS = st.lists(TERMS, max_size=4)


def power(x, n):
    return gamma(x) ** n if n >= 0 else GammaSum.rational(1) / gamma(x) ** -n


def ours(terms):
    """By the operations of the type."""
    return sum((reduce(mul, [power(x, n) for x, n in powers], GammaSum.rational(q)) for q, powers in terms), GammaSum())


def theirs(terms):
    """By SymPy's."""
    products = (sympy.prod([to_sympy(q), *(sympy.gamma(to_sympy(x)) ** n for x, n in p)]) for q, p in terms)
    return reduce(add, products, sympy.Integer(0))


@given(SUMS)
def test_a_sum_is_what_sympy_makes_of_it_and_written_as_sympy_writes_it(terms):
    form, expression = ours(terms), theirs(terms)
    assert form.to_sympy() == expression
    assert (str(form), form.latex(), form.is_sum) == (str(expression), sympy.latex(expression), expression.is_Add)
    assert pickle.loads(pickle.dumps(form)) == form
    near_miss = form + fmpq(1, 10**6)
    assert str(near_miss) != str(expression) != str(-near_miss)


@given(SUMS, SUMS)
def test_products_and_differences_are_those_of_sympy(x, y):
    assert (ours(x) * ours(y) - ours(y)).to_sympy() == sympy.expand(theirs(x) * theirs(y) - theirs(y))


@given(SUMS)
def test_the_ball_holds_the_number_that_sympys_expression_is(terms):
    with ctx.workprec(200):
        ball, other = ours(terms).ball(), closed_form_ball(theirs(terms))
        assert ball.overlaps(other) and ball.rad() < arb(10) ** -40 * (1 + abs(ball).upper())
        assert not ball.overlaps(other + arb(10) ** -30 * (1 + abs(ball).upper()))


@pytest.mark.parametrize(
    ("terms", "text"),
    [
        ([], "0"),
        ([(1, [(1, -4)])], "pi**(-2)"),
        ([(-1, [(1, -4)])], "-1/pi**2"),
        ([(1, [(1, -3)])], "pi**(-3/2)"),
        ([(1, [(1, -1)])], "1/sqrt(pi)"),
        ([(2, []), (-3, [(1, 4)])], "2 - 3*pi**2"),  # a positive rational first: by value it would come last
        ([(1, [(1, 2)]), (-3, [(1, 4)])], "pi - 3*pi**2"),
        ([(2, []), (-3, [(1, 1)]), (1, [(1, -2)])], "-3*sqrt(pi) + 1/pi + 2"),
    ],
)
def test_where_sympys_spelling_has_rules_of_its_own(terms, text):
    given_terms = [(fmpq(q), [(fmpq(k, 2), n) for k, n in powers]) for q, powers in terms]
    assert str(ours(given_terms)) == text == str(theirs(given_terms))


def test_only_one_term_can_be_divided_by():
    with pytest.raises(ValueError, match="unpack"):
        gamma(fmpq(1, 3)) / (1 + gamma(fmpq(1, 3)))
