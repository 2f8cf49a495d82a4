"""The exact motions of one law: initial values, the equation of motion, mirror images."""

from fractions import Fraction

import pytest

from asymptotics.errors import InputError
from asymptotics.law import Law, Oscillator
from asymptotics.motions.coulomb import coulomb_motion
from asymptotics.motions.linear import linear_motion
from asymptotics.motions.quadratic import quadratic_motion


def oscillator(alpha, b, **rest):
    return Oscillator(Law({alpha: b}), **rest)


MOTIONS = [("0", coulomb_motion), ("1", linear_motion), ("2", quadratic_motion)]


@pytest.mark.parametrize(("alpha", "motion"), MOTIONS)
def test_equation_of_motion_by_fourth_order_differences(alpha, motion):
    """m x'' + k x + b v|v|^(alpha-1) = 0 with x'' and x' from five points, h = 1e-6: errors below 1e-22."""
    system = oscillator(alpha, "1/3", mass="2", stiffness="3", x0="1")
    h = Fraction(1, 10**6)
    x = [Fraction(motion(system, Fraction(1) + n * h, 60).x) for n in (-2, -1, 0, 1, 2)]
    acceleration = (-x[0] + 16 * x[1] - 30 * x[2] + 16 * x[3] - x[4]) / (12 * h * h)
    velocity = (x[0] - 8 * x[1] + 8 * x[3] - x[4]) / (12 * h)
    v = Fraction(motion(system, 1, 60).v)
    assert abs(v - velocity) < Fraction(1, 10**20) and v < 0
    residual = 2 * acceleration + 3 * x[2] - Fraction(1, 3) * abs(v) ** int(alpha)
    assert abs(residual) < Fraction(1, 10**20)
    assert abs(residual + Fraction(1, 100) * abs(v) ** int(alpha)) > Fraction(1, 10**3)  # a near miss of b


@pytest.mark.parametrize(("alpha", "motion"), MOTIONS)
def test_the_start_and_fewer_digits(alpha, motion):
    system = oscillator(alpha, "1/3", x0="-3/7")
    start = motion(system, 0, 12)
    assert (start.x, start.v) == ("-0.428571428571", "0")
    few, many = (motion(system, "5/2", digits) for digits in (10, 40))
    assert abs(Fraction(few.x) - Fraction(many.x)) <= Fraction(few.error)
    assert few.certified and few.gauge is None
    with pytest.raises(InputError, match="time"):
        motion(system, "-1", 10)
    with pytest.raises(InputError, match="law"):
        motion(oscillator("3/2", "1"), "1", 10)


def test_mirror_symmetry():
    for alpha, motion in MOTIONS:
        plus, minus = (motion(oscillator(alpha, "1/3", x0=x), "7/2", 15) for x in ("1", "-1"))
        assert Fraction(plus.x) == -Fraction(minus.x) and Fraction(plus.v) == -Fraction(minus.v)
