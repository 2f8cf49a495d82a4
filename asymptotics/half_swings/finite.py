"""A half-swing at finite strength by the series of the quarter-swing: balls whose tails are proved.

The series R(delta) = ln r(pi/2)/r(0) and T_q(delta) of ``certified`` are summed through order N.  What is cut off is

    sum_(N < |n| <= N+K) |R_n| |delta|^n  +  M x^(N+K+1)/(1 - x),     x = max_i |delta_i|/rho_i < 1,

the next K orders as they are, and Cauchy's inequality beyond, with M from ``finite_majorant`` on the polydisc of radii
rho_i.  The first part makes the bound nearly attained, the second is small against it.

*The half-swing.*  L = ln(A_(n+1)/A_n) is the root of G(L) = L - R(delta) + R(-F(L)), F_i = delta_i e^((alpha_i-1) L)
(reversal identity).  G increases, because L + R(-F) is ln r at the passage of an orbit that starts at ln r = L, and
orbits do not meet.  If all alpha_i >= 1 even G' >= 1, since R falls in each delta_i: any number L_hat is then off by at
most |G(L_hat)|.  Otherwise a sign change of G encloses L.  (Derivation ``quarter-swing-tail``.)

*Many half-swings.*  x = ln A is carried as an exact midpoint with a radius e.  For all alpha_i >= 1 two motions satisfy
0 <= d ln A_(n+1)/d ln A_n <= 1, so e grows by the local error only; otherwise |Delta A_(n+1)| <= |Delta A_n| is used.

>>> from asymptotics.numbers.exact import parse_real
>>> quarter = finite_quarter([parse_real("2", "--alpha")], [arb(1) / 10], bits=60)
>>> swing = quarter.half_swing([arb(1) / 10])
>>> swing.amplitude.str(12), swing.duration.str(12)      # 1 + W_0(-(1 + 2 delta) e^-(1 + 2 delta)) over 2 delta
('[0.882189986247 +/- 3.07e-13]', '[3.14622255601 +/- 1.01e-12]')
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import ceil, log, log2

from flint import arb, arb_poly, ctx

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.half_swings.certified import RADIUS, enclose, tail_constants, truncated_sums
from asymptotics.half_swings.finite_majorant import BITS, Majorant, majorant, widest
from asymptotics.half_swings.forces import Forces
from asymptotics.numbers.exact import ExactReal
from asymptotics.series import Key, Series

NEXT = 8
"""K of the module docstring."""
ROUTE = "series of the quarter-swing"
MAX_ORDER = {1: 96, 2: 16, 3: 10, 4: 8}
"""The highest order that is computed, by the number of laws: a few seconds to half a minute."""
_STEP = 4
_EXTRA = 40
"""Bits beyond those asked for: with them the next coefficients are sharp, and so is the tail."""


@dataclass(frozen=True)
class Tail:
    """What a sum through ``order`` lacks: the next orders in absolute value, and ``cauchy`` x^(last+1)/(1 - x)."""

    following: Series
    order: int
    last: int
    cauchy: arb

    def __call__(self, size: Sequence[arb], x: arb) -> arb:
        """A bound at |delta_i| <= size[i], x = max size[i]/rho_i; UndecidedError for x >= 1."""
        if not x < 1:
            raise UndecidedError("delta is outside the polydisc in which the series is proved to converge")
        rest = self.cauchy * x ** (self.last + 1) / (1 - x)
        bound: arb = (self.following.at(tuple(size)) + rest).upper()
        return bound


@dataclass(frozen=True)
class TruncatedSum:
    """A function of the delta_i by its series through some order, with the tail of the rest."""

    series: Series
    tail: Tail

    def __post_init__(self) -> None:
        one = self.series.variables == 1
        rows = [self.series[k] for k in range(self.series.order + 1)] if one else []
        object.__setattr__(self, "_polynomial", arb_poly(rows) if one else None)

    def __call__(self, delta: Sequence[arb], tail: arb) -> arb:
        """The value at real balls delta_i, ``tail`` being the bound of `Tail` there."""
        polynomial: arb_poly | None = self._polynomial  # type: ignore[attr-defined]
        value = polynomial(delta[0]) if polynomial is not None else self.series.at(tuple(delta))
        return value + arb(0, tail)


@dataclass(frozen=True)
class SwingValue:
    """One half-swing: L = ln(q/p), amplitude = q/p and duration as balls; how they were found.

    ``terms``: the order of the series (or the number of pieces, nodes, ...); ``tail``: the largest bound of what was
    cut off in L.
    """

    log_ratio: arb
    amplitude: arb
    duration: arb
    route: str
    terms: int
    tail: arb


@dataclass(frozen=True, eq=False)
class FiniteQuarter:
    """R and T_q with their tails on the polydisc of ``majorant``; build it with `finite_quarter`."""

    weights: tuple[arb, ...]
    expanding: bool
    R: TruncatedSum
    T: TruncatedSum
    majorant: Majorant

    def half_swing(self, delta: Sequence[arb]) -> SwingValue:
        """The half-swing at the local strengths ``delta`` (balls >= 0); UndecidedError outside the polydisc."""
        before = self._R(delta)
        guess = self._newton(delta, before)
        L = self._enclosed(delta, before, guess)
        after = [-f for f in self.strengths(delta, L)]
        duration = self._T(delta) + self._T(after)
        tail = 2 * self._tail(self.R, delta).max(self._tail(self.R, after))
        return SwingValue(L, L.exp(), duration, ROUTE, self.R.series.order, tail.upper())

    def orbit(self, epsilons: Sequence[arb], start: arb, radius: arb) -> "Iterator[tuple[arb, arb, arb]]":
        """Yield (x_n, e_n, T_n): ln A_n is within e_n of the exact x_n, and T_n is the duration of half-swing n.

        Starts at ln A_0 = ``start`` +- ``radius`` (of A relative); the amplitude is in the units of epsilon.
        """
        x, e = start.mid(), radius + start.rad()
        tails = None
        while True:
            wide = self._at(epsilons, x + arb(0, e))
            if self.expanding or tails is None:  # else the delta_i never grow, nor do the tails
                tails = self._tail(self.R, wide), self._tail(self.T, wide)
            delta = self._at(epsilons, x)
            before = self.R(delta, tails[0])
            L = self._enclosed(delta, before, self._newton(delta, before), None if self.expanding else tails[0])
            following, e_next = (x + L).mid(), self._carried(e, L) + (x + L).rad()
            after = [-f for f in self._at(epsilons, following + arb(0, e_next))]
            ending = self._T(after) if self.expanding else self.T(after, tails[1])
            yield x, e, self.T(wide, tails[1]) + ending
            x, e = following, e_next

    def strengths(self, delta: Sequence[arb], L: arb) -> list[arb]:
        """F_i = delta_i e^((alpha_i - 1) L)."""
        return [d * (w * L).exp() for d, w in zip(delta, self.weights, strict=True)]

    def _at(self, epsilons: Sequence[arb], x: arb) -> list[arb]:
        return [e * (w * x).exp() for e, w in zip(epsilons, self.weights, strict=True)]

    def _carried(self, e: arb, L: arb) -> arb:
        """The error of ln A after a half-swing from the error before it."""
        if self.expanding:
            change = (e.exp() - 1) * (-L).exp()
            e = -(1 - change.upper()).log()
        return e.upper()

    def _tail(self, f: TruncatedSum, delta: Sequence[arb]) -> arb:
        with ctx.workprec(BITS):
            return f.tail([abs(d).upper() for d in delta], self.majorant.ratio(delta))

    def _R(self, delta: Sequence[arb]) -> arb:
        return self.R(delta, self._tail(self.R, delta))

    def _T(self, delta: Sequence[arb]) -> arb:
        return self.T(delta, self._tail(self.T, delta))

    def _residual(self, delta: Sequence[arb], before: arb, L: arb, tail: arb | None = None) -> arb:
        """G(L); ``tail`` bounds that of R at the end if it is known."""
        after = [-f for f in self.strengths(delta, L)]
        return L - before + (self._R(after) if tail is None else self.R(after, tail))

    def _newton(self, delta: Sequence[arb], before: arb) -> arb:
        """An exact number near the root, by a secant iteration without any claim: the one with the least residual."""
        L, slope = (2 * before).mid(), arb(1)
        best, last = L, None
        for _ in range(60):
            residual = (L - before + self._plain([-f.mid() for f in self.strengths(delta, L)])).mid()
            if last is not None:
                if not abs(residual) < abs(last[1]):
                    break
                if last[0] != L:
                    slope = ((residual - last[1]) / (L - last[0])).mid()
            best, step = L, (residual / slope).mid()
            last, L = (L, residual), (L - step).mid()
            if abs(step) <= arb(2) ** (8 - ctx.prec) * abs(L) or not step.is_finite():
                break
        found = L if last is not None and abs(L - best) <= abs(best) / 4 else best
        return found if self.expanding or found < 0 else arb(0)  # the delta_i do not grow: the known tails hold

    def _plain(self, delta: Sequence[arb]) -> arb:
        return self.R(delta, arb(0))

    def _enclosed(self, delta: Sequence[arb], before: arb, guess: arb, tail: arb | None = None) -> arb:
        residual = abs(self._residual(delta, before, guess, tail)).upper()
        if not self.expanding:
            return guess + arb(0, residual)
        for widening in (2, 8, 64):
            e = residual * widening
            below, above = (self._residual(delta, before, guess + side * e) for side in (-1, 1))
            if below < 0 and above > 0:
                return guess + arb(0, e)
        raise UndecidedError("the half-swing is not enclosed: raise the precision, or delta is too near its end")


def finite_quarter(alphas: Sequence[ExactReal], delta: Sequence[arb], bits: int) -> FiniteQuarter:
    """The quarter-swing summed so that R has a tail below 2^-``bits`` at local strengths up to ``delta``.

    Tables of coefficients are kept per law and precision.  LimitError if the order would be too high: delta is too near
    the radius, or there are too many laws.
    """
    direction = (1.0,) if len(alphas) == 1 else tuple(float(d) for d in delta)
    radii = _polydisc(tuple(alphas), direction)
    order = _order(radii, delta, bits)
    highest = MAX_ORDER[len(alphas)]
    if order > highest:
        shown = ", ".join(d.str(3, radius=False) for d in delta)
        reason = f"{shown} is out of reach of the series of the quarter-swing with {bits} bits"
        raise LimitError("delta", reason, f"what order {highest} can do: a smaller delta or fewer digits")
    return _table(tuple(alphas), tuple(float(r) for r in radii.radii), order, _STEP * 8 * ceil(bits / (8 * _STEP)))


def _order(bound: Majorant, delta: Sequence[arb], bits: int) -> int:
    """The order at which Cauchy's bound is below 2^-bits, rounded up; a float chooses it."""
    x = float(bound.ratio(delta))
    if not 0 < x < 1:
        return _STEP if x == 0 else 10**9
    needed = (bits + max(0.0, log2(float(bound.growth) / (1 - x)))) / -log2(x)
    return _STEP * ceil(max(needed, 1) / _STEP)


