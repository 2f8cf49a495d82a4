"""The fit of one law step by step: the minimiser, scales of the noise, likelihood and freedoms, by their formulas."""

from types import SimpleNamespace

import numpy as np
import pytest

from asymptotics.decays.identification.fitting import least_squares
from asymptotics.decays.identification.fitting.least_squares import Fit, fit, likely_scales, minimise
from asymptotics.decays.identification.fitting.model import Noise
from asymptotics.decays.identification.forward.quadrature import TooStrongError

X = np.array([0.0, 1.0, 2.0, 3.0, 5.0, 8.0])


class Line:
    """Two kinds of data: three about a + b x, three about 2 a; with shapes, and a floor of 1e-6."""

    kinds, groups, size, after = ["x", "t"], [slice(0, 3), slice(3, 6)], 2, 2
    J = np.array([[1.0, 0.0], [1.0, 1.0], [1.0, 2.0], [2.0, 0.0], [2.0, 0.0], [2.0, 0.0]])
    offset, absorbed, predicted = False, 0, None

    def __init__(self, data, shape=None, reference=1.0, coarse=True):
        self.data, self.shape = np.array(data, dtype=float), np.ones(6) if shape is None else np.array(shape)
        self.swing = SimpleNamespace(coarse=coarse, free=False, tolerance=None)
        self.seen = SimpleNamespace(reference=reference, samples=None)

    def predict(self, theta):
        return self.J @ theta, self.J

    def scale_vector(self, scales):
        return self.shape * np.repeat([scales["x"], scales["t"]], 3)

    def floor(self, kind, theta):
        return 1e-6


DATA = [1.0, 1.6, 1.9, 2.2, 1.8, 2.1]


def weighted(data, sigma):
    return np.linalg.lstsq(Line.J / sigma[:, None], np.array(data) / sigma, rcond=None)[0]


@pytest.mark.parametrize("scales", [{"x": 1.0, "t": 1.0}, {"x": 0.1, "t": 3.0}])
def test_the_minimum_of_a_straight_model_is_that_of_weighted_least_squares(scales):
    theta, converged = minimise(Line(DATA), np.array([5.0, -3.0]), scales)
    assert converged and theta == pytest.approx(weighted(DATA, np.repeat([scales["x"], scales["t"]], 3)), abs=1e-6)


def test_nothing_is_predicted_twice_in_a_row():
    asked = []

    class Watched(Line):
        def predict(self, theta):
            asked.append(theta.tolist())
            return super().predict(theta)

    fit(Watched(DATA), np.array([5.0, -3.0]))
    assert len(asked) > 2 and all(now != then for now, then in zip(asked, asked[1:]))


def test_what_was_predicted_is_told_only_for_its_parameters_and_tolerance():
    model, theta = Line(DATA), np.array([1.0, 2.0])
    model.swing.tolerance = 1e-3
    first = least_squares.predicted_at(model, theta)[0]
    model.J = 2 * Line.J
    assert least_squares.predicted_at(model, theta)[0] is first
    assert least_squares.predicted_at(model, 3 * theta)[0] == pytest.approx(6 * first)
    model.swing.tolerance = 1e-5
    assert least_squares.predicted_at(model, theta)[0] == pytest.approx(2 * first)


def test_a_penalty_is_one_residual_more():
    held = lambda theta: ((theta[1] - 4.0) * 100, np.array([0.0, 100.0]))  # noqa: E731
    theta, _ = minimise(Line(DATA), np.zeros(2), {"x": 1.0, "t": 1.0}, held)
    J, y = np.vstack([Line.J, [0.0, 100.0]]), np.append(DATA, 400.0)
    assert theta == pytest.approx(np.linalg.lstsq(J, y, rcond=None)[0], abs=1e-5)


class Bent:
    """Rosenbrock's residuals, 3 (b - a^2) and 1 - a; the model ends at b = ``end``."""

    swing, predicted = SimpleNamespace(free=False, tolerance=None), None
    data, end = np.zeros(2), -10.0

    def predict(self, theta):
        a, b = theta
        if b < self.end:
            raise TooStrongError("outside")
        return np.array([3 * (b - a * a), 1 - a]), np.array([[-6 * a, 3.0], [-1.0, 0.0]])

    def scale_vector(self, scales):
        return np.ones(2)


