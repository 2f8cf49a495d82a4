"""The large orders of the amplitude and phase equations: their constants are c_1, c_1 + d_1/pi and d_1.

>>> derivation.name, len(derivation.steps) >= 9
('large-orders', True)
"""

import sympy

from derivations.steps import At, Coefficient, Derivation

h, q, c1, d1, Wm, w = sympy.symbols("h q c_1 d_1 W w")
y, K, a = sympy.symbols("y K a", positive=True)
c = sympy.Symbol("c", nonzero=True)
k = sympy.Symbol("k", positive=True, integer=True)
m = sympy.Symbol("m", positive=True, integer=True)
V, Om, p = sympy.symbols("V Omega p")
pi, i = sympy.pi, sympy.I

derivation = Derivation(
    "large-orders",
    "The large orders of V, p_k and Omega_k",
    source="divergence; abel-petal, cauchy-heine; dPhi/dpsi = 1/pi, V = 1/(pi Phi'), W = 1 + V theta', turning points",
)
step = derivation.step

n = sympy.Symbol("n")
step(
    "On the two petals Phi = w + h D, theta = t + h E with h = 1/2 and -1/2, D = c_1 q + …, E = d_1 q + …, q ="
    " e^(-2 pi i w). By dw, D is, to first order in q,",
    sympy.Derivative(c1 * sympy.exp(-2 * pi * i * w), w),
    -2 * pi * i * c1 * sympy.exp(-2 * pi * i * w),
)
rate = 1 + h * (-2 * pi * i * c1 * q)
step(
    "V = 1/(pi Phi') = (1/(pi w'))/(1 + h dD/dw): the difference of its two values, relatively, is",
    Coefficient(1 / rate, h, 1),
    2 * pi * i * c1 * q,
)
time = 1 + (pi * (Wm - 1) + h * (-2 * pi * i * d1 * q)) / (pi * rate)
step(
    "W = 1 + (dt/dw + h dE/dw)/(pi (1 + h dD/dw)), where dt/dw = pi (W - 1):",
    Coefficient(time, h, 1),
    2 * pi * i * q * (c1 * (Wm - 1) - d1 / pi),
)
change = 2 * pi * i * q * (c1 * (Wm - 1) - d1 / pi)
step(
    "The amplitude equation has p = -V/((alpha - 1) delta W): relatively",
    Coefficient((1 + h * 2 * pi * i * c1 * q) / (1 + h * change / Wm), h, 1),
    2 * pi * i * q * (c1 + d1 / pi) / Wm,
)
step(
    "and the phase Omega = 1/W (Omega - 1 alike): at W = 1",
    At(-change / Wm**2, {Wm: 1}),
    2 * i * d1 * q,
)
step(
    "Cauchy's formula on the two half-discs (cauchy-heine) for f = V, p/p_1, Omega: [delta^k] f c^k is 1/(2 pi i)"
    " times -i^(-k) int Delta f(-iy) y^(k-1) dy + (-i)^(-k) int Delta f(iy) y^(k-1) dy. V and Omega are even, so"
    " Delta f is odd; for even k = 2m that is, per unit of int Delta f(-iy) y^(k-1) dy,",
    At(-(i**-n) - (-i) ** -n, {n: 2 * m}) / (2 * pi * i),
    i * (-1) ** m / pi,
)
step(
    "p is odd, Delta p even; for odd k = 2m + 1",
    At(-(i**-n) + (-i) ** -n, {n: 2 * m + 1}) / (2 * pi * i),
    (-1) ** m / pi,
)
step(
    "V begins with -delta^2/(pi c), delta = c/z. At z = -iy, Delta V = 2 pi i c_1 q V is",
    2 * pi * i * c1 * q * At(-((c / w) ** 2) / (pi * c), {w: -i * y}),
    2 * i * c * c1 * q / y**2,
)
moment = sympy.Integral(sympy.exp(-2 * pi * y) * y ** (a - 1), (y, 0, sympy.oo))
step(
    "and with int e^(-2 pi y) y^(k-3) dy = Gamma(k-2)/(2 pi)^(k-2): V_k = -(-1)^(k/2) times",
    i / pi * (2 * i * c * c1) * At(moment, {a: k - 2}) / c**k / -1,
    2 * c1 / (pi * c) * sympy.gamma(k - 2) / (2 * pi) ** (k - 2) / c ** (k - 2),
)
step(
    "p/p_1 begins with delta, Delta p/p_1 = 2 pi i q (c_1 + d_1/pi) c/(-iy): p_k/p_1 = -(-1)^((k-1)/2) times",
    -1 / pi * (2 * pi * i * K * c / -i) * At(moment, {a: k - 1}) / c**k,
    2 * K * sympy.gamma(k - 1) / (2 * pi) ** (k - 1) / c ** (k - 1),
)
step(
    "with K = c_1 + d_1/pi; and Omega_k = -(-1)^(k/2) times",
    -i / pi * (2 * i * d1) * At(moment, {a: k}) / c**k,
    (2 * d1 / pi) * sympy.gamma(k) / (2 * pi * c) ** k,
)
eps, n = sympy.symbols("epsilon_1 n", positive=True)
step(
    "The first corrections all come from q = e^(-2 pi y)(1 + 2 pi eps_1/y + O(1/y^2)), as V, p and W - 1 have every"
    " second power only: with n! where n = k-3, k-2, k-1 for V, p, Omega, the factor is 1 + f/n + O(n^(-2)), f = 4"
    " pi^2 e_1 c:",
    2 * pi * eps * At(moment, {a: n}) / At(moment, {a: n + 1}),
    4 * pi**2 * eps / n,
)
step(
    "From V_k to V_(k+2) the law grows by -(k-1)(k-2)/(2 pi c)^2 (1 + O(k^(-2))): what used to be measured",
    -At(moment, {a: k}) / At(moment, {a: k - 2}) / c**2,
    -(k - 1) * (k - 2) / (2 * pi * c) ** 2,
)
step(
    "Beyond the first correction: to first order in q the change of Omega, over 2 i d_1 q, is for any W",
    sympy.Derivative(1 / Wm, Wm) * change / (2 * i * d1 * q),
    (1 - pi * c1 / d1 * (Wm - 1)) / Wm**2,
)
step(
    "and Delta p is 1/W times p; W, V/delta^2, p/delta go on in powers of delta^2, which on z = -iy is",
    At((c / w) ** 2, {w: -i * y}),
    -(c**2) / y**2,
)
x, eps_3, s_2 = sympy.symbols("x epsilon_3 s_2")
step(
    "With x = 1/y, v = y - epsilon_1 x + epsilon_3 x^3 - …, q is e^(-2 pi y) times a series in x; beside a factor 1 +"
    " s_2 x^2 + … of V, p or Omega its second coefficient is",
    Coefficient(sympy.exp(2 * pi * (eps * x - eps_3 * x**3)) * (1 + s_2 * x**2), x, 2),
    2 * pi**2 * eps**2 + s_2,
)
step(
    "and x^j lowers the moment by j powers of y: relatively by (2 pi)^j/(n (n-1) … (n-j+1)), at j = 2",
    At(moment, {a: n - 1}) / At(moment, {a: n + 1}),
    (2 * pi) ** 2 / (n * (n - 1)),
)
