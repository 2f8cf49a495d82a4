"""How far one law contradicts another: the ratio, what relieves it, and its probability, each by its own formula."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.stats import chi2, f

from asymptotics.decays.identification.forward.candidates import read_candidate as read
from asymptotics.decays.identification.judging.contradiction import contradiction, further_parameters
from tests.each import each


def fit(likelihood, *, known=False, squares=50.0, sizes=(40,), freedoms=(37.0,)):
    """Of so many residuals in groups; the sum of squares is in units of the noise."""
    stops = np.cumsum(sizes)
    groups = [slice(int(stop - size), int(stop)) for stop, size in zip(stops, sizes, strict=True)]
    kinds = ["x", "t", "passage"][: len(sizes)]
    return SimpleNamespace(
        log_likelihood=likelihood,
        chi2=squares,
        known=known,
        residuals=np.zeros(sum(sizes)),
        model=SimpleNamespace(groups=groups, kinds=kinds),
        freedoms=dict(zip(kinds, freedoms, strict=True)),
    )


def test_the_probability_of_a_ratio_is_that_of_chi_squared_where_the_noise_is_known():
    found = contradiction(read("1"), fit(10.0, known=True), read("1+2"), fit(13.0, known=True))
    assert (found.ratio, found.terms) == (6.0, 1) and found.p == pytest.approx(chi2.sf(6.0, 1), rel=1e-12)
    found = contradiction(read("1"), fit(10.0, known=True), read("1+2+3"), fit(13.0, known=True))
    assert found.terms == 2 and found.p == pytest.approx(chi2.sf(6.0, 2), rel=1e-12)


def test_with_noise_from_the_residuals_it_is_that_of_f_in_the_smallest_group():
    better = fit(13.0, sizes=(40, 12), freedoms=(37.0, 9.0))
    found = contradiction(read("1"), fit(10.0, sizes=(40, 12), freedoms=(38.0, 10.0)), read("1+2"), better)
    assert found.p == pytest.approx(f.sf(np.expm1(6.0 / 12) * 9.0, 1, 9.0), rel=1e-12)
    few = fit(13.0, sizes=(40, 12), freedoms=(37.0, 0.25))  # no freedom left: that of one datum
    found = contradiction(read("1"), fit(10.0, sizes=(40, 12), freedoms=(38.0, 1.0)), read("1+2"), few)
    assert found.p == pytest.approx(f.sf(np.expm1(6.0 / 12), 1, 1.0), rel=1e-12)


@pytest.mark.parametrize(("law", "by", "better"), [("1", "1+2", 10.0), ("1", "1+2", 8.0), ("1+2", "1", 13.0)])
def test_nothing_is_contradicted_by_a_worse_law_or_one_without_a_further_parameter(law, by, better):
    found = contradiction(read(law), fit(10.0), read(by), fit(better))
    assert found.p == 1.0 and found.ratio == max(2 * (better - 10.0), 0.0)


def test_residuals_that_remember_divide_the_ratio_by_the_square_of_what_they_stretch():
    plain, stretched = (
        contradiction(read("1"), fit(10.0, known=True), read("2"), fit(14.0, known=True), inflation=s) for s in (1, 2)
    )
    assert (plain.ratio, stretched.ratio) == (8.0, 2.0) and stretched.p == pytest.approx(chi2.sf(2.0, 1), rel=1e-12)


@pytest.mark.parametrize(("known", "relief"), [(True, 50.0 * 0.1), (False, -40 * np.log(0.9))])
def test_what_the_data_cannot_show_is_taken_off_the_ratio(known, relief):
    """A share of the sum of squares where the scale is known; else N ln of the share."""
    found = contradiction(read("1"), fit(10.0, known=known), read("2"), fit(14.0, known=known), left=0.9)
    assert found.ratio == pytest.approx(8.0 - relief, rel=1e-12)
    assert contradiction(read("1"), fit(10.0), read("2"), fit(14.0), left=0.0).ratio == 0.0


@each(
    ("larger", "law", "count"),
    [
        ("free", "free", 0), ("free+s3", "free", 1), ("free", "1+2", 2), ("free", "1,2:", 2), ("1", "free", 0),
        ("1,2:", "free", 1), ("1+2", "free", 2), ("7", "free", 1), ("free", "7", 2), ("pendulum+1", "1", 1),
        ("1", "pendulum+1", 1), ("1+s3+s5", "1+s3", 1), ("1+s3", "2+s3", 1), ("0+1", "1+2", 1),
    ],
)  # fmt: skip
def test_further_parameters_are_counted_once(larger, law, count):
    assert further_parameters(read(larger), read(law)) == count
