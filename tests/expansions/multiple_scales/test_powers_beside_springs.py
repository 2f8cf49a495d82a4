"""Any exponent beside springs by the classical route: against the exact, the certified and the closed second order.

The near misses: a spring with the sign of a loss, parity by the total degree, and (p - 1) for (p - alpha) in the cross
term, which agrees at alpha = 1 and nowhere else.
"""

import numpy as np
import pytest
import sympy
from flint import arb, ctx
from sympy import Integer, Rational, Symbol, simplify, sqrt

import asymptotics as asy
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.certified_zeros import certified_half_swing
from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.moments import symbolic as moments
from asymptotics.expansions.moments.symbolic import mean, moment
from asymptotics.expansions.multiple_scales.exact import odd_hierarchy
from asymptotics.expansions.multiple_scales.harmonics import displacement_sum, harmonic, spring_sum
from asymptotics.expansions.multiple_scales.orders import a
from asymptotics.expansions.multiple_scales.powers import Powers
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.expansions.normal_form.spring_terms import cross_term
from asymptotics.gauges import GAUGES
from asymptotics.numbers.bridge import closed_form_ball, to_sympy
from asymptotics.numbers.exact import parse_real
from asymptotics.terms import Term
from tests.each import each
from tests.second_route.harmonic_sums import cosine_harmonic, cross_sum
from tests.second_route.observables_of_powers import half_period, log_ratio

SPRINGS = {p: Term(1, 0, p, "position") for p in (1, 2, 3, 4, 5)}
PENDULUM = Term(1, 0, 3, "position", "pendulum")
alpha = Symbol("alpha", nonnegative=True)


def as_sympy(c):
    return c.to_sympy() if hasattr(c, "to_sympy") else to_sympy(c)


def differ(closed, series):
    keys = set(closed) | {key for key in series.coefficients if any(key)}
    return [key for key in keys if simplify(closed.get(key, 0) - as_sympy(series[key])) != 0]


@pytest.mark.parametrize("x", [0, 1, 2, 3])
@pytest.mark.parametrize("spring", [SPRINGS[2], SPRINGS[3], PENDULUM], ids=["x|x|", "x^3", "pendulum"])
def test_integer_exponents_are_those_of_the_exact_engine_in_every_gauge(x, spring):
    found, terms = Powers((Integer(x),), (spring,)), [Term(1, x), spring]
    for gauge in GAUGES:
        engine = exact_expansion(terms, 2, gauge)
        assert differ(found.p(gauge), engine.p) == []
        assert differ(found.Omega(gauge), engine.Omega) == []
    swing = exact_half_swing(terms, 2)
    assert differ(log_ratio(found), swing.L) == [] and differ(half_period(found), swing.T) == []


def test_two_losses_and_two_springs_have_all_their_products():
    terms = [Term(1, 0), Term(1, 2), SPRINGS[2], SPRINGS[5]]
    found, swing = Powers((Integer(0), Integer(2)), (SPRINGS[2], SPRINGS[5])), exact_half_swing(terms, 2)
    assert differ(log_ratio(found), swing.L) == [] and differ(half_period(found), swing.T) == []
    assert len(found.p()) == 2 + 4 and len(found.Omega()) == 2 + 3 + 3


@pytest.mark.parametrize("loss", ["1/2", "3/2", "5/2", "sqrt(2)"])
@pytest.mark.parametrize("p", [2, 3])
def test_other_exponents_lie_in_the_certified_balls(loss, p):
    found = Powers((sqrt(2) if loss == "sqrt(2)" else Rational(loss),), (SPRINGS[p],))
    with ctx.workprec(90):
        engine = certified_half_swing([Term(1, parse_real(loss, "--alpha")), SPRINGS[p]], 2)
    for closed, series in ((log_ratio(found), engine.L), (half_period(found), engine.T)):
        for key, value in closed.items():
            with ctx.workprec(300):
                fine = closed_form_ball(sympy.N(0) if value == 0 else value)
            ball = arb(series[key])
            assert ball.rad() < arb(10) ** -16
            assert ball.contains(fine)
            assert not ball.contains(fine + arb(10) ** -14)


@pytest.mark.parametrize("p", [2, 3, 5])
def test_symbolic_exponents_are_the_engines_closed_cross_term(p):
    forces = Powers((alpha,), (SPRINGS[p],))
    P, Q = moment(alpha + 1), moment(Integer(p) + 1)
    engine = -cross_term(alpha, 0, p, moments) + P * Q  # p = -U/W
    found = forces.p("turning-point")[1, 1]
    assert simplify(sympy.gammasimp((found - engine) / P)) == 0
    # near miss: (p - 1) for (p - alpha) agrees at alpha = 1 and nowhere else
    U = ((p - 1) * mean(0, alpha + 1) + p * mean(p - 1, alpha + 1)) / (p + 1)
    gap = sympy.gammasimp((found + U - P * Q) / P)
    assert simplify(gap.subs(alpha, 1)) == 0
    assert all(simplify(gap.subs(alpha, x)) != 0 for x in (0, Rational(3, 2), 2, 3))


