"""When Lancaster's (13) becomes valid, alpha > 1: under strong damping the first swing is a creep, which makes it late.

The creep is told to leading order in 1/epsilon.  How near (13) then is, is measured by the check of
``lancaster2020:claim.valid-for-any-b``.

>>> print(derivation.steps[12].text())
Limit(N*((N/(N - nu))**(1/nu) - 1), N, oo, dir='-') = 1
"""

import sympy
from sympy import Derivative, Integral, Limit, oo

from derivations.steps import At, Derivation, Solution, defined

y, w, e, s, tau, N, D = sympy.symbols("y w epsilon s tau N D", positive=True)
nu, p_1, p_3, T_c = sympy.symbols("nu p_1 p_3 T_c", positive=True)  # nu = alpha - 1
fallen = sympy.Symbol("g", nonnegative=True)  # 1 - X
T = sympy.Symbol("T", real=True)
alpha = 1 + nu

derivation = Derivation(
    "creep-arrival",
    "Strong damping: the creep of the first swing, and when the averaged amplitude becomes right",
    source="Lancaster 2020, below (15): (13) at late times, regardless of b",
)
step, asserts = derivation.step, derivation.asserts

# The creep: X = y falls from 1 at the speed w, w' = y - epsilon w^alpha.
slow = defined("m", lambda y: (y / e) ** (1 / alpha))
step(
    "alpha = 1 + nu, nu > 0.  On the first swing X = y falls from 1: y' = -w, w' = y - epsilon w^alpha.  On the slow"
    " curve w = m(y) friction balances the spring",
    e * slow(y) ** alpha,
    y,
)
asserts(
    "w rises from 0 and cannot pass m(1): there, where X = 1 - g, its rate is -g",
    sympy.Le(At(1 - fallen - e * w**alpha, {w: slow(1)}), 0, evaluate=False),
)
step(
    "so X = 0 is not reached before tau = epsilon^(1/alpha), at any strength: the way at the speed m(1) until then",
    Integral(slow(1), (s, 0, e ** (1 / alpha))),
    1,
)
step(
    "How near is w to m(y)?  On the slow curve m changes at the rate m m'; beside the spring y this is, in the local"
    " strength D = epsilon y^(alpha-1),",
    At(slow(y) * Derivative(slow(y), y) / y, {e: D * y**-nu}),
    D ** (-2 / alpha) / alpha,
)
step(
    "so w = m(y) to leading order while D is large, and the power 1 - 1/alpha of y falls at a constant rate: along"
    " y' = -m(y)",
    Derivative(y ** (1 - 1 / alpha), y) * -slow(y),
    -(1 - 1 / alpha) * e ** (-1 / alpha),
)
arrival = alpha / nu * e ** (1 / alpha)
step(
    "from 1 to 0 in the time T_c = alpha epsilon^(1/alpha)/(alpha-1), the length of the creep",
    Solution(1 - Integral((1 - 1 / alpha) * e ** (-1 / alpha), (s, 0, T)), 0, T),
    arrival,
)
step(
    "of which is left, once D has fallen to order 1 and the mass begins to swing, a time of order 1/(alpha-1):",
    At(arrival * y ** (1 - 1 / alpha), {y: (D / e) ** (1 / nu)}),
    alpha / nu * D ** (1 / alpha),
)

# From there on the averaged law, from a strength D of order 1; (13) is the same law from epsilon at tau = 0.
late = defined("delta", lambda tau: 1 / (1 / D + nu * p_1 * (tau - T_c)))
step(
    "From tau = T_c on delta = epsilon |X|^(alpha-1) of the turning points obeys the averaged law, whose solution is",
    Derivative(late(tau), tau),
    -nu * p_1 * late(tau) ** 2,
)
step("from a D of order 1, whatever epsilon was:", At(late(tau), {tau: T_c}), D)
averaged = defined("delta_13", lambda tau: 1 / (1 / e + nu * p_1 * tau))
step(
    "(13) is A = [1 + (alpha-1) kappa tau]^(-1/(alpha-1)), kappa = p_1 epsilon: the same law from tau = 0,"
    " epsilon A^(alpha-1)",
    e * At(y**nu, {y: (1 + nu * p_1 * e * tau) ** (-1 / nu)}),
    averaged(tau),
)
step(
    "Their inverses grow at the same rate.  |X|^(1-alpha) is that of (13), late by T_c, but for what is of order 1,"
    " here 1/epsilon - 1/D,",
    1 / averaged(tau) - 1 / late(tau),
    nu * p_1 * T_c + 1 / e - 1 / D,
)
quotient = late(tau) / averaged(tau)
step(
    "and (|X|/(13))^(alpha-1) at tau = N T_c/(alpha-1), when T_c is long:",
    Limit(At(quotient, {tau: N * T_c / nu}), T_c, oo),
    N / (N - nu),
)
excess = (N / (N - nu)) ** (1 / nu)
step(
    "so |X|/(13) is 1 + 1/N to leading order, for every alpha > 1:",
    Limit(N * (excess - 1), N, oo),
    1,
    corrects=("lancaster2020:claim.valid-for-any-b",),
)
step("it stays so when alpha tends to 1", Limit(excess, nu, 0, "+"), sympy.exp(1 / N))
step(
    "Without the second factor 1/(alpha-1), at N T_c, (|X|/(13))^(alpha-1) is",
    Limit(At(quotient, {tau: N * T_c}), T_c, oo),
    N / (N - 1),
)
asserts(
    "which is no time for alpha near 1: at alpha = 11/10 and N = 20 |X| is more than 8/5 of (13)",
    sympy.Gt(At((N / (N - 1)) ** (1 / nu), {N: 20, nu: sympy.Rational(1, 10)}), sympy.Rational(8, 5), evaluate=False),
)

# Weak damping has no creep.  What makes (13) late there is the next term of the amplitude equation.
step(
    "For T_c < 1, so epsilon < (nu/alpha)^alpha, there is no creep; the next term of dA/dtau, -p_3 A delta^3, adds to"
    " 1/delta, over all times together,",
    Integral(nu * p_3 * averaged(tau).doit() ** 2, (tau, 0, oo)),
    p_3 / p_1 * e,
)
step(
    "in ln |X| that is, at tau = N/(alpha-1), less than p_3/(N p_1^2) times epsilon/(alpha-1), with the largest"
    " epsilon; and this is of order 1 up to alpha = 1:",
    Limit(At(e / nu, {e: (nu / alpha) ** alpha}), nu, 0, "+"),
    1,
)
step(
    "Strong damping, right after the creep, by the time s: (|X|/(13))^(alpha-1) grows with T_c, so that not only the"
    " phase is wrong; over T_c it tends to",
    Limit(At(quotient, {tau: T_c + s}) / T_c, T_c, oo),
    nu * p_1 / (1 / D + nu * p_1 * s),
    corrects=("lancaster2020:claim.large-b-agreement",),
)
