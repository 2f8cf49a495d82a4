"""The whole way: the right law, honest intervals, and refusals."""

import json

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.synthetic import exact, observed
from asymptotics.shell.main import main


@pytest.mark.parametrize(
    ("law", "strengths", "swings", "noise"),
    [
        ("1", [0.02], 60, 1e-3),
        ("2", [0.03], 80, 1e-3),
        ("1+2", [0.01, 0.02], 100, 1e-3),
        ("0+1", [0.002, 0.01], 60, 3e-4),
    ],
)
def test_the_right_law_is_identified_with_its_strengths(law, strengths, swings, noise):
    answer = asy.identify(observed(law, strengths, swings, noise, noise, seed=4))
    assert answer.verdict.text.startswith(f"identified: {law}")
    found = answer.law(law)
    assert found.law.verdict == "consistent"
    for interval, true in zip(found.law.epsilon, strengths, strict=True):
        half = (interval.high - interval.low) / 2
        assert abs(interval.estimate - true) < 2 * half < 0.2 * true


def test_what_is_identified_says_what_is_not_excluded_beside_it():
    # 20 swings with 1 % of noise: dry friction that carries half of the loss is not seen, and the answer says so
    weak = asy.identify(observed("1", [0.03], 20, 1e-2, seed=6), laws=["0", "1", "0+1", "1+2"])
    sharp = asy.identify(observed("1", [0.03], 20, 1e-4, seed=6), laws=["0", "1", "0+1", "1+2"])
    for answer, largest in ((weak, 1.0), (sharp, 0.02)):
        friction, drag = answer.verdict.allowed
        assert (friction.term, drag.term) == ("0", "2")
        assert friction.largest == pytest.approx(answer.law("0+1").law.epsilon[0].high)
        assert friction.share == pytest.approx(2 * friction.largest / (np.pi / 2 * 0.03), rel=0.05)
        assert largest / 20 < friction.share < largest
        assert (
            f"not excluded beside it (95 %; in brackets the share of the loss at the first amplitude): {friction}"
            in (answer.verdict.text)
        )
    assert sharp.to_dict()["not_excluded"][0]["term"] == "0"
    assert asy.identify(observed("1", [0.03], 20, 1e-4, seed=6), laws=["1"]).verdict.allowed == ()


def test_a_term_that_may_carry_over_a_fifth_of_the_loss_leaves_no_law_identified():
    answer = asy.identify(observed("1", [0.01], 12, 1e-2, seed=2), laws=["1", "1+2"])
    assert answer.verdict.kind == "several laws are consistent"
    assert "1 is the smallest, but a further term may carry over a fifth of the loss" in answer.verdict.text
    assert answer.verdict.telling.startswith("to tell 1+2 from 1: ")


def test_a_free_exponent_finds_three_halves_and_refutes_the_integers():
    answer = asy.identify(observed("3/2", [0.02], 150, 1e-3, seed=1))
    assert answer.law("free").law.alpha.contains(1.5)
    assert answer.law("free").law.alpha.high - answer.law("free").law.alpha.low < 0.02
    assert {answer.law(a).law.verdict for a in "0123"} == {"refuted"}


def test_the_linear_control_comes_out_linear():
    answer = asy.identify(observed("1", [0.02], 100, 1e-3, 1e-3, seed=7))
    assert answer.verdict.kind == "identified"
    assert str(answer.verdict.text).startswith("identified: 1")
    assert answer.law("free").law.alpha.contains(1.0)
    assert answer.law("2").law.verdict == "refuted"


def test_the_unit_of_the_file_sets_the_strengths():
    # x0 = 10 units: epsilon refers to x0 = 1 unit, so delta = epsilon 10 for the quadratic law
    answer = asy.identify(observed("2", [0.003], 60, 1e-4, seed=2, x0=10.0), laws=["2", "free"])
    assert answer.law("2").law.epsilon[0].contains(0.003)
    assert answer.law("free").law.epsilon[0].contains(0.003)


