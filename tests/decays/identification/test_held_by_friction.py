"""Turning points whose last one friction held on the other side: dry friction and cubic drag, 15 half-swings."""

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.fitting.model import Model
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.sequence import turning_sequence
from asymptotics.decays.identification.measuring.observations import Observations
from tests.decays.identification.stopped import stopped

HELD = (
    0.11988, -0.11140, 0.10268, -0.09435, 0.08619, -0.07770, 0.06979, -0.06152, 0.05368, -0.04548, 0.03752, -0.02951,
    0.02167, -0.01356, 0.00567, 0.00220,
)  # fmt: skip
EDGE = np.array([-0.00254775, 0.03635976, 0.0682521, 0.00014882])
"""A law whose 16th amplitude is 2e-5 of a metre, after one of 7e-3: next to one that was fitted to these points, the
last one among them, and had 2e-8 there, for which an exact half-swing is no longer found."""


def test_the_held_point_is_left_out_and_the_law_is_found():
    """It was a fault of the program (exit code 70), by the exponent that was nearly that of dry friction."""
    answer = asy.identify({"n": np.arange(16), "x": np.array(HELD)}, unit="m", kind="turning-points")
    assert str(answer.best.law.candidate) == "0+3" and answer.best.law.verdict == "consistent"
    assert any("at rest" in note for note in answer.notes)


def test_what_was_fitted_can_be_asked_after_another_law_was(monkeypatch):
    """A guess from another law may lead out of the domain at its edge, and none is needed."""
    model = Model(read_candidate("free").swing(), Observations.of(range(16), HELD))
    model.swing.tolerance = 2e-5
    sizes = model.amplitudes(EDGE)[0]
    assert 0 < sizes[-1] < 2e-5

    def astray(swing, count, law, guess):
        if guess is not None:
            raise TooStrongError("no turning point follows on the other side")
        return turning_sequence(swing, count, law, guess)

    monkeypatch.setattr("asymptotics.decays.identification.fitting.model.turning_sequence", astray)
    with pytest.raises(TooStrongError):
        model.predict(EDGE)
    assert model.amplitudes(EDGE)[0] == pytest.approx(sizes, rel=1e-6)


def velocity_of(t):
    return stopped(t, 2.0, 5.0, {0: 0.3, 2: 0.06})[1]


def acceleration_of(t):
    x, v = stopped(t, 0.2, 6.0, {0: 0.06, 1: 0.1})
    a = -(36 * x + 0.06 * np.sign(v) + 0.1 * v)
    return np.where((v == 0) & (np.abs(x) < 0.01), 0.0, a)


@pytest.mark.parametrize(
    ("column", "made", "noise", "law", "strengths"),
    [
        ("v", velocity_of, 0.01, "0+2", (0.3 / 25, 0.06)),
        ("a", acceleration_of, 0.02, "0+1", (0.06 / 36, 0.1 / 6)),
    ],
)
def test_the_rest_of_a_velocity_and_of_an_acceleration_is_no_motion(column, made, noise, law, strengths):
    """With half a second of rest among the samples 0+1 was refuted, and a free exponent of 0.34 identified."""
    t = np.arange(0, 30, 0.04)
    values = made(t) + noise * np.random.default_rng(5).standard_normal(len(t))
    answer = asy.identify({"t": t, column: values}, laws=[law, "free"])
    assert answer.verdict.kind == "identified" and str(answer.best.law.candidate) == law
    assert all(e.contains(true) for e, true in zip(answer.best.law.epsilon, strengths))
    assert any("are not used" in note for note in answer.notes)
