"""Half-swings at finite strength: contained at every precision, and every part of the bound is needed."""

import pytest
from flint import arb, ctx

from asymptotics.expansions.half_swings import finite_majorant
from asymptotics.expansions.half_swings.finite_majorant import majorant, widest
from asymptotics.numbers.exact import parse_real
from tests.second_route.quarter_series import finite_quarter


def reals(*texts):
    return [parse_real(text, "alpha") for text in texts]


@pytest.mark.parametrize("alpha", ["0", "1/2", "3/2", "3"])
def test_the_majorant_is_above_the_function_and_not_far_above(alpha):
    # On the circle |R| is largest where the damping drives, at delta = -rho: compare there.
    with ctx.workprec(100):
        exponent = reals(alpha)[0].ball()
        rho = widest([exponent], [arb(1)]).radii[0] / 5
        bound = majorant([exponent], [rho])
        quarter = finite_quarter(reals(alpha), [rho], 60)
        at = [-rho]
        R, T = quarter.R(at, quarter._tail(quarter.R, at)), quarter.T(at, quarter._tail(quarter.T, at)) - arb.pi() / 2
        assert abs(R) < bound.growth < 1.3 * abs(R)
        assert abs(T) < bound.excess < 1.5 * abs(T)


def test_a_majorant_needs_enough_room():
    assert majorant([arb(2)], [arb("0.9")]) is None
    assert majorant([arb(2)], [arb("0.5")], whole=True) is None
    assert majorant([arb(2)], [arb(0)]) is None
    assert majorant([arb(1), arb(2)], [arb("0.2"), arb("0.2")]) is not None


def test_the_largest_ratio_is_found_below_the_range_of_doubles():
    cube = majorant([arb(1), arb(2)], [arb("0.25"), arb("0.25")])
    tiny, less = arb(2) ** -1100, arb(2) ** -1200
    for pair in ((tiny, less), (less, tiny)):
        assert abs(cube.ratio(pair) / (4 * tiny) - 1) < 1e-15


def test_too_small_a_candidate_is_refused(monkeypatch):
    # The oracle may say anything: a number below the solution is not accepted as a bound.
    honest = finite_majorant._fixed_point
    monkeypatch.setattr(finite_majorant, "_fixed_point", lambda *given: honest(*given) * 0.99)
    assert majorant([arb(2)], [arb("0.5")]) is None


def test_an_uncertain_exponent_is_as_dear_as_the_worst_that_it_may_be():
    def largest(alpha):
        return finite_majorant._extremes(((alpha.mid().man_exp(), alpha.rad().man_exp()),), 8)

    for wide, worst in zip(largest(arb("1.5", "0.25")), largest(arb("1.26"))):
        assert all(bound >= seen for (bound,), (seen,) in zip(wide, worst, strict=True))
