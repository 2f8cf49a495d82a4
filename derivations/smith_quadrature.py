"""From the constant (38b) to the quadrature (54), (55), and from (69) to the curve of Fig. 5, (72), put right.

>>> print(derivation.steps[4].text())
Subs(V*gamma - omega**2*x, V, V_n(x)) = 2*E_n*gamma*exp(2*gamma*x) + omega**2/(2*gamma)
"""

import sympy
from sympy import Derivative, Limit, Rational, atan, exp, pi, sqrt

from derivations.steps import At, Derivation, Solution, Taylor, defined

gamma, omega, y = sympy.symbols("gamma omega y", positive=True)
x, E, V, v = sympy.symbols("x E_n V v", real=True)
r = sympy.Symbol("r", positive=True)  # |v|
j, n = sympy.symbols("j n", integer=True, positive=True)
t = sympy.Symbol("t", real=True)

derivation = Derivation(
    "smith-quadrature",
    "Smith's quadrature and the curve of his Fig. 5",
    source="Smith 2012, (38b), (54), (55), (69)-(72); smith-generating-functions has (69)",
)
step, asserts = derivation.step, derivation.asserts

radicand = 2 * E * exp(2 * gamma * x) + omega**2 / gamma * (x + 1 / (2 * gamma))
square = defined("V_n", lambda x: 2 * E * exp(2 * gamma * x) + omega**2 / gamma * (x + 1 / (2 * gamma)))
level = exp(-2 * gamma * x) * (V / 2 - omega**2 / (2 * gamma) * (x + 1 / (2 * gamma)))
step(
    "(38b) on a half-cycle with v < 0: S^- = e^(-2 gamma x) [v^2/2 - omega^2/(2 gamma) (x + 1/(2 gamma))] = E_n gives"
    " V = v^2: with omega^2/gamma, where (54) and (55) print omega^2/(2 gamma)",
    Solution(level, E, V),
    radicand,
)
step(
    "Near miss: with the printed factor the level changes with x, by",
    Derivative(At(level, {V: radicand - omega**2 / (2 * gamma) * (x + 1 / (2 * gamma))}), x),
    omega**2 * x * exp(-2 * gamma * x) / 2,
)
acceleration = sympy.Function("a")(x)
step(
    "It is the motion of the law: (v^2)'/2 by x is the acceleration gamma v^2 - omega^2 x",
    Derivative(square(x), x) / 2,
    At(gamma * V - omega**2 * x, {V: square(x)}),
)
step(
    "(54): dx = v dt with v < 0, so dt/dx has the minus sign; (55), over |dx|, has the positive one",
    1 / At(v, {v: -sqrt(square(x))}),
    -1 / sqrt(square(x)),
    corrects=("smith2012:54", "smith2012:55"),
)

# (69) -> (72): v = -r, r = sqrt(V_n).
step(
    "(72) is (69) with v_n(x): the denominator of its arctangent",
    At(gamma * V - omega**2 * x, {V: square(x)}),
    2 * gamma * E * exp(2 * gamma * x) + omega**2 / (2 * gamma),
)
below = (
    4 * gamma**2 * E**2 * exp(4 * gamma * x)
    + 4 * omega**2 * E * exp(2 * gamma * x)
    + omega**4 * x / gamma
    + 3 * omega**4 / (4 * gamma**2)
)
step(
    "the square of it and omega^2 v^2 together: 2 omega^2 E_n e^(2 gamma x) comes from each, so 4, where (72) prints 3",
    At(omega**2 * V + (gamma * V - omega**2 * x) ** 2, {V: square(x)}),
    below,
)
time = atan(omega * v / y) + 2 * omega * gamma * v**3 / (3 * (omega**2 * v**2 + y**2))
step(
    "and both terms of (69), omega t = arctan(omega v/y) + (2/3) omega gamma v^3/(omega^2 v^2 + y^2), y = gamma v^2 -"
    " omega^2 x, change sign with v = -r: 0 = omega t + arctan(...) + (2/3)(...)",
    At(time, {v: -r}),
    -atan(omega * r / y) - 2 * omega * gamma * r**3 / (3 * (omega**2 * r**2 + y**2)),
)
step(
    "The arctangent: from rest at x_n > 0 y < 0 and omega v/y = omega r/|y| grows from 0; as |y| falls to 0, to",
    Limit(atan(omega * r / y), y, 0, "+"),
    pi / 2,
)
step(
    "and beyond, y > 0, it comes from -pi/2: there pi is added, and omega t goes on without a jump,",
    Limit(atan(omega * r / y), y, 0, "+") - Limit(atan(-omega * r / y), y, 0, "+"),
    pi,
)
step("to omega t = pi at the end, where v = 0: (70), the half period to this order", At(pi + time, {v: 0}), pi)
step(
    "(71): n half-cycles, numbered from 0 as E_n and u_n are, are over when half-cycle n begins, at t =",
    sympy.Sum(pi / omega, (j, 0, n - 1)),
    n * pi / omega,
    corrects=("smith2012:71",),
)
small = sympy.Symbol("lambda", positive=True)
step(
    "How good (69) is: d(omega t)/dt along the motion is 1 but for terms of the second order in lambda, v = lambda V,"
    " x = lambda x: through lambda",
    Taylor(
        At(
            (v * Derivative(time.subs(y, gamma * v**2 - omega**2 * x), x)
             + (gamma * v**2 - omega**2 * x) * Derivative(time.subs(y, gamma * v**2 - omega**2 * x), v)),
            {v: small * V, x: small * x},
        ),
        small,
        1,
    ),
    omega,
)  # fmt: skip
whole = At(At(time, {v: -r, y: gamma * V - omega**2 * x}), {V: square(x), r: sqrt(square(x))})
step(
    "(72) in one: the right side of (69), arctan(...) + (2/3)(...) with v = -r, y and V_n put in, is, less the"
    " arctangent,",
    whole
    - At(atan(-omega * r / y), {y: 2 * gamma * E * exp(2 * gamma * x) + omega**2 / (2 * gamma), r: sqrt(square(x))}),
    -2 * gamma * omega * square(x) ** Rational(3, 2) / (3 * below),
    corrects=("smith2012:72",),
)
