"""A modulated line step by step: its sum and derivatives, where it turns, what is loud, its colour, and its fit."""

from types import SimpleNamespace

import numpy as np
import pytest

from asymptotics.decays.identification.measuring import demodulation
from asymptotics.decays.identification.measuring.demodulation import SpectralLine, demodulated

T = np.linspace(2.0, 42.0, 401)
OMEGA = 1.5
P, Q = np.array([1.0 - 0.2j, -0.3 + 0.1j, 0.05j]), np.array([0.02 + 0.01j, 0.01, -0.005j])


def line(P=P, Q=Q, t=T, omega=OMEGA):
    return SpectralLine(t, omega, P, Q, 0.1, 100.0, 0.0)


def motion(t, P=P, Q=Q, omega=OMEGA):
    """base 0: Re(P e^(i w t)) + Re(Q e^(3 i w t)), P and Q polynomials of Chebyshev's in u."""
    u = 2 * (t - T[0]) / (T[-1] - T[0]) - 1
    polynomials = [sum(c * np.cos(k * np.arccos(np.clip(u, -1, 1))) for k, c in enumerate(each)) for each in (P, Q)]
    return (polynomials[0] * np.exp(1j * omega * t) + polynomials[1] * np.exp(3j * omega * t)).real


@pytest.mark.parametrize("order", [0, 1, 2])
def test_the_sum_of_a_line_and_its_derivatives_are_those_of_the_motion(order):
    t, h = np.linspace(5.0, 38.0, 23), 1e-3
    value = {0: motion(t), 1: (motion(t + h) - motion(t - h)) / (2 * h),
             2: (motion(t + h) - 2 * motion(t) + motion(t - h)) / h**2}[order]  # fmt: skip
    assert line()._sum(P, Q, t, order) == pytest.approx(value, abs=2e-5)
    assert line()._sum(P, np.zeros(1), t, order).shape == t.shape


def test_amplitude_and_phase_are_those_of_the_carrier():
    size, phase = line().at(T)
    waves = motion(T, Q=np.zeros(1))
    assert size * np.cos(phase) == pytest.approx(waves, abs=1e-12) and (np.diff(phase) > 0).all()
    assert line()._places(np.array([2.0, 22.0, 42.0])).tolist() == [-1.0, 0.0, 1.0]


@pytest.mark.parametrize("derivative", [1, 2])
def test_a_line_is_integrated_to_the_motion_of_which_it_is_the_derivative(derivative):
    """The integrated coefficients, differentiated as often by numbers, are the line again."""
    integrated = [line().integrated(c, k, derivative) for c, k in ((P, 1), (Q, 3))]
    t, h = np.linspace(5.0, 38.0, 23), 1e-2
    each = lambda at: line()._sum(*integrated, at, 0)  # noqa: E731
    back = (
        (each(t + h) - each(t - h)) / (2 * h) if derivative == 1 else (each(t + h) - 2 * each(t) + each(t - h)) / h**2
    )
    assert back == pytest.approx(motion(t), abs=2e-3)
    assert line().integrated(P, 1, 0) is P


DECAY = np.array([1.0, -0.4, 0.1, -0.02], dtype=complex) * np.exp(0.8j)


def test_a_line_turns_where_its_slope_is_zero_with_alternating_values():
    own = line(DECAY, Q * 0.5)
    n, times, values, inside = own.turning_points()
    assert n.tolist() == list(range(len(times))) and times[0] < T[0] + 1e-9 and times[-1] > T[-1] - 1e-9
    assert inside.tolist() == [False, *[True] * (len(n) - 2), False]
    at, h = times[inside], 1e-4
    x = lambda t: motion(t, DECAY, Q * 0.5)  # noqa: E731
    assert np.abs((x(at + h) - x(at - h)) / (2 * h)).max() < 1e-4
    assert values[inside] == pytest.approx(x(at), abs=1e-9)
    assert (np.sign(values[1:]) == -np.sign(values[:-1])).all()
    assert np.diff(times) == pytest.approx(np.full(len(n) - 1, np.pi / OMEGA), rel=0.1)
    # In the ends the line is continued: the amplitude goes on as it did.
    assert abs(values[0]) == pytest.approx(abs(values[1]) ** 2 / abs(values[2]), rel=0.15)
    assert abs(values[-1]) == pytest.approx(abs(values[-2]) ** 2 / abs(values[-3]), rel=0.15)


