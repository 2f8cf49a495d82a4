"""From fits to verdicts, step by step: what is measured of each law, its intervals, what is outside, which profiles."""

from types import SimpleNamespace

import numpy as np
import pytest

from asymptotics.decays.identification.fitting.profile import Interval
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.forward.work import Work
from asymptotics.decays.identification.judging import judgement
from asymptotics.decays.identification.judging.contradiction import Contradiction
from asymptotics.decays.identification.judging.judgement import judged
from asymptotics.decays.identification.judging.laws import UNTRIED, Fitted
from asymptotics.decays.identification.judging.single_fits import fit_law
from asymptotics.decays.identification.measuring.observations import Observations, Samples
from tests.decays.identification import small_laws
from tests.decays.identification.small_laws import BELOW, SURE, fit


def test_a_contradiction_is_asked_with_the_stretch_of_the_other_and_the_share_of_the_law(monkeypatch):
    monkeypatch.setattr(judgement, "contradiction", lambda *given: given)
    one = small_laws.law("1", fit(), left=0.25)
    other = small_laws.law("2", fit(), stretches=(1.0, 3.0))
    assert judgement.against(one, other) == (one.candidate, one.fit, other.candidate, other.fit, 3.0, 0.25)


def motion(x, sizes, *, n=None, samples=None, alternating=True, rest=0.0, inside=None):
    n = np.arange(len(x)) if n is None else np.array(n)
    inside = np.ones(len(x), dtype=bool) if inside is None else np.array(inside)
    seen = SimpleNamespace(n=n, x=np.array(x), samples=samples, inside=inside)
    amplitudes = lambda theta: (np.array(sizes) * theta, None)  # noqa: E731
    times = lambda theta: np.arange(len(sizes)) * 1.0  # noqa: E731
    model = SimpleNamespace(alternating=alternating, seen=seen, amplitudes=amplitudes, turning_times=times)
    return SimpleNamespace(model=model, theta=1.0, rest=rest)


def test_a_fit_whose_amplitudes_no_datum_reaches_is_outside():
    """More than half as large again as the largest distance from the rest position."""
    inside = motion([1.0, -0.8, 0.9], [1.5, 1.2, 1.0])
    assert judgement.outside(inside) == ""
    inside.theta = 1.0001
    assert judgement.outside(inside) == "its amplitude, 1.5, is far outside the data (1)"
    moved = motion([1.5, -0.5, 1.2], [1.6, 1.2, 1.0], rest=0.5)  # about 0.5 the data reach 1.0
    assert judgement.outside(moved) == "its amplitude, 1.6, is far outside the data (1)"
    assert judgement.outside(motion([1.0, -0.8], [9.0, 1.0, 1.0, 1.2], n=[1, 3])) == ""  # those that were seen
    assert judgement.outside(motion([1.0, -0.8], [9.0, 9.0], alternating=False)) == ""  # printed decrements


def test_before_the_first_sample_an_amplitude_may_be_larger():
    """Of a point that no sample reaches neither the datum counts nor the closer limit."""
    most = judgement._BEFORE
    for share, outside in ((0.999, False), (1.001, True)):
        found = motion([99.0, 1.0, -0.8], [share * most, 1.2, 1.0], inside=[False, True, True])
        assert bool(judgement.outside(found)) == outside


def test_samples_tell_how_far_the_data_reach_unless_they_are_of_a_velocity():
    """They go up and down by twice the amplitude; the turning points of the line may be wilder."""
    x, t = np.array([0.5, -0.5, 0.25]), np.arange(3.0)
    samples = Samples(t, x, 1.0, 1.0)
    assert judgement.outside(motion([1.0, -0.8], [0.74, 0.5], samples=samples)) == ""
    found = motion([1.0, -0.8], [0.76, 0.5], samples=samples)
    assert judgement.outside(found) == "its amplitude, 0.76, is far outside the data (0.5)"
    velocity = Samples(t, x, 1.0, 1.0, derivative=1)
    assert judgement.outside(motion([1.0, -0.8], [1.6, 1.0], samples=velocity)).endswith("outside the data (1)")
    assert judgement.outside(motion([1.0, -0.8], [1.4, 1.0], samples=velocity)) == ""


