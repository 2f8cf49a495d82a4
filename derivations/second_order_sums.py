"""Second order for a sum of laws: W = 1 + sum_ij a_ij M_(alpha_i+alpha_j) delta_i delta_j, and nothing in U.

Here a_ij = alpha_i alpha_j/((alpha_i+1)(alpha_j+1)).  Two laws x, y are enough: a second-order term knows two of them.

>>> print(weight)
2*x*y/((x + 1)*(y + 1))
"""

import sympy

from derivations.steps import At, Coefficient, Derivation, defined

x, y, s = sympy.symbols("x y s", positive=True)
c = sympy.Symbol("c", real=True)
S_x, S_y = sympy.symbols("S_x S_y", real=True)
q_x, q_y, d_x, d_y, m_x, m_y, M = sympy.symbols("q_x q_y delta_x delta_y m_x m_y M_(x+y)")

derivation = Derivation(
    "second-order-sums",
    "The frequency of a sum of laws at second order",
    source="theory page closed_forms; asymptotics.expansions.normal_form.in_moments.second_order_sum",
)
step = derivation.step


def rate(f: sympy.Expr) -> sympy.Expr:
    """d/d theta, with S_x = int_(pi/2)^theta s^(x+1) and S_y likewise; c^2 = 1 - s^2."""
    slopes = {s: c, c: -s, S_x: s ** (x + 1), S_y: s ** (y + 1)}
    return reduced(sum(sympy.diff(f, name) * slope for name, slope in slopes.items()))


def reduced(f: sympy.Expr) -> sympy.Expr:
    """Expanded, with c^2 = 1 - s^2 and powers of s collected."""
    return sympy.powsimp(sympy.expand(sympy.expand(f).subs(c**2, 1 - s**2)))


def second_order(f: sympy.Expr) -> sympy.Expr:
    """The coefficient of q_x q_y."""
    return Coefficient(Coefficient(f, q_x, 1), q_y, 1)


# Start at the passage theta = pi/2 with r = 1 and rho = q; run back to the turning point theta = 0.
log_r = -q_x * S_x - q_y * S_y
N_1 = q_x * s**x + q_y * s**y
slope = defined("D_theta", rate)
step("d ln r/d theta = -N s/D begins with -N s, so ln r = -q_x S_x - q_y S_y + ...", slope(log_r), -s * N_1)
N_2 = q_x * (x - 1) * log_r * s**x + q_y * (y - 1) * log_r * s**y
step(
    "d tau/d theta = 1/D = 1 + N c + N^2 c^2 + ..., with rho_i = q_i (1 + (alpha_i-1) ln r): its q_x q_y term",
    second_order(N_2 * c + (N_1 * c) ** 2),
    -(x - 1) * S_y * s**x * c - (y - 1) * S_x * s**y * c + 2 * s ** (x + y) * c**2,
)
for a, b, S in ((x, y, S_y), (y, x, S_x)):
    step(
        "by parts, the boundary terms vanish (s = 0 at the turning point, S = 0 at the passage)",
        slope(S * s ** (a + 1) / (a + 1)),
        S * s**a * c + s ** (a + b + 2) / (a + 1),
    )
step(
    "and M_(p+2) = (p+1)/(p+2) M_p from",
    slope(s ** (x + y + 1) * c),
    reduced((x + y + 1) * s ** (x + y) - (x + y + 2) * s ** (x + y + 2)),
)
M_up = M * (x + y + 1) / (x + y + 2)
M_2 = sympy.Symbol("M_(x+y+2)")
mean = At((x - 1) / (x + 1) * M_2 + (y - 1) / (y + 1) * M_2 + 2 * (M - M_2), {M_2: M_up})
weight = sympy.factor(mean.doit() / M)
step("so the mean over the quarter is 2 x y/((x+1)(y+1)) M_(x+y)", mean, 2 * x * y / ((x + 1) * (y + 1)) * M)
step(
    "The same with x = y, half of it (one law: q_x^2 instead of q_x q_y): (x/(x+1))^2 M_(2x)",
    At(weight, {y: x}) / 2,
    (x / (x + 1)) ** 2,
)
q, t_1, w = sympy.symbols("q t_1 W_2")
quarter = sympy.pi / 2 + t_1 * q + sympy.pi / 2 * w * q**2
step(
    "T = T_q(q) + T_q(-q), for any one strength, doubles the even part, pi/2 times that mean W_2: pi W_2, since T has"
    " no first order and q = delta + ...",
    Coefficient(At(quarter, {q: q_x}) + At(quarter, {q: -q_x}), q_x, 2),
    sympy.pi * w,
)
step("alpha = 0 adds nothing: dry friction leaves the period", At(weight, {y: 0}), sympy.Integer(0))

# U: L is odd in q; the second order in delta comes from q(delta) and from the flow, and cancels.
start = {q_x: d_x * (1 - (x - 1) * (m_x * d_x + m_y * d_y)), q_y: d_y * (1 - (y - 1) * (m_x * d_x + m_y * d_y))}
L = At(-2 * (m_x * q_x + m_y * q_y), start)
step(
    "With m = pi M_(alpha+1)/2: L = -2 (m_x q_x + m_y q_y) + O(q^3) and q_i = d_i (1 - (alpha_i-1)(m_x d_x + m_y d_y)):"
    " the d_x d_y term",
    Coefficient(Coefficient(L, d_x, 1), d_y, 1),
    2 * (x - 1) * m_x * m_y + 2 * (y - 1) * m_x * m_y,
)
U = -2 / sympy.pi * (m_x * d_x + m_y * d_y)
along_flow = defined("D", lambda f: sum((a - 1) * d * U * sympy.diff(f, d) for a, d in ((x, d_x), (y, d_y))))
step(
    "U = -(2/pi)(m_x d_x + m_y d_y) alone gives L through second order: pi U + (pi^2/2) D U with"
    " D = sum_i (alpha_i-1) d_i U d/d d_i",
    sympy.pi * U + sympy.pi**2 / 2 * along_flow(U),
    L,
)

# The mean itself, for four pairs of laws: the integrand of d tau/d theta, its S_x and S_y integrals too.
theta, u = sympy.symbols("theta u", real=True)
TEST = "tests/derivations/test_second_order_sums.py"
for a, b in ((1, 2), (0, 3), (2, 3), (1, 4)):
    cited = f"; the engine's W and U of the four are in {TEST}" if (a, b) == (1, 4) else ""
    S_a, S_b = (sympy.Integral(sympy.sin(u) ** (p + 1), (u, sympy.pi / 2, theta)) for p in (a, b))
    sine, cosine = sympy.sin(theta), sympy.cos(theta)
    first = -(a - 1) * S_b * sine**a * cosine - (b - 1) * S_a * sine**b * cosine
    M_ab = sympy.Integral(sine ** (a + b), (theta, 0, sympy.pi)) / sympy.pi
    step(
        f"alpha = {a}, {b}: the mean of the q_x q_y term of d tau/d theta is"
        f" {'2 x y/((x+1)(y+1)) M_(x+y)' if a else 'nothing, as x is 0'}{cited}",
        2 / sympy.pi * sympy.Integral(first + 2 * sine ** (a + b) * cosine**2, (theta, 0, sympy.pi / 2)),
        At(weight, {x: a, y: b}) * M_ab if a else 0,
    )
