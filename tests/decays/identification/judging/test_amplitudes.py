"""What an unseen spring could do, step by step: the parabola of the sum of squares, and the shifts of the estimates."""

from types import SimpleNamespace

import numpy as np
import pytest

from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.judging import amplitudes
from asymptotics.decays.identification.judging.amplitudes import ASSUMED_DRIFT, relieved, spring_bound, widened
from asymptotics.decays.identification.judging.laws import Fitted
from asymptotics.decays.identification.measuring.observations import Observations
from tests.decays.identification.small_laws import law


def with_spring(monkeypatch, squares, strengths=lambda _: (0.0,)):
    monkeypatch.setattr(amplitudes, "_with_spring", lambda _, g: (np.array(strengths(g)), squares(g)))


def fitted(chi2):
    """Nothing is known of its share yet: no number."""
    return Fitted(read("1"), None if chi2 is None else SimpleNamespace(chi2=chi2), left=float("nan"))


@pytest.mark.parametrize("place", [-0.4, -0.1, 0.0, 0.3, 0.45])
def test_the_least_sum_of_squares_of_a_spring_within_the_bound_is_that_of_the_parabola(monkeypatch, place):
    squares = lambda g: 5 + 10 * (g - place) ** 2  # noqa: E731
    with_spring(monkeypatch, squares)
    assert relieved(fitted(squares(0.0)), 0.5).left == pytest.approx(5 / squares(0.0), rel=1e-12)


@pytest.mark.parametrize(
    ("squares", "least"),
    [
        (lambda g: 5 + 10 * (g - 2) ** 2, 5 + 10 * 1.5**2),  # the vertex lies beyond the bound
        (lambda g: 5 + 10 * (g + 2) ** 2, 5 + 10 * 1.5**2),
        (lambda g: 20 - 10 * g * g, 17.5),  # no vertex: it falls on both sides
        (lambda g: 20 - 10 * g * g - g, 17.0),
        (lambda g: 20 - 30 * g, 5.0),
        (lambda g: 20.0 + 0 * g, 20.0),
        (lambda g: 1 - 10 * g + 16 * g * g, 0.0),  # -0.56 by the parabola: no share is below 0
    ],
)
def test_without_a_vertex_between_the_bounds_the_better_bound_counts(monkeypatch, squares, least):
    with_spring(monkeypatch, squares)
    assert relieved(fitted(squares(0.0)), 0.5).left == pytest.approx(least / squares(0.0), rel=1e-12)


def test_a_law_that_a_spring_makes_worse_is_not_relieved(monkeypatch):
    squares = lambda g: 5 + 10 * g * g  # noqa: E731
    with_spring(monkeypatch, squares)
    assert relieved(fitted(squares(0.0)), 0.5).left == 1.0
    assert relieved(fitted(0.0), 0.5).left == 1.0  # nothing is left: nothing to relieve


@pytest.mark.parametrize("side", [-1, 1])
def test_where_one_spring_has_no_fit_nothing_is_relieved(monkeypatch, side):
    monkeypatch.setattr(amplitudes, "_with_spring", lambda _, g: None if g * side > 0 else (np.zeros(1), 1.0))
    known, unfitted = fitted(5.0), fitted(None)
    assert relieved(known, 0.5) is known and relieved(unfitted, 0.5) is unfitted


def test_intervals_grow_to_the_side_to_which_a_spring_moves_the_estimates(monkeypatch):
    with_spring(monkeypatch, lambda _: 1.0, lambda g: (0.1 + 0.04 * g, 0.2 - 0.02 * g, 0.3 + 0.08 * g * g))
    known = law(
        "0+1+2",
        SimpleNamespace(),
        profiled=True,
        epsilon=tuple(Interval(e - 0.01, e, e + 0.02) for e in (0.1, 0.2, 0.3)),
    )
    found = widened(known, 0.5).epsilon
    assert [e.estimate for e in found] == [0.1, 0.2, 0.3]
    lows, highs = ([e.low for e in found], [e.high for e in found])
    assert lows == pytest.approx([0.1 - 0.03, 0.2 - 0.02, 0.3 - 0.01], rel=1e-12)
    assert highs == pytest.approx([0.1 + 0.04, 0.2 + 0.03, 0.3 + 0.04], rel=1e-12)
    assert widened(known, 0.5).intervals.profiled  # all else is kept


def test_one_spring_that_has_a_fit_widens_alone_and_none_nothing(monkeypatch):
    known = law("1", SimpleNamespace(), epsilon=(Interval(0.09, 0.1, 0.11),))
    monkeypatch.setattr(amplitudes, "_with_spring", lambda _, g: (np.array([0.13]), 1.0) if g > 0 else None)
    assert [widened(known, 0.5).epsilon[0].low, widened(known, 0.5).epsilon[0].high] == pytest.approx([0.09, 0.14])
    monkeypatch.setattr(amplitudes, "_with_spring", lambda *_: None)
    assert widened(known, 0.5) is known
    unfitted, without = law("1", epsilon=known.epsilon), law("1", SimpleNamespace(), epsilon=())
    assert widened(unfitted, 0.5) is unfitted and widened(without, 0.5) is without


def test_without_times_a_drift_is_assumed_and_said():
    """omega moves by (3/8) c A^2."""
    bound, said = spring_bound(Observations.of(range(6), 0.9 ** np.arange(6)))
    assert 3 / 8 * bound == pytest.approx(ASSUMED_DRIFT, rel=1e-12) and said.startswith("no times: a drift of 0.01")
