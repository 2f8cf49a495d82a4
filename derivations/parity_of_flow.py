"""U is odd, V and W are even: time reversal seen by the logarithm of the half-swing map.

Two proofs: by operators, for any law, sums and alpha = 1 included; and order by order with a quarter-swing whose
coefficients are indeterminates.

>>> sorted(n for (n,), x in generic[0].coefficients.items() if x != 0)
[1, 3]
"""

import sympy
from sympy import QQ
from sympy.polys.fields import field

from asymptotics.series import Series
from derivations.steps import At, Coefficient, Derivation, defined

PL, PT, v2, v3, v4, delta = sympy.symbols("PL PT v_2 v_3 v_4 delta")
ORDER = 4
FIELD, a, pi, r1, r2, r3, r4, t1, t2, t3, t4 = field("a,pi,r1,r2,r3,r4,t1,t2,t3,t4", QQ)

derivation = Derivation(
    "parity-of-flow",
    "The amplitude law is odd and the frequency even in the strength",
    source="theory page half_swing; asymptotics.expansions.normal_form.flow",
)
step = derivation.step

# First proof.  P f(delta) = f(-delta), C f = f o F; F^(-1)(delta) = -F(-delta) says C^(-1) = P C P.
G = sympy.Function("G")
F_of = defined("F", lambda d: -G(-d))
step(
    "C^(-1) = P C P: with G = F^(-1), G(delta) = -F(-delta) and F(delta) = -G(-delta) are the same statement",
    -F_of(-delta),
    G(delta),
)
C = sympy.Symbol("C", positive=True)  # the operator, as a number
h = defined("h", lambda c: sympy.log(c) / (c - 1))
step(
    "A motion seen backwards starts with -delta and returns to the turning point before: P L = -C^(-1) L and"
    " P T = C^(-1) T. With h(C) = (log C)/(C-1) and log C^(-1) = -log C, h(C^(-1)) C^(-1) = h(C)",
    h(1 / C) / C,
    h(C),
)
step(
    "pi P U = P h(C) L = h(C^(-1)) P L = -h(C^(-1)) C^(-1) L = -h(C) L: U is odd",
    At(h(1 / C) * PL, {PL: -1 / C}),
    -h(C),
)
step(
    "pi P W = h(C^(-1)) P T = h(C) T: W is even (and V_i = (alpha_i-1) delta_i U is even with U odd)",
    At(h(1 / C) * PT, {PT: 1 / C}),
    h(C),
)


def time_pi(V: sympy.Expr, sign: int) -> sympy.Expr:
    """exp(sign pi V d/d delta) delta through delta^4."""
    total, term = delta, delta
    for j in range(1, 4):
        term = sympy.expand(sign * sympy.pi * V * sympy.diff(term, delta) / j)
        total += term
    return sum(sympy.expand(total).coeff(delta, n) * delta**n for n in range(1, 5))


V = v2 * delta**2 + v3 * delta**3 + v4 * delta**4
broken = sympy.expand(time_pi(V, -1) + time_pi(V, 1).subs(delta, -delta))
step(
    "In coefficients (alpha != 1): F^(-1)(delta) + F(-delta) for a field V with a cubic term",
    Coefficient(broken, delta, 3),
    -2 * sympy.pi * v3,
)
step(
    "so v_3 = 0, and then the next order vanishes by itself",
    At(Coefficient(broken, delta, 4), {v3: 0}),
    sympy.Integer(0),
)


# Second proof: a quarter-swing with indeterminate coefficients, exponent alpha = 1 + a.
def strengths(log_ratio: Series) -> Series:
    """delta exp(a log_ratio)."""
    return (log_ratio.truncate(ORDER - 1) * a).exp().shift(0).truncate(ORDER)


def half_swing(R: Series, T_q: Series) -> tuple[Series, Series]:
    """The reversal identity: L = R(delta) - R(-F) by fixed point, T = T_q(delta) + T_q(-F)."""
    L = Series({}, 1, ORDER)
    for _ in range(ORDER):
        L = R - R.compose((-strengths(L),))
    return L, T_q + T_q.compose((-strengths(L),))


def flow(L: Series, T: Series) -> tuple[Series, Series]:
    """U and W - 1 as (1/pi) sum_k (-1)^k/(k+1) (C-1)^k of L and T - pi."""
    F, results = (strengths(L),), []
    for f in (L, T.without_constant()):
        total, term = f, f
        for k in range(1, ORDER):
            term = term.compose(F) - term
            total = total + term * FIELD(QQ((-1) ** k, k + 1))
        results.append(total.map(lambda x: x / pi))
    return results[0], results[1]


R_generic = Series.from_list([FIELD.zero, r1, r2, r3, r4])
T_generic = Series.from_list([pi / 2, t1, t2, t3, t4])
L_generic, T_full = half_swing(R_generic, T_generic)
generic = flow(L_generic, T_full)
U, W = (defined(x, lambda n, s=s: (FIELD.one * s[int(n)]).as_expr(), index=True) for x, s in zip("UW", generic))
for name, series, orders in (("U", U, (2, 4)), ("W", W, (1, 3))):
    for n in orders:
        step(f"{name}_{n} = 0 for all R = r_1 delta + ..., T_q = pi/2 + t_1 delta + ...", series(n), sympy.Integer(0))
step("while", U(1), (2 * r1 / pi).as_expr())
step("and", W(2), ((2 * t2 - 2 * a * r1 * t1) / pi).as_expr())
false_time = flow(L_generic, T_generic + T_generic)[1]
W_false = defined("W^false", lambda n: (FIELD.one * false_time[int(n)]).as_expr(), index=True)
step("With T = 2 T_q, a duration that ignores the reversal, W_1 does not vanish", W_false(1), (2 * t1 / pi).as_expr())
