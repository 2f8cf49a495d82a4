"""One half-swing after the other, any law, any number of digits: the sign of the velocity is fixed on each.

A naive |x'| in the equation of motion is silently wrong for any high-order integrator: the right-hand side is not
smooth at x' = 0.  Here a half-swing is y' = -w, w' = y - N(w) with w > 0 (``local_expansion``), in pieces:

* next to a turning point by the local expansion in powers w^2 and w^alpha_i, which contains the branch point, so that
  the turning point is found to full precision: it is the parameter of the expansion through the last point reached;
* in between by Taylor steps in tau, with p = w^alpha from w p' = alpha w' p, that is
  p_k = (1/(k w_0)) sum_(j=1..k) ((alpha + 1) j - k) w_j p_(k-j).

*When no turning point follows.*  Dry friction: the mass sticks where |X| <= friction.  While y > 0 the orbit cannot
turn, and it can never reach y = 0 once it is inside a trap, a region w <= c(y) that it cannot leave
(derivation ``creep``):

    one alpha < 1:  (w/c)^alpha <= y/epsilon with c^alpha = 2/(2 - alpha), while c^2 y^(2/alpha-2) < alpha^2/(2-alpha)
                    epsilon^(2/alpha);          alpha = 1, epsilon >= 2:  w <= y (epsilon + sqrt(epsilon^2 - 4))/2.

More terms only slow the motion down, so a trap of one term is a trap of the sum.

Heuristic arithmetic (midpoints of balls): the independent second route of the tests.

>>> from fractions import Fraction
>>> from flint import ctx
>>> from asymptotics.numbers.exact import ExactReal
>>> quadratic = Damping.of([(arb(1), ExactReal(Fraction(2)))])
>>> with ctx.workprec(100):
...     turn = next(p for p in orbit(quadratic, arb(1), arb(0)) if p.turning is not None)
>>> turn.turning.str(20, radius=False), turn.end.str(20, radius=False)
('-0.41071968606103944670', '3.3809710603589252128')
"""

from collections.abc import Iterator
from dataclasses import dataclass
from math import exp, log
from operator import mul

from flint import arb, ctx

from asymptotics.errors import LimitError
from tests.second_route.local_expansion import Damping, LocalExpansion

MAX_PIECES = 8_000
STICKS, CREEPS, OVERDAMPED = "sticks", "creeps", "overdamped"


@dataclass(frozen=True)
class Piece:
    """The motion for start <= tau <= end: X = sign (y + friction), X' = -sign w.

    ``turning``: X where the piece ends in a turning point, else None; ``trapped``: why no turning point can follow.
    ``expansion`` with ``w_end`` (next to the turning point at the time ``base``), or Taylor coefficients ``y``, ``w``.
    """

    damping: Damping
    sign: int
    start: arb
    end: arb | None
    base: arb
    y: tuple[arb, ...] = ()
    w: tuple[arb, ...] = ()
    expansion: LocalExpansion | None = None
    w_end: arb | None = None
    turning: arb | None = None
    trapped: str | None = None

    def at(self, tau: arb) -> tuple[arb, arb]:
        """(X, X') at a time inside the piece."""
        if self.expansion is not None and self.w_end is not None:
            y, w = self.expansion.at_time(self.damping, (tau - self.base).mid(), self.w_end)
        else:
            h = (tau - self.base).mid()
            y, w = _horner(self.y, h), _horner(self.w, h)
        return self.sign * (y + self.damping.friction), -self.sign * w


def orbit(damping: Damping, X: arb, V: arb, *, static: arb | None = None, pieces: int = MAX_PIECES) -> Iterator[Piece]:
    """The pieces of the motion from (X, V) at tau = 0, without end or until the mass sticks.

    ``static``: where the mass sticks (|X| <= static, at least the friction, which is the default).
    LimitError after ``pieces`` pieces since the last turning point (a stiff motion: strong damping or long creep).
    """
    hold = damping.friction if static is None else static
    tau = arb(0)
    if V == 0:
        if abs(X) <= hold:
            yield _rest(damping, X, tau)
            return
        sign, y, w = (1 if X > 0 else -1), abs(X) - damping.friction, arb(0)
    else:
        sign = -1 if V > 0 else 1
        y, w = (sign * X - damping.friction).mid(), abs(V)
    while True:
        last = None
        for last in _half_swing(damping, sign, tau, y.mid(), w, pieces):
            yield last
        if last is None or last.turning is None or last.end is None:
            return
        X, tau, sign, w = last.turning, last.end, -sign, arb(0)
        if sign * X <= hold:
            yield _rest(damping, X, tau)
            return
        y = sign * X - damping.friction


def _rest(damping: Damping, X: arb, tau: arb) -> Piece:
    """The mass at rest at X for all later time."""
    y = (X - damping.friction).mid()
    return Piece(damping, 1, tau, None, tau, (y,), (arb(0),), trapped=STICKS)


