"""How an answer is told: every entry of the JSON, the rows of the table, units and digits, each from known numbers."""

import numpy as np
import pytest

from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.judging.contradiction import Contradiction
from asymptotics.decays.identification.judging.grades import Unexplained
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.telling.law_answer import LawAnswer, shown_interval
from asymptotics.decays.identification.telling.record_units import RecordUnits
from asymptotics.decays.identification.telling.result import _data, sorted_laws
from tests.decays.identification import small_laws
from tests.decays.identification.small_laws import BELOW, SURE, fit


def law(text="1+s3", criterion=-12.5, **more):
    """A judged law of which everything is known that can be told."""
    left = Unexplained(0.012, np.ones(2), np.zeros(2))
    known = {
        "found": fit(criterion, bic=-7.5, scales={"x": 1e-3, "t": 2e-3}), "unexplained": left,
        "epsilon": (Interval(0.04, 0.05, 0.07),), "springs": (Interval(0.1, 0.2, None),), "excess": 0.25,
        "unneeded": ("s3",), "against": Contradiction(p=0.125), "profiled": True, "held_out": 1.0625,
    }  # fmt: skip
    return small_laws.law(text, **(known | more))


def test_every_entry_of_the_json_of_a_law():
    """The contract of ``identify --json``: keys and numbers as texts."""
    assert LawAnswer(law()).to_dict() == {
        "alphas": ["1"], "springs": ["3"], "pendulum": False, "verdict": "consistent",
        "grade": "consistent", "unexplained": "0.012", "reason": None,
        "epsilon": [Interval(0.04, 0.05, 0.07).to_dict()],
        "spring_strengths": [Interval(0.1, 0.2, None).to_dict()], "alpha": None, "criterion": "-12.5",
        "criterion_difference": "0.25", "unneeded": ["s3"], "p_value": "0.125", "bic": "-7.5",
        "intervals": "profile likelihood", "unphysical": [], "held_out_error": "1.0625",
        "formula": read("1+s3").formula(), "words": "viscous drag, hardening spring", "equivalent": None,
        "residual": {"x": "0.001", "t": "0.002"},
    }  # fmt: skip


def test_what_is_not_there_is_null():
    found = LawAnswer(law(unexplained=None, found=None, held_out=None, excess=np.nan)).to_dict()
    assert [found[k] for k in ("unexplained", "bic", "held_out_error", "criterion", "criterion_difference")] == [
        None
    ] * 5
    assert "residual" not in found and "physical" not in found


def test_intervals_say_how_they_were_made():
    kinds = [
        LawAnswer(law(profiled=profiled), certified=certified).to_dict()["intervals"]
        for profiled, certified in ((True, True), (False, True), (True, False), (False, False))
    ]
    assert kinds == ["certified set", "certified set", "profile likelihood", "curvature"]


@pytest.mark.parametrize(
    ("alpha", "position", "mass", "factor", "name"),
    [
        (1.0, 0, None, 3.0, "b/m"), (2.0, 0, None, 1 / 0.01, "b/m"), (0.0, 0, None, 9.0 * 0.01, "b/m"),
        (1.0, 2, 0.5, 0.5 * 3.0 / 0.01**2, "b"), (1.5, 0, 2.0, 2.0 * 3.0**0.5 * 0.01**-0.5, "b"),
    ],
)  # fmt: skip
def test_strengths_in_si_are_those_of_the_scaled_equation(alpha, position, mass, factor, name):
    """b/m = epsilon omega_0^(2 - alpha) (unit of x)^(1 - alpha - m), x in cm."""
    found = RecordUnits("cm", 0.01, mass, None, 3.0).physical(alpha, position, Interval(0.04, 0.05, None))
    assert found[0] == name and found[1].high is None
    assert (found[1].low, found[1].estimate) == pytest.approx((0.04 * factor, 0.05 * factor), rel=1e-14)


def test_without_a_frequency_or_a_unit_nothing_is_in_si():
    for units in (RecordUnits("cm", 0.01, 2.0, None, None), RecordUnits("", 1.0, 2.0, None, 3.0)):
        assert units.physical(1.0, 0, Interval(0.04, 0.05, 0.06)) is None
        assert "physical" not in LawAnswer(law(), units).to_dict()
    # The unit of b would depend on the exponent that was found.
    answer = LawAnswer(law("free"), RecordUnits("cm", 0.01, 2.0, None, 3.0))
    assert answer.physical(0) is None and "physical" not in answer.to_dict()


