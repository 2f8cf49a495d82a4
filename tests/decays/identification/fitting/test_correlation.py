"""Residuals that remember: the test of whiteness, the blocks, the draws and the stretch, each by its own formula."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.stats import chi2

from asymptotics.decays.identification.fitting.correlation import (
    _whiteness,
    block_length,
    is_correlated,
    replicas,
    stretch,
)
from asymptotics.decays.identification.fitting.directions import Directions


def fit(r, slopes=None, units=None, groups=None):
    r = np.asarray(r, dtype=float)
    slopes = np.ones((len(r), 1)) if slopes is None else slopes
    model = SimpleNamespace(groups=groups or [slice(0, len(r))], units=units or len(r))
    return SimpleNamespace(
        weighted=r, residuals=r, model=model, theta=np.zeros(slopes.shape[1]), directions=Directions.of(slopes)
    )


def remembering(rho, count, seed=0):
    rng, r = np.random.default_rng(seed), [0.0]
    for _ in range(count + 20):
        r.append(rho * r[-1] + rng.standard_normal())
    return np.array(r[-count:])


@pytest.mark.parametrize(("count", "lags"), [(20, 4), (50, 10), (200, 10)])
def test_the_statistic_is_that_of_ljung_and_box(count, lags):
    r = remembering(0.3, count)
    c = r - r.mean()
    rho = [sum(c[i] * c[i + k] for i in range(count - k)) / sum(c * c) for k in range(1, lags + 1)]
    q = count * (count + 2) * sum(x**2 / (count - k) for k, x in enumerate(rho, start=1))
    assert _whiteness(r) == pytest.approx(chi2.sf(q, lags), rel=1e-9)
    assert _whiteness(np.ones(50)) == 1.0 == _whiteness(r[:4])


def test_memory_is_seen_in_any_kind_and_not_in_a_few_data():
    white, red = remembering(0.0, 60, 3), remembering(0.9, 60)
    assert not is_correlated(fit(white)) and is_correlated(fit(red))
    both = [slice(0, 60), slice(60, 120)]
    assert is_correlated(fit([*white, *red], groups=both)) and not is_correlated(fit([*white, *white], groups=both))
    assert is_correlated(fit(np.arange(12.0))) and not is_correlated(fit(np.arange(11.0)))


def test_the_level_is_shared_between_the_kinds():
    r = next(r for s in range(99) if 0.006 < _whiteness(r := remembering(0.3, 40, s)) < 0.01)
    assert is_correlated(fit(r)) and not is_correlated(fit([*r, *r], groups=[slice(0, 40), slice(40, 80)]))


def test_a_block_is_twice_the_memory_within_its_bounds():
    wave = np.repeat([1.0, -1.0], 10)  # ten alike
    slow = np.tile(wave, 10)
    lag = next(k for k in range(1, 40) if abs(slow[k:] @ slow[:-k]) / 200 < 2 / np.sqrt(200))
    assert block_length(fit(slow)) == 2 * lag
    assert block_length(fit(np.tile([1.0, 0, -1, 0], 25))) == 3 and block_length(fit(slow, units=20)) == 4
    assert block_length(fit(slow, units=10)) == 3


def test_a_replica_is_drawn_in_blocks_that_go_round():
    """The residuals 0 ... 39 about their mean: whose successors are their neighbours but where a block ends."""
    r = np.arange(40.0)
    one = fit(r, slopes=np.eye(40))
    drawn = replicas(one, count=50)
    scale = np.sqrt(40 / 38)
    steps = np.round(np.diff(drawn, axis=1) / scale)
    assert drawn.shape == (50, 40) and np.allclose(np.sort(np.unique(np.round(drawn / scale + 19.5))), r)
    inside = np.isin(steps, [1, -39])
    length = block_length(one)
    assert 1 - 1.3 / length < inside.mean() < 1 - 0.6 / length
    assert np.array_equal(drawn, replicas(one, count=50))  # the same at every call


def test_the_stretch_is_the_spread_of_the_draws_over_the_error():
    one = fit(np.zeros(25))  # the mean of 25: an error of 1/5
    g = lambda theta: (theta[0], np.ones(1))  # noqa: E731
    draws = np.array([[0.3], [-0.3], [0.3], [-0.3]])
    assert stretch(one, g, draws) == pytest.approx(1.5) and stretch(one, g, draws / 3) == 1.0
    assert stretch(one, lambda theta: (0.0, np.zeros(1)), draws) == 1.0
    red = fit(remembering(0.8, 400))
    assert stretch(red, g, replicas(red)) == pytest.approx(np.sqrt(1.8 / 0.2), rel=0.35)  # AR(1): (1 + rho)/(1 - rho)
