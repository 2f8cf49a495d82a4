from fractions import Fraction

import pytest
import sympy
from hypothesis import given
from hypothesis import strategies as st

from asymptotics.numbers.bridge import closed_form_ball, from_sympy, to_sympy
from asymptotics.numbers.rationals import to_fmpq, to_fraction


@given(st.fractions())
def test_round_trips_are_exact(q: Fraction):
    assert to_fraction(to_fmpq(q)) == q
    assert from_sympy(to_sympy(q)) == q
    assert to_sympy(to_fmpq(q)) == sympy.Rational(q.numerator, q.denominator)
    assert to_sympy(to_fmpq(q)).is_Rational


def test_no_float_and_no_ball_crosses_the_bridge():
    with pytest.raises(TypeError):
        from_sympy(sympy.Float("0.1"))
    with pytest.raises(TypeError):
        closed_form_ball(sympy.Float("0.1"))
    with pytest.raises(TypeError):
        closed_form_ball(sympy.Symbol("x"))


@pytest.mark.parametrize(
    ("expression", "value"),
    [  # values from the definitions: W(e) = 1, Gamma(1/2)^2 = pi, zeta(2) = pi^2/6, atan(1) = pi/4
        (sympy.LambertW(sympy.E), 1),
        (sympy.gamma(sympy.Rational(1, 2), evaluate=False) ** 2 / sympy.pi, 1),
        (6 * sympy.zeta(2, evaluate=False) / sympy.pi**2, 1),
        (4 * sympy.atan(1, evaluate=False) / sympy.pi, 1),
    ],
)
def test_closed_forms_are_enclosed(expression, value):
    ball = closed_form_ball(expression)
    assert ball.contains(value)
    assert ball.rad() < 1e-12
