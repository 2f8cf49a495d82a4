"""One Taylor step in time from an exact state with w > 0, as an enclosure: the error is bounded by the residual.

The residual (the field says defect) of any approximant bounds how far the truth parts from it: the differential
inequality of the logarithmic norm (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
theorem I.10.6).  The powers p = w^alpha come from w l = w' and p' = alpha l p, those of u and the sine from
``composition``.  Let W, U be the Taylor polynomials of degree n, and on |t| <= R |U - u_0| <= du, |W - w_0| <= dw <
w_0, |F(U, W)| <= M (``largest``), where G = lambda u + F: lambda is 1 where F depends on w alone, else 0 (``linear``).
By Cauchy they solve the equations up to

    U' + W = w_n t^n,        W' - G(U, W) = -lambda u_n t^n + (terms of F(U, W) from t^n on),

so the truth parts from them, in the distance with the given ``unit`` of places, at time h by at most the factor by
which distances grow times

    (unit |w_n| + lambda |u_n|) h^(n+1)/(n+1) + M (h/R)^n h/((n+1) (1 - h/R))        (derivation ``taylor-residual``).

Beside the linear spring the factor is 1.  The true motion may meanwhile have turned: nothing above needs its speed to
stay positive.

>>> from asymptotics.law import Law
>>> from asymptotics.flow.damping import Damping
>>> with ctx.workprec(60):
...     law = Damping.of_law(Law({"3/2": "1/10"}))
...     step = TaylorStep.at(law, arb(0), arb(1), arb(1), arb(1))
...     u, w = step.state(step.length)
>>> step.length > 0.1, u < 0, step.residual < 1e-17
(True, True, True)
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from math import inf
from operator import mul

from flint import arb, arb_poly, arb_series

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import dyadic, size_of, upper
from asymptotics.flow.composition import ComposedSeries, ExponentLine
from asymptotics.flow.force import Smooth
from asymptotics.flow.growing_product import GrowingProduct, block_for
from asymptotics.numbers.context import cached_property, ctx

GUARD = 32  # bits more for the coefficients, whose recurrence cancels; the force should carry them
DEGREE_PER_BIT = 0.42
"""The degree n of a step for each bit.  A step of n terms is as long as R 2^(-bits/n) and costs n^2 products, so the
cost per time is least at n = (ln 2/2) bits = 0.35 bits.  What a step costs besides, its discs and its state, asks for
longer ones: measured for 0.25, 0.35, 0.42, 0.5 and 0.69 on a busy machine, a half-swing of x'|x'|^(1/2)/5 took 24, 19,
19, 19 and 16 ms in 100 bits, 166, 121, 112, 114 and 118 in 300, and 1.43, 1.15, 1.12, 1.14 and 1.19 s in 1000."""
_LEAST, _BLOCK = 12, 12
"""Coefficients up to which the recurrence is faster than the second half from the first; those of the second half up to
which sums are faster than a product.  Choices: 20 and 30, 10 and 24 take as long within 5 %."""
_SHARES = (0.95, 0.88, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.12, 0.05, 0.02, 0.01, 0.004, 0.001)
"""Radii to try, in units of one where no term of W exceeds w_0: dense where a step usually is, and down to a thousandth
for a force that grows fast."""
_NEXT = 0.1  # log2 of the ratio of two of them at least: 0.95/0.88 = 2^0.11
_LOW = 40  # bits in which bounds are computed: the radius of a ball has 30


@dataclass(frozen=True)
class TaylorStep:
    """Taylor polynomials of u and w, good for 0 <= t <= ``length`` but for the integrated ``residual``.

    ``radius``, ``largest`` and ``linear``: R, M and lambda of the module's docstring.
    """

    us: tuple[arb, ...]
    ws: tuple[arb, ...]
    length: arb
    unit: arb
    radius: arb
    largest: arb
    linear: int

    @classmethod
    def at(cls, force: Smooth, u: arb, w: arb, unit: arb, scale: arb) -> "TaylorStep":
        """A step from (u, w), w > 0 exact, whose residual is near 2^-precision ``scale``.

        UndecidedError where no disc is found on which w keeps its sign.
        """
        # log2 of the residual that is aimed at: one unit in the last place of the scale of the motion.
        tolerance = size_of(scale) - ctx.prec
        with ctx.workprec(ctx.prec + GUARD):
            # ``ctx.prec`` has the guard bits here; the degree is that of the precision asked for.
            us, ws = coefficients(force, u, w, order_for(ctx.prec - GUARD))
        with ctx.workprec(_LOW):
            radius, largest, length = _longest(force, us, ws, unit, tolerance)
        return cls(tuple(us), tuple(ws), dyadic(length), unit, radius, largest, force.linear)

    def shortened(self, length: arb) -> "TaylorStep":
        """The same polynomials for another time below R."""
        return replace(self, length=length)

    @cached_property
    def residual(self) -> arb:
        """The integral of the residual at h = ``length`` < R = ``radius``."""
        # The integral of the residual over 0 <= t <= h, in the distance of the flow: the two terms of the module's
        # docstring, with 1/(1 - t/R) <= 1/(1 - h/R).  h < R by the choice of the length.
        with ctx.workprec(_LOW):
            h, n = self.length, len(self.ws) - 1
            share = h / self.radius
            cut = (self.unit * abs(self.ws[-1]) + self.linear * abs(self.us[-1])) * h ** (n + 1)
            return upper((cut + self.largest * share**n * h / (1 - share)) / (n + 1))

    @cached_property
    def box(self) -> tuple[arb, arb]:
        """Balls with all places and speeds of the polynomials; U falls.  UndecidedError where w may vanish."""
        with ctx.workprec(_LOW):
            h, n = self.length, len(self.ws) - 1
            w = arb(self.ws[0].mid(), upper(sizes(self.ws)(h) + self.ws[0].rad()))
            # U' = -W + w_n t^n: where W exceeds the last term U falls throughout, so that its ends enclose it.  The box
            # of the true motion is made wider by its distance, in ``error_propagation.growth``.
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


def order_for(bits: int) -> int:
    """The degree at which full precision is reached near e^-1.65 of the radius."""
    # 2^-bits = (h/R)^n at n = 0.42 bits makes h/R = 2^(-1/0.42) = e^-1.65; six terms more for the bits of a first look.
    return int(DEGREE_PER_BIT * bits) + 6


def coefficients(force: Smooth, u: arb, w: arb, order: int) -> tuple[list[arb], list[arb]]:
    """Taylor coefficients of u and w about a state with w > 0, through t^order; at u = 0 on the side u < 0."""
    # Two recurrences: products of whole powers go through w = 0, the logarithmic derivative divides by w_0.
    if force.entire:
        return _of_whole_powers(force, u, w, order)
    return _by_halves(force, u, w, order, order) if force.linear else _of_real_powers(force, u, w, order)


def _of_whole_powers(force: Smooth, u: arb, w: arb, order: int) -> tuple[list[arb], list[arb]]:
    """w^alpha by products: the speed may vanish."""
    # The mass moves towards smaller u: from u = 0 on it is on the side u < 0.
    side, none = 1 if u > 0 else -1, arb(0)
    springs = force.restoring_powers(side)
    losses = [(d, m, _whole(a)) for d, m, a in force.loss_powers(side)]
    curve = ComposedSeries(ExponentLine(()), force.rate, {n for _, n in springs} | {m for _, m, _ in losses}, u)
    speed = ComposedSeries(ExponentLine(()), None, {a for _, _, a in losses}, w)
    for k in range(order):
        slope = curve.restoring(springs)
        for d, m, a in losses:
            slope += d * (sum(map(mul, curve.power[m], reversed(speed.power[a])), none) if m else speed.power[a][-1])
        curve.append(-speed.u[k] / (k + 1))
        speed.append(slope / (k + 1))
    return curve.u, speed.u


def _whole(exponent: arb) -> int:
    """The exponent of a force that says it is ``entire``."""
    found = exponent.unique_fmpz()
    if found is None or found < 0:
        raise ArithmeticError(f"w^{exponent.str(5)} is not entire: no step may go through w = 0")
    return int(found)


def _by_halves(force: Smooth, u: arb, w: arb, order: int, whole: int) -> tuple[list[arb], list[arb]]:
    """The second half of the coefficients from the first, where F depends on w alone: one step of Newton's method.

    With W_0 of degree n the coefficients of F(W) = F(W_0) + F'(W_0) (W - W_0) + ... are those of the first two terms
    through t^(2n+1), as (W - W_0)^2 begins with t^(2n+2).  ``whole``: how many coefficients the step will have.
    """
    if order <= _LEAST:
        return _of_real_powers(force, u, w, order)
    half = (order + 1) // 2
    us, ws = _by_halves(force, u, w, half, whole)
    # The second half needs fewer bits, and so does all that it is made of.
    with ctx.workprec(_bits_for(half, whole, ctx.prec)):
        rounded = [c + 0 for c in ws]
        _append(us, ws, *_linearized(force.loss_powers(1 if u > 0 else -1), rounded, order))
    return us, ws


def _linearized(losses: list[tuple[arb, int, arb]], ws: list[arb], order: int) -> tuple[list[arb], list[arb]]:
    """The coefficients of F(W_0) from the degree of W_0 up to t^(order-1), and as many of F'(W_0)."""
    half = len(ws) - 1
    with ctx.workcap(order):
        ln_w = arb_series(ws, order).log()
        powers = [(a, d * (a * ln_w).exp()) for d, _, a in losses]
        F = sum((power for _, power in powers), arb_series([]))
        known = [F[k] for k in range(half, order)]
    with ctx.workcap(order - half):
        slopes = sum((a * power for a, power in powers), arb_series([])) / arb_series(ws)
        return known, [slopes[k] for k in range(order - half)]


