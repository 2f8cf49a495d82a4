"""What swings can tell: the bound of Fisher, and how many are needed."""

from dataclasses import replace

import numpy as np
import pytest

from asymptotics.decays.identification.fitting.profile import coordinate, wald_interval
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.identifiability import standard_errors, swings_needed
from asymptotics.decays.identification.judging.single_fits import fit_law
from asymptotics.decays.identification.synthetic import observed


def test_the_scatter_of_estimates_is_the_fisher_bound():
    bound = standard_errors("1+2", [0.01, 0.02], swings=60, noise=1e-3)
    found = []
    for seed in range(40):
        fit = fit_law(read_candidate("1+2"), observed("1+2", [0.01, 0.02], 60, 1e-3, seed=seed)).fit
        found.append(fit.theta[fit.model.law])
    ratio = np.std(found, axis=0) / bound
    assert ((ratio > 0.75) & (ratio < 1.3)).all()


def test_more_noise_needs_more_swings():
    needed = [swings_needed("1+2", [0.002, 0.02], term=0, noise=noise) for noise in (3e-4, 1e-3, 3e-3)]
    assert needed == sorted(needed)
    assert needed[0] < needed[-1]


@pytest.mark.parametrize(
    ("law", "strengths", "term", "noise"),
    [
        ("0+1", [0.04, 0.02], 1, 0.012),  # the motion ends after the 10 swings that are enough
        ("0+1", [0.04, 0.02], 1, 0.1),  # and before those that would be
        ("1", [0.04], 0, 1e-3),
        ("1+2", [0.01, 0.02], 1, 1e-5),
    ],
)
def test_the_least_number_of_swings_is_the_first_that_is_enough(law, strengths, term, noise):
    def enough(swings):
        try:
            return strengths[term] > 3.24 * standard_errors(law, strengths, swings=swings, noise=noise)[term]
        except TooStrongError:
            return False

    first = next((n for n in range(1, 20) if enough(n)), None)
    assert swings_needed(law, strengths, term=term, noise=noise) == first


def test_strengths_that_the_data_do_not_see_have_no_limit():
    # two turning points and three parameters; two losses of one exponent
    assert np.isinf(standard_errors("1+2", [0.01, 0.02], swings=1, noise=1e-6)).all()
    fit = fit_law(read_candidate("1+2"), observed("1+2", [0.01, 0.02], 30, 1e-4)).fit
    slopes = fit.slopes.copy()
    slopes[:, 2] = slopes[:, 1]
    blind = replace(fit, slopes=slopes)
    for i, seen in ((1, False), (2, False), (3, True)):
        assert (wald_interval(blind, coordinate(i)).low is not None) is seen
