"""Straightening: any even well is a linear spring in xi = sgn(x) sqrt(2 V(x)), with losses that depend on the place.

>>> print(derivation.steps[1].text())
sqrt(2)*Derivative(V(x), x)/(2*sqrt(V(x))) = Derivative(sqrt(2)*sqrt(V(x)), x)
"""

import sympy

from derivations.steps import At, Coefficient, Derivation, Taylor

x, h, xi, c, A = sympy.symbols("x h xi c A", positive=True)
V = sympy.Function("V", positive=True)(x)
root = sympy.sqrt(2 * V)

derivation = Derivation(
    "straightening",
    "Every even potential is a linear spring in its own coordinate",
    source="asymptotics.expansions.straightening",
)
step = derivation.step

step("For x > 0 put xi = sqrt(2 V): xi xi' = V'", root * sympy.Derivative(root, x), sympy.Derivative(V, x))
step("so that xi'(x) is", sympy.Derivative(V, x) / root, sympy.Derivative(root, x))
slope = sympy.Derivative(root, x)
step(
    "With d sigma = xi' dt: d xi/d sigma = v, and d v/d sigma = (-V' - h)/xi' is linear but for the loss",
    (-sympy.Derivative(V, x) - h) / slope,
    -root - h / slope,
)
step(
    "Pendulum, V = 1 - cos x, the integral of the force: xi^2 = 2 V is (2 sin(x/2))^2",
    2 * sympy.Integral(sympy.sin(h), (h, 0, x)),
    4 * sympy.sin(x / 2) ** 2,
)
step(
    "x = 2 arcsin(xi/2) has the slope (1 - xi^2/4)^(-1/2)",
    sympy.Derivative(2 * sympy.asin(xi / 2), xi),
    1 / sympy.sqrt(1 - xi**2 / 4),
)
step(
    "Duffing, V = x^2/2 + c x^4/4, at the turning point: xi_A^2",
    At(2 * (x**2 / 2 + c * x**4 / 4), {x: A}),
    A**2 * (1 + c * A**2 / 2),
)

# What a half-swing loses at first order in the loss, in x and in xi, by the amplitude.
end, theta = sympy.symbols("xi_A theta", positive=True)
clock = Taylor(1 / sympy.sqrt(1 - xi**2 / 4), xi, 4)
lost = sympy.Integral(2 * sympy.cos(x) - 2 * sympy.cos(A), (x, 0, A))
step(
    "A pendulum with quadratic loss v^2 = 2 cos x - 2 cos A loses the integral over x; through A^7 it is that of the"
    " straightened loss x'(xi) v^2, v^2 = xi_A^2 - xi^2, over xi, at xi_A = 2 sin(A/2)",
    Taylor(lost, A, 7),
    Taylor(At(sympy.Integral(clock * (end**2 - xi**2), (xi, 0, end)), {end: 2 * sympy.sin(A / 2)}), A, 7),
)
step(
    "and without the factor x'(xi) it would not be: at A^5 there is missing",
    Coefficient(lost - At(sympy.Integral(end**2 - xi**2, (xi, 0, end)), {end: 2 * sympy.sin(A / 2)}), A, 5),
    sympy.Rational(1, 60),
)
inverse = xi * (1 - c * xi**2 / 4 + sympy.Rational(7, 32) * c**2 * xi**4)
step(
    "Duffing: xi^2 = x^2 + c x^4/2 inverted, through c^2",
    Taylor(At(x**2 + c * x**4 / 2, {x: inverse}), c, 2),
    xi**2,
)
sine, cosine = sympy.sin(theta), sympy.cos(theta)
in_xi = sympy.Integral(
    At(sympy.Derivative(inverse, xi), {xi: end * sine}) * (end * cosine) ** 2, (theta, 0, sympy.pi / 2)
)
step(
    "with linear loss it loses int v dx, v = A cos theta (1 + c A^2 (1 + sin^2 theta)/2)^(1/2) at x = A sin theta;"
    " through c^2 that is the integral of x'(xi) v over xi = xi_A sin theta.  The half-swings themselves, to"
    " the fifth order of the losses, are compared in tests/expansions/straightening/test_wells.py",
    sympy.Integral(
        (A * cosine) ** 2 * Taylor(sympy.sqrt(1 + c * A**2 * (1 + sine**2) / 2), c, 2), (theta, 0, sympy.pi / 2)
    ),
    Taylor(At(in_xi, {end: A * sympy.sqrt(1 + c * A**2 / 2)}), c, 2),
)
