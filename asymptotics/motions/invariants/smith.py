"""Smith's machinery for quadratic damping, by the names of the paper.

>>> f(3)                                                   # f_3(w) = sum_i C_i^3 w^i
{0: Fraction(-1, 3), 2: Fraction(8, 15)}
>>> C(31, 10)
Fraction(2010398511427223552, 37418691427425)
>>> G(1).in_z()
2*z**2/(3*z**2 + 3)
"""

from fractions import Fraction

from asymptotics.motions.invariants.exact import coefficient, coefficients
from asymptotics.motions.invariants.symbolic import GeneratingFunction, generating_function
from asymptotics.numbers.policy import Number, exact_integer
from asymptotics.running.public import public

# Sizes of answers that still come at once and can be read; they refuse, and nothing that is answered rests on them.
MAX_ROW, MAX_N, MAX_G = 5_000, 10_000, 100


@public
def f(n: int, *, max_seconds: Number = 60) -> dict[int, Fraction]:
    """Smith's polynomial f_n(w) = sum_i C_i^n w^i, exactly (Smith 2012, (59) and (62)).

    Parameters
    ----------
    n
        its index, an integer >= 1
    max_seconds
        the time the call may take, in s

    Returns
    -------
    dict
        i -> C_i^n, where it is not 0

    Examples
    --------
    >>> f(3)
    {0: Fraction(-1, 3), 2: Fraction(8, 15)}
    """
    return dict(coefficients(exact_integer(n, "n", 1, MAX_ROW)))


@public
def C(n: int, i: int, *, max_seconds: Number = 60) -> Fraction:
    """Smith's coefficient C_i^n of w^i in f_n(w), exactly (Smith 2012, (62)).

    Parameters
    ----------
    n
        the index of the polynomial, an integer >= 1
    i
        the power of w, an integer from 0 to n - 1
    max_seconds
        the time the call may take, in s

    Returns
    -------
    Fraction
        the coefficient

    Examples
    --------
    >>> C(3, 2)
    Fraction(8, 15)
    """
    row = exact_integer(n, "n", 1, MAX_N)
    return coefficient(row, exact_integer(i, "i", 0, row - 1))


@public
def G(i: int, *, max_seconds: Number = 60) -> GeneratingFunction:
    """The sum G_i(z) = sum_n C_i^n z^n in closed form, for any i.  Source: derivation ``smith-generating-functions``.

    Parameters
    ----------
    i
        the power of w, an integer >= 0
    max_seconds
        the time the call may take, in s

    Returns
    -------
    GeneratingFunction
        ``in_z()`` and ``in_angle()`` as SymPy expressions

    Examples
    --------
    >>> print(G(0).in_z())
    atan(z)
    """
    return generating_function(exact_integer(i, "i", 0, MAX_G))
