"""The panel of the backbone: periods of a law and of the envelope, each by a second route."""

from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np
import pytest
from matplotlib.collections import PolyCollection
from scipy.interpolate import CubicSpline

from asymptotics.decays.identification.fitting.profile import quantile
from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.judging.single_fits import fit_law
from asymptotics.decays.identification.synthetic import observed
from asymptotics.decays.identification.telling import plots
from asymptotics.decays.identification.telling.drawn_backbone import backbone_band, draw_backbone
from asymptotics.decays.identification.telling.envelope import envelope
from tests.decays.identification import small_laws
from tests.decays.identification.telling.test_drawn_panels import answer, laws_of

RUN = observed("1", [0.05], 12, 1e-3, 1e-3, seed=4, x0=1.3)


@pytest.fixture
def axes():
    figure, axes = plt.subplots()
    yield axes
    plt.close(figure)


def test_linear_loss_has_one_period(axes):
    law = small_laws.law("1", fit_law(read("1"), RUN).fit)
    amplitude, period, _ = backbone_band(law.fit)
    e, omega = law.fit.theta[1], np.exp(law.fit.theta[-2])
    assert period == pytest.approx(np.full(len(amplitude), 2 * np.pi / np.sqrt(1 - e * e / 4) / omega), rel=1e-9)
    # As far as the dots of the envelope stand: to the first amplitude, and the last.
    size = law.fit.model.amplitudes(law.fit.theta)[0]
    assert (amplitude[0], amplitude[-1]) == pytest.approx((size[0], size[-1]), rel=0.045)  # half a step
    draw_backbone(axes, [law], "mm")
    assert axes.lines[0].get_ydata() == pytest.approx(period)
    assert (axes.get_xlabel(), axes.get_ylabel()) == ("amplitude (mm)", "period (s)")
    assert [text.get_text() for text in axes.get_legend().get_texts()] == ["1", "before any law"]


def test_a_band_is_what_the_covariance_makes_of_a_period():
    """By differences of the curve through the half-swings instead of its derivatives."""
    fit = fit_law(read("1+s3"), RUN).fit

    def curve(theta):
        size, times = fit.model.amplitudes(theta)[0], fit.model.turning_times(theta)
        return CubicSpline(np.sqrt(size[1:] * size[:-1])[::-1], 2 * np.diff(times)[::-1])

    step, (amplitude, value, band) = 1e-5, backbone_band(fit)
    unit = np.eye(len(fit.theta))
    slopes = [
        (curve(fit.theta + step * e)(amplitude) - curve(fit.theta - step * e)(amplitude)) / (2 * step) for e in unit
    ]
    spread = np.array([np.sqrt(s @ fit.covariance @ s) for s in np.array(slopes).T])
    assert value == pytest.approx(curve(fit.theta)(amplitude), rel=1e-6)
    assert band == pytest.approx(quantile(fit, 0.95, "t") * spread, rel=0.01)
    assert backbone_band(fit, 2.5)[2] == pytest.approx(2.5 * band, rel=1e-12)


def test_the_three_periods_before_any_law_have_their_intervals_and_the_unit_of_the_file(axes):
    run = replace(RUN, time_unit="ms")
    law = small_laws.law("1", fit_law(read("1"), run).fit)
    draw_backbone(axes, [law], "")
    rows = envelope(run).backbone
    (drawn,) = axes.containers
    assert drawn.lines[0].get_ydata() == pytest.approx([row["estimate"] for row in rows], rel=1e-12)
    (bars,) = drawn.lines[2]
    ends = [path.vertices[:, 1] for path in bars.get_paths()]
    assert np.array(ends) == pytest.approx(np.array([[row["low"], row["high"]] for row in rows]), rel=1e-9)
    assert axes.get_ylabel() == "period (ms)"
    assert axes.lines[0].get_ydata() == pytest.approx(1e3 * backbone_band(law.fit)[1], rel=1e-12)
    assert len([each for each in axes.collections if isinstance(each, PolyCollection)]) == 1


def test_the_fifth_panel_is_there_where_there_are_times(axes):
    timed = laws_of(RUN, "1")
    plots.draw_panels(answer(*timed, chosen=timed), axes)
    titles = [panel.get_title() for panel in axes.figure.axes]
    assert titles[-1] == "backbone: period against amplitude"
    assert len(titles) == 5
    places = [panel.get_subplotspec() for panel in axes.figure.axes]
    shown = [(place.rowspan.start, place.colspan.start, place.colspan.stop) for place in places]
    assert shown == [(0, 0, 1), (0, 1, 2), (1, 0, 1), (1, 1, 3), (0, 2, 3)]
