"""The parts on which a proved tail rests, each alone: the majorant, the order, the reach, the integrals of I_4."""

from dataclasses import replace
from itertools import islice

import mpmath
import pytest
from flint import arb, arb_poly, ctx

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.half_swings.certified import enclose, quarter_swing, tail_constants, terms_needed
from asymptotics.half_swings.certified_orders import bound_ring, indices, integrate_series, order_series
from asymptotics.half_swings.certified_zeros import certified_half_swing, duration_vanishes
from asymptotics.half_swings.finite import (
    MAX_ORDER,
    FiniteQuarter,
    Tail,
    TruncatedSum,
    _order,
    _polydisc,
    finite_quarter,
    series_reach,
)
from asymptotics.half_swings.finite_majorant import _extremes, _Step, majorant, widest
from asymptotics.half_swings.forces import Forces
from asymptotics.half_swings.quarter import half_swing
from asymptotics.half_swings.symbolic import (
    RADIUS,
    _integrate,
    alpha,
    field_half_swing,
    nested_integral_definition,
    nested_integral_exact,
)
from asymptotics.numbers.exact import parse_real
from asymptotics.series import Series


def real(text):
    return parse_real(text, "alpha")


@pytest.mark.parametrize("factor", ["1.001", "1.5", "1.99", "5"])
def test_outside_the_polydisc_no_order_is_enough(factor):
    (radius,) = widest([arb(2)], [arb(1)]).radii
    with pytest.raises(LimitError, match="out of reach"):
        finite_quarter([real("2")], [radius * arb(factor)], 30)


@pytest.mark.parametrize("exponent", ["0", "3/2", "3"])
def test_the_reach_of_an_order_is_what_that_order_reaches(exponent):
    disc = _polydisc((real(exponent),), (1.0,))
    for order, bits in ((MAX_ORDER[1], 40), (12, 10)):
        reach = series_reach(real(exponent), bits, order)
        assert _order(disc, [reach], bits) <= order < _order(disc, [reach * arb("1.5")], bits)


@pytest.mark.parametrize("exponent", ["0", "2", "3"])
def test_the_final_strength_and_its_inverse_are_bounded_and_nearly_attained(exponent):
    """u = delta e^((alpha - 1) R) at the passage; its size and that of 1/u are largest at delta = -rho and rho."""
    with ctx.workprec(100):
        a = real(exponent).ball()
        rho = widest([a], [arb(1)]).radii[0] / 5
        bound, quarter = majorant([a], [rho]), finite_quarter([real(exponent)], [rho], 60)
        ends = [abs(d * ((a - 1) * quarter._R([d])).exp()) for d in (rho, -rho)]
        largest, smallest = max(ends, key=float), min(ends, key=float)
        assert largest < bound.final(0) < largest * arb("1.3")
        assert 1 / smallest < bound.inverse() < 1 / smallest * arb("1.3")
        with ctx.workprec(300):  # rounded to the safe side
            assert bound.inverse() >= 1 / bound.radii[0] + abs(a - 1) * bound.gains[0]
        inside = (bound.inverse() - 1 / rho) / 2 + 1 / rho  # with half the gain it would be no bound
        assert not 1 / smallest < inside


def test_a_tail_that_is_known_is_counted():
    quarter = finite_quarter([real("2")], [arb("0.05")], 40)
    residual = quarter._residual([arb("0.05")], arb(0), arb("-0.1"), arb("1e-5"))
    assert residual.rad() >= 1e-5


def test_a_tail_is_the_next_terms_and_a_geometric_sum():
    """2 d^3 + M sum over k > 3 of x^k, term by term."""
    M, d, x = arb("0.7"), arb("0.1"), arb("0.4")
    found = Tail(Series({(3,): arb(2)}, 1, 3), 2, 3, M)([d], x)
    whole = 2 * d**3 + sum((M * x**k for k in range(4, 200)), arb(0))
    assert whole <= found * (1 + arb(1e-12)) and found <= whole * (1 + arb(1e-12))


def test_the_majorant_of_the_polydisc_is_what_cauchy_s_inequality_takes():
    quarter = finite_quarter([real("3/2")], [arb("0.05")], 40)
    assert quarter.R.tail.cauchy >= quarter.majorant.growth and quarter.T.tail.cauchy >= quarter.majorant.excess


def test_a_root_without_a_change_of_sign_is_not_claimed(monkeypatch):
    quarter = finite_quarter([real("1/2")], [arb("0.05")], 40)
    monkeypatch.setattr(FiniteQuarter, "_residual", lambda *_: arb("0.001"))
    with pytest.raises(UndecidedError, match="not enclosed"):
        quarter._enclosed([arb("0.05")], arb(0), arb("-0.1"))


@pytest.mark.parametrize("exponent", ["1/2", "3/2"])
def test_what_is_rounded_at_a_turning_point_is_carried(exponent):
    rough, fine = (finite_quarter([real(exponent)], [arb("0.02")], bits) for bits in (20, 90))
    with ctx.workprec(24):
        found = list(islice(rough.orbit([arb(1) / 64], arb(0), arb(0)), 8))
    with ctx.workprec(120):
        true = list(islice(fine.orbit([arb(1) / 64], arb(0), arb(0)), 8))
        for (x, e, _), (right, _, _) in zip(found[1:], true[1:], strict=True):
            assert 0 < abs(x - right) < e and e < arb(2) ** -14


def test_what_is_uncertain_about_the_start_is_its_radius():
    quarter, e = finite_quarter([real("3/2")], [arb("0.05")], 40), arb(2) ** -20
    ((x, radius, _),) = islice(quarter.orbit([arb("0.02")], arb(0, e), e), 1)
    assert x == 0 and 2 * e <= radius and radius <= arb("2.001") * e


@pytest.mark.parametrize("side", [-1, 1])
def test_a_duration_is_taken_over_the_whole_ball_at_both_ends(side):
    """Were T_q = d^2, an even function, the changes at both ends would add up: neither of them may be left out."""
    square = TruncatedSum(Series({(2,): arb(1)}, 1, 2), Tail(Series({}, 1, 2), 2, 2, arb(0)))
    e = side * arb(2) ** -10
    with ctx.workprec(100):
        quarter = replace(finite_quarter([real("3/2")], [arb(1) / 32], 60), T=square)
        ((_, _, wide),) = islice(quarter.orbit([arb(1) / 40], arb(0), abs(e)), 1)
        ((_, _, end),) = islice(quarter.orbit([arb(1) / 40], e, arb(0)), 1)
        assert wide.contains(end.mid()) and abs(end - wide.mid()) > wide.rad() * arb("0.99")


def test_the_tail_that_is_shown_is_that_of_both_quarters():
    """Below alpha = 1 the local strength grows: the end lacks more than the beginning."""
    delta = [arb("0.05")]
    quarter = finite_quarter([real("1/2")], delta, 40)
    found = quarter.half_swing(delta)
    before, after = (quarter._tail(quarter.R, d) for d in (delta, quarter.strengths(delta, found.log_ratio)))
    assert before < after and before + after <= found.tail and found.tail <= arb("2.001") * after


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
        monkeypatch.setattr(_Step, "_candidate", lambda self, start, share=share: float(found) * share)
        assert step.upper_end(arb(0)) is None
    monkeypatch.setattr(_Step, "_candidate", lambda self, start: float(found) * 1.01)
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
