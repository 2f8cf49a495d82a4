"""A second mode of the structure, hum, a rocking base: a line of its own in the spectrum, measured and taken off.

Looked for is a peak that stands out of both its sides, away from the motion and its overtones (which chirp with the
amplitude, k times as much in the k-th).  Then the motion and the line

    x(t) = base + drift u + Re(P(u) e^(i w t)) + Re(Q(u) e^(3 i w t)) + Re(S(u) e^(i w' t)),    u in [-1, 1],

are fitted together, linear in all but w', the degree of S chosen by Akaike's criterion, and Re(S e^(i w' t)) is
subtracted if it is worth its coefficients beyond doubt.  Nearer to the motion than a few periods of the record
tell apart, a line is its modulation: such a beat is named (``defects``), not taken off.

>>> t = np.arange(0, 200, 0.1)
>>> pure, line = np.exp(-0.01 * t) * np.cos(t), 0.05 * np.exp(-0.02 * t) * np.cos(2.7 * t)
>>> rest, notes = without_second_modes(t, pure + line)
>>> bool(np.abs(rest - pure).max() < 1e-3), notes
(True, ('a second mode at 2.7 rad/s, 5 % of the first at the beginning, measured and taken off',))
"""

import numpy as np

from asymptotics.decays.identification.forward.blocks import triangle
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.demodulation import SpectralLine, demodulated
from asymptotics.decays.identification.measuring.main_frequency import dominant_period
from asymptotics.present.percent import percent

_LEAST, _PER_PERIOD, _MOST = 200, 12.0, 6_000
"""Samples in all and in a period, below which overtones appear at other places; and as many as the fit is given."""
_LOWEST, _HIGHEST, _NYQUIST, _APART = 0.3, 8.0, 0.4, 0.03
"""Frequencies that are looked at, as shares of that of the motion, and of that of the samples; what is left out about
each overtone."""
_NEAR, _SIDE, _LOW, _HEIGHT = 3, 10, 0.3, 6.0
"""The sides of a peak are the bins so far from it; it is so many times as high as the lower ones of each."""
_SLOW = 5
"""Coefficients of both modulations in the rough fit, which only takes the line away from the motion: few, or that of
the motion would follow the line."""
_SMALLEST, _DEGREES, WORTH = 1e-3, 6, 60.0
"""A line below 1/1000 of the motion in the spectrum is not looked at, a free choice: WORTH decides what is taken off;
its own modulation has degree 6 at most, lower than that of the motion; and it must lower the criterion by 60, a
likelihood e^30 times as large, for what is taken off in error is signal that is lost."""
_MODES = 2
"""So many lines are taken off: each further one is looked for in the rest that the ones before it left."""


def without_second_modes(t: Array, x: Array) -> tuple[Array, tuple[str, ...]]:
    """The record without further lines, and what they were."""
    notes: list[str] = []
    for _ in range(_MODES):
        place = _peak(t, x)
        found = None if place is None else line_beside(t, x, *place)
        if found is None:
            break
        x = x - found[0]
        notes.append(found[1])
    return x, tuple(notes)


def _peak(t: Array, x: Array) -> tuple[float, float] | None:
    """(frequency of the motion, that of the highest line beside it) in the spectrum; None where there is none."""
    if len(t) < _LEAST:
        return None
    span, step = float(t[-1] - t[0]), float(np.median(np.diff(t)))
    # As in ``main_frequency``.
    count = int(min(2 ** int(np.log2(len(t)) + 1), 2**17))
    grid = np.linspace(t[0], t[-1], count)
    even = np.interp(grid, t, x)
    even = even - np.polynomial.Polynomial.fit(grid, even, 1)(grid)
    power = np.abs(np.fft.rfft(even * np.hanning(count)))
    power[:2] = 0
    bin_width = 2 * np.pi * (count - 1) / count / span
    # Not the highest line: a second mode that dies later may be that.
    omega = 2 * np.pi / dominant_period(t, x)
    main = round(omega / bin_width)
    # Below five periods in the record every other line stands within the width of the motion's.
    if main < 5 or 2 * np.pi / omega / step < _PER_PERIOD:
        return None
    far = _APART + _chirp(t, x, omega)
    highest = min(_HIGHEST * omega, _NYQUIST * 2 * np.pi / step) / bin_width
    k = np.arange(max(int(_LOWEST * main), 3), min(int(highest), len(power) - _SIDE - 1))
    # The odd overtone nearest to each bin: those of a symmetric force.
    odd = 2 * np.floor(k / main / 2) + 1
    k = k[np.abs(k - odd * main) > np.maximum(far * odd * main, _NEAR)]
    k = k[(power[k] >= power[k - 1]) & (power[k] >= power[k + 1]) & (power[k] > _SMALLEST * power[main])]
    if not len(k):
        return None
    reach = np.arange(_NEAR, _SIDE + 1)
    # The higher of both sides: the flank of the motion has one high side, and is no line.
    sides = [np.quantile(power[np.maximum(k[:, None] + way * reach, 2)], _LOW, axis=1) for way in (-1, 1)]
    k = k[power[k] > _HEIGHT * np.maximum(*sides)]
    return (omega, float(k[np.argmax(power[k])] * bin_width)) if len(k) else None


