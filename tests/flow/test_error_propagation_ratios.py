"""How relative errors of turning points travel: the truth by two swings, and half the bound."""

from itertools import islice

import pytest
from flint import arb, ctx

from asymptotics.flow.damping import Damping
from asymptotics.flow.error_propagation import contraction_by_energy, contraction_by_ratio, ratio_growth
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.flow.sequence import sequence
from asymptotics.flow.turning import TurningState, at_rest
from asymptotics.law import Law
from asymptotics.return_map.half_swing_map import integrated
from asymptotics.turning.choose import turning_points
from asymptotics.turning.enclosing import bits_of
from asymptotics.turning.table import PointsRequest

NEARBY = arb(2) ** -40
WEAK = [{"1/2": "1/10"}, {"9/10": "1/100"}, {"99/100": "1/10"}, {"1/10": "1/50"}]
MIXED = [{1: "1/10", "9/10": "1/10"}, {"1/2": "1/10", 3: 2}, {"99/100": 1}]


def turns_at(law, p):
    """q, by pieces."""
    with ctx.workprec(120):
        return p * integrated(Damping.of_law(Law(law)), p).amplitude


def slope(law, p):
    """d ln q/d ln p as a quotient of differences."""
    with ctx.workprec(120):
        further = p * (1 + NEARBY)
        return (turns_at(law, further) / turns_at(law, p)).log() / (1 + NEARBY).log()


def bound(law, p, error):
    """At few bits, q a ball."""
    with ctx.workprec(30):
        return ratio_growth(Damping.of_law(Law(law)).least_power, p, error, turns_at(law, p))


LAW = Law({1: "1/2"})


@pytest.mark.parametrize("law", WEAK + MIXED, ids=str)
def test_ratios_part_no_faster_than_is_said(law):
    assert slope(law, arb(1)) <= bound(law, arb(1), arb(0))


@pytest.mark.parametrize("law", WEAK, ids=str)
def test_under_a_weak_law_half_of_what_ratios_part_by_is_too_little(law):
    assert 1 + (bound(law, arb(1), arb(0)) - 1) / 2 < slope(law, arb(1))


@pytest.mark.parametrize("law", WEAK[:2], ids=str)
def test_every_start_within_the_error_counts(law):
    """At the lower end ratios part faster than from p itself."""
    p, e = arb(1) / 8, arb(1) / 16
    assert bound(law, p, arb(0)) < slope(law, p - e) <= bound(law, p, e)


@pytest.mark.parametrize("law", WEAK + MIXED, ids=str)
@pytest.mark.parametrize("e", [arb(2) ** -4, arb(2) ** -20])
def test_turning_points_of_both_ends_of_a_wide_error_are_held(law, e):
    with ctx.workprec(30):
        found = contraction_by_ratio(Damping.of_law(Law(law)), arb(1), e, turns_at(law, arb(1)))
    apart = [abs(turns_at(law, 1 + s * e) - turns_at(law, arb(1))) for s in (1, -1)]
    assert max(apart) <= found <= e
    assert law not in WEAK or found / 2 < max(apart)


def test_a_turning_point_within_the_error_of_rest_has_no_ratio():
    law, e = Damping.of_law(Law({"1/2": "1/10"})), arb(2) ** -10
    assert [contraction_by_ratio(law, arb(1), e, q) for q in (e, e / 2, arb(e, e))] == [e] * 3


def test_relative_errors_hardly_grow_over_many_half_swings():
    """As (p_0/p_n)^(1 - alpha), and both ends of the first error stay inside; absolute errors would be e."""
    law, e, n = Law({"99/100": "1/2"}), arb(2) ** -20, 12
    with ctx.workprec(60):
        flow = LinearSpring(Damping.of_law(law))
        starts = [TurningState(0, 1, arb(1), arb(0), e, arb(0)), at_rest(1 + e), at_rest(1 - e)]
        wide, *ends = [next(islice(sequence(flow, start), n, None)) for start in starts]
    relative = wide.amplitude_error / wide.amplitude
    assert relative < e * arb("1.1") / wide.amplitude ** arb("0.01") and wide.amplitude_error < e / 2**13
    for end in ends:
        assert wide.x.contains(end.x) and wide.tau.contains(end.tau)


def test_an_exponent_below_1_beside_1_takes_the_bits_of_one_law():
    """Below 2^-45 of the start, at the first precision: absolute errors asked for more."""
    law = {1: "1/10", "9999999/10000000": "1/10"}
    # Step by step, as the words of a map do not tell which precision was enough.
    found, finer = (turning_points(law, 101, digits, times=True, route="stepping") for digits in (12, 20))
    last, truth, first = found.points[-1], finer.points[-1], bits_of(PointsRequest.read(Law(law), 101, 12, times=True))
    assert found.certified and found.method.endswith(f"balls of {first} bits") and abs(arb(last.x)) < arb(2) ** -45
    for few, many in ((last.x, truth.x), (last.tau, truth.tau)):
        assert abs(arb(few) - arb(many)) <= abs(arb(many)) * arb("5e-12")


def test_beside_a_linear_spring_the_turning_points_keep_their_ratio():
    """Linear damping: q e/p exactly."""
    with ctx.workprec(60):
        law = Damping.of_law(LAW)
        p, e, q = arb(1), arb(2) ** -10, arb("0.5")
        assert q * e / p <= contraction_by_energy(law, p, e, arb(3), arb(0), -q, arb(0)) < q * e * arb("1.01")
        assert q * e / p <= contraction_by_ratio(law, p, e, q) < q * e * arb("1.01")
        assert (
            q * e / p <= contraction_by_energy(law, p, e, arb(3), arb(0), -q / 2, q / 2) < q * e * arb("1.01")
        )  # q at the far end


@pytest.mark.parametrize(
    ("law", "error", "q"), [({2: 1}, "0.5", "0.01"), ({2: 1}, "0.25", "0.01"), ({"1/2": "1/10"}, "0.001", "0.25")]
)
def test_the_distance_of_two_starts_is_the_largest_of_their_logarithms(law, error, q):
    """error/(p - error) times the growth: the slope of ln p is steepest at the nearest start."""
    force, error, q = Damping.of_law(Law(law)), arb(error), arb(q)
    growth = ratio_growth(force.least_power, arb(1), error, q)
    again = q * (growth * error / (1 - error)).expm1()
    found = contraction_by_ratio(force, arb(1), error, q)
    assert again * arb("0.99999") <= found <= again * arb("1.00001") and found < error


def test_an_error_as_large_as_the_start_has_no_ratio():
    """Nothing is known of p - e <= 0: the distance is that of a nonexpansive flow."""
    law = Damping.of_law(LAW)
    assert [contraction_by_ratio(law, arb(1), arb(error), arb(1)) for error in (1, 2)] == [1, 2]


def test_a_start_that_may_turn_at_zero_has_no_bound_of_its_growth():
    """inf, not a number that is none: whoever compares it with another bound takes the other."""
    assert ratio_growth(arb(1) / 2, arb(1), arb("0.25"), arb("0.125")) == arb("inf")
    assert ratio_growth(arb(1) / 2, arb(1), arb("0.125"), arb("0.25")).is_finite()
