"""Creep for all times: the slow curve of the least exponent alpha < 1, between two barriers.

The slow curve is a slow manifold, and the barriers are fences: a lower and an upper solution (Walter 1998, section 9).

The slow curve is a divergent sum of powers of w (``slow_curve_series``).  Cut off below w^E, and theta w^E more in
B, it is a curve that the motion crosses in one direction only as long as w is small: downwards in y for theta = -h,
upwards for theta = h.  In between the motion is caught, and the time on either curve is a sum of powers of
w, so the state is known at any later time, however late, where steps in time would have to be ever shorter (derivation
``slow-curve``).

>>> from fractions import Fraction
>>> from asymptotics.numbers.exact import ExactReal
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
from math import log2
from typing import Protocol

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import size_of, upper
from asymptotics.flow.damping import Damping
from asymptotics.flow.slow_manifold.slow_curve_series import Power, Truncated, summed, truncated
from asymptotics.numbers.context import ctx

# Ten bits of the height may be lost to the strip.  A smaller factor waits longer before a creep is caught, a larger one
# loses more digits; what is lost is in the enclosure.
WIDEST = 2**10  # how much wider a strip may be than what the error of the state means for its height
# One per cent: the state itself must lie where the barriers are checked, with its error.
INSIDE = arb(101) / 100  # the barriers are checked up to this multiple of w: the curves start beside the state
# Newton steps for one root; from a guess that is right to a bit seven lead to 100 bits, and the rest is for poor
# guesses.
_NEWTON, _LN2 = 60, 0.6931471805599453
# Orders that are tried, each about 4/3 of the last: the series diverges, so the first that is short enough is taken,
# and the search ends where its terms grow.
ORDERS = (1, 2, 3, 4, 6, 8, 11, 15, 20, 27, 36, 48, 64, 85, 110, 140)


@dataclass(frozen=True)
class SlowCurve:
    """y = N(w) - epsilon w^alpha B, with B and the relative terms R of the other laws as sums of powers of w.

    Functions of ln w, at the current precision.
    """

    epsilon: arb
    alpha: arb
    others: tuple[Power, ...]
    b: tuple[Power, ...]

    @property
    def a(self) -> list[Power]:
        """A without its first term alpha."""
        return [((self.alpha + d) * r, d) for r, d in self.others] + [(-(self.alpha + e) * b, e) for b, e in self.b]

    def place(self, log_w: arb) -> tuple[arb, arb]:
        """y and dy/d ln w."""
        size = self.epsilon * (self.alpha * log_w).exp()
        return (
            size * (1 + summed(self.others, log_w) - summed(self.b, log_w)),
            size * (self.alpha + summed(self.a, log_w)),
        )

    def clock(self, log_w: arb) -> tuple[arb, arb]:
        """The antiderivative of dy/w, and its derivative by ln w: it falls by the time that passes."""
        whole = sum((a * _grown(self.alpha - 1 + e, log_w) for a, e in [(self.alpha, arb(0)), *self.a]), arb(0))
        return self.epsilon * whole, self.epsilon * ((self.alpha - 1) * log_w).exp() * (
            self.alpha + summed(self.a, log_w)
        )


def _grown(d: arb, log_w: arb) -> arb:
    """An antiderivative of w^(d-1): w^d/d, or, where d may be 0, (w^d - 1)/d: ln w times a mean of 1 and w^d, which the
    ball of w^d holds."""
    # Where the ball of d holds 0, neither formula is safe; (w^d - 1)/d is ln w times w^(s d) for some 0 <= s <= 1 (mean
    # value theorem).
    power = (d * log_w).exp()
    return log_w * power if d.contains(0) else power / d


class Barrier(Protocol):
    """What a strip asks of the two curves beside it, as functions of ln w, with their derivatives."""

    def place(self, log_w: arb) -> tuple[arb, arb]:
        """The place y on the curve, and dy/d ln w."""

    def clock(self, log_w: arb) -> tuple[arb, arb]:
        """An antiderivative of dy/w along the curve, by whose decrease time passes, and its derivative by ln w."""


@dataclass(frozen=True)
class FencedStrip:
    """Between the curves ``above`` (theta = -h) and ``below`` (theta = h), the last power of each; ``starts``: ln w on
    either curve at the greatest and the least height y of the state that entered; ``most``: ln w up to which the
    curves were checked, where y and the clock increase with w.

    At one height ln w differs by at most ``share`` w^``power`` (11/10) from one curve to the other: 2 h / min A, and E.
    """

    above: Barrier
    below: Barrier
    starts: tuple[arb, arb]
    most: arb
    share: arb
    power: arb

    def state(self, elapsed: arb) -> tuple[arb, arb]:
        """Enclosures of (y, w) at the exact time ``elapsed`` after the entrance: the lower w the slower the motion, so
        y is at most what it is on the curve above, and at least what it is on the curve below."""
        # Comparison of the two curves (differential inequality): between them y falls no slower than on the upper and
        # no faster than on the lower one.
        slow, fast = (_after(curve, log_w, elapsed) for curve, log_w in zip((self.above, self.below), self.starts))
        # Within the range of w where the barriers were verified; otherwise the motion might cross them.
        if not (self.holds(slow) and self.holds(fast)):
            raise UndecidedError("the time on the slow curve was not found below the place where it begins")
        y = self.above.place(slow)[0].union(self.below.place(fast)[0])
        return y, self._speed(slow).union(self._speed(fast))

    def holds(self, log_w: arb) -> bool:
        """Whether the barriers are checked there."""
        return bool(log_w < self.most)

    def _speed(self, log_w: arb) -> arb:
        """All speeds in the strip at the height of one of its curves at ``log_w``: d ln w/d theta = w^E/A."""
        # theta goes from -h to h and d ln w/d theta = w^E/A; w^E inside the strip exceeds its value here by less than
        # 11/10, which the next line verifies.
        blur = upper(self.share * (self.power * log_w).exp() * arb(11) / 10)
        if not (self.power * blur).exp() < arb(11) / 10:
            raise UndecidedError("the strip about the slow curve is too wide")
        return (log_w + arb(0, blur)).exp()


def _after(curve: Barrier, start: arb, elapsed: arb) -> arb:
    """ln w on the curve at the time ``elapsed`` after ln w = start; with a = dy/d ln w over y the clock is about
    -w^(a-1) times a factor."""
    now, slope = curve.clock(start)
    y, step = curve.place(start)
    steep = 1 - (step / y).mid()
    shrunk = 1 + elapsed * steep / slope
    guess = shrunk.log() / steep if steep != 0 and shrunk > 0 else elapsed / slope
    return solve(curve.clock, now - elapsed, start - guess)


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
    # Interval Newton: if m - f(m)/f'(box) lies in the interior of the box, every function of the family has exactly one
    # zero there, in that interval.  Boxes 4 to 4^7 times the last step.
    for widening in range(1, 8):
        box = log_w + arb(0, 4**widening * upper(step))
        found = log_w - (function(log_w)[0] - value) / function(box)[1]
        if box.contains_interior(found):
            return found
    raise UndecidedError("the place on the slow curve is undecided: raise the precision")


def caught(damping: Damping, y: arb, w: arb, error: arb) -> FencedStrip | None:
    """The strip that holds all states within ``error`` of the exact (y, w) from now on, or None where none is narrow
    enough."""
    if not damping.sublinear or not w > 2 * error:
        return None
    leading = damping.leading
    a, size, place, speed = damping.exponents[leading], damping.resistance(w), y + arb(0, error), w + arb(0, error)
    most = (INSIDE * speed).upper().log()
    # What the error of the state and the last bit of y mean for B: dy over epsilon w^alpha, with dN = alpha N dw/w.
    goal = upper((error * (1 + a * size / w) + abs(y) * arb(2) ** -ctx.prec) / size)
    series = short_enough(damping, leading, most, goal)
    if series is None:
        return None
    # theta of the state: what its N - y has beyond B, over w^E, in balls for all states within the error.
    E, log_w = series.cut, speed.log()
    lacking = (damping.resistance(speed) - place) / (series.epsilon * (a * log_w).exp()) - summed(series.b, log_w)
    theta = lacking * (-E * log_w).exp()
    # Twice the state's own theta, so that it lies well inside, and more than what is neglected needs: the drift alpha h
    # w^E has to exceed it, which ``one_way`` verifies.
    h = 2 * upper(theta) + 4 * upper(summed(series.neglected, most) * (-E * most).exp() / a)
    # A choice (how many digits the strip may cost), and the theorem's hypothesis.
    if not h * (E * most).exp() < WIDEST * goal or not one_way(series, h, most):
        return None
    above, below = (SlowCurve(series.epsilon, a, series.others, (*series.b, (sign * h, E))) for sign in (-1, 1))
    try:
        # The state lies between the curves, so it is no higher than the upper one at y + error and no lower than the
        # lower one at y - error.
        starts = solve(above.place, y + error, w.log()), solve(below.place, y - error, w.log())
    except UndecidedError:  # too few bits here: a later state may do
        return None
    return (
        FencedStrip(above, below, starts, most, upper(4 * h / a), E) if all(start < most for start in starts) else None
    )


def short_enough(damping: Damping, leading: int, most: arb, goal: arb) -> Truncated | None:
    """The shortest series that neglects less than the goal for ln w <= most; None where its terms grow before."""
    # Cheap, and nearly always the answer before a creep has slowed down: no series is formed then.
    if too_early(damping.strengths[leading], damping.exponents[leading], most):
        return None
    before = arb(1)
    for order in ORDERS:
        series = truncated(damping, leading, order)
        if series is None or not (left := upper(summed(series.neglected, most))) <= before:
            return None
        # A quarter of the drift of h = goal: with the factor 4 in h the barriers have room.
        if left < goal * series.alpha / 4:
            return series
        before = left
    return None


def too_early(epsilon: arb, alpha: arb, most: arb) -> bool:
    """Whether the second term of B would not be below half the first: no series is short, a choice."""
    # log2 of the ratio of the second term of B to the first, c_2/c_1 s with s = w^(2-2 alpha)/epsilon^2 and c_2/c_1 =
    # (2 - alpha)/alpha^2, against 1/2.
    a = float(alpha.mid())
    return 2 * (1 - a) * float(most) / _LN2 - 2 * size_of(epsilon) + log2(max(abs(2 - a), 1e-9) / a**2) > -1


def one_way(series: Truncated, h: arb, most: arb) -> bool:
    """Whether for all ln w <= most the motion crosses the curves of theta = +-h as their drift +-alpha h w^E in A B
    says, and A > alpha/2: y and w fall together on them."""
    # A B - w^(2-2 alpha)/epsilon^2 on a curve of theta = +-h is +-alpha h w^E and the rest, in absolute values: the
    # neglected powers, and h w^E times A - alpha, B and itself.  If the rest is smaller at the largest w it is so at
    # all lower ones, as its powers are no less than E (derivation ``slow-curve``).
    a, E, drift = series.alpha, series.cut, h * (series.cut * most).exp()
    others = summed([((a + d) * r, d) for r, d in series.others], most)
    own = summed([(abs((a + e) * b), e) for b, e in series.b], most)
    plain = summed([(abs(b), e) for b, e in series.b], most)
    residual = summed(series.neglected, most) + drift * (others + own + abs(a + E) * (plain + drift))
    # The second part: A > alpha/2 > 0, so that y rises with w on either curve (the terms of the other laws in A are
    # above 0).
    return bool(residual < a * drift) and bool(own + abs(a + E) * drift < a / 2)
