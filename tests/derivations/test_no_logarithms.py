"""psi without a logarithm grows by pi over an exact half-swing, through delta^7 (derivation no-logarithms)."""

import pytest

from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.half_swings.pi_ring import PI
from asymptotics.expansions.normal_form.flow import flow_of
from asymptotics.series import Series

ORDER = 8


def abel_defect(U, half, a):
    """delta (Psi(F) - Psi(delta) - pi) with Psi = int d delta/V = E(delta)/delta, a = alpha - 1."""
    V = U * a
    quotient = Series({(n - 1,): x for (n,), x in V.coefficients.items()}, 1, ORDER - 1).inverse()  # delta^2/V
    E = quotient.map_keys(lambda k, x: x / (k[0] - 1))
    growth = (half.L.truncate(ORDER - 1) * -a).exp()  # delta/F
    pi_delta = Series({(1,): PI}, 1, ORDER - 1)
    return growth * E.compose((half.F[0].truncate(ORDER - 1),)) - E - pi_delta


@pytest.mark.parametrize("alpha", [0, 2, 3])
def test_psi_without_a_logarithm_grows_by_pi_over_a_half_swing(alpha):
    half = exact_half_swing((alpha,), ORDER)
    F, U = half.F[0], flow_of(half).U
    assert F[3] == F[2] * F[2] and F[2] != 0
    assert not any(abel_defect(U, half, alpha - 1).coefficients.values())
    near_miss = abel_defect(U + Series({(5,): PI}, 1, ORDER), half, alpha - 1)
    assert any(near_miss.coefficients.values())
