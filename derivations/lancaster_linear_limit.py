"""The limit alpha -> 1 of the envelope, the time and the phase: no new integration, no gap.

>>> print(derivation.steps[7].text())
b*t*M(2)/m = b*t/(2*m)
"""

import sympy

from asymptotics.expansions.moments.symbolic import moment
from derivations.steps import At, Derivation, Taylor, defined

alpha, kappa, tau, A, epsilon = sympy.symbols("alpha kappa tau A epsilon", positive=True)
mu, w_2, p_1, nu = sympy.symbols("mu w_2 p_1 nu", positive=True)
x_0, b, k, m, t = sympy.symbols("x_0 b k m t", positive=True)

derivation = Derivation(
    "lancaster-linear-limit",
    "The limit alpha -> 1",
    source="Lancaster 2020, below (10) and Table I, alpha = 1; lancaster2020:table1.alpha1; theory page slow_flow",
)
step = derivation.step

envelope = (1 + mu * kappa * tau) ** (-1 / mu)  # mu = alpha - 1
step(
    "With mu = alpha - 1, ln A = -ln(1 + mu kappa tau)/mu",
    At(sympy.log((1 + (alpha - 1) * kappa * tau) ** (-1 / (alpha - 1))), {alpha: 1 + mu}),
    -sympy.log(1 + mu * kappa * tau) / mu,
)
step("mu -> 0", sympy.Limit(envelope, mu, 0, "+"), sympy.exp(-kappa * tau))
below = (1 - nu * kappa * tau) ** (1 / nu)
step("and from below, alpha = 1 - nu", sympy.Limit(below, nu, 0, "+"), sympy.exp(-kappa * tau))
step(
    "the first correction is mu (kappa tau)^2/2: not uniform in tau",
    Taylor(-sympy.log(1 + mu * kappa * tau) / mu, mu, 1),
    -kappa * tau + mu * (kappa * tau) ** 2 / 2,
)
time = (A**-mu - 1) / (mu * kappa)
step("The time", sympy.Limit(time, mu, 0, "+"), -sympy.log(A) / kappa)
paper = (sympy.exp((1 - alpha) * sympy.log(A)) - 1) / (1 - alpha)
step("the paper's way: expand e^{(1-alpha) ln A}", sympy.Limit(paper, alpha, 1), sympy.log(A))
M_2 = defined("M", moment, index=True)(2)
theta = sympy.Symbol("theta", real=True)
step("The mean of the squared sine", M_2, sympy.Integral(sympy.sin(theta) ** 2, (theta, 0, sympy.pi)) / sympy.pi)
omega_0 = sympy.sqrt(k / m)
step(
    "kappa tau = b t/(2m): Table I",
    (M_2 * b * omega_0 / k * omega_0 * t),
    b * t / (2 * m),
)
delta = epsilon / (1 + mu * p_1 * epsilon * tau)
phase = -w_2 / (mu * p_1) * (epsilon - delta)
step("The phase", sympy.Limit(phase, mu, 0, "+"), -w_2 * epsilon**2 * tau)
step("w_2 at alpha = 1 is 1/8", sympy.Rational(1, 4) * M_2, sympy.Rational(1, 8))
exact = sympy.sqrt(1 - epsilon**2 / 4) - 1
step(
    "and the exact frequency of linear damping has -epsilon^2/8",
    Taylor(exact, epsilon, 3),
    -(epsilon**2) / 8,
)
