"""The driven oscillator has one periodic response, every motion tends to it, and how a trial orbit proves where it is.

>>> derivation.steps[0].right
-V*(g_1 - g_2)
"""

import sympy

from derivations.steps import At, Derivation, Solution

X, V, r, u = sympy.symbols("X V r u", real=True)
g1, g2, p1, p2, q1, q2 = sympy.symbols("g_1 g_2 p_1 p_2 q_1 q_2", real=True)
mu, k, w, a, e, q, lam, s, D, n, T = sympy.symbols("mu k w a e q lambda s D n T", positive=True)
c, P, Q, S, tau, d = sympy.symbols("c P Q S tau d", positive=True)
alpha = sympy.Symbol("alpha", positive=True)
t, theta, phi = sympy.symbols("t theta phi", real=True)
j, N = sympy.symbols("j N", integer=True, positive=True)
place, speed = sympy.Function("X")(t), sympy.Function("V")(t)

derivation = Derivation(
    "driven-unique",
    "One driven response, and it attracts",
    source="monotone operators (Brezis 1973) and Brouwer's fixed point, in one degree of freedom; asymptotics.driven",
)
step, asserts = derivation.step, derivation.asserts


def rate(acceleration: sympy.Expr) -> sympy.Expr:
    """d/dt of (k X^2 + mu V^2)/2 along X' = V, V' = acceleration."""
    rates = {sympy.Derivative(place, t): V, sympy.Derivative(speed, t): acceleration, place: X, speed: V}
    return At(sympy.Derivative(k * place**2 / 2 + mu * speed**2 / 2, t), rates)


