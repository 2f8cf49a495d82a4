"""The quarter swing of one law with an even exponent by the reciprocal of its strength: exact."""

import pytest
from flint import fmpq_poly

from asymptotics.expansions.half_swings import one_law
from asymptotics.expansions.half_swings.exact import exact_quarter_swing
from asymptotics.expansions.half_swings.one_law import even_quarter
from asymptotics.expansions.half_swings.pi_ring import PiNumber


@pytest.mark.parametrize("alpha", [0, 2, 4])
def test_even_exponents_agree_with_polynomials_in_theta(alpha):
    exact, (R, T) = exact_quarter_swing((alpha,), 7), even_quarter(alpha, 7)
    assert [exact.R[n] for n in range(1, 8)] == [PiNumber.rational(x) for x in R[1:]]
    assert [exact.T_q[n] for n in range(8)] == T


def test_a_rate_that_is_no_polynomial_is_noticed(monkeypatch):
    monkeypatch.setattr(one_law, "_half_of_the_square", lambda q, n: fmpq_poly([0, n]))
    with pytest.raises(ArithmeticError, match="polynomial"):
        even_quarter(2, 3)
