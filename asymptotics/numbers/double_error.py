"""What a column of doubles is good to: one error of all its values, relative or absolute, as a header has it.

    --double-error=amplitude:3.2e-15:relative    |double - value| <= 3.2e-15 |value|
    --double-error=phase:4.1e-14:absolute        |double - value| <= 4.1e-14 in the unit of the column

It is an estimate by what the computation does (rounding, and interpolation in its tables), not a bound that is proved;
and it is the distance of the doubles from what they stand for, such as an averaged law, not of that from the motion.

>>> error, value = of_column([1.0, 0.25], [3e-15, 1e-15], relative=True), Fraction(1, 4)
>>> error, error.allows(value + Fraction("1e-15"), value), error.allows(value + Fraction("1.1e-15"), value)
(relative 4.2e-15, True, False)
>>> of_column([1.0, 0.0, -0.25], [3e-15, 1e-15, 1e-15])
absolute 3.1e-15
"""

from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import numpy as np

EPS = 2.0**-52
STEP = 2.0**-20
"""The relative step of a difference quotient, which leaves half of the digits of a double."""
# Above it some value is next to a zero, and only the absolute error says something.
_MOST_RELATIVE = 1e-10


@dataclass(frozen=True)
class DoubleError:
    """|double - value| is at most ``size``, times |value| if ``relative``."""

    size: Fraction
    relative: bool

    def allows(self, given: Fraction, value: Fraction) -> bool:
        """Whether a double of this column may be that far from the value."""
        return abs(given - value) <= self.size * (abs(value) if self.relative else 1)

    def __repr__(self) -> str:
        return f"{'relative' if self.relative else 'absolute'} {float(self.size):.1e}"


def of_column(values: Any, errors: Any, *, relative: bool = False) -> DoubleError | None:
    """The error of a column from those of its values, rounded up; None where no finite one is known.

    ``relative``: of values that keep their sign, as far as none is next to 0.  NaN and 0 are passed over: no digits.
    """
    values, errors = np.abs(np.asarray(values, float)), np.asarray(errors, float)
    known = np.isfinite(values) & (values > 0)
    if not known.any() or not np.isfinite(errors[known]).all():
        return None
    share = float(np.max(errors[known] / values[known]))
    if relative and share <= _MOST_RELATIVE:
        return DoubleError(_up(share, EPS), True)
    return DoubleError(_up(float(np.max(errors[known])), EPS * float(np.max(values[known]))), False)


def _up(size: float, least: float) -> Fraction:
    """Two digits, upwards, and not less than the last place of a double."""
    # 5 % are half a unit of the second digit or more.
    return Fraction(f"{max(size, least) * 1.05:.1e}")


def of_rounding(values: Any, earlier: Any, steps: Any) -> Any:
    """The errors of values after ``steps`` roundings, that of the time too; ``earlier`` are they at t (1 - STEP)."""
    with np.errstate(invalid="ignore", over="ignore"):
        return steps * EPS * (np.abs(values) + np.abs(values - earlier) / STEP)
