"""Near dry friction: c_k = (-1)^(k+1) alpha/k to first order in alpha, d_k of second order.

>>> derivation.name, len(derivation.steps) >= 9
('stokes-small-alpha', True)
"""

import sympy

from derivations.steps import At, Derivation, Taylor

theta = sympy.Symbol("theta", positive=True)
X, x, A, a, alpha = sympy.symbols("X x A a alpha", positive=True)
rho, Q, t = sympy.symbols("rho Q t", real=True)
k, n = sympy.symbols("k n", integer=True)
pi, i, ln = sympy.pi, sympy.I, sympy.log

derivation = Derivation(
    "stokes-small-alpha",
    "The Stokes constants near dry friction",
    source="divergence; units with epsilon = 1; D = Phi_+ - Phi_- = sum c_k q^k of abel-petal, c = -1/2 at alpha = 0",
)
step = derivation.step

primitive = -sympy.cos(theta) * ln(sympy.sin(theta)) + ln(sympy.tan(theta / 2)) + sympy.cos(theta)
step(
    "At alpha = 0 a half-swing is half a cosine of amplitude a = A - 1 about 1, A' = A - 2, |v| = a sin(theta). To"
    " first order |v|^alpha = 1 + alpha ln|v|. A primitive of sin(theta) ln sin(theta):",
    sympy.Derivative(primitive, theta),
    sympy.sin(theta) * ln(sympy.sin(theta)),
)
step("vanishes at pi/2 and is, as theta -> 0,", sympy.Limit(primitive, theta, 0, "+"), 1 - ln(2))
step(
    "so the work is A + A' + alpha times int_0^pi ln(a sin) a sin d theta",
    ln(a) * a * sympy.Integral(sympy.sin(theta), (theta, 0, sympy.pi)) - 2 * a * At(1 - ln(A), {A: 2}),
    2 * a * (ln(2 * a) - 1),
)
step(
    "(A^2 - A'^2)/2 is the work. With A' = A - 2 + alpha rho the first order is -(A - 2) rho = rho + 2 a (ln(2a) -"
    " 1), A - 1 = a: the defect",
    At(-(A - 2) * rho - rho - 2 * a * (ln(2 * a) - 1), {rho: -2 * (ln(2 * a) - 1), A: a + 1}),
    sympy.Integer(0),
)
A_of = X + alpha * X * ln(X)
following = A_of - 2 - 2 * alpha * (ln(2 * (X - 1)) - 1)
first = At(sympy.Derivative(following - alpha * (X - 2) * ln(X - 2), alpha), {alpha: 0})
r = X * ln(X) - (X - 2) * ln(X - 2) - 2 * ln(2 * (X - 1)) + 2
step(
    "vanishes for rho = -2 (ln(2a) - 1). X = 1/delta = A^(1 - alpha) = A - alpha A ln A, A = X + alpha X ln X: X' ="
    " X - 2 + alpha r, r being",
    first,
    r,
)
step(
    "With X = 2x + 1, x' = x - 1 + O(alpha), the second derivative of r by x is",
    sympy.Derivative(r.subs(X, 2 * x + 1), (x, 2)),
    4 / (2 * x + 1) - 4 / (2 * x - 1) + 2 / x**2,
)
step(
    "z = c/delta = -X/2 to lowest order: g = -(alpha/2)(r - r(oo)), r(oo) belonging to c. Phi_+ = z + sum_(j>=0)"
    " g(z_j), Phi_- = z - sum_(j<0) g(z_j): to first order D is the sum of g over all x + n, and of its second"
    " derivative the first two terms telescope,",
    sympy.Sum(4 / (2 * t + 2 * n + 1) - 4 / (2 * t + 2 * n - 1), (n, -3, 3)),
    4 / (2 * t + 7) - 4 / (2 * t - 7),
)
step(
    "and vanish in the limit; 1/(x + n)^2 sums to pi^2/sin^2(pi x), as at x = 1/2, where it is",
    2 * sympy.Sum(1 / (k + sympy.Rational(1, 2)) ** 2, (k, 0, sympy.oo)),
    pi**2,
)
q = sympy.exp(-2 * pi * i * (-t - sympy.Rational(1, 2)))
step(
    "Hence D'' = -alpha pi^2/sin^2(pi x). With q = e^(-2 pi i z), z = -x - 1/2, that is the second derivative of"
    " alpha ln(1 + q),",
    sympy.Derivative(ln(1 + q), (t, 2)),
    (-(pi**2) / sympy.sin(pi * t) ** 2).rewrite(sympy.exp),
)
step(
    "and both vanish as Im z -> -oo: D = alpha ln(1 + q) + O(alpha^2), uniformly on a line Im z = const, so c_k ="
    " (-1)^(k+1) alpha/k + O(alpha^2), from",
    Taylor(ln(1 + Q), Q, 3),
    Q - Q**2 / 2 + Q**3 / 3,
)
step(
    "The time: the force ln|v| is even about the middle of the half-swing, what it adds to the angle is weighted by"
    " cos(theta), and the primitive of cos(theta) ln sin(theta)",
    sympy.Derivative(sympy.sin(theta) * ln(sympy.sin(theta)) - sympy.sin(theta), theta),
    sympy.cos(theta) * ln(sympy.sin(theta)),
)
step(
    "vanishes at both ends: T = pi + O(alpha^2), so all d_k = O(alpha^2)",
    sympy.Limit(sympy.sin(theta) * ln(sympy.sin(theta)) - sympy.sin(theta), theta, 0, "+"),
    sympy.Integer(0),
)
