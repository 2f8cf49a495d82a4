"""What must hold of every half-swing and flow as a series, on random exponents and sums, at few bits.

Balls are compared with what they must contain, and their radii are bounded: two wide balls always meet.  Hypothesis is
told how many bits were lost (``target``), so that it looks for the exponents that lose most.
"""

from fractions import Fraction
from itertools import islice

import pytest
from flint import arb, ctx
from hypothesis import assume, given, settings, target
from hypothesis import strategies as st

from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.expansions.normal_form.expansion import exact_expansion, expansion_of
from asymptotics.expansions.normal_form.flow import flow_of
from asymptotics.gauges import GAUGES
from asymptotics.numbers.exact import ExactReal
from asymptotics.series import Series
from asymptotics.testing import strategies
from asymptotics.turning.abel import abel_function
from tests.second_route.closed_forms import certified_coefficients
from tests.second_route.gauge_observables import observables
from tests.second_route.quarter_series import finite_quarter

LONGER = max(1, settings().max_examples // 80)  # the nightly profile draws more

ORDER, BITS = 4, 70
sums = st.lists(strategies.exponents(high=4), min_size=1, max_size=2, unique_by=str).map(tuple)
integers = st.lists(st.integers(0, 5), min_size=1, max_size=2, unique=True).map(tuple)


def certified(alphas, order=ORDER, bits=BITS):
    with ctx.workprec(bits):
        return half_swing(quarter_swing(alphas, order))


def mirrored(f: Series) -> Series:
    """f(-delta)."""
    return f.with_coefficients({key: c * (-1) ** sum(key) for key, c in f.coefficients.items()})


def lost(f: Series, bits: int = BITS) -> float:
    """How many of the bits the worst coefficient has lost."""
    radii = [float(arb(c.rad()).log()) / 0.6931 for c in f.coefficients.values() if isinstance(c, arb) and c.rad() > 0]
    return bits + max(radii, default=-float(bits))


def vanishes(f: Series, bits: int = BITS) -> bool:
    """Every coefficient is a small ball around zero."""
    assert lost(f, bits) < 45, f
    return all(arb(c).contains(0) for c in f.coefficients.values())


@settings(max_examples=15 * LONGER)
@given(sums)
def test_backwards_is_the_map_with_the_damping_turned_round(alphas):
    """F^-1(delta) = -F(-delta): the half-swing seen from its end is one of the law with -epsilon."""
    half = certified(alphas)
    back = tuple(-mirrored(f) for f in half.F)
    with ctx.workprec(BITS):
        for i, f in enumerate(half.F):
            there_and_back = f.compose(back) - Series.variable(i, len(alphas), f.order, arb(1))
            target(lost(there_and_back), label=f"bits lost in F_{i}")
            assert vanishes(there_and_back)
            if alphas[i] != ExactReal(Fraction(1)):  # at alpha = 1 the strength stays what it is
                twice = f.compose(half.F) - Series.variable(i, len(alphas), f.order, arb(1))
                assert not vanishes(twice)


@settings(max_examples=15 * LONGER)
@given(sums)
def test_amplitude_odd_and_time_even_in_the_strengths(alphas):
    """U is odd and W even; seen from its end, at -F(-delta), a half-swing has -L(-delta) and lasts T(-delta)."""
    half = certified(alphas)
    back = tuple(-mirrored(f) for f in half.F)
    with ctx.workprec(BITS):
        assert vanishes(half.L.compose(back) + mirrored(half.L))
        assert vanishes(half.T.compose(back) - mirrored(half.T))
        flow = flow_of(half)
    target(lost(flow.U))
    assert all(sum(key) % 2 == 1 for key in flow.U.coefficients)
    assert all(sum(key) % 2 == 0 for key in flow.W.coefficients)


@settings(max_examples=15 * LONGER)
@given(integers)
def test_exact_and_certified_arithmetic_agree_at_integers(alphas):
    exact, balls = exact_half_swing(alphas, ORDER), certified(tuple(ExactReal(Fraction(a)) for a in alphas))
    with ctx.workprec(300):
        for ours, theirs in ((exact.L, balls.L), (exact.T, balls.T)):
            for key in {*ours.coefficients, *theirs.coefficients}:
                c = ours.coefficients.get(key, 0)
                value = c.ball() if hasattr(c, "ball") else arb(c)
                assert arb(theirs.coefficients.get(key, 0)).contains(value.mid()), (key, value)
    target(lost(balls.L))


@settings(max_examples=10 * LONGER)
@given(strategies.exponents(high=4))
def test_closed_forms_in_alpha_and_certified_arithmetic_agree_at_any_exponent(alpha):
    """p_1, p_3, Omega_2, Omega_4 in moments and I_4, at 120 bits, lie in the balls of the series at 70."""
    with ctx.workprec(BITS):
        flow = flow_of(certified((alpha,)))
        slow = flow.W.inverse()
        found = {"p": -(flow.U * slow), "Omega": slow}
    with ctx.workprec(120):
        for name, row in certified_coefficients(alpha.ball()).items():
            for k, value in row.items():
                ball = arb(found[name][k])
                assert ball.contains(value.mid()), (name, k)
                assert value.contains(0) or not ball.contains((value * (1 + arb(2) ** -25)).mid()), (name, k)
    target(lost(flow.W))


@settings(max_examples=8 * LONGER)
@given(sums)
def test_what_is_seen_is_the_same_in_every_gauge(alphas):
    with ctx.workprec(BITS):
        quarter = quarter_swing(alphas, 3, moments=True)
        seen = [observables(expansion_of(quarter, gauge, arithmetic="certified")) for gauge in GAUGES]
        for other in seen[1:]:
            assert vanishes(seen[0].amplitude_ratio - other.amplitude_ratio)
            assert vanishes(seen[0].half_period - other.half_period)


@pytest.mark.parametrize("alphas", [(3,), (2,), (1, 3)])
def test_what_is_not_seen_differs(alphas):
    """Near miss: the amplitude and phase equations are no observables."""
    first, *others = (exact_expansion(alphas, 3, gauge) for gauge in GAUGES)
    assert all(other.Omega.coefficients != first.Omega.coefficients for other in others)


@settings(max_examples=10 * LONGER)
@given(st.sampled_from([0, 1, 2]), st.integers(12, 40), st.sampled_from([1, -1]))
def test_next_to_an_integer_the_coefficients_are_next_to_its_own(n, places, side):
    """alpha -> 0, 1, 2: the error is of the order of the distance, also where alpha - 1 is divided out."""
    assume(n > 0 or side > 0)
    near = certified((ExactReal(n + Fraction(side, 2**places)),))
    at = certified((ExactReal(Fraction(n)),))
    with ctx.workprec(BITS):
        pairs = [(flow_of(near), flow_of(at))]
        for here, there in pairs:
            for f, g in ((here.U, there.U), (here.W, there.W)):
                distance = max(abs(arb(f[k]) - arb(g[k])) for k in range(ORDER + 1))
                assert distance < arb(2) ** (6 - places)
        assert abs(arb(pairs[0][0].U[1]) - arb(pairs[0][1].U[1])) > arb(2) ** (-6 - places)  # and no smaller


@settings(max_examples=6 * LONGER)
@given(strategies.exponents(low=2, high=4), st.integers(50, 300))
def test_the_abel_function_counts_the_half_swings(alpha, inverse):
    """Psi(F(delta)) = Psi(delta) + 1: one step by the function is one half-swing of the series."""
    with ctx.workprec(80):
        delta = (arb(1) / (20 * inverse)).mid()
        abel = abel_function(alpha, 4)
        rows = list(islice(finite_quarter([alpha], [delta], 80).orbit([delta], arb(0), arb(0)), 2))
        step = delta * (abel_weight(alpha) * (rows[1][0] + arb(0, rows[1][1]))).exp()
        found = abel.advance(delta, 1)
        assert found.overlaps(step)
        assert found.rel_accuracy_bits() > 30
        assert not abel.advance(delta, 2).overlaps(step)


def abel_weight(alpha: ExactReal) -> arb:
    return alpha.ball() - 1
