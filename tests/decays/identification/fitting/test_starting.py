"""Where a fit begins: regressions that are exact to first order, and strengths that let the motion go on."""

import numpy as np
import pytest

from asymptotics.decays.identification.fitting.directions import Directions
from asymptotics.decays.identification.fitting.model import Model
from asymptotics.decays.identification.fitting.printed import DecrementModel, Decrements, decrement_start
from asymptotics.decays.identification.fitting.starting import _reachable, rest_position, starting_values
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.swing import HalfSwingModel
from asymptotics.decays.identification.measuring.observations import Observations


def swing_of(text):
    candidate = read_candidate(text)
    return HalfSwingModel(candidate.elements, candidate.free)


def seen_of(text, law, count=15, gap=(), omega=3.0, start=0.7, offset=0.0, times=True):
    """Turning points of the law itself, of the first amplitude 1.5."""
    n = np.array([k for k in range(count) if k not in gap])
    template = Observations.of(n, 1.5 * (-1.0) ** n, n.astype(float) if times else ())
    model = Model(swing_of(text), template)
    theta = np.array([0.0, *law, *([offset] * model.offset), *([np.log(omega), start] * times)])
    data = model.predict(theta)[0]
    seen = Observations.of(n, data[: len(n)], data[len(n) :] if times else ())
    return Model(swing_of(text), seen), theta


@pytest.mark.parametrize("gap", [(), (4, 5, 9)])
@pytest.mark.parametrize(
    ("text", "law"),
    [("1", [0.02]), ("2", [0.02]), ("0+1", [0.01, 0.02]), ("1+s3", [0.02, 0.05]), ("free", [0.02, 1.5])],
)
def test_weak_strengths_are_found_to_first_order(text, law, gap):
    """Also across a gap; the frequency, the start of the clock and the rest with them."""
    model, theta = seen_of(text, law, gap=gap, offset=0.02)
    found = starting_values(model)
    assert len(found) == len(theta) == model.size
    assert found[1] == pytest.approx(law[0], rel=0.1) and found[0] == pytest.approx(0.0, abs=0.02)
    assert found[model.after] == pytest.approx(0.02, abs=3e-3)
    assert found[-2] == pytest.approx(np.log(3.0), abs=2e-3) and found[-1] == pytest.approx(0.7, abs=5e-3)
    assert len(law) == 1 or found[2] == pytest.approx(law[1], rel=0.15)


def test_without_times_or_with_few_points_the_vector_is_shorter():
    for count, times, size in ((15, False, 3), (7, False, 2), (7, True, 4), (15, True, 5)):
        model, theta = seen_of("1", [0.02], count=count, times=times)
        assert len(starting_values(model)) == len(theta) == size


@pytest.mark.parametrize("offset", [0.1, -0.2])
def test_the_rest_is_the_mean_of_neighbours_and_none_across_a_gap(offset):
    n = np.arange(9)
    seen = Observations.of(n, 0.9**n * (-1.0) ** n + offset)
    means = [(seen.x[k - 1] + 2 * seen.x[k] + seen.x[k + 1]) / 4 for k in range(1, 8)]
    assert rest_position(seen) == pytest.approx(np.mean(means), rel=1e-12)
    split = Observations.of([0, 1, 3, 4, 5], seen.x[[0, 1, 3, 4, 5]])
    assert rest_position(split) == pytest.approx(means[3], rel=1e-12)  # 3, 4, 5 alone are whole
    assert rest_position(Observations.of([0, 2, 4], [1.0, 0.9, -0.8])) == 0.0
    assert rest_position(Observations.of([0, 1], [1.0, -0.9])) == 0.0


def test_strengths_that_stop_the_motion_shrink_until_it_reaches_the_last_point():
    model, theta = seen_of("0", [0.01])
    strong = theta.copy()
    strong[1] = 0.5
    found = _reachable(model, strong)
    steps = np.log(found[1] / 0.5) / np.log(0.7)
    assert steps == pytest.approx(round(steps), abs=1e-9) and steps >= 1
    model.predict(found)
    before = found.copy()
    before[1] /= 0.7
    with pytest.raises(TooStrongError):
        model.predict(before)
    assert np.delete(found, 1).tolist() == np.delete(theta, 1).tolist() and strong[1] == 0.5
    assert _reachable(model, theta).tolist() == theta.tolist()


AMPLITUDE = np.array([2.0, 1.5, 1.1, 0.8, 0.5])


@pytest.mark.parametrize(("text", "law"), [("1", [0.05]), ("2", [0.08]), ("0+2", [0.02, 0.05]), ("free", [0.05, 1.5])])
def test_a_decrement_is_that_of_the_half_swing_with_this_mean_amplitude(text, law):
    """(A + B)/2 = a and A - B = D, B = A e^L(A); its derivatives by differences."""
    model = DecrementModel(swing_of(text), Decrements(AMPLITUDE, AMPLITUDE))
    theta = np.array(law)
    found, slopes = model.predict(theta)
    first, second = AMPLITUDE + found / 2, AMPLITUDE - found / 2
    L = model.swing.at(np.log(first / model.reference), theta).values[0]
    assert np.log(second / first) == pytest.approx(L, abs=1e-11)
    for i, step in enumerate(np.eye(len(theta)) * 1e-5):
        numeric = (model.predict(theta + step)[0] - model.predict(theta - step)[0]) / 2e-5
        assert slopes[:, i] == pytest.approx(numeric, rel=1e-5, abs=1e-7)


@pytest.mark.parametrize(("text", "law"), [("1", [0.004]), ("0+2", [0.002, 0.005]), ("free", [0.004, 2.0])])
def test_a_fit_of_decrements_begins_with_their_first_order(text, law):
    table = Decrements(AMPLITUDE, AMPLITUDE)
    exact = DecrementModel(swing_of(text), table).predict(np.array(law))[0]
    found = decrement_start(DecrementModel(swing_of(text), Decrements(AMPLITUDE, exact)))
    assert found == pytest.approx(law, rel=0.02)


def test_rows_in_a_range_keep_their_resolution():
    table = Decrements(AMPLITUDE, AMPLITUDE / 10, AMPLITUDE / 100, "m", "d", ("n",))
    kept = table.between(0.8, 1.5)
    assert kept.amplitude.tolist() == [1.5, 1.1, 0.8] and kept.resolution.tolist() == (AMPLITUDE[1:4] / 100).tolist()
    assert kept.decrement.tolist() == (AMPLITUDE[1:4] / 10).tolist() and (kept.unit, kept.name) == ("m", "d")
    assert Decrements(AMPLITUDE, AMPLITUDE).between(0, 9).resolution is None and table.reference == 2.0


def test_the_covariance_of_seen_directions_is_that_of_the_normal_equations():
    J = np.random.default_rng(2).standard_normal((9, 3)) * [1.0, 100.0, 1e-3]
    found = Directions.of(J)
    assert found.covariance == pytest.approx(np.linalg.inv(J.T @ J), rel=1e-9) and found.seen.all()
    g = np.array([0.3, -20.0, 1e-4])
    assert found.standard_error(g) == pytest.approx(np.sqrt(g @ np.linalg.inv(J.T @ J) @ g), rel=1e-9)
    flat = Directions.of(np.column_stack([J[:, 0], np.zeros(9)]))
    assert flat.seen.tolist() == [True, False] and flat.standard_error(np.array([0.0, 1.0])) == np.inf
    assert Directions.of(J[:2]).seen.sum() == 2 and len(Directions.of(J[:2]).values) == 3  # fewer data than parameters
