"""L = ln(A'/A) of a half-swing in balls: the certified coefficients, and a bound for what the truncated sum lacks.

The half-swing is half of a return map (Guckenheimer and Holmes 1983, section 1.5); L is analytic in the strengths, and
what its Taylor polynomial lacks follows from a majorant for complex strengths by Cauchy's inequalities.

*The tail.*  For complex z put L(z delta) for the half-swing with strengths z delta_i of losses |x|^m v|v|^(alpha-1).
With y = ln r, w_i = alpha_i + m_i - 1, W = max |w_i|, and while |y| <= Y,

    dy/dtheta = -s N/(1 - c N),     |c N| <= |z| sum_i |delta_i| e^(|w_i| Y) k_i = |z| H,
    d|y|/dtheta <= |z| e^(W |y|) sum_i |delta_i| s^(alpha_i+1) |c|^(m_i)/(1 - |z| H),

k_i = sup s^alpha |c|^(m+1), which is where tan^2 = alpha/(m+1).  The integral of s^(alpha+1) |c|^m over the half-swing
is minus the first coefficient of L, J_i.  Divided by e^(W |y|) and integrated, with S = sum_i |delta_i| J_i,

    (1 - e^(-W |y|))/W <= |z| S/(1 - |z| H).

If the right-hand side is less than E = (1 - e^(-W Y))/W, then |y| < Y all the way: the solution exists there and is
analytic in z, and |L| <= Y.  This holds for |z| <= q with q (S + H E) < E.  By Cauchy's inequality the orders above K
lack at most Y q^(-K-1)/(1 - 1/q) at z = 1.

>>> ratio = CertifiedRatio.of((Term(1, 1),))
>>> ratio.at([arb("0.1")]).str(8)                                 # -pi (delta/2)/sqrt(1 - delta^2/4)
'[-0.15727635 +/- ...]'
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.flow.damping import Damping
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.extremes import greatest
from asymptotics.return_map.half_swing_map import integrated
from asymptotics.series import Key
from asymptotics.terms import Term

BITS = 80
"""27 more than a double has, so that roundings stay far below the tails; fewer would make the sets larger, not
wrong."""
_FOLLOWED, _SMALL = 53, arb("1e-9")
"""A half-swing is followed in pieces with as many bits as a double has, where the tail of the series is not below the
second number.  Both are far below what a printed table resolves."""
_ORDERS = {1: 20, 2: 12, 3: 7, 4: 5}
"""The order of the series, by the number of losses.  It leaves about a hundred coefficients for two to four of them,
and their number decides the cost of a box; a lower order has a larger tail, and more half-swings are followed."""
_EXACT, _EXACT_ORDERS = 6, {**_ORDERS, 1: 40}
"""Up to this integer exponent the exact coefficients come sooner than the balls, and more of them are affordable."""
_REACHES = [arb(k) / 20 for k in (1, 2, 4, 6, 8, 10, 12, 14, 17, 21, 26, 32, 40)]
"""The heights Y of the majorant at which its tail is bounded: each gives a bound, and the least is taken."""


@dataclass(frozen=True)
class CertifiedRatio:
    """The coefficients of L through ``order`` as balls; ``weights``: alpha_i + m_i - 1; ``crests``: k_i."""

    weights: tuple[arb, ...]
    crests: tuple[arb, ...]
    coefficients: Mapping[Key, arb]
    order: int
    losses: tuple[Term, ...] = ()

    @property
    def areas(self) -> list[arb]:
        """J_i: minus the first coefficients."""
        count = len(self.weights)
        # To first order L = -sum J_i delta_i: the areas of the majorant are there already, as balls.
        return [-self.coefficients[tuple(int(i == j) for j in range(count))] for i in range(count)]

    @classmethod
    def of(cls, losses: tuple[Term, ...]) -> "CertifiedRatio":
        """From losses of strength 1, at most four."""
        return _ratio(losses)

    def at(self, delta: Sequence[arb]) -> arb:
        """L at these strengths (balls): by the series, or followed in pieces where its tail is not small.

        UndecidedError where neither serves; minus infinity where no turning point follows.
        """
        try:
            # The upper end as a point: it is compared, and then added as a radius, which Arb rounds up.
            tail = self.tail(delta).upper()
        except UndecidedError:
            tail = arb("inf")
        if tail < _SMALL:
            return self.polynomial(delta) + arb(0, tail)
        # The equation is followed for losses |v|^alpha of strength >= 0 alone: its steps rest on a force that increases
        # with the speed. A gain has the series or nothing.
        if self.losses and all(t.is_power_of_velocity for t in self.losses) and all(d >= 0 for d in delta):
            return followed([(d, t.velocity) for d, t in zip(delta, self.losses)])
        # Here the tail is large but proved, or there is none: then this call raises UndecidedError once more.
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
        # S, H and with them the bound grow with every |delta_i|, so that the largest of a ball serves for all of it.
        sizes = [arb(d.abs_upper()) for d in delta]
        S = sum((d * J for d, J in zip(sizes, self.areas)), arb(0))
        # A larger W only weakens the inequality: e^(W |y|) grows with it, and E = (1 - e^(-W Y))/W falls.
        W = greatest(abs(w) for w in self.weights).upper()
        for Y in _REACHES:
            H = sum((d * k * (abs(w) * Y).exp() for d, k, w in zip(sizes, self.crests, self.weights)), arb(0))
            # The limit for W -> 0, which is that of linear loss, is Y itself; expm1 keeps the digits beside it.
            E = -(-W * Y).expm1() / W if W > 0 else Y
            # The majorant asks q (S + H E) < E strictly: 0.99 leaves room, and costs the bound a factor 0.99^(-K-1), no
            # more.
            q = E * arb("0.99") / (S + H * E)
            # On a circle hardly larger than 1 the geometric sum is more than 21 times its first term, which helps
            # nobody: such a Y is passed over, and without another one the bound is refused.
            if not q > arb("1.05"):
                continue
            bound = Y * q ** (-self.order - 1) / (1 - 1 / q)
            # Every one of these bounds is proved; if two balls overlap either of them will do.
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


# For unit strengths the coefficients depend on the law alone: one table serves all boxes and points of a request.
@lru_cache(maxsize=64)
def _ratio(losses: tuple[Term, ...]) -> CertifiedRatio:
    with ctx.workprec(BITS):
        weights, crests = tuple(term.degree.ball() - 1 for term in losses), tuple(map(_crest, losses))
        if all(term.velocity.is_integer and term.velocity <= _EXACT for term in losses):
            order = _EXACT_ORDERS[len(losses)]
            exact = exact_half_swing(losses, order).L.coefficients
            # The coefficients are exact numbers here; the sum with 0 rounds their balls to BITS.
            return CertifiedRatio(weights, crests, {k: arb(0) + c.ball() for k, c in exact.items()}, order, losses)
        order = _ORDERS[len(losses)]
        L = half_swing(quarter_swing(losses, order)).L
        return CertifiedRatio(weights, crests, dict(L.coefficients), order, losses)


def followed(terms: list[tuple[arb, ExactReal]]) -> arb:
    """L at the strengths >= 0 of powers of the velocity, at any strength, by local expansions and Taylor steps."""
    with ctx.workprec(_FOLLOWED):
        # By scaling, the half-swing from A with strengths epsilon_i is that from 1 with the local ones, epsilon_i
        # A^w_i.
        found = integrated(Damping.of(terms), arb(1))
        # Where the mass stays on its side the decrement exceeds every level, which -L = infinity says: A' is none or 0.
        return arb("-inf") if found.amplitude is None else found.amplitude.log()


def _crest(term: Term) -> arb:
    """The largest value of s^alpha |c|^(m+1)."""
    # The logarithmic derivative alpha cot - (m + 1) tan vanishes once; for alpha = 0 the supremum stands at theta = 0.
    alpha, m = term.velocity.ball(), arb(term.position + 1)
    return arb(1) if term.velocity.is_zero else (alpha / (alpha + m)) ** (alpha / 2) * (m / (alpha + m)) ** (m / 2)


def _product(powers: list[list[arb]], key: Key) -> arb:
    found = arb(1)
    for row, n in zip(powers, key):
        if n:
            found = found * row[n]
    return found
