"""The fit of the motion itself: sparse samples, velocities, accelerations, clipped peaks, noise that remembers."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import asymptotics as asy
from asymptotics.decays.identification.fitting.least_squares import likely_scales
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.judging.single_fits import fit_law
from asymptotics.decays.identification.measuring.sampled import observations_of_motion
from asymptotics.errors import InputError
from tests.worlds import RIVALS

FEW = np.arange(0, 47, 2.1)  # 3 samples a period, 15 swings
MANY = np.linspace(0, 32 * np.pi, 961)


def truth(t, e1, e2):
    """(x, v, a) of the law 1,2 at omega_0 = 1 from rest at 1, by SciPy."""
    force = lambda _, y: [y[1], -y[0] - e1 * y[1] - e2 * y[1] * abs(y[1])]  # noqa: E731
    x, v = solve_ivp(force, (0, t[-1] + 0.1), [1.0, 0.0], t_eval=t, rtol=1e-10, atol=1e-12).y
    return x, v, -x - e1 * v - e2 * v * abs(v)


def test_three_samples_a_period_without_noise_give_the_strengths_to_six_digits():
    seen = observations_of_motion(FEW, truth(FEW, 0.04, 0.02)[0], unit="", name="r")
    found = fit_law(read_candidate("1+2"), seen).fit
    strengths = found.theta[1:3] / seen.reference ** np.array([0, 1])
    assert strengths == pytest.approx([0.04, 0.02], rel=2e-6)


@pytest.mark.parametrize("derivative", [0, 1, 2])
def test_its_derivatives_are_those_of_what_it_predicts(derivative):
    x = truth(FEW + 0.1, 0.04, 0.02)[derivative] + 1e-3 * np.random.default_rng(1).standard_normal(len(FEW))
    seen = observations_of_motion(FEW, x, unit="", name="r", derivative=derivative)
    fit = fit_law(read_candidate("1+2"), seen).fit
    model, theta = fit.model, fit.theta
    _, slopes = model.predict(theta)
    for i, step in enumerate(np.eye(len(theta)) * 1e-5):
        numeric = (model.predict(theta + step)[0] - model.predict(theta - step)[0]) / 2e-5
        assert np.abs(numeric - slopes[:, i]).max() < 1e-3 * np.abs(numeric).max()
    assert likely_scales(model, theta, fit.scales)["x"] == pytest.approx(fit.scales["x"], rel=1e-2)


def test_three_samples_a_period_and_fifteen_swings_have_an_answer():
    x = truth(FEW, 0.04, 0.02)[0] + 2e-3 * np.random.default_rng(5).standard_normal(len(FEW))
    answer = asy.identify({"t": FEW, "x": x}, laws=RIVALS)
    law = answer.law("1+2").law
    assert law.verdict == "consistent"
    assert [e.contains(v) for e, v in zip(law.epsilon, (0.04, 0.02), strict=True)] == [True, True]
    assert any("all 23 samples of the motion fitted (2.99 a period)" in note for note in answer.notes)


@pytest.mark.parametrize(
    ("column", "place", "shift"), [("v", 1, 0.05), ("a", 2, 0.3)], ids=["a gyroscope's offset", "an accelerometer's g"]
)
def test_velocities_and_accelerations_are_fitted_with_the_offset_of_their_sensor(column, place, shift):
    measured = truth(MANY, 0.02, 0.04)[place] + shift + 0.01 * np.random.default_rng(5).standard_normal(len(MANY))
    answer = asy.identify({"t": MANY, column: measured}, laws=RIVALS)
    assert answer.verdict.text.startswith("identified: 1+2")
    law = answer.law("1+2").law
    assert [e.contains(v) for e, v in zip(law.epsilon, (0.02, 0.04), strict=True)] == [True, True]


@pytest.mark.parametrize("defect", ["clipped", "remembering", "gaps"])
def test_what_is_wrong_with_samples_is_told_and_the_true_law_stands(defect):
    random = np.random.default_rng(7)
    x, t = truth(MANY, 0.02, 0.04)[0], MANY
    noise = (0.01 if defect == "remembering" else 0.005) * random.standard_normal(len(t))
    if defect == "remembering":
        for i in range(1, len(t)):
            noise[i] = 0.9 * noise[i - 1] + np.sqrt(1 - 0.81) * noise[i]
    x = x + noise
    if defect == "clipped":
        x = np.clip(x, -0.6, 0.6)
    if defect == "gaps":
        keep = random.random(len(t)) < 0.15
        t, x = t[keep], x[keep]
    answer = asy.identify({"t": t, "x": x}, laws=RIVALS)
    law = answer.law("1+2").law
    assert law.verdict == "consistent"
    assert [e.contains(v) for e, v in zip(law.epsilon, (0.02, 0.04), strict=True)] == [True, True]
    said = {"clipped": "clipped samples masked", "remembering": "neighbours correlated by 0.", "gaps": "a period)"}
    assert any(said[defect] in note for note in answer.notes)


def test_noise_alone_is_no_motion():
    t = np.arange(40.0)
    with pytest.raises(InputError, match="argument data"):
        asy.identify({"t": t, "x": np.random.default_rng(0).standard_normal(40)})
