"""How far the local expansion at a turning point is used, and which of its terms are kept: choices, in doubles.

In units of |P_0| the expansion depends on delta_i = epsilon_i |P_0|^(alpha_i - 1) alone; at the speed omega |P_0|

    a = omega^2/2,      b_i = delta_i omega^alpha_i,        and it converges while 2 sqrt(a) + sum b_i < 1.

A larger omega saves Taylor steps and costs terms.  Two shapes of the set of terms:

* ``line``: all alpha_i are multiples of 1/q, the terms are powers of w^(1/q), and w is stretched by one factor;
* ``simplex``: one index for z_0 = w^2 and one for each z_i = w^alpha_i, weights g_i = log2 of the room z_i has; kept
  is sum n_i g_i < G.  Weights are integers, so that a term is either in or out; coefficients are shared (``rows``).

Where both would need too many terms (0 < alpha < 1/100 and a strength near 1, where w^alpha hardly depends on w) only
the first term is kept: a ``short`` plan, for a speed so small that this is enough; Taylor steps, each about as long as
the way to w = 0, do the rest.

Nothing here enters a bound: ``expansion`` checks the convergence in balls and computes the tail from the first term
left out.

>>> plan = plan_for((-3.0,), (Fraction(3, 2),), (1.5,), 1000)
>>> plan.denominator, -4 < plan.omega < -1, plan.count < 2000
(2, True, True)
>>> [plan_for((-3.0,), (alpha,), (1.5,), 130).denominator for alpha in (Fraction(3, 2), None)]
[0, 0]
"""

from dataclasses import dataclass
from fractions import Fraction
from math import factorial, gcd, inf, lcm, log, prod

from asymptotics.errors import LimitError
from asymptotics.flow.taylor import DEGREE_PER_BIT
from asymptotics.numbers.context import lru_cache

Key = tuple[int, ...]
MAX_LINE, MAX_KEYS = 3000, 1500
"""The most terms of a line and of a simplex: by ``_microseconds`` either takes about three seconds, many half-swings by
Taylor steps."""
_UNIT = 1 << 16  # of the integer weights: to round one down gives away 2^-16 bits for each factor of a term
_LN2 = log(2)
# Rows are kept (``rows``), and the next half-swings of the same law take them as they are: a share of the cost is
# ascribed to the one that asks.  Which share decides cost alone, and 0.1 to 1 cost the same within a third
# (``benchmarks/constants.json``).
_ALONE = 0.25  # the share of its coefficients that a half-swing pays for, where others use them too
_STEP = (150, 0.1)  # microseconds of a Taylor step, and of each pair of its coefficients
SMALL = 0.2  # exponents below which short plans are made: w^alpha halves only where w falls to 1/32 or less
# How many powers of two below the edge of convergence a hand-over is tried, ever farther apart, down to 2^-32; nothing
# rests on the list.
_HALVINGS = (0.2, 0.5, 1, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10, 13, 16, 20, 26, 32)


@dataclass(frozen=True)
class KeptTerms:
    """The hand-over speed 2^omega |P_0|; log2 of the stretch of w (with q, on a line) or of each z_i (with G)."""

    omega: float
    denominator: int
    stretch: tuple[float, ...]
    count: int
    weights: Key = ()
    top: int = 0

    @property
    def short(self) -> bool:
        """Whether only the first term is kept."""
        return not self.stretch


