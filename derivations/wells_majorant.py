"""The local expansion at a turning point in any well has a majorant of two numbers.

eta = u_0 - u and P = G(u, w) = P_0 (1 - r) as series in z_0 = w^2, z_i = w^alpha_i; D = w d/dw.

>>> len(derivation.steps) > 4
True
"""

import sympy

from derivations.steps import At, Derivation

w, P0, a, H, n = sympy.symbols("w P_0 a H n", positive=True)
r, R = sympy.symbols("r R")
slope = sympy.Symbol("u'")
rate, u0 = sympy.symbols("rho u_0", positive=True)

derivation = Derivation(
    "wells-majorant",
    "A majorant of the local expansion at a turning point of any well",
    source="Cauchy's method of majorants; derivation turning-point-majorant for the linear spring",
)
step, holds = derivation.step, derivation.holds

step(
    "du/dw = -w/P, so with eta = u_0 - u and P = P_0 (1 - r): D eta = -w du/dw",
    At(-w * slope, {slope: -w / (P0 * (1 - r))}),
    w**2 / (P0 * (1 - r)),
)
step(
    "Every monomial of eta has a factor z_0 = w^2, so D multiplies it by at least 2: eta << (z_0/(2 |P_0|))/(1 - r)",
    w * sympy.Derivative(w ** (2 + n), w),
    (2 + n) * w ** (2 + n),
)
step(
    "A power of the place: u_0^3 - (u_0 - eta)^3 has coefficients whose absolute values make (u_0 + H)^3 - u_0^3",
    sympy.Add(sympy.expand((u0 + H) ** 3), -(u0**3), evaluate=False),
    3 * u0**2 * H + 3 * u0 * H**2 + H**3,
)
step(
    "A sine: sin(rho (u_0 - eta))/rho has the coefficients of sin and cos alike, in absolute value at most those of",
    sympy.sin(rate * u0) * (sympy.cosh(rate * H) - 1) + sympy.cos(rate * u0) * sympy.sinh(rate * H),
    sympy.sin(rate * u0) * 2 * sympy.sinh(rate * H / 2) ** 2 + sympy.cos(rate * u0) * sympy.sinh(rate * H),
)
step(
    "So r << R(H), the sum of all these and of epsilon_i (|u_0| + H)^m_i z_i, over |P_0|, and eta << H_j for every j"
    " in H_(j+1) = a/(1 - R(H_j)), H_0 = 0, up to the j-th degree.  R grows with H, and a/(1 - R) grows with R:",
    sympy.Derivative(a / (1 - R), R),
    a / (1 - R) ** 2,
)
spring = H / 2
holds(
    "So if a/(1 - R(H)) <= H < oo with R(H) < 1 for one number H, all iterates from 0 stay below it (example: R = H/2,"
    " a = 1/4, H = 1/2), and with them the sums of absolute values of all coefficients of eta; those of r are <= R(H)",
    bool((a / (1 - spring)).subs({a: sympy.Rational(1, 4), H: sympy.Rational(1, 2)}) <= sympy.Rational(1, 2)),
    sympy.Le(a / (1 - R), H),
)
step(
    "1/P = (1/P_0)/(1 - r) without its constant term is then at most",
    1 / (1 - R) - 1,
    R / (1 - R),
)
