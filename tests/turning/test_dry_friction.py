from fractions import Fraction

import pytest

import asymptotics as asy
from asymptotics.errors import InputError
from asymptotics.law import Law, Oscillator
from asymptotics.motions.coulomb import coulomb_stop
from asymptotics.numbers.exact import ExactReal, square_root
from asymptotics.turning.choose import turning_points
from asymptotics.turning.dry_friction import amplitude_in_motion, half_swings_until


@pytest.mark.parametrize("reach", [ExactReal(Fraction(1, 7)), square_root(Fraction(1, 50)), ExactReal(Fraction(2))])
def test_the_count_is_the_first_that_holds(reach):
    first, hold = ExactReal(1), reach * Fraction(3, 2)
    n = half_swings_until(first, reach, hold)
    assert first - 2 * n * reach <= hold and (n == 0 or first - 2 * (n - 1) * reach > hold)


def test_a_reach_of_zero_is_refused_by_name():
    with pytest.raises(InputError, match="never brings the mass to rest"):
        half_swings_until(ExactReal(1), ExactReal(0), ExactReal(0))


def test_a_speed_with_a_root_and_an_offset_has_its_own_square():
    """(s x0 - c)^2 + 2 = 9/4 is a square, (s x0 - c)^2 + (sqrt(2) - 1)^2 is none: the offset counts."""
    law, place, speed = Law({0: "1/10"}), Fraction(-3, 5), square_root(Fraction(2)) - 1
    half, reach = ExactReal(Fraction(3, 5)), ExactReal(Fraction(1, 10))
    assert amplitude_in_motion(half, reach, ExactReal(2)) == Fraction(7, 5)
    assert amplitude_in_motion(half, reach, speed * speed) is None
    near = "0.41421356237309504880168872420969807857"
    rounded, exact = (coulomb_stop(Oscillator(law, x0=place, v0=v), 10) for v in (near, speed))
    assert rounded == exact and exact.half_swings == 4
    tables = [turning_points(law, 3, 10, x0=place, v0=v) for v in (near, speed)]
    assert tables[0].points == tables[1].points


TIES = [(Fraction(7, 5), Fraction(16, 5), 1, -1), (0, square_root(Fraction(15)), 1, -1)]
TIES += [(0, square_root(Fraction(2, 25)), Fraction(1, 10), 0)]


@pytest.mark.parametrize(("x0", "v0", "b", "last"), TIES)
def test_ties_after_a_start_in_motion_are_decided_in_si_units(x0, v0, b, last):
    """With m = k = 1 and R^2 = (x0 + b)^2 + v0^2 = 16 or 9/100: it stops where friction just holds, or at 0."""
    found = asy.turning_points(asy.Oscillator({0: b}, x0=x0, v0=v0), 5, digits=9)
    assert found.ended == {"n": 1, "reason": "sticks"} and Fraction(found.points[-1].x) == last
    stop = coulomb_stop(Oscillator(Law({0: b}), x0=x0, v0=v0), 9)
    assert Fraction(stop.x) == last
    rough = Oscillator(Law({0: b}), x0=x0, v0=v0 * (1 + Fraction(1, 10**12)))  # the near miss: the next swing is made
    other = asy.turning_points(rough, 5, digits=9)
    assert (other.points[-1].n, Fraction(other.points[-1].x)) != (1, last)
