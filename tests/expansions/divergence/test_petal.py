"""The numbers of a petal a second time from their definition, and how near orbits stay to z."""

import pytest
from flint import acb, arb
from mpmath import mp

from asymptotics.errors import UndecidedError
from asymptotics.expansions.divergence.abel import at, odd_series
from asymptotics.expansions.divergence.constants import rough_petal
from asymptotics.expansions.divergence.germ import majorants
from asymptotics.expansions.divergence.petal import petal, quadratic_bound
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import parse_real

DRAG = parse_real("2", "alpha")


def number(x):
    return mp.mpf(x.mid().str(40, radius=False))


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
