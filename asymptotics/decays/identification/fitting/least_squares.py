"""The fit of one law to one run: weighted least squares with exact derivatives, noise scales from the residuals.

The method is Levenberg and Marquardt's; the likelihood is concentrated, that is maximised over the scales.

Unknown beside the law: ln of the first amplitude, the offset of the rest position, and (with times) ln omega_0 and the
start of the clock.  Turning points, turning times and passages each have a noise scale of their own.  For a scale
that is not known, the likelihood is maximised over it, so that

    -2 ln(likelihood) = sum over the kinds of data  N_g (1 + ln(2 pi RSS_g/N_g)),

which needs no outside estimate of the noise, and AICc and BIC follow with one parameter more for each scale.
"""

from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from asymptotics.decays.identification.fitting.directions import Directions
from asymptotics.decays.identification.fitting.model import KINDS, Model, Noise
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.swing import MAX_FREE_ALPHA, TOLERANCE
from asymptotics.decays.identification.measuring.criteria import aicc, bic
from asymptotics.numbers.alike import Alike
from asymptotics.numbers.context import cached_property
from asymptotics.running.budget import tick

_ROUNDS, _STEPS = 5, 40
"""How often the scales are found anew, and steps of the minimiser for each.  Choices: a fit that has not ended by then
says so (``converged``), and one that is worse than that of a smaller law begins again from there (``comparison``)."""
_MODEL_SHARE = 3e-3
"""The last degree of a summed series, as a share of the noise: what is neglected is smaller still."""
_HUGE = 1e140
"""Beyond this a prediction is none: its square would leave the doubles."""
_NEARLY = 1e-10
"""Of a large chi-squared, which belongs to a law that is far away: N/2 times this is lost of the log-likelihood."""


@dataclass(frozen=True, eq=False)
class Fit(Alike):
    """The best parameters, with everything that intervals and criteria need."""

    model: Model = field(compare=False)  # ``theta`` and what was fitted tell it
    theta: Array
    residuals: Array
    slopes: Array
    scales: dict[str, float]
    known: bool
    converged: bool

    @property
    def weighted(self) -> Array:
        """Residuals in units of the standard deviations."""
        return self.residuals / self.model.scale_vector(self.scales)

    @property
    def rest(self) -> float:
        """The rest position among the turning points: those of a line through samples are about it already."""
        model = self.model
        return float(self.theta[model.after]) if model.offset and model.seen.samples is None else 0.0

    @property
    def chi2(self) -> float:
        """The weighted sum of squares."""
        return float((self.weighted**2).sum())

    @cached_property
    def freedoms(self) -> dict[str, float]:
        """For each kind of data, their number minus the parameters they determine."""
        # Kinds that were not measured have the freedom of all data together.
        left = _left_over(self.model, self.slopes, self.scales)
        return {**dict.fromkeys(KINDS, float(self.freedom)), **left}

    @cached_property
    def directions(self) -> Directions:
        """The directions of the weighted problem."""
        return Directions.of(self.slopes / self.model.scale_vector(self.scales)[:, None])

    @cached_property
    def covariance(self) -> Array:
        """(J^T J)^(-1) of the weighted problem; very large along directions that the data do not see."""
        return self.directions.covariance

    @property
    def freedom(self) -> int:
        """Data minus parameters."""
        return len(self.residuals) - self.model.absorbed - self.model.size

    @cached_property
    def log_likelihood(self) -> float:
        """ln(likelihood), with the scales at their most likely values if they are not known."""
        total = 0.0
        for kind, group in zip(self.model.kinds, self.model.groups):
            r = self.residuals[group] / self.model.shape[group]
            low = self.model.floor(kind, self.theta)
            # The most likely scale is the mean square (over N, not N - k), but not below what the arithmetic leaves.
            s2 = self.scales[kind] ** 2 if self.known else max(float(np.mean(r**2)), low**2)
            total -= float((r**2).sum()) / (2 * s2) + len(r) / 2 * np.log(2 * np.pi * s2)
        return float(total - np.log(self.model.shape).sum())

    @cached_property
    def aicc(self) -> float:
        """Akaike's criterion with the correction for small samples; infinite when there are too few data."""
        return aicc(-2 * self.log_likelihood, self._counted, len(self.residuals))

    @property
    def bic(self) -> float:
        """Schwarz's criterion."""
        return bic(-2 * self.log_likelihood, self._counted, len(self.residuals))

    @property
    def _counted(self) -> int:
        # Each scale that was found is a parameter too.
        return self.model.absorbed + self.model.size + (0 if self.known else len(self.model.groups))


Penalty = Callable[[Array], tuple[float, Array]]


def fit(model: Model, start: Array, noise: Noise | None = None) -> Fit:
    """The best fit from ``start``; the noise scales are found with it unless all of them are given."""
    given = {k: getattr(noise, k) for k in model.kinds} if noise else {}
    known = bool(given) and all(v is not None for v in given.values())
    # A beginning, forgotten after the first round: its ratio only weighs positions against times once.
    scales = dict(given) if known else {k: 1e-2 * model.seen.reference if k == "x" else 0.1 for k in model.kinds}
    theta, converged = start, False
    for _ in range(1 if known else _ROUNDS):
        if not model.swing.coarse:
            # A series that is exact beyond the noise wastes time; 3e-4 keeps the model smooth for the minimiser however
            # loud the noise is.
            model.swing.tolerance = float(np.clip(_MODEL_SHARE * scales["x"] / model.seen.reference, TOLERANCE, 3e-4))
        theta, converged = minimise(model, theta, scales)
        previous = scales
        if not known:
            scales = likely_scales(model, theta, scales)
            # A thousandth of a scale is a thousandth of the length of an interval.
            if all(abs(scales[k] - previous[k]) < 1e-3 * scales[k] for k in scales):
                break
    predicted, slopes = predicted_at(model, theta)
    return Fit(model, theta, model.data - predicted, slopes, scales, known, converged)


