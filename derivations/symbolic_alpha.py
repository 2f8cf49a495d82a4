"""One law with a symbolic exponent: U_1, U_3, W_2 and W_4 from the half-swing equations, step by step.

The motion is started at the equilibrium passage theta = pi/2 with r = 1, rho = q, and followed back to the turning
point theta = 0.  One integral remains, J = <s^(2 alpha) S^2> with S = int_(pi/2)^theta s^(alpha+1).

>>> W_4.subs({alpha: 0})
0
"""

import sympy

from asymptotics.expansions.half_swings.fourier_flow import fourier_flow
from asymptotics.expansions.half_swings.symbolic import nested_integral_exact
from asymptotics.expansions.moments.symbolic import moment
from derivations.steps import At, Coefficient, Derivation, Solution, Taylor, defined

alpha, s = sympy.symbols("alpha s", positive=True)
c = sympy.Symbol("c", real=True)
S, S_1, S_3 = sympy.symbols("S S_1 S_3", real=True)
M, M2, M3, M4, J, I_4, m = sympy.symbols("M_(alpha+1) M_(2alpha) M_(3alpha+1) M_(4alpha) J I_4 m")
a, b = alpha - 1, 1 / (2 * alpha + 2)
half = sympy.pi / 2
ORDER = 4

derivation = Derivation(
    "symbolic-alpha",
    "One law, any exponent: closed forms through fourth order",
    source="theory page closed_forms; expansions.half_swings.symbolic, expansions.normal_form.symbolic",
)
step = derivation.step


def reduced(f: sympy.Expr) -> sympy.Expr:
    """Expanded, with c^2 = 1 - s^2, as a polynomial in c of degree 1; powers of s collected."""
    f = sympy.expand(f)
    while f.has(c**2) or f.has(c**3) or f.has(c**4):
        f = sympy.expand(f.subs({c**4: (1 - s**2) ** 2, c**3: c * (1 - s**2), c**2: 1 - s**2}))
    return sympy.powsimp(f)


def rate(f: sympy.Expr) -> sympy.Expr:
    """d f/d theta with S' = s^(alpha+1), S_1' = s^(3 alpha+1), S_3' = s^(3 alpha+3)."""
    slopes = {s: c, c: -s, S: s ** (alpha + 1), S_1: s ** (3 * alpha + 1), S_3: s ** (3 * alpha + 3)}
    return reduced(sum(sympy.diff(f, name) * slope for name, slope in slopes.items()))


slope = defined("D_theta", rate)
# ln r = q l_1 + q^2 l_2 + q^3 l_3.
l_1 = -S
l_2 = a * S**2 / 2 + b * (1 - s ** (2 * alpha + 2))
l_3 = -(a**2) * S**3 / 3 - a * b * S + 2 * a * b * S * s ** (2 * alpha + 2) + (1 - a * b) * S_3 - S_1


def power(n: int, k: int) -> sympy.Expr:
    """The coefficient of q^k in rho^n = q^n exp(n a ln r)."""
    y_1, y_2, y_3 = (n * a * x for x in (l_1, l_2, l_3))
    return (sympy.Integer(1), y_1, y_2 + y_1**2 / 2, y_3 + y_1 * y_2 + y_1**3 / 6)[k - n]


def force(k: int) -> sympy.Expr:
    """The coefficient of q^k in N s/D = sum_n rho^n s^(n alpha+1) c^(n-1)."""
    return sum(power(n, k) * s ** (n * alpha + 1) * c ** (n - 1) for n in range(1, k + 1))


def lag(k: int) -> sympy.Expr:
    """The coefficient of q^k in 1/D - 1 = sum_n rho^n s^(n alpha) c^n."""
    return sum(power(n, k) * s ** (n * alpha) * c**n for n in range(1, k + 1))


for n, value in ((1, l_1), (2, l_2), (3, l_3)):
    step(
        f"d ln r/d theta = -sum_n rho^n s^(n alpha+1) c^(n-1), order q^{n}: l_{n} = {value} has this derivative, and"
        " vanishes at the passage (s = 1, all S = 0)",
        slope(value),
        reduced(-force(n)),
    )
step("with l_2 at the passage", At(l_2, {S: 0, s: 1}), sympy.Integer(0))

