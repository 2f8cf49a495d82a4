"""Half-swings at finite strength: contained at every precision, and every part of the bound is needed."""

import pytest
from flint import arb, ctx

from asymptotics.expansions.half_swings import finite_majorant
from asymptotics.expansions.half_swings.finite_majorant import _extremes, _Step, majorant, widest
from asymptotics.numbers.exact import parse_real
from tests.second_route.quarter_series import finite_quarter


def reals(*texts):
    return [parse_real(text, "alpha") for text in texts]


def real(text):
    return parse_real(text, "alpha")


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


def test_an_end_that_was_not_proved_is_refused(monkeypatch):
    step = _Step(arb("0.1"), [arb("0.5")], [arb(1)], [arb(1)], [arb("0.5")])
    found = step.upper_end(arb(0))
    assert found is not None
    for share in (0.9, 0.99, 0.999):
        monkeypatch.setattr(finite_majorant, "_fixed_point", lambda *given, share=share: float(found) * share)
        assert step.upper_end(arb(0)) is None
    monkeypatch.setattr(finite_majorant, "_fixed_point", lambda *given: float(found) * 1.01)
    assert step.upper_end(arb(0)) is not None
