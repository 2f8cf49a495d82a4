"""What a reader is told before any table: words, equation, strengths with units, shares, and Q by whatever is known."""

import json
from fractions import Fraction

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.judging.grades import in_words as graded
from asymptotics.decays.identification.judging.grades import off
from asymptotics.decays.identification.synthetic import exact
from asymptotics.decays.identification.telling.agreement import agreed
from asymptotics.decays.identification.telling.equivalents import half_life, spring_ratios
from asymptotics.decays.identification.telling.in_words import law_in_words
from asymptotics.decays.identification.telling.record_units import RecordUnits, unit_of_strength
from tests.decays.identification import small_laws
from tests.decays.identification.small_laws import SURE


def decay(law, strengths, swings=40, noise=1e-4, **more):
    """Turning points and times, in s where omega_0 = 2."""
    run, n = exact(law, strengths, swings), np.arange(swings + 1)
    x = (-1.0) ** n * np.exp(run.a) + noise * np.random.default_rng(1).standard_normal(swings + 1)
    return {"n": n, "x": x, "tau": run.tau / 2} | more


@pytest.mark.parametrize(
    ("text", "springs", "alpha", "words"),
    [
        ("1+2+s3", [-0.1], None, "viscous drag and drag in v^2, softening spring"),
        ("0+1+2", [], None, "dry friction, viscous drag and drag in v^2"),
        ("3+s3", [0.2], None, "cubic drag, hardening spring"),
        ("free", [], 1.4512, "drag in v^1.45"),
        ("1+pendulum", [], None, "viscous drag, pendulum"),
        ("1,2:", [], None, "drag in |x|^2 v"),
        ("2+s3+s5", [0.1, 0.1], None, "drag in v^2, springs in x^3 and x^5"),
    ],
)
def test_a_law_in_words(text, springs, alpha, words):
    ends = tuple(Interval(0.9 * c, c, 1.1 * c) if c > 0 else Interval(1.1 * c, c, 0.9 * c) for c in springs)
    found = None if alpha is None else Interval(1.4, alpha, 1.5)
    assert law_in_words(small_laws.law(text, springs=ends, alpha=found)) == words


def test_a_spring_that_may_be_none_is_neither_hard_nor_soft():
    law = small_laws.law("1+s3", springs=(Interval(-0.1, 0.1, 0.3),))
    assert law_in_words(law) == "viscous drag, spring in x^3"


def test_units_follow_the_scaled_equation():
    told = [unit_of_strength(a, m, "rad", False) for a, m in ((0, 0), (1, 0), (2, 0), (3, 0), (1, 2))]
    assert told == ["rad/s^2", "1/s", "1/rad", "s/rad^2", "1/(rad^2 s)"]
    assert unit_of_strength(3, 0, "m", True) == "kg s/m^2"
    epsilon = Interval(0.04, 0.05, 0.06)
    name, ends, unit = RecordUnits("cm", 0.01, None, None, 3.0).beside(2.0, 0, epsilon)
    assert (name, unit) == ("b/m", "1/m") and ends.estimate == pytest.approx(5.0)
    name, ends, unit = RecordUnits("", 1.0, None, None, 3.0).beside(2.0, 0, epsilon)
    assert (name, unit, ends.estimate) == ("b/m", "1/(unit of x)", pytest.approx(0.05))
    assert RecordUnits("", 1.0, None, None, None).beside(2.0, 0, epsilon) is None


def test_each_law_of_the_verdict_has_its_equation_its_strengths_and_their_shares():
    answer = asy.identify(decay("1+2", [0.02, 0.04]), laws=["1", "1+2", "2"], bootstrap=False, unit="m")
    head, viscous, quadratic, q, bare = answer.lines
    assert head == "1+2: viscous drag and drag in v^2; x'' + x + e1 x' + e2 x'|x'| = 0"
    assert viscous.startswith("  1: b/m = 0.0") and " 1/s, " in viscous and "(SI)" not in "".join(answer.lines)
    # zeta = 0.01 + (4/(3 pi)) 0.04 A: 37 % at A = 1.
    assert "37 % of the loss at 1 m" in viscous and "63 % of the loss at 1 m" in quadratic and " 1/m, " in quadratic
    assert q.startswith("  Q = 18.5 at 1 m") and bare.startswith("envelope, before any law: period 3.14")
    card = answer._repr_html_()
    assert "viscous drag and drag in v" in card and "1: b/m = 0.04 " in card and "envelope, before any law" in card


