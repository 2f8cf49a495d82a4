"""Any exponent to second order: the engine's closed forms, and its exact and certified half-swings."""

import pytest
from flint import arb, ctx
from sympy import Float, I, Integer, Rational, Symbol, gammasimp, pi, simplify, sqrt

import asymptotics as asy
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.certified_zeros import certified_half_swing
from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.moments.symbolic import moment
from asymptotics.expansions.multiple_scales.exact import odd_hierarchy
from asymptotics.expansions.multiple_scales.harmonics import velocity_sum
from asymptotics.expansions.multiple_scales.initial import initial_conditions
from asymptotics.expansions.multiple_scales.open_orders import open_scales
from asymptotics.expansions.multiple_scales.powers import Powers
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.expansions.normal_form.in_moments import second_order_sum
from asymptotics.expansions.normal_form.symbolic import alpha, omega_2
from asymptotics.gauges import GAUGES
from asymptotics.numbers.bridge import closed_form_ball, to_sympy
from asymptotics.numbers.exact import parse_real
from tests.second_route.observables_of_powers import half_period, log_ratio


@pytest.mark.parametrize("gauge", GAUGES)
def test_symbolic_exponent_is_the_engines_in_every_gauge(gauge):
    assert simplify(gammasimp(Powers((alpha,)).Omega(gauge)[(2,)] - omega_2(gauge))) == 0


@pytest.mark.parametrize("gauge", GAUGES)
@pytest.mark.parametrize("x", [0, 2, 4])
def test_even_exponents_are_the_exact_brackets_of_the_quarter_swing(x, gauge):
    engine = exact_expansion((x,), 2, gauge)
    assert simplify(Powers((Integer(x),)).Omega(gauge)[(2,)] - as_sympy(engine.Omega[2])) == 0


def test_gauges_differ():
    found = {Powers((Integer(3),)).Omega(gauge)[(2,)] for gauge in GAUGES}
    assert found == {Rational(-45, 256), Rational(-27, 256), Rational(9, 256)}


@pytest.mark.parametrize("x", [0, 1, 2, 3, 4, 5])
def test_observables_of_integer_exponents(x):
    found, engine = Powers((Integer(x),)), exact_half_swing((x,), 2)
    for n in (1, 2):
        assert simplify(log_ratio(found)[(n,)] - as_sympy(engine.L[n])) == 0
    assert simplify(half_period(found)[(2,)] - as_sympy(engine.T[2])) == 0


@pytest.mark.parametrize("laws", [("1/2",), ("3/2",), ("5/2",), ("0", "3/2"), ("1/2", "5/2")])
def test_observables_of_other_exponents_against_certified_half_swings(laws):
    found = Powers(tuple(Rational(x) for x in laws))
    with ctx.workprec(120):
        engine = certified_half_swing([parse_real(x, "--alpha") for x in laws], 2)
        for key, value in log_ratio(found).items():
            assert meets(value, engine.L[key])
        for key, value in half_period(found).items():
            assert meets(value, engine.T[key])
            assert not meets(value + Rational(1, 10**20), engine.T[key])


def as_sympy(c):
    return c.to_sympy() if hasattr(c, "to_sympy") else to_sympy(c)


def meets(value, ball):
    ball = arb(ball)
    return ball.overlaps(closed_form_ball(value)) and ball.rad() < arb(10) ** -25


def test_two_laws_are_the_engines():
    W = second_order_sum((Rational(1, 2), Integer(2)), moment)
    Omega = Powers((Rational(1, 2), Integer(2))).Omega("turning-point")
    assert all(simplify(Omega[key] + value) == 0 for key, value in W.items())


@pytest.mark.parametrize("x", [1, 3, 5])
def test_odd_exponents_are_those_of_the_exact_hierarchy(x):
    general, exact = Powers((Integer(x),)), odd_hierarchy((x,), 2)
    assert general.p()[1,] == to_sympy(exact.p[1])
    assert general.Omega()[(2,)] == to_sympy(exact.Omega[2])
    turning_phase = -Rational(x + 3, 2 * (x + 1)) * moment(Integer(x + 1))  # of a turning point, to first order
    assert turning_phase == to_sympy(initial_conditions(exact).phase[1])


def test_the_delta_function_of_dry_friction_counts():
    dry = Powers((Integer(0),))
    assert dry.Omega()[(2,)] == -6 / pi**2
    assert half_period(dry)[(2,)] == 0  # the half period of dry friction is exactly pi
    # without that term: 2 a g_2 - alpha p^2 a^(2 alpha - 1) = 0, so Omega_2 = 0, and the half period is not pi
    change = dry.Omega("turning-point")[(2,)] - dry.Omega()[(2,)]
    assert change != 0


def test_solvability_closes_the_sum_over_harmonics():
    x = Rational(3, 2)
    p = Powers((x,)).p()[1,]
    closed = (x - 2) * p**2 / 2 - velocity_sum(x, x) / 2
    assert simplify(gammasimp(closed - Powers((x,)).Omega()[(2,)])) == 0


@pytest.mark.parametrize("alphas", [(Integer(-1),), (Float(1.5),), (I,), (Symbol("x"),), (1.5,)])
def test_bad_exponents_are_refused(alphas):
    with pytest.raises(InputError, match="alpha"):
        open_scales(alphas, (), 2)


def test_surds_are_exact():
    assert Powers((sqrt(2),)).Omega("turning-point")[(2,)].has(sqrt(2))
    with pytest.raises(InputError, match="gauge"):
        Powers((Integer(2),)).Omega("nobody")


def test_a_huge_integer_exponent_is_answered_and_has_the_rates_of_the_engine():
    scales, engine = asy.multiple_scales(1000, order=2), asy.expand(1000, order=2, digits=15)
    one = dict.fromkeys(scales.amplitude_rate.free_symbols, 1)
    assert abs(scales.amplitude_rate.subs(one).n(30) + Float(engine.p[1].value, 30)) < Float(10) ** -16
    assert abs(scales.phase_rate.subs(one).n(30) - 1 - Float(engine.Omega[2].value, 30)) < Float(10) ** -15
