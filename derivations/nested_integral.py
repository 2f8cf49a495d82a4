"""No combination of the moments that accompany I_4 equals it, with coefficients rational in alpha.

>>> print(derivation.steps[0].text())
Integral(phi**2, (phi, -pi/2, pi/2))/pi = pi**2/12
"""

import sympy

from asymptotics.expansions.moments.symbolic import moment
from derivations.steps import At, Coefficient, Derivation, Solution, defined

phi, m, u = sympy.symbols("phi m u", real=True)
alpha = sympy.Symbol("alpha", positive=True)
j = sympy.Symbol("j", integer=True, positive=True)
pi, half = sympy.pi, sympy.Rational(1, 2)
g = sympy.gamma(sympy.Rational(1, 4)) ** 4 / pi**2

derivation = Derivation(
    "nested-integral",
    "I_4 is no combination of its moments with coefficients rational in alpha",
    source="expansions.half_swings.symbolic; J = <s^(2 alpha) S^2>, suppose J = r_1 pi^2 M_(alpha+1)^2 M_(2alpha)"
    " + r_2 M_(4alpha) + r_3 M_(alpha+1) M_(3alpha+1), r_i in Q(alpha)",
)
step = derivation.step

# Odd integers.
quarter = (phi, -pi / 2, pi / 2)
step(
    "alpha odd, phi = theta - pi/2, s = cos(phi): s^(alpha+1) = M_(alpha+1) + rational cosines of 2 j phi, so S ="
    " M_(alpha+1) phi + rational sines. In <s^(2 alpha) S^2> the mean of phi^2 is",
    sympy.Integral(phi**2, quarter) / pi,
    pi**2 / 12,
)
step(
    "that of phi^2 cos(2 j phi) is rational: the primitive",
    sympy.Derivative(
        phi**2 * sympy.sin(2 * j * phi) / (2 * j)
        + phi * sympy.cos(2 * j * phi) / (2 * j**2)
        - sympy.sin(2 * j * phi) / (4 * j**3),
        phi,
    ),
    phi**2 * sympy.cos(2 * j * phi),
)
step(
    "between the ends, where sin(2 j phi) = 0 and phi = -+ pi/2,",
    (At(phi * sympy.cos(2 * j * phi), {phi: pi / 2}) - At(phi * sympy.cos(2 * j * phi), {phi: -pi / 2}))
    / (2 * j**2 * pi),
    (-1) ** j / (2 * j**2),
)
step(
    "that of phi sin(2 j phi) is rational too: the primitive",
    sympy.Derivative(
        -phi * sympy.cos(2 * j * phi) / (2 * j) + sympy.sin(2 * j * phi) / (4 * j**2),
        phi,
    ),
    phi * sympy.sin(2 * j * phi),
)
step(
    "So J = pi^2 M_(alpha+1)^2 M_(2alpha)/12 + rational, the moments being rational. alpha = 1: J (rational part 0)",
    sympy.Integral(sympy.cos(phi) ** 2 * (phi / 2 + sympy.sin(2 * phi) / 4) ** 2, quarter) / pi,
    pi**2 * moment(2) ** 3 / 12,
)
w = sympy.Symbol("w", real=True)
S_3 = 3 * phi / 8 + sympy.sin(2 * phi) / 4 + sympy.sin(4 * phi) / 32
step("alpha = 3: S", sympy.Integral(sympy.cos(w) ** 4, (w, 0, phi)), S_3)
step(
    "and I_4 = J - pi^2 M_(alpha+1)^2 M_(2alpha)/12.  pi^2 is irrational: r_1 = 1/12 at every odd integer that is no"
    " pole of an r_i: r_1 - 1/12 has infinitely many zeros",
    sympy.Integral(sympy.cos(phi) ** 6 * S_3**2, quarter) / pi - pi**2 * moment(4) ** 2 * moment(6) / 12,
    -sympy.Rational(143, 20480),
)
M_of = defined("M", moment, index=True)

