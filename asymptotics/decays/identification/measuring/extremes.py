"""Extremes and passages of a sampled record about a base line: local polynomials with propagated errors.

A smoothed copy gives the lobes between passages; around each extreme and each passage a polynomial is fitted to the raw
samples (Savitzky and Golay 1964, of one degree and at any spacing), and its extreme (or root) is taken with the error
that follows from the residuals and their correlation.

>>> t = np.linspace(0, 20, 2001)
>>> found = extremes_of(t, np.cos(2 * t), np.pi)
>>> bool(np.allclose(np.diff(found.t), np.pi / 2)), bool(np.allclose(np.abs(found.x), 1))
(True, True)
"""

from dataclasses import dataclass

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.late_extremes import DEGREE

WINDOW, WIDEST, SAMPLES = 0.11, 0.26, 4.6
"""Half-width of a local fit, in periods: 0.7 rad, where a polynomial of degree 6 follows a cosine to 1e-7.  Where the
samples are few it is nine of them, which the fit needs, up to a quarter of a period, where it follows to 1e-5."""


@dataclass(frozen=True)
class Extremes:
    """Extremes and passages found about one base line."""

    t: Array
    x: Array
    sigma_t: Array
    sigma_x: Array
    passage_t: Array
    sigma_passage: Array
    noise: float


def half_width(t: Array, period: float) -> float:
    """Of the local fits: the same share of the period for all records, but as many samples as the fit needs."""
    step = float(np.median(np.diff(t)))
    return min(max(WINDOW * period, SAMPLES * step), WIDEST * period)


def extremes_of(t: Array, x: Array, period: float) -> Extremes:
    """Extremes, one in each lobe of the smoothed record, and the passages between them."""
    step = float(np.median(np.diff(t)))
    half = half_width(t, period)
    # A twentieth of a period: noise goes, and a cosine loses 0.4 % of its height, which the local fits restore. Odd, so
    # that it is centred.
    width = max(1, int(0.05 * period / step)) | 1
    smooth = _moving_mean(x, width)
    crossing = np.flatnonzero(np.signbit(smooth[1:]) != np.signbit(smooth[:-1])) + 1
    # Noise makes several crossings of one: the last of a group counts.
    crossing = crossing[np.diff(t[crossing], append=np.inf) > 0.2 * period]
    peaks = [
        a + int(np.argmax(np.abs(smooth[a:b])))
        for a, b in zip(crossing[:-1], crossing[1:])
        # A lobe lasts half a period; one of 0.8 has a gap in it, or has lost a crossing.
        if t[b] - t[a] < 0.8 * period and b - a >= 4
    ]
    # The extreme before the first crossing, where the record begins with a whole window about it.
    if len(crossing) and len(peaks) and t[crossing[0]] - t[0] > 0.05 * period and t[crossing[0]] - t[0] < 0.8 * period:
        first = int(np.argmax(np.abs(smooth[: crossing[0]])))
        peaks = [first, *peaks] if first > 0 and t[first] - t[0] > half else peaks
    extremes = [_local(t, x, t[p], half, extreme=True) for p in peaks]
    passages = [_local(t, x, t[c], half, extreme=False) for c in crossing]
    good = [e for e in extremes if e is not None]
    roots = [p for p in passages if p is not None]
    residual = [e[4] for e in good]
    noise = float(np.median(residual)) if residual else 0.0
    e = np.array(good).reshape(-1, 5)
    p = np.array(roots).reshape(-1, 5)
    return Extremes(e[:, 0], e[:, 1], e[:, 2] * noise, e[:, 3] * noise, p[:, 0], p[:, 2] * noise, noise)


def _moving_mean(x: Array, width: int) -> Array:
    """The mean over ``width`` samples (odd) about each, by sums: the cost does not grow with the width."""
    total = np.concatenate([[0.0], np.cumsum(np.pad(x, width // 2, mode="edge"))])
    return np.asarray((total[width:] - total[:-width]) / width)


def _local(t: Array, x: Array, centre: float, half: float, *, extreme: bool) -> tuple[float, ...] | None:
    """(time, value, d time/noise, d value/noise, noise) of an extreme or a root near ``centre``, or None."""
    # The window is centred again on the extreme that was found, where its errors are least, to less than a sample.
    for attempt in range(3):
        low, high = np.searchsorted(t, [centre - half, centre + half])
        u, y = (t[low:high] - centre) / half, x[low:high]
        # As above, and no gap of more than a quarter of the window within it.
        if len(u) < DEGREE + 3 or u[0] > -0.7 or u[-1] < 0.7 or np.diff(u).max() > 0.5:
            return None
        V = np.vander(u, DEGREE + 1, increasing=True)
        inverse = np.linalg.inv(V.T @ V)  # of degree 6 on [-1, 1]: a condition of 1e6, and much sooner than an SVD
        c = inverse @ (V.T @ y)
        root = _newton(c.tolist(), extreme)
        if root is None:
            return None
        if abs(root) < 0.01 or attempt == 2:
            break
        centre += root * half
    assert root is not None
    powers = root ** np.arange(DEGREE + 1)
    slopes = np.concatenate([[0.0], np.arange(1, DEGREE + 1) * powers[:-1]])
    curve = np.concatenate([[0.0, 0.0], np.arange(2, DEGREE + 1) * np.arange(1, DEGREE) * powers[:-2]])
    r = y - V @ c
    spread = float(np.sqrt((r**2).sum() / (len(u) - DEGREE - 1)))
    memory = _correlation_factor(r)
    toward, steepness = (slopes, curve @ c) if extreme else (powers, slopes @ c)
    # The error of a zero: that of the function (or its slope) over its own slope there.
    in_time = float(np.sqrt(toward @ inverse @ toward) / abs(steepness) * half)
    in_value = float(np.sqrt(powers @ inverse @ powers))
    return centre + root * half, float(powers @ c), in_time * memory, in_value * memory, spread


def _slopes(c: list[float]) -> list[float]:
    """The coefficients of the derivative of a polynomial."""
    return [k * each for k, each in enumerate(c)][1:]


def _value(c: list[float], u: float) -> float:
    """By Horner's rule, in Python's own numbers: of one place it takes a tenth of the time of an array."""
    total = 0.0
    for each in reversed(c):
        total = total * u + each
    return total


def _newton(polynomial: list[float], extreme: bool) -> float | None:
    function = _slopes(polynomial) if extreme else polynomial
    slope, u = _slopes(function), 0.0
    # Newton's iteration in the unit of the window, from its middle; beyond 0.9 the polynomial is not known.
    for _ in range(12):
        d = _value(slope, u)
        if d == 0:
            return None
        step = _value(function, u) / d
        u -= step
        if abs(u) > 0.9:
            return None
        if abs(step) < 1e-13:
            break
    return u


def _correlation_factor(r: Array) -> float:
    """sqrt((1 + rho)/(1 - rho)): what correlated residuals add to the error of a mean."""
    power = float((r**2).sum())
    rho = float((r[1:] * r[:-1]).sum()) / power if power > 0 else 0.0
    # The sum formula of AR(1); at 0.9 the error is stretched by 4.4, and a window knows no more than that.
    rho = min(max(rho, 0.0), 0.9)
    return float(np.sqrt((1 + rho) / (1 - rho)))
