"""The quadratic map contracts: 2/3 < 1/q - 1/p < 1 (so < 2) for p = 2|u_n|, q = 2|u_(n+1)|, and 0 < F' < 1.

The bounds that ``asymptotics.turning`` relies on; the upper bound needed there is 2, the one proved is 1.

>>> print(derivation.steps[8].text())
(1 - p/3)*(2*p/3 + 1)**2 = -4*p**3/27 + p + 1
"""

import sympy

from derivations.steps import At, Derivation, Taylor, named

p, q, lam = sympy.symbols("p q lambda", positive=True)
log, diff = sympy.log, sympy.diff
third = sympy.Rational(1, 3)

derivation = Derivation(
    "smith-contraction",
    "Neighbouring turning points: bounds on 1/q - 1/p, and the map is a contraction",
    source="Smith 2012, (43) gives the map; the bounds are not in the paper",
)
step, holds = derivation.step, derivation.holds


def h(p: sympy.Expr) -> sympy.Expr:
    """p - log(1+p), the start of the half-swing."""
    return p - log(1 + p)


def k(q: sympy.Expr) -> sympy.Expr:
    """-q - log(1-q), its end: h(p) = k(q) defines q = F(p)."""
    return -q - log(1 - q)


u = sympy.Symbol("u", real=True)
g = sympy.exp(-2 * u) * (1 + 2 * u)
log_g = log(1 + 2 * u) - 2 * u
step(
    "Smith (43): g = e^{-2u}(1+2u) is the same at both ends; its logarithm",
    named("ln(g)", sympy.expand_log(log(g), force=True)),
    log_g,
)
step("is -h(p) at the start u = p/2", At(log_g, {u: p / 2}), -h(p))
step("and -k(q) at the end u = -q/2: h(p) = k(q)", At(log_g, {u: -q / 2}), -k(q))
step("h rises from 0 to infinity on p > 0", diff(h(p), p), p / (1 + p))
step("k rises from 0 to infinity on 0 < q < 1: one q = F(p) for each p > 0", diff(k(q), q), q / (1 - q))
trial = p / (1 + lam * p)
slope = diff(h(p), p) - diff(k(trial), p)
step("Compare q with p/(1 + lambda p), which has 1/q = 1/p + lambda", 1 / trial - 1 / p, lam)
product = (1 + (lam - 1) * p) * (1 + lam * p) ** 2
step(
    "d/dp [h(p) - k(p/(1 + lambda p))] = p/(1+p) - p/P(p), P = (1 + (lambda-1) p)(1 + lambda p)^2; both start at 0,"
    " so the sign is that of P - (1+p)",
    slope,
    p / (1 + p) - p / product,
)
step("lambda = 1: P = (1+p)^2", At(product, {lam: 1}), (1 + p) ** 2)
step("lambda = 2/3: P", product.subs(lam, 2 * third), 1 + p - 4 * third**3 * p**3)
step("and lambda = 2: P", At(product, {lam: 2}), (1 + p) * (1 + 2 * p) ** 2)
for value in (1, 2):
    excess = sympy.factor(product.subs(lam, value) - (1 + p))
    holds(
        f"lambda = {value}: P > 1 + p, so k(p/(1 + lambda p)) < h(p) = k(q), p/(1 + lambda p) < q: 1/q - 1/p < {value}",
        bool(excess.is_positive),
        excess,
    )
deficit = sympy.factor(1 + p - product.subs(lam, 2 * third))
holds(
    "lambda = 2/3, p < 3: 0 < P < 1 + p, so k(p/(1 + lambda p)) > k(q): 1/q - 1/p > 2/3",
    bool(deficit.is_positive) and bool((1 - p * third).subs(p, 3) == 0),
    deficit,
)
step("and for p >= 3, p/(1 + 2p/3) >= 1 > q", At(p - (1 + lam * p), {lam: 2 * third}), third * (p - 3))
holds(
    "2/3 is sharp: the difference tends to it as p -> 0 (P - (1+p) has (3 lambda - 2) p in front) ...",
    bool(sympy.expand(product - 1 - p).coeff(p, 1) == 3 * lam - 2),
    sympy.expand(product - 1 - p),
)
q_of = p - 2 * third * p**2
step(
    "... as the map itself begins F = p - (2/3) p^2 + ...",
    Taylor(h(p), p, 3),
    sympy.series(sympy.series(k(q), q, 0, 4).removeO().subs(q, q_of), p, 0, 4).removeO(),
)
derivative = diff(h(p), p) / diff(k(q), q)
step("F' = h'(p)/k'(q)", derivative, p * (1 - q) / (q * (1 + p)))
step("is (1/q - 1)/(1/p + 1): positive because q < 1", derivative, (1 / q - 1) / (1 / p + 1))
difference = sympy.Symbol("Delta", positive=True)
step(
    "and with 1/q = 1/p + Delta, 1 - F' = (2 - Delta)/(1/p + 1) > 0 since Delta < 2: 0 < F' < 1",
    sympy.simplify(1 - derivative.subs(q, 1 / (1 / p + difference))),
    (2 - difference) / (1 / p + 1),
)
step(
    "Delta < 1 gives more: 1/(1+p) - F' = (1 - Delta)/(1/p + 1) > 0, F' < 1/(1+p)",
    sympy.simplify(1 / (1 + p) - derivative.subs(q, 1 / (1 / p + difference))),
    (1 - difference) / (1 / p + 1),
)
