"""Lancaster's energy argument: from the ansatz A(t) cos(omega_0 t) to the envelope (13), exponent left open.

>>> print(derivation.steps[1].reason)
(5): the energy of the ansatz
"""

import sympy

from asymptotics.expansions.moments.symbolic import moment
from derivations.steps import At, Derivation, Solution

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
step = derivation.step

x = A * cos(omega_0 * t)
step(
    "The velocity of the ansatz",
    sympy.Derivative(x, t),
    diff(A, t) * cos(omega_0 * t) - A * omega_0 * sin(omega_0 * t),
    corrects=("lancaster2020:claim.velocity-sign",),
)
slow = diff(A, t) / (omega_0 * A)
bracket = 1 + slow**2 * cos(omega_0 * t) ** 2 - slow * sin(2 * omega_0 * t)
place, pace = sympy.symbols("x v", real=True)
step(
    "(5): the energy of the ansatz",
    At(m * pace**2 / 2 + k * place**2 / 2, {pace: sympy.Derivative(x, t), place: x}),
    k * A**2 / 2 * bracket,
    proves=("lancaster2020:5",),
)
eta = sympy.Symbol("eta")
shape = k * size**2 / 2 * (1 + eta**2 * cos(theta) ** 2 - eta * sin(2 * theta))
step(
    "(6): at eta = (dA/dt)/(omega_0 A) -> 0 it is k A^2/2",
    At(shape, {eta: 0}),
    k * size**2 / 2,
    corrects=("lancaster2020:claim.slow-dissipation",),
)
step(
    "the neglected part is of first order in eta; its mean over a period is of second order",
    sympy.Integral(shape, (theta, 0, 2 * sympy.pi)) / (2 * sympy.pi),
    k * size**2 / 2 * (1 + eta**2 / 2),
)
path, force = sympy.Function("x")(t), sympy.Function("f")(t)
total = m * diff(path, t) ** 2 / 2 + k * path**2 / 2
step(
    "(7): dE/dt = v (m a + k x), and the equation of motion puts f for the bracket",
    At(sympy.Derivative(total, t), {diff(path, t, 2): (force - k * path) / m}),
    force * diff(path, t),
    proves=("lancaster2020:7",),
)
step(
    "(8): d/dt of (6)",
    sympy.Derivative(k * A**2 / 2, t),
    k * A * diff(A, t),
    corrects=("lancaster2020:claim.energy-derivative",),
)

sine = sympy.Symbol("s", positive=True)  # |sin(omega_0 t)|, with (9): |v| = A omega_0 s
drag = -b * speed ** (alpha + 1)  # f(v) v for f = -b v|v|^(alpha-1)
step(
    "f v with (9), divided by k A: dA/dt = -(b omega_0^(alpha+1)/k) A^alpha |sin|^(alpha+1)",
    At(drag, {speed: size * omega_0 * sine}) / (k * size),
    sympy.powsimp(
        sympy.expand_power_base(-b * omega_0 ** (alpha + 1) / k * size**alpha * sine ** (alpha + 1), force=True)
    ),
)
primitive = (size ** (1 - alpha) - x_0 ** (1 - alpha)) / (1 - alpha)
step("(10): the left side integrates dA/A^alpha", sympy.Derivative(primitive, size), size**-alpha)
s, moment_of_time = sympy.Function("s", positive=True), sympy.Symbol("u", positive=True)
impulse = sympy.Integral(s(moment_of_time) ** (alpha + 1), (moment_of_time, 0, t))
ten = primitive.subs(size, A) + b * omega_0 ** (alpha + 1) / k * impulse
step(
    "(10), left minus right, with s(t) = |sin(omega_0 t)|: its d/dt is 0 with dA/dt by the line before last",
    At(
        sympy.Derivative(ten, t),
        {diff(A, t): -b * omega_0 ** (alpha + 1) / k * A**alpha * s(t) ** (alpha + 1)},
    ),
    sympy.Integer(0),
)
step(
    "and it is 0 at t = 0, where A = x_0",
    At(ten, {A: x_0, t: 0}),
    sympy.Integer(0),
    proves=("lancaster2020:10",),
)