# Moments of the quarter-swing: <f> = (2/pi) int_0^(pi/2) f.
p = sympy.Symbol("p", positive=True)
step("<s^(p+2)> = (p+1)/(p+2) <s^p>", slope(s ** (p + 1) * c), (p + 1) * s**p - (p + 2) * s ** (p + 2))
M_22 = M2 * (2 * alpha + 1) / (2 * alpha + 2)
M_33 = M3 * (3 * alpha + 2) / (3 * alpha + 3)
M_42 = M4 * (4 * alpha + 1) / (4 * alpha + 2)
M_44 = M_42 * (4 * alpha + 3) / (4 * alpha + 4)
turning = {s: 0, S: -m, S_1: -half * M3, S_3: -half * M_33}
lam = {
    1: m,
    2: a * m**2 / 2 + b,
    3: a**2 * m**3 / 3 + a * b * m + half * (M3 - (1 - a * b) * M_33),
}
for n, value in ((1, l_1), (2, l_2), (3, l_3)):
    step(
        f"At the turning point (s = 0, S = -m, m = pi M_(alpha+1)/2): lambda_{n}",
        At(At(value, {s ** (2 * alpha + 2): 0}), turning),
        lam[n],
    )

# The duration of the quarter-swing, even orders.
by_parts = -a * S * s ** (alpha + 1) / (alpha + 1)
rest = a / (alpha + 1) * s ** (2 * alpha + 2) + s ** (2 * alpha) - s ** (2 * alpha + 2)
step(
    "d tau/d theta = 1 + sum_n rho^n s^(n alpha) c^n, order q^2; the first term by parts, with nothing at the ends,",
    At(sympy.expand(lag(2)), {c**2: 1 - s**2}),
    slope(by_parts) + rest,
)
M_up = sympy.Symbol("M_(2alpha+2)")
t_2 = At(half * (a / (alpha + 1) * M_up + M2 - M_up), {M_up: M_22})
step("so t_2 = (pi/2) (alpha/(alpha+1))^2 M_(2alpha)", t_2, half * M2 * (alpha / (alpha + 1)) ** 2)
f, g, line_1, line_2, line_3 = sympy.symbols("f g l_1 l_2 l_3")
step(
    "order q^4, with f = a l_3 + a^2 l_1 l_2 + a^3 l_1^3/6 and g = 2 a l_2 + 2 a^2 l_1^2",
    At(lag(4), {power(1, 4): f, power(2, 4): g}),
    s**alpha * c * f + s ** (2 * alpha) * c**2 * g + 3 * a * l_1 * s ** (3 * alpha) * c**3 + s ** (4 * alpha) * c**4,
)
f_closed = -(a**3) * S**3 - 2 * a**2 * b * S + 3 * a**2 * b * S * s ** (2 * alpha + 2) + a * (1 - a * b) * S_3 - a * S_1
step(
    "f itself is",
    At(a * line_3 + a**2 * line_1 * line_2 + a**3 * line_1**3 / 6, {line_1: l_1, line_2: l_2, line_3: l_3}),
    f_closed,
)
f_rate = (
    -3 * a**3 * s ** (alpha + 1) * S**2
    - 2 * a**2 * b * (s ** (alpha + 1) - s ** (3 * alpha + 3))
    + 3 * a**2 * s ** (2 * alpha + 1) * c * S
    - a * s ** (3 * alpha + 1)
    + a * s ** (3 * alpha + 3)
)
step("first term: int s^alpha c f = -int s^(alpha+1) f'/(alpha+1), f' =", slope(f_closed), f_rate)
step(
    "<s^(3 alpha+2) c S> = -M_(4 alpha+4)/(3 alpha+3)",
    slope(s ** (3 * alpha + 3) * S),
    ((3 * alpha + 3) * s ** (3 * alpha + 2) * c * S + s ** (4 * alpha + 4)),
)
step(
    "<s^(2 alpha+2) S^2> from J = <s^(2 alpha) S^2>",
    slope(s ** (2 * alpha + 1) * c * S**2),
    (
        (2 * alpha + 1) * s ** (2 * alpha) * S**2
        - (2 * alpha + 2) * s ** (2 * alpha + 2) * S**2
        + 2 * s ** (3 * alpha + 2) * c * S
    ),
)
J_22 = ((2 * alpha + 1) * J - 2 * M_44 / (3 * alpha + 3)) / (2 * alpha + 2)
odd = s ** (3 * alpha + 1) / (3 * alpha + 1) - s ** (3 * alpha + 3) / (3 * alpha + 3)
step(
    "third term: int s^(3 alpha) c^3 S = -int s^(alpha+1) (s^(3 alpha+1)/(3 alpha+1) - s^(3 alpha+3)/(3 alpha+3))",
    slope(odd * S),
    reduced(s ** (3 * alpha) * c**3 * S + odd * s ** (alpha + 1)),
)
f_mean = -3 * a**3 * J_22 - 2 * a**2 * b * (M_22 - M_44) - a**2 * M_44 / (alpha + 1) - a * (M_42 - M_44)
means = {
    "first": -f_mean / (alpha + 1),
    "second": 3 * a**2 * (J - J_22) + 2 * a * b * (M2 - M_22 - M_42 + M_44),
    "third": 3 * a * (M_42 / (3 * alpha + 1) - M_44 / (3 * alpha + 3)),
    "fourth": M4 - 2 * M_42 + M_44,
}
step(
    "second term: g",
    At(2 * a * line_2 + 2 * a**2 * line_1**2, {line_1: l_1, line_2: l_2}),
    3 * a**2 * S**2 + 2 * a * b * (1 - s ** (2 * alpha + 2)),
)

