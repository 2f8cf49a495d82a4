"""How many half-swings lie between extremes that were found, and how many of the first a hand has disturbed.

>>> half_swings_between(np.array([0.0, 1.0, 2.1, 5.0, 6.0])).tolist()
[1.0, 1.0, 3.0, 1.0]
"""

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array

EXACT = 5e-5
"""What the narrowest local fit (``extraction``) leaves without noise, as a share of the amplitude and of 1/omega:
measured with losses of exponents 0 to 3."""


def half_swings_between(t: Array) -> Array:
    """How many half-swings lie between successive extremes: 1, but across a gap as many as its length holds."""
    half = np.diff(t)
    return np.asarray(np.maximum(np.round(half / np.median(half)), 1.0)) if len(half) else half


def start_of_freedom(t: Array) -> int:
    """How many of the first half periods do not lie on the line through the next eight: the hand is still there."""
    # Across an extreme that was not found are two half periods, and the middle of both is half a swing later.
    steps = half_swings_between(t)
    half, middle = np.diff(t) / steps, np.cumsum(steps) - steps / 2
    # The latest of the first three that is disturbed takes those before it along.
    for first in (2, 1, 0):
        following, k = half[first + 1 : first + 9], middle[first + 1 : first + 9]
        if len(following) < 8:
            continue
        line = np.polynomial.Polynomial.fit(k, following, 1)
        # Eight half periods less the two coefficients of the line.
        scatter = float(np.sqrt(np.mean((following - line(k)) ** 2) * 8 / 6))
        # Five of its scatter, extrapolated by one: chance hardly does that, and a hand does; less than what the local
        # fits themselves leave is no hand.
        if abs(half[first] - line(middle[first])) > max(5 * scatter, EXACT * float(np.median(half)) / np.pi):
            return first + 1
    return 0
