"""A base line that wanders: what is taken off, what is not, and what it does to a verdict."""

import numpy as np
import pytest

from asymptotics.decays.identification import sources
from asymptotics.decays.identification.identify import identified
from asymptotics.decays.identification.measuring.slow_base_line import slow_base_line
from asymptotics.decays.identification.sources import load
from benchmarks.decays import decay

T = np.arange(0, 150, 0.1)
PURE = np.exp(-0.01 * T) * np.cos(T)
NOISE = 1e-3 * np.random.default_rng(4).standard_normal(len(T))


def beside_a_line(x):
    return np.abs(x - np.polynomial.Polynomial.fit(T, x, 1)(T)).max()


@pytest.mark.parametrize(
    "base",
    [
        0.05 / (1 + np.exp(-(T - 110) / 4)),  # a step that takes a period
        0.03 * np.sin(0.12 * T + 1),
        0.04 * np.exp(-((T - 100) ** 2) / 200),
    ],
)
def test_what_wanders_is_taken_off_and_told(base):
    found = slow_base_line(T, PURE + base + NOISE)
    assert beside_a_line(base - found.values) < 2e-3 < beside_a_line(base) / 5
    assert "wanders" in found.in_words


def remembering(rho, size, seed=0):
    drawn = np.random.default_rng(seed).standard_normal(len(T))
    for i in range(1, len(T)):
        drawn[i] = rho * drawn[i - 1] + np.sqrt(1 - rho**2) * drawn[i]
    return size * drawn


@pytest.mark.parametrize(
    "x",
    [
        PURE,
        PURE + NOISE,
        PURE + NOISE + 0.2 - 0.001 * T,  # offset and drift belong to the fit
        PURE + remembering(0.95, 0.01),
        np.exp(-0.1 * T) * np.cos(T) + NOISE,  # hardly two periods are seen
        np.cos(T) / (1 + 0.1 * T) + NOISE,
        np.maximum(1 - 0.01 * T, 0) * np.cos(T) + 0.01 * (T > 100) + NOISE,  # at rest, off centre by a hundredth
        PURE + 0.05 * np.cos(0.7 * T) + NOISE,  # a second mode
        (PURE + NOISE)[:190],  # too few samples
        np.ones(len(T)),
    ],
)
def test_a_decay_is_left_alone(x):
    assert slow_base_line(T[: len(x)], x) is None


def test_the_right_law_stands_with_an_unquiet_tail(monkeypatch):
    made = decay("unquiet tail", 11, 77005)
    law = identified(made.data, laws=[made.law]).law(made.law).law
    assert law.verdict == "consistent"
    assert law.epsilon[0].contains(made.strengths[0])
    # Without it the disturbance is what the law leaves.
    monkeypatch.setattr(sources, "slow_base_line", lambda *_: None)
    assert identified(made.data, laws=[made.law]).law(made.law).law.verdict == "refuted"


def test_the_cosines_stand_beside_the_law_to_nine_tenths_of_its_frequency():
    base = 0.05 / (1 + np.exp(-(T - 110) / 4))
    (seen,) = load({"t": T, "x": PURE + base + NOISE})
    t, columns = seen.samples.t, seen.samples.slow
    assert columns.T @ columns == pytest.approx(np.eye(columns.shape[1]), abs=1e-9)
    u, inside = (t - T[0]) / T[-1], []
    for k in range(1, 48):  # k half-turns in the record, of frequency 1 where k is 47.7
        wave = np.cos(k * np.pi * u)
        inside.append(np.linalg.norm(columns.T @ wave) / np.linalg.norm(wave))
    assert min(inside[:41]) > 0.99 and max(inside[44:]) < 0.5
    # Of a few periods no more than they tell apart: 1 - 1/periods of the frequency, but half of it.
    slow = slow_base_line(T, PURE + base + NOISE)
    for periods, share in ((5, 0.8), (3, 0.67)):
        count = slow.columns(np.linspace(0, 2 * np.pi * periods, 400)).shape[1]
        assert 2 * share * periods - 1 <= count <= 2 * share * periods + 4
    (plain,) = load({"t": T, "x": PURE + NOISE})
    assert plain.samples is None  # many extremes of a dense record: they are fitted


def test_a_strong_decay_with_a_step_of_its_base_line_is_told():
    """The cosines of 15 periods are dependent in the few that swing; with all of them a law may be undetermined."""
    t = np.arange(0, 15, 0.01)
    x = np.exp(-0.12 * 2 * np.pi * t) * np.cos(2 * np.pi * t) + 0.015 / (1 + np.exp(-(t - 8) * 4))
    data = {"t": t, "x": x + 0.002 * np.random.default_rng(2).standard_normal(len(t))}
    (seen,) = load(data)
    assert seen.samples.slow.shape[1] < 18  # 27 in the record; 7 periods are used
    law = identified(data, laws=["1", "2"]).law("1").law
    assert law.verdict == "consistent"
    assert law.epsilon[0].low > 0.2