def series_reach(alpha: ExactReal, bits: int, order: int) -> arb:
    """The largest delta at which the series of one law needs no more than ``order`` for 2^-bits (by Cauchy's bound)."""
    bound = _polydisc((alpha,), (1.0,))
    with ctx.workprec(BITS):
        return bound.radii[0] * arb(2) ** (-arb(bits + 8) / order)


@lru_cache(maxsize=32)
def _polydisc(alphas: tuple[ExactReal, ...], delta: tuple[float, ...]) -> Majorant:
    """The largest polydisc found in the direction of ``delta``."""
    with ctx.workprec(BITS):
        top = max(delta)
        direction = [arb(max(d / top, 1e-6)) if top > 0 else arb(1) for d in delta]
        return widest([a.ball() for a in alphas], direction)


@lru_cache(maxsize=16)
def _table(alphas: tuple[ExactReal, ...], radii: tuple[float, ...], order: int, bits: int) -> FiniteQuarter:
    """Coefficients through order + K, good to 2^-``bits`` at strengths that need this order, and their tails."""
    with ctx.workprec(BITS):
        balls, forces = [a.ball() for a in alphas], Forces.losses(alphas)
        bound = majorant(balls, [arb(r) for r in radii])
        if bound is None:
            raise UndecidedError("the polydisc of the series was not verified")
        last = order + NEXT
        tails, sizes = (tail_constants(forces, last, radius, False) for radius in (RADIUS, 1))
        share = -bits / order  # log2 of the x at which the order is just enough
        terms = ceil((bits + _largest(tails, radii, share)) / log2(RADIUS)) + _EXTRA // 2
        guard = _EXTRA + ceil(_largest(sizes, radii, share))
    with ctx.workprec(bits + guard):
        exact = [a.ball() for a in alphas]
        sums = truncated_sums(forces, last, terms, False)
        series = [Series(enclose(s, b, RADIUS, terms), len(alphas), last) for s, b in zip(sums, tails, strict=True)]
        weights = tuple(a - 1 for a in exact)
    with ctx.workprec(BITS):
        R, T = (_cut(f, order, m) for f, m in zip(series, (bound.growth, bound.excess), strict=True))
    return FiniteQuarter(weights, any(a < 1 for a in alphas), R, T, bound)


def _largest(bounds: Sequence[Mapping[Key, arb]], radii: Sequence[float], share: float) -> float:
    """log2 of the largest bound times |delta|^n, |delta_i| = 2^share rho_i, at least 0; it decides widths only."""
    logs = [log2(r) + share for r in radii]
    sizes = [
        float(b.log()) / log(2) + sum(k * x for k, x in zip(n, logs, strict=True))
        for part in bounds
        for n, b in part.items()
    ]
    return max(0.0, *sizes)


def _cut(f: Series, order: int, cauchy: arb) -> TruncatedSum:
    following = {n: abs(c).upper() for n, c in f.coefficients.items() if sum(n) > order}
    return TruncatedSum(f.truncate(order), Tail(Series(following, f.variables, f.order), order, f.order, cauchy))
