"""The waveform of the turning-point gauge as enclosures: how large Z_n is, and what the truncated equations leave.

With X - i X' = A e^(i psi) Z, Z = 1 + sum_(1<=|n|<=N+1) delta^n Z_n(psi), U = d ln A/d psi and W = d tau/d psi of the
equations of order N, the motion that an expansion describes satisfies the equations of motion up to A R, per unit of
psi,

    R = Z' - [i (W - 1) Z - (U + U D) Z - i W F e^(-i psi)],       F = sum_i delta_i s^alpha_i g^alpha_i,

s = sin psi, c = cos psi, Z = P + i Q, |X'| = A s g, g = P + (c/s) Q; D multiplies delta^n by sum_i n_i (alpha_i - 1).
Z_n is what makes R vanish with the *true* U and W, through degree N + 1.  Hence R begins with degree N + 1, where only
p_(N+1) and Omega_(N+1) are left, for every psi: what an expansion omits is secular.

*Enclosures.*  [0, pi/2] is cut into pieces; by reversal (``motions.waveform``) the rest is the same.  On a piece
[a, b] the hull of the integrand f encloses int_a^psi f by [0, b - a] f, and the mean of f over [0, psi] is its mean
over [0, a] and a mean value on the piece with the weights a/psi and 1 - a/psi, in [0, 1 - a/b].  So (c/s) Q, which is
psi cot psi times the mean of Q', stays bounded near psi = 0, for every alpha >= 0.  Degree by degree every right-hand
side is known (derivation ``uniform-bound``).

*Beyond degree J* Cauchy's inequality on |delta_i| <= rho takes over, with |g - 1| <= h <= 1/2 there, so that the
real powers are analytic: |g^alpha| <= (1 + h)^alpha, and Z, U and W are bounded by the sums of absolute values.

>>> from asymptotics.numbers.exact import parse_real
>>> drag = waveform_bounds((parse_real("2", "--alpha"),), 2)             # Z_1 at pi/2: -i/3
>>> drag.sizes[1].str(5, radius=False), [c.str(2, radius=False) for c in drag.residual.coefficients[:3]]
('0.33450', ['0.0047', '0.062', '0.035'])
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from flint import arb

from asymptotics.bounds.local import NEXT, Remainder, multinomial
from asymptotics.errors import UndecidedError
from asymptotics.expansions.half_swings.certified import quarter_swing
from asymptotics.expansions.half_swings.quarter import half_swing
from asymptotics.expansions.normal_form.flow import Flow, flow_of
from asymptotics.graded import power_part
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.exact import ExactReal
from asymptotics.running.budget import tick
from asymptotics.series import Key, Series, accumulate, monomials, unit_key

# Bounds of two digits on pieces a thousandth wide: rounding is far below the widths.
BITS = 80
# The hulls are as wide as the pieces, and with each order the widths add up: half as many make the bound of the highest
# degree wider by a fourth (one law) or a tenth (two), twice as many narrower by less than a tenth at twice the cost
# (``benchmarks/constants.json``).  No bound rests on them.
PIECES = {1: 1024, 2: 512}
"""Pieces of the quarter by the number of laws, 128 for more than two; for one law twice as many for each order from 5
to 7."""
Part = dict[Key, Any]
Parts = list[Part]


@dataclass(frozen=True)
class WaveformBounds:
    """|R| <= ``residual``(|delta|), and for |n| = k <= N + 1, all psi, in units of the multinomial coefficient of n:
    |Z_n| <= ``sizes``[k], |Z_n' + i Z_n| <= ``turns``[k], |c P_n - s Q_n| <= ``displacements``[k],
    |s P_n + c Q_n| <= ``velocities``[k]."""

    alphas: tuple[ExactReal, ...]
    p: Series
    Omega: Series
    sizes: tuple[arb, ...]
    turns: tuple[arb, ...]
    displacements: tuple[arb, ...]
    velocities: tuple[arb, ...]
    residual: Remainder


@lru_cache(maxsize=64)
def waveform_bounds(alphas: tuple[ExactReal, ...], order: int) -> WaveformBounds:
    """The bounds for any exponents >= 0 and any order N >= 1.  UndecidedError if no polydisc is verified."""
    count = PIECES.get(len(alphas), 128) * (2 ** min(max(order - 4, 0), 3) if len(alphas) == 1 else 1)
    return _Waveform.of(alphas, order, count).bounds()


@dataclass(frozen=True, eq=False)
class _Pieces:
    """Hulls on the pieces of [0, pi/2]: ends, psi cot psi, s, c; the rest of the class integrates."""

    count: int
    s: Any
    c: Any
    psi_cot: Any

    @classmethod
    def of(cls, count: int) -> "_Pieces":
        h = arb.pi() / (2 * count)
        sines = [arb(0), *((h * k).sin() for k in range(1, count)), arb(1)]
        cosines = [arb(1), *((h * k).cos() for k in range(1, count)), arb(0)]
        # psi cot psi falls on (0, pi/2) from 1 to 0 (derivation ``uniform-bound``): its hull on a piece is that of the
        # ends, as for s, c and s^alpha, which are monotone too.
        psi_cot = [arb(1), *(h * k * cosines[k] / sines[k] for k in range(1, count)), arb(0)]
        return cls(count, *(_hulls(values) for values in (sines, cosines, psi_cot)))

    def power(self, alpha: ExactReal) -> Any:
        """s^alpha, monotone; 1 for alpha = 0, dry friction."""
        if alpha.is_zero:
            return self.s * 0 + 1
        h, a = arb.pi() / (2 * self.count), alpha.ball()
        return _hulls([arb(0), *((h * k).sin() ** a for k in range(1, self.count)), arb(1)])

    def integrate(self, f: Any) -> tuple[Any, Any]:
        """Hulls of int_0^psi f and of the mean of f over [0, psi]."""
        h = arb.pi() / (2 * self.count)
        step, left, total = _between(h), [], arb(0)
        for value in f:
            left.append(total)
            total = total + h * value
        # The mean over [0, psi] on the first piece is a mean of f there; on a later one it lies between the mean before
        # and f, with the weight 1 - a/psi of f in [0, 1/(k+1)].
        means = [f[0]]
        for k, (place, weight) in enumerate(_weights(self.count, ctx.prec), 1):
            before = left[k] / place
            means.append(before + (f[k] - before) * weight)
        return np.array(left, dtype=object) + f * step, np.array(means, dtype=object)


@dataclass(frozen=True, eq=False)
class _Waveform:
    """Z through degree N + 1 and g on the pieces, with the truncated U and W through degree J."""

    order: int
    alphas: tuple[ExactReal, ...]
    weights: tuple[arb, ...]
    true: Flow
    cut: Flow
    pieces: _Pieces
    powers: list[Any]
    P: Parts
    Q: Parts
    g: Parts
    turns: list[arb]

    @classmethod
    def of(cls, alphas: tuple[ExactReal, ...], order: int, count: int) -> "_Waveform":
        with ctx.workprec(BITS):
            last = order + 1 + (NEXT if len(alphas) <= 2 else NEXT // 2)
            true = flow_of(half_swing(quarter_swing(alphas, order + 1)))
            p, Omega = (f.truncate(order).extend(last) for f in (true.p, true.Omega))
            W = (Omega + 1).inverse()
            pieces = _Pieces.of(count)
            zero, one = (0,) * len(alphas), pieces.s * 0 + 1
            weights = tuple(a.ball() - 1 for a in alphas)
            powers = [pieces.power(a) for a in alphas]
            P, Q, g = ([{zero: x}] for x in (one, one * 0, one))
            cut = Flow(true.grading, -p * W, W)
            self = cls(order, alphas, weights, true, cut, pieces, powers, P, Q, g, [arb(1)])
            self._solve()
            return self

    def _solve(self) -> None:
        """Z and g degree by degree, with the true U and W."""
        force = _Force(self)
        for n in range(1, self.order + 2):
            dP, dQ = self._right_hand_sides(self.true, force, n)
            P, Q, g = {}, {}, {}
            for k in dP:
                P[k], _ = self.pieces.integrate(dP[k])
                Q[k], mean = self.pieces.integrate(dQ[k])
                # (c/s) Q = psi cot psi times the mean of Q': bounded near psi = 0, where Q and s vanish together.
                g[k] = P[k] + self.pieces.psi_cot * mean
            self.P.append(P)
            self.Q.append(Q)
            self.g.append(g)
            self.turns.append(_size({k: _modulus(dP[k] - Q[k], dQ[k] + P[k]) for k in dP}))

    def _right_hand_sides(self, flow: Flow, force: "_Force", n: int) -> tuple[Part, Part]:
        """The parts of degree n of i (W - 1) Z - (U + U D) Z - i W F e^(-i psi)."""
        tick("the waveform of an expansion")
        U, W = flow.U.parts, flow.W.parts
        # W F: W begins with 1.
        F: Part = dict(force.part(n))
        for j in range(1, n):
            accumulate(F, W[j], force.part(n - j).items())
        dP = {k: -(self.pieces.s * f) for k, f in F.items()}
        dQ = {k: -(self.pieces.c * f) for k, f in F.items()}
        for j in range(1, n + 1):
            if n - j < len(self.P):
                P, Q = self.P[n - j], self.Q[n - j]
                minus_U = [(k, -u) for k, u in U[j]]
                accumulate(dP, minus_U, self._weighted(P).items())
                accumulate(dQ, minus_U, self._weighted(Q).items())
                accumulate(dP, [(k, -w) for k, w in W[j]], Q.items())
                accumulate(dQ, W[j], P.items())
        return dP, dQ

    def _weighted(self, part: Part) -> Part:
        return {k: x * (1 + sum((n * w for n, w in zip(k, self.weights)), arb(0))) for k, x in part.items()}

    def bounds(self) -> WaveformBounds:
        with ctx.workprec(BITS):
            s, c, none = self.pieces.s, self.pieces.c, self.pieces.s * 0
            turned = [[(P[k], Q[k], k) for k in P] for P, Q in zip(self.P, self.Q)]
            sizes = [_size({k: _modulus(p, q) for p, q, k in part}) for part in turned]
            x = [_size({k: _modulus(c * p - s * q, none) for p, q, k in part}) for part in turned]
            v = [_size({k: _modulus(s * p + c * q, none) for p, q, k in part}) for part in turned]
            force, rows = _Force(self), [self._secular()]
            for n in range(self.order + 2, self.cut.order + 1):
                dP, dQ = self._right_hand_sides(self.cut, force, n)
                # Z has no degree n here, so that what the right-hand side makes of it is the residual.
                rows.append(_size({k: _modulus(dP[k], dQ[k]) for k in dP}))
            M, rho = self._cauchy()
            # Dry friction alone: Z of two orders is the whole motion, by the closed form.
            if len(self.alphas) == 1 and self.alphas[0].is_zero:
                M = arb(0)
            p, Omega = (f.truncate(self.order).without_constant() for f in (self.true.p, self.true.Omega))
            remainder = Remainder(self.order + 1, tuple(rows), M, rho)
            return WaveformBounds(self.alphas, p, Omega, tuple(sizes), tuple(self.turns), tuple(x), tuple(v), remainder)

    def _secular(self) -> arb:
        """|R| of degree N + 1: the true U and W less those of order N, the same for every psi."""
        n, found = self.order + 1, {}
        for k in monomials(len(self.alphas), n):
            found[k] = _modulus(arb(self.true.U[k]) - arb(self.cut.U[k]), arb(self.true.W[k]) - arb(self.cut.W[k]))
        return _size(found)

    def _cauchy(self) -> tuple[arb, arb]:
        """(M, rho): |R - Z'| <= M for complex |delta_i| <= rho; |g - 1| <= 1/2 and 1 + Omega_N != 0 there."""
        one = arb(1)
        p, Omega = ((f.truncate(self.order)) for f in (self.true.p, self.true.Omega))
        # Radii 3/(k + 2), the first on which |g - 1| <= 1/2 and |1 + Omega_N| >= 1/2: hypotheses of the bound, choices
        # of the values.
        for k in range(1, 60):
            rho = one * 3 / (k + 2)
            deltas = (rho,) * len(self.alphas)
            growth = _sum(self.g, rho) - 1
            swing = 1 - _absolute(Omega.without_constant()).at(deltas)
            if not (growth < one / 2 and swing > one / 2):
                continue
            Z, weighted = (
                _sum(self.P, rho, self.Q),
                _sum([self._weighted(P) for P in self.P], rho, [self._weighted(Q) for Q in self.Q]),
            )
            W = 1 / swing
            force = sum((rho * (1 + growth) ** a.ball() for a in self.alphas), arb(0))
            return arb(((W - 1) * Z + _absolute(p).at(deltas) * W * weighted + W * force).upper()), arb(rho.mid())
        raise UndecidedError("no polydisc was verified on which the waveform may be expanded")


