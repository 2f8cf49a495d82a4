r"""Smith's quadrature (54) is not elementary: int du/y, y^2 = u + 1/2 - k e^(2u), k != 0, by Liouville's theorem.

With theta = e^(2u), K = C(u, theta, y) is the field C(u, y): theta = (u + 1/2 - y^2)/k is in it, and u and y are
independent over C, as e^(2u) is transcendental over C(u).  K consists of meromorphic functions on some disc, so only
complex numbers have the derivative 0.  An integral of 1/y would be elementary only if (Liouville)

    1/y = Dv + sum_i c_i D(v_i)/v_i,    v, v_i in K,  the numbers c_i independent over Q.

The places of K are judged over the algebraic closure k' of C(u), to which D extends: y = a for a in k', and infinity.

>>> print(derivation.steps[0].text())
Subs((-2*k*theta + 1)/(2*y), theta, (u - y**2 + 1/2)/k) = -u/y + y
"""

import sympy
from sympy import Derivative, Limit, Rational, exp, oo, sqrt

from derivations.steps import At, Derivation, Solution, defined

u, y, k, theta, C = sympy.symbols("u y k theta C", nonzero=True)
j, n, m = sympy.symbols("j n m", positive=True, integer=True)
t, v = sympy.Symbol("t", nonzero=True), sympy.Symbol("v", real=True)
order = sympy.Symbol("n", real=True)  # the order of g at a place
a, c = (sympy.Function(name)(u) for name in "ac")
half = Rational(1, 2)

derivation = Derivation(
    "smith-not-elementary",
    "Smith's quadrature is not elementary",
    source="Smith 2012, (54); Liouville's theorem on elementary integrals; a referee's proof, its steps judged again",
)
step, asserts = derivation.step, derivation.asserts

radicand = u + half - k * theta
inside = (u + half - y**2) / k
D = defined("D", lambda f: Derivative(f, u) + (y - u / y) * Derivative(f, y))

step(
    "theta = e^(2u), y^2 = u + 1/2 - k theta, k != 0; D = d/du.  2 y Dy = 1 - 2 k theta, where theta is in C(u, y): Dy",
    At((1 - 2 * k * theta) / (2 * y), {theta: inside}),
    y - u / y,
)
step("so D is a derivation of C(u, y), with D theta = 2 theta", D(inside), 2 * inside)
step(
    "sigma: y -> -y leaves u and theta as they are and commutes with D",
    D(u**m * (-y) ** n),
    At(D(u**m * y**n), {y: -y}),
)
step(
    "Half the difference of Liouville's 1/y = Dv + sum_i c_i D(v_i)/v_i and its image is of the same form, with"
    " v(u, -y) = -v(u, y), and g_i = v_i/sigma v_i in the place of v_i: sigma g_i = 1/g_i.  The left side stays",
    (1 / y - At(1 / y, {y: -y})) / 2,
    1 / y,
)
rate = sympy.Function("r")(u)  # Dt
step(
    "At a place with the parameter t a function begins with c t^n, c algebraic over C(u): D of this, over itself, is",
    (Derivative(c * t**n, u) + rate * Derivative(c * t**n, t)) / (c * t**n),
    Derivative(c, u) / c + n * rate / t,
)
step(
    "Ordinary places, y = a, a not 0, t = y - a: Dt is there a number of k' that is not 0, unless y = a is a solution;"
    " so D raises the order j of a pole to j + 1, and D(g)/g has a simple pole",
    At(D(y - a), {y: a}),
    a - u / a - Derivative(a, u),
)
square = u + half + C * exp(2 * u)
step(
    "If a' = a - u/a, (a^2)' = 2 a^2 - 2 u: a^2 = u + 1/2 + C e^(2u), algebraic over C(u) for C = 0 only",
    Derivative(square, u),
    At(2 * y**2 - 2 * u, {y**2: square}),
)
step("which are the places a = +- sqrt(u + 1/2) of theta = 0", At(inside, {y: sqrt(u + half)}), 0)
step(
    "The place y = 0, t = y: Dt = y - u/y has a pole, D raises the order j of a pole to j + 2, and D(g)/g has a pole of"
    " the second order at most: t^2 Dt/t is",
    Limit(y**2 * (D(y) / y), y, 0),
    -u,
)
step("The places theta = 0, t = theta: D keeps the order, Dt/t", D(inside) / inside, 2)
step("and infinity, t = 1/y: it does too, Dt/t", Limit(D(1 / y) * y, y, oo), -1)

