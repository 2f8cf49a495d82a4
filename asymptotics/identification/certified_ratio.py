"""L = ln(A'/A) of a half-swing in balls: the certified coefficients, and a bound for what the truncated sum lacks.

*The tail.*  For complex z put L(z delta) for the half-swing with strengths z delta_i.  While |y| <= Y, y = ln r,

    |dy/dtheta| = |s N/(1 - c N)| <= s h/(1 - h),     |N| <= h = |z| sum_i |delta_i| e^(|w_i| Y),

because s, |c| <= 1.  The integral of s over the half-swing is 2.  So if Y (1 - h) > 2 h, then |y| < Y all the way, for
every |z| <= q, if h is taken at |z| = q: the solution exists there, is analytic in z, and |L| <= Y.  By Cauchy's
inequality the orders above K lack at most Y q^(-K-1)/(1 - 1/q) at z = 1.

>>> from asymptotics.numbers.exact import parse_real
>>> ratio = CertifiedRatio.of((parse_real("1", "alpha"),))
>>> ratio.at([arb("0.1")]).str(8)                                 # -pi (delta/2)/sqrt(1 - delta^2/4)
'[-0.15727635 +/- ...]'
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache

from flint import arb, ctx

from asymptotics.errors import UndecidedError
from asymptotics.half_swings.certified import quarter_swing
from asymptotics.half_swings.quarter import half_swing
from asymptotics.numbers.exact import ExactReal
from asymptotics.series import Key

BITS = 80
_ORDERS = {1: 20, 2: 12, 3: 7}
_REACHES = [arb(k) / 10 for k in range(1, 21)]


@dataclass(frozen=True)
class CertifiedRatio:
    """The coefficients of L through ``order`` as balls; ``weights``: alpha_i - 1."""

    weights: tuple[arb, ...]
    coefficients: Mapping[Key, arb]
    order: int

    @classmethod
    def of(cls, alphas: tuple[ExactReal, ...]) -> "CertifiedRatio":
        """From exponents, at most three."""
        return _ratio(alphas)

    def at(self, delta: Sequence[arb]) -> arb:
        """L at these strengths (balls)."""
        return self.polynomial(delta) + arb(0, self.tail(delta).upper())

    def polynomial(self, delta: Sequence[arb]) -> arb:
        """The truncated sum."""
        powers = self._powers(delta)
        return sum((c * _product(powers, k) for k, c in self.coefficients.items()), arb(0))

    def gradient(self, delta: Sequence[arb]) -> list[arb]:
        """The derivatives of the truncated sum by each strength."""
        powers = self._powers(delta)
        found = []
        for i in range(len(delta)):
            terms = ((c * k[i], (*k[:i], k[i] - 1, *k[i + 1 :])) for k, c in self.coefficients.items() if k[i])
            found.append(sum((c * _product(powers, k) for c, k in terms), arb(0)))
        return found

    def tail(self, delta: Sequence[arb]) -> arb:
        """A bound of |L - truncated sum|; UndecidedError for strengths too large for it."""
        best: arb | None = None
        sizes = [arb(d.abs_upper()) for d in delta]
        for Y in _REACHES:
            load = sum((s * (abs(w) * Y).exp() for s, w in zip(sizes, self.weights)), arb(0))
            if not load > 0:
                return arb(0)
            q = Y / (2 + Y) * arb("0.99") / load
            h = q * load
            if not (q > arb("1.05") and Y * (1 - h) > 2 * h):
                continue
            bound = Y * q ** (-self.order - 1) / (1 - 1 / q)
            best = bound if best is None or bound < best else best
        if best is None:
            raise UndecidedError("the strengths are too large for the bound on the tail of the series")
        return best

    def _powers(self, delta: Sequence[arb]) -> list[list[arb]]:
        table = []
        for d in delta:
            row = [arb(1)]
            for _ in range(self.order):
                row.append(row[-1] * d)
            table.append(row)
        return table


@lru_cache(maxsize=32)
def _ratio(alphas: tuple[ExactReal, ...]) -> CertifiedRatio:
    order = _ORDERS[len(alphas)]
    with ctx.workprec(BITS):
        L = half_swing(quarter_swing(list(alphas), order)).L
        return CertifiedRatio(tuple(a.ball() - 1 for a in alphas), dict(L.coefficients), order)


def _product(powers: list[list[arb]], key: Key) -> arb:
    found = arb(1)
    for row, n in zip(powers, key):
        if n:
            found = found * row[n]
    return found
