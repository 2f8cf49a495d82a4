"""The picture of an identification."""

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.errors import InputError
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
