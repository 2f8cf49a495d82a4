"""Smith's two constants of the harmonic oscillator: how far they can be inverted, the factor of T-hat, and (31).

>>> print(derivation.steps[8].text())
D(atan(omega*x/v)) = omega
"""

import sympy
from sympy import Derivative, Limit, atan, oo, pi

from derivations.steps import At, Derivation, Solution, defined

x, v = sympy.symbols("x v", real=True)
m, omega, t, s, r, N, V = sympy.symbols("m omega t s r N V", positive=True)
z = sympy.Symbol("z", real=True)
j = sympy.Symbol("j", integer=True, nonnegative=True)

derivation = Derivation(
    "smith-harmonic",
    "Two constants of the harmonic oscillator, and the angle between them",
    source="Smith 2012, below (2), (21), (22), (26)-(31)",
)
step, asserts = derivation.step, derivation.asserts

D = defined("D", lambda f: Derivative(f, t) + v * Derivative(f, x) - omega**2 * x * Derivative(f, v))
S = defined("S", lambda x, v: m * v**2 / 2 + m * omega**2 * x**2 / 2)
T = defined("T", lambda x, v: omega * t - atan(omega * x / v))

step("x'' = -omega^2 x; D is d/dt along the motion.  S of (26), the energy, is constant: D(S)", D(S(x, v)), 0)
step("and T of (28), omega t less the angle of the state: D(T)", D(T(x, v)), 0)
step(
    "They are independent: the determinant of their derivatives by x and v is nowhere 0, so locally they give x and v",
    Derivative(S(x, v), x) * Derivative(T(x, v), v) - Derivative(S(x, v), v) * Derivative(T(x, v), x),
    m * omega,
)
step(
    "but not as a whole: (-x, -v) has the same S and the same T, as the arctangent is an angle modulo pi",
    sympy.Tuple(At(S(x, v), {x: -x, v: -v}), At(T(x, v), {x: -x, v: -v})),
    sympy.Tuple(S(x, v), T(x, v)),
    corrects=("smith2012:claim.inversion",),
)
step(
    "and no third one has: where x = s v, which T says, S = m V^2 (1 + omega^2 s^2)/2 has v = V and v = -V alone",
    Solution(At(S(x, v), {x: s * v}), At(S(x, v), {x: s * V, v: V}), v, sign=-1),
    -V,
)

# The series (21) of the time in 1/v, one integration by parts after the other.
F = defined("F", lambda j: (-1) ** j * omega ** (2 * j) * x ** (2 * j + 1) / (2 * j + 1))
E = defined("E", lambda j: (-1) ** j * (omega * x / v) ** (2 * j))
step(
    "(21): F_n of odd n = 2j + 1 is (-1)^j omega^(2j) x^(2j+1)/(2j+1), those of even n are 0.  The rate of F_n/v^n is a"
    " difference, with E_j = (-1)^j (omega x/v)^(2j):",
    D(F(j) / v ** (2 * j + 1)),
    E(j) - E(j + 1),
)
step("so the sum from j = 0 to N has the rate E_0 - E_(N+1), where E_0 is", At(E(j), {j: 0}), 1)
step(
    "and E_(N+1) tends to 0 for omega |x| < |v|, the quotient being 1/(1 + r): the series is a time, up to a constant",
    Limit((1 + r) ** (-2 * N), N, oo),
    0,
)
step(
    "and the angle, T-hat = arctan(omega x/v), is omega times that time: its rate is",
    D(atan(omega * x / v)),
    omega,
    corrects=("smith2012:claim.hat-T",),
)
step(
    "Near miss: without the factor omega, omega t less the series has the rate",
    D(omega * t - atan(omega * x / v) / omega),
    omega - 1,
)

# (31): the two ways to write the angle.
step(
    "(31): arctan z and -arctan(1/z) have the same derivative; that of the sum", Derivative(atan(z) + atan(1 / z), z), 0
)
asserts(
    "so the sum is constant on each side of 0, and not the same constant: pi/2 for z > 0, -pi/2 for z < 0",
    sympy.Eq(At(atan(z) + atan(1 / z), {z: 1}), pi / 2, evaluate=False),
    sympy.Eq(At(atan(z) + atan(1 / z), {z: -1}), -pi / 2, evaluate=False),
    corrects=("smith2012:31",),
)
step(
    "Near miss: with -pi/2 on both sides, as printed, the two members would differ at z = 1 by",
    At(atan(z) - (-pi / 2 - atan(1 / z)), {z: 1}),
    pi,
)
step("From z < 0 to z > 0 the sum jumps by", Limit(atan(1 / z), z, 0, "+") - Limit(atan(1 / z), z, 0, "-"), pi)