def test_each_loss_in_si_is_told_with_its_quantity():
    answer = LawAnswer(law("1"), RecordUnits("m", 1.0, None, None, 3.0))
    (found,) = answer.to_dict()["physical"]
    assert (found["quantity"], found["unit"]) == ("b/m", "1/s")
    assert float(found["estimate"]) == pytest.approx(0.15, rel=1e-12)


def test_the_rows_of_a_law_are_its_exponent_its_losses_and_its_springs():
    answer = LawAnswer(law("free+s3", alpha=Interval(1.4, 1.5, 1.6)))
    rows = answer.strengths()
    assert [row["parameter"] for row in rows] == ["alpha", "epsilon free", "spring 3"]
    assert [row["estimate"] for row in rows] == [1.5, 0.05, 0.2] and [row["high"] for row in rows] == [1.6, 0.07, None]
    assert {(row["law"], row["verdict"], row["dAICc"], row["held_out_error"]) for row in rows} == {
        ("free+s3", "consistent", 0.25, 1.0625)
    }
    assert answer._table()["low"] == [1.4, 0.04, 0.1] and list(answer._table()) == list(rows[0])


def test_a_line_of_the_table_has_five_cells():
    assert LawAnswer(law()).row() == (
        "1+s3", "consistent, s3 not needed", "0.2", "1.06", "1: 0.05 [0.04, 0.07]  s3: 0.2 [0.1, -]",
    )  # fmt: skip
    bare = law("1", springs=(), unneeded=(), excess=np.inf, held_out=None, alpha=Interval(1.0, 1.5, 2.0))
    assert LawAnswer(bare).row() == ("1", "consistent", "-", "-", "alpha 1.5 [1, 2]  0.05 [0.04, 0.07]")


@pytest.mark.parametrize(
    ("interval", "text"),
    [
        ((0.1, 0.2, 0.4), "0.2 [0.1, 0.4]"),  # four digits at least
        ((1.2345678, 1.2346, 1.2347), "1.2346 [1.234568, 1.2347]"),  # seven: the shorter half is 3.2e-5 of 1.2
        ((None, 1.23456789, None), "1.235 [-, -]"),
        ((None, 1.23456789, 1.23457), "1.2345679 [-, 1.23457]"),
        ((0.0, 0.0, 0.0), "0 [0, 0]"),
        ((1.0, 1 + 1e-13, 2.0), "1 [1, 2]"),  # twelve at most
    ],
)
def test_a_strength_is_told_to_two_digits_of_its_interval(interval, text):
    assert shown_interval(Interval(*interval)) == text


def test_the_laws_of_the_verdict_stand_first_then_the_better_ones():
    laws = [
        law("1+2", unneeded=("2",), criterion=1.0), law("3", verdict="refuted", criterion=0.0),
        law("2", unneeded=(), criterion=5.0), law("1", unneeded=(), criterion=4.0),
        law("0+1", unneeded=(), criterion=4.0),
    ]  # fmt: skip
    assert [str(one.candidate) for one in sorted_laws(laws)] == ["1", "0+1", "2", "3", "1+2"]


def test_physical_laws_stand_before_those_with_a_negative_loss_which_say_so():
    negative = (SURE, SURE, BELOW)
    laws = [law("0+2+3", unneeded=(), epsilon=negative, criterion=0.0), law("1+2", unneeded=(), criterion=5.0)]
    assert [str(one.candidate) for one in sorted_laws(laws)] == ["1+2", "0+2+3"]
    assert LawAnswer(laws[0]).row()[1] == "consistent, unphysical" and LawAnswer(laws[1]).row()[1] == "consistent"


def test_where_none_is_consistent_a_physical_law_within_the_data_heads_the_answer():
    laws = [
        law("0+2+3", verdict="refuted", epsilon=(SURE, SURE, BELOW), criterion=0.0),
        law("1+3", verdict="undetermined", epsilon=(SURE, SURE), outside="far", criterion=1.0),
        law("1+2", verdict="refuted", unneeded=(), epsilon=(SURE, SURE), criterion=5.0),
    ]
    assert [str(one.candidate) for one in sorted_laws(laws)] == ["1+2", "0+2+3", "1+3"]
    # Beside a consistent law the criterion alone puts the rest in order.
    laws.append(law("2", unneeded=(), criterion=9.0))
    assert [str(one.candidate) for one in sorted_laws(laws)] == ["2", "0+2+3", "1+3", "1+2"]


def test_the_data_are_told_by_what_they_are():
    assert _data(Decrements(np.ones(3), np.ones(3) / 10, None, "m", "d")) == {"name": "d", "decrements": 3}
    seen = Observations.of([0, 1], [0.5, -0.4], [0.0, 1.0], name="r")
    assert _data(seen) == {"name": "r", "turning_points": 2, "times": True, "first": "0.5"}
