"""Decays of a few swings: what ln A loses in a half-swing, by samples of motions that another route has made."""

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp

from asymptotics.decays.identification.measuring import damped_cosine as module
from asymptotics.decays.identification.measuring.damped_cosine import damped_cosine

OMEGA = 18.4
T = np.arange(0, 0.6, 0.01)
LAWS = {  # exponents of the velocity and b/m, each with Q about 3 at 50
    "1": {1: 5.7}, "2": {2: 0.011}, "0+3": {0: 1781.0, 3: 4.58e-6},
}  # fmt: skip


def motion(law):
    def slope(_, y):
        loss = sum(b * (np.tanh(y[1] / 1e-2) if a == 0 else y[1] * abs(y[1]) ** (a - 1)) for a, b in law.items())
        return [y[1], -(OMEGA**2) * y[0] - loss]

    return solve_ivp(slope, (0, T[-1]), [50.0, 0.0], t_eval=T, rtol=1e-8, atol=1e-6).y[0]


def true_fall(law, amplitude):
    """pi times zeta to first order, its averages by quadrature."""
    mean = {a: quad(lambda p, a=a: np.sin(p) ** (a + 1), 0, np.pi)[0] / np.pi for a in law}
    return np.pi * sum(mean[a] * b * OMEGA ** (a - 2) * amplitude ** (a - 1) for a, b in law.items())


@pytest.mark.parametrize("name", LAWS)
def test_intervals_of_two_periods_cover_the_loss_and_the_period(name):
    """Without the shape of a swing (z) 0+3 misses more than a third, and its period too."""
    law, hits, count = LAWS[name], [], 5
    x = motion(law)
    falls = {amplitude: true_fall(law, amplitude) for amplitude in (45.0, 30.0, 20.0)}
    for seed in range(count):
        found = damped_cosine(T, x + 0.6 * np.random.default_rng(seed).standard_normal(len(T)), 17.5, 4.0)
        for amplitude, true in falls.items():
            fall = found.fall(amplitude)
            hits.append(fall["low"] <= true <= fall["high"])
            assert fall["high"] - fall["low"] < 1.2 * true  # wide, and still an answer
        assert found.omega["estimate"] == pytest.approx(OMEGA, rel=0.04)
    assert np.mean(hits) >= 0.85


@pytest.mark.parametrize("k", [-1, 0, 1, 2])
def test_the_shape_of_a_swing_is_what_its_loss_makes_of_it(k):
    """A swing of an integrator less A cos psi, A by the first order, is d z, but for the second order in d."""
    d, psi, a = 0.004, np.linspace(0, np.pi, 50), k + 1

    def slope(_, y):
        return [y[1], -y[0] - d * (np.sign(y[1]) if a == 0 else y[1] * abs(y[1]) ** (a - 1))]

    seen = solve_ivp(slope, (0, np.pi), [1.0, 0.0], t_eval=psi, rtol=1e-10, atol=1e-12, max_step=0.01).y[0]
    first = module._shape((k,), np.array([d * module._mean_power(k)]), psi) * np.cos(psi)
    z = np.interp(psi, module._PLACES, module._bent(k))
    assert (seen - first) / d == pytest.approx(z, abs=0.02)
    assert np.abs(z).max() > 0.2


@pytest.mark.parametrize("powers", [(-1, 1), (0, 2), (1, 2)])
def test_the_amplitude_of_two_losses_is_that_of_its_equation(powers):
    g, s = np.array([0.3, 0.5]), np.linspace(0, 2, 60)
    exact = solve_ivp(lambda _, A: -A * sum(c * A**k for k, c in zip(powers, g)), (0, 2), [1.0], t_eval=s, rtol=1e-9)
    assert module._shape(powers, g, s) == pytest.approx(exact.y[0], rel=2e-3)


@pytest.mark.parametrize("bent", [True, False])
@pytest.mark.parametrize("powers", [(-1,), (0,), (1,), (2,), (-1, 1), (0, 2)])
def test_the_slopes_of_the_samples_are_their_differences(powers, bent):
    """By which the fit descends; a slope of 1 in 500 is noticed, of the rates of two powers 1 in 50."""
    s, c = np.linspace(0, 1, 80), np.array([0.1, 0.4, 9.0, 0.2, -0.1, *[0.6, 0.3][: len(powers)]])
    slopes = module._waves(c, powers, s, bent)[1]
    for j in range(len(c)):
        low, high = (module._waves(c + h * np.eye(len(c))[j], powers, s, bent)[0] for h in (-1e-3, 1e-3))
        near = 2e-2 if j >= module._OTHERS and len(powers) == 2 else 2e-3
        assert np.abs((high - low) / 2e-3 - slopes[:, j]).max() < near * np.abs(slopes[:, j]).max()


def test_of_a_velocity_the_amplitudes_are_those_of_the_motion():
    t = np.arange(0, 1, 0.01)
    swing = 3 * np.exp((-2 + 18j) * t)
    v = ((-2 + 18j) * swing).real
    found = damped_cosine(t, v, 17.0, 1.5, 1)
    assert found.fall(1.0)["estimate"] == pytest.approx(2 * np.pi / 18, rel=1e-3)
    assert found.size(np.array([0.0]))[0] == pytest.approx(3, rel=0.02)


def test_too_few_samples_have_no_line():
    assert damped_cosine(T[:8], np.cos(18 * T[:8]), 18.0, 0.1) is None
    assert damped_cosine(T[:14], np.exp(-3 * T[:14]) * np.cos(18 * T[:14]), 18.0, 2.0) is not None
