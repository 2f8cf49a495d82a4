"""The Abel function of a sum of laws as an integral of its slow flow: no logarithm is expanded, the defect is bounded.

>>> print(derivation.steps[0].text())
[lambda^0] int 1/(lambda v_1) = 1
"""

import sympy

from derivations.steps import At, Derivation, named

lam, xi, w, w2 = sympy.symbols("lambda xi w_1 w_2", positive=True)
c1, c2, v3c, d1, d2 = sympy.symbols("c_1 c_2 c_3 delta_1 delta_2", positive=True)
rho, D, x, j = sympy.symbols("rho_1 D x j", positive=True)
k = sympy.Symbol("k", real=True)

derivation = Derivation(
    "abel-flow",
    "The n-th turning point of a sum of laws, every exponent above 1: the Abel function as an integral",
    source="turning.abel_flow; x = ln A, delta_i = epsilon_i e^(w_i x), w_i = alpha_i - 1, 0 < w_1 < w_2 < ...",
)
step, holds = derivation.step, derivation.holds

# The formal flow through third order: v = lambda v_1 + lambda^3 v_3, the delta_i made lambda times larger.
v1 = -c1 * d1 - c2 * d2
v3 = -v3c * d1**2 * d2  # one monomial stands for all of degree 3


def slope_of(f: sympy.Expr) -> sympy.Expr:
    """df/dx: delta_i grows like e^(w_i x)."""
    return w * d1 * sympy.diff(f, d1) + w2 * d2 * sympy.diff(f, d2)


shift, term = {n: sympy.Integer(0) for n in (1, 2, 3)}, {1: v1, 3: v3}
for order in range(1, 4):  # L = sum D^(n-1) v/n!, the time-one map of dx/dj = v, power of lambda by power
    for n, part in term.items():
        shift[n] += part / sympy.factorial(order)
    slopes = {n: slope_of(part) for n, part in term.items()}
    term = {n + 1: v1 * slopes[n] for n in (1, 2) if n in slopes}
L = sum(shift[n] * lam**n for n in shift)


def grown(f: sympy.Expr) -> list[sympy.Expr]:
    """The coefficients of lambda, lambda^2, lambda^3 of int_x^(x+L) f, by the Taylor series of f about x."""
    total, derivative = [sympy.Integer(0)] * 3, f
    for n in range(3):
        power = sympy.Poly(L ** (n + 1), lam)
        for i in range(3):
            total[i] += derivative * power.coeff_monomial(lam ** (i + 1)) / sympy.factorial(n + 1)
        derivative = slope_of(derivative)
    return [sympy.cancel(part) for part in total]


first, second = grown(1 / v1), grown(-v3 / v1**2)  # times 1/lambda and lambda
e1, e2 = d1 * sympy.exp(w * x), d2 * sympy.exp(w2 * x)
step(
    "The half-swing shifts x by L, the time-one map of dx/dj = v: with K = 1 term, f = 1/(lambda v_1), the integral of"
    " f over it begins with",
    named("[lambda^0] int 1/(lambda v_1)", first[0]),
    sympy.Integer(1),
)
step(
    "has no power lambda, whatever the two exponents are,",
    named("[lambda] int 1/(lambda v_1)", first[1]),
    sympy.Integer(0),
)
step(
    "and the defect begins with",
    named("[lambda^2] int 1/(lambda v_1)", first[2]),
    sympy.cancel(v3 / v1),
)
step(
    "which the second term -lambda v_3/v_1^2 takes away",
    named("[lambda^2] int -lambda v_3/v_1^2", second[0]),
    -sympy.cancel(v3 / v1),
)