@lru_cache(maxsize=4096)
def plan_for(
    ln2_delta: tuple[float, ...],
    rational: tuple[Fraction | None, ...],
    alphas: tuple[float, ...],
    bits: int,
    speed: float | None = None,
    shared: bool = True,
) -> KeptTerms:
    """The cheapest plan for delta_i up to 2^ln2_delta, with the hand-over speed 2^``speed`` if it is given.

    ``shared``: whether the coefficients of a simplex are those of all strengths (``rows``).

    LimitError where every plan needs too many terms, and no exponent is small.
    """
    edge = _edge(ln2_delta, alphas)
    # A given speed must be served if it can be, since a state ahead hangs on it; one that may be chosen rather gives
    # way.
    best, cost, most = None, inf, MAX_KEYS if speed is None else 2 * MAX_KEYS
    for omega in _speeds(edge, alphas) if speed is None else [speed]:
        for plan in (_line(omega, ln2_delta, rational, alphas, bits), _simplex(omega, ln2_delta, alphas, bits, most)):
            if plan is not None and (total := _microseconds(plan, bits, alphas, shared)) < cost:
                best, cost = plan, total
    if shared and min(alphas, default=1.0) < SMALL:
        # At a speed 2^-(bits+8) below the amplitude d = w^2/(2 p) is far below the last bit, and one term is enough.
        short = KeptTerms(-bits - 8.0 if speed is None else speed, 1, (), 1)
        # From so small a speed Taylor steps each double it a few times: about 3 steps for a bit are set against the
        # series, a rough figure that decides the cost alone.
        if best is None or (speed is None and 3 * bits * _step_microseconds(bits, len(alphas)) < cost):
            return short
    if best is None:
        shown = ", ".join(f"{a:.6g}" for a in alphas)
        limits = f"{MAX_KEYS} terms ({MAX_LINE} where its exponents lie on a line)"
        reason = f"the majorant of the expansion at a turning point needs more than {limits} for ({shown})"
        raise LimitError("alpha", reason, "weaker damping or larger exponents")
    return best


def _speeds(edge: float, alphas: tuple[float, ...]) -> list[float]:
    """Hand-over speeds to try: half the speed, or half the term with the least exponent, where that is below 1."""
    # For alpha < 1 what must halve is w^alpha: the speed falls to 2^(-1/alpha) for it.
    halved = _HALVINGS if not min(alphas, default=1) < 1 else (*_HALVINGS, *(h / min(alphas) for h in _HALVINGS))
    return [edge - h for h in halved]


def _sizes(omega: float, ln2_delta: tuple[float, ...], alphas: tuple[float, ...]) -> tuple[float, list[float]]:
    """(log2 a, log2 b_i) at the speed 2^omega."""
    return 2 * omega - 1, [d + a * omega for d, a in zip(ln2_delta, alphas)]


# 2 sqrt(a) + sum b < 1 is where the root of the majorant R is real.  0.92 leaves room for the rounding of a plan: a
# larger share makes ``expansion`` refuse some of them, a smaller one hands over earlier.
def _converges(a: float, b: list[float], share: float = 0.92) -> bool:
    return 2 * _power(a / 2) + sum(map(_power, b)) < share


def _power(x: float) -> float:
    power: float = 2.0 ** min(x, 99.0)
    return power


def _edge(ln2_delta: tuple[float, ...], alphas: tuple[float, ...]) -> float:
    """log2 of the largest omega where the expansion converges."""
    # At omega = 1 a = 1/2 is beyond the edge, and so is a single b_i = 1; downwards in doubling steps until it
    # converges, then 40 bisections of that interval, more than a double needs.
    high = min([0.0] + [-d / a for d, a in zip(ln2_delta, alphas)])
    drop = 1.0
    while not _converges(*_sizes(high - drop, ln2_delta, alphas)):
        drop *= 2
    low = high - drop
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if _converges(*_sizes(middle, ln2_delta, alphas)) else (low, middle)
    return low


def _line(
    omega: float, delta: tuple[float, ...], rational: tuple[Fraction | None, ...], alphas: tuple[float, ...], bits: int
) -> KeptTerms | None:
    q = lcm(*(r.denominator for r in rational if r is not None)) if None not in rational else 0
    # A line has q coefficients for each power of w: with a larger common denominator nearly all of them vanish, and a
    # simplex holds the same terms without the gaps.
    if not 0 < q <= 200:
        return None
    stretch = _edge(delta, alphas) - omega
    # log2 of the stretch: below it more than 50 powers of w make one bit.
    if stretch < 0.02:
        return None
    # 2^(-stretch count/q) = 2^-(bits+4): the tail is four bits below the precision.
    count = int((bits + 4) / stretch * q) + 2
    return KeptTerms(omega, q, (stretch,), count) if count <= MAX_LINE else None


