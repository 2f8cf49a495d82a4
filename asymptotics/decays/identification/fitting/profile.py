"""Profile-likelihood intervals for any function of the parameters.

That twice the fall of the log-likelihood has chi-squared's distribution is Wilks's theorem (1938); the ends are those
of MINOS, to which the tests compare them.

With S the weighted sum of squares, the 95 % interval of g(theta) is where  S_prof(v) - S_min <= t^2,  S_prof(v) being
the minimum of S at fixed g = v and t the quantile of Student's distribution (of the normal one when the noise is
known).  The minimum at fixed g is found by adding one residual (g - v)/w, small w: its minimiser minimises S at its own
value of g, whatever w is, so every point lies exactly on the profile.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from scipy.special import ndtri, stdtrit

from asymptotics.decays.identification.fitting.least_squares import Fit, minimise, predicted_at
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.present.shown import Page, Shown

Function = Callable[[Array], tuple[float, Array]]
_STEPS, _CLOSE = 12, 5e-3
"""Points of the profile for one end, and how near its height must be to t: half a percent of an interval's length."""


@dataclass(frozen=True)
class Interval(Shown):
    """An estimate with its interval; an end is None where the data set no limit.

    >>> Interval(0.5, 1.0, None).contains(3.0), Interval(0.5, 1.0, 2.0).widened(0.5, 0.5)
    (True, Interval(low=0.0, estimate=1.0, high=2.5))
    """

    low: float | None
    estimate: float
    high: float | None

    def __repr__(self) -> str:
        return f"Interval(low={self.low!r}, estimate={self.estimate!r}, high={self.high!r})"

    def _page(self) -> Page:
        ends = ("no limit" if v is None else f"{v:.6g}" for v in (self.low, self.high))
        return Page(f"{self.estimate:.6g}", ("estimate, in doubles",), ("at least", "at most"), (tuple(ends),))

    def _formula(self) -> str:
        low, high = ("-" if v is None else f"{v:.6g}" for v in (self.low, self.high))
        return rf"{self.estimate:.6g}\ \text{{in}}\ [{low},\, {high}]"

    def contains(self, value: float) -> bool:
        """Whether ``value`` lies in the interval."""
        return (self.low is None or self.low <= value) and (self.high is None or value <= self.high)

    def widened(self, below: float, above: float) -> "Interval":
        """The interval with both ends moved outwards."""
        return Interval(
            None if self.low is None else self.low - below,
            self.estimate,
            None if self.high is None else self.high + above,
        )

    def stretched(self, factor: float) -> "Interval":
        """The interval with its two half-lengths multiplied by ``factor``."""
        return Interval(
            None if self.low is None else self.estimate - factor * (self.estimate - self.low),
            self.estimate,
            None if self.high is None else self.estimate + factor * (self.high - self.estimate),
        )

    def to_dict(self) -> dict[str, str | None]:
        """JSON-ready: numbers are strings, a missing end is null."""
        shown = (("low", self.low), ("estimate", self.estimate), ("high", self.high))
        return {name: None if value is None else f"{value:.6g}" for name, value in shown}


def coordinate(index: int, factor: float = 1.0) -> Function:
    """g(theta) = factor theta_index."""

    def g(theta: Array) -> tuple[float, Array]:
        gradient = np.zeros(len(theta))
        gradient[index] = factor
        return float(theta[index]) * factor, gradient

    return g


def quantile(fit: Fit, level: float, kind: str) -> float:
    """How many standard errors reach the two-sided ``level``; ``kind``: the data that determine the quantity."""
    if fit.known:
        return float(ndtri((1 + level) / 2))
    return float(stdtrit(max(fit.freedoms[kind], 1.0), (1 + level) / 2))


def wald_interval(fit: Fit, g: Function, level: float = 0.95, kind: str = "x") -> Interval:
    """The interval from the curvature alone: g plus or minus t standard errors."""
    value, gradient = g(fit.theta)
    reach = quantile(fit, level, kind) * fit.directions.standard_error(gradient)
    return Interval(value - reach, value, value + reach) if np.isfinite(reach) else Interval(None, value, None)


