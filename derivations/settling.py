"""How a creep settles beside N: the region, and the time until any slow state is in it.

>>> len(derivation.steps) > 12
True
"""

import sympy

from derivations.steps import At, Derivation

w, W, m, kappa, sigma = sympy.symbols("w W m kappa sigma", positive=True)
n, n_m, t = sympy.symbols("n n(m) t", positive=True)
rho, h = sympy.symbols("rho h", nonnegative=True)
N = sympy.Function("N", positive=True)(w)

derivation = Derivation(
    "settling",
    "A creep whose speed is lost in the errors settles beside N",
    source="derivations creep and slow-curve; asymptotics.flow.slow_manifold.attraction",
)
step, asserts = derivation.step, derivation.asserts

a, e, b, f = sympy.symbols("alpha epsilon beta phi", positive=True)
two = e * w**a + f * w**b


def D(function: sympy.Expr) -> sympy.Expr:
    """w d/dw."""
    return w * sympy.diff(function, w)


first, second = (a**k * e * w**a + b**k * f * w**b for k in (1, 2))
step("Two terms: n = w N'(w) is", w * sympy.Derivative(two, w), first)
step(
    "rho = w n'(w)/n is the mean of the exponents with the weights of n; it grows with w, its slope being"
    " their variance, shown for two of them (for more, Cauchy and Schwarz: (sum p x)^2 <= sum p x^2):",
    w * sympy.Derivative(second / first, w),
    (a - b) ** 2 * (a * e * w**a) * (b * f * w**b) / first**2,
)
step(
    "sigma = w^2/n^2 has the slope 2 (1 - rho) sigma: where rho < 1 at W both are larger there than at any w < W",
    w * sympy.Derivative((w / first) ** 2, w),
    2 * (1 - second / first) * (w / first) ** 2,
)
S = h * w**2 / first
step(
    "On a curve y = N - S, S = h w^2/n, w S'(w) = S (2 - rho):",
    w * sympy.Derivative(S, w),
    S * (2 - second / first),
)
drift = S * (first - D(S)) - w**2
step(
    "y' = -w and w' = y - N = -S: there y - (N - S) changes at the rate (S (n - w S') - w^2)/w, in units of w",
    (-w - sympy.Derivative(two - S, w) * (-S)) / w,
    drift / w**2,
)
step(
    "which is h - 1 - h^2 (2 - rho) sigma: for h = 0 the motion stays below y = N, for h = 2 above the other curve"
    " while sigma < 1/8, as 0 <= rho < 1",
    At(h * (1 - h * (2 - rho) * sigma) - 1, {h: 2, rho: 0, sigma: sympy.Rational(1, 8)}),
    0,
)
asserts(
    "The second curve rises with w, at the rate n (1 - 2 (2 - rho) sigma) >= n (1 - 4 sigma); as the two are 2 n sigma"
    " apart, ln w differs at one height by at most 2 sigma/(1 - 4 sigma)",
    sympy.Ge(1 - 2 * (2 - rho) * sigma, 1 - 4 * sigma, evaluate=False),
)
step(
    "The time on a curve, dt = -dy/w, needs the antiderivative of w S'/w by ln w; by parts it is S/w and that of S/w,"
    " h times the one of w/n, where w/n has the slope",
    w * sympy.Derivative(w / first, w),
    (1 - second / first) * w / first,
)
room, grown = sympy.Symbol("v", positive=True), sympy.Symbol("d", nonnegative=True)
asserts(
    "so that the antiderivative from 0 on lies between w/n over 1 - alpha_min and over 1 - rho: rho = alpha_min + d"
    " grows from alpha_min on, and with 1 - rho = v > 0",
    sympy.Le((w / n) / (room + grown), (w / n) / room, evaluate=False),
)

# From above: z = N - y = kappa n > 0 with kappa > 2 sigma, so w' = -z and N(w) > y: w stays above the slow speed m.
z = kappa * n
above, swell = sympy.Function("z", positive=True)(t), sympy.Function("n", positive=True)(t)
rates = {above.diff(t): -n * z / w + w, swell.diff(t): -rho * n * z / w, above: z, swell: n}
step(
    "From above, z = N - y = kappa n: z' = -(n/w) z + w and n' = -rho n z/w, so kappa'/kappa is",
    At(sympy.Derivative(sympy.log(above / swell), t), rates),
    n / w * (-1 + w**2 / n**2 / kappa + rho * kappa),
)
step(
    "For 2 sigma <= kappa <= 1/8 it is at most -3/8 n/w: there",
    At(-1 + sigma / kappa + rho * kappa, {kappa: 2 * sigma, rho: 0}) + sympy.Rational(1, 8),
    -sympy.Rational(3, 8),
)
step(
    "where n/w >= n(W)/W, as its slope is (rho - 1) n/w <= 0; so kappa falls from 1/8 to 2 sigma(m) in the time"
    " (8/3) (W/n(W)) ln(1/(16 sigma(m))) at most",
    w * sympy.Derivative(first / w, w),
    (second / first - 1) * first / w,
)
step(
    "and before that, while kappa >= 1/8, w' = -kappa n <= -n(m)/8, for which w <= W has no longer than",
    At(W / (kappa * n), {kappa: sympy.Rational(1, 8), n: n_m}),
    8 * W / n_m,
)

# From below: N(w) < y, w' = y - N > 0.
c, k, u_0 = sympy.symbols("c K u_0", positive=True)
u = (u_0 + c / k) * sympy.exp(-k * t) - c / k
step(
    "From below, u = y - N > 0 with w >= m/e: u' = -(n/w) u - w <= -K u - c, K = n(W)/W, c = m/e; with equality u is",
    sympy.Derivative(u, t),
    -k * u - c,
)
step("which is 0 at the time", At(u, {t: sympy.log(1 + k * u_0 / c) / k}), 0)
step(
    "and up to w = m/e y - N(w) >= N(m) - N(m/e), which is the mean of n over ln w from ln m - 1 to ln m: at least"
    " n(m/e), as n grows with w; it is passed in the time (m/e)/n(m/e)",
    At(two, {w: m}) - At(two, {w: m / sympy.E}),
    sympy.Integral(first.subs(w, m * sympy.exp(-t)), (t, 0, 1)),
)
step(
    "At z = 0 the motion is in the region, since z' = w there and z goes on growing",
    At(-n * z / w + w, {kappa: 0}),
    w,
)
