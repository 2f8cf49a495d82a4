"""U is odd, V and W are even: time reversal seen by the logarithm of the half-swing map.

Two proofs: by operators, for any law, sums and alpha = 1 included; and order by order with a quarter-swing whose
coefficients are indeterminates.

>>> derivation.steps[-1].text()
'Coefficient((2*delta**4*t_4 + 2*delta**3*t_3 + 2*delta**2*t_2 + 2*delta*t_1 + pi)/pi, delta, 1) = 2*t_1/pi'
"""

import sympy

from derivations.steps import At, Coefficient, Derivation, Taylor, defined, named

PL, PT, v2, v3, v4, delta = sympy.symbols("PL PT v_2 v_3 v_4 delta")
ORDER = 4

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
    """exp(sign pi V d/d delta) delta, the terms through the third derivative, not yet differentiated."""
    terms = [delta]
    for _ in range(3):
        terms.append(V * sympy.Derivative(terms[-1], delta))
    return sympy.Add(*((sign * sympy.pi) ** j / sympy.factorial(j) * term for j, term in enumerate(terms)))


V = v2 * delta**2 + v3 * delta**3 + v4 * delta**4
broken = time_pi(V, -1) + At(time_pi(V, 1), {delta: -delta})
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

# Second proof: a quarter-swing with indeterminate coefficients, exponent alpha = 1 + a, through delta^4.
a = sympy.Symbol("a", real=True)
r, t = sympy.symbols("r_1:5", real=True), sympy.symbols("t_1:5", real=True)
R = sum(r[n - 1] * delta**n for n in range(1, ORDER + 1))
T_q = sympy.pi / 2 + sum(t[n - 1] * delta**n for n in range(1, ORDER + 1))


def through(f: sympy.Expr, last: int = ORDER) -> sympy.Expr:
    """The value of what waits, without the powers of delta above ``last``."""
    return sympy.collect(Taylor(f, delta, last).doit(), delta)


def strength(L: sympy.Expr) -> sympy.Expr:
    """delta e^(a L) with the exponential through L^3, which is enough for delta^4."""
    return delta * (1 + a * L + (a * L) ** 2 / 2 + (a * L) ** 3 / 6)


log_ratio = sympy.Integer(0)
for _ in range(ORDER):
    log_ratio = through(R - At(R, {delta: -through(strength(log_ratio))}))
L = derivation.defines("Second proof, through delta^4, for any R = r_1 delta + ...: let", "L", log_ratio)
mapped = through(strength(L))
step("F = delta e^(a L), a = alpha - 1, is", Taylor(strength(L), delta, ORDER), mapped)
F = named("F", mapped)
step("and L obeys the reversal identity L = R(delta) - R(-F)", Taylor(R - At(R, {delta: -F}), delta, ORDER), log_ratio)


def advance(letter: str, f: sympy.Expr, last: int) -> sympy.Expr:
    """Display (C-1) f = f(F) - f through delta^last and return it under its name."""
    grown = At(f, {delta: F}) - f
    step(f"{letter} = (C-1) {f}, C f = f(F)", Taylor(grown, delta, last), through(grown, last))
    return named(letter, through(grown, last))


L_1 = advance("L_1", L, ORDER)
L_2 = advance("L_2", L_1, ORDER)
L_3 = advance("L_3", L_2, ORDER)
step(
    "pi U = log C/(C-1) L = L - L_1/2 + L_2/3 - L_3/4: U has neither delta^2 nor delta^4",
    Taylor((L - L_1 / 2 + L_2 / 3 - L_3 / 4) / sympy.pi, delta, ORDER),
    2 / sympy.pi * (r[0] * delta + (r[2] - 2 * a * r[0] * r[1] + 2 * a**2 * r[0] ** 3 / 3) * delta**3),
)
duration = T_q + At(T_q, {delta: -F}) - sympy.pi
step(
    "For any T_q = pi/2 + t_1 delta + ... the duration T = T_q(delta) + T_q(-F) less pi is, through delta^3,",
    Taylor(duration, delta, 3),
    through(duration, 3),
)
T = named("T", through(duration, 3))
T_1 = advance("T_1", T, 3)
step(
    "pi (W - 1) = T - T_1/2 + ...: W has neither delta nor delta^3",
    Taylor((T - T_1 / 2) / sympy.pi, delta, 3),
    2 / sympy.pi * (t[1] - a * r[0] * t[0]) * delta**2,
)
step(
    "With T = 2 T_q, a duration that ignores the reversal, W_1 does not vanish",
    Coefficient(2 * T_q / sympy.pi, delta, 1),
    2 * t[0] / sympy.pi,
)
