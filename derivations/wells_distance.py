"""How fast two motions in a well can part at equal times, in a distance with a free unit.

u' = -w, w' = G(u, w) = s_0(u) - h(u, w) with h increasing in w; k is the unit.  For the linear spring and k = 1 nothing
parts (derivation ``motions-never-part``).

>>> len(derivation.steps) > 4
True
"""

import sympy

from derivations.steps import At, Derivation

U, W, m, r1, r2 = sympy.symbols("U W m r_1 r_2", real=True)
hh = sympy.Symbol("Delta_h", real=True)
k, d, b, t, lam = sympy.symbols("k d b t lambda", positive=True)

derivation = Derivation(
    "wells-distance",
    "How far two motions in a well can part",
    source="logarithmic norms (Dahlquist 1958, Lozinskii 1958) in one degree of freedom",
)
step, asserts = derivation.step, derivation.asserts

place, speed = sympy.Function("U")(t), sympy.Function("W")(t)
step(
    "U, W: the differences of two motions; G(u_1, w_1) - G(u_2, w_2) = m U - Delta_h with a slope m of G in u between"
    " the two and Delta_h = h(u_2, w_1) - h(u_2, w_2).  Half the square of k^2 U^2 + W^2 changes at the rate",
    At(
        sympy.Derivative((k**2 * place**2 + speed**2) / 2, t),
        {sympy.Derivative(place, t): -W, sympy.Derivative(speed, t): m * U - hh, place: U, speed: W},
    ),
    (m - k**2) * U * W - W * hh,
)
chord = sympy.Symbol("s", nonnegative=True)
step(
    "W Delta_h >= 0, so the last term only helps: h grows with the speed, Delta_h = s W with a slope s >= 0",
    At(W * hh, {hh: chord * W}),
    chord * W**2,
)
asserts(
    "and k |U| |W| is at most half of k^2 U^2 + W^2, whatever the signs of U and W",
    sympy.Le(k * U * W, (k**2 * U**2 + W**2) / 2, evaluate=False),
    sympy.Le(-k * U * W, (k**2 * U**2 + W**2) / 2, evaluate=False),
)
step(
    "so with lambda = max |m - k^2|/(2 k) the distance grows at most at the rate lambda: (|m - k^2|/k) half the square",
    At(sympy.Derivative(sympy.exp(2 * lam * t), t) / 2 / sympy.exp(2 * lam * t), {lam: sympy.Abs(m - k**2) / (2 * k)}),
    sympy.Abs(m - k**2) / (2 * k),
)
asserts(
    "A residual (r_1, r_2) of an approximant adds at most |(k r_1, r_2)| <= k |r_1| + |r_2| to the rate",
    sympy.Le((k**2 * U * r1 + W * r2) ** 2, (k**2 * U**2 + W**2) * (k**2 * r1**2 + r2**2), evaluate=False),
)
step(
    "Times of turning: when the first turns the other has w <= d, and from there on w' <= s_0 <= -b: it turns within",
    At(d - b * t, {t: d / b}),
    0,
)
