"""A sampled motion as one slowly modulated line: turning points where no extreme can be seen, and the noise.

    x(t) = base + drift u + Re(P(u) e^(i w t)) + Re(Q(u) e^(3 i w t)),        u in [-1, 1] over the record,

with polynomials P, Q whose degree Akaike's criterion chooses, is linear in all that is unknown but w, asks for no
extreme and no even sampling, and holds for every law with slow losses.  Its turning points start the fit of the motion
(``waveform``), and what it leaves over is noise, measured without any law.

>>> t = np.arange(0, 47, 2.1)
>>> line = demodulated(t, np.exp(-0.02 * t) * np.cos(t))
>>> n, times, values = line.turning_points()
>>> bool(np.abs(times - np.pi * np.round(times / np.pi)).max() < 0.05), len(n)
(True, 17)
"""

from dataclasses import dataclass

import numpy as np

from asymptotics.identification.coefficients import Array
from asymptotics.identification.observations import Indices

_DEGREES, _DENSE, _DIRECT = 12, 8.0, 1500
_OVER, _FINE, _MARGIN = 4, 40, 0.15


@dataclass(frozen=True)
class Line:
    """``omega``: the frequency; ``modulation``: complex coefficients of P; ``noise``: what is left, with ``freedom``
    data more than coefficients; ``memory``: its correlation from sample to sample."""

    t: Array
    omega: float
    modulation: Array
    noise: float
    freedom: float
    memory: float

    def _places(self, t: Array) -> Array:
        return np.asarray(2 * (t - self.t[0]) / (self.t[-1] - self.t[0]) - 1)

    def at(self, t: Array) -> tuple[Array, Array]:
        """(amplitude, phase) at times inside the record."""
        P = np.polynomial.chebyshev.chebval(self._places(t), self.modulation)
        return np.abs(P), np.asarray(self.omega * t + np.unwrap(np.angle(P)))

    def turning_points(self, derivative: int = 0) -> tuple[Indices, Array, Array]:
        """(n, times, signed values) of the motion, of which the record is this derivative: from the last one before
        the first sample to the first after the last."""
        count = int(_FINE * (self.t[-1] - self.t[0]) * self.omega / (2 * np.pi)) + 3
        grid = np.linspace(self.t[0], self.t[-1], count)
        size, phase = self.at(grid)
        phase = np.maximum.accumulate(phase) - derivative * np.pi / 2
        size = np.log(np.maximum(size, 1e-300)) - derivative * np.log(self.omega)
        k = np.arange(int(np.floor(phase[0] / np.pi - _MARGIN)), int(np.ceil(phase[-1] / np.pi)) + 1)
        outside = np.minimum(k * np.pi - phase[0], 0) + np.maximum(k * np.pi - phase[-1], 0)
        times = np.interp(k * np.pi, phase, grid) + outside / self.omega
        slopes = [
            min(float(np.polyfit(g, s, 1)[0]), 0.0)
            for g, s in ((grid[:_FINE], size[:_FINE]), (grid[-_FINE:], size[-_FINE:]))
        ]
        values = np.interp(times, grid, size) + np.where(outside < 0, slopes[0], slopes[1]) * outside / self.omega
        return np.arange(len(k)), times, np.exp(values) * np.where(k % 2, -1.0, 1.0)


def demodulated(t: Array, x: Array, period: float | None = None) -> Line:
    """The line of a record; ``period`` where it is known."""
    omega = 2 * np.pi / period if period else _frequency(t, x)
    for _ in range(3):
        line = _line(t, x, omega)
        grid = np.linspace(t[0], t[-1], 400)
        size, phase = line.at(grid)
        drift = float(np.polynomial.Polynomial.fit(grid, phase - omega * grid, 1, w=size).convert().coef[1])
        if abs(drift) * (t[-1] - t[0]) < 0.3:
            break
        omega += drift
    return line


def _frequency(t: Array, x: Array) -> float:
    """Of the strongest line: of few samples, however they lie, from 1.5 periods in the record to half as many periods
    as samples; of many, by the fast transform."""
    if len(t) > _DIRECT:
        return 2 * np.pi / dominant_period(t, x)
    span = t[-1] - t[0]
    low, high = 2 * np.pi * 1.5 / span, np.pi * (len(t) - 1) / span
    trials = np.linspace(low, high, int(_OVER * (high - low) * span / (2 * np.pi)) + 2)
    even = x - np.polynomial.Polynomial.fit(t, x, 1)(t)
    return float(trials[np.argmax(np.abs(np.exp(-1j * trials[:, None] * (t - t[0])) @ even))])


def dominant_period(t: Array, x: Array) -> float:
    """The period of the strongest line of the spectrum, from the record resampled evenly."""
    count = int(min(2**17, max(256, 2 ** int(np.log2(len(t)) + 1))))
    grid = np.linspace(t[0], t[-1], count)
    even = np.interp(grid, t, x)
    even = even - np.polynomial.Polynomial.fit(grid, even, 1)(grid)
    power = np.abs(np.fft.rfft(even * np.hanning(count)))
    power[:2] = 0
    k = int(np.argmax(power))
    return float((t[-1] - t[0]) * count / (count - 1) / k)


def _line(t: Array, x: Array, omega: float) -> Line:
    u = 2 * (t - t[0]) / (t[-1] - t[0]) - 1
    dense = 2 * np.pi / omega / float(np.median(np.diff(t))) > _DENSE
    best: tuple[float, Line] | None = None
    for degree in range(_DEGREES + 1):
        V = np.polynomial.chebyshev.chebvander(u, degree)
        parts = [V * f(k * omega * t)[:, None] for k in ((1, 3) if dense else (1,)) for f in (np.cos, np.sin)]
        columns = np.concatenate([*parts, np.ones((len(t), 1)), u[:, None]], axis=1)
        size, left = columns.shape[1], len(t) - columns.shape[1]
        if left < max(4, len(t) / 3) and best is not None:
            break
        c = np.linalg.lstsq(columns, x, rcond=1e-10)[0]
        r = x - columns @ c
        rss = max(float(r @ r), 1e-300)
        criterion = len(t) * np.log(rss / len(t)) + 2 * size + 2 * size * (size + 1) / max(left - 1, 0.5)
        if best is None or criterion < best[0]:
            noise = float(np.sqrt(rss / max(left, 1)))
            P = c[: degree + 1] - 1j * c[degree + 1 : 2 * degree + 2]
            best = criterion, Line(t, omega, P, noise, float(left), _memory(r, size))
    assert best is not None
    return best[1]


def _memory(r: Array, size: int) -> float:
    """The correlation of neighbours, with its bias for so many coefficients; 0 where it is not beyond doubt."""
    rho = float(r[1:] @ r[:-1]) / max(float(r @ r), 1e-300)
    rho += (1 + 3 * rho) / len(r) * (1 + size / 8)
    return min(rho, 0.98) if rho > 3 / np.sqrt(len(r)) else 0.0
