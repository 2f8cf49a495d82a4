"""The error of the explicit form of one law, for all times: what A and phi, cut off, leave over in the motion.

>>> len(derivation.steps) > 10
True
"""

import sympy

from derivations.steps import At, Derivation

w, epsilon, p_1, p_3, D, u, rho, N = sympy.symbols("w epsilon p_1 p_3 D u rho N", positive=True)
tau = sympy.Symbol("tau", nonnegative=True)
A, Z, EZ, Z_psi, f_a, f_phi, p, Omega, delta = sympy.symbols("A Z EZ Z_psi f_A f_phi p Omega delta")
slope = sympy.Symbol("r_D")

derivation = Derivation(
    "explicit-bound",
    "The error of the explicit form of one law, for all times at once",
    source="uniform-bound; motions-never-part; Cauchy; asymptotics.bounds.explicit",
)
step = derivation.step

# 1. What the explicit A and phi leave over in the truncated equations; w = alpha - 1, D = A_0^w.
growth = 1 + w * p_1 * epsilon * tau
A_0 = growth ** (-1 / w)
step(
    "A_0 = D^(1/w), D = 1/(1 + w p_1 epsilon tau), falls at the rate p_1 epsilon D",
    sympy.Derivative(A_0, tau),
    -p_1 * epsilon / growth * A_0,
)
step("and D at w times that rate", sympy.Derivative(1 / growth, tau), -w * p_1 * epsilon * growth**-2)
shape = sympy.Function("r")(D)
step(
    "So with A = A_0 r(D) the rate of ln A is that of ln A_0 and of ln r, D' = -w p_1 epsilon D^2:",
    At(
        -p_1 * epsilon * D + sympy.Derivative(sympy.log(shape), D) * (-w * p_1 * epsilon * D**2), {shape.diff(D): slope}
    ),
    -p_1 * epsilon * D * (1 + w * D * slope / shape),
)
k = sympy.Symbol("k", integer=True, positive=True)
R_0 = sympy.Symbol("r", positive=True)
step(
    "and delta = epsilon A^w = epsilon D r^w: a term p_k delta^k of p, over epsilon D, is",
    At(delta**k / (epsilon * D), {delta: epsilon * D * R_0**w}),
    (epsilon * D) ** (k - 1) * R_0 ** (k * w),
)

# 2. f_A begins with epsilon^N: order 3 of any law, r = 1 + epsilon^2 p_3/(w p_1) (D^2 - D); epsilon^0 cancels at sight.
ratio = 1 + epsilon**2 * p_3 / (w * p_1) * (D**2 - D)
step(
    "At epsilon^2 the rate of ln A, -p_1 (1 + w D r_D/r), has",
    At(sympy.Derivative(-p_1 * (1 + w * D * sympy.diff(ratio, D) / ratio), (epsilon, 2)) / 2, {epsilon: 0}),
    -p_3 * (2 * D**2 - D),
)
step(
    "and p_1 r^w + p_3 (epsilon D)^2 r^(3 w) has the opposite; odd powers occur in neither: f_A begins with epsilon^4",
    At(sympy.Derivative(p_1 * ratio**w + p_3 * epsilon**2 * D**2 * ratio ** (3 * w), (epsilon, 2)) / 2, {epsilon: 0}),
    p_3 * (2 * D**2 - D),
)

# 3. The residual of the motion.
psi, log_a = sympy.symbols("psi l")
wave = sympy.Function("Z")(psi, log_a)
full = sympy.exp(log_a + sympy.I * psi) * wave
moved = (-p + epsilon * D * f_a) * sympy.Derivative(full, log_a)
moved += (1 + Omega + epsilon * D * f_phi) * sympy.Derivative(full, psi)
step(
    "z~ = A e^(i psi) Z(psi, delta), l = ln A at the rate -p + epsilon D f_A, psi at 1 + Omega + epsilon D f_phi, over"
    " A e^(i psi), E = w delta d/d delta = d/dl:",
    At(sympy.exp(-log_a - sympy.I * psi) * moved, {wave.diff(psi): Z_psi, wave.diff(log_a): EZ, wave: Z}),
    (-p * (Z + EZ) + (1 + Omega) * (sympy.I * Z + Z_psi))
    + epsilon * D * (f_a * (Z + EZ) + f_phi * (sympy.I * Z + Z_psi)),
)
U, W, F = sympy.symbols("U W F")  # F stands for F e^(-i psi)
residual = Z_psi - (sympy.I * (W - 1) * Z - U * Z - U * EZ) + sympy.I * W * F
step(
    "The first bracket less the motion's i Z - i F is (1 + Omega) R, R per unit of psi (uniform-bound), as U = -p W and"
    " 1 + Omega = 1/W:",
    At(
        -p * (Z + EZ) + (1 + Omega) * (sympy.I * Z + Z_psi) - (sympy.I * Z - sympy.I * F), {p: -U / W, Omega: 1 / W - 1}
    ),
    sympy.expand(residual / W),
)
a, b = sympy.symbols("a b")
step(
    "With Z + E Z = 1 + a and i Z + Z_psi = i + b the rest is f_A + i f_phi and two small terms",
    At(f_a * (Z + EZ) + f_phi * (sympy.I * Z + Z_psi), {EZ: 1 + a - Z, Z_psi: sympy.I + b - sympy.I * Z}),
    (f_a + sympy.I * f_phi) + f_a * a + f_phi * b,
)

# 4. Integrated: two motions never part, and z~ is a motion but for its residual.
step(
    "Per unit of u = A_0, d tau = -du/(p_1 epsilon D u): a residual A epsilon D f becomes, A = u r,",
    At(A * epsilon * D * f_a / (p_1 * epsilon * D * u), {A: u * R_0}),
    R_0 * f_a / p_1,
)
step(
    "and a term A (1 + Omega) r_k delta^k, as delta = epsilon D r^w,",
    At(u * R_0 * delta**k / (p_1 * epsilon * D * u), {delta: epsilon * D * R_0**w}),
    R_0 ** (1 + w) / p_1 * (epsilon * D * R_0**w) ** (k - 1),
)

# 5. Beyond the degrees that are computed.
q, x, M = sympy.symbols("q x M", positive=True)
J = sympy.Symbol("J", integer=True, positive=True)
turn = sympy.Symbol("theta", real=True)
size, log_r = sympy.Symbol("s", real=True), sympy.Symbol("l")
step(
    "Where |r - 1| <= q < 1 for |epsilon| <= rho, r^(k w) = e^(k w l), l = ln r = s + i theta, is analytic in epsilon,"
    " and for real k w its modulus is e^(k w s), 1 - q <= e^s <= 1 + q",
    At(sympy.Abs(sympy.exp(k * w * log_r), evaluate=False), {log_r: size + sympy.I * turn}),
    sympy.exp(k * w * size),
)
y, j = sympy.Symbol("r", positive=True), sympy.Symbol("j", integer=True, nonnegative=True)
step(
    "Cauchy: the degrees of epsilon beyond J add at most, x = epsilon/rho = 1/(1 + r) < 1,",
    sympy.Sum(At(M * x ** (J + 1 + j), {x: 1 / (1 + y)}), (j, 0, sympy.oo)),
    At(M * x ** (J + 1) / (1 - x), {x: 1 / (1 + y)}),
)