class _Force:
    """F by degree: sum_i delta_i s^alpha_i g^alpha_i; g^alpha by n y_n = sum_j (alpha j - (n - j)) g_j y_(n-j)."""

    def __init__(self, waveform: _Waveform) -> None:
        self._w = waveform
        self._powers: list[Parts] = [[waveform.g[0]] for _ in waveform.alphas]

    def part(self, n: int) -> Part:
        """F of degree n >= 1; needs g below that degree, which is 0 where it is not there."""
        F: Part = {}
        for i, powers in enumerate(self._powers):
            while len(powers) < n:
                powers.append(power_part(self._w.g, powers, self._w.alphas[i].ball(), len(powers)))
            key = unit_key(i, len(self._powers))
            accumulate(F, [(key, self._w.powers[i])], powers[n - 1].items())
        return F


@lru_cache(maxsize=8)
def _weights(count: int, bits: int) -> tuple[tuple[arb, arb], ...]:
    """The beginnings of all pieces but the first, and the intervals [0, 1/(k+1)]."""
    with ctx.workprec(bits):
        h = arb.pi() / (2 * count)
        return tuple((h * k, _between(arb(1) / (k + 1))) for k in range(1, count))


def _between(h: arb) -> arb:
    """The ball that holds the interval [0, h]."""
    return arb(0).union(h)


def _hulls(values: Sequence[arb]) -> Any:
    # Of monotone functions alone: the union of the ends holds all values between.
    return np.array([a.union(b) for a, b in zip(values, values[1:])], dtype=object)


def _modulus(x: Any, y: Any) -> Any:
    """The largest sqrt(x^2 + y^2) on the pieces."""
    pairs = zip(np.atleast_1d(x), np.atleast_1d(y))
    largest = max(arb((a * a + b * b).upper()) for a, b in pairs)  # exact: no float decides
    return arb(largest.sqrt().upper())


def _size(part: dict[Key, Any]) -> arb:
    """max_n |c_n|/binomial(k; n): sum_(|n|=k) |c_n| delta^n is at most that times |delta|^k."""
    return max(arb((c / multinomial(k)).upper()) for k, c in part.items())


def _sum(parts: Parts, rho: arb, others: Parts | None = None) -> arb:
    """sum_n sup |c_n| rho^|n|, c = x + i y."""
    total = arb(0)
    for n, part in enumerate(parts):
        for k, x in part.items():
            total += arb(_modulus(x, x * 0 if others is None else others[n][k])) * rho**n
    return total


def _absolute(f: Series) -> Series:
    return f.map(lambda c: arb(abs(arb(c)).upper()))
