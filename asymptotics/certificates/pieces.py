"""A series cut to a piece of a certificate: how long it may be, and its coefficients as integers over 2^bits.

>>> from asymptotics.certificates.series import from_rest
>>> undamped = Equation((), Fraction(1), Fraction(1), Fraction(0))
>>> cosine = from_rest(undamped, arb(1), -1, -1, 8)
>>> round(longest(cosine, -20.0), 3)
0.396
>>> piece("leave", cosine, undamped, Fraction(1, 2), 20)["y"][:3]
[[0, '1048576'], [2, '-131072'], [4, '2731']]
"""

from fractions import Fraction
from math import log2
from typing import Any

from flint import arb

from asymptotics.certificates.equation import Equation
from asymptotics.certificates.series import Powers, PowerSeries
from asymptotics.flow.balls import size_of
from asymptotics.numbers.rationals import to_fmpq

_KEPT = 0.25
"""The least share of the first coefficient of a speed and of its powers that the others may leave: a choice."""


def longest(series: PowerSeries, tolerance: float) -> float:
    """A duration up to which the coefficients left out are at most 2^tolerance, and the speed keeps its sign."""
    s = 8.0
    for p, weight in ((series.y, 2), *((w, 0) for w in (series.v, *series.powers))):
        top = max(p, default=0)
        for n, c in p.items():
            if 8 * n > 7 * top > 0 and c != 0:
                # The last ones: each of these terms, as it enters the residual, is to be within the tolerance.
                size = size_of(c) + weight * log2(n / series.root)
                s = min(s, 2.0 ** ((tolerance - size) * series.root / n))
    while not all(_one_sign(p, series.root, s) for p in (series.v, *filter(None, series.powers))):
        s *= 0.9
    return s


def _one_sign(p: Powers, root: int, s: float) -> bool:
    first, rest = size_of(p[0]), 0.0
    for n, c in p.items():
        if n and c != 0:
            rest += 2.0 ** min(60.0, size_of(c) - first + n / root * log2(s))
    return rest <= 1 - _KEPT


def piece(kind: str, series: PowerSeries, equation: Equation, scale: Fraction, bits: int) -> dict[str, Any]:
    """The piece as the checker reads it."""
    z = arb(to_fmpq(scale)) ** arb(to_fmpq(Fraction(1, series.root)))

    def packed(terms: Powers, shift: int) -> list[list[Any]]:
        # A power w of the speed v, of which |P'| = z^lead v, takes its part z^(lead a) along.
        whole = [(n, nearest(c * z ** (n + shift), bits)) for n, c in sorted(terms.items())]
        return [[n, str(c)] for n, c in whole if c or n == 0]

    powers = [packed(w, int(series.lead * a)) if w else None for (a, _), w in zip(equation.terms, series.powers)]
    return {"kind": kind, "scale": str(scale), "y": packed(series.y, 0), "powers": powers}


def nearest(x: arb, bits: int) -> int:
    """The midpoint of a ball in units of 2^-bits, rounded."""
    mantissa, exponent = x.mid().man_exp()
    shift = int(exponent) + bits
    if shift >= 0:
        return int(mantissa) << shift
    return (int(mantissa) + (1 << -shift - 1)) >> -shift
