"""What a spring that is ignored does to the decrements: to first order it looks like loss of a higher exponent.

On a half-swing d ln r/d theta = -s N/(1 - c N), N = rho s^alpha - gamma c^p with rho = e r^(alpha-1) and
gamma = g r^(p-1), r(0) = 1: a loss of strength e beside a spring g x^p, p odd.  Its term e g in L = ln r(pi)
is the bias.

>>> derivation.steps[-1].right
-11*c*epsilon/12
"""

import sympy

from derivations.steps import At, Coefficient, Derivation, Solution, Taylor, defined

alpha = sympy.Symbol("alpha", nonnegative=True)
p = sympy.Symbol("p", positive=True)
theta = sympy.Symbol("theta", positive=True)
N, e, g, K, J, I_Y = sympy.symbols("N e g K J I_Y")
epsilon, c = sympy.symbols("epsilon c", positive=True)
s, cos = sympy.sin(theta), sympy.cos(theta)
S, C = sympy.symbols("s c_theta", positive=True)

derivation = Derivation(
    "ignored-spring",
    "The bias of an ignored spring",
    source="the half-swing equations with a spring; used where amplitudes are fitted without times",
)
step = derivation.step

step("the rate of ln r to second order in N", Taylor(-S * N / (1 - C * N), N, 2), -S * N - S * C * N**2)
step(
    "in N^2, the product of loss and spring: -s c (-2 e g s^alpha c^p)",
    Coefficient(Coefficient(-S * C * (e * S**alpha - g * C**p) ** 2, e, 1), g, 1),
    2 * S ** (alpha + 1) * C ** (p + 1),
)
rise = (1 - cos ** (p + 1)) / (p + 1)
step("the spring alone moves ln r by g (1 - c^(p+1))/(p+1)", sympy.Derivative(rise, theta), cos**p * s)
Y = sympy.Function("Y")(theta)  # int_0^theta s^(alpha+1): the loss alone moves ln r by -e Y
mixed = -(s ** (alpha + 1)) * (alpha - 1) * rise + 2 * s ** (alpha + 1) * cos ** (p + 1) - (p - 1) * cos**p * s * Y
step(
    "the last term of the mixed rate by parts: (c^(p+1) Y)' with Y' = s^(alpha+1)",
    At(sympy.Derivative(cos ** (p + 1) * Y, theta), {sympy.Derivative(Y, theta): s ** (alpha + 1)}),
    cos ** (p + 1) * s ** (alpha + 1) - (p + 1) * cos**p * s * Y,
)
# with K = int_0^pi s^(alpha+1), J = int_0^pi c^(p+1) s^(alpha+1), and c(pi)^(p+1) = 1: int c^p s Y = (J - K)/(p + 1)
total = -(alpha - 1) * (K - J) / (p + 1) + 2 * J - (p - 1) * I_Y
total = At(total, {I_Y: (J - K) / (p + 1)})
step(
    "the coefficient of e g in L, with I_Y = int c^p s Y = (J - K)/(p+1)",
    total,
    ((p - alpha) * K + (p + 2 + alpha) * J) / (p + 1),
)
step(
    "(p + 2 + alpha) J = p int c^(p-1) s^(alpha+1): the derivative of c^p s^(alpha+2) integrates to 0",
    sympy.Derivative(C**p * (1 - C**2) ** (alpha / 2 + 1), C),
    (p * C ** (p - 1) * (1 - C**2) - (alpha + 2) * C ** (p + 1)) * (1 - C**2) ** (alpha / 2),
)

for a, power, value in (
    (0, 3, 2),
    (1, 3, 11 * sympy.pi / 32),
    (2, 3, sympy.Rational(8, 15)),
    (1, 5, 37 * sympy.pi / 96),
):
    whole = mixed.subs({alpha: a, p: power}).subs(
        Y.subs({alpha: a, p: power}), sympy.integrate(s ** (a + 1), (theta, 0, theta))
    )
    step(f"alpha = {a}, p = {power}: the coefficient itself", sympy.Integral(whole, (theta, 0, sympy.pi)), value)
    integrals = {
        K: sympy.integrate(s ** (a + 1), (theta, 0, sympy.pi)),
        J: sympy.integrate(cos ** (power + 1) * s ** (a + 1), (theta, 0, sympy.pi)),
    }
    step("and by K and J", At(total.doit().subs({alpha: a, p: power}), integrals), value)

apparent = defined("L", lambda strength: -3 * sympy.pi / 8 * strength)  # cubic loss: -pi M_4 epsilon_3
step(
    "viscous loss with the spring c x^3 has the decrements of cubic loss of strength -(11/12) epsilon c",
    apparent(-sympy.Rational(11, 12) * epsilon * c),
    11 * sympy.pi / 32 * epsilon * c,
)
strength = sympy.Symbol("epsilon_3", real=True)
step(
    "that is, solved for its strength,",
    Solution(apparent(strength), 11 * sympy.pi / 32 * epsilon * c, strength),
    -sympy.Rational(11, 12) * epsilon * c,
)
