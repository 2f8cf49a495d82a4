"""The classical multiple-scale derivation: every order an object that shows itself.

>>> derivation = multiple_scales(3, order=3)
>>> print(derivation.orders[1])
order 1: X_1(psi) + Derivative(X_1(psi), (psi, 2)) = ...
  D_1 a = f_1 = -3*a**3/8
  D_1 psi = g_1 = 0
  solution: X_1(psi) = a**3*sin(3*psi)/32
>>> multiple_scales("3/2", order=2).phase_rate                  # any exponent, to second order
a*epsilon**2*(-12/(25*pi) + 9*gamma(7/4)**2/(20*pi*gamma(9/4)**2)) + 1
>>> multiple_scales(1, spring={3: 1}).phase_rate                # a Duffing spring: x'' + x + epsilon x' + c x^3 = 0
-15*a**4*c**2/256 + 3*a**2*c/8 - epsilon**2/8 + 1
"""

from dataclasses import replace
from typing import Any

from asymptotics.equations.build import terms_of
from asymptotics.errors import InputError
from asymptotics.half_swings.forces import Forces
from asymptotics.half_swings.fourier_flow import is_smooth
from asymptotics.half_swings.symbolic import alpha
from asymptotics.multiscale.general import SecondOrder, second_order
from asymptotics.multiscale.symbolic import MultipleScales
from asymptotics.multiscale.symbolic import multiple_scales as smooth_multiple_scales
from asymptotics.numbers.bridge import to_sympy
from asymptotics.numbers.policy import exact_integer
from asymptotics.terms import Term

MAX_ORDER = 60


def multiple_scales(law: Any, *, order: Any = 2, spring: Any = None) -> MultipleScales | SecondOrder:
    """The hierarchy T_0, T_1, ... solved: polynomial forces exactly to any order, other exponents to second order.

    ``law``: an exponent, a list of exponents, a law, an oscillator, or "symbolic"; ``spring``: {P: c} or {(P, Q): c}
    for c x|x|^(P-1) |x'|^Q, or "pendulum".  Polynomial are |x|^M x'|x'|^(A-1) with A odd and M even, and springs with
    P odd and Q even; the strengths stay symbols.  InputError for an order above 2 where an exponent is not odd, and
    for a spring or a position-dependent loss in a sum that is no polynomial; LimitError for too much work.
    """
    N = exact_integer(order, "order", 1, MAX_ORDER)
    if isinstance(law, str) and law.strip() == "symbolic":
        if spring is not None:
            raise InputError("spring", "a symbolic exponent stands alone", "one law, in closed form")
        return second_order((alpha,)) if N <= 2 else _no_more(N)
    terms, _, _, notes = terms_of(law, spring)
    if is_smooth(Forces.of(terms, N)):
        return replace(smooth_multiple_scales(terms, N), notes=notes)
    _require_powers(terms)
    if N > 2:
        return _no_more(N)
    return replace(second_order(tuple(to_sympy(t.velocity) for t in terms)), notes=notes)


def _require_powers(terms: tuple[Term, ...]) -> None:
    """InputError by name if a sum that is no polynomial has a spring or a position-dependent loss."""
    for t in terms:
        if not t.is_power_of_velocity:
            whole = " + ".join(other.shape() for other in terms)
            reason = f"{t.shape()} is served among polynomials only, and the sum {whole} is not one"
            accepted = "losses |x|^M x'^A, A odd and M even, and springs x^P x'^Q, P odd and Q even"
            raise InputError("spring" if t.sign > 0 else "law", reason, accepted)


def _no_more(order: int) -> SecondOrder:
    reason = f"{order}: the hierarchy closes in general to second order, to any order for odd exponents"
    raise InputError("order", reason, "1 or 2, or odd exponents")
