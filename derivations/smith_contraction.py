"""The quadratic map contracts: 2/3 < 1/q - 1/p < 1 (so < 2) for p = 2|u_n|, q = 2|u_(n+1)|, and 0 < F' < 1.

The bounds that ``asymptotics.turning_points`` relies on; the upper bound needed there is 2, the one proved is 1.

>>> print(derivation.steps[8].text())
Subs((lambda*p + 1)**2*(p*(lambda - 1) + 1), lambda, 2/3) = -4*p**3/27 + p + 1
"""

import sympy

from derivations.steps import At, Coefficient, Derivation, Solution, Taylor, defined

p, q, lam = sympy.symbols("p q lambda", positive=True)
log = sympy.log
third = sympy.Rational(1, 3)

derivation = Derivation(
    "smith-contraction",
    "Neighbouring turning points: bounds on 1/q - 1/p, and the map is a contraction",
    source="Smith 2012, (43) gives the map; the bounds are not in the paper",
)
step, asserts = derivation.step, derivation.asserts


def h(p: sympy.Expr) -> sympy.Expr:
    """p - log(1+p), the start of the half-swing."""
    return p - log(1 + p)


def k(q: sympy.Expr) -> sympy.Expr:
    """-q - log(1-q), its end: h(p) = k(q) defines q = F(p)."""
    return -q - log(1 - q)


u = sympy.Symbol("u", real=True)
g = sympy.exp(-2 * u) * (1 + 2 * u)
log_g = log(1 + 2 * u) - 2 * u
size = sympy.Symbol("x", positive=True)  # 1 + 2u
step(
    "Smith (43): g = e^{-2u}(1+2u) is the same at both ends; its logarithm, where 1 + 2u = x > 0, is that of 1 + 2u"
    " less 2u,",
    At(log(g), {u: (size - 1) / 2}),
    At(log_g, {u: (size - 1) / 2}),
)
h_of, k_of = defined("h", h), defined("k", k)
step("is -h(p) at the start u = p/2", At(log_g, {u: p / 2}), -h_of(p))
step("and -k(q) at the end u = -q/2: h(p) = k(q)", At(log_g, {u: -q / 2}), -k_of(q))
step("h rises from 0 to infinity on p > 0", sympy.Derivative(h_of(p), p), p / (1 + p))
step(
    "k rises from 0 to infinity on 0 < q < 1: one q = F(p) for each p > 0",
    sympy.Derivative(k_of(q), q),
    q / (1 - q),
)
trial = p / (1 + lam * p)
step("Compare q with the one that has 1/q = 1/p + lambda", Solution(1 / q, 1 / p + lam, q), trial)
product = (1 + (lam - 1) * p) * (1 + lam * p) ** 2
step(
    "d/dp [h(p) - k(p/(1 + lambda p))] = p/(1+p) - p/P(p), P = (1 + (lambda-1) p)(1 + lambda p)^2; both start at 0,"
    " so the sign is that of P - (1+p)",
    sympy.Derivative(h_of(p) - k_of(trial), p),
    p / (1 + p) - p / product,
)
step("lambda = 1: P = (1+p)^2", At(product, {lam: 1}), (1 + p) ** 2)
step("lambda = 2/3: P", At(product, {lam: 2 * third}), 1 + p - 4 * third**3 * p**3)
step("and lambda = 2: P", At(product, {lam: 2}), (1 + p) * (1 + 2 * p) ** 2)
for value in (1, 2):
    asserts(
        f"lambda = {value}: P > 1 + p, so k(p/(1 + lambda p)) < h(p) = k(q), p/(1 + lambda p) < q: 1/q - 1/p < {value}",
        sympy.Gt(At(product, {lam: value}), 1 + p, evaluate=False),
    )
ratio = sympy.Symbol("r", positive=True)
asserts(
    "lambda = 2/3: P < 1 + p, and for p < 3, p = 3 r/(1 + r), 0 < P, so k(p/(1 + lambda p)) > k(q): 1/q - 1/p > 2/3",
    sympy.Lt(At(product, {lam: 2 * third}), 1 + p, evaluate=False),
    sympy.Gt(At(product, {lam: 2 * third, p: 3 * ratio / (1 + ratio)}), 0, evaluate=False),
)
step("and for p >= 3, p/(1 + 2p/3) >= 1 > q", At(p - (1 + lam * p), {lam: 2 * third}), third * (p - 3))
step(
    "2/3 is sharp: the difference tends to it as p -> 0, where P - (1+p) begins with the power p ...",
    Coefficient(product - (1 + p), p, 1),
    3 * lam - 2,
)
q_of = p - 2 * third * p**2
step(
    "... as the map itself begins F = p - (2/3) p^2 + ...",
    Taylor(h_of(p), p, 3),
    Taylor(At(k_of(q), {q: q_of}), p, 3),
)
derivative = sympy.Derivative(h_of(p), p) / sympy.Derivative(k_of(q), q)
step("F' = h'(p)/k'(q)", derivative, p * (1 - q) / (q * (1 + p)))
step("is (1/q - 1)/(1/p + 1): positive because q < 1", derivative, (1 / q - 1) / (1 / p + 1))
difference = sympy.Symbol("Delta", positive=True)
step(
    "and with 1/q = 1/p + Delta, 1 - F' = (2 - Delta)/(1/p + 1) > 0 since Delta < 2: 0 < F' < 1",
    At(1 - derivative, {q: 1 / (1 / p + difference)}),
    (2 - difference) / (1 / p + 1),
)
step(
    "Delta < 1 gives more: 1/(1+p) - F' = (1 - Delta)/(1/p + 1) > 0, F' < 1/(1+p)",
    At(1 / (1 + p) - derivative, {q: 1 / (1 / p + difference)}),
    (1 - difference) / (1 / p + 1),
)
