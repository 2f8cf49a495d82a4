"""One Taylor step in time from an exact state with w > 0, as an enclosure: the error is bounded by the residual.

From p = w^alpha: w l = w' and p' = alpha l p, one product of series each.  Let W, Y be the Taylor polynomials of degree
n, and R such that rho w_0 := sum_(k>=1) |w_k| R^k < w_0.  On |t| <= R, |W^alpha| <= (w_0 (1+rho))^alpha, so by Cauchy
the terms of N(W) from t^n on are at most N(w_0 (1+rho)) (t/R)^n/(1 - t/R).  The polynomials solve the equations up to

    Y' + W = w_n t^n,        W' - Y + N(W) = -y_n t^n + (terms of N(W) from t^n on),

and two motions never part (derivation ``motions-never-part``): the Euclidean error at time h is at most the integral

    (|w_n| + |y_n|) h^(n+1)/(n+1) + N(w_0 (1+rho)) (h/R)^n h/((n+1) (1 - h/R)).     (derivation ``taylor-residual``)

The true motion may meanwhile have turned: nothing above needs its speed to stay positive.

>>> from fractions import Fraction
>>> from asymptotics.numbers.exact import ExactReal
>>> with ctx.workprec(60):
...     law = Damping.of([(arb(1) / 10, ExactReal(Fraction(3, 2)))])
...     step = TaylorStep.at(law, arb(0), arb(1), arb(1))
...     y, w = step.state(step.length)
>>> step.length > 0.1, y < 0, step.error < 1e-17
(True, True, True)
"""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from operator import mul

from flint import arb, arb_poly, ctx

from asymptotics.errors import UndecidedError
from asymptotics.swing.damping import Damping, dyadic, size_of, upper

GUARD = 32  # bits more for the coefficients, whose recurrence cancels; the law should carry them
_SHARES = (0.95, 0.88, 0.8, 0.7, 0.6, 0.5, 0.3, 0.15)
_LOW = 40  # bits in which bounds are computed


@dataclass(frozen=True)
class TaylorStep:
    """Taylor polynomials of y and w, good for 0 <= t <= ``length`` up to the Euclidean distance ``error``."""

    ys: tuple[arb, ...]
    ws: tuple[arb, ...]
    length: arb
    error: arb

    @classmethod
    def at(cls, damping: Damping, y: arb, w: arb, scale: arb) -> "TaylorStep":
        """A step from (y, w), w > 0 exact, whose error is near 2^-precision ``scale``."""
        tolerance = size_of(scale) - ctx.prec
        with ctx.workprec(ctx.prec + GUARD):
            ys, ws = coefficients(damping, y, w, order_for(ctx.prec - GUARD))
        with ctx.workprec(_LOW):
            radius, resistance, length = max(
                ((*disc, _length(ys, ws, *disc, tolerance)) for disc in discs(damping, ws)),
                key=lambda found: size_of(found[2]),
            )
            error = residual(ys, ws, length, radius, resistance)
        return cls(tuple(ys), tuple(ws), length, error)

    @cached_property
    def _polynomials(self) -> tuple[arb_poly, arb_poly]:
        return arb_poly(list(self.ys)), arb_poly(list(self.ws))

    def state(self, t: arb) -> tuple[arb, arb]:
        """(y, w) of the Taylor polynomials at 0 <= t <= ``length``; the truth is within ``error`` of it."""
        y, w = self._polynomials
        return y(t), w(t)


def order_for(bits: int) -> int:
    """The degree at which full precision is reached near e^-1.65 of the radius."""
    return int(0.42 * bits) + 6


def coefficients(damping: Damping, y: arb, w: arb, order: int) -> tuple[list[arb], list[arb]]:
    """Taylor coefficients of y and w about a state with w > 0, through t^order."""
    ys, ws, slopes = [y], [w], []
    inverse, powers = 1 / w, [[p] for p in damping.terms(w)]
    ratio: list[arb] = []  # of w'/w
    none = arb(0)
    for k in range(order):
        slope = ys[k] - sum((p[k] for p in powers), none)
        ys.append(-ws[k] / (k + 1))
        ws.append(slope / (k + 1))
        slopes.append(slope)
        ratio.append((slope - sum(map(mul, ws[1 : k + 1], reversed(ratio)), none)) * inverse)
        for a, p in zip(damping.exponents, powers):
            p.append(a * sum(map(mul, ratio, reversed(p)), none) / (k + 1))
    return ys, ws


def discs(damping: Damping, ws: list[arb]) -> Iterator[tuple[arb, arb]]:
    """(R, N(w_0 (1+rho))) for the largest R of a few with rho certainly below 1.

    For large exponents, where N(w_0 (1+rho)) is huge, also for smaller ones.
    """
    w = ws[0]
    start, bounds = size_of(w), [abs(c).upper() for c in ws[1:]]
    sizes = [(start - size_of(c)) / k for k, c in enumerate(bounds, start=1) if c != 0]
    widest = min(sizes, default=0.0)
    moving = arb_poly([arb(0), *bounds])
    for share in _SHARES:
        radius = dyadic(widest) * arb(share)
        moved = upper(moving(radius))
        if moved < w:
            yield radius, upper(damping.resistance(w + moved))
            break
    else:
        raise UndecidedError("the Taylor coefficients of a step are too wide")
    steepest = max((a for _, a in damping.sizes), default=0.0)
    for part in (16, 8, 4, 2, 1) if steepest > 8 else ():
        smaller = radius * arb(min(1.0, part / steepest))
        yield smaller, upper(damping.resistance(w + upper(moving(smaller))))


def _length(ys: list[arb], ws: list[arb], radius: arb, resistance: arb, tolerance: float) -> arb:
    """A step for which ``residual`` is near 2^tolerance; chosen in doubles."""
    order, largest = len(ws) - 1, size_of(radius)
    sizes = [(size_of(resistance) - order * largest, order), *((size_of(c[-1]), order + 1) for c in (ys, ws))]
    return dyadic(min(largest - 0.2, *((tolerance - size) / power for size, power in sizes)))


def residual(ys: list[arb], ws: list[arb], length: arb, radius: arb, resistance: arb) -> arb:
    """The bound of the module's docstring at h = ``length`` < R = ``radius``."""
    n, share = len(ws) - 1, length / radius
    cut = (abs(ws[-1]) + abs(ys[-1])) * length ** (n + 1)
    return upper((cut + resistance * share**n * length / (1 - share)) / (n + 1))
