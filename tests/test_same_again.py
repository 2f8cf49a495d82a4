"""Every public result through a pickle, a copy and a deep copy, and made twice: the same each time, by ==, by hash."""

import copy
import pickle

import numpy as np
import pytest
from flint import acb, arb

import asymptotics as asy
from asymptotics.numbers.alike import key
from asymptotics.sweeps.run import SweepResult
from tests.every_call import CALLS, answered
from tests.present import every_type

TEXTS = (*every_type.SAMPLES.values(), *every_type.VARIANTS)
NO_RESULT = ("html_report", "plot", "sweep", "sweep_command")
"""A text, a figure; the result of a sweep has its duration and its folder in it."""
OTHERS = [name for name in CALLS if not every_type.samples_of(getattr(asy, name)) and name not in NO_RESULT]
"""Calls that are none of the questions, whose answers are among the types."""
AGAIN = {
    "pickle": lambda x: pickle.loads(pickle.dumps(x)), "copy": copy.copy, "deepcopy": copy.deepcopy,
}  # fmt: skip


def _hash(x):
    try:
        return hash(x)
    except TypeError:  # of what holds a mapping or a list
        return None


def same(a, b) -> None:
    assert type(a) is type(b) and repr(a) == repr(b)
    assert (a == b) is True and (a != b) is False
    assert _hash(a) == _hash(b)


def all_the_same(one, other):
    same(one, other)
    for again in AGAIN.values():
        same(one, again(one))
    # What is kept inside after use (repr, tables) goes along, and changes nothing.
    assert str(one) == str(other)
    same(other, AGAIN["pickle"](one))


@pytest.mark.parametrize("text", TEXTS)
def test_a_result_of_every_type_is_the_same_again(text):
    one, other = (made[text] for made in (every_type.made(), every_type.made(2)))
    if isinstance(one, SweepResult):  # it has its folder's name in it, and the two folders differ
        other = one
    all_the_same(one, other)


@pytest.mark.parametrize("name", OTHERS)
def test_the_answer_of_every_call_is_the_same_again(name, tmp_path):
    call = getattr(asy, name)
    usual = answered(call, folder=tmp_path / "store")
    all_the_same(call(**usual), call(**usual))


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
