"""The matrices of integration, in balls."""

import pytest
from flint import arb, arb_mat, arb_poly, ctx, fmpz_poly

from asymptotics.return_map.chebyshev import nodes
from asymptotics.return_map.spectral import analysis, integrals, of_the_integral


@pytest.mark.parametrize("m", [2, 3, 8])
def test_the_matrices_of_integration(m):
    """T_k has the coefficients e_k, and its integral from -1 is that of the polynomial."""
    with ctx.workprec(80):
        T = [arb_poly(fmpz_poly.chebyshev_t(k)) for k in range(m + 1)]
        unit = analysis(m, 80) * arb_mat([[p(t) for p in T[:m]] for t in nodes(m)])
        sums = integrals(m, 80)
        for k in range(m):
            whole = T[k].integral()
            for j, t in enumerate([*nodes(m), arb(1)]):
                assert (sums[j, k] - whole(t) + whole(arb(-1))).contains(0) and sums[j, k].rad() < 1e-20
                assert j == m or ((unit[j, k] - int(j == k)).contains(0) and unit[j, k].rad() < 1e-20)
        b = [arb(k + 1) for k in range(m)]
        whole = sum((c * p for c, p in zip(b, T, strict=False)), arb_poly([])).integral()
        again = sum((c * p for c, p in zip(of_the_integral(b), T[1:], strict=True)), arb_poly([]))
        assert all((whole - again)[k].contains(0) for k in range(1, m + 1))