def test_a_peak_that_was_clipped_or_lies_in_a_gap_is_told_by_the_rest_of_its_swing():
    """The nearest sample, 0.3 half-swings from the turning point, shows cos(0.3 pi) = 0.59 of the amplitude."""
    clipped = Samples(np.array([-0.3, 0.3, 0.7, 1.3]), np.array([0.5, 0.5, -0.5, -0.5]), 1.0, 1.0)
    seen = 0.75 / np.cos(0.3 * np.pi)
    assert judgement.outside(motion([2.0, -2.0], [0.99 * seen, 0.8], samples=clipped)) == ""
    assert "far outside" in judgement.outside(motion([2.0, -2.0], [1.01 * seen, 0.8], samples=clipped))
    # Where no sample is near a third of the amplitude is asked for, so that a wild line in a gap is no motion.
    gap = Samples(np.array([-0.49, 0.5, 0.6, 1.0]), np.array([0.5, -0.5, -0.5, -0.5]), 1.0, 1.0)
    assert judgement.outside(motion([9.0, -0.8], [0.74 * 3 / 2, 0.4], samples=gap)) == ""
    assert "far outside" in judgement.outside(motion([9.0, -0.8], [0.76 * 3, 0.4], samples=gap))


@pytest.fixture
def named(monkeypatch):
    """Intervals that say of what they are and how they were made."""
    for how in ("profile", "wald"):
        make = lambda fit, g, level=0.95, kind="x", how=how: Interval(-1.0, f"{how} {g} by {kind}", 1.0)  # noqa: E731
        monkeypatch.setattr(judgement, f"{how}_interval", make)


def fitted(text, kinds, functions):
    return SimpleNamespace(
        fit=SimpleNamespace(model=SimpleNamespace(kinds=kinds)), candidate=read(text), terms=len(read(text).elements),
        functions=functions,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("kinds", "clock"),
    [(["x", "t", "passage"], "passage"), (["x", "t"], "t"), (["x"], "x"), (["x", "passage"], "passage")],
)
def test_losses_are_seen_in_the_amplitudes_and_springs_in_the_best_clock(named, kinds, clock):
    found = judgement._intervals(fitted("1+2+s3+s5", kinds, ["a", "b", "c", "d"]), (), profiled=False)
    assert [e.estimate for e in found.epsilon] == ["wald a by x", "wald b by x"]
    assert [e.estimate for e in found.springs] == [f"wald c by {clock}", f"wald d by {clock}"]
    assert found.alpha is None and not found.profiled and found.stretches == ()
    found = judgement._intervals(fitted("1", kinds, ["a"]), (), profiled=True)
    assert found.epsilon[0].estimate == "profile a by x" and found.profiled and found.springs == ()


def test_a_free_exponent_has_its_interval_within_its_range(monkeypatch):
    ends = {"a": (0.1, 0.2, 0.3), "c": (1.0, 2.0, 3.0), "q": (-0.5, 0.5, 1.5)}
    monkeypatch.setattr(judgement, "wald_interval", lambda fit, g, kind: Interval(*ends[g]))
    made = lambda: judgement._intervals(fitted("free+s3", ["x"], ["a", "c", "q"]), (), profiled=False)  # noqa: E731
    found = made()
    assert found.alpha == Interval(0.0, 0.5, 1.5) and found.epsilon == (Interval(0.1, 0.2, 0.3),)
    assert found.springs == (Interval(1.0, 2.0, 3.0),)
    ends["q"] = (0.25, 0.5, None)
    assert made().alpha == Interval(0.25, 0.5, None)
    ends["q"] = (None, 0.5, 1.5)
    assert made().alpha == Interval(0.0, 0.5, 1.5)


def test_residuals_that_remember_stretch_each_interval_by_its_own_factor(monkeypatch):
    monkeypatch.setattr(judgement, "wald_interval", lambda fit, g, kind: Interval(0.0, 1.0, 2.0))
    found = judgement._intervals(fitted("1+2", ["x"], ["a", "b"]), (2.0, 3.0), profiled=False)
    assert found.epsilon == (Interval(-1.0, 1.0, 3.0), Interval(-2.0, 1.0, 4.0)) and found.stretches == (2.0, 3.0)


@pytest.fixture
def parts(monkeypatch):
    """Every part of a measurement by a name, and whether the residuals are noise and remember."""
    known = SimpleNamespace(good=True, correlated=True, asked=[])
    monkeypatch.setattr(
        judgement, "adequate", lambda fit, levels, left: (known.asked.append((levels, left)), (known.good, "said"))[1]
    )
    monkeypatch.setattr(judgement, "is_correlated", lambda fit: known.correlated)
    monkeypatch.setattr(judgement, "replicas", lambda fit: "drawn")
    monkeypatch.setattr(judgement, "stretch", lambda fit, g, drawn: f"{g} of {drawn}")
    monkeypatch.setattr(judgement, "unexplained", lambda fit: "left open")
    monkeypatch.setattr(judgement, "outside", lambda fit: "far")
    monkeypatch.setattr(Fitted, "functions", ["a", "b"])
    monkeypatch.setattr(judgement, "_intervals", lambda law, stretches, profiled: (stretches, profiled))
    return known