def _half_swing(damping: Damping, sign: int, tau: arb, y: arb, w: arb, limit: int) -> Iterator[Piece]:
    """The pieces up to and including the one that ends in a turning point."""
    if w == 0:
        w = _speed_within(damping, y)
        start = LocalExpansion.at(damping, y, w)
        y, duration = start.evaluate(w)
        end = (tau + duration).mid()
        yield Piece(damping, sign, tau, end, tau, expansion=start, w_end=w, trapped=trap(damping, y, w))
        tau = end
    for _ in range(limit):
        if y < 0 and damping.radius(y, w) > damping.lattice.reach:
            stop = LocalExpansion.through(damping, y, w)
            rest = stop.evaluate(w)[1]
            turn = (tau - rest).mid()
            X = (sign * (stop.y0 + damping.friction)).mid()
            yield Piece(damping, sign, tau, turn, turn, expansion=stop, w_end=w, turning=X)
            return
        ys, ws = taylor(damping, y, w)
        h = _step(ys, ws)
        end = (tau + h).mid()
        yield Piece(damping, sign, tau, end, tau, tuple(ys), tuple(ws), trapped=trap(damping, y, w))
        y, w, tau = _horner(ys, h), _horner(ws, h), end
    reason = f"one half-swing takes more than {limit} Taylor steps: the motion is too stiff or too long"
    raise LimitError("time", reason, "weaker damping or a shorter time")


def trap(damping: Damping, y: arb, w: arb) -> str | None:
    """Why y = 0 can never be reached from here, or None if nothing says so (module docstring)."""
    if not y > 0:
        return None
    for epsilon, alpha in zip(damping.strengths, damping.alphas):
        if alpha.is_rational and alpha.rational == 1 and not epsilon < 2:
            if w <= y * (epsilon + (epsilon**2 - 4).mid().sqrt()) / 2:
                return OVERDAMPED
        elif alpha < 1 and _slow(epsilon, alpha.ball(), y, w):
            return CREEPS
    return None


def _slow(epsilon: arb, a: arb, y: arb, w: arb) -> bool:
    c = (2 / (2 - a)) ** (1 / a)
    inside = w**a <= c**a * y / epsilon
    slow = c**2 * y ** (2 / a - 2) < a**2 / (2 - a) * epsilon ** (2 / a)
    return bool(inside) and bool(slow)


def taylor(damping: Damping, y: arb, w: arb) -> tuple[list[arb], list[arb]]:
    """Taylor coefficients of y and w about a point with w > 0; as many as give full precision at e^-2 of the radius."""
    order = int(0.36 * ctx.prec) + 6
    ys, ws, weighted = [y.mid()], [w.mid()], [arb(0)]
    exponents = [a.ball() for a in damping.alphas]
    powers = [[(w.log() * a).exp().mid()] for a in exponents]
    inverse = 1 / w
    for k in range(order):
        force = sum((e * p[k] for e, p in zip(damping.strengths, powers)), arb(0))
        ys.append((-ws[k] / (k + 1)).mid())
        ws.append(((ys[k] - force) / (k + 1)).mid())
        weighted.append(ws[k + 1] * (k + 1))
        for a, p in zip(exponents, powers):
            plain = sum(map(mul, ws[1:], reversed(p)), arb(0))
            scaled = sum(map(mul, weighted[1:], reversed(p)), arb(0))
            p.append((((a + 1) * scaled - (k + 1) * plain) * inverse / (k + 1)).mid())
    return ys, ws


def _step(ys: list[arb], ws: list[arb]) -> arb:
    """The step at which the last coefficients fall below the precision, relative to y and to w each."""
    found = []
    for c in (ys, ws):
        size = _magnitude(c[0]) if _magnitude(c[0]) is not None else _magnitude(c[1])
        for k in (len(c) - 1, len(c) - 2, len(c) - 3):
            last = _magnitude(c[k])
            if last is not None and size is not None:
                found.append((size - last - (ctx.prec + 2) * log(2)) / k)
    h = arb(exp(max(-700.0, min(found)))) if found and min(found) < 0 else arb(1)
    while not _horner(ws, h) > 0:  # an analytic law (integer alpha) would continue beyond the turning point
        h = h / 2
    return h


def _magnitude(x: arb) -> float | None:
    mantissa, exponent = x.mid().man_exp()
    return log(abs(int(mantissa))) + int(exponent) * log(2) if mantissa != 0 else None


def _horner(coefficients: tuple[arb, ...] | list[arb], h: arb) -> arb:
    total = arb(0)
    for c in reversed(coefficients):
        total = total * h + c
    return total.mid()


def _speed_within(damping: Damping, y: arb) -> arb:
    """A speed for which the expansion at y > 0 has the reach asked for, as large as simple halving finds it."""
    w = abs(y).mid()
    excess = damping.radius(y, w) - damping.lattice.reach
    return (w * arb(excess).exp()).mid() if excess < 0 else w
