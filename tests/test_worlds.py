"""What holds of every answer in every world: routes, digits, units, expansions, bounds, fits agree."""

from fractions import Fraction
from pathlib import Path

import pytest

import asymptotics as asy
from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.routes import ROUTES
from tests.worlds import CREEPING, DECAYING, EVERYDAY, NEAR_EQUAL, WORLDS

COUNT, TIME = 3, 2


def number(text):
    return Fraction(str(text))


def points(oscillator, digits=12, **more):
    return [number(p.x) for p in asy.turning_points(oscillator, COUNT, digits=digits, **more).points]


def answered(call):
    """What a call answers; None where it refuses."""
    try:
        return call()
    except asy.InputError as refused:
        assert str(refused).isprintable()
        return None


def unused(worlds, text):
    """The worlds that no test asks for by name."""
    return [name for name in worlds if f'"{name}"' not in text]


def test_every_world_is_another_says_what_it_may_break_and_is_asked():
    whole = {*EVERYDAY, *CREEPING, *NEAR_EQUAL}  # groups over which their tests run as they are
    files = (path for path in Path(__file__).parent.rglob("*.py") if path.name != "worlds.py")
    assert unused(WORLDS.keys() - whole, "".join(path.read_text(encoding="utf-8") for path in files)) == []
    assert len({repr((w.law, w.spring, w.units)) for w in WORLDS.values()}) == len(WORLDS)
    assert all(w.breaks for w in WORLDS.values())
    assert unused(["nobody asks " + "for me"], "nobody asks") != []  # near miss


@pytest.fixture(params=DECAYING)
def world(request):
    return WORLDS[request.param]


def test_more_digits_are_the_same_number(world):
    few, many = points(world.oscillator, 8), points(world.oscillator, 16)
    assert len(few) == len(many) > 1
    assert all(abs(a - b) <= abs(b) * Fraction(51, 10**9) for a, b in zip(few, many))
    exact = world.law.keys() == {0}  # 1, -47/50, ...
    assert exact or few != many  # near miss: they were rounded


def test_every_route_that_serves_it_finds_the_same_points(world):
    found, served = points(world.oscillator), 0
    for route in (r.name for r in ROUTES):
        other = answered(lambda route=route: points(world.oscillator, route=route))
        if other is not None:
            assert other == found
            served += 1
    assert served


def test_the_motion_turns_where_the_turning_points_are(world):
    """From one turning point to the time of the next: there the reference motion is at rest, at the next."""
    table = asy.turning_points(world.oscillator, COUNT, digits=15, times=True).points
    reference, first = asy.reference(world.oscillator), table[0]
    if number(first.x) != number(world.oscillator.x0.rational or 1):  # its times begin at turning point 0
        return
    there = reference.sample([float(table[1].t), float(table[1].t) / 2])
    assert abs(there.x[0] - float(table[1].x)) < 1e-8
    assert abs(there.v[0]) < 1e-6 < abs(there.v[1])  # near miss: at half of the time it is under way


def test_an_expansion_is_near_the_motion_and_nearer_with_its_order(world):
    truth = answered(lambda: number(asy.reference(world.oscillator).at(TIME, digits=9).x))
    found = [answered(lambda n=n: asy.motion(world.oscillator, order=n).at(TIME, digits=9)) for n in (1, 2)]
    if truth is None or None in found:
        return
    low, high = (abs(number(p.x) - truth) for p in found)
    assert low < abs(number(world.oscillator.x0.rational or 1)) and (high < low or world.law == {2: "3"})


def test_a_bound_holds(world):
    moving = answered(lambda: asy.motion(world.oscillator, order=1))
    bound = None if moving is None else answered(lambda: moving.bound(TIME))
    if bound is not None and bound != float("inf"):
        truth = number(asy.reference(world.oscillator).at(TIME, digits=9).x)
        assert abs(number(moving.at(TIME, digits=9).x) - truth) <= number(bound)


def test_twice_the_mass_and_the_spring_and_the_loss_are_the_same_motion(world):
    if world.units or world.spring or any(isinstance(a, tuple) for a in world.law):
        return
    doubled = asy.Oscillator({a: ExactReal(2 * Fraction(e)) for a, e in world.law.items()}, mass=2, stiffness=2)
    assert points(doubled) == points(world.oscillator)
    assert points(asy.Oscillator(world.law, mass=2, stiffness=2)) != points(world.oscillator)  # near miss


FITTED = {"linear": "1", "quadratic": "2", "a sum of powers": "1+2", "another rational power": "3/2"}


@pytest.mark.parametrize("name", FITTED)
def test_what_it_does_is_fitted_by_its_own_law(name):
    world = WORLDS[name]
    table = asy.turning_points(world.oscillator, 20, digits=12).points
    data = {"n": [p.n for p in table], "x": [float(p.x) for p in table]}
    (law,) = asy.identify(data, laws=[FITTED[name]], noise=1e-6, bootstrap=False).laws
    for interval, strength in zip(law.law.epsilon, world.law.values(), strict=True):
        assert interval.contains(float(Fraction(strength)))
        assert not interval.contains(float(Fraction(strength)) * 1.001)  # near miss
