"""The half period for alpha = 2 by the trapezoidal rule: a periodic integrand, a strip without zeros, an error bound.

>>> print(derivation.steps[4].text())
E(t) = Integral(exp(-l*t), (l, 0, 1))
"""

import sympy

from derivations.steps import At, Derivation, defined

u, p, ell, m, x, y, chi = sympy.symbols("u p l m x y chi", real=True)
t, end, a, M, N, k = sympy.symbols("t t_* a M N k", positive=True)
K = sympy.Symbol("K", positive=True)

derivation = Derivation(
    "quadratic-trapezoid",
    "The duration of a half-swing for alpha = 2: the trapezoidal rule and its error",
    source="turning.quadratic_duration; u = gamma x, w = gamma v/omega, |u_n| = p/2, t = p - 2u, t* = p + q",
)
step = derivation.step

# The first integral and its factors.
speed = u + sympy.Rational(1, 2) - (1 + p) / 2 * sympy.exp(2 * u - p)
step(
    "On the falling half-swing w dw/du = w^2 - u; the square of the speed that vanishes at u = p/2 is",
    sympy.Derivative(speed, u),
    2 * (speed - u),
)
step("with", At(speed, {u: p / 2}), sympy.Integer(0))
step("In t = p - 2u: 2 w^2", At(2 * speed, {u: (p - t) / 2}), (1 + p) * (1 - sympy.exp(-t)) - t)
E = defined("E", lambda t: (1 - sympy.exp(-t)) / t)
step(
    "with E(t) = (1 - e^(-t))/t it is t ((1+p) E(t) - 1), zero at t*: 1 = (1+p) E(t*). So 2 w^2 ="
    " t (1+p) (E(t) - E(t*))",
    At((1 + p) * t * (E(t) - E(end)), {p: 1 / E(end) - 1}),
    At((1 + p) * (1 - sympy.exp(-t)) - t, {p: 1 / E(end) - 1}),
)
step("E is a mean of exponentials", E(t), sympy.Integral(sympy.exp(-ell * t), (ell, 0, 1)))
step(
    "and so is its difference quotient: K(t) = (1+p)/2 (E(t) - E(t*))/(t* - t) = (1+p)/2 int int l e^(...) dm dl, from",
    -sympy.Derivative(sympy.exp(-ell * ((1 - m) * t + m * end)), m) / (end - t),
    ell * sympy.exp(-ell * ((1 - m) * t + m * end)),
)

# The substitution.
place = end * (1 - sympy.cos(chi)) / 2
step("t = t* (1 - cos chi)/2 makes t (t* - t)", At(t * (end - t), {t: place}), end**2 * sympy.sin(chi) ** 2 / 4)
step(
    "and T = int |du/w| = int dt/(2 sqrt(t (t* - t) K)) = 1/2 int_0^pi K^(-1/2) dchi (square of the integrand)",
    (sympy.Derivative(place, chi) / 2) ** 2 / (place * (end - place) * K),
    1 / (4 * K),
)

# Where the integrand is analytic.
exponent = -ell * ((1 - m) * (x + sympy.I * y) + m * end)
step(
    "At t = x + i y the integrand of K is that at x times e^(-i l (1-m) y), of real part cos(l (1-m) y) >= cos y for"
    " |y| < pi/2: Re K(x + i y) >= cos(y) K(x) > 0. K is entire, so K^(-1/2) is analytic there",
    exponent - At(exponent, {y: 0}),
    -sympy.I * ell * (1 - m) * y,
)
step(
    "K decreases along the real axis: l times the factor l (1-m) >= 0 appears with a minus",
    sympy.Derivative(sympy.exp(-ell * ((1 - m) * x + m * end)), x),
    -ell * (1 - m) * sympy.exp(-ell * ((1 - m) * x + m * end)),
)
step(
    "At chi = x + i y, |y| <= a: |Im t| = (t*/2) |sin x sinh y| <= (t*/2) sinh a = b < pi/2, and"
    " Re t <= (t*/2)(1 + cosh a) = t_max. So |K^(-1/2)| <= M = (cos b K(t_max))^(-1/2) in the strip",
    At(place, {chi: x + sympy.I * y}),
    end / 2 * (1 - sympy.cos(x) * sympy.cosh(y)) + sympy.I * end / 2 * sympy.sin(x) * sympy.sinh(y),
)

