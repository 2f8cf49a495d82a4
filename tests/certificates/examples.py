"""Certificates that several tests attack, made once each: what they are of, in the words of the library."""

import copy
from fractions import Fraction
from functools import cache

from asymptotics import turning_points
from asymptotics.certificates.of_results import of_states, of_turning_points
from asymptotics.law import Oscillator
from asymptotics.motions.reference import reference_motion
from tests.worlds import WORLDS

OSCILLATORS = {
    "quadratic": WORLDS["quadratic"].oscillator,
    "three halves": Oscillator({"3/2": "1/5"}),
    "sum": WORLDS["a sum of powers"].oscillator,
    "friction": Oscillator({0: "1/10", 2: "1/10"}),
    "strong": WORLDS["strong"].oscillator,
    "root": WORLDS["below the linear one"].oscillator,
    "units": Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="-1/5"),
    "in motion": Oscillator({2: "1/10"}, x0="1/2", v0="-1/3"),
    "seventh": Oscillator({"1/7": "1/10"}),
    "near one": Oscillator({"1001/1000": "1/10"}),
}
FOR_ATTACKS = {
    "linear": WORLDS["linear"].oscillator,
    "stronger": Oscillator({2: "3/20"}),
    "undamped": Oscillator({2: 0}),
    "pushed": Oscillator({1: "1/10"}, v0="-1/10"),
    "downwards": Oscillator({2: "1/10"}, v0="-1/1000"),
    "held": Oscillator({0: "3/10"}, x0="899/1000"),
    "from there": Oscillator({1: "1/10"}, x0="4999/5000", v0="-201/10000"),
    "three fifths": Oscillator({1: "3/5"}),
    "soft": Oscillator({2: "1/10"}, stiffness="1/100"),
    "stiff": Oscillator({2: "1/10"}, stiffness=100, x0="1/2", v0="-1/3"),
}


@cache
def _turning(name, count, digits):
    oscillator = (OSCILLATORS | FOR_ATTACKS)[name]
    return of_turning_points(oscillator, turning_points(oscillator, count, digits=digits, times=True))


@cache
def _state(name, times, digits):
    oscillator = (OSCILLATORS | FOR_ATTACKS)[name]
    return of_states(oscillator, [(t, reference_motion(oscillator, t, digits)) for t in times], digits)


def turning(name, count=3, digits=12):
    """The content of a certificate of turning points, to be changed at will."""
    return copy.deepcopy(_turning(name, count, digits).content[0])


def state(name, *times, digits=12):
    """The same of states at times."""
    return copy.deepcopy(_state(name, times, digits).content[0])


def time_of_first(content):
    """The time of turning point 1 since the start in motion, to five digits, from the pieces."""
    arrived, time = 0, Fraction(0)
    for p in content["pieces"]:
        time += Fraction(p["scale"]) * (2 if p["kind"] == "pass" else 1)
        arrived += p["kind"] == "arrive"
        if arrived == 2:
            return f"{float(time):.5g}"
    raise AssertionError
