"""Two systems of units, drawn once: a formula whose value in them differs is dimensionally false, and refuted.

In m = k = x_0 = 1 a factor omega_0^2 x_0^2 is invisible.  So whatever is measured of a form is its value in a unit of
its own kind, at the same dimensionless strength and time, in both systems.

>>> agreed(2.0, 2.0 + 1e-12)
2.0
>>> agreed(2.0, 3.0)
Traceback (most recent call last):
    ...
paper_checks.units.UnitsError: the value depends on the units: 2.0 in one system, 3.0 in another
"""

import random
from typing import Any

import sympy

_DRAWN = random.Random("units of mass, rate, length and gravity")
SYSTEMS = tuple(tuple(sympy.Rational(_DRAWN.randint(7, 40), 11) for _ in range(4)) for _ in range(2))
"""Mass, omega_0, x_0 and g in two systems: rationals between 7/11 and 40/11."""

TOLERANCE = 1e-9


class UnitsError(ValueError):
    """The value of a form depends on the units in which it is computed."""


def agreed(first: Any, second: Any) -> Any:
    """The first of two values that are one number, up to rounding; UnitsError if they are not."""
    if not abs(first - second) <= TOLERANCE * (1 + abs(first)):
        raise UnitsError(f"the value depends on the units: {first} in one system, {second} in another")
    return first
