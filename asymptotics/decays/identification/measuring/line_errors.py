"""Amplitudes and turning times of a smooth line, with the covariance of their errors: they are as smooth as it.

A line (``demodulation``) of polynomials has errors as smooth as itself, larger at its ends, where nothing holds it on
one side; and what its degree, the best for the whole record, cannot follow is a bias, largest there too: a decay is
steepest where it begins.  So the degree is raised by two, until the bias is small beside the noise (undersmoothing),
and the covariance of the amplitudes, sigma^2 B (V^T V)^(-1) B^T with the columns V of the samples and B those of the
turning times, goes into what is fitted to them.  A turning time is a zero of x': its error is that of x' over -x''.

>>> t = np.arange(0, 40, 0.1)
>>> x = np.exp(-0.05 * t) * np.cos(t) + 0.01 * np.random.default_rng(0).standard_normal(400)
>>> turns = line_turns(Samples(t, x, 0.01, 390.0), np.pi * np.arange(12), np.arange(12))
>>> error = np.sqrt((turns.size_root**2).sum(axis=1))
>>> off = np.abs(turns.size - np.exp(-0.05 * np.pi * np.arange(12)))
>>> bool((off < 4 * error).all()), bool(error[0] > 1.5 * error[6])
(True, True)
"""

from dataclasses import dataclass

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.demodulation import SpectralLine, density, fitted_line
from asymptotics.decays.identification.measuring.observations import Indices, Samples

_MORE, _SPARE = 2, 8
"""Degrees above the best one, and samples that are left for the noise."""
_STIFF, _NEAR = 0.3, 0.3
"""The least -x'' at a turning point, beside omega^2 |x|, and how far from a first guess, in radians, it is sought."""


@dataclass(frozen=True)
class LineTurns:
    """``size``: |x| at the turning points; ``t``: their times; ``size_root``, ``time_root``: roots F of the covariances
    F F^T of their errors, a row for each; ``harmonics``: of the motion, those that the line has."""

    size: Array
    size_root: Array
    t: Array
    time_root: Array
    harmonics: tuple[int, ...]


def line_turns(samples: Samples, t: Array, n: Indices) -> LineTurns:
    """The turning points of the numbers ``n`` near the times ``t``."""
    omega = np.pi * float(n[-1] - n[0]) / float(t[-1] - t[0])
    best = fitted_line(samples.t, samples.x, omega)
    harmonics = (1,) if len(best.third) == 1 else (1, 3)
    degree = len(best.modulation) - 1
    while degree < len(best.modulation) - 1 + _MORE and len(samples.t) > 2 * len(harmonics) * (degree + 2) + _SPARE:
        degree += 1
    beside = np.stack([np.ones(len(samples.t)), samples.t - samples.t[0]], axis=1)
    V = np.concatenate([beside, _columns(best, samples.t, degree, harmonics, 0)], axis=1)
    x, v, a = (_columns(best, t, degree, harmonics, samples.derivative, order) for order in range(3))
    scale = np.sqrt((V**2).sum(axis=0))
    inverse = np.linalg.pinv(V / scale)[2:] / scale[2:, None]
    c = inverse @ samples.x
    loud = density(samples.memory, omega * float(np.median(np.diff(samples.t))))
    along, noise = np.asarray(np.linalg.qr(inverse.T, mode="r")).T, samples.noise * np.sqrt(loud)
    # x'' is -omega^2 x but for the losses, and is never taken for less than a part of that.
    force = np.sign(a @ c) * np.maximum(np.abs(a @ c), _STIFF * omega**2 * np.abs(x @ c))
    step = np.clip(-(v @ c) / force, -_NEAR / omega, _NEAR / omega)
    size_root = noise * _root(np.sign(x @ c)[:, None] * (x @ along), degree)
    return LineTurns(np.abs(x @ c), size_root, t + step, noise * _root(v @ along / force[:, None], degree), harmonics)


def _root(errors: Array, degree: int) -> Array:
    """A root of the covariance of errors that are polynomials: of degree d they have d + 1 parts that are independent,
    and what is beside them is nothing that a line could follow."""
    left, size, _ = np.linalg.svd(errors, full_matrices=False)
    return np.asarray((left * size)[:, : degree + 1])


def _columns(
    line: SpectralLine, t: Array, degree: int, harmonics: tuple[int, ...], derivative: int, order: int = 0
) -> Array:
    """What each coefficient of the modulation is at times, in a derivative of the motion that is ``order``; of a record
    that is a ``derivative``, integrated to the motion."""
    found = []
    for harmonic in harmonics:
        units = np.repeat(np.eye(degree + 1, dtype=complex), 2, axis=0)
        units[1::2] *= -1j
        each = [line.differentiated(line.integrated(c, harmonic, derivative), harmonic, order) for c in units]
        found.append(line.waves(np.stack(each, axis=1), harmonic, t))
    return np.concatenate(found, axis=1)