# From q to delta, and the flow.  Here the letter a stands for alpha - 1, so that what is solved for stays short.
w, q, delta, lam_1, lam_2, lam_3 = sympy.symbols("a q delta lambda_1:4")
L_1, L_2, u_1, u_3, w_2, w_4 = sympy.symbols("L_1 L_2 U_1 U_3 W_2 W_4")
t = (half, *sympy.symbols("t_1:5"))
found = {lam_1: half * M, lam_2: lam[2].subs(m, half * M), lam_3: lam[3].subs(m, half * M), w: a}
log_r = {1: lam_1, 2: lam_2, 3: lam_3}
start = {
    1: sympy.Integer(1),
    2: w * lam_1,
    3: w * lam_2 + w**2 * lam_1**2 / 2,
    4: w * lam_3 + w**2 * lam_1 * lam_2 + w**3 * lam_1**3 / 6,
}


def series(coefficients: dict[int, sympy.Expr], x: sympy.Symbol, last: int = ORDER) -> sympy.Expr:
    """The sum of c x^n through x^last."""
    return sympy.Add(*(c * x**n for n, c in coefficients.items() if n <= last))


def order(n: int, coefficients: dict[int, sympy.Expr]) -> sympy.Expr:
    """The coefficient of q^n in a series in delta, with delta = q exp(a lambda(q))."""
    return Coefficient(At(series(coefficients, delta, n), {delta: series(start, q, n)}), q, n)


def reversed_log(n: int) -> sympy.Expr:
    """The coefficient of q^n in lambda(-q) - lambda(q)."""
    return Coefficient(At(series(log_r, q, n), {q: -q}) - series(log_r, q, n), q, n)


def reversed_time(n: int) -> sympy.Expr:
    """The coefficient of q^n in t(-q) + t(q)."""
    time = series(dict(enumerate(t)), q, n)
    return Coefficient(At(time, {q: -q}) + time, q, n)


step(
    "At the turning point ln r = lambda(q) = lambda_1 q + ..., and delta = q exp(a lambda(q)), a = alpha - 1, begins",
    Taylor(q * sympy.exp(w * series(log_r, q)), q, ORDER),
    series(start, q),
)
step(
    "By reversal L = lambda(-q) - lambda(q), T = t(q) + t(-q). In powers of delta, order q gives L_1",
    At(Solution(order(1, {1: L_1}), reversed_log(1), L_1), {lam_1: found[lam_1]}),
    -sympy.pi * M,
)
step(
    "and order q^2 gives L_2",
    At(
        Solution(order(2, {1: L_1, 2: L_2}), reversed_log(2), L_2),
        {L_1: -sympy.pi * M, lam_1: found[lam_1], w: a},
    ),
    a * sympy.pi**2 * M**2 / 2,
)

U_1, U_3 = -M, -alpha * (3 * alpha + 1) / (6 * (alpha + 1) ** 2) * M3
W_2 = (alpha / (alpha + 1)) ** 2 * M2
rational = (
    alpha**2
    * (35 * alpha**3 + 9 * alpha**2 - 17 * alpha - 3)
    / (2 * (alpha + 1) ** 4 * (2 * alpha + 1) * (3 * alpha + 1))
)
W_4 = rational * M4 + 3 * (alpha * a / (alpha + 1)) ** 2 * I_4


def over_half_swing(f: sympy.Expr, last: int) -> sympy.Expr:
    """int_0^pi f d psi = sum_j pi^(j+1)/(j+1)! D^j f through j = last, not yet differentiated."""
    terms = [f]
    for _ in range(last):
        terms.append(w * delta * (u_1 * delta + u_3 * delta**3) * sympy.Derivative(terms[-1], delta))
    return sympy.Add(*(sympy.pi ** (j + 1) / sympy.factorial(j + 1) * term for j, term in enumerate(terms)))


