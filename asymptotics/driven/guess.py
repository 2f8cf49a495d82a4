"""Where the response turns, in doubles: half a period by Runge and Kutta and Newton, or its harmonics.  Proves nothing.

The unit of x is the amplitude of first order, that of a force f.
"""

from collections.abc import Callable
from math import ceil, cos, hypot, inf, isfinite, pi, sin, sqrt

from asymptotics.driven.balance import balanced, turns_of
from asymptotics.driven.drive import Balls
from asymptotics.errors import LimitError
from asymptotics.running.budget import tick

_STEPS, _TRIES = 300, 40  # of a half period, and of Newton's method; choices
State = tuple[float, float]


def turning_point(balls: Balls, phase: float) -> State:
    """(theta, x) of the turning point in (-pi, 0]; LimitError where the orbit turns more than once in half a period."""
    mu, k = float(balls.mu.mid()), float(balls.k.mid())
    losses = [(float(c.mid()), float(a.mid())) for c, a in balls.losses]

    def slope(theta: float, x: float, v: float) -> State:
        loss = sum(c * abs(v) ** a for c, a in losses)
        return v, (cos(theta) - k * x - (loss if v > 0 else -loss if v < 0 else 0.0)) / mu

    # How many steps: by the fastest rate of the equation; what no double holds is too fast as well.
    rate = max(1.0, sqrt(k / mu), max(c / mu for c, _ in losses)) if mu > 0 else inf
    steps = ceil(_STEPS * min(rate, 1000.0))
    if steps > 100 * _STEPS:
        raise LimitError("omega", "the free motion swings too often in half a period", "a frequency nearer omega_0")
    x, v = _fixed(slope, steps, cos(phase), sin(phase))
    turns, theta, h = [], 0.0, pi / steps
    for _ in range(steps):
        later = _step(slope, theta, x, v, h)
        if v != 0 and (later[1] > 0) != (v > 0):
            turns.append(_at_rest(slope, theta, x, v, h * v / (v - later[1])))
        theta, (x, v) = theta + h, later
    if len(turns) != 1:
        raise _many(len(turns))
    ((theta, x),) = turns
    return theta - pi, -x


def _not_found(perhaps: str = "") -> LimitError:
    reason = f"the response was not found in doubles{perhaps}"
    return LimitError("force", reason, "a weaker loss, or a frequency nearer omega_0")


def _many(turns: int) -> LimitError:
    reason = f"the response turns {turns} times in half a period: one turn is served"
    return LimitError("omega", reason, "a frequency nearer omega_0, or a stronger loss")


def turning_point_of_waves(balls: Balls, phase: float) -> State:
    """The same for losses steep at rest, by the balance of the harmonics; LimitError where it sticks as well."""
    losses = tuple((float(c.mid()), float(a.mid())) for c, a in balls.losses)
    k = float(balls.k.mid())
    waves = balanced(k, float(balls.mu.mid()), losses, (cos(phase), sin(phase)))
    dry = sum(c for c, a in losses if a == 0)
    if waves is None:
        raise _not_found(", or dry friction holds the mass" if dry else "")
    turns = turns_of(waves)
    if len(turns) != 1:
        raise _many(len(turns))
    ((theta, x),) = turns
    if not x > 0 or abs(cos(theta) - k * x) <= dry:
        reason = "dry friction holds the mass where it turns: a response that slides all along is served"
        raise LimitError("force", reason, "a larger force, or less dry friction")
    return theta - pi, -x


Slope = Callable[[float, float, float], State]


def _step(slope: Slope, theta: float, x: float, v: float, h: float) -> State:
    a = slope(theta, x, v)
    b = slope(theta + h / 2, x + h / 2 * a[0], v + h / 2 * a[1])
    c = slope(theta + h / 2, x + h / 2 * b[0], v + h / 2 * b[1])
    d = slope(theta + h, x + h * c[0], v + h * c[1])
    return x + h / 6 * (a[0] + 2 * b[0] + 2 * c[0] + d[0]), v + h / 6 * (a[1] + 2 * b[1] + 2 * c[1] + d[1])


def _at_rest(slope: Slope, theta: float, x: float, v: float, share: float) -> State:
    """(theta, x) after a part of a step, about ``share``, that ends at rest: Newton's method for the speed."""
    for _ in range(2):
        near = _step(slope, theta, x, v, share)
        rate = slope(theta + share, *near)[1]
        share -= near[1] / rate if rate else 0.0
    return theta + share, _step(slope, theta, x, v, share)[0]


def _half(slope: Slope, steps: int, x: float, v: float) -> State:
    """Minus the state after half a period: the response is a fixed point."""
    h = pi / steps
    for i in range(steps):
        x, v = _step(slope, i * h, x, v, h)
    return -x, -v


def _fixed(slope: Slope, steps: int, x: float, v: float) -> State:
    size = hypot(x, v)
    for _ in range(_TRIES):
        tick("the response in doubles")
        X, V = _half(slope, steps, x, v)
        miss = (X - x, V - v)
        if not all(map(isfinite, miss)):
            break
        if hypot(*miss) < 1e-11 * size:
            return x, v
        d = 1e-6 * size
        (a, c), (b, e) = (
            [(p - q) / d for p, q in zip(_half(slope, steps, x + dx, v + dv), (X, V))]
            for dx, dv in ((d, 0.0), (0.0, d))
        )
        a, e = a - 1, e - 1
        det = a * e - b * c
        step = ((-miss[0] * e + miss[1] * b) / det, (-miss[1] * a + miss[0] * c) / det)
        # A long step is no step of Newton's: the map itself leads towards its fixed point.
        far = hypot(*step) > size
        x, v = (X, V) if far else (x + step[0], v + step[1])
        if hypot(*step) < 1e-9 * size:
            return x, v
    raise _not_found()
