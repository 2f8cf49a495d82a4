"""Springs and losses in closed form: the first order of every force, the second-order term of a loss with a spring.

Means over theta of |c|^a |s|^b are beta functions, <|c|^a |s|^b> = B((a+1)/2, (b+1)/2)/pi.  To first order
d ln r/d theta = -N s and d tau/d theta = 1 + N c (``expansions.half_swings.quarter``), so that

    U_rho = -<|c|^m |s|^(alpha+1)>,     W_gamma = -<|c|^(p+1) |s|^q>.

*The cross term.*  A spring changes the decrement at second order, rho gamma, with rho a loss |x|^m v|v|^(alpha-1) and
gamma a spring c x|x|^(p-1).  Half a swing takes the energy int f dx along the conservative path, v^2 = 2 (V(A) - V(x)),
V = x^2/2 + c |x|^(p+1)/(p+1), from E = V(A).  With x = A cos(theta), v^2 = A^2 s^2 (1 + 2 gamma (1 - |c|^(p+1))/((p+1)
s^2)) + ..., and with (A + c A^p) dA = dE the decrement per unit of psi is, to first order in gamma,

    U_(rho gamma) = <|c|^m s^(alpha+1)> - alpha/(p+1) <|c|^m s^(alpha-1) (1 - |c|^(p+1))>
                  = (p - d)/(p + 1) <|c|^m s^(alpha+1)> + (p + m)/(p + 1) <|c|^(m+p-1) s^(alpha+1)>,     d = m + alpha,

the second line by the recurrence of the beta function.  W has no term rho gamma.

>>> forces = Forces.read([Term(1, "3/2"), Term(1, 0, 3, "position")], 2)
>>> second_order_cross(forces, exact)[1, 1].ball().str(10)
'[0.2478969231 +/- ...]'
"""

from types import ModuleType
from typing import Any

from asymptotics.expansions.half_swings.forces import Forces
from asymptotics.expansions.moments import exact as exact  # for the examples
from asymptotics.series import Key
from asymptotics.terms import Term as Term  # as above


def cross_term(alpha: Any, m: int, p: int, moments: ModuleType) -> Any:
    """U_(rho gamma) of the loss |x|^m v|v|^(alpha-1) and the spring x|x|^(p-1); ``alpha`` may be a symbol.

    >>> [cross_term(exact.number(alpha), 0, 3, exact) for alpha in (1, 2)]
    [11/32, 8/(15*pi)]
    """
    # The second line of the docstring: no negative power of the sine, so that alpha = 0 needs no limit.
    first, second = moments.mean(m, alpha + 1), moments.mean(m + p - 1, alpha + 1)
    return ((p - m - alpha) * first + (p + m) * second) / (p + 1)


def first_order(forces: Forces, moments: ModuleType) -> tuple[dict[Key, Any], dict[Key, Any]]:
    """U and W - 1 at first order, by monomials."""
    U: dict[Key, Any] = {}
    W: dict[Key, Any] = {}
    for f in forces.through(1):
        ratio, v = moments.number(f.ratio), moments.number(f.velocity)
        if f.sign < 0:
            U[f.key] = -ratio * moments.mean(f.position, v + 1)
        else:
            W[f.key] = -ratio * moments.mean(f.position + 1, v)
    return U, W


def second_order_cross(forces: Forces, moments: ModuleType) -> dict[Key, Any]:
    """U at second order: the terms of one loss and one spring that depends on the position alone."""
    losses = [f for f in forces.through(1) if f.sign < 0]
    springs = [f for f in forces.through(1) if f.sign > 0 and f.velocity.is_zero]
    return {
        tuple(a + b for a, b in zip(x.key, y.key)): moments.number(x.ratio * y.ratio)
        * cross_term(moments.number(x.velocity), x.position, y.position, moments)
        for x in losses
        for y in springs
    }


def second_order_p(forces: Forces, moments: ModuleType) -> dict[Key, Any]:
    """The same terms of p = -U/W: p_(rho gamma) = -U_(rho gamma) + U_rho W_gamma.

    >>> second_order_p(Forces.read([Term(1, 1), Term(1, 0, 3, "position")], 2), exact)
    {(1, 1): -5/32}
    """
    U, W = first_order(forces, moments)
    # p = -U/W = -U (1 - (W - 1) + ...): of second order -U_2 + U_1 W_1.
    products = {tuple(a + b for a, b in zip(x, y)): U[x] * W[y] for x in U for y in W}
    return {key: products[key] - u for key, u in second_order_cross(forces, moments).items()}