L_of_flow = {
    1: sympy.pi * u_1,
    2: sympy.pi**2 * w * u_1**2 / 2,
    3: sympy.pi * u_3 + sympy.pi**3 * w**2 * u_1**3 / 3,
    4: 2 * sympy.pi**2 * w * u_1 * u_3 + sympy.pi**4 * w**3 * u_1**4 / 4,
}
step(
    "L is the integral of U = U_1 delta + U_3 delta^3 over 0 < psi < pi along d delta/d psi = a delta U: with D = a"
    " delta U d/d delta it is sum_j pi^(j+1)/(j+1)! D^j U, through delta^4",
    Taylor(over_half_swing(u_1 * delta + u_3 * delta**3, 3), delta, ORDER),
    series(L_of_flow, delta),
)
step(
    "With delta = q exp(a lambda(q)) that is lambda(-q) - lambda(q). Order q has one solution, U_1",
    At(Solution(order(1, L_of_flow), reversed_log(1), u_1), {lam_1: found[lam_1]}),
    U_1,
)
step(
    "order q^3 has one, U_3,",
    At(Solution(order(3, L_of_flow), reversed_log(3), u_3), {u_1: U_1, **found}),
    U_3,
)
first = -2 * lam_1 / sympy.pi
third = (-2 * lam_3 + 2 * w * lam_1 * lam_2 - w**2 * lam_1**3 / 3) / sympy.pi
step(
    "and the orders q^2 and q^4, where lambda(-q) - lambda(q) has nothing, cancel, whatever the lambda_n are",
    sympy.Tuple(At(order(2, L_of_flow), {u_1: first}), At(order(4, L_of_flow), {u_1: first, u_3: third})),
    sympy.Tuple(0, 0),
)
T_of_flow = {
    0: sympy.pi,
    2: sympy.pi * w_2,
    3: sympy.pi**2 * w * u_1 * w_2,
    4: sympy.pi * w_4 + sympy.pi**3 * w**2 * u_1**2 * w_2,
}
step(
    "T is the integral of W = 1 + W_2 delta^2 + W_4 delta^4 likewise, through delta^4",
    Taylor(over_half_swing(1 + w_2 * delta**2 + w_4 * delta**4, 2), delta, ORDER),
    series(T_of_flow, delta),
)
step(
    "and t(q) + t(-q) in powers of q. Order q^2 has one solution, W_2",
    At(Solution(order(2, T_of_flow), reversed_time(2), w_2), {t[2]: half * M2 * (alpha / (alpha + 1)) ** 2}),
    W_2,
)
step(
    "order q^3, where t(q) + t(-q) has nothing, cancels, whatever W_2 is",
    At(order(3, T_of_flow), {u_1: first}),
    sympy.Integer(0),
)
fourth = 2 * t[4] / sympy.pi - 2 * w * lam_2 * w_2
step(
    "and order q^4 has one solution, W_4,",
    At(Solution(order(4, T_of_flow), reversed_time(4), w_4), {u_1: first}),
    fourth,
)
step(
    "where t_4 is pi/2 times the means of the four terms, with J = I_4 + pi^2 M_(alpha+1)^2 M_(2alpha)/12:",
    At(
        At(fourth, {t[4]: half * sympy.Add(*means.values()), w_2: W_2, lam_2: found[lam_2], w: a}),
        {J: I_4 + sympy.pi**2 * M**2 * M2 / 12},
    ),
    W_4,
)
step(
    "p = -U/W: p_1 = M_(alpha+1), p_3 = -U_3 + U_1 W_2",
    At(
        Coefficient(-(u_1 * delta + u_3 * delta**3) / (1 + w_2 * delta**2), delta, 3),
        {u_1: U_1, u_3: U_3, w_2: W_2},
    ),
    alpha * (3 * alpha + 1) / (6 * (alpha + 1) ** 2) * M3 - (alpha / (alpha + 1)) ** 2 * M2 * M,
)
step(
    "Omega = 1/W - 1: Omega_2 = -W_2, Omega_4 = W_2^2 - W_4",
    Coefficient(Taylor(1 / (1 + w_2 * delta**2 + w_4 * delta**4), delta, 4), delta, 4),
    w_2**2 - w_4,
)
cubic = fourier_flow((3,), 4)
exact = {M4: moment(12), M3: moment(10), M2: moment(6), M: moment(4), alpha: 3}
exact[I_4] = nested_integral_exact(3).to_sympy()
for name, computed, n, value in (("U", cubic.U, 3, U_3), ("W", cubic.W, 2, W_2), ("W", cubic.W, 4, W_4)):
    step(
        f"alpha = 3 by Fourier polynomials, which share nothing with the above: {name}_{n}",
        At(value, exact),
        computed[n].to_sympy(),
    )
step(
    "I_4 is needed: without it W_4 at alpha = 3 would be wrong, its term there being",
    At(3 * (alpha * a / (alpha + 1)) ** 2 * I_4, exact),
    -sympy.Rational(3861, 81920),
)
