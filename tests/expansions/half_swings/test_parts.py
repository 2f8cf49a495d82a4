"""The parts on which a proved tail rests, each alone: the majorant, the order, the reach, the integrals of I_4."""

import mpmath
import pytest
from flint import arb, arb_poly, ctx

from asymptotics.expansions.half_swings import finite_majorant
from asymptotics.expansions.half_swings.certified import enclose, quarter_swing, tail_constants, terms_needed
from asymptotics.expansions.half_swings.certified_orders import bound_ring, indices, integrate_series, order_series
from asymptotics.expansions.half_swings.certified_zeros import certified_half_swing, duration_vanishes
from asymptotics.expansions.half_swings.finite_majorant import _extremes, _Step, majorant, widest
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.expansions.half_swings.symbolic import (
    RADIUS,
    _integrate,
    alpha,
    field_half_swing,
    nested_integral_definition,
    nested_integral_exact,
)
from asymptotics.numbers.exact import parse_real
from tests.second_route.quarter_series import finite_quarter


def real(text):
    return parse_real(text, "alpha")


@pytest.mark.parametrize("exponent", ["0", "2", "3"])
def test_the_final_strength_and_its_inverse_are_bounded_and_nearly_attained(exponent):
    """u = delta e^((alpha - 1) R) at the passage; its size and that of 1/u are largest at delta = -rho and rho."""
    with ctx.workprec(100):
        a = real(exponent).ball()
        rho = widest([a], [arb(1)]).radii[0] / 5
        bound, quarter = majorant([a], [rho]), finite_quarter([real(exponent)], [rho], 60)
        ends = [abs(d * ((a - 1) * quarter.R([d], quarter._tail(quarter.R, [d]))).exp()) for d in (rho, -rho)]
        largest, smallest = max(ends, key=float), min(ends, key=float)
        assert largest < bound.final(0) < largest * arb("1.3")
        assert 1 / smallest < bound.inverse() < 1 / smallest * arb("1.3")
        with ctx.workprec(300):  # rounded to the safe side
            assert bound.inverse() >= 1 / bound.radii[0] + abs(a - 1) * bound.gains[0]
        inside = (bound.inverse() - 1 / rho) / 2 + 1 / rho  # with half the gain it would be no bound
        assert not 1 / smallest < inside


@pytest.mark.parametrize("exponent", ["1/2", "2"])
def test_the_extremes_on_a_piece_are_the_largest_values_on_it(exponent):
    a, pieces = real(exponent).ball(), 6
    for j, ((power,), (product,)) in enumerate(_extremes(((a.mid().man_exp(), a.rad().man_exp()),), pieces)):
        start, end = (arb.pi() * (j + i) / (2 * pieces) for i in (0, 1))
        at = [start + (end - start) * k / 50 for k in range(51)]
        values = [[float(x.sin() ** (a + 1)) for x in at], [float(x.sin() ** a * x.cos()) for x in at]]
        assert max(values[0]) <= float(power) * (1 + 1e-12) and float(power) <= max(values[0]) * (1 + 1e-12)
        assert max(values[1]) <= float(product) <= float(end.sin() ** a * start.cos()) * (1 + 1e-12)


def test_one_piece_for_the_whole_quarter_is_done_by_hand():
    """s = 1 and s^a c <= 1 throughout, so C* = rho e^G with the G of the end."""
    rho = arb("0.05")
    bound = majorant([arb(2)], [rho], pieces=1)
    C, half_pi = rho * bound.growth.exp(), arb.pi() / 2
    for found, truth in ((bound.excess, half_pi * (1 / (1 - C) - 1)), (bound.gains[0], half_pi / (1 - C))):
        assert truth * (1 - arb(1e-12)) < found < truth * (1 + arb(1e-9))


@pytest.mark.parametrize("exponent", ["1/2", "3/2", "3"])
def test_the_bounds_of_the_first_order_are_attained_on_the_circle(exponent):
    """At theta = i pi, |t| = 4: g = pi sinh pi, c = cosh pi, y_1 = (sinh pi/pi)^alpha and
    e^(-i theta) c = (1 + e^(2 pi))/2; the factors of the moments by hand, each of them attained there."""
    a, pi = real(exponent).ball(), arb.pi()
    R, T, *K = tail_constants(Forces.losses([real(exponent)]), 2, 4, True)
    scale, y, last = (pi / 2) ** a, (pi.sinh() / pi) ** a, (1 + (2 * pi).exp()) / 2
    d, w = pi.cosh() * y, pi * pi.exp() * y / (a + 1)
    known = [(R[(1,)], scale * pi * pi.sinh() * y), (T[(1,)], scale * pi / 2 * pi.cosh() * y)]
    known += [(K[2 * k][(0,)], (pi / 2) ** (k + 1) * last) for k in range(3)]
    known += [(K[0][(1,)], scale * pi / 2 * last * (d + w))]
    known += [(K[2][(1,)], scale * (pi / 2) ** 2 * last * (d + w + d / (a + 1)))]
    for bound, value in known:
        assert value * (1 - arb(1e-12)) < bound < value * (1 + arb(1e-12))


