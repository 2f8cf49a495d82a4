"""Multiple scales for X'' + X + eps X'^3 = 0 by hand, to third order, and what goes wrong if slow derivatives commute.

The vector fields D_n = f_n d/da + g_n d/d psi are applied as written; nothing comes from ``asymptotics``.

>>> rates[3]                                       # (D_3 a, D_3 psi)
(-351*a**7/8192, 0)
>>> commuting_rate                                 # with 2 D_2 D_1 in the place of D_1 D_2 + D_2 D_1
-567*a**7/8192
"""

import sympy
from sympy import cos, sin

from derivations.steps import Derivation, defined, named

a, eps = sympy.symbols("a epsilon", positive=True)
psi = sympy.Symbol("psi", real=True)
R = sympy.Rational
Field = tuple[sympy.Expr, sympy.Expr]

derivation = Derivation(
    "multiple-scales-cubic",
    "Multiple scales for cubic damping to third order",
    source="Nayfeh's scheme with T_0, ..., T_3; Lancaster 2020 stops at first order; the commuting slip is oscilate's",
)
step = derivation.step


def D(field: Field, f: sympy.Expr) -> sympy.Expr:
    """(D_n a) df/da + (D_n psi) df/d psi."""
    return sympy.expand(field[0] * sympy.diff(f, a) + field[1] * sympy.diff(f, psi))


def harmonics(f: sympy.Expr) -> sympy.Expr:
    """A trigonometric polynomial as a sum of sin m psi and cos m psi."""
    q = sympy.Symbol("q")
    exponential = sympy.expand(f.subs({sin(psi): (q - 1 / q) / (2 * sympy.I), cos(psi): (q + 1 / q) / 2}))
    found = 0
    for m in range(12):
        plus, minus = exponential.coeff(q, m), exponential.coeff(q, -m)
        found += plus if m == 0 else (plus + minus) * cos(m * psi) + sympy.I * (plus - minus) * sin(m * psi)
    return sympy.expand(found)


def in_first_harmonic(f: sympy.Expr) -> sympy.Expr:
    """sin m psi, cos m psi for m > 1 as polynomials in sin psi, cos psi."""
    return sympy.expand(sympy.expand_trig(f))


def secular(f: sympy.Expr) -> Field:
    """The coefficients of sin psi and cos psi."""
    resolved = harmonics(in_first_harmonic(f))
    return resolved.coeff(sin(psi)), resolved.coeff(cos(psi))


def solve(f: sympy.Expr) -> sympy.Expr:
    """x with x'' + x = f without first harmonic, from a sum of harmonics m > 1."""
    resolved = harmonics(in_first_harmonic(f))
    waves = [w(m * psi) for m in range(2, 12) for w in (sin, cos)]
    return sum((resolved.coeff(w) * w / (1 - R(w.args[0] / psi) ** 2) for w in waves), sympy.S.Zero)


rates: list[Field] = [(sympy.S.Zero, sympy.S.One)]
X = [a * cos(psi)]

# Order 1.
step("Order 0: X_0 = a cos psi", sympy.Derivative(X[0], psi, 2) + X[0], sympy.S.Zero)
V = [sympy.diff(X[0], psi)]
f, g = sympy.symbols("f g")
pair = sympy.Tuple
D_0, D_n = defined("D_0", lambda h: D(rates[0], h)), defined("D_n", lambda h: D((f, g), h))
D_1, D_2 = defined("D_1", lambda h: D(rates[1], h)), defined("D_2", lambda h: D(rates[2], h))
X_0, V_0, phase = named("X_0", X[0]), named("V_0", V[0]), named("psi", psi)
step(
    "Any D_n = f d/da + g d/d psi enters order n by D_0 D_n + D_n D_0 on X_0, and -(...) is the secular handle",
    -(D_0(D_n(X_0)) + D_n(V_0)),
    2 * f * sin(psi) + 2 * a * g * cos(psi),
)
right = -(V[0] ** 3)
step("Order 1: -V_0^3", -(V_0**3), R(3, 4) * a**3 * sin(psi) - R(1, 4) * a**3 * sin(3 * psi))
rates.append((-secular(right)[0] / 2, -secular(right)[1] / (2 * a)))
step("Solvability", pair(D_1(a), D_1(phase)), pair(-R(3, 8) * a**3, 0))
X.append(solve(right))
X_1 = named("X_1", X[1])
step(
    "The first wave X_1, found by undetermined coefficients, leaves what is not secular",
    sympy.Derivative(X[1], psi, 2) + X[1],
    -R(1, 4) * a**3 * sin(3 * psi),
)

