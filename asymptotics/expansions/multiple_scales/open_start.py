"""a(0) and phi(0) for any start where waveforms are no polynomials: closed through order 2 of one law, 1 of a sum.

A start X(0) = r cos theta, X'(0) = -r sin theta lies on X - i X' = a e^(i psi) (1 + sum_k delta^k (u_k - i w_k)), where
X_k = a^.. (cos psi u_k + sin psi w_k) is how variation of constants finds X_k (``open_orders``): with s = sin psi, c =
cos psi and u = int_0^psi (M_(alpha+1) - sin^(alpha+1)),

    u_1 = u,      w_1 = s^(alpha+1)/(alpha+1),      u_2 = (alpha/2)(u^2 + w_1^2),      w_2 = w of ``open_orders``.

Both lines of ln(a Z) = ln r + i (theta - psi), expanded about theta and rho = epsilon r^(alpha-1), give

    ln(a(0)/r)     = -rho u_1 + rho^2 [(u_1^2 - w_1^2)/2 - u_2 + (alpha-1) u_1^2 - w_1 u_1'],
    psi(0) - theta =  rho w_1 + rho^2 [w_2 - u_1 w_1 - (alpha-1) u_1 w_1 + w_1 w_1'],

at psi = theta.  The third order needs X_3, which is an open integral.

>>> from sympy import Rational
>>> size, turn = start_of_open((Rational(3, 2),), 1)
>>> turn
(2*sin(theta)**(5/2)/5,)
"""

from sympy import Expr, Symbol, cos, sin

from asymptotics.errors import InputError
from asymptotics.expansions.moments.symbolic import moment
from asymptotics.expansions.multiple_scales.open_orders import lag, second_turn

theta = Symbol("theta", real=True)
Parts = tuple[Expr, ...]


def start_of_open(alphas: tuple[Expr, ...], order: int) -> tuple[Parts, Parts]:
    """The coefficients of rho_i (one for each law), and of rho^2 (one law), of a(0)/r and of psi(0) - theta.

    InputError beyond the order that closes, with what is accepted.
    """
    last = 2 if len(alphas) == 1 else 1
    if order > last:
        accepted = f"1 to {last} for these exponents; integer exponents; a start in numbers (solution, --v0) to 12"
        raise InputError("order", f"{order}: a(0) and psi(0) are open integrals of theta there", accepted)
    sizes: list[Expr] = [-lag(alpha, theta) for alpha in alphas]
    turns: list[Expr] = [sin(theta) ** (alpha + 1) / (alpha + 1) for alpha in alphas]
    if order == 2:
        (alpha,), (u,), (w,) = alphas, (-size for size in sizes), turns
        slope, bend = moment(alpha + 1) - sin(theta) ** (alpha + 1), sin(theta) ** alpha * cos(theta)
        second = alpha / 2 * (u**2 + w**2)
        log_size = (u**2 - w**2) / 2 - second + (alpha - 1) * u**2 - w * slope
        # From the logarithm to a(0)/r itself: half the square of the first order, -u.
        sizes.append(log_size + u**2 / 2)
        # -u w - (alpha - 1) u w = -alpha u w, and w' = sin^alpha cos.
        turns.append(second_turn(alpha, theta) - alpha * u * w + w * bend)
    return tuple(sizes), tuple(turns)
