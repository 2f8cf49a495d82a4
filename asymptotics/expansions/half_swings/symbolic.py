"""One law with a symbolic exponent: the half-swing through fourth order in moments and one nested integral.

Start at the equilibrium passage theta = pi/2 with r = 1, rho = q, and write a = alpha - 1, S(theta) = int_(pi/2)^theta
s^(alpha+1), b = 1/(2 alpha + 2).  Order by order d ln r/d theta = -sum_k rho^k s^(k alpha+1) c^(k-1) gives

    ln r = -q S + q^2 (a S^2/2 + b (1 - s^(2 alpha+2))) + q^3 (...),

and every product of a power of s, an odd power of c and S is integrated by parts.  Backwards to the turning point
theta = 0, ln r = lambda(q) and the elapsed time is t(q).  By the reversal identity the next turning point has
lambda(-q) and t(-q), so L = lambda(-q) - lambda(q), T = t(q) + t(-q), delta = q exp(a lambda(q)): the odd part of
lambda and the even part of t only.  In t_4 the integral of s^(2 alpha) S^2 remains, in the normal form as

    I_4(alpha) = <s^(2 alpha) (S^2 - pi^2 M_(alpha+1)^2/12)>,    S = int_(pi/2)^theta s^(alpha+1),

the mean over 0 < theta < pi.  (pi^2 M^2/12 is the mean of (M (theta - pi/2))^2, the secular part of S^2.)

*Does I_4 reduce?*  Not to the products of moments that stand beside it in t_4, with coefficients rational in alpha
(derivation ``nested-integral``; other polynomials in moments are not excluded).  Write J = <s^(2 alpha) S^2>; suppose
J = r_1 pi^2 M_(alpha+1)^2 M_(2 alpha) + r_2 M_(4 alpha) + r_3 M_(alpha+1) M_(3 alpha+1) with r_i in Q(alpha).

* alpha an odd integer: S = M_(alpha+1) (theta - pi/2) + trigonometric polynomial, all M involved are rational, and J =
  pi^2 M^2 M_(2 alpha)/12 + rational (the term linear in theta - pi/2 leaves a rational mean, the theta^2 term of the
  oscillating part of s^(2 alpha) too).  pi^2 is irrational, so r_1 = 1/12 at all large odd integers.
* 2 alpha an odd integer: int s^(2 alpha) is an odd polynomial in c, and by parts J = pi^2 M_(alpha+1)^2 M_(2 alpha)/4 +
  rational * M_(4 alpha).  Here M_(4 alpha) is rational, M_(alpha+1) M_(3 alpha+1) is rational/pi, and the other product
  is a rational multiple of Gamma(1/4)^4/pi^2 or of its inverse; pi and Gamma(1/4) are algebraically independent
  (Chudnovsky), so r_1 = 1/4 at all large half-integers.

A rational function cannot do both.  So I_4 has a closed form in moments at every integer and half-integer alpha, and
none of this kind holds for all alpha.  At another exponent nothing is proved; an integer-relation search with 105
digits at alpha = 1/4, 2/3, 4/3 finds none below 10^12 (evidence, not proof).  Whether a generalised hypergeometric
value counts as closed is a matter of taste: it is evaluated here with certificates instead.

>>> half = symbolic_half_swing()
>>> half.L[1], half.T[2]
(-sqrt(pi)*gamma(alpha/2 + 1)/gamma(alpha/2 + 3/2), ...)
>>> nested_integral(arb(0)).str(12)                 # alpha = 0: S = -c, <c^2> - 1/3 = 1/6
'[0.166666666667 +/- ...]'
>>> nested_integral_exact(0), nested_integral_exact(2), nested_integral_exact(3)
(1/6, ...)
"""

from math import ceil
from typing import Any

from flint import arb, fmpq
from sympy import QQ, Expr, Function, Integral, Symbol, pi, sin
from sympy.polys.fields import field

