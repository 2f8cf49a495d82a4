import pickle
from concurrent.futures import ProcessPoolExecutor
from copy import deepcopy
from fractions import Fraction
from multiprocessing import get_context

import pytest
import sympy
from flint import acb, acb_poly, arb, arb_poly, arb_series, ctx, fmpq, fmpq_poly, fmpq_series, fmpz, fmpz_poly
from hypothesis import given
from hypothesis import strategies as st

from asymptotics.numbers import ExactReal
from asymptotics.numbers.bridge import closed_form_ball, from_sympy, to_sympy
from asymptotics.numbers.rationals import bounds, to_fmpq, to_fraction


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


@given(st.fractions(min_value=Fraction(1, 1000), max_value=1000), st.integers(20, 300))
def test_bounds_enclose(q: Fraction, bits: int):
    with ctx.workprec(bits):
        low, high = bounds(ExactReal(q).ball())
    assert low <= q <= high
    assert high - low <= q * Fraction(2) ** (2 - bits)


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


def _numbers():
    with ctx.workprec(200):
        root = arb(2).sqrt()
        z = acb(root, arb.pi())
    rationals = [fmpq_poly([1, fmpq(1, 2)]), fmpq_series([1, fmpq(1, 3)], prec=7), fmpz_poly([fmpz(10) ** 5000, 2])]
    return [root, z, arb_poly([1, root]), acb_poly([z, 1]), arb_series([root, 1], 5), *rationals, fmpq(1, 3), arb.nan()]


def _same(a, b) -> bool:
    return a.repr() == b.repr() if hasattr(a, "repr") else str(a) == str(b)


@pytest.mark.parametrize("number", _numbers(), ids=lambda x: type(x).__name__)
def test_pickling_and_copying_are_exact(number):
    with ctx.workprec(30):  # the receiver's precision must not matter
        assert _same(pickle.loads(pickle.dumps(number)), number)
        assert _same(deepcopy(number), number)


def _square(x: arb) -> arb:
    return x * x


def test_balls_travel_through_a_process_pool():
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        assert pool.submit(_square, arb(3)).result().contains(9)
