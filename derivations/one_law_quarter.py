"""The quarter swing of one law by the reciprocal of its local strength: a square, and the time linear in it.

>>> derivation.name, len(derivation.steps) >= 5
('one-law-quarter', True)
"""

import sympy

from derivations.steps import At, Derivation, named

theta = sympy.Symbol("theta", real=True)
s, delta, alpha, u = sympy.symbols("s delta alpha u", positive=True)
c, Q, D, slope = sympy.symbols("c Q D Q'", real=True)
eta = alpha - 1

derivation = Derivation(
    "one-law-quarter",
    "The quarter swing of one law by the reciprocal of its local strength",
    source="half_swings.one_law; u = delta e^(eta R), eta = alpha - 1, R' = -s^(alpha+1) u/(1 - c s^alpha u)",
)
step = derivation.step

Y = s**alpha * u / (1 - c * s**alpha * u)
step(
    "Q = delta/u = e^(-eta R) has the derivative -eta R' Q, with Y = s^alpha u/(1 - c s^alpha u), R' = -s Y,",
    named("Q'", eta * s * Y * delta / u),
    eta * delta * s ** (alpha + 1) / (1 - c * s**alpha * u),
)
step(
    "where the quotient is the rate of the time:",
    1 / (1 - c * s**alpha * u),
    named("1 + c Y", 1 + c * Y),
)
rate = eta * delta * s ** (alpha + 1) / (1 - c * s**alpha * delta / Q)
step(
    "Multiplied by 1 - c s^alpha u, u = delta/Q, and by Q: Q Q' - delta s^alpha c Q' is",
    named("Q Q' - delta s^alpha c Q'", Q * rate - delta * s**alpha * c * rate),
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
    sympy.expand(At(delta * s**alpha * (c * slope + eta * s * Q), {slope: -s * D}) / -s),
    delta * s**alpha * (c * D - eta * Q),
)
v, n = sympy.symbols("v n", positive=True)
step(
    "Order by order Q_n' = eta [g (1 + c Y)_(n-1)]/theta, g = theta s. Its coefficients of t^j are divided by n alpha +"
    " 2j (t = theta^2 up to a factor): an integral over the radius that, by Schwarz' lemma, divides a bound by"
    " n alpha + 2 at least",
    sympy.Integral(v ** (n * alpha / 2 - 1) * v / 2, (v, 0, 1)),
    1 / (n * alpha + 2),
)
