"""One half-swing at a complex local strength, in balls: the series of F, then a step of interval Newton on R.

Inside the circle of its majorant |F| <= S, and what the series through delta^K lacks is at most S x^(K+1)/(1 - x), x =
|delta|/rho.  The quarter-swing has the larger circle: |R| <= G, |T_q - pi/2| <= E on |delta| <= rho_q.  So L is taken
from the ball of F and improved by a step of Newton's method for

    G(L) = L - R(delta) + R(u),  u = -delta e^(eta L),      G'(L) = 1 + eta u R'(u)        (the reversal identity);

the mean value theorem along the segment from the midpoint m to L keeps the enclosure: L in m - G(m)/G'(ball of L), the
interval Newton method (Moore 1966).

>>> from asymptotics.numbers.exact import parse_real
>>> from asymptotics.expansions.divergence.germ import germ
>>> with ctx.workprec(120):
...     drag = germ(parse_real("2", "alpha"), 40, 120, 0.1)
...     F, tau = half_step(drag, acb(0, arb(1) / 10))
...     y = 1 + 2 * acb(0, arb(1) / 10)
>>> F.overlaps((1 + (-y * (-y).exp()).lambertw()) / 2), F.real.rad() < 1e-30           # Smith 2012, (43)
(True, True)
"""

from collections.abc import Sequence

from flint import acb, acb_poly, arb

from asymptotics.errors import UndecidedError
from asymptotics.expansions.divergence.germ import Germ
from asymptotics.numbers.context import ctx

BOUND_BITS = 64


def half_step(g: Germ, delta: acb) -> tuple[acb, acb]:
    """(F(delta), T(delta) - pi) at a ball; UndecidedError outside the circle of the majorant."""
    first = at(g.F, delta, tail(g.half.final(0), delta, g.half.radii[0], g.order))
    # F/delta = e^(eta L) with |eta L| <= |eta| growth < 3 < pi: then eta L is the principal logarithm.
    if not abs(g.eta) * g.half.growth < 3:
        raise UndecidedError("the half-swing may turn around the origin: its logarithm is not known")
    L = (first / delta).log() / g.eta
    middle = acb(L.real.mid(), L.imag.mid())
    value = middle - _R(g, delta) + _R(g, -delta * (g.eta * middle).exp())
    # On the whole ball of L: a rectangle is convex, so that it
    # holds the segment, and G' over it holds the mean of G' there.
    slope = 1 + g.eta * _weighted_R(g, -delta * (g.eta * L).exp())
    F = delta * (g.eta * (middle - value / slope)).exp()
    return F, _T(g, delta) + _T(g, -F)


def tail(size: arb, delta: acb, radius: arb, order: int) -> arb:
    """``size`` x^(order+1)/(1 - x), x = |delta|/``radius``: Cauchy's bound of what a series through ``order`` lacks."""
    with ctx.workprec(BOUND_BITS):
        x = share(delta, radius)
        return arb((size * x ** (order + 1) / (1 - x)).upper())


def share(delta: acb, radius: arb) -> arb:
    """|delta|/radius, rounded up and proved to be below 1."""
    # One number that is at least |delta|/radius for every delta of the ball; the tails grow with it.
    x = arb((abs(delta) / radius).upper())
    if not x < 1:
        raise UndecidedError(f"|delta| = {abs(delta).str(3)} is outside the circle of the majorant")
    return x


def at(f: Sequence[arb], delta: acb, radius: arb) -> acb:
    """sum f_n delta^n with a disc of ``radius`` around it."""
    return acb_poly(list(f))(delta) + acb(arb(0, radius), arb(0, radius))


def _R(g: Germ, delta: acb) -> acb:
    return at(g.R, delta, tail(g.quarter.growth, delta, g.quarter.radii[0], g.order))


def _T(g: Germ, delta: acb) -> acb:
    return at(g.T_q, delta, tail(g.quarter.excess, delta, g.quarter.radii[0], g.order))


def _weighted_R(g: Germ, u: acb) -> acb:
    """u R'(u): the sum over n > K of n x^n is x^(K+1) (K + 1 - K x)/(1 - x)^2."""
    K = g.order
    with ctx.workprec(BOUND_BITS):
        x = share(u, g.quarter.radii[0])
        # A sum of terms that grow with x, so that the x that was
        # rounded up gives an upper bound, although K + 1 - K x falls.
        rest = (g.quarter.growth * x ** (K + 1) * (K + 1 - K * x) / (1 - x) ** 2).upper()
    return at([n * r for n, r in enumerate(g.R)], u, arb(rest))
