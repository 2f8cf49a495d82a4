"""A swing or two in samples, and what does not swing: period and Q are told, or it is refused with the true reason."""

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.measuring import few_swings as module
from asymptotics.decays.identification.measuring.few_swings import of_a_short_record, swings
from asymptotics.decays.identification.sources import load
from asymptotics.decays.identification.telling.envelope import envelope
from asymptotics.errors import InputError

S = np.linspace(0, 1, 120)
Q = 8.0


def swing(periods, phase=0.0, noise=0.01, seed=1, rate=np.pi / Q):
    """``periods`` of viscous drag, from any phase on."""
    wave = np.exp(-rate * periods * S) * np.cos(2 * np.pi * periods * S + phase)
    return wave + noise * np.random.default_rng(seed).standard_normal(len(S))


def told(x, t=S, **more):
    return asy.identify({"t": t, "x": x}, laws=["1", "2"], **more).to_dict()


@pytest.mark.parametrize("phase", [0.0, 1.0, 2.5])
@pytest.mark.parametrize("periods", [1.0, 1.25])
def test_a_swing_has_its_period_and_quality_and_tells_no_law(periods, phase):
    """Failed before: "no oscillation above its noise", or one of two laws identified."""
    found = told(swing(periods, phase))
    assert found["verdict_kind"] == "undecided" and "periods tell no law from another" in found["verdict"]
    assert all(law["verdict"] == "undetermined" for law in found["laws"])
    bare = found["envelope"]
    assert bare["law_known"] is False and found["envelope_untold"] is None
    low, high = (float(bare["period"][k]) for k in ("low", "high"))
    assert low <= 1 / periods <= high < 1.06 * low
    for row in bare["quality"]:
        assert float(row["low"]) <= Q <= float(row["high"] or np.inf)
    middle = bare["quality"][1]
    assert float(middle["high"]) < 2.5 * float(middle["low"])  # wide, and still an answer
    life = bare["half_life"]
    assert float(life["low"]) <= np.log(2) / (np.pi / Q * periods) <= float(life["high"] or np.inf)


def still(name):
    """What does not swing, or not beyond doubt."""
    noise = np.random.default_rng(7).standard_normal(len(S))
    return {
        "overdamped": np.exp(-3 * S) - 1.3 * np.exp(-12 * S) + 0.01 * noise,
        "critical": (1 + 20 * S) * np.exp(-20 * S) + 0.003 * noise,
        "noise": noise,
        "walk": np.cumsum(noise),
        "half a period": swing(0.5, 0.4),
    }[name]


@pytest.mark.parametrize("name", ["overdamped", "critical", "noise", "walk", "half a period"])
def test_what_does_not_swing_is_refused_with_the_true_reason(name):
    """Failed before: periods of 0.2 to 0.8 and laws of it, a LinAlgError, or another reason."""
    with pytest.raises(InputError, match="no swing beyond doubt: a motion without a turn, or noise"):
        told(still(name))


@pytest.mark.parametrize("rounds", [1, pytest.param(12, marks=pytest.mark.slow)])
def test_noise_of_any_memory_and_creeping_motions_never_swing(rounds):
    random, found = np.random.default_rng(20261127), []
    for _ in range(rounds):
        noise = random.standard_normal(len(S))
        p, q = random.uniform(1, 20, 2)
        found += [swings(S, y) for y in (noise, np.cumsum(noise), np.exp(-p * S) - np.exp(-q * S) + 0.003 * noise)]
    assert found == [None] * 3 * rounds


@pytest.mark.parametrize("count", [10, pytest.param(60, marks=pytest.mark.slow)])
def test_period_and_quality_of_a_swing_are_covered(count):
    hits = []
    for seed in range(count):
        line, periods = swings(S, swing(1.2, seed, seed=seed))
        fall = line.fall(float(line.size(np.array([0.5]))[0]))
        assert periods == pytest.approx(1.2, rel=0.05)
        omega = 2 * np.pi * 1.2
        hits.append((fall["low"] <= np.pi / 2 / Q <= fall["high"], line.omega["low"] <= omega <= line.omega["high"]))
    assert (np.mean(hits, axis=0) >= 0.9).all()


def test_a_record_of_more_swings_or_with_another_line_is_no_short_one():
    short = {"unit": "", "name": "r"}
    for x in (swing(1.7), swing(6.0), 3 * S + 0.1 * swing(20.0), np.exp(-3 * S) + 0.1 * swing(20.0)):
        assert of_a_short_record(S, x, **short) is None
    assert of_a_short_record(S, swing(1.4), **short).no_law


def test_pulses_of_a_hand_are_no_swing():
    """Failed before a release: 4.5 periods, whose cosine leaves a third of them."""
    t = np.arange(0, 20, 0.01)
    assert swings(t, np.where((t // 2) % 2, 1.0, 0.0) + 1e-3 * np.sin(40 * t)) is None


def test_the_turning_points_are_those_of_the_motion():
    """Also of a velocity, whose phase is a quarter of a period ahead."""
    seen = of_a_short_record(S, swing(1.4, 1.0, noise=1e-4), unit="", name="r")
    assert seen.t == pytest.approx((np.pi * np.arange(1, 4) - 1.0) / (2.8 * np.pi), abs=0.02)
    assert np.sign(seen.x).tolist() == [-1, 1, -1]
    w, g = 2.8 * np.pi, 0.4
    speed = (np.exp((-g + 1j * w) * S + 1j) * (-g + 1j * w)).real
    moved = of_a_short_record(S, speed, unit="", name="r", derivative=1)
    assert moved.t == pytest.approx(seen.t, abs=0.02) and np.sign(moved.x).tolist() == [-1, 1, -1]
    assert np.abs(moved.x) == pytest.approx(np.exp(-g * moved.t), rel=0.02)
    assert envelope(moved).quality[1]["estimate"] == pytest.approx(w / 2 / g, rel=0.02)


def test_means_of_neighbours_are_enough():
    t = np.arange(2_001.0)
    times, values = module.averaged(t, t**2)
    assert len(times) == 333 and times[0] == 2.5 and values[0] == pytest.approx(55 / 6)


def test_one_swing_above_the_noise_of_a_long_record_is_told():
    """Failed before: 0.98 periods, of five."""
    t = np.arange(0, 5, 1 / 40)
    x = np.exp(-np.pi / 2 * t) * np.cos(2 * np.pi * t + 0.3) + 0.015 * np.random.default_rng(1).standard_normal(len(t))
    found = told(x, t)["envelope"]
    assert float(found["period"]["low"]) <= 1 <= float(found["period"]["high"]) < 1.1
    assert all(float(row["low"]) <= 2 <= float(row["high"]) for row in found["quality"])


@pytest.mark.parametrize(("quality", "per_period", "swings", "noise"), [(1.27, 106, 12, 0.05), (1.43, 46, 8, 0.017)])
def test_a_strong_decay_with_a_long_rest_keeps_its_swings(quality, per_period, swings, noise):
    """Refused before, all 10: the scatter of a long tail hides the last swings, and half a period before it was no more
    left of the record than a few samples."""
    g = 1 / (2 * quality)
    w = np.sqrt(1 - g * g)
    t = np.arange(0.3, np.pi * swings, 2 * np.pi / per_period)
    x = np.exp(-g * t) * (np.cos(w * t) + g / w * np.sin(w * t))
    for seed in range(2):
        (seen,) = load({"t": t, "x": x + noise * np.random.default_rng(seed).standard_normal(len(t))})
        assert envelope(seen).period["estimate"] == pytest.approx(2 * np.pi / w, rel=0.08)
