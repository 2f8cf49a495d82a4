"""The uniform phase phi(tau) for any exponent, line by line, and why the total lag is finite for alpha > 1.

>>> print(derivation.steps[9].text())
Subs(w_2*(-epsilon + x)/(mu*p_1), x, epsilon/(epsilon*mu*p_1*tau + 1)) = -epsilon**2*tau*w_2/(epsilon*mu*p_1*tau + 1)
"""

import sympy
from sympy import Derivative, Integral, Limit, oo, pi, sin

from asymptotics.expansions.moments.symbolic import moment
from asymptotics.expansions.normal_form.symbolic import alpha as exponent
from asymptotics.expansions.normal_form.symbolic import omega_2
from derivations.steps import At, Derivation

alpha, epsilon, tau, p_1, w_2, nu, s, x, y = sympy.symbols("alpha epsilon tau p_1 w_2 nu s x y", positive=True)
mu = sympy.Symbol("mu", nonzero=True)  # alpha - 1, of either sign
A, delta = (sympy.Function(name, positive=True)(tau) for name in ("A", "delta"))
phi, psi = (sympy.Function(name, real=True)(tau) for name in ("phi", "psi"))
chi = sympy.Symbol("chi_1", real=True)

derivation = Derivation(
    "finite-phase-lag",
    "The phase correction and its finite total",
    source="theory page slow_flow; Lancaster 2020 neglects it, below (9)",
)
step, asserts = derivation.step, derivation.asserts

# The flow: dA/dtau = -p_1 A delta, dphi/dtau = Omega_2 delta^2 = -w_2 delta^2 (derivation multiple-scales-turning).
local = derivation.defines("The local strength, mu = alpha - 1", "delta", epsilon * A**mu)
step(
    "moves with dA/dtau = -p_1 A delta: ddelta/dtau",
    At(Derivative(local, tau), {Derivative(A, tau): -p_1 * A * local}),
    -mu * p_1 * local**2,
)
slowing = {Derivative(delta, tau): -mu * p_1 * delta**2}
step("so its inverse grows at a constant rate", At(Derivative(1 / delta, tau), slowing), mu * p_1)
solved = epsilon / (1 + mu * p_1 * epsilon * tau)
step("from 1/epsilon at tau = 0, where A = 1: delta(tau)", 1 / (1 / epsilon + Integral(mu * p_1, (s, 0, tau))), solved)
step("which is right: ddelta/dtau", Derivative(solved, tau), -mu * p_1 * solved**2)
step(
    "and A = (delta/epsilon)^(1/mu), with y = 1 + mu p_1 epsilon tau > 0: Lancaster's (13)",
    At((x / epsilon) ** (1 / mu), {x: epsilon / y}),
    y ** (-1 / mu),
)
step(
    "The phase phi = psi - tau: a turn has dtau/dpsi = W = 1 + w_2 delta^2 + ..., even in delta, with"
    " w_2 of multiple-scales-turning.  d(psi - tau)/dtau with dpsi/dtau = 1/W, over delta^2, for small delta",
    Limit(At(Derivative(psi - tau, tau), {Derivative(psi, tau): 1 / (1 + w_2 * x**2)}) / x**2, x, 0),
    -w_2,
)
step(
    "To this order dphi/dtau = -w_2 delta^2, and by elimination of the time dphi/ddelta is constant",
    At(Derivative(phi, tau) / Derivative(delta, tau), {Derivative(phi, tau): -w_2 * delta**2} | slowing),
    w_2 / (mu * p_1),
)
in_delta = w_2 / (mu * p_1) * (x - epsilon)
step(
    "phi = 0 at delta = epsilon, so where delta has come to x: phi",
    Integral(w_2 / (mu * p_1), (s, epsilon, x)),
    in_delta,
)
phase = -w_2 * epsilon**2 * tau / (1 + mu * p_1 * epsilon * tau)
step("as a function of time: phi(tau)", At(in_delta, {x: solved}), phase)
step("which is right: dphi/dtau", Derivative(phase, tau), -w_2 * solved**2)
step("and phi(0)", At(phase, {tau: 0}), 0)

# Its end.
lag = w_2 * epsilon / (nu * p_1)
step("alpha = 1 + nu, nu > 0: delta -> 0", Limit(At(solved, {mu: nu}), tau, oo), 0)
step("so the phase comes to an end, the total lag: lim phi", Limit(At(phase, {mu: nu}), tau, oo), -lag)
step(
    "The same by the integral, which converges",
    Integral(-w_2 * At(solved, {mu: nu, tau: s}).doit() ** 2, (s, 0, oo)),
    -lag,
)
step(
    "half of it has come when delta has halved, at tau = 1/((alpha-1) p_1 epsilon)",
    At(phase, {mu: nu, tau: 1 / (nu * p_1 * epsilon)}),
    -lag / 2,
)
step("alpha -> 1: the lag has no end, dphi/dtau is constant", Limit(phase, mu, 0), -w_2 * epsilon**2 * tau)
below = Limit(At(in_delta, {mu: -nu}), x, oo)
asserts(
    "alpha = 1 - nu: delta grows without bound towards the extinction, the lag too",
    sympy.Eq(below, -oo, evaluate=False),
)
step(
    "Omega has even powers only: the rest is of third order, uniformly, int_0^infinity delta^4 dtau",
    Integral((epsilon / (1 + nu * p_1 * epsilon * tau)) ** 4, (tau, 0, oo)),
    epsilon**3 / (3 * nu * p_1),
)
step(
    "In another gauge psi changes by chi_1 delta: phi by chi_1 (delta - epsilon), and Omega_2 by -(alpha-1) p_1 chi_1",
    Derivative(chi * (solved - epsilon), tau),
    -mu * p_1 * chi * solved**2,
)
step(
    "with its start psi(0) = chi_1 epsilon the phase at infinity, where delta = 0, is the same in every gauge",
    Limit(At(chi * epsilon + phase + chi * (solved - epsilon), {mu: nu}), tau, oo),
    -lag,
)

# Numbers.
step(
    "alpha = 3: w_2 = (3/4)^2 M_6",
    sympy.Rational(9, 16) * Integral(sin(x) ** 6, (x, 0, pi)) / pi,
    sympy.Rational(45, 256),
)
step("which is the engine's -Omega_2", -At(omega_2(), {exponent: 3}), sympy.Rational(45, 256))
step("p_1 = M_4", Integral(sin(x) ** 4, (x, 0, pi)) / pi, moment(4))
cubic = {w_2: sympy.Rational(45, 256), p_1: moment(4), nu: 2}
step("alpha = 3: the total lag", At(lag, cubic), sympy.Rational(15, 64) * epsilon)
