"""The coefficients of the Abel function are moments of what its two halves differ by.

>>> derivation.name, len(derivation.steps) >= 10
('cauchy-heine', True)
"""

import sympy

from derivations.steps import At, Coefficient, Derivation

y, r, Y, s, b, lam = sympy.symbols("y r Y s b lambda", positive=True)
m = sympy.Symbol("m", nonnegative=True, integer=True)
n, k = sympy.symbols("n k", positive=True, integer=True)
D, B, eps1, eps3, x = sympy.symbols("D B epsilon_1 epsilon_3 x", real=True)
pi, i = sympy.pi, sympy.I

derivation = Derivation(
    "cauchy-heine",
    "Cauchy-Heine: the large orders of the Abel function, and why it converges only if all Stokes constants vanish",
    source="divergence; Phi_+, Phi_-, D, Y, s, Y_0 of abel-petal; Phi = z + sum eps_n z^(-n), eps_n = e_n c^n, n odd",
)
step, asserts = derivation.step, derivation.asserts
z_ = sympy.Symbol("z")

step(
    "Where it holds: let y_0 = sqrt(2) (Y + s). A point with |z| >= y_0, Re z >= 0 has |Im z| >= Y + s (abel-petal), or"
    " Re z >= Y + s; there |z_j| >= Re z_j >= Y + j lambda, the first term and the integral of the others being",
    b / Y**2 + sympy.Integral(b / (Y + lam * x) ** 2, (x, 0, sympy.oo)).subs(x, y),
    b * (1 / (lam * Y) + 1 / Y**2),
)
asserts(
    "less than s. So f_+ = Phi_+ - z and f_- = Phi_- - z are bounded by s on the right and the left half of |z| >= y_0",
    sympy.Lt(1 / (lam * Y) + 1 / Y**2, pi / (lam * Y) + 1 / Y**2, evaluate=False),
)
step(
    "and have the same expansion. In u = 1/z, |u| <= 1/y_0, Cauchy's formula on both half-discs gives eps_n = (1/(2"
    " pi i)) times the arcs, at most 2 pi s y_0^n, and the two radii, with f_+ - f_- = D. On u = i r from i/y_0 to"
    " 0, r = 1/y, D u^(-n-1) du is D dy times",
    At(r ** (-n - 1), {r: 1 / y}) * i ** (-n - 1) * i * sympy.Derivative(1 / y, y),
    -(i ** (-n)) * y ** (n - 1),
)
step(
    "Phi_-(z) = -Phi_+(-z) makes D(-z) = D(z), so on u = -i r the same D stands; from 0 to -i/y_0, where y falls from"
    " infinity to y_0: together, at even n,",
    At(-(i**-n) + (-i) ** -n, {n: 2 * k}),
    sympy.Integer(0),
)
step(
    "and at odd n = 2m + 1, divided by 2 pi i, they are",
    At(-(i ** (-n)) + (-i) ** (-n), {n: 2 * m + 1}) / (2 * pi * i),
    (-1) ** m / pi,
)
step(
    "Hence |eps_n - ((-1)^((n-1)/2)/pi) int_(y_0)^oo D(-iy) y^(n-1) dy| <= s y_0^n for odd n. On z = -iy, w = -iv with"
    " v = i w,",
    At(i * (z_ + eps1 / z_ + eps3 / z_**3), {z_: -i * y}),
    y - eps1 / y + eps3 / y**3,
)
delta = sympy.Symbol("delta")
Phi = sympy.Function("Phi")(delta)
q = sympy.exp(2 * pi * (eps1 * x - eps3 * x**3))
step(
    "up to O(y^(-5)), for w has the expansion of Phi: q = e^(-2 pi v) = e^(-2 pi y)(1 + 2 pi eps_1/y + O(1/y^2)), with"
    " x = 1/y",
    Coefficient(q, x, 1),
    2 * pi * eps1,
)
step(
    "The term c_k q^k of D gives moments of",
    sympy.Integral(sympy.exp(-2 * pi * k * y) * y ** (n - 1), (y, 0, sympy.oo)),
    sympy.gamma(n) / (2 * pi * k) ** n,
)
moment = sympy.Integral(sympy.exp(-2 * pi * y) * y ** (n - 1), (y, 0, sympy.oo))
step(
    "those with k > 1 smaller by k^(-n), and what [0, y_0] lacks is at most |c_1| y_0^n. The first correction of k ="
    " 1 is the moment of one power less, relatively",
    2 * pi * eps1 * At(moment, {n: n - 1}) / moment,
    4 * pi**2 * eps1 / (n - 1),
)
step(
    "and where |q e^(2 pi y) - 1 - 2 pi eps_1/y| <= B/y^2 on y >= y_0, the rest is at most, relatively,",
    B * At(moment, {n: n - 2}) / moment,
    4 * pi**2 * B / ((n - 1) * (n - 2)),
)
step(
    "So e_n c^n = (c_1/pi)(-1)^((n-1)/2) Gamma(n)/(2 pi)^n (1 + f/(n-1) + O(n^(-2))), f = 4 pi^2 e_1 c. If all c_k"
    " vanish, |eps_n| <= s y_0^n: Phi converges for |z| > y_0, and V = 1/(pi Phi') is an analytic amplitude equation"
    " whose motion over pi is F, since along it Phi grows at the rate",
    Phi.diff(delta) * At(1 / (pi * sympy.Symbol("u")), {sympy.Symbol("u"): Phi.diff(delta)}),
    1 / pi,
)
lag, W = sympy.Function("theta")(delta), sympy.Symbol("W")
V2, V4 = sympy.symbols("V_2 V_4", nonzero=True)
step(
    "Conversely let an analytic V = V_2 delta^2 + V_4 delta^4 + … have F as its motion over pi (F is reversible: its"
    " formal generator is even). Then Phi = int d delta/(pi V) is analytic up to a pole, without a logarithm: in"
    " 1/(pi V) the power delta^(-1)",
    Coefficient(1 / (pi * (V2 + V4 * x**2)), x, 1),
    sympy.Integer(0),
)
step(
    "is missing. It grows by 1 over F, so Phi(z_j) - j is constant along orbits both ways, and as z_j -> infinity it"
    " tends to Phi_+ and to Phi_- (with the constant that makes it odd): D = Phi - Phi vanishes, and so does each"
    " c_k = int_0^1 D e^(2 pi i k w) dw. No analytic amplitude equation has the half-swing as its map unless all c_k"
    " vanish; and an analytic W beside it would make theta = int (W - 1)/V analytic, all d_k zero, as its increment"
    " is the integral of",
    sympy.Symbol("V") * At(sympy.Derivative(lag, delta), {sympy.Derivative(lag, delta): (W - 1) / sympy.Symbol("V")}),
    W - 1,
)
