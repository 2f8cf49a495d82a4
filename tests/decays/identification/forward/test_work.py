"""Work is counted, so that a verdict is the same on a slow machine; where a limit is reached, what is left is told."""

from time import monotonic

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification import identify as room
from asymptotics.decays.identification.forward import work as counting
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.forward.work import ALL, Work, counted
from asymptotics.decays.identification.judging import comparison
from asymptotics.decays.identification.judging.comparison import fit_laws
from asymptotics.decays.identification.judging.judgement import judged
from asymptotics.decays.identification.judging.laws import UNTRIED
from asymptotics.decays.identification.synthetic import observed
from asymptotics.errors import InputError, LimitError
from asymptotics.running import budget as budgets
from tests.worlds import RIVALS

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
    monkeypatch.setattr(Work, "of_a_verdict", classmethod(lambda cls, share: cls(limit=1e9)))
    answer = asy.identify(SEEN, laws=["1+2", "0+1", "2", "1"], bootstrap=False)
    assert tried[:2] == ["2", "1"]
    # None is identified while others are not judged.
    assert answer.verdict.kind == "undecided"
    assert "the limit of work or time was reached before 2 of 4 laws were judged" in answer.verdict.text
    assert any("before 2 of 4 laws were judged" in note for note in answer.notes)
    assert sum(law.law.untried for law in answer.laws) == len(answer.to_dict()["untried"]) == 2


def test_without_anything_left_nothing_is_fitted_and_nothing_raised():
    candidates = [read_candidate(law) for law in RIVALS]
    fits = fit_laws(candidates, SEEN, work=Work(deadline=0.0))
    assert [law.reason for law in fits] == [UNTRIED] * 4
    assert [law.verdict for law in judged(fits, {}, work=Work(deadline=0.0))] == ["undetermined"] * 4
    assert all(law.fit is not None for law in fit_laws(candidates, SEEN, work=ALL))


def test_without_work_left_for_profiles_the_curvature_gives_the_intervals():
    fits = fit_laws([read_candidate("1")], SEEN)
    levels = room._levels(fits, None)
    (rough,), (fine,) = judged(fits, levels, work=Work(deadline=0.0)), judged(fits, levels)
    assert (rough.intervals.profiled, fine.intervals.profiled) == (False, True)
    assert (rough.verdict, fine.verdict) == ("undetermined", "consistent")
    assert rough.epsilon[0].low == pytest.approx(fine.epsilon[0].low, rel=0.01)


@pytest.fixture
def slow(monkeypatch):
    """A machine on which each fit takes half a minute longer than here, by its clock."""
    late = [0.0]

    def busy(*args, **kwargs):
        late[0] += 30.0
        return fit_law(*args, **kwargs)

    fit_law = comparison.fit_law
    monkeypatch.setattr(comparison, "fit_law", busy)
    for module in (budgets, counting):
        monkeypatch.setattr(module, "monotonic", lambda: monotonic() + late[0])


def record():
    """A decay whose samples are fitted: about a second of work."""
    t = np.arange(0, 45, 0.35)
    return {"t": t, "x": np.exp(-0.02 * t) * np.cos(t) + 4e-3 * np.random.default_rng(5).standard_normal(len(t))}


def answered(**asked):
    return {k: v for k, v in asy.identify(record(), laws=RIVALS, **asked).to_dict().items() if k != "made_by"}


def test_the_verdict_is_the_same_on_a_slow_machine(slow, request):
    asked = answered()
    request.getfixturevalue("monkeypatch").undo()
    assert asked == answered() and asked["verdict_kind"] == "identified" and asked["untried"] == []


def test_what_is_cut_off_by_the_time_is_undecided(slow):
    found = answered(max_seconds=100)
    assert found["verdict_kind"] == "undecided" and found["untried"]


def test_the_work_ends_at_the_same_law_on_every_machine(slow, request, monkeypatch):
    monkeypatch.setattr(counting, "RATE", 1e3)  # 0.06 seconds' worth
    cut = answered()
    assert cut["verdict_kind"] == "undecided" and cut["untried"]
    request.getfixturevalue("monkeypatch").undo()
    assert answered()["untried"] == []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(counting, "RATE", 1e3)
        assert answered() == cut


def test_more_time_is_more_work():
    limits = []
    for seconds in (60, 600, 6000):
        with budgets.budget(seconds):
            limits.append(Work.of_a_verdict().limit)
    assert limits[0] == limits[1] == counting.RATE * 60 and limits[2] == counting.RATE * 600


def test_work_is_counted_only_inside_and_ends_there():
    counted(1e12)  # nobody asks
    work = Work(limit=100.0)

    def half():
        counted(60)
        return "done"

    assert [work.within(half, "left") for _ in range(3)] == ["done", "left", "left"] and work.done == 120


@pytest.mark.parametrize(
    ("bad", "argument"),
    [({"laws": ["1,oops"]}, "laws"), ({"amplitudes": (1, 2, 3)}, "amplitudes"), ({"springs": ["x"]}, "springs")],
)
def test_a_bad_option_is_refused_before_the_data_are_read(bad, argument, monkeypatch):
    monkeypatch.setattr(room, "load", lambda *a: pytest.fail("the data are read"))
    with pytest.raises(InputError, match=argument):
        asy.identify({"t": np.arange(9.0), "x": np.arange(9.0)}, **bad)
