"""The Abel function of a sum of laws as an integral of its slow flow: no logarithm is expanded, the defect is bounded.

>>> derivation.steps[1].right
1
"""

import sympy

from derivations.steps import At, Derivation, Taylor, defined

lam, xi, w, w2 = sympy.symbols("lambda xi w_1 w_2", positive=True)
c1, c2, v3c, d1, d2 = sympy.symbols("c_1 c_2 c_3 delta_1 delta_2", positive=True)
rho, D, x, j = sympy.symbols("rho_1 D x j", positive=True)
k = sympy.Symbol("k", real=True)

derivation = Derivation(
    "abel-flow",
    "The n-th turning point of a sum of laws, every exponent above 1: the Abel function as an integral",
    source="turning.abel_flow; x = ln A, delta_i = epsilon_i e^(w_i x), w_i = alpha_i - 1, 0 < w_1 < w_2 < ...",
)
step, asserts = derivation.step, derivation.asserts

# The formal flow through third order: v = lambda v_1 + lambda^3 v_3, the delta_i made lambda times larger.
v1 = -c1 * d1 - c2 * d2
v3 = -v3c * d1**2 * d2  # one monomial stands for all of degree 3


def slope_of(f: sympy.Expr) -> sympy.Expr:
    """df/dx: delta_i grows like e^(w_i x)."""
    return w * d1 * sympy.diff(f, d1) + w2 * d2 * sympy.diff(f, d2)


D_x = defined("D", slope_of)
v = lam * v1 + lam**3 * v3
shift = v1 * lam + v1 * slope_of(v1) / 2 * lam**2 + (v3 + v1 * slope_of(v1 * slope_of(v1)) / 6) * lam**3
step(
    "The half-swing shifts x by L, the time-one map of dx/dj = v = lambda v_1 + lambda^3 v_3; D is d/dx: through"
    " lambda^3 L is v + v Dv/2 + v D(v Dv)/6",
    Taylor(v + v * D_x(v) / 2 + v * D_x(v * D_x(v)) / 6, lam, 3),
    shift,
)


def over_shift(f: sympy.Expr, k: sympy.Expr) -> sympy.Expr:
    """The coefficient of lambda^(k+1) in int_x^(x+L) f, by the Taylor series of f about x."""
    total, derivative = sympy.Integer(0), f
    for n in range(1, 4):
        total += derivative * sympy.Poly(shift**n, lam).coeff_monomial(lam ** (int(k) + 1)) / sympy.factorial(n)
        derivative = slope_of(derivative)
    return sympy.cancel(total)


grown = defined("G", over_shift)  # times 1/lambda for f = 1/v_1, times lambda for -v_3/v_1^2
e1, e2 = d1 * sympy.exp(w * x), d2 * sympy.exp(w2 * x)
step(
    "With K = 1 term, f = 1/(lambda v_1), the integral of f over it, f L + Df L^2/2 + D^2f L^3/6, has at lambda^k the"
    " coefficient G(1/v_1, k); it begins with",
    grown(1 / v1, 0),
    sympy.Integer(1),
)
step(
    "has no power lambda, whatever the two exponents are,",
    grown(1 / v1, 1),
    sympy.Integer(0),
)
step(
    "and the defect begins with",
    grown(1 / v1, 2),
    v3 / v1,
)
step(
    "which the second term -lambda v_3/v_1^2 takes away",
    grown(-v3 / v1**2, 0),
    -v3 / v1,
)

K = sympy.Symbol("K", positive=True, integer=True)
missing = sympy.Symbol("g_K")
step(
    "In general: the integral of 1/v over the time-one map is 1, exactly. K terms of 1/v lack g_K lambda^(2K-1) + ...,"
    " and over the length L = lambda v_1 + ... the integral begins with",
    sympy.Integral(missing * lam ** (2 * K - 1), (x, 0, lam * v1)),
    missing * v1 * lam ** (2 * K),
)
s = sympy.Symbol("s", positive=True)
u1, u2 = sympy.symbols("u_1 u_2", positive=True)
a1, a2 = sympy.symbols("alpha_1 alpha_2", positive=True)
slope = -w * u1 * (u1 * s ** (a1 + 1) + u2 * s ** (a2 + 1)) / (1 - k)
step(
    "Along the orbit: u_i = epsilon_i r^w_i obeys u_1' = -w_1 u_1 N/(1 - C), N = sum u_i s^(alpha_i+1) >= u_1"
    " s^(alpha_1+1): the other laws only add; (1/u_1)' (1 - C)/w_1 is",
    -sympy.Derivative(1 / u1, u1) * -slope * (1 - k) / w,
    s ** (a1 + 1) + u2 * s ** (a2 + 1) / u1,
)
gap, small = sympy.symbols("d C_2", nonnegative=True)
asserts(
    "C = sum u_i s^alpha_i c falls from theta to pi - theta, from C_1 = C_2 + d to C_2, because all u_i fall: with the"
    " factors 1/(1 - C_1) and 1/(1 + C_2) a pair gives 2 at least, d + 2 C_1 C_2 >= 0, so 1/delta_1 grows by g = w_1 pi"
    " M_(alpha_1+1) at least",
    sympy.Ge(gap + 2 * (small + gap) * small, 0, evaluate=False),
)
step(
    "and ln(delta_i/delta_1) falls with x, its slope in x being",
    sympy.Derivative(sympy.log(e2 / e1), x),
    w2 - w,
)

re_xi, im_xi = sympy.symbols("xi_r xi_i", real=True)
turned = sympy.Symbol("xi")
step(
    "On |lambda delta_1| = rho_1 and |xi| <= G, lambda turned to the positive axis: the terms of -v_1 have real parts"
    " c_i |lambda delta_i| e^(w_i xi_r) cos(w_i xi_i), >= 0 for w_i G <= pi/2, and of the first at least b = c_1 rho_1"
    " e^(-w_1 G) cos(w_1 G)",
    At(sympy.re(c1 * rho * sympy.exp(w * turned), evaluate=False), {turned: re_xi + sympy.I * im_xi}),
    c1 * rho * sympy.exp(w * re_xi) * sympy.cos(w * im_xi),
)
bound, lower = sympy.symbols("g_t a_t", positive=True)  # the series 1 + g_1 t + ..., a_1 t + a_2 t^2 + ...
step(
    "With |v_(2k+1)| <= a_k b there, the g_k, whose recurrence is |g_k| <= sum_j a_j |g_(k-j)|, are at most those of"
    " g(t) = 1 + a(t) g(t), a(t) = a_1 t + a_2 t^2 + ...: the coefficients of",
    At(bound - lower * bound, {bound: 1 / (1 - lower)}),
    sympy.Integer(1),
)
step(
    "Hence |d| <= D = 1 + G (1 + g_1 + ... )/b on that circle, and Schwarz' inequality for d = O(lambda^(2K)), |lambda|"
    " = rho_1/delta_1 on it, gives at lambda = 1 D (delta_1/rho_1)^(2K): a power of delta_1, as in abel-defect",
    At(D * (1 / lam) ** (2 * K), {lam: rho / d1}),
    D * (d1 / rho) ** (2 * K),
)
step(
    "Further on rho_i may be kept for i > 1, since delta_i/delta_1 falls. The following term: |g_K/v_1| <= C"
    " delta_1^(2K-1), and over all smaller amplitudes",
    sympy.Derivative(d1 ** (2 * K - 1) * sympy.exp((2 * K - 1) * w * x) / ((2 * K - 1) * w), x),
    (d1 * sympy.exp(w * x)) ** (2 * K - 1),
)