from asymptotics.errors import InputError
from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.expansions.half_swings.pi_ring import PI, PiNumber
from asymptotics.expansions.half_swings.quarter import HalfSwing
from asymptotics.expansions.half_swings.theta_algebra import sine_power
from asymptotics.expansions.moments.certified import moment as moment_ball
from asymptotics.expansions.moments.symbolic import moment
from asymptotics.numbers.context import cache, ctx
from asymptotics.series import Series

alpha = Symbol("alpha", nonnegative=True)
I_4 = Function("I_4", real=True)
ORDER = 4

# Q(alpha)(pi, M_(alpha+1), M_(2 alpha), M_(3 alpha+1), M_(4 alpha), J), with J = <s^(2 alpha) S^2>
FIELD, _alpha, _pi, _M, _M2, _M3, _M4, _J = field("alpha,pi,M,M2,M3,M4,J", QQ)
_GRADING = Grading.of((_alpha,))


def nested_integral_definition() -> Expr:
    """I_4(alpha) as the SymPy integral that defines it (unevaluated)."""
    theta, u = Symbol("theta"), Symbol("u")
    S = Integral(sin(u) ** (alpha + 1), (u, pi / 2, theta))
    return Integral(sin(theta) ** (2 * alpha) * (S**2 - pi**2 * moment(alpha + 1) ** 2 / 12), (theta, 0, pi)) / pi


def to_expression(element: Any) -> Expr:
    """An element of FIELD as a SymPy expression in alpha, with Gamma quotients and the named integral I_4(alpha)."""
    names = {str(s): s for s in FIELD.symbols}
    J = I_4(alpha) + pi**2 * moment(alpha + 1) ** 2 * moment(2 * alpha) / 12
    values = {
        names["alpha"]: alpha,
        names["pi"]: pi,
        names["M"]: moment(alpha + 1),
        names["M2"]: moment(2 * alpha),
        names["M3"]: moment(3 * alpha + 1),
        names["M4"]: moment(4 * alpha),
        names["J"]: J,
    }
    return element.as_expr().subs(values, simultaneous=True)


def symbolic_half_swing() -> HalfSwing:
    """L, F, T through fourth order as SymPy expressions in ``alpha``; T_4 contains ``I_4(alpha)``."""
    half = field_half_swing()
    L, T, *F = (s.map(lambda x: to_expression(x * FIELD.one)) for s in (half.L, half.T, *half.F))
    return HalfSwing(Grading.of((alpha,)), L, tuple(F), T)


@cache
def field_half_swing() -> HalfSwing:
    """L, F, T through fourth order with coefficients in FIELD: pi, the moments and J as independent generators."""
    minus_lambda = Series({(n,): -x for n, x in _lambda().items()}, 1, ORDER)
    log_mid = minus_lambda  # ln(q/delta)/a as a series in delta: its fixed point gains one order a pass
    for _ in range(ORDER):
        # From delta, which is known, to q at the passage: delta = q e^(a lambda(q)) solved for q.
        log_mid = minus_lambda.compose(_GRADING.strengths(log_mid))
    q = _GRADING.strengths(log_mid)
    odd = Series({(n,): -2 * x for n, x in _lambda().items() if n % 2}, 1, ORDER)
    even = Series({(0,): _pi, (2,): 2 * _t_2(), (4,): 2 * _t_4()}, 1, ORDER)
    L, T = odd.compose(q), even.compose(q)
    return HalfSwing(_GRADING, L, _GRADING.strengths(L), T)


def _lambda() -> dict[int, Any]:
    """lambda_1, lambda_2, lambda_3: ln r at the turning point before the passage with rho = q, by powers of q.

    With m = pi M_(alpha+1)/2 = -S(0): lambda_1 = m, lambda_2 = a m^2/2 + b,
    lambda_3 = a^2 m^3/3 + a b m + (pi/2) (M_(3 alpha+1) - (1 - a b) M_(3 alpha+3)).
    """
    a, b, m = _alpha - 1, 1 / (2 * (_alpha + 1)), _pi * _M / 2
    M_33 = _M3 * (3 * _alpha + 2) / (3 * _alpha + 3)
    third = a**2 * m**3 / 3 + a * b * m + _pi / 2 * (_M3 - (1 - a * b) * M_33)
    return {1: m, 2: a * m**2 / 2 + b, 3: third}


