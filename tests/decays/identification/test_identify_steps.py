"""The steps of an identification between the fits and the answer: what is left out, what is told, and of which law."""

from types import SimpleNamespace

import numpy as np
import pytest

from asymptotics.decays.identification import identify
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.identify import (
    _candidates,
    _in_range,
    _lengths,
    _measured,
    _memory,
    _omega,
    _untried,
)
from asymptotics.decays.identification.judging.laws import UNTRIED
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.telling.record_units import RecordUnits
from asymptotics.decays.records.units import GRAVITY
from asymptotics.errors import InputError
from tests.decays.identification import small_laws


def law(text, verdict="consistent", fit=None, inflation=1.0, criterion=1.0, **more):
    """A judged law; its criterion is known though it has no fit."""
    known = {"stretches": (inflation,), "total": criterion}
    return small_laws.law(text, fit, verdict=verdict, **(known | more))


@pytest.fixture
def by_criterion(monkeypatch):
    monkeypatch.setattr(identify, "sorted_laws", lambda laws: sorted(laws, key=lambda one: one.criterion))


FIT = SimpleNamespace(theta=np.zeros(5), model=SimpleNamespace(kinds=["x", "t"]))


def test_the_length_of_a_pendulum_is_that_of_its_frequency(monkeypatch, by_criterion):
    """g/omega^2, whose ends are those of omega turned round, stretched as its residuals ask."""
    asked = []

    def interval(fit, function, *, kind):
        asked.append((fit, function(np.arange(5.0))[0], kind))
        return Interval(*(float(np.log(w)) for w in (2.9, 3.0, 3.1)))

    monkeypatch.setattr(identify, "wald_interval", interval)
    (said,) = _lengths([law("pendulum+1", fit=FIT)])
    assert asked == [(FIT, 3.0, "t")]  # ln omega_0 is the last but one of the vector
    middle, low, high = (GRAVITY / w**2 for w in (3.0, 3.1, 2.9))
    assert said == (
        f"1+pendulum: omega_0 = 3 rad/s, length g/omega_0^2 = {middle:.5g} m [{low:.5g}, {high:.5g}] "
        f"where g = {GRAVITY} m/s^2"
    )
    (wider,) = _lengths([law("pendulum+1", fit=FIT, inflation=2.0)])
    low, high = (GRAVITY / (3.0 * (w / 3.0) ** 2) ** 2 for w in (3.1, 2.9))
    assert f"[{low:.5g}, {high:.5g}]" in wider


@pytest.mark.parametrize(
    "laws",
    [
        [],
        [law("1", fit=FIT)],
        [law("pendulum+1", verdict="refuted", fit=FIT)],
        [law("pendulum+1", verdict="undetermined", fit=FIT)],
        [law("pendulum+1", fit=None)],
    ],
)
def test_only_a_consistent_pendulum_that_was_fitted_has_a_length(by_criterion, laws):
    assert _lengths(laws) == []


def test_the_best_of_the_pendulums_is_told(monkeypatch, by_criterion):
    monkeypatch.setattr(identify, "wald_interval", lambda *_, **__: Interval(0.9, 1.0, 1.1))
    laws = [law("pendulum+1", fit=FIT, criterion=3.0), law("pendulum+2", fit=FIT, criterion=2.0), law("1", criterion=0)]
    (said,) = _lengths(laws)
    assert said.startswith("2+pendulum: ")


def test_what_the_time_did_not_suffice_for_is_counted_and_named():
    laws = [law("1"), law("2", missed=UNTRIED), law("1+2", missed=UNTRIED)]
    assert (
        _untried(laws) == ["the limit of work or time was reached before 2 of 3 laws were judged: 2; 1+2"]
        and _untried(laws[:1]) == []
    )


def test_the_memory_of_residuals_is_told_of_consistent_laws_only(monkeypatch):
    monkeypatch.setattr(identify, "block_length", lambda fit: fit)
    laws = [
        law("1", fit=3, inflation=1.5), law("2", fit=7, inflation=1.25), law("3", fit=9),
        law("1+2", fit=8, inflation=4.0, verdict="refuted"),
    ]  # fmt: skip
    assert _memory(laws) == ["correlated residuals: intervals stretched by up to 1.5 (blocks of 7 swings)"]
    assert _memory(laws[2:]) == []


N = np.arange(12)
SEEN = Observations.of(N, 0.9**N * (-1.0) ** N)
TABLE = Decrements(0.9**N, 0.1 * 0.9**N, None)


@pytest.mark.parametrize("run", [SEEN, TABLE], ids=["turning points", "decrements"])
def test_a_range_keeps_what_lies_in_it_and_needs_four(run):
    assert _in_range(run, None) is run
    kept = _in_range(run, (0.9**4, 0.9))
    assert len(kept.x if run is SEEN else kept.amplitude) == 4
    for within, count in (((0.9**3, 0.9), 3), ((-0.1, 0.9), 11), ((0.9, 0.9), 1), ((0.9, 0.5), 0)):
        with pytest.raises(InputError, match=f"amplitudes.*{count} turning points"):
            _in_range(run, within)


def names(*given):
    return [str(c) for c in _candidates(*given)]


def test_springs_are_added_to_each_law_that_has_none():
    assert names(["1", "2", "1+s3"], ["5", "3+5"], True, False) == [
        "1", "2", "1+s3", "1+s5", "2+s5", "1+s3+s5", "2+s3+s5",
    ]  # fmt: skip
    assert names(["pendulum+1", "1"], ["3"], True, True) == ["1+pendulum", "1", "1+s3"]
    assert names(["1", "2", "1"], (), False, False) == ["1", "2"]  # once each


@pytest.mark.parametrize(
    ("laws", "springs", "times", "angles", "reason"),
    [
        ([], (), True, True, "no law is named"),
        (["pendulum+1"], (), True, False, "a pendulum needs angles"),
        (["pendulum+1"], (), False, True, "springs need times"),
        (["1+s3"], (), False, False, "springs need times"),
        (["1"], ["3"], False, False, "springs need times"),
    ],
)
def test_laws_that_the_data_cannot_tell_are_refused(laws, springs, times, angles, reason):
    with pytest.raises(InputError, match=reason):
        _candidates(laws, springs, times, angles)


def test_the_frequency_is_that_of_the_law_if_its_times_were_fitted():
    units = RecordUnits("m", 1.0, None, None, None)
    theta = np.array([0.0, 0.1, 0.0, np.log(3.0), 7.0])
    timed, untimed = (
        SimpleNamespace(aicc=1.0, theta=theta, model=SimpleNamespace(seen=SimpleNamespace(has_times=times)))
        for times in (True, False)
    )
    assert _measured(units, small_laws.law("1", timed)).omega_0 == pytest.approx(3.0, rel=1e-15)
    for law_without in (small_laws.law("1", untimed), small_laws.law("1"), small_laws.law("1", timed, outside="far")):
        assert _measured(units, law_without).omega_0 is None
    given = RecordUnits("m", 1.0, None, None, 5.0)
    assert _measured(given, small_laws.law("1", timed)) is given


def test_the_frequency_is_given_once():
    assert _omega(2.0, 18.0, None) == 3.0 and _omega(None, 18.0, 5.0) == 5.0 and _omega(2.0, None, None) is None
    with pytest.raises(InputError, match="stands next to"):
        _omega(2.0, 18.0, 3.0)
