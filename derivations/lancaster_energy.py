"""Lancaster's energy argument: from the ansatz A(t) cos(omega_0 t) to the envelope (13), exponent left open.

>>> print(derivation.steps[1].reason)
(5): the energy of the ansatz
"""

import sympy

from asymptotics.moments.symbolic import moment
from derivations.steps import At, Derivation, defined, named

b, k, m, x_0, tau, t = sympy.symbols("b k m x_0 tau t", positive=True)
alpha = sympy.Symbol("alpha", positive=True)
omega_0 = sympy.sqrt(k / m)
A = sympy.Function("A", positive=True)(t)
size, speed = sympy.symbols("A u", positive=True)
theta = sympy.Symbol("theta", real=True)
diff, sin, cos = sympy.diff, sympy.sin, sympy.cos

derivation = Derivation(
    "lancaster-energy",
    "The energy argument for the envelope",
    source="Lancaster 2020, (4)-(10), (13)-(15); lancaster2020:5, 6, 7, 8, 10, 13, 14, 15",
)
step, holds = derivation.step, derivation.holds

x = A * cos(omega_0 * t)
velocity = diff(x, t)
step(
    "The velocity of the ansatz", sympy.Derivative(x, t), diff(A, t) * cos(omega_0 * t) - A * omega_0 * sin(omega_0 * t)
)
slow = diff(A, t) / (omega_0 * A)
energy = m * velocity**2 / 2 + k * x**2 / 2
bracket = 1 + slow**2 * cos(omega_0 * t) ** 2 - slow * sin(2 * omega_0 * t)
step("(5): the energy of the ansatz", sympy.expand_trig(energy), sympy.expand_trig(k * A**2 / 2 * bracket))
eta = sympy.Symbol("eta")
shape = k * size**2 / 2 * (1 + eta**2 * cos(theta) ** 2 - eta * sin(2 * theta))
step("(6): at eta = (dA/dt)/(omega_0 A) -> 0 it is k A^2/2", At(shape, {eta: 0}), k * size**2 / 2)
step(
    "the neglected part is of first order in eta; its mean over a period is of second order",
    sympy.integrate(shape, (theta, 0, 2 * sympy.pi)) / (2 * sympy.pi),
    k * size**2 / 2 * (1 + eta**2 / 2),
)
path, force = sympy.Function("x")(t), sympy.Function("f")(t)
total = m * diff(path, t) ** 2 / 2 + k * path**2 / 2
step(
    "(7): dE/dt = v (m a + k x), and the equation of motion puts f for the bracket",
    diff(total, t).subs(diff(path, t, 2), (force - k * path) / m),
    force * diff(path, t),
)
step("(8): d/dt of (6)", sympy.Derivative(k * A**2 / 2, t), k * A * diff(A, t))

sine = sympy.Symbol("s", positive=True)  # |sin(omega_0 t)|, with (9): |v| = A omega_0 s
drag = -b * speed ** (alpha + 1)  # f(v) v for f = -b v|v|^(alpha-1)
power = drag.subs(speed, size * omega_0 * sine)
step(
    "f v with (9), divided by k A: dA/dt = -(b omega_0^(alpha+1)/k) A^alpha |sin|^(alpha+1)",
    power / (k * size),
    sympy.powsimp(
        sympy.expand_power_base(-b * omega_0 ** (alpha + 1) / k * size**alpha * sine ** (alpha + 1), force=True)
    ),
)
primitive = (size ** (1 - alpha) - x_0 ** (1 - alpha)) / (1 - alpha)
step("(10): the left side integrates dA/A^alpha", diff(primitive, size), size**-alpha)
step("and vanishes at A = x_0", At(primitive, {size: x_0}), sympy.Integer(0))

M = sympy.Symbol("M", positive=True)  # the mean of |sin|^(alpha+1), see lancaster-average
kappa = sympy.Symbol("kappa", positive=True)  # M b omega_0^alpha x_0^(alpha-1)/k
growth = sympy.Symbol("B", positive=True)  # 1 + (alpha-1) kappa omega_0 t
mu = sympy.Symbol("mu", real=True, nonzero=True)  # alpha - 1
root = x_0 * growth ** (-1 / mu)
clock = (growth - 1) / (mu * M * b * omega_0 ** (mu + 1) * x_0**mu / k * omega_0)
step(
    "(13) solves the averaged (10): with mu = alpha - 1 and B = 1 + mu kappa omega_0 t",
    primitive.subs(alpha, 1 + mu).subs(size, root),
    -b * omega_0 ** (mu + 2) * M / k * clock,
)
envelope = (1 + (alpha - 1) * kappa * tau) ** (-1 / (alpha - 1))
decay = sympy.simplify(-diff(envelope, tau) / envelope)
A_of = defined("A", lambda tau: (1 + (alpha - 1) * kappa * tau) ** (-1 / (alpha - 1)))
step(
    "(14): |dA/dt|/(omega_0 A) in tau = omega_0 t",
    -sympy.Derivative(A_of(tau), tau) / A_of(tau),
    kappa / (1 + (alpha - 1) * kappa * tau),
)
late = sympy.limit(decay * tau, tau, sympy.oo)
step("(15): tau times it tends to 1/(alpha-1), whatever kappa", late, 1 / (alpha - 1))
for n, name in ((0, "2/pi"), (1, "1/2"), (2, "4/(3 pi)"), (3, "3/8")):
    beta = 2 ** sympy.Integer(n + 1) * sympy.gamma(sympy.Rational(n, 2) + 1) ** 2 / sympy.gamma(n + 2) / sympy.pi
    step(f"alpha = {n}: the coefficient of kappa in (13) is {name}", named(f"M_{n + 1}", moment(n + 1)), beta)
