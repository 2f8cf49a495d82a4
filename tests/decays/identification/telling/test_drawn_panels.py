"""What the four panels show: the numbers of every line and band, their names, colours and order, by a second route."""

from dataclasses import replace
from types import SimpleNamespace

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_hex
from scipy.interpolate import CubicSpline

from asymptotics.decays.identification.fitting.profile import Interval, quantile
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.judging.grades import Unexplained
from asymptotics.decays.identification.judging.judgement import judged
from asymptotics.decays.identification.judging.laws import Evidence
from asymptotics.decays.identification.judging.single_fits import fit_law
from asymptotics.decays.identification.measuring.observations import Samples
from asymptotics.decays.identification.synthetic import observed
from asymptotics.decays.identification.telling import plots
from asymptotics.decays.identification.telling.law_answer import shown_interval
from asymptotics.errors import InputError
from tests.decays.identification import small_laws

OFFSET, FIRST = 0.1, 1.3


def seen(times=None):
    return observed("1", [0.05], 12, 1e-3, times, seed=4, x0=FIRST, offset=OFFSET)


def laws_of(run, *texts):
    return judged([fit_law(read(text), run) for text in texts], dict.fromkeys(("x", "t", "passage"), (0.0, 0.0)))


@pytest.fixture(scope="module")
def pair():
    """Linear loss, and linear with quadratic loss."""
    return laws_of(seen(), "1", "1+2")


@pytest.fixture
def axes():
    figure, axes = plt.subplots()
    yield axes
    plt.close(figure)


def line(axes, label):
    (found,) = [each for each in axes.lines if each.get_label() == label]
    return found


def dots(axes):
    """The measured decrements, and the half-lengths of their error bars."""
    (drawn,) = axes.containers
    (bars,) = drawn.lines[2]
    return drawn.lines[0], np.array([np.ptp(path.vertices[:, 1]) / 2 for path in bars.get_paths()])


def bands(axes):
    return [each for each in axes.collections if isinstance(each, PolyCollection)]


def colour(artist):
    return to_hex(artist.get_color())


def names(axes):
    return [text.get_text() for text in axes.get_legend().get_texts()]


def cycle(i):
    return to_hex(plt.rcParams["axes.prop_cycle"].by_key()["color"][i])


def linear(fit, n):
    """The amplitudes of linear loss, each exp(-pi (e/2)/sqrt(1 - e^2/4)) times the one before; the strength is e."""
    e = fit.theta[1]
    return first_of(fit) * np.exp(-np.pi * e / 2 / np.sqrt(1 - e * e / 4) * n)


def first_of(fit):
    return fit.model.seen.reference * np.exp(fit.theta[0])


def test_the_decay_has_its_points_and_an_envelope_about_the_rest_position(axes, pair):
    fit, run = pair[0].fit, seen()
    axes.plot([], [])
    plots._decay(axes, pair[0], "mm")
    _, upper, lower, points = axes.lines
    assert abs(fit.rest - OFFSET) < 2e-3
    for each, sign in ((upper, 1), (lower, -1)):
        n = each.get_xdata()
        assert (n[0], n[-1]) == (0, 12) and colour(each) == cycle(1)
        # Between turning points too: a polyline would lie above the envelope there.
        assert each.get_ydata() == pytest.approx(fit.rest + sign * linear(fit, n), rel=1e-6)
        assert each.get_linewidth() == 1
    assert np.array_equal(points.get_xdata(), run.n) and points.get_ydata() == pytest.approx(run.x, rel=1e-12)
    assert (points.get_marker(), points.get_markersize(), points.get_linestyle()) == ("o", 3, "None")
    assert names(axes) == ["envelope", "turning points"]
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("turning point n", "x (mm)")
    assert axes.get_title() == "decay and envelope of 1"
    axes.clear()
    plots._decay(axes, pair[0], "")
    assert axes.get_ylabel() == "x"