K = sympy.Symbol("K", positive=True, integer=True)
missing = sympy.Symbol("g_K")
step(
    "In general: the integral of 1/v over the time-one map is 1, exactly. K terms of 1/v lack g_K lambda^(2K-1) + ...,"
    " and over the length L = lambda v_1 + ... that is",
    (missing * lam ** (2 * K - 1)) * (lam * v1),
    missing * v1 * lam ** (2 * K),
)
s = sympy.Symbol("s", positive=True)
u1, u2 = sympy.symbols("u_1 u_2", positive=True)
a1, a2 = sympy.symbols("alpha_1 alpha_2", positive=True)
slope = -w * u1 * (u1 * s ** (a1 + 1) + u2 * s ** (a2 + 1)) / (1 - k)
step(
    "Along the orbit: u_i = epsilon_i r^w_i obeys u_1' = -w_1 u_1 N/(1 - C), N = sum u_i s^(alpha_i+1) >= u_1"
    " s^(alpha_1+1): the other laws only add",
    named("-u_1' (1 - C)/(w_1 u_1^2)", sympy.expand(-slope / u1**2 * (1 - k) / w)),
    s ** (a1 + 1) + u2 * s ** (a2 + 1) / u1,
)
gap, small = sympy.symbols("d C_2", nonnegative=True)
holds(
    "C = sum u_i s^alpha_i c falls from theta to pi - theta, from C_1 = C_2 + d to C_2, because all u_i fall: with the"
    " factors 1/(1 - C_1) and 1/(1 + C_2) a pair gives 2 at least, d + 2 C_1 C_2 >= 0, so 1/delta_1 grows by g = w_1 pi"
    " M_(alpha_1+1) at least",
    bool((gap + 2 * (small + gap) * small).is_nonnegative),
    gap + 2 * (small + gap) * small,
)
step(
    "and ln(delta_i/delta_1) falls with x, its slope in x being",
    sympy.Derivative(sympy.log(e2 / e1), x),
    w2 - w,
)

re_xi, im_xi = sympy.symbols("xi_r xi_i", real=True)
step(
    "On |lambda delta_1| = rho_1 and |xi| <= G, lambda turned to the positive axis: the terms of -v_1 have real parts"
    " c_i |lambda delta_i| e^(w_i xi_r) cos(w_i xi_i), >= 0 for w_i G <= pi/2, and of the first at least b = c_1 rho_1"
    " e^(-w_1 G) cos(w_1 G)",
    named("Re e^(w_1 (xi_r + i xi_i))", sympy.re(sympy.exp(w * (re_xi + sympy.I * im_xi)))),
    sympy.exp(w * re_xi) * sympy.cos(w * im_xi),
)
bound, lower = sympy.symbols("g_t a_t", positive=True)  # the series 1 + g_1 t + ..., a_1 t + a_2 t^2 + ...
step(
    "With |v_(2k+1)| <= a_k b there, the g_k, whose recurrence is |g_k| <= sum_j a_j |g_(k-j)|, are at most those of"
    " g(t) = 1 + a(t) g(t), a(t) = a_1 t + a_2 t^2 + ...: the coefficients of",
    At(bound - lower * bound, {bound: 1 / (1 - lower)}),
    sympy.Integer(1),
)
holds(
    "Hence |d| <= D = 1 + G (1 + g_1 + ... )/b on that circle, and Schwarz' inequality for d = O(lambda^(2K)) gives at"
    " lambda = 1: |d| <= D (delta_1/rho_1)^(2K), a power of delta_1 whose sum along the orbit is that of abel-defect",
    bool((D * (d1 / rho) ** (2 * j)).is_positive),
    D * (d1 / rho) ** (2 * j),
)
step(
    "Further on rho_i may be kept for i > 1, since delta_i/delta_1 falls. The following term: |g_K/v_1| <= C"
    " delta_1^(2K-1), and over all smaller amplitudes",
    sympy.Derivative(d1 ** (2 * K - 1) * sympy.exp((2 * K - 1) * w * x) / ((2 * K - 1) * w), x),
    (d1 * sympy.exp(w * x)) ** (2 * K - 1),
)
