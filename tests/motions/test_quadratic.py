"""Quadratic drag after many half-swings, and places that are enclosed or undecided."""

from fractions import Fraction

import pytest
from flint import arb, ctx

from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.law import Law, Oscillator
from asymptotics.motions import quadratic
from asymptotics.motions.quadratic import quadratic_motion
from asymptotics.motions.reference import reference_states
from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.choose import turning_points


def oscillator(alpha, b, **rest):
    return Oscillator(Law({alpha: b}), **rest)


@pytest.mark.parametrize("side", [-1, 1])
def test_a_place_is_enclosed_from_both_sides_or_not_at_all(side, monkeypatch):
    """The time at the middle is right; on one side of it nothing is known."""
    middle = []

    def elapsed(_p, _q, chi):
        middle[:] = middle or [chi]
        return chi + arb(0, 9 if side * (chi - middle[0]) > 0 else 0)

    monkeypatch.setattr(quadratic, "elapsed", elapsed)
    with ctx.workprec(60), pytest.raises(UndecidedError, match="not enclosed"):
        quadratic._angle(arb("0.5"), arb("0.4"), arb.pi() / 2)


@pytest.mark.parametrize("time", ["200", "646.073", "3000"])
def test_quadratic_motion_after_many_half_swings(time):
    # the time left over for the last half-swing is less certain than the working precision, at every precision
    system = oscillator("2", "9/500", x0="-9/10")
    states = reference_states(Oscillator(Law({"2": "9/500"}), x0="-9/10", v0="1e-30"), [ExactReal(Fraction(time))], 14)
    assert abs(states.x[0] - float(quadratic_motion(system, time, 14).x)) < 1e-13


def test_quadratic_motion_passes_the_turning_points():
    table = turning_points(Law({"2": "1"}), 3, 10, times=True)
    for point in table.points[1:]:
        near = quadratic_motion(oscillator("2", "1"), Fraction(point.tau), 6)
        assert abs(Fraction(near.x) - Fraction(point.x)) < Fraction(1, 10**6)
        assert abs(Fraction(near.v)) < Fraction(1, 10**9)
    with pytest.raises(LimitError, match="time"):
        quadratic_motion(oscillator("2", "1"), "1e6", 12)
    with pytest.raises(InputError, match="v0"):
        quadratic_motion(oscillator("2", "1", v0="1"), "1", 12)


def test_the_place_on_a_half_swing_is_enclosed_or_undecided(monkeypatch):
    """Where time goes by slowly a tolerance of 16 radii is just wide enough for 10 of them, not for 100 on any side."""
    time = arb(1, "1e-6")
    monkeypatch.setattr(quadratic, "_slope", lambda *_: arb(1) / 10)
    monkeypatch.setattr(quadratic, "elapsed", lambda _p, _q, chi: 1 + (chi - 2) / 10)
    found = quadratic._angle(arb(1), arb(1), time)
    assert found.contains(2 - arb("9.9e-6")) and found.contains(2 + arb("9.9e-6")) and found.rad() < 1e-4
    for sides in ((10, 100), (100, 10)):
        monkeypatch.setattr(
            quadratic, "elapsed", lambda _p, _q, chi, sides=sides: 1 + (chi - 2) / sides[0 if chi < 2 else 1]
        )
        with pytest.raises(UndecidedError, match="not enclosed"):
            quadratic._angle(arb(1), arb(1), time)


def test_a_time_that_may_be_on_two_half_swings_is_undecided(monkeypatch):
    monkeypatch.setattr(quadratic, "duration", lambda *_: arb(3, "0.1"))
    with pytest.raises(UndecidedError, match="half-swing of this time"):
        quadratic._place(oscillator("2", "1/10"), arb(3))
