"""Every sum over n is elementary: G_i(z) = sum_n C_i^n z^n in closed form for all i, by induction.

With z = tan(theta), c = cos(theta): H_i = sin(theta)^i G_i = theta P_i(c) + sin(theta) R_i(c), polynomials P_i, R_i
with rational coefficients, P_i of parity (-1)^i and R_i of parity (-1)^(i+1).  Dividing by sin^i leaves a rational
function of z plus a rational function of z times arctan z, for every i: the paper finds nothing recognisable from
i = 2 on.

>>> closed[2]
(1/6, 4*c**5/9 - 7*c**3/9 + c/6)
>>> limits[:5]
[pi, 0, pi/6, -2*pi/9, 49*pi/144]
"""

import sympy

from derivations.steps import At, Derivation, Taylor

z, theta, t = sympy.symbols("z theta t", positive=True)
c = sympy.Symbol("c", real=True)
i, n, m = sympy.symbols("i n m", integer=True, positive=True)
A, B, D = sympy.symbols("C_i^n C_{i-1}^{n-1} C_i^{n-2}")
diff, sin, cos = sympy.diff, sympy.sin, sympy.cos

derivation = Derivation(
    "smith-generating-functions",
    "The sums over n are elementary for every i",
    source="Smith 2012, (62a), (64), (68) and the claim after it; smith2012:64, 68, claim.not-identifiable",
)
step, asserts = derivation.step, derivation.asserts

# 1. The differential equation.
step(
    "z(1+z^2) d/dz + i on C_i^n z^n: the power z^n also collects C_i^{n-2} from z^3 d/dz; 2 z^2 d/dz on"
    " C_{i-1}^{n-1} z^{n-1}"
    " gives the right side: z(1+z^2) G_i' + i G_i = 2 z^2 G_{i-1}' is (62a), power by power",
    (
        z * sympy.Derivative(A * z**n, z)
        + i * A * z**n
        + z**3 * sympy.Derivative(D * z ** (n - 2), z)
        - 2 * z**2 * sympy.Derivative(B * z ** (n - 1), z)
    )
    / z**n,
    (n + i) * A + (n - 2) * D - 2 * (n - 1) * B,
)
step(
    "G_0 = arctan z, from C_0^n = (-1)^{(n-1)/2}/n",
    (1 + z**2) * sympy.Derivative(sympy.atan(z), z),
    sympy.Integer(1),
    proves=("smith2012:64",),
)

# 2. The angle.
G, G_before = (sympy.Function(name)(theta) for name in ("G_i", "G_{i-1}"))
H_before = sympy.Function("H_{i-1}")(theta)
step(
    "z = tan(theta): z(1+z^2) d/dz = tan(theta) d/dtheta",
    sympy.tan(theta) * (1 + sympy.tan(theta) ** 2) / sympy.Derivative(sympy.tan(theta), theta),
    sympy.tan(theta),
)
step(
    "and 2 z^2 d/dz = 2 sin^2(theta) d/dtheta",
    sympy.trigsimp(2 * sympy.tan(theta) ** 2 / sympy.Derivative(sympy.tan(theta), theta)),
    2 * sin(theta) ** 2,
)
step(
    "The left side times sin^{i-1} cos is a derivative: (sin^i G_i)' = 2 sin^{i+1} cos G_{i-1}'",
    sin(theta) ** (i - 1) * cos(theta) * (sin(theta) / cos(theta) * diff(G, theta) + i * G),
    diff(sin(theta) ** i * G, theta),
)
substituted = diff(H_before * sin(theta) ** (1 - i), theta)
step(
    "with G_{i-1} = H_{i-1}/sin^{i-1}: H_i' = 2 sin^2 cos H_{i-1}' - 2(i-1) sin cos^2 H_{i-1}, H_i(0) = 0",
    sympy.powsimp(sympy.expand(2 * sin(theta) ** (i + 1) * cos(theta) * substituted)),
    2 * sin(theta) ** 2 * cos(theta) * diff(H_before, theta) - 2 * (i - 1) * sin(theta) * cos(theta) ** 2 * H_before,
)

# 3. One step of the induction, with arbitrary functions p, r of c for P_{i-1}, R_{i-1} and P, R for those of i.
p, r, P, R = (sympy.Function(name) for name in "prPR")
s = sympy.Symbol("s")


def d_theta(part: sympy.Expr, rest: sympy.Expr) -> tuple[sympy.Expr, sympy.Expr]:
    """d/dtheta of theta part(c) + s rest(c), as (coefficient of theta, remainder), with dc = -s and ds = c."""
    return -s * diff(part, c), part + c * rest - s**2 * diff(rest, c)


def residue(expression: sympy.Expr) -> sympy.Expr:
    """An expression in s and c with s^2 = 1 - c^2."""
    return sympy.expand(sympy.expand(expression).subs({s**3: s * (1 - c**2), s**4: (1 - c**2) ** 2, s**2: 1 - c**2}))


