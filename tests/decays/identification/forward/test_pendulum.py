"""The pendulum without a free coefficient: its half-swing against SciPy, and records up to 175 degrees."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import asymptotics as asy
from asymptotics.decays.identification.forward.candidates import default_candidates, read_candidate
from asymptotics.decays.identification.forward.coefficients import loss
from asymptotics.decays.identification.forward.pendulum import PendulumHalfSwing
from asymptotics.errors import InputError

G = 9.80665


def integrated(amplitude, law):
    """(next amplitude, half-swing, quarter-swing) at omega_0 = 1 by SciPy with events."""
    force = lambda _, y: [y[1], -np.sin(y[0]) - sum(e * np.sign(y[1]) * abs(y[1]) ** q for q, e in law)]  # noqa: E731
    stop = lambda _, y: y[1]  # noqa: E731
    stop.terminal, stop.direction = True, 1
    found = solve_ivp(force, (0, 60), [amplitude, -1e-300], events=[stop, lambda _, y: y[0]], rtol=1e-12, atol=1e-14)
    return -found.y_events[0][0][0], found.t_events[0][0], found.t_events[1][0]


@pytest.mark.parametrize("degrees", [17, 86, 150, 175])
@pytest.mark.parametrize("law", [[(1.0, 0.01)], [(1.0, 0.01), (2.0, 0.01)], [(0.0, 0.001), (1.0, 0.01)]])
def test_the_half_swing_is_that_of_an_integrator(degrees, law):
    A = np.radians(degrees)
    r = 2 * np.sin(A / 2)
    swing = PendulumHalfSwing([loss(q) for q, _ in law], A)
    strengths = np.array([e * r ** (q - 1) for q, e in law])
    value = swing.at(np.array([0.0]), strengths)
    following, half, quarter = integrated(A, law)
    assert value.of("L")[0] == pytest.approx(np.log(2 * np.sin(following / 2) / r), abs=1e-10)
    assert [value.of("T")[0], value.of("T_q")[0]] == pytest.approx([half, quarter], rel=1e-8)
    near = swing.at(np.array([0.0]), strengths * 1.01)
    assert abs(near.of("L")[0] - value.of("L")[0]) > 1e-5
    h = 1e-6
    ahead, behind = swing.at(np.array([-h]), strengths), swing.at(np.array([-3 * h]), strengths)
    slope = swing.at(np.array([-2 * h]), strengths).by_amplitude
    assert slope == pytest.approx((ahead.values - behind.values) / (2 * h), rel=1e-3, abs=1e-6)


def record(degrees, count, noise, seconds=20.0, w=3.0):
    t = np.linspace(0, seconds, count)
    force = lambda _, y: [y[1], -w * w * np.sin(y[0]) - 0.015 * y[1] - 0.02 * y[1] * abs(y[1])]  # noqa: E731
    x = solve_ivp(force, (0, seconds), [np.radians(degrees), 0.0], t_eval=t, rtol=1e-10, atol=1e-12).y[0]
    return t, x + noise * np.random.default_rng(degrees).standard_normal(count)


@pytest.mark.parametrize(
    ("degrees", "unit"), [(40, "rad"), (120, "deg"), pytest.param(175, "deg", marks=pytest.mark.slow)]
)
def test_a_pendulum_is_found_with_its_length_and_its_losses(degrees, unit):
    t, x = record(degrees, 1000, 1e-3)
    size = 1.0 if unit == "rad" else np.pi / 180
    answer = asy.identify({"t": t, "x": x / size}, unit=unit, laws=["1+2", "1+2+pendulum"])
    law = answer.law("1+2+pendulum").law
    assert law.verdict == "consistent"
    assert answer.law("1+2").law.verdict == "refuted"
    for interval, true in zip(law.epsilon, (0.005, 0.02 * size), strict=True):
        assert interval.stretched(1.5).contains(true)
        assert interval.high - interval.low < 0.4 * true
    note = next(note for note in answer.notes if "length g/omega_0^2 = " in note)
    assert float(note.split("omega_0^2 = ")[1].split()[0]) == pytest.approx(G / 9, rel=2e-3)


def test_it_is_a_candidate_by_default_for_angles_alone():
    names = [str(c) for c in default_candidates(True, angles=True)]
    assert {"1+pendulum", "1+2+pendulum", "0+1+2+3+pendulum"} <= set(names)
    assert not any("pendulum" in str(c) for c in default_candidates(True))
    assert not any("pendulum" in str(c) for c in default_candidates(False, angles=True))
    assert read_candidate("1+2+pendulum").formula() == "x'' + sin x + e1 x' + e2 x'|x'| = 0"


@pytest.mark.parametrize("law", ["free+pendulum", "1+s3+pendulum", "1,2:+pendulum", "pendulum"])
def test_what_it_cannot_be_joined_with_is_refused(law):
    with pytest.raises(InputError, match="argument laws"):
        read_candidate(law)


def test_a_pendulum_needs_angles():
    t = np.arange(600) / 9
    with pytest.raises(InputError, match="a pendulum needs angles"):
        asy.identify({"t": t, "x": np.exp(-t / 90) * np.cos(t)}, laws=["1+pendulum"])


LAWS = ["1", "2", "1+2", "free", "1+s3", "1+2+s3", "1+s3+s5", "free+s3", "1+pendulum", "2+pendulum", "1+2+pendulum"]


def swung(spring, degrees, seed):
    """60 s of an angle with viscous loss and the spring's own restoring force."""
    t = np.linspace(0, 60, 1500)
    force = lambda _, y: [y[1], -9 * spring(y[0]) - 0.06 * y[1]]  # noqa: E731
    x = solve_ivp(force, (0, 60), [np.radians(degrees), 0.0], t_eval=t, rtol=1e-10, atol=1e-12).y[0]
    return {"t": t, "x": x + 2e-3 * np.random.default_rng(seed).standard_normal(len(t))}


@pytest.mark.parametrize("degrees", [25, 60])
def test_a_free_spring_is_no_rival_of_the_sine(degrees):
    # failed before: "several laws are consistent: 1+pendulum; 1+s3+s5"
    answer = asy.identify(swung(np.sin, degrees, 4), unit="rad", laws=LAWS)
    assert answer.verdict.text.startswith("identified: 1+pendulum,")
    assert "s3 in place of sin x up to 0.1" in answer.verdict.text
    spring = next(a for a in answer.verdict.allowed if a.term.startswith("s3 "))
    assert 0.15 < spring.largest < 0.25  # sin x = x - x^3/6 + ...
    standing = [e.law for e in answer.laws if e.law.verdict == "consistent" and e.law.candidate.springs]
    assert standing
    assert all("contains 1+pendulum, which is consistent; not needed: " in law.reason for law in standing)
    assert not any("excludes" in law.reason for law in standing)


@pytest.mark.parametrize("cubic", [-0.12, 0.1])
def test_a_spring_that_is_no_sine_is_not_called_a_pendulum(cubic):
    answer = asy.identify(swung(lambda x: x + cubic * x**3, 60, 5), unit="rad", laws=LAWS)
    assert answer.law("1+pendulum").law.verdict == "refuted"
    assert answer.verdict.text.startswith("identified: 1+s3,")
    assert answer.law("1+s3").law.springs[0].contains(cubic)
