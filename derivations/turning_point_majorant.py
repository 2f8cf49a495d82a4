"""The local expansion at a turning point has an algebraic majorant.

With z_0 = w^2, z_i = w^alpha_i, D = w d/dw, P = y - N(w) = P_0 (1 - r), and dy/dw = -w/P.

>>> len(derivation.steps) > 6
True
"""

import sympy

from derivations.steps import At, Derivation, Taylor

w, P0, e, z, b, A, t, lam = sympy.symbols("w P_0 epsilon z b a t lambda", positive=True)
alpha, n = sympy.symbols("alpha n", positive=True)
R, S, r = sympy.symbols("R S r")
z_1, z_2, g_1, g_2, n_1, n_2 = sympy.symbols("z_1 z_2 g_1 g_2 n_1 n_2", positive=True)
power = sympy.Symbol("k", integer=True, positive=True)

derivation = Derivation(
    "turning-point-majorant",
    "A majorant of the local expansion at a turning point",
    source="Cauchy's method of majorants, in the variables w^2 and w^alpha_i",
)
step, asserts = derivation.step, derivation.asserts

f = sympy.Function("r")(w)
P = P0 * (1 - f)
step(
    "y = P + N and dy/dw = -w/P, times w/P_0: D P/P_0 = -(w^2/P_0^2)/(1-r) - alpha (epsilon/P_0) w^alpha, where",
    w * sympy.Derivative(P, w) / P0,
    -w * sympy.diff(f, w),
)
step(
    "and the right side (w/P_0) (-w/P - N'(w)) is, for one term of N (several add)",
    w / P0 * (-w / (P0 * (1 - r)) - sympy.Derivative(e * w**alpha, w)),
    -(w**2) / P0**2 / (1 - r) - alpha * e / P0 * w**alpha,
)
step(
    "D multiplies a monomial by its exponent: at least 2 if z_0 divides it, alpha for z = w^alpha alone",
    w * sympy.Derivative(w ** (2 + n), w),
    (2 + n) * w ** (2 + n),
)
first = ((1 + b) - sympy.sqrt((1 - b) ** 2 - 4 * A)) / 2
step(
    "So with a = z_0/(2 P_0^2), b = |epsilon z/P_0| all coefficients of r are at most those of the solution of"
    " R = a/(1-R) + b without constant term",
    At(A / (1 - R) + b, {R: first}),
    first,
)
step("it begins with a + b", Taylor(first.subs({A: t * A, b: t * b}), t, 1), t * (A + b))
second = 1 - sympy.sqrt(1 - 2 * A - 2 * b)
step(
    "Times (1-r), for epsilon/P_0 > 0: D (r - r^2/2) = z_0/P_0^2 + (1-r) alpha (epsilon/P_0) z."
    "  All coefficients of r are >= 0 then, so the product with r only takes away: they are at most"
    " those of S = S^2/2 + a + b",
    At(S**2 / 2 + A + b, {S: second}),
    second,
)
step(
    "For P_0 < 0 replace z by -z: the signs of epsilon/P_0 return, absolute values stay: D does not see the sign",
    z * sympy.Derivative((-z) ** power, z),
    power * (-z) ** power,
)
step(
    "1/P = (1/P_0)/(1-r) has the majorant 1/(1-R); without its constant term",
    sympy.Sum(At(R**power, {R: 1 / (1 + t)}), (power, 1, sympy.oo)),
    At(R / (1 - R), {R: 1 / (1 + t)}),
)
step(
    "Tail: stretch each z_i by lambda^(g_i).  A monomial with sum n_i g_i = G + n was lambda^(G+n) times smaller",
    At(z_1**n_1 * z_2**n_2, {z_1: z_1 / lam**g_1, z_2: z_2 / lam**g_2}),
    z_1**n_1 * z_2**n_2 / lam ** (n_1 * g_1 + n_2 * g_2),
)
excess = sympy.Symbol("mu", nonnegative=True)
asserts(
    "and lambda^(-n) = e^(-n ln lambda) <= 1 for lambda = 1 + mu >= 1: all monomials from G on add up to at most"
    " lambda^(-G) R*",
    sympy.Ge(power * sympy.log(1 + excess), 0, evaluate=False),
)
