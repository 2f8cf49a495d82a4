"""The quarter swing of one law by the reciprocal of its local strength: a square, and the time linear in it.

>>> derivation.name, len(derivation.steps) >= 5
('one-law-quarter', True)
"""

import sympy

from derivations.steps import At, Derivation, Solution

theta = sympy.Symbol("theta", real=True)
s, delta, alpha, u = sympy.symbols("s delta alpha u", positive=True)
c, Q, D, slope = sympy.symbols("c Q D Q'", real=True)
eta = alpha - 1

derivation = Derivation(
    "one-law-quarter",
    "The quarter swing of one law by the reciprocal of its local strength",
    source="expansions.half_swings.one_law; u = delta e^(eta R), eta = alpha - 1, "
    "R' = -s^(alpha+1) u/(1 - c s^alpha u)",
)
step = derivation.step

R = sympy.Function("R")(theta)
Y = s**alpha * u / (1 - c * s**alpha * u)
falling, y = {sympy.Derivative(R, theta): -s * Y}, sympy.Symbol("Y")
step(
    "Q = delta/u = e^(-eta R) has the derivative -eta R' Q, with Y = s^alpha u/(1 - c s^alpha u), R' = -s Y,",
    At(sympy.Derivative(sympy.exp(-eta * R), theta), falling),
    eta * s ** (alpha + 1) * u / (1 - c * s**alpha * u) * sympy.exp(-eta * R),
)
step(
    "where the quotient is the rate of the time:",
    1 / (1 - c * s**alpha * u),
    At(1 + c * y, {y: Y}),
)
rate = eta * delta * s ** (alpha + 1) / (1 - c * s**alpha * delta / Q)
step(
    "Multiplied by 1 - c s^alpha u, u = delta/Q, and by Q: Q Q' - delta s^alpha c Q' is",
    At(Q * slope - delta * s**alpha * c * slope, {slope: rate}),
    delta * s**alpha * eta * s * Q,
)
q = sympy.Function("q")(theta)
step(
    "and Q Q' is the derivative of a square, each pair of coefficients once",
    sympy.Derivative(q**2, theta) / 2,
    q * q.diff(theta),
)
step(
    "In c, Q' = -s Q_c: the same equation without s, polynomial where alpha is even",
    At(delta * s**alpha * (c * slope + eta * s * Q), {slope: -s * D}) / -s,
    delta * s**alpha * (c * D - eta * Q),
)
v, n, beta = sympy.symbols("v n beta", positive=True)
half = sympy.sin(theta / 2) ** 2
step(
    "For any other alpha v = sin(theta/2)^2 is the variable, dv/d theta = s/2,",
    sympy.Derivative(half, theta),
    sympy.sin(theta) / 2,
)
step("with c = 1 - 2v: s^2 = 1 - c^2 is", At(1 - c**2, {c: 1 - 2 * v}), 4 * v * (1 - v))
step(
    "dR/d theta = -s Y, so P = e^(eta R) = u/delta has dP/dv = -2 eta P Y = -2 eta C,",
    At(sympy.Derivative(sympy.exp(eta * R), theta), falling) / (s / 2),
    -2 * eta * sympy.exp(eta * R) * Y,
)
step("and Y solves Y = s^alpha u (1 + c Y):", Solution(y, s**alpha * u * (1 + c * y), y), Y)
f = sympy.Function("f")
step(
    "H f = int_0^1 x^(beta-1) f(x v) dx on a power of v: it solves beta h + v h' = f, and |H f| <= |f|/beta",
    sympy.Integral(u ** (beta - 1) * (u * v) ** n, (u, 0, 1)),
    v**n / (beta + n),
)
step(
    "For p_n (2v)^(n alpha/2) the equation of P is (n alpha/2) p_n + v p_n' = -2 eta v C_n: p_n = v h with beta = n"
    " alpha/2 + 1. The time d tau = (1 + c Y) d theta, d theta = 2 dv/s, where 2/s is",
    At(2 / s, {s: 2 * sympy.sqrt(v * (1 - v))}),
    1 / sympy.sqrt(v * (1 - v)),
)
x = sympy.Symbol("x")
T = [sympy.chebyshevt(k, x) for k in range(6)]
step(
    "v h' = (x + 1) dh/dx, x = 4v - 1: (x + 1) T_k' = k T_k + 2k (T_(k-1) + … + T_1) + k, here for k = 5. So the"
    " coefficients of h obey (beta + k) h_k + s_k = f_k with s_(k-1) = s_k + 2k h_k, from the highest down, s_0 half",
    (x + 1) * sympy.Derivative(T[5], x),
    5 * T[5] + 10 * sum(T[1:5]) + 5,
)