@pytest.mark.slow
def test_times_tell_a_spring_from_cubic_loss_and_amplitudes_do_not():
    seen = observed("1+s3", [0.02, 0.05], 80, 3e-4, 1e-3, seed=3)
    answer = asy.identify(seen)
    assert answer.verdict.text.startswith("identified: 1+s3")
    assert answer.law("1+s3").law.springs[0].contains(0.05)
    assert answer.law("1").law.verdict == "refuted"
    alone = asy.identify(seen, amplitudes_only=True)
    assert alone.law("1+3").law.epsilon[1].contains(0.0)  # widened: the spring looks like cubic loss
    assert any("cannot tell" in note for note in alone.notes)
    narrow = asy.identify(seen.without_times())
    assert not narrow.law("1+3").law.epsilon[1].contains(0.0)


def test_two_modes_fit_no_law():
    run, n = exact("1", [0.02], 80), np.arange(81)
    beat = np.exp(run.a) * (1 + 0.05 * np.sin(0.7 * n))
    seen = {"n": n, "x": (-1.0) ** n * beat + 1e-4 * np.random.default_rng(0).standard_normal(81)}
    answer = asy.identify(seen)
    assert answer.verdict.kind == "none fits"
    assert "model inadequate" in answer.verdict.text


def test_a_short_noisy_record_is_refused_and_says_what_would_tell():
    answer = asy.identify(observed("1", [0.02], 9, 2e-2, seed=5))
    assert answer.verdict.kind in {"too short or too noisy", "several laws are consistent"}
    assert answer.verdict.telling


def test_negative_strengths_are_reported_not_clipped():
    run = exact("1+2", [0.03, -0.01], 60)
    x = (-1.0) ** np.arange(61) * np.exp(run.a) + 1e-5 * np.random.default_rng(0).standard_normal(61)
    answer = asy.identify({"n": np.arange(61), "x": x}, laws=["1+2"])
    assert answer.law("1+2").law.epsilon[1].estimate == pytest.approx(-0.01, rel=0.05)
    assert answer.law("1+2").law.negative == ("2",)
    assert answer.to_dict()["laws"][0]["unphysical"] == ["2"]


def test_several_runs_share_a_law_and_scatter():
    runs = [observed("1+2", [0.01 * f, 0.02 * f], 80, 3e-4, seed=i) for i, f in enumerate((0.9, 1.0, 1.1))]
    answer = asy.identify(runs, laws=["1", "2", "1+2"])
    assert "1+2" in answer.verdict.text
    mean = answer.law("1+2").law.epsilon[0]
    alone = answer.per_run[0].law("1+2").law.epsilon[0]
    assert mean.contains(0.01)
    assert mean.high - mean.low > 3 * (alone.high - alone.low)  # the runs differ by more than their errors


def test_correlated_residuals_stretch_the_intervals():
    run, random = exact("1", [0.02], 120), np.random.default_rng(1)
    noise = np.convolve(random.standard_normal(140), np.ones(12) / 12, mode="valid")[:121] * 3e-3
    x = (-1.0) ** np.arange(121) * (np.exp(run.a) + noise)
    data = {"n": np.arange(121), "x": x}
    plain = asy.identify(data, laws=["1"], bootstrap=False).law("1").law.epsilon[0]
    longer = asy.identify(data, laws=["1"]).law("1").law.epsilon[0]
    assert longer.high - longer.low > 1.5 * (plain.high - plain.low)


def test_the_command_answers_in_the_json_of_the_contract(tmp_path, capsys):
    seen = observed("1+2", [0.01, 0.02], 80, 1e-3, 1e-3, seed=9)
    path = tmp_path / "points.csv"
    rows = [f"{n},{x:.8f},{t:.8f}" for n, x, t in zip(seen.n, seen.x, seen.t)]
    path.write_text("n,x,tau\n" + "\n".join(rows) + "\n")
    options = ["--kind", "turning-points", "--laws", "1", "1+2", "0+2", "free", "--json"]
    assert main(["identify", str(path), *options]) == 0
    answer = json.loads(capsys.readouterr().out)
    laws = {"+".join(law["alphas"]): law for law in answer["laws"]}
    assert set(laws) == {"1", "1+2", "0+2", "free"}
    assert laws["1+2"]["verdict"] == "consistent"
    assert laws["1"]["verdict"] == "refuted"
    assert laws["1+2"]["springs"] == []
    low, estimate, high = (float(laws["1+2"]["epsilon"][1][k]) for k in ("low", "estimate", "high"))
    assert low < estimate < high
    assert isinstance(laws["1+2"]["criterion"], str)
    assert answer["verdict"].startswith("identified: 1+2")
