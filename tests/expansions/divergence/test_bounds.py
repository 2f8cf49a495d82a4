"""The bounds behind the constants: contained at few bits and terms, evaluated a second time, near the truth."""

import mpmath
import pytest
from flint import acb, arb
from mpmath import mp

from asymptotics.errors import UndecidedError
from asymptotics.expansions.divergence.abel import at, at_height, later, odd_series
from asymptotics.expansions.divergence.constants import _solved, effort, rough_petal
from asymptotics.expansions.divergence.germ import germ, majorants
from asymptotics.expansions.divergence.half_step import half_step, share, tail
from asymptotics.expansions.divergence.petal import petal, quadratic_bound
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import parse_real

DRAG = parse_real("2", "alpha")


def number(x):
    return mp.mpf(x.mid().str(40, radius=False))


@pytest.mark.parametrize("bits", [20, 53, 120])
@pytest.mark.parametrize("delta", ["0.2j", "0.1+0.1j", "0.15-0.05j"])
def test_a_half_swing_at_complex_strength_holds_smiths_map(bits, delta):
    """Few terms and bits, wide input: the true value is inside; with twelve terms the tail is what counts."""
    z = complex(delta)
    with ctx.workprec(bits):
        g = germ(DRAG, 12, bits, 0.3)
        point = acb(arb(z.real), arb(z.imag))
        F, tau = half_step(g, point)
        wide, _ = half_step(g, point * (1 + arb(0, arb(2) ** -6)))
    with mp.workdps(50):
        x = 1 + 2 * mp.mpc(z)
        truth = (1 + mpmath.lambertw(-x * mpmath.exp(-x))) / 2
    with ctx.workprec(160):
        exact = acb(arb(mp.nstr(truth.real, 45)), arb(mp.nstr(truth.imag, 45)))
        assert F.contains(exact.mid()) and wide.contains(exact.mid())
        assert abs(F - exact).upper() < 1e-3 and tau.real.is_finite()
        if bits == 120:  # the enclosure is not wider than a few thousand times the error of the truncated series
            polynomial = acb(0)
            for coefficient in reversed(g.F):
                polynomial = polynomial * point + coefficient
            assert F.real.rad() < 1e4 * abs(polynomial - exact).upper()


def test_the_tail_of_cauchy_is_its_formula_and_ends_at_the_circle():
    x, size, K = mp.mpf("0.3") / mp.mpf("0.4"), mp.mpf("0.7"), 9
    found = tail(arb("0.7"), acb(0, arb("0.3")), arb("0.4"), K)
    assert size * x ** (K + 1) / (1 - x) <= number(found) * (1 + mp.mpf(10) ** -15)
    assert number(found) < size * x ** (K + 1) / (1 - x) * (1 + mp.mpf(10) ** -12)
    assert share(acb(0, arb("0.3")), arb("0.4")) >= 0.75
    with pytest.raises(UndecidedError, match="outside"):
        share(acb(0, arb("0.4")), arb("0.4"))


