"""Printed decrements: the certified set holds the truth, is not much larger than it must be, and can be empty."""

import json
from fractions import Fraction

import numpy as np
import pytest
from flint import arb, ctx

import asymptotics as asy
from asymptotics.cli.main import main
from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.identification.certified_sets import free_exponent, physical, set_valued
from asymptotics.identification.certified_sets.central_point import chebyshev_point
from asymptotics.identification.certified_sets.certified_ratio import CertifiedRatio, followed
from asymptotics.identification.certified_sets.free_exponent import exponents_that_fit
from asymptotics.identification.certified_sets.physical import physical_box
from asymptotics.identification.certified_sets.set_valued import strengths_that_fit
from asymptotics.identification.certified_sets.table_rows import RatioInequality, linear, rows_of
from asymptotics.identification.fitting.printed import DecrementModel, Decrements
from asymptotics.identification.forward.candidates import read_candidate
from asymptotics.identification.forward.coefficients import loss
from asymptotics.identification.forward.swing import HalfSwingModel
from asymptotics.numbers.exact import ExactReal
from asymptotics.terms import Term


def losses(law):
    """Terms of strength 1 from a candidate such as 1+1,2:."""
    return tuple(Term(1, a, m) for a, m in read_candidate(law).losses)


def printed(law, strengths, digits, rows=12):
    a = np.round(np.linspace(1.0, 0.3, rows), 4)
    model = DecrementModel(read_candidate(law).swing(), Decrements(a, a))
    D = model.predict(np.array(strengths, dtype=float))[0]  # the reference amplitude is 1
    return Decrements(a, np.round(D, digits), np.full(rows, 0.5 * 10.0**-digits))


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


def test_the_tail_of_the_series_is_an_enclosure_that_bites():
    # viscous: L = -pi (d/2)/sqrt(1 - d^2/4), known in closed form
    with ctx.workprec(80):
        ratio = CertifiedRatio.of(losses("1"))
        d = arb("0.08")
        true = -arb.pi() * (d / 2) / (1 - d**2 / 4).sqrt()
        assert ratio.at([d]).contains(true)
        low = {k: c for k, c in ratio.coefficients.items() if sum(k) <= 3}
        short = CertifiedRatio(ratio.weights, ratio.crests, low, 3)
        assert short.at([d]).contains(true)
        assert not abs(short.polynomial([d]) - true) <= short.tail([d]) / 10**5  # the bound is not absurdly wide
        assert not short.polynomial([d]).overlaps(true)  # and without it the sum is wrong
        with pytest.raises(UndecidedError):
            ratio.tail([arb(1)])


def test_a_row_that_the_truth_just_meets_is_met_with_the_tail_only():
    """No box about the centre, and L itself as the level: b <= 0 on both sides, which the truncated sum is not."""
    with ctx.workprec(80):
        ratio, d = CertifiedRatio.of(losses("1")), arb("0.0625")
        true = -arb.pi() * (d / 2) / (1 - d**2 / 4).sqrt()
        short = CertifiedRatio(
            ratio.weights, ratio.crests, {k: c for k, c in ratio.coefficients.items() if sum(k) <= 3}, 3
        )
        b = linear(
            short, [RatioInequality(sign, (arb(1),), -true) for sign in (1, -1)], np.array([0.0625]), np.zeros(1)
        )[1]
        tail = float(short.tail([d]))
    assert max(b) <= 0 < max(b) + tail * (1 - 1e-9) and min(b) > -2 * tail


def test_the_tail_reaches_strong_losses_and_holds_what_is_left_out():
    with ctx.workprec(80):
        for law, strengths in (("3", ["0.12"]), ("0", ["0.1"]), ("1+3", ["0.05", "0.06"])):
            ratio = CertifiedRatio.of(losses(law))
            d = [arb(s) for s in strengths]
            low = {k: c for k, c in ratio.coefficients.items() if sum(k) <= 3}
            short = CertifiedRatio(ratio.weights, ratio.crests, low, 3)
            assert short.at(d).contains(ratio.at(d))
            assert short.tail(d) < 0.3
            assert not short.polynomial(d).overlaps(ratio.at(d))
        assert CertifiedRatio.of(losses("3")).tail([arb("0.12")]) < arb("1e-9")


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


def test_exact_coefficients_are_those_of_the_balls():
    with ctx.workprec(80):
        for law in ("1+2", "0+3", "1,2:+2"):
            ratio = CertifiedRatio.of(losses(law))
            balls = half_swing(quarter_swing(losses(law), 4)).L.coefficients
            for key, ball in balls.items():
                assert any(key)
                assert ball.overlaps(ratio.coefficients.get(key, arb(0)))
                assert not ball.overlaps(ratio.coefficients.get(key, arb(0)) + arb("1e-15"))


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


def test_the_physical_box_holds_the_truth_and_its_tests_bite():
    terms, table = losses("1+2"), printed("1+2", [0.01, 0.03], 3)
    with ctx.workprec(80):
        ratio = CertifiedRatio.of(terms)
        low, high = physical_box(terms, ratio, rows_of(ratio, table))
        assert (low <= [0.01, 0.03]).all()
        assert (high >= [0.01, 0.03]).all()
        assert (high - low < 0.02).all()
        # half a unit of the last digit more in one row, and the box is empty
        wrong = Decrements(table.amplitude, table.decrement + 3e-3 * (np.arange(12) == 5), table.resolution)
        assert physical_box(terms, ratio, rows_of(ratio, wrong)) == "none"