@pytest.mark.parametrize("x", [1, 3])
@pytest.mark.parametrize("spring", [SPRINGS[3], SPRINGS[5], PENDULUM], ids=["x^3", "x^5", "pendulum"])
def test_odd_exponents_are_those_of_the_exact_hierarchy(x, spring):
    general, exact = Powers((Integer(x),), (spring,)), odd_hierarchy([Term(1, x), spring], 2)
    assert differ(general.p(), exact.p) == [] and differ(general.Omega(), exact.Omega) == []


def test_a_spring_with_the_sign_of_a_loss_is_refuted():
    """The spring meets X_1 of the loss with +1; with the sign of a loss alpha - 1 would stand for alpha + 1."""
    x, p = Integer(2), Integer(3)
    right, swing = Powers((x,), (SPRINGS[3],)), exact_half_swing([Term(1, 2), SPRINGS[3]], 2)
    wrong = right.p()[1, 1] - cross_sum(x, p)
    observed = -sympy.pi * (wrong - right.p()[1, 1])
    assert simplify(log_ratio(right)[1, 1] - as_sympy(swing.L[1, 1])) == 0
    assert simplify(log_ratio(right)[1, 1] + observed - as_sympy(swing.L[1, 1])) != 0
    assert simplify(half_period(right)[0, 1] + as_sympy(swing.T[0, 1])) != 0  # the phase turns the other way


def test_parity_counts_the_losses():
    """By the total degree p would have no term rho gamma and Omega no gamma: both are there, and right."""
    forces, swing = Powers((Integer(2),), (SPRINGS[3],)), exact_half_swing([Term(1, 2), SPRINGS[3]], 2)
    assert as_sympy(swing.L[1, 1]) != 0 and as_sympy(swing.T[0, 1]) != 0
    assert {key for key in forces.p() if sum(key) == 2} == {(1, 1)}
    assert (1, 1) not in forces.Omega() and (0, 1) in forces.Omega()


@pytest.mark.parametrize(("x", "y"), [(Rational(3, 2), 2), (0, 4), (Rational(1, 2), 3), (2, 2), (3, 5)])
def test_the_sums_over_harmonics_by_direct_summation(x, y):
    x, y = Integer(x) if isinstance(x, int) else x, Integer(y)
    odd = range(3, 400, 2)
    b, d = ([float(f(e, 3))] for f, e in ((harmonic, x), (cosine_harmonic, y)))
    for n in odd[:-1]:
        b.append(b[-1] * float((n - x) / (n + x + 2)))
        d.append(-d[-1] * float((n - y) / (n + y + 2)))
    n, b, d = np.array(odd), np.array(b), np.array(d)
    assert np.sum(n * b * d / (n**2 - 1)) == pytest.approx(float(cross_sum(x, y)), abs=1e-9)
    assert np.sum(d * d / (n**2 - 1)) == pytest.approx(float(spring_sum(y, y)), abs=1e-9)
    assert np.sum(d / (n**2 - 1)) == pytest.approx(float(displacement_sum(y)), abs=1e-7)


def test_the_public_function_and_its_words():
    found = asy.multiple_scales("3/2", spring={3: "1/10", 2: 1})
    assert [str(s) for s in found.symbols] == ["epsilon", "c_0", "c_1"]
    assert "x^3" in repr(found) and found.amplitude_rate.has(a)
    assert asy.multiple_scales("symbolic", spring={3: 1}).phase_rate.has(alpha)
    air = asy.multiple_scales(2, spring="pendulum")
    assert air.initial_amplitude == 1 and air.orders[2]._repr_latex_().startswith("$")
    assert asy.multiple_scales(asy.Law({}, spring={2: 1})).amplitude_rate == 0


@each(
    ("law", "spring", "order", "gauge", "argument"),
    [
        ("3/2", {3: 1}, 13, None, "order"), (1, {2: 1}, 4, None, "order"), ({(2, 1): 1}, None, 3, None, "order"),
        ("3/2", {"1/2": 1}, 2, None, "spring"), ("3/2", {0: 1}, 2, None, "spring"), (2, None, 0, None, "order"),
        ("symbolic", 3, 2, None, "spring"), (2, None, 2, "no-first-harmonic", "gauge"), (2, None, 61, None, "order"),
        (3, None, 2, "averaging", "gauge"), (3, None, 2, "nobody", "gauge"), (-2, None, 2, None, "alpha"),
        ("symbolic", None, 2, "no-first-harmonic", "gauge"), ("symbolic", None, 13, None, "order"),
    ],
)  # fmt: skip
def test_what_is_not_served_is_refused_by_name(law, spring, order, gauge, argument):
    with pytest.raises(InputError, match=f"argument {argument}"):
        asy.multiple_scales(law, spring=spring, order=order, gauge=gauge)


def test_a_spring_of_power_one_is_a_change_of_the_linear_spring():
    """omega = sqrt(1 + c): Omega = c/2 - c^2/8; the loss per radian p = eps/2 (1 - c/2) + ... for alpha = 1."""
    forces = Powers((Integer(1),), (SPRINGS[1],))
    assert [forces.Omega()[key] for key in ((0, 1), (0, 2))] == [Rational(1, 2), -Rational(1, 8)]
    assert forces.p() == {(1, 0): Rational(1, 2), (1, 1): 0}
    assert Forces.of([SPRINGS[1]], 2).weights[0].is_zero