def test_a_curved_valley_is_followed_to_its_end():
    theta, converged = minimise(Bent(), np.array([-1.2, 1.0]), {})
    assert converged and theta == pytest.approx([1.0, 1.0], abs=1e-6)


def test_a_step_that_leaves_the_model_is_shortened():
    """Gauss and Newton's first step from (-0.9, 0.81) leads to (1, -2.6)."""
    model, asked = Bent(), []
    model.end = -1.0
    real = model.predict
    model.predict = lambda theta: (asked.append(theta.copy()), real(theta))[1]
    theta, converged = minimise(model, np.array([-0.9, 0.81]), {})
    assert asked[1] == pytest.approx([1.0, 0.81 - 2 * 0.9 * 1.9], abs=1e-3)
    assert converged and theta == pytest.approx([1.0, 1.0], abs=1e-6)


def test_a_free_exponent_stays_in_its_range():
    model = SimpleNamespace(swing=SimpleNamespace(free=True), after=3)
    inside = lambda value: least_squares._inside(model, np.array([9.0, 9.0, value, 9.0])).tolist()  # noqa: E731
    assert inside(-0.5) == [9, 9, 0, 9] and inside(6.0) == [9, 9, 5, 9] and inside(2.5) == [9, 9, 2.5, 9]
    model.swing.free = False
    assert inside(6.0) == [9, 9, 6, 9]


def test_a_step_is_damped_towards_the_gradient():
    J, r = np.array([[1.0, 2.0], [0.0, 1.0], [1.0, 1.0]]), np.array([1.0, -1.0, 2.0])
    assert least_squares._step(J, r, 0.0) == pytest.approx(-np.linalg.lstsq(J, r, rcond=None)[0])
    assert least_squares._step(J, r, 1e6) * 1e6 == pytest.approx(-J.T @ r, rel=1e-4)


def test_scales_are_root_mean_squares_over_what_the_parameters_leave():
    """N_g less the trace of the hat matrix over the group; the floor where nothing is left."""
    model, scales = Line(DATA, [1.0, 1, 1, 2, 2, 1]), {"x": 0.2, "t": 0.4}
    theta = np.array([1.1, 0.4])
    sigma = model.scale_vector(scales)
    A = Line.J / sigma[:, None]
    hat = np.diag(A @ np.linalg.inv(A.T @ A) @ A.T)
    r = (np.array(DATA) - Line.J @ theta) / model.shape
    found = likely_scales(model, theta, scales)
    assert found["x"] == pytest.approx(np.sqrt((r[:3] ** 2).sum() / (3 - hat[:3].sum())))
    assert found["t"] == pytest.approx(np.sqrt((r[3:] ** 2).sum() / (3 - hat[3:].sum())))
    exact = Line(Line.J @ theta)
    assert likely_scales(exact, theta, scales) == {"x": 1e-6, "t": 1e-6}


def test_a_kind_without_freedom_has_half_a_datum(monkeypatch):
    monkeypatch.setattr(least_squares, "_left_over", lambda *_: {"x": 0.2, "t": 2.0})
    theta = np.array([1.1, 0.4])
    r = np.array(DATA) - Line.J @ theta
    found = likely_scales(Line(DATA), theta, {"x": 1.0, "t": 1.0})
    assert found == pytest.approx({"x": np.sqrt((r[:3] ** 2).sum() / 0.5), "t": np.sqrt((r[3:] ** 2).sum() / 2)})


def test_known_noise_is_kept_and_unknown_noise_is_found():
    known = fit(Line(DATA), np.zeros(2), Noise(x=0.1, t=0.3))
    assert known.known and known.scales == {"x": 0.1, "t": 0.3} and known.converged
    assert known.theta == pytest.approx(weighted(DATA, np.repeat([0.1, 0.3], 3)), abs=1e-6)
    for noise in (None, Noise(x=0.1), Noise(t=0.1)):
        found = fit(Line(DATA), np.zeros(2), noise)
        assert not found.known and found.scales != {"x": 0.1, "t": 0.3}
        again = likely_scales(found.model, found.theta, found.scales)
        assert all(again[k] == pytest.approx(found.scales[k], rel=0.05) for k in again)  # they fit each other
    assert np.array_equal(found.residuals, np.array(DATA) - Line.J @ found.theta) and found.slopes is Line.J