def test_decrements_are_those_of_neighbours_about_the_rest_position(axes, pair):
    """Two points are missing: nothing is measured across the gap."""
    run = seen()
    kept = np.flatnonzero(~np.isin(run.n, (4, 9)))
    (law,) = laws_of(replace(run, n=run.n[kept], x=run.x[kept]), "1")
    plots.draw_decrements(axes, [law], "mm")
    size = {n: abs(x - law.fit.rest) for n, x in zip(run.n[kept].tolist(), run.x[kept].tolist(), strict=True)}
    pairs = [(size[n], size[n + 1]) for n in size if n + 1 in size]
    measured, errors = dots(axes)
    # Of two points with one standard deviation each.
    assert errors == pytest.approx(np.full(8, np.sqrt(2) * law.fit.scales["x"]), rel=1e-6)
    assert measured.get_xdata() == pytest.approx([(a + b) / 2 for a, b in pairs], rel=1e-12)
    assert measured.get_ydata() == pytest.approx([a - b for a, b in pairs], rel=1e-9) and len(pairs) == 8
    assert (measured.get_marker(), measured.get_markersize(), measured.get_linestyle()) == ("o", 3, "None")
    assert measured.get_color() == "0.5"
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("mean amplitude (mm)", "decrement (mm)")
    assert axes.get_title() == "decrement against amplitude"
    drawn, curve = linear(law.fit, np.arange(13)), line(axes, "1")
    share = 2 * (drawn[0] - drawn[1]) / (drawn[0] + drawn[1])
    assert curve.get_ydata() == pytest.approx(share * curve.get_xdata(), rel=1e-6)
    assert curve.get_xdata()[0] == pytest.approx(drawn[0], rel=share / 2)
    assert curve.get_xdata()[-1] == pytest.approx(drawn[-1], rel=share / 2)


def test_each_law_has_its_colour_and_its_band_and_the_first_lies_in_front(axes):
    pair = laws_of(seen(), "1", "2")
    axes.plot([], [])
    plots.draw_decrements(axes, pair, "")
    assert names(axes) == ["1", "2", "measured"]
    curves = [line(axes, "1"), line(axes, "2")]
    assert [colour(each) for each in curves] == [cycle(0), cycle(1)]
    assert [each.get_linestyle() for each in curves] == ["-", "--"]
    assert [each.get_zorder() for each in curves] == pytest.approx([3.0, 2.9])
    for law, curve, band, i in zip(pair, curves, bands(axes), (0, 1), strict=True):
        amplitude, value, half = plots.decrement_band(law.fit, law.inflation)
        assert curve.get_xdata() == pytest.approx(amplitude, rel=1e-9)
        assert curve.get_ydata() == pytest.approx(value, rel=1e-7)
        corners = band.get_paths()[0].vertices
        for a, low, high in zip(amplitude, value - half, value + half, strict=True):
            own = corners[np.isclose(corners[:, 0], a, rtol=1e-9), 1]
            assert own.min() == pytest.approx(low, rel=1e-6) and own.max() == pytest.approx(high, rel=1e-6)
        assert to_hex(band.get_facecolor()[0]) == cycle(i) and band.get_alpha() == 0.25
        assert band.get_linewidth() == 0
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("mean amplitude", "decrement")


def test_a_band_is_what_the_covariance_makes_of_a_decrement_at_its_amplitude(pair):
    """By differences of the curve, not derivatives; 95 % by Student's t, and stretched as the intervals are."""
    fit = pair[1].fit

    def curve(theta):
        size = fit.model.amplitudes(theta)[0]
        return CubicSpline((size[1:] + size[:-1])[::-1] / 2, (size[:-1] - size[1:])[::-1])

    step, (mean, value, band) = 1e-4, plots.decrement_band(fit)
    moved = [(curve(fit.theta + step * e)(mean) - curve(fit.theta - step * e)(mean)) / (2 * step)
             for e in np.eye(len(fit.theta))]  # fmt: skip
    spread = [float(np.sqrt(s @ fit.covariance @ s)) for s in np.array(moved).T]
    assert value == pytest.approx(curve(fit.theta)(mean), rel=1e-3)
    assert band == pytest.approx(quantile(fit, 0.95, "x") * np.array(spread), rel=0.02)
    assert plots.decrement_band(fit, 2.5)[2] == pytest.approx(2.5 * band, rel=1e-12)


def left_of(law, share=0.05):
    left = Unexplained(share, np.array([0.6, 0.8, 1.0]), np.array([0.1, -0.2, 0.3]))
    return replace(law, verdict="refuted", evidence=Evidence(unexplained=left))


