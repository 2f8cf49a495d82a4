"""The energies of two motions in one well never part: dV(q) = dV(p) exp(-int dh/dv dt), whatever the spring.

From the turning point (p, 0) the motion x'' + V'(x) + h(x, x') = 0 runs to the next one, (-q, 0); V even, V' > 0 on
the way.  The Wronskian of x' and of dx/dp is known, and it is V'(p) at the start and V'(q) dq/dp at the end.  Where h
is not smooth at a turning point (0 < alpha < 1) both are taken on the sections x' = -eta, between which the field is
smooth, and eta -> 0: J converges by step 7.  A kink |x|^m or x|x|^(p-1) at x = 0 is crossed once, and f_x has left the
formula.

>>> print(derivation.steps[0].right)
-f_v*(v*y_1 - v_1*y)
"""

import sympy

from derivations.steps import At, Derivation, Solution

v, v1, v2, y, y1, y2, fx, fv = sympy.symbols("v v_1 v_2 y y_1 y_2 f_x f_v", real=True)
p, q, w, t, g, T, epsilon = sympy.symbols("p q w t g T epsilon", positive=True)
alpha, slope, elapsed, J = sympy.symbols("alpha q' T' J", positive=True)
force, friction = (sympy.Function(name, positive=True) for name in ("V'", "h_0"))

derivation = Derivation(
    "energy-contraction",
    "The energies of two motions never part",
    source="Liouville's formula; asymptotics.limit_cycles.certified uses it with V = x^2/2",
)
step, asserts = derivation.step, derivation.asserts

wronskian = v * y1 - v1 * y
step(
    "x'' = -f(x, v), f = V' + h.  v = x' and y = dx/dp both obey y'' = -f_x y - f_v y'; their Wronskian changes at",
    At(v * y2 - v2 * y, {y2: -fx * y - fv * y1, v2: -fx * v - fv * v1}),
    -fv * wronskian,
)
step(
    "At the start x = p, v = 0: y = 1, y' = 0 and v' = -V'(p), so the Wronskian is",
    At(wronskian, {v: 0, v1: -force(p), y: 1, y1: 0}),
    force(p),
)
step(
    "At the end x(T(p), p) = -q(p): differentiated, v T' + y = -q'; with v = 0 this is y",
    At(-slope - v * elapsed, {v: 0}),
    -slope,
)
step(
    "and v' = -V'(-q) = V'(q), so the Wronskian is V'(q) dq/dp",
    At(wronskian, {v: 0, v1: force(q), y: -slope}),
    force(q) * slope,
)
rate, s = sympy.Function("f_v", real=True), sympy.Symbol("s", real=True)
decay = sympy.exp(-sympy.Integral(rate(s), (s, 0, t)))
step(
    "W' = -f_v W is solved by e^(-int f_v dt): hence V'(q) dq = V'(p) dp e^(-J), J = int f_v dt over the half-swing",
    sympy.Derivative(decay, t),
    -rate(t) * decay,
)
step(
    "A loss eps |x|^m v|v|^(alpha-1), eps >= 0, has h_v >= 0 (|v| = w), a spring V' has none: 0 < dV(q)/dV(p) <= 1",
    sympy.Derivative(epsilon * w**alpha, w),
    alpha * epsilon * w**alpha / w,
)
step(
    "For 0 < alpha < 1 it is integrable at a turning point, where |v| = g t + ..., g > 0",
    sympy.Integral(alpha * epsilon * (g * t) ** (alpha - 1), (t, 0, T)),
    epsilon * g ** (alpha - 1) * T**alpha,
)
step(
    "Dry friction (alpha = 0) is -h_0(x) on the way from p to -q, no part of h_v, and it enters at the ends: the start",
    At(wronskian, {v: 0, v1: -force(p) + friction(p), y: 1, y1: 0}),
    force(p) - friction(p),
)
step(
    "and the end: (V'(q) + h_0(q)) dq = (V'(p) - h_0(p)) dp e^(-J), and dV(q) <= dV(p) all the more",
    At(wronskian, {v: 0, v1: force(q) + friction(q), y: -slope}),
    (force(q) + friction(q)) * slope,
)

# Two laws whose map is known.
root = sympy.sqrt(4 - epsilon**2)
ratio = sympy.exp(-sympy.pi * epsilon / root)
z = sympy.Symbol("z")
step(
    "Linear spring and loss: x = e^(z t), z = -eps/2 + i omega, omega = sqrt(4 - eps^2)/2",
    At(z**2 + epsilon * z + 1, {z: (-epsilon + sympy.I * root) / 2}),
    sympy.Integer(0),
)
step(
    "T = pi/omega, q = p e^(-eps T/2) and J = eps T: q dq/dp is p e^(-J)",
    p * ratio * sympy.Derivative(p * ratio, p),
    p * sympy.exp(-2 * sympy.pi * epsilon / root),
)
x = sympy.Symbol("x", real=True)
potential = sympy.Function("V")
constant = sympy.exp(-2 * epsilon * x)
u = sympy.Function("u")(x)
step(
    "Quadratic loss, any spring: u = v^2/2 obeys du/dx = -V' + 2 eps u on the way, so u e^(-2 eps x) changes at",
    At(sympy.Derivative(u * constant, x), {sympy.Derivative(u, x): -sympy.diff(potential(x), x) + 2 * epsilon * u}),
    -sympy.Derivative(potential(x), x) * constant,
)
reach = sympy.Function("q")(p)
step(
    "so int_-q^p V' e^(-2 eps x) dx = 0 for every p; with V' odd its derivative is",
    At(sympy.Derivative(sympy.Integral(force(x) * constant, (x, -reach, p)), p), {force(-reach): -force(reach)}),
    force(p) * sympy.exp(-2 * epsilon * p) - force(reach) * sympy.exp(2 * epsilon * reach) * sympy.Derivative(reach, p),
)
step(
    "which is 0 for dq/dp = V'(p)/V'(q) e^(-J), J = 2 eps int |v| dt = 2 eps (p + q)",
    Solution(force(p) * sympy.exp(-2 * epsilon * p), force(q) * sympy.exp(2 * epsilon * q) * slope, slope),
    force(p) / force(q) * sympy.exp(-2 * epsilon * (p + q)),
)

step(
    "So a ball of energies does not grow: |V(q_1) - V(q_2)| = |int e^(-J) dV| <= |V(p_1) - V(p_2)|; at J = 0 equality",
    At(sympy.exp(-J), {J: 0}),
    sympy.Integer(1),
)
step(
    "Near miss, amplitudes in the place of energies: in dq/dp = V'(p)/V'(q) e^(-J) the first factor,"
    " for a pendulum from p = pi/2 to q = pi/6, is",
    At(sympy.sin(p) / sympy.sin(q), {p: sympy.pi / 2, q: sympy.pi / 6}),
    sympy.Integer(2),
)
asserts(
    "Near miss, a gain: with eps < 0 the factor e^(-J) exceeds 1 and energies part; with linear gain, eps = -1/10,",
    sympy.Gt(At(sympy.exp(-2 * sympy.pi * epsilon / root), {epsilon: -sympy.Rational(1, 10)}), 1, evaluate=False),
)
