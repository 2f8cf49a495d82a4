"""A sampled envelope: amplitudes at times, of a ring-down whose swings are far faster than the samples.

The amplitudes are taken as those of turning points n that are an artificial clock: between two of them lie
``stride`` = 2 f h true half-swings.  To first order the loss of a half-swing is proportional to the strengths, so that
the strengths of the artificial clock are ``stride`` times the true ones; what this neglects is the square of what is
lost from one n to the next, which is kept below 2 % by counting finely enough: about 1e-4 of a strength.  Without a
frequency ``stride`` is 0: the amplitudes have their times and rates, and no strength.

>>> t = np.arange(0, 60, 0.1)
>>> seen = observations_of_envelope(t, 5 * np.exp(-t / 20), 1000.0)
>>> seen.stride, seen.spacing, seen.last
(66.6..., 0.0333..., 1797)
"""

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.observations import Indices, Observations
from asymptotics.errors import InputError
from asymptotics.present.counts import many

_LEAST, _COUNTED, _UNEVEN, _SIGMAS = 5, 1000, 0.01, 4.0
"""Rows of an envelope; the number of artificial half-swings at least; and how uneven a clock may be, as a share of its
step, to count in steps; and how many errors below the largest an amplitude may be it."""
_FOLLOWING = 8
"""Rows behind the largest ones by which it is told whether those fall already."""
_FINE = 20_000
"""Artificial half-swings of an uneven clock."""


def observations_of_envelope(
    t: Array, x: Array, frequency: float | None, *, relative: bool = False, unit: str = "", name: str = "the envelope",
    notes: tuple[str, ...] = (),
) -> Observations:  # fmt: skip
    """The amplitudes from where they fall on; ``relative``: their errors are proportional to them, as in decibels.

    InputError for what is no decay of amplitudes.
    """
    first = _falling(x)
    said = [f"the first {many(first, 'row')}, before the amplitude falls, left out"] if first else []
    t, x = t[first:], x[first:]
    dead = np.flatnonzero(x <= 0)
    if len(dead):
        said.append(f"the amplitudes from t = {t[dead[0]]:.6g} on, where one is 0 or below, left out")
        t, x = t[: dead[0]], x[: dead[0]]
    if len(x) < _LEAST:
        raise InputError("FILE", f"{name}: {many(len(x), 'amplitude')} that fall", f"at least {_LEAST}")
    n, spacing = _counted(t)
    stride = 0.0 if frequency is None else 2 * frequency * spacing
    told = f"an envelope of unknown frequency: {many(len(x), 'amplitude')}"
    if frequency is not None:
        told = f"an envelope at {frequency:.8g} Hz: {many(len(x), 'amplitude')}, {stride * int(n[-1]):.6g} half-swings"
    seen = Observations.of(n, x, sigma_x=x if relative else (), unit=unit, name=name, notes=(*notes, *said, told))
    # Amplitudes have one sign, which the reading of turning points tells: here it says nothing.
    kept = tuple(note for note in seen.notes if "one sign" not in note)
    return seen.as_envelope(stride, spacing, kept)


def _falling(x: Array) -> int:
    """The row at which the decay begins: behind the last that noise may have taken for the largest, for a drive holds
    the amplitude before it stops; the first of them, if they fall already as those that follow."""
    alive = np.maximum(x, 1e-300)
    level = np.log(alive)
    if len(x) < _LEAST or not (x > 0).any():
        return 0
    # Second differences of a smooth line are small; those of noise have six times its variance.
    noise = float(np.median(np.abs(np.diff(level, 2)))) / (0.6745 * 6**0.5)
    top = np.flatnonzero(level >= level.max() - _SIGMAS * noise)
    first, last = int(top[0]), int(top[-1])
    if last == 0 or _falls_already(level, first, last):
        return first
    return last + 1


def _falls_already(level: Array, first: int, last: int) -> bool:
    """Whether the rows lie on the line through as many that follow (eight at least), nearer than if they were held."""
    rows = np.arange(last + 1, min(last + 1 + max(last + 1 - first, _FOLLOWING), len(level)))
    if first == last or len(rows) < _LEAST:
        return False
    slope, start = np.polyfit(rows, level[rows], 1)
    before = np.arange(first, last + 1)
    lacking = float((start + slope * before - level[before]).mean())
    # Held rows lack half of what the line falls by on them, on average; falling ones nothing: half of that divides.
    return bool(slope < 0 and lacking < -slope * (last - first) / 4)


def _counted(t: Array) -> tuple[Indices, float]:
    """Artificial numbers of half-swings, and the time between two of them."""
    step = float(np.median(np.diff(t)))
    rows = np.round((t - t[0]) / step)
    even = bool((np.abs((t - t[0]) / step - rows) < _UNEVEN).all() and (np.diff(rows) > 0).all())
    if not even:
        spacing = float(t[-1] - t[0]) / _FINE
        return np.round((t - t[0]) / spacing).astype(np.intp), spacing
    # An odd number for each step: signs alternate, so that no rest position is taken for a loss.
    parts = int(np.ceil(_COUNTED / max(rows[-1], 1))) // 2 * 2 + 1
    return (rows * parts).astype(np.intp), step / parts
