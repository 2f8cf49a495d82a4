"""Which answer follows from which proofs: every case of point, box and what is proved of the strengths >= 0."""

import numpy as np
import pytest

from asymptotics.decays.identification.certified_sets import set_valued
from asymptotics.decays.identification.certified_sets.set_valued import strengths_that_fit
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.errors import UndecidedError
from asymptotics.terms import Term

TABLE = Decrements(np.array([1.0, 0.8]), np.array([0.10, 0.06]), np.array([0.005, 0.005]))
PLUS, NONE, MINUS = np.array([0.05]), np.array([0.0]), np.array([-0.05])
INSIDE = (np.array([-0.06]), np.array([0.06]))
TOUCHING = (np.array([-0.06]), np.array([0.1]))
PHYSICAL = (np.array([0.01]), np.array([0.3]))


def answer(monkeypatch, point, box, physical, **known):
    """The set from these proofs, searched up to 0.1, and how often the strengths >= 0 were asked for."""
    asked = []

    def of_the_physical(*given, **named):
        asked.append((given, named))
        if isinstance(physical, Exception):
            raise physical
        return physical

    monkeypatch.setattr(set_valued, "proved_point", lambda *_: point)
    monkeypatch.setattr(set_valued, "_searched", lambda *_: np.array([0.1]))
    monkeypatch.setattr(set_valued, "_smallest_box", lambda *_: box)
    monkeypatch.setattr(set_valued, "physical_box", of_the_physical)
    return strengths_that_fit((Term(1, 2),), TABLE, **known), len(asked)


@pytest.mark.parametrize(
    ("point", "box", "physical", "verdict", "asked"),
    [
        (None, INSIDE, None, "undetermined", 1),
        (None, INSIDE, PHYSICAL, "undetermined", 1),
        (None, INSIDE, "none", "refuted", 1),
        (MINUS, INSIDE, None, "consistent", 1),
        (MINUS, INSIDE, PHYSICAL, "consistent", 1),
        (MINUS, INSIDE, "none", "refuted", 1),
        (PLUS, INSIDE, "none", "consistent", 0),  # the point is the proof: nothing else is asked
        (NONE, INSIDE, "none", "consistent", 0),  # no loss at all is >= 0 too
        (None, None, None, "undetermined", 1),
        (None, None, "none", "refuted", 1),
        (None, None, PHYSICAL, "undetermined", 1),
        (PLUS, None, None, "consistent", 1),
        (PLUS, TOUCHING, PHYSICAL, "consistent", 1),
        (None, TOUCHING, None, "undetermined", 1),
        (None, TOUCHING, "none", "refuted", 1),
        (MINUS, TOUCHING, PHYSICAL, "consistent", 1),
    ],
)
def test_only_a_proof_refutes_and_only_a_point_is_consistent(monkeypatch, point, box, physical, verdict, asked):
    found, times = answer(monkeypatch, point, box, physical)
    assert (found.verdict, times) == (verdict, asked)


def ends(found):
    return [(e.low, e.estimate, e.high) for e in found.epsilon]


def test_the_intervals_are_those_of_the_box_that_holds_the_set(monkeypatch):
    assert ends(answer(monkeypatch, PLUS, INSIDE, None)[0]) == [(-0.06, 0.05, 0.06)]
    assert ends(answer(monkeypatch, None, INSIDE, None)[0]) == [(-0.06, 0.0, 0.06)]  # the middle, and no point
    assert ends(answer(monkeypatch, PLUS, TOUCHING, PHYSICAL)[0]) == [(0.01, 0.05, 0.3)]
    assert ends(answer(monkeypatch, PLUS, TOUCHING, None)[0]) == [(None, 0.05, None)]  # it goes on, who knows how far
    assert ends(answer(monkeypatch, NONE, TOUCHING, PHYSICAL)[0]) == [(0.01, 0.0, 0.3)]
    assert ends(answer(monkeypatch, MINUS, TOUCHING, PHYSICAL)[0]) == [(None, -0.05, None)]


@pytest.mark.parametrize("end", [0.1, 0.1 * (1 - 1e-7)])
def test_a_box_that_touches_the_end_of_the_search_on_either_side_may_go_on(monkeypatch, end):
    for box in ((np.array([-0.01]), np.array([end])), (np.array([-end]), np.array([0.06]))):
        assert ends(answer(monkeypatch, PLUS, box, None)[0]) == [(None, 0.05, None)]
    within = (np.array([-0.0999]), np.array([0.0999]))
    assert ends(answer(monkeypatch, PLUS, within, None)[0]) == [(-0.0999, 0.05, 0.0999)]


@pytest.mark.parametrize("point", [0.061, -0.061])
def test_a_point_outside_the_box_shows_that_the_set_goes_on(monkeypatch, point):
    assert ends(answer(monkeypatch, np.array([point]), INSIDE, None)[0]) == [(None, point, None)]


def test_what_could_not_be_bounded_says_nothing_against_a_point(monkeypatch):
    open_ = UndecidedError("the ladder ends here")
    found, _ = answer(monkeypatch, MINUS, INSIDE, open_)
    assert found.verdict == "consistent" and found.reason == "the ladder ends here"
    found, _ = answer(monkeypatch, None, INSIDE, open_)
    assert (found.verdict, found.epsilon, found.reason) == ("undetermined", (), "the ladder ends here")


def test_a_point_that_is_known_is_not_sought(monkeypatch):
    found, _ = answer(monkeypatch, None, INSIDE, None, known=PLUS)
    assert found.verdict == "consistent" and found.point.tolist() == PLUS.tolist()


def test_a_refutation_says_what_was_proved(monkeypatch):
    reasons = [answer(monkeypatch, p, b, "none")[0].reason for p, b in ((None, INSIDE), (MINUS, INSIDE), (None, None))]
    first, unphysical, beyond = reasons
    assert first == "no strengths >= 0 meet every printed value (proved)"
    assert (
        unphysical == first + "; negative ones do: unphysical" and beyond == first + ", nor any with |epsilon| <= 0.1"
    )
