"""The error of a Taylor step, from the residual of the Taylor polynomials.

>>> len(derivation.steps) > 4
True
"""

import sympy

from derivations.steps import At, Derivation

t, h, R, w0, rho, a, N, c = sympy.symbols("t h R w_0 rho a N c", positive=True)
n = sympy.Symbol("n", positive=True, integer=True)
k = sympy.Symbol("k", integer=True, nonnegative=True)

derivation = Derivation(
    "taylor-residual",
    "The error of a Taylor step by its residual",
    source="derivation motions-never-part",
)
step = derivation.step

later, place, load = sympy.symbols("c_(k+1) y_k N_k")
step(
    "In general the coefficients of t^k, k < n, in Y' + W and in W' - Y + N(W) vanish: c_(k+1) is y_(k+1) or w_(k+1),",
    sympy.Add(
        At((k + 1) * later + w0, {later: -w0 / (k + 1)}),
        At((k + 1) * later - place + load, {later: (place - load) / (k + 1)}),
        evaluate=False,
    ),
    0,
)
y_next, w_n, w_next, y_n, N_n = sympy.symbols("y_(n+1) w_n w_(n+1) y_n N_n")
step(
    "For n = 0 the residual of Y' = -W is w_0. One degree more adds (n+1) y_(n+1) t^n + w_(n+1) t^(n+1) to Y' + W,"
    " which takes w_n t^n away: the residual is w_n t^n for every n",
    At((n + 1) * y_next * t**n + w_next * t ** (n + 1), {y_next: -w_n / (n + 1)}),
    -w_n * t**n + w_next * t ** (n + 1),
)
step(
    "and, as N(W) and N(w) agree below t^n, that of W' = Y - N(W) is -y_n t^n and the terms of N(W) from t^n on: -y_0"
    " for n = 0, and one degree more adds (n+1) w_(n+1) t^n - y_(n+1) t^(n+1), besides the term N_n t^n that is"
    " counted below",
    At((n + 1) * w_next * t**n - y_next * t ** (n + 1) + N_n * t**n, {w_next: (y_n - N_n) / (n + 1)}),
    y_n * t**n - y_next * t ** (n + 1),
)
z, speed, r = *sympy.symbols("z W"), sympy.Symbol("r", positive=True)
k = sympy.Symbol("k", integer=True, nonnegative=True)
step(
    "Where |W - w_0| <= rho w_0 < w_0, W stays in the right half-plane, |W^a| = |W|^a: at most",
    At(sympy.Abs(speed) ** a, {sympy.Abs(speed): w0 + rho * w0}),
    (w0 * (1 + rho)) ** a,
)
step(
    "By Cauchy the k-th coefficient of N(W) is at most N_R R^-k, N_R = N(w_0 (1+rho)): with x = t/R = 1/(1 + r) < 1"
    " those from t^n on add up to N_R times the geometric series without its first n terms",
    sympy.Sum((1 / (1 + r)) ** (n + k), (k, 0, sympy.oo)),
    At(z**n / (1 - z), {z: 1 / (1 + r)}),
)
step("Integrated from 0 to h, the first part gives", sympy.Integral(t**n, (t, 0, h)), h ** (n + 1) / (n + 1))
step(
    "and the other, with 1/(1 - t/R) <= 1/(1 - h/R),",
    sympy.Integral((t / R) ** n, (t, 0, h)) / (1 - h / R),
    (h / R) ** n * h / ((n + 1) * (1 - h / R)),
)
