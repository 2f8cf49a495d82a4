"""The solution of several laws: implicit in the amplitude, and its quadrature is the motion."""

import mpmath
import pytest
import sympy

import asymptotics as asy
from asymptotics.curves.implicit import ImplicitSolution


def test_sums_are_implicit_and_their_quadrature_is_the_motion():
    found = asy.solution({1: "1/10", 2: "1/20"}, order=3)
    assert isinstance(found, ImplicitSolution) and found.to_dict()["x"] is None
    point = found.at("10", digits=20)
    strengths = dict(zip(found.scales.symbols, (sympy.Rational(1, 10), sympy.Rational(1, 20))))
    for form, value in ((found.time_of_amplitude, 10), (found.phase_of_amplitude, float(point.phase))):
        integrand = sympy.lambdify(form.variables[0], form.function.subs(strengths), "mpmath")
        assert float(mpmath.quad(integrand, [mpmath.mpf(point.amplitude), 1])) == pytest.approx(value, abs=1e-10)
