"""The turning-point gauge: residual zero, the engine's p_k and Omega_k, near misses, the map to the other gauge."""

import random

import pytest
from flint import fmpq
from sympy import Integer, Rational, cos, diff, lambdify, sin, symbols
from sympy.core.function import AppliedUndef

import asymptotics as asy
from asymptotics.errors import InputError, LimitError
from asymptotics.expansions.half_swings.pi_ring import PI, PiNumber
from asymptotics.expansions.half_swings.symbolic import alpha
from asymptotics.expansions.multiple_scales.exact import odd_hierarchy
from asymptotics.expansions.multiple_scales.hierarchy import any_start, map_of_gauges
from asymptotics.expansions.multiple_scales.open_orders import first_wave, psi, second_wave
from asymptotics.expansions.multiple_scales.orders import a, epsilon
from asymptotics.expansions.multiple_scales.turning import turning_hierarchy
from asymptotics.expansions.normal_form.expansion import exact_expansion
from asymptotics.terms import Term
from paper_checks.verdict import Outcome
from tests.second_route.multiscale_observables import flow_in
from tests.second_route.turning_residual import turning_outcome, turning_residual, with_rate

PENDULUM = Term(1, 0, 3, "position", "pendulum")


def random_laws(count, seed):
    """Sums of one to three integer exponents, some with a spring or a factor x^2, and an order."""
    draw = random.Random(seed)
    for _ in range(count):
        laws = [Term(1, x) for x in draw.sample(range(7), draw.choice((1, 1, 2, 2, 3)))]
        extra = [Term(1, 0, draw.choice((3, 5)), "position"), Term(1, 2, 3, "position"), Term(1, draw.randint(0, 3), 2)]
        laws += draw.sample([*extra, PENDULUM], draw.choice((0, 0, 1)))
        yield laws, draw.randint(2, {1: 8, 2: 5, 3: 4, 4: 3}[len(laws)])


@pytest.mark.parametrize(("laws", "order"), list(random_laws(20, seed=20)), ids=str)
def test_random_sums_have_the_rates_of_the_half_swing_engine(laws, order):
    solved, engine = turning_hierarchy(laws, order), exact_expansion(laws, order)
    assert solved.p.coefficients and (solved.p - engine.p).coefficients == {}
    assert (solved.Omega - engine.Omega).coefficients == {}


@pytest.mark.parametrize(("laws", "order"), list(random_laws(6, seed=7)), ids=str)
def test_the_residual_is_identically_zero_and_a_wrong_rate_is_refuted(laws, order):
    solved = turning_hierarchy(laws, order)
    assert turning_outcome(solved) is Outcome.CONFIRMED
    for series in (solved.p, solved.Omega):
        for key, c in series.coefficients.items():
            wrong = with_rate(solved, key, c * fmpq(1000001, 1000000))
            assert turning_outcome(wrong) is Outcome.REFUTED
            assert min(map(sum, turning_residual(wrong))) == sum(key)


def test_a_rate_that_should_vanish_is_refuted():
    solved = turning_hierarchy((2,), 4)
    assert turning_outcome(with_rate(solved, (4,), PiNumber.rational(fmpq(1, 1000)))) is Outcome.REFUTED


@pytest.mark.parametrize("order", [8, 12])
def test_the_quadratic_law_to_high_order(order):
    solved, engine = turning_hierarchy((2,), order), exact_expansion((2,), order)
    assert (solved.p - engine.p).coefficients == {} and (solved.Omega - engine.Omega).coefficients == {}
    assert solved.p[3] == PiNumber.rational(fmpq(2, 135)) / PI and solved.Omega[4] == fmpq(-7, 432)


@pytest.mark.parametrize("laws", [(3,), (1, 3), (5,), (Term(1, 1), Term(1, 1, 2)), (Term(1, 3), PENDULUM)], ids=str)
def test_both_gauges_of_smooth_forces_are_joined_by_the_map(laws):
    through_the_map, direct = flow_in(odd_hierarchy(laws, 5), "turning-point"), turning_hierarchy(laws, 5)
    assert (through_the_map.p - direct.p).coefficients == {}
    assert (through_the_map.Omega - direct.Omega).coefficients == {}


