"""The error of an expansion for all times at once: how far z_N may be from the motion.

>>> len(derivation.steps) > 12
True
"""

import sympy

from derivations.steps import At, Derivation

psi = sympy.Symbol("psi", real=True)
P, Q = (sympy.Function(n)(psi) for n in "PQ")
s, c = sympy.sin(psi), sympy.cos(psi)
A, U, W, DP, DQ, F = sympy.symbols("A U W DP DQ F")
alpha, delta, K, a, b, M, J = sympy.symbols("alpha delta K a b M J", positive=True)
k = sympy.Symbol("k", integer=True, positive=True)
m = sympy.Symbol("m", nonnegative=True)

derivation = Derivation(
    "uniform-bound",
    "The error of an expansion, for all times at once",
    source="motions-never-part; Cauchy; asymptotics.bounds.waveform, asymptotics.bounds.uniform",
)
step = derivation.step

# 1. What is left over.  D Z: the change of Z with the strengths, d delta_i/d psi = (alpha_i - 1) delta_i U.
Z = P + sympy.I * Q
turned = sympy.exp(sympy.I * psi) * A * Z
p, q, shape = *sympy.symbols("p q", real=True), sympy.Symbol("Z")
PARTS = sympy.re, sympy.im
step(
    "z = X - i X' = A e^(i psi) Z, Z = p + i q: X/A is the real part of this, and -X'/A = s g the imaginary one,"
    " g = p + (c/s) q",
    sympy.Tuple(*(At(part((c + sympy.I * s) * shape, evaluate=False), {shape: p + sympy.I * q}) for part in PARTS)),
    sympy.Tuple(c * p - s * q, s * (p + c / s * q)),
)
tau = sympy.Symbol("tau", real=True)
X = sympy.Function("X", real=True)(tau)
V = sympy.Derivative(X, tau)
step(
    "The motion: X'' = -X + A F while X' < 0, F = sum_i delta_i (s g)^alpha_i, so that z' = i z - i A F",
    At(sympy.Derivative(X - sympy.I * V, tau), {sympy.Derivative(X, (tau, 2)): -X + A * F}),
    sympy.I * (X - sympy.I * V) - sympy.I * A * F,
)
rate = sympy.Derivative(turned, psi) + sympy.exp(sympy.I * psi) * A * (U * Z + U * (DP + sympy.I * DQ))
field = W * (sympy.I * turned - sympy.I * A * F)
R = (
    sympy.diff(Z, psi)
    - (sympy.I * (W - 1) * Z - U * Z - U * (DP + sympy.I * DQ))
    + sympy.I * W * F * sympy.exp(-sympy.I * psi)
)
step(
    "Along d ln A/d psi = U, d tau/d psi = W any Z(psi, delta) fails to solve it, per unit of psi, by A e^(i psi) R",
    rate - field,
    sympy.expand(A * sympy.exp(sympy.I * psi) * R),
)
U_N, W_N = sympy.symbols("U_N W_N")
step(
    "Z_n, |n| <= N + 1, makes R vanish with the true U and W.  With those of order N the degree N + 1 of R is the"
    " difference of two such terms at Z = 1 (F begins with degree 1, D Z too): no psi in it",
    At(sympy.I * (W - 1) * shape - U * shape, {shape: 1}) - At(sympy.I * (W_N - 1) * shape - U_N * shape, {shape: 1}),
    sympy.I * (W - W_N) - (U - U_N),
)

# 2. The second half of the half-swing.
sine, cosine, P_psi, Q_psi = sympy.symbols("s c P_psi Q_psi", real=True)
step(
    "Reversal: psi -> pi - psi with delta -> -delta, Q -> -Q, U -> -U, F -> -F, c -> -c keeps g and turns X over",
    At(cosine * p - sine * q, {cosine: -cosine, q: -q}),
    -(cosine * p - sine * q),
)
real_part = P_psi + (W - 1) * q + U * p + W * sine * F
imaginary_part = Q_psi - (W - 1) * p + U * q + W * cosine * F
step(
    "Re R changes its sign (P' does as well; U p stands for U P + U D P),",
    At(real_part, {P_psi: -P_psi, q: -q, U: -U, F: -F}),
    -real_part,
)
step(
    "and Im R keeps it: the moduli on (pi/2, pi) are those on (0, pi/2)",
    At(imaginary_part, {q: -q, U: -U, F: -F, cosine: -cosine}),
    Q_psi + (1 - W) * p + U * q + W * cosine * F,
)

