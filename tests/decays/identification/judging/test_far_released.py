"""What is released far up: its first extreme, which no sample that is fitted holds, is the largest by far."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.judging import single_fits
from asymptotics.decays.identification.judging.judgement import outside
from asymptotics.decays.identification.judging.single_fits import fit_law
from asymptotics.decays.identification.measuring import extraction
from asymptotics.decays.identification.sources import load

SQUARED = (2 * np.pi / 1.3) ** 2


def released(angle, friction, drag, t, spring=np.sin):
    """x from rest at ``angle``, by DOP853 from turning point to turning point."""
    x, begin, sign = np.full(len(t), np.nan), 0.0, -1.0
    place = angle
    while begin < t[-1]:

        def turned(_, y):
            return y[1]

        def slope(_, y, sign=sign):
            return [y[1], -SQUARED * spring(y[0]) - sign * (friction + drag * y[1] ** 2)]

        turned.terminal, turned.direction = True, -sign
        run = solve_ivp(
            slope, (begin, t[-1] + 1), [place, sign * 1e-9], method="DOP853", events=turned, dense_output=True,
            rtol=1e-9, atol=1e-12, first_step=1e-3,
        )  # fmt: skip
        here = np.isnan(x) & (t <= run.t[-1])
        x[here] = run.sol(t[here])[0]
        begin, place, sign = run.t[-1], run.y[0, -1], -sign
    return x


def test_the_law_of_a_release_from_140_degrees_is_found():
    """Failed before: refuted, with twice the noise left, and a spring in x^3 and x^5 was identified."""
    t = np.arange(0, 20, 0.04)
    x = released(np.radians(140), 0.08, 0.02, t) + 0.005 * np.random.default_rng(0).standard_normal(len(t))
    seen = load({"t (s)": t, "theta (rad)": x})[0]
    fit = fit_law(read_candidate("0+2+pendulum"), seen).fit
    left = fit.model.data - fit.model.predict(fit.theta)[0]
    assert np.sqrt(np.mean(left**2)) == pytest.approx(0.005, rel=0.2)


def far_up(noise):
    """A pendulum from 145 degrees with dry friction and drag in v^2, whose first swings no smooth line follows."""
    t = np.arange(0, 16, 0.024)
    friction, drag = (0.3, 0.01) if noise < 0.01 else (0.08, 0.02)
    x = released(np.radians(145), friction, drag, t) + noise * np.random.default_rng(1).standard_normal(len(t))
    return load({"t (s)": t, "theta (rad)": x})[0]


def left(law):
    model = law.fit.model
    return float(np.std(model.data - model.predict(law.fit.theta)[0]))


def test_a_law_begins_with_the_late_swings_of_a_pendulum(monkeypatch):
    """Failed before: of the right law 0.79 rad were left where the noise is 0.005."""
    seen, law = far_up(0.005), read_candidate("0+2+pendulum")
    assert left(fit_law(law, seen)) == pytest.approx(0.005, rel=0.1)
    monkeypatch.setattr(single_fits, "from_the_tail", lambda *_: None)
    assert left(fit_law(law, seen)) > 0.5


@pytest.mark.parametrize(("drag", "noise"), [(6.0, 0.002), (12.0, 0.001)])
def test_a_release_of_which_the_first_swing_leaves_little_has_its_law(monkeypatch, drag, noise):
    """Failed before: the first swing loses 83 and 92 %; the right law was undetermined, "its amplitude, 0.43, is far
    outside the data", and of the second record the period was 4.2."""
    t = np.arange(0, 12, 0.025)
    x = released(0.5, 0.0, drag, t, spring=lambda x: x) + noise * np.random.default_rng(1).standard_normal(len(t))
    seen = load({"t (s)": t, "x (m)": x})[0]
    assert 2 * np.median(np.diff(seen.t)) == pytest.approx(1.3, rel=0.02)
    assert any("the first swing, from 0.5" in note and "is not fitted" in note for note in seen.notes)
    fit = fit_law(read_candidate("2"), seen).fit
    assert outside(fit) == ""
    assert fit.theta[1] / fit.model.reference == pytest.approx(drag, rel=0.05)
    # Up to the passage before its first extreme, it has a turning point that it cannot tell.
    monkeypatch.setattr(extraction, "_STRONG", np.inf)
    fit = fit_law(read_candidate("2"), load({"t (s)": t, "x (m)": x})[0]).fit
    assert "far outside the data" in outside(fit)
