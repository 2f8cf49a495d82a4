"""Lancaster's averaging of two damping terms: from (18) by (12) to the separated equation (20).

>>> len(derivation.steps)
6
"""

import sympy
from sympy import Derivative, Integral, pi

from asymptotics.expansions.moments.symbolic import moment
from derivations.steps import At, Derivation, Solution, named

A, k, b, b_2, omega, s, v, u, x_0, t = sympy.symbols("A k b b' omega_0 s v u x_0 t", positive=True)
c, d = sympy.symbols("c c'", positive=True)
alpha, beta = sympy.symbols("alpha alpha'", positive=True)
M_a, M_b = sympy.symbols("M_(alpha+1) M_(alpha'+1)", positive=True)
r = sympy.Symbol("A'", real=True)

derivation = Derivation(
    "two-laws-average",
    "Two damping terms averaged together",
    source="Lancaster 2020, (18)-(20); lancaster-energy has (8), lancaster-average has (12), two-laws-time goes on",
)
step = derivation.step

power = -(b * v**alpha + b_2 * v**beta) * v
slow = -b * (A * omega) ** (alpha + 1) * s ** (alpha + 1) - b_2 * (A * omega) ** (beta + 1) * s ** (beta + 1)
step(
    "(18): k A A' is the power of both forces, -(b v^alpha + b' v^alpha') v, v = |x'|.  For slow A, |x'| = A omega_0 s,"
    " s = |sin|: (19)",
    At(power, {v: A * omega * s}),
    slow,
)
waves = {s ** (alpha + 1): M_a, s ** (beta + 1): M_b}
step(
    "A is nearly constant over a half-swing, and the mean is linear: of each term by itself, M_p = <|sin|^p>",
    At(slow, waves),
    -b * (A * omega) ** (alpha + 1) * M_a - b_2 * (A * omega) ** (beta + 1) * M_b,
)
half_beta = named("B", sympy.gamma(alpha / 2 + 1) ** 2 / sympy.gamma(alpha + 2))
step(
    "(12): M_(alpha+1) = 2^(alpha+1) B/pi, B = B(alpha/2 + 1, alpha/2 + 1).  So b omega_0^(alpha+1) M_(alpha+1) = c/pi"
    " with c = b (2 omega_0)^(alpha+1) B, and c' likewise",
    b * (2 * omega) ** (alpha + 1) * half_beta / pi,
    At(b * omega ** (alpha + 1) * M_a, {M_a: moment(alpha + 1)}),
)
averaged = -(c * A ** (alpha + 1) + d * A ** (beta + 1)) / pi
step("k A A' = this: A' is", Solution(k * A * r, averaged, r), -(c * A**alpha + d * A**beta) / (pi * k))
speed = sympy.Function("A")(t)
step(
    "Separated: the integral of du/(c u^alpha + c' u^alpha') from x_0 to A(t) changes with t at the rate",
    At(
        Derivative(Integral(1 / (c * u**alpha + d * u**beta), (u, x_0, A)), A) * r,
        {r: -(c * A**alpha + d * A**beta) / (pi * k)},
    ),
    -1 / (pi * k),
)
step(
    "so it is -t/(pi k): (20); it is 0 at t = 0.  One term, alpha > 1, c' = 0, beside (13): dA^(1-alpha)/dt is",
    At(Derivative(A ** (1 - alpha), A) * r, {r: -c * A**alpha / (pi * k)}),
    (alpha - 1) * c / (pi * k),
)
