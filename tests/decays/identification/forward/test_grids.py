"""Half-swings on Gauss's nodes against those on the sinc grid, and the edge of the motion on both."""

import numpy as np
import pytest

from asymptotics.decays.identification.forward import quadrature
from asymptotics.decays.identification.forward.coefficients import loss, spring
from asymptotics.decays.identification.forward.quadrature import PRECISE, TooStrongError, integrated_swings
from asymptotics.decays.identification.forward.swing import HalfSwingModel

TERMS = (loss(0.0), loss(1.0), loss(2.0), loss(3.0), spring(3), spring(5), spring(2), loss(1.0, 1), loss(0.0, 1))


@pytest.mark.parametrize("elements", [(loss(1.0),), (loss(0.0), loss(2.0), spring(3)), (loss(1.0, 2), loss(3.0))])
def test_gauss_nodes_agree_with_the_series(elements):
    strengths = np.full(len(elements), 0.02)
    a = np.array([0.0, -0.4])
    series = HalfSwingModel(elements).at(a, strengths)
    found = integrated_swings(elements, a, strengths, None, 0.0, PRECISE)
    for own, other in zip(found, (series.values, series.by_amplitude, series.by_parameter), strict=True):
        assert np.abs(own - other).max() < 1e-9


@pytest.mark.parametrize("seed", range(12))
def test_gauss_nodes_are_as_exact_as_they_say(seed):
    """Any whole exponents, from weak to the edge of the motion, beside a linear spring and in a pendulum."""
    random = np.random.default_rng(seed)
    for _ in range(4):
        elements = tuple(TERMS[i] for i in random.choice(len(TERMS), 1 + seed % 4, replace=False))
        k2 = 0.9 * random.random() if all(e in TERMS[:4] for e in elements) else 0.0
        strengths = random.uniform(0, random.choice([0.05, 0.3, 1.0]), len(elements))
        a = np.linspace(0, -1, 8)
        try:
            exact = integrated_swings(elements, a, strengths, None, k2)
        except TooStrongError:
            with pytest.raises(TooStrongError):
                integrated_swings(elements, a, strengths, None, k2, PRECISE)
            continue
        found = integrated_swings(elements, a, strengths, None, k2, PRECISE)
        for right, own, error in zip(exact, found, (PRECISE, 1e-5, 1e-5), strict=True):
            assert np.abs(right - own).max() < error
        moved = integrated_swings(elements, a, strengths * 1.001, None, k2, PRECISE)
        assert np.abs(moved[0] - exact[0]).max() > np.abs(found[0] - exact[0]).max()


def test_a_swing_that_gauss_nodes_do_not_resolve_is_left_to_the_finer_grid(monkeypatch):
    asked = []
    solved = quadrature._Swings.solved
    monkeypatch.setattr(quadrature._Swings, "solved", lambda own, t: asked.append(len(own.a)) or solved(own, t))
    elements, a, strengths = (loss(2.0), spring(3)), np.log([1.0, 0.2, 0.1]), np.array([2.5, 0.1])
    found = integrated_swings(elements, a, strengths, None, 0.0, PRECISE)
    assert asked == [3, 1]
    assert np.abs(found[0] - integrated_swings(elements, a, strengths, None)[0]).max() < PRECISE


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("tolerance", [0.0, PRECISE])
def test_beyond_the_edge_there_is_no_swing_and_no_warning(tolerance):
    """Friction and drag that leave 1e-6 of the spring's force, and that leave none: both are refused."""
    theta = np.pi / 96
    viscous = (1 - 1e-6 - 0.5 * np.cos(theta)) / (np.cos(theta) * np.sin(theta))
    for strengths in ([0.5, viscous], [0.2, 5.0], [3.0, 0.1], [0.1, 1e30]):
        with pytest.raises(TooStrongError):
            integrated_swings((loss(0.0), loss(1.0)), np.array([0.0]), np.array(strengths), None, 0.0, tolerance)


@pytest.mark.parametrize("strength", [1.5, 2.5])
def test_strong_drag_whose_first_guess_is_beyond_the_edge_has_its_swing(strength):
    """x'' + x + e x'|x'| = 0 in closed form: a half-swing ends where (1 + 2 e x) e^(-2 e x) is as at 1."""
    values, _, _ = integrated_swings((loss(2.0),), np.array([0.0]), np.array([strength]), None, 0.0, PRECISE)
    after, e = float(np.exp(values[0, 0])), strength
    assert (1 + 2 * e) * np.exp(-2 * e) == pytest.approx((1 - 2 * e * after) * np.exp(2 * e * after), abs=1e-6)
