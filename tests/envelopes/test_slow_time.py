"""A and phi explicit in the slow time: no logarithm, and the truncated flow is solved beyond the closed orders."""

from dataclasses import replace
from fractions import Fraction

import mpmath
import pytest
import sympy

import asymptotics as asy
from asymptotics.curves.solution import D, epsilon, tau
from asymptotics.expansions.normal_form.digits import certified_digits
from asymptotics.terms import Term


def residual_of_the_flow(found, alpha, rates, eps):
    """The larger of |A'/A + p(delta)| and |phi' - Omega(delta)| at one slow time: no algebra of the slow time."""
    time = mpmath.mpf(1) / 2 / eps
    A, phi = (sympy.lambdify([tau], e.subs(epsilon, eps), "mpmath") for e in (found.amplitude, found.phase))
    delta = eps * A(time) ** (alpha - 1)
    p, Omega = (sum(mpmath.mpf(c) * delta**n for (n,), c in rates[name].items()) for name in ("p", "Omega"))
    return max(abs(mpmath.diff(A, time) / A(time) + p), abs(mpmath.diff(phi, time) - Omega))


def test_no_logarithm_and_a_finite_lag():
    found = asy.solution("2", order=6)
    assert not (found.relative.has(sympy.log) or found.slow_phase.has(sympy.log))
    assert sympy.Poly(found.slow_phase.coeff(epsilon, 1), D).degree() == 1
    lag = -sympy.limit(found.slow_phase.coeff(epsilon, 1), D, 0)
    assert lag == sympy.pi / 8  # w_2/((alpha-1) p_1) = (1/6)/(4/(3 pi))


@pytest.mark.parametrize(("law", "order"), [("5/2", 9), pytest.param("3/2", 12, marks=pytest.mark.slow)])
def test_open_exponents_reach_order_twelve(law, order):
    """Decimals beyond the closed orders solve the truncated flow to O(eps^(N+1)); one of them changed does not."""
    found, rates = asy.solution(law, order=order), certified_digits([Term(1, law)], order, 40, names=("p", "Omega"))
    with mpmath.workdps(60):
        alpha, eps = mpmath.mpf(Fraction(law).numerator) / Fraction(law).denominator, mpmath.mpf(1) / 40
        coarse, fine = (residual_of_the_flow(found, alpha, rates, e) for e in (eps, eps / 2))
        assert mpmath.log(coarse / fine, 2) > order + 0.4
        wrong = replace(found, slow_phase=found.slow_phase + epsilon**3 * D**3 / 10**12)
        assert residual_of_the_flow(wrong, alpha, rates, eps / 2) > 10 * fine
    assert not found.relative.coeff(epsilon, 2).has(sympy.Float)
    assert max(len(str(e)) for e in (found.amplitude, found.phase)) < 6000
