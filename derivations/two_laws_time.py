"""Two laws: the time integral (20) by 2F1, its companion, where each breaks down, (21), (22), elementary cases.

>>> derivation.steps[-5].reason
'(3,4)'
"""

import sympy

from derivations.steps import At, Derivation, named

c, d, x, x_0, tau, beta, alpha = sympy.symbols("c d x x_0 tau beta alpha", positive=True)  # d is the paper's c'
a, k, z = sympy.symbols("a k z", positive=True)
gap = beta - alpha  # beta is the paper's alpha'
diff, log, exp, atan, sqrt = sympy.diff, sympy.log, sympy.exp, sympy.atan, sympy.sqrt

derivation = Derivation(
    "two-laws-time",
    "Two laws: the time as a function of the amplitude",
    source="Lancaster 2020, (20)-(22), footnote 22; lancaster2020:20, 21, 22, fn22; the companion is not in the paper",
)
step = derivation.step

term = a / (a + k)  # coefficient of z^k in F(a; z) = 2F1(1, a; a+1; z)
step(
    "(1)_k (a)_k/((a+1)_k k!) = a/(a+k): the quotient of successive coefficients is that of 2F1",
    At(term, {k: k + 1}) / term,
    (a + k) * (1 + k) / ((a + 1 + k) * (1 + k)),
)
step("and it starts with 1", At(term, {k: 0}), sympy.Integer(1))
step(
    "(z d/dz + a) multiplies it by k + a: z F' + a F = a/(1-z)",
    (z * sympy.Derivative(term * z**k, z) + a * term * z**k) / z**k,
    a,
)
hyper = sympy.Function("F")(x)  # F(index; argument) as a function of x


def derivative(factor: sympy.Expr, index: sympy.Expr, argument: sympy.Expr) -> sympy.Expr:
    """d/dx of factor F(index; argument), by that identity, with F(x) for the function."""
    slope = index * (1 / (1 - argument) - hyper) / argument
    return At(sympy.Derivative(factor * hyper, x), {sympy.Derivative(hyper, x): slope * diff(argument, x)})


target = 1 / (c * x**alpha + d * x**beta)
printed = x ** (1 - beta) / (d * (1 - beta))
index = (beta - 1) / gap
step(
    "Footnote 22: its third parameter is the second plus 1",
    (1 + alpha - 2 * beta) / (alpha - beta),
    At(a + 1, {a: index}),
)
step("Footnote 22 is an antiderivative", derivative(printed, index, -c / d * x ** (alpha - beta)), target)
other = (1 - alpha) / gap
companion = x ** (1 - alpha) / (c * (1 - alpha))
step("The companion (laws exchanged) is one too", derivative(companion, other, -d / c * x**gap), target)
wrong = derivative(printed, 1 / index, -c / d * x ** (alpha - beta))
step(
    "Near miss: with the index a upside down it is not; what is left over, z = -(c/c') x^(alpha-alpha'), is",
    wrong - target,
    printed * (1 / index - index) * (1 / (1 + c / d * x ** (alpha - beta)) - hyper) * (alpha - beta) / x,
)
n = sympy.Symbol("n", integer=True, positive=True)
step(
    "The indices, one with the laws exchanged, add up to 1: they are not both <= 0",
    index + At(index, {alpha: beta, beta: alpha}),
    sympy.Integer(1),
)
step(
    "a/(a+k) has a pole at a = -n: the printed form fails at beta = 1 (n = 0) and beta = 1 - n gap",
    At(index, {beta: (1 + n * alpha) / (1 + n)}),
    -n,
)
r = sympy.Symbol("r", real=True)
step(
    "where the coefficient a/(a+k), k = n, has the residue -n: F has no value; at n = 0 the factor 1/(1-beta) has none",
    sympy.Limit((r + n) * At(term, {a: r, k: n}), r, -n),
    -n,
    proves=("lancaster2020:fn22",),
)
step("which needs alpha = 1 - (n+1) gap < 1", At(alpha - 1 + (n + 1) * gap, {beta: (1 + n * alpha) / (1 + n)}), 0)
step("the companion at alpha = 1 (n = 0) and alpha = 1 + n gap > 1", At(other, {beta: (alpha - 1) / n + alpha}), -n)

lam = x_0 / (c + d * x_0)
A = c * lam * exp(-c * tau) / (1 - lam * d * exp(-c * tau))
step("(21) with tau = t/(pi k) solves dA/dtau = -c A - c' A^2", sympy.Derivative(A, tau), -c * A - d * A**2)
step("and starts at x_0", At(A, {tau: 0}), x_0)
step(
    "(22): the limit of A e^{c tau}",
    sympy.Limit(A * exp(c * tau), tau, sympy.oo),
    x_0 / (1 + d / c * x_0),
    corrects=("lancaster2020:22",),
)
b, b_prime, m, omega_0 = sympy.symbols("b b_prime m omega_0", positive=True)
ratio = named("c'", 4 * b_prime * omega_0 * k / (3 * m)) / named("c", sympy.pi * b * k / (2 * m))
step("c'/c = 8 b' omega_0/(3 b pi)", ratio, 8 * b_prime * omega_0 / (3 * b * sympy.pi))

elementary = {
    (0, 1): -log(c + d * x) / d,
    (0, 2): -atan(x * sqrt(d / c)) / sqrt(c * d),
    (1, 2): log((c + d * x) / x) / c,
    (2, 3): 1 / (c * x) - d / c**2 * log((c + d * x) / x),
    (1, 3): log((c + d * x**2) / x**2) / (2 * c),
    (3, 4): 1 / (2 * c * x**2) - d / (c**2 * x) + d**2 / c**3 * log((c + d * x) / x),
}
for (low, high), time in elementary.items():
    step(f"({low},{high})", -sympy.Derivative(time, x), 1 / (c * x**low + d * x**high))

# Which of two laws decides at late times.
p, q = sympy.symbols("p q", positive=True)
step(
    "As x -> 0 the smaller exponent decides: c x^alpha + c' x^(alpha+p) over c x^alpha alone tends to",
    sympy.Limit((c * x**alpha + d * x ** (alpha + p)) / (c * x**alpha), x, 0, "+"),
    1,
)
step(
    "so the time to x tends to that of c x^alpha alone, for alpha = 2 + q x^(-1-q)/((1+q) c): x falls like"
    " tau^(-1/(1+q)), more slowly than 1/tau, whenever all exponents exceed 2",
    -sympy.Derivative(x ** (-1 - q) / ((1 + q) * c), x),
    1 / (c * x ** (2 + q)),
    corrects=("lancaster2020:claim.single-term-slow",),
)
step("(3,4) is such a sum: 2 c tau x^2 tends to", sympy.Limit(2 * c * x**2 * elementary[3, 4], x, 0, "+"), 1)
step(
    "Near miss: beside a term with an exponent of 2, (2,3), it is c tau x that does: 1/tau",
    sympy.Limit(c * x * elementary[2, 3], x, 0, "+"),
    1,
)
