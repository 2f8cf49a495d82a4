"""The reversal identity: the half-swing from the quarter-swing, for one law and for sums.

    L = R(delta) - R(-F),   T = T_q(delta) + T_q(-F),   F = -Q^(-1)(-Q(delta)).

>>> print(derivation.steps[8].text())
Taylor(F(delta), delta, 3) = 4*delta**3*q_2**2 + 2*delta**2*q_2 + delta
"""

import sympy

from derivations.steps import At, Derivation, Taylor, defined

s, rho_1, rho_2, a_1, a_2, e = sympy.symbols("s rho_1 rho_2 alpha_1 alpha_2 epsilon", positive=True)
c, phi, theta = sympy.symbols("c phi theta", real=True)
delta = sympy.Symbol("delta")

derivation = Derivation(
    "reversal-identity",
    "The second quarter is the first, run backwards with the opposite strength",
    source="theory page half_swing; asymptotics.expansions.half_swings.quarter",
)
step = derivation.step

N = rho_1 * s**a_1 + rho_2 * s**a_2
opposite = {rho_1: -rho_1, rho_2: -rho_2}
log_rate, time_rate = -N * s / (1 - N * c), 1 / (1 - N * c)
step("theta = pi - phi leaves the sine as it is", At(sympy.sin(theta), {theta: sympy.pi - phi}), sympy.sin(phi))
step("and changes the sign of the cosine", At(sympy.cos(theta), {theta: sympy.pi - phi}), -sympy.cos(phi))
step(
    "With d theta = -d phi, d ln r/d phi is the first-quarter equation with every rho_i replaced by -rho_i",
    -At(log_rate, {c: -c}),
    At(log_rate, opposite),
)
step(
    "So is the time, counted backwards",
    At(time_rate, {c: -c}),
    At(time_rate, opposite),
)
growth = (a_1 - 1) * log_rate
step(
    "and -rho_i obeys d(-rho_i)/d phi = (alpha_i - 1) (-rho_i) d ln r/d phi: the same system",
    -At(-rho_1 * growth, {c: -c}),
    At(rho_1 * growth, opposite),
)


class Passage(sympy.Function):
    """Q, any invertible function: Q(Q^(-1)(x)) = x."""

    @classmethod
    def eval(cls, x: sympy.Expr) -> sympy.Expr | None:
        """What cancels."""
        return x.args[0] if isinstance(x, Return) else None


class Return(sympy.Function):
    """Q^(-1)."""

    @classmethod
    def eval(cls, x: sympy.Expr) -> sympy.Expr | None:
        """What cancels."""
        return x.args[0] if isinstance(x, Passage) else None


half = defined("F", lambda x: -Return(-Passage(x)))
step("In general, in one line: F = -Q^(-1)(-Q) is reversible whatever Q is", half(-half(-delta)), delta)

# Springs and position-dependent losses: only the losses change their sign.
rho, gamma, m, p, alpha, q_v = sympy.symbols("rho gamma m p alpha q", positive=True)
mixed = rho * sympy.Abs(c) ** m * s**alpha - gamma * c * sympy.Abs(c) ** (p - 1) * s**q_v
step(
    "A loss |x|^m v|v|^(alpha-1) and a spring x|x|^(p-1) |v|^q: c -> -c turns N into -N with rho -> -rho, gamma kept",
    At(mixed, {c: -c}),
    -mixed.subs(rho, -rho),
)

# Both quarters end at the same passage: Q(-F) = -Q(delta), as power series with symbolic coefficients.
ORDER = 5
q = dict(zip(range(2, ORDER + 1), sympy.symbols("q_2:6"), strict=True))


def truncated(expression: sympy.Expr, order: int = ORDER) -> sympy.Expr:
    """The polynomial in delta without the powers above ``order``."""
    terms = sympy.Poly(sympy.expand(expression), delta).terms()
    return sum(coefficient * delta**n for (n,), coefficient in terms if n <= order)


def quarter(x: sympy.Expr) -> sympy.Expr:
    """Q(x) = x + q_2 x^2 + ... + q_5 x^5, truncated."""
    total = power = truncated(x)
    for k in range(2, ORDER + 1):
        power = truncated(power * x)
        total += q[k] * power
    return truncated(total)


