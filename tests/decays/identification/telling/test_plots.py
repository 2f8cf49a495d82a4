"""The picture of an identification."""

from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.fitting.profile import quantile
from asymptotics.decays.identification.synthetic import observed
from asymptotics.decays.identification.telling.plots import _profile, decrement_band, draw_decrements
from asymptotics.errors import InputError


def test_the_picture_is_drawn():
    answer = asy.identify(observed("1+2", [0.01, 0.02], 40, 1e-3, seed=1), laws=["1", "1+2"])
    svg = answer.picture("svg", panels=True)
    assert svg.startswith(b"<?xml")
    mean, decrement, band = decrement_band(answer.law("1+2").law.fit)
    first_order = np.pi / 2 * 0.01 * mean + 4 / 3 * 0.02 * mean**2
    assert (np.abs(decrement - first_order) < 3 * band + 0.02 * first_order).all()
    with pytest.raises(InputError, match="plot"):
        asy.identify([observed("1", [0.01], 30, 1e-3, seed=s) for s in (1, 2)], laws=["1"]).picture()


def test_pictures_have_the_quantile_of_the_intervals():
    # ten turning points leave so few freedoms that 1.96 would be far too short
    answer = asy.identify(observed("1", [0.05], 8, 1e-3, seed=4), laws=["1"], bootstrap=False)
    fit = answer.law("1").law.fit
    t = quantile(fit, 0.95, "x")
    assert t > 2.3
    slopes = fit.model.amplitudes(fit.theta)[1]
    gradient = np.zeros(fit.model.size)
    gradient[: fit.model.after] = slopes[:, 0] - slopes[:, 1]
    assert decrement_band(fit)[2][0] == pytest.approx(t * fit.directions.standard_error(gradient), rel=1e-9)


def test_pictures_have_intervals_as_long_as_those_that_are_printed():
    """Residuals that remember stretch the intervals: three times, in a band and at the ends of a profile."""
    law = asy.identify(observed("1", [0.05], 20, 1e-3, seed=4), laws=["1"], bootstrap=False).law("1").law
    ends = replace(law.intervals, stretches=(3.0,), epsilon=(law.epsilon[0].stretched(3.0),))
    longer = replace(law, intervals=ends)
    heights, ends = [], []
    for each in (law, longer):
        figure, (band, profile) = plt.subplots(1, 2)
        draw_decrements(band, [each], "")
        _profile(profile, each)
        (outline,) = band.collections[0].get_paths()
        x, y = outline.vertices.T
        heights.append(np.ptp(y[x == np.median(x)]))
        (marks,) = [line.get_xdata() for line in profile.lines if line.get_marker() == "|"]
        ends.append(np.array(marks))
        plt.close(figure)
    assert heights[1] == pytest.approx(3 * heights[0], rel=1e-6)
    assert ends[1] == pytest.approx(3 * ends[0], rel=1e-6) and ends[0][0] < 0 < ends[0][1]
