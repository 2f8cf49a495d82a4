"""Equivalent damping: what a power law loses in a cycle, in the words of a linear oscillator.

>>> print(derivation.steps[9].text())
Solution(Eq(A**2*k*x, 2*pi*A**2*k*zeta), x) = 2*pi*zeta
"""

import sympy

from asymptotics.expansions.moments.symbolic import mean
from derivations.steps import At, Derivation, Solution

m, k, b, c, A, u, x = sympy.symbols("m k b c A u x", positive=True)
alpha = sympy.Symbol("alpha", nonnegative=True)
place = sympy.Symbol("n", integer=True, nonnegative=True)
theta, a = sympy.symbols("theta a", positive=True)
zeta, Lambda, w, kappa, eta = sympy.symbols("zeta Lambda w kappa eta", positive=True)
omega = sympy.sqrt(k / m)
sin, cos, pi, HALF = sympy.sin, sympy.cos, sympy.pi, sympy.Rational(1, 2)
C, S = sympy.symbols("C S", positive=True)

derivation = Derivation(
    "equivalent-damping",
    "Equivalent damping of a power law",
    source="asymptotics.equivalent: the energy of one cycle without loss, m x'' + k x + b |x|^n x'|x'|^(alpha-1) = 0",
)
step = derivation.step

speed, path = sympy.symbols("v x_", positive=True)
step(
    "the power b |x|^n |v|^(alpha+1) with x = A cos(theta), v = -A omega sin(theta), dt = d theta/omega, on a quarter",
    At(
        b * path**place * speed ** (alpha + 1) / omega,
        {path: A * C, speed: A * omega * S},
    ),
    sympy.powsimp(
        b * A ** (place + alpha + 1) * omega**alpha * C ** place
        * S ** (alpha + 1)
    ),
)  # fmt: skip
for power, n in ((0, 0), (1, 0), (2, 0), (3, 0), (1, 2), (2, 1)):
    step(
        f"four quarters are 2 pi <|cos|^n |sin|^(alpha+1)>: alpha = {power}, n = {n}",
        4 * sympy.Integral(cos(theta) ** n * sin(theta) ** (power + 1), (theta, 0, pi / 2)),
        2 * pi * mean(n, power + 1),
    )
M, drop, energy = sympy.symbols("M DeltaE E", positive=True)
lost = 2 * pi * M * b * omega**alpha * A ** (place + alpha + 1)
step(
    "zeta = Delta E/(4 pi E), E = k A^2/2",
    At(drop / (4 * pi * energy), {drop: lost, energy: k * A**2 / 2}),
    M * b * omega**alpha * A ** (place + alpha - 1) / k,
)
step(
    "viscous: M = 1/2, so zeta = b/(2 sqrt(k m))",
    At(lost / (2 * pi * k * A**2), {M: HALF, alpha: 1, place: 0}),
    b / (2 * sympy.sqrt(k * m)),
)
step(
    "d ln A over a cycle: k A dA = -Delta E, which is 2 pi zeta",
    Solution(k * A * (x * A), 2 * pi * k * A**2 * zeta, x),
    2 * pi * zeta,
)
step(
    "closed integral of v dx = int v^2 dt: a viscous c takes c pi omega A^2 in a cycle",
    sympy.Integral((A * omega * sin(theta)) ** 2 / omega, (theta, 0, 2 * pi)),
    pi * omega * A**2,
)
step(
    "so c_eq = Delta E/(pi omega A^2) = 2 zeta sqrt(k m)",
    Solution(pi * omega * A**2 * x, 2 * pi * k * A**2 * zeta, x),
    2 * zeta * sympy.sqrt(k * m),
)
decay = 2 * pi * zeta / sympy.sqrt(1 - zeta**2)
step(
    "the decrement of the linear oscillator, 2 pi zeta/sqrt(1 - zeta^2), solved for zeta^2",
    Solution(Lambda**2 * (1 - x), 4 * pi**2 * x, x),
    Lambda**2 / (4 * pi**2 + Lambda**2),
)
step("and back", At(Lambda**2 / (4 * pi**2 + Lambda**2), {Lambda: decay}), zeta**2)
step(
    "half-life of one loss, dA/d tau = -zeta A with zeta = kappa A^w: int from A/2 to A",
    sympy.Integral(a ** (-w - 1) / kappa, (a, A / 2, A)),
    (2**w - 1) / (w * kappa * A**w),
)
step("viscous: w -> 0", sympy.Limit((2**w - 1) / (w * kappa * A**w), w, 0), sympy.log(2) / kappa)
two = sympy.log((kappa + eta * a**w) / a**w) / (w * kappa)
step(
    "two losses, one of degree 1: 1/(kappa a + eta a^(w+1)) is minus the derivative of ln(kappa a^-w + eta)/(w kappa)",
    -sympy.Derivative(two, a),
    1 / (kappa * a + eta * a ** (w + 1)),
)
p = 3
V = x**2 / 2 + c * x ** (p + 1) / (p + 1)
g = 1 + x + 2 * c / (p + 1) * sum(x**j for j in range(p + 1))
step(
    "beside a spring c x^3, x = 1 - u^2: v^2 = 2 (V(1) - V(x)) = u^2 g(x)",
    At(2 * (V.subs(x, 1) - V) / (1 - x), {x: 1 - u**2}),
    At(g, {x: 1 - u**2}),
)
q = sympy.Symbol("q", positive=True)
step(
    "beside the pendulum 1 + x carries two factors sin(y)/y, y = q (1 + x)/2 and q (1 - x)/2",
    2 * (cos(q * x) - cos(q)) / q**2 / (1 - x),
    (1 + x) * sin(q * (1 + x) / 2) / (q * (1 + x) / 2) * sin(q * (1 - x) / 2) / (q * (1 - x) / 2),
)
step(
    "dx = -2 u du: |x|^n |v|^alpha dx over a quarter is 2 x^n u^(alpha+1) g^(alpha/2) du",
    At(path**place * speed**alpha * 2 * u, {speed: u * sympy.sqrt(sympy.Symbol("g", positive=True))}),
    2 * path**place * u ** (alpha + 1) * sympy.Symbol("g", positive=True) ** (alpha / 2),
)
