"""When the time is over: what is known is told, with what was not tried; a bad option costs no work."""

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification import identify as room
from asymptotics.decays.identification.fitting.in_time import ALL, Time
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.judging import comparison
from asymptotics.decays.identification.judging.comparison import fit_laws
from asymptotics.decays.identification.judging.judgement import judged
from asymptotics.decays.identification.judging.laws import UNTRIED
from asymptotics.decays.identification.synthetic import observed
from asymptotics.errors import InputError, LimitError

LAWS = ["1", "2", "1+2", "0+1"]
SEEN = observed("1", [0.02], 40, 1e-3, seed=2)


def test_laws_are_tried_from_cheap_to_dear_and_the_rest_is_told(monkeypatch):
    tried = []

    def patient(candidate, *args, **kwargs):
        tried.append(str(candidate))
        if len(tried) > 2:
            raise LimitError("max_seconds", "its share is over", "more")
        return fit_law(candidate, *args, **kwargs)

    fit_law = comparison.fit_law
    monkeypatch.setattr(comparison, "fit_law", patient)
    monkeypatch.setattr(Time, "but_for_the_answer", classmethod(lambda cls, share: cls.of(60.0)))
    answer = asy.identify(SEEN, laws=["1+2", "0+1", "2", "1"], bootstrap=False)
    assert tried[:2] == ["2", "1"]
    # None is identified while others are not judged.
    assert answer.verdict.kind == "undecided"
    assert "the time was over before 2 of 4 laws were judged" in answer.verdict.text
    assert any("before 2 of 4 laws were judged" in note for note in answer.notes)
    assert sum(law.law.untried for law in answer.laws) == len(answer.to_dict()["untried"]) == 2


def test_without_time_left_nothing_is_fitted_and_nothing_raised():
    candidates = [read_candidate(law) for law in LAWS]
    fits = fit_laws(candidates, SEEN, time=Time.of(-1.0))
    assert [law.reason for law in fits] == [UNTRIED] * 4
    assert [law.verdict for law in judged(fits, {}, time=Time.of(-1.0))] == ["undetermined"] * 4
    assert all(law.fit is not None for law in fit_laws(candidates, SEEN, time=ALL))


def test_without_time_for_profiles_the_curvature_gives_the_intervals():
    fits = fit_laws([read_candidate("1")], SEEN)
    levels = room._levels(fits, None)
    (rough,), (fine,) = judged(fits, levels, time=Time.of(-1.0)), judged(fits, levels)
    assert (rough.intervals.profiled, fine.intervals.profiled) == (False, True)
    assert (rough.verdict, fine.verdict) == ("undetermined", "consistent")
    assert rough.epsilon[0].low == pytest.approx(fine.epsilon[0].low, rel=0.01)


@pytest.mark.parametrize(
    ("bad", "argument"),
    [({"laws": ["1,oops"]}, "laws"), ({"amplitudes": (1, 2, 3)}, "amplitudes"), ({"springs": ["x"]}, "laws")],
)
def test_a_bad_option_is_refused_before_the_data_are_read(bad, argument, monkeypatch):
    monkeypatch.setattr(room, "load", lambda *a: pytest.fail("the data are read"))
    with pytest.raises(InputError, match=argument):
        asy.identify({"t": np.arange(9.0), "x": np.arange(9.0)}, **bad)
