"""The flow from Fourier coefficients: each gauge is what its bracket says, and other forces are refused."""

import pytest

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.fourier_flow import fourier_flow
from asymptotics.gauges import GAUGES


@pytest.mark.parametrize("alphas", [(3,), (1, 3), (5,)])
@pytest.mark.parametrize("gauge", ["averaging", "no-first-harmonic"])
def test_a_gauge_is_what_its_bracket_says(alphas, gauge):
    """In its own gauge the mean that defines it is 1 through every order, and in no other."""
    for own in GAUGES:
        bracket = fourier_flow(alphas, 4, own).bracket(gauge)
        assert (bracket.coefficients == {(0,) * len(alphas): 1}) == (own == gauge)


@pytest.mark.parametrize("alphas", [(2,), (0,), (1, 2), (-1,)])
def test_the_fourier_route_refuses_what_is_not_odd(alphas):
    # It would otherwise return U = delta/2 for alpha = 2, where -4/(3 pi) delta is right.
    with pytest.raises(InputError, match="odd integers|negative"):
        fourier_flow(alphas, 2)
