"""The sequence of turning points and times of a law, with exact derivatives: the forward model of identification.

An orbit of the return map, solved as one nonlinear system (as in multiple shooting), with its variational equations.

a_(n+1) = a_n + L(a_n) for a = ln A is solved for all n at once by Newton's iteration.  The linearised recurrence

    u_(n+1) = (1 + L_a(a_n)) u_n + f_n      has the solution      u_n = P_n (u_0 + sum_(k<n) f_k/P_(k+1)),

P_n = prod_(k<n) (1 + L_a(a_k)), and serves three times: for the Newton step, for the derivatives by each parameter, and
(with P = 1) for the times tau_n = sum_(k<n) T(a_k).  Everything is a handful of vector operations.

>>> from asymptotics.decays.identification.forward.coefficients import loss
>>> orbit = turning_sequence(HalfSwingModel((loss(0.0),)), 4, np.array([0.0, 0.1]))
>>> np.exp(orbit.a)                                            # dry friction: 2 epsilon a half-swing
array([1. , 0.8, 0.6, 0.4, 0.2])
"""

from dataclasses import dataclass

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.quadrature import TooStrongError
from asymptotics.decays.identification.forward.swing import HalfSwingModel

_NEWTON_STEPS = 12
"""Newton's iteration doubles the digits, so that from a guess in reach a few steps do; where they do not, the sequence
is halved (``_in_parts``)."""
_CLOSE = 1e-7
"""A change of ln(amplitude) whose square, the size of the next one, is below every noise and nearly below doubles."""
_FEW = 4
"""So many half-swings are stepped through where Newton's iteration fails."""


@dataclass(frozen=True)
class TurningSequence:
    """a_n = ln(A_n), omega_0 t_n (n = 0 ... N); omega_0 (passage time) and ln of the speed there (n = 0 ... N - 1).

    The derivatives have one row for a_0 and one for each parameter of the law.
    """

    a: Array
    tau: Array
    passage: Array
    log_speed: Array
    d_a: Array
    d_tau: Array
    d_passage: Array
    d_log_speed: Array


def turning_sequence(
    swing: HalfSwingModel, count: int, parameters: Array, guess: Array | None = None
) -> TurningSequence:
    """Turning points 0 ... ``count`` from (a_0, strengths ..., exponent); TooStrongError if the motion ends before."""
    a0, law = float(parameters[0]), parameters[1:]
    a = _solved(swing, a0, law, count, guess)
    value = swing.at(a[:-1], law)
    growth = 1 + value.by_amplitude[0]
    # d ln A'/d ln A > 0, for paths do not cross; at 0 the motion ends at the next turning point, and products would
    # vanish.
    if not (growth > 1e-9).all():
        raise TooStrongError("the next amplitude falls when this one rises")
    product = np.concatenate([[1.0], np.cumprod(growth)])
    # The formula of the docstring, with f = dL/dparameter, for all parameters at once.
    source = value.by_parameter[:, 0] / product[1:]
    d_a = np.concatenate([product[None], product * _before(source)])
    d_value = value.by_amplitude[:, None, :] * d_a[None, :, :-1]
    d_value[:, 1:] += np.moveaxis(value.by_parameter, 0, 1)
    tau, d_tau = _before(value.values[1]), _before(d_value[1])
    passage, d_passage = tau[:-1] + value.values[3], d_tau[:, :-1] + d_value[3]
    log_speed, d_log_speed = a[:-1] + value.values[2], d_a[:, :-1] + d_value[2]
    return TurningSequence(a, tau, passage, log_speed, d_a, d_tau, d_passage, d_log_speed)


def _before(increments: Array) -> Array:
    """Sums over k < n, along the last axis, for n = 0 ... N."""
    zero = np.zeros((*increments.shape[:-1], 1))
    return np.concatenate([zero, np.cumsum(increments, axis=-1)], axis=-1)


def _solved(swing: HalfSwingModel, a0: float, law: Array, count: int, guess: Array | None) -> Array:
    if guess is None or len(guess) != count + 1:
        # The guess falls like 1/n, as for quadratic loss: between the decay of linear loss and the end of friction.
        first = float(swing.at(np.array([a0]), law).values[0, 0])
        guess = -np.log1p(np.arange(count + 1) * max(-first, 0.0))
    # A coarse look gives a law up where Newton's iteration does: the full fit decides about it.
    return _polished(swing, a0, law, guess) if swing.coarse else _in_parts(swing, a0, law, guess)


def _in_parts(swing: HalfSwingModel, a0: float, law: Array, guess: Array) -> Array:
    """Newton's iteration for the whole; where it goes astray, for one half after the other, so that a motion that ends
    too early is known after a few evaluations for each halving.  Of a few half-swings their steps decide."""
    try:
        return _polished(swing, a0, law, guess)
    except TooStrongError:
        if len(guess) <= _FEW + 1:
            return _stepwise(swing, a0, law, len(guess) - 1)
    middle = len(guess) // 2
    first = _in_parts(swing, a0, law, guess[: middle + 1])
    return np.concatenate([first, _in_parts(swing, float(first[-1]), law, guess[middle:])[1:]])


def _polished(swing: HalfSwingModel, a0: float, law: Array, a: Array) -> Array:
    """Newton's iteration for the whole sequence."""
    a = a - a[0] + a0
    for _ in range(_NEWTON_STEPS):
        value = swing.at(a[:-1], law)
        L, slope = value.values[0], value.by_amplitude[0]
        product = np.concatenate([[1.0], np.cumprod(1 + slope)])
        # An iterate at which the map is not increasing is no orbit, nor near one.
        if not (product > 0).all():
            break
        change = product * _before((a[:-1] + L - a[1:]) / product[1:])
        # At most a factor e in an amplitude: a longer step would leave the domain of the series.
        a = a + np.clip(change, -1.0, 1.0)
        if np.abs(change).max() < _CLOSE:  # quadratic: the next change would be far below
            return a
    raise TooStrongError("the sequence of turning points could not be computed")


def _stepwise(swing: HalfSwingModel, a0: float, law: Array, count: int) -> Array:
    """One half-swing after the other."""
    a = np.empty(count + 1)
    a[0] = a0
    for n in range(count):
        a[n + 1] = a[n] + swing.at(a[n : n + 1], law).values[0, 0]
        if not np.isfinite(a[n + 1]):
            raise TooStrongError("the amplitudes leave every bound")
    return a
