"""No logarithm for one law: phase and time as functions of delta are odd Laurent series, because V is even.

>>> print(derivation.steps[7].text())
v_3 = (-f_2**2 + f_3)/pi
"""

import sympy

from asymptotics.half_swings.exact import exact_half_swing
from asymptotics.half_swings.pi_ring import PI
from asymptotics.normal_form.flow import Flow, flow_of
from asymptotics.series import Series
from derivations.steps import At, Coefficient, Derivation, named

delta = sympy.Symbol("delta", positive=True)
v2, v3, v4, v5, v6, w2, w4, f2, f3 = sympy.symbols("v_2:7 w_2 w_4 f_2 f_3", real=True)
ONE = sympy.Integer(1)
ORDER = 8

derivation = Derivation(
    "no-logarithms",
    "Why no logarithm appears for a single law",
    source="theory page ``half_swing``; asymptotics.normal_form.flow",
)
step, holds = derivation.step, derivation.holds


def laurent(field: sympy.Expr, numerator: sympy.Expr = ONE, last: int = 2) -> sympy.Expr:
    """numerator/field as a Laurent series in delta through delta^last; the field begins with delta^2."""
    regular = sympy.series(sympy.expand(numerator) / sympy.expand(field / delta**2), delta, 0, last + 3).removeO()
    return sympy.expand(sympy.expand(regular) / delta**2)


any_field = v2 * delta**2 + v3 * delta**3 + v4 * delta**4
step(
    "d psi/d delta = 1/V; for any V = v_2 delta^2 + ... it begins with",
    Coefficient(laurent(any_field), delta, -2),
    1 / v2,
)
step(
    "and its 1/delta term, which would integrate to a logarithm, is",
    Coefficient(laurent(any_field), delta, -1),
    -v3 / v2**2,
)
even = v2 * delta**2 + v4 * delta**4 + v6 * delta**6
phase_rate = laurent(even)
step("V even (derivation parity-of-flow): no such term", Coefficient(phase_rate, delta, -1), sympy.Integer(0))
step("1/V is even", phase_rate, At(phase_rate, {delta: -delta}))
phase = sympy.integrate(phase_rate, delta)
step(
    "so psi, up to its constant, is an odd Laurent series",
    phase,
    -1 / (v2 * delta) - v4 * delta / v2**2 + (v4**2 / v2**3 - v6 / v2**2) * delta**3 / 3,
)
time = sympy.integrate(laurent(even, 1 + w2 * delta**2 + w4 * delta**4), delta)
step("and with W even so is tau = int W/V d delta", time + At(time, {delta: -delta}), sympy.Integer(0))

k, c_k = sympy.Symbol("k", integer=True), sympy.Symbol("c_k")
step(
    "At every order: V even means that the coefficient c_k of delta^k in 1/V equals (-1)^k c_k; the one of 1/delta"
    " (k = -1) is its own negative, hence 0",
    At((-1) ** k * c_k, {k: -1}),
    -c_k,
)

# The same in terms of the map: the residue is an invariant of F.
field_of_map = f2 / sympy.pi * delta**2 + v3 * delta**3
second_term = field_of_map * sympy.diff(field_of_map, delta)
mapped = sympy.expand(delta + sympy.pi * field_of_map + sympy.pi**2 / 2 * second_term)
v3_of_map = sympy.solve(mapped.coeff(delta, 3) - f3, v3)[0]
residue = sympy.simplify((-v3 / v2**2).subs({v3: v3_of_map, v2: f2 / sympy.pi}))
step("From F = exp(pi V) delta = delta + f_2 delta^2 + f_3 delta^3", named("v_3", v3_of_map), (f3 - f2**2) / sympy.pi)
step("so the coefficient of the logarithm is", residue, sympy.pi * (1 - f3 / f2**2))
back = delta - f2 * delta**2 + f3 * delta**3
composed = sympy.expand(back.subs(delta, delta + f2 * delta**2 + f3 * delta**3))
step(
    "reversibility, F^(-1) = -F(-delta) = delta - f_2 delta^2 + f_3 delta^3, means f_3 = f_2^2: no logarithm",
    Coefficient(composed, delta, 3),
    2 * f3 - 2 * f2**2,
)


# On real laws: psi grows by pi over a half-swing, exactly through the order known.
def abel_defect(flow: Flow, L: Series, a: int, F: Series) -> Series:
    """delta (Psi(F) - Psi(delta) - pi) with Psi = int d delta/V = E(delta)/delta, a = alpha - 1."""
    V = flow.U * a
    quotient = Series({(n - 1,): x for (n,), x in V.coefficients.items()}, 1, ORDER - 1).inverse()  # delta^2/V
    E = quotient.map_keys(lambda k, x: x / (k[0] - 1))
    growth = (L.truncate(ORDER - 1) * -a).exp()  # delta/F
    pi_delta = Series({(1,): PI}, 1, ORDER - 1)
    return growth * E.compose((F.truncate(ORDER - 1),)) - E - pi_delta


for alpha in (0, 2, 3):
    half = exact_half_swing((alpha,), ORDER)
    flow = flow_of(half)
    defect = abel_defect(flow, half.L, alpha - 1, half.F[0])
    second, third = (half.F[0][n].to_sympy() for n in (2, 3))
    step(f"alpha = {alpha}: f_3 = f_2^2", named("f_3", third), named("f_2", second) ** 2)
    holds(
        f"and psi(F(delta)) - psi(delta) = pi through delta^{ORDER - 2}, psi without a logarithm; its leading term",
        all(x == 0 for x in defect.coefficients.values()),
        -1 / ((alpha - 1) * flow.U[1].to_sympy() * delta),
    )
wrong = Flow(flow.grading, flow.U + Series({(5,): PI}, 1, ORDER), flow.W)
first = next(iter(abel_defect(wrong, half.L, 2, half.F[0]).coefficients.items()))
holds(
    "With another U_5 (alpha = 3) psi does not grow by pi: the defect begins with",
    bool(first[1] != 0),
    first[1].to_sympy() * delta ** first[0][0],
)
