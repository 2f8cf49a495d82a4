"""The local expansion at a turning point in any well has a majorant of two numbers.

eta = u_0 - u and P = G(u, w) = P_0 (1 - r) as series in z_0 = w^2, z_i = w^alpha_i; D = w d/dw.

>>> len(derivation.steps) > 4
True
"""

import sympy

from derivations.steps import At, Derivation

w, P0, a, H, n = sympy.symbols("w P_0 a H n", positive=True)
r, R, eta = sympy.symbols("r R eta")
c_j, m, j = sympy.symbols("c_j m j", integer=True, nonnegative=True)
slope = sympy.Symbol("u'")
rate, u0 = sympy.symbols("rho u_0", positive=True)

derivation = Derivation(
    "wells-majorant",
    "A majorant of the local expansion at a turning point of any well",
    source="Cauchy's method of majorants; derivation turning-point-majorant for the linear spring",
)
step, asserts = derivation.step, derivation.asserts

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
    "A power of the place, (u_0 - eta)^m: its derivatives by eta, with c_(j+1) = (m - j) c_j and c_0 = 1, are",
    sympy.Derivative((-1) ** j * c_j * (u0 - eta) ** (m - j), eta),
    (-1) ** (j + 1) * ((m - j) * c_j) * (u0 - eta) ** (m - j) / (u0 - eta),
)
step(
    "while those of (u_0 + H)^m are the same without signs: the absolute values of all Taylor coefficients but the"
    " first (c_j >= 0 for a natural m) make (u_0 + H)^m - u_0^m",
    sympy.Derivative(c_j * (u0 + H) ** (m - j), H),
    ((m - j) * c_j) * (u0 + H) ** (m - j) / (u0 + H),
)
step(
    "A sine: sin(rho (u_0 - eta)) is",
    sympy.sin(rate * (u0 - eta)),
    sympy.sin(rate * u0) * sympy.cos(rate * eta) - sympy.cos(rate * u0) * sympy.sin(rate * eta),
)
step(
    "The series of the cosine is even with alternating signs: at eta = i H all its terms are >= 0, and it is",
    At(sympy.cos(rate * eta), {eta: sympy.I * H}),
    sympy.cosh(rate * H),
)
step(
    "that of the sine is odd: over i, so that the absolute values make |sin rho u_0| (cosh rho H - 1) + |cos rho u_0|"
    " sinh rho H",
    At(sympy.sin(rate * eta) / sympy.I, {eta: sympy.I * H}),
    sympy.sinh(rate * H),
)
step(
    "So r << R(H), the sum of all these and of epsilon_i (|u_0| + H)^m_i z_i, over |P_0|, and eta << H_j for every j"
    " in H_(j+1) = a/(1 - R(H_j)), H_0 = 0, up to the j-th degree.  R grows with H, and a/(1 - R) grows with R:",
    sympy.Derivative(a / (1 - R), R),
    a / (1 - R) ** 2,
)
gap, left = sympy.symbols("d e", positive=True)  # R(H) = 1 - e, R(H_j) = R(H) - d
asserts(
    "So if a/(1 - R(H)) <= H < oo with R(H) < 1 for one number H, then H_j <= H gives H_(j+1) <= a/(1 - R(H)) <= H:"
    " with R(H) = 1 - e, R(H_j) = 1 - e - d the difference is >= 0. All iterates from 0 stay below H, and with them"
    " the sums of absolute values of all coefficients of eta; those of r are <= R(H)",
    sympy.Ge(a / left, a / (left + gap), evaluate=False),
)
power, x = sympy.Symbol("k", integer=True, positive=True), sympy.Symbol("x", positive=True)
step(
    "1/P = (1/P_0)/(1 - r) without its constant term is then at most a geometric series, R = 1/(1 + x) < 1,",
    sympy.Sum(At(R**power, {R: 1 / (1 + x)}), (power, 1, sympy.oo)),
    At(R / (1 - R), {R: 1 / (1 + x)}),
)
