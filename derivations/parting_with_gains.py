"""How fast two motions can part where the force may also feed energy in, in a distance with a free unit.

u' = -w, w' = G(u, w) with slopes m = G_u and g = G_w of any sign; k is the unit.  Where G_w <= 0 the derivation
``wells-distance`` is enough; here gains are allowed, and strong losses are made use of.

>>> len(derivation.steps) > 4
True
"""

import sympy

from derivations.steps import At, Derivation

U, W, m, g, a, b, c = sympy.symbols("U W m g a b c", real=True)
lam, k, D, t = sympy.symbols("lambda k D t", positive=True)

derivation = Derivation(
    "parting-with-gains",
    "How far two motions can part where there are gains",
    source="logarithmic norms (Dahlquist 1958, Lozinskii 1958) in one degree of freedom",
)
step, asserts = derivation.step, derivation.asserts

place, speed = sympy.Function("U")(t), sympy.Function("W")(t)

step(
    "U, W: the differences of two motions; G differs by m U + g W with slopes of G between the two (mean value"
    " theorem).  Half the square of k^2 U^2 + W^2 changes at the rate",
    At(
        sympy.Derivative((k**2 * place**2 + speed**2) / 2, t),
        {sympy.Derivative(place, t): -W, sympy.Derivative(speed, t): m * U + g * W, place: U, speed: W},
    ),
    (m - k**2) * U * W + g * W**2,
)
step(
    "With a = k U, b = W and c = (m - k^2)/(2 k) this is a quadratic form of the point (a, b)",
    At((m - k**2) * U * W + g * W**2, {U: a / k, W: b, m: 2 * k * c + k**2}),
    2 * c * a * b + g * b**2,
)
root = sympy.sqrt(g**2 / 4 + c**2)
step(
    "The eigenvalues of the form obey lambda^2 - g lambda - c^2 = 0; the larger one is",
    At(lam**2 - g * lam - c**2, {lam: g / 2 + root}),
    0,
)
asserts(
    "and bounds the form, with g = lambda - c^2/lambda: what is missing is (lambda a - c b)^2/lambda",
    sympy.Le(At(2 * c * a * b + g * b**2, {g: lam - c**2 / lam}), lam * (a**2 + b**2), evaluate=False),
)
step(
    "So with lambda the largest on a convex set that holds both motions the distance grows at most like e^(lambda t)",
    sympy.Derivative(D * sympy.exp(lam * t), t) / (D * sympy.exp(lam * t)),
    lam,
)
step(
    "Where losses are strong, g < 0, the rate is small: c^2/(lambda - g) writes it without cancellation",
    At(c**2 / (lam - g), {lam: g / 2 + root}),
    g / 2 + root,
)