def test_what_is_measured_of_a_law(parts):
    law = Fitted(read("1+2"), fit(), left=0.5)
    found = judgement._measured(law, "levels", bootstrap=True)
    assert found.intervals == (("a of drawn", "b of drawn"), False) and found.fitted is law
    evidence = found.evidence
    assert (evidence.residuals, evidence.misfit, evidence.unexplained, evidence.outside) == (
        "said",
        "",
        "left open",
        "far",
    )
    assert parts.asked == [("levels", 0.5)]
    parts.good = False
    assert judgement._measured(law, "levels", bootstrap=True).evidence.misfit == "said"
    assert judgement._measured(law, "levels", bootstrap=False).intervals == ((), False)
    parts.correlated = False
    assert judgement._measured(law, "levels", bootstrap=True).intervals == ((), False)


def test_nothing_is_measured_without_a_fit_or_data_to_spare(parts):
    for law in (Fitted(read("1"), None, "why"), Fitted(read("1"), fit(float("inf")), "why")):
        found = judgement._measured(law, "levels", bootstrap=True)
        assert (found.verdict, found.reason, found.epsilon) == ("undetermined", "why", ()) and parts.asked == []


OPEN, SHUT = Interval(None, 1.0, 2.0), Interval(0.0, 1.0, 2.0)


@pytest.mark.parametrize(
    ("verdict", "epsilon", "kept"),
    [
        ("refuted", OPEN, True),
        ("refuted", Interval(0.0, 1.0, None), True),
        ("refuted", SHUT, False),
        ("consistent", OPEN, False),
    ],
)
def test_a_profile_replaces_the_curvature_unless_a_refuted_law_leaves_its_domain(monkeypatch, verdict, epsilon, kept):
    profiled = SimpleNamespace(epsilon=(SHUT, epsilon))

    def intervals(law, stretches, *, profiled_=profiled, profiled):
        assert stretches == (2.0, 2.5) and profiled
        return profiled_

    monkeypatch.setattr(judgement, "_intervals", intervals)
    law = small_laws.law("1+2", fit(), verdict=verdict, stretches=(2.0, 2.5))
    found = judgement._profiled(law)
    assert (found is law) == kept and (kept or found.intervals is profiled)


@pytest.fixture
def steps(monkeypatch):
    """Judging with every step replaced: measured laws are those of ``small_laws``; profiles say so."""
    known = SimpleNamespace(profiled=[], asked=[], growing=[])

    def measured(law, levels, bootstrap):
        known.asked.append((levels, bootstrap))
        return small_laws.law(str(law.candidate), law.fit)

    def profile(law):
        known.profiled.append(str(law.candidate))
        return law.judged_as(law.verdict, "profiled")

    monkeypatch.setattr(judgement, "_measured", measured)
    monkeypatch.setattr(judgement, "_profiled", profile)
    monkeypatch.setattr(judgement, "worst", lambda law, laws, growing: Contradiction(read("3"), len(laws), 1, growing))
    monkeypatch.setattr(judgement, "labelled", lambda law, growing: (known.growing.append(growing), law)[1])
    monkeypatch.setattr(judgement, "minimal", lambda laws: laws[2:])
    monkeypatch.setattr(judgement, "relabelled", lambda laws, growing: (known.growing.append(growing), laws)[1])
    return known


def test_each_law_is_compared_with_the_best_and_with_all(steps):
    laws = [Fitted(read(t), fit(c)) for t, c in (("1", 3.0), ("2", 1.0), ("1+2", float("inf")))]
    found = judged(laws, "levels", growing=True, bootstrap=True)
    assert [law.excess for law in found] == [2.0, 0.0, float("inf")]
    assert all(law.evidence.against == Contradiction(read("3"), 3, 1, True) for law in found)
    assert steps.asked == [("levels", True)] * 3 and steps.growing == [True] * 4
    assert steps.profiled == ["1", "2"] and [law.reason for law in found] == ["profiled", "profiled", ""]
    assert judged([], {}) == []
    steps.growing.clear()
    judged(laws[:1], "levels")
    assert steps.growing == [False, False] and steps.asked[-1] == ("levels", False)


TEXTS = ["0", "1", "2", "3", "0+1", "0+2", "0+3", "1+2", "1+3", "2+3", "0+1+2"]