def test_all_laws_of_an_open_verdict_say_q_together():
    data = decay("1", [0.02], swings=12, noise=0.02)
    answer = asy.identify(data, laws=["1", "2", "0"], bootstrap=False)
    laws = [str(law.law.candidate) for law in answer.of_the_verdict]
    assert len(laws) > 1 and "identified" not in answer.verdict.kind
    found = json.loads(json.dumps(answer.to_dict()))["agreed"]
    assert found["laws"] == laws
    first, middle, last = ([float(row[k]) for k in ("low", "high")] for row in found["quality"])
    # In the middle of the record they agree, and with the truth: Q = 50, whichever law it is.
    assert 45 < middle[0] < middle[1] < 55 and all(middle[1] - middle[0] < 0.2 * (b - a) for a, b in (first, last))
    assert 25 < float(found["half_life"]["low"]) < float(found["half_life"]["high"]) < 40
    assert "both laws say: Q = 47.6 to 57 at" in answer.lines[-2] and answer.quality_in_words == answer.lines[-2]
    one = answer.laws[:1]
    assert agreed([law.law for law in one], answer.units) is None


@pytest.mark.parametrize(("alpha", "spring"), [(1, "1/2"), (2, "1/2"), (1, "-1/3"), (0, "1/2")])
def test_beside_a_spring_the_ratio_and_the_half_life_are_the_certified_ones(alpha, spring):
    row = asy.damping({alpha: "1/50"}, "1/2", spring={3: spring}, motion=False, digits=8).rows[0].first
    zeta, rate = spring_ratios([(float(alpha), 0, 0.02)], [(3, float(Fraction(spring)))])
    assert float(zeta(0.5)) == pytest.approx(float(row.zeta), rel=1e-6)
    assert half_life(rate, 0.5) == pytest.approx(float(row.half_life), rel=1e-4)


def test_the_envelope_tells_times_in_the_unit_of_the_file(tmp_path):
    t = np.arange(0, 25, 0.1)
    x = np.exp(-0.05 * t) * np.cos(2 * t) + 1e-4 * np.random.default_rng(0).standard_normal(len(t))
    found = {}
    for unit, size in (("s", 1.0), ("ms", 1e3), ("min", 1 / 60)):
        file = tmp_path / f"{unit}.csv"
        file.write_text(f"t ({unit}),x\n" + "\n".join(f"{size * a!r},{b!r}" for a, b in zip(t.tolist(), x.tolist())))
        found[unit] = asy.identify(file, laws=["1"], bootstrap=False).to_dict()["envelope"]
        assert found[unit]["time_unit"] == unit
        assert float(found[unit]["period"]["estimate"]) == pytest.approx(np.pi * size, rel=1e-3)
        assert float(found[unit]["half_life"]["estimate"]) == pytest.approx(np.log(2) / 0.05 * size, rel=0.02)
    assert found["s"]["quality"] == found["ms"]["quality"]


def test_of_several_runs_each_envelope_is_told_by_its_name():
    runs = [decay("1", [0.02], noise=1e-4 * k) for k in (1, 2)]
    answer = asy.identify(runs, laws=["1", "2"], bootstrap=False)
    assert answer.lines[0].startswith("1: viscous drag") and "b/m = 0.04" in answer.lines[1]
    assert sum("envelope, before any law" in line for line in answer.lines) == 2
    assert answer.lines[-1].startswith(f"{answer.runs[1].name}: envelope")


def test_a_share_is_told_in_plain_words_and_never_above_the_whole():
    assert (graded("adequate", 0.0), graded("adequate", 0.02)) == (
        "consistent with the loss",
        "adequate to 2 % of the loss",
    )
    assert off(0.32) == "32 % off on average" and "%" not in off(1.3e5)
    assert small_laws.law("1", epsilon=(SURE,)).graded == "consistent"


def test_an_envelope_without_times_begins_with_what_it_has():
    x = (-1.0) ** np.arange(12) * np.exp(-0.05 * np.arange(12))
    answer = asy.identify({"n": np.arange(12), "x": x}, laws=["1"], bootstrap=False)
    assert any(line.startswith("envelope, before any law: Q = ") for line in answer.lines)
