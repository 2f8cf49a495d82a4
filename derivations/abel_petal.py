"""Two Abel functions, one on each petal, and what their difference is: real constants, bounded, from one axis.

>>> derivation.name, len(derivation.steps) >= 9
('abel-petal', True)
"""

import sympy

from derivations.steps import At, Coefficient, Derivation

x, Y, lam, b, r = sympy.symbols("x Y lambda b r", positive=True)
k, n = sympy.symbols("k n", positive=True, integer=True)
u, v, p, q_ = sympy.symbols("u v p q", real=True)
Q, s, Y_0 = sympy.symbols("Q s Y_0", positive=True)
w = sympy.Symbol("w")

derivation = Derivation(
    "abel-petal",
    "The difference of the two Abel functions of the half-swing",
    source="expansions.divergence.petal, .constants; z' = z + 1 + g, |g| <= b/|z|^2 for |z| >= Y (stokes-reversal)",
)
step = derivation.step

step(
    "While |z_j| >= Y the real part grows by 1 - b/Y^2 = lambda at least. Points of a line Im z = -Y with distances"
    " lambda at least: all but the one nearest to the axis are bounded by the integral of the decreasing function",
    sympy.Integral(1 / (Y**2 + x**2), (x, -sympy.oo, sympy.oo)),
    sympy.pi / Y,
)
step(
    "over lambda, and that one by 1/Y^2: sum |g(z_j)| <= b (pi/(lambda Y) + 1/Y^2) = s. From Im z <= -(Y + s) the"
    " imaginary part moves by s at most, so |z_j| >= Y holds for all j: the limits Phi_+ = lim (z_j - j) exist, with"
    " |Phi_+ - z| <= s. At lambda = 1",
    At(b * (sympy.pi / (lam * Y) + 1 / Y**2), {lam: 1}),
    b * (sympy.pi * Y + 1) / Y**2,
)
plus, minus = sympy.symbols("Phi_+ Phi_-")
axis = {plus: u - sympy.I * v, minus: -sympy.conjugate(u - sympy.I * v)}
step(
    "Phi_-(delta) = -Phi_+(-delta), from the orbit backwards (reversal): on the imaginary axis -delta is the conjugate"
    " of delta and F is real, so with Phi_+ = u - i v the difference D = Phi_+ - Phi_- is real,",
    At(plus - minus, axis),
    2 * u,
)
step(
    "and w = (Phi_+ + Phi_-)/2 is imaginary:",
    At((plus + minus) / 2, axis),
    -sympy.I * v,
)
step(
    "Both Abel functions grow by 1 under F, so D does not change under F and w grows by 1 (|w - z| <= s and Rouche's"
    " theorem: w takes each value with Im w <= -Y_0 once). D is a function of period 1 of w, bounded by 2 s, that tends"
    " to 0: a series in q,",
    At(sympy.exp(-2 * sympy.pi * sympy.I * w), {w: w + 1}),
    sympy.exp(-2 * sympy.pi * sympy.I * w),
)
step(
    "and on w = -i v q is real, so all c_k are real:",
    At(sympy.exp(-2 * sympy.pi * sympy.I * w), {w: -sympy.I * v}),
    sympy.exp(-2 * sympy.pi * v),
)
step(
    "Its coefficients are means over a period at Im w = -Y_0, |c_k| <= 2 s e^(2 pi k Y_0). At w = -i v, Q ="
    " e^(2 pi (Y_0 - v)) < 1, what lies beyond the n-th term is at most",
    sympy.Sum(2 * s * Q ** (n + k), (k, 1, sympy.oo)).subs(Q, 1 / (1 + r)),
    At(2 * s * Q ** (n + 1) / (1 - Q), {Q: 1 / (1 + r)}),
)
step(
    "The same holds for the time, |theta_+| <= s_T, for theta_+(delta) = -sum (T - pi) and T(-F) = T(delta) make"
    " theta_-(delta) = -theta_+(-delta); with theta_+ = p + i q for Phi_+ the difference on the axis is",
    At(plus - minus, {plus: p + sympy.I * q_, minus: -sympy.conjugate(p + sympy.I * q_)}),
    2 * p,
)
first, second, pi = sympy.Symbol("c_1", real=True), sympy.Symbol("c_2", real=True), sympy.pi
h = sympy.Symbol("h")
step(
    "Why w and not Phi_-: with h = e^(-2 pi i Phi_-) and w = Phi_- + D/2 the second coefficient is not real any more,",
    Coefficient(first * h * sympy.exp(-pi * sympy.I * first * h) + second * h**2, h, 2),
    second - sympy.I * pi * first**2,
)