# Half-integers.
step(
    "2 alpha odd: G = int_(pi/2)^theta s^(2 alpha) is an odd polynomial in c, G(0) = -pi M_(2alpha)/2 = -G(pi), and"
    " S(pi) = m = -S(0), m = pi M_(alpha+1)/2. By parts [G S^2]/pi is",
    2 * (pi * moment(2 * alpha) / 2) * At(m**2, {m: pi * moment(alpha + 1) / 2}) / pi,
    pi**2 * moment(alpha + 1) ** 2 * moment(2 * alpha) / 4,
)
p = sympy.Symbol("p", positive=True)
step(
    "The rest is -2 int G s^(alpha+1) S. In it -c s^(p-1) has the primitive -s^p/p, zero at both ends,",
    sympy.Derivative(-(sympy.sin(phi) ** p) / p, phi),
    -sympy.cos(phi) * sympy.sin(phi) ** (p - 1),
)
step(
    "and S' = s^(alpha+1), so integrals of s^(p+alpha+1) remain, p - alpha - 2 = 0, 2, …: even powers 2 alpha + 3, …,"
    " hence rational after division by pi. J = pi^2 M_(alpha+1)^2 M_(2alpha)/4 + rational; at alpha = 1/2 it is",
    -sympy.Rational(4, 5) * M_of(4),
    -sympy.Rational(3, 10),
)
step("M_(p+2) = (p+1)/(p+2) M_p", M_of(p + 2) / M_of(p), (p + 1) / (p + 2))
step(
    "brings every half-integer to 1/2 or 3/2. There M_(4alpha) is rational and M_(2alpha) rational/pi,",
    M_of(1),
    2 / pi,
)
low, high = sympy.Rational(3, 2), sympy.Rational(5, 2)
step(
    "M_(alpha+1) M_(3alpha+1) is rational/pi, as 2 alpha is odd: one of both is a rational times M_(3/2), one M_(5/2)",
    M_of(low) * M_of(high),
    sympy.Rational(4, 5) / pi,
)
z = sympy.Symbol("z")
step(
    "Reflection, Gamma(z) Gamma(1-z) = pi/sin(pi z), at z = 1/4",
    sympy.Mul(sympy.gamma(half / 2), sympy.gamma(3 * half / 2), evaluate=False),
    At(pi / sympy.sin(pi * z), {z: half / 2}),
)
step(
    "and pi^2 M_(alpha+1)^2 M_(2alpha) is a rational multiple of g = Gamma(1/4)^4/pi^2 or of 1/g: of g for M_(3/2)",
    pi**2 * M_of(low) ** 2 * M_of(1),
    2 * (sympy.gamma(half / 2) / sympy.gamma(3 * half / 2)) ** 2 / 9,
)
step(
    "here with the square of Gamma(3/4) = sqrt(2) pi/Gamma(1/4),",
    At(2 * (sympy.gamma(half / 2) / u) ** 2 / 9, {u: sympy.sqrt(2) * pi / sympy.gamma(half / 2)}),
    g / 9,
)
step(
    "of 1/g for M_(5/2)",
    pi**2 * M_of(high) ** 2 * M_of(3),
    sympy.Rational(192, 25) * (sympy.gamma(3 * half / 2) / sympy.gamma(half / 2)) ** 2,
)
step(
    "here",
    At(sympy.Rational(192, 25) * (u / sympy.gamma(half / 2)) ** 2, {u: sympy.sqrt(2) * pi / sympy.gamma(half / 2)}),
    sympy.Rational(384, 25) / g,
)
r_1, r_3, rho, sigma, kappa, X, Y = sympy.symbols("r_1 r_3 rho sigma kappa X Y")
step(
    "pi = X and Gamma(1/4) = Y are algebraically independent (Chudnovsky): (1/4 - r_1) rho g + sigma - r_3 kappa/pi"
    " = 0 with rational rho != 0, times X^2, is a polynomial identity, in which Y^4 has",
    Coefficient(X**2 * ((sympy.Rational(1, 4) - r_1) * rho * Y**4 / X**2 + sigma - r_3 * kappa / X), Y, 4),
    (sympy.Rational(1, 4) - r_1) * rho,
)
step(
    "and with 1/g, times X Y^4, X^3 has the same",
    Coefficient(X * Y**4 * ((sympy.Rational(1, 4) - r_1) * rho * X**2 / Y**4 + sigma - r_3 * kappa / X), X, 3),
    (sympy.Rational(1, 4) - r_1) * rho,
)
step(
    "so that at every half-integer that is no pole r_1 is",
    Solution((sympy.Rational(1, 4) - r_1) * rho, 0, r_1),
    sympy.Rational(1, 4),
)
step(
    "and r_1 would be 1/12 and 1/4 identically. No such r_i exist. (Other polynomials in moments are not excluded.)",
    At(r_1, {r_1: sympy.Rational(1, 4)}) - At(r_1, {r_1: sympy.Rational(1, 12)}),
    sympy.Rational(1, 6),
)
