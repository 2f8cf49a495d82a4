"""Records that lead a search astray: no warning, no line of LAPACK, no amplitude far outside the data, no odd words."""

import re
import warnings
from dataclasses import replace

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.fitting.least_squares import predicted_at
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.judging.judgement import outside
from asymptotics.decays.identification.measuring.demodulation import demodulated
from asymptotics.decays.identification.sources import load
from asymptotics.decays.identification.telling.runs import common, verdict_of_runs
from asymptotics.errors import InputError

LAWS = ["1", "0+2", "free", "2+s3", "1+s3+s5"]


def stopped():
    """Comes to rest exactly; the second half is one number (LAPACK wrote DLASCL)."""
    t = np.arange(616) / 56
    return t, np.maximum(1 - 0.5 * t, 0) * np.cos(2 * np.pi * t) + 5


def growing():
    """A cost that leaves the doubles in the search."""
    t = np.arange(300) / 30
    return t, np.cos(2 * np.pi * t) * np.exp(0.3 * t)


def coarse():
    t = np.arange(200) / 20
    return t, np.round(np.exp(-0.3 * t) * np.cos(2 * np.pi * t) / 0.3) * 0.3


def released_thrice():
    """Three releases of another size in noise, which no search for releases divides."""
    t, random = np.arange(300) / 12, np.random.default_rng(4)
    size = np.where(t < 8, np.exp(-0.1 * t), np.where(t < 16, 0.8 * np.exp(-0.1 * (t - 8)), np.exp(-0.1 * (t - 16))))
    return t, 17 * size * np.cos(2 * np.pi * t) + 2 * random.standard_normal(len(t))


def tiny():
    t = np.arange(240) / 24
    return t, 1e-40 * np.exp(-0.2 * t) * np.cos(2 * np.pi * t)


@pytest.mark.parametrize("made", [stopped, growing, coarse, released_thrice, tiny])
def test_nothing_reaches_the_terminal_and_no_amplitude_lies_far_outside(made, capfd):
    t, x = made()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            answer = asy.identify({"t": t, "x": x}, laws=LAWS)
        except InputError:
            return
        found = answer.to_dict()
        said = "\n".join([answer.verdict.text, *answer.lines, *answer.notes, answer.table()])
    assert capfd.readouterr() == ("", "")
    largest = 1.5 * max(float(np.ptp(x)) / 2, float(np.abs(x).max()))
    told = [float(a) for a in (found["equivalent"] or {}).get("amplitudes", [])]
    for entry in ("envelope", "agreed"):
        told += [float(row["amplitude"]) for row in (found[entry] or {}).get("quality", [])]
    told += [abs(float(run["first"])) for run in found["data"]]
    assert told and max(told) <= largest
    assert "apart: \n" not in said and " 0 laws" not in said
    assert all(float(share) <= 100 for share in re.findall(r"([\d.e+]+) % (?:off|of the loss)", said))


def wild_fit():
    """The fit of a decay, and the same moved to amplitudes e^2 times as large."""
    t = np.arange(240) / 20
    x = np.exp(-0.1 * t) * np.cos(2 * np.pi * t) + 3e-3 * np.random.default_rng(1).standard_normal(len(t))
    answer = asy.identify({"t": t, "x": x}, laws=["1", "2"])
    return answer, answer.law("1").law


def test_a_law_far_outside_the_data_is_no_result_on_any_path():
    answer, law = wild_fit()
    theta = law.fit.theta + np.array([2.0, *[0.0] * (len(law.fit.theta) - 1)])
    fit = replace(law.fit, theta=theta)
    assert outside(law.fit) == "" and "far outside the data" in outside(fit)
    wild = replace(law, fitted=replace(law.fitted, fit=fit)).with_evidence(outside=outside(fit))
    # Several runs: one of them has found another motion, so that there is no common law, and it refutes none.
    both = [[law, answer.law("2").law], [wild, answer.law("2").law]]
    (found, _) = common(both)
    assert found.verdict == "undetermined" and "in 1 of 2 runs its amplitude" in found.reason
    assert verdict_of_runs([answer.verdict] * 2, [found]).kind == "too short or too noisy"


def test_turning_points_beyond_the_samples_are_not_measured():
    t = np.arange(13, 200) / 20
    x = np.exp(-0.1 * t) * np.cos(2 * np.pi * t) + 1e-2 * np.random.default_rng(1).standard_normal(len(t))
    (seen,) = load({"t": t, "x": x})
    assert seen.samples is not None and not seen.inside[0] and seen.inside[1]
    assert seen.reference == abs(seen.x[1]) == seen.sizes[0]
    # A step of the samples more is not beyond what they tell.
    assert (seen.inside == ((seen.t >= t[0] - 0.05) & (seen.t <= t[-1] + 0.05))).all()


def test_a_wild_line_is_continued_by_a_factor_e_at_most():
    t = np.arange(0.0, 12.0, 0.25)
    x = np.exp(-3.0 * np.minimum(t, 1.0)) * np.cos(2 * np.pi * t)
    line = demodulated(t, x, 1.0)
    _, _, values, inside = line.turning_points()
    assert np.abs(values[~inside]).max() <= 1.01 * np.e * np.abs(line.at(np.linspace(t[0], t[-1], 999))[0]).max()


def test_what_leaves_the_doubles_is_refused_before_linear_algebra():
    _, law = wild_fit()
    far = law.fit.theta.copy()
    assert np.isfinite(predicted_at(law.fit.model, far)[0]).all()
    far[0] = 400.0
    with pytest.raises(TooStrongError):
        predicted_at(law.fit.model, far)
