"""The quarter swing of one law from the nodes of an integral: in balls, and its bound a second time."""

import pytest
from flint import arb
from hypothesis import given
from hypothesis import strategies as st
from mpmath import mp
from numpy.polynomial import chebyshev

from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.nodes import _Ellipse, _Orders, _solved, node_quarter
from asymptotics.expansions.half_swings.one_law import even_quarter
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import parse_real


@pytest.mark.parametrize(("text", "bits"), [("3/2", 53), ("3", 100), ("1/3", 100), ("sqrt(7)", 53), ("2", 20)])
def test_the_balls_hold_those_of_the_sums(text, bits):
    """Few bits too; moved by a thousandth of themselves they would not."""
    law = parse_real(text, "alpha")
    R, T = node_quarter(law, 8, bits, 1.0)
    with ctx.workprec(200):
        other = quarter_swing([law], 8)
        for n in range(1, 9):
            for mine, ball in ((R[n], other.R[n]), (T[n], other.T_q[n])):
                assert mine.contains(ball.mid()) and mine.rad() < 2.0 ** (10 - bits)
                assert not mine.contains(ball * arb("1.001")) or mine.rad() > 1e-4 * abs(ball)


def test_the_nodes_agree_with_the_polynomials_to_high_order():
    R, T = node_quarter(parse_real("2", "alpha"), 40, 120, 0.1)
    exact_R, exact_T = even_quarter(2, 40)
    with ctx.workprec(300):
        for n in range(1, 41):
            for mine, true in ((R[n], arb(exact_R[n])), (T[n], exact_T[n].ball())):
                assert mine.contains(true) and mine.rad() * arb("0.1") ** n < 2.0**-118


@pytest.mark.parametrize("count", [4, 7])
def test_few_nodes_err_by_what_they_say(monkeypatch, count):
    """Their error is inside, is not nothing, and is left out where the bound is: the first order, nearly attained."""
    monkeypatch.setattr(_Ellipse, "nodes", lambda self, bits, lost=0: count)
    law = parse_real("3/2", "alpha")
    few = node_quarter(law, 6, 100, 0.3)
    monkeypatch.undo()
    for coarse, fine in zip(few, node_quarter(law, 6, 100, 0.3), strict=True):
        assert all(x.contains(y.mid()) for x, y in zip(coarse[1:], fine[1:], strict=True))
    monkeypatch.setattr(_Ellipse, "nodes", lambda self, bits, lost=0: count)
    monkeypatch.setattr(_Ellipse, "interpolation_error", lambda self, nodes, bound: arb(0))
    without = node_quarter(law, 6, 100, 0.3)
    monkeypatch.undo()
    for coarse, fine in zip(without, node_quarter(law, 6, 100, 0.3), strict=True):
        assert not any(x.overlaps(y) for x, y in zip(coarse[1:], fine[1:], strict=True))


def test_the_bounds_in_the_ellipse_are_their_formulas():
    """Orders 1 and 2 by hand, from the largest |c|, |1 - v| and |v|, which are reached at the ends."""
    a, rho, small = mp.mpf("1.5"), mp.mpf(4), mp.mpf("0.25")
    with ctx.workprec(64):
        e = _Ellipse.of(arb("1.5"), arb(4), 2, arb("0.25"))
    with mp.workdps(30):
        half_axis = (rho + 1 / rho) / 8
        v, far, cosine = half_axis + mp.mpf(1) / 4, half_axis + mp.mpf(3) / 4, 2 * half_axis + mp.mpf(1) / 2
        y_1 = small * (2 * far) ** (a / 2)
        p_1 = 2 * (a - 1) * v * y_1 / (a / 2 + 1)
        y_2 = y_1 * (p_1 + cosine * y_1)
        near = 1 / mp.sqrt(1 - v)
        wanted = [(e.C[1], y_1), (e.C[2], y_2 + p_1 * y_1), (e.rates[1], near * cosine * y_1)]
        wanted += [
            (e.rates[2], near * cosine * y_2),
            (e.interpolation_error(9, arb(5)), 4 * 5 * rho ** (-8) / (rho - 1)),
        ]
        for ball, value in wanted:
            assert value <= mp.mpf(ball.upper().str(25, radius=False)) * (1 + mp.mpf(10) ** -17)
            assert mp.mpf(ball.upper().str(25, radius=False)) < value * (1 + mp.mpf(10) ** -12)
        for x in (-1, 1):  # the ends of the ellipse: |c|, |1 - v|, |v| reach their bounds there
            z = mp.mpf(1) / 4 + x * half_axis
            assert max(abs(1 - 2 * z) - cosine, abs(1 - z) - far, abs(z) - v) <= 1e-25


def test_the_error_of_an_integral_is_that_of_its_function():
    """At the first order T_1 = 1/(alpha + 1) and R_1: two errors known in advance, from the bound by hand."""
    law, count = parse_real("3/2", "alpha"), 9
    with ctx.workprec(64):
        e = _Ellipse.of(arb("1.5"), arb("5.5"), 1, arb(1))
        orders = _Orders(arb("1.5"), arb(1), e, count)
        ends, durations = orders.through(1)
        of_p = arb("0.5") * e.interpolation_error(count, e.C[1]) / (arb("0.75") + 1)  # |eta|/beta
        of_T = e.interpolation_error(count, e.rates[1]) / arb("1.25") / arb(2).sqrt()
    assert float(ends[1].rad()) == pytest.approx(float(of_p), rel=1e-6)
    assert float(durations[1].rad()) == pytest.approx(float(of_T), rel=1e-6)
    assert durations[1].contains(arb(2) / 5) and node_quarter(law, 1, 60, 1.0)[1][1].overlaps(arb(2) / 5)


@given(st.lists(st.integers(-9, 9), min_size=1, max_size=6), st.integers(1, 40))
def test_the_integral_of_a_polynomial_solves_its_equation(f, twice_beta):
    """beta h + (x + 1) h' = f, by the Chebyshev polynomials of another library."""
    h = [float(x) for x in _solved([arb(x) for x in f], arb(twice_beta) / 2)]
    slope = chebyshev.chebmul([1, 1], chebyshev.chebder(h)) if len(h) > 1 else [0.0]
    left = chebyshev.chebadd(chebyshev.chebmul([twice_beta / 2], h), slope)
    right = [f[0] / 2, *f[1:]]
    for z in (-1.0, -0.3, 0.6, 1.0):
        assert chebyshev.chebval(z, left) == pytest.approx(chebyshev.chebval(z, right), abs=1e-9)
