"""The half-swing as a reversible germ: in z = c/delta it is z + 1 + O(1/z^2), and its Abel function is odd.

>>> derivation.name, len(derivation.steps) >= 6
('stokes-reversal', True)
"""

import sympy

from derivations.steps import At, Coefficient, Derivation, Taylor

delta, z = sympy.symbols("delta z")
c, kappa = sympy.symbols("c kappa", nonzero=True)
h2, h3, f3, f4, e1 = sympy.symbols("h_2 h_3 f_3 f_4 e_1")

derivation = Derivation(
    "stokes-reversal",
    "The half-swing as a reversible germ",
    source="expansions.divergence.germ;"
    " one law, eta = alpha - 1, h(delta) = delta e^(eta R(delta)) (reversal-identity)",
)
step = derivation.step

h = delta + h2 * delta**2 + h3 * delta**3
F = delta + 2 * h2 * delta**2 + 4 * h2**2 * delta**3
step(
    "The reversal identity says h(F) backwards: h(delta) = -h(-F). With h = delta + h_2 delta^2 + h_3 delta^3 + … it is"
    " solved by F = delta + 2 h_2 delta^2 + 4 h_2^2 delta^3 + …, whatever h_3",
    Taylor(-h.subs(delta, -F), delta, 3),
    h,
)
G = delta - kappa * delta**2 + f3 * delta**3
step(
    "F = sigma h^(-1) sigma h, sigma delta = -delta, so sigma F sigma undoes F: in -F(-F(delta)) = delta the power"
    " delta^3",
    Coefficient(-G.subs(delta, -G), delta, 3),
    2 * f3 - 2 * kappa**2,
)
R = delta - kappa * delta**2 + kappa**2 * delta**3 + f4 * delta**4
step(
    "must vanish, f_3 = kappa^2. With -2 h_2 = kappa = 1/c, c/F in powers of delta = c/z",
    Taylor(delta / sympy.expand(R), delta, 2),
    1 + kappa * delta,
)
step(
    "has no term in delta^2: z' = c/F = z (1 + kappa c/z + O(1/z^3)), that is",
    At(z * (1 + kappa * c / z), {kappa: 1 / c}),
    z + 1,
)
Phi = c / delta + e1 * delta
grown = At(Phi, {delta: R.subs(kappa, 1 / c)}) - Phi - 1
step(
    "The odd ansatz Phi = c/delta + e_1 delta + … in Phi(F) = Phi + 1: in delta^1 all cancels,",
    Coefficient(grown, delta, 1),
    sympy.Integer(0),
)
step(
    "and the next power determines e_1 (f_4 is that of F)",
    Coefficient(grown, delta, 2),
    -c * f4 - (1 + e1 * c) / c**2,
)