# Order 2.
V.append(D(rates[0], X[1]) + D(rates[1], X[0]))
V_1 = named("V_1", V[1])
step("Its velocity", D_0(X_1) + D_1(X_0), R(3, 32) * a**3 * cos(3 * psi) - R(3, 8) * a**3 * cos(psi))
right = -D(rates[1], D(rates[1], X[0])) - 2 * D(rates[1], D(rates[0], X[1])) - 3 * V[0] ** 2 * V[1]
step(
    "Order 2: -D_1 D_1 X_0 - (D_0 D_1 + D_1 D_0) X_1 - 3 V_0^2 V_1",
    -D_1(D_1(X_0)) - D_0(D_1(X_1)) - D_1(D_0(X_1)) - 3 * V_0**2 * (D_0(X_1) + D_1(X_0)),
    a**5 * (-R(9, 128) * cos(psi) - R(27, 128) * cos(3 * psi) + R(9, 128) * cos(5 * psi)),
)
rates.append((-secular(right)[0] / 2, -secular(right)[1] / (2 * a)))
step("Solvability, in the gauge no-first-harmonic", pair(D_2(a), D_2(phase)), pair(0, R(9, 256) * a**4))
X.append(solve(right))
step(
    "The second wave X_2",
    sympy.Derivative(X[2], psi, 2) + X[2],
    a**5 * (-R(27, 128) * cos(3 * psi) + R(9, 128) * cos(5 * psi)),
)

# Order 3.
V.append(D(rates[0], X[2]) + D(rates[1], X[1]) + D(rates[2], X[0]))
step(
    "The slow derivatives do not commute",
    pair(D_1(D_2(phase)), D_2(D_1(phase))),
    pair(-R(27, 512) * a**6, 0),
)
rest = (
    -2 * D(rates[1], D(rates[0], X[2]))
    - D(rates[1], D(rates[1], X[1]))
    - 2 * D(rates[2], D(rates[0], X[1]))
    - 3 * V[0] ** 2 * V[2]
    - 3 * V[0] * V[1] ** 2
)
one_two, two_one = D(rates[1], D(rates[2], X[0])), D(rates[2], D(rates[1], X[0]))
step("so D_1 D_2 X_0 and D_2 D_1 X_0 differ by", D_1(D_2(X_0)) - D_2(D_1(X_0)), R(27, 512) * a**7 * sin(psi))
right = rest - one_two - two_one
rates.append((-secular(right)[0] / 2, -secular(right)[1] / (2 * a)))
D_3 = defined("D_3", lambda h: D(rates[3], h))
step(
    "Solvability at order 3 with D_1 D_2 + D_2 D_1",
    pair(D_3(a), D_3(phase)),
    pair(-R(351, 8192) * a**7, 0),
)
X.append(solve(right))


def first(f: sympy.Expr, wave: sympy.Expr) -> sympy.Expr:
    """The Fourier coefficient of a first harmonic: the mean of f times it, doubled."""
    return sympy.Integral(f * wave, (psi, 0, 2 * sympy.pi)) / sympy.pi


step("X_3 has no first harmonic", sympy.Add(*(first(named("X_3", X[3]), wave(psi)) for wave in (sin, cos))), 0)


def residual(third: sympy.Expr) -> sympy.Expr:
    """The coefficient of eps^3 in D^2 X + X + eps (D X)^3, D = sum eps^n D_n, with D_3 a = ``third``."""
    total: Field = (
        sum((eps**n * r[0] for n, r in enumerate(rates[:3])), eps**3 * third),
        sum((eps**n * r[1] for n, r in enumerate(rates[:3])), sympy.S.Zero),
    )
    x = sum(eps**n * term for n, term in enumerate(X))
    velocity = truncated(D(total, x))
    return harmonics(in_first_harmonic(truncated(D(total, velocity) + x + eps * velocity**3).coeff(eps, 3)))


def truncated(f: sympy.Expr) -> sympy.Expr:
    """Through eps^3."""
    expanded = sympy.expand(f)
    return sum((eps**n * expanded.coeff(eps, n) for n in range(4)), sympy.S.Zero)


defect = defined("R", residual)
step("Proof without any hierarchy: the residual R(D_3 a) of X in the equation at eps^3", defect(rates[3][0]), 0)

# The near miss: derivatives taken as commuting.
commuting_rate = -secular(rest - 2 * two_one)[0] / 2
other_rate = -secular(rest - 2 * one_two)[0] / 2
bracket = first(R(27, 512) * a**7 * sin(psi), sin(psi))  # of D_1 D_2 X_0 - D_2 D_1 X_0, above
step(
    "With 2 D_2 D_1 the solvability condition gives another D_3 a, less by half the first harmonic of the commutator",
    D_3(a) - bracket / 2,
    -R(567, 8192) * a**7,
)
step("with 2 D_1 D_2 a third one", D_3(a) + bracket / 2, -R(135, 8192) * a**7)
step(
    "and the right value is their mean",
    sympy.Add(-R(567, 8192) * a**7, -R(135, 8192) * a**7, evaluate=False) / 2,
    D_3(a),
)
step(
    "The published -567/8192 with this waveform is refuted: the residual at eps^3 is",
    defect(-R(567, 8192) * a**7),
    R(27, 512) * a**7 * sin(psi),
)
step("-351/8192 stands", defect(-R(351, 8192) * a**7), 0)
