"""The quarter swing of one law by the reciprocal of its strength: exact, in balls, and its bound a second time."""

import pytest
from flint import arb, fmpq_poly
from mpmath import mp

from asymptotics.half_swings import one_law
from asymptotics.half_swings.certified import quarter_swing
from asymptotics.half_swings.exact import exact_quarter_swing
from asymptotics.half_swings.one_law import even_quarter, real_quarter
from asymptotics.half_swings.pi_ring import PiNumber
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import parse_real


@pytest.mark.parametrize("alpha", [0, 2, 4])
def test_even_exponents_agree_with_polynomials_in_theta(alpha):
    exact, (R, T) = exact_quarter_swing((alpha,), 7), even_quarter(alpha, 7)
    assert [exact.R[n] for n in range(1, 8)] == [PiNumber.rational(x) for x in R[1:]]
    assert [exact.T_q[n] for n in range(8)] == T


@pytest.mark.parametrize(("text", "bits"), [("3/2", 53), ("3", 100), ("1/3", 100), ("sqrt(7)", 53), ("2", 20)])
def test_the_balls_hold_those_of_the_sums(text, bits):
    """Few bits too; moved by a thousandth of themselves they would not."""
    law = parse_real(text, "alpha")
    R, T = real_quarter(law, 8, bits, 1.0)
    with ctx.workprec(200):
        other = quarter_swing([law], 8)
        for n in range(1, 9):
            for mine, ball in ((R[n], other.R[n]), (T[n], other.T_q[n])):
                assert mine.contains(ball.mid()) and mine.rad() < 2.0 ** (10 - bits)
                assert not mine.contains(ball * arb("1.001")) or mine.rad() > 1e-4 * abs(ball)


def test_the_bound_of_a_coefficient_is_its_formula():
    """B_1 = kappa^alpha |eta| |g| |sigma^alpha| in mpmath; B_2 has |c| |y_1| besides; four terms lie within."""
    law = parse_real("3/2", "alpha")
    with ctx.workprec(64):
        Q, T = one_law._bounds(law, 2, 4)
    with mp.workdps(30):
        kappa, a, size = mp.pi / 2, mp.mpf("1.5"), mp.pi  # theta at |t| = 4
        g, sigma, c = size * mp.sinh(size), (mp.sinh(size) / size) ** a, mp.cosh(size)
        wanted = [kappa**a * (a - 1) * g * sigma, kappa ** (2 * a) * (a - 1) * g * sigma * c * sigma]
        for n, value in enumerate(wanted, 1):
            assert value <= mp.mpf(Q[(n,)].str(25, radius=False)) * (1 + 1e-15) < value * (1 + 1e-12)
        assert abs(mp.mpf(T[(1,)].str(25, radius=False)) / (kappa ** (a + 1) * c * sigma) - 1) < 1e-15
    few, many = (one_law._orders(law.ball(), 3, terms)[0] for terms in (5, 60))
    for n in (1, 2):
        x = arb.pi() / 2
        rest = abs(sum(many[n].coeffs(), arb(0)) - sum(few[n].coeffs(), arb(0))) * x ** (n * law.ball())
        assert 0 < rest < Q[(n,)] * arb(4) ** -4 / (2 * 5 * 3)


def test_a_rate_that_is_no_polynomial_is_noticed(monkeypatch):
    monkeypatch.setattr(one_law, "_half_of_the_square", lambda q, n: fmpq_poly([0, n]))
    with pytest.raises(ArithmeticError, match="polynomial"):
        even_quarter(2, 3)