def test_the_map_takes_one_waveform_to_the_other():
    order = 3
    change = map_of_gauges(3, order=order)
    smooth, turning = (asy.multiple_scales(3, order=order, gauge=g) for g in ("no-first-harmonic", "turning-point"))
    values = {a: Rational(9, 10), psi: Rational(7, 5)}
    inner = {a: change["A"], psi: change["psi_tp"]}
    gap = (turning.waveform.subs(inner, simultaneous=True) - smooth.waveform).subs(values, simultaneous=True)
    size = [abs(gap.subs(epsilon, e).evalf(40)) for e in (Rational(1, 20), Rational(1, 40))]
    assert 14 < size[0] / size[1] < 18 and size[1] > 0  # order 4, and no smaller
    with pytest.raises(InputError, match="gauge"):
        map_of_gauges(2)


@pytest.mark.parametrize("x", [0, 2, 3, 4, 5])
def test_the_closed_waves_of_general_exponents_are_the_polynomials(x):
    solved = turning_hierarchy((x,), 2)
    for n, closed in ((1, first_wave(Integer(x))), (2, second_wave(Integer(x)))):
        here, there = lambdify(psi, closed, "mpmath"), lambdify(psi, solved.X[n][n,].to_sympy(), "mpmath")
        assert all(abs(here(t) - there(t)) < 1e-12 for t in (0.1, 1.2, 1.5707, 2.0, 3.1))


@pytest.mark.parametrize(
    ("law", "order"), [("1/2", 12), ("sqrt(2)", 12), ("symbolic", 12), (["1/2", 2], 5), ({("3/2", 2): 1}, 5)], ids=str
)
def test_no_order_is_refused_and_every_letter_is_defined(law, order):
    found = asy.multiple_scales(law, order=order)
    assert len(found.orders) == order + 1
    defined = {letter(e.lhs) for one in found.orders for e in (*one.where, one.solution)}
    shown = [e for one in found.orders[1:] for e in (one.equation.rhs, one.solution.rhs, *(w.rhs for w in one.where))]
    assert {letter(f) for e in shown for f in e.atoms(AppliedUndef)} <= defined
    rates = {s for one in found.orders for s in (e.lhs for e in one.solvability)}
    assert {s for e in shown for s in e.free_symbols} <= rates | {*found.symbols, a, psi, alpha}


def letter(applied):
    return applied.func.__name__


def test_certified_digits_stand_where_nothing_is_closed():
    found = asy.multiple_scales("3/2", order=5)
    p_5 = -found.amplitude_rate.subs(a, 1).coeff(epsilon, 5)
    engines = asy.expand("3/2", order=5, digits=25).to_dict()["amplitude"]["5"]["value"]
    assert str(p_5.evalf(25)) == engines and not engines.startswith("0.0000000000")
    assert "K_5" in str(found.orders[5].conditions[0][1])


def test_too_much_work_is_refused_with_its_estimate():
    with pytest.raises(LimitError, match="order 60 would take about"):
        asy.multiple_scales([0, 1, 2, 4], order=60)


@pytest.mark.parametrize("laws", [(2,), (0,), (1, 2), (3,)], ids=str)
def test_a_start_in_motion_lies_on_the_solution_to_its_order(laws):
    order = 3
    scales = asy.multiple_scales(list(laws), order=order, gauge="turning-point")
    found, (r, theta) = any_start(scales), symbols("r theta", positive=True)
    theta = next(s for s in found["psi(0)"].free_symbols if s.name == "theta")
    velocity = scales.amplitude_rate * diff(scales.waveform, a) + scales.phase_rate * diff(scales.waveform, psi)
    gaps = []
    for size in (Rational(1, 50), Rational(1, 100)):
        values = {r: 1, theta: Rational(6, 5), **{s: size * (i + 1) for i, s in enumerate(scales.symbols)}}
        inside = {a: found["a(0)"].subs(values), psi: found["psi(0)"].subs(values)}
        X, V = (e.subs(values).subs(inside).evalf(30) for e in (scales.waveform, velocity))
        gaps.append(abs(X - cos(Rational(6, 5)).evalf(30)) + abs(V + sin(Rational(6, 5)).evalf(30)))
    assert gaps[1] == 0 or 2 ** (order + 0.7) < gaps[0] / gaps[1] < 2 ** (order + 1.6)


def test_a_start_needs_waves_in_closed_form():
    with pytest.raises(InputError, match="start"):
        any_start(asy.multiple_scales("3/2", spring={3: 1}))