def _append(us: list[arb], ws: list[arb], known: list[arb], rates: list[arb]) -> None:
    """As many coefficients as ``known`` has: U' = -W and W' = U + F(W_0) + F'(W_0) (W - W_0)."""
    first, count, turned = len(ws) - 1, len(known), rates[::-1]
    for start in range(0, count, _BLOCK):
        rest: list[arb] = []  # of W - W_0, which begins with t^(first+1)
        for k in range(start, min(start + _BLOCK, count)):
            slope = sum(map(mul, rest, turned[count - len(rest) :]), us[-1] + known[k])
            us.append(-ws[-1] / (first + k + 1))
            ws.append(slope / (first + k + 1))
            rest.append(ws[-1])
        if start + _BLOCK < count:
            # What the block adds to all later slopes.
            more = arb_poly(rest) * arb_poly(rates[: count - start])
            for k in range(start + _BLOCK, count):
                known[k] += more[k - start - 1]


def _of_real_powers(force: Smooth, u: arb, w: arb, order: int) -> tuple[list[arb], list[arb]]:
    """w^alpha by its logarithmic derivative."""
    side, none, full = 1 if u > 0 else -1, arb(0), ctx.prec
    springs, losses, ln_w, inverse = force.restoring_powers(side), force.loss_powers(side), w.log(), 1 / w
    curve = ComposedSeries(ExponentLine(()), force.rate, {n for _, n in springs} | {m for _, m, _ in losses if m}, u)
    ws, powers = [w], [[d * (a * ln_w).exp()] for d, _, a in losses]
    rest: list[arb] = []  # of w, from t on
    ratio: list[arb] = []  # of l = w'/w
    placed = [GrowingProduct(curve.power[m], p, order) for (_, m, _), p in zip(losses, powers) if m]
    alone = [p for (_, m, _), p in zip(losses, powers) if not m]
    moved = GrowingProduct(rest, ratio, order)
    growing = [(a, p, GrowingProduct(ratio, p, order)) for (_, _, a), p in zip(losses, powers)]
    block = block_for(order)
    for start in range(0, order, block):
        with ctx.workprec(_bits_for(start, order, full)):
            for k in range(start, min(start + block, order)):
                slope = curve.restoring(springs)
                for p in alone:
                    slope += p[-1]
                for product in placed:
                    slope += product.last()
                curve.append(-ws[k] / (k + 1))
                ws.append(slope / (k + 1))
                # w l = w' solved for the k-th coefficient of l, and then (k+1) p_(k+1) = alpha sum l_j p_(k-j), from p'
                # = alpha l p.
                ratio.append((slope - (moved.last() if k else none)) * inverse)
                rest.append(ws[-1])
                for a, p, product in growing:
                    p.append(a * product.last() / (k + 1))
    return curve.u, ws


