"""A sampled motion as one slowly modulated line: turning points where no extreme can be seen, and the noise.

The field's word is complex demodulation: a carrier with an amplitude and a phase that vary slowly.

    x(t) = base + drift u + Re(P(u) e^(i w t)) + Re(Q(u) e^(3 i w t)),        u in [-1, 1] over the record,

with polynomials P, Q whose degree Akaike's criterion chooses, is linear in all that is unknown but w, asks for no
extreme and no even sampling, and holds for every law with slow losses.  Its turning points start the fit of the motion
(``waveform``), and what it leaves over is noise, measured without any law.

>>> t = np.arange(0, 47, 2.1)
>>> line = demodulated(t, np.exp(-0.02 * t) * np.cos(t))
>>> n, times, values, inside = line.turning_points()
>>> bool(np.abs(times - np.pi * np.round(times / np.pi)).max() < 0.05), len(n)
(True, 17)
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from asymptotics.decays.identification.forward.blocks import triangle
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.main_frequency import main_frequency
from asymptotics.decays.identification.measuring.observations import Indices

_DEGREES, _MOST, _EACH, _DENSE = 12, 32, 30, 8.0
"""Degree 12 for every record, and up to 32 where there are 30 samples for each coefficient, so that noise stays noise;
the third overtone is fitted from 8 samples a period on, of which it has a third."""
_A_PERIOD, _FEWEST = 1.0, 6
"""A polynomial of degree d turns d/2 times in the record: with one turn for a period it would be the motion itself, and
the phase of the line would mean nothing.  Half of that, which keeps its third overtone apart too; and in short records
degree 6, which a strong decay needs."""
_FARTHEST, _CHIRP, _LOUD = 0.15, 0.1, 0.1
"""By how much the mean drift of the phase may correct the frequency: a bin of the record, at most a share of the
frequency, and its chirp; the drift is that of the amplitudes above a tenth of the largest, for in a tail the
polynomials follow whatever is there."""
_DEPENDENT = 1e-9
"""Columns that are so much smaller beside the others are no longer independent of them in doubles."""
_NEWTON, _NEAR, _PARTS = 3, 0.3, 5
"""Steps of Newton's method to an extreme, begun where the phase has it; how small the slope must then be, as a share of
omega |x|; and terms of the integration by parts, each smaller by the slowness of the modulation."""
_SPECTRAL, _COEFFICIENTS = 60, 8
"""Samples below which a spectrum has too few bins to tell its colour from chance."""
_FINE, _MARGIN = 40, 0.15
"""Places of the phase in a period; and by how much of a half-swing the phase at the start may be off before the turning
point next to it is missed."""
_OWN = 0.5
"""How far from where the phase has it an extreme may lie, in half-swings."""
_WILD, _ABOUT, _REST, _POOR, _GRID = 2.0, 0.75, 0.01, 0.1, 200
"""The amplitude of a line is at most so many times half the range of the samples within so many periods: the cosine of
a line is as large as that in any half-swing, and polynomials that cancel one another are none.  Where nothing moves it
may still be a hundredth of the record; and it leaves at most a tenth of the record.  Places where it is asked."""
_STEEP = 1.0
"""By how much ln A may change from the last sample to the turning point beyond it: no decay that is seen to swing
changes by more in a half-swing, and a wild polynomial must not begin a fit far outside the data."""


Flags = NDArray[np.bool_]


@dataclass(frozen=True)
class SpectralLine:
    """``omega``: the frequency; ``modulation``, ``third``: complex coefficients of P and Q; ``noise``: what is left,
    with ``freedom`` data more than coefficients; ``memory``: its correlation from sample to sample."""

    t: Array
    omega: float
    modulation: Array
    third: Array
    noise: float
    freedom: float
    memory: float

    def _places(self, t: Array) -> Array:
        return np.asarray(2 * (t - self.t[0]) / (self.t[-1] - self.t[0]) - 1)

    def at(self, t: Array) -> tuple[Array, Array]:
        """(amplitude, phase) at times inside the record."""
        P = np.polynomial.chebyshev.chebval(self._places(t), self.modulation)
        return np.abs(P), np.asarray(self.omega * t + np.unwrap(np.angle(P)))

    def turning_points(self, derivative: int = 0) -> tuple[Indices, Array, Array, Flags]:
        """(n, times, signed values) of the motion, of which the record is this derivative: from the last one before
        the first sample to the first after the last; and which of them lie inside, where the line is known."""
        P, Q = (self.integrated(c, k, derivative) for c, k in ((self.modulation, 1), (self.third, 3)))
        count = int(_FINE * (self.t[-1] - self.t[0]) * self.omega / (2 * np.pi)) + 3
        grid = np.linspace(self.t[0], self.t[-1], count)
        modulation = np.polynomial.chebyshev.chebval(self._places(grid), P)
        # P may vanish at a place of a wild polynomial; its logarithm must not be infinite.
        size = np.log(np.maximum(np.abs(modulation), 1e-300))
        # The clock of an oscillation does not go back: where the modulation is noise it is held, so that it can be
        # inverted.
        phase = np.maximum.accumulate(self.omega * grid + np.unwrap(np.angle(modulation)))
        k = np.arange(int(np.floor(phase[0] / np.pi - _MARGIN)), int(np.ceil(phase[-1] / np.pi)) + 1)
        # Beyond the record the phase goes on at omega, and the amplitude with its mean slope over the first or last
        # period, never growing with time.
        outside = np.minimum(k * np.pi - phase[0], 0) + np.maximum(k * np.pi - phase[-1], 0)
        times = np.interp(k * np.pi, phase, grid) + outside / self.omega
        slopes = [
            min(float(np.polyfit(g, s, 1)[0]), 0.0)
            for g, s in ((grid[:_FINE], size[:_FINE]), (grid[-_FINE:], size[-_FINE:]))
        ]
        beyond = np.where(outside < 0, slopes[0], slopes[1]) * outside / self.omega
        values = np.interp(times, grid, size) + np.clip(beyond, -_STEEP, _STEEP)
        values = np.exp(values) * np.where(k % 2, -1.0, 1.0)
        # The third overtone and the slope of the amplitude move an extreme away from where the phase has it.
        by_phase, guessed = times, values
        for _ in range(_NEWTON):
            x, v, a = (self._sum(P, Q, times, order) for order in range(3))
            toward = np.sign(x) * np.sign(a) < 0
            inside = (outside == 0) & (np.abs(v) < _NEAR * self.omega * np.abs(x)) & toward
            times = np.where(inside, times - np.divide(v, a, where=inside, out=np.zeros_like(v)), times)
        # Nearer to its neighbours than to its own place, it is the extreme of something else.
        own = np.abs(times - by_phase) < _OWN * np.pi / self.omega
        times, inside, values = np.where(own, times, by_phase), inside & own, np.where(own, values, guessed)
        return np.arange(len(k)), times, np.where(inside, self._sum(P, Q, times, 0), values), inside

    def integrated(self, c: Array, harmonic: int, derivative: int) -> Array:
        """Coefficients of P when the record, a derivative, is integrated: sum_k (-1)^k P^(k)/(i k omega)^(k+1)."""
        rate = 1j * harmonic * self.omega
        for _ in range(derivative):
            # Integration by parts ends for a polynomial; the terms fall like (rate of the modulation/omega)^k.
            total, term = np.zeros(len(c), dtype=complex), c / rate
            for _ in range(_PARTS):
                total[: len(term)] += term
                if len(term) == 1:
                    break
                term = -np.polynomial.chebyshev.chebder(term, scl=2 / (self.t[-1] - self.t[0])) / rate
            c = total
        return c

    def wave(self, c: Array, harmonic: int, t: Array) -> Array:
        """Re(c(u) e^(i harmonic omega t))."""
        modulation = np.polynomial.chebyshev.chebval(self._places(t), c)
        return np.asarray((modulation * np.exp(1j * harmonic * self.omega * t)).real)

    def waves(self, c: Array, harmonic: int, t: Array) -> Array:
        """The same of each column of coefficients, in one product."""
        modulation = np.polynomial.chebyshev.chebvander(self._places(t), len(c) - 1) @ c
        return np.asarray((modulation * np.exp(1j * harmonic * self.omega * t)[:, None]).real)

    def _sum(self, P: Array, Q: Array, t: Array, order: int) -> Array:
        """A derivative by time of Re(P e^(i w t)) + Re(Q e^(3 i w t))."""
        return self.wave(self.differentiated(P, 1, order), 1, t) + self.wave(self.differentiated(Q, 3, order), 3, t)

    def differentiated(self, c: Array, harmonic: int, order: int) -> Array:
        """Coefficients of a derivative by time: each is P' + i k omega P."""
        total, scale = c.astype(complex), 2 / (self.t[-1] - self.t[0])
        for _ in range(order):
            slope = np.zeros_like(total)
            slope[: len(c) - 1] = np.polynomial.chebyshev.chebder(total, scl=scale)[: len(c) - 1]
            total = 1j * harmonic * self.omega * total + slope
        return np.asarray(total)


