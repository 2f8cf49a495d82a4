"""Profile intervals against those of MINOS."""

import numpy as np
import pytest
from iminuit import Minuit

import asymptotics as asy
from asymptotics.decays.identification.fitting.profile import profile_interval, quantile
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.judging.laws import strength
from asymptotics.decays.identification.judging.single_fits import fit_law
from asymptotics.decays.identification.synthetic import observed


def test_profile_intervals_are_those_of_minos():
    seen = observed("1+2", [0.01, 0.02], 60, 5e-3, seed=2)
    fit = fit_law(read_candidate("1+2"), seen).fit
    sigma = fit.model.scale_vector(fit.scales)

    def chi2(theta):
        return float((((fit.model.data - fit.model.predict(np.array(theta))[0]) / sigma) ** 2).sum())

    minuit = Minuit(chi2, fit.theta)
    minuit.errordef = quantile(fit, 0.95, "x") ** 2
    minuit.migrad()
    minuit.minos()
    for i in (0, 1):
        mine = profile_interval(fit, strength(fit_law(read_candidate("1+2"), seen).candidate, i, seen.reference))
        scale = seen.reference ** -fit.model.swing.elements[i].weight
        errors = minuit.merrors[1 + i]
        assert mine.low - mine.estimate == pytest.approx(errors.lower * scale, rel=0.02)
        assert mine.high - mine.estimate == pytest.approx(errors.upper * scale, rel=0.02)


def test_strengths_that_the_data_hardly_see_have_long_intervals_and_refute_nothing():
    # 30 swings lose a twentieth of the amplitude: four losses can hardly be told apart, and the true one is 0.001 alone
    law = asy.identify(observed("1", [1e-3], 30, 1e-6, seed=1), laws=["1", "0+1+2+3"]).law("0+1+2+3").law
    assert law.verdict == "consistent"
    assert all(e.contains(true) for e, true in zip(law.epsilon, [0.0, 1e-3, 0.0, 0.0], strict=True))
    assert all(e.high - e.low > 0.05 for e in law.epsilon)
