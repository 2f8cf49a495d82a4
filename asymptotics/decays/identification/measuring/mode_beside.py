"""A second mode that is fitted beside the motion, on demand: where its fit begins.

Unasked, a line is taken off where it is beyond doubt (``second_mode``).  Asked for (``modes=2``), the strongest line
beside the motion (of a beat the weaker mode, ``near_modes``) is taken whatever its size is, and the fit of each law has
it beside the motion, with its amplitude, phase, frequency and rate of decay as unknowns: what it costs the intervals is
in them.

>>> t = np.arange(0, 200, 0.5)
>>> x = np.exp(-0.01 * t) * np.cos(t) + 0.05 * np.exp(-0.02 * t) * np.cos(2.7 * t)
>>> omega, line = strongest_line(t, x)
>>> round(omega, 2), [abs(round(v, 2)) for v in beginning(t, line, omega)]
(2.7, [0.05, 0.0, 2.7, 0.02])
"""

from dataclasses import replace

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.demodulation import demodulated
from asymptotics.decays.identification.measuring.near_modes import near_modes
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.measuring.sampled import observations_of_motion
from asymptotics.decays.identification.measuring.second_mode import line_beside, motion_columns, solved
from asymptotics.errors import InputError

_MOST, _NYQUIST, _NEAR = 1500, 0.45, 3
"""So many samples are looked at for the place of the line; up to this share of their frequency; and the bins about the
motion and its third overtone that belong to them."""
_RATES = np.array([0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0])
"""Rates of decay, over the record, of which the best begins the fit."""


def with_mode_beside(
    t: Array, x: Array, *, unit: str, name: str, notes: tuple[str, ...], derivative: int
) -> Observations:
    """The samples with the beginning of a second mode; InputError where there is no further line."""
    near = near_modes(t, x)
    found = strongest_line(t, x) if near is None else (near.omega[1], near.lines[1])
    if found is None:
        raise InputError("modes", f"{name} shows no line beside the motion", "1")
    omega, line = found
    seen = observations_of_motion(t, x - line, unit=unit, name=name, notes=notes, derivative=derivative)
    assert seen.samples is not None
    beside = np.interp(seen.samples.t, t, line)
    mode = beginning(seen.samples.t, beside, omega)
    said = f"a second mode at about {omega:.4g} rad/s is fitted beside the motion"
    samples = replace(seen.samples, x=seen.samples.x + beside, mode=mode)
    return replace(seen, samples=samples, notes=(*seen.notes, said))


def strongest_line(t: Array, x: Array) -> tuple[float, Array] | None:
    """(frequency, values at all samples) of the strongest line beside the motion, however small; None where none is."""
    some = slice(None, None, -(-len(t) // _MOST))
    T, X = t[some], x[some]
    motion = demodulated(T, X)
    columns = motion_columns(motion, T)
    left = X - columns @ solved(columns, columns[:, :0], X)
    width = 2 * np.pi / float(T[-1] - T[0])
    # Half a bin apart: no line falls between two places.
    trials = np.arange(1.0, _NYQUIST * 2 * np.pi / float(np.median(np.diff(T))) / width, 0.5) * width
    apart = np.minimum(np.abs(trials - motion.omega), np.abs(trials - 3 * motion.omega)) > _NEAR * width
    if not apart.any():
        return None
    power = np.where(apart, np.abs(np.exp(-1j * trials[:, None] * (T - T[0])) @ left), 0.0)
    found = line_beside(t, x, motion.omega, float(trials[np.argmax(power)]), worth=0.0)
    return None if found is None else (found[2], found[0])


def beginning(t: Array, line: Array, omega: float) -> tuple[float, ...]:
    """Cosine, sine, frequency and rate of the decaying wave that is nearest to the line."""
    s, best = t - t[0], (np.inf, np.zeros(2), 0.0)
    for rate in _RATES / float(s[-1]):
        waves = np.exp(-rate * s)[:, None] * np.stack([np.cos(omega * s), np.sin(omega * s)], axis=1)
        c = np.linalg.lstsq(waves, line, rcond=None)[0]
        rss = float(((line - waves @ c) ** 2).sum())
        if rss < best[0]:
            best = rss, c, float(rate)
    return (*map(float, best[1]), omega, best[2])