# 3. Pieces.
f = sympy.Derivative(sympy.Function("F")(psi), psi)
f_1, f_2 = sympy.Integral(f, (psi, 0, a)) / a, sympy.Integral(f, (psi, a, b)) / (b - a)
step(
    "Let f_1 be the mean of f = F' over [0, a] and f_2 over [a, b]: the mean over [0, b] is f_1 plus 1 - a/b of the"
    " difference",
    sympy.Integral(f, (psi, 0, b)) / b,
    f_1 + (1 - a / b) * (f_2 - f_1),
)
step(
    "(c/s) Q is psi cot psi times the mean of Q'; psi cot psi falls on (0, pi/2): its derivative is this over sin^2",
    sympy.Derivative(psi * sympy.cot(psi), psi) * sympy.sin(psi) ** 2,
    sympy.sin(2 * psi) / 2 - psi,
)
step(
    "which is negative: 2 psi - sin 2 psi begins with 0 and grows, its derivative being",
    sympy.Derivative(2 * psi - sympy.sin(2 * psi), psi),
    4 * sympy.sin(psi) ** 2,
)

# 4. The distance grows by no more than what is left over (motions-never-part), in ds = (p_N/(1 + Omega_N)) d psi.
t = sympy.Symbol("t", nonnegative=True)
p_cut, Omega = sympy.symbols("p_N Omega_N", positive=True)
step(
    "A = A_0 e^-t: d psi = (1 + Omega_N)/p_N dt, and K is the largest |delta| (1 + Omega_N)/p_N, so a term r_k"
    " |delta|^k of |R| adds at most r_k K times the integral of e^-t |delta|^(k-1)",
    At(delta**k * (1 + Omega) / p_cut, {p_cut: delta * (1 + Omega) / K}),
    K * delta ** (k - 1),
)
step(
    "For a linear law |delta| is constant, and yet the integral is finite for all times: errors of phase are made while"
    " there is amplitude",
    sympy.Integral(sympy.exp(-t) * delta**m, (t, 0, sympy.oo)),
    delta**m,
)
w = sympy.Symbol("w", nonnegative=True)
step(
    "one law, w = alpha - 1 >= 0:",
    sympy.Integral(sympy.exp(-t) * (delta * sympy.exp(-w * t)) ** m, (t, 0, sympy.oo)),
    delta**m / (1 + w * m),
)

# 5. Beyond the degrees that are computed, and the start.
real, turn, log_g = *sympy.symbols("r theta", real=True), sympy.Symbol("l")
step(
    "Where |g - 1| <= h < 1, the power g^alpha is analytic and at most (1 + h)^alpha, as alpha is real: with l = ln g ="
    " r + i theta, r <= ln(1 + h), its modulus is",
    At(sympy.Abs(sympy.exp(alpha * log_g), evaluate=False), {log_g: real + sympy.I * turn}),
    sympy.exp(alpha * real),
)
y, x = sympy.symbols("r x", positive=True)
j = sympy.Symbol("j", integer=True, nonnegative=True)
step(
    "Cauchy on |delta_i| <= rho: the degrees from J on add at most, x = |delta|/rho = 1/(1 + r) < 1,",
    sympy.Sum(At(M * x ** (J + j), {x: 1 / (1 + y)}), (j, 0, sympy.oo)),
    At(M * x**J / (1 - x), {x: 1 / (1 + y)}),
)
size = sympy.Symbol("q", positive=True)
step(
    "A start in motion, A_0 |Z| = 1 with | |Z| - 1 | <= q: A_0 is at most 1/(1 - q), and it exceeds 1 by at most",
    At(A - 1, {A: 1 / (1 - size)}),
    size / (1 - size),
)
