"""The bound of what a truncated L lacks: Y on a circle, against complex half-swings; its use, against half-swings."""

from fractions import Fraction

import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.decays.identification.certified_sets import certified_ratio as module
from asymptotics.decays.identification.certified_sets.certified_ratio import BITS, CertifiedRatio, followed
from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.flow.damping import Damping
from asymptotics.numbers.exact import ExactReal
from asymptotics.return_map.half_swing_map import integrated
from asymptotics.terms import Term
from tests.decays.identification.certified_sets.printed_tables import losses

# Losses (alpha, m), their strengths, and how far Y is above the largest |L| on its circle.
CASES = [
    (((2, 0),), (0.08,), 2),
    (((1, 0), (3, 0)), (0.05, 0.03), 2.5),
    (((2, 1),), (0.1,), 2.5),
    ((("3/2", 0),), (0.1,), 2.5),
]


def ratio_of(losses):
    return CertifiedRatio.of(tuple(Term(1, alpha, m) for alpha, m in losses))


def best_circle(ratio, delta):
    """(Y, q) as in the module's docstring, by a second evaluation in doubles; the tail is the least over the same Y."""
    weights, crests, areas = ([float(arb(c)) for c in cs] for cs in (ratio.weights, ratio.crests, ratio.areas))
    found = []
    for Y in map(float, module._REACHES):
        S = sum(d * J for d, J in zip(delta, areas))
        H = sum(d * k * np.exp(abs(w) * Y) for d, k, w in zip(delta, crests, weights))
        W = max(map(abs, weights))
        E = -np.expm1(-W * Y) / W if W else Y
        q = 0.99 * E / (S + H * E)
        if q > 1.05:
            found.append((Y * q ** (-ratio.order - 1) / (1 - 1 / q), Y, q))
    return min(found)


@pytest.mark.parametrize(("losses", "delta", "slack"), CASES)
def test_L_is_bounded_on_the_circle_of_the_tail(losses, delta, slack):
    ratio = ratio_of(losses)
    tail, Y, q = best_circle(ratio, delta)
    assert float(ratio.tail([arb(d) for d in delta])) == pytest.approx(tail, rel=1e-6, abs=0)
    largest = max(abs(complex_ratio(losses, [q * turn * d for d in delta])) for turn in (1, -1, 1j))
    assert largest < Y < slack * largest


def complex_ratio(losses, delta):
    """ln(A'/A) of the half-swing in the angle, for complex strengths, in doubles."""
    laws = [(float(Fraction(a)), m) for a, m in losses]

    def slope(angle, y):
        s, c = max(np.sin(angle), 0.0), np.cos(angle)
        N = sum(d * np.exp((a + m - 1) * y[0]) * s**a * abs(c) ** m for d, (a, m) in zip(delta, laws))
        return [-s * N / (1 - c * N)]

    return solve_ivp(slope, (0, np.pi), [0j], rtol=1e-9, atol=1e-11).y[0, -1]


@pytest.mark.parametrize("size", ["0.001", "0.01", "0.05", "0.1"])
def test_the_series_with_its_tail_holds_the_half_swing(size):
    """Few orders: the truth is within the tail of the sum, which is not empty, and without it not always."""
    ratio = ratio_of(((2, 0),))
    few = CertifiedRatio(ratio.weights, ratio.crests, {k: c for k, c in ratio.coefficients.items() if sum(k) <= 3}, 3)
    d = arb(float(size))
    with ctx.workprec(160):
        truth = integrated(Damping.of([(d, Term(1, 2).velocity)]), arb(1)).amplitude.log()
    with ctx.workprec(80):
        assert abs(few.polynomial([d]) - truth) <= few.tail([d])
        assert bool(few.tail([d]) < module._SMALL) is (size == "0.001"), "both ways to add it"
        assert few.at([d]).contains(truth) and not few.polynomial([d]).contains(truth)
        assert ratio.at([d]).contains(truth)


