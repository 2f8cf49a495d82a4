"""A solution in numbers: every form beside every other, at any digits and any time."""

from fractions import Fraction

import mpmath
import numpy as np
import pytest
import sympy

import asymptotics as asy
from asymptotics.curves.solution import epsilon, tau
from asymptotics.errors import InputError


@pytest.mark.parametrize("law", ["1", "2", "3", pytest.param("3/2", marks=pytest.mark.slow)])
def test_the_three_forms_of_one_solution_agree(law):
    found = asy.solution({law: "1/10"}, order=3)
    numbers = {tau: sympy.Rational(23, 3), epsilon: sympy.Rational(1, 10)}
    point = found.at("23/3", digits=25)
    A, phi, x = (float(f(np.array([23 / 3]), 0.1)[0]) for f in found.functions())
    for text, number, form in zip(point, (A, phi, x), (found.amplitude, found.phase, found.x)):
        assert abs(mpmath.mpf(text) - mpmath.mpf(form.subs(numbers).evalf(30))) < mpmath.mpf(10) ** -23
        assert float(text) == pytest.approx(number, abs=1e-12)


def test_a_table_of_open_integrals_is_the_closed_wave():
    """Orders above 3 of other exponents are tables; those of 2 and 3 are checked against the closed forms."""
    found, times = asy.solution("3/2", order=3), np.linspace(0.1, 30, 50)
    closed = sympy.lambdify([tau, epsilon], found.x, "mpmath")
    numbers = found.functions()[2](times, 0.1)
    assert max(abs(float(closed(t, 0.1)) - x) for t, x in zip(times, numbers)) < 1e-11


def test_digits_beyond_those_that_are_shown_are_right():
    """Rates and start of a law without closed forms are made again for more digits."""
    osc = asy.Oscillator({"3/2": "1/10"}, x0="3/5", v0="-4/5")
    short, long = (asy.solution(osc, order=4).at(7, digits=d) for d in (40, 60))
    for x, y in zip(short, long):
        assert abs(mpmath.mpf(x) - mpmath.mpf(y)) < mpmath.mpf(10) ** -39
    assert asy.solution("5/2", order=4).to_dict()["x"].count("x_3(") == 1


def test_a_strength_that_is_a_product_of_roots_has_the_digits_asked_for():
    """epsilon = b sqrt(k/m)^alpha x0^(alpha-1)/k, to 40 digits as it is shown and to more inside."""
    osc = asy.Oscillator({"3/2": "1/10"}, mass=2, stiffness="sqrt(3)", x0="1/5")
    found = asy.solution(osc, order=2)
    with mpmath.workdps(90):
        k, omega = mpmath.sqrt(3), mpmath.sqrt(mpmath.sqrt(3) / 2)
        right = (k / 2) ** mpmath.mpf("0.75") * mpmath.sqrt(mpmath.mpf(1) / 5) / k / 10
        assert str(found.strength) == mpmath.nstr(right, 40)
        exact = asy.solution({"3/2": Fraction(mpmath.nstr(right, 85))}, order=2)
    assert found.at(7, digits=60) == exact.at(7, digits=60)
    # The same x in metres: tau = omega_0 t, in units of x0 = 1/5.
    metres = float(found.at_time(osc, 7, 60).x)
    assert metres == pytest.approx(float(exact.at(str(7 * omega), digits=20).x) / 5, rel=1e-12)


@pytest.mark.parametrize("time", [10**20, 10**60])
def test_the_turns_of_a_late_phase_take_no_digits(time):
    """As many digits are right as are asked for, with and without units."""
    osc = asy.Oscillator({2: "1/10"})
    found = asy.solution(osc, order=2)
    long = found.at(time, digits=60)
    with mpmath.workdps(100):
        for short in (found.at(time, digits=20), found.at_time(osc, time, 20)):
            for x, y in zip(short, long):
                assert abs(mpmath.mpf(x) / mpmath.mpf(y) - 1) < 1e-18
        # Far beyond: x = A cos psi with delta below 1e-18.
        psi = time + mpmath.mpf(long.phase)
        assert abs(mpmath.mpf(long.x) / (mpmath.mpf(long.amplitude) * mpmath.cos(psi)) - 1) < 1e-15


def test_a_time_of_very_many_swings_is_no_fault():
    assert abs(float(asy.solution({2: "1e400"}, order=2).at(5, digits=5).phase)) > 1e300


def test_numbers_need_a_strength_and_a_time_before_the_end():
    with pytest.raises(InputError, match="epsilon"):
        asy.solution("2").at(1)
    with pytest.raises(InputError, match="time"):
        asy.solution({"1/2": "1/10"}, order=2).at(100)
    with pytest.raises(InputError, match="units"):
        asy.solution("2").in_units("feet")
