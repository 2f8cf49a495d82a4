"""The coefficients of the expansion at a turning point that belong to the exponents alone, shared by all strengths.

In units of P_0, with z_0 = (w/P_0)^2 and z_i = epsilon_i w^alpha_i/P_0, neither strength nor amplitude is left: with
P = P_0 p, q = 1/p and e(n) = 2 n_0 + sum alpha_i n_i,

    y/P_0 = sum y_n z^n,    P_0 tau/w = sum q_n z^n/(e(n) + 1),
    y_n = -q_(n - (1,0,...))/e(n),    p_n = y_n - [z^n = z_i],    q_n = -sum_(0 < f <= n) p_f q_(n-f),    p_0 = q_0 = 1.

All p_f with f > 0 are negative and all q_n positive: nothing cancels.  For each power m of (z_1, z_2, ...) there is a
*row*, a polynomial in z_0.  Rows grow when more terms are asked for; no coefficient depends on how many there are.

>>> from fractions import Fraction
>>> from asymptotics.numbers.exact import ExactReal
>>> [(m, str(y)) for m, y, _ in rows_below((ExactReal(Fraction(2)),), (2, 3), 5, 53)]
[((0,), '(-0.125000000000000)*x^2 + (-0.500000000000000)*x + 1.00000000000000'), ((1,), '0')]
"""

from collections.abc import Iterator
from itertools import product
from operator import mul, sub

from flint import arb, arb_poly

from asymptotics.flow.composition import Key, below
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.exact import ExactReal

Row = tuple[Key, arb_poly, arb_poly]
# A bit of precision more or less takes the same rows; between whole limbs arithmetic costs the same.
_LIMB = 64


def rows_below(alphas: tuple[ExactReal, ...], weights: Key, top: int, bits: int) -> tuple[Row, ...]:
    """(m, y_m(z_0), s_m(z_0)) of all n = (n_0, m) with sum n_i weights_i < top, at ``bits`` or up to 63 bits more.

    s_m has the coefficients of P_0 tau/w.
    """
    return _cut(alphas, weights, top, -(-bits // _LIMB) * _LIMB)


@lru_cache(maxsize=64)
def _cut(alphas: tuple[ExactReal, ...], weights: Key, top: int, bits: int) -> tuple[Row, ...]:
    grown = _grown(alphas, bits)
    found = []
    for m, length in lengths(weights, top):
        grown.extend(m, length)
        found.append((m, arb_poly(grown.y[m][:length]), arb_poly(grown.s[m][:length])))
    return tuple(found)


def lengths(weights: Key, top: int) -> Iterator[tuple[Key, int]]:
    """(m, the number of its n_0) by rows, the parts of an m before it.

    >>> list(lengths((2, 3), 7))
    [((0,), 4), ((1,), 2), ((2,), 1)]
    """
    first, *others = weights
    for m, left in below(tuple(others), top):
        yield m, -(-left // first)


@lru_cache(maxsize=32)
def _grown(alphas: tuple[ExactReal, ...], bits: int) -> "_Rows":
    # One growing table for a law's exponents and a precision, so that expansions at all strengths and all turning
    # points add to it and read from it.
    return _Rows(alphas, bits)


class _Rows:
    """Rows of y, p, q and s = q/(e+1) by m, each as long as it was asked for."""

    def __init__(self, alphas: tuple[ExactReal, ...], bits: int) -> None:
        self.bits = bits
        with ctx.workprec(bits):
            self.exponents = [a.ball() for a in alphas]
        axes = range(len(alphas))
        self.units = {tuple(int(i == j) for j in axes) for i in axes}
        self.y: dict[Key, list[arb]] = {}
        self.p: dict[Key, list[arb]] = {}
        self.q: dict[Key, list[arb]] = {}
        self.s: dict[Key, list[arb]] = {}

    def extend(self, m: Key, length: int) -> None:
        """Make a row ``length`` long; the rows of the parts of m are at least as long."""
        y, p, q, s = columns = tuple(table.setdefault(m, []) for table in (self.y, self.p, self.q, self.s))
        whole = len(s)  # the last to grow: an alarm may have stopped the columns before it one further
        if whole >= length:
            return
        for column in columns:
            del column[whole:]
        parts = [(j, tuple(map(sub, m, j))) for j in product(*(range(k + 1) for k in m))]
        with ctx.workprec(self.bits):
            weight = sum(map(mul, m, self.exponents), arb(0))
            for k in range(whole, length):
                # e is the exponent of the monomial; only the constant term has none, where y = p = q = 1.
                e, start = weight + 2 * k, not k and not any(m)
                y.append(-q[k - 1] / e if k else arb(int(start)))
                # p = y - N: N has the coefficient 1 at each z_i alone.
                p.append(y[k] - 1 if not k and m in self.units else y[k])
                q.append(arb(1) if start else -self._products(parts, k))
                s.append(q[k] / (e + 1))

    def _products(self, parts: list[tuple[Key, Key]], k: int) -> arb:
        """The sum of p_f q_(n-f) over 0 < f <= n = (k, m)."""
        total = arb(0)
        for j, rest in parts:
            left, right = self.p[j], self.q[rest]
            first = 0 if any(j) else 1
            total = sum(map(mul, left[first : k + 1], reversed(right[: k + 1 - first])), total)
        return total