left = d_theta(P(c), R(c))
inner = d_theta(p(c), r(c))
right = [2 * s**2 * c * new - 2 * (i - 1) * s * c**2 * old for new, old in zip(inner, (p(c), s * r(c)))]
slope = 2 * c * (1 - c**2) * diff(p(c), c) + 2 * (i - 1) * c**2 * p(c)
step(
    "The part with theta: P_i' = 2c(1-c^2) P_{i-1}' + 2(i-1) c^2 P_{i-1}",
    residue((left[0] - right[0]) / -s),
    diff(P(c), c) - slope,
)
known = 2 * (1 - c**2) * (c * p(c) + c**2 * r(c) - (1 - c**2) * c * diff(r(c), c) - (i - 1) * c**2 * r(c))
step(
    "The rest: L R_i = (1-c^2) R_i' - c R_i = P_i - 2(1-c^2)[c P_{i-1} + c^2 R_{i-1} - (1-c^2) c"
    " R_{i-1}' - (i-1) c^2 R_{i-1}]",
    residue(left[1] - right[1]),
    P(c) - ((1 - c**2) * diff(R(c), c) - c * R(c)) - known,
)
step(
    "L lowers and raises: L c^m = m c^{m-1} - (m+1) c^{m+1}, so every polynomial is L of a polynomial plus a constant",
    (1 - c**2) * sympy.Derivative(c**m, c) - c * c**m,
    m * c ** (m - 1) - (m + 1) * c ** (m + 1),
)
step("(the case m = 0)", (1 - c**2) * sympy.Derivative(sympy.Integer(1), c) - c, -c)
even, odd = c ** (2 * m), c ** (2 * m + 1)
parts = [
    (sign, part)
    for sign, first, second in ((1, even, odd), (-1, odd, even))
    for part in (slope.subs(p(c), first), c * known.subs({p(c): first, r(c): second}))
]
asserts(
    "Parity: the slope has the parity of P_{i-1}, so P_i the opposite one; the known terms have the opposite parity of"
    " P_{i-1} and the parity of R_{i-1}; L changes the parity. With (even, odd) for (P, R) at i - 1"
    " follows (odd, even) at"
    " i, the right side of L R_i being odd, with no constant term to miss; with (odd, even) follows"
    " (even, odd), where the"
    " free constant of P_i is chosen so that L R_i is reached. Hence P_i, R_i exist for every i",
    *(sympy.Eq(At(part, {c: -c}), sign * part, evaluate=False) for sign, part in parts),
    proves=("smith2012:claim.not-identifiable",),
)


def next_pair(number: int, pair: tuple[sympy.Expr, sympy.Expr]) -> tuple[sympy.Expr, sympy.Expr]:
    """(P_i, R_i) from (P_(i-1), R_(i-1)), i = number: integrate the slope, peel L R_i, settle the constant."""
    before = {p(c): pair[0], r(c): pair[1], i: number}
    integral = sympy.integrate(sympy.expand(slope.subs(before).doit()), c)
    rest, R_next = sympy.Poly(integral - known.subs(before).doit(), c), sympy.Poly(0, c)
    while (power := rest.degree()) > 0:
        monomial = sympy.Poly(-rest.LC() / power * c ** (power - 1), c)
        R_next += monomial
        rest -= sympy.Poly(1 - c**2, c) * monomial.diff(c) - sympy.Poly(c, c) * monomial
    return sympy.expand(integral - rest.as_expr()), R_next.as_expr()


closed = [(sympy.Integer(1), sympy.Integer(0))]
for number in range(1, 9):
    closed.append(next_pair(number, closed[-1]))
    new, old = ({P(c): closed[-1][0], R(c): closed[-1][1]}, {p(c): closed[-2][0], r(c): closed[-2][1], i: number})
    asserts(
        f"P_{number}, R_{number}: P_i' is its slope, and (1-c^2) R_i' - c R_i is P_i less the known terms",
        sympy.Eq(sympy.Derivative(P(c), c).subs(new), slope.subs(old), evaluate=False),
        sympy.Eq(((1 - c**2) * diff(R(c), c) - c * R(c)).subs(new), P(c).subs(new) - known.subs(old), evaluate=False),
    )
limits = [sympy.pi * pair[0].subs(c, -1) for pair in closed]
step(
    "At theta = pi: H_i(pi) = pi P_i(-1), so the half period is sum_i H_i(pi) u_1^i (u_1 < 0 where it ends):"
    " i = 0, 1, 2, 3, 4",
    sympy.Tuple(*(sympy.pi * At(pair[0], {c: -1}) for pair in closed[:5])),
    sympy.Tuple(sympy.pi, 0, sympy.pi / 6, -2 * sympy.pi / 9, 49 * sympy.pi / 144),
)
cosine = 1 / sympy.sqrt(1 + z**2)
step(
    "i = 1: P_1 = 0, so G_1 = R_1 = (2/3) sin^2(theta) at c = 1/sqrt(1+z^2), which is (68)",
    At(closed[1][1], {c: cosine}),
    sympy.Rational(2, 3) * z**2 / (1 + z**2),
    proves=("smith2012:68",),
)
G2 = (sympy.atan(z) * closed[2][0] + z * cosine * closed[2][1].subs(c, cosine)) * (1 + z**2) / z**2
step(
    "i = 2, in z: its Taylor coefficients are C_2^3 = 8/15, C_2^5 = -104/105, C_2^7 = 272/189",
    Taylor(sympy.simplify(G2), z, 8),
    sympy.Rational(8, 15) * z**3 - sympy.Rational(104, 105) * z**5 + sympy.Rational(272, 189) * z**7,
)
