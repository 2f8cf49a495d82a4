"""The oracles let through what is right and stop what is nearly right."""

from fractions import Fraction
from math import cos, exp, sin, sqrt

import pytest
from hypothesis import given, settings

from asymptotics.law import Law, Oscillator
from asymptotics.testing import strategies
from asymptotics.testing.oracles import check_coefficients, check_motion, check_turning_points


def coulomb(law, count):  # each half-swing loses 2 epsilon; the mass sticks within epsilon of the centre
    epsilon = Fraction(str(law.terms[0].strength))
    points = [Fraction(1)]
    while len(points) < count and abs(points[-1]) > epsilon:
        points.append(-(points[-1] - 2 * epsilon if points[-1] > 0 else points[-1] + 2 * epsilon))
    return points


def test_exact_dry_friction_passes_and_a_wrong_loss_does_not():
    check_turning_points(coulomb, {0: "1/20"}, 12)
    with pytest.raises(AssertionError, match="turning point 1"):
        check_turning_points(lambda law, n: coulomb(Law({0: "51/1000"}), n), {0: "1/20"}, 5)
    with pytest.raises(AssertionError, match="there are"):
        check_turning_points(lambda law, n: coulomb(law, n)[:-1], {0: "1/20"}, 12)


def linear(oscillator, times, damping=Fraction(1, 10)):  # x'' + x + x'/10 = 0 from rest at 1
    rate, omega = float(damping) / 2, sqrt(1 - float(damping) ** 2 / 4)
    return [exp(-rate * t) * (cos(omega * t) + rate / omega * sin(omega * t)) for t in map(float, times)]


def test_the_exact_linear_motion_passes_and_a_wrong_rate_does_not():
    oscillator = Oscillator({1: "1/10"})
    check_motion(linear, oscillator, [0, "1/2", 7, 40], 12)
    with pytest.raises(AssertionError, match=r"x\(7 s\)"):
        check_motion(lambda o, t: linear(o, t, Fraction(101, 1000)), oscillator, [7], 4)


def test_coefficients_know_their_gauge():
    # Cubic damping: Omega_2 is -45/256 in the turning-point gauge and +9/256 without first harmonic.
    check_coefficients({"p_1": "3/8", "Omega_2": "-45/256"}, [3], 2)
    with pytest.raises(AssertionError, match="Omega_2 in the gauge turning-point"):
        check_coefficients({"p_1": "3/8", "Omega_2": "9/256"}, [3], 2)
    check_coefficients({"p_1": "3/8", "Omega_2": "9/256"}, [3], 2, "no-first-harmonic")
    with pytest.raises(AssertionError, match="missing"):
        check_coefficients({"p_1": "3/8"}, [3], 2)


@settings(max_examples=20)
@given(strategies.laws(), strategies.oscillators())
def test_drawn_laws_and_oscillators_are_valid(law, oscillator):
    assert law.is_dissipative
    assert 1 <= len(law.terms) <= 3
    assert oscillator.length() > 0
