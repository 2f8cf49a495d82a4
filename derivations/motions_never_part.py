"""Two motions never part: their Euclidean distance in the phase plane does not grow, whatever the loss.

For x' = v, v' = -x - g(v) with g nondecreasing (dry friction included: g(0) is then any value between the one-sided
limits), and for approximants with a residual.  Turning points and half periods inherit the bound.

>>> derivation.steps[0].right
-V*(g_1 - g_2)
"""

import sympy

from derivations.steps import At, Derivation, defined

X, V, r1, r2 = sympy.symbols("X V r_1 r_2", real=True)
v, v1, x1 = sympy.symbols("v v_1 x_1", real=True)
g1, g2 = sympy.symbols("g_1 g_2", real=True)
p, q, d, f, w, c = sympy.symbols("p q d f w c", positive=True)
a = sympy.Symbol("a", positive=True)

derivation = Derivation(
    "motions-never-part",
    "Two motions never part",
    source="monotone operators (Brezis 1973) in one degree of freedom",
)
step, asserts = derivation.step, derivation.asserts

elapsed = sympy.Symbol("t", real=True)


def rate_of_square(x_rate: sympy.Expr, v_rate: sympy.Expr) -> sympy.Expr:
    """d/dt of (X^2 + V^2)/2 along X' = x_rate, V' = v_rate."""
    x, y = sympy.Function("X")(elapsed), sympy.Function("V")(elapsed)
    rates = {sympy.Derivative(x, elapsed): x_rate, sympy.Derivative(y, elapsed): v_rate, x: X, y: V}
    return At(sympy.Derivative((x**2 + y**2) / 2, elapsed), rates)


step(
    "X, V: the differences of two solutions in x and v.  Half the square of their distance changes at the rate",
    rate_of_square(V, -X - g1 + g2),
    -V * (g1 - g2),
)
step(
    "The rate is <= 0, as V = v_1 - v_2 and g_1 - g_2 have the same sign: g is odd, and for v > 0 each term grows",
    sympy.Derivative(w**a, w),
    a * w ** (a - 1),
)
step(
    "An approximant with the residual (r_1, r_2) adds to the rate the first two terms,",
    rate_of_square(V + r1, -X - g1 + g2 + r2),
    X * r1 + V * r2 - V * (g1 - g2),
)
asserts(
    "which is at most the distance times |(r_1, r_2)|: the distance grows at most by the integral of the residual",
    sympy.Le((X * r1 + V * r2) ** 2, (X**2 + V**2) * (r1**2 + r2**2), evaluate=False),
)
step(
    "The energy falls: |x| at a turning point is never exceeded later",
    At(rate_of_square(V, -X - g1), {X: x1, V: v1}),
    -v1 * g1,
)
step(
    "Turning points of two orbits d apart: when the first turns, at -p, the second is at most at -p + d and falls on,"
    " so it turns at -q with q >= p - d; the slack is",
    At(p - q, {q: p - d}),
    d,
)
step(
    "and when the second turns, at -q, the first has turned and stays above -p, so -q >= -p - d: at the extreme",
    At(q - p, {q: p + d}),
    d,
)
step(
    "Half periods: when one orbit turns the other moves with w <= d at y <= -(p - 2 d) - f (f: friction, y = u - f),"
    " whichever of them it is; w' = y - N(w) <= y, so it turns within",
    At(d / -v, {v: -(p - 2 * d) - f}),
    d / (p - 2 * d + f),
)
step(
    "Relative contraction: in units of c the orbit from c p has the damping N(c w)/c; for N = w^a",
    defined("N", lambda w: w**a)(c * w) / c,
    c ** (a - 1) * w**a,
)
step(
    "For c > 1 this is at least N(w) if a >= 1 (every exponent of a sum): c^(a-1) is 1 at c = 1 and does not fall, as",
    sympy.Derivative(c ** (a - 1), c),
    (a - 1) * c ** (a - 2),
)
step(
    "and w dw/dy = N(w) - y says that more damping ends at a smaller amplitude: q(c p) <= c q(p), that is"
    " d ln q/d ln p <= 1; for linear damping q = p e^(-k), and it is",
    sympy.Derivative(sympy.log(p * sympy.exp(-d)), p) * p,
    1,
)
asserts(
    "For a < 1 it fails: relative errors can grow (ratio-growth bounds by how much)",
    sympy.Lt(At(c ** (a - 1), {a: sympy.Rational(1, 2), c: 2}), 1, evaluate=False),
)
