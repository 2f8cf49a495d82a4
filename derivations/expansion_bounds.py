"""The error of a truncated expansion: from one half-swing to all of them.

>>> print(derivation.steps[2].text())
delta_1**3 + 3*delta_1**2*delta_2 + 3*delta_1*delta_2**2 + delta_2**3 = (delta_1 + delta_2)**3
"""

import sympy

from derivations.steps import Derivation, Taylor, named

n, m, x = sympy.symbols("n m x", positive=True)
Y, g, G, delta = sympy.symbols("Y g G delta", positive=True)
psi = sympy.Symbol("psi")

derivation = Derivation(
    "expansion-bounds",
    "What the O() of an expansion holds, on one half-swing and on all of them",
    source="bounds.local, bounds.turning; the map, its majorant and L1b are those of quarter-swing-tail",
)
step, holds = derivation.step, derivation.holds

# 1. One half-swing.
step(
    "Order N odd lacks p_(N+2) and Omega_(N+1), order N even p_(N+1) and Omega_(N+2) (p is odd, Omega even). With V of"
    " degree 2 the missing p_k changes L by pi p_k delta^k, to first order",
    sympy.Integral(-sympy.Symbol("p_k") * delta**n, (psi, 0, sympy.pi)),
    -sympy.pi * sympy.Symbol("p_k") * delta**n,
)
k, kk = sympy.symbols("k K", positive=True)
holds(
    "L_N and T_N are analytic where G' = P(v)/(1 - Q(v)), v = rho e^(|alpha-1| G), stays finite: |p/(1 + Omega)| <="
    " P/(1 - Q), the geometric series having coefficients >= 0",
    all(c >= 0 for c in sympy.Poly(Taylor(1 / (1 - kk), kk, 5).doit(), kk).coeffs()),
    Taylor(1 / (1 - kk), kk, 5),
)
a, b = sympy.symbols("delta_1 delta_2", positive=True)
step(
    "A sum: with multinomial coefficients sum_n binomial(k; n) delta^n = |delta|^k, so |c_n|/binomial(k; n) <= c gives"
    " sum |c_n| delta^n <= c |delta|^k; for two laws, k = 3",
    a**3 + 3 * a**2 * b + 3 * a * b**2 + b**3,
    (a + b) ** 3,
)

# 2. All half-swings.
w = sympy.Symbol("w", nonnegative=True)
d = sympy.Function("d")(psi)
rate = sympy.Symbol("r", positive=True)
step(
    "The truncated orbit: |delta| = d falls at least like d' = -w r d^2, r = inf p_N/(d (1 + Omega_N)),"
    " w = min alpha_i - 1; then 1/d grows at the rate",
    named("-d'/d^2", -(-w * rate * d**2) / d**2),
    w * rate,
)
half = sympy.Rational(1, 2)
power = (Y + g * x) ** (-m)
step(
    "so delta_j <= 1/(Y + g j), g = pi w r, Y = 1/delta_0. The powers are convex in j,",
    sympy.Derivative(power, x, 2),
    m * (m + 1) * g**2 * (Y + g * x) ** (-m - 2),
)
primitive = -((Y + g * x) ** (1 - m)) / ((m - 1) * g)
step("with the primitive", sympy.Derivative(primitive, x), power)
step(
    "Hence the sum over j < n is at most the integral from -1/2 to n - 1/2, S_m(n) (Hermite-Hadamard)",
    named("P(n - 1/2) - P(-1/2)", primitive.subs(x, n - half) - primitive.subs(x, -half)),
    ((Y - g / 2) ** (1 - m) - (Y + g * (n - half)) ** (1 - m)) / ((m - 1) * g),
)
eta = sympy.Symbol("d_j", nonnegative=True)
step(
    "ln A_(j+1) = ln A_j + L(delta_j), ln A^_(j+1) = ln A^_j + L_N(delta^_j): the mean value theorem for ln A + L, with"
    " slope lambda in [0, 1] (L1b), gives e_(j+1) <= lambda e_j + |L - L_N|(delta^_j). With e_0 = 0, lambda = 1",
    named("e_2", (0 + eta) + eta),
    2 * eta,
)
alpha = sympy.Symbol("alpha", positive=True)
step(
    "One law: lambda = d(ln A + L)/d ln A = 1 + (alpha-1) delta L'(delta), here for L = -k delta; and 1 - x <= e^(-x)",
    1 + (alpha - 1) * delta * sympy.Derivative(-k * delta, delta),
    1 - (alpha - 1) * k * delta,
)
j = sympy.Symbol("j", positive=True)
step(
    "The product of the lambda_i, j < i < n, delta_i >= 1/(Y + G i): the sum is above the integral of 1/(Y + G x),",
    sympy.Derivative(sympy.log(Y + G * x) / G, x),
    1 / (Y + G * x),
)
extra = sympy.Symbol("h", nonnegative=True)
holds(
    "so an error made at j counts ((Y + G (j+1))/(Y + G n))^q at n, q = (alpha-1) k/G. With G = g + h >= g,"
    " (Y + G (j+1)) <= (G/g)(1 + g/Y)(Y + g j), since the difference",
    bool(sympy.expand((g + extra) * (1 + g / Y) * (Y + g * j) - g * (Y + (g + extra) * (j + 1))).is_nonnegative),
    sympy.expand((g + extra) * (1 + g / Y) * (Y + g * j) - g * (Y + (g + extra) * (j + 1))),
)
