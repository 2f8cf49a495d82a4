"""One law with a symbolic exponent: p_1, p_3, Omega_2, Omega_4 in closed form, with one named integral in Omega_4.

    U = -[M_(alpha+1) delta + alpha (3 alpha+1)/(6 (alpha+1)^2) M_(3 alpha+1) delta^3 + ...]
    W = 1 + (alpha/(alpha+1))^2 M_(2 alpha) delta^2 + W_4 delta^4 + ...
    W_4 = alpha^2 (35 alpha^3 + 9 alpha^2 - 17 alpha - 3)/(2 (alpha+1)^4 (2 alpha+1) (3 alpha+1)) M_(4 alpha)
          + 3 (alpha (alpha-1)/(alpha+1))^2 I_4(alpha),

with I_4 of ``half_swings.symbolic`` (defined there, evaluated with certificates, and shown not to reduce to moments).

*The other gauges at second order.*  To first order Z = 1 + delta Z_1 with Z_1' = p_1 - s^(alpha+1) - i c s^alpha on a
half-swing, so Z_1 = p_1 psi - int s^(alpha+1) - i s^(alpha+1)/(alpha+1).  Its real part is odd about psi = pi/2, hence
<Z_1> = -i p_1/(alpha+1); and with <s^(alpha+1) cos 2 psi> = -p_1 (alpha+1)/(alpha+3), by parts,
<Z_1 + conj(Z_1) e^(-2 i psi)> = -i p_1 (alpha+3)/(2 (alpha+1)).  With arg c = chi_1 delta + ..., Omega_2 changes by
D(chi_1 delta) = -(alpha - 1) p_1 chi_1 delta^2:

    averaging:          Omega_2 + (alpha-1)/(alpha+1) p_1^2,
    no-first-harmonic:  Omega_2 + (alpha-1)(alpha+3)/(2 (alpha+1)) p_1^2.

>>> expansion = symbolic_expansion()
>>> [omega.subs(alpha, 3) for omega in (expansion["Omega"][2], omega_2("averaging"), omega_2("no-first-harmonic"))]
[-45/256, -27/256, 9/256]
>>> expansion["p"][3].subs(alpha, 3)
45/4096
"""

from typing import Any

from sympy import Expr

from asymptotics.expansions.half_swings.symbolic import I_4, alpha
from asymptotics.expansions.moments.symbolic import moment
from asymptotics.expansions.normal_form import in_moments
from asymptotics.expansions.normal_form.in_moments import Moment, flow_through_third_order, rates
from asymptotics.gauges import TURNING_POINT


def symbolic_expansion() -> dict[str, dict[int, Expr]]:
    """p_1, p_3, Omega_2, Omega_4, and U, W, for symbolic alpha, turning-point gauge; Omega_4 contains ``I_4(alpha)``.

    U and W are assembled from the closed forms of the module docstring; the tests derive
    them from the equation of motion, for the whole field and not at single exponents.
    """
    U, W = flow_through_fourth_order(alpha, moment, I_4(alpha))
    p, Omega = rates(U, W)
    return {"U": U, "W": W, "p": p, "Omega": Omega}


def flow_through_fourth_order(a: Any, moment: Moment, I4: Any) -> tuple[dict[int, Any], dict[int, Any]]:
    """U_1, U_3 and W_2, W_4 of the module docstring, in expressions or in balls."""
    U, W = flow_through_third_order(a, moment)
    W_4 = a**2 * (35 * a**3 + 9 * a**2 - 17 * a - 3) / (2 * (a + 1) ** 4 * (2 * a + 1) * (3 * a + 1)) * moment(4 * a)
    return U, {**W, 4: W_4 + 3 * (a * (a - 1) / (a + 1)) ** 2 * I4}


def omega_2(gauge: str = TURNING_POINT) -> Expr:
    """Omega_2 for symbolic alpha in any of the three gauges (module docstring)."""
    return in_moments.omega_2(alpha, moment, gauge)
