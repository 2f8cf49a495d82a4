"""For alpha < 1 the mass creeps: a region of slow motion that it cannot leave, and the law of the creep.

>>> print(derivation.steps[0].reason)
On the slow curve w = m(y) = (y/e)^(1/alpha) friction balances the spring
"""

import sympy

from derivations.steps import At, Derivation, Solution, defined

y, e, C, w = sympy.symbols("y e C w", positive=True)
a = sympy.Symbol("a", positive=True)
tau = sympy.Symbol("tau", positive=True)
powsimp, diff = sympy.powsimp, sympy.diff

derivation = Derivation(
    "creep",
    "Creep for 0 < alpha < 1",
    source="theory page finite_strength; asymptotics.flow.linear_spring",
)
step, asserts = derivation.step, derivation.asserts

m = (y / e) ** (1 / a)
slow = defined("m", lambda y: (y / e) ** (1 / a))
step("On the slow curve w = m(y) = (y/e)^(1/alpha) friction balances the spring", e * slow(y) ** a, y)
boundary = C * m
step(
    "The trap 0 <= w <= C m(y), y > 0: on its upper boundary w - C m(y) changes at the rate w' - C m'(y) y',"
    " w^alpha = C^alpha y/e",
    At(y - e * w**a + C * sympy.Derivative(slow(y), y) * w, {w: C * slow(y)}) / y,
    sympy.simplify(1 - C**a + C**2 / a * y ** (2 / a - 2) * e ** (-2 / a)),
)
step(
    "It is negative if C^2 y^(2/alpha-2) < alpha (C^alpha - 1) e^(2/alpha); for C^alpha = 2/(2-alpha) the bound is",
    At(a * (C**a - 1) * e ** (2 / a), {C**a: 2 / (2 - a)}),
    a**2 / (2 - a) * e ** (2 / a),
)
step(
    "This C allows the largest y: (C^alpha - 1)/C^2 has its maximum there",
    At(sympy.Derivative((C**a - 1) / C**2, C) * C**3, {C**a: 2 / (2 - a)}),
    0,
)
b = sympy.Symbol("b", positive=True)  # 1/alpha - 1
step(
    "For alpha = 1/(1+b) < 1, b > 0, the exponent 2/alpha - 2 is positive: once the condition holds it goes on holding,"
    " as y only falls",
    At(2 / a - 2, {a: 1 / (1 + b)}),
    2 * b,
)
step(
    "On the lower boundary w = 0 the speed grows at the rate y > 0: the orbit does not turn",
    At(y - e * w**a, {w: 0}),
    y,
)
step(
    "Nor is y = 0 reached in finite time: inside, -y' = w <= C m(y), so d y^(1-1/alpha)/d tau <= "
    "(1/alpha - 1) C e^(-1/alpha), bounded",
    sympy.Derivative(y ** (1 - 1 / a), y) * -boundary,
    sympy.simplify((1 / a - 1) * C * e ** (-1 / a)),
)
part = sympy.Symbol("y_1", positive=True)
step(
    "Falling in: down to the w of the trap at y_1 = y (1 - alpha/4), C^alpha = 2/(2-alpha), the speed falls at the rate"
    " e w^alpha - y at least",
    At(e * (C**a * part / e) - y, {C**a: 2 / (2 - a), part: y * (1 - a / 4)}),
    y * a / (2 * (2 - a)),
)
step(
    "which takes the time w/rate at most, in which y loses w^2/rate at most: no more than y alpha/4 while w^2 is up to",
    Solution(w**2 / (y * a / (2 * (2 - a))), y * a / 4, w**2),
    (a * y) ** 2 / (8 * (2 - a)),
)
gap = sympy.Symbol("G", positive=True)  # N(w_1) - y
step(
    "And from further up: until w has fallen to a w_1 with N(w_1) = y + G it falls at the rate N(w) - y >= G, as N"
    " grows and y falls; in the time w/G at most y loses, at a speed of at most w,",
    w * (w / gap),
    w**2 / (At(sympy.Function("N")(sympy.Symbol("w_1")), {sympy.Function("N")(sympy.Symbol("w_1")): y + gap}) - y),
)
more = sympy.Symbol("N_2", nonnegative=True)
drift = sympy.Symbol("D", real=True)  # w' - C m'(y) y' with N_1 alone
asserts(
    "A further term N_2 >= 0 lowers the rate D on the upper boundary: the trap of one term is a trap of the sum",
    sympy.Le(drift - more, drift, evaluate=False),
)
b_1, a_1 = sympy.symbols(
    "beta alpha_1", positive=True
)  # alpha - alpha_1 >= 0, for a term of an exponent alpha_1 <= alpha
step("By the energy w <= V on all of the half-swing, V^2 = y^2 + w^2; with alpha_1 = alpha - beta w^alpha_1/w^alpha is",
     At(w**a_1 / w**a, {a_1: a - b_1}), w**-b_1)  # fmt: skip
