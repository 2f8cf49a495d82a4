"""What a sensor and its clock add, read off the record itself: the step of its values, the scatter of its time stamps.

>>> t = np.arange(400) * 0.01
>>> sensor_notes(t, np.round(np.cos(t) / 0.02) * 0.02)
['values in steps of 0.02: at least 0.0058 of noise (step/sqrt(12))']
>>> sensor_notes(t + 1e-3 * np.random.default_rng(0).standard_normal(400), np.cos(t))
['time stamps scatter by 10 % of their spacing: taken as they are; an error of the clock would be noise']
"""

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.present.percent import percent

_FEWEST, _SHARE, _WHOLE = 50, 0.5, 1e-3
"""Samples below which nothing is said; a step is seen where less than half of the values differ, for a fine step hides
in the noise; and how far a multiple of it may be from whole, which printing makes of it."""
_EVEN, _UNEVEN, _SAME = 0.01, 0.35, 1e-9
"""A scatter of the stamps below 1 % of their spacing is not worth a sentence, and beyond 35 % the record is simply
uneven; values that differ by less than 1e-9 of their range are one number in other last digits."""


def sensor_notes(t: Array, x: Array) -> list[str]:
    """One sentence for each that is seen; none for a short record."""
    notes: list[str] = []
    if len(t) < _FEWEST:
        return notes
    step = quantum(x)
    # An error spread evenly over a step has this standard deviation (Bennett 1948, Bell Syst. Tech. J. 27, 446-472).
    if step:
        notes.append(f"values in steps of {step:.3g}: at least {step / 12**0.5:.2g} of noise (step/sqrt(12))")
    gaps = np.diff(t)
    usual = float(np.median(gaps))
    # Gaps in the record are no scatter of the clock; where they are more than a tenth nothing is said.
    near = gaps[np.abs(gaps - usual) < usual / 2]
    # A gap is the difference of two stamps, whose errors add in squares.
    scatter = float(near.std()) / np.sqrt(2) / usual if len(near) > 0.9 * len(gaps) and usual > 0 else 0.0
    if _EVEN < scatter < _UNEVEN:
        said = "taken as they are; an error of the clock would be noise"
        notes.append(f"time stamps scatter by {percent(scatter)} of their spacing: {said}")
    return notes


def quantum(x: Array) -> float:
    """The step of which all differences are multiples, where values repeat; 0 where there is none."""
    values = np.unique(x)
    if not 2 < len(values) < _SHARE * len(x):
        return 0.0
    steps = np.diff(values)
    steps = steps[steps > _SAME * float(np.ptp(x))]  # equal numbers may differ in their last digit
    step = float(steps.min())
    multiples = (values - values[0]) / step
    # Printing in decimals spoils a multiple in proportion to its size: a millionth is allowed for.
    return step if np.abs(multiples - np.round(multiples)).max() < _WHOLE * max(1.0, multiples[-1] * 1e-6) else 0.0
