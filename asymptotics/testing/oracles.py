"""Certified answers beside the caller's own: turning points, motion, and the coefficients of an expansion: an oracle of
which every digit is proved, where a second program would only agree or not.

Each check takes a function of the caller, asks the certified routes of this package for the same thing and compares.
What is not certified is never used as an oracle: UndecidedError says so.
"""

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from typing import Any

from asymptotics.errors import InputError, UndecidedError
from asymptotics.expansions.normal_form.coefficients import expansion_coefficients
from asymptotics.gauges import TURNING_POINT
from asymptotics.law import Law, Oscillator
from asymptotics.motions.reference import reference_motion
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.running.public import public
from asymptotics.testing.assertions import assert_digits, exactly
from asymptotics.turning.choose import turning_points

# The certified value is rounded to six digits more, so that its own rounding moves a comparison by 10^-6 of what is
# compared.
GUARD = 6
"""Digits that the certified value has beyond those that are compared."""


@public
def check_turning_points(
    mine: Callable[[Law, int], Sequence[Any]],
    law: Law | Mapping[Any, Any],
    count: int = 10,
    digits: int = 8,
    *,
    max_seconds: Number = 60,
) -> None:
    """``mine(law, count)`` returns x_0 = 1, x_1, ... with their signs, right to ``digits`` digits.

    A motion that ends early (sticks, creeps) must give as many points as there are.  AssertionError names the first bad
    point, its right digits and the certified value.
    """
    law = Law.read(law)
    truth = turning_points(law, count, digits + GUARD)
    if not truth.certified:
        raise UndecidedError(f"no certified turning points of {law}: {truth.method}")
    found = list(mine(law, count))
    if len(found) != len(truth.points):
        why = f"ended: {truth.ended}" if truth.ended else "as many as were asked for"
        raise AssertionError(f"{len(found)} turning points, there are {len(truth.points)} ({why})")
    for value, point in zip(found, truth.points):
        assert_digits(value, point.x, digits, f"turning point {point.n}")


@public
def check_motion(
    mine: Callable[[Oscillator, Sequence[Fraction]], Sequence[Any]],
    oscillator: Oscillator,
    times: Sequence[Number],
    digits: int = 8,
    *,
    max_seconds: Number = 60,
) -> None:
    """``mine(oscillator, times)`` returns x in m, wrong by at most 10^-digits of the oscillator's unit of length.

    The times are handed over as exact fractions of a second.  (Relative digits of x mean nothing near its zeros.)
    """
    moments = [exact_number(t, "times").rational for t in times]
    found = list(mine(oscillator, moments))
    if len(found) != len(moments):
        raise AssertionError(f"{len(found)} values for {len(moments)} times")
    # The scale of an absolute error: its own twenty digits, or fifteen of a double, are far more than it takes.
    length = Fraction(oscillator.length().mid().str(20, radius=False))
    for value, moment in zip(found, moments):
        truth = reference_motion(oscillator, moment, digits + GUARD)
        if not truth.certified:
            raise UndecidedError(f"no certified motion of {oscillator}: {truth.method}")
        error = abs(_fraction(value) - exactly(truth.x)) / length
        if error > Fraction(1, 10**digits):
            raise AssertionError(f"x({moment} s) = {value} is wrong by {float(error):.1e} of x0, certified: {truth.x}")


@public
def check_coefficients(
    mine: Mapping[str, Any],
    exponents: Sequence[Number],
    order: int,
    gauge: str = TURNING_POINT,
    digits: int = 10,
    *,
    max_seconds: Number = 60,
) -> None:
    """Coefficients of one's own expansion: keys "p_1", "Omega_2" (sums "p_1,0", ...), in the gauge that is named.

    AssertionError for one that is wrong and for one that is missing; a coefficient that vanishes must be 0.
    """
    alphas = [exact_number(a, "exponents") for a in exponents]
    truth = expansion_coefficients(alphas, order, digits + GUARD, gauge)
    rows = {"p": truth.amplitude, "Omega": truth.frequency}
    for name, row in rows.items():
        for key, c in row.items():
            label = f"{name}_{key}"
            if c.value is None:
                raise UndecidedError(f"{label} has no certified digits")
            if label not in mine:
                # One that vanishes by theorem may be left out: half of all coefficients do.
                if c.value != "0":
                    raise AssertionError(f"{label} is missing: {c.value} in the gauge {gauge}")
                continue
            assert_digits(mine[label], c.value, digits, f"{label} in the gauge {gauge}")


def _fraction(value: Any) -> Fraction:
    try:
        return exactly(value)
    except ValueError:
        raise InputError("mine", f"{value!r} is not a finite number", "floats, text, fractions") from None
