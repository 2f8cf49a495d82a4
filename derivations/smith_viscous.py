"""Smith's constants of the viscously damped oscillator, (32) and (33), the frequency (34), and why S is not one value.

>>> print(derivation.steps[1].text())
Subs(D(P(x, v)), omega_0, sqrt(gamma**2 + omega**2)) = -gamma*P(x, v) - omega**2*x
"""

import sympy
from sympy import Derivative, atan, exp

from derivations.steps import At, Derivation, Solution, defined

x, v = sympy.symbols("x v", real=True)
gamma, omega, omega_0, m, t = sympy.symbols("gamma omega omega_0 m t", positive=True)
R, chi = sympy.symbols("R phi", positive=True)
alike = {omega_0: sympy.sqrt(omega**2 + gamma**2)}

derivation = Derivation(
    "smith-viscous",
    "Two constants of the damped linear oscillator",
    source="Smith 2012, (32)-(34), and below (15) on integrating factors",
)
step, asserts = derivation.step, derivation.asserts

D = defined(
    "D", lambda f: Derivative(f, t) + v * Derivative(f, x) + (-(omega_0**2) * x - 2 * gamma * v) * Derivative(f, v)
)
P = defined("P", lambda x, v: v + gamma * x)
step("x'' = -omega_0^2 x - 2 gamma v; D is d/dt along the motion.  P = v + gamma x: x' is", D(x), P(x, v) - gamma * x)
step(
    "and P', with omega^2 = omega_0^2 - gamma^2: (34), where the paper prints a plus",
    At(D(P(x, v)), alike),
    -gamma * P(x, v) - omega**2 * x,
    corrects=("smith2012:34",),
)
angle = defined("phi", lambda x, v: atan(omega * x / P(x, v)))
step("So the angle phi with tan phi = omega x/P turns at the rate", At(D(angle(x, v)), alike), omega)
step("and T = omega t - phi is constant: (33)", At(D(omega * t - angle(x, v)), alike), 0)
size = defined("Q", lambda x, v: P(x, v) ** 2 + omega**2 * x**2)
step("while Q = P^2 + omega^2 x^2 falls, at the rate", At(D(size(x, v)), alike), -2 * gamma * size(x, v))
step(
    "so S = (m/2) Q e^(2 gamma phi/omega) is constant: (32)",
    At(D(m * size(x, v) * exp(2 * gamma / omega * angle(x, v)) / 2), alike),
    0,
)
step(
    "Near miss: with omega^2 = omega_0^2 + gamma^2, as printed, T changes, D(T) times Q being",
    At(D(omega * t - angle(x, v)) * size(x, v), {omega_0: sympy.sqrt(omega**2 - gamma**2)}),
    2 * gamma**2 * omega * x**2,
)
step(
    "The two give the motion: phi = omega t - T and Q = R^2, so omega x = R sin(phi) and P = omega x cot(phi)",
    At(omega * x * sympy.cot(chi), {x: R * sympy.sin(chi) / omega}),
    R * sympy.cos(chi),
)

# Why no integrating factor serves a whole ring around the equilibrium.
Q_0, Q_1, x_0, mu, place = sympy.symbols("Q_0 Q_1 x_0 mu x", positive=True)
step(
    "S is not one value: once round, phi has grown by 2 pi at the same S, so Q has fallen from Q_0 to",
    Solution(Q_1 * exp(2 * gamma / omega * (chi + 2 * sympy.pi)), Q_0 * exp(2 * gamma / omega * chi), Q_1),
    Q_0 * exp(-4 * sympy.pi * gamma / omega),
)
step("and on the axis v = 0 Q is, with the same angle at each passage,", size(x, 0), (gamma**2 + omega**2) * x**2)
step(
    "so the orbit from (x_0, 0) comes back to this axis at x_1, where Q(x_1, 0) = Q(x_0, 0) e^(-4 pi gamma/omega): x_1",
    Solution(size(x, 0), At(size(x, 0), {x: x_0}) * exp(-4 * sympy.pi * gamma / omega), x, sign=1),
    x_0 * exp(-2 * sympy.pi * gamma / omega),
    corrects=("smith2012:claim.integrating-factor-exists",),
)
asserts(
    "There a total dS = mu [v dv + (omega_0^2 x + 2 gamma v) dx] with mu > 0 has a positive coefficient of dx, so S"
    " would rise from x_1 to x_0; but S is constant along the orbit that joins them: no mu without a zero serves",
    sympy.Gt(At(mu * (omega_0**2 * place + 2 * gamma * v), {v: 0}), 0, evaluate=False),
)
step(
    "Near miss, gamma = 0: the orbit closes, x_1 = x_0, and mu = 1 does: the form is closed, its cross derivatives",
    At(Derivative(v, x) - Derivative(omega_0**2 * x + 2 * gamma * v, v), {gamma: 0}),
    0,
)