M = sympy.Symbol("M", positive=True)  # the mean of |sin|^(alpha+1), see lancaster-average
kappa = sympy.Symbol("kappa", positive=True)  # M b omega_0^alpha x_0^(alpha-1)/k
growth = sympy.Symbol("B", positive=True)  # 1 + (alpha-1) kappa omega_0 t
mu = sympy.Symbol("mu", real=True, nonzero=True)  # alpha - 1
root = x_0 * growth ** (-1 / mu)
instant = (growth - 1) / (mu * (M * b * omega_0 ** (mu + 1) * x_0**mu / k) * omega_0)  # t at which B is reached
step(
    "(13) solves the averaged (10), M t for the integral: mu = alpha - 1, at the time t of B = 1 + mu kappa omega_0 t",
    At(primitive.subs(alpha, 1 + mu), {size: root}),
    At(-b * omega_0 ** (mu + 2) / k * M * t, {t: instant}),
)
fading = (1 + (alpha - 1) * kappa * tau) ** (-1 / (alpha - 1))  # A/x_0 by (13)
step(
    "(14): |dA/dt|/(omega_0 A) in tau = omega_0 t, with A/x_0 of (13)",
    -sympy.Derivative(fading, tau) / fading,
    kappa / (1 + (alpha - 1) * kappa * tau),
    proves=("lancaster2020:14", "lancaster2020:claim.weak-equals-slow"),
)
rate = kappa / (1 + (alpha - 1) * kappa * tau)
step(
    "this rate r has the derivative -(alpha-1) r^2",
    sympy.Derivative(rate, tau),
    -(alpha - 1) * rate**2,
)
R, beyond = sympy.symbols("r p", positive=True)
slope = -(alpha - 1) * R**2
derivation.asserts(
    "it falls for alpha = 1 + p > 1, is constant for alpha = 1, and grows for alpha = 1 - p < 1",
    sympy.Lt(At(slope, {alpha: 1 + beyond}), 0, evaluate=False),
    sympy.Eq(At(slope, {alpha: 1}), 0, evaluate=False),
    sympy.Gt(At(slope, {alpha: 1 - beyond}), 0, evaluate=False),
    proves=tuple(f"lancaster2020:claim.{name}" for name in ("weak-not-slow", "long-or-short", "crossover")),
)
q, nu = sympy.symbols("q nu", positive=True)
step(
    "(15), alpha = 1 + q: in B = q kappa tau alone, q tau times the rate is B/(1+B), which tends to 1",
    sympy.Limit(At(rate * q * tau, {alpha: 1 + q, tau: growth / (q * kappa)}), growth, sympy.oo),
    sympy.Integer(1),
    proves=("lancaster2020:15",),
)
step(
    "alpha = 1 - nu < 1: the amplitude is 0 at the finite time nu kappa tau = 1",
    At((1 - nu * kappa * tau) ** (1 / nu), {tau: 1 / (nu * kappa)}),
    sympy.Integer(0),
)
step(
    "(17): the rate grows from kappa at the start",
    At(rate, {alpha: 1 - nu, tau: sympy.Integer(0)}),
    kappa,
)
step(
    "and without bound: its inverse tends to 0 there",
    sympy.Limit(At(1 / rate, {alpha: 1 - nu}), tau, 1 / (nu * kappa), "-"),
    sympy.Integer(0),
    proves=("lancaster2020:claim.fails-at-long-times",),
)
step(
    "it equals omega_0 (rate 1) at nu kappa tau = 1 - kappa, if kappa < 1",
    Solution(At(rate, {alpha: 1 - nu}), sympy.Integer(1), tau),
    (1 - kappa) / (nu * kappa),
)
for n, name in ((0, "2/pi"), (1, "1/2"), (2, "4/(3 pi)"), (3, "3/8")):
    mean = sympy.Integral(sympy.sin(theta) ** (n + 1), (theta, 0, sympy.pi)) / sympy.pi
    step(f"alpha = {n}: the coefficient of kappa in (13) is {name}", mean, moment(n + 1))
