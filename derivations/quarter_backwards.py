"""At complex strengths no quarter-swing grows more than the one backwards in time, at the sizes of these strengths.

>>> print(derivation.steps[3].text())
Derivative(n/(k*n + 1), n) = (k*n + 1)**(-2)
"""

import sympy

from derivations.steps import At, Derivation

n, k, phi = sympy.symbols("n k phi", positive=True)
p, q = sympy.symbols("p q", real=True)
y, d, z, rho, sine, swell = sympy.symbols("y d z rho s H", positive=True)
b = sympy.Symbol("b", nonnegative=True)

derivation = Derivation(
    "quarter-backwards",
    "How far quarter-swings are analytic in the strengths",
    source="return_map.quarter_majorant; the equations are those of half-swing-equations",
)
step, asserts = derivation.step, derivation.asserts

turned = n * (sympy.cos(phi) + k * n) / (1 + 2 * k * n * sympy.cos(phi) + k**2 * n**2)
step(
    "g' = -N/(1 - k N), k = c/s >= 0; at N = -(p + i q) its real part is (p + k |N|^2)/|1 - k N|^2, in polar form",
    At((p + k * (p**2 + q**2)) / ((1 + k * p) ** 2 + (k * q) ** 2), {p: n * sympy.cos(phi), q: n * sympy.sin(phi)}),
    turned,
)
lacking = n * (1 - k * n) * y / ((1 + k * n) * ((1 + k * n) ** 2 - 2 * k * n * y))
step(
    "It is at most n/(1 + k n), that of phi = 0, the motion backwards in time; it lacks, y = 1 - cos(phi) <= 2,",
    At(n / (1 + k * n) - turned, {sympy.cos(phi): 1 - y}),
    lacking,
)
step(
    "no less than 0 for k n < 1, as the last factor below is least at y = 2,",
    At((1 + k * n) ** 2 - 2 * k * n * y, {y: 2}),
    (1 - k * n) ** 2,
)
step(
    "and n/(1 + k n) grows with n: all N of modulus at most n have real parts of g' below it",
    sympy.Derivative(n / (1 + k * n), n),
    1 / (1 + k * n) ** 2,
)
step(
    "n = sum rho_i e^(b_i H) s^(alpha_i+1), b_i = alpha_i - 1 >= 0, does not fall with H: by comparison Re g <= H,",
    sympy.Derivative(rho * sympy.exp(b * swell) * sine ** (b + 2), swell),
    b * rho * sympy.exp(b * swell) * sine ** (b + 2),
)
step(
    "with H' = n/(1 + k n), H(0) = 0, as long as k n < 1.  On a piece k is least at its end: the rate falls with k",
    sympy.Derivative(n / (1 + k * n), k),
    -(n**2) / (1 + k * n) ** 2,
)
step(
    "The modulus of g' is at most n/(1 - k n): at N = p + i q, of modulus n and angle phi, |1 - k N|^2 is",
    At((1 - k * p) ** 2 + (k * q) ** 2, {p: n * sympy.cos(phi), q: n * sympy.sin(phi)}),
    (1 - k * n) ** 2 + 2 * k * n * (1 - sympy.cos(phi)),
)
asserts(
    "and |d tau/d theta - 1| = |C/(1 - C)|, C = k N, at most z/(1 - z), z = k n < 1, which grows: at z = 1 - d, d > 0,",
    sympy.Gt(At(sympy.Derivative(z / (1 - z), z), {z: 1 - d}), 0, evaluate=False),
)
