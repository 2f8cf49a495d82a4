"""Multiple scales for X'' + X + eps X'|X'|^(alpha-1) = 0, any alpha >= 0, to second order, in closed form.

The force is expanded in harmonics; the second-order frequency is a sum over them, and the sum telescopes.  Two laws
cost no more than one, so the sum is done for exponents alpha, beta.

>>> Omega_2.subs(alpha, 3)
9/256
"""

import sympy
from sympy import cos, gamma, pi, sin, sqrt

from derivations.steps import At, Coefficient, Derivation, Solution, defined

alpha, beta = sympy.symbols("alpha beta", nonnegative=True)
n = sympy.Symbol("n", positive=True)
a = sympy.Symbol("a", positive=True)
psi, eps = sympy.symbols("psi epsilon", real=True)
p, q, B, C, M, S = sympy.symbols("p q b_n c_n M S", real=True)
f_2, g_2 = sympy.symbols("f_2 g_2", real=True)
R = sympy.Rational

derivation = Derivation(
    "multiple-scales-general",
    "Multiple scales for any exponent to second order",
    source="Lancaster 2020, (13) is the first order; the second is not in the papers",
)
step = derivation.step


def moment(x: sympy.Expr) -> sympy.Expr:
    """M_x = <|sin|^x>."""
    return gamma((x + 1) * R(1, 2)) / (sqrt(pi) * gamma(x * R(1, 2) + 1))


def magnitude(x: sympy.Expr, m: sympy.Expr) -> sympy.Expr:
    """b_m without its sign (-1)^((m-1)/2)."""
    return 2 ** (1 - x) * gamma(x + 1) / (gamma((x + m) / 2 + 1) * gamma((x - m) / 2 + 1))


# The harmonics b_n of |sin|^alpha sgn sin.
b = defined("b", lambda m: magnitude(alpha, m), index=True)
derivation.defines(
    "b_n = (2/pi) int_0^pi sin^alpha sin n psi, a Beta integral, is, without its sign (-1)^((n-1)/2),",
    b(n),
    magnitude(alpha, n),
)
step("its first value is the mean: b_1 = 2 M_(alpha+1)", b(1), sympy.gammasimp(2 * moment(alpha + 1)))
step(
    "Neighbours: b_(n+2)/b_n, with the sign that changes from n to n + 2",
    -b(n + 2) / b(n),
    (n - alpha) / (n + alpha + 2),
)
# The same ratio from the equation that |sin|^alpha sgn sin obeys, without the Beta integral.
s = sympy.Function("s")(psi)
step(
    "The same from the series: with s' the cosine series sum n b_n cos n psi, sin psi s' = alpha cos psi s",
    sin(psi) * sympy.Derivative(sin(psi) ** alpha, psi) - alpha * cos(psi) * sin(psi) ** alpha,
    sympy.S.Zero,
)
b_next = sympy.Symbol("b_{n+2}")
step(
    "so between n and n + 2: (n b_n - (n+2) b_(n+2))/2 = alpha (b_n + b_(n+2))/2",
    At(n * B - (n + 2) * b_next, {b_next: (n - alpha) / (n + 2 + alpha) * B}),
    At(alpha * (B + b_next), {b_next: (n - alpha) / (n + 2 + alpha) * B}),
)

# Order 1: V_0 = -a sin psi.
f_1, slope = -p * a**alpha, sympy.Symbol("f_1", real=True)
step(
    "Order 1, coefficient of sin psi: 2 f_1 + a^alpha b_1 = 0 with b_1 = 2 p, p = M_(alpha+1); D_1 a = f_1",
    Solution(2 * slope + 2 * p * a**alpha, 0, slope),
    f_1,
)
x_n = -(a**alpha) * B / (n**2 - 1) * sin(n * psi)
step("Each harmonic n >= 3 of X_1", sympy.Derivative(x_n, psi, 2) + x_n, a**alpha * B * sin(n * psi))

