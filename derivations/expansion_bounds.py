"""The error of a truncated expansion: from one half-swing to all of them.

>>> print(derivation.steps[6].text())
Subs(Derivative(1/d(psi), psi), Derivative(d(psi), psi), -r*w*d(psi)**2) = r*w
"""

import sympy

from derivations.steps import At, Derivation, defined

n, m, x = sympy.symbols("n m x", positive=True)
Y, g, G, delta = sympy.symbols("Y g G delta", positive=True)
psi = sympy.Symbol("psi")

derivation = Derivation(
    "expansion-bounds",
    "What the O() of an expansion holds, on one half-swing and on all of them",
    source="bounds.local, bounds.turning, bounds.turning_sequence; the map, its majorant and L1b are those of "
    "quarter-swing-tail",
)
step, asserts = derivation.step, derivation.asserts

# 1. One half-swing.
step(
    "Order N odd lacks p_(N+2) and Omega_(N+1), order N even p_(N+1) and Omega_(N+2) (p is odd, Omega even). With V of"
    " degree 2 the missing p_k changes L by pi p_k delta^k, to first order",
    sympy.Integral(-sympy.Symbol("p_k") * delta**n, (psi, 0, sympy.pi)),
    -sympy.pi * sympy.Symbol("p_k") * delta**n,
)
kk, over = sympy.symbols("K r", positive=True)  # K = 1/(1 + r) < 1
i, k = sympy.symbols("i k", integer=True, nonnegative=True)
step(
    "L_N and T_N are analytic where G' = P(v)/(1 - Q(v)), v = rho e^(|alpha-1| G), stays finite: |p/(1 + Omega)| <="
    " P/(1 - Q), for |Omega| <= Q = K = 1/(1 + r) < 1 the geometric series of terms K^i >= 0, of which after k terms"
    " is left",
    sympy.Sum(At(kk ** (k + i), {kk: 1 / (1 + over)}), (i, 0, sympy.oo)),
    At(kk**k / (1 - kk), {kk: 1 / (1 + over)}),
)
a, b = sympy.symbols("delta_1 delta_2", positive=True)
step(
    "A sum: with multinomial coefficients sum_n binomial(k; n) delta^n = |delta|^k, so |c_n|/binomial(k; n) <= c gives"
    " sum |c_n| delta^n <= c |delta|^k. Multinomial coefficients are k! times those of the product of the exponential"
    " series of all delta_i, which is the series of |delta|; a further law adds a factor:",
    sympy.Sum(a**i / sympy.factorial(i), (i, 0, sympy.oo)) * sympy.Sum(b**k / sympy.factorial(k), (k, 0, sympy.oo)),
    sympy.Sum((a + b) ** k / sympy.factorial(k), (k, 0, sympy.oo)),
)
M, rho, J = sympy.symbols("M rho J", positive=True)
h = defined("h", lambda k: (a ** (k + 1) - b ** (k + 1)) / (a - b), index=True)
derivation.defines(
    "Cauchy on the polydisc |delta_i| <= rho: |c_n| <= M rho^(-k), |n| = k. The monomials of degree k add up to at"
    " most |delta|^k: each of degree k+1 is some delta_i times one of degree k. For two laws their sum is",
    h(k),
    (a ** (k + 1) - b ** (k + 1)) / (a - b),
)
step("and |delta| h_k exceeds h_(k+1) by a sum of terms >= 0:", (a + b) * h(k) - h(k + 1), a * b * h(k - 1))
step(
    "so all degrees from J on give at most, x = |delta|/rho = 1/(1 + r) < 1,",
    sympy.Sum(At(M * x ** (J + i), {x: 1 / (1 + over)}), (i, 0, sympy.oo)),
    At(M * x**J / (1 - x), {x: 1 / (1 + over)}),
)

