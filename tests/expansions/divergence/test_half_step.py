"""Half-swings at complex strengths: contained at few bits and terms, their tails beside the formula of Cauchy."""

from dataclasses import replace

import mpmath
import pytest
from flint import acb, arb
from mpmath import mp

from asymptotics.errors import UndecidedError
from asymptotics.expansions.divergence.germ import germ
from asymptotics.expansions.divergence.half_step import _weighted_R, half_step, share, tail
from asymptotics.expansions.divergence.half_step import at as polynomial
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import parse_real

DRAG = parse_real("2", "alpha")


def number(x):
    return mp.mpf(x.mid().str(40, radius=False))


POINT = acb(0, arb("0.1"))


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


def test_a_half_swing_wants_its_logarithm_and_its_tails(law):
    g, _ = law
    with ctx.workprec(100):
        with pytest.raises(UndecidedError, match="logarithm"):
            half_step(replace(g, half=replace(g.half, growth=arb(4))), POINT)
        around = polynomial([arb(1)], POINT, arb("0.25"))
        assert float(around.real.rad()) == pytest.approx(0.25) == float(around.imag.rad())
        x, K = 0.1 / float(g.quarter.radii[0]), g.order
        wanted = float(g.quarter.growth) * sum(n * x**n for n in range(K + 1, 400))
        found = _weighted_R(replace(g, R=(arb(0),) * (K + 1)), POINT)
        assert float(found.real.rad()) / wanted == pytest.approx(1, rel=1e-6)
        assert germ(DRAG, 8, 60, 0.1).order == 8
