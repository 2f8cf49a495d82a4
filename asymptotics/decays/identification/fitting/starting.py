"""Starting values by linear regression on sums over the swings: no derivative of the data, no iteration.

To first order A_(n+1) - A_n = sum_i c_i s_i A^(w_i+1) with c_i the first coefficients of L, hence with A between
successive turning points

    A_n = A_0 + sum_i s_i c_i sum_(k<n) A_(k+1/2)^(w_i+1),     t_n = t_0 + (1/omega_0) sum_(k<n) (pi + sum_i s_i e_i
    A_k^w_i),

linear in everything unknown.  Sums forgive noise where differences would not.
"""

import numpy as np

from asymptotics.decays.identification.fitting.model import Model
from asymptotics.decays.identification.forward.coefficients import Array, swing_coefficients
from asymptotics.decays.identification.forward.pendulum import PendulumHalfSwing, well
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.sequence import turning_sequence
from asymptotics.decays.identification.measuring.observations import Observations

_EXPONENTS = (0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0)
"""Where a free exponent may begin: the misfit has few minima in it, and one of these lies near the least."""


def starting_values(model: Model) -> Array:
    """A parameter vector from which the fit converges; strengths shrink until the motion reaches the last point."""
    if not model.swing.free:
        return _reachable(model, _regressed(model, None)[0])
    tried = [_regressed(model, alpha) for alpha in _EXPONENTS]
    return _reachable(model, min(tried, key=lambda found: found[1])[0])


def rest_position(seen: Observations) -> float:
    """The mean of (x_(n-1) + 2 x_n + x_(n+1))/4 over successive turning points: alternating parts cancel."""
    x, n = seen.x, seen.n
    # Across a gap in n the signs do not cancel.
    whole = (n[2:] - n[:-2] == 2) if len(n) > 2 else np.array([], dtype=bool)
    return float(np.mean((x[:-2] + 2 * x[1:-1] + x[2:])[whole] / 4)) if whole.any() else 0.0


def _regressed(model: Model, alpha: float | None) -> tuple[Array, float]:
    seen, swing = model.seen, model.swing
    first = swing_coefficients(swing.elements, 1, () if alpha is None else (alpha,))
    offset = rest_position(seen) if model.offset else 0.0
    # Points that noise has carried across 0 must not make a negative power infinite.
    size = np.maximum(np.abs(seen.x - offset), 1e-3 * seen.reference)
    size = (size if model.angle is None else well(size, model.angle)) / model.reference
    if not np.isfinite(size).all():
        raise TooStrongError("an amplitude beyond the top of the pendulum")
    weights = first.weights[0]
    units = {k.index(1): j for j, k in enumerate(first.keys) if sum(k) == 1}
    by_loss = np.array([first.L[0, units[i]] for i in range(len(weights))])
    by_time = np.array([first.T[0, units[i]] for i in range(len(weights))])
    losses = np.array([e.kind == "loss" for e in swing.elements])
    gap = np.diff(seen.n)
    # The geometric mean is the amplitude in the middle of the half-swing, where the loss is centred to second order.
    middle = np.sqrt(size[1:] * size[:-1])
    basis = [np.ones(len(size))]
    basis += [c * _sums(gap * middle ** (w + 1)) for c, w in zip(by_loss[losses], weights[losses])]
    matrix = np.stack(basis, axis=1)
    # Parallel columns share their strength, which is as good a beginning as any.
    found, *_ = np.linalg.lstsq(matrix, size, rcond=1e-9)
    misfit = float(((size - matrix @ found) ** 2).sum())
    strengths = np.zeros(len(weights))
    strengths[losses] = found[1:]
    # A first amplitude below a thousandth of the reference is the regression's failure, not the motion's.
    theta = [np.log(max(float(found[0]), 1e-3)), *strengths, *([] if alpha is None else [alpha])]
    theta += [offset] if model.offset else []
    if seen.has_times:
        lag = [e * _sums(gap * middle**w) for e, w in zip(by_time[~losses], weights[~losses])]
        half = np.pi * gap
        if isinstance(swing, PendulumHalfSwing):
            # A pendulum's half-swing lasts 2 K(k) without any loss.
            half = half * swing.period_ratio(np.log(middle))
        columns = np.stack([np.ones(len(size)), _sums(half), *lag], axis=1)
        clock, *_ = np.linalg.lstsq(columns, seen.t, rcond=1e-9)
        spring_place = 1 + np.flatnonzero(~losses)
        for place, value in zip(spring_place, clock[2:] / clock[1]):
            # A regression on noisy times may ask for a spring beyond the reach of the series: begin within it.
            theta[place] = float(np.clip(value, -0.2, 0.2))
        theta += [-np.log(max(float(clock[1]), 1e-12)), clock[0]]
    return np.array(theta, dtype=float), misfit


def _sums(steps: Array) -> Array:
    return np.concatenate([[0.0], np.cumsum(steps)])


def _reachable(model: Model, theta: Array) -> Array:
    theta = theta.copy()
    strengths = slice(1, 1 + len(model.swing.elements))
    # 0.7^12 is 1.4 %: strengths so weak reach any last point, or the fit refuses the law.
    for _ in range(12):
        try:
            turning_sequence(model.swing, model.seen.last, theta[: model.after])
        except TooStrongError:
            theta[strengths] *= 0.7
        else:
            break
    return theta
