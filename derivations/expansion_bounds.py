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
    source="bounds.local, bounds.turning, bounds.orbit; the map, its majorant and L1b are those of quarter-swing-tail",
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

M, rho, J = sympy.symbols("M rho J", positive=True)
step(
    "Cauchy on the polydisc |delta_i| <= rho: |c_n| <= M rho^(-k), |n| = k; the monomials of degree k add up to at most"
    " |delta|^k (each multinomial coefficient is >= 1), here for two laws and k = 3",
    (a + b) ** 3 - (a**3 + a**2 * b + a * b**2 + b**3),
    2 * a * b * (a + b),
)
y = sympy.Symbol("y", positive=True)  # |delta|/rho = y/(1 + y) < 1
ratio = y / (1 + y)
step(
    "so all degrees from J on give at most M x^J/(1 - x), x = |delta|/rho < 1: the remainder R_J with"
    " R_J - R_(J+1) = M x^J and R_J -> 0",
    M * ratio**J / (1 - ratio) - M * ratio ** (J + 1) / (1 - ratio),
    M * ratio**J,
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
    "ln A_(j+1) = ln A_j + L(delta_j), ln A_hat_(j+1) = ln A_hat_j + L_N(delta_hat_j): the mean value theorem for"
    " ln A + L, with slope lambda in [0, 1] (L1b), gives e_(j+1) <= lambda e_j + |L - L_N|(delta_hat_j). With e_0 = 0,"
    " lambda = 1",
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
m_, q_ = sympy.symbols("a q", positive=True)
step(
    "With d_j <= (Y + g j)^(-1) the error made at j, C d_j^a, counts at n at most"
    " C ((G/g)(1 + g/Y)/(Y + G n))^q (Y + g j)^(q - a): the sum over j is S_(a-q)(n)",
    ((G / g) * (1 + g / Y) * (Y + g * j)) ** q_ * (Y + g * j) ** (-m_),
    ((G / g) * (1 + g / Y)) ** q_ * (Y + g * j) ** (q_ - m_),
)

# 3. Times.
theta = sympy.Symbol("theta", real=True)
s = sympy.sin(theta)
primitive = s ** (alpha + 1) / (alpha + 1)
step(
    "T begins with degree 2: d tau/d theta = 1/(1 - u s^alpha c) = 1 + u s^alpha c + ..., and s^alpha c has the"
    " primitive",
    sympy.Derivative(primitive, theta),
    s**alpha * sympy.cos(theta),
)
step(
    "which vanishes at both ends of the half-swing",
    named("P(pi) - P(0)", primitive.subs(theta, sympy.pi) - primitive.subs(theta, 0)),
    0 * alpha,
)
log_a, c_n, w_max = sympy.symbols("l c_n w", positive=True)
step(
    "Along ln A = l each delta_i changes by w_i delta_i, w = max |w_i|: a term c_n delta^n of degree 3 by at most",
    sympy.Derivative(c_n * (a * sympy.exp(w_max * log_a)) ** 2 * (b * sympy.exp(w_max * log_a)), log_a),
    3 * w_max * c_n * a**2 * b * sympy.exp(3 * w_max * log_a),
)
e = sympy.Symbol("e", positive=True)
B = sympy.Symbol("B", positive=True)
step(
    "With B |delta|^2 >= sum |delta_i dT/d delta_i|, amplitudes within a factor e^e have |T - T'| at most",
    sympy.Integral(B * w_max * (delta * sympy.exp(w_max * log_a)) ** 2, (log_a, 0, e)),
    B * delta**2 * (sympy.exp(2 * w_max * e) - 1) / 2,
)
holds(
    "which is at most B w e (delta exp(w e))^2: e^(2x) - 1 <= 2 x e^(2x), for x e^(2x) - (e^(2x) - 1)/2 is 0 at x = 0"
    " and grows",
    bool(sympy.expand(sympy.diff(x * sympy.exp(2 * x) - (sympy.exp(2 * x) - 1) / 2, x)).is_positive),
    sympy.diff(x * sympy.exp(2 * x) - (sympy.exp(2 * x) - 1) / 2, x),
)

# 4. Any exponents, half-swing by half-swing.
Q, Q_N = (sympy.Function(name) for name in ("Q", "Q_N"))
A_n, A_hat, D = sympy.symbols("A_n Ahat_n D", positive=True)
step(
    "A -> Q(A) from one turning point to the next, |Q(A) - Q(B)| <= |A - B| (motions-never-part); the truncated map Q_N"
    " differs by the error there was, contracted, and the error of this half-swing",
    named("[Q(A_n) - Q(A_hat_n)] + [Q(A_hat_n) - Q_N(A_hat_n)]", (Q(A_n) - Q(A_hat)) + (Q(A_hat) - Q_N(A_hat))),
    Q(A_n) - Q_N(A_hat),
)
gap = sympy.Symbol("x", nonnegative=True)
holds(
    "|Q - Q_N| = Q_N |exp(L - L_N) - 1| <= Q_N (exp(|L - L_N|) - 1): e^x - 1 is at least 1 - e^(-x), the difference",
    bool(
        sympy.expand((sympy.exp(gap / 2) - sympy.exp(-gap / 2)) ** 2 - (sympy.exp(gap) - 1 - 1 + sympy.exp(-gap))) == 0
    ),
    (sympy.exp(gap / 2) - sympy.exp(-gap / 2)) ** 2,
)
step(
    "|A - A_hat| <= D < A_hat gives |ln(A/A_hat)| <= -ln(1 - D/A_hat): the upper end ln(1 + D/A_hat) is nearer, by",
    sympy.exp(-(sympy.log(1 - D / A_hat)) - sympy.log(1 + D / A_hat)),
    1 / (1 - (D / A_hat) ** 2),
)
