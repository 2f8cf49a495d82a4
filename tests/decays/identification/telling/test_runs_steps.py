"""Several runs step by step: the mean and its two errors by their formulas, common laws, and every verdict in words."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.stats import chi2, norm
from scipy.stats import t as student

from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.judging.allowance import Allowance
from asymptotics.decays.identification.judging.contradiction import REFUTED, Contradiction
from asymptotics.decays.identification.telling import runs
from asymptotics.decays.identification.telling.runs import common, mean_of_runs, verdict_of_runs
from asymptotics.decays.identification.telling.verdicts import IDENTIFIED, NONE, SEVERAL, UNDECIDED, UNTOLD, Verdict
from tests.decays.identification.small_laws import BELOW, SURE, fit, law


def test_runs_that_agree_have_the_error_within_them():
    y, s = np.array([1.0, 1.02, 0.99]), np.array([0.01, 0.02, 0.03])
    mean, between = mean_of_runs(y, s, level=0.9)
    w = s**-2.0
    assert mean.estimate == pytest.approx((w * y).sum() / w.sum()) and between == 0.0
    reach = norm.ppf(0.95) / np.sqrt(w.sum())
    assert mean.high - mean.estimate == pytest.approx(reach) == mean.estimate - mean.low
    assert mean_of_runs([2.0], [0.1]) == (Interval(None, 2.0, None), 0.0)


def test_runs_that_differ_have_the_error_between_them():
    """DerSimonian and Laird's variance; Hartung and Knapp's interval."""
    y, s = np.array([1.0, 1.3, 0.8, 1.1]), np.array([0.01, 0.02, 0.03, 0.02])
    mean, between = mean_of_runs(y, s)
    w = s**-2.0
    fixed = (w * y).sum() / w.sum()
    Q = (w * (y - fixed) ** 2).sum()
    tau2 = (Q - 3) / (w.sum() - (w**2).sum() / w.sum())
    w = 1 / (s**2 + tau2)
    random = (w * y).sum() / w.sum()
    reach = student.ppf(0.975, 3) * np.sqrt((w * (y - random) ** 2).sum() / 3 / w.sum())
    assert between == pytest.approx(np.sqrt(tau2)) and mean.estimate == pytest.approx(random)
    assert mean.high - random == pytest.approx(reach, rel=1e-7) and random - mean.low == pytest.approx(reach, rel=1e-7)


@pytest.mark.parametrize(("shift", "apart"), [(0.999, False), (1.001, True)])
def test_strengths_are_one_up_to_the_level_of_cochrans_test(shift, apart):
    """Two of equal errors differ by d: Q = d^2/(2 s^2) against its 95 % quantile."""
    d = shift * np.sqrt(2 * chi2.ppf(0.95, 1)) * 0.01
    assert (mean_of_runs([1.0, 1.0 + d], [0.01, 0.01])[1] > 0) == apart


def run(text, epsilon, criterion=1.0, **more):
    return law(text, fit(criterion), epsilon=tuple(Interval(*e) for e in epsilon), **more)


def test_a_common_law_has_the_sum_of_the_criteria_and_the_means():
    springs = (Interval(0.1, 0.2, 0.3),)
    first = run("free+s3", [(0.96, 1.0, 1.04)], 3.0, springs=springs, alpha=Interval(1.3, 1.5, 1.7))
    second = run("free+s3", [(1.26, 1.3, 1.34)], 4.0, springs=springs, alpha=Interval(1.4, 1.5, 1.6))
    found = runs._common([first, second])
    assert found.total == 7.0 == found.criterion and found.fit is None and str(found.candidate) == "free+s3"
    assert found.epsilon[0].estimate == pytest.approx(1.15) and found.intervals.apart == ("free",)
    assert found.springs[0].estimate == pytest.approx(0.2) and found.alpha.estimate == pytest.approx(1.5)
    pooled = 1.96 / np.sqrt(2 * (3.92 / 0.2) ** 2)
    assert found.springs[0].high - found.springs[0].estimate == pytest.approx(pooled, rel=1e-4)
    plain = runs._common([run("1", [(0.9, 1.0, 1.1)]), run("1", [(0.9, 1.0, 1.1)])])
    assert plain.alpha is None and plain.springs == () and plain.intervals.apart == ()


def test_a_law_that_one_run_does_not_determine_has_no_common_one():
    for second in (run("1", [(0.9, 1.0, 1.1)], float("inf")), law("1", None)):
        found = runs._common([run("1", [(0.9, 1.0, 1.1)]), second])
        assert (found.reason, found.verdict) == ("not every run determines it", "undetermined")


def test_a_mean_with_an_open_end_has_no_limit():
    found, between = runs._mean([Interval(0.9, 1.0, 1.1), Interval(1.9, 2.0, None)])
    assert (found, between) == (Interval(None, 1.5, None), 0.0)
    assert runs._mean([Interval(None, 1.0, 1.1), Interval(1.9, 2.0, 2.1)])[0].low is None


@pytest.fixture
def level(monkeypatch):
    """The p-value of every law of one run against any other."""
    known = SimpleNamespace(p={}, asked=[])

    def against(one, other):
        known.asked.append((str(one.candidate), str(other.candidate)))
        return Contradiction(other.candidate, 2.0, 1, known.p.get((str(one.candidate), str(other.candidate)), 1.0))

    monkeypatch.setattr(runs, "against", against)
    monkeypatch.setattr(runs, "commented", lambda laws: laws)
    return known


def test_contradictions_of_all_runs_are_combined_as_fisher_does():
    found = runs._combined([Contradiction(read("2"), 2.0, 1, 0.04), Contradiction(read("2"), 3.0, 1, 0.5)])
    assert (str(found.by), found.ratio, found.terms) == ("2", 5.0, 2)
    assert found.p == pytest.approx(chi2.sf(-2 * np.log(0.04 * 0.5), 4))
    assert 0 <= runs._combined([Contradiction(read("2"), 2.0, 1, 0.0)] * 2).p < 1e-200


ENDS = (0.9, 1.0, 1.1)


def test_common_laws_are_judged_as_those_of_one_run(level):
    level.p = {("1", "2"): 1e-3}
    per_run = [[run("1", [ENDS], 5.0), run("2", [ENDS], 3.0), law("3", None)] for _ in range(2)]
    one, two, none = common(per_run)
    assert [one.excess, two.excess, none.excess] == [4.0, 0.0, float("inf")]
    assert one.evidence.against.p < REFUTED and (one.verdict, two.verdict) == ("refuted", "consistent")
    assert one.reason == f"{one.evidence.against}, in all runs together" and two.reason == ""
    assert none.reason == "not every run determines it" and none.verdict == "undetermined"
    assert ("1", "1") not in level.asked  # none is its own rival


@pytest.mark.parametrize(("p", "verdict"), [(0.011, "consistent"), (0.0085, "refuted")])
def test_two_runs_together_refute_where_neither_does_alone(level, p, verdict):
    """Fisher's p of two values p: p^2 (1 - 2 ln p), which is 0.001 near 0.0098."""
    level.p = {("1", "2"): p}
    per_run = [[run("1", [ENDS], 5.0), run("2", [ENDS], 3.0)] for _ in range(2)]
    assert (p**2 * (1 - 2 * np.log(p)) < REFUTED) == (verdict == "refuted")
    assert common(per_run)[0].verdict == verdict