@pytest.mark.parametrize("derivative", [1, 2])
def test_of_a_velocity_the_turning_points_are_those_of_the_motion(derivative):
    """A steady wave: the velocity -w sin(w t + f) belongs to cos(w t + f), which turns at k pi."""
    steady = line(np.array([(1j * OMEGA) ** derivative * np.exp(0.3j)]), np.zeros(1, dtype=complex))
    n, times, values, inside = steady.turning_points(derivative)
    k = (OMEGA * times + 0.3) / np.pi
    assert k == pytest.approx(np.round(k), abs=1e-6) and values == pytest.approx((-1.0) ** np.round(k), abs=1e-6)


@pytest.mark.parametrize(
    ("sizes", "kept"),
    [
        ([1.0] * 40, (0, 40)),
        ([0.05, *[0.5] * 10, *[1.0] * 10, 0.09, *[0.5] * 18], (1, 21)),  # as far as it is above a tenth
        ([*[0.5] * 18, 0.1, *[1.0] * 21], (0, 40)),  # a tenth itself is loud
        ([*[0.01] * 20, 1.0, *[0.01] * 19], (18, 22)),  # at least a twentieth of the record on either side
        ([1.0, *[0.01] * 39], (0, 2)),
        ([*[0.01] * 39, 1.0], (37, 40)),
    ],
)
def test_what_is_loud_is_the_stretch_about_the_largest_amplitude(sizes, kept):
    found = demodulation._loud(np.array(sizes))
    assert (found.start, found.stop) == kept


def test_a_line_is_found_with_its_modulation_its_overtone_and_its_noise():
    random = np.random.default_rng(2)
    t = np.linspace(0.0, 60.0, 601)
    u = 2 * t / 60 - 1
    x = 0.3 + 0.05 * u + (1 - 0.5 * u) * np.cos(2 * t + 0.4) + 0.03 * np.cos(6 * t + 0.1)
    found = demodulation.fitted_line(t, x + 1e-3 * random.standard_normal(len(t)), 2.0)
    assert found.omega == 2.0 and np.array_equal(found.t, t)
    wanted = np.exp(0.4j) * np.array([1.0, -0.5])
    assert (
        found.modulation[:2] == pytest.approx(wanted, abs=6e-4) and np.abs(found.modulation[2:]).max(initial=0) < 6e-4
    )
    assert found.third[0] == pytest.approx(0.03 * np.exp(0.1j), abs=6e-4)
    assert found.noise == pytest.approx(1e-3, rel=0.08) and found.memory == 0
    assert found.freedom == len(t) - 2 - 4 * len(found.modulation)


@pytest.mark.parametrize(("a_period", "overtone"), [(8.5, True), (7.5, False)])
def test_the_third_overtone_is_fitted_from_eight_samples_a_period_on(a_period, overtone):
    t = np.arange(0, 60, 2 * np.pi / a_period)
    found = demodulation.fitted_line(t, np.cos(t) + 0.1 * np.cos(3 * t), 1.0)
    assert (len(found.third) > 1 or bool(np.abs(found.third[0]) > 0.05)) == overtone


def test_the_frequency_is_corrected_by_the_drift_of_the_phase():
    t = np.linspace(0, 200, 401)
    x = np.exp(-0.005 * t) * np.cos(1.01 * t + 0.2)
    found = demodulated(t, x, 2 * np.pi / 1.0)  # off by two rad over the record
    assert found.omega == pytest.approx(1.01, abs=2e-3) != 1.0
    near = demodulated(t, np.exp(-0.005 * t) * np.cos(1.001 * t), 2 * np.pi)  # 0.2 rad: the modulation takes it up
    assert near.omega == 1.0
    far = demodulated(t, np.exp(-0.005 * t) * np.cos(1.4 * t), 2 * np.pi)  # no correction, another line
    assert abs(far.omega - 1.0) < 2 * np.pi / 200 + 0.1
    assert demodulated(t, x).omega == pytest.approx(1.01, abs=2e-3)


def coloured(rho, count=4000, seed=5):
    random = np.random.default_rng(seed).standard_normal(count)
    r = np.empty(count)
    r[0] = random[0]
    for k in range(1, count):
        r[k] = rho * r[k - 1] + np.sqrt(1 - rho**2) * random[k]
    return r