def solve_reversal(target: sympy.Expr) -> sympy.Expr:
    """G with Q(-G) = target, order by order."""
    G = sympy.Integer(0)
    for _ in range(ORDER):
        G = truncated(G - (target - quarter(-G)))
    return G


F = solve_reversal(-quarter(delta))


def mapped(x: sympy.Expr) -> sympy.Expr:
    """F(x) = f_1 x + ... + f_5 x^5, truncated."""
    total = sympy.Integer(0)
    for n in range(ORDER, 0, -1):
        total = truncated((total + F.coeff(delta, n)) * x)
    return total


reason = "Both quarters end at the same passage: Q(-F) = -Q(delta), so F = -Q^(-1)(-Q(delta))"
Q = defined("Q", quarter)
F_of = defined("F", mapped)
step(reason, Q(-F_of(delta)), -quarter(delta))
step("F begins", Taylor(F_of(delta), delta, 3), delta + 2 * q[2] * delta**2 + 4 * q[2] ** 2 * delta**3)
step("F is reversible for any Q: F(-F(-delta)) = delta", Taylor(F_of(-F_of(-delta)), delta, ORDER), delta)
spoilt = defined("G", lambda x: x + 2 * q[2] * x**2 + (4 * q[2] ** 2 + 1) * x**3)
step(
    "G = F + delta^3 is not: there the same composition gives",
    Taylor(spoilt(-spoilt(-delta)), delta, 3),
    delta + 2 * delta**3,
)

# The two exactly solvable laws.
ratio = delta / (1 - 2 * delta)
dry = delta / sympy.sqrt(1 - 2 * delta)
reason = "alpha = 0: Q = delta/sqrt(1 - 2 delta), F = delta/(1 - 2 delta); Q(-F)^2 = Q^2"
step(reason, At(dry, {delta: -ratio}) ** 2, dry**2)
root = sympy.sqrt(4 - e**2)
first_quarter = 2 / root * (sympy.pi / 2 + sympy.atan(e / root))
step(
    "alpha = 1: F = delta = epsilon, T_q(e) + T_q(-e) = pi/sqrt(1 - e^2/4)",
    first_quarter + At(first_quarter, {e: -e}),
    2 * sympy.pi / root,
)
log_quarter = sympy.log(1 - 2 * delta) / 2
step(
    "alpha = 0: Q = delta e^(-R), so R = ln(1 - 2 delta)/2; R(delta) - R(-F) has the slope of L = ln(1 - 2 delta), and"
    " both are 0 at delta = 0",
    sympy.Derivative(log_quarter - At(log_quarter, {delta: -ratio}), delta),
    sympy.Derivative(sympy.log(1 - 2 * delta), delta),
)
step(
    "alpha = 1: R = -(e/2) T_q, and R(e) - R(-e) is the L = -(e/2) T of an exponential decay",
    -e / 2 * first_quarter - At(-e / 2 * first_quarter, {e: -e}),
    -e / 2 * (2 * sympy.pi / root),
)

# The second order of a half-swing integrated directly, theta from 0 to pi, against the identity.
u = sympy.Symbol("u", real=True)
whole, part = (theta, 0, sympy.pi), (theta, 0, sympy.pi / 2)
sine, cosine = sympy.sin(theta), sympy.cos(theta)
S = sympy.Rational(2, 3) - 3 * cosine / 4 + sympy.cos(3 * theta) / 12
step("alpha = 2: S", sympy.Integral(sympy.sin(u) ** 3, (u, 0, theta)), S)
R_1, L_1 = -sympy.Integral(sine**3, part), -sympy.Integral(sine**3, whole)
step(
    "to delta^2: ln r = -delta S + ...; with F = delta + L_1 delta^2 the identity L = R(delta) - R(-F) says"
    " L_2 = R_1 L_1, as R_2 cancels",
    sympy.Integral(S * sine**3 - sine**5 * cosine, whole),
    R_1 * L_1,
)
T_2 = -S * sine**2 * cosine + sine**4 * cosine**2
step(
    "and T = T_q(delta) + T_q(-F) says that T_2 is twice that of the quarter, less t_1 L_1; alpha = 0, 1, 2, 3, to the"
    " orders 3 to 5, and a sum of laws are in tests/derivations/test_reversal_identity.py",
    sympy.Integral(T_2, whole),
    2 * sympy.Integral(T_2, part) - L_1 * sympy.Integral(sine**2 * cosine, part),
)
