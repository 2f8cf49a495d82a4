"""Lelas's exact motion with friction (49), half-swing by half-swing, how many there are, and where the block rests.

>>> print(derivation.steps[6].text())
Solution(Eq(-2*d*n + x_0, d), n) = -1/2 + x_0/(2*d)
"""

import sympy
from sympy import Derivative, pi

from derivations.steps import At, Derivation, Solution, Taylor, defined

t, sigma = sympy.Symbol("t", real=True), sympy.Symbol("sigma", nonzero=True, real=True)
omega, d, x_0, h = sympy.symbols("omega_0 d x_0 h", positive=True)
n, q = sympy.Symbol("n", real=True), sympy.Symbol("q", nonnegative=True)
whole = sympy.Symbol("n", integer=True, positive=True)
cos, sin = sympy.cos, sympy.sin

derivation = Derivation(
    "lelas-friction-exact",
    "The exact motion with sliding friction, and its end",
    source="Lelas 2024, (49) and the claims on its range, on the number of half-swings and on the place of rest",
)
step, asserts = derivation.step, derivation.asserts

place = defined("x_ex", lambda n, sigma: (x_0 - (2 * n - 1) * d) * cos(omega * t) - sigma * d)
motion = place(n, sigma)
step(
    "Half-swing n, (n-1) pi <= omega_0 t <= n pi, sgn v = sigma = (-1)^n.  With d = mu m g/k the law is"
    " x'' = -omega_0^2 (x + sigma d): (49) obeys it,",
    Derivative(motion, t, 2),
    -(omega**2) * (motion + sigma * d),
    corrects=("lancaster2020:claim.solvable-only-linear",),
)
step("begins with x_0, n = 1, sigma = -1, t = 0,", At(motion, {n: 1, sigma: -1, t: 0}), x_0)
ends = At(motion, {cos(omega * t): sigma, sigma**2: 1})
step(
    "ends where cos(omega_0 t) = (-1)^n = sigma, at rest: the turning point (-1)^n (x_0 - 2 n d)",
    ends,
    sigma * (x_0 - 2 * n * d),
)
step(
    "and half-swing n + 1, with -sigma, begins there, where the cosine is still sigma: so the motion is continuous,",
    At(place(n + 1, -sigma), {cos(omega * t): sigma}),
    ends,
)
step(
    "and so is its velocity, which is 0 at both",
    At(Derivative(place(whole, sigma), t), {t: whole * pi / omega}),
    0,
    corrects=("lancaster2020:claim.never-strictly-zero",),
)
step(
    "In between sin(omega_0 t) = -sigma h, h > 0, and v has the sign of sigma while x_0 > (2n-1) d: v is",
    At(Derivative(motion, t), {sin(omega * t): -sigma * h}),
    sigma * omega * h * (x_0 - (2 * n - 1) * d),
)
step(
    "At a turning point the spring, k |x|, overcomes friction while x_0 - 2 n d > d: up to the n",
    Solution(x_0 - 2 * n * d, d, n),
    (x_0 / d - 1) / 2,
)
last = (x_0 / d - 1) / 2 + q / (1 + q)
step(
    "The number N of half-swings is the first whole number from there on, N = ceil((k x_0/(mu m g) - 1)/2): N exceeds"
    " it by f = q/(1 + q), 0 <= f < 1, and x_0 - 2 N d is d (1 - 2 f),",
    At(x_0 - 2 * n * d, {n: last}),
    d * (1 - q) / (1 + q),
    corrects=("lelas2024:claim.range-of-49",),
)
asserts(
    "between -d, excluded, and d: from t = N pi/omega_0 on it stays at (-1)^N (x_0 - 2 N d), in general not at 0",
    sympy.Gt(d * (1 - q) / (1 + q), -d, evaluate=False),
    sympy.Le(d * (1 - q) / (1 + q), d, evaluate=False),
    corrects=("lelas2024:claim.no-closed-form",),
)
step(
    "Near miss, n > N: from rest at x_0 - 2 N d = h d, 0 < h < 1, (49) would go on to 2 d - h d on the same side:"
    " outward, against the spring, by",
    At(-(x_0 - 2 * (n + 1) * d) - (x_0 - 2 * n * d), {x_0: 2 * n * d + d * h}),
    2 * d * (1 - h),
)
step(
    "The averaged line (48) passes through all turning points: x_0 - 2 n d at omega_0 t = n pi",
    At(x_0 - 2 * d * omega * t / pi, {t: n * pi / omega}),
    x_0 - 2 * n * d,
    corrects=("lancaster2020:claim.gradual-breakdown",),
)

# The second motion, from x = 0 with v = omega_0 x_0, beside the first: e = d/x_0, tau = omega_0 t, x in units of x_0.
e, tau = sympy.symbols("e tau", positive=True)
R = sympy.sqrt(1 + e**2)
second = defined("x_2", lambda tau: sin(tau) + e * cos(tau) - e)
step(
    "The second motion of (9), from 0 at the speed omega_0 x_0, in units of x_0, e = d/x_0, tau = omega_0 t: its first"
    " quarter obeys x'' = -x - e,",
    Derivative(second(tau), tau, 2) + second(tau) + e,
    0,
)
step(
    "begins with 0 and the speed 1",
    sympy.Tuple(At(second(tau), {tau: 0}), At(Derivative(second(tau), tau), {tau: 0})),
    sympy.Tuple(0, 1),
)
turn = sympy.atan(1 / e)
step(
    "and turns at tan(tau) = 1/e, tau = pi/2 - arctan(e), at the place",
    At(second(tau), {tau: turn}),
    R - e,
)
step("where it is at rest", At(Derivative(second(tau), tau), {tau: turn}), 0)
f_1 = defined("f_1", lambda tau: 1 - 2 * e * tau / pi)
f_2 = defined("f_2", lambda tau: R - e - 2 * e * (tau - pi / 2 + sympy.atan(e)) / pi)
step(
    "Each later half-swing loses 2 e, as in the first motion: the lines through the turning points have one slope",
    Derivative(f_2(tau), tau),
    Derivative(f_1(tau), tau),
)
step(
    "and are not the same line: they are apart by (1/2 - 2/pi) e^2 to second order",
    Taylor(f_2(tau) - f_1(tau), e, 2),
    (sympy.Rational(1, 2) - 2 / pi) * e**2,
    corrects=("lelas2024:claim.same-decay-friction",),
)

# Friction with viscous drag beside it.
k, b, drag, m = sympy.symbols("k b b' m", positive=True)
y = sympy.Function("y")(t)
law = defined("L", lambda x: m * Derivative(x, t, 2) + drag * Derivative(x, t) + k * x)
step(
    "Friction b and viscous drag b' together: about the centre -sigma b/k a half-swing is the linear oscillation y, so"
    " it is solved as that is: with x = y - sigma b/k, m x'' + b' x' + k x + sigma b is",
    law(y - sigma * b / k) + sigma * b,
    m * Derivative(y, t, 2) + drag * Derivative(y, t) + k * y,
    corrects=("lancaster2020:claim.no-exact-solutions",),
)