# Order 2: the equation, from the ansatz; then its coefficient of cos psi.
D_0, D_1, D_2, X_0, X_1, X_2 = sympy.symbols("D_0 D_1 D_2 X_0 X_1 X_2", commutative=False)
slopes, ansatz = D_0 + eps * D_1 + eps**2 * D_2, X_0 + eps * X_1 + eps**2 * X_2
step(
    "Order 2 of d^2X/dtau^2, with the operators D_n = (D_n a) d/da + (D_n psi) d/d psi, which do not commute",
    Coefficient(slopes**2 * ansatz, eps, 2),
    D_0**2 * X_2 + (D_0 * D_1 + D_1 * D_0) * X_1 + (D_1**2 + D_0 * D_2 + D_2 * D_0) * X_0,
)
drag = sympy.Function("S")
V_a, V_b = sympy.symbols("V_0 V_1", real=True)
step(
    "and of the force eps S(V), S(V) = V|V|^(alpha-1), V = V_0 + eps V_1 + ..., V_1 = D_0 X_1 + D_1 X_0",
    R(1, 2) * At(sympy.Derivative(eps * drag(V_a + eps * V_b), (eps, 2)), {eps: 0}),
    V_b * sympy.diff(drag(V_a), V_a),
)
slow = defined("D_1", lambda h: f_1 * sympy.diff(h, a))
step(
    "-D_1 D_1 X_0, with D_1 psi = 0",
    -slow(slow(a * cos(psi))),
    -alpha * p**2 * a ** (2 * alpha - 1) * cos(psi),
)
step(
    "-(D_0 D_2 + D_2 D_0) X_0",
    -2 * (f_2 * sympy.Derivative(a * cos(psi), psi, a) + g_2 * sympy.Derivative(a * cos(psi), psi, 2)),
    2 * f_2 * sin(psi) + 2 * a * g_2 * cos(psi),
)
V_1 = sympy.diff(x_n, psi)
step(
    "The velocity at order 1: f_1 cos psi and, for each n,",
    sympy.Derivative(x_n, psi),
    -(a**alpha) * n * B / (n**2 - 1) * cos(n * psi),
)
S_of = sympy.Function("S")
step(
    "The force is S'(V_0) V_1, S(V) = V|V|^(alpha-1). Since dV_0/d psi = -a cos psi,"
    " a cos psi S'(V_0) = -d S(V_0)/d psi",
    sympy.Derivative(S_of(-a * sin(psi)), psi),
    -a * cos(psi) * sympy.Subs(sympy.diff(S_of(f_2), f_2), f_2, -a * sin(psi)),
)
force_n = a**alpha * n * B * cos(n * psi)
step(
    "and S(V_0) = -a^alpha sum b_n sin n psi: the n-th harmonic of a cos psi S'(V_0). At alpha = 0 this is"
    " the series of the delta functions 2 a cos psi delta(V_0), all harmonics with n b_n = 4/pi",
    -sympy.Derivative(-(a**alpha) * B * sin(n * psi), psi),
    force_n,
)
whole = sympy.Symbol("n", integer=True, positive=True)
pulls = -(force_n / a * sympy.diff(x_n, psi)).subs(n, whole), -(a**alpha * 2 * p * cos(psi) / a) * f_1 * cos(psi)
means = [sympy.Integral(pull, (psi, 0, 2 * pi)) / (2 * pi) for pull in pulls]
step(
    "Coefficient of cos psi in -S'(V_0) V_1 = -2 <S'(V_0) cos psi V_1>: harmonic n of X_1, and f_1 cos psi with b_1",
    2 * (means[0] + means[1]),
    a ** (2 * alpha - 1) * (whole**2 * B**2 / (whole**2 - 1) + 2 * p**2),
)
condition = 2 * a * g_2 - alpha * p**2 * a ** (2 * alpha - 1) + a ** (2 * alpha - 1) * (S + 2 * p**2)
step(
    "Solvability, with S = sum_(n>=3) n^2 b_n^2/(n^2-1); D_2 a = 0, for there is no sin psi;"
    " D_2 psi = a^(2 alpha-2) times",
    Solution(condition, 0, g_2) / a ** (2 * alpha - 2),
    (alpha - 2) * p**2 / 2 - S / 2,
)

