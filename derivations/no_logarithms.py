"""No logarithm for one law: phase and time as functions of delta are odd Laurent series, because V is even.

>>> print(derivation.steps[8].text())
Subs(-v_3/v_2**2, (v_3, v_2), ((-f_2**2 + f_3)/pi, f_2/pi)) = pi*(1 - f_3/f_2**2)
"""

import sympy

from derivations.steps import At, Coefficient, Derivation, Solution, Taylor

delta = sympy.Symbol("delta", positive=True)
v2, v3, v4, v5, v6, w2, w4, f2, f3 = sympy.symbols("v_2:7 w_2 w_4 f_2 f_3", real=True)

derivation = Derivation(
    "no-logarithms",
    "Why no logarithm appears for a single law",
    source="theory page half_swing; asymptotics.expansions.normal_form.flow",
)
step = derivation.step


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
step("V even (derivation parity-of-flow): no such term", Coefficient(delta**2 / even, delta, 1), sympy.Integer(0))
step("1/V is even", At(1 / even, {delta: -delta}), 1 / even)
step(
    "so psi, up to its constant, is an odd Laurent series: the integral of 1/V, expanded through delta^2,",
    sympy.Integral(Taylor(1 / even, delta, 2), delta),
    -1 / (v2 * delta) - v4 * delta / v2**2 + (v4**2 / v2**3 - v6 / v2**2) * delta**3 / 3,
)
even_rate = 1 + w2 * delta**2 + w4 * delta**4
step(
    "and with W even so is tau = int W/V d delta, W/V expanded likewise",
    sympy.Integral(Taylor(even_rate / even, delta, 2), delta),
    -1 / (v2 * delta)
    + (w2 / v2 - v4 / v2**2) * delta
    + (w4 / v2 - v4 * w2 / v2**2 + v4**2 / v2**3 - v6 / v2**2) * delta**3 / 3,
)

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
step(
    "reversibility, F^(-1) = -F(-delta) = delta - f_2 delta^2 + f_3 delta^3, means f_3 = f_2^2: no logarithm",
    Coefficient(At(back, {delta: delta + f2 * delta**2 + f3 * delta**3}), delta, 3),
    2 * f3 - 2 * f2**2,
)


# psi without a logarithm grows by pi over a half-swing if V is even, and does not if V has delta^3.
def half_swing(field: sympy.Expr, last: int) -> sympy.Expr:
    """exp(pi V d/d delta) delta, the terms through (pi V d/d delta)^last, not yet differentiated."""
    terms = [delta]
    for _ in range(last):
        terms.append(field * sympy.Derivative(terms[-1], delta))
    return sympy.Add(*(sympy.pi**n / sympy.factorial(n) * term for n, term in enumerate(terms)))


def growth(psi: sympy.Expr, field: sympy.Expr, last: int) -> sympy.Expr:
    """delta (psi(F) - psi(delta)) with F = exp(pi V d/d delta) delta."""
    return delta * (At(psi, {delta: half_swing(field, last)}) - psi)


psi = -1 / (v2 * delta) - v4 * delta / v2**2
step(
    "For every even V = v_2 delta^2 + v_4 delta^4 this psi grows by pi over F = exp(pi V d/d delta) delta:"
    " delta (psi(F) - psi(delta)) through delta^3",
    Taylor(growth(psi, v2 * delta**2 + v4 * delta**4, 4), delta, 3),
    sympy.pi * delta,
)
step(
    "and with v_3 delta^3 in V a psi without a logarithm does not: through delta^2",
    Taylor(growth(-1 / (v2 * delta), v2 * delta**2 + v3 * delta**3, 2), delta, 2),
    sympy.pi * delta + sympy.pi * v3 / v2 * delta**2,
)

# Two laws whose half-swing is known in closed form.
dry = delta / (1 - 2 * delta)
step(
    "alpha = 0: A falls by 2 epsilon, so F = delta/(1 - 2 delta): its f_3 is the square of its f_2",
    Coefficient(dry, delta, 3),
    Coefficient(dry, delta, 2) ** 2,
)
step(
    "and psi = -pi/(2 delta) grows by pi exactly, without a logarithm",
    At(-sympy.pi / (2 * delta), {delta: dry}) + sympy.pi / (2 * delta),
    sympy.pi,
)
place, start, speed = sympy.symbols("x A w", positive=True)
half = sympy.Rational(1, 2)
energy = place + half - (start + half) * sympy.exp(2 * (place - start))
step(
    "alpha = 2, epsilon = 1: w = x'^2 has w' = 2w - 2x on the way down, solved by",
    sympy.Derivative(energy, place),
    At(2 * speed - 2 * place, {speed: energy}),
)
step("with w = 0 at the start x = A", At(energy, {place: start}), sympy.Integer(0))
mapped_2 = delta + f2 * delta**2 + f3 * delta**3
at_the_turn = At(energy, {place: -mapped_2, start: delta})
found = -sympy.Rational(4, 3)
step(
    "It turns where w(-F) = 0, A = delta; order delta^3 gives f_2",
    Solution(Coefficient(at_the_turn, delta, 3), 0, f2),
    found,
)
step(
    "and order delta^4 gives f_3 = f_2^2; the exact half-swings of alpha = 0, 2, 3, to delta^7, are compared in"
    " tests/derivations/test_no_logarithms.py",
    Solution(Coefficient(At(at_the_turn, {f2: found}), delta, 4), 0, f3),
    At(f2**2, {f2: found}),
)
