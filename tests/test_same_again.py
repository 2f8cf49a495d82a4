"""Every public result through a pickle, a copy and a deep copy, and made twice: the same each time, by ==, by hash."""

import copy
import pickle
from functools import cache, partial

import numpy as np
import pytest
from flint import acb, arb

import asymptotics as asy
from asymptotics.numbers.alike import key
from tests.every_question import IN_PYTHON, call_of, usual
from tests.present import every_type
from tests.worlds import OSCILLATOR as OSC

STARTED = asy.Oscillator({2: "1/10"}, x0="3/5", v0="-4/5")
PENDULUM = asy.Oscillator({2: "1/20"}, spring="pendulum", x0=3)
DECAY = {"n": list(range(12)), "x": [(-0.9) ** n for n in range(12)]}
MEASURED = {"A": [1, 0.9, 0.8, 0.7], "zeta": [0.01, 0.009, 0.008, 0.007]}
POL = {1: -1, (1, 2): 1}

MADE = {
    "C": [lambda: asy.C(9, 2)],
    "Coefficient": [lambda: asy.Coefficient("0.5", None)],
    "DampingLaw": [lambda: asy.damping_law(MEASURED, laws=["1", "2"]), lambda: _damped().rows[0]],
    "Envelope": [lambda: asy.envelope(OSC), lambda: asy.envelope({2: "1/10"}).formula],
    "Equations": [lambda: asy.expand("3/2", order=4), lambda: asy.expand("3/2").p, lambda: asy.expand("symbolic"),
                  lambda: asy.expand("3/2").observables(1, epsilon="1/10"), lambda: asy.expand(["1", "2"], order=2),
                  lambda: asy.expand("3/2").compare(asy.expand("3/2", order=2), epsilon="1/10")],
    "EquivalentDamping": [lambda: asy.damping({2: "1/10"}, 1, digits=5)],
    "Events": [lambda: asy.motion(OSC).events(2), lambda: asy.reference(OSC).events(2)],
    "ExactReal": [lambda: asy.ExactReal(1, 2, 1)],
    "G": [lambda: asy.G(3)],
    "Identification": [lambda: asy.identify(DECAY, laws=["1"], bootstrap=False)],
    "Law": [lambda: asy.Law({"3/2": "1/10"}), lambda: asy.Law({2: 1}).terms[0]],
    "Motion": [lambda: asy.motion(OSC), lambda: asy.motion(OSC).at(7), lambda: asy.motion(OSC).sample([0.0, np.nan]),
               lambda: asy.motion({2: "1/10"}).uniform_bound()],
    "Oscillator": [lambda: OSC, lambda: OSC.dimensionless, lambda: PENDULUM],
    "TurningPoints": [lambda: asy.turning_points(OSC, 3), lambda: asy.turning_points(OSC, 3).points[0]],
    "PaperStatement": [lambda: asy.paper("smith2012:43")],
    "PhysicalLaw": [lambda: OSC.law],
    "Reference": [lambda: asy.reference(OSC), lambda: asy.reference(OSC).at(1, digits=8),
                  lambda: asy.reference(OSC).sample([0.0, np.nan]), lambda: asy.reference({0: "1/50"}, static="1/30")],
    "S": [lambda: asy.S("1/4", "-1/4")],
    "T": [lambda: asy.T("1/4", "-1/4")],
    "any_start": [lambda: asy.any_start(asy.multiple_scales(2, order=1))],
    "compare": [lambda: asy.compare({"n": [0, 1], "x": [1, -0.41]}, {2: 1})],
    "envelope": [lambda: asy.envelope({2: "1/10"}).series(3), lambda: asy.envelope({2: "1/10"}).slow(),
                 lambda: asy.envelope(PENDULUM), lambda: asy.envelope(OSC).sample([0.0, 1.0])],
    "f": [lambda: asy.f(5)],
    "half_swing": [lambda: asy.half_swing(2), lambda: asy.half_swing(2, delta="1/10")],
    "limit_cycle": [lambda: asy.limit_cycle(POL), lambda: asy.limit_cycle(POL, mu="1/10", order=4)],
    "map_of_gauges": [lambda: asy.map_of_gauges(3)],
    "multiple_scales": [lambda: asy.multiple_scales(3, order=3), lambda: asy.multiple_scales("5/2", order=3),
                        lambda: asy.multiple_scales(2, order=3, gauge="turning-point"),
                        lambda: asy.multiple_scales("symbolic", order=2)],
    "radii": [lambda: asy.radii("1/2")],
    "remainder": [lambda: asy.remainder(2, order=2)],
    "solution": [lambda: asy.solution({2: "1/10"}), lambda: asy.solution({"3/2": "1/10"}, order=4),
                 lambda: asy.solution("symbolic"), lambda: asy.solution({1: "1/10"}), lambda: asy.solution(STARTED),
                 lambda: asy.solution({2: "1/10"}).at(1), lambda: asy.solution({0: "1/50", 2: "1/10"})],
    "statements": [lambda: asy.statements("smith2012")],
    "sweep": [],
    "table": [lambda: asy.table("smith2012.table1", digits=8)],
    "table_names": [asy.table_names],
    "turning_points": [lambda: asy.turning_points({2: 1}, 3), lambda: asy.turning_points({2: 1}, 3).certificate()],
    "waveforms": [lambda: asy.waveforms("3/2", order=2), lambda: asy.solution({2: "1/10"}).waveforms],
}  # fmt: skip
for _name in IN_PYTHON:  # by the example of its docstring
    if (_given := usual(call_of(_name))) is not None:
        MADE.setdefault(_name.replace("-", "_"), [partial(call_of(_name), **_given)])