def demodulated(t: Array, x: Array, period: float | None = None) -> SpectralLine:
    """The line of a record; ``period`` where it is known."""
    first = omega = 2 * np.pi / period if period else main_frequency(t, x)
    # Half a bin and the chirp of a strong spring: what lies beyond is no correction, but the noise of a tail.
    reach = min(2 * np.pi / (t[-1] - t[0]), _FARTHEST * first) + _CHIRP * first
    # The frequency of the spectrum is off by up to half a bin: the mean drift of the phase corrects it, until it is
    # less than 0.3 rad over the record, which the modulation takes up.
    for _ in range(3):
        line = fitted_line(t, x, omega)
        grid = np.linspace(t[0], t[-1], 400)
        size, phase = line.at(grid)
        loud = _loud(size)
        grid, size, phase = grid[loud], size[loud], phase[loud] - omega * grid[loud]
        drift = float(np.polynomial.Polynomial.fit(grid, phase, 1, w=size).convert().coef[1])
        if abs(drift) * (grid[-1] - grid[0]) < 0.3 or abs(omega + drift - first) > reach:
            break
        omega += drift
    return line


def _loud(size: Array) -> slice:
    """About the largest amplitude, as far as the phase is that of the motion; at least a twentieth of the record."""
    top = int(np.argmax(size))
    low = np.flatnonzero(size < _LOUD * size[top])
    first, last = (low[low < top].max(initial=-1) + 1, low[low > top].min(initial=len(size)))
    least = len(size) // 20
    return slice(min(first, max(top - least, 0)), max(last, min(top + least, len(size))))


