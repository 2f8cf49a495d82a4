"""The half-swing of one law as a germ at delta = 0, with what bounds it: the series of F and T, and their majorants.

F(delta) = delta e^(eta L), eta = alpha - 1, is tangent to the identity and reversible: F^(-1)(delta) = -F(-delta).  In

    z = c/delta,   c = 1/(eta pi M_(alpha+1)),      F reads z' = z + 1 + g(z),   g = sum_(m>=2) gamma_m delta^m:

the first power is missing because F is reversible (derivation ``stokes-reversal``), so no logarithm ever appears.

The coefficients come from the quarter-swing: F = sigma h^(-1) sigma h with h = delta e^(eta R), sigma delta = -delta,
T = T_q(delta) + T_q(-F).  Where delta is small, R_n needs fewer right bits the higher n is: the terms and the working
precision that ``half_swings.certified`` would choose for right bits *relative to one* are many times too many.

>>> from asymptotics.numbers.exact import parse_real
>>> drag = germ(parse_real("2", "alpha"), 8, 100, 0.1)
>>> drag.c.str(10), drag.F[2].str(10), drag.gamma[1].contains(0), drag.gamma[2].str(10)
('[0.7500000000 +/- ...]', '[-1.333333333 +/- ...]', True, '[0.1777777778 +/- ...]')
"""

from dataclasses import dataclass
from math import ceil, log2

from flint import arb, arb_series

from asymptotics.expansions.half_swings.finite_majorant import Majorant, widest
from asymptotics.expansions.half_swings.nodes import node_quarter
from asymptotics.expansions.half_swings.one_law import even_quarter
from asymptotics.expansions.moments.certified import moment
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.exact import ExactReal

SHARE = 0.9
"""The part of the widest majorant that is used: near its end the bounds explode."""
# For the rounding, with a bit an order for the reversion; the balls say whether that was enough.
GUARD = 32


@dataclass(frozen=True, eq=False)
class Germ:
    """eta, c, and the coefficients of delta^0, delta^1, … of R, T_q - pi/2, F and T - pi, as balls.

    ``gamma``: those of g; ``quarter`` and ``half``: the majorants on |delta| <= rho_q and |delta| <= rho.
    """

    alpha: ExactReal
    eta: arb
    c: arb
    R: tuple[arb, ...]
    T_q: tuple[arb, ...]
    F: tuple[arb, ...]
    tau: tuple[arb, ...]
    gamma: tuple[arb, ...]
    quarter: Majorant
    half: Majorant

    @property
    def order(self) -> int:
        """The order through which all are known (gamma: two less)."""
        return len(self.R) - 1


def germ(alpha: ExactReal, order: int, bits: int, small: float) -> Germ:
    """The germ through ``order``, its coefficients good to about 2^-``bits`` where |delta| <= ``small`` (a float)."""
    # In eighths of an octave, rounded up: calls that differ by little find one germ in the cache.
    return _germ(alpha, order, bits, ceil(8 * log2(small)))


@lru_cache(maxsize=32)
def _germ(alpha: ExactReal, order: int, bits: int, eighths: int) -> Germ:
    with ctx.workprec(bits + GUARD + order):
        R, T_q = _quarter(alpha, order, bits, 2 ** (eighths / 8))
        eta = alpha.ball() - 1
        c = 1 / (eta * arb.pi() * moment(alpha.ball() + 1))
        F, tau, gamma = _half(eta, c, R, T_q)
        quarter, half = majorants(alpha)
    return Germ(alpha, eta, c, tuple(R), tuple(T_q), F, tau, gamma, quarter, half)


@lru_cache(maxsize=64)
def majorants(alpha: ExactReal) -> tuple[Majorant, Majorant]:
    """The majorants of the quarter-swing and of the half-swing on discs of ``SHARE`` of the widest."""
    quarter, half = (widest([alpha.ball()], [arb(1)], whole=whole, share=SHARE) for whole in (False, True))
    return quarter, half


def _quarter(alpha: ExactReal, order: int, bits: int, small: float) -> tuple[list[arb], list[arb]]:
    """R_n and T_n; exactly at alpha = 2 (from 4 on the nodes are faster than the polynomials)."""
    if alpha == ExactReal(2):
        R, T = even_quarter(2, order)
        rows = [[arb(x) for x in R], [x.ball() for x in T]]
    else:
        rows = [list(row) for row in node_quarter(alpha, order, bits, small)]
    # R has no constant term, and pi/2 is taken off T_q: exact zeros in the place of balls.
    return [arb(0), *rows[0][1:]], [arb(0), *rows[1][1:]]


def _half(eta: arb, c: arb, R: list[arb], T_q: list[arb]) -> tuple[tuple[arb, ...], ...]:
    """F, T - pi and g from the quarter-swing, by the reversal identity."""
    length = len(R)
    with ctx.workcap(length + 1):
        identity = arb_series([0, 1], length)
        h = identity * (arb_series(R, length) * eta).exp()
        F = -h.reversion()(-h)
        T = arb_series(T_q, length)
        tau = T + T(-F)
        # c/F = (c/delta) (delta/F): z, then 1, then nothing at delta^1, and gamma_m at delta^m.
        ratio = arb_series([F[n + 1] for n in range(length - 1)], length - 1)  # F/delta
        inverse = ratio.inv() * c
    gamma = [arb(0), arb(0), *(inverse[n + 1] for n in range(2, length - 2))]
    if not ((inverse[1] - 1).contains(0) and inverse[2].contains(0)):
        raise ArithmeticError("the half-swing is not reversible")
    return tuple(F[n] for n in range(length)), tuple(tau[n] for n in range(length)), tuple(gamma)