def _simplex(
    omega: float, delta: tuple[float, ...], alphas: tuple[float, ...], bits: int, most: int
) -> KeptTerms | None:
    """The best of a few ways to share the room between z_0 and the z_i; a simplex has about G^d/(d! prod g) points."""
    a, b = _sizes(omega, delta, alphas)
    used, best = sum(map(_power, b)), None
    if not used < 1:
        return None
    # The convergence condition 2 sqrt(a) + sum b < 1 is a room of 1 - sum b, of which b_i get a part and z_0 the rest:
    # its own stretch for each variable, and the best of four splits.  0.9 keeps a off the edge, as 0.92 does above.
    for part in (0.2, 0.4, 0.6, 0.8):
        target = used + (1 - used) * part
        room = 0.9 * (1 - target) ** 2 / 4
        extra = (target - used) / max(1, len(b))
        stretch = (log(room) / _LN2 - a, *(log(_power(s) + extra) / _LN2 - s for s in b))
        if min(stretch) < 0.02:
            continue
        top = bits + 4.0
        count = prod(top / g + 1 for g in stretch) / factorial(len(stretch))
        if count <= most and (best is None or count < best.count):
            # Rounded down, so that the stretches made of the weights are no larger than those for which the majorant
            # was thought to converge.
            weights = tuple(int(g * _UNIT) for g in stretch)
            best = KeptTerms(omega, 0, tuple(g / _UNIT for g in weights), int(count) + 1, weights, int(top * _UNIT))
    return best


def sums_below(count: int, parts: tuple[int, ...]) -> list[bool]:
    """Which k < count are sums of the parts, 0 among them.

    >>> [k for k, reached in enumerate(sums_below(12, (4, 5))) if reached]
    [0, 4, 5, 8, 9, 10]
    """
    reached = [True]
    for k in range(1, count):
        reached.append(any(k >= part and reached[k - part] for part in parts))
    return reached


def _microseconds(plan: KeptTerms, bits: int, alphas: tuple[float, ...], shared: bool) -> float:
    """A rough cost of a half-swing's two ends and of the Taylor steps that a small omega adds."""
    # Rough times in microseconds, of products of balls (quadratic in the terms) and of handling each term.  They choose
    # between plans, and decide cost alone: half and twice ``_STEP``, against which they are weighed, made half-swings
    # no slower than the noise of the measurement (``benchmarks/constants.json``).
    q, terms, step = plan.denominator, plan.count, _step_microseconds(bits, len(alphas))
    if q:
        parts = (2 * q, *(round(a * q) for a in alphas))
        terms = min(plan.count // gcd(*parts), int(prod(plan.count / p + 1 for p in parts) / factorial(len(parts))))
        ends = 3.5 * (0.1 * terms**2 * (1 + bits / 500) + 5 * terms + plan.count)
    elif not shared:
        ends = 3.5 * (0.3 * terms**2 * (1 + bits / 500) + 8 * terms)
    else:
        ends = _ALONE * (0.025 * terms**2 * (1 + bits / 500) + 8 * terms) + 4 * (20 + 0.3 * terms)
    # Both ends hand over at 2^omega, and Taylor steps lead from there to about 1/2: in ln w they are all equally long,
    # some 8.8 for a factor e of the speed.
    return ends + 2 * 8.8 * _LN2 * max(0.0, -1 - plan.omega) * step


def _step_microseconds(bits: int, laws: int) -> float:
    # Of ``taylor.order_for``: quadratic in the degree, one product of series for each law beside the first.
    order = DEGREE_PER_BIT * bits + 6
    return _STEP[0] + _STEP[1] * order**2 * (1 + laws) * (1 + bits / 500)