@pytest.mark.parametrize(("count", "profiled"), [(8, TEXTS[:8]), (9, TEXTS[2:9]), (11, TEXTS[2:10])])
def test_of_few_laws_all_are_profiled_and_of_more_those_of_the_verdict(steps, count, profiled):
    """At most eight of them."""
    found = judged([Fitted(read(t), fit(1.0)) for t in TEXTS[:count]], {})
    assert steps.profiled == profiled and [str(law.candidate) for law in found] == TEXTS[:count]


def test_a_law_whose_profile_has_no_time_is_untried(steps):
    (found,) = judged([Fitted(read("1"), fit(1.0))], {}, work=Work(limit=0.0))
    assert steps.profiled == [] and found.fitted.reason == UNTRIED and found.fitted.fit is not None


def test_a_negative_loss_makes_no_law_admissible_but_in_a_growing_motion():
    physical, negative = small_laws.law("1", fit()), small_laws.law("2", fit(), epsilon=(BELOW,))
    far = small_laws.law("3", fit(), outside="far")
    admissible = lambda growing: [judgement._admissible(law, growing) for law in (physical, negative, far)]  # noqa: E731
    assert admissible(False) == [True, False, False] and admissible(True) == [True, True, False]


def test_beside_a_physical_law_one_with_a_negative_loss_is_no_rival(monkeypatch):
    monkeypatch.setattr(judgement, "against", lambda *_: SimpleNamespace(p=1.0))
    one, negative = small_laws.law("1", fit(2.0)), small_laws.law("2", fit(1.0), epsilon=(BELOW,))
    assert judgement.rivals([negative, one]) == ([one], [negative])
    assert judgement.rivals([negative]) == ([negative], [])
    assert judgement.minimal([negative, one]) == [one, negative]


def test_a_physical_law_is_not_set_aside_by_one_inside_it_with_a_negative_loss(monkeypatch):
    monkeypatch.setattr(judgement, "against", lambda *_: SimpleNamespace(p=1.0))
    below = Interval(-0.3, -0.1, 0.1)
    inside = small_laws.law("1+2", fit(1.0), epsilon=(SURE, below))
    whole = small_laws.law("1+2+3", fit(2.0))
    assert judgement.minimal([inside, whole]) == [whole, inside]
    assert judgement.rivals([inside, whole]) == ([whole], [inside])
    assert [law.unneeded for law in judgement.commented([inside, whole])] == [(), ()]
    # Beside a physical one inside, and where the larger law is unphysical too, the smaller one does.
    one = small_laws.law("1", fit(3.0))
    assert judgement.rivals([inside, whole, one])[0] == [one]
    spoilt = small_laws.law("1+2+3", fit(2.0), epsilon=(SURE, SURE, below))
    assert judgement.minimal([inside, spoilt]) == [inside]


def test_a_law_with_a_negative_loss_beats_no_physical_one(monkeypatch):
    monkeypatch.setattr(judgement, "against", lambda law, other: SimpleNamespace(p=0.0))
    negative = small_laws.law("2", fit(1.0), epsilon=(Interval(-0.3, -0.1, 0.1),))
    physical = small_laws.law("0+1", fit(2.0))
    assert judgement.rivals([negative, physical]) == ([physical], [negative])


@pytest.mark.parametrize(("p", "beaten"), [(0.00999, True), (0.01, False)])
def test_a_law_of_more_parameters_is_beaten_below_a_hundredth(monkeypatch, p, beaten):
    monkeypatch.setattr(
        judgement, "against", lambda law, other: SimpleNamespace(p=p if str(law.candidate) == "2+3" else 1.0)
    )
    one, two = small_laws.law("1", fit(2.0)), small_laws.law("2+3", fit(1.0))
    assert [str(law.candidate) for law in judgement.rivals([one, two])[1]] == (["2+3"] if beaten else [])


@pytest.mark.parametrize(("p", "inside"), [(0.01, True), (0.00999, False)])
def test_a_spring_contains_the_sine_unless_it_explains_the_data_better(monkeypatch, p, inside):
    monkeypatch.setattr(
        judgement, "against", lambda law, other: SimpleNamespace(p=p if law.candidate.pendulum else float("nan"))
    )
    assert judgement.contains(small_laws.law("1+s3", fit()), small_laws.law("1+pendulum", fit())) == inside


def test_observed_amplitudes_are_those_of_the_model():
    """On a true fit the first amplitude is that of the data, and nothing is outside."""
    seen = Observations.of(range(12), 2.0 * (-0.9) ** np.arange(12.0))
    assert judgement.outside(fit_law(read("1"), seen).fit) == ""