@pytest.mark.parametrize("rho", [0.0, 0.3, 0.8, 0.97])
def test_the_colour_of_noise_is_that_of_its_neighbours(rho):
    r, t = 2.0 * coloured(rho), np.arange(4000) * 0.1
    noise, memory = demodulation._coloured(t, r, 3.0, 20, 4)
    assert noise == pytest.approx(2.0, rel=0.04 if rho < 0.9 else 0.2) and memory == pytest.approx(rho, abs=0.03)


def test_lines_of_motion_that_is_left_do_not_colour_the_noise():
    r, t = coloured(0.0), np.arange(4000) * 0.1
    for k in (1, 3):
        left = r + 3.0 * np.cos(k * 3.0 * t) + 5.0
        noise, memory = demodulation._coloured(t, left, 3.0, 20, 4)
        assert noise == pytest.approx(1.0, rel=0.04) and memory == 0


def test_of_uneven_or_few_samples_the_colour_is_taken_as_it_is(monkeypatch):
    monkeypatch.setattr(demodulation, "_memory", lambda r, size: ("memory", len(r), size))
    r = coloured(0.0, 80)
    t = np.arange(80) * 0.1
    plain = np.sqrt((r**2).sum() / (80 - 12))
    jumps = t + np.where(np.arange(80) == 40, 0.021, 0)
    assert demodulation._coloured(jumps, r, 3.0, 12, 4) == (pytest.approx(plain), ("memory", 80, 12))
    assert demodulation._coloured(t[:59], r[:59], 3.0, 12, 4)[1] == ("memory", 59, 12)
    assert demodulation._coloured(t, r, 3.0, 12, 1)[1] == ("memory", 80, 12)  # a wide line leaves too few bins
    assert isinstance(demodulation._coloured(t, r, 3.0, 12, 4)[1], float)
    assert demodulation._coloured(t[:5], r[:5], 3.0, 12, 4)[0] == pytest.approx(np.sqrt((r[:5] ** 2).sum()))


def test_the_memory_of_few_samples_is_unbiased_and_beyond_doubt():
    """rho + (1 + 3 rho)/n (1 + size/8), of what exceeds 3/sqrt(n)."""
    r = coloured(0.6, 100)
    rho = float(r[1:] @ r[:-1] / (r @ r))
    assert demodulation._memory(r, 8) == pytest.approx(rho + (1 + 3 * rho) / 100 * 2)
    assert demodulation._memory(coloured(0.0, 100), 8) == 0.0
    assert demodulation._memory(np.ones(100), 8) == 0.98
    edge = np.array([1.0, 0.0] * 50)
    edge[1::2] = 0.14
    rho = float(edge[1:] @ edge[:-1] / (edge @ edge))
    assert rho + (1 + 3 * rho) / 100 < 0.3 and demodulation._memory(edge, 0) == 0.0
    assert demodulation._memory(np.zeros(50), 4) == 0.0


def test_what_is_left_of_a_line_without_noise_is_nothing():
    t = np.linspace(0, 40, 400)
    found = demodulation.fitted_line(t, np.cos(1.3 * t), 1.3)
    assert found.noise < 1e-9 and found.modulation[0] == pytest.approx(1.0)


def test_turning_points_begin_before_the_first_sample_and_end_after_the_last():
    """Of cos(w t) from t0 to t1: one at or before t0, one at or after t1."""
    for start in (0.0, 0.05, 1.0, 2.0):
        t = np.linspace(start, start + 30.0, 601)
        own = SimpleNamespace(
            line=SpectralLine(t, 1.0, np.array([1.0 + 0j]), np.zeros(1, dtype=complex), 0.0, 0.0, 0.0)
        )
        _, times, values, inside = own.line.turning_points()
        k = np.round(times / np.pi)
        assert times == pytest.approx(k * np.pi, abs=1e-6) and values == pytest.approx((-1.0) ** k, abs=1e-6)
        first = np.floor(start / np.pi - 0.15)  # one more where the first lies just before the record
        assert k[0] == first and k[-1] == np.ceil((start + 30) / np.pi) and len(k) == k[-1] - k[0] + 1
        assert inside.tolist() == ((times >= t[0]) & (times <= t[-1])).tolist()
