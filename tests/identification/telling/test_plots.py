"""The picture of an identification."""

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.errors import InputError
from asymptotics.identification.fitting.profile import quantile
from asymptotics.identification.synthetic import observed
from asymptotics.identification.telling.plots import decrement_band


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