# The rule.
n = sympy.Symbol("n", integer=True, positive=True)
complex_chi = sympy.Symbol("chi")
step(
    "f = K^(-1/2) has period 2 pi: Fourier's integral may be moved to Im chi = a, where e^(i k chi) has the size"
    " e^(-a k), so |c_k| <= M e^(-a |k|)",
    At(sympy.Abs(sympy.exp(sympy.I * k * complex_chi), evaluate=False), {complex_chi: x + sympy.I * a}),
    sympy.exp(-a * k),
)
ratio, off = sympy.Symbol("r"), sympy.Symbol("g", complex=True, zero=False)
j = sympy.Symbol("j", integer=True)
step(
    "The mean of e^(i k chi) over the N midpoints is a geometric sum, r = e^(2 pi i k/N): zero, as r^N = 1, unless"
    " r = 1, N | k; there its size is 1. For r = 1 + g, g != 0,",
    At((1 - ratio) * sympy.Sum(ratio**j, (j, 0, n - 1)), {ratio: 1 + off}),
    1 - (1 + off) ** n,
)
step(
    "The rule is wrong by the c_k with N | k, k != 0, alone, in the mean by 2 M sum_(l>=1) e^(-a N l), x = e^(-a N):",
    At(2 * M * x / (1 - x), {x: sympy.exp(-a * N)}),
    2 * M / (sympy.exp(a * N) - 1),
)
step(
    "and T = (pi/2) c_0 (f is even) by at most",
    sympy.pi / 2 * At(2 * M * x / (1 - x), {x: sympy.exp(-a * N)}),
    sympy.pi * M / (sympy.exp(a * N) - 1),
)

# Part of a half-swing.
a_k = sympy.Symbol("a_k")
step(
    "The time from the turning point to chi is 1/2 int_0^chi f, f = c_0 + sum_(k>=1) a_k cos(k chi), |a_k| = 2 |c_k|",
    sympy.Derivative(a_k * sympy.sin(k * chi) / k, chi),
    a_k * sympy.cos(k * chi),
)
z = sympy.Symbol("z", positive=True)
tail, aliases = z**n / (1 - z), sympy.Symbol("S")
r_ = sympy.Symbol("r", positive=True)  # z = 1/(1 + r) < 1
step(
    "Dropped, k >= m: 1/2 sum 2 M z^k |sin(k chi)|/k, z = e^(-a) and |sin(k chi)|/k <= pi: at most pi M times",
    sympy.Sum(At(z ** (n + j), {z: 1 / (1 + r_)}), (j, 0, sympy.oo)),
    At(tail, {z: 1 / (1 + r_)}),
)
step(
    "Aliases (N = 2m): a_k is wrong by at most 2 M sum_(l>=1) (z^(2ml-k) + z^(2ml+k)), c_0 by half of that at k = 0;"
    " the sum of z^k over |k| < m is geometric,",
    sympy.Sum(At(z**j, {z: 1 / (1 + r_)}), (j, 1 - n, n - 1)),
    At((z ** (1 - n) - z**n) / (1 - z), {z: 1 / (1 + r_)}),
)
step(
    "is at most z^(1-m)/(1-z); times S = sum_l z^(2ml) = z^(2m)/(1 - z^(2m))",
    At(z ** (1 - n) / (1 - z) * aliases, {aliases: z ** (2 * n) / (1 - z ** (2 * n))}),
    z**n / ((1 / z - 1) * (1 - z ** (2 * n))),
)
step(
    "so that both cost pi M e^(-a m) (1/(1-e^(-a)) + 1/((e^a - 1)(1 - e^(-2am)))) at most (the program allows twice the"
    " second term), e^a = 1/z:",
    At(z**n / ((1 / z - 1) * (1 - z ** (2 * n))), {z: sympy.exp(-a)}),
    sympy.exp(-a * n) / ((sympy.exp(a) - 1) * (1 - sympy.exp(-2 * a * n))),
)
