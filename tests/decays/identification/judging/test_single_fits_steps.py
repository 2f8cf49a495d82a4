"""One law fitted to one run, step by step: too few data, failures, starts, and the error of prediction."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from asymptotics.decays.identification.fitting.model import Noise
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.judging import prediction, single_fits
from asymptotics.decays.identification.judging.prediction import predicted_error
from asymptotics.decays.identification.judging.single_fits import embedded, fit_decrements, fit_law
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.synthetic import exact, observed


def decay(count):
    return Observations.of(range(count), 0.9 ** np.arange(count) * (-1.0) ** np.arange(count))


@pytest.mark.parametrize(("count", "reason"), [(3, "3 data for 2 unknowns"), (4, "4 data for 2 unknowns")])
def test_two_data_to_spare_are_needed_and_one_more_for_the_criterion(count, reason):
    found = fit_law(read("1"), decay(count))
    assert (found.reason, found.usable) == (reason, False) and (found.fit is None) == (count == 3)
    assert fit_law(read("1"), decay(5)).usable


@pytest.mark.parametrize("error", [TooStrongError("it ends"), np.linalg.LinAlgError("it ends")])
def test_a_fit_that_fails_says_why(monkeypatch, error):
    def fail(*_):
        raise error

    monkeypatch.setattr(single_fits, "fit", fail)
    found = fit_law(read("1"), decay(9))
    assert (found.fit, found.reason, str(found.candidate)) == (None, "no fit: it ends", "1")
    table = Decrements(np.array([1.0, 0.5, 0.3]), np.array([0.2, 0.1, 0.05]))
    assert fit_decrements(read("1"), table).reason == "no fit: it ends"


def test_a_start_is_used_where_it_is_given_and_noise_is_passed_on(monkeypatch):
    asked = []
    monkeypatch.setattr(
        single_fits, "fit", lambda model, start, noise: (asked.append((start, noise)), SimpleNamespace(aicc=0.0))[1]
    )
    monkeypatch.setattr(single_fits, "starting_values", lambda model: "begun")
    fit_law(read("1"), decay(9), "noise", start="given")
    fit_law(read("1"), decay(9))
    assert asked == [("given", "noise"), ("begun", None)]


@pytest.mark.parametrize(("rows", "fitted"), [(1, False), (2, True)])
def test_printed_decrements_need_one_datum_to_spare(rows, fitted):
    table = Decrements(np.array([1.0, 0.5, 0.3])[:rows], np.array([0.2, 0.1, 0.06])[:rows])
    found = fit_decrements(read("1"), table)
    assert (found.fit is not None) == fitted and found.reason == ("" if fitted else "1 data for 1 unknowns")
    if fitted:  # D = 0.2 a: L = -2 artanh(0.1) = -pi (e/2)/sqrt(1 - e^2/4)
        lag = 2 * np.arctanh(0.1) / np.pi
        assert found.fit.theta[0] == pytest.approx(2 * lag / np.sqrt(1 + lag**2), rel=1e-6)


def test_a_weaker_start_is_tried_three_times(monkeypatch):
    asked = []

    def fail(model, start, noise):
        asked.append(start.tolist())
        raise TooStrongError("it ends")

    monkeypatch.setattr(single_fits, "fit", fail)
    model = SimpleNamespace(swing=SimpleNamespace(elements=("a", "b")))
    with pytest.raises(TooStrongError):
        single_fits._fit_from(model, np.array([1.0, 2.0, 3.0, 4.0]), None)
    assert [a[0] for a in asked] == [1.0] * 4 == [a[3] / 4 for a in asked]
    assert np.array([a[1:3] for a in asked]) == pytest.approx(np.outer(0.8 ** np.arange(4), [2.0, 3.0]))


def test_the_turning_points_of_samples_start_their_fit_with_the_errors_that_are_stated(monkeypatch):
    asked = []
    seen = replace(decay(9), samples="samples", t=np.arange(9.0), sigma_x=np.arange(9.0), sigma_t=np.full(9, 0.5))

    def fit(model, start, noise):
        asked.append((model.seen.samples, model.swing.coarse, start, noise))
        return SimpleNamespace(theta="found")

    monkeypatch.setattr(single_fits, "fit", fit)
    monkeypatch.setattr(single_fits, "starting_values", lambda model: "begun")
    assert single_fits._from_turning_points(read("1"), seen) == "found"
    assert asked == [(None, True, "begun", Noise(pytest.approx(np.sqrt(204 / 9)), pytest.approx(0.5)))]

    def fail(*_):
        raise TooStrongError("it ends")

    monkeypatch.setattr(single_fits, "fit", fail)
    assert single_fits._from_turning_points(read("1"), seen) == "begun"


@pytest.mark.parametrize(
    ("law", "larger", "vector"),
    [
        ("1", "1+2", [0.1, 0.2, 0.0, 0.3]), ("2", "1+2", [0.1, 0.0, 0.2, 0.3]), ("1", "1+s3", [0.1, 0.2, 0.0, 0.3]),
        ("1", "free", [0.1, 0.2, 1.0, 0.3]), ("3", "free+s3", [0.1, 0.2, 0.0, 3.0, 0.3]),
    ],
)  # fmt: skip
def test_a_law_in_a_larger_one_has_further_strengths_0(law, larger, vector):
    fit = SimpleNamespace(theta=np.array([0.1, 0.2, 0.3]))
    assert embedded(fit, read(law), read(larger)).tolist() == vector
    free = SimpleNamespace(theta=np.array([0.1, 0.2, 1.4, 0.3]))  # its exponent leaves the vector
    assert embedded(free, read("free"), read("1+2")).tolist() == [0.1, 0.2, 0.0, 0.3]
    assert embedded(free, read("free"), read("free+s3")).tolist() == [0.1, 0.2, 0.0, 1.4, 0.3]


def test_the_error_of_prediction_is_that_of_the_swings_that_the_fit_has_not_seen():
    seen = observed("1+2", [0.02, 0.05], 30, 2e-3, seed=8)
    law = fit_law(read("1"), seen)
    early = fit_law(read("1"), seen.up_to(20)).fit
    e = early.theta[1]
    n = np.arange(31)
    size = early.model.reference * np.exp(early.theta[0] - np.pi * e / 2 / np.sqrt(1 - e * e / 4) * n)
    late = (seen.x - early.theta[2] - size * (-1.0) ** n)[21:]
    assert predicted_error(law, seen) == pytest.approx(np.sqrt(np.mean(late**2)) / law.fit.scales["x"], rel=1e-6)
    assert predicted_error(law, seen, 0.5) != predicted_error(law, seen)
    right = fit_law(read("1+2"), seen)
    assert predicted_error(right, seen) * right.fit.scales["x"] < predicted_error(law, seen) * law.fit.scales["x"] / 3


def test_without_a_fit_of_the_first_swings_nothing_is_predicted(monkeypatch):
    seen = decay(30)
    law = fit_law(read("1"), seen)
    assert predicted_error(replace(law, fit=None), seen) is None
    assert predicted_error(law, replace(seen, samples="samples")) is None
    assert predicted_error(fit_law(read("1"), decay(5)), decay(5)) is None  # three points of five
    dry = Observations.of(
        range(12), exact("0", [0.04], 11).a * 0 + np.exp(exact("0", [0.04], 11).a) * (-1.0) ** np.arange(12)
    )
    ends = fit_law(read("0"), dry)
    monkeypatch.setattr(prediction, "fit_law", lambda c, s: fit_law(c, s, start=None))
    assert predicted_error(ends, dry) < 10
    stronger = SimpleNamespace(fit=SimpleNamespace(theta=np.array([0.0, 0.05, 0.0]), model=ends.fit.model))
    monkeypatch.setattr(prediction, "fit_law", lambda c, s: stronger)  # ends after ten half-swings
    assert predicted_error(ends, dry) is None