def test_a_last_box_that_is_dismissed_in_the_last_round_leaves_none(monkeypatch):
    terms, table = losses("1+2"), printed("1+2", [0.01, 0.03], 3)
    wrong = Decrements(table.amplitude, table.decrement + 3e-3 * (np.arange(12) == 5), table.resolution)
    monkeypatch.setattr(physical, "MAX_BOXES", 1)
    with ctx.workprec(80):
        ratio = CertifiedRatio.of(terms)
        assert physical_box(terms, ratio, rows_of(ratio, wrong)) == "none"
        assert isinstance(physical_box(terms, ratio, rows_of(ratio, table)), tuple)


@pytest.mark.parametrize(("law", "strength"), [("3/2", 0.05), ("0", 0.05)])
def test_the_set_of_a_free_exponent_holds_the_truth_and_its_ends_are_nearly_attained(law, strength):
    table, alpha = printed(law, [strength], 4, rows=20), float(Fraction(law))
    found = exponents_that_fit(table)
    assert found.verdict == "consistent"
    assert found.alpha.low <= alpha <= found.alpha.high < found.alpha.low + 0.005
    assert found.epsilon.low <= strength <= found.epsilon.high < found.epsilon.low + 1e-3
    # at a fixed exponent the least t with |D(epsilon) - D_k| <= t r_k, in doubles
    least = lambda a: chebyshev_point(read_candidate(str(Fraction(a))), table)[0]  # noqa: E731
    width = found.alpha.high - found.alpha.low
    assert least(found.alpha.high - 0.2 * width) < 1 < least(found.alpha.high + 0.01 * width)
    if alpha > 0:
        assert least(found.alpha.low + 0.2 * width) < 1 < least(found.alpha.low - 0.01 * width)


def test_no_exponent_fits_a_sum_and_a_wrong_digit_is_noticed():
    assert exponents_that_fit(printed("0+2", [0.01, 0.03], 4)).verdict == "refuted"
    table = printed("2", [0.05], 4)
    assert exponents_that_fit(table).alpha.contains(2.0)
    wrong = Decrements(table.amplitude, table.decrement + 3e-4 * (np.arange(12) == 5), table.resolution)
    assert exponents_that_fit(wrong).verdict == "refuted"


def test_more_resistance_costs_more_at_every_row():
    # what the strips rest on, in balls: the loss of a half-swing grows with e and falls with alpha, from below 1 on
    with ctx.workprec(60):
        for amplitude in ("1", "0.4"):
            lost = [
                -followed([(arb(e) * arb(amplitude) ** (ExactReal(Fraction(a)).ball() - 1), ExactReal(Fraction(a)))])
                for e, a in (("0.1", "2"), ("0.1", "3/2"), ("0.101", "3/2"), ("0.101", "1/2"))
            ]
            assert all(less < more for less, more in zip(lost, lost[1:]))


@pytest.mark.slow
def test_the_table_of_an_unknown_exponent_names_it(tmp_path, capsys):
    table = printed("3/2", [0.05], 4)
    path = tmp_path / "decrements.csv"
    rows = [f"{a},{d:.4f},0.00005" for a, d in zip(table.amplitude, table.decrement)]
    path.write_text("amplitude,decrement,resolution\n" + "\n".join(rows) + "\n")
    assert main(["identify", str(path), "--laws", "1", "2", "free", "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["verdict"].startswith("identified: free with alpha = 1.5")
    law = answer["laws"][0]
    assert law["alphas"] == ["free"]
    assert law["intervals"] == "certified set"
    assert float(law["alpha"]["low"]) <= 1.5 <= float(law["alpha"]["high"])


def test_a_narrow_box_is_covered_by_its_centre_and_radius_exactly():
    random = np.random.default_rng(5)
    low = random.uniform(0.0, 1.0, 2000)
    high = low + low * 10.0 ** random.uniform(-16.0, 0.0, 2000)
    for c, r, one, two in zip(*physical._covering(low, high), low, high, strict=True):
        assert Fraction(c) - Fraction(r) <= Fraction(one)
        assert Fraction(two) <= Fraction(c) + Fraction(r)


def test_a_law_that_is_consistent_by_a_smaller_one_alone_allows_its_further_term_without_limit():
    # five losses have no certified set of their own
    table = {"amplitude": [1.0, 0.8, 0.6], "decrement": [0.1, 0.06, 0.04], "resolution": [0.005] * 3}
    answer = asy.identify(table, laws=["0+1+2+3", "0+1+2+3+4"])
    assert answer.law("0+1+2+3+4").law.verdict == "consistent"
    assert [(a.term, a.largest) for a in answer.verdict.allowed] == [("4", None)]


@pytest.mark.parametrize("reference", [1.0, 0.37])
def test_the_strength_beside_a_free_exponent_is_the_one_that_is_proved(monkeypatch, reference):
    asked = []
    meets = free_exponent._Strips.meets
    monkeypatch.setattr(free_exponent._Strips, "meets", lambda *a: asked.append(a[1:]) or meets(*a))
    a = np.array([1.0, 0.7, 0.4]) * reference
    found = exponents_that_fit(Decrements(a, 0.1 * a**2, np.full(3, 5e-4)))
    assert found.verdict == "consistent"
    assert asked == [(found.epsilon.estimate, found.alpha.estimate)]


def test_a_point_that_lies_outside_the_searched_box_is_no_estimate_within_it(monkeypatch):
    table = printed("1", [0.02], 3)
    point, box = np.array([0.02]), (np.array([0.03]), np.array([0.04]))
    monkeypatch.setattr(set_valued, "_smallest_box", lambda *a: box)
    found = strengths_that_fit(losses("1"), table, point)
    assert found.verdict == "consistent" and found.epsilon[0].contains(0.02)