def test_a_common_law_is_refuted_by_residuals_and_by_a_negative_loss(level):
    per_run = [[run("1", [ENDS], misfit=said), run("2", [(-3.0, -2.0, -1.5)])] for said in ("a line", "", "x")]
    one, two = common(per_run)
    assert (one.verdict, one.reason) == ("refuted", "its residuals are not independent noise in 2 of 3 runs")
    assert (two.verdict, two.reason) == ("refuted", "unphysical: the strength of 2 is negative")
    assert ("1", "2") not in level.asked and ("2", "1") in level.asked  # what feeds a decay refutes nothing


@pytest.fixture
def chosen(monkeypatch):
    known = SimpleNamespace(laws=[], allowed=())
    monkeypatch.setattr(runs, "rivals", lambda laws: (known.laws, []))
    monkeypatch.setattr(runs, "allowances", lambda one, laws, first: known.allowed)
    return known


def said(*kinds):
    return [Verdict(kind, kind, f"telling {i}") for i, kind in enumerate(kinds)]


def told(found):
    return found.kind, found.text


def test_while_one_run_is_undecided_all_are(chosen):
    chosen.laws = [law(t, fit()) for t in ("1", "2")]
    found = verdict_of_runs(said(IDENTIFIED, UNDECIDED, NONE), [])
    text = "the limit of work or time was reached before all laws were judged in 1 of 3 runs; best: 1; 2"
    assert told(found) == (UNDECIDED, f"{UNDECIDED}: {text}") and "max_seconds" in found.telling
    chosen.laws = []
    assert verdict_of_runs(said(UNDECIDED), []).text.endswith("in 1 of 1 runs")


