"""What the data still allow beside a law: which terms are asked, how strong they may be, and their share."""

from types import SimpleNamespace

import pytest

from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.judging.allowance import Allowance, allowance_text, allowances

SURE = Interval(0.04, 0.05, 0.06)


def law(text, *epsilon, springs=(), verdict="consistent"):
    candidate = read(text)
    names = [*candidate.alphas, *(f"s{p}" for p in candidate.springs)]
    strengths = list(zip(names, [*epsilon, *springs], strict=False))
    return SimpleNamespace(candidate=candidate, epsilon=epsilon, strengths=strengths, verdict=verdict)


def found(chosen, *laws, first=1.0):
    return [(a.term, a.largest, a.share) for a in allowances(chosen, (chosen, *laws), first)]


def test_one_term_that_stands_alone_beside_the_law_is_allowed():
    one, loose = law("1", SURE), Interval(-0.01, 0.0, 0.03)
    beside = [law("1+2", SURE, loose), law("1+2+3", SURE, loose, loose), law("2", SURE), law("free", SURE)]
    assert [term for term, *_ in found(one, *beside)] == ["2"]
    assert found(one, law("1+2", SURE, loose, verdict="refuted")) == []


@pytest.mark.parametrize(
    ("first", "share"), [(1.0, 0.03 * 8 / (0.05 * 3 * 3.14159265)), (0.5, 0.015 * 8 / (0.15 * 3.14159265))]
)
def test_the_share_of_a_loss_is_that_of_its_first_order_at_the_first_amplitude(first, share):
    """-L = (pi/2) epsilon_1 and (4/3) epsilon_2 A a half-swing."""
    ((term, largest, got),) = found(law("1", SURE), law("1+2", SURE, Interval(-0.01, 0.0, 0.03)), first=first)
    assert (term, largest) == ("2", 0.03) and got == pytest.approx(share, rel=1e-6)


def test_springs_and_unknown_amplitudes_have_no_share_and_open_ends_no_limit():
    one = law("1", SURE)
    assert found(one, law("1+s3", SURE, springs=(Interval(-0.3, 0.0, 0.2),))) == [("s3", 0.3, None)]
    assert found(one, law("1+2", SURE, Interval(-0.01, 0.0, 0.03)), first=None) == [("2", 0.03, None)]
    assert found(one, law("1+2", SURE, Interval(None, 0.0, 0.03))) == [("2", None, None)]
    assert found(one, law("1+2", SURE, Interval(-0.01, 0.0, None))) == [("2", None, None)]
    assert found(one, law("1+2")) == [("2", None, None)]  # consistent by the point of the smaller law: no interval
    assert found(one, law("1+2", SURE, Interval(-0.3, -0.2, -0.1))) == []  # a loss is not negative: none is allowed


def test_in_place_of_a_sine_the_smallest_spring_is_told():
    one, ends = law("1+pendulum", SURE), Interval(-0.3, -0.2, -0.1)
    two = law("1+s3+s5", SURE, springs=(ends, Interval(-0.1, 0.0, 0.2)))
    assert found(one, two, law("1+s3", SURE, springs=(ends,))) == [("s3 in place of sin x", 0.3, None)]
    assert [t for t, *_ in found(one, two)] == ["s3 in place of sin x", "s5 in place of sin x"]
    assert (
        found(one, law("2+s3", SURE, springs=(ends,)))
        == []
        == found(law("1", SURE), law("2+s3", SURE, springs=(ends,)))
    )


def test_what_is_allowed_is_told_in_words_and_in_json():
    terms = (Allowance("2", 0.0123, 0.034), Allowance("3", 0.5, 1.234), Allowance("s3", None))
    assert allowance_text(terms) == (
        "; not excluded beside it (95 %; in brackets the share of the loss at the first amplitude): "
        "2 up to 0.012 (3.4 %), 3 up to 0.5 (all of it), s3 without limit"
    )
    assert allowance_text(terms[2:], "proved") == "; not excluded beside it (proved): s3 without limit"
    assert allowance_text(()) == ""
    assert terms[0].to_dict() == {"term": "2", "largest": "0.0123", "share": "0.034"}
    assert terms[2].to_dict() == {"term": "s3", "largest": None, "share": None}
