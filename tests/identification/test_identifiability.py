"""What swings can tell: the bound of Fisher, and how many are needed."""

import numpy as np

from asymptotics.identification.forward.candidates import read_candidate
from asymptotics.identification.identifiability import standard_errors, swings_needed
from asymptotics.identification.judging.comparison import fit_law
from asymptotics.identification.synthetic import observed


def test_the_scatter_of_estimates_is_the_fisher_bound():
    bound = standard_errors("1+2", [0.01, 0.02], swings=60, noise=1e-3)
    found = []
    for seed in range(60):
        fit = fit_law(read_candidate("1+2"), observed("1+2", [0.01, 0.02], 60, 1e-3, seed=seed)).fit
        found.append(fit.theta[fit.model.law])
    ratio = np.std(found, axis=0) / bound
    assert ((ratio > 0.75) & (ratio < 1.3)).all()


def test_more_noise_needs_more_swings():
    needed = [swings_needed("1+2", [0.002, 0.02], term=0, noise=noise) for noise in (3e-4, 1e-3, 3e-3)]
    assert needed == sorted(needed)
    assert needed[0] < needed[-1]
