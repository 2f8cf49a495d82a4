"""A and phi of order N at a time, explicit in the slow time: one law from rest; formal, nothing is certified.

>>> from asymptotics.curves.slow_series import envelope_series
>>> air = Oscillator({2: "1/10"}, mass=2, stiffness=8, x0=3)
>>> amplitude_and_phase(envelope_series(ExactReal(2), 3), air, ExactReal(7), 12)
('1.58613883660', '-0.0277591588534')
"""

from math import inf

import mpmath
import numpy as np
import sympy

from asymptotics.curves.slow_series import EnvelopeSeries
from asymptotics.envelopes.slow_time import D, epsilon
from asymptotics.envelopes.symbolic import tau
from asymptotics.errors import InputError
from asymptotics.expansions.moments.symbolic import moment
from asymptotics.law import Oscillator
from asymptotics.numbers.bridge import from_sympy, to_sympy
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimal_context import workdps
from asymptotics.numbers.exact import ExactReal
from asymptotics.terms import Term

_REAL = 1e-9  # a root of doubles is taken for real; a pair that is nearly double may be missed, and A touches 0 there


def acting_term(oscillator: Oscillator) -> Term:
    """The one term whose strength is not 0, without units; InputError where there is none, or more than one."""
    terms = [t for t in oscillator.dimensionless.terms if not t.strength.is_zero]
    if len(terms) != 1:
        raise InputError("law", f"{len(terms)} laws have no single strength delta", "one law")
    return terms[0]


def require_rest(oscillator: Oscillator) -> None:
    """InputError for a start in motion, which the series do not know."""
    if not oscillator.v0.is_zero:
        raise InputError("order", "it starts at rest", "v0 = 0; for another start the motion of that order")


def amplitude_and_phase(
    series: EnvelopeSeries, oscillator: Oscillator, time: ExactReal, digits: int
) -> tuple[str, str]:
    """A and phi at ``time`` in the units of the oscillator, to ``digits`` digits of the truncated formulas.

    InputError for a start in motion, and from the extinction of the truncated series on.
    """
    require_rest(oscillator)
    A, phi = series.explicit
    # Four bits a digit are more than log2(10), and 128 bits are thirty digits more with room: the decimals handed to
    # SymPy are right to their last digit but the formula is truncated, so that nothing here is certified.
    with ctx.workprec(4 * digits + 128):
        strength = acting_term(oscillator).strength.ball()
        values = {tau: (time.ball() * oscillator.omega_0()).mid(), epsilon: strength.mid()}
        numbers = {s: sympy.Float(v.str(digits + 30, radius=False), digits + 30) for s, v in values.items()}
        length = sympy.Float(oscillator.length().mid().str(digits + 30, radius=False), digits + 30)
    _require_before_extinction(series, numbers)
    # From rest on the other side phi is half a turn later.
    first = sympy.pi if oscillator.x0 < 0 else sympy.Integer(0)
    return _decimal(length * A.subs(numbers), digits), _decimal(first + phi.subs(numbers), digits)


def _decimal(form: sympy.Expr, digits: int) -> str:
    # Ten digits more than are shown; SymPy raises its own precision where terms cancel.  A number of mpmath is rounded
    # to the precision in force, which is that of a double outside.
    value = sympy.N(form, digits + 10)
    with workdps(digits + 10):
        return mpmath.nstr(mpmath.mpf(value), digits, strip_zeros=False) if value else "0"


def _require_before_extinction(series: EnvelopeSeries, numbers: dict[sympy.Symbol, sympy.Float]) -> None:
    end = end_of_series(series, ExactReal(from_sympy(sympy.Rational(numbers[epsilon]))))
    if not float(numbers[tau]) < end:
        raise InputError("time", f"the averaged amplitude is extinct from tau = {end:.6g} on", "an earlier time")


def end_of_series(series: EnvelopeSeries, strength: ExactReal) -> float:
    """tau where the truncated amplitude, explicit in the slow time, first vanishes; infinity for alpha >= 1; a double.

    >>> from asymptotics.curves.slow_series import envelope_series
    >>> from fractions import Fraction
    >>> round(end_of_series(envelope_series(ExactReal(0), 3), ExactReal(Fraction(1, 50))), 6)
    78.539816
    """
    if not series.alpha < 1:
        return inf
    # A = A_0 (a polynomial in D), and D = 1/(1 + (alpha-1) p_1 epsilon tau) grows from 1 to infinity, where A_0 is 0;
    # beyond, its powers are complex.
    exponent, size = to_sympy(series.alpha), float(strength.ball().mid())
    polynomial = sympy.Poly(series.relative.subs(epsilon, size), D)
    roots = np.roots([float(c) for c in polynomial.all_coeffs()])
    first = min((float(r.real) for r in roots if abs(r.imag) <= _REAL * abs(r) and r.real > 1), default=inf)
    return (1 - 1 / first) / float((1 - exponent) * moment(exponent + 1) * size)
