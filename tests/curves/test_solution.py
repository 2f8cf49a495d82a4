"""The solution as functions of time: the order of its error, its start, its units, bad input."""

from dataclasses import replace
from fractions import Fraction
from random import Random

import mpmath
import numpy as np
import pytest
import sympy
from scipy.integrate import solve_ivp

import asymptotics as asy
from asymptotics.curves.solution import D, epsilon, epsilon_0, kappa, tau
from asymptotics.errors import InputError

_SLOW_ROWS = [("3", 3), ("4", 3), ("3/2", 3), ("1/2", 2), ("sqrt(2)", 4), ("5/2", 3), ("7/3", 2)]
SLOW = [Fraction(k, 8) for k in (5, 7, 9, 10)]


def error(law, order, eps):
    """The largest error of x at a few fixed slow times, against certified motion."""
    found, moving = asy.solution({law: str(eps)}, order=order), asy.reference({law: str(eps)})
    gaps = []
    for slow in SLOW:
        time = str(slow / eps)
        gaps.append(abs(mpmath.mpf(found.at(time, digits=20).x) - mpmath.mpf(moving.at(time, digits=18).x)))
    return max(gaps)


@pytest.mark.parametrize(
    ("law", "order"),
    [("2", 2), ("2", 4), *(pytest.param(*row, marks=pytest.mark.slow) for row in _SLOW_ROWS)],
)  # fmt: skip
def test_the_error_at_fixed_slow_time_falls_like_the_order(law, order):
    """Twenty and forty: the measured order is above N - 1/2, and an order less is refused by the size of the error."""
    coarse, fine = (error(law, order, Fraction(1, n)) for n in (20, 40))
    assert mpmath.log(coarse / fine, 2) > order - 0.6
    assert error(law, order - 1, Fraction(1, 40)) > 1.5 * fine


def integrated(strengths, times):
    """x at many times by an integrator in doubles: no route of ours."""

    def field(_, y):
        return [y[1], -y[0] - sum(e * np.sign(y[1]) * abs(y[1]) ** a for a, e in strengths.items())]

    span = (0.0, times[-1])
    return solve_ivp(field, span, [1.0, 0.0], "DOP853", rtol=1e-10, atol=1e-12, t_eval=times, max_step=0.1).y[0]


def random_laws():
    """Laws that nobody chose: one exponent, or two."""
    draw = Random(20261123)
    one = [{Fraction(draw.randint(11, 35), 10): 1} for _ in range(2)]
    return [
        (one[0], 2),
        (one[1], 3),
        ({Fraction(draw.randint(10, 19), 10): 1, Fraction(draw.randint(21, 30), 10): 2}, 2),
    ]


@pytest.mark.parametrize(("law", "order"), random_laws())
def test_the_error_of_random_laws_falls_like_the_order_and_a_wrong_coefficient_is_noticed(law, order):
    """At fixed slow time, beside an integrator: epsilon^N; a phase wrong by a tenth makes it larger."""
    gaps, wrong = [], []
    for n in (20, 40):
        strengths = {a: weight / Fraction(n) for a, weight in law.items()}
        times = [n * s for s in (0.5, 0.8, 1.1)]
        true = integrated({float(a): float(e) for a, e in strengths.items()}, times)
        found = asy.solution(strengths, order=order)
        gaps.append(np.max(np.abs(found.sample(np.array(times))[2] - true)))
        if len(law) == 1:
            miss = replace(found, slow_phase=found.slow_phase * sympy.Rational(9, 10))
            wrong.append(np.max(np.abs(miss.sample(np.array(times))[2] - true)))
    assert np.log2(gaps[0] / gaps[1]) > order - 0.5
    assert not wrong or wrong[1] > 3 * gaps[1]


@pytest.mark.parametrize("law", ["0", "2", "3/2", "5"])
def test_the_start_is_exact(law):
    found = asy.solution(law, order=4)
    gaps = [sympy.simplify(e.subs(D, 1).subs(epsilon, 1)) for e in (found.relative - 1, found.slow_phase)]
    assert all(abs(gap) < sympy.Rational(1, 10**30) if gap.has(sympy.Float) else gap == 0 for gap in gaps)
    assert float(found.functions()[2](np.array([0.0]), 0.1)[0]) == pytest.approx(1, abs=1e-14)


def test_units():
    found = asy.solution("2", order=2)
    assert sympy.simplify(found.in_units("kappa")[0] - 1 / (1 + kappa * tau)) == 0
    m, k, b, x_0, t = sympy.symbols("m k b x_0 t", positive=True)
    known = x_0 / (1 + 4 * b * sympy.sqrt(k / m) * x_0 * t / (3 * sympy.pi * m))  # Lancaster 2020, Table I
    assert sympy.simplify(found.in_units("SI")[0] - known) == 0
    osc = asy.Oscillator({2: "1/10"}, mass="3/2", stiffness=30, x0="1/5")
    si = asy.solution(osc, order=2).at_time(osc, "7", 15)
    assert float(si.x) == pytest.approx(float(asy.motion(osc, order=2).at("7", digits=15).x), abs=1e-7)


@pytest.mark.parametrize(
    ("law", "order", "argument"),
    [({2: 1}, 0, "order"), ({2: 1}, 13, "order"), ({-2: 1}, 2, "alpha"), ({2: -1}, 2, "strength"), ("-1", 2, "alpha")],
)  # fmt: skip
def test_bad_input_is_refused_by_name(law, order, argument):
    with pytest.raises(InputError, match=f"argument {argument}"):
        asy.solution(law, order=order)


@pytest.mark.parametrize(
    "law",
    [
        {2: "1/10"},
        {"3/2": "1/7"},
        {1: "1/5"},
        asy.Oscillator({2: "1/10"}, x0="3/5", v0="-4/5"),
        asy.Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="1/5"),  # a strength of roots
    ],
)
def test_sympy_has_the_strength_that_was_given(law):
    found, letters = asy.solution(law, order=2), asy.solution(law, order=2, symbolic=True)
    point = found.at(7, digits=12)
    for expression, kept, number in (
        (found.amplitude, letters.amplitude, point.amplitude),
        (found.phase, letters.phase, point.phase),
        (found.x, letters.x, point.x),
    ):
        assert expression.free_symbols <= {tau} and (
            {epsilon, epsilon_0} & kept.free_symbols or kept == 0
        )  # failed before
        # numbers() puts the letters in by itself, in mpmath.
        assert float(expression.subs(tau, 7).evalf(20)) == pytest.approx(float(number), abs=1e-11)


def test_the_end_of_validity_has_the_strength_too():
    end = asy.solution({"1/2": "1/10"}, order=2)
    assert end.valid_until.is_number and epsilon in end.formulas.valid_until.free_symbols
    assert "epsilon = 1/10" in end.to_dict()["where"] and "epsilon = 1/10" in str(end).splitlines()


def test_a_sum_has_its_strengths_in_its_quadratures():
    found = asy.solution(asy.Oscillator({1: "1/10", 2: "1/20"}, x0="3/5", v0="-4/5"), order=2)
    amplitude = {sympy.Symbol("A", positive=True)}
    kept = asy.solution({1: "1/10", 2: "1/20"}, order=1, symbolic=True).time_of_amplitude
    assert found.time_of_amplitude.free_symbols <= amplitude and found.phase_of_amplitude.free_symbols <= amplitude
    assert len(kept.free_symbols) == 3
    with pytest.raises(asy.InputError, match="symbolic"):
        asy.solution({2: "1/10"}, symbolic="yes")
