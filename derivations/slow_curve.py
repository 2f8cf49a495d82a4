"""Creep for alpha < 1 to all orders: curves beside the slow curve that the motion crosses one way only.

>>> len(derivation.steps) > 8
True
"""

import sympy

from derivations.steps import At, Derivation

w, e, h, r, d, E = sympy.symbols("w epsilon h r d E", positive=True)
a = sympy.Symbol("alpha", positive=True)
b, q, theta = sympy.symbols("b q theta")
A, B, R = (sympy.Function(name)(w) for name in "ABR")

derivation = Derivation(
    "slow-curve",
    "Creep for 0 < alpha < 1 between two barriers",
    source="derivation creep; flow.slow_manifold.slow_curve, flow.slow_manifold.slow_curve_series",
)
step = derivation.step

N = e * w**a * (1 + R)  # the law: its least exponent and, relative to it, all others
Y = N - e * w**a * B
slope = a * (1 + R - B) + w * (R.diff(w) - B.diff(w))
step(
    "Of the curve y = Y(w) = e w^alpha (1 + R - B), where N = e w^alpha (1 + R), let A be the slope w Y'/(e w^alpha):",
    w * sympy.Derivative(Y, w) / (e * w**a),
    sympy.expand(slope),
)
drift = -w - sympy.Derivative(Y, w) * (Y - N)
step(
    "y' = -w and w' = y - N: on it y - Y(w) changes at the rate -w - Y'(w) (Y - N), divided by w",
    drift / w,
    sympy.expand(-1 + e**2 * w ** (2 * a - 2) * slope * B),
)
powers = {R: r * w**d, B: b * w**q}
step(
    "A for a power r w^d of R and a power b w^q of B (several add)",
    At(slope, powers),
    a + (a + d) * r * w**d - (a + q) * b * w**q,
)
step(
    "B = w^(2-2 alpha)/(alpha e^2) + ... makes the rate small: its first term is",
    At(e**2 * w ** (2 * a - 2) * a * B, {B: w ** (2 - 2 * a) / (a * e**2)}),
    1,
)
step(
    "Add theta w^E to a B of powers below w^E: A B becomes A B plus alpha theta w^E and powers above w^E, for A -"
    " alpha and B have positive powers only:",
    At(A * B, {A: A - (a + E) * theta * w**E, B: B + theta * w**E}),
    A * B + a * theta * w**E + theta * w**E * (A - a - (a + E) * (B + theta * w**E)),
)
left = sympy.Symbol("r_E")
step(
    "So power by power, in any order: if e^2 w^(2 alpha-2) A B - 1 begins with r_E e^2 w^(2 alpha-2+E), the next term"
    " of B is theta w^E, theta = -r_E/alpha, and this power goes",
    At(left * w**E + a * theta * w**E, {theta: -left / a}),
    0,
)
s, order = sympy.symbols("s n", positive=True)
c_n, product = sympy.symbols("c_n p_n")  # p_n: what the terms before make at s^n
step(
    "Without other laws A = alpha - sum (alpha + 2n (1-alpha)) c_n s^n, B = sum c_n s^n, s = w^(2-2 alpha)/e^2, and A"
    " B = s: with c_1 = 1/alpha, c_n = (1/alpha) sum_(0<j<n) (alpha + 2j (1-alpha)) c_j c_(n-j) = p_n/alpha",
    At(a * c_n * s**order - product * s**order, {c_n: product / a}),
    0,
)
part = sympy.Symbol("lambda", positive=True)
step(
    "Now for an error: all powers beside alpha theta w^E, those that A B was left with too, are w^E times powers >= 0:"
    " if at some w their absolute values add up to less than alpha h w^E, |theta| = h, so they do at lambda w, lambda"
    " < 1, for",
    At(w ** (E + d) / w**E, {w: part * w}),
    part**d * w**d,
)
step(
    "So the rate has the sign of theta: the motion crosses the curve with -h towards smaller y, the one with h towards"
    " greater y, and stays in between.  At a height y the greater theta has the greater w: d ln w/d theta is",
    -sympy.Derivative(-e * w**a * theta * w**E, theta) / (e * w**a * sympy.Symbol("A")),
    w**E / sympy.Symbol("A"),
)
step(
    "as dy/d ln w = e w^alpha A > 0.  y' = -w: y falls slowest on the curve with -h, fastest on the one with h."
    "  On a curve dt = -dY/w, and a power c w^q of A gives to the antiderivative of Y'/w",
    sympy.Derivative(e * b * w ** (a - 1 + q) / (a - 1 + q), w),
    e * w**a * b * w**q / w**2,
)
step(
    "For alpha > 1 and one law alone the powers of B and of what is left are negative: with a constant theta they"
    " are largest at the least w, and what holds at some w holds at w/lambda > w, for",
    At(w**-d, {w: w / part}),
    part**d * w ** (-d),
)
step("or, where alpha - 1 + q = 0,", sympy.Derivative(e * b * sympy.log(w), w), e * b / w)
reach, m, lam = sympy.symbols("R m lambda", positive=True)
t, k = sympy.Symbol("t", real=True), sympy.Symbol("k", integer=True, nonnegative=True)
eta, centre = sympy.symbols("eta c", real=True)
p = sympy.Function("p")
step(
    "Where exponents are nearly equal: over a stretch ln w = c + R t, w^eta is e^(eta c) times",
    sympy.Sum((eta * reach * t) ** k / sympy.factorial(k), (k, 0, sympy.oo)),
    sympy.exp(eta * reach * t),
)
step(
    "so the coefficients are polynomials in t, and the slope of a part p(t) w^q by ln w = lambda is",
    sympy.Derivative(p((lam - centre) / reach) * sympy.exp(q * lam), lam),
    sympy.exp(q * lam) * (q * p((lam - centre) / reach) + sympy.Subs(p(t).diff(t), t, (lam - centre) / reach) / reach),
)