def test_what_a_refuted_law_leaves_is_shaded_from_its_decrement_to_the_measured_one(axes, pair):
    plots._draw_left(axes, left_of(pair[0]))
    (band,) = axes.collections
    assert band.get_label() == "measured: 1 is 5 % off on average"
    e = pair[0].fit.theta[1]
    q = np.exp(-np.pi * e / 2 / np.sqrt(1 - e * e / 4))
    corners = band.get_paths()[0].vertices
    for a, ratio in ((0.6, 0.1), (0.8, -0.2), (1.0, 0.3)):
        of_law = 2 * a * (1 - q) / (1 + q)  # the decrement at the mean amplitude a
        own = sorted(set(corners[np.isclose(corners[:, 0], a), 1].tolist()))
        assert [own[0], own[-1]] == pytest.approx(sorted([of_law, of_law * (1 + ratio)]), rel=1e-6)
    assert to_hex(band.get_facecolor()[0]) == cycle(3) and band.get_alpha() == 0.4 and band.get_linewidth() == 0


def test_nothing_is_shaded_where_nothing_is_left(axes, pair):
    one = left_of(pair[0])
    for law in (replace(one, verdict="consistent"), left_of(pair[0], 0.0), replace(one, evidence=Evidence())):
        plots._draw_left(axes, law)
        assert not axes.collections
    other = laws_of(seen(), "2")[0]
    plots.draw_decrements(axes, [one, other], "")  # the first law's alone
    assert sorted(names(axes)) == ["1", "2", "measured", "measured: 1 is 5 % off on average"]
    axes.clear()
    plots.draw_decrements(axes, [other, one], "")
    assert names(axes) == ["2", "1", "measured"]


def test_residuals_stand_at_their_times_in_standard_deviations(axes):
    run = replace(seen(1e-3), passage_n=np.arange(1, 12), passage_t=np.arange(1, 12) * np.pi + np.pi / 2)
    law = small_laws.law("1", fit_law(read("1"), run).fit)
    plots._residuals(axes, law)
    fit, zero = law.fit, axes.lines[-1]
    assert names(axes) == ["x", "t", "passage"]
    r = fit.residuals
    for label, place, own in (("x", run.t, r[:13]), ("t", run.t, r[13:26]), ("passage", run.passage_t, r[26:])):
        drawn = line(axes, label)
        assert np.array_equal(drawn.get_xdata(), place)
        assert drawn.get_ydata() == pytest.approx(own / fit.scales[label], rel=1e-12)
        assert (drawn.get_marker(), drawn.get_markersize(), drawn.get_linestyle()) == ("o", 3, "None")
    assert list(zero.get_ydata()) == [0, 0] and zero.get_color() == "0.5" and zero.get_linewidth() == 0.6
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("t (s)", "residual / standard deviation")
    assert axes.get_title() == "residuals of 1"
    plots._residuals(axes, laws_of(seen(), "1")[0])  # without times by their numbers
    assert axes.get_xlabel() == "turning point n" and np.array_equal(axes.lines[-2].get_xdata(), np.arange(13))


def test_residuals_of_samples_stand_at_their_times(axes):
    t, r = np.array([0.0, 0.5, 1.5]), np.array([0.3, -1.0, 2.0])
    model = SimpleNamespace(seen=SimpleNamespace(samples=Samples(t, r, 1.0, 1.0), time_unit=""))
    plots._residuals(axes, small_laws.law("1+2", SimpleNamespace(model=model, weighted=r)))
    points, zero = axes.lines
    assert np.array_equal(points.get_xdata(), t) and np.array_equal(points.get_ydata(), r)
    assert (points.get_marker(), points.get_markersize(), points.get_linestyle()) == (".", 2, "None")
    assert list(zero.get_ydata()) == [0, 0] and zero.get_color() == "0.5" and zero.get_linewidth() == 0.6
    assert names(axes) == ["3 samples"] and axes.get_title() == "residuals of 1+2"
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("t (s)", "residual / standard deviation")


