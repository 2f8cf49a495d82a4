"""A turning point beside a rest of an approximant: there is one, one only, how near and when.

y rests at the time T at y_T, E bounds the distance from the true motion (``defect-bound``), |y'| >= (s/S) V_low at the
distance s <= S in time, and V_low > E.  h = H/k is where dry friction just holds the mass.

>>> len(derivation.steps) > 10
True
"""

import sympy

from derivations.steps import At, Derivation, Solution

s, S, E, V_low, k, H, d, g, x, y = sympy.symbols("s S E V_low k H d g x y", positive=True)
f, v, b, r, eta, X = sympy.symbols("f v b r eta X", real=True)
t = sympy.Symbol("t", real=True)

derivation = Derivation(
    "landing",
    "A turning point beside a rest of an approximant",
    source="energy about the place of rest under friction; a speed whose zeros all fall",
)
step, asserts = derivation.step, derivation.asserts
position, speed = sympy.Function("x")(t), sympy.Function("v")(t)


def energy_rate(centre: sympy.Expr, force: sympy.Expr) -> sympy.Expr:
    """Half the rate of k (x + centre)^2 + x'^2 along x'' = -k x - force."""
    rates = {sympy.Derivative(position, t): v, sympy.Derivative(speed, t): -k * X - force, position: X, speed: v}
    return At(sympy.Derivative((k * (position + centre) ** 2 + speed**2) / 2, t), rates)


step(
    "|x' - y'| <= E: the true speed has the sign of y' where |y'| > E, which is so farther from T than",
    Solution(s / S * V_low, E, s),
    S * E / V_low,
)
asserts("and this is within the piece if E < V_low,", sympy.Lt(S * V_low / (V_low + d), S, evaluate=False))
step(
    "Where x' = 0 and k x = H + d, what holds the mass is at most H: the acceleration is at most",
    At(-k * x - f, {x: (H + d) / k, f: -H}),
    -d,
)
step(
    "so the speed falls through each of its zeros at k x > H.  Where k x = H - d it stays: friction f is",
    Solution(-k * (H - d) / k - f, 0, f),
    d - H,
)
asserts(
    "which is within what friction holds (d <= H, here half of it)", sympy.Ge(At(d - H, {d: H / 2}), -H, evaluate=False)
)
step(
    "Arriving, there is one: a mass that moves on with v > 0 is slowed down by k x + F(v), which is g at the least,",
    At(k * x + f, {x: y - E / sympy.sqrt(k), f: H}),
    k * y - sympy.sqrt(k) * E + H,
)
step("and from v <= E it rests after", Solution(E - g * s, 0, s), E / g)
step(
    "On the way up, where F = H + f with f >= 0, half of k (x + H/k)^2 + x'^2 falls,",
    energy_rate(H / k, H + f),
    -f * v,
)
asserts(
    "so at that rest sqrt(k) (x + H/k) <= sqrt(k) (y_T + H/k) + E, by Cauchy for (sqrt(k) y, 0) and what is off,",
    sympy.Le((sympy.sqrt(k) * y * b + 0 * v) ** 2, k * y**2 * (b**2 + v**2), evaluate=False),
)
step(
    "The same of y, half of R^2, changes by r beside it: R changes by |r| at most, as |y'| <= R,",
    energy_rate(H / k, H + f - r),
    -f * v + r * v,
)
step(
    "and g = d > 0 says that at T, where y' = 0, R = sqrt(k) (y_T + H/k) is more than E by",
    At(sympy.sqrt(k) * (X + H / k) - E, {X: (d - H) / k + E / sympy.sqrt(k)}),
    d / sympy.sqrt(k),
)
step(
    "A second rest in the piece is at x_3 = -(H + d)/k: if eta = y + H/k >= 0 there, y is farther than eta from it by",
    At(y - x - eta, {x: -(H + d) / k, y: eta - H / k}),
    d / k,
)
step(
    "and if eta = -s < 0 it was so at the first one too, at x_1 = (H + d)/k, from which y is farther than |eta| by",
    At(x - y - s, {x: (H + d) / k, y: -s - H / k}),
    (2 * H + d) / k,
)
step(
    "either way the distance is more than R, and that more than E less what r adds: no second rest.  Leaving downwards,"
    " f v >= 0, and half of k y^2 + y'^2 changes by",
    energy_rate(0, f - r),
    -f * v + r * v,
)
asserts(
    "A rest of x at x = -d beside y >= 0: the distance is k y^2 + y'^2 at the least, so |y'| <= E there and at the end",
    sympy.Ge(k * (y + d) ** 2 + v**2, k * y**2 + v**2, evaluate=False),
)
step(
    "and beside y = -s < 0, y' = -v: spring and losses add to y'' = -k y - F + r at least r",
    At(-k * y - f + r, {y: -s, f: -g}) - r,
    k * s + g,
)
asserts(
    "Nothing less than g > 0 will do: y_T = E/(2 sqrt(k)), H = 0 has g < 0, and x may be beyond the centre",
    sympy.Lt(At(k * (y - E / sympy.sqrt(k)), {y: E / (2 * sympy.sqrt(k))}), 0, evaluate=False),
)
asserts(
    "The time alone does not tell how near: with E/g and the speed E the mass could move farther than E/sqrt(k)",
    sympy.Gt(At(E**2 / g, {g: sympy.sqrt(k) * E / 2}), E / sympy.sqrt(k), evaluate=False),
)