# Their results are those of another name; what they return besides is None, a figure or a text; and errors are their
# own, as everywhere in Python.
SAME_AS = {"damping": "EquivalentDamping", "damping_law": "DampingLaw", "expand": "Equations",
           "identify": "Identification", "motion": "Motion", "paper": "PaperStatement", "reference": "Reference",
           "sweep_command": "sweep"}  # fmt: skip
NO_RESULT = {"InputError", "LimitError", "UndecidedError", "html_report", "plot", "testing"}
CASES = [pytest.param(make, id=f"{name}-{i}") for name, made in MADE.items() for i, make in enumerate(made)]
AGAIN = {
    "pickle": lambda x: pickle.loads(pickle.dumps(x)), "copy": copy.copy, "deepcopy": copy.deepcopy,
}  # fmt: skip


def _damped():
    return asy.damping({2: "1/10"}, 1, digits=5)


def test_every_public_name_is_here():
    assert set(asy.__all__) - NO_RESULT == set(MADE) | set(SAME_AS)
    assert set(SAME_AS.values()) <= set(MADE)


def _hash(x):
    try:
        return hash(x)
    except TypeError:  # of what holds a mapping or a list
        return None


def same(a, b) -> None:
    assert type(a) is type(b) and repr(a) == repr(b)
    assert (a == b) is True and (a != b) is False
    assert _hash(a) == _hash(b)


@pytest.mark.parametrize("make", CASES)
def test_a_result_is_the_same_again(make):
    one, other = make(), make()
    same(one, other)
    for again in AGAIN.values():
        same(one, again(one))
    # What is kept inside after use (repr, tables) goes along, and changes nothing.
    assert str(one) == str(other)
    same(other, AGAIN["pickle"](one))


def test_a_result_of_a_sweep_is_the_same_again(tmp_path):
    found = asy.sweep_command("moment", {"p": "1,2"}, tmp_path / "s", workers=1)
    for again in AGAIN.values():
        same(found, again(found))


DIFFERENT = [
    lambda n: asy.motion({2: "1/10"}, order=n), lambda n: asy.reference({2: n}),
    lambda n: asy.solution({2: "1/10"}, order=n),
    lambda n: asy.solution({0: "1/50", 2: "1/10"}, order=n), lambda n: asy.motion({2: "1/10"}).sample([0.0, float(n)]),
    lambda n: asy.motion({2: "1/10"}).events(5 * n), lambda n: asy.remainder(2, order=n),
    lambda n: asy.multiple_scales(2, order=n, gauge="turning-point"), lambda n: asy.envelope({2: n}),
]  # fmt: skip


@pytest.mark.parametrize("make", DIFFERENT)
def test_what_differs_is_unequal(make):
    one, other = make(2), make(3)
    assert one != other and (one == other) is False and one != 3


def test_every_kind_of_ball_and_array_has_a_key():
    one = {"a": [arb(2).sqrt(), acb(1, arb(3).sqrt())], "b": np.array([0.0, np.nan]), "c": arb.nan()}
    other = {"a": [arb(2).sqrt(), acb(1, arb(3).sqrt())], "b": np.array([-0.0, np.nan]), "c": arb.nan()}
    assert key(one) == key(other)
    for near in ({"a": [arb(2), acb(1)]}, {"b": np.array([0.0, 1.0])}, {"b": np.array([[0.0, np.nan]])}):
        assert key(one) != key(one | near)


def test_radii_come_back_exactly():
    # FLINT adds a unit of thirty bits to some of the radii that it is handed.
    for man in (648696931, 2**29 + 1, 2**30 - 1, 1, 3):
        for exponent in (-156, 0, 40):
            x = arb((-24070053663323292899311606104569099541, -128), (man, exponent))
            assert key(pickle.loads(pickle.dumps(x))) == key(x)


@cache
def _made_twice() -> tuple[dict, dict]:
    spaces: tuple[dict, dict] = ({}, {})
    for space in spaces:
        exec(every_type.SETUP, space)
    return spaces


@pytest.mark.parametrize("name", every_type.SAMPLES)
def test_one_of_every_type_is_the_same_again(name):
    """The list by types, which a new type enters or its own test fails; the list above is by names of calls."""
    one, other = (eval(every_type.SAMPLES[name], space) for space in _made_twice())
    assert every_type.name_of(type(one)) == name
    # A sweep has its folder's name in it, and the two folders differ.
    if name != "sweeps.run.SweepResult":
        same(one, other)
    for again in AGAIN.values():
        same(one, again(one))
