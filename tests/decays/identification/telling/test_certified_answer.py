"""Which certified sets are asked for, and what a law inherits from those it contains."""

import numpy as np
import pytest

from asymptotics.decays.identification.certified_sets.set_valued import StrengthSet
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.telling import certified_answer
from asymptotics.decays.identification.telling.certified_answer import _embedded, _set, _sets, certified
from asymptotics.decays.identification.telling.record_units import RecordUnits

TABLE = Decrements(np.array([1.0, 0.8]), np.array([0.10, 0.06]), np.array([0.005, 0.005]))


def consistent(*point):
    return StrengthSet("consistent", tuple(Interval(None, p, None) for p in point))


OPEN, REFUTED = StrengthSet("undetermined", (), "open"), StrengthSet("refuted", (), "none")


def answers(monkeypatch, sets):
    """The laws with their sets given, and with which known point each was asked."""
    asked = {}

    def found(candidate, _table, known):
        asked[str(candidate)] = None if known is None else known.tolist()
        return sets[str(candidate)]

    monkeypatch.setattr(certified_answer, "_set", found)
    laws = _sets([read(text) for text in sets], TABLE)
    return {str(law.candidate): law for law in laws}, asked


def test_a_law_is_asked_with_the_point_of_one_that_it_contains(monkeypatch):
    laws, asked = answers(monkeypatch, {"1+2": consistent(0.05, 0.0), "1": consistent(0.05), "2": REFUTED})
    assert asked == {"1": None, "2": None, "1+2": [0.05, 0.0]}
    assert {name: law.verdict for name, law in laws.items()} == {"1": "consistent", "2": "refuted", "1+2": "consistent"}


def test_a_negative_point_spares_no_search_but_makes_consistent(monkeypatch):
    laws, asked = answers(monkeypatch, {"1": consistent(-0.05), "1+2": OPEN, "2": OPEN})
    assert asked["1+2"] is None
    assert (laws["1+2"].verdict, laws["1+2"].reason) == ("consistent", "")
    assert (laws["2"].verdict, laws["2"].reason) == ("undetermined", "open")


def test_a_law_that_contains_none_keeps_its_own_answer(monkeypatch):
    laws, asked = answers(monkeypatch, {"1": OPEN, "1+2": REFUTED, "3": consistent(0.1)})
    assert laws["1+2"].verdict == "refuted" and asked["1+2"] is None and laws["3"].epsilon[0].estimate == 0.1


@pytest.mark.parametrize(
    ("smaller", "larger", "strengths"),
    [("1", "1+2", [0.5, 0.0]), ("2", "1+2", [0.0, 0.5]), ("2", "0+2+3", [0, 0.5, 0])],
)
def test_further_terms_have_the_strength_0(smaller, larger, strengths):
    assert _embedded(read(smaller), np.array([0.5]), read(larger)).tolist() == strengths


def test_more_losses_than_the_series_has_orders_for_stay_open():
    found = _set(read("0+1+2+3+4"), TABLE, None)
    assert (found.verdict, found.reason) == ("undetermined", "a certified set needs at most 4 losses")


@pytest.mark.parametrize(
    ("sets", "kind", "words"),
    [
        ({"1": consistent(0.05), "2": REFUTED}, "identified", "1 meets every printed value (proved)"),
        ({"1": consistent(0.05), "2": OPEN}, "several", "undecided: 2"),
        ({"1": consistent(0.05), "1+2": OPEN}, "identified", "1 meets every printed value (proved)"),
        ({"1": consistent(0.05), "2": consistent(0.1)}, "several", "meet every printed value"),
        ({"1": OPEN, "2": REFUTED}, "too short", "undetermined for 1"),
        ({"1": REFUTED, "2": REFUTED}, "none", "no candidate law meets every printed value"),
    ],
)
def test_the_verdict_of_certified_sets(monkeypatch, sets, kind, words):
    monkeypatch.setattr(certified_answer, "_set", lambda candidate, *_: sets[str(candidate)])
    found = certified(TABLE, [read(text) for text in sets], RecordUnits())
    assert found.verdict.kind.startswith(kind) and words in found.verdict.text
