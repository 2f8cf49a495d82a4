"""A turning point beside a rest of an approximant: there is one, one only, how near and when.

y rests at the time T at y_T, E bounds the distance from the true motion (``defect-bound``), and |y'| >= (s/S) V_low at
the distance s <= S in time.

>>> len(derivation.steps) > 6
True
"""

import sympy

from derivations.steps import At, Derivation, Solution

s, S, E, V_low, V_high, k, H, d, g, x, y = sympy.symbols("s S E V_low V_high k H d g x y", positive=True)
f, v, b = sympy.symbols("f v b", real=True)
t = sympy.Symbol("t", real=True)

derivation = Derivation(
    "landing",
    "A turning point beside a rest of an approximant",
    source="energy; a speed whose zeros all fall",
)
step, asserts = derivation.step, derivation.asserts

step(
    "|x' - y'| <= E: the true speed has the sign of y' where |y'| > E, which is so farther from T than",
    Solution(s / S * V_low, E, s),
    S * E / V_low,
)
asserts("and this is within the piece if E < V_low,", sympy.Lt(S * V_low / (V_low + d), S, evaluate=False))
step(
    "In that time y, with |y'| <= (s/S) V_high, moves at most by D,",
    sympy.Integral(s / S * V_high, (s, 0, S * E / V_low)),
    S * E**2 * V_high / (2 * V_low**2),
)
step(
    "so that |y_T| = D + E/sqrt(k) + d leaves |x| >= d > 0 there: x has one sign",
    At(y - S * E**2 * V_high / (2 * V_low**2) - E / sympy.sqrt(k),
       {y: S * E**2 * V_high / (2 * V_low**2) + E / sympy.sqrt(k) + d}),
    d,
)  # fmt: skip
step(
    "Where x' = 0 and k x = H + d, what holds the mass is at most H: the acceleration is at most",
    At(-k * x - f, {x: (H + d) / k, f: -H}),
    -d,
)
step(
    "so the speed falls through each of its zeros and has one at most.  Where k x = H - d it stays: friction f is",
    Solution(-k * (H - d) / k - f, 0, f),
    d - H,
)
asserts(
    "which is within what friction holds (d <= H, here half of it)", sympy.Ge(At(d - H, {d: H / 2}), -H, evaluate=False)
)
step(
    "There is one: a mass that moves on with v > 0 is slowed down by k x + F(v), which is g at the least,",
    At(k * x + f, {x: y - E / sympy.sqrt(k), f: H}),
    k * y - sympy.sqrt(k) * E + H,
)
step("and from v <= E it rests after", Solution(E - g * s, 0, s), E / g)
position, speed = sympy.Function("x")(t), sympy.Function("v")(t)
rates = {sympy.Derivative(position, t): v, sympy.Derivative(speed, t): -k * x - f, position: x, speed: v}
step(
    "Energy only falls, as f v >= 0,",
    At(sympy.Derivative((k * position**2 + speed**2) / 2, t), rates),
    -f * v,
)
asserts(
    "so at that rest sqrt(k) |x| <= sqrt(k) y_T + E, by the inequality of Cauchy for (sqrt(k) y_T, 0) and what is off,",
    sympy.Le((sympy.sqrt(k) * y * b + 0 * v) ** 2, k * y**2 * (b**2 + v**2), evaluate=False),
)
step(
    "Before the centre, at y_T = -y, g > 0 asks for k (y + E/sqrt(k)) < H: then y_T is a rest as well, and y is below",
    Solution(H - k * (y + E / sympy.sqrt(k)), 0, y),
    H / k - E / sympy.sqrt(k),
)
asserts(
    "The time alone does not tell how near: with E/g and the speed E the mass could move farther than E/sqrt(k)",
    sympy.Gt(At(E**2 / g, {g: sympy.sqrt(k) * E / 2}), E / sympy.sqrt(k), evaluate=False),
)
