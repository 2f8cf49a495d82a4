"""Creep and overdamping in a well: the traps of the linear spring, with a chord of the force in place of the spring.

u' = -w, w' <= K y - epsilon w^alpha for y = u - u* > 0, where the spring less the dry friction is at most K y.

>>> len(derivation.steps) > 3
True
"""

import sympy

from derivations.steps import At, Derivation

y, e, C, K, w, c = sympy.symbols("y e C K w c", positive=True)
a = sympy.Symbol("a", positive=True)

derivation = Derivation(
    "wells-traps",
    "Traps beside any spring",
    source="derivation creep, for a spring below a chord",
)
step = derivation.step

m = (K * y / e) ** (1 / a)
boundary = C * m
step(
    "The trap 0 <= w <= C m(y) with m = (K y/e)^(1/a), y > 0: on its upper boundary w - C m(y) changes, over K y,"
    " at most at the rate",
    (K * y - e * (C**a * K * y / e) + C * sympy.Derivative(m, y) * boundary) / (K * y),
    1 - C**a + C**2 / a * y ** (2 / a - 2) * K ** (2 / a - 1) * e ** (-2 / a),
)
step(
    "It is negative if C^2 y^(2/a-2) < a (C^a - 1) e^(2/a) K^(1-2/a); for C^a = 2/(2-a) the right side is",
    At(a * (C**a - 1) * e ** (2 / a) * K ** (1 - 2 / a), {C**a: 2 / (2 - a)}),
    a**2 / (2 - a) * e ** (2 / a) * K ** (1 - 2 / a),
)
b = sympy.Symbol("b", positive=True)  # 1/a - 1
step(
    "For a = 1/(1+b) < 1 the exponent 2/a - 2 is positive: once it holds it goes on holding as y falls",
    At(2 / a - 2, {a: 1 / (1 + b)}),
    2 * b,
)
step(
    "On the lower boundary the orbit does not turn: at w = 0 the speed grows at the rate s_0 > 0, for s_0 = K y",
    At(K * y - e * w**a, {w: 0}),
    K * y,
)
step(
    "a = 1: on w = c y the rate of w - c y is at most y (K - e c + c^2), and for the larger root c it vanishes",
    At(K - e * c + c**2, {c: (e + sympy.sqrt(e**2 - 4 * K)) / 2}),
    0,
)
