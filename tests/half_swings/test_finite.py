"""Half-swings at finite strength: contained at every precision, and every part of the bound is needed."""

from dataclasses import replace
from itertools import islice

import pytest
from flint import arb, ctx

from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.half_swings import finite_majorant
from asymptotics.half_swings.finite import finite_quarter
from asymptotics.half_swings.finite_majorant import majorant, widest
from asymptotics.half_swings.finite_result import certified_swing, half_swing_at
from asymptotics.law import Law
from asymptotics.numbers.exact import parse_real
from asymptotics.turning.general import turning_points
from asymptotics.turning.quadratic_duration import duration
from asymptotics.turning.quadratic_map import next_amplitude


def reals(*texts):
    return [parse_real(text, "alpha") for text in texts]


def closed_form(alpha, delta):
    """(A'/A, T) exactly: dry friction, linear, quadratic."""
    if alpha == "0":
        return 1 - 2 * delta, arb.pi()
    if alpha == "1":
        root = (1 - delta**2 / 4).sqrt()
        return (-arb.pi() * delta / 2 / root).exp(), arb.pi() / root
    q = next_amplitude(2 * delta)
    return q / (2 * delta), duration(2 * delta, q)


@pytest.mark.parametrize("alpha", ["0", "1", "2"])
@pytest.mark.parametrize("bits", [7, 20, 70])
@pytest.mark.parametrize("size", ["1e-9", "0.01", "0.08"])
def test_a_ladder_of_precisions_contains_the_closed_form(alpha, bits, size):
    with ctx.workprec(400):
        amplitude, time = closed_form(alpha, arb(size))
    with ctx.workprec(bits + 10):
        found = finite_quarter(reals(alpha), [arb(size)], bits).half_swing([arb(size).mid()])
        wide = finite_quarter(reals(alpha), [arb(size)], bits).half_swing([arb(size).mid() + arb(0, 1e-7)])
    with ctx.workprec(400):
        amplitude_here, time_here = closed_form(alpha, arb(found_point(size, bits)))
    assert found.amplitude.contains(amplitude_here.mid())
    assert found.duration.contains(time_here.mid())
    assert found.amplitude.rad() < arb(2) ** (6 - bits)
    assert wide.amplitude.contains(amplitude.mid())
    assert wide.duration.contains(time.mid())


def found_point(size, bits):
    with ctx.workprec(bits + 10):
        return arb(size).mid()


@pytest.mark.parametrize(("alpha", "epsilon"), [("1/2", "1/20"), ("3/2", "1/6"), ("3", "1/20")])
def test_other_exponents_agree_with_the_integrated_motion(alpha, epsilon):
    table = turning_points(Law({alpha: epsilon}), 3, 18, times=True)
    with ctx.workprec(90):
        strength = parse_real(epsilon, "e").ball()
        rows = list(islice(finite_quarter(reals(alpha), [strength * 5 / 4], 64).orbit([strength], arb(0), arb(0)), 3))
        elapsed = arb(0)
        for point, (x, e, time) in zip(table.points, rows, strict=True):
            found = (x + arb(0, e)).exp()
            assert abs(found - abs(arb(point.x))) < arb("1e-17")
            assert abs(elapsed - arb(point.tau)) < arb("1e-16")
            elapsed += time


def test_a_sum_agrees_with_the_integrated_motion():
    table = turning_points(Law({1: "1/500", 2: "1/400"}), 2, 15, times=True)
    found = half_swing_at(reals("1", "2"), reals("1/500", "1/400"), 9)
    assert abs(float(found.amplitude) + float(table.points[1].x)) < 1e-9
    assert abs(float(found.duration) - float(table.points[1].tau)) < 1e-8


# Where the bound is nearly attained, found by search: exponent, delta, bits, the share of the tail of R and of T_q.
ATTAINED = [
    ("0", "0.05", 30, 0.95, 0.95),
    ("1/2", "0.05", 30, 0.9, 0.9),
    ("1", "0.05", 30, 0.95, 0.95),
    ("3/2", "0.05", 60, 0.55, 0.55),
]


