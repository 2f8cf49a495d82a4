"""Records like those on which the first version failed, integrated here by another method, with their truth."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import asymptotics as asy
from asymptotics.decays.identification.judging import judgement
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.sources import load
from asymptotics.decays.identification.synthetic import exact
from asymptotics.decays.identification.telling.envelope import envelope
from asymptotics.errors import InputError


def moved(force, x0, periods, per_period, noise, seed=1, v0=0.0):
    """Samples of x'' + x + force(x, x') = 0 from (x0, v0) in time units of a period, by DOP853."""
    t = np.arange(int(periods * per_period)) / per_period
    found = solve_ivp(
        lambda s, y: [y[1], -y[0] - force(*y)], (0, 2 * np.pi * t[-1]), [x0, v0], t_eval=2 * np.pi * t,
        method="DOP853", rtol=1e-10, atol=1e-12,
    )  # fmt: skip
    return t, found.y[0] + noise * np.random.default_rng(seed).standard_normal(len(t))


def strong_cubic():
    return moved(lambda x, v: 0.768 * v**3, 1.0, 12, 20, 3e-3)


def strong_quadratic_with_spring():
    return moved(lambda x, v: 0.85 * v * abs(v) + 0.3 * x**3, 0.62, 7, 40, 2e-3)


def stuck(rest=True, noise=2e-3):
    """Dry friction with 18 samples a period, in noise."""
    t = np.arange(170) / 18
    x = dry(t, 0.044, 1.3) + noise * np.random.default_rng(2).standard_normal(len(t))
    return (t, x) if rest else (t[:110], x[:110])


def dry(t, f, place):
    """Exactly: half cosines about +-f, until the mass stays where |x| <= f."""
    side, start, x = 1.0, 0.0, []
    for now in t:
        while now - start >= 0.5 and abs(place) > f:
            place, side, start = 2 * side * f - place, -side, start + 0.5
        x.append(place if abs(place) <= f else side * f + (place - side * f) * np.cos(2 * np.pi * (now - start)))
    return np.array(x)


def test_a_record_that_begins_at_a_turning_point_has_none_before_it():
    t, x = strong_cubic()
    (seen,) = load({"t": t, "x": x})
    assert seen.t[0] == pytest.approx(0.0, abs=0.01) and abs(seen.x[0]) == pytest.approx(1.0, abs=0.02)
    answer = asy.identify({"t": t, "x": x}, laws=["1", "2", "3", "1+2", "0+1+2"])
    assert answer.verdict.text.startswith("identified: 3,")
    assert answer.law("3").law.epsilon[0].contains(0.768)
    # Near miss: from the middle of a swing on, there was one.
    (later,) = load({"t": t[5:], "x": x[5:]})
    assert later.t[0] < t[5]


@pytest.mark.slow
@pytest.mark.parametrize(("made", "law"), [(strong_cubic, "3"), (strong_quadratic_with_spring, "2+s3")])
def test_all_default_laws_are_fitted_and_the_true_one_is_found(made, law):
    t, x = made()
    answer = asy.identify({"t": t, "x": x}, max_seconds=600)
    assert answer.verdict.kind == "identified" and answer.best.law.candidate == answer.law(law).law.candidate
    assert not answer.to_dict()["untried"]


def test_refuted_means_fitted_or_contained_in_a_law_that_is():
    t, x = strong_quadratic_with_spring()
    laws = ["1", "2", "3", "1+2", "1+3", "2+3", "1+2+3", "2+s3", "1+2+s3"]
    answer = asy.identify({"t": t, "x": x}, laws=laws, bootstrap=False)
    assert answer.law("2").law.verdict == "refuted" and answer.law("2+s3").law.verdict == "consistent"
    fitted = {law.law.candidate for law in answer.laws if law.law.fit is not None}
    for law in (found.law for found in answer.laws):
        spoken = any(law.candidate.is_within(other) for other in fitted)
        assert law.verdict != "refuted" or law.fit is not None or spoken, law.candidate


def test_friction_that_holds_the_mass_off_centre_is_found():
    t, x = stuck()
    answer = asy.identify({"t": t, "x": x}, laws=["0", "1", "0+1", "2"])
    assert answer.verdict.text.startswith("identified: 0,")
    assert answer.law("0").law.epsilon[0].contains(0.044)
    assert any("are not used" in note for note in answer.notes)
    # A sensor of coarse steps shows a rest without any noise.
    t, x = stuck(noise=0.0)
    (seen,) = load({"t": t, "x": x})
    assert "are not used" in seen.notes[-1] and seen.samples.t[-1] < 7.6
    # Near miss: a record that ends while it swings is used whole.
    t, x = stuck(rest=False)
    (seen,) = load({"t": t, "x": x})
    assert seen.samples.t[-1] == t[-1]


def test_noise_about_a_place_of_rest_is_no_beat():
    """It was refused: "the data beats: two modes near each other"; found among 60 records of dry friction."""
    random = np.random.default_rng([12, 10])
    f, x0 = random.uniform(0.015, 0.06), random.uniform(0.9, 1.6)
    t = np.arange(int((x0 / f / 4 + random.uniform(2, 8)) * 12)) / 12
    noise = random.choice([2e-4, 1e-3, 3e-3])
    x = dry(t, f, x0) + noise * random.standard_normal(len(t))
    answer = asy.identify({"t": t, "x": x}, laws=["0", "1", "0+1"])
    assert answer.verdict.text.startswith("identified: 0,") and answer.law("0").law.epsilon[0].contains(f)
    # Near miss: what beats before it rests is still refused.
    beat = np.exp(-0.05 * t) * (np.cos(2 * np.pi * t) + 0.8 * np.cos(2 * np.pi * 1.12 * t))
    with pytest.raises(InputError, match="beats: two modes"):
        asy.identify({"t": t, "x": np.where(t < 16, beat, 0.0) + noise * random.standard_normal(len(t))})


def test_amplitudes_outside_the_data_are_no_result():
    t, x = strong_cubic()
    fit = asy.identify({"t": t, "x": x}, laws=["1"]).law("1").law.fit
    assert judgement.outside(fit) == ""

    wild = replace(fit, theta=fit.theta + np.array([2.0, *[0] * (len(fit.theta) - 1)]))
    assert "far outside the data" in judgement.outside(wild)


def test_the_envelope_needs_no_law():
    t, x = strong_cubic()
    found = asy.identify({"t": t, "x": x}, laws=["1"]).to_dict()
    assert found["verdict_kind"] == "none fits" and found["envelope"]["law_known"] is False
    told = found["envelope"]
    # Strong damping lengthens the first swings.
    assert float(told["period"]["estimate"]) == pytest.approx(1.0, abs=0.01)
    for row in told["quality"]:
        # First order: Q = 1/(2 M_4 epsilon A^2), M_4 = 3/8.
        assert float(row["estimate"]) == pytest.approx(1 / (0.75 * 0.768 * float(row["amplitude"]) ** 2), rel=0.04)
    assert asy.identify({"t": t, "x": x}, laws=["3"]).to_dict()["envelope"]["law_known"] is True


@pytest.mark.parametrize(
    ("law", "strengths", "zeta"),
    [
        ("1", [0.02], lambda a: 0.01),
        ("0", [0.006], lambda a: 2 / np.pi * 0.006 / a),
        ("1+2", [0.01, 0.03], lambda a: 0.005 + 4 / 3 / np.pi * 0.03 * a),
    ],
)
def test_the_intervals_of_the_envelope_cover(law, strengths, zeta):
    run, n, hits = exact(law, strengths, 60), np.arange(61), []
    for seed in range(40):
        random = np.random.default_rng(seed)
        x = (-1.0) ** n * (np.exp(run.a) + 1e-3 * random.standard_normal(61))
        found = envelope(Observations.of(n, x, run.tau / 2 / np.pi + 1e-4 * random.standard_normal(61)))
        hits += [row["low"] < 1 / (2 * zeta(row["amplitude"])) < row["high"] for row in found.quality]
        # Near miss: an interval that holds everything would be no interval.
        assert all(row["high"] < 1.15 * row["low"] for row in found.quality)
    assert np.mean(hits) > 0.92


def test_a_pendulum_law_says_so():
    n = np.arange(30)
    data = {"n": n, "x": (-1.0) ** n * 60 * 0.97**n, "tau": np.pi * n * 1.01}
    answer = asy.identify(data, unit="deg", laws=["1", "1+pendulum"])
    assert {law["pendulum"] for law in answer.to_dict()["laws"]} == {True, False}