def _chirp(t: Array, x: Array, omega: float) -> float:
    """By which share the frequency changes: slopes of the phase, from means over whole periods, in both halves."""
    # Means over two whole periods, in which the carrier and its overtones cancel.
    place = ((t - t[0]) * omega / (4 * np.pi)).astype(int)
    count = np.maximum(np.bincount(place), 1)
    wave = (x - np.median(x)) * np.exp(-1j * omega * (t - t[0]))
    means = (np.bincount(place, wave.real) + 1j * np.bincount(place, wave.imag)) / count
    phase, middle = np.unwrap(np.angle(means)), len(means) // 2
    # Two slopes of less than three points each would be noise.
    if middle < 3:
        return 0.0
    slopes = [_slope(phase[part], np.abs(means[part])) for part in (slice(middle), slice(middle, None))]
    # The phase gains 4 pi times the share in each step of two periods.
    return float(abs(slopes[1] - slopes[0])) / (4 * np.pi)


def _slope(y: Array, size: Array) -> float:
    """Of y over its places, by least squares with the weights ``size``; 0 where nothing but one place has any."""
    top = float(size.max())
    # In units of the largest: the squares of a record in units of 1e-200 would be 0.
    weight = (size / top) ** 2 if top > 0 else size
    place = np.arange(len(y)) - float(weight @ np.arange(len(y))) / max(float(weight.sum()), 1e-300)
    spread = float(weight @ place**2)
    return float(weight @ (place * y)) / spread if spread > 1e-12 else 0.0


def line_beside(
    t: Array, x: Array, omega: float, other: float, worth: float = WORTH
) -> tuple[Array, str, float] | None:
    """(the line at all samples, its description, its frequency) from a fit of the motion and the line together; None if
    it does not lower the criterion by ``worth``."""
    some = slice(None, None, -(-len(t) // _MOST))
    T, X = t[some], x[some]
    slow = motion_columns(SpectralLine(T, omega, np.zeros(_SLOW), np.zeros(1), 0.0, 0.0, 0.0), T)
    # A rough fit of both, to take the line off before the motion is demodulated.
    line = _line(t, other)[some, : 2 * _SLOW]
    rough = X - line @ solved(slow, line, X)[slow.shape[1] :]
    first = demodulated(T, rough, 2 * np.pi / omega)  # without the line, or its modulation would follow it
    main = motion_columns(first, T)
    # The frequency again, now that the motion is away: a bin of the spectrum is too coarse for a phase over the record.
    other = _refined(T, X - main @ solved(main, main[:, :0], rough), other)
    line = _line(t, other)
    along = triangle(np.concatenate([main, line[some], X[:, None]], axis=1))[:, -1]
    # What so many columns leave: the coordinates beyond them, and in the last one what lies outside all of them.
    left = np.maximum(np.cumsum(along[::-1] ** 2)[::-1][main.shape[1] :: 2], 1e-300)
    # Without the line: the criterion that it has to beat by WORTH.  Cosine and sine of one degree together: Akaike's 2
    # for each.
    criteria = len(T) * np.log(left / len(T)) + 4.0 * np.arange(len(left))
    criteria[0] -= worth
    columns = 2 * int(np.argmin(criteria))
    if not columns:
        return None
    c = solved(main, line[some, :columns], X)[main.shape[1] :]
    first_sign = (-1.0) ** np.arange(columns // 2)  # Chebyshev's polynomials at the beginning
    size = float(np.hypot(*(first_sign @ c.reshape(-1, 2)))) / float(first.at(T)[0][0])
    said = f"a second mode at {other:.4g} rad/s, {percent(size)} of the first at the beginning"
    taken = line[:, :columns] @ c
    # A line larger than the record itself is one of two that cancel: the fit has not told it from the motion.
    if float(np.abs(taken).max()) > float(np.ptp(x)) / 2:
        return None
    return taken, f"{said}, measured and taken off", other


def solved(main: Array, line: Array, x: Array) -> Array:
    """The coefficients of both together, by least squares."""
    R = triangle(np.concatenate([main, line, x[:, None]], axis=1))[: main.shape[1] + line.shape[1]]
    return np.asarray(np.linalg.lstsq(R[:, :-1], R[:, -1], rcond=1e-10)[0])


def motion_columns(line: SpectralLine, t: Array) -> Array:
    """The columns of the motion: base, drift, and the modulated line with its third overtone."""
    degree = len(line.modulation) - 1
    modulated = [_line(t, k * line.omega, degree) for k in ((1, 3) if len(line.third) > 1 else (1,))]
    return np.concatenate([np.ones((len(t), 1)), _places(t)[:, None], *modulated], axis=1)


def _line(t: Array, omega: float, degree: int = _DEGREES) -> Array:
    """The columns of a line: each Chebyshev polynomial times cosine and sine."""
    waves = np.stack([np.cos(omega * t), np.sin(omega * t)], axis=1)
    V = np.polynomial.chebyshev.chebvander(_places(t), degree)
    return np.asarray((V[:, :, None] * waves[:, None, :]).reshape(len(t), -1))


def _places(t: Array) -> Array:
    return np.asarray(2 * (t - t[0]) / (t[-1] - t[0]) - 1)


def _refined(t: Array, left: Array, omega: float) -> float:
    """The frequency of the line in what the motion leaves, within a bin of where the spectrum shows it."""
    # A twentieth of a bin: the phase is then off by 0.16 rad at the ends, which the modulation takes up.
    trials = omega + np.linspace(-1.5, 1.5, 61) * 2 * np.pi / (t[-1] - t[0])
    # Hann's window: what is left of the motion leaks less into the place.
    window = np.sin(np.pi * (t - t[0]) / (t[-1] - t[0])) ** 2 * left
    return float(trials[np.argmax(np.abs(np.exp(-1j * trials[:, None] * (t - t[0])) @ window))])
