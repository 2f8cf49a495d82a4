"""The motion within a half-swing, read off quarter-swings at any time: what each of its errors adds.

>>> len(derivation.steps) > 10
True
"""

import sympy

from derivations.steps import At, Derivation

t, x, y, phi, e, p, q, A, b, d = sympy.symbols("t x y phi e p q A b d", positive=True)
J, E0, eta, rate, N, C, g, L = sympy.symbols("J E_0 eta J' N C g L", positive=True)
k, m, n = sympy.symbols("k m n", positive=True, integer=True)

derivation = Derivation(
    "quarter-courses",
    "The motion within a half-swing, off its quarters",
    source="return_map.courses and course; quarter-collocation, quarter-swing-tail; Markov's inequality",
)
step, asserts = derivation.step, derivation.asserts

# 1. Along one quarter.
so_far, far = sympy.Function("J")(t), sympy.exp(J) * (E0 + eta * t)
step(
    "Up to each t the polynomial at a node is off by e^J (E_0 + eta t) at most, J the integral of the rate up to t"
    " (quarter-collocation).  It grows at the rate",
    sympy.Derivative(far.subs(J, so_far), t),
    sympy.exp(so_far) * (sympy.Derivative(so_far, t) * (E0 + eta * t) + eta),
)
asserts(
    "which is not negative, as J' >= 0: what holds at the centre holds on the way",
    sympy.Gt(sympy.exp(J) * (rate * (E0 + eta * t) + eta), 0, evaluate=False),
)

# 2. From strength to strength, at one angle.
step(
    "d ln r/d theta is N/(1 - C) in size, N and C the majorant's (quarter-swing-tail); d tau/d theta - 1 is C/(1 - C):",
    At(x - 1, {x: 1 / (1 - C)}),
    C / (1 - C),
)
asserts(
    "both positive where C < 1, so that their integrals grow with theta and are largest at the centre",
    sympy.Gt(At(C / (1 - C), {C: x / (1 + x)}), 0, evaluate=False),
)
weights = sympy.Rational(1, 2) + sympy.Sum(1, (k, 1, m - 1))
step(
    "Values at m nodes that are off by e: 2 d_0^2 + d_1^2 + ... <= 2 e^2 (chebyshev), so that by Cauchy and Schwarz"
    " (|d_0| + |d_1| + ...)^2 is at most 2 e^2 (1/2 + 1 + ... + 1)",
    2 * e**2 * weights,
    (2 * m - 1) * e**2,
)
asserts(
    "Near miss, e alone: through e and -e at the two nodes +-2^(-1/2) goes e t 2^(1/2), at the end t = 1",
    sympy.Gt(At(e * t / x, {t: 1, x: 1 / sympy.sqrt(2)}), e, evaluate=False),
)

# 3. An uncertain strength.
step(
    "T_l(cos phi) = cos(n phi) changes with cos phi at the rate",
    sympy.Derivative(sympy.cos(n * phi), phi) / sympy.Derivative(sympy.cos(phi), phi),
    n * sympy.sin(n * phi) / sympy.sin(phi),
)
step(
    "|sin(n phi)| <= n |sin phi|: for n = 1, and from n to n + 1 by |cos| <= 1 in",
    sympy.sin((n + 1) * phi),
    At(x * sympy.cos(phi) + y * sympy.sin(phi), {x: sympy.sin(n * phi), y: sympy.cos(n * phi)}),
)
step(
    "so |T_l'| <= n^2 (Markov), which is attained at the end, phi -> 0",
    sympy.Limit(n * sympy.sin(n * phi) / sympy.sin(phi), phi, 0),
    n**2,
)
step(
    "A place that is off by d moves b T_k(t) T_l, |T_k| <= 1, by the integral of that rate at most",
    sympy.Integral(b * n**2, (x, 0, d)),
    b * n**2 * d,
)
step(
    "Near miss, n in place of n^2: T_2 = 2 x^2 - 1 has twice as much at the end x = 1",
    At(sympy.Derivative(2 * x**2 - 1, x), {x: 1}),
    4,
)

# 4. The two quarters of a half-swing from p to q, and an uncertain time.
step(
    "z = A^g at the start becomes (q/p)^g times as large at the end, e^(g L) with L = ln(q/p)",
    At(A**g * sympy.exp(g * L), {L: sympy.log(q / p)}),
    (A * q / p) ** g,
)
w, u, fall, slope = sympy.symbols("w u u' w'", positive=True)
step(
    "u' = -w, w' = u - N(w): u^2 + w^2 changes at the rate",
    At(2 * u * fall + 2 * w * slope, {fall: -w, slope: u - N}),
    -2 * w * N,
)
asserts("which is not positive: |u| and |w| stay below p", sympy.Lt(-2 * w * N, 0, evaluate=False))
step(
    "N grows with w, so that the acceleration is at most p + N(p); in the time d the speed moves by at most",
    sympy.Integral(p + N, (x, 0, d)),
    d * (p + N),
)
asserts(
    "Near miss, the rate p for both: from rest backwards in time the losses add to the spring",
    sympy.Gt(p + N, p, evaluate=False),
)
step(
    "and by so much, f = p + N(p) for each unit of time, u and w differ from those on the way: w adds up to at most",
    sympy.Integral(w + x * (p + N), (x, 0, d)),
    d * w + d**2 * (p + N) / 2,
)
asserts(
    "Near miss, w at t alone: from rest it is 0, and the place moves all the same",
    sympy.Gt(At(d * w + d**2 * (p + N) / 2, {w: 0}), At(d * w, {w: 0}), evaluate=False),
)
