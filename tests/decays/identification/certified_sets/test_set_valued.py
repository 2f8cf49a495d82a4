"""Printed decrements: the certified set holds the truth, is not much larger than it must be, and can be empty."""

import json

import numpy as np
import pytest
from flint import ctx

import asymptotics as asy
from asymptotics.decays.identification.certified_sets import set_valued
from asymptotics.decays.identification.certified_sets.certified_ratio import BITS, CertifiedRatio
from asymptotics.decays.identification.certified_sets.set_valued import _beyond, strengths_that_fit
from asymptotics.decays.identification.certified_sets.table_rows import meets, rows_of
from asymptotics.decays.identification.fitting.printed import DecrementModel, Decrements
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.forward.coefficients import loss
from asymptotics.decays.identification.forward.swing import HalfSwingModel
from asymptotics.shell.main import main
from asymptotics.terms import Term
from tests.decays.identification.certified_sets.printed_tables import losses, printed


@pytest.mark.parametrize(
    ("law", "strengths"), [("1", [0.02]), ("2", [0.03]), ("0+1", [0.004, 0.01]), ("1+2", [0.01, 0.03])]
)
@pytest.mark.parametrize("digits", [3, 4])
def test_the_set_holds_the_truth_and_shrinks_with_the_digits(law, strengths, digits):
    found = strengths_that_fit(losses(law), printed(law, strengths, digits))
    assert found.verdict == "consistent"
    for interval, true in zip(found.epsilon, strengths, strict=True):
        assert interval.low <= true <= interval.high
        assert interval.high - interval.low < (60 if "," in law else 6) * 10.0**-digits


def test_the_ends_of_the_set_are_attained():
    table = printed("1", [0.02], 3)
    found = strengths_that_fit(losses("1"), table).epsilon[0]
    model = DecrementModel(HalfSwingModel([loss(1.0)]), table)

    def met(epsilon):
        return (np.abs(model.predict(np.array([epsilon]))[0] - table.decrement) <= table.resolution).all()

    width = found.high - found.low
    assert met(found.low + 0.01 * width)
    assert met(found.high - 0.01 * width)
    assert not met(found.low - 0.01 * width)
    assert not met(found.high + 0.01 * width)


def test_a_wrong_law_is_refuted_by_proof_and_a_wrong_digit_too():
    table = printed("1+2", [0.01, 0.03], 4)
    assert strengths_that_fit(losses("1"), table).verdict == "refuted"
    assert strengths_that_fit(losses("2"), table).verdict == "refuted"
    wrong = Decrements(table.amplitude, table.decrement + 2e-4 * (np.arange(12) == 5), table.resolution)
    assert strengths_that_fit(losses("1+2"), wrong).verdict == "refuted"


@pytest.mark.slow
def test_a_strong_cubic_loss_is_proved_and_so_is_every_law_that_contains_it():
    # a decrement of an eighth of the amplitude
    answer = asy.identify(printed("3", [0.1], 4, rows=30), laws=["2", "3", "0+3", "1+2+3"])
    verdicts = {str(entry.law.candidate): entry.law.verdict for entry in answer.laws}
    assert verdicts == {"2": "refuted", "3": "consistent", "0+3": "consistent", "1+2+3": "consistent"}
    assert answer.verdict.text.startswith("identified: 3")
    assert answer.law("0+3").law.epsilon[0].high < 1e-5
    assert answer.law("0+3").law.epsilon[1].contains(0.1)


