"""How many parameters the data bear: the criteria by hand, and a choice that counts the noise as one of them."""

from math import inf, log

import numpy as np
import pytest

from asymptotics.decays.identification.measuring.criteria import aicc, bic, chosen


@pytest.mark.parametrize(("k", "n", "value"), [(2, 7, 10 + 4 + 12 / 4), (3, 5, 10 + 6 + 24), (3, 4, inf), (4, 4, inf)])
def test_the_small_sample_term_is_that_of_hurvich_and_tsai(k, n, value):
    assert aicc(10.0, k, n) == value and bic(10.0, k, n) == pytest.approx(10 + k * log(n))


def test_of_two_bases_the_one_with_the_least_criterion_is_chosen():
    rng = np.random.default_rng(1)
    u = np.linspace(-1, 1, 40)
    bases = [np.vander(u, d + 1, increasing=True) for d in range(5)]
    for degree in (0, 1, 3):
        y = bases[degree].sum(axis=1) + 1e-3 * rng.standard_normal(40)
        c, rss, parameters = chosen(bases, y, bic)
        assert len(c) == degree + 1 and parameters == degree + 2  # the noise is a parameter too
        assert c == pytest.approx(np.ones(degree + 1), abs=5e-3) and rss == pytest.approx(
            ((y - bases[degree] @ c) ** 2).sum()
        )


def test_the_criterion_is_asked_with_the_deviance_the_parameters_and_the_data():
    asked, y = [], np.array([1.0, -1, 1, -1])
    chosen([np.ones((4, 1)), np.eye(4)], y, lambda *given: asked.append(given) or 0.0)
    assert asked[0] == (4 * log(4 / 4), 2, 4) and asked[1][1:] == (5, 4) and asked[1][0] < -1000  # nothing is left


def test_of_equals_the_first_is_chosen_and_of_none_that_is_finite_none():
    bases = [np.ones((4, 1)), np.eye(4)]
    assert len(chosen(bases, np.ones(4), lambda *_: 1.0)[0]) == 1
    assert chosen(bases, np.ones(4), lambda *_: inf) is None and chosen([], np.ones(4), bic) is None
