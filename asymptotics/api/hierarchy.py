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
>>> multiple_scales(2, spring="pendulum").amplitude_rate        # x in units of theta_0, air: second order
-a**4*epsilon*theta_0**2/(80*pi) - 4*a**2*epsilon/(3*pi)
"""

from dataclasses import replace
from typing import Any

from sympy import Expr

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
    P odd and Q even; the strengths stay symbols.  Sums that are no polynomial: x'|x'|^(A-1), any A, with c x|x|^(P-1)
    or a pendulum.  InputError for an order above 2 of such a sum, and for a position-dependent loss or a
    velocity-dependent spring in it; LimitError for too much work.
    """
    N = exact_integer(order, "order", 1, MAX_ORDER)
    if isinstance(law, str) and law.strip() == "symbolic":
        return symbolic_multiple_scales(() if spring is None else terms_of([], spring)[0], N)
    terms, _, _, notes = terms_of(law, spring)
    if is_smooth(Forces.of(terms, N)):
        return replace(smooth_multiple_scales(terms, N), notes=notes)
    exponents = tuple(to_sympy(t.velocity) for t in terms if t.sign < 0)
    return replace(_second_order(exponents, terms, N), notes=notes)


def symbolic_multiple_scales(springs: tuple[Term, ...], order: int) -> SecondOrder:
    """One loss with a symbolic exponent beside some springs; InputError as for ``multiple_scales``."""
    return _second_order((alpha,), springs, order)


def _second_order(exponents: tuple[Expr, ...], terms: tuple[Term, ...], order: int) -> SecondOrder:
    _require_powers(terms)
    if order > 2:
        reason = f"{order}: the hierarchy closes in general to second order, to any order for polynomial forces"
        raise InputError("order", reason, "1 or 2, or odd exponents")
    return second_order(exponents, tuple(t for t in terms if t.sign > 0))


def _require_powers(terms: tuple[Term, ...]) -> None:
    """InputError by name if a sum that is no polynomial has a force of position and velocity together."""
    for t in terms:
        if t.position if t.sign < 0 else not t.velocity.is_zero:
            whole = " + ".join(other.shape() for other in terms)
            reason = f"{t.shape()} is served among polynomials only, and the sum {whole} is not one"
            accepted = "x'|x'|^(A-1) with x|x|^(P-1); or |x|^M x'^A, A odd, M even, with x^P x'^Q, P odd, Q even"
            raise InputError("spring" if t.sign > 0 else "law", reason, accepted)
