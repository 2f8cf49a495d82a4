"""What the conditions beside Lancaster's (13) ask: a start from rest, slow, an exponent, kappa itself, a real swing.

>>> print(derivation.steps[2].text())
Subs(A*omega_0/(2*pi*r), r, A*eta*omega_0) = 1/(2*pi*eta)
"""

import sympy
from sympy import Derivative, Integral, Limit, Rational, cos, exp, oo, pi

from asymptotics.expansions.moments.symbolic import moment
from derivations.steps import At, Derivation, defined

b, k, m, x_0, t, kappa, eta, r, s = sympy.symbols("b k m x_0 t kappa eta r s", positive=True)
omega, A, v, p, n, epsilon = sympy.symbols("omega_0 A v p n epsilon", positive=True)
alpha = sympy.Symbol("alpha", positive=True)
M = sympy.Symbol("M", positive=True)

derivation = Derivation(
    "lancaster-conditions",
    "What the conditions of the averaged amplitude ask",
    source="Lancaster 2020, below (2), (5), (13), (15), (17) and Table I; lancaster-energy has (13)-(15)",
)
step, asserts = derivation.step, derivation.asserts

amplitude = defined("A", lambda t: x_0 * (1 + (alpha - 1) * kappa * omega * t) ** (-1 / (alpha - 1)))
step(
    "x = A(t) cos(omega_0 t) with A of (13) and phi(0) = 0 does not start from rest: x'(0) is A'(0),",
    At(Derivative(amplitude(t) * cos(omega * t), t), {t: 0}),
    -kappa * omega * x_0,
    corrects=("lancaster2020:claim.phase-at-start",),
)
step("Near miss: to lowest order, A not differentiated, it does", At(A * Derivative(cos(omega * t), t), {t: 0}), 0)

step(
    "Slow: let |A'| = r = eta omega_0 A, eta << 1.  A/|A'|, in periods of length 2 pi/omega_0, is not 1/eta but",
    At(A / r / (2 * pi / omega), {r: eta * omega * A}),
    1 / (2 * pi * eta),
    corrects=("lancaster2020:claim.slow-timescale",),
)
step(
    "At a constant rate r the loss in one period is 2 pi r/omega_0: for r = eta omega_0 A, in units of A,",
    Integral(At(r / A, {r: eta * omega * A}), (t, 0, 2 * pi / omega)),
    2 * pi * eta,
    corrects=("lelas2024:claim.slight-decrease",),
)
left = defined("q", lambda eta: exp(-2 * pi * eta))
step(
    "at a constant r/A what is left after one is e^(-2 pi eta)",
    At(exp(-eta * omega * t), {t: 2 * pi / omega}),
    left(eta),
)
asserts(
    "so eta = 1/10 is not slow against the period: little more than half is left",
    sympy.Gt(left(Rational(1, 10)), Rational(53, 100), evaluate=False),
    sympy.Lt(left(Rational(1, 10)) - Rational(54, 100), 0, evaluate=False),
)

asserts(
    "The exponents: as a mass comes to rest the force b v^alpha tends to 0 for alpha = p > 0, to b for alpha = 0, so it"
    " starts, there if k x_0 > b.  For alpha = -n < 0 it grows beyond every spring: there is no start from rest",
    sympy.Eq(Limit(b * v**p, v, 0, "+"), 0, evaluate=False),
    sympy.Eq(Limit(b * v**0, v, 0, "+"), b, evaluate=False),
    sympy.Eq(Limit(b * v**-n, v, 0, "+"), oo, evaluate=False),
    corrects=("lancaster2020:claim.any-exponent",),
)
step(
    "The mean in (11) is finite further down, for alpha + 2 = p > 0: near a zero |sin|^(alpha+1) = s^(p-1)",
    Integral(s ** (p - 1), (s, 0, 1)),
    1 / p,
)

rate = defined("r", lambda t: kappa * omega / (1 - n * kappa * omega * t))
step(
    "(17), alpha = 1 - n: the rate |A'|/A of (13) has kappa in both places,",
    -At(Derivative(amplitude(t), t), {alpha: 1 - n}) / At(amplitude(t), {alpha: 1 - n}),
    rate(t),
)
step(
    "kappa = M epsilon, M = M_(alpha+1) < 1.  With epsilon for it the printed rate has no value at n epsilon omega_0 t"
    " = 1, where the true one is still of the order of kappa omega_0:",
    At(rate(1 / (n * epsilon * omega)), {kappa: M * epsilon}),
    M * epsilon * omega / (1 - M),
    corrects=("lancaster2020:17",),
)
step(
    "alpha = 0, M = 2/pi: 2.75 kappa omega_0",
    1 / (1 - At(moment(alpha + 1), {alpha: 0})),
    pi / (pi - 2),
)
step(
    "Table I at alpha = 3: (13) with kappa = M_4 b omega_0^3 x_0^2/k, k = m omega_0^2; omega_0^2/m is k/m^2",
    At(amplitude(t), {alpha: 3, kappa: moment(4) * b * omega * k * x_0**2 / (k * m)}),
    x_0 / sympy.sqrt(1 + Rational(3, 4) * b * omega**2 * x_0**2 * t / m),
    corrects=("lancaster2020:table1.alpha3",),
)

# That A(t) cos(omega_0 t) oscillates does not say that the motion does: alpha = 1, epsilon = 5/2, tau = omega_0 t.
motion = defined("X", lambda t: (4 * exp(-t / 2) - exp(-2 * t)) / 3)
step(
    "alpha = 1, epsilon = 5/2, t in units of 1/omega_0: X = (4 e^(-t/2) - e^(-2t))/3 obeys X'' + (5/2) X' + X = 0",
    Derivative(motion(t), t, 2) + Rational(5, 2) * Derivative(motion(t), t) + motion(t),
    0,
)
step(
    "and starts from rest at 1",
    sympy.Tuple(At(motion(t), {t: 0}), At(Derivative(motion(t), t), {t: 0})),
    sympy.Tuple(1, 0),
)
asserts(
    "It never passes 0: 3 e^(2t) X = 4 e^(3t/2) - 1, where e^(3t/2) = 1 + r, r > 0.  A cos(omega_0 t) has its zeros for"
    " every A: what the ansatz puts in is not found",
    sympy.Gt(At(4 * s - 1, {s: 1 + r}), 0, evaluate=False),
    corrects=("lancaster2020:claim.corollary",),
)