@pytest.mark.parametrize(("reference", "tolerance"), [(1.0, 3e-3 * 0.05), (1e-4, 3e-4), (1e12, 1e-11)])
def test_a_series_is_summed_as_far_as_the_noise_asks(reference, tolerance):
    """A 3/1000 of the noise in units of the first amplitude, between 1e-11 and 3e-4."""
    model = Line(DATA, reference=reference, coarse=False)
    fit(model, np.zeros(2), Noise(x=0.05, t=0.3))
    assert model.swing.tolerance == pytest.approx(tolerance)
    coarse = Line(DATA)
    fit(coarse, np.zeros(2), Noise(x=0.05, t=0.3))
    assert coarse.swing.tolerance is None


def test_rounds_end_where_the_scales_stay_and_after_five(monkeypatch):
    calls, scale = [], [1.0]
    monkeypatch.setattr(least_squares, "minimise", lambda m, theta, s: (calls.append(dict(s)), (theta, True))[1])
    for change, rounds in ((1.0, 2), (1.0005, 2), (1.01, 5)):
        calls.clear()
        scale[0] = 1.0

        def scales(model, theta, known, change=change):
            scale[0] *= change
            return {"x": scale[0], "t": scale[0]}

        monkeypatch.setattr(least_squares, "likely_scales", scales)
        fit(Line(DATA, reference=2.0), np.zeros(2))
        assert calls[0] == {"x": 0.02, "t": 0.1} and len(calls) == rounds


def of(known, shape=None, scales=None):
    model = Line(DATA, shape)
    theta = np.array([1.05, 0.45])
    return Fit(model, theta, model.data - Line.J @ theta, Line.J, scales or {"x": 0.1, "t": 0.2}, known, True)


def normal(r, sigma):
    return float(np.log(np.exp(-((r / sigma) ** 2) / 2) / (sigma * np.sqrt(2 * np.pi))).sum())


def test_the_likelihood_is_that_of_normal_noise():
    """Known: by the scales; unknown: at the most likely ones, the mean squares over N."""
    shape = np.array([1.0, 2.0, 1.0, 1.0, 0.5, 1.0])
    known = of(True, shape)
    sigma = shape * np.repeat([0.1, 0.2], 3)
    assert known.log_likelihood == pytest.approx(normal(known.residuals, sigma))
    found = of(False, shape)
    r = found.residuals / shape
    best = np.repeat([np.sqrt(np.mean(r[:3] ** 2)), np.sqrt(np.mean(r[3:] ** 2))], 3)
    assert found.log_likelihood == pytest.approx(normal(found.residuals, shape * best))
    assert found.weighted == pytest.approx(found.residuals / sigma) and found.chi2 == pytest.approx(
        (found.weighted**2).sum()
    )


def test_criteria_count_the_scales_that_were_found():
    n = 6
    for known, k in ((True, 2), (False, 4)):
        found = of(known)
        deviance = -2 * found.log_likelihood
        assert found.aicc == pytest.approx(deviance + 2 * k + 2 * k * (k + 1) / (n - k - 1))
        assert found.bic == pytest.approx(deviance + k * np.log(n))


def test_freedoms_are_shared_out_between_the_kinds():
    found = of(True)
    sigma = np.repeat([0.1, 0.2], 3)
    A = Line.J / sigma[:, None]
    hat = np.diag(A @ np.linalg.inv(A.T @ A) @ A.T)
    assert found.freedom == 4
    assert found.freedoms == pytest.approx({"x": 3 - hat[:3].sum(), "t": 3 - hat[3:].sum(), "passage": 4.0})
    assert found.covariance == pytest.approx(np.linalg.inv(A.T @ A), rel=1e-9)


def test_the_rest_position_is_the_offset_of_turning_points_alone():
    found = of(True)
    assert found.rest == 0.0
    found.model.offset, found.model.after = True, 1
    assert found.rest == 0.45
    found.model.seen.samples = "samples"
    assert found.rest == 0.0
