"""Strong damping, alpha > 1: far above w = epsilon^(-1/(alpha-1)) a motion slides on its slow curve, between barriers.

The curve is an attracting slow manifold (Fenichel 1979), the barriers are a lower and an upper solution.

One law alone, epsilon w^(alpha-1) large: after a short time y = epsilon w^alpha (1 - B), with the B of derivation
``slow-curve``, whose powers of w are negative here: all of them are largest at the least speed.  With a constant theta
instead of theta w^E the two barriers, theta = -+h, are checked at that speed once and hold from there on upwards (last
lines of the derivation).  The motion is followed between them down to a moderate strength, and by steps from there on.

>>> from fractions import Fraction
>>> from asymptotics.numbers.exact import ExactReal
>>> law = Damping.of([(arb(10) ** 6, ExactReal(Fraction(2)))])
>>> with ctx.workprec(80):
...     strip = strong_damping_strip(law, arb(1), arb("0.001"), arb("1e-8"))
...     strip.length.str(3, radius=False), [value.str(5) for value in strip.state(arb(1000))]
('1.99e+3', ['[0.2500 +/- ...]', '[0.0005000 +/- ...]'])
"""

from dataclasses import dataclass, replace
from math import log, log2

from flint import arb

from asymptotics.errors import UndecidedError
from asymptotics.flow.balls import upper
from asymptotics.flow.damping import Damping
from asymptotics.flow.slow_manifold.slow_curve import WIDEST, FencedStrip, SlowCurve, one_way, short_enough, solve
from asymptotics.flow.slow_manifold.slow_curve_series import Truncated, summed
from asymptotics.numbers.context import ctx

# A slide may end where B = 1/16, as no few terms are near for a larger one, or earlier, up to B = 2^-60, if the
# precision asks for it.
_NEAREST, _FARTHEST = 4, 60  # log2 of 1/B at the end of a slide
# A slide over less than a factor e^(1/2) of the speed is left to Taylor steps.
_LN2, _WORTH = log(2), 0.5  # a slide lets ln w fall by more


@dataclass(frozen=True)
class StrongDampingStrip(FencedStrip):
    """A strip for ln w >= ``most``; ``length``: how long the motion is followed in it."""

    length: arb

    def holds(self, log_w: arb) -> bool:
        """Whether the barriers are checked there."""
        return bool(log_w > self.most)


def strong_damping_strip(damping: Damping, y: arb, w: arb, error: arb) -> StrongDampingStrip | None:
    """The strip that holds all states within ``error`` of the exact (y, w) for a while, or None where none is narrow
    enough, or none is worth it."""
    if len(damping.alphas) != 1 or not damping.alphas[0] > 1 or not (w > 2 * error and y > 2 * error):
        return None
    a, size, log_w = damping.exponents[0], damping.resistance(w), w.log()
    goal = upper((error * (1 + a * size / w) + abs(y) * arb(2) ** -ctx.prec) / size)
    lacking = upper((damping.resistance(w + arb(0, error)) - y - arb(0, error)) / size)
    # N - y is more than an eighth of N: the motion is still on its way to the slow curve.  A choice; the strip is
    # verified below.
    if not lacking < arb(1) / 8:
        return None
    for end in _ends(damping, float(log_w.mid())):
        series = short_enough(damping, 0, end, goal)
        if series is not None:
            # theta constant, E = 0: all powers of B and of what is left are negative, largest at the least w, so that
            # ``one_way`` asks its inequality there (last lines of ``slow-curve``).
            return _between(replace(series, cut=arb(0)), (damping, y, w, error), end, goal)
    return None


def _ends(damping: Damping, start: float) -> list[arb]:
    """Values of ln w where B is about 2^-m, the least first: a choice."""
    (size, alpha), found = damping.sizes[0], []
    steep = float((damping.alphas[0] - 1).ball())
    for m in range(_NEAREST, _FARTHEST):
        # B = w^(2-2 alpha)/(alpha epsilon^2) = 2^-m solved for ln w.
        end = (m - 2 * size - log2(alpha)) * _LN2 / (2 * steep)
        if end < start - _WORTH:
            found.append(arb(end))
    return found


def _between(series: Truncated, state: tuple[Damping, arb, arb, arb], end: arb, goal: arb) -> StrongDampingStrip | None:
    damping, y, w, error = state
    a = series.alpha
    speed, place = w + arb(0, error), y + arb(0, error)
    log_w = speed.log()
    theta = (damping.resistance(speed) - place) / (series.epsilon * (a * log_w).exp()) - summed(series.b, log_w)
    h = 2 * upper(theta) + 4 * upper(summed(series.neglected, end) / a)
    if not h < WIDEST * goal or not one_way(series, h, end):
        return None
    above, below = (SlowCurve(series.epsilon, a, (), (*series.b, (sign * h, arb(0)))) for sign in (-1, 1))
    try:
        starts = solve(above.place, y + error, w.log()), solve(below.place, y - error, w.log())
    except UndecidedError:  # too few bits here: a later state may do
        return None
    # The motion is followed to a little above the place where the barriers end, for the time that the faster of the two
    # curves takes.
    last = (end + arb(1) / 64).mid()
    times = [(curve.clock(at)[0] - curve.clock(last)[0]).lower() for curve, at in zip((above, below), starts)]
    length = times[0].min(times[1]).mid()
    worth = all(at > last for at in starts) and length > 0
    return StrongDampingStrip(above, below, starts, end, upper(4 * h / a), arb(0), length) if worth else None
