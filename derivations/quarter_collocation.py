"""Quarter-swings by collocation: the variable in which nothing is singular, and what a polynomial misses the truth by.

>>> len(derivation.steps) > 10
True
"""

import sympy

from derivations.steps import At, Derivation

theta, z, x, y, phi, h, R = sympy.symbols("theta z x y phi h R", positive=True)
D, slope, c, s = sympy.symbols("D D_g c s", positive=True)
K, eta, E0, t = sympy.symbols("K eta E_0 t", positive=True)
alpha = sympy.Symbol("alpha", positive=True)
k = sympy.Symbol("k", positive=True, integer=True)

derivation = Derivation(
    "quarter-collocation",
    "Quarter-swings by collocation, enclosed",
    source="return_map.quarters; the equations are those of half-swing-equations, interpolation: return_map.chebyshev",
)
step = derivation.step

# 1. The variable.
step(
    "z = ln tan(theta/2): d theta = s dz, as dz/d theta is",
    sympy.Derivative(sympy.log(sympy.tan(theta / 2)), theta),
    1 / sympy.sin(theta),
)
half = sympy.atan(sympy.exp(z))
step(
    "The sine, 2 sin(theta/2) cos(theta/2), becomes 1/cosh z",
    At(2 * sympy.sin(theta / 2) * sympy.cos(theta / 2), {theta: 2 * half}),
    1 / sympy.cosh(z).rewrite(sympy.exp),
)
step(
    "and the cosine -tanh z",
    At(sympy.cos(theta / 2) ** 2 - sympy.sin(theta / 2) ** 2, {theta: 2 * half}),
    -sympy.tanh(z).rewrite(sympy.exp),
)
step(
    "dg/d theta = -N/(1 - C) with N = s D, C = c D (half-swing-equations) is, by dz,",
    At(-x / (1 - y), {x: s * D, y: c * D}) * s,
    -(s**2) * D / (1 - c * D),
)
swing = sympy.Symbol("g_z", real=True)
step(
    "and d tau/dz = s - (c/s) g_z with this g_z = dg/dz",
    At(s - c / s * swing, {swing: -(s**2) * D / (1 - c * D)}),
    s / (1 - c * D),
)
v, a, b = sympy.symbols("v a b", real=True)
step(
    "Backwards in time, v -> -v, each strength changes its sign: x' = v, v' = -x - N(v) with N odd",
    sympy.Add(At(-x - b * v, {v: -v}), x, evaluate=False),
    b * v,
)

# 2. On the ellipse.
point, turned = sympy.Symbol("t"), sympy.exp(sympy.I * phi)
real, imaginary = sympy.symbols("p q", real=True)
step(
    "cosh(x + iy) = p + i q: |cosh(x + iy)|^2, so that s is analytic for |Im z| < pi/2, where it does not vanish",
    At(real**2 + imaginary**2, {real: sympy.cosh(x) * sympy.cos(y), imaginary: sympy.sinh(x) * sympy.sin(y)}),
    sympy.sinh(x) ** 2 + sympy.cos(y) ** 2,
)
step(
    "and |sinh(x + iy)|^2 in the same way",
    At(real**2 + imaginary**2, {real: sympy.sinh(x) * sympy.cos(y), imaginary: sympy.cosh(x) * sympy.sin(y)}),
    sympy.sinh(x) ** 2 + sympy.sin(y) ** 2,
)
step(
    "The imaginary part of z = h (t - 1), t = (R e^(i phi) + e^(-i phi)/R)/2, is largest at phi = pi/2",
    At(sympy.im(h * (point - 1), evaluate=False), {point: (R * turned + 1 / (R * turned)) / 2}),
    h * (R - 1 / R) / 2 * sympy.sin(phi),
)
step(
    "The integral of sum b_k T_k has the coefficients (b_(k-1) - b_(k+1))/(2k): the derivative of T_k, t = cos phi, is",
    sympy.Derivative(sympy.cos(k * phi), phi) / sympy.Derivative(sympy.cos(phi), phi),
    k * sympy.sin(k * phi) / sympy.sin(phi),
)
higher, lower = sympy.cos((k + 1) * phi), sympy.cos((k - 1) * phi)
step(
    "and T_(k+1)/(2(k+1)) - T_(k-1)/(2(k-1)), k >= 2, has the derivative T_k",
    sympy.Derivative(higher / (2 * (k + 1)) - lower / (2 * (k - 1)), phi) / sympy.Derivative(sympy.cos(phi), phi),
    sympy.cos(k * phi),
)

# 3. On the real line.
swell = sympy.sin(theta) ** alpha * sympy.cos(theta)
step(
    "s^alpha c is largest where s^2 = alpha c^2: its logarithmic derivative vanishes at tan(theta) = alpha^(1/2)",
    At(alpha * sympy.cot(theta) - sympy.tan(theta), {theta: sympy.atan(sympy.sqrt(alpha))}),
    0,
)
step(
    "where it is",
    At(swell, {theta: sympy.atan(sympy.sqrt(alpha))}),
    sympy.sqrt(alpha**alpha / (1 + alpha) ** (1 + alpha)),
)
drag = sympy.Function("D")(x)
step(
    "The right-hand sides change with g at the rates -s^2 D_g/(1 - cD)^2",
    sympy.Derivative(-(s**2) * drag / (1 - c * drag), x),
    -(s**2) * sympy.Derivative(drag, x) / (1 - c * drag) ** 2,
)
step(
    "and s c D_g/(1 - cD)^2, |D_g| a sum of s^alpha with alpha >= 0",
    sympy.Derivative(s / (1 - c * drag), x),
    s * c * sympy.Derivative(drag, x) / (1 - c * drag) ** 2,
)
step(
    "By theta, as dz = d theta/s, the first is s^(1+alpha) <= s of it, over the quarter at most K times",
    sympy.Integral(sympy.sin(theta), (theta, 0, sympy.pi / 2)),
    1,
)
step(
    "and the second s^alpha c <= c",
    sympy.Integral(sympy.cos(theta), (theta, 0, sympy.pi / 2)),
    1,
)
J = sympy.Function("J", nonnegative=True)(t)
bound = sympy.exp(J) * (E0 + eta * t)
step(
    "|g - G|' <= J' |g - G| + eta from E_0, J the integral of the rate: e^J (E_0 + eta t) grows at least as fast",
    sympy.Derivative(bound, t),
    sympy.Derivative(J, t) * bound + eta * sympy.exp(J),
)
step(
    "as e^J >= 1: for J >= 0 the integral of what is positive is",
    sympy.Integral(sympy.exp(y), (y, 0, K)),
    sympy.exp(K) - 1,
)
step(
    "at the end of the length 2, where J <= K, the bound is at most that of J = K",
    At(bound, {J: K, t: 2}),
    sympy.exp(K) * (E0 + 2 * eta),
)
