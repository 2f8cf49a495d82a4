"""The turning point ahead without bracketing: orbits that end at different turning points spread as the speed grows.

>>> len(derivation.steps) > 4
True
"""

import sympy

from derivations.steps import Derivation

w, s, e, Y0, N = sympy.symbols("w s e Y_0 N", positive=True)
y, y1 = sympy.symbols("y y_1", negative=True)
P, P1, P2 = sympy.symbols("P P_1 P_2", negative=True)

derivation = Derivation(
    "arrival",
    "The turning point ahead",
    source="linearised flow; no-crossing of orbits",
)
step, asserts = derivation.step, derivation.asserts

asserts(
    "Where y < 0 and w > 0 the orbit turns: w' = y - N is less than y < 0, and y only falls",
    sympy.Lt(y - N, y, evaluate=False),
)
force = sympy.Function("N")(w)
eta = sympy.Symbol("eta")
step(
    "Y(w; y_1): the orbit that ends at y_1, dY/dw = -w/(Y - N(w)).  Its derivative by y_1 obeys (d/dw) E = (w/P^2) E,"
    " P = Y - N",
    sympy.Derivative(-w / (eta - N), eta),
    w / (eta - N) ** 2,
)
along = sympy.Function("P")
E = sympy.exp(sympy.Integral(s / along(s) ** 2, (s, 0, w)))
step(
    "so E, which begins with 1, is exp(integral of w/P^2) >= 1",
    sympy.Derivative(E, w) / E,
    w / along(w) ** 2,
)
more = sympy.Symbol("h", nonnegative=True)
step(
    "Hence |y_1 - guess| <= |Y(w; y_1) - Y(w; guess)|: over the distance e, with the mean slope 1 + h >= 1, that is",
    sympy.Integral(1 + more, (s, 0, e)),
    e + e * more,
)
step(
    "Orbits do not cross: those between the two also have P <= Y <= y < 0 up to the speed w, y rising with w",
    sympy.Derivative(-w / P1, w),
    -1 / P1,
)
step(
    "Their times d tau/dw = 1/P differ by the integral of 1/P^2 from the one to the other,",
    sympy.Integral(1 / P**2, (P, P1, P2)),
    (P2 - P1) / (P1 * P2),
)
step(
    "with |P_2 - P_1| <= e and |P| >= |y| all the way: the times differ by at most e w/y^2",
    sympy.Integral(e / y**2, (s, 0, w)),
    e * w / y**2,
)
