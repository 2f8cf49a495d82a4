"""Initial conditions, gauges and half-swings of the classical route against the engine, exactly."""

import pytest
from flint import fmpq

from asymptotics.expansions.half_swings.exact import exact_half_swing, exact_quarter_swing
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.expansions.multiple_scales.exact import odd_hierarchy
from asymptotics.expansions.multiple_scales.initial import initial_conditions, map_to_turning_points
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.gauges import GAUGES
from tests.each import each
from tests.second_route.multiscale_observables import flow_in, half_swing_of
from tests.second_route.multiscale_residual import with_amplitude_coefficient

LAWS = [((1,), 6), ((3,), 6), ((5,), 6), ((1, 3), 4), ((3, 5), 4)]


@pytest.mark.parametrize(("alphas", "order"), LAWS)
def test_turning_amplitudes_and_half_periods_are_the_engines(alphas, order):
    found, engine = half_swing_of(odd_hierarchy(alphas, order)), exact_half_swing(alphas, order)
    assert (found.L - engine.L).coefficients == {}
    assert (found.T - engine.T).coefficients == {}
    assert all((f - g).coefficients == {} for f, g in zip(found.F, engine.F))


def test_and_those_of_the_reversal_identity():
    found, engine = half_swing_of(odd_hierarchy((3,), 4)), half_swing(exact_quarter_swing((3,), 4))
    assert (found.L - engine.L).coefficients == {}
    assert (found.T - engine.T).coefficients == {}


def test_a_wrong_third_order_is_seen_in_the_turning_amplitudes():
    wrong = with_amplitude_coefficient(odd_hierarchy((3,), 4), (3,), fmpq(567, 8192))
    assert (half_swing_of(wrong).L - exact_half_swing((3,), 4).L)[3] != 0


@pytest.mark.parametrize(("alphas", "order"), LAWS)
def test_initial_conditions_are_the_bracket_of_the_gauge(alphas, order):
    own = map_to_turning_points(odd_hierarchy(alphas, order)).inverse()
    engine = exact_expansion(alphas, order, "no-first-harmonic").gauge_map
    assert (own.log_modulus - engine.log_modulus).coefficients == {}
    assert (own.argument - engine.argument).coefficients == {}


def test_initial_conditions_of_linear_damping():
    # a(0) cos psi_0 = 1, tan psi_0 = -(eps/2)/sqrt(1 - eps^2/4), a(0) = 1/sqrt(1 - eps^2/4)
    start = initial_conditions(odd_hierarchy((1,), 4))
    assert [start.amplitude[n] for n in (2, 4)] == [fmpq(1, 8), fmpq(3, 128)]
    assert [start.phase[n] for n in (1, 3)] == [fmpq(-1, 2), fmpq(-1, 48)]  # -arcsin(eps/2)


@each("gauge", GAUGES)
@each(("alphas", "order"), LAWS)
def test_every_gauge(alphas, order, gauge):
    found, engine = flow_in(odd_hierarchy(alphas, order), gauge), exact_expansion(alphas, order, gauge)
    assert (found.p - engine.p).coefficients == {}
    assert (found.Omega - engine.Omega).coefficients == {}
