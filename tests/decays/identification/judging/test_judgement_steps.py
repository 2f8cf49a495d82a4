"""The steps of a verdict, each alone: what refutes, in which order, which laws stand for others, and what is said."""

from types import SimpleNamespace

import pytest

from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.judging import judgement
from asymptotics.decays.identification.judging.contradiction import REFUTED, Contradiction
from asymptotics.decays.identification.judging.judgement import (
    commented,
    contains,
    is_negative,
    labelled,
    minimal,
    relabelled,
    rivals,
    worst,
)
from asymptotics.decays.identification.judging.laws import UNTRIED
from tests.decays.identification import small_laws
from tests.decays.identification.small_laws import BELOW, SURE, fit


def law(text, found=None, *, criterion=0.0, **known):
    """A judged law, fitted unless it is said otherwise."""
    return small_laws.law(text, found or fit(criterion), **known)


@pytest.mark.parametrize(
    ("ends", "negative"),
    [
        ((-3.0, -2.0, -0.9), False),  # twice as far as the upper end: 0.2 above 0
        ((-3.0, -2.0, -1.0), False),  # just 0
        ((-3.0, -2.0, -1.01), True),
        ((-3.0, -2.0, -0.99), False),
        ((-3.0, -2.0, None), False),
        ((None, -2.0, -1.5), True),
        ((1.0, 2.0, 3.0), False),
    ],
)
def test_a_strength_is_negative_where_twice_its_interval_lies_below_zero(ends, negative):
    assert is_negative(Interval(*ends)) == negative


def test_what_refutes_a_law_is_asked_in_its_order():
    worse = Contradiction(read("2"), 20.0, 1, REFUTED / 2)
    steps = [{"epsilon": (SURE, BELOW)}, {"misfit": "a line at 3"}, {"against": worse}]
    told = [
        "unphysical: the strength of 2 is negative",
        "its residuals are not independent noise: a line at 3",
        str(worse),
    ]
    known = {}
    for step, reason in zip(steps, told, strict=True):
        known |= step
        found = labelled(law("1+2", verdict="undetermined", **known), growing=False)
        assert (found.verdict, found.reason) == ("refuted", reason)


@pytest.mark.parametrize(("p", "verdict"), [(REFUTED * 0.999, "refuted"), (REFUTED, "consistent")])
def test_a_contradiction_refutes_below_its_level(p, verdict):
    assert labelled(law("1", against=Contradiction(read("2"), 9.0, 1, p)), False).verdict == verdict


def test_a_growing_motion_may_have_negative_losses():
    assert labelled(law("1", epsilon=(BELOW,)), growing=True).verdict == "consistent"
    assert labelled(law("1", epsilon=(BELOW,)), growing=False).verdict == "refuted"


def test_a_law_without_a_limit_is_open_and_one_end_is_enough():
    none, one = Interval(None, 0.05, None), Interval(None, 0.05, 0.06)
    assert labelled(law("1+2", epsilon=(none, none)), False).verdict == "undetermined"
    assert labelled(law("1+2", epsilon=(none, one)), False).verdict == "consistent"
    for none in (fit(float("inf")), None):
        unusable = small_laws.law("1", none, verdict="as it was", misfit="x")
        assert labelled(unusable, False) is unusable


def test_the_worst_contradiction_is_that_of_a_law_that_may_be(monkeypatch):
    """Not of the law itself, and not of a loss that feeds a decay."""
    p = {"2": 0.3, "3": 0.01, "1+2": 0.2, "1": 0.0}
    monkeypatch.setattr(
        judgement, "against", lambda _, other: Contradiction(other.candidate, p=p[str(other.candidate)])
    )
    # Nor of one whose amplitudes lie outside the data.
    others = [law("1"), law("2"), law("3", epsilon=(BELOW,)), law("1+2"), law("0", outside="far outside")]
    p["0"] = 1e-9
    assert str(worst(others[0], others).by) == "1+2" and str(worst(others[0], others, growing=True).by) == "3"
    assert worst(others[0], others[:1]) == Contradiction()


def test_nothing_speaks_against_a_law_without_a_fit(monkeypatch):
    monkeypatch.setattr(judgement, "contradiction", lambda *_: "asked")
    full, other, none = law("1"), law("2"), small_laws.law("2")
    unusable = law("2", fit(float("inf")))
    assert judgement.against(full, other) == "asked"
    for less in (none, unusable):
        assert judgement.against(full, less) == Contradiction() == judgement.against(less, full)


@pytest.mark.parametrize(
    ("other", "known", "verdict"),
    [
        ("1", {}, "refuted"),
        ("1", {"misfit": ""}, "consistent"),  # a better law without a disturbance is a rival
        ("1", {"criterion": 4.5}, "consistent"),  # a worse one says nothing
        ("1", {"epsilon": (BELOW,)}, "consistent"),
        ("1", {"outside": "far"}, "consistent"),
        ("1", {"against": Contradiction(read("2"), 20.0, 1, REFUTED / 2)}, "consistent"),
        ("0+1+3", {}, "consistent"),  # it contains the law: no other loss
    ],
)
def test_no_law_stands_because_it_hides_a_disturbance_in_a_worse_fit(other, known, verdict):
    said = {"misfit": "a line at 3", "criterion": 1.0} | known
    better = law(other, verdict="undetermined", criterion=said.pop("criterion"), **said)
    (found, _) = relabelled([law("0+3", verdict="undetermined", criterion=4.0), better], growing=False)
    assert found.verdict == verdict and (verdict == "consistent" or "1 explains the data better" in found.reason)


