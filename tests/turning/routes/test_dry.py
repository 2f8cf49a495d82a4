"""Turning points under dry friction: the last one and the first amplitude, decided exactly."""

from fractions import Fraction
from types import SimpleNamespace

from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.routes.dry import _first_amplitude, last_turning_point


def test_a_start_that_dry_friction_holds_has_no_first_amplitude():
    """R = 1/2 about the shifted place of rest, and the friction is 1/2."""
    speed = ExactReal(Fraction(3, 10))

    def request(c, x0):
        return SimpleNamespace(alone=(0, ExactReal(c)), place=ExactReal(x0), speed=speed)

    assert _first_amplitude(request(Fraction(1, 2), Fraction(-9, 10))) is None
    assert _first_amplitude(request(Fraction(1, 10), Fraction(-1, 2))) == Fraction(4, 10)


def test_the_last_turning_point_of_dry_friction_is_decided_exactly():
    for n in (1, 2, 50):
        edge = Fraction(1, 2 * n + 1)
        assert last_turning_point(ExactReal(edge)) == n
        assert last_turning_point(ExactReal(edge - Fraction(1, 10**30))) == n + 1
