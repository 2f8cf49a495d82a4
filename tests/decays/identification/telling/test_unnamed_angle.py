"""A pendulum whose file names no unit is told what its spring says."""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import asymptotics as asy


def hard(x):
    return x - 0.25 * x**3


@pytest.mark.parametrize(
    ("size", "unit", "restoring", "told"),
    [
        (1.0, "", np.sin, "in rad"),
        (180 / np.pi, "", np.sin, "in deg"),
        (1.0, "rad", np.sin, ""),  # the pendulum is tried
        (1.0, "", hard, ""),  # near miss: another spring
    ],
)
def test_a_pendulum_without_a_unit(size, unit, restoring, told):
    t = np.arange(0, 25, 0.04)
    made = solve_ivp(
        lambda _, y: [y[1], -16 * restoring(y[0]) - 0.05 * y[1]],
        (0, 40),
        [0.7, 0],
        t_eval=t,
        rtol=1e-10,
        atol=1e-12,
        method="DOP853",
    )
    x = size * (made.y[0] + 1e-3 * np.random.default_rng(2).standard_normal(len(t)))
    answer = asy.identify({"t": t, "x": x}, **({"unit": unit} if unit else {}), laws=["1+s3", "1+s3+s5"])
    assert str(answer.best.law.candidate) in ("1+s3", "1+s3+s5") and answer.best.law.verdict == "consistent"
    notes = [note for note in answer.notes if "of a pendulum" in note]
    assert len(notes) == bool(told)
    assert all(told in note and "--unit" in note for note in notes)