def _bits_for(k: int, order: int, full: int) -> int:
    """Bits in which the coefficients from the k-th on are computed: those of the last one need ``GUARD`` only."""
    # On a step |c_k| h^k falls about evenly, from the scale to 2^-bits of it at the order.  A choice: what is rounded
    # off is in the radii, and those in the state at the end of the step.
    return max(GUARD, full - max(0, full - GUARD) * k // order)


def _longest(force: Smooth, us: list[arb], ws: list[arb], unit: arb, tolerance: float) -> tuple[arb, arb, float]:
    """R, M and log2 of the time for which the residual is near 2^tolerance, where it is longest: chosen in doubles."""
    n, best = len(ws) - 1, None
    # The three terms of the residual, each made to be 2^tolerance: the last coefficients give ``cut``, M (h/R)^n the
    # third time below.
    parts = [size_of(unit) + size_of(ws[-1]), size_of(us[-1]) if force.linear else -inf]
    cut = min((tolerance - size) / (n + 1) for size in parts)
    least = size_of(ws[1] - us[0] if force.linear else ws[1])  # no M is smaller than |F(u_0, w_0)|
    for radius, largest in discs(force, us, ws):
        edge = size_of(radius)
        # h <= 2^-0.2 R = 0.87 R keeps 1/(1 - h/R) below 8, which the residual counts exactly.
        length = min(edge - 0.2, cut, (tolerance - size_of(largest)) / n + edge)
        # Smaller discs have smaller M and shorter steps in the end: after the first that is no better the search stops.
        # It also stops where the next disc could not be better even with the least possible M.
        if best is not None and length <= best[2]:
            break
        best = (radius, largest, length)
        if (tolerance - least) / n + edge - _NEXT <= length:
            break
    if best is None:
        raise UndecidedError("the Taylor coefficients of a step are too wide")
    return best


def discs(force: Smooth, us: list[arb], ws: list[arb]) -> Iterator[tuple[arb, arb]]:
    """(R, M) for some R, descending, on which W keeps its sign certainly."""
    w, moving_u, moving_w = ws[0], None if force.linear else sizes(us), sizes(ws)
    # Where the speed may vanish its size at the start says nothing; then the place is the scale.
    start = max(size_of(us[0]), size_of(w)) if force.entire else size_of(w)
    steepest = [(start - size_of(c)) / k for k, c in enumerate(moving_w.coeffs()) if c != 0]
    # log2 of the radius at which the first term |w_k| t^k reaches the scale.
    widest = min(steepest, default=0.0)
    for share in _SHARES:
        radius = dyadic(widest) * arb(share)
        moved = upper(moving_w(radius))
        # On the disc |W - w_0| <= moved < w_0, the hypothesis of ``largest``; whole powers are entire and need none.
        if force.entire or moved < w:
            du = arb(0) if moving_u is None else upper(moving_u(radius))
            yield radius, force.largest(us[0], du, w, moved)


def sizes(series: "list[arb] | tuple[arb, ...]") -> arb_poly:
    """The polynomial sum_(k>=1) |c_k| t^k, by which a series moves at most."""
    # For every complex |t| <= R the series moves by at most this polynomial at R, the hypothesis of Cauchy's
    # inequality.
    return arb_poly([arb(0), *(abs(c).upper() for c in series[1:])])
