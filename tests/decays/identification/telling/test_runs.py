"""Several runs: their mean, how they differ, and what is said of them."""

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.synthetic import observed
from asymptotics.decays.identification.telling.runs import mean_of_runs


def test_random_effects_cover_runs_that_differ():
    random, hits = np.random.default_rng(0), 0
    for _ in range(300):
        true = 1 + 0.1 * random.standard_normal(6)
        mean, _ = mean_of_runs(true + 0.01 * random.standard_normal(6), [0.01] * 6)
        hits += mean.contains(1.0)
    assert 0.90 <= hits / 300 <= 0.985


def test_the_mean_of_two_runs_that_agree_has_their_pooled_error_and_covers():
    random, hits, widths = np.random.default_rng(7), 0, []
    for _ in range(1000):
        mean, between = mean_of_runs(1 + 0.01 * random.standard_normal(2), [0.01, 0.01])
        hits += mean.contains(1.0)
        widths.append((mean.high - mean.low, between > 0))
    assert 0.93 <= hits / 1000 <= 0.97
    assert {round(width, 6) for width, apart in widths if not apart} == {round(2 * 1.959964 * 0.01 / np.sqrt(2), 6)}
    assert 0.03 <= np.mean([apart for _, apart in widths]) <= 0.07


@pytest.mark.parametrize(("factor", "alike"), [(1.0, True), (1.3, False)])
def test_a_verdict_of_two_runs_says_whether_their_strengths_are_one(factor, alike):
    runs = [observed("1", [0.02 * f], 60, 1e-3, seed=s) for f, s in ((1.0, 1), (factor, 2))]
    answer = asy.identify(runs, laws=["1", "2", "1+2"])
    mean, said = answer.law("1").law.epsilon[0], answer.verdict.text
    assert answer.verdict.kind == "identified"
    assert ("the strength of 1 differs from run to run" in said) == (not alike)
    assert mean.contains(0.02) and (mean.high - mean.low < 0.03 * 0.02) == alike


def test_two_runs_are_not_identified_while_a_further_term_may_carry_over_a_fifth_of_the_loss():
    runs = [observed("1+2", [0.006, 0.006], 14, 1e-2, seed=s) for s in (1, 2)]
    answer = asy.identify(runs, laws=["1", "1+2"])
    assert answer.verdict.kind == "several laws are consistent"
    assert "a further term may carry over a fifth of the loss" in answer.verdict.text


def test_each_law_of_the_verdict_of_two_runs_has_its_q_and_its_row_says_what_is_unphysical():
    """They had none; a column of the CSV said consistent of a law with a negative loss."""
    runs = [observed("1", [0.02], 60, 1e-3, seed=s) for s in (1, 2)]
    answer = asy.identify(runs, laws=["1", "2", "1+2", "0+1"], omega_0=2.0)
    assert float(answer.to_dict()["laws"][0]["equivalent"]["Q"][0]) == pytest.approx(50, rel=0.02)
    assert "  Q = 50" in "\n".join(answer.lines) or "  Q = 49" in "\n".join(answer.lines)
    for law in answer.laws:
        row = law.strengths()[0]
        assert ("unphysical" in row["verdict"]) == bool(law.law.negative)
    (rate,) = [row for row in answer.laws[0].strengths() if row["parameter"] == "b/m of 1 [1/s]"]
    assert rate["low"] < 0.04 < rate["high"]
    apart = asy.identify([observed("1", [e], 60, 1e-3, seed=1) for e in (0.02, 0.03)], laws=["1", "2"])
    assert apart.to_dict()["laws"][0]["equivalent"] is None  # of runs that differ none is that of all
