"""A resonance as a table of the judge of decays: certified responses with noise, and the same law from a decay."""

from fractions import Fraction

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.resonance_table import as_losses
from asymptotics.errors import InputError

TRUTH = {1: "1/50", 2: "1/10"}
FORCES = ("1/100", "1/50", "3/100", "1/20", "2/25", "1/8", "1/5", "3/10")


def resonance(law, omega, units=None, forces=FORCES):
    """Certified amplitudes under the forces, at a frequency."""
    osc = asy.Oscillator(law, **(units or {}))
    amplitudes = [float(asy.response(osc, F, omega, digits=8).amplitude) for F in forces]
    return np.array(amplitudes), np.array([float(Fraction(F)) for F in forces])


BOTH = {"params": [1, "49/50"], "ids": ["at omega_0", "beside it"]}


@pytest.fixture(scope="module", **BOTH)
def every(request):
    A, F = resonance(TRUTH, request.param)
    return A, F, np.full(len(A), 1.0 if request.param == 1 else 0.98)


@pytest.fixture(scope="module", **BOTH)
def measured(request):
    """Under every third force."""
    A, F = resonance(TRUTH, request.param, forces=FORCES[1::3])
    return A, F, np.full(len(A), 1.0 if request.param == 1 else 0.98)


@pytest.mark.slow
def test_intervals_cover_the_law_that_was_driven(every):
    """60 tables with noise of 1 in 100: 95 % intervals cover in 86 to 100 of 100 (three standard errors of 60)."""
    A, F, omega = every
    rng, covered, consistent, refuted = np.random.default_rng(39), 0, 0, 0
    for _ in range(60):
        s = 0.01 * A
        seen = A + s * rng.standard_normal(len(A))
        found = asy.damping_law({"A": seen, "force": F, "omega": omega, "resolution": s}, laws=["1+2", "3"])
        own = found.law("1+2")
        covered += sum(e.low <= b <= e.high for e, b in zip(own.strengths, (0.02, 0.1)))
        consistent += own.grade == "consistent"
        refuted += found.law("3").grade == "refuted"
    assert covered / 120 > 0.89 and consistent / 60 > 0.86
    assert refuted == 60  # near miss: another law


def test_the_error_of_zeta_is_that_of_the_law_at_another_amplitude(measured):
    """zeta less that of the law at the place, as A moves: its slope by a difference, within the parabola's error."""
    A, F, omega = measured
    step = 1e-4

    def beyond(A):
        places, zeta, _, _ = as_losses({"amplitude": A, "force": F, "omega": omega}, None, None, None)
        return zeta - 0.02 / 2 - 0.1 * 4 / (3 * np.pi) * places

    _, _, spread, _ = as_losses({"amplitude": A, "force": F, "omega": omega}, 0.01 * A, None, None)
    true = abs(beyond(A * (1 + step)) - beyond(A)) / step * 0.01
    assert np.allclose(spread, true, rtol=0.1)


def test_the_amplitudes_are_brought_to_first_order(measured):
    """Without noise the law comes out as it was driven; by first order alone it is off by what the harmonics add."""
    A, F, omega = measured
    table = {"A": A, "force": F, "omega": omega, "resolution": 1e-5 * A}
    found = asy.damping_law(table, laws=["1+2"])
    off = [abs(s.estimate / b - 1) for s, b in zip(found.best.strengths, (0.02, 0.1))]
    places, zeta, _, _ = as_losses({"amplitude": A, "force": F, "omega": omega}, None, None, None)
    first = asy.damping_law({"A": places, "zeta": zeta, "resolution": 1e-5 * zeta}, laws=["1+2"])
    alone = [abs(s.estimate / b - 1) for s, b in zip(first.best.strengths, (0.02, 0.1))]
    assert max(off) < max(alone) / 5 and "next harmonics" in " ".join(found.notes)


def test_a_decay_and_a_resonance_have_one_law_and_another_drag_is_refuted():
    units = {"mass": "1/5", "stiffness": "16/5"}
    osc = asy.Oscillator({2: "1/5"}, **units, x0="1/5")
    decay = asy.turning_points(osc, 30, digits=12)
    table = {"n": [p.n for p in decay.points], "A": [abs(float(p.x)) for p in decay.points]}
    A, F = resonance({2: "1/5"}, 4, units, FORCES[1::3])
    laws, given = ["1", "2", "3"], {"mass": "1/5", "stiffness": "16/5"}
    free = asy.damping_law({**table, "resolution": [1e-4 * a for a in table["A"]]}, laws=laws, **given)
    driven = asy.damping_law({"A": A, "force": F, "resolution": 1e-3 * A}, laws=laws, **given)
    assert free.best.name == driven.best.name == "2"
    (a,), (b,) = free.best.strengths, driven.best.strengths
    assert abs(a.estimate / 0.2 - 1) < 5e-3 and b.low < 0.2 < b.high
    # A decay of another law: its drag, at the forces, is not what drove.
    assert driven.law("1").grade == driven.law("3").grade == "refuted"
    other = asy.damping_law({"A": A, "force": F * 1.05, "resolution": 1e-3 * A}, laws=laws, **given)
    assert not other.best.strengths[0].low < 0.2 < other.best.strengths[0].high


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"A": [1, 2], "force": [1, -1]}, "force"),
        ({"A": [1.0, 2.0, 3.0], "force": [1, 1, 1], "omega": [2, 2, 2]}, "force"),
    ],
)
def test_what_no_force_could_drive_is_refused(given, said):
    with pytest.raises(InputError) as error:
        asy.damping_law({**given, "resolution": [0.01] * len(given["A"])}, laws=["1"])
    assert error.value.argument == said


def test_other_columns_are_not_used_and_the_file_can_be_asked_again(tmp_path):
    found = asy.damping_law({"A": [0.1, 0.2, 0.4], "zeta": [0.01, 0.02, 0.04], "force": [1, 2, 3]}, laws=["2"])
    assert any("not used: force" in note for note in found.notes)
