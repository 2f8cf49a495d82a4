"""The words of a law found behind a table: what is named, and what the table cannot tell."""

import pytest

from asymptotics.ask.questions._damping_law import damping_law
from asymptotics.decays.identification.found_law import DampingLaw
from asymptotics.decays.identification.inverse_damping import DampingCandidate, Problem, Strength
from asymptotics.frames import BARE, Frame

METRES = Frame("m", "s")


def candidate(name, grade="consistent", low=0.01):
    """A law whose last strength has this lower end; each strength is its exponent in hundredths."""
    alphas = name.split("+")
    strengths = tuple(
        Strength(a, low if a == alphas[-1] else 0.01, 0.02 + int(a) / 100, 0.04 + int(a) / 100) for a in alphas
    )
    return DampingCandidate(name, strengths, 0.123, 1.0, 0.5, 1.0, grade)


def law(*candidates, frame=BARE):
    return DampingLaw(Problem("zeta", ()), candidates, 8, (0.1, 0.8), 0.01, 0.02, frame)


def unsaid(*candidates, frame=BARE):
    """What the table cannot tell, as the verdict says it."""
    _, _, found = law(*candidates, frame=frame).verdict.text.partition("the table cannot tell ")
    return found


def test_one_law_that_fits_is_named_with_its_strengths():
    found = law(candidate("1+2"), candidate("1", "refuted")).verdict.text
    assert found.startswith("viscous drag and drag in v^2: ")
    assert found.endswith("epsilon_1 = 0.03 [0.01, 0.05], epsilon_2 = 0.04 [0.01, 0.06]")


def test_where_nothing_fits_the_nearest_is_named_with_what_it_leaves():
    found = law(candidate("7", "refuted"), candidate("1", "refuted"))
    assert found.verdict.text.startswith(
        "no candidate fits; nearest is drag in v^(7), whose damping is 12 % off on average (root mean square);"
    )
    assert "cannot tell" not in found.verdict.text


def test_rivals_of_the_same_grade_are_told_but_for_those_with_a_term_too_many():
    rivals = [candidate("2"), candidate("1+2", low=0.0), candidate("3", "adequate"), candidate("0")]
    assert unsaid(candidate("1"), *rivals).startswith("it from 2 or 0, nor ")
    assert unsaid(candidate("1"), candidate("3", "adequate")) == ""
    assert unsaid(candidate("1", "adequate"), candidate("3", "adequate")) == "it from 3"
    assert unsaid(*map(candidate, "123456")) == "it from 2 or 3 or 4 or 5"  # four are named, all are in the table


def test_of_a_wider_law_the_terms_that_may_be_none_are_told_with_their_limits():
    """Of the first of them, if it is consistent and not the best itself."""
    wide, wider = candidate("1+2", low=0.0), candidate("1+3", low=0.0)
    assert unsaid(candidate("1"), wide, wider) == "drag in v^2 below 0.06 from none"
    assert unsaid(candidate("1"), wider, wide) == "cubic drag below 0.07 from none"
    assert unsaid(candidate("1"), candidate("1+2", "adequate", low=0.0)) == "" == unsaid(wide)
    assert unsaid(candidate("1"), candidate("1+0", low=0.0)) == "dry friction below 0.04 from none"


@pytest.mark.parametrize(("alpha", "unit"), [("0", "N"), ("1", "N s/m"), ("2", "N (s/m)^2")])
def test_strengths_in_si_have_their_units(alpha, unit):
    found = law(candidate(alpha), frame=METRES).verdict.text
    assert found.endswith(f"b_{alpha} = {0.02 + int(alpha) / 100:.4g} [0.01, {0.04 + int(alpha) / 100:.4g}] {unit}")
    assert unsaid(candidate("3"), candidate(f"3+{alpha}", low=0.0), frame=METRES).endswith(f" {unit} from none")


def test_what_the_first_order_lacks_is_told_and_more_than_the_resolution_is_a_warning():
    fine, coarse = (
        law(candidate("1")),
        DampingLaw(Problem("Q", ()), (candidate("1"),), 8, (0.1, 0.8), 0.03, 0.02, BARE),
    )
    assert "differs from it by at most 1 %" in str(fine) and "more than the resolution" not in str(fine)
    assert "by at most 3 %" in str(coarse) and "more than the resolution (2 %): the strengths are off" in str(coarse)


def test_every_entry_of_the_json_and_every_row_of_the_table():
    found = law(candidate("1+2", low=0.0), candidate("3", "refuted"), frame=METRES)
    told = found.to_dict()
    assert told["laws"][0] == {
        "law": "1+2", "pendulum": False, "grade": "consistent", "told": "consistent", "left": "0.123", "p_value": "0.5",
        "chi_squared": "1", "criterion": "1", "unneeded": ["2"],
        "strengths": [
            {"alpha": "1", "low": "0.01", "estimate": "0.03", "high": "0.05"},
            {"alpha": "2", "low": "0.0", "estimate": "0.04", "high": "0.06"},
        ],
    }  # fmt: skip
    assert {k: told[k] for k in ("quantity", "points", "amplitudes", "si", "certified", "neglected", "notes")} == {
        "quantity": "zeta", "points": 8, "amplitudes": ["0.1", "0.8"], "si": True, "certified": False,
        "neglected": "0.01", "notes": [],
    }  # fmt: skip
    assert told["verdict"] == found.verdict.text and [entry["law"] for entry in told["laws"]] == ["1+2", "3"]
    assert found._table() == {
        "law": ["1+2", "1+2", "3"], "grade": ["consistent", "consistent", "refuted"], "alpha": ["1", "2", "3"],
        "strength": [0.03, 0.04, 0.05], "strength_low": [0.01, 0.0, 0.01], "strength_high": [0.05, 0.06, 0.07],
    }  # fmt: skip
    page = found._page()
    assert (page.title, page.head) == (found.verdict.text, ("law", "grade", "strengths [95 %]"))
    assert page.rows == (
        ("1+2", "consistent", "b_1 = 0.03 [0.01, 0.05] N s/m, b_2 = 0.04 [0, 0.06] N (s/m)^2"),
        ("3", "refuted", "b_3 = 0.05 [0.01, 0.07] N (s/m)^3"),
    )
    assert found.law("3") is found.laws[1] and found.best is found.laws[0]


def test_the_strengths_behind_angles_are_torques():
    """Failed before: b_1 of a pendulum in rad was told in N s/m, where ``damping`` of the same law says N m s."""
    table = {"A [deg]": [5, 10, 20, 40], "zeta": [0.0120, 0.0141, 0.0178, 0.0261]}
    for spring in (None, "pendulum"):
        found = damping_law(table, laws=["1+2"], mass=2, stiffness=3, spring=spring)
        assert " N m s, " in found.verdict.text and found.verdict.text.endswith("N m (s/rad)^2")
    metres = damping_law({"A": [1, 2], "zeta": [0.01, 0.02]}, laws=["1"], mass=2, stiffness=3)
    assert " N s/m" in metres.verdict.text and " N m s" not in metres.verdict.text
