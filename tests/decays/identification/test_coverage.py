"""Measured coverage: how often the interval holds the true strength, and the right law is among the consistent ones.

Each record has its own law, strengths, length and noise; amplitudes only (which is the harder case), no bootstrap.
"""

from dataclasses import dataclass

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.forward.coefficients import swing_coefficients
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.judging.judgement import rivals
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.synthetic import observed

LAWS = ("1", "2", "1+2", "0+1", "3/2")


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
    if law == "0+1":
        strengths[0] *= 0.5  # dry friction ends the motion in finite time
    return law, strengths, observed(law, strengths, swings, noise, seed=index)


@dataclass
class Counts:
    """What was found in all records together."""

    records: int = 0
    intervals: int = 0
    covered: int = 0
    consistent: int = 0
    won: int = 0
    wrongly_identified: int = 0
    supersets: int = 0
    supersets_refuted: int = 0

    def add(self, law: str, strengths: list[float], answer: asy.Identification) -> None:
        """One more record, whose law is known."""
        wanted = "free" if law == "3/2" else law
        found = answer.law(wanted).law
        pairs = list(zip(found.epsilon, strengths, strict=True))
        if found.alpha is not None:
            pairs.append((found.alpha, 1.5))
        self.records += 1
        self.intervals += len(pairs)
        self.covered += sum(interval.contains(true) for interval, true in pairs)
        self.consistent += found.verdict == "consistent"
        named = [str(other.candidate) for other in rivals([entry.law for entry in answer.laws])[0]]
        self.won += answer.verdict.kind == "identified" and named == [wanted]
        self.wrongly_identified += answer.verdict.kind == "identified" and named != [wanted]
        larger = [entry.law for entry in answer.laws if found.candidate.is_within(entry.law.candidate)]
        self.supersets += len(larger)
        self.supersets_refuted += sum(other.verdict == "refuted" for other in larger)


def measure(indices: range) -> Counts:
    """The whole way for each record, without the bootstrap."""
    counts = Counts()
    for index in indices:
        try:
            law, strengths, seen = draw(index)
        except TooStrongError:
            continue
        counts.add(law, strengths, asy.identify(seen, bootstrap=False))
    return counts


def test_coverage_on_a_reduced_set():
    found = measure(range(25))  # each of the five laws five times
    assert found.records >= 22
    assert found.consistent >= 0.95 * found.records - 1
    assert found.covered / found.intervals >= 0.84  # binomial: 0.95 within three standard errors of 40 intervals
    assert found.wrongly_identified <= 1
    assert found.supersets_refuted <= 0.01 * found.supersets


@pytest.mark.slow
def test_coverage_on_a_thousand_records():
    found = measure(range(1000))
    print(found)
    assert found.records >= 950
    assert 0.93 <= found.covered / found.intervals <= 0.97, found
    assert found.consistent / found.records >= 0.95, found
    assert found.wrongly_identified / found.records <= 0.02, found
    assert found.supersets_refuted / found.supersets <= 0.01, found