def test_profiles_rise_to_the_height_at_which_the_printed_intervals_end(axes, pair):
    law = pair[1]
    axes.plot([], [])  # the colours are those of the losses, whatever was drawn before
    plots._profile(axes, law)
    labels = [f"epsilon of {name}: {shown_interval(e)}" for name, e in zip(("1", "2"), law.epsilon, strict=True)]
    curves = [line(axes, label) for label in labels]
    height = quantile(law.fit, 0.95, "x") ** 2
    marks = [each for each in axes.lines if each.get_marker() == "|"]
    levels = [each for each in axes.lines if each.get_color() == "0.5"]
    for i, (curve, ends, level, found) in enumerate(zip(curves, marks, levels, law.epsilon, strict=True)):
        change, rise = curve.get_xdata(), curve.get_ydata()
        assert len(change) == 13 and colour(curve) == colour(ends) == cycle(i)
        scale = abs(found.estimate)
        assert ends.get_xdata() == pytest.approx([(e - found.estimate) / scale for e in (found.low, found.high)])
        assert list(ends.get_ydata()) == pytest.approx([height] * 2) and ends.get_markersize() == 9
        assert ends.get_linestyle() == "None"
        assert list(level.get_ydata()) == pytest.approx([height] * 2) and level.get_linewidth() == 0.6
        assert rise[6] == 0 == change[6] and (np.diff(rise[:7]) < 0).all() and (np.diff(rise[6:]) > 0).all()
        # The profile itself passes through the ends: found by another search (_end), to 0.5 % of their height.
        assert np.interp(ends.get_xdata()[1], change[6:], np.sqrt(rise[6:])) == pytest.approx(np.sqrt(height), rel=0.02)
    assert names(axes) == [labels[0], "95 % interval", labels[1]]
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("relative change of the strength", "rise of chi squared")
    assert axes.get_title() == "profiles of 1+2"
    assert len(axes.get_xticks()) <= 6  # four intervals, and one beyond each end


def test_ends_without_a_limit_have_no_mark_and_a_strength_of_zero_its_own_scale(axes, pair):
    law = pair[0]
    zero = Interval(-0.001, 0.0, None)
    plots._profile(axes, replace(law, intervals=replace(law.intervals, epsilon=(zero,))))
    (marks,) = [each for each in axes.lines if each.get_marker() == "|"]
    assert list(marks.get_xdata()) == [-0.001] and len(marks.get_ydata()) == 1


def answer(*laws, per_run=(), chosen=()):
    said = " ".join(["word"] * 40)
    return SimpleNamespace(
        laws=[SimpleNamespace(law=law) for law in laws],
        of_the_verdict=[SimpleNamespace(law=law) for law in chosen],
        quality_in_words="Q = 3 at 1",
        per_run=per_run,
        runs=(),
        verdict=SimpleNamespace(text=said),
        units=SimpleNamespace(unit="mm", shown="mm"),
    )


def test_the_laws_of_the_verdict_are_shown_and_three_at_most(pair):
    one, two = pair
    other, third = laws_of(seen(), "2", "3")
    assert plots.shown_laws(answer(one, two, other, chosen=[other])) == [other]
    assert plots.shown_laws(answer(one, two, chosen=[other])) == [one, two]  # none is of the verdict: the first ones
    assert plots.shown_laws(answer(one, two, other, third)) == [one, two, other]
    unseen = one
    unfitted = small_laws.law("1", None)
    printed = small_laws.law("1", SimpleNamespace(model=SimpleNamespace(alternating=False)))
    assert plots.shown_laws(answer(unfitted, printed, unseen)) == [unseen]
    with pytest.raises(InputError, match="no single run of turning points"):
        plots.shown_laws(answer(unfitted, printed))


def test_the_panels_stand_in_two_rows_under_the_verdict(axes, pair):
    plots.draw_panels(answer(pair[1], pair[0], chosen=[pair[0]]), axes)
    places = [(p.get_subplotspec().rowspan.start, p.get_subplotspec().colspan.start) for p in axes.figure.axes]
    assert places == [(0, 0), (0, 1), (1, 0), (1, 1)]
    titles = ["decay and envelope of 1", "decrement against amplitude", "residuals of 1", "profiles of 1"]
    assert [panel.get_title() for panel in axes.figure.axes] == titles
    assert axes.get_ylabel() == "x (mm)" and axes.figure.axes[1].get_ylabel() == "decrement (mm)"
    (said,) = [axes.figure._suptitle]
    # 110 characters a line, and Q below the verdict.
    assert said.get_text() == "\n".join([" ".join(["word"] * 22), " ".join(["word"] * 18), "Q = 3 at 1"])
    assert said.get_fontsize() == 11


def test_axes_outside_of_a_grid_are_refused(pair):
    figure = plt.figure()
    with pytest.raises(InputError, match="not in a grid"):
        plots.draw_panels(answer(pair[0]), figure.add_axes((0, 0, 1, 1)))
    plt.close(figure)
