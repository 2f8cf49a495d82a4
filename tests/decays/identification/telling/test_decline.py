"""Q before any law of losses whose exponents are no whole numbers."""

from functools import cache
from math import exp, gamma, log, pi, sqrt

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

from asymptotics.decays.identification.telling import decline

DRAWN = 15


def decay(alpha, epsilon, noise):
    """Amplitudes, and the fall of ln A in a half-swing whose geometric mean is A: dA/dn = -pi <|sin|^(alpha+1)> epsilon
    A^alpha, so that A^(1-alpha) is linear in n."""
    rate = gamma(alpha / 2 + 1) * sqrt(pi) / gamma((alpha + 3) / 2) * epsilon
    after = lambda a: (a ** (1 - alpha) - (1 - alpha) * rate) ** (1 / (1 - alpha))  # noqa: E731
    size = [1.0]
    while size[-1] > max(10 * noise, 0.05) and len(size) < 80:
        size.append(after(size[-1]))
    fall = lambda a: brentq(lambda s: log(a * exp(s / 2) / after(a * exp(s / 2))) - s, 1e-9, 1.2)  # noqa: E731
    return np.array(size), fall


def held(alpha, epsilon, noise):
    """How many of the intervals at the geometric mean and the last amplitude hold the fall of ln A."""
    size, fall = decay(alpha, epsilon, noise)
    n, found = np.arange(len(size)), 0
    for seed in range(DRAWN):
        seen = size + noise * np.random.default_rng(seed).standard_normal(len(size))
        told = decline.decline_of(n, seen, 0.0, 1.0)
        for a in (sqrt(seen[0] * seen[-1]), seen[-1]):
            ends = told(float(a))
            found += ends["low"] <= fall(float(a)) <= ends["high"]
    return found / (2 * DRAWN)


@pytest.mark.parametrize(
    ("alpha", "epsilon", "noise"),
    [
        (1.5, 0.04, 1e-3),
        (0.5, 0.01, 1e-3),
        (2.5, 0.08, 1e-3),
        (4 / 3, 0.03, 3e-4),
        (1.7, 0.04, 3e-4),
        (1.25, 0.03, 3e-4),
    ],
)
def test_exponents_between_have_their_q(monkeypatch, alpha, epsilon, noise):
    """Failed before for the last three: of the intervals by 4/3, 17/10 and 5/4 0.30, 0.77 and 0.20 held."""
    assert held(alpha, epsilon, noise) > 0.9
    monkeypatch.setattr(decline, "_BESIDE", ())  # whole powers alone
    assert held(alpha, epsilon, noise) < 0.9


@pytest.mark.parametrize(("alpha", "epsilon"), [(2.0, 0.05), (3.0, 0.1), (1.0 + 1e-9, 0.02)])
def test_whole_exponents_lose_nothing(alpha, epsilon):
    assert held(alpha, epsilon, 1e-3) > 0.9


def test_dry_friction_of_a_seventh_of_the_spring_force_has_its_fall(monkeypatch):
    """Failed before: A_n - A_(n+1) is 2 f exactly; to first order in f/A the loss of ln A is 0.4 % off at the end."""
    n, f = np.arange(33), 0.0145
    size = 1 - 2 * f * n
    for seed in range(5):
        seen = size + 1e-6 * np.random.default_rng(seed).standard_normal(len(n))
        told, a = decline.decline_of(n, seen, 0.0, 1.0), float(seen[-1])
        true = 2 * np.arcsinh(f / a)
        assert abs(told(a)["estimate"] / true - 1) < 3e-4 < abs(2 * f / a / true - 1)
        assert told.friction()["estimate"] == pytest.approx(f, rel=1e-4)


@cache
def swung(amplitude, alpha, epsilon):
    """Where the pendulum turns next, by another integrator."""
    turning = lambda t, y: y[1]  # noqa: E731
    turning.terminal, turning.direction = True, 1
    start, slope = [amplitude, -1e-12], lambda t, y: [y[1], -np.sin(y[0]) + epsilon * abs(y[1]) ** alpha]
    found = solve_ivp(slope, (0, 60), start, method="DOP853", rtol=1e-10, atol=1e-13, events=turning, first_step=1e-4)
    return -found.y[0, -1]


@pytest.mark.parametrize(("alpha", "epsilon"), [(1.0, 0.03), (0.0, 0.02), (1.5, 0.03)])
def test_a_pendulum_from_far_up_has_its_fall(alpha, epsilon):
    """Failed before: from 120 degrees the fall was 2 to 3 % off, with intervals of 1 %."""
    size = [np.radians(120)]
    while len(size) < 25 and size[-1] > 0.2:
        size.append(swung(size[-1], alpha, epsilon))
    size, seeds, at = np.array(size), range(8), [0, 5, 10]
    true = [log(size[k] / size[k + 1]) for k in at]
    held = {0.0: 0, float(size[0]): 0}
    for seed in seeds:
        seen = size + 3e-4 * size[0] * np.random.default_rng(seed).standard_normal(len(size))
        for angle in held:
            told = decline.decline_of(np.arange(len(size)), seen, 0.0, 1.0, angle=angle)
            ends = [told(float(np.sqrt(size[k] * size[k + 1]))) for k in at]
            held[angle] += sum(e["low"] <= s <= e["high"] for e, s in zip(ends, true, strict=True))
    assert held[float(size[0])] >= 0.9 * len(seeds) * len(at) > held[0.0]


def test_the_dry_part_beside_a_pendulum_is_the_force_over_the_slope_of_the_spring():
    size = [np.radians(100)]
    while len(size) < 30 and size[-1] > 0.2:
        size.append(swung(size[-1], 0.0, 0.02))
    told = decline.decline_of(np.arange(len(size)), np.array(size), 0.0, 1.0, angle=size[0])
    assert told.friction()["estimate"] == pytest.approx(0.02, rel=2e-3)