@pytest.mark.parametrize(("alpha", "delta", "bits", "share_R", "share_T"), ATTAINED)
def test_half_the_tail_or_one_coefficient_less_would_be_wrong(alpha, delta, bits, share_R, share_T):
    with ctx.workprec(300):
        at = [arb(delta).mid()]
        fine, coarse = (finite_quarter(reals(alpha), [arb(delta)], b) for b in (110, bits))
        for f, better, share in ((coarse.R, fine.R, share_R), (coarse.T, fine.T, share_T)):
            tail, order = coarse._tail(f, at), f.series.order
            kept = type(f)(better.series.truncate(order), f.tail)  # the same sum with sharper coefficients
            miss = abs(better(at, fine._tail(better, at)) - kept(at, arb(0)))
            assert miss < tail
            assert miss > tail * share > tail / 2
            shorter = type(f)(better.series.truncate(order - 1), f.tail)
            assert not shorter(at, tail).overlaps(better(at, fine._tail(better, at)))


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
    honest = finite_majorant._Step._candidate
    monkeypatch.setattr(finite_majorant._Step, "_candidate", lambda self, start: honest(self, start) * 0.99)
    assert majorant([arb(2)], [arb("0.5")]) is None


@pytest.mark.parametrize(("alpha", "share"), [("3/2", 0.9), ("2", 0.9), ("1/2", 0.9), ("1", 0.99)])
def test_the_error_of_the_start_is_carried_and_no_less(alpha, share):
    """Starts at both ends of a wide ball stay inside; with ``share`` of the carried error they would not."""
    strength, e = arb(1) / 1000, arb(2) ** -20
    with ctx.workprec(120):
        quarter = finite_quarter(reals(alpha), [arb(1) / 400], 100)
        runs = [list(islice(quarter.orbit([strength], x, arb(0)), 40)) for x in (arb(0), e, -e)]
        wide = list(islice(quarter.orbit([strength], arb(0), e), 40))
        for n in range(40):
            x, radius, time = wide[n]
            for other in runs[1:]:
                assert abs(other[n][0] - x) <= radius
                assert time.contains(other[n][2].mid())
        gap = abs(runs[1][39][0] - runs[0][39][0])
        assert gap > wide[39][1] * share


def test_an_uncertain_logarithm_carries_the_error_by_its_lower_end():
    """ln A grows by at most -ln(1 - (e^e - 1) e^(-L)), which is largest at the least L of the ball."""
    with ctx.workprec(80):
        e, least = arb("0.01"), arb("-0.3")
        carried = finite_quarter(reals("1/2"), [arb(1) / 400], 60)._carried(e, arb("-0.2", "0.1"))
        wanted = -(1 - (e.exp() - 1) * (-least).exp()).log()
        assert wanted < carried < wanted * arb("1.001")


def test_a_wrong_residual_is_noticed():
    """Any guess is enclosed: a bad one gives a wide ball, never a wrong one."""
    with ctx.workprec(100):
        delta = [arb(1) / 16]
        for alpha in ("1/2", "3/2"):
            quarter = finite_quarter(reals(alpha), delta, 60)
            right = quarter.half_swing(delta).log_ratio
            before = quarter._R(delta)
            off = quarter._enclosed(delta, before, right.mid() + arb("1e-6"))
            assert off.contains(right)
            assert off.rad() < arb("4e-6")


def test_outside_the_polydisc_nothing_is_claimed():
    with pytest.raises(LimitError, match="delta"):
        finite_quarter(reals("3"), [arb(5)], 60)
    quarter = finite_quarter(reals("3"), [arb("0.1")], 60)
    with pytest.raises(UndecidedError, match="polydisc"):
        quarter.half_swing([arb(1)])


def test_the_result_object():
    found = half_swing_at(reals("2"), reals("1/10"), 12)
    data = found.to_dict()
    assert data["certified"] is True
    assert data["route"] == "series of the quarter-swing"
    with ctx.workprec(200):
        low, high = map(arb, data["amplitude"]["enclosure"])
        exact = closed_form("2", arb(1) / 10)[0]
        assert low < exact < high
    assert found._repr_latex_().startswith("$A'/A")
    assert repr(found).endswith("(certified)") and repr(replace(found, certified=False)).endswith("(not certified)")
    assert arb(found.tail) < arb("1e-12")


@pytest.mark.parametrize(("alphas", "delta"), [(("2",), ("-1",)), (("2",), ("1", "2")), (("1", "2"), ("1/9",))])
def test_bad_strengths_are_refused(alphas, delta):
    with pytest.raises(InputError, match="delta"):
        half_swing_at(reals(*alphas), reals(*delta))


def test_what_is_not_decided_is_said():
    def vague(bits):
        return finite_quarter(reals("2"), [arb("0.1")], 30).half_swing([arb("0.1") + arb(0, 1e-6)])

    with pytest.raises(UndecidedError, match="20 digits"):
        certified_swing(reals("2"), reals("1/10"), 20, vague)