# 2. All half-swings.
w = sympy.Symbol("w", nonnegative=True)
d = sympy.Function("d")(psi)
rate = sympy.Symbol("r", positive=True)
step(
    "The truncated orbit: |delta| = d falls at least like d' = -w r d^2, r = inf p_N/(d (1 + Omega_N)),"
    " w = min alpha_i - 1; then 1/d grows at the rate",
    At(sympy.Derivative(1 / d, psi), {sympy.Derivative(d, psi): -w * rate * d**2}),
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
    At(primitive, {x: n - half}) - At(primitive, {x: -half}),
    ((Y - g / 2) ** (1 - m) - (Y + g * (n - half)) ** (1 - m)) / ((m - 1) * g),
)
eta, before, later, now = sympy.symbols("eta_j sigma_j Lambda_(j+1) lambda_j", positive=True)
product, now_sum = sympy.symbols("Lambda_j sigma_(j+1)", positive=True)
step(
    "ln A_(j+1) = ln A_j + L(delta_j), ln A_hat_(j+1) = ln A_hat_j + L_N(delta_hat_j): the mean value theorem for ln A"
    " + L, with slope lambda_j in [0, 1] (L1b), gives e_(j+1) <= lambda_j e_j + eta_j, eta_j = |L - L_N|(delta_hat_j)."
    " With e_0 = 0 this is solved by e_j = Lambda_j sigma_j, Lambda_(j+1) = lambda_j Lambda_j the product of the"
    " slopes, sigma_(j+1) = sigma_j + eta_j/Lambda_(j+1): an error counts with the slopes after it, e_n <= sum_(j<n)"
    " eta_j if all are taken as 1",
    At(later * now_sum, {now_sum: before + eta / (now * product), later: now * product}),
    now * (product * before) + eta,
)
alpha = sympy.Symbol("alpha", positive=True)
log_a, epsilon = sympy.symbols("l epsilon", positive=True)
gain = sympy.Function("L")
local = epsilon * sympy.exp((alpha - 1) * log_a)
arg = sympy.Symbol("x_1")
step(
    "One law: lambda = d(l + L(delta))/dl, l = ln A, delta = epsilon e^((alpha-1) l), is",
    sympy.Derivative(log_a + gain(local), log_a),
    1 + (alpha - 1) * local * sympy.Subs(sympy.Derivative(gain(arg), arg), arg, local),
)
share = sympy.Symbol("t", nonnegative=True)  # 1 + t = e^x
spare = 1 / (1 + share) - 1 + sympy.log(1 + share)
asserts(
    "so with L' <= -k it is at most 1 - x <= e^(-x), x = (alpha-1) k delta: with e^x = 1 + t, e^(-x) - 1 + x is 0 at t"
    " = 0 and grows with t",
    sympy.Eq(At(spare, {share: 0}), 0, evaluate=False),
    sympy.Ge(sympy.Derivative(spare, share), 0, evaluate=False),
)
j = sympy.Symbol("j", positive=True)
step(
    "The product of the lambda_i, j < i < n, delta_i >= 1/(Y + G i): the sum is above the integral of 1/(Y + G x),",
    sympy.Derivative(sympy.log(Y + G * x) / G, x),
    1 / (Y + G * x),
)
extra = sympy.Symbol("h", nonnegative=True)
asserts(
    "so an error made at j counts ((Y + G (j+1))/(Y + G n))^q at n, q = (alpha-1) k/G. With G = g + h >= g,"
    " (Y + G (j+1)) <= (G/g)(1 + g/Y)(Y + g j):",
    sympy.Le(Y + (g + extra) * (j + 1), (g + extra) / g * (1 + g / Y) * (Y + g * j), evaluate=False),
)
m_, q_, weight, met = sympy.symbols("a q B d_j", positive=True)
step(
    "With d_j <= (Y + g j)^(-1) the error made at j, C d_j^a, counts at n at most"
    " C ((G/g)(1 + g/Y)/(Y + G n))^q (Y + g j)^(q - a): the sum over j is S_(a-q)(n)",
    At(weight**q_ * met**m_, {weight: (G / g) * (1 + g / Y) * (Y + g * j), met: 1 / (Y + g * j)}),
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
    At(primitive, {theta: sympy.pi}) - At(primitive, {theta: 0}),
    0,
)
c_n, w_1, w_2, w_max = sympy.symbols("c_n w_1 w_2 w", positive=True)
n_1, n_2 = sympy.symbols("n_1 n_2", integer=True, nonnegative=True)
grown = c_n * (a * sympy.exp(w_1 * log_a)) ** n_1 * (b * sympy.exp(w_2 * log_a)) ** n_2
step(
    "Along ln A = l each delta_i changes by w_i delta_i: of a term c_n delta^n the relative change is sum n_i w_i, at"
    " most k w in modulus, k = |n|, w = max |w_i|",
    sympy.Derivative(grown, log_a) / grown,
    n_1 * w_1 + n_2 * w_2,
)
e = sympy.Symbol("e", positive=True)
B = sympy.Symbol("B", positive=True)
step(
    "With B |delta|^2 >= sum |delta_i dT/d delta_i|, amplitudes within a factor e^e have |T - T'| at most",
    sympy.Integral(B * w_max * (delta * sympy.exp(w_max * log_a)) ** 2, (log_a, 0, e)),
    B * delta**2 * (sympy.exp(2 * w_max * e) - 1) / 2,
)
slack = x * sympy.exp(2 * x) - (sympy.exp(2 * x) - 1) / 2
asserts(
    "which is at most B w e (delta exp(w e))^2: e^(2x) - 1 <= 2 x e^(2x), for x e^(2x) - (e^(2x) - 1)/2 is 0 at x = 0"
    " and grows",
    sympy.Eq(At(slack, {x: 0}), 0, evaluate=False),
    sympy.Gt(sympy.Derivative(slack, x), 0, evaluate=False),
)

# 4. Any exponents, half-swing by half-swing.
Q, Q_N = (sympy.Function(name) for name in ("Q", "Q_N"))
A_n, A_hat, size = sympy.symbols("A_n Ahat_n A", positive=True)
step(
    "A -> Q(A) from one turning point to the next, |Q'| <= 1 (motions-never-part); the truncated map Q_N differs"
    " by the error there was, contracted, and the error of this half-swing",
    sympy.Integral(sympy.Derivative(Q(size), size), (size, A_hat, A_n)) + Q(A_hat) - Q_N(A_hat),
    Q(A_n) - Q_N(A_hat),
)
asserts(
    "|Q - Q_N| = Q_N |exp(L - L_N) - 1| <= Q_N (exp(|L - L_N|) - 1): e^x - 1 is at least 1 - e^(-x), with e^x = 1 + t",
    sympy.Ge(share, 1 - 1 / (1 + share), evaluate=False),
)
nearer = sympy.log(1 + share) - sympy.log(1 + share / (1 + share))
asserts(
    "|A - A_hat| <= D < A_hat gives |ln(A/A_hat)| <= -ln(1 - D/A_hat) = ln(1 + t), D/A_hat = t/(1 + t): the upper end"
    " ln(1 + D/A_hat) is nearer, as the difference is 0 at t = 0 and grows",
    sympy.Eq(At(nearer, {share: 0}), 0, evaluate=False),
    sympy.Ge(sympy.Derivative(nearer, share), 0, evaluate=False),
)