# The sum, for two exponents.
ratio = (n - alpha) * (n - beta) / ((n + alpha + 2) * (n + beta + 2))
certificate = -(n + alpha) * (n + beta) / (2 * (alpha + 1) * (beta + 1) * (n - 1))
weight = (alpha + beta + 1) / ((alpha + 1) * (beta + 1))
step(
    "b_n c_n/(n^2-1) + weight b_n c_n = F(n+2) - F(n) with F(n) = certificate b_n c_n: divided by b_n c_n",
    1 / (n**2 - 1) + weight,
    ratio * At(certificate, {n: n + 2}) - certificate,
)
step(
    "b_n = O(n^(-alpha-1)), so F(n) = O(n^(-alpha-beta-1)) vanishes at infinity;"
    " at the lower end b_3 = (1-alpha)/(3+alpha) b_1",
    At(certificate, {n: 3}) * (1 - alpha) * (1 - beta) / ((3 + alpha) * (3 + beta)) * 4 * p * q,
    -(alpha - 1) * (beta - 1) / ((alpha + 1) * (beta + 1)) * p * q,
)
lower = -(alpha - 1) * (beta - 1) / ((alpha + 1) * (beta + 1)) * p * q
M_3 = sympy.Symbol("Sigma", real=True)
rest = 2 * M - 4 * p * q
total = At(M_3 + (-lower - weight * M_3), {M_3: rest})
step(
    "Parseval: Sigma = sum_(n>=3) b_n c_n = 2 M - 4 p q with M = M_(alpha+beta); n^2/(n^2-1) = 1 + 1/(n^2-1)",
    total,
    (2 * alpha * beta * M + (1 - alpha - beta - 3 * alpha * beta) * p * q) / ((alpha + 1) * (beta + 1)),
)
single = At((alpha - 2) * p**2 / 2 - S / 2, {S: total.doit().subs({beta: alpha, q: p})})
closed = -((alpha / (alpha + 1)) ** 2) * M + (alpha - 1) * (alpha + 3) / (2 * (alpha + 1)) * p**2
step("Omega_2, no first harmonic, with M = M_(2 alpha), p = M_(alpha+1)", single, closed)
Omega_2 = closed.subs({M: moment(2 * alpha), p: moment(alpha + 1)})
step("alpha = 3", At(Omega_2, {alpha: 3}), R(9, 256))
step("alpha = 1: sqrt(1 - eps^2/4) - 1", At(Omega_2, {alpha: 1}), -R(1, 8))
step("alpha = 0; without the delta function the condition would give 0", At(Omega_2, {alpha: 0}), -6 / pi**2)

# The initial phase, and the observable.
own = -(n + alpha) / (2 * (alpha + 1) * (n - 1))
step(
    "X'(0) = 0 needs sum n b_n/(n^2-1), which telescopes with G(n) = -(n+alpha)/(2(alpha+1)(n-1)) b_n",
    (n - alpha) / (n + alpha + 2) * At(own, {n: n + 2}) - own,
    n / (n**2 - 1),
)
turn = -At(own, {n: 3}) * (1 - alpha) / (3 + alpha) * 2 * p
chi = p + turn
step(
    "a turning point is at psi = -chi delta, chi = p - G(3) with b_3 = (1-alpha)/(3+alpha) 2 p",
    chi,
    (alpha + 3) / (2 * (alpha + 1)) * p,
)
delta_rate = sympy.Symbol("delta_tau", real=True)
step(
    "psi_tp = psi + chi delta with d delta/d tau = delta_tau delta^2 = -(alpha-1) p delta^2: the frequency at the"
    " turning points",
    At(closed + delta_rate * (alpha + 3) / (2 * (alpha + 1)) * p, {delta_rate: -(alpha - 1) * p}),
    -((alpha / (alpha + 1)) ** 2) * M,
)
half_period = pi * (alpha / (alpha + 1)) ** 2 * moment(2 * alpha)
step("The half period is pi + this delta^2 + ...; alpha = 2: Smith's pi/6", At(half_period, {alpha: 2}), pi / 6)
step("alpha = 0: the half period of dry friction is exactly pi", At(half_period, {alpha: 0}), sympy.S.Zero)
step(
    "Near miss: with twice the moment of Parseval the value 9/256 at alpha = 3 is lost",
    At(closed, {M: 2 * moment(6), p: moment(4), alpha: 3}),
    R(9, 256) - R(9, 16) * R(5, 16),
)
