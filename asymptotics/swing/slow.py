"""Creep for all times: the slow curve of one exponent alpha < 1, between two barriers.

With s = w^(2-2 alpha)/epsilon^2 the slow curve is y = epsilon w^alpha (1 - sum_k c_k s^k), where

    alpha c_1 = 1,    alpha c_m = sum_(k=1)^(m-1) (alpha + 2(1-alpha)k) c_k c_(m-k),

a divergent series.  With theta in place of c_(n+1) as its last coefficient it is a curve that the motion crosses in one
direction only, as long as s is small: downwards in y for theta = c_(n+1) - h, upwards for c_(n+1) + h.  In between the
motion is caught, and the time on either curve is a sum of powers of w, so the state is known at any later time, however
late, where steps in time would have to be ever shorter (derivation ``slow-curve``).

>>> from fractions import Fraction
>>> law = Damping.of([(arb(1), ExactReal(Fraction(1, 2)))])
>>> with ctx.workprec(80):
...     y = arb("0.01")
...     w = y**2 * (1 + 2 * arb(2) * y**2)
...     strip = caught(law, y, w, arb("1e-9"))
...     strip.state(arb(10) ** 12)[0].str(12)
'[9.99999999900e-13 +/- ...]'
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

from flint import arb, arb_poly, ctx

from asymptotics.errors import UndecidedError
from asymptotics.numbers.exact import ExactReal
from asymptotics.swing.damping import Damping, upper

_WIDEST = 2**10  # how much wider a strip may be than what the error of the state means for its height
_INSIDE = arb(101) / 100  # the barriers are checked up to this multiple of s: the curves start beside the state
_NEWTON = 60


@lru_cache(maxsize=32)
def coefficients(alpha: ExactReal, order: int, bits: int) -> tuple[arb, ...]:
    """c_1, ..., c_order at ``bits`` bits.

    >>> from fractions import Fraction
    >>> [c.str(8) for c in coefficients(ExactReal(Fraction(1, 2)), 4, 60)]
    ['2.0000000', '12.000000', '192.00000', '4560.0000']
    """
    with ctx.workprec(bits):
        a = alpha.ball()
        found = [1 / a]
        for m in range(2, order + 1):
            products = ((a + 2 * (1 - a) * k) * found[k - 1] * found[m - k - 1] for k in range(1, m))
            found.append(sum(products, arb(0)) / a)
    return tuple(found)


@dataclass(frozen=True)
class Curve:
    """y = epsilon w^alpha (1 - B(s)) with B = sum_k b_k s^k, as functions of log_w = ln w, at the current precision."""

    epsilon: arb
    alpha: arb
    b: tuple[arb, ...]

    @property
    def a(self) -> list[arb]:
        """A(s) = d(epsilon w^alpha (1 - B))/dl / (epsilon w^alpha), coefficient by coefficient."""
        return [self.alpha, *(-(self.alpha + 2 * (1 - self.alpha) * k) * b for k, b in enumerate(self.b, start=1))]

    def s(self, log_w: arb) -> arb:
        """s at w = exp(log_w)."""
        return (2 * (1 - self.alpha) * log_w).exp() / self.epsilon**2

    def place(self, log_w: arb) -> tuple[arb, arb]:
        """y and dy/dl."""
        s, size = self.s(log_w), self.epsilon * (self.alpha * log_w).exp()
        return size * (1 - arb_poly([arb(0), *self.b])(s)), size * arb_poly(self.a)(s)

    def clock(self, log_w: arb) -> tuple[arb, arb]:
        """The antiderivative of dy/w, and its derivative by log_w: it falls by the time that passes."""
        s, size = self.s(log_w), self.epsilon * ((self.alpha - 1) * log_w).exp()
        whole = arb_poly([a / (2 * k - 1) for k, a in enumerate(self.a)])
        return size * whole(s) / (1 - self.alpha), size * arb_poly(self.a)(s)


@dataclass(frozen=True)
class Strip:
    """Between the curves ``above`` (theta = c_(n+1) - h) and ``below`` (c_(n+1) + h); ``starts``: ln w on either curve
    at the greatest and the least height y of the state that entered; ``share``: 2 h / min A."""

    above: Curve
    below: Curve
    starts: tuple[arb, arb]
    share: arb

    def state(self, elapsed: arb) -> tuple[arb, arb]:
        """Enclosures of (y, w) at the exact time ``elapsed`` after the entrance: the lower w the slower the motion, so
        y is at most what it is on the curve above, and at least what it is on the curve below."""
        slow, fast = (_after(curve, log_w, elapsed) for curve, log_w in zip((self.above, self.below), self.starts))
        y = self.above.place(slow)[0].union(self.below.place(fast)[0])
        return y, self._speed(slow).union(self._speed(fast))

    def _speed(self, log_w: arb) -> arb:
        """All speeds in the strip at the height of one of its curves at ``log_w``: d ln w/d theta = s^(n+1)/A."""
        order = len(self.above.b)
        blur = upper(self.share * self.above.s(log_w) ** order * arb(11) / 10)
        if not (2 * (1 - self.above.alpha) * order * blur).exp() < arb(11) / 10:
            raise UndecidedError("the strip about the slow curve is too wide")
        return (log_w + arb(0, blur)).exp()


def _after(curve: Curve, start: arb, elapsed: arb) -> arb:
    """ln w on the curve at the time ``elapsed`` after ln w = start; the clock is about -alpha epsilon
    w^(alpha-1)/(1-alpha)."""
    now = curve.clock(start)[0]
    scale = curve.alpha * curve.epsilon / (1 - curve.alpha) * ((curve.alpha - 1) * start).exp()
    return solve(curve.clock, now - elapsed, start - (1 + elapsed / scale).log() / (1 - curve.alpha))


def solve(function: Callable[[arb], tuple[arb, arb]], value: arb, guess: arb) -> arb:
    """The enclosure of log_w with function(log_w) = value, by Newton's method, for a function that increases and gives
    its derivative too."""
    log_w = guess.mid()
    for _ in range(_NEWTON):
        now, slope = function(log_w)
        step = (now - value) / slope
        log_w = (log_w - step).mid()
        if upper(step) <= 2 * step.rad() + upper(log_w) * arb(2) ** (4 - ctx.prec):
            break
    for widening in range(1, 8):
        box = log_w + arb(0, 4**widening * upper(step))
        found = log_w - (function(log_w)[0] - value) / function(box)[1]
        if box.contains_interior(found):
            return found
    raise UndecidedError("the place on the slow curve is undecided: raise the precision")


def caught(damping: Damping, y: arb, w: arb, error: arb) -> Strip | None:
    """The strip that holds all states within ``error`` of the exact (y, w) from now on, or None where none is narrow
    enough."""
    if len(damping.alphas) != 1 or not damping.alphas[0] < 1 or not w > 2 * error:
        return None
    epsilon, a = damping.strengths[0], damping.exponents[0]
    place, speed = y + arb(0, error), w + arb(0, error)
    s = speed ** (2 - 2 * a) / epsilon**2
    most = upper(_INSIDE * s)
    size = damping.resistance(w)
    goal = upper((error * (1 + a * size / w) + abs(y) * arb(2) ** -ctx.prec) / size)
    c = coefficients(damping.alphas[0], 24 + ctx.prec // 3, ctx.prec)
    n = _order(c, most, goal)
    if n is None:
        return None
    theta = (1 - place / damping.resistance(speed) - arb_poly([arb(0), *c[:n]])(s)) / s ** (n + 1)
    h = (2 * upper(theta - c[n])).max(4 * upper(c[n + 1] * most))
    curves = [Curve(epsilon, a, (*c[:n], c[n] + sign * h)) for sign in (-1, 1)]
    if not h * most ** (n + 1) < _WIDEST * goal or not all(one_way(curve, a * h, most) for curve in curves):
        return None
    starts = [solve(curve.place, end, w.log()) for curve, end in zip(curves, (y + error, y - error))]
    if not all(curve.s(log_w) < most for curve, log_w in zip(curves, starts)):
        return None
    return Strip(curves[0], curves[1], (starts[0], starts[1]), upper(4 * h / a))


def _order(c: tuple[arb, ...], s: arb, goal: arb) -> int | None:
    """The least n >= 1 whose first term left out is below the goal; None if the terms grow before."""
    with ctx.workprec(53):
        before, power = c[0] * s, s
        for n in range(1, len(c) - 1):
            power *= s
            term = c[n] * power
            if not term < before:
                return None
            if term < goal:
                return n
            before = term
    return None


def one_way(curve: Curve, drift: arb, s: arb) -> bool:
    """Whether for all s up to this one the motion crosses the curve as its leading drift +-``drift`` says, and
    A > alpha/2: y and w fall together on it."""
    order, A = len(curve.b), curve.a
    product = arb_poly(A) * arb_poly([arb(0), *curve.b])
    rest = sum((abs(product[m]) * s ** (m - order) for m in range(order + 1, 2 * order + 1)), arb(0))
    falls = sum((abs(a) * s**k for k, a in enumerate(A) if k), arb(0))
    return bool(rest < drift) and bool(falls < curve.alpha / 2)