def test_the_command_reads_resolutions(tmp_path, capsys):
    table = printed("1+2", [0.01, 0.03], 4)
    rows = [f"{a},{d:.4f},0.00005" for a, d in zip(table.amplitude, table.decrement)]
    path = tmp_path / "decrements.csv"
    path.write_text("amplitude,decrement,resolution\n" + "\n".join(rows) + "\n")
    assert main(["identify", str(path), "--laws", "1", "1+2", "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["verdict"].startswith("identified: 1+2")
    laws = {"+".join(law["alphas"]): law for law in answer["laws"]}
    assert laws["1"]["verdict"] == "refuted"
    assert laws["1+2"]["intervals"] == "certified set"
    assert float(laws["1+2"]["epsilon"][0]["low"]) <= 0.01 <= float(laws["1+2"]["epsilon"][0]["high"])


def test_decrements_without_resolution_have_statistical_intervals():
    table = printed("1+2", [0.01, 0.03], 5, rows=30)
    noisy = table.decrement + 1e-5 * np.random.default_rng(1).standard_normal(30)
    answer = asy.identify({"amplitude": table.amplitude, "decrement": noisy}, laws=["1", "1+2"])
    assert answer.law("1+2").law.epsilon[1].contains(0.03)
    assert answer.law("1").law.verdict == "refuted"


def test_a_loss_that_depends_on_position_has_a_certified_set():
    table = printed("1+1,2:", [0.01, 0.04], 4)
    found = strengths_that_fit(losses("1+1,2:"), table)
    assert found.verdict == "consistent"
    for interval, true in zip(found.epsilon, (0.01, 0.04), strict=True):
        assert interval.low <= true <= interval.high
        assert interval.high - interval.low < 0.005
    assert strengths_that_fit(losses("1"), table).verdict == "refuted"


def test_every_law_that_contains_a_consistent_one_is_consistent_and_no_other_is_left_open():
    answer = asy.identify(printed("1+2", [0.01, 0.03], 4), laws=["1", "2", "0+3", "1+2", "0+1+2", "free"])
    verdicts = {str(entry.law.candidate): entry.law.verdict for entry in answer.laws}
    assert answer.verdict.text.startswith(
        "identified: 1+2 meets every printed value (proved); not excluded beside it (proved"
    )
    assert [a.term for a in answer.verdict.allowed] == ["0"]
    assert answer.verdict.allowed[0].largest == answer.law("0+1+2").law.epsilon[0].high
    assert {verdicts[law] for law in ("1+2", "0+1+2")} == {"consistent"}
    assert {verdicts[law] for law in ("1", "2", "0+3", "free")} == {"refuted"}
    assert answer.law("0+1+2").law.unneeded == ("0",)


def test_strengths_beyond_the_searched_box_are_found_among_the_physical_ones():
    # the first box, |epsilon| <= 0.15, does not reach 0.4
    found = strengths_that_fit(losses("1"), printed("1", [0.4], 3))
    assert found.verdict == "consistent"
    assert found.reason == "the set is that of strengths >= 0"
    assert found.epsilon[0].contains(0.4)
    assert found.epsilon[0].high - found.epsilon[0].low < 0.001


def test_a_table_that_only_negative_strengths_meet_refutes_the_law_as_unphysical():
    # a decrement that falls faster than a^2 between 1 and 2: linear loss minus quadratic loss is met, but not physical
    a = np.array([1.0, 0.8, 0.6, 0.4])
    model = DecrementModel(read_candidate("1+2").swing(), Decrements(a, a))
    D = np.round(model.predict(np.array([0.04, -0.01]))[0], 5)
    table = Decrements(a, D, np.full(4, 5e-6))
    found = strengths_that_fit(losses("1+2"), table)
    assert found.verdict == "refuted"
    assert "unphysical" in found.reason


def test_a_table_that_grows_is_met_by_no_loss():
    table = {"amplitude": [1.0, 0.5, 0.2], "decrement": [-0.1, -0.05, -0.02], "resolution": [0.005] * 3}
    answer = asy.identify(table, laws=["1", "2", "1+2", "free"])
    assert {entry.law.verdict for entry in answer.laws} == {"refuted"}
    assert "negative ones do: unphysical" in answer.law("1").law.reason


def test_a_negative_point_is_no_estimate_of_strengths_that_are_not_negative():
    """Where the set goes on behind the searched box, a box of the strengths >= 0 has no room for a negative point."""
    losses = (Term(1, 1), Term(1, 2))
    a = np.array([1.0, 0.9])
    table = Decrements(a, np.array([0.06, 0.05]), np.array([0.02, 0.02]))
    negative, positive = np.array([-0.002, 0.05]), np.array([0.01, 0.02])
    with ctx.workprec(BITS):
        ratio = CertifiedRatio.of(losses)
        rows = rows_of(ratio, table)
        found = [_beyond(losses, ratio, rows, np.ones(2), None, p, False) for p in (negative, positive)]
        assert meets(ratio, rows, negative) and meets(ratio, rows, positive)
    for answer, point in zip(found, (negative, positive)):
        assert answer.verdict == "consistent" and (answer.point == point).all()
        assert all(e.low is None or e.low <= e.estimate <= e.high for e in answer.epsilon)
    assert found[1].epsilon[0].low is not None


def test_a_law_that_is_consistent_by_a_smaller_one_alone_allows_its_further_term_without_limit():
    # five losses have no certified set of their own
    table = {"amplitude": [1.0, 0.8, 0.6], "decrement": [0.1, 0.06, 0.04], "resolution": [0.005] * 3}
    answer = asy.identify(table, laws=["0+1+2+3", "0+1+2+3+4"])
    assert answer.law("0+1+2+3+4").law.verdict == "consistent"
    assert [(a.term, a.largest) for a in answer.verdict.allowed] == [("4", None)]


def test_a_point_that_lies_outside_the_searched_box_is_no_estimate_within_it(monkeypatch):
    table = printed("1", [0.02], 3)
    point, box = np.array([0.02]), (np.array([0.03]), np.array([0.04]))
    monkeypatch.setattr(set_valued, "_smallest_box", lambda *a: box)
    found = strengths_that_fit(losses("1"), table, point)
    assert found.verdict == "consistent" and found.epsilon[0].contains(0.02)
