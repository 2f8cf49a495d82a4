"""A resonance with its phases: the loss is F sin(phase), so that a drive far from omega_0 tells the law as well."""

import json
from fractions import Fraction
from functools import cache

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.ask.questions._damping_law import damping_law
from asymptotics.errors import InputError
from asymptotics.shell.main import main

TRUTH, FORCES, OMEGA = {1: "1/50", 2: "1/10"}, ("1/10", "1/5", "3/10", "1/2", "4/5", "5/4", "2", "3"), "4/5"


@cache
def driven(force):
    return asy.response(asy.Oscillator(TRUTH), force, OMEGA, digits=8)


def under(forces):
    """Certified amplitudes and phases at 4/5 of omega_0, where the spring takes nearly all of the force."""
    found = [driven(F) for F in forces]
    A, phase = (np.array([float(getattr(r, name)) for r in found]) for name in ("amplitude", "phase"))
    return {
        "A": A,
        "force": np.array([float(Fraction(F)) for F in forces]),
        "omega": np.full(len(A), 0.8),
        "phase": phase,
    }


@pytest.fixture(scope="module")
def measured():
    """Every third force."""
    return under(FORCES[::3])


def test_without_noise_the_law_is_that_which_was_driven(measured):
    A = measured["A"]
    table = {**measured, "resolution": 1e-6 * A, "phase_resolution": np.full(len(A), 1e-6)}
    own = damping_law(table, laws=["1+2"]).best
    assert [s.estimate for s in own.strengths] == pytest.approx([0.02, 0.1], rel=1e-3)
    lead = damping_law({**table, "phase": 0.9 * measured["phase"]}, laws=["1+2"]).best  # near miss
    assert abs(lead.strengths[0].estimate / 0.02 - 1) > 0.02


def noisy(measured, rng):
    """A hundredth of each amplitude, and 0.002 rad, with their resolutions."""
    size = len(measured["A"])
    s, lag = 0.01 * measured["A"], np.full(size, 0.002)
    A, phase = measured["A"] + s * rng.standard_normal(size), measured["phase"] + lag * rng.standard_normal(size)
    return {**measured, "A": A, "resolution": s, "phase": phase, "phase_resolution": lag}


def width(law):
    """Of the interval of the second strength."""
    return law.strengths[1].high - law.strengths[1].low


@pytest.mark.parametrize(("count", "least"), [(8, 13), pytest.param(60, 106, marks=pytest.mark.slow)])
def test_intervals_cover_and_are_a_third_of_those_of_amplitudes_alone(count, least):
    """Two intervals of 95 % in each table: ``least`` is three standard errors off."""
    rng, covered, own, alone, measured = np.random.default_rng(391), 0, [], [], under(FORCES)
    for _ in range(count):
        seen = noisy(measured, rng)
        law = damping_law(seen, laws=["1+2"]).law("1+2")
        covered += sum(e.low <= b <= e.high for e, b in zip(law.strengths, (0.02, 0.1)))
        own.append(width(law))
        try:
            bare = {n: c for n, c in seen.items() if not n.startswith("phase")}
            alone.append(width(damping_law(bare, laws=["1+2"]).law("1+2")))
        except InputError:  # the spring takes more than the force, by the noise
            alone.append(np.inf)
    assert covered >= least and 3 * np.median(own) < np.median(alone)


def test_an_export_holds_the_phases_and_is_fitted_again(measured, tmp_path, capsys):
    seen = noisy(measured, np.random.default_rng(392))
    rows = zip(*(seen[name] for name in seen))
    (tmp_path / "t.csv").write_text("\n".join([",".join(seen), *(",".join(map(repr, map(float, r))) for r in rows)]))
    law = tmp_path / "law.csv"
    assert main(["identify", str(tmp_path / "t.csv"), "--laws", "1+2", "2"]) == 0  # it is a kind of identify
    assert main(["damping", "--from", str(tmp_path / "t.csv"), "--laws", "1+2", "2", "--csv", str(law)]) == 0
    assert "--phase=" in law.read_text() and "--phase_resolution=" in law.read_text()
    capsys.readouterr()
    assert main(["compare", str(law), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["rows"] and all(float(r["digits"]) > 12 or float(r["given"]) == 0 for r in found["rows"])


def test_degrees_and_a_phase_that_cannot_be_weighed(measured):
    own = damping_law(measured, laws=["1+2"])
    degrees = {**measured, "phase [deg]": np.degrees(measured["phase"])}
    del degrees["phase"]
    again = damping_law(degrees, laws=["1+2"])
    assert [s.estimate for s in again.best.strengths] == pytest.approx(
        [s.estimate for s in own.best.strengths], rel=1e-9
    )
    assert any("degrees" in note for note in again.notes)
    some = {n: c[-3:] for n, c in measured.items()}
    near = {**some, "omega": np.full(3, 1.0), "A": np.sqrt(some["force"])}
    told = damping_law({**near, "resolution": 0.01 * near["A"]}, laws=["1", "2"]).notes
    assert any("not used: phase, beside which no phase_resolution stands" in note for note in told)


@pytest.mark.parametrize("bad", [0.0, -0.3, 3.2, float("nan")])
def test_a_phase_that_no_loss_makes_is_refused_by_name(measured, bad):
    phase = measured["phase"].copy()
    phase[2] = bad
    with pytest.raises(InputError, match="argument phase: .* row 3"):
        damping_law({**measured, "phase": phase}, laws=["1"])
