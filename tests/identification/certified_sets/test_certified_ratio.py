"""The bound of what a truncated L lacks: Y on a circle, against complex half-swings; its use, against half-swings."""

from fractions import Fraction

import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.flow.damping import Damping
from asymptotics.identification.certified_sets import certified_ratio as module
from asymptotics.identification.certified_sets.certified_ratio import CertifiedRatio
from asymptotics.return_map.half_swing_map import integrated
from asymptotics.terms import Term

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
