"""Any power of the velocity: the sign that a force needs, (54) and its zeros, and the trick for two amplitudes.

>>> print(derivation.steps[2].text())
Subs(-V*V**(2*j), V, -v) = v**(2*j + 1)
"""

import sympy
from sympy import Integral, Limit, pi, sin

from derivations.steps import At, Derivation, Solution, defined

v, m, omega, theta, C, K = sympy.symbols("v m omega_0 theta C K", positive=True)
A, B, f, s, c = sympy.symbols("A_0 B_0 f s c", positive=True)
n = sympy.Symbol("n", integer=True, nonnegative=True)
j = sympy.Symbol("j", integer=True, nonnegative=True)
V = sympy.Symbol("V", real=True)

derivation = Derivation(
    "lelas-powers",
    "The squaring trick for the three powers at once",
    source="Lelas 2024, (38), (39), (53)-(55) and the discussion of section VII",
)
step = derivation.step

force = defined("F", lambda V: -sympy.sign(V) * abs(V) ** n)
step(
    "A force against the motion, F(v) = -sgn(v) |v|^n: its power F v at v > 0",
    At(force(V) * V, {V: v}),
    -(v ** (n + 1)),
)
step(
    "and at -v, the same: it takes energy at both signs",
    At(force(V) * V, {V: -v}),
    -(v ** (n + 1)),
    corrects=("lelas2024:claim.force-powers",),
)
step(
    "Near miss: v^n without the sign, n = 2j.  Its power at -v would drive the block,",
    At(-V * V ** (2 * j), {V: -v}),
    v ** (2 * j + 1),
)
step("while for n = 2j + 1 it is the same as at v", At(-V * V ** (2 * j + 1), {V: -v}), -(v ** (2 * j + 2)))
step(
    "-v^(n+1)/|v| for n = 2j is F, at -v and at v,",
    sympy.Tuple(*(At(-(V ** (2 * j + 1)) / abs(V), {V: side}) for side in (-v, v))),
    sympy.Tuple(*(At(force(V), {V: side, n: 2 * j}) for side in (-v, v))),
)
step(
    "but has no value at v = 0: for n = 0, friction, the limits from the two sides are apart by",
    Limit(-V / abs(V), V, 0, "+") - Limit(-V / abs(V), V, 0, "-"),
    -2,
    corrects=("lelas2024:claim.force-without-sign",),
)
step(
    "for n = 2 both are the value of F there",
    sympy.Tuple(*(Limit(-(V**3) / abs(V), V, 0, side) for side in "+-")),
    sympy.Tuple(0, 0),
)

# (54): x = A_0 f cos(omega_0 t + phi_0), s = |sin|; C times F is the force.
power = -C * (A * omega * f * s) ** (n + 1)
step(
    "(54): with v = -A_0 omega_0 f sin(...) the power C F v is, whatever the sign of the sine, s = |sin|,",
    sympy.Tuple(*(At(C * force(V) * V, {V: sign * A * omega * f * s}) for sign in (-1, 1))),
    sympy.Tuple(power, power),
    corrects=("lelas2024:54",),
)
step(
    "Near miss: without the modulus, n = 2j, f would grow while the sine is negative: -(sin)^(n+1) at sin = -s,",
    At(-(V ** (2 * j + 1)), {V: -s}),
    s ** (2 * j + 1),
)
rate = sympy.Symbol("f'", real=True)
step(
    "It is the rate m omega_0^2 A_0^2 f f' of (53): f' is",
    Solution(m * omega**2 * A**2 * f * rate, power, rate),
    -C * omega ** (n - 1) / m * A ** (n - 1) * f**n * s ** (n + 1),
)
loss = defined("R", lambda size, wave: K * size ** (n - 1) * f**n * wave ** (n + 1))
step(
    "With K = C omega_0^(n-1)/m, |f'| is 0 twice a period, at each zero of the sine, so for no power positive at all t",
    At(loss(A, s), {s: sin(pi * j)}),
    0,
    corrects=("lelas2024:claim.both-sides-positive",),
)
step(
    "n = 2 averaged: the integral of sin^3 over a period is 0, that of |sin|^3 is not",
    sympy.Tuple(
        Integral(sin(theta) ** 3, (theta, 0, 2 * pi)),
        Integral(sin(theta) ** 3, (theta, 0, pi)) - Integral(sin(theta) ** 3, (theta, pi, 2 * pi)),
    ),
    sympy.Tuple(0, sympy.Rational(8, 3)),
    corrects=("lelas2024:claim.integral-of-sin-cubed",),
)

# The second pair: B_0 for A_0 and the cosine for the sine, c = |cos|.
root = 2 / (n + 1)
step(
    "Two amplitudes: each |f'|^(2/(n+1)), over its own A_0^(2(n-1)/(n+1)), has K f^n in common",
    sympy.Tuple(*(size ** (-root * (n - 1)) * loss(size, wave) ** root for size, wave in ((A, s), (B, c)))),
    sympy.Tuple(*((K * f**n) ** root * wave**2 for wave in (s, c))),
)
step(
    "and the sum is free of t, for any A_0 and B_0",
    At((K * f**n) ** root * (s**2 + c**2), {c: sympy.sqrt(1 - s**2)}),
    (K * f**n) ** root,
)
step(
    "What a pair has at last is the rate K 2^(-(n+1)/2) A_0^(n-1) f^n; the quotient of the two: for n = 0, 1, 2",
    sympy.Tuple(*(At(loss(A, 1) / loss(B, 1), {n: number}) for number in (0, 1, 2))),
    sympy.Tuple(B / A, 1, A / B),
    corrects=("lelas2024:claim.equal-amplitudes",),
)
step(
    "so one f for both needs A_0 = B_0 for n = 0",
    Solution(At(loss(A, 1), {n: 0}), At(loss(B, 1), {n: 0}), A),
    B,
)
step("and for n = 2", Solution(At(loss(A, 1), {n: 2}), At(loss(B, 1), {n: 2}), A), B)
