"""From the quadrature (56a) to the recurrence (59) of f_n, and the first polynomials (60).

On the falling half-swing D = w^2 - u is the acceleration dw/dtau and z = w/D.

>>> polynomials[3]
8*w**2/15 - 1/3
"""

import sympy

from derivations.steps import At, Derivation, Taylor, defined

u, w, z = sympy.symbols("u w z", real=True)
n = sympy.Symbol("n", integer=True, positive=True)
f, df, g, dg, h = sympy.symbols("f_n f_n' f_{n-1} f_{n-1}' f_{n-2}")

derivation = Derivation(
    "smith-time-series",
    "The time as a power series in z = w/(w^2 - u)",
    source="Smith 2012, (56a)-(60g); smith2012:56a ... 60g",
)
step = derivation.step


def rate(expression: sympy.Expr) -> sympy.Expr:
    """d/dtau along the falling motion, u' = w and w' = w^2 - u."""
    return w * sympy.diff(expression, u) + (w**2 - u) * sympy.diff(expression, w)


D = w**2 - u
slope = defined("D_tau", rate)
step("The acceleration", slope(w), D)
step("changes as", slope(D), 2 * w * D - w)
step("so z = w/D obeys dz/dtau = 1 - 2wz + z^2", slope(w / D), At(1 - 2 * w * z + z**2, {z: w / D}))
step("and dw/dtau = w/z", slope(w), At(w / z, {z: w / D}))
step(
    "One integration by parts: d(w/D) - dtau = w dD/D^2 with the sign of (56b)",
    slope(w / D) - 1,
    -w * slope(D) / D**2,
    corrects=("smith2012:56b",),
)

speed = 1 - 2 * w * z + z**2
tau = sympy.Symbol("tau", real=True)
f_of, z_of, row = sympy.Function("f_n")(tau), sympy.Function("z")(tau), sympy.Function("f_n")(w)
step(
    "A term of the series, d(f_n z^n)/dtau",
    At(sympy.Derivative(f_of * z_of**n, tau), {f_of.diff(tau): df * w / z, z_of.diff(tau): speed, f_of: f, z_of: z}),
    z ** (n - 1) * (w * df + n * f) - 2 * w * n * f * z**n + n * f * z ** (n + 1),
)
terms = {  # what the terms n, n - 1, n - 2 contribute to z^(n-1)
    f: w * df + n * f,
    g: -2 * w * (n - 1) * g,
    h: (n - 2) * h,
}
recurrence = sum(terms.values())
step(
    "(59d), n >= 3: the coefficient of z^{n-1} in sum d(f_n z^n)/dtau = 1 vanishes",
    (
        z ** (n - 1) * (w * df + n * f)
        + At(-2 * w * n * f * z**n, {n: n - 1, f: g})
        + At(n * f * z ** (n + 1), {n: n - 2, f: h})
    )
    / z ** (n - 1),
    (n - 2) * h + w * df + n * f - 2 * w * (n - 1) * g,
    proves=("smith2012:59d", "smith2012:57", "smith2012:58"),
)
step(
    "its second form: times w^{n-1}, with (w^n f_n)' = w^n f_n' + n w^{n-1} f_n",
    recurrence * w ** (n - 1),
    (n - 2) * w ** (n - 1) * h
    + At(sympy.Derivative(w**n * row, w), {row.diff(w): df, row: f})
    - 2 * (n - 1) * w**n * g,
)
step(
    "(59c), n = 2: f_0 has the factor 0",
    At(recurrence, {n: 2}),
    w * df + 2 * f - 2 * w * g,
    proves=("smith2012:59c",),
)
constant = sympy.Symbol("c")
general = 1 + constant / w
step(
    "(59b), n = 1: w f_1' + f_1 = 1, so f_1 = 1 + c/w; regular at the turning points w = 0 only for c = 0",
    w * sympy.Derivative(general, w) + general,
    sympy.Integer(1),
    proves=("smith2012:59b", "smith2012:60a"),
)

polynomials = {1: sympy.Integer(1)}
for number in range(2, 8):
    before = polynomials[number - 1]
    twice = polynomials.get(number - 2, sympy.Integer(0))
    right = 2 * (number - 1) * w**number * before - (number - 2) * w ** (number - 1) * twice
    polynomials[number] = sympy.expand(sympy.integrate(sympy.expand(right), (w, 0, w)) / w**number)
    row = polynomials[number]
    step(
        f"(60): f_{number}",
        w * sympy.Derivative(row, w) + number * row,
        sympy.expand(2 * (number - 1) * w * before - (number - 2) * twice),
    )
    step(
        f"f_{number} = w^(-{number}) times the integral from 0, where it is regular",
        sympy.Integral(sympy.expand(right), (w, 0, w)) / w**number,
        row,
        proves=(f"smith2012:60{'abcdefg'[number - 1]}",),
    )
i = sympy.Symbol("i", positive=True)
step(
    "(60h): it makes w^{i+1} of a power w^i of f_{n-1}",
    sympy.Integral(2 * (n - 1) * w**n * w**i, (w, 0, w)) / w**n,
    2 * (n - 1) * w ** (i + 1) / (n + i + 1),
)
step(
    "and keeps those of f_{n-2}: so f_n has the powers 0 ... n - 1, as f_1 = 1 has",
    sympy.Integral((n - 2) * w ** (n - 1) * w**i, (w, 0, w)) / w**n,
    (n - 2) * w**i / (n + i),
    proves=("smith2012:60h",),
)
total = sum(row * z**number for number, row in polynomials.items())
step(
    "Together: d/dtau of the sum to n = 7 is 1 + O(z^7)",
    Taylor(w / z * sympy.Derivative(total, w) + speed * sympy.Derivative(total, z), z, 6),
    sympy.Integer(1),
)
step(
    "(56c) is (56b) with dx eliminated, and w/D stays before it: the integrand w dD/D^2 over dw, with dw/dtau = D, is",
    w * slope(D) / (D**2 * slope(w)),
    2 * w**2 / D**2 - w**2 / D**3,
    corrects=("smith2012:56c",),
)
step(
    "Near miss: what the supplied (56c) begins with, D for w/D, has another rate, too large by",
    slope(D) - slope(w / D),
    2 * w * D - w - 1 + w * (2 * w * D - w) / D**2,
)
