"""From the equation of motion (35) to the integrating factors and the first constants S^- and S^+ (36)-(40).

Both half-swings at once: x'' = s gamma v^2 - omega^2 x with s = +1 for v < 0 and s = -1 for v > 0.

>>> print(derivation.steps[4].text())
Derivative(exp(-2*gamma*s*x), x) = -2*gamma*s*exp(-2*gamma*s*x)
"""

import sympy

from derivations.steps import At, Derivation

x, gamma, omega = sympy.symbols("x gamma omega", positive=True)
v, u, w = sympy.symbols("v u w", real=True)
s = sympy.Symbol("s", nonzero=True, real=True)
mu = sympy.Function("mu")(x)
exp, diff = sympy.exp, sympy.diff

derivation = Derivation(
    "smith-integrating-factor",
    "The integrating factors and the first constants of the motion",
    source="Smith 2012, (35)-(40); smith2012:36, 37, 38a, 38b, 40",
)
step = derivation.step

force = s * gamma * v**2 - omega**2 * x
coefficient_dx = omega**2 * x - s * gamma * v**2
step(
    "The parity (x, v) -> (-x, -v) exchanges the two laws: a_{-s}(-x, -v) = -a_s(x, v), so -x(t) is a"
    " motion if x(t) is",
    At(force, {s: -s, x: -x, v: -v}),
    -force,
)
dv, dx = sympy.symbols("dv dx")
step(
    "(36): v dv + (omega^2 x - s gamma v^2) dx vanishes along dx = v dt, dv = a dt",
    At(v * dv + coefficient_dx * dx, {dv: force, dx: v}),
    0,
)
step(
    "It is not closed: its cross derivatives differ",
    sympy.Derivative(v, x) - sympy.Derivative(coefficient_dx, v),
    2 * s * gamma * v,
)
step(
    "(37) for a factor mu(x): the cross derivatives of mu times the form",
    sympy.Derivative(mu * v, x) - sympy.Derivative(mu * coefficient_dx, v),
    v * (diff(mu, x) + 2 * s * gamma * mu),
)
factor = exp(-2 * s * gamma * x)
step(
    "so mu' = -2 s gamma mu, mu = e^{-2 s gamma x}: the upper sign of e^{-+ 2 gamma x} belongs to v < 0",
    sympy.Derivative(factor, x),
    -2 * s * gamma * factor,
    corrects=("smith2012:claim.integrating-factors",),
)
step(
    "(38a): the form is now closed",
    sympy.Derivative(factor * v, x),
    sympy.Derivative(factor * coefficient_dx, v),
)
S = factor * (v**2 / 2 - omega**2 / (2 * s * gamma) * (x + 1 / (2 * s * gamma)))
step("(38b): S integrates it: the coefficient of dv", sympy.Derivative(S, v), factor * v, corrects=("smith2012:38b",))
step("and that of dx", sympy.Derivative(S, x), factor * coefficient_dx)
step(
    "S is constant along the motion",
    v * sympy.Derivative(S, x) + force * sympy.Derivative(S, v),
    0,
    corrects=("lelas2024:claim.not-analytically-solvable",),
)
step(
    "S^-(-x, -v) = S^+(x, v)",
    At(S, {s: 1, x: -x, v: -v}),
    At(S, {s: -1}),
)
units = {x: u / gamma, v: omega * w / gamma}
step(
    "(40) in u = gamma x, w = gamma v/omega, for v < 0",
    gamma**2 / omega**2 * At(S, {s: 1} | units),
    exp(-2 * u) * (w**2 / 2 - u / 2 - sympy.Rational(1, 4)),
    corrects=("smith2012:40",),
)
step(
    "and for v > 0",
    gamma**2 / omega**2 * At(S, {s: -1} | units),
    exp(2 * u) * (w**2 / 2 + u / 2 - sympy.Rational(1, 4)),
)
