"""Large orders of the normal form of one law: factorial divergence as a theorem, where to stop, and Borel-Pade.

A map that is not a flow has a divergent formal flow.  With c, c_1, d_1, e_1 of ``divergence`` and f = 4 pi^2 e_1 c the
laws are proved (derivation ``large-orders``), each with a factor 1 + f/n + O(n^-2), n! being the factorial:

    V_k     = -(-1)^(k/2)     (2 c_1/(pi c))     (k-3)!/(2 pi c)^(k-2),     k even,
    p_k/p_1 = -(-1)^((k-1)/2) 2 (c_1 + d_1/pi)   (k-2)!/(2 pi c)^(k-1),     k odd,
    Omega_k = -(-1)^(k/2)     (2 d_1/pi)         (k-1)!/(2 pi c)^k,         k even,

so V_(k+2)/V_k -> -(k-1)(k-2) (|alpha - 1| p_1/2)^2, 2 pi |c| = 2/(|alpha - 1| p_1), unless the constant vanishes.  The
O(n^-2) goes on as a series (``divergence.rows``); the place of the smallest term, near k* = 2 pi |c|/delta, and
Borel-Pade are heuristic.

At alpha = 0 and alpha = 1 the series of U and W end or converge, and nothing here applies.

>>> from asymptotics.normal_form.expansion import exact_expansion
>>> expansion = exact_expansion((3,), 31)
>>> [(k, round(ratio, 3)) for k, ratio in growth_ratios(expansion)][-3:]
[(26, 0.883), (28, 0.892), (30, 0.899)]
>>> stop = optimal_truncation(expansion, 0.2)
>>> stop.predicted_index, stop.smallest_term_index
(13, 16)
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import exp
from typing import Any

import mpmath
from flint import arb

from asymptotics.errors import InputError, LimitError
from asymptotics.half_swings.pi_ring import PiNumber
from asymptotics.normal_form.expansion import Expansion
from asymptotics.numbers.bridge import bounds
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimal_context import workdps
from asymptotics.series import Series

LABEL = "heuristic"


@dataclass(frozen=True)
class Truncation:
    """Where to stop the series of V at a given delta, and how large the error then is, by prediction and by the terms.

    ``smallest_term`` is the size of the first omitted term when the sum ends before ``smallest_term_index``; if that
    index is the last one known, more orders would still help.  ``status`` is always "heuristic".
    """

    delta: float
    predicted_index: int
    predicted_error: float
    smallest_term_index: int
    smallest_term: float
    status: str = LABEL


def large_order(
    k: int, row: str, c: mpmath.mpf, f: mpmath.mpf, c_1: mpmath.mpf, d_1: mpmath.mpf, further: Sequence[mpmath.mpf] = ()
) -> mpmath.mpf:
    """The proved law of ``row`` "V", "p" (over p_1) or "Omega" at k with its first correction; 0 where k has no term.

    ``further``: g_2, g_3, … of ``divergence.rows.corrections``, each of which takes a power of k from what is left.

    >>> c, f, d_1 = map(mpmath.mpf, ("0.75", "3.948", "0.4125"))
    >>> print(mpmath.nstr(large_order(40, "Omega", c, f, mpmath.mpf(0), d_1), 6))
    -6.93621e+18
    """
    size, n, power, odd = {
        "V": (2 * c_1 / (mpmath.pi * c), k - 3, k - 2, 0),
        "p": (2 * (c_1 + d_1 / mpmath.pi), k - 2, k - 1, 1),
        "Omega": (2 * d_1 / mpmath.pi, k - 1, k, 0),
    }[row]
    if n < 1 or k % 2 != odd:
        return mpmath.mpf(0)
    factor = 1 + sum(g / mpmath.ff(n, j) for j, g in enumerate((f, *further), 1))
    return -((-1) ** (k // 2)) * size * mpmath.factorial(n) / (2 * mpmath.pi * c) ** power * factor


def slope(expansion: Expansion) -> float:
    """|alpha - 1| p_1/2, the growth rate of the coefficients; InputError for sums of laws and for alpha = 0, 1."""
    if len(expansion.degrees) != 1:
        raise InputError("law", "large orders are known for one law only", "one law")
    alpha, p_1 = _float(expansion.degrees[0]), _float(expansion.p[1])
    if alpha in (0.0, 1.0):
        raise InputError("alpha", f"at alpha = {alpha:.0f} the series does not diverge", "alpha > 0 other than 1")
    return abs(alpha - 1) * p_1 / 2


def growth_ratios(expansion: Expansion) -> list[tuple[int, float]]:
    """(k, V_(k+2)/V_k divided by the predicted -k^2 (|alpha - 1| p_1/2)^2), for even k; tends to 1 like 1 - 3/k."""
    rate = slope(expansion)
    V = _mpf_coefficients(expansion.turning_point_flow().U)  # V_k = (alpha - 1) U_(k-1)
    return [(k, float(V[k + 1] / V[k - 1] / (-((k * rate) ** 2)))) for k in range(2, len(V) - 1, 2)]


def optimal_truncation(expansion: Expansion, delta: float) -> Truncation:
    """The predicted k* = 2/(|alpha - 1| p_1 delta) beside the smallest term of V actually found."""
    star = 1 / (slope(expansion) * delta)
    U = _mpf_coefficients(expansion.turning_point_flow().U)
    alpha = _float(expansion.degrees[0])
    terms = {k + 1: abs(float((alpha - 1) * u * mpmath.mpf(delta) ** (k + 1))) for k, u in enumerate(U) if u}
    index = min(terms, key=lambda k: terms[k])
    return Truncation(delta, round(star), exp(-star), index, terms[index])


def borel_pade(series: Series, delta: float, digits: int = 20) -> str:
    """Heuristic Borel-Pade sum of a one-law series in delta^2 steps: int_0^oo e^(-t) Pade[sum_n c_n (t delta)^n/n!] dt.

    The diagonal Pade approximant of the Borel transform continues it past its singularities on the imaginary axis; no
    error bound is known.  Returns a decimal string of ``digits`` digits, none of them certified.  LimitError where the
    order is too high for the digits.

    >>> from asymptotics.normal_form.expansion import exact_expansion
    >>> U = exact_expansion((2,), 25).flow.U
    >>> borel_pade(U, 0.1, 10)
    '-0.04251686509'
    """
    coefficients = _mpf_coefficients(series)
    lead = next((n for n, c in enumerate(coefficients) if c), 0)
    steps = coefficients[lead::2]
    with workdps(4 * digits):
        borel = [c * mpmath.mpf(delta) ** (lead + 2 * i) / mpmath.factorial(lead + 2 * i) for i, c in enumerate(steps)]
        half = (len(borel) - 1) // 2
        try:
            top, bottom = mpmath.pade(borel, half, half)
        except ZeroDivisionError as singular:
            reason = f"{series.order}: the Pade equations are singular to {4 * digits} digits"
            raise LimitError("order", reason, "fewer orders, or more digits") from singular

        def integrand(t: mpmath.mpf) -> mpmath.mpf:
            square = t * t
            value = mpmath.polyval(top[::-1], square) / mpmath.polyval(bottom[::-1], square)
            return mpmath.exp(-t) * t**lead * value

        return str(mpmath.nstr(mpmath.quad(integrand, [0, 1, 2, 5, 10, 20, 50, 100, 200]), digits))


def _mpf_coefficients(series: Series) -> list[mpmath.mpf]:
    """Midpoints of the coefficients in one variable: from here on nothing is claimed."""
    with workdps(60), ctx.workprec(220):
        return [_mpf(series[n]) for n in range(series.order + 1)]


def _mpf(c: Any) -> mpmath.mpf:
    low, high = bounds(c.ball() if isinstance(c, PiNumber) else arb(c))
    middle = (low + high) / 2
    return mpmath.mpf(middle.numerator) / middle.denominator


def _float(c: Any) -> float:
    return float(_mpf(c))