def test_the_tail_of_a_sum_that_is_not_followed_is_added_whole():
    ratio = CertifiedRatio.of((Term(1, 2),))
    few = CertifiedRatio(ratio.weights, ratio.crests, {(1,): ratio.coefficients[(1,)]}, 1)
    with ctx.workprec(BITS):
        for size in (arb("0.1"), arb("1e-7")):
            assert few.at([size]).rad() >= few.tail([size]) * arb("0.999")


def test_negative_strengths_are_not_followed():
    """What is followed is a loss: a gain has the series alone, or nothing."""
    ratio = CertifiedRatio.of((Term(1, 2),))
    with ctx.workprec(BITS):
        assert ratio.at([arb("0.3")]) < 0
        for size in ("-0.2", "-0.3", "-5"):
            try:
                tail = ratio.tail([arb(size)])
            except UndecidedError:
                with pytest.raises(UndecidedError, match="too large"):
                    ratio.at([arb(size)])
            else:
                assert ratio.at([arb(size)]).rad() >= tail * arb("0.999")


def test_the_tail_of_the_series_is_an_enclosure_that_bites():
    # viscous: L = -pi (d/2)/sqrt(1 - d^2/4), known in closed form
    with ctx.workprec(80):
        ratio = CertifiedRatio.of(losses("1"))
        d = arb("0.08")
        true = -arb.pi() * (d / 2) / (1 - d**2 / 4).sqrt()
        assert ratio.at([d]).contains(true)
        low = {k: c for k, c in ratio.coefficients.items() if sum(k) <= 3}
        short = CertifiedRatio(ratio.weights, ratio.crests, low, 3)
        assert short.at([d]).contains(true)
        assert not abs(short.polynomial([d]) - true) <= short.tail([d]) / 10**5  # the bound is not absurdly wide
        assert not short.polynomial([d]).overlaps(true)  # and without it the sum is wrong
        with pytest.raises(UndecidedError):
            ratio.tail([arb(1)])


def test_the_tail_reaches_strong_losses_and_holds_what_is_left_out():
    with ctx.workprec(80):
        for law, strengths in (("3", ["0.12"]), ("0", ["0.1"]), ("1+3", ["0.05", "0.06"])):
            ratio = CertifiedRatio.of(losses(law))
            d = [arb(s) for s in strengths]
            low = {k: c for k, c in ratio.coefficients.items() if sum(k) <= 3}
            short = CertifiedRatio(ratio.weights, ratio.crests, low, 3)
            assert short.at(d).contains(ratio.at(d))
            assert short.tail(d) < 0.3
            assert not short.polynomial(d).overlaps(ratio.at(d))
        assert CertifiedRatio.of(losses("3")).tail([arb("0.12")]) < arb("1e-9")


def test_exact_coefficients_are_those_of_the_balls():
    with ctx.workprec(80):
        for law in ("1+2", "0+3", "1,2:+2"):
            ratio = CertifiedRatio.of(losses(law))
            balls = half_swing(quarter_swing(losses(law), 4)).L.coefficients
            for key, ball in balls.items():
                assert any(key)
                assert ball.overlaps(ratio.coefficients.get(key, arb(0)))
                assert not ball.overlaps(ratio.coefficients.get(key, arb(0)) + arb("1e-15"))


def test_more_resistance_costs_more_at_every_row():
    # what the strips rest on, in balls: the loss of a half-swing grows with e and falls with alpha, from below 1 on
    with ctx.workprec(60):
        for amplitude in ("1", "0.4"):
            lost = [
                -followed([(arb(e) * arb(amplitude) ** (ExactReal(Fraction(a)).ball() - 1), ExactReal(Fraction(a)))])
                for e, a in (("0.1", "2"), ("0.1", "3/2"), ("0.101", "3/2"), ("0.101", "1/2"))
            ]
            assert all(less < more for less, more in zip(lost, lost[1:]))
