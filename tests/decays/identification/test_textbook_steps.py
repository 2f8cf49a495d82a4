"""The classical estimators on decays that are theirs, and what they add elsewhere, by the exact turning points."""

import numpy as np
import pytest

from asymptotics.decays.identification import textbook
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.judging.single_fits import fit_law
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.synthetic import exact, observed
from asymptotics.decays.identification.textbook import exact_points, systematic_error, textbook_estimates

N = np.arange(12)
SIGN = (-1.0) ** N


def sequence(decrement, first=2.0):
    """Amplitudes whose decrement is this function of the mean of both."""
    found = [first]
    for _ in N[1:]:
        a = found[-1]
        for _ in range(60):
            a = found[-1] - decrement((found[-1] + a) / 2)
        found.append(a)
    return np.array(found)


def test_each_estimator_is_right_where_its_law_is_the_law():
    size = 2 * np.exp(-np.pi / 2 * 0.03 * N)
    assert textbook.logarithmic_decrement(size * SIGN) == pytest.approx([0.03])
    size = sequence(lambda a: np.pi / 2 * 0.03 * a + 4 / 3 * 0.05 * a**2)
    assert textbook.froude(size * SIGN) == pytest.approx([0.03, 0.05])
    size = sequence(lambda a: 4 / 3 * 0.05 * a**2)
    assert textbook.bertin(size * SIGN) == pytest.approx([0.05])
    assert textbook.froude(size * SIGN) == pytest.approx([0.0, 0.05], abs=1e-9)


def test_the_energy_of_a_half_swing_falls_by_its_polynomial():
    size = [2.0]
    for _ in N[1:]:
        b = size[-1]
        for _ in range(80):
            a = (size[-1] + b) / 2
            b = np.sqrt(size[-1] ** 2 - 2 * (np.pi / 2 * 0.03 * a**2 + 4 / 3 * 0.05 * a**3))
        size.append(b)
    assert textbook.energy_method(np.array(size) * SIGN) == pytest.approx([0.03, 0.05])


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_dry_and_linear_damping_are_told_apart_by_the_extremes(side):
    """x' = q x about the place where friction holds: X_(n+1) = -q X_n + side friction (1 + q)."""
    epsilon, friction = 0.04, 0.01
    lag = epsilon / 2 / np.sqrt(1 - epsilon**2 / 4)
    q = np.exp(-np.pi * lag)
    x = [2.0 * side]
    for _ in range(8):
        x.append(-q * x[-1] + np.sign(x[-1]) * friction * (1 + q))
    found = textbook.feeny_liang(np.array(x))
    assert found == pytest.approx([friction, epsilon], rel=1e-9)


def test_where_sums_of_extremes_do_not_shrink_the_estimator_has_no_value():
    assert np.isnan(textbook.feeny_liang(np.array([1.0, -1.5, 2.0, -2.8, 4.0]))).all()
    assert np.isfinite(textbook.feeny_liang(np.array([1.0, -0.9, 0.81, -0.729]))).all()


def test_the_estimates_are_told_with_their_exponents_and_errors():
    seen = observed("1+2", [0.02, 0.03], 20, 1e-4, seed=1, x0=2.0)
    found = textbook_estimates(seen)
    assert {name: each["alphas"] for name, each in found.items()} == {
        "logarithmic decrement": ["1"], "Froude": ["1", "2"], "Bertin": ["2"], "Feeny-Liang": ["0", "1"],
        "energy": ["1", "2"],
    }  # fmt: skip
    froude = textbook.froude(seen.x)
    assert found["Froude"]["epsilon"] == [f"{e:.6g}" for e in froude]
    error = systematic_error(textbook.froude, exact_points(read("1+2"), seen))
    assert found["Froude"]["systematic_error"] == [f"{e:.3g}" for e in error]


def test_the_systematic_error_is_what_the_estimator_adds_on_exact_data():
    seen = observed("2", [0.05], 15, 1e-4, seed=1, x0=2.0)
    fitted = fit_law(read("2"), seen).fit
    strength = fitted.theta[1] / seen.reference  # of one unit, from that of the first amplitude
    run = exact("2", [fitted.theta[1] * np.exp(fitted.theta[0])], 15)
    data = seen.reference * np.exp(fitted.theta[0] + run.a) * (-1.0) ** np.arange(16)
    assert systematic_error(textbook.bertin, exact_points(read("2"), seen)) == pytest.approx(
        textbook.bertin(data) - strength, rel=1e-4
    )


@pytest.mark.parametrize("change", ["few", "gap", "zero", "samples"])
def test_records_that_the_estimators_do_not_serve_have_none(change):
    n, x = N, 0.9**N * SIGN
    if change == "few":
        n, x = n[:3], x[:3]
    if change == "gap":
        n, x = np.delete(n, 4), np.delete(x, 4)
    if change == "zero":
        x = np.where(n == 5, 0.0, x)
    seen = Observations.of(n, x)
    if change == "samples":
        object.__setattr__(seen, "samples", "samples")
    assert textbook_estimates(seen) == {}
    assert textbook_estimates(Observations.of(N[:4], (0.9**N * SIGN)[:4])) != {}


def test_without_a_fit_or_a_motion_there_is_no_error(monkeypatch):
    seen = Observations.of(N, 0.9**N * SIGN)
    fitted = fit_law(read("1"), seen)

    def ends(*_):
        raise TooStrongError("it ends")

    monkeypatch.setattr(textbook, "turning_sequence", ends)
    assert systematic_error(textbook.logarithmic_decrement, exact_points(read("1"), seen)) is None
    monkeypatch.setattr(textbook, "fit_law", lambda *_: type(fitted)(fitted.candidate, None))
    assert systematic_error(textbook.logarithmic_decrement, exact_points(read("1"), seen)) is None
    assert all(each["systematic_error"] is None for each in textbook_estimates(seen).values())