asserts(
    "which falls as w grows: e_1 w^alpha_1 >= e_1 V^(alpha_1 - alpha) w^alpha, and such terms together have a trap",
    sympy.Lt(sympy.Derivative(w**-b_1, w), 0, evaluate=False),
)

# Inside the trap the orbit approaches the slow curve: r = w/m(y) tends to 1.
r = sympy.Symbol("r", positive=True)
ratio = w / slow(y)
ratio_rate = (y - e * w**a) * sympy.Derivative(ratio, w) - w * sympy.Derivative(ratio, y)
step(
    "r = w/m(y) changes along w' = y - e w^alpha, y' = -w; in the clock d sigma = (y/m) d tau its rate is, at"
    " w = r m(y),",
    At(ratio_rate, {w: r * slow(y)}) * slow(y) / y,
    1 - r**a + r**2 / a * (m / y) ** 2,
)
step(
    "y falls to 0: at a limit y > 0 the speed would tend to m(y) > 0, where w' = 0, and y would fall on",
    y - e * slow(y) ** a,
    0,
)
step(
    "The last term fades as y falls to 0, since alpha = 1/(1+b) < 1:",
    sympy.Limit(At((slow(y) / y) ** 2, {a: 1 / (1 + b)}), y, 0, "+"),
    0,
)
step(
    "and sigma runs to infinity: d sigma/d tau = y/m grows as y falls, and y takes for ever to reach 0, as b > 0 in",
    At(y / m, {a: 1 / (1 + b)}),
    e ** (1 + b) * y**-b,
)
asserts(
    "So from some sigma on r falls wherever r > 1 + eta and rises wherever r < 1 - eta, at a rate away from 0, for"
    " any eta > 0, since 1 - r^a falls through 0 at r = 1: r -> 1, every orbit of the trap approaches the slow curve",
    sympy.Eq(At(1 - r**a, {r: 1}), 0, evaluate=False),
    sympy.Lt(sympy.Derivative(1 - r**a, r), 0, evaluate=False),
)
x = (a / (1 - a)) ** (a / (1 - a)) * e ** (1 / (1 - a)) * tau ** (-a / (1 - a))
step("On the slow curve e (-x')^alpha = x.  For this x:", -sympy.Derivative(x, tau), a / (1 - a) * x / tau)
log_a, log_e, log_tau, log_x = sympy.symbols("ln(alpha/(1-alpha)) ln(e) ln(tau) ln(x)")
solved = a / (1 - a) * log_a + log_e / (1 - a) - a / (1 - a) * log_tau
step(
    "so ln[e (-x')^alpha] = ln e + alpha (ln(alpha/(1-alpha)) + ln x - ln tau), which is ln x: alpha < 1",
    At(log_e + a * (log_a + log_x - log_tau), {log_x: solved}),
    solved,
)
half = x.subs({a: sympy.Rational(1, 2), e: 1})
step("For alpha = 1/2 and e = 1: x = 1/tau", At(sympy.Function("x")(tau) * tau, {sympy.Function("x")(tau): half}), 1)