def _t_2() -> Any:
    """(pi/2) [a/(alpha+1) M_(2 alpha+2) + M_(2 alpha) - M_(2 alpha+2)]."""
    M_22 = _M2 * (2 * _alpha + 1) / (2 * _alpha + 2)
    return _pi / 2 * ((_alpha - 1) / (_alpha + 1) * M_22 + _M2 - M_22)


def _t_4() -> Any:
    """The coefficient of q^4 in the duration of the quarter: the integral over 0 < theta < pi/2 of

    s^alpha c f + s^(2 alpha) c^2 (2 a l_2 + 2 a^2 l_1^2) + 3 a s^(3 alpha) c^3 l_1 + s^(4 alpha) c^4,
    f = a l_3 + a^2 l_1 l_2 + a^3 l_1^3/6,   l_n = coefficient of q^n in ln r.

    The first term is -1/(alpha+1) int s^(alpha+1) f' with
    f' = -3 a^3 s^(alpha+1) S^2 - 2 a^2 b s^(alpha+1) (1 - s^(2 alpha+2)) + 3 a^2 s^(2 alpha+1) c S
         - a s^(3 alpha+1) + a s^(3 alpha+3),
    and (2 alpha+2) <s^(2 alpha+2) S^2> = (2 alpha+1) <s^(2 alpha) S^2> - 2 M_(4 alpha+4)/(3 alpha+3) by parts.
    """
    A, a = _alpha + 1, _alpha - 1
    b = 1 / (2 * A)
    M_22 = _M2 * (2 * _alpha + 1) / (2 * A)
    M_42 = _M4 * (4 * _alpha + 1) / (4 * _alpha + 2)
    M_44 = M_42 * (4 * _alpha + 3) / (4 * A)
    J_22 = ((2 * _alpha + 1) * _J - 2 * M_44 / (3 * A)) / (2 * A)
    first = -3 * a**3 * J_22 - 2 * a**2 * b * (M_22 - M_44) - a**2 * M_44 / A - a * (M_42 - M_44)
    second = 3 * a**2 * (_J - J_22) + 2 * a * b * (_M2 - M_22 - M_42 + M_44)
    third = 3 * a * (M_42 / (3 * _alpha + 1) - M_44 / (3 * A))
    return _pi / 2 * (-first / A + second + third + _M4 - 2 * M_42 + M_44)


RADIUS = 3
"""Radius |theta| < 3 < pi of the discs on which the functions below are bounded; the series are used at pi/2."""


