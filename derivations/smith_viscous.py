"""Smith's two constants of the viscously damped oscillator, (32) and (33), and the frequency (34) that makes them so.

>>> print(derivation.steps[1].text())
Subs(D(P(x, v)), omega_0, sqrt(gamma**2 + omega**2)) = -gamma*P(x, v) - omega**2*x
"""

import sympy
from sympy import Derivative, atan, exp

from derivations.steps import At, Derivation, defined

x, v = sympy.symbols("x v", real=True)
gamma, omega, omega_0, m, t = sympy.symbols("gamma omega omega_0 m t", positive=True)
R, chi = sympy.symbols("R phi", positive=True)
alike = {omega_0: sympy.sqrt(omega**2 + gamma**2)}

derivation = Derivation(
    "smith-viscous",
    "Two constants of the damped linear oscillator",
    source="Smith 2012, (32)-(34)",
)
step = derivation.step

D = defined(
    "D", lambda f: Derivative(f, t) + v * Derivative(f, x) + (-(omega_0**2) * x - 2 * gamma * v) * Derivative(f, v)
)
P = defined("P", lambda x, v: v + gamma * x)
step("x'' = -omega_0^2 x - 2 gamma v; D is d/dt along the motion.  P = v + gamma x: x' is", D(x), P(x, v) - gamma * x)
step(
    "and P', with omega^2 = omega_0^2 - gamma^2: (34), where the paper prints a plus",
    At(D(P(x, v)), alike),
    -gamma * P(x, v) - omega**2 * x,
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
