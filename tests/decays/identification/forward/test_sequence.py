"""The whole sequence of turning points at once: where Newton's iteration fails, what the steps one by one say."""

from fractions import Fraction

import numpy as np
import pytest

from asymptotics.decays.identification.forward.coefficients import loss, spring
from asymptotics.decays.identification.forward.pendulum import PendulumHalfSwing
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.sequence import turning_sequence
from asymptotics.decays.identification.forward.swing import HalfSwingModel
from asymptotics.law import Law
from asymptotics.turning.choose import turning_points

LAW = np.array([-0.05, 0.0003, 0.02])
"""ln(amplitude), dry friction, quadratic drag."""


def counted(swing):
    """The swing, and how often it was evaluated."""
    calls, at = [], swing.at
    swing.at = lambda *given: (calls.append(len(given[0])), at(*given))[1]
    return swing, calls


def one_by_one(swing, law):
    """ln(amplitude) at every turning point that the motion has."""
    a = [float(law[0])]
    try:
        while True:
            a.append(a[-1] + float(swing.at(np.array(a[-1:]), law[1:]).values[0, 0]))
    except TooStrongError:
        return np.array(a)


def swings():
    return [PendulumHalfSwing((loss(0.0), loss(2.0)), 0.7), HalfSwingModel((loss(0.0), loss(2.0)))]


LAWS = [[("1/10", "3/2")], [("1/25", "0"), ("1/20", "1")], [("1/10", "1"), ("1/10", "2")]]


@pytest.mark.parametrize("swing", swings())
def test_a_motion_that_ends_too_early_is_known_soon(swing):
    # failed before: an evaluation for each half-swing
    swing.tolerance = 3e-6
    last = len(one_by_one(swing, LAW)) - 1
    swing, calls = counted(swing)
    with pytest.raises(TooStrongError, match="no turning point follows"):
        turning_sequence(swing, last + 1, LAW)
    assert len(calls) < last / 2


@pytest.mark.parametrize("swing", swings())
def test_the_last_half_swing_is_that_of_the_steps_one_by_one(swing):
    swing.tolerance = 3e-6
    a = one_by_one(swing, LAW)
    assert len(a) > 200
    whole = turning_sequence(swing, len(a) - 1, LAW)
    assert np.abs(whole.a - a).max() < 1e-10
    with pytest.raises(TooStrongError):
        turning_sequence(swing, len(a), LAW)


@pytest.mark.parametrize("spoiled", [0, 7, 60])
def test_a_guess_that_leads_astray_changes_nothing(spoiled):
    swing = HalfSwingModel((loss(0.0), loss(2.0)))
    plain = turning_sequence(swing, 60, LAW)
    guess = plain.a.copy()
    guess[spoiled:] -= 8.0
    guess[0] = plain.a[0]
    swing, calls = counted(swing)
    astray = turning_sequence(swing, 60, LAW, guess)
    assert np.abs(astray.a - plain.a).max() < 1e-12
    assert spoiled == 60 or len(calls) > 12


@pytest.mark.parametrize("law", LAWS)
def test_turning_points_and_times_are_those_of_the_certified_program(law):
    swings = 8
    table = turning_points(Law({a: e for e, a in law}), swings + 1, 14, times=True)
    swing = HalfSwingModel([loss(float(Fraction(a))) for _, a in law])
    found = turning_sequence(swing, swings, np.array([0.0, *(float(Fraction(e)) for e, _ in law)]))
    assert np.abs(np.exp(found.a) - [abs(float(p.x)) for p in table.points]).max() < 1e-10
    assert np.abs(found.tau - [float(p.tau) for p in table.points]).max() < 1e-10


def test_the_derivatives_of_the_sequence_are_exact():
    swing, p = HalfSwingModel((loss(1), loss(2), spring(3))), np.array([0.0, 0.01, 0.02, 0.02])
    found, h = turning_sequence(swing, 60, p), 1e-6
    for i in range(4):
        e = np.eye(4)[i] * h
        up, down = turning_sequence(swing, 60, p + e), turning_sequence(swing, 60, p - e)
        for name in ("a", "tau", "passage", "log_speed"):
            slope = (getattr(up, name) - getattr(down, name)) / (2 * h)
            assert np.abs(slope - getattr(found, "d_" + name)[i]).max() < 1e-6 * (1 + np.abs(slope).max()), name


def test_motion_that_sticks_has_no_next_turning_point():
    with pytest.raises(TooStrongError):
        turning_sequence(HalfSwingModel((loss(0),)), 6, np.array([0.0, 0.1]))  # from 1 by 0.2: five swings
