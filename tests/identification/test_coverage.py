"""Measured coverage: how often the interval holds the true strength, and the right law is among the consistent ones.

Each record has its own law, strengths, length and noise; amplitudes only (which is the harder case), no bootstrap.
"""

import numpy as np
import pytest

from asymptotics.identification.candidates import default_candidates, read_candidate
from asymptotics.identification.coefficients import swing_coefficients
from asymptotics.identification.comparison import fit_laws, judged, minimal
from asymptotics.identification.observations import Observations
from asymptotics.identification.quadrature import TooStrongError
from asymptotics.identification.synthetic import observed

LAWS = ("1", "2", "1,2", "0,1", "3/2")


def draw(index: int) -> tuple[str, list[float], Observations]:
    """A record: 20 to 150 swings, noise 1e-4 to 1e-2 of x0, amplitudes falling to between 0.2 and 0.6, times absent."""
    random = np.random.default_rng([12, index])
    law, swings = LAWS[index % len(LAWS)], int(random.integers(20, 151))
    noise, fall = 10 ** random.uniform(-4, -2), random.uniform(0.5, 1.6)
    candidate = read_candidate(law)
    first = [-float(swing_coefficients((e,), 1).L[0, 1]) for e in candidate.elements]
    share = random.uniform(0.3, 0.7)
    parts = [share, 1 - share] if len(first) == 2 else [1.0]
    strengths = [fall * part / (c * swings) for part, c in zip(parts, first)]
    if law == "0,1":
        strengths[0] *= 0.5  # dry friction ends the motion in finite time
    return law, strengths, observed(law, strengths, swings, noise, seed=index)


def measure(indices: range) -> tuple[int, int, int, int]:
    """(covered, intervals, right law consistent, records)."""
    covered = intervals = right = records = 0
    for index in indices:
        try:
            law, strengths, seen = draw(index)
        except TooStrongError:
            continue
        wanted = "free" if law == "3/2" else law
        laws = {str(f.candidate): f for f in judged(fit_laws(default_candidates(False), seen), growing=False)}
        records += 1
        right += laws[wanted].verdict == "consistent"
        chosen = {str(f.candidate) for f in minimal(list(laws.values()))}
        own = judged(fit_laws([read_candidate(law)], seen), growing=False, everything=True)[0]
        right_and_minimal = wanted in chosen
        assert own.profiled, (index, right_and_minimal)
        for interval, true in zip(own.epsilon, strengths, strict=True):
            covered, intervals = covered + interval.contains(true), intervals + 1
    return covered, intervals, right, records


def test_coverage_on_a_reduced_set():
    covered, intervals, right, records = measure(range(40))
    assert records >= 36
    assert right >= 0.95 * records - 1
    assert covered / intervals >= 0.85  # binomial: 0.95 within three standard errors of 56 intervals


@pytest.mark.slow
def test_coverage_on_a_thousand_records():
    covered, intervals, right, records = measure(range(1000))
    assert records >= 950
    assert 0.93 <= covered / intervals <= 0.97
    assert right / records >= 0.95
