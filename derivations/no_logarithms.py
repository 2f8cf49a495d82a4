"""No logarithm for one law: phase and time as functions of delta are odd Laurent series, because V is even.

>>> print(derivation.steps[8].text())
Subs(-v_3/v_2**2, (v_3, v_2), ((-f_2**2 + f_3)/pi, f_2/pi)) = pi*(1 - f_3/f_2**2)
"""

import sympy

from asymptotics.expansions.half_swings.exact import exact_half_swing
from asymptotics.expansions.half_swings.pi_ring import PI
from asymptotics.expansions.normal_form.flow import Flow, flow_of
from asymptotics.series import Series
from derivations.steps import At, Coefficient, Derivation, Solution, defined

delta = sympy.Symbol("delta", positive=True)
v2, v3, v4, v5, v6, w2, w4, f2, f3 = sympy.symbols("v_2:7 w_2 w_4 f_2 f_3", real=True)
ONE = sympy.Integer(1)
ORDER = 8

derivation = Derivation(
    "no-logarithms",
    "Why no logarithm appears for a single law",
    source="theory page half_swing; asymptotics.expansions.normal_form.flow",
)
step, asserts = derivation.step, derivation.asserts


def laurent(field: sympy.Expr, numerator: sympy.Expr = ONE, last: int = 2) -> sympy.Expr:
    """numerator/field as a Laurent series in delta through delta^last; the field begins with delta^2."""
    regular = sympy.series(sympy.expand(numerator) / sympy.expand(field / delta**2), delta, 0, last + 3).removeO()
    return sympy.expand(sympy.expand(regular) / delta**2)


any_field = v2 * delta**2 + v3 * delta**3 + v4 * delta**4
step(
    "d psi/d delta = 1/V; for any V = v_2 delta^2 + ... the series of delta^2/V begins with",
    Coefficient(delta**2 / any_field, delta, 0),
    1 / v2,
)
step(
    "and the power delta in it, 1/delta in 1/V, which would integrate to a logarithm, has",
    Coefficient(delta**2 / any_field, delta, 1),
    -v3 / v2**2,
)
even = v2 * delta**2 + v4 * delta**4 + v6 * delta**6
phase_rate = laurent(even)
step("V even (derivation parity-of-flow): no such term", Coefficient(delta**2 / even, delta, 1), sympy.Integer(0))
step("1/V is even", phase_rate, At(phase_rate, {delta: -delta}))
step(
    "so psi, up to its constant, is an odd Laurent series",
    sympy.Integral(phase_rate, delta),
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
mapped = (
    delta + sympy.pi * field_of_map + sympy.pi**2 / 2 * field_of_map * sympy.Derivative(field_of_map, delta)
)  # exp(pi V d/d delta) delta through delta^3
v3_of_map = (f3 - f2**2) / sympy.pi
step(
    "From F = exp(pi V) delta = delta + f_2 delta^2 + f_3 delta^3, where v_2 = f_2/pi: solved for v_3",
    Solution(Coefficient(mapped, delta, 3), f3, v3),
    v3_of_map,
)
step(
    "so the coefficient of the logarithm is",
    At(-v3 / v2**2, {v3: v3_of_map, v2: f2 / sympy.pi}),
    sympy.pi * (1 - f3 / f2**2),
)
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


HALF = {alpha: exact_half_swing((alpha,), ORDER) for alpha in (0, 2, 3)}
f_2, f_3 = (defined(f"f_{n}", lambda alpha, n=n: HALF[int(alpha)].F[0][n].to_sympy()) for n in (2, 3))


def defects(alpha: sympy.Expr, more: sympy.Expr) -> sympy.Tuple:
    """The coefficients of the defect when U_5 is made larger by ``more`` times pi."""
    half = HALF[int(alpha)]
    flow = flow_of(half)
    other = Flow(flow.grading, flow.U + Series({(5,): PI * int(more)}, 1, ORDER), flow.W)
    found = abel_defect(other, half.L, int(alpha) - 1, half.F[0])
    return sympy.Tuple(*(found[n].to_sympy() if found[n] != 0 else 0 for n in range(1, ORDER)))


defect = defined("D", defects)
for alpha in HALF:
    step(f"alpha = {alpha}: f_3 = f_2^2, with the coefficients of its half-swing", f_3(alpha), f_2(alpha) ** 2)
    step(
        "and psi(F(delta)) - psi(delta) - pi, times delta, psi without a logarithm: D(alpha, x), the coefficients of"
        f" delta ... delta^{ORDER - 1} with U_5 + pi x in the place of U_5; at x = 0",
        defect(alpha, 0),
        sympy.Tuple(*[0] * (ORDER - 1)),
    )
asserts(
    "With another U_5 (alpha = 3) psi does not grow by pi",
    sympy.Ne(defect(3, 1), defect(3, 0), evaluate=False),
)
