"""The classical multiple-scale derivation: every order an object that shows itself.

>>> derivation = multiple_scales(3, order=3)
>>> print(derivation.orders[1])
order 1: X_1(psi) + Derivative(X_1(psi), (psi, 2)) = ...
  D_1 a = f_1 = -3*a**3/8
  D_1 psi = g_1 = 0
  solution: X_1(psi) = a**3*sin(3*psi)/32
>>> multiple_scales("3/2", order=2).phase_rate                  # any exponent, to second order
a*epsilon**2*(-12/(25*pi) + 9*gamma(7/4)**2/(20*pi*gamma(9/4)**2)) + 1
"""

from dataclasses import replace
from typing import Any

from asymptotics.equations.build import terms_of
from asymptotics.errors import InputError
from asymptotics.half_swings.symbolic import alpha
from asymptotics.law import Law
from asymptotics.multiscale.general import SecondOrder, second_order
from asymptotics.multiscale.symbolic import MultipleScales
from asymptotics.multiscale.symbolic import multiple_scales as odd_multiple_scales
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.policy import exact_integer

MAX_ORDER = 60


def multiple_scales(law: Any, *, order: Any = 2) -> MultipleScales | SecondOrder:
    """The hierarchy T_0, T_1, ... solved: odd exponents exactly to any order, every other exponent to second order.

    ``law``: an exponent, a list of exponents, a law, an oscillator, or "symbolic".  InputError for an order above 2
    where an exponent is not odd; LimitError for too much work.
    """
    N = exact_integer(order, "order", 1, MAX_ORDER)
    if isinstance(law, str) and law.strip() == "symbolic":
        return second_order((alpha,)) if N <= 2 else _no_more(N)
    terms, _, _, notes = terms_of(law)
    exponents = Law.from_terms(terms).alphas
    if all(a.is_integer and a.rational % 2 == 1 for a in exponents):
        return replace(odd_multiple_scales(tuple(int(a.rational) for a in exponents), N), notes=notes)
    if N > 2:
        return _no_more(N)
    return replace(second_order(tuple(to_sympy(a) for a in exponents)), notes=notes)


def _no_more(order: int) -> SecondOrder:
    reason = f"{order}: the hierarchy closes in general to second order, to any order for odd exponents"
    raise InputError("order", reason, "1 or 2, or odd exponents")
