"""The quarter swing for any real exponents and any springs, in sums, as series whose coefficients are proved balls.

R = ln r(pi/2)/r(0), the duration T_q and the waveform moments K_k of `quarter` are power series in the local strengths
delta_i.  `certified_orders` computes the first ``terms`` coefficients, in t = (2 theta/pi)², of the function that
belongs to each order, and bounds the same function on |t| < varrho.  At the equilibrium passage t = 1, with kappa =
pi/2,

    R_n = −kappa^{n·alpha} sum_j [g y_n]_j/(n·alpha + 2j),
    T_n = kappa^{n·alpha+1} sum_j [c y_n]_j/(n·alpha + 1 + 2j),

and what the sums lack from j = K on is at most (Cauchy, item 4 of `certified_orders`)

    B_n varrho^{−K}/(2K (1 − 1/varrho))    with B_n = kappa^{n·alpha} |g||y_n| for R_n,
    kappa^{n·alpha+1} |c||y_n| for T_n

(for the moments see `certified_moments`), which is added to the radius.  varrho = 4 is the largest radius at which the
functions are analytic: two bits a term.  The number of terms and the working precision are chosen from the bounds; they
decide how narrow the balls are, not whether they are right.

>>> from asymptotics.numbers.exact import parse_real
>>> quarter = quarter_swing([parse_real("3/2", "--alpha")], 2)
>>> quarter.R[1].str(12), quarter.T_q[1].str(12)            # −(pi/2) M_(5/2) and 1/(alpha+1)
('[-0.718884140841 +/- ...]', '[0.400000000000 +/- ...]')
>>> two = quarter_swing([parse_real("1", "--alpha"), parse_real("sqrt(2)", "--alpha")], 2)
>>> two.R[1, 0].overlaps(-arb.pi() / 4), two.R[1, 1].str(12)
(True, '[-0.328899510902 +/- ...]')
>>> from asymptotics.terms import Term
>>> duffing = quarter_swing([Term(1, "3/2"), Term(1, 0, 3, "position")], 2)
>>> duffing.T_q[0, 1].str(12), (-3 * arb.pi() / 16).str(12)
('[-0.589048622548 +/- ...]', '[-0.589048622548 +/- ...]')
"""

from collections.abc import Sequence
from math import comb, log2

from flint import arb

from asymptotics.costs import node_seconds, require_affordable, series_seconds
from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.certified_moments import Orders, duration_orders, moment_bounds, moment_orders
from asymptotics.expansions.half_swings.certified_nodes import only_law, quarter_orders
from asymptotics.expansions.half_swings.certified_orders import (
    bound_ring,
    dot,
    elementary_series,
    indices,
    order_series,
    power_series_ring,
)
from asymptotics.expansions.half_swings.forces import Forces, Given
from asymptotics.expansions.half_swings.quarter import QuarterSwing
from asymptotics.numbers.context import ctx
from asymptotics.numbers.exact import MAX_ORDER
from asymptotics.numbers.integers import require_integer
from asymptotics.running.budget import Unasked, require_seconds
from asymptotics.series import Series

# Bounds are wanted to a digit or two; they are balls, so that 64 bits cannot make them too small.
BOUND_BITS = 64
# sigma vanishes at t = 4 itself; the suprema are those of the open disc, where every function is bounded.
RADIUS = 4
MAX_SECONDS = Unasked(600)
_GUARD = (24, 1.25)


