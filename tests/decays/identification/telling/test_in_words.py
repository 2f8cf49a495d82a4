"""What identify says of Q and the half-life, against the certified first order of the true law."""

import json
import re
from fractions import Fraction

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.forward.coefficients import loss
from asymptotics.decays.identification.forward.pendulum import PendulumHalfSwing, angle
from asymptotics.decays.identification.forward.sequence import turning_sequence
from asymptotics.decays.identification.telling.equivalents import equivalent_ratio, half_life, pendulum_ratios
from asymptotics.decays.identification.telling.in_words import in_words


@pytest.fixture(scope="module")
def answer():
    points = asy.turning_points({1: "1/100", 2: "1/20"}, 40, digits=12, times=True).points
    x = np.array([float(p.x) for p in points]) + 1e-5 * np.random.default_rng(0).standard_normal(40)
    record = {"n": np.arange(40), "x": x, "t": [float(p.tau) / 2 for p in points]}
    return asy.identify(record, laws=["1", "1+2"], bootstrap=False)


def test_the_words_are_those_of_the_true_law(answer):
    last = answer.to_dict()["equivalent"]["amplitudes"][1]
    rows = [r.first for r in asy.damping({1: "1/100", 2: "1/20"}, [1, last], motion=False, digits=8).rows]
    found = answer.to_dict()["equivalent"]
    assert [float(q) for q in found["Q"]] == pytest.approx([float(r.Q) for r in rows], rel=1e-3)
    assert float(found["half_life"]) == pytest.approx(float(rows[0].half_life) / 2, rel=1e-3)  # omega_0 = 2
    assert float(found["half_life"]) != pytest.approx(float(rows[1].half_life) / 2, rel=0.1)
    assert found["half_life_unit"] == "s" and answer.in_words.startswith(
        "Q = 19.1 at 1, 56.1 at 0.184; half-life 17.5 s"
    )
    assert json.dumps(found) and answer.in_words in answer._repr_html_()


@pytest.mark.parametrize(("key", "alpha", "m"), [(0, 0.0, 0), ("3/2", 1.5, 0), ((1, 2), 1.0, 2)], ids=str)
def test_the_ratio_and_the_half_life_are_the_certified_ones(key, alpha, m):
    row = asy.damping({key: "1/10"}, "1/2", motion=False, digits=10).rows[0].first
    zeta = equivalent_ratio([(alpha, m, 0.1)])
    assert float(zeta(0.5)) == pytest.approx(float(row.zeta), rel=1e-9)
    assert half_life(zeta, 0.5) == pytest.approx(float(row.half_life), rel=1e-4)


@pytest.mark.parametrize(("key", "alpha"), [(0, 0.0), (1, 1.0), ("3/2", 1.5)])
@pytest.mark.parametrize("amplitude", [Fraction(1, 2), Fraction(13, 5)])
def test_beside_a_pendulum_the_ratio_and_the_half_life_are_the_certified_ones(key, alpha, amplitude):
    row = asy.damping({key: "1/50"}, str(amplitude), spring="pendulum", motion=False, digits=8).rows[0].first
    degree = np.pi / 180
    for unit, epsilon in ((1.0, 0.02), (degree, 0.02 * degree ** (alpha - 1))):
        zeta, rate = pendulum_ratios([(alpha, 0, epsilon)], unit)
        A = float(amplitude) / unit
        assert float(zeta(A)) == pytest.approx(float(row.zeta), rel=1e-6)
        assert half_life(rate, A) == pytest.approx(float(row.half_life), rel=1e-4)


def test_a_pendulum_is_told_by_its_own_formula():
    # the linear spring's says 50 at the first amplitude
    swing = PendulumHalfSwing([loss(1.0)], 2.6)
    run = turning_sequence(swing, 19, np.array([0.0, 0.02]))
    size, _ = angle(2 * np.sin(1.3) * np.exp(run.a), 1.0)
    record = {"n": np.arange(20), "x": size, "tau": run.tau}
    answer = asy.identify(record, laws=["1+pendulum"], unit="rad", bootstrap=False)
    assert answer.in_words.startswith("Q = 41.2 at 2.6 rad")


def test_nothing_is_said_where_nothing_is_known():
    assert in_words(None, "m") == ""
    swings = {"amplitudes": [1.0, 0.5], "Q": [10.0, 20.0], "half_life": np.inf, "half_life_unit": "swings"}
    assert in_words(swings, "deg") == "Q = 10 at 1 deg, 20 at 0.5 deg (first order)"


def test_each_strength_of_a_sum_is_named_as_in_the_law():
    n = np.arange(25)
    answer = asy.identify({"n": n, "x": (-0.95) ** n}, laws=["1", "1+2"], bootstrap=False)
    strengths = {row[0]: row[-1] for row in (law.row() for law in answer.laws)}
    assert re.fullmatch(r"1: \S+ \[.*\]  2: \S+ \[.*\]", strengths["1+2"]) and ":" not in strengths["1"]
