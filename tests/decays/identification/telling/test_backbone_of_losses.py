"""The period before any law of decays whose spring is linear: dry friction does not lengthen it, and a short record of
a smooth line has errors as smooth as the line."""

import numpy as np
import pytest

from asymptotics.decays.identification.measuring import late_extremes
from asymptotics.decays.identification.measuring.line_errors import line_turns
from asymptotics.decays.identification.measuring.observations import Samples
from asymptotics.decays.identification.sources import load
from asymptotics.decays.identification.telling import backbone as module
from asymptotics.decays.identification.telling import envelope as told
from asymptotics.decays.identification.telling.envelope import envelope

PERIOD, SEED = 2 * np.pi, 910003
LATE = 0.3
"""rad, of the first sample after the release."""


def friction(tau, dry):
    """x of dry friction alone, by its closed form: half-swings about places at ``dry`` on either side."""
    n = np.floor(tau / np.pi)
    return (1 - (2 * n + 1) * dry) * np.cos(tau) + (-1) ** n * dry


def drag(tau, strength):
    """x of a linear loss from rest; its half-swings last pi/sqrt(1 - strength^2/4)."""
    w = np.sqrt(1 - strength**2 / 4)
    return np.exp(-strength * tau / 2) * (np.cos(w * tau) + strength / (2 * w) * np.sin(w * tau))


CASES = {
    "dry, smooth line": (lambda tau: friction(tau, 0.035), 12, 50, 0.003, PERIOD),
    "dry, few samples": (lambda tau: friction(tau, 0.011), 36, 15, 0.003, PERIOD),
    "dry, extremes": (lambda tau: friction(tau, 0.0145), 32, 100, 3e-4, PERIOD),
    "strong drag, short": (lambda tau: drag(tau, 0.075), 12, 25, 0.003, PERIOD / np.sqrt(1 - 0.075**2 / 4)),
}

LONG = {
    "dry, smooth line": 1.7e-3,
    "dry, few samples": 7e-4,
    "dry, extremes": 1.1e-4,
    "strong drag, short": 3.5e-3,
}
"""Half-widths, of the period.  When the intervals of all choices of a spring were united, they were 2.0e-3, 1.02e-3,
1.6e-4 and 5.1e-3, and held no more."""


def periods(case, count=8):
    made, swings, per_period, noise, true = CASES[case]
    tau = np.arange(LATE, np.pi * swings, PERIOD / per_period)
    for seed in range(count):
        random = np.random.default_rng([SEED, seed])
        yield from envelope(load({"t": tau, "x": made(tau) + noise * random.standard_normal(len(tau))})[0]).backbone


def held(case):
    true = CASES[case][-1]
    rows = list(periods(case))
    return np.mean([row["low"] < true < row["high"] for row in rows]), rows


@pytest.mark.parametrize("case", CASES)
def test_the_period_of_a_linear_spring_is_held_and_not_by_everything(case):
    """Failed before: of these intervals 0.47, 0.50, 0.44 and 0.78 held the period."""
    share, rows = held(case)
    true = CASES[case][-1]
    assert share >= 0.9
    error = [row["estimate"] / true - 1 for row in rows]
    reach = [(row["high"] - row["low"]) / 2 / true for row in rows]
    assert abs(np.median(error)) < 0.2 * np.median(reach)
    assert np.median(reach) < LONG[case]


def test_near_miss_without_the_lateness_the_period_is_too_long(monkeypatch):
    monkeypatch.setattr(told, "LINE_LATENESS", dict.fromkeys(told.LINE_LATENESS, 0.0))
    rows = list(periods("dry, smooth line", 4))
    assert np.median([row["estimate"] / PERIOD - 1 for row in rows]) > 2e-4


def test_near_miss_without_the_covariance_the_intervals_of_a_short_line_are_too_short(monkeypatch):
    alone = module.TurningTimes.fitted

    def without(self, columns):
        return alone(module.TurningTimes(self.n, self.size, self.t), columns)

    monkeypatch.setattr(module.TurningTimes, "fitted", without)
    assert held("strong drag, short")[0] < 0.9


@pytest.mark.parametrize(("per_period", "harmonics"), [(60, (1, 3)), (7.3, (1,))])
def test_a_line_finds_the_extremes_of_dry_friction_late_by_its_missing_harmonics(per_period, harmonics):
    """Second route: the line itself, of a record without noise, inside it."""
    dry = 0.004
    tau = np.arange(0.1, 40 * np.pi, PERIOD / per_period)
    n = np.arange(6, 34)
    turns = line_turns(Samples(tau, friction(tau, dry), 1e-6, 100.0), np.pi * n, n)
    assert turns.harmonics == harmonics
    late = (turns.t - np.pi * n) * (1 - 2 * n * dry) / dry
    assert np.median(late) == pytest.approx(late_extremes.LINE_LATENESS[harmonics], rel=0.05)


def test_the_errors_of_times_are_those_of_many_noises():
    tau, n, sigma = np.arange(0, 40, 0.15), np.arange(12), 0.01
    pure = drag(tau, 0.06)
    noises = sigma * np.random.default_rng(SEED).standard_normal((60, len(tau)))
    found = [line_turns(Samples(tau, pure + noise, sigma, 250.0), np.pi * n, n) for noise in noises]
    measured = np.cov(np.array([each.t for each in found]).T)
    covariance = np.mean([each.time_root @ each.time_root.T for each in found], axis=0)
    ratio = np.diag(measured) / np.diag(covariance)
    assert ratio.min() > 0.5 and ratio.max() < 1.7
    beside = [np.diag(m, 1) / np.sqrt(np.diag(m)[1:] * np.diag(m)[:-1]) for m in (measured, covariance)]
    assert beside[0] == pytest.approx(beside[1], abs=0.3)
    assert beside[1].max() > 0.3  # near miss: they are not independent
