"""From S to the turning points: the equation (43), its Lambert form, no overdamping, and q'' = -q ln q.

>>> sympy.N(next_size.subs(u0, 1), 12)
0.410719686061
"""

import sympy

from derivations.steps import At, Derivation, defined

u0, q = sympy.symbols("u_0 q", positive=True)
u, w, L = sympy.symbols("u w L", real=True)
tau = sympy.Symbol("tau", real=True)
exp, diff, log, sqrt = sympy.exp, sympy.diff, sympy.log, sympy.sqrt
half, quarter = sympy.Rational(1, 2), sympy.Rational(1, 4)

derivation = Derivation(
    "smith-turning-points",
    "Turning points, Lambert's W, and why there is no overdamping",
    source="Smith 2012, (41)-(46c), (51)-(52b); smith2012:43, 44, 45, 46c; Lambert's form is not in the paper",
)
step, asserts = derivation.step, derivation.asserts

value = sympy.Symbol("S")
S = exp(-2 * u) * (w**2 / 2 - u / 2 - quarter)
g = exp(-2 * u) * (2 * u + 1)
start = g.subs(u, u0)
step("With g(u) = e^{-2u}(2u+1), a turning point (w = 0) has -4 S = g(u)", -4 * At(S, {w: 0}), g)
step("g rises to its maximum 1 at u = 0 and falls from there", sympy.Derivative(g, u), -4 * u * exp(-2 * u))
asserts(
    "from minus infinity up to g(0) = 1 and down to 0",
    sympy.Eq(sympy.Limit(g, u, -sympy.oo), -sympy.oo, evaluate=False),
    sympy.Eq(At(g, {u: 0}), 1, evaluate=False),
    sympy.Eq(sympy.Limit(g, u, sympy.oo), 0, evaluate=False),
)
g_of = defined("g", lambda place: g.subs(u, place))
squared = (u + half) - exp(2 * u) * start / 2
step("The speed on the falling orbit from (u_0, 0)", At(S, {w: sqrt(squared)}), -start / 4)
step(
    "is positive exactly where g(u) > g(u_0): between u_0 and the other root u_1 < 0 of (43)",
    squared,
    exp(2 * u) * (g_of(u) - g_of(u0)) / 2,
)
step(
    "(45): at u = 0 it is not zero, since g(u_0) < 1: the origin is passed, never approached",
    At(squared, {u: 0}),
    (1 - start) / 2,
)
step(
    "The acceleration w^2 - u is S-linear and falls with u, so that it has one zero",
    At(half + 2 * value * exp(2 * u), {value: S}),
    w**2 - u,
)
turning = u0 - log(2 * u0 + 1) / 2
step("(46c): that zero", At(half - start / 2 * exp(2 * u), {u: turning}), sympy.Integer(0))

y = 1 + 2 * u0
step(
    "(43) in L = -(2u_1+1): multiply g(u_1) = g(u_0) by -1/e; with y = 1 + 2u_0 it is L e^L = -y e^{-y}",
    -At(g, {u: -(L + 1) / 2}) / sympy.E,
    L * exp(L),
)
step("the right side likewise", -At(g, {u: u0}) / sympy.E, -y * exp(-y))
step(
    "L = -y is one root, the branch W_{-1}, since y > 1: the starting point itself",
    At(L * exp(L), {L: -y}),
    -y * exp(-y),
)
root = sympy.LambertW(-y * exp(-y))
next_size = (1 + root) / 2
step(
    "L e^L rises from -1/e to 0 as L goes from -1 to 0, so there is exactly one other root, in (-1, 0):"
    " L = W_0(-y e^{-y}),"
    " and 2|u_1| = -2u_1 = 1 + W_0(-y e^{-y})",
    sympy.Derivative(L * exp(L), L),
    (1 + L) * exp(L),
)
step(
    "At u_1 = -|u_1| g has the value it started with, by W e^W = -y e^{-y} (here W stands for L)",
    At(At(g, {u: -(1 + L) / 2}) - start, {exp(L): -y * exp(-y) / L}),
    sympy.Integer(0),
)
inner = sympy.Symbol("r", positive=True)
asserts(
    "W_0 maps (-1/e, 0) into (-1, 0), where L = -1/(1 + r), r > 0: 0 < |u_1| = (1 + L)/2 < 1/2 for every u_0 > 0:"
    " never overdamped, whatever the strength",
    sympy.Eq(At(L * exp(L), {L: -1}), -1 / sympy.E, evaluate=False),
    sympy.Gt(At(sympy.Derivative(L * exp(L), L), {L: -1 / (1 + inner)}), 0, evaluate=False),
    sympy.Gt(At((1 + L) / 2, {L: -1 / (1 + inner)}), 0, evaluate=False),
    sympy.Lt(At((1 + L) / 2, {L: -1 / (1 + inner)}), half, evaluate=False),
)
step(
    "The rising half-swing is the mirror image, S^+(u, w) = S^-(-u, -w): the same map for |u_n|, all n",
    At(S, {u: -u, w: 0}),
    exp(2 * u) * (2 * u - 1) / 4,
)

path = sympy.Function("u")(tau)
for sign, reason in ((1, "u' < 0: q = e^{-u} obeys q'' = -q ln q"), (-1, "u' > 0: q = e^{u} obeys the same equation")):
    velocity = diff(path, tau)
    acceleration = sign * velocity**2 - path
    carrier = exp(-sign * path)
    step(
        reason,
        At(sympy.Derivative(carrier, tau, 2), {sympy.Derivative(path, tau, 2): acceleration}),
        -carrier * (-sign * path),
    )
rate = sympy.Symbol("p", real=True)
energy = rate**2 / 2 + q**2 * (2 * log(q) - 1) / 4
step("whose energy", sympy.Derivative(energy, q), q * log(q))
step(
    "is Smith's constant: E(q = e^{-u}, q' = -w e^{-u}) = S^-",
    At(energy, {q: exp(-u), rate: -w * exp(-u)}),
    S,
)

# Two ways to solve (43) by iteration, g(u) = c, c = g(u_0), for the root u_1 in (-1/2, 0).
c = sympy.Symbol("c", positive=True)
forward = defined("h", lambda place, level: (level * exp(2 * place) - 1) / 2)
step("(43), g(u) = c, is u = h(u) = (c e^{2u} - 1)/2: with c = g(u)", At(forward(u, c), {c: g_of(u)}), u)
step("At the root the slope of h is", At(sympy.Derivative(forward(u, c), u), {c: g_of(u)}), 1 + 2 * u)
asserts(
    "between 0 and 1 there, as -1/2 < u_1 = -1/(2(1 + r)) < 0: the iteration u -> h(u) converges",
    sympy.Gt(At(1 + 2 * u, {u: -half / (1 + inner)}), 0, evaluate=False),
    sympy.Lt(At(1 + 2 * u, {u: -half / (1 + inner)}), 1, evaluate=False),
    corrects=("smith2012:claim.iterations",),
)
step(
    "from u = 0 on: h rises, and between u_1 and 0, where g(u) > c, it falls below u and not below u_1 = h(u_1):",
    forward(u, c) - u,
    exp(2 * u) * (c - g_of(u)) / 2,
)
step(
    "Near miss: the other way, u = (1/2) ln((2u + 1)/c), has the slope 1/(1 + 2u), larger than 1: it runs away",
    sympy.Derivative(log((2 * u + 1) / c) / 2, u),
    1 / (1 + 2 * u),
)