@pytest.mark.parametrize("text", ["2", "3/2", "1/2"])
def test_the_numbers_of_a_petal_are_those_of_its_definition(text):
    """b, lambda, s, s_T, Y_0 a second time in mpmath, from the coefficients and the majorant."""
    g, p = rough_petal(parse_real(text, "alpha"))
    quarter, half = majorants(g.alpha)
    assert quarter.radii[0] > half.radii[0] and petal(g).Y_0.overlaps(p.Y_0)
    with mp.workdps(40):
        Y, c, rho = number(p.Y), abs(number(g.c)), number(g.half.radii[0])
        r, x = c / Y, c / Y / rho
        Gamma = c * abs(number(g.eta)) * number(g.half.gains[0]) + 1

        def bound(f, size):
            known = sum(abs(number(f[m])) * r ** (m - 2) for m in range(2, len(f)))
            return c**2 * (known + size * x ** len(f) / (1 - x) / r**2)

        b, b_T = bound(g.gamma, Gamma), bound(g.tau, number(g.half.excess))
        lam = 1 - b / Y**2
        s, s_T = (value * (mp.pi / (lam * Y) + 1 / Y**2) for value in (b, b_T))
        for ball, value in ((p.b, b), (p.s, s), (p.s_T, s_T), (p.Y_0, Y + 2 * s + 2 * b / Y**2)):
            assert value <= number(ball) * (1 + mp.mpf(10) ** -16) and number(ball) < value * (1 + mp.mpf(10) ** -9)
        assert lam >= number(p.lam) * (1 - mp.mpf(10) ** -16)
        assert number(quadratic_bound(g.gamma, arb(2), arb("0.1"), arb("0.5"))) > abs(number(g.gamma[2]))
        Q = mp.exp(2 * mp.pi * (number(p.Y_0) - 20))
        wanted = 2 * number(p.s) * Q**3 / (1 - Q)
        assert wanted * (1 - mp.mpf(10) ** -9) <= number(p.tail(p.s, 2, arb(20))) < wanted * (1 + mp.mpf(10) ** -9)
    with pytest.raises(UndecidedError, match="half-plane"):
        p.tail(p.s, 1, p.Y_0)


def test_orbits_stay_as_near_to_z_as_the_petal_says():
    """|Phi_+ - z| <= s and |theta_+| <= s_T on the edge of the petal; a twentieth of either is refuted."""
    g, p = rough_petal(DRAG)
    with ctx.workprec(100):
        series = odd_series(g)
        y = p.Y + p.s
        worst, late = arb(0), arb(0)
        for u in ("-2", "-1", "0", "1"):
            z = acb(arb(u), -y)
            Phi, theta = at(g, p, series, z)
            worst, late = worst.max(abs(Phi - z)), late.max(abs(theta))
    assert worst <= p.s and late <= p.s_T
    assert worst > p.s / 20 and late > p.s_T / 20


def test_what_an_orbit_leaves_out_is_bounded():
    """Fewer terms give the same Phi_+ within their own bound, which is above their error and not far above."""
    g, p = rough_petal(DRAG)
    plan = effort(g, p, 1, 20)
    with ctx.workprec(plan.bits):
        fine, coarse = germ(DRAG, plan.order, plan.bits, 0.1), germ(DRAG, 14, plan.bits, 0.1)
        y = arb(9)
        truth, found = at_height(fine, p, odd_series(fine), y)[0], at_height(coarse, p, odd_series(coarse), y)[0]
        assert found.overlaps(truth) and found.imag.rad() > 1e6 * truth.imag.rad()
        radius = later(coarse, p, odd_series(coarse)[0], arb(144)).real.rad()
        assert 0 < radius < found.imag.rad() * 1.001
        with pytest.raises(UndecidedError, match="petal"):
            later(coarse, p, odd_series(coarse)[0], arb(1))
        with pytest.raises(UndecidedError, match="petal"):
            at_height(coarse, p, odd_series(coarse), arb(2))


def test_a_tail_left_out_moves_the_constants():
    """D = sum c_k q^k with the largest c_k that the petal allows: enclosed, and not without the tail."""
    _, p = rough_petal(DRAG)
    with ctx.workprec(200):
        heights = [p.Y_0 + arb(k) / 4 + 1 for k in range(3)]
        c = [2 * p.s * (2 * arb.pi() * k * p.Y_0).exp() * arb("0.99") for k in range(1, 60)]
        q = [(-2 * arb.pi() * v).exp() for v in heights]
        rows = [(x, sum(a * x**k for k, a in enumerate(c, 1)).mid(), v) for x, v in zip(q, heights, strict=True)]
        found = _solved(p, rows, p.s)
        assert all(ball.contains(value.mid()) for ball, value in zip(found, c, strict=False))
        without = _solved(p, rows, arb(0))
        assert not any(ball.contains(value.mid()) for ball, value in zip(without, c, strict=False))
