"""The quarter swing of one power of the velocity through a high order: by ``nodes``, at a strength that suits it.

``nodes`` is good to so many bits at one strength; relative to each coefficient it is so where that strength is near the
radius of convergence, which a short trial tells, with the bits that the recursion loses.  Both are choices: how right
the balls are they say themselves.

>>> from asymptotics.numbers.exact import parse_real
>>> with ctx.workprec(120):
...     R, T = quarter_orders(parse_real("3/2", "alpha"), 24)
>>> R[1,].str(12), R[24,].rel_accuracy_bits() > 120, T[1,].str(12)
('[-0.718884140841 +/- ...]', True, '[0.400000000000 +/- ...]')
"""

from collections.abc import Sequence
from math import ceil

from flint import arb

from asymptotics.expansions.half_swings.certified_moments import Orders
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.half_swings.nodes import GUARD, lost_bits, node_quarter
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import ExactReal

# At lower orders series in the angle are as fast: for alpha = 3/2 nodes take 0.7, 1.4 and 2.1 times less at the orders
# 10, 14 and 18, for alpha = 1/20 the same at 18.
_FEWEST = 18
# The trial: enough orders to see the radius and the loss, in some hundredths of a second.
_TRIAL, _TRIAL_BITS = 12, 128
_SPARE = 16  # bits for coefficients that are smaller than their neighbours, as signs change


def only_law(forces: Forces, order: int) -> ExactReal | None:
    """The exponent, where one power of the velocity acts whose quarter swing is faster by nodes; else None."""
    if not forces.is_pure or len(forces.members) > 1 or order < _FEWEST:
        return None
    (member,) = forces.members
    alpha = member.velocity
    # Linear friction has a closed form, dry friction an exponent 0 that the nodes do not know.
    served = member.key == (1,) and member.ratio == 1 and alpha > 0 and alpha != 1
    return alpha if served else None


def quarter_orders(alpha: ExactReal, order: int) -> tuple[Orders, Orders]:
    """R_n (n >= 1) and T_n of one law through ``order``, good to about the current precision relative to each."""
    bits = ctx.prec + _SPARE
    small, lost = _trial(alpha, order)
    R, T = node_quarter(alpha, order, bits, small, lost)
    with ctx.workprec(bits):
        return {(n,): x for n, x in enumerate(R) if n}, {(n,): x for n, x in enumerate(T)}


def _trial(alpha: ExactReal, order: int) -> tuple[float, int]:
    """A strength at which late coefficients are near 1, and the bits that the recursion loses through ``order``."""
    small = 1 / _growth(node_quarter(alpha, _TRIAL, _TRIAL_BITS, 1.0)[0])
    # So many bits an order, the guard bits among them.
    lost = (GUARD + lost_bits(alpha, _TRIAL, _TRIAL_BITS, small)) * order / _TRIAL
    return small, max(0, ceil(lost) - GUARD)


def _growth(R: Sequence[arb]) -> float:
    """About how much the last coefficients grow from one order to the next."""
    # Several of them, as signs change and one may be small.
    sizes = {n: float(abs(R[n]).upper()) for n in range(len(R) - 5, len(R))}
    growth: float = max(size ** (1 / n) for n, size in sizes.items())
    return growth
