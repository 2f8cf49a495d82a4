"""The amplitudes of a smooth line at its turning times, with the covariance of their errors: they are as smooth as it.

A line (``demodulation``) of polynomials has errors as smooth as itself, larger at its ends, where nothing holds it on
one side; and what its degree, the best for the whole record, cannot follow is a bias, largest there too: a decay is
steepest where it begins.  So the degree is raised by two, until the bias is small beside the noise (undersmoothing),
and the covariance of the amplitudes, sigma^2 B (V^T V)^(-1) B^T with the columns V of the samples and B those of the
turning times, goes into what is fitted to them.

>>> t = np.arange(0, 40, 0.1)
>>> x = np.exp(-0.05 * t) * np.cos(t) + 0.01 * np.random.default_rng(0).standard_normal(400)
>>> size, root = line_amplitudes(Samples(t, x, 0.01, 390.0), np.pi * np.arange(12), np.arange(12))
>>> error = np.sqrt((root**2).sum(axis=1))
>>> bool((np.abs(size - np.exp(-0.05 * np.pi * np.arange(12))) < 4 * error).all()), bool(error[0] > 1.5 * error[6])
(True, True)
"""

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.demodulation import SpectralLine, density, fitted_line
from asymptotics.decays.identification.measuring.observations import Indices, Samples

_MORE, _SPARE = 2, 8
"""Degrees above the best one, and samples that are left for the noise."""


def line_amplitudes(samples: Samples, t: Array, n: Indices) -> tuple[Array, Array]:
    """|x| at turning times of the numbers ``n``, and a root F of the covariance F F^T of its errors, a row for each."""
    omega = np.pi * float(n[-1] - n[0]) / float(t[-1] - t[0])
    best = fitted_line(samples.t, samples.x, omega)
    harmonics = (1,) if len(best.third) == 1 else (1, 3)
    degree = len(best.modulation) - 1
    while degree < len(best.modulation) - 1 + _MORE and len(samples.t) > 2 * len(harmonics) * (degree + 2) + _SPARE:
        degree += 1
    beside = np.stack([np.ones(len(samples.t)), samples.t - samples.t[0]], axis=1)
    V = np.concatenate([beside, _columns(best, samples.t, degree, harmonics, 0)], axis=1)
    B = _columns(best, t, degree, harmonics, samples.derivative)
    scale = np.sqrt((V**2).sum(axis=0))
    inverse = np.linalg.pinv(V / scale)[2:] / scale[2:, None]
    values = B @ (inverse @ samples.x)
    loud = density(samples.memory, omega * float(np.median(np.diff(samples.t))))
    along = np.asarray(np.linalg.qr(inverse.T, mode="r")).T
    # The amplitudes of a polynomial of degree d have d + 1 errors that are independent: what is beside them is nothing
    # that a line could follow.
    left, size, _ = np.linalg.svd(np.sign(values)[:, None] * (B @ along), full_matrices=False)
    root = (left * size)[:, : degree + 1]
    return np.abs(values), samples.noise * np.sqrt(loud) * root


def _columns(line: SpectralLine, t: Array, degree: int, harmonics: tuple[int, ...], derivative: int) -> Array:
    """What each coefficient of the modulation is at times; of a derivative, integrated to the motion."""
    found = []
    for harmonic in harmonics:
        for k in range(degree + 1):
            for part in (1.0, -1j):
                c = np.zeros(degree + 1, dtype=complex)
                c[k] = part
                found.append(line.wave(line.integrated(c, harmonic, derivative), harmonic, t))
    return np.stack(found, axis=1)