def predicted_at(model: Model, theta: Array) -> tuple[Array, Array]:
    """``Model.predict``, without infinities: TooStrongError where a step of the search has left the doubles.

    LAPACK is never handed a nan or an infinity, of which it writes to the terminal.  The last prediction is kept: the
    scales and the result ask once more for that with which the search has ended.
    """
    asked = (theta.tobytes(), model.swing.tolerance)
    if model.predicted is not None and model.predicted[0] == asked:
        return model.predicted[1]
    # The search may lead anywhere; what overflows there is refused, and is no warning for the user.
    with np.errstate(all="ignore"):
        predicted, slopes = model.predict(theta)
        # Written so that nan is wild too.
        tame = bool((np.abs(predicted) < _HUGE).all() and (np.abs(slopes) < _HUGE).all())
    if not tame:
        raise TooStrongError("the motion leaves every bound")
    model.predicted = asked, (predicted, slopes)
    return predicted, slopes


def likely_scales(model: Model, theta: Array, scales: dict[str, float]) -> dict[str, float]:
    """sqrt(RSS_g/(N_g - k_g)), k_g the trace of the hat matrix over the data of one kind; never below the floor."""
    predicted, slopes = predicted_at(model, theta)
    r = (model.data - predicted) / model.shape
    left = _left_over(model, slopes, scales)
    found = {}
    for kind, group in zip(model.kinds, model.groups):
        # With no freedom left the scale is not determined; half a datum keeps the quotient finite.
        size = float(np.sqrt((r[group] ** 2).sum() / max(left[kind], 0.5)))
        found[kind] = max(size, model.floor(kind, theta))
    return found


def _left_over(model: Model, slopes: Array, scales: dict[str, float]) -> dict[str, float]:
    found = Directions.of(slopes / model.scale_vector(scales)[:, None])
    hat = found.left[:, found.seen]
    return {
        # N_g minus the trace of the hat matrix over the group: the parameters shared out between the kinds.
        kind: group.stop - group.start - model.absorbed - float(np.sum(hat[group] ** 2))
        for kind, group in zip(model.kinds, model.groups)
    }


@np.errstate(all="ignore")  # a step of the search may lead anywhere: a cost that overflows is refused there
def minimise(
    model: Model, theta: Array, scales: dict[str, float], penalty: Penalty | None = None
) -> tuple[Array, bool]:
    """Levenberg and Marquardt's iteration; a step that leaves the model's domain is shortened.

    ``penalty`` adds one residual with its gradient (a function of the parameters held near a value).
    """
    sigma = model.scale_vector(scales)

    def residuals(at: Array) -> tuple[Array, Array]:
        predicted, slopes = predicted_at(model, at)
        r, J = (model.data - predicted) / sigma, -slopes / sigma[:, None]
        if penalty is None:
            return r, J
        value, gradient = penalty(at)
        return np.append(r, value), np.vstack([J, gradient])

    r, J = residuals(theta)
    # Nearly Gauss and Newton's step at once: the starting values are within its reach as a rule.
    cost, damping = float(r @ r), 1e-6
    for _ in range(_STEPS):
        tick()
        size = np.sqrt((J**2).sum(axis=0)) + 1e-300
        # In Marquardt's scaling, the damping does not depend on the units of the parameters.
        step = _step(J / size, r, damping) / size
        trial = _inside(model, theta + step)
        try:
            new_r, new_J = residuals(trial)
            new_cost = float(new_r @ new_r)
        # The step leads to a motion that ends before the data do: infinitely bad, so that the damping grows.
        except TooStrongError:
            new_cost = np.inf
        if new_cost <= cost:
            # In units of the noise: 1e-7 of chi-squared is far below the 3.84 that moves an interval.
            done = cost - new_cost <= 1e-7 * min(cost, 1.0) + _NEARLY * cost
            theta, r, J, cost, damping = trial, new_r, new_J, new_cost, damping / 10
            if done:
                return theta, True
        # A step too small to be seen that does not descend either: the minimum, to rounding.
        elif np.linalg.norm(step * size) <= 1e-7 * (1 + np.sqrt(cost)):
            return theta, True
        else:
            # Downhill the damping vanishes and the steps are Newton's; uphill it must come back from there.
            damping = max(damping * 10, 1e-6)
            # The step has shrunk by 1e12 without a descent: no minimum is claimed.
            if damping > 1e12:
                break
    return theta, False


def _step(J: Array, r: Array, damping: float) -> Array:
    normal = J.T @ J
    return np.asarray(-np.linalg.solve(normal + damping * np.eye(len(normal)), J.T @ r))


def _inside(model: Model, theta: Array) -> Array:
    """A free exponent stays between 0 and its largest value."""
    if model.swing.free:
        theta[model.after - 1] = np.clip(theta[model.after - 1], 0.0, MAX_FREE_ALPHA)
    return theta