# v has no poles.
asserts(
    "Where D raises the order of a pole of v, there is nothing to cancel it: 1/y and D(g_i)/g_i have a simple pole at"
    " most at an ordinary place, one of the second order at most at y = 0; j + 1 against 1, j + 2 against 2",
    sympy.Gt(j + 1, 1, evaluate=False),
    sympy.Gt(j + 2, 2, evaluate=False),
)
step(
    "At theta = 0, where 1/y and D(g_i)/g_i are finite, c theta^(-j) in v must have D(c theta^(-j)) = 0: c' = 2 j c,"
    " c = C e^(2ju), which is not algebraic but for C = 0",
    D(C * exp(2 * j * u) * inside**-j),
    0,
)
step(
    "At infinity, where they are finite too, c y^j must have c' + j c = 0: c = C e^(-ju), C = 0 again",
    Derivative(C * exp(-j * u), u) + j * C * exp(-j * u),
    0,
)
step("So v has no pole at all: it is in C(u), it does not see sigma, and it is odd: v", Solution(v, -v, v), 0)

# The functions g_i have no zeros and no poles.
number = sympy.Symbol("s", real=True)  # sum_i c_i n_i
step(
    "At an ordinary place 1/y is finite: the residues of D(g_i)/g_i, n_i times r = a - u/a - a' != 0, with"
    " s = sum_i c_i n_i, cancel; c_i independent over Q: all n_i = 0",
    Solution(number * sympy.Symbol("r", nonzero=True), 0, number),
    0,
)
step(
    "sigma keeps the places y = 0 and infinity, and takes g_i to 1/g_i: the order of g_i there is its own negative",
    Solution(order, -order, order),
    0,
)
step(
    "The places a = +- sqrt(u + 1/2) of theta = 0: the conjugation of the root keeps g_i, which is in C(u, y), and"
    " gives it the same order at both; sigma gives 1/g_i at one the order of g_i at the other: again 0",
    At(At(y, {y: -y}), {y: sqrt(u + half)}),
    -sqrt(u + half),
)
g = sympy.Symbol("g", real=True)
step(
    "So g_i is in C(u), sigma keeps it, and g_i = 1/g_i: it is 1 or -1, here the positive one,",
    Solution(g**2, 1, g, sign=1),
    1,
)
G = sympy.Function("g")(u)
step(
    "and from g_i^2 = 1, 2 g_i D(g_i) = 0.  Nothing is left on the right side of Liouville's equation, and on the left"
    " 1/y: the integral is not elementary.  D(g^2) is",
    Derivative(G**2, u),
    2 * G * Derivative(G, u),
)
x, gamma, omega = sympy.symbols("x gamma omega", positive=True)
E = sympy.Symbol("E", real=True, nonzero=True)
step(
    "(54), corrected, is this integral: with u = gamma x, du = gamma dx, the square under its root is, for E != 0,"
    " as on every half-cycle between two turning points",
    omega**2 / gamma**2 * At(radicand, {theta: exp(2 * gamma * x), k: -2 * E * gamma**2 / omega**2, u: gamma * x}),
    2 * E * exp(2 * gamma * x) + omega**2 / gamma * (x + 1 / (2 * gamma)),
    proves=("smith2012:claim.not-in-tables",),
)

# Near misses: integrals that are elementary, and where the proof stops for them.
step(
    "Near miss, k = 0: theta is not in C(u, y), y is algebraic over C(u), and the integral is 2 y",
    Derivative(2 * sqrt(u + half), u),
    1 / sqrt(u + half),
)
step(
    "Near miss: y - u/y is odd, and the integral is y.  It grows like y, so v may have a pole at infinity",
    Limit(D(y) / y, y, oo),
    1,
)
step(
    "Near miss: 2 (y - u/y)/(1 - y^2) is odd, and the integral is ln((1+y)/(1-y)).  It is not finite at y = 1, which is"
    " ordinary: its residue there, which g may have, is",
    Limit((y - 1) * (2 * (y - u / y) / (1 - y**2)), y, 1),
    u - 1,
)
