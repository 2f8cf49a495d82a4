"""What the series of one half-swing lacks after delta^N: L = ln(A'/A) cut there, with a constant.

Cauchy's inequalities on a polydisc (Hörmander, An Introduction to Complex Analysis in Several Variables, section 2.2).

On the polydisc |delta_i| <= rho the half-swing is analytic and |L| <= M (``half_swings.finite_majorant``).  With the
next coefficients computed, and Cauchy's inequality beyond them (derivation ``expansion-bounds``),

    |L - L^(N)| <= C |delta|^(N+1),     |delta| = sum_i |delta_i| < rho,
    C = sum_(N < k <= J) max_n |c_n|/multinomial(n) |delta|^(k-N-1) + M rho^(-J-1) |delta|^(J-N)/(1 - |delta|/rho).

>>> from asymptotics.numbers.exact import ExactReal
>>> cut = half_swing_series((ExactReal(2),), 3)
>>> cut.at((arb("0.1"),)).str(6), cut.rest(arb("0.1")).str(2)
('[-0.125 +/- ...]', '[0.00017 +/- ...]')
"""

from collections.abc import Sequence
from dataclasses import dataclass

from flint import arb

from asymptotics.bounds.local import BITS, Remainder, sizes_from
from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.half_swings.finite_majorant import majorant, widest
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.exact import ExactReal
from asymptotics.series import Series

# Of the widest radius that seems to have a majorant: the first that is proved is taken.
_SHARES = ("0.9", "0.8", "0.6", "0.4", "0.2")
_NEXT = {1: 8, 2: 6}
"""How many orders are computed before Cauchy's inequality takes over: sums have many coefficients (2 from three on)."""
_EXACT = 6
"""Up to this integer exponent the exact coefficients come sooner than the balls."""


@dataclass(frozen=True)
class HalfSwingSeries:
    """L^(N) and the bound of what it lacks; exponents of powers of the velocity beside the linear spring."""

    order: int
    L: Series
    rest: Remainder

    def at(self, delta: Sequence[arb]) -> arb:
        """A ball that holds L: the polynomial at these strengths, widened by the bound."""
        # |delta| = sum |delta_i| for balls and for negative strengths: the remainder grows with it.
        size = sum((arb(d.abs_upper()) for d in delta), arb(0))
        value: arb = self.L.at(tuple(delta))
        return value + arb(0, self.rest(size))


@lru_cache(maxsize=64)
def half_swing_series(alphas: tuple[ExactReal, ...], order: int) -> HalfSwingSeries:
    """L through delta^``order`` >= 1 and its remainder; UndecidedError where no polydisc is verified."""
    last = order + _NEXT.get(len(alphas), 2)
    cauchy, radius = disc(alphas)
    with ctx.workprec(BITS):
        if all(a.is_integer and a <= _EXACT for a in alphas):
            exact = exact_half_swing([int(a.rational) for a in alphas], last).L
            # Rational combinations of powers of pi, rounded once.
            L = exact.map(lambda c: arb(0) + c.ball())
        else:
            L = half_swing(quarter_swing(alphas, last)).L
        rest = Remainder(order + 1, sizes_from(L, order + 1), cauchy, radius)
        return HalfSwingSeries(order, L.truncate(order), rest)


@lru_cache(maxsize=64)
def disc(alphas: tuple[ExactReal, ...]) -> tuple[arb, arb]:
    """(M, rho): the largest polydisc of equal radii that is tried and verified; UndecidedError for none."""
    with ctx.workprec(BITS):
        balls = [a.ball() for a in alphas]
        radius = widest(balls, [arb(1)] * len(balls), whole=True).radii[0]
        for share in _SHARES:
            rho = arb((radius * arb(share)).mid())
            motion = majorant(balls, [rho] * len(balls), whole=True)
            if motion is not None:
                return motion.growth, rho
    raise UndecidedError("no polydisc was verified on which the half-swing is analytic")
