"""Any exponent in the turning-point gauge: the second order by inserting the ansatz, both waves closed.

s = sin psi > 0 and c = cos psi on 0 < psi < pi, u = int_0^psi (p - sin^(alpha+1)), p = M_(alpha+1); d is d/dpsi.

>>> print(derivation.steps[0].text())
Subs(Derivative(-epsilon*(-V_1*epsilon + Y_0)**alpha, (epsilon, 2)), epsilon, 0)/2 = V_1*Y_0**(alpha - 1)*alpha
"""

import sympy
from sympy import pi, sin

from asymptotics.expansions.moments.symbolic import moment
from derivations.steps import At, Derivation, defined, named

alpha = sympy.Symbol("alpha", nonnegative=True)
a, s, p, Y_0, eps, m = sympy.symbols("a s p Y_0 epsilon m", positive=True)
c, u, V, psi = sympy.symbols("c u V_1 psi", real=True)
R = sympy.Rational

derivation = Derivation(
    "multiple-scales-turning",
    "Multiple scales for any exponent in the turning-point gauge",
    source="Lancaster 2020, (13) is the first order; the second is not in the papers",
)
step, asserts = derivation.step, derivation.asserts


def reduced(h: sympy.Expr) -> sympy.Expr:
    """c^2 -> 1 - s^2, powers of s collected."""
    poly = sympy.Poly(sympy.expand(h), c)
    squared = 1 - s**2
    return sympy.powsimp(sympy.expand(sum(q * squared ** (n // 2) * c ** (n % 2) for (n,), q in poly.terms())))


def dpsi(h: sympy.Expr) -> sympy.Expr:
    """s' = c, c' = -s, u' = p - s^(alpha+1), w' = rest' + (alpha/(alpha+1))^2 (s^(2 alpha) - M)."""
    turned = sympy.diff(h, s) * c - sympy.diff(h, c) * s + sympy.diff(h, u) * (p - s ** (alpha + 1))
    if h.has(w):
        power = (alpha / (alpha + 1)) ** 2 * (s ** (2 * alpha) - M)
        turned += sympy.diff(h, w) * (dpsi(rest) + power)
    return reduced(turned)


d = defined("d", dpsi)
w, M = sympy.symbols("w M", real=True)
rest = alpha / (alpha + 1) * (s ** (alpha + 1) * u - s ** (2 * alpha + 1) * c / (alpha + 1))

# The equation of order 2, from the ansatz.
force = -eps * (Y_0 - eps * V) ** alpha
step(
    "On 0 < psi < pi the force is -eps (-V)^alpha; V = -Y_0 + eps V_1 + ...: its part of order 2",
    R(1, 2) * At(sympy.Derivative(force, (eps, 2)), {eps: 0}),
    alpha * Y_0 ** (alpha - 1) * V,
)
step(
    "and of order 1, where Y_0 = a s",
    At(At(sympy.Derivative(force, eps), {eps: 0}), {Y_0: a * s}),
    -((a * s) ** alpha),
)

# Order 1: two conditions, X_1 and V_1.
mean = sympy.Integral(sin(psi) ** 4, (psi, 0, pi)) / pi
step(
    "X_1(pi) = 0: pi D_1 a = -a^alpha int sin^(alpha+1), so D_1 a = -p a^alpha; alpha = 3: p",
    mean,
    moment(sympy.Integer(4)),
)
f_1 = -p * a**alpha
X_1 = a**alpha * (c * u + s ** (alpha + 2) / (alpha + 1))
V_1 = a**alpha * (-s * u + s ** (alpha + 1) * c / (alpha + 1))
step("X_1 = a^alpha (c u + s^(alpha+2)/(alpha+1)) has the velocity V_1 = d X_1 + D_1 X_0", d(X_1) + f_1 * c, V_1)
step("and d V_1 + X_1 + D_1 V_0 is the force", d(V_1) + X_1 - f_1 * s, a**alpha * s**alpha)
ends = {u: 0, c: -1}
step(
    "u = 0 at psi = 0 and psi = pi, so V_1 is a power of s there, and V_1/s stays bounded",
    At(V_1 / s, ends),
    -(a**alpha) * s**alpha / (alpha + 1),
)

# Order 2.
K_2 = f_1 * sympy.diff(X_1, a)
L_2 = f_1 * sympy.diff(V_1, a) + alpha * (a * s) ** (alpha - 1) * V_1
D_1 = defined("D_1", lambda h: f_1 * sympy.diff(h, a))
X, W_1 = named("X_1", X_1), named("V_1", V_1)
step("K_2 = D_1 X_1", D_1(X), sympy.expand(K_2))
step("L_2 = D_1 V_1 + the force", D_1(W_1) + alpha * (a * s) ** (alpha - 1) * W_1, L_2)
half = R(1, 2) * alpha * (u**2 + s ** (2 * alpha + 2) / (alpha + 1) ** 2)
unit = a ** (2 * alpha - 1)
circle = defined("C", reduced)
step(
    "C puts c^2 = 1 - s^2: s L_2 - c K_2 is a derivative: its integral over 0 < psi < pi is 0, so D_2 a = 0",
    circle(s * named("L_2", L_2) - c * named("K_2", K_2)),
    unit * d(half),
)
step(
    "s K_2 + c L_2 is one but for a power of s",
    circle(s * named("K_2", K_2) + c * named("L_2", L_2)),
    -unit * (d(rest) + (alpha / (alpha + 1)) ** 2 * s ** (2 * alpha)),
)
Omega_2 = -((alpha / (alpha + 1)) ** 2) * moment(2 * alpha)
step(
    "V_2(pi) = 0: pi a D_2 psi = int (s K_2 + c L_2), so D_2 psi = -(alpha/(alpha+1))^2 M_(2 alpha) a^(2 alpha-2);"
    " alpha = 2",
    -R(4, 9) * sympy.Integral(sin(psi) ** 4, (psi, 0, pi)) / pi,
    Omega_2.subs(alpha, 2),
)
step("which is Smith's half period pi/6 over pi", At(Omega_2, {alpha: 2}), -R(1, 6))
step("alpha = 3", At(Omega_2, {alpha: 3}), -R(45, 256))
step("alpha = 0: dry friction keeps the period", At(Omega_2, {alpha: 0}), 0)

# X_2 needs no integral beyond those of order 1 and int sin^(2 alpha).
X_2 = unit * (c * half + s * w)
g_2 = -((alpha / (alpha + 1)) ** 2) * M * a ** (2 * alpha - 2)
V_2 = unit * (c * w - s * half)
step(
    "X_2 = a^(2 alpha-1) (c alpha/2 (u^2 + s^(2 alpha+2)/(alpha+1)^2) + s w) with a^(2 alpha-1) dw = a D_2 psi"
    " - s K_2 - c L_2, M = M_(2 alpha): V_2 = d X_2 + K_2 + D_2 X_0",
    d(X_2) + named("K_2", K_2) - g_2 * a * s,
    V_2,
)
asserts(
    "Near miss: without the slow change of X_1 the condition of order 2 is not that derivative",
    sympy.Ne(circle(s * alpha * (a * s) ** (alpha - 1) * W_1), unit * d(half), evaluate=False),
)
step(
    "How the force fails elsewhere: with V = -a s + eps V_1 and V_1 not 0 where s is, its order j + 1 has s^(alpha-j)",
    At(sympy.Derivative((a * s) ** alpha, (s, 3)), {alpha: R(3, 2)}),
    -R(3, 8) * a ** R(3, 2) * s ** R(-3, 2),
)
step(
    "which is not integrable for j >= alpha + 1; here alpha = 3/2, j = 3",
    sympy.Limit(sympy.Integral(m ** R(-3, 2), (m, s, 1)) * sympy.sqrt(s), s, 0),
    2,
)