def quarter_swing(
    given: Given,
    order: int,
    *,
    moments: bool = False,
    terms: int | None = None,
    guard: int | None = None,
    radius: int = RADIUS,
    max_seconds: float = MAX_SECONDS,
) -> QuarterSwing:
    """R, T_q and, if asked for, the moments K_k (k = 0 … order, through order − k) at the current precision.

    ``given``: forces, terms, or the exponents of plain losses, all >= 0; the coefficient of delta_1^{n_1} delta_2^{n_2}
    … has the key (n_1, n_2, …).  ``terms`` (coefficients kept), ``guard`` (bits beyond the precision) and ``radius``
    (varrho = 2, 3 or 4) change the width of the balls only.  InputError for no force, a negative exponent, or order <
    1; LimitError if the work would exceed ``max_seconds``.
    """
    forces = Forces.read(given, order)
    _check(order, radius)
    alpha = None if moments or terms or guard or radius != RADIUS else only_law(forces, order)
    if alpha is not None:
        _check_nodes(order, max_seconds)
        R, T_q = (Series(c, 1, order) for c in quarter_orders(alpha, order))
        return QuarterSwing(forces.ball_grading(), R, T_q, ())
    products = _products(forces, order, moments)
    # First of all with an estimate, for the bounds are work too: log2(4) = 2 bits a term tell how many there will be.
    _check_work(products, terms or ctx.prec // 2, ctx.prec, max_seconds)  # the bounds themselves cost scalar products
    # At varrho the bounds of what is cut off, at 1 those of the coefficients themselves: their size is what cancels.
    with ctx.workprec(BOUND_BITS):
        bounds = tail_constants(forces, order, radius, moments)
        size = tail_constants(forces, order, 1, moments)
    kept = terms or terms_needed(bounds, radius, ctx.prec)
    bits = ctx.prec + (_guard_bits(size) if guard is None else guard)
    _check_work(products, kept, bits, max_seconds)
    with ctx.workprec(bits):
        sums = truncated_sums(forces, order, kept, moments)
        enclosed = [enclose(s, b, radius, kept) for s, b in zip(sums, bounds, strict=True)]
    # The moments come as Re K_0, Im K_0, Re K_1, ...; each series is known through its own highest degree.
    R, T_q, *K = [Series(c, forces.variables, max(map(sum, c))) for c in enclosed]
    return QuarterSwing(forces.ball_grading(), R, T_q, tuple(zip(K[::2], K[1::2], strict=True)))


def truncated_sums(forces: Forces, order: int, terms: int, moments: bool) -> list[Orders]:
    """R, T_q, Re K_0, Im K_0, Re K_1, … from the first ``terms`` coefficients: balls around the truncated sums only."""
    ring = power_series_ring(forces, terms)
    y = order_series(ring, indices(forces.variables, order))
    kappa = arb.pi() / 2
    R: Orders = {}
    T: Orders = {(0,) * forces.variables: kappa}
    for n, tau in duration_orders(ring, y).items():
        exponent = dot(n, ring.velocities)
        # At t = 1 a series in t is the sum of its coefficients.
        R[n] = -sum(ring.integrate(ring.cut(ring.turn * y[n]), exponent).coeffs(), arb(0)) * kappa**exponent
        T[n] = sum(tau.coeffs(), arb(0)) * kappa ** (exponent + 1)
    K = moment_orders(ring, elementary_series(terms)[1], y, order) if moments else []
    return [R, T, *(part for pair in K for part in pair)]


def tail_constants(forces: Forces, order: int, radius: int, moments: bool) -> list[Orders]:
    """B_n of the module docstring for R, T_q, Re K_0, Im K_0, Re K_1, … in the order of `truncated_sums`."""
    ring = bound_ring(forces, radius)
    y = order_series(ring, indices(forces.variables, order))
    kappa = arb.pi() / 2
    scale = {n: kappa ** dot(n, ring.velocities) for n in [(0,) * forces.variables, *y]}
    R = {n: scale[n] * ring.turn * bound for n, bound in y.items()}
    T = {n: kappa * scale[n] * ring.cosine * bound for n, bound in y.items()}
    K = moment_bounds(ring.velocities, y, radius, order) if moments else []
    scaled = [{n: kappa ** (k + 1) * scale[n] * bound for n, bound in part.items()} for k, part in enumerate(K)]
    return [R, T, *(part for part in scaled for _ in range(2))]


def enclose(sums: Orders, bounds: Orders, radius: int, terms: int) -> Orders:
    """The truncated sums with their tails: B_n varrho^{−K}/(2K (1 − 1/varrho)) added to the radius of each ball."""
    # varrho^(-K)/(1 - 1/varrho); 2K is the least of the divisors from j = K on, so all of the rest is divided by it.
    tail = arb(radius) ** (1 - terms) / (2 * terms * (radius - 1))
    # Rounded up, as a radius must be. What has no bound (T_0 = pi/2) has no tail either.
    return {n: x + arb(0, (bounds[n] * tail).upper()) if n in bounds else x for n, x in sums.items()}


def terms_needed(bounds: Sequence[Orders], radius: int, bits: int) -> int:
    """Enough terms for tails below 2^(−bits − 3|n|); the factor allows for coefficients that fall with the order."""
    largest = max(_log2(b) + 3 * sum(n) for part in bounds for n, b in part.items())
    # In doubles: how many terms are kept decides how narrow the balls are, and the tail is counted whatever it is.
    return max(4, int((bits + largest) / log2(radius)) + 2)


def _guard_bits(size: Sequence[Orders]) -> int:
    """Bits lost to cancellation: the bounds at varrho = 1 bound the largest coefficient.  This affects the width
    only."""
    # The factor 1 is what the bound says, 24 and a quarter are spare: from 1 on the tail alone is seen in the widths,
    # with 0 they exceed the precision by 10 to 20 bits (``benchmarks/constants.json``).  Too few bits leave wider
    # balls, which whoever wants digits answers with a higher precision.
    return _GUARD[0] + int(_GUARD[1] * max(_log2(b) + 3 * sum(n) for part in size for n, b in part.items()))


def _log2(x: arb) -> float:
    mantissa, exponent = x.upper().man_exp()
    return log2(int(mantissa)) + int(exponent)


def _check(order: int, radius: int) -> None:
    require_integer(order, "order", 1, MAX_ORDER)
    if radius not in (2, 3, 4):
        raise InputError("radius", f"{radius} is not a radius of proved analyticity", "2, 3 or 4")


def _check_nodes(order: int, max_seconds: float) -> None:
    """The same for one law at nodes, of which there are about as many as a third of the bits and of five an order."""
    bits = ctx.prec + 5 * order
    seconds = node_seconds(order, bits // 3 + order, bits)
    told = f"the quarter-swing through order {order} at {bits} bits"
    require_affordable(seconds, max_seconds, "order", told, ": a lower order, fewer digits, or a higher limit")
    require_seconds(seconds, told)


def _products(forces: Forces, order: int, moments: bool) -> int:
    """Products of series: C(order + 2 k, 2 k) per convolution in k variables, one for each member and one for y."""
    # A convolution through the order sums over the pairs (m, n - m), multi-indices in 2 k variables.
    k, convolutions = forces.variables, len(forces.members) + 1
    products = convolutions * comb(order + 2 * k, 2 * k)
    return products + (4 * comb(order + 2 * k + 1, 2 * k + 1) if moments else 0)


def _check_work(products: int, terms: int, bits: int, max_seconds: float) -> None:
    """Refuse what is too large before it starts, at all or for the time that is left."""
    seconds = series_seconds(products, terms, bits)
    told = f"{products} products of series of {terms} terms at {bits} bits"
    require_affordable(seconds, max_seconds, "order", told, ": a lower order, fewer digits, or a higher limit")
    require_seconds(seconds, told)