def profile_interval(fit: Fit, g: Function, level: float = 0.95, kind: str = "x") -> Interval:
    """The interval of g by profile likelihood; an end is None if the profile never rises high enough."""
    value, gradient = g(fit.theta)
    error = fit.directions.standard_error(gradient)
    if not (np.isfinite(error) and error > 0):
        return Interval(None, value, None)
    t = quantile(fit, level, kind)
    low, high = (_end(fit, g, value, sign * error, t) for sign in (-1, 1))
    return Interval(low, value, high)


def profile_curve(fit: Fit, g: Function, count: int = 21, reach: float = 3.0) -> tuple[Array, Array]:
    """(values of g, S_prof - S_min) over ``reach`` standard errors on both sides; shorter where the model ends."""
    value, gradient = g(fit.theta)
    error = fit.directions.standard_error(gradient)
    # From the estimate outwards, each point beginning where the last one ended.
    points = [(value, 0.0)]
    for sign in (-1, 1):
        theta = fit.theta
        for step in np.linspace(0, reach, count // 2 + 1)[1:]:
            try:
                theta, at, rise = _minimum_at(fit, g, theta, value + sign * step * error, error)
            except TooStrongError:
                break
            points.append((at, rise))
    points.sort()
    curve = np.array(points)
    return curve[:, 0], curve[:, 1]


def _end(fit: Fit, g: Function, value: float, error: float, t: float) -> float | None:
    """Secant iteration on sqrt(S_prof - S_min) = t, which is nearly linear in v."""
    theta, known, target = fit.theta, [(0.0, value)], value + t * error
    for _ in range(_STEPS):
        try:
            theta, at, rise = _minimum_at(fit, g, theta, target, abs(error))
        except TooStrongError:
            # The motion ends before the data do at this strength: half-way back to what is known.
            target = (target + known[-1][1]) / 2
            continue
        height = float(np.sqrt(max(rise, 0.0)))
        known.append((height, at))
        if abs(height - t) < _CLOSE * t:
            return at
        # The secant through the two points nearest to the height that is wanted.
        (h0, v0), (h1, v1) = sorted(known, key=lambda point: abs(point[0] - t))[:2]
        slope = (v1 - v0) / (h1 - h0) if h1 != h0 else 0.0
        # The profile falls, or has not risen within a thousand standard errors: the data set no limit on this side.
        if slope * error <= 0 or abs(target - value) > 1e3 * abs(error):
            return None
        lowest, highest = sorted((value, value + 1e4 * error))
        target = min(max(v0 + (t - h0) * slope, lowest), highest)
    # The secants have not met the height: between two points that enclose it, the straight line.
    heights = np.array(known)
    return float(np.interp(t, heights[:, 0], heights[:, 1])) if heights[:, 0].max() >= t else None


def _minimum_at(fit: Fit, g: Function, start: Array, target: float, error: float) -> tuple[Array, float, float]:
    # w is small beside the error, so that g comes near to its target; any w gives a point of the profile.
    width = 0.02 * error

    def penalty(theta: Array) -> tuple[float, Array]:
        value, gradient = g(theta)
        return (value - target) / width, gradient / width

    gradient = g(fit.theta)[1]
    step = fit.covariance @ gradient
    # Along the conditional minimum of the quadratic approximation: where the model is nearly linear, one step does.
    straight = fit.theta + step * (target - g(fit.theta)[0]) / max(float(gradient @ step), 1e-300)
    try:
        theta, _ = minimise(fit.model, straight, fit.scales, penalty)
    except TooStrongError:  # where a straight line leaves the model's domain, the last point of the curve may not
        theta, _ = minimise(fit.model, start, fit.scales, penalty)
    predicted, _ = predicted_at(fit.model, theta)
    r = (fit.model.data - predicted) / fit.model.scale_vector(fit.scales)
    return theta, g(theta)[0], float(r @ r) - fit.chi2