def test_a_law_that_the_time_did_not_suffice_for_is_open_whatever_speaks_against_it():
    untried = law("1", missed=UNTRIED, misfit="x", against=Contradiction(read("2"), 9.0, 1, 0.0), verdict="refuted")
    found = labelled(untried, False)
    assert (found.verdict, found.reason) == ("undetermined", UNTRIED)


@pytest.fixture
def level(monkeypatch):
    """The probability of every law, were any other true."""
    p = SimpleNamespace(p=1.0)
    monkeypatch.setattr(judgement, "against", lambda *_: p)
    return p


@pytest.mark.parametrize(
    ("larger", "smaller", "inside"),
    [
        ("1+2", "1", True), ("1", "1+2", False), ("1", "1", False), ("1+s3", "1", True), ("2+s3", "1+pendulum", False),
        ("1+s3", "1+pendulum", True), ("1+2+s3", "1+pendulum", True), ("1", "1+pendulum", False),
        ("1+pendulum", "1+s3", False), ("free", "1", True), ("free", "1+2", False), ("free", "1,2:", False),
    ],
)  # fmt: skip
def test_a_law_contains_its_special_cases(level, larger, smaller, inside):
    del level
    assert contains(law(larger), law(smaller)) == inside


@pytest.mark.parametrize(
    ("alpha", "inside"),
    [((0.9, 1.2, 1.5), True), ((1.126, 1.25, 1.5), False), ((1.125, 1.25, 1.5), True), ((None, 3.0, None), True)],
)
def test_a_free_exponent_contains_those_within_twice_its_interval(level, alpha, inside):
    assert contains(law("free", alpha=Interval(*alpha)), law("1")) == inside
    assert contains(law("free+s3", alpha=Interval(*alpha)), law("1+pendulum")) == inside
    level.p = 0.0
    assert not contains(law("free+s3", alpha=Interval(*alpha)), law("1+pendulum"))  # the spring is a law of its own


def names(laws):
    return [str(one.candidate) for one in laws]


def test_the_minimal_laws_contain_no_other_that_stands(level):
    del level
    laws = [
        law("1+2", criterion=1.0), law("1", criterion=3.0), law("2+3", criterion=2.0), law("2", verdict="refuted"),
        law("0+2+3", criterion=0.0),
    ]  # fmt: skip
    assert names(minimal(laws)) == ["2+3", "1"]


def test_a_law_with_more_parameters_is_beaten_by_a_simpler_one_that_makes_it_improbable(level):
    laws = [law("1", criterion=1.0), law("2+3", criterion=0.0)]
    assert [names(part) for part in rivals(laws)] == [["2+3", "1"], []]
    level.p = 0.0
    assert [names(part) for part in rivals(laws)] == [["1"], ["2+3"]]
    assert [names(part) for part in rivals([law("1"), law("2")])] == [["1", "2"], []]  # as many parameters


def test_a_law_says_which_of_its_terms_are_not_needed(level):
    del level
    around, beside = Interval(-0.01, 0.01, 0.03), Interval(0.001, 0.01, 0.03)
    one, two, three, free = commented(
        [
            law("1"), law("1+2", epsilon=(SURE, around)), law("1+3+s3", epsilon=(SURE, beside), springs=(around,)),
            law("free", alpha=Interval(0.9, 1.2, 1.5)),
        ]
    )  # fmt: skip
    assert (one.reason, one.unneeded) == ("", ())
    assert (two.reason, two.unneeded) == ("contains 1, which is consistent; not needed: 2", ("2",))
    excluded = "; the interval of 3 excludes it, but not beyond doubt"
    assert three.reason == f"contains 1, which is consistent; not needed: 3, s3{excluded}" and three.unneeded == (
        "3",
        "s3",
    )
    assert free.reason == "contains 1, which is consistent; not needed: a free exponent"


def test_an_exponent_that_is_excluded_though_not_beyond_doubt_is_told(level):
    del level
    _, free = commented([law("1"), law("free", alpha=Interval(1.125, 1.25, 1.5), reason="before")])
    said = "not needed: a free exponent; the interval of a free exponent excludes it, but not beyond doubt; before"
    assert free.reason.endswith(said)


def test_springs_in_place_of_a_sine_are_not_excluded_by_their_own_strengths(level):
    """They stand for sin x, not for 0; a further loss does stand for itself."""
    del level
    _, spring = commented(
        [law("1+pendulum"), law("1+2+s3", epsilon=(SURE, SURE), springs=(Interval(-0.3, -0.2, -0.1),))]
    )
    assert spring.unneeded == ("2", "s3")
    assert spring.reason.endswith("not needed: 2, s3; the interval of 2 excludes it, but not beyond doubt")
