"""How relative errors of turning points travel beside the linear spring, for exponents below 1 as well.

On a half-swing u' = -w, w' = u - N(w), N = sum epsilon_i w^alpha_i, alpha_i > 0, from (p, 0) to (-q, 0); a is the least
of 1 and all alpha_i.  Then d ln q/d ln p <= 1 + (1 - a)/(2 - a) ((p/q)^(2-a) - 1): 1 for every alpha_i >= 1, and next
to 1 hardly more.  The area that the motion sweeps in the phase plane obeys a linear equation, whose source is known.

>>> print(derivation.steps[-4].right)
(p/q)**(1 - a)
"""

import sympy

from derivations.steps import At, Derivation, defined

u, u1, w1, R, c, e, p, q, t, w = sympy.symbols("u u' w' R c epsilon p q t w", positive=True)
a, b, alpha, J, S, x, d = sympy.symbols("a b alpha J S x d", positive=True)
N, rate = sympy.symbols("N N'", positive=True)

derivation = Derivation(
    "ratio-growth",
    "How ratios of turning points part",
    source="Liouville's formula; energy-contraction; asymptotics.flow.error_propagation.contraction_by_ratio",
)
step, asserts = derivation.step, derivation.asserts

place, speed = sympy.Function("u")(t), sympy.Function("w")(t)
loss = sympy.Function("N")


def along(function: sympy.Expr) -> sympy.Expr:
    """d/dt along the motion, written by the state and N'."""
    slope = sympy.Derivative(loss(speed), speed)
    held = {sympy.Derivative(place, t): -w, sympy.Derivative(speed, t): u - N}
    return At(sympy.Derivative(function, t), {slope: rate, **held, loss(speed): N, place: u, speed: w})


area = u**2 + w**2 - u * N
step(
    "Twice the rate at which the area is swept: s = u w' - w u'",
    At(u * w1 - w * u1, {w1: u - N, u1: -w}),
    area,
)
step(
    "It changes at the rate -N' s + w (w N' - N)",
    along(place**2 + speed**2 - place * loss(speed)),
    -rate * area + w * (w * rate - N),
)
step("At the start it is p^2", At(area, {u: p, w: 0, N: 0}), p**2)
step("and at the end q^2", At(area, {u: -q, w: 0, N: 0}), q**2)
slope = sympy.Function("N'")
end, r = sympy.symbols("T r", positive=True)
kept = sympy.exp(-sympy.Integral(slope(r), (r, t, end)))
step(
    "K(t) = exp(-int_t^T N' dt), T the end, grows at the rate N', so that (s K)' = -K w (N - w N')",
    sympy.Derivative(kept, t),
    slope(t) * kept,
)
step(
    "Hence q^2 = p^2 K(0) - S, S = int K w (N - w N') dt over the half-swing (for alpha_i < 1 it converges: w N' is"
    " a sum of powers of w, as N is); and q dq = p dp K(0) (energy-contraction).  d ln q/d ln p is (p/q)^2 K(0)",
    At(p**2 / q**2 * J, {J: (q**2 + S) / p**2}),
    1 + S / q**2,
)
step(
    "A term epsilon w^alpha of N has its part in S:",
    w * (e * w**alpha - w * sympy.Derivative(e * w**alpha, w)),
    (1 - alpha) * e * w ** (alpha + 1),
)
asserts(
    "so each alpha_i > 1 makes d ln q/d ln p less, and N - w N' <= (1 - a) N, as alpha_i = a + d >= a; for a = 1 it is"
    " motions-never-part",
    sympy.Le(1 - (a + d), 1 - a, evaluate=False),
)
step(
    "How K falls back in time: R^2 = u^2 + w^2 changes at the rate 2 R R' =",
    along(place**2 + speed**2),
    -2 * w * N,
)
step(
    "so (ln R)' = -w N/R^2, which is no less than -N/w: what is between them is, as R >= w,",
    At(N / w - w * N / R**2, {R: sympy.sqrt(u**2 + w**2)}),
    N * u**2 / (w * (u**2 + w**2)),
)
step(
    "N' >= a N/w, as each term has alpha_i N_i/w:",
    sympy.Derivative(e * w**alpha, w) / (e * w**alpha),
    alpha / w,
)
step(
    "Together int_t^T N' dt >= a ln(R/q), and K <= (q/R)^a:",
    sympy.exp(-a * sympy.Integral(1 / x, (x, q, R))),
    (q / R) ** a,
)
step(
    "As w N dt = -R dR, R from p to q: S <= (1 - a) int K w N dt, that is b - 1 times, b = 2 - a,",
    sympy.Integral(R * (q / R) ** (2 - b), (R, q, p)),
    q ** (2 - b) * (p**b - q**b) / b,
)
growth = defined("g", lambda ratio: 1 + (b - 1) * (ratio**b - 1) / b)
step(
    "So d ln q/d ln p <= g(p/q), g(x) = 1 + (b - 1) (x^b - 1)/b:",
    At(1 + (b - 1) * S / q**2, {S: q ** (2 - b) * (p**b - q**b) / b}),
    growth(p / q),
)
step("No law below 1, b = 1: ratios never part", At(growth(x), {b: 1}), sympy.Integer(1))
step(
    "One weak law: q = p - c p^a + ...; ln(q/p) changes with ln p at the rate, to the first order in c,",
    sympy.Derivative(-c * p ** (1 - b), p) * p,
    (b - 1) * c * p ** (1 - b),
)
step(
    "and g(p/q) - 1, p/q = 1 + c p^(a-1) + ..., is that as well: to the first order the bound is attained.  g' is",
    sympy.Derivative(growth(x), x),
    (b - 1) * x ** (b - 1),
)
step(
    "So relative errors grow like (p_0/p_n)^(1-a) under a weak law, as d ln(error) = (1 - a) d ln(p_0/p_n) says",
    sympy.exp(sympy.Integral((1 - a) / x, (x, 1, p / q))),
    (p / q) ** (1 - a),
)
step(
    "All starts within e < q of p turn, as they are within e of (-q, 0) when the one from p turns there; g grows with"
    " p/q.  From p + d, 0 <= d <= e, the ratio is at most (p + d)/q, as orbits do not cross: less than p/(q - d) by",
    At(p / x - (p + d) / q, {x: q - d}),
    d * (p - q + d) / (q * (q - d)),
)
step(
    "and from p - d at most (p - d)/(q - d) (motions-never-part), which is less than p/(q - d) <= p/(q - e) by",
    At(p / x - (p - d) / x, {x: q - d}),
    d / (q - d),
)
asserts(
    "Near miss, a = 1 for a law below it: relative errors do grow; in first order, for alpha = 1/2,",
    sympy.Gt(At((b - 1) * c * p ** (1 - b), {b: sympy.Rational(3, 2)}), 0, evaluate=False),
)
