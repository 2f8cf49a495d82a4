"""Lelas's exact motion with friction (49), half-swing by half-swing, how many there are, and where the block rests.

>>> print(derivation.steps[6].text())
Solution(Eq(-2*d*n + x_0, d), n) = -1/2 + x_0/(2*d)
"""

import sympy
from sympy import Derivative, pi

from derivations.steps import At, Derivation, Solution, defined

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
step("and so is its velocity, which is 0 at both", At(Derivative(place(whole, sigma), t), {t: whole * pi / omega}), 0)
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
)
asserts(
    "between -d, excluded, and d: from t = N pi/omega_0 on it stays at (-1)^N (x_0 - 2 N d), in general not at 0",
    sympy.Gt(d * (1 - q) / (1 + q), -d, evaluate=False),
    sympy.Le(d * (1 - q) / (1 + q), d, evaluate=False),
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
)
