"""One identification from its runs to its answer, with every part replaced: order, what each is given, what is told."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from asymptotics.decays.identification import identify as module
from asymptotics.decays.identification.fitting.model import Noise
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.forward.work import ALL
from asymptotics.decays.identification.identify import identified
from asymptotics.decays.identification.judging.laws import Fitted
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.telling.result import Identification, LawAnswer, RecordUnits
from asymptotics.decays.identification.telling.verdicts import IDENTIFIED, Verdict
from asymptotics.errors import InputError
from tests.decays.identification.small_laws import BELOW, fit, law

N = np.arange(20)
RUN = Observations.of(N, (-0.9) ** N, 1.0 * N, unit="m", name="run", notes=("read",))
CANDIDATES = [read(text) for text in ("1", "2", "1+2", "free", "1+s3")]


CLOCKLESS = SimpleNamespace(seen=SimpleNamespace(has_times=False))


@pytest.fixture
def parts(monkeypatch):
    """Fits that are laws already; each step is written down with what it was given."""
    known = SimpleNamespace(asked=[], laws={}, constant=False, growing=False, chosen=1)

    def note(name, result):
        def step(*given, **more):
            known.asked.append((name, given, more))
            return result(*given, **more)

        monkeypatch.setattr(module, name, step)

    model = SimpleNamespace(seen=SimpleNamespace(has_times=True), kinds=["x"], alternating=True)
    made = fit(1.0, model=model, theta=np.array([0.0, 0.0, np.log(3.0), 0.0]), bic=0.0)
    note("is_constant", lambda x: known.constant)
    note("is_growing", lambda x: known.growing)
    note("fit_laws", lambda candidates, *_: [Fitted(c, made) for c in candidates])
    note("spring_bound", lambda run: (0.25, "the times show"))
    note("relieved", lambda one, bound: replace(one, left=0.5))
    note("_levels", lambda fits, noise: "levels")
    note(
        "judged", lambda fits, *_, **__: [known.laws.get(str(f.candidate)) or law(str(f.candidate), made) for f in fits]
    )
    note("widened", lambda one, bound: replace(one, reason="widened"))
    note("relabelled", lambda laws, growing: laws)
    note("verdict_of", lambda *_, advice=True: Verdict(IDENTIFIED, "identified", "advice" if advice else ""))
    note("minimal", lambda laws: laws[: known.chosen])
    note("predicted_error", lambda fitted, seen: 1.5)
    note("textbook_estimates", lambda seen: {"Froude": 1})
    for name, told in (("_untried", "untried"), ("_lengths", "length"), ("_memory", "memory")):
        note(name, lambda laws, told=told: [told])
    known.given = lambda name: [(given, more) for each, given, more in known.asked if each == name]
    return known


def one(parts, run=RUN, *, amplitudes_only=False, noise=None, bootstrap=True, candidates=CANDIDATES):
    parts.asked.clear()
    return module._one_run(run, candidates, RecordUnits("m"), amplitudes_only, noise, bootstrap, ALL)


def test_a_run_is_fitted_judged_told_and_predicted(parts):
    noise = Noise(x=0.1)
    found = one(parts, noise=noise, bootstrap=False)
    assert parts.given("fit_laws") == [((CANDIDATES, RUN, noise, ALL), {})]
    (((fits, levels), more),) = parts.given("judged")
    assert levels == "levels" and more == {"growing": False, "bootstrap": False, "work": ALL}
    assert [str(f.candidate) for f in fits] == [str(c) for c in CANDIDATES]
    assert [more for _, more in parts.given("verdict_of")] == [{"advice": False}, {}]
    assert all(given[1:] == (RUN, False) for given, _ in parts.given("verdict_of"))
    assert found.verdict.telling == "advice" and found.textbook == {"Froude": 1} and found.runs == (RUN,)
    assert found.notes == ("read", "untried", "length", "memory") and found.per_run == ()
    assert [a.law.evidence.held_out for a in found.laws if str(a.law.candidate) == "1"] == [1.5]
    assert sum(a.law.evidence.held_out is not None for a in found.laws) == 1 and len(found.laws) == 5
    assert found.units.omega_0 == pytest.approx(3.0) and not parts.given("spring_bound")
    assert parts.given("textbook_estimates") == [((RUN,), {})] and parts.given("is_constant")[0][0][0] == pytest.approx(
        0.9**N
    )


def test_four_laws_of_the_verdict_are_predicted(parts):
    parts.chosen = 5
    one(parts)
    assert len(parts.given("predicted_error")) == 4 and all(
        given[1] is RUN for given, _ in parts.given("predicted_error")
    )


def test_of_a_constant_amplitude_only_laws_of_one_strength_are_compared(parts):
    parts.constant = parts.growing = True
    found = one(parts)
    assert [str(c) for c in parts.given("fit_laws")[0][0][0]] == ["1", "2"]
    assert found.notes[1] == "the amplitude is constant within the noise: only laws of one term are compared"
    left = [f for f in parts.given("judged")[0][0][0] if f.fit is None]
    assert [str(f.candidate) for f in left] == ["1+2", "free", "1+s3"]
    assert {f.reason for f in left} == {"the amplitude is constant within the noise"}
    assert parts.given("judged")[0][1]["growing"] is False  # it may be a little larger at its end


def test_in_a_growing_motion_strengths_may_be_negative(parts):
    parts.growing = True
    parts.laws = {"2": law("2", fit(5.0, model=CLOCKLESS), epsilon=(BELOW,))}
    found = one(parts, candidates=CANDIDATES[1:2] + CANDIDATES[:1])
    assert parts.given("judged")[0][1]["growing"] is True
    assert found.notes[-1] == "the amplitude grows: strengths may be negative (self-excitation)"
    assert parts.given("verdict_of")[0][0][2] is True


def test_a_negative_estimate_is_unphysical_and_told_of_three_laws(parts):
    texts = ("0", "1", "2", "3", "1+2")
    parts.laws = {t: law(t, fit(5.0, model=CLOCKLESS), epsilon=(BELOW,) * (2 if "+" in t else 1)) for t in texts}
    parts.laws["0"] = replace(parts.laws["0"], verdict="refuted")
    parts.laws["1+2"] = replace(parts.laws["1+2"], unneeded=("2",))
    candidates = [read(t) for t in (*texts, "5", "1/2")]
    found = one(parts, candidates=candidates)
    odd = [note for note in found.notes if "unphysical" in note]
    assert odd == [f"{t}: the estimate of {t} is negative: unphysical" for t in ("1", "2", "3")]
    parts.laws["5"] = law("5", fit(5.0, model=CLOCKLESS), epsilon=(BELOW,))
    assert len([note for note in one(parts, candidates=candidates).notes if "unphysical" in note]) == 3


def test_without_times_what_cannot_be_told_is_said(parts):
    found = one(parts, RUN.without_times())
    assert found.notes[1].startswith("amplitudes cannot tell a nonlinear spring from position-dependent loss")
    assert found.notes[1].endswith("; intervals and verdicts hold for a linear spring")
    assert not parts.given("relieved")


def test_amplitudes_alone_allow_for_an_unseen_spring(parts):
    found = one(parts, amplitudes_only=True)
    seen = parts.given("fit_laws")[0][0][1]
    assert not seen.has_times and parts.given("spring_bound")[0][0][0] is RUN
    assert found.notes[1].endswith("measure either; the times show: intervals and verdicts allow for it")
    assert all(given[1] == 0.25 for given, _ in parts.given("relieved")) and len(parts.given("relieved")) == 5
    assert all(f.left == 0.5 for f in parts.given("judged")[0][0][0])
    assert all(given[1] == 0.25 for given, _ in parts.given("widened")) and len(parts.given("widened")) == 5
    assert {a.law.reason for a in found.laws} == {"widened"} and parts.given("relabelled")[0][0][1] is False
    order = [name for name, *_ in parts.asked]
    assert order.index("relieved") < order.index("judged") < order.index("widened") < order.index("verdict_of")


def table(resolution=None):
    return Decrements(np.array([1.0, 0.5]), np.array([0.2, 0.1]), resolution, "m", "table", ("read",))


def test_printed_decrements_without_resolutions_are_samples(parts, monkeypatch):
    monkeypatch.setattr(
        module,
        "fit_decrements",
        lambda c, t, noise: (parts.asked.append(("fit", (c, t, noise), {})), Fitted(c, None))[1],
    )
    noise = Noise(x=0.1)
    found = one(parts, table(), noise=noise)
    assert [given[1:] for given, _ in parts.given("fit")] == [(found.runs[0], noise)] * 5
    assert parts.given("verdict_of")[0][0][1] is None and found.textbook == {}
    assert found.notes == (
        "read",
        "decrements cannot tell a nonlinear spring from loss: the intervals hold for linear springs",
    )


def test_printed_decrements_with_resolutions_are_sets(parts, monkeypatch):
    from asymptotics.decays.identification.telling import certified_answer  # noqa: PLC0415 (patched where it is imported late)

    monkeypatch.setattr(certified_answer, "certified", lambda *given: given)
    given = table(np.array([0.01, 0.01]))
    assert one(parts, given) == (given, CANDIDATES, RecordUnits("m"))


def answer(name, omega, *laws, first=1.0):
    run = Observations.of([0, 1], [first, -0.5 * first], name=name)
    return Identification(
        Verdict(IDENTIFIED, name),
        tuple(LawAnswer(one) for one in laws),
        (run,),
        {},
        (f"note of {name}",),
        RecordUnits("m", omega_0=omega),
    )


def test_several_runs_have_a_common_answer(monkeypatch):
    asked = {}
    one, two = law("1", fit(1.0)), law("2", fit(2.0))
    monkeypatch.setattr(module, "common", lambda per_run: (asked.update(runs=per_run), [two, one])[1])
    monkeypatch.setattr(
        module, "verdict_of_runs", lambda *given: (asked.update(verdict=given), Verdict(IDENTIFIED, "all"))[1]
    )
    answers = [answer("a", 2.0, one, two), answer("b", 4.0, two, one, first=3.0)]
    found = module._together(answers, RecordUnits("m"))
    assert [[str(e.candidate) for e in run] for run in asked["runs"]] == [["1", "2"], ["1", "2"]]
    assert asked["verdict"] == ([a.verdict for a in answers], [two, one], 3.0)
    assert (
        found.notes == ("a: note of a", "b: note of b")
        and found.units.omega_0 == 3.0
        and found.per_run == tuple(answers)
    )
    assert [str(a.law.candidate) for a in found.laws] == ["1", "2"] and [r.name for r in found.runs] == ["a", "b"]
    assert all(a.units is found.units for a in found.laws) and found.textbook == {}
    assert module._together([answer("a", None, one), answer("b", None, one)], RecordUnits("m")).units.omega_0 is None


@pytest.fixture
def whole(monkeypatch):
    """``identify`` up to its runs."""
    asked = []
    monkeypatch.setattr(module, "_order_by_its_name", lambda _: 0)
    monkeypatch.setattr(module, "_one_run", lambda *given: (asked.append(given), f"answer {len(asked)}")[1])
    monkeypatch.setattr(module, "_together", lambda answers, units: (answers, units))
    monkeypatch.setattr(module.Work, "of_a_verdict", lambda share=1.0: share)
    return asked


def test_each_run_has_its_share_of_the_time_and_all_the_same_laws(whole):
    answers, units = identified([RUN, RUN, RUN.without_times()], mass=2.0, stiffness=8.0, noise=0.1, bootstrap=False)
    assert answers == ["answer 1", "answer 2", "answer 3"] and units == RecordUnits("m", 1.0, 2.0, 8.0, 2.0)
    assert [given[-1] for given in whole] == [1 / 3, 1 / 2, 1.0]
    run, candidates, known, amplitudes_only, noise, bootstrap, _ = whole[0]
    assert run is RUN and known == units and (amplitudes_only, noise, bootstrap) == (False, Noise(x=0.1), False)
    assert not any(c.springs for c in candidates)  # one run without times leaves no spring to any


def test_one_run_with_times_tries_springs_and_angles_pendulums(whole):
    assert identified(RUN) == "answer 1"
    assert any(c.springs for c in whole[0][1]) and not any(c.pendulum for c in whole[0][1]) and whole[0][4] is None
    identified(replace(RUN, unit="deg"), omega_0=3.0)
    assert any(c.pendulum for c in whole[1][1]) and whole[1][2] == RecordUnits("deg", np.pi / 180, omega_0=3.0)
    identified(RUN, amplitudes_only=True, laws=["1", "2"])
    assert [str(c) for c in whole[2][1]] == ["1", "2"] and whole[2][3] is True
    identified(RUN, laws="1", springs=["3", "3+5"])
    assert [str(c) for c in whole[3][1]] == ["1", "1+s3", "1+s3+s5"]
    identified(RUN, amplitudes=(0.2, 0.9))
    assert np.abs(whole[4][0].x).min() >= 0.2 and np.abs(whole[4][0].x).max() <= 0.9


def test_two_arrays_are_one_record_and_a_list_is_several_runs():
    t, x = np.arange(3.0), np.ones(3)
    (found,) = module._sources((t, x))
    assert list(found) == ["t", "x"] and found["t"] is t and found["x"] is x
    assert module._sources([t, x]) == [t, x] and module._sources(RUN) == [RUN]
    assert len(module._sources((t, np.ones((2, 2))))) == 2 and len(module._sources((t, x, x))) == 3


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"data": []}, "argument data: 0 runs"), ({"data": [RUN] * 51}, "argument data: 51 runs"),
        ({"data": [RUN, replace(RUN, unit="mm")]}, "argument unit: the runs have different units: m, mm"),
        ({"laws": []}, "argument laws: no law is named"),
        ({"laws": [1]}, "argument laws: 1 .int. is no text"),
        ({"springs": [3]}, "argument springs: 3 .int. is no text"),
        ({"laws": ["1+pendulum"]}, "a pendulum needs angles"),
        ({"mass": 1, "stiffness": 1, "omega_0": 1}, "argument omega_0"),
    ],
)  # fmt: skip
def test_what_cannot_be_asked_is_refused_by_its_name(whole, more, said):
    with pytest.raises(InputError, match=said):
        identified(**({"data": RUN} | more))
    assert whole == []


def test_fifty_runs_are_served(whole):
    assert len(identified([RUN] * 50, laws="1")[0]) == 50
