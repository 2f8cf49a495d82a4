"""One Taylor step in time from an exact state with w > 0, as an enclosure: the error is bounded by the residual.

The powers w^alpha come from w l = w' and p' = alpha l p, those of u and the sine from ``composition``.  Let W, U be
the Taylor polynomials of degree n, and on |t| <= R |U - u_0| <= du, |W - w_0| <= dw < w_0, |G(U, W)| <= M
(``largest``).  They solve the equations up to

    U' + W = w_n t^n,        W' - G(U, W) = (terms of G(U, W) from t^n on),

so two motions that follow them part, in the distance of ``distance``, at time h by at most the growth factor times

    unit |w_n| h^(n+1)/(n+1) + M (h/R)^n h/((n+1) (1 - h/R))              (derivation ``taylor-residual``).

>>> from asymptotics.law import Law
>>> with ctx.workprec(60):
...     force = Force.of(Law({"3/2": "1/10"}, spring="pendulum").terms)
...     step = TaylorStep.at(force, arb(0), arb(1), arb(1), arb(1))
...     u, w = step.state(step.length)
>>> step.length > 0.1, u < 0, step.residual < 1e-17
(True, True, True)
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from functools import cached_property

from flint import arb, arb_poly, ctx

from asymptotics.errors import UndecidedError
from asymptotics.swing.damping import dyadic, size_of, upper
from asymptotics.swing.taylor import GUARD, order_for
from asymptotics.wells.composition import Curve, Line
from asymptotics.wells.force import Force

_SHARES = (0.95, 0.85, 0.7, 0.55, 0.4, 0.25, 0.12, 0.05)
_LOW = 40


@dataclass(frozen=True)
class TaylorStep:
    """Taylor polynomials of u and w, good for 0 <= t <= ``length`` but for the integrated ``residual``.

    ``radius`` and ``largest``: R and M of the module's docstring.
    """

    us: tuple[arb, ...]
    ws: tuple[arb, ...]
    length: arb
    unit: arb
    radius: arb
    largest: arb

    @classmethod
    def at(cls, force: Force, u: arb, w: arb, unit: arb, scale: arb) -> "TaylorStep":
        """A step from the exact (u, w), w > 0, whose residual is near 2^-precision ``scale``."""
        tolerance = size_of(scale) - ctx.prec
        with ctx.workprec(ctx.prec + GUARD):
            us, ws = coefficients(force, u, w, order_for(ctx.prec - GUARD))
        with ctx.workprec(_LOW):
            found = [(*disc, _length(ws, unit, *disc, tolerance)) for disc in discs(force, us, ws)]
            if not found:
                raise UndecidedError("the Taylor coefficients of a step are too wide")
            radius, largest, length = max(found, key=lambda one: size_of(one[2]))
        return cls(tuple(us), tuple(ws), length, unit, radius, largest)

    def shortened(self, length: arb) -> "TaylorStep":
        """The same polynomials for a shorter time."""
        return replace(self, length=length)

    @cached_property
    def residual(self) -> arb:
        """The integral of the residual at h = ``length`` < R = ``radius``."""
        with ctx.workprec(_LOW):
            h, n = self.length, len(self.ws) - 1
            share = h / self.radius
            cut = self.unit * abs(self.ws[-1]) * h ** (n + 1)
            return upper((cut + self.largest * share**n * h / (1 - share)) / (n + 1))

    @cached_property
    def box(self) -> tuple[arb, arb]:
        """Balls with all places and speeds of the polynomials; U falls.  UndecidedError where w may vanish."""
        with ctx.workprec(_LOW):
            h, n = self.length, len(self.ws) - 1
            w = arb(self.ws[0].mid(), upper(sizes(self.ws)(h) + self.ws[0].rad()))
            if not w.lower() > abs(self.ws[-1]) * h**n:
                raise UndecidedError("the speed of a step may vanish")
            return self.us[0].union(self.state(h)[0]), w

    @cached_property
    def _polynomials(self) -> tuple[arb_poly, arb_poly]:
        return arb_poly(list(self.us)), arb_poly(list(self.ws))

    def state(self, t: arb) -> tuple[arb, arb]:
        """(u, w) of the Taylor polynomials at 0 <= t <= ``length``."""
        u, w = self._polynomials
        return u(t), w(t)


def coefficients(force: Force, u: arb, w: arb, order: int) -> tuple[list[arb], list[arb]]:
    """Taylor coefficients of u and w about a state with w > 0, through t^order; at u = 0 on the side u < 0."""
    side = 1 if u > 0 else -1
    rest = force.rest_powers(side)
    grid, ws, ln_w, inverse = Line(()), [w], w.log(), 1 / w
    curve = Curve(grid, force.rate, {n for _, n in rest} | {f.place for f in force.losses if f.place}, u)
    factors = [(-f.strength * side**f.place, f.place) for f in force.losses]
    powers = [[(f.exponent * ln_w).exp()] for f in force.losses]
    ratio: list[arb] = []  # of w'/w
    for k in range(order):
        slope = curve.rest(rest)
        for (c, m), p in zip(factors, powers):
            slope += c * (grid.product(curve.power[m], p) if m else p[-1])
        curve.append(-ws[k] / (k + 1))
        ws.append(slope / (k + 1))
        ratio.append((slope - grid.product_from_1(ws[: k + 1], ratio)) * inverse)
        for f, p in zip(force.losses, powers):
            p.append(f.exponent * grid.product(ratio, p) / (k + 1))
    return curve.u, ws


def discs(force: Force, us: list[arb], ws: list[arb]) -> Iterator[tuple[arb, arb]]:
    """(R, M) for some R on which W keeps its sign certainly."""
    w, moving_u, moving_w = ws[0], sizes(us), sizes(ws)
    start = size_of(w)
    steepest = [(start - size_of(c)) / k for k, c in enumerate(moving_w.coeffs()) if c != 0]
    widest = min(steepest, default=0.0)
    for share in _SHARES:
        radius = dyadic(widest) * arb(share)
        moved = upper(moving_w(radius))
        if moved < w:
            yield radius, force.largest(us[0], upper(moving_u(radius)), w, moved)


def sizes(series: "list[arb] | tuple[arb, ...]") -> arb_poly:
    """sum_(k>=1) |c_k| t^k."""
    return arb_poly([arb(0), *(abs(c).upper() for c in series[1:])])


def _length(ws: list[arb], unit: arb, radius: arb, largest: arb, tolerance: float) -> arb:
    """A step for which the residual is near 2^tolerance; chosen in doubles."""
    order, edge = len(ws) - 1, size_of(radius)
    sizes = [(size_of(largest) - order * edge, order), (size_of(unit) + size_of(ws[-1]), order + 1)]
    return dyadic(min(edge - 0.2, *((tolerance - size) / power for size, power in sizes)))
