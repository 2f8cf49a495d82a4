"""Errors of amplitude and of time, half-swing by half-swing: what a table of turning points or of x(tau) gets wrong.

A motion that is slightly wrong is, over one half-swing, the right one with a factor and a delay:

    x_given(tau) = (1 + a) x(tau + s)   so that   x_given - x = a x + s v + (smaller)

At turning points a and s are read off; from samples they are the least-squares solution around each turning point.
Doubles: this judges errors, it certifies nothing.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np

_SAMPLES = 4  # that a fit needs
_WIDTHS = (0.5, 0.8, 1.2, np.pi / 2)
"""How far about a turning point, in units of 1/omega_0, samples are taken: as near as there are four of them.  Nearer
is better, for a first-order waveform is wrong in third order there; beyond a quarter-swing they belong to the next one.
A choice."""


@dataclass(frozen=True)
class Errors:
    """Per point: error a of ln ``amplitude``, ``advance`` s (None if there are no times), true ``size`` and ``tau``.

    ``jumps``: the share of the errors of samples that no a and s explain.
    """

    tau: Any
    size: Any
    amplitude: Any
    advance: Any | None
    jumps: float = 0.0

    def __len__(self) -> int:
        return len(self.size)


def of_turning_points(ns: Any, given: Any, x: Any, given_tau: Any | None = None, tau: Any | None = None) -> Errors:
    """From amplitudes at the turning points ``ns``, given and true, and times if there are any."""
    order = np.argsort(ns)
    g, c = (np.abs(np.asarray(values, float))[order] for values in (given, x))
    # Without times the clock without damping will do: rates are compared with rates on the same clock.
    true = np.pi * np.asarray(ns, float)[order] if tau is None else np.asarray(tau, float)[order]
    advance = None if given_tau is None else true - np.asarray(given_tau, float)[order]
    # An amplitude given as 0 has an infinite error, which is told as such (``run``).
    with np.errstate(divide="ignore", invalid="ignore"):
        return Errors(true, c, np.log(g / c), advance)


def of_motion(tau: Any, given: Any, x: Any, v: Any, turning: tuple[Any, Any]) -> tuple[Errors, Any]:
    """From samples of x(tau): an error of ln A and an advance at each turning point (times, sizes) that has enough.

    Only samples near a turning point count: there a first-order waveform differs from the true one in third order, so
    that a and s are those of the amplitude and the phase.  Also returns the numbers of the turning points.
    """
    order = np.argsort(tau)
    tau, given, x, v = (np.asarray(values, float)[order] for values in (tau, given, x, v))
    times, sizes = turning
    found, missed, whole = [], 0.0, 0.0
    for n, (time, size) in enumerate(zip(times, sizes)):
        near = _near(tau, time)
        # A motion that ends at 0 under dry friction has no amplitude there to be wrong by.
        if len(near) < _SAMPLES or size == 0:
            continue
        columns = np.stack([x[near], v[near]], axis=1)
        wrong = (given - x)[near]
        (a, s), *_ = np.linalg.lstsq(columns, wrong, rcond=None)
        # What a and s leave, over all turning points: its share tells noise from a wrong motion.
        missed, whole = missed + float(np.sum((wrong - columns @ (a, s)) ** 2)), whole + float(np.sum(wrong**2))
        # A factor of 0 or less is no amplitude.
        if a > -1:
            found.append((time, size, np.log1p(a), s, n))
    if not found:
        return Errors(*np.zeros((4, 0))), np.zeros(0)
    table = np.array(found).T
    tau, size, amplitude, advance, ns = table
    return Errors(tau, size, amplitude, advance, float(np.sqrt(missed / whole)) if whole else 0.0), ns


def _near(tau: Any, time: float) -> Any:
    """The samples around a time: within 0.5, or as far as a quarter-swing if there are too few."""
    for width in _WIDTHS:
        near = np.arange(*np.searchsorted(tau, (time - width, time + width)))
        if len(near) >= _SAMPLES:
            break
    return near
