"""A start in motion where waveforms are no polynomials: closed in theta, beside polynomials, balls and refusals."""

import mpmath
import pytest
import sympy

import asymptotics as asy
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.symbolic import alpha
from asymptotics.expansions.multiple_scales.hierarchy import any_start, multiple_scales
from asymptotics.expansions.multiple_scales.open_orders import open_scales
from asymptotics.expansions.multiple_scales.open_start import theta
from asymptotics.shell.main import main

r, epsilon = sympy.Symbol("r", positive=True), sympy.Symbol("epsilon", positive=True)


def at(form, **values):
    found = {s: values[s.name] for s in form.free_symbols if s.name in values}
    return sympy.N(form.subs(found), 25)


@pytest.mark.parametrize("exponent", [2, 3])
@pytest.mark.parametrize("angle", ["1/3", "5/2"])
def test_at_integers_it_is_the_polynomial_start(exponent, angle):
    """The general formulas at an integer beside those of the polynomials, and one with a wrong second order."""
    general = any_start(open_scales((sympy.Integer(exponent),), (), 2))
    exact = any_start(multiple_scales(exponent, order=2, gauge="turning-point"))
    values = {"theta": sympy.Rational(angle), "r": sympy.Rational(3, 2), "epsilon": sympy.Rational(1, 7)}
    for name in ("a(0)", "psi(0)"):
        assert abs(at(general[name], **values) - at(exact[name], **values)) < 1e-20
        wrong = general[name].subs(epsilon, epsilon + epsilon**2 / 100)
        assert abs(at(wrong, **values) - at(exact[name], **values)) > 1e-7


def test_other_exponents_have_the_coefficients_that_balls_have():
    """alpha = 3/2 beside ``start_in_motion``, whose coefficients are certified by another route."""
    law = asy.Oscillator({"3/2": 1}, x0="3/5", v0="-4/5")
    size, turn = asy.solution(law, order=2).start
    found = any_start(multiple_scales("3/2", order=2))
    angle = sympy.acos(sympy.Rational(3, 5))
    for form, numbers in ((found["a(0)"], size), (found["psi(0)"], turn)):
        for n in (1, 2):
            here = sympy.expand(form.subs({r: 1, theta: angle})).coeff(epsilon, n)
            assert abs(sympy.N(here, 25) - sympy.expand(numbers).coeff(epsilon, n)) < mpmath.mpf(10) ** -20


def test_a_sum_and_a_symbol_have_their_first_order():
    whole = any_start(multiple_scales(["1/2", 2], order=1))
    alone = [any_start(multiple_scales(x, order=1)) for x in ("1/2", 2)]
    values = {"theta": sympy.Rational(4, 3), "r": 2, "epsilon_0": 1, "epsilon_1": 1, "epsilon": 1}
    for name, free in (("a(0)", 2), ("psi(0)", sympy.Rational(4, 3))):
        parts = sum(at(one[name], **values) - free for one in alone)
        assert abs(at(whole[name], **values) - free - parts) < 1e-20
    general = any_start(multiple_scales("symbolic", order=2))["psi(0)"].subs(alpha, sympy.Rational(3, 2))
    known = any_start(multiple_scales("3/2", order=2))["psi(0)"]
    assert abs(at(general, **values) - at(known, **values)) < 1e-20


@pytest.mark.parametrize(
    ("scales", "argument", "accepted"),
    [
        (lambda: multiple_scales("3/2", order=3), "order", "1 to 2 for these exponents"),
        (lambda: multiple_scales(["1/2", 2], order=2), "order", "1 to 1 for these exponents"),
        (lambda: multiple_scales("3/2", order=2, spring={3: 1}), "start", "powers of x' alone"),
        (lambda: multiple_scales(3, order=2), "start", "gauge turning-point"),
    ],
)
def test_what_is_open_is_refused_with_what_is_accepted(scales, argument, accepted):
    with pytest.raises(InputError, match=f"argument {argument}.*{accepted}"):
        any_start(scales())


def test_the_command_shows_it_and_names_the_option(capsys):
    assert main(["multiple-scales", "--alpha", "3/2", "--order", "1", "--start"]) == 0
    assert "psi(0) = 2*epsilon*sqrt(r)*sin(theta)**(5/2)/5 + theta" in capsys.readouterr().out
    assert main(["multiple-scales", "--alpha", "3/2", "--order", "3", "--start"]) == 2
    assert "integer exponents" in capsys.readouterr().err
