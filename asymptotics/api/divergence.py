"""Why the series diverge, in numbers: the Stokes constants of the half-swing.  The half-swing is a parabolic germ;
the two Abel functions on its petals differ by a Fourier series, whose coefficients are these constants (Ecalle).

>>> stokes(2, digits=12).constants
('-0.0909280010378',)
"""

from asymptotics.expansions.divergence.result import MAX_COUNT, MAX_DIGITS, StokesConstants, stokes_constants
from asymptotics.numbers.policy import Number, exact_integer, exact_number, float_notes
from asymptotics.public import public


@public
def stokes(alpha: Number, *, count: int = 1, digits: int = 17, max_seconds: Number = 60) -> StokesConstants:
    """The Stokes constants c_k (amplitude) and d_k (time) of x'|x'|^(alpha-1), k = 1 ... ``count``, certified.

    Phi_+ - Phi_- = sum c_k q^k and theta_+ - theta_- = sum d_k q^k, q = e^(-2 pi i w), for the Abel function Phi of the
    half-swing and its time theta on the two petals: c_1 + d_1/pi and d_1 are in front of the large orders of p_k and
    Omega_k.  ``alpha`` from 0 to 50 other than 1; InputError for what is not, LimitError with the estimate where it
    takes longer than ``max_seconds`` (near alpha = 1), UndecidedError where a bound does not hold.  Sums of laws and
    springs are not treated.  Source: derivation ``abel-petal``.
    """
    number = exact_number(alpha, "alpha")
    n, D = exact_integer(count, "count", 1, MAX_COUNT), exact_integer(digits, "digits", 1, MAX_DIGITS)
    return stokes_constants(number, n, D, tuple(float_notes(alpha=alpha)))