@pytest.mark.parametrize("exponent", ["1/2", "3/2", "3"])
def test_the_bound_of_an_integral_is_attained_and_the_second_order_uses_it(exponent):
    """I_n t = t/(n·alpha + 2), the largest of all t^j; y_2 by hand: p_1 = |alpha - 1| g y_1/(alpha + 2)."""
    a, pi = real(exponent).ball(), arb.pi()
    ring = bound_ring(Forces.losses([real(exponent)]), 4)
    for n in (0, 1, 2):
        bound = ring.integrate(arb(1), n * a)
        first, *more = (abs(integrate_series(arb_poly([0] * j + [arb(1)]), n * a)(arb(1))) for j in (1, 2, 5))
        assert first * (1 - arb(1e-12)) <= bound <= first * (1 + arb(1e-12)) and all(m < bound for m in more)
    y = (pi.sinh() / pi) ** a
    second = y * abs(a - 1) * pi * pi.sinh() * y / (a + 2) + pi.cosh() * y * y
    found = order_series(ring, indices(1, 2))[(2,)]
    assert second * (1 - arb(1e-12)) < found < second * (1 + arb(1e-12))


def test_the_tail_of_a_power_series_is_that_of_its_bound():
    """Sum over k >= K of B r^-k/(2 k) at most, nearly attained by coefficients that are all as large as their bound."""
    for radius, terms in ((2, 50), (3, 20), (4, 9)):
        cut = enclose({(1,): arb(0)}, {(1,): arb(7)}, radius, terms)[(1,)].rad()
        whole = sum((7 * arb(radius) ** -k / (2 * k) for k in range(terms, 40 * terms)), arb(0))
        assert whole < cut < whole * arb("1.1")
    for bits in (8, 12, 40):
        terms = terms_needed([{(1,): arb(1)}], 4, bits)
        assert enclose({(1,): arb(0)}, {(1,): arb(1)}, 4, terms)[(1,)].rad() < arb(2) ** (-bits - 3)


def test_the_duration_is_even_where_no_loss_bends_the_amplitude():
    linear, quadratic = Forces.losses([real("1")]), Forces.losses([real("2")])
    assert [duration_vanishes(linear, (n,)) for n in (1, 2, 3, 4)] == [True, False, True, False]
    assert [duration_vanishes(quadratic, (n,)) for n in (1, 2, 3, 4)] == [True, False, False, False]


@pytest.mark.parametrize("exponents", [("0", "3/2"), ("2", "0"), ("0", "sqrt(2)")])
def test_dry_friction_by_the_shifted_centre_is_dry_friction_by_the_quarter_swing(exponents):
    alphas = tuple(map(real, exponents))
    with ctx.workprec(100):
        shifted, plain = certified_half_swing(alphas, 3), half_swing(quarter_swing(alphas, 3))
        for ours, theirs in ((shifted.L, plain.L), (shifted.T, plain.T)):
            for key in {*ours.coefficients, *theirs.coefficients}:
                difference = arb(ours.coefficients.get(key, 0)) - arb(theirs.coefficients.get(key, 0))
                assert difference.contains(0) and difference.rad() < 1e-20, key


def test_an_end_that_was_not_proved_is_refused(monkeypatch):
    step = _Step(arb("0.1"), [arb("0.5")], [arb(1)], [arb(1)], [arb("0.5")])
    found = step.upper_end(arb(0))
    assert found is not None
    for share in (0.9, 0.99, 0.999):
        monkeypatch.setattr(finite_majorant, "_fixed_point", lambda *given, share=share: float(found) * share)
        assert step.upper_end(arb(0)) is None
    monkeypatch.setattr(finite_majorant, "_fixed_point", lambda *given: float(found) * 1.01)
    assert step.upper_end(arb(0)) is not None


@pytest.mark.parametrize("terms", [1, 2, 5])
def test_the_tail_of_an_integral_is_needed(terms):
    """y_j = R^(-2 j) attains Cauchy's bound with B = 1; for a large power of theta the bound is nearly attained."""
    y, e = [arb(RADIUS) ** (-2 * j) for j in range(400)], arb(60)
    with ctx.workprec(200):
        value, found = _integrate(y, e, arb(1)), _integrate(y[:terms], e, arb(1))
        assert found.contains(value.mid())
        assert not (found.mid() + arb(0, found.rad() / 2)).overlaps(value)
        assert _integrate(y[:terms], e, arb(2)).rad() > found.rad() * arb("1.99")


@pytest.mark.parametrize("n", [1])
def test_the_integral_that_defines_i_4_is_i_4(n):
    shown = nested_integral_definition().subs(alpha, n).doit()
    with mpmath.workdps(20):
        assert (
            abs(mpmath.mpmathify(shown.evalf(20)) - mpmath.mpf(nested_integral_exact(n).ball().str(20, radius=False)))
            < 1e-15
        )


def test_the_symbolic_half_swing_is_what_it_was_computed_to_be():
    cached, anew = field_half_swing(), field_half_swing.__wrapped__()
    assert [cached.T[k] for k in range(5)] == [anew.T[k] for k in range(5)]
    assert [cached.L[k] for k in range(5)] == [anew.L[k] for k in range(5)]


def test_some_variables_by_themselves_are_the_forces_that_they_make():
    both = Forces.read((real("1"), real("5/2")), 4)
    for place, text in enumerate(("1", "5/2")):
        alone, here = Forces.read((real(text),), 4), both.only([place], 4)
        assert here.members == alone.members != ()
        assert (here.weights, here.signs, here.velocities) == (alone.weights, alone.signs, alone.velocities)