def nested_integral(exponent: arb) -> arb:
    """An enclosure of I_4(alpha) at the current precision, for a ball alpha >= 0.

    With s = theta g, g even and free of zeros for |theta| < pi, and S = -m + theta^(alpha+2) sigma, where
    sigma(theta) = int_0^1 u^(alpha+1) g(u theta)^(alpha+1) du,

        (pi/2) J = (pi/2) m^2 M_(2 alpha) + int_0^(pi/2) theta^(3 alpha+2) (-2 m g^(2 alpha) sigma)
                   + int_0^(pi/2) theta^(4 alpha+4) g^(2 alpha) sigma^2.

    For |theta| = R < pi: |g| <= sinh(R)/R (Taylor coefficients of sin alternate), so |g^p| <= G^p with G = sinh(R)/R,
    p >= 0, and |sigma| <= G^(alpha+1)/(alpha+2).  A function y of theta^2 bounded by B has |y_j| <= B R^(-2 j)
    (Cauchy), so the terms from j = K on of int_0^h theta^e y are at most B h^(e+1) x^K/((e + 1 + 2 K) (1 - x)),
    x = (h/R)^2.
    InputError unless the ball lies in alpha >= 0.
    """
    if not exponent >= 0:
        raise InputError("alpha", f"{exponent.str(5)} is not certainly >= 0", "alpha >= 0")
    # x = (pi/6)^2 is worth 1.87 bits a term. Counted as 1.8, with
    # eight terms to spare; the tail is added whatever it is.
    terms = ceil(ctx.prec / 1.8) + 8
    weight = _sinc_power(2 * exponent, terms)
    sigma = [c / (exponent + 2 + 2 * j) for j, c in enumerate(_sinc_power(exponent + 1, terms))]
    first, (linear_bound, square_bound) = _product(weight, sigma), cauchy_bounds(exponent)
    M, M2 = moment_ball(exponent + 1), moment_ball(2 * exponent)
    m = arb.pi() * M / 2
    linear = _integrate(first, 3 * exponent + 2, linear_bound)
    square = _integrate(_product(first, sigma), 4 * exponent + 4, square_bound)
    J = m**2 * M2 + (square - 2 * m * linear) * 2 / arb.pi()
    return J - arb.pi() ** 2 * M**2 * M2 / 12


def cauchy_bounds(exponent: arb) -> tuple[arb, arb]:
    """Of |g^(2 alpha) sigma| and |g^(2 alpha) sigma^2| on |theta| = R: G^(3 alpha + 1)/(alpha + 2) and the like."""
    growth = arb(RADIUS).sinh() / RADIUS
    sigma = growth ** (exponent + 1) / (exponent + 2)
    return growth ** (2 * exponent) * sigma, growth ** (2 * exponent) * sigma**2


def _sinc_power(p: arb, terms: int) -> list[arb]:
    """Coefficients in theta^2 of (sin(theta)/theta)^p, by n y_n = sum_(k=1..n) ((p + 1) k - n) g_k y_(n-k)."""
    g, y = [arb(1)], [arb(1)]
    for n in range(1, terms):
        g.append(-g[-1] / (2 * n * (2 * n + 1)))
        y.append(sum((((p + 1) * k - n) * g[k] * y[n - k] for k in range(1, n + 1)), start=arb(0)) / n)
    return y


def _product(x: list[arb], y: list[arb]) -> list[arb]:
    return [sum((x[j] * y[n - j] for j in range(n + 1)), start=arb(0)) for n in range(len(x))]


def _integrate(y: list[arb], e: arb, bound: arb) -> arb:
    """int_0^(pi/2) theta^e y(theta^2) with the tail bound of ``nested_integral`` in the radius."""
    h = arb.pi() / 2
    ratio, scale = (h / RADIUS) ** 2, h ** (e + 1)
    total = sum((c * h ** (2 * j) / (e + 1 + 2 * j) for j, c in enumerate(y)), start=arb(0))
    # Cauchy: |y_j| <= bound R^(-2 j), the divisor e + 1 + 2 j is least at j = K, and the rest is a geometric series.
    tail = bound * scale * ratio ** len(y) / ((e + 1 + 2 * len(y)) * (1 - ratio))
    return total * scale + arb(0, tail.upper())


def nested_integral_exact(n: int) -> PiNumber:
    """I_4(n) at an integer n >= 0, by the algebra of theta, s and c; InputError for a negative n."""
    if n < 0:
        raise InputError("alpha", f"{n} is negative", "an integer >= 0")
    S, weight = sine_power(n + 1).integral(), sine_power(2 * n)
    m, mean = S.at_quarter(), 2 / PI * weight.integral().at_quarter()
    linear, square = ((weight * f).integral().at_quarter() * 2 / PI for f in (S, S * S))
    # S = int_0^theta - m with m = pi M/2, so that pi^2 M^2/12 = m^2/3 leaves two thirds of m^2.
    return m * m * mean * fmpq(2, 3) - 2 * m * linear + square
