"""Q before any law of losses whose exponents are no whole numbers."""

from math import gamma, pi, sqrt

import numpy as np
import pytest

from asymptotics.decays.identification.telling import decline

DRAWN = 40


def held(alpha, epsilon, noise):
    """How many of the intervals at three amplitudes hold the fall of ln A of epsilon x'|x'|^(alpha-1)."""
    mean = gamma(alpha / 2 + 1) / (sqrt(pi) * gamma((alpha + 3) / 2))
    size = [1.0]
    while size[-1] > 10 * noise and len(size) < 80:
        # dA/dn = -pi <|sin|^(alpha+1)> epsilon A^alpha, exactly: A^(1-alpha) is linear in n.
        size.append((size[-1] ** (1 - alpha) - (1 - alpha) * pi * mean * epsilon) ** (1 / (1 - alpha)))
    n, size = np.arange(len(size)), np.array(size)
    found = 0
    for seed in range(DRAWN):
        seen = size + noise * np.random.default_rng(seed).standard_normal(len(size))
        fall = decline.decline_of(n, seen, 0.0, 1.0)
        for a in (seen[0], sqrt(seen[0] * seen[-1]), seen[-1]):
            ends = fall(float(a))
            found += ends["low"] <= pi * mean * epsilon * a ** (alpha - 1) <= ends["high"]
    return found / (3 * DRAWN)


@pytest.mark.parametrize(("alpha", "epsilon"), [(1.5, 0.04), (0.5, 0.01), (2.5, 0.08)])
def test_exponents_between_have_their_q(monkeypatch, alpha, epsilon):
    assert held(alpha, epsilon, 1e-3) > 0.9
    monkeypatch.setattr(decline, "_HALVES", ())  # whole powers alone, as it was
    assert held(alpha, epsilon, 1e-3) < 0.75


@pytest.mark.parametrize(("alpha", "epsilon"), [(2.0, 0.05), (3.0, 0.1), (1.0 + 1e-9, 0.02)])
def test_whole_exponents_lose_nothing(alpha, epsilon):
    assert held(alpha, epsilon, 1e-3) > 0.9
