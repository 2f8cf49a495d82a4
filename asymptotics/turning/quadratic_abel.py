"""The Abel function of quadratic damping (alpha = 2) from its exact rational coefficients: any number of them, fast.

The coefficients of ``quadratic_series`` belong to p = 2|u| = 2 delta; the bound of the defect is that of ``abel``.

>>> from asymptotics.turning.quadratic_map import amplitudes
>>> from itertools import islice
>>> with ctx.workprec(100):
...     head = list(islice(amplitudes(arb(2)), 301))
...     far = 2 * quadratic_abel(terms=8).advance(head[100] / 2, 200)
>>> far.overlaps(head[300]), far.rel_accuracy_bits() > 60
(True, True)
"""

from fractions import Fraction

from flint import arb, fmpq

from asymptotics.numbers.context import ctx, lru_cache
from asymptotics.numbers.exact import ExactReal
from asymptotics.turning.abel import AbelFunction, of_coefficients
from asymptotics.turning.quadratic_series import abel_coefficients, time_coefficients


def quadratic_abel(terms: int) -> AbelFunction:
    """Psi_K and Theta_K in delta for alpha = 2, K = ``terms``, at the current precision."""
    return _quadratic_abel(terms, ctx.prec)


@lru_cache(maxsize=8)
def _quadratic_abel(terms: int, bits: int) -> AbelFunction:
    with ctx.workprec(bits):
        psi = [_in_delta(c, k) for k, c in enumerate(abel_coefficients(terms))]
        theta = [arb.pi() * _in_delta(c, k) for k, c in enumerate(time_coefficients(terms))]
        # No following coefficients: with any number of exact terms at hand Cauchy's inequality may begin at delta^(2K).
        return of_coefficients(ExactReal(Fraction(2)), (psi, theta), ([], []))


def _in_delta(c: fmpq, k: int) -> arb:
    """c p^(2k-1) = (2^(2k-1) c) delta^(2k-1)."""
    return arb(c) * arb(2) ** (2 * k - 1)
