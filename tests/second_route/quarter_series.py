"""Half-swings by the series of the quarter-swing, as a second route: balls that share nothing with Taylor steps.

The series R(delta) = ln r(pi/2)/r(0) and T_q(delta) of ``half_swings.certified`` are summed through order N; what is
cut off is bounded by the next K orders and, beyond, by Cauchy's inequality with the majorant (``finite_majorant``).
L = ln(A_(n+1)/A_n) is the root of G(L) = L - R(delta) + R(-F(L)) (reversal identity).  Cold it is slower than the
pieces in every case that was measured, so the library does without it; for hundreds of half-swings it is quick.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from math import ceil, log, log2

from flint import arb, arb_poly

from asymptotics.errors import LimitError, UndecidedError
from asymptotics.expansions.half_swings.certified import RADIUS, enclose, tail_constants, truncated_sums
from asymptotics.expansions.half_swings.finite_majorant import BITS, Majorant, majorant, widest
from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.exact import ExactReal
from asymptotics.series import Key, Series

NEXT = 8
"""K of the module docstring."""
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


@dataclass(frozen=True, eq=False)
class FiniteQuarter:
    """R and T_q with their tails on the polydisc of ``majorant``; build it with `finite_quarter`."""

    weights: tuple[arb, ...]
    expanding: bool
    R: TruncatedSum
    T: TruncatedSum
    majorant: Majorant

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
            ending = self.T(after, self._tail(self.T, after)) if self.expanding else self.T(after, tails[1])
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

    def _residual(self, delta: Sequence[arb], before: arb, L: arb, tail: arb | None = None) -> arb:
        """G(L); ``tail`` bounds that of R at the end if it is known."""
        after = [-f for f in self.strengths(delta, L)]
        return L - before + self.R(after, self._tail(self.R, after) if tail is None else tail)

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
