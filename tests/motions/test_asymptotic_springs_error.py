"""The printed error of an expansion covers the true one beside springs: random oscillators against DOP853.

Losses with and without |x|^m, the pendulum up to 3 rad, Duffing, x^5, x|x|, softening springs, springs with |x'|^q, two
springs; a start with a velocity where that is served; any units.  What is refused is refused by name.
"""

from fractions import Fraction
from random import Random

import pytest

from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.motions.asymptotic import AsymptoticMotion
from tests.motions.test_asymptotic_springs import truth

EXPONENTS = [Fraction(1, 2), 1, 1, Fraction(3, 2), 2, 2, 3, Fraction(7, 3)]


def case(seed):
    random = Random(seed)

    def fraction(low, high):
        return Fraction(random.randint(int(low * 100), int(high * 100)), 100)

    law, rest = {}, {}
    for _ in range(random.randint(1, 2)):
        key = random.choice(EXPONENTS), random.choice([0, 0, 0, 1, 2])
        law[key] = fraction(0.01, 0.5) * random.choice([Fraction(1, 5), 1])
    kind = random.choice(["pendulum", "x^3", "x^5", "x|x|", "soft", "velocity", "two"])
    x0 = fraction(0.3, 3.0 if kind == "pendulum" else 1.5) * random.choice([1, -1])
    strength = fraction(0.02, 0.6)
    spring = {
        "pendulum": "pendulum", "x^3": {3: strength}, "x^5": {5: strength}, "x|x|": {2: strength},
        "soft": {3: -strength}, "velocity": {(random.choice([1, 3]), random.choice([2, Fraction(1, 2)])): strength},
        "two": {3: strength, 5: fraction(-0.3, 0.3)},
    }[kind]  # fmt: skip
    if kind not in ("pendulum", "soft", "two") and random.random() < 0.4:
        rest["v0"] = fraction(-1, 1)
    if random.random() < 0.3:
        rest |= {"mass": fraction(0.5, 3), "stiffness": fraction(0.5, 5)}
    return Oscillator(law, spring=spring, x0=x0, **rest), fraction(0.5, 25), random.randint(1, 3)


def assert_covered(seed):
    oscillator, time, order = case(seed)
    told = f"{oscillator} at {time}, order {order}"
    try:
        found = AsymptoticMotion.of(oscillator, order).at(time, 10)
    except InputError as refused:
        assert refused.argument in ("order", "spring", "v0"), told
        return
    x = truth(oscillator, [float(time)])[0]
    assert abs(float(found.x) - x) <= float(found.error) + 1e-7, f"{told}: {found} against {x}"


@pytest.mark.parametrize("seed", [1, 5])
def test_the_error_is_covered(seed):
    assert_covered(seed)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(100, 220))
def test_the_error_is_covered_on_many(seed):
    assert_covered(seed)


@pytest.mark.parametrize("x0", ["8/5", "5/2", "3"])
def test_a_pendulum_beyond_ninety_degrees_knows_that_the_series_says_little(x0):
    """Order 3 from 92, 143 and 172 degrees: the printed error covers the true one, and above delta = 1 it says why."""
    oscillator = Oscillator({2: "1/20"}, spring="pendulum", x0=x0)
    found = AsymptoticMotion.of(oscillator, 3).at(7, 10)
    assert abs(float(found.x) - truth(oscillator, [7.0])[0]) <= float(found.error)
    assert any("not small" in note for note in found.notes) is (x0 != "8/5")