def fitted_line(t: Array, x: Array, omega: float) -> SpectralLine:
    """The line of the degree that Akaike's criterion chooses: the columns of all degrees are nested, so that one
    factorisation answers for each of them."""
    u = 2 * (t - t[0]) / (t[-1] - t[0]) - 1
    harmonics = (1, 3) if 2 * np.pi / omega / float(np.median(np.diff(t))) > _DENSE else (1,)
    waves = np.stack([f(k * omega * t) for k in harmonics for f in (np.cos, np.sin)], axis=1)
    each = waves.shape[1]
    # A third of the samples, and four of them at least, stay for the noise.
    most = max((len(t) - max(4, len(t) // 3) - 2) // each - 1, 0)
    most = min(most, max(_FEWEST, int(_A_PERIOD * omega * (t[-1] - t[0]) / (2 * np.pi))))
    V = np.polynomial.chebyshev.chebvander(u, min(max(_DEGREES, min(_MOST, len(t) // (_EACH * each))), most))
    modulated = (V[:, :, None] * waves[:, None, :]).reshape(len(t), -1)
    # Nested columns: the first k of Q span the first k of all of them, so that one factorisation serves each degree.
    A = np.concatenate([np.ones((len(t), 1)), u[:, None], modulated], axis=1)
    R = triangle(np.concatenate([A, x[:, None]], axis=1))
    y, R = R[:, -1], R[: A.shape[1], :-1]
    # What so many columns leave: the coordinates beyond them, and in the last one what lies outside all of them.
    beyond = np.cumsum(y[::-1] ** 2)[::-1]
    size, criteria = np.abs(np.diag(R)), dict[int, float]()
    for columns in range(2 + each, R.shape[1] + 1, each):
        if size[:columns].min() < _DEPENDENT * size[:columns].max():
            break
        left = len(t) - columns
        rss = max(float(beyond[columns]), 1e-300)
        # AICc as in ``criteria``, but finite when there are too few data: such a degree loses by its size.
        penalty = 2 * columns + 2 * columns * (columns + 1) / max(left - 1, 0.5)
        criteria[columns] = len(t) * np.log(rss / len(t)) + penalty
    ordered = sorted(criteria, key=lambda count: criteria[count]) or [2 + each]
    places, highest = _highest(t, x, 2 * np.pi / omega)
    # Of less than two periods a low degree may be no line at all: then one within twice the range of the record.
    seen = [n for n in ordered if float((y[n:-1] ** 2).sum()) < _POOR**2 * float((y[1:-1] ** 2).sum())]
    limits = [(seen, highest), (ordered, _WILD * np.ptp(x))]
    tame = (n for some, most in limits for n in some if (np.abs(_modulation(R, y, n, each, places)) <= most).all())
    columns = next(tame, ordered[0])
    c = _coefficients(R, y, columns)
    noise, memory = _coloured(t, x - A[:, :columns] @ c, omega, columns, each)
    waves_of = c[2:].reshape(-1, each)
    third = waves_of[:, 2] - 1j * waves_of[:, 3] if each > 2 else np.zeros(1, dtype=complex)
    return SpectralLine(t, omega, waves_of[:, 0] - 1j * waves_of[:, 1], third, noise, float(len(t) - columns), memory)


def _coefficients(R: Array, y: Array, columns: int) -> Array:
    """The coefficients of so many columns: base, drift, and for each power its cosines and sines."""
    return np.asarray(np.linalg.lstsq(R[:columns, :columns], y[:columns], rcond=1e-10)[0])


def _modulation(R: Array, y: Array, columns: int, each: int, places: Array) -> Array:
    """P of so many columns at places from -1 to 1."""
    waves = _coefficients(R, y, columns)[2:].reshape(-1, each)
    return np.asarray(np.polynomial.chebyshev.chebval(places, waves[:, 0] - 1j * waves[:, 1]))


def _highest(t: Array, x: Array, period: float) -> tuple[Array, Array]:
    """Places from -1 to 1, and how large the amplitude of a line may be there; no limit in a gap."""
    times = np.linspace(t[0], t[-1], _GRID)
    ends = zip(np.searchsorted(t, times - _ABOUT * period), np.searchsorted(t, times + _ABOUT * period, side="right"))
    size = np.array([np.ptp(x[low:high]) / 2 if high > low else np.inf for low, high in ends])
    return np.linspace(-1.0, 1.0, _GRID), _WILD * np.maximum(size, _REST * float(np.ptp(x)))


def _coloured(t: Array, r: Array, omega: float, columns: int, each: int) -> tuple[float, float]:
    """(standard deviation, correlation of neighbours) of what is left, 0 where that is not beyond doubt.

    Whittle's likelihood of an AR(1) spectrum, without the lines at 0, omega and 3 omega: there the polynomials take
    noise away, or leave motion.  Of uneven samples: the standard deviation and the correlation as they are.
    """
    n, step = len(r), float(np.median(np.diff(t)))
    plain = float(np.sqrt(max(float(r @ r), 1e-300) / max(n - columns, 1)))
    # Bins of a spectrum are independent for even sampling only; a fifth of a step is a choice.
    if n < _SPECTRAL or np.abs(np.diff(t) - step).max() > 0.2 * step:
        return plain, _memory(r, columns)
    power = np.abs(np.fft.rfft(r))[1:-1] ** 2 / n
    k = np.arange(1, len(power) + 1)
    # A polynomial of degree d occupies about d bins around its line; four more for what leaks.
    wide, line = columns // each + 4, omega * step * n / (2 * np.pi)
    near = [k > wide // 2, np.abs(k - line) > wide, np.abs(k - 3 * line) > wide]
    keep = np.logical_and.reduce(near)
    if keep.sum() < _SPECTRAL // 4:
        return plain, _memory(r, columns)
    power, place = power[keep], 2 * np.pi * k[keep] / n
    # A grid is enough: half a step of 0.01 changes the length of an interval by 3 % at most, and closer to 1, where it
    # would change more, the grid is finer.
    rho = np.concatenate([np.linspace(-0.3, 0.9, 121), np.linspace(0.905, 0.995, 19)])
    g = 1 / (1 - 2 * rho[:, None] * np.cos(place) + rho[:, None] ** 2)
    # The most likely innovation variance at each correlation; what is minimised is then Whittle's likelihood,
    # concentrated.
    size = (power / g).mean(axis=1)
    best = int(np.argmin(np.log(g).mean(axis=1) + np.log(size)))
    found = float(rho[best])
    noise = float(np.sqrt(size[best] / (1 - found**2)))
    # 1.5 standard errors: a memory that is not there costs little, one that is not allowed for shortens the intervals.
    return noise, found if found > 1.5 / np.sqrt(keep.sum()) else 0.0


def density(memory: float, turn: float) -> float:
    """How loud AR(1) noise is at a frequency, of ``turn`` radians a sample, beside white noise of its size.

    >>> density(0.0, 0.3), round(density(0.8, 0.0), 6), round(density(0.8, np.pi), 6)
    (1.0, 9.0, 0.111111)
    """
    return float((1 - memory**2) / (1 - 2 * memory * np.cos(turn) + memory**2))


def _memory(r: Array, size: int) -> float:
    """The correlation of neighbours, with its bias for so many coefficients; 0 where it is not beyond doubt."""
    rho = float(r[1:] @ r[:-1]) / max(float(r @ r), 1e-300)
    # The bias of the estimate, -(1 + 3 rho)/n (Marriott and Pope 1954, Biometrika 41, 390-402), and more for the
    # coefficients: no theory, but by simulation (seed 35, ``benchmarks/constants.json``) intervals are 0.95 to 1.33
    # times as long as the true correlation makes them where it is seen, without the term down to 0.77 times, with four
    # times the term up to 2.8 times.  A correlation of 0.3 in 40 or 58 samples is not seen: 0.73 times.
    rho += (1 + 3 * rho) / len(r) * (1 + size / _COEFFICIENTS)
    # Beyond three standard errors only. At 1 nothing would be left of the data.
    return min(rho, 0.98) if rho > 3 / np.sqrt(len(r)) else 0.0
