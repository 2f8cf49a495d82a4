"""Linear damping next to its critical strength beside other laws: an answer, or a refusal by name before the work."""

from fractions import Fraction
from math import inf, log, log2

import pytest

from asymptotics.errors import LimitError
from asymptotics.flow.linear_spring.near_critical import (
    creeping,
    faded_bits,
    fading,
    longest_half_swing,
    lost_bits,
    turning,
)
from asymptotics.law import Law, Oscillator
from asymptotics.motions import reference
from asymptotics.numbers.exact import ExactReal
from asymptotics.running.budget import budget
from asymptotics.turning.choose import turning_points

NEAR = Law({1: "1.95", 2: "1/10"})


@pytest.fixture(scope="module")
def short():
    return turning_points(NEAR, 3, 8, times=True)


def test_the_answer_is_that_of_more_digits(short):
    long = turning_points(NEAR, 3, 20, times=True)
    for few, many in zip(short.points[1:], long.points[1:], strict=True):
        for a, b in ((Fraction(few.x), Fraction(many.x)), (Fraction(few.tau), Fraction(many.tau))):
            assert abs(a - b) <= abs(b) * Fraction(5, 10**8)
    assert short.certified and short.ended is None


def test_what_is_left_of_a_half_swing_is_the_estimate(short):
    """exp(-T epsilon/2) with T = ``longest_half_swing``: the bits lost cover it, a tenth less would not."""
    reached = abs(Fraction(short.points[2].x) / Fraction(short.points[1].x))
    assert Fraction(1, 2 ** lost_bits(NEAR)) < reached < Fraction(1, 2 ** (lost_bits(NEAR) * 9 // 10))


@pytest.mark.parametrize("gap", ["1e-6", "1e-20", "1e-300"])
@pytest.mark.parametrize("more", [{2: "1/10"}, {0: "1/50", 3: 5}], ids=str)
def test_a_motion_that_lingers_too_long_is_refused_at_once(gap, more):
    strength = ExactReal(2) - ExactReal(Fraction(gap))
    with pytest.raises(LimitError, match="next to critical damping"):
        turning_points(Law({1: strength, **more}), 3, 15)
    with pytest.raises(LimitError, match="next to critical damping"):
        turning_points(Law({1: strength, **more}), 3, 15, x0=0, v0=1)


def test_friction_ends_what_lingers_in_closed_form_or_soon():
    assert turning_points(Law({0: "1/50", 1: "1.99"}), 5, 12).ended == {"n": 1, "reason": "sticks"}
    with budget(60):
        found = turning_points(Law({0: "1/50", 1: "1.99", 2: "1/10"}), 20, 12)
    assert found.ended == {"n": 1, "reason": "sticks"} and found.points[1].x == "0.0200000000000"


def test_critical_and_stronger_damping_and_traps_do_not_linger():
    assert turning_points(Law({1: 2, 2: "1/10"}), 2, 10).ended == {"n": 0, "reason": "overdamped"}
    for law in ({1: 2, 2: 1}, {1: 3}, {1: "1.99"}, {"1/2": "1/10", 1: "1.99"}, {2: 5}, {1: "1/2", 2: 1}):
        assert longest_half_swing(Law(law)) == 0, law


def test_a_reference_motion_carries_the_bits_that_it_loses(monkeypatch):
    oscillator, tried = Oscillator(Law({1: "1.999", 2: "1/10"})), []
    passes = reference._states
    monkeypatch.setattr(reference, "_states", lambda *given: tried.append(given[2]) or passes(*given))
    point = reference.reference_motion(oscillator, "60", 20)
    assert len(tried) == 1 and point.x.startswith("3.24063346198") and point.x.endswith("e-25")
    finer = reference.reference_motion(oscillator, "60", 30)
    assert len(tried) == 2 and abs(Fraction(point.x) - Fraction(finer.x)) <= Fraction("5e-45")
    with pytest.raises(LimitError, match="would take about"):
        reference.reference_motion(Oscillator(Law({1: "1.999999999999", 2: "1/10"})), "1e6", 20)


@pytest.mark.parametrize(("law", "t"), [({1: 2, "0.9999999": 1}, 100), ({1: 1, "1.0000001": 2}, 100)], ids=str)
def test_a_creep_with_exponents_next_to_1_carries_the_bits_by_which_it_fades(monkeypatch, law, t):
    """Two passes before, the first for nothing; at ten times the time it ran out of seconds, now it is not begun."""
    oscillator, tried = Oscillator(law), []
    passes = reference._states
    monkeypatch.setattr(reference, "_states", lambda *given: tried.append(given[2]) or passes(*given))
    x = reference.reference_motion(oscillator, t, 15).x
    assert len(tried) == 1 and log2(abs(float(x))) > -faded_bits(oscillator.law, t) - 8
    tried.clear()
    with pytest.raises(LimitError, match="would take about"):
        reference.reference_motion(oscillator, 20 * t, 15)
    assert not tried


@pytest.mark.parametrize(("law", "t"), [({"0.999": 1}, 60), ({"0.99": "1/2"}, 100)], ids=str)
def test_a_motion_that_turns_keeps_its_digits_while_it_fades(monkeypatch, law, t):
    """One pass, whose bits are far fewer than those by which it fades; the digits are those of a finer pass."""
    oscillator, tried = Oscillator(Law(law)), []
    passes = reference._states
    monkeypatch.setattr(reference, "_states", lambda *given: tried.append(given[2]) or passes(*given))
    x = reference.reference_motion(oscillator, t, 15).x
    assert len(tried) == 1 and log2(abs(float(x))) < -10 * faded_bits(oscillator.law, t)
    finer = reference.reference_motion(oscillator, t, 25).x
    assert len(tried) == 2 and abs(Fraction(x) - Fraction(finer)) <= abs(Fraction(finer)) * Fraction(5, 10**15)


def test_a_strength_that_grows_traps_the_motion_when_it_is_said():
    """epsilon w^(alpha - 1) reaches 2 at the time of the last turning point, within 10 %."""
    law = Law({"0.985": 1})
    ended = turning_points(law, 40, 8, times=True)
    assert ended.ended["reason"] == "creeps"
    assert float(ended.points[-1].tau) == pytest.approx(turning(law), rel=0.1)


def test_motions_fade_as_long_as_the_strength_of_the_exponents_next_to_1_lasts():
    assert fading(Law({"1.001": 3})) == pytest.approx(((3 - 5**0.5) / 2, log(1.5) / 0.001 / ((3 - 5**0.5) / 2)))
    assert fading(Law({1: 2, "0.999": 1}))[1] == inf and creeping(Law({1: 1, "0.999": "1/2"})) == 0
    for law in ({1: 3}, {"1/2": 1, "0.999": 1}, {0: "1/10", "0.999": 1}, {"1.001": 1}, {2: 1}, {"0.999": 1}):
        assert fading(Law(law)) == (0, 0)


@pytest.mark.parametrize(("alpha", "epsilon"), [("1.0001", 2), ("1.00001", "2.0001"), ("1.00000001", "1.99")])
def test_one_law_next_to_linear_damping_lingers_as_long_as_is_said(alpha, epsilon):
    """Within 5 % of the time of the first turning point, which is no later."""
    law = Law({alpha: epsilon})
    first, said = float(turning_points(law, 2, 8, times=True).points[1].tau), longest_half_swing(law)
    assert 0.95 * said < first < 1.001 * said


def test_one_law_that_lingers_too_long_is_refused_at_once():
    """1 + 10^-20 at 2: it ran for 60 s."""
    for epsilon in (2, "1.9999999", 3):
        with pytest.raises(LimitError, match="next to critical damping"):
            turning_points(Law({"1.00000000000000000001": epsilon}), 2, 15)
    assert longest_half_swing(Law({"1.0001": 1})) == 0