def test_a_run_that_no_law_fits_is_told_with_what_would_tell(chosen):
    chosen.laws = [law(str(n), fit()) for n in range(8)]
    found = verdict_of_runs(said(IDENTIFIED, NONE, NONE), [])
    assert told(found) == (NONE, f"{NONE} at the noise level in 2 of 3 runs (model inadequate); best: 0; 1; 2; 3; 4; 5")
    assert found.telling == "telling 1"


def test_one_common_law_is_identified_with_what_is_allowed_beside_it(chosen):
    one = law("1", fit())
    chosen.laws, chosen.allowed = [one], (Allowance("2", 0.01, 0.2),)
    found = verdict_of_runs(said(IDENTIFIED, IDENTIFIED), [one])
    assert found.kind == IDENTIFIED and found.text.startswith(
        f"{IDENTIFIED} in 2 runs: 1, among the laws tried; not exc"
    )
    assert found.allowed == chosen.allowed and found.telling == ""
    chosen.allowed = (Allowance("2", 0.01, 0.201),)
    found = verdict_of_runs(said(IDENTIFIED, IDENTIFIED), [one])
    text = f"{SEVERAL} with 2 runs: 1 is the smallest, but a further term may carry over a fifth of the loss; not exc"
    assert found.kind == SEVERAL and found.text.startswith(text) and found.allowed == chosen.allowed


def test_strengths_that_differ_are_told(chosen):
    one = law("1+2", fit(), epsilon=(SURE, SURE), apart=("1", "2"))
    chosen.laws = [one]
    text = (
        "; but the strength of 1, 2 differs from run to run by more than its errors: the interval is that of the mean"
    )
    assert verdict_of_runs(said(IDENTIFIED), [one]).text == f"{IDENTIFIED} in 1 runs: 1+2, among the laws tried{text}"


def test_without_a_loss_that_shows_runs_tell_nothing_unless_they_differ(chosen):
    around = Interval(-0.1, 0.0, 0.1)
    chosen.laws = [law("1", fit(), epsilon=(around,))]
    found = verdict_of_runs(said(IDENTIFIED), [])
    assert (
        told(found) == (UNTOLD, f"{UNTOLD} to tell: the data do not show any loss") and "more swings" in found.telling
    )
    chosen.laws = [law("1", fit(), epsilon=(around,), apart=("1",))]
    assert verdict_of_runs(said(IDENTIFIED), []).kind == IDENTIFIED
    chosen.laws = [law("1+2", fit(), epsilon=(around, SURE))]
    assert verdict_of_runs(said(IDENTIFIED), []).kind == IDENTIFIED


def test_no_common_law_is_identified_that_needs_a_negative_loss(chosen):
    chosen.laws = [law("1+2", fit(), epsilon=(SURE, BELOW))]
    found = verdict_of_runs(said(IDENTIFIED, IDENTIFIED), chosen.laws)
    assert told(found) == (NONE, f"{NONE} with strengths >= 0: 1+2 needs a negative one (2)")
    chosen.laws = [law("1+2", fit(), epsilon=(SURE, BELOW)), law("3", fit())]
    assert verdict_of_runs(said(IDENTIFIED, IDENTIFIED), chosen.laws).kind == SEVERAL


def test_the_headline_of_runs_names_no_unphysical_law_beside_a_physical_one():
    below = Interval(-0.3, -0.1, 0.1)
    laws = [law("1", fit()), law("2+3", fit(), epsilon=(SURE, below))]
    found = verdict_of_runs(said(IDENTIFIED, IDENTIFIED), laws)
    assert found.kind == IDENTIFIED and "2+3" not in found.text
    assert verdict_of_runs(said(UNDECIDED), laws).text.endswith("best: 1")


@pytest.mark.parametrize(
    ("count", "kind", "text"),
    [
        (0, UNTOLD, f"{UNTOLD} to tell: the 2 runs together determine no law"),
        (2, SEVERAL, f"{SEVERAL} with 2 runs: 0; 1"),
        (3, SEVERAL, f"{SEVERAL} with 2 runs: 0; 1; 2"),
        (4, UNTOLD, f"{UNTOLD} to tell 4 laws apart: 0; 1; 2; 3"),
    ],
)
def test_several_laws_or_none(chosen, count, kind, text):
    refuted = [law("5", fit(), verdict="refuted")]
    if not count:
        found = verdict_of_runs(said(IDENTIFIED, UNTOLD), refuted)
        assert told(found) == (NONE, f"{NONE}: no law is consistent with all 2 runs together")
    chosen.laws = [law(str(n), fit()) for n in range(count)]
    assert told(verdict_of_runs(said(IDENTIFIED, UNTOLD), [])) == (kind, text)
