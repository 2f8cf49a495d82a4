"""A motion beside the true one: whatever fulfils the equation up to a residual is as near as jumps and residual say.

For x'' = -k x - F(x') with F nondecreasing (dry friction: F(0) is what holds the mass) and y of pieces with
y'' = -k y - F(y') + r.  On it, and on nothing else, rests the checker of certificates.

>>> derivation.steps[0].right
-V*r - V*(g_1 - g_2)
"""

import sympy

from derivations.steps import At, Derivation

X, V, r, u = sympy.symbols("X V r u", real=True)
g1, g2, b, c = sympy.symbols("g_1 g_2 b c", real=True)
k, H, s, v, w, a, S = sympy.symbols("k H s v w a S", positive=True)
h, R, q, m = sympy.symbols("h R q m", positive=True)
t = sympy.Symbol("t", real=True)

derivation = Derivation(
    "defect-bound",
    "A motion beside the true one",
    source="monotone operators (Brezis 1973); an approximant with a defect and jumps",
)
step, asserts = derivation.step, derivation.asserts


def rate(x_rate: sympy.Expr, v_rate: sympy.Expr, of: sympy.Expr) -> sympy.Expr:
    """d/dt of an expression in X and V along X' = x_rate, V' = v_rate."""
    x, y = sympy.Function("X")(t), sympy.Function("V")(t)
    rates = {sympy.Derivative(x, t): x_rate, sympy.Derivative(y, t): v_rate, x: X, y: V}
    return At(sympy.Derivative(of.subs({X: x, V: y}, simultaneous=True), t), rates)


step(
    "X = x - y, V = x' - y', the forces g_1 = F(x'), g_2 = F(y').  Half of E^2 = k X^2 + V^2 changes at the rate",
    rate(V, -k * X - g1 + g2 - r, (k * X**2 + V**2) / 2),
    -V * (g1 - g2) - V * r,
)
step(
    "The first term is <= 0: V = x' - y' and g_1 - g_2 have the same sign, as each term of F grows,",
    sympy.Derivative(w**a, w),
    a * w ** (a - 1),
)
step(
    "and where dry friction holds the mass, x' = 0 and g_1 = H - s with 0 <= s <= 2 H, while y' = v > 0 and g_2 = H:",
    At((g1 - g2) * (0 - v), {g1: H - s, g2: H}),
    s * v,
)
asserts(
    "So E E' <= |V r|, which is at most E |r|,",
    sympy.Le((V * r) ** 2, r**2 * (k * X**2 + V**2), evaluate=False),
)
step(
    "and E <= E_0 + the integral of |r|: over a piece of the length S, with a bound of |r|, that is",
    sympy.Integral(R, (s, 0, S)),
    S * R,
)
asserts(
    "A jump (b, c) of (y, y') changes E by at most its own size, by the inequality of Cauchy",
    sympy.Le((k * X * b + V * c) ** 2, (k * X**2 + V**2) * (k * b**2 + c**2), evaluate=False),
)
asserts(
    "which is at most sqrt(k) |b| + |c|",
    sympy.Ge((sympy.sqrt(k) * abs(b) + abs(c)) ** 2, k * b**2 + c**2, evaluate=False),
)
step(
    "Nothing less will do.  With F(v) = -v, which falls, the first term is >= 0,",
    At(-V * (g1 - g2), {g1: -V, g2: 0}),
    V**2,
)
step(
    "and with another spring beside the one of E, x'' = -2 k x, a term of either sign is left:",
    rate(V, -2 * k * X, (k * X**2 + V**2) / 2),
    -k * V * X,
)
power, speed = sympy.Function("W")(u), sympy.Function("V")(u)
step(
    "The power V^a of a polynomial by another one, W: the logarithm of W/V^a has the derivative",
    sympy.Derivative(sympy.log(power) - a * sympy.log(speed), u),
    (speed * power.diff(u) - a * power * speed.diff(u)) / (speed * power),
)
step(
    "At u = 0 it is the logarithm of a number R >= 1 or of 1/R, and ln R <= R - 1: both are 0 at R = 1, and then",
    sympy.Derivative(R - 1 - sympy.log(R), R),
    1 - 1 / R,
)
step(
    "If |ln(W/V^a)| <= h then |W - V^a| <= W (e^h - 1) <= W h/(1 - h), as (1 - h) e^h begins with 1 and falls:",
    sympy.Derivative((1 - h) * sympy.exp(h), h),
    -h * sympy.exp(h),
)
z = sympy.Symbol("z", positive=True)
step(
    "From rest y = P(z), z = s^(1/q): a power z^n gives the speed",
    At(sympy.Derivative(s ** (m / q), s), {s: z**q}),
    m * z ** (m - q) / q,
)
step(
    "and the acceleration, so that no power between 0 and 2 q may be there",
    At(sympy.Derivative(s ** (m / q), (s, 2)), {s: z**q}),
    m * (m - q) * z ** (m - 2 * q) / q**2,
)
