"""The reversal identity: the half-swing from the quarter-swing, for one law and for sums.

    L = R(delta) - R(-F),   T = T_q(delta) + T_q(-F),   F = -Q^(-1)(-Q(delta)).

>>> print(derivation.steps[8].text())
Taylor(F(delta), delta, 3) = 4*delta**3*q_2**2 + 2*delta**2*q_2 + delta
"""

import sympy

from asymptotics.expansions.half_swings.formal_solution import FormalSolution
from asymptotics.expansions.half_swings.grading import Grading
from asymptotics.expansions.half_swings.theta_algebra import COSINE, SINE, THETA, ThetaTrig, sine_power
from asymptotics.series import Series
from derivations.steps import At, Derivation, Taylor, defined

s, rho_1, rho_2, a_1, a_2, e = sympy.symbols("s rho_1 rho_2 alpha_1 alpha_2 epsilon", positive=True)
c, phi, theta = sympy.symbols("c phi theta", real=True)
delta = sympy.Symbol("delta")
LAWS = {(0,): 5, (1,): 4, (2,): 4, (3,): 3, (1, 2): 3}
"""Exponents -> order through which the identity is checked on directly integrated half-swings."""

derivation = Derivation(
    "reversal-identity",
    "The second quarter is the first, run backwards with the opposite strength",
    source="theory page half_swing; asymptotics.expansions.half_swings.quarter",
)
step, asserts = derivation.step, derivation.asserts

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
reason = "Both quarters end at the same passage: Q(-F) = -Q(delta), so F = -Q^(-1)(-Q(delta))"
Q = defined("Q", quarter)
F_of = defined("F", lambda x: sum(F.coeff(delta, n) * x**n for n in range(1, ORDER + 1)))
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


# Half-swings integrated directly, theta from 0 to pi, against the identity.
def flight(alphas: tuple[int, ...], order: int) -> tuple[Series, ...]:
    """R, T_q (theta = pi/2) and L, T (theta = pi) of one and the same orbit."""
    powers = tuple(sine_power(a) for a in alphas)
    grading, keys = Grading.of(alphas), (tuple(int(i == j) for j in range(len(alphas))) for i in range(len(alphas)))
    orbit = FormalSolution.solve(grading, order, list(zip(keys, powers)), COSINE, lambda m: -(SINE * m).integral())
    log_r = orbit.series(orbit.log_r, lambda f: f)
    time = orbit.series(orbit.m, lambda m: (COSINE * m).integral()) + THETA
    return tuple(f.map(at) for at in (ThetaTrig.at_quarter, ThetaTrig.at_half) for f in (log_r, time))


def defects(alphas: tuple[int, ...], swing: tuple[Series, ...], sign: int = -1) -> tuple[Series, Series]:
    """L - R(delta) + R(-F) and T - T_q(delta) - T_q(-F), F_i = delta_i exp((alpha_i-1) L)."""
    R, T_q, L, T = swing
    lower = L.truncate(L.order - 1)
    images = tuple(((lower * (a - 1)).exp() * sign).shift(i) for i, a in enumerate(alphas))
    return L - R + R.compose(images), T - T_q - T_q.compose(images)


swings = {alphas: flight(alphas, order) for alphas, order in LAWS.items()}


def largest(series: Series) -> sympy.Expr:
    """The first coefficient that is not zero, or zero."""
    return next((x.to_sympy() for x in series.coefficients.values() if x != 0), sympy.Integer(0))


def defect_of(part: int, sign: int, *alphas: sympy.Expr) -> sympy.Expr:
    """The first coefficient in which a half-swing departs from the identity."""
    law = tuple(int(a) for a in alphas)
    return largest(defects(law, swings[law], sign)[part])


off_log, off_time = (defined(f"d_{x}", lambda *a, k=k: defect_of(k, -1, *a)) for k, x in enumerate("LT"))
for alphas in LAWS:
    asserts(
        f"alpha = {', '.join(map(str, alphas))}: L and T integrated from 0 to pi agree with the identity through order"
        f" {LAWS[alphas]}: the first coefficient in which they do not is d_L(alpha), d_T(alpha), or 0",
        sympy.Eq(off_log(*alphas), 0, evaluate=False),
        sympy.Eq(off_time(*alphas), 0, evaluate=False),
    )
engine = defined("T_q", lambda x: sum(swings[1,][1][n].to_sympy() * x**n for n in range(4)))
step("and the T_q of alpha = 1 is the one used above, through order 3", engine(e), Taylor(first_quarter, e, 3))
wrong = defined("d_L^+", lambda *a: defect_of(0, 1, *a))
asserts(
    "With +F in the place of -F the identity of L fails, for every law",
    *(sympy.Ne(wrong(*alphas), 0, evaluate=False) for alphas in LAWS),
)
