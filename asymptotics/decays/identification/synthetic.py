"""Synthetic runs: turning points of a known law with known noise, for tests, coverage and planning an experiment.

>>> seen = observed("1", [0.02], 3, noise_x=0.0)
>>> seen.x.round(4)                                            # e^(-pi (epsilon/2)/sqrt(1 - epsilon^2/4)) each
array([ 1.    , -0.9691,  0.9391, -0.9101])
"""

from collections.abc import Sequence

import numpy as np

from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.forward.sequence import TurningSequence, turning_sequence
from asymptotics.decays.identification.measuring.observations import Observations


def exact(law: str, strengths: Sequence[float], swings: int, x0: float = 1.0) -> TurningSequence:
    """Noiseless turning points, in units of x0; TooStrongError if the motion ends before ``swings``."""
    candidate = read_candidate(law)
    scale = np.array([x0**e.weight for e in candidate.elements])
    return turning_sequence(candidate.swing(), swings, np.array([0.0, *(np.array(strengths) * scale)]))


def observed(
    law: str,
    strengths: Sequence[float],
    swings: int,
    noise_x: float,
    noise_t: float | None = None,
    *,
    seed: int = 0,
    x0: float = 1.0,
    offset: float = 0.0,
) -> Observations:
    """Signed turning points (and times) from x0, with noise as a fraction of x0 and in units of 1/omega_0."""
    run, random = exact(law, strengths, swings, x0), np.random.default_rng(seed)
    n = np.arange(swings + 1)
    x = offset + x0 * ((-1.0) ** n * np.exp(run.a) + noise_x * random.standard_normal(swings + 1))
    t = () if noise_t is None else run.tau + noise_t * random.standard_normal(swings + 1)
    return Observations.of(n, x, t)
