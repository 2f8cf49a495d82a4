"""The uniform first-order phase for any exponent, and why the total lag is finite for alpha > 1.

>>> print(derivation.steps[4].text())
-w_2/(p_1*(1 - alpha)) = w_2/(p_1*(alpha - 1))
"""

import sympy

from asymptotics.moments.symbolic import moment
from asymptotics.normal_form.symbolic import alpha as exponent
from asymptotics.normal_form.symbolic import omega_2
from derivations.steps import At, Derivation

alpha, epsilon, tau, p_1, w_2, mu, x, r, e = sympy.symbols("alpha epsilon tau p_1 w_2 mu x r e", positive=True)
delta = sympy.Function("delta", positive=True)(tau)
A, chi = sympy.Function("A", positive=True)(tau), sympy.Symbol("chi_1", real=True)
diff = sympy.diff

derivation = Derivation(
    "finite-phase-lag",
    "The phase correction and its finite total",
    source="theory page ``slow_flow``; Lancaster 2020 neglects it, below (9)",
)
step, holds = derivation.step, derivation.holds

step(
    "delta = epsilon A^(alpha-1) with dA/dtau = -p_1 A delta",
    sympy.powsimp(diff(epsilon * A ** (alpha - 1), tau).subs(diff(A, tau), -p_1 * epsilon * A**alpha)),
    sympy.powsimp(-(alpha - 1) * p_1 * (epsilon * A ** (alpha - 1)) ** 2),
)
local = epsilon / (1 + (alpha - 1) * p_1 * epsilon * tau)
step("is solved by delta(tau)", diff(local, tau), -(alpha - 1) * p_1 * local**2)
phase = -w_2 / ((alpha - 1) * p_1) * (epsilon - local)
step("dphi/dtau = Omega_2 delta^2 = -w_2 delta^2", sympy.Derivative(phase, tau), -w_2 * local**2)
step("phi(0) = 0", At(phase, {tau: 0}), sympy.Integer(0))
step(
    "Same by elimination of the time: dphi/ddelta is constant",
    -w_2 * x**2 / (-(alpha - 1) * p_1 * x**2),
    w_2 / ((alpha - 1) * p_1),
)
lag = w_2 * epsilon / (mu * p_1)
step("mu = alpha - 1 > 0: the total lag", -sympy.Limit(At(phase, {alpha: 1 + mu}), tau, sympy.oo), lag)
half = 1 / (mu * p_1 * epsilon)
step(
    "half of it has come when delta has halved, at tau = 1/((alpha-1) p_1 epsilon)",
    -At(At(phase, {alpha: 1 + mu}), {tau: half}),
    lag / 2,
)
below = -w_2 / (-mu * p_1) * (epsilon - x)
holds(
    "alpha < 1: delta grows without bound towards the extinction, the lag too",
    bool(sympy.limit(below, x, sympy.oo) == -sympy.oo),
    below,
)
step(
    "The rest is of third order, uniformly: int_0^infinity delta^4 dtau",
    sympy.Integral((epsilon / (1 + mu * p_1 * epsilon * tau)) ** 4, (tau, 0, sympy.oo)),
    epsilon**3 / (3 * mu * p_1),
)
step(
    "In another gauge psi changes by chi_1 delta: phi by chi_1 (delta - epsilon), and Omega_2 by -(alpha-1) p_1 chi_1",
    diff(chi * (local - epsilon), tau),
    -(alpha - 1) * p_1 * chi * local**2,
)
step(
    "with its start psi(0) = chi_1 epsilon the phase at infinity, where delta = 0, is the same in every gauge",
    sympy.Limit(At(chi * epsilon + phase + chi * (local - epsilon), {alpha: 1 + mu}), tau, sympy.oo),
    -lag,
)
averaged = sympy.Integral(sympy.sin(x) ** 6, (x, 0, sympy.pi)) / sympy.pi
step("alpha = 3: w_2 = (3/4)^2 M_6", sympy.Rational(9, 16) * averaged, sympy.Rational(45, 256))
step("which is the engine's -Omega_2", -At(omega_2(), {exponent: 3}), sympy.Rational(45, 256))
cubic = {w_2: sympy.Rational(45, 256), p_1: moment(4), mu: 2}
step("alpha = 3: the total lag", At(lag, cubic), sympy.Rational(15, 64) * epsilon)