step(
    "X, V: the differences of two motions under one force, g_1 - g_2 that of their losses.  Half the square of their"
    " distance sqrt(k X^2 + mu V^2) changes at the rate",
    rate((-k * X - g1 + g2) / mu),
    -V * (g1 - g2),
)
step(
    "which is <= 0, as V and g_1 - g_2 have one sign: each loss is odd and grows with the speed",
    sympy.Derivative(w**alpha, w),
    alpha * w ** (alpha - 1),
)
step(
    "Two periodic motions have a distance that neither grows nor falls: V = 0 all along, and their equations leave",
    At(mu * w + k * X + g1, {w: 0, g1: 0}),
    k * X,
)
step(
    "which is then 0: there is one at most.  With x(t) also -x(t + half a period) is a motion, so that the response is"
    " its own mirror image",
    -At(sympy.cos(u), {u: theta + sympy.pi}),
    sympy.cos(theta),
)
step(
    "A trial orbit with the defect r in its equation adds r V to the rate,",
    rate((-k * X - g1 + g2 + r) / mu),
    r * V - V * (g1 - g2),
)
asserts(
    "at most the distance times |r|/sqrt(mu): it parts from a motion by the integral of that",
    sympy.Le((r * V) ** 2, (k * X**2 + mu * V**2) * r**2 / mu, evaluate=False),
)
step(
    "Half a period and the mirror map a turning point to one that is e away, and shorten distances within d of it by q:"
    " the ball of radius d <= room is mapped into itself, so that it holds the response (Brouwer), if d is at least",
    Solution(e + q * w, w, w),
    e / (1 - q),
)
step(
    "Contraction: let a = (g_1 - g_2)/(mu V), and count X in 1/sqrt(k), V in 1/sqrt(mu): without a the difference turns"
    " at the rate nu = sqrt(k/mu), and the square D^2 of the distance falls at the rate",
    -2 * rate((-k * X - a * mu * V) / mu),
    2 * a * mu * V**2,
)
asserts(
    "so Delta = int a V^2 = (D_0^2 - D_1^2)/2.  What the losses have added to V is at most int a |V|, by Cauchy at most"
    " sqrt(G Delta) with G >= int a; in two places, weights p and values q:",
    sympy.Le((p1 * q1 + p2 * q2) ** 2, (p1**2 + p2**2) * (q1**2 + q2**2), evaluate=False),
)
step(
    "The turning difference D_0 sin(nu theta + phi) has int a sin^2 >= (I - |int a e^(2 i nu theta)|)/2 = lambda, for"
    " any a that is no larger than the true one, I its integral, as sin^2 = (1 - cos 2)/2; for a = 1 from 0 to T",
    sympy.Integral(sympy.sin(theta + phi) ** 2, (theta, 0, T)),
    (T - (sympy.sin(2 * T + 2 * phi) - sympy.sin(2 * phi)) / 2) / 2,
)
step(
    "Minkowski: sqrt(lambda) D_0 <= sqrt(Delta) + sqrt(I) sqrt(G Delta) = (1 + s) sqrt(Delta), s = sqrt(I G): D_1^2 is"
    " at most",
    Solution((D**2 - w) / 2, lam * D**2 / (1 + s) ** 2, w),
    D**2 * (1 - 2 * lam / (1 + s) ** 2),
)
step(
    "a is a slope of the losses at a speed between two (mean value theorem), for alpha >= 1 between its values at the"
    " least and the largest speed: it grows as",
    sympy.Derivative(alpha * w ** (alpha - 1), w),
    alpha * (alpha - 1) * w ** (alpha - 2),
)
series = sympy.Function("w")(t)
step(
    "The series of a piece: P = w^alpha obeys w P' = alpha w' P",
    series * sympy.Derivative(series**alpha, t),
    alpha * sympy.Derivative(series, t) * series**alpha,
)
asserts(
    "Its tail: w = w_0 (1 + g), and the binomial coefficients of (1 + g)^alpha are no larger than those of"
    " (1 - g)^(-alpha), factor by factor |alpha - n| <= alpha + n:",
    sympy.Le((alpha - n) ** 2, (alpha + n) ** 2, evaluate=False),
)
step(
    "so with G(R) < 1 the sum of the |g_j| R^j what is beyond s^e is (s/R)^e (1 - G(R))^(-alpha) at most; on the ball"
    " |g| <= G that is",
    At((1 - w) ** (-alpha), {w: sympy.Rational(1, 2)}),
    2**alpha,
)
asserts(
    "Near misses: without (1 + s)^2 even viscous damping, D_1^2 = e^(-a T) D_0^2, would be too slow for the bound;",
    sympy.Gt(At(sympy.exp(-a * T), {a: sympy.Rational(1, 10), T: 3}), 1 - sympy.Rational(3, 10), evaluate=False),
)
asserts(
    "for alpha < 1 the slope falls with the speed, and the bounds of a change places",
    sympy.Lt(At(alpha * (alpha - 1), {alpha: sympy.Rational(1, 2)}), 0, evaluate=False),
)
step(
    "A turn, with dry friction c and the pull P > c + g towards the other side, g what the other losses take there at"
    " most: before it a motion is slowed at P + c over mu at least, and after it at P - c - g.  Both together are S/mu",
    At(p1 + c, {p1: P}) + At(p1 - c - g1, {p1: P}),
    2 * P - g1,
)
step(
    "While one of two motions, tau later, has not turned, |V| is the sum of both speeds, its integral S tau^2/(2 mu) at"
    " least, and friction, twice c, takes of the half square of the distance",
    2 * c * sympy.Integral(S / mu * u, (u, 0, tau)),
    c * S * tau**2 / mu,
)
step(
    "at least, which is what V is as the first one turns, tau (P_high + c + g)/mu at most, in the square, mu V^2 times",
    Solution(c * S * tau**2 / mu, w * mu * (tau * (Q + c) / mu) ** 2, w),
    c * S / (Q + c) ** 2,
)
step(
    "with Q = P_high + g: a part of the measure a dt in one point; exact for friction alone, whose two motions leave a"
    " turn with (P - c)/(P + c) of V",
    At(c * S / (Q + c) ** 2, {S: 2 * P, Q: P}),
    (1 - ((P - c) / (P + c)) ** 2) / 2,
)
step(
    "To sqrt(mu) V friction adds 2 c tau/sqrt(mu), of what it takes the root times that of",
    Solution((2 * c * tau) ** 2 / mu, w * c * S * tau**2 / mu, w),
    4 * c / S,
)
step(
    "which is a part of G.  For 0 < alpha < 1 a motion that turns at 0 has the speed gamma |t| at least, and a quotient"
    " of differences is 2^(1-alpha) times the larger speed to the power alpha - 1 at most: its integral is finite,",
    sympy.Derivative(w**alpha / alpha, w),
    w ** (alpha - 1),
)
asserts(
    "because (1 - r^alpha)/(1 - r) <= 1 for speeds of one sign, and (1 + r^alpha)/2 <= ((1 + r)/2)^alpha for two:"
    " w^alpha is concave,",
    sympy.Le(At(sympy.Derivative(w**alpha, (w, 2)), {alpha: sympy.Rational(1, 2)}), 0, evaluate=False),
)
turns = sympy.sin(phi) ** 2 + sympy.sin(phi + w) ** 2
step(
    "Of two turns w = nu pi apart in phase, what friction alone takes in a period is least or largest where 2 phi + w"
    " is a multiple of pi, or everywhere the same:",
    sympy.Derivative(turns, phi),
    2 * sympy.cos(w) * sympy.sin(2 * phi + w),
)
step("there it is 1 - cos(w)", At(turns, {phi: -w / 2}), 1 - sympy.cos(w))
step(
    "or 1 + cos(w), so 1 - |cos(nu pi)| at least: it is 0 where omega_0/Omega is a whole number alone,",
    At(turns, {phi: (sympy.pi - w) / 2}),
    1 + sympy.cos(w),
)
step(
    "Far motions: the period T(z) never lengthens a distance.  With T(p) = p, a factor q within d of p, and z beyond, w"
    " the point of the segment d from p: |T z - p| <= |T z - T w| + |T w - p| <= (D - d) + q d.  After N periods it is"
    " at most",
    D - sympy.Sum((1 - q) * d, (j, 1, N)),
    D - N * (1 - q) * d,
)
asserts(
    "so every motion comes within d, and from there on the distance falls by q: the response attracts them all, and is"
    " the only one.  Near miss: with omega_0 = 2 Omega there are others, cos(2 theta) at rest at both turns",
    sympy.Eq(At(sympy.Derivative(sympy.cos(2 * u), u), {u: sympy.pi}), 0, evaluate=False),
)
