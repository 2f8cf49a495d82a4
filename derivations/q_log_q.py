"""Quadratic damping, alpha = 2: q = e^(-u) gives q'' = -q ln q, and its energy is Smith's S.

>>> print(derivation.steps[6].text())
E*Subs(y*exp(y), y, r - 1) = (r - 1)*exp(r)
"""

import sympy

from derivations.steps import At, Derivation

tau = sympy.Symbol("tau", real=True)
s = sympy.Symbol("s", nonzero=True, real=True)
w, Y = sympy.symbols("w Y", real=True)
u = sympy.Function("u", real=True)(tau)
Q = sympy.Function("q", positive=True)(tau)
q = sympy.Symbol("q", positive=True)
exp, log, diff = sympy.exp, sympy.log, sympy.diff

derivation = Derivation(
    "q-log-q",
    "Quadratic damping as a conservative motion, q'' = -q ln q",
    source="Smith 2012, (35)-(43); theory page finite_strength",
)
step = derivation.step

acceleration = -u + s * diff(u, tau) ** 2
step(
    "u'' = -u + s u'^2 with s = +1 for u' < 0 and s = -1 for u' > 0.  Put q = e^(-s u): the square of u' drops out",
    At(sympy.Derivative(exp(-s * u), tau, 2), {sympy.Derivative(u, tau, 2): acceleration}),
    s * u * exp(-s * u),
)
step(
    "that is q'' = -q ln q on either half-swing, since s u = -ln q",
    At(s * u * exp(-s * u), {u: -log(Q) / s}),
    -Q * log(Q),
)
U = q**2 * log(q) / 2 - q**2 / 4
step("a conservative motion in the potential", sympy.Derivative(U, q), q * log(q))
energy = diff(Q, tau) ** 2 / 2 + U.subs(q, Q)
step(
    "so E = q'^2/2 + (q^2/2) ln q - q^2/4 is constant",
    At(sympy.Derivative(energy, tau), {sympy.Derivative(Q, tau, 2): -Q * log(Q)}),
    0,
)
v = sympy.Symbol("u_value", real=True)
place = {q: exp(-s * v)}
step(
    "back in u with w = u': E = e^(-2 s u) (s^2 w^2/2 - s u/2 - 1/4), Smith's constant S for s^2 = 1",
    At(At((s * w * q) ** 2 / 2 + U, place), {log(exp(-s * v)): -s * v}),
    (exp(-2 * s * v) * (s**2 * w**2 / 2 - s * v / 2 - sympy.Rational(1, 4))).expand(),
)
p, r = sympy.symbols("p r", positive=True)
y = sympy.Symbol("y")
at_rest = exp(-2 * v) * (-v / 2 - sympy.Rational(1, 4))
step(
    "from rest at u = p/2 to rest at u = -r/2 (s = 1) it gives (1 + p) e^(-p) = (1 - r) e^r (Smith (43))",
    -4 * (At(at_rest, {v: p / 2}) - At(at_rest, {v: -r / 2})),
    (1 + p) * exp(-p) - (1 - r) * exp(r),
)
step(
    "hence r = 1 + W(-(1+p) e^(-p-1)), the principal branch because r < 1: y = r - 1 solves y e^y = -(1+p) e^(-p-1)",
    At(y * exp(y), {y: r - 1}) * sympy.E,
    -(1 - r) * exp(r),
)
t = sympy.Symbol("t", positive=True)
square = sympy.solve(
    sympy.Eq(exp(-2 * v) * (Y / 2 - v / 2 - sympy.Rational(1, 4)), -(1 + p) * exp(-p) / 4), Y
)[0]  # fmt: skip
step(
    "and the speed at u = (p - t)/2: 2 w^2 = (1+p)(1 - e^(-t)) - t",
    2 * At(square, {v: (p - t) / 2}),
    sympy.expand((1 + p) * (1 - exp(-t)) - t),
)
