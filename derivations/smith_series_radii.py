"""Where Smith's series (57) and (61) converge: the orbit through (w, z), followed back to w = 0, must not meet D = 0.

>>> print(derivation.steps[0].text())
D_w(B) = 4*w - 4*w/B
"""

import sympy

from derivations.smith_time_series import polynomials
from derivations.smith_time_series import w as real_w
from derivations.steps import At, Coefficient, Derivation, Taylor, defined

w, z, t, b, p, q, x = sympy.symbols("w z t b p q x", positive=True)
B, eta = sympy.symbols("B eta")
n, i = sympy.symbols("n i", integer=True, positive=True)

derivation = Derivation(
    "smith-series-radii",
    "The radii of convergence of sum f_n(w) z^n and of the double series",
    source="Smith 2012, (57), (61); motions.invariants.certified; z = w/D, dw/dtau = D, dz/dtau = 1 - 2wz + z^2"
    " (smith-time-series)",
)
step, asserts = derivation.step, derivation.asserts


def along(f: sympy.Expr) -> sympy.Expr:
    """d/dw along the motion, as a function of (w, B): dB/dtau = 2 dD/dtau = 2 w (B - 1), dw/dtau = B/2."""
    return sympy.expand(sympy.diff(f, w) + sympy.diff(f, B) * 2 * w * (B - 1) / (B / 2))


slope = defined("D_w", along)
step("With B = 2 D = 2w/z, a falling half-swing in the variable w obeys", slope(B), 4 * w - 4 * w / B)
step(
    "so B + ln(B - 1) - 2 w^2 is constant (A e^A e^(-2 w^2) with A = B - 1): in h = w^2, dB/dh = 2 - 2/B",
    slope(B + sympy.log(B - 1) - 2 * w**2),
    sympy.Integer(0),
)
zeta = 1 / B
step(
    "The time since w = 0 is F = int_0^w 2 dw'/B. At z = 0, zeta = 1/B = 0, all is regular:",
    slope(zeta),
    -4 * w * zeta**2 + 4 * w * zeta**3,
)
step(
    "hence F is analytic in z for fixed real w wherever B(w') != 0 on the way from w' = w to 0. Its coefficients are"
    " regular at w = 0 and obey (59) since dF/dtau = 1; they are the f_n. First: F = z + O(z^2), B = 2w/z",
    Coefficient(sympy.Integral(2 / (2 * w / z), (x, 0, w)), z, 1),
    sympy.Integer(1),
)

# The bad starting points.
step(
    "B = 0 is met at h_0 >= 0 by the two orbits that leave it, B^2 = -4 (h - h_0) + …: to lowest order -B^2/2 of",
    Taylor(B + sympy.log(1 - B), B, 2),
    -(B**2) / 2,
)
curve = -eta * sympy.cot(eta) + sympy.I * eta
A = sympy.Symbol("A")
step(
    "They are B = 1 + W_0(-e^(2(h-h_0)-1)) and its conjugate: A = -eta cot(eta) + i eta, 0 < eta < pi, has"
    " A sin(eta)/eta = -e^(-i eta), so A e^A is real and negative",
    At(A * sympy.sin(eta) / eta, {A: curve}),
    -(sympy.cos(eta) - sympy.I * sympy.sin(eta)),
)
log_size = sympy.log(eta / sympy.sin(eta)) - eta * sympy.cot(eta)
elapsed = (log_size + 1) / 2
re, im = 1 - eta * sympy.cot(eta), eta
P = re**2 + im**2
step(
    "|A e^A| = e^(2 (h - h_0) - 1) there, and eta grows with h: dh/deta = |B|^2/(2 eta)",
    sympy.Derivative(elapsed, eta),
    P / (2 * eta),
)
step("from h = h_0 at eta = 0", sympy.Limit(elapsed, eta, 0), sympy.Integer(0))
step(
    "Re B = 1 - eta cot(eta) grows from 0, because eta > sin(eta) cos(eta):",
    sympy.Derivative(re, eta),
    (eta - sympy.sin(eta) * sympy.cos(eta)) / sympy.sin(eta) ** 2,
)
step(
    "So P = |B|^2 = (Re B)^2 + eta^2 grows with h - h_0 <= w^2: all bad B = 2w/z lie in |B| <= |1 + W_0(-e^(2 w^2-1))|,"
    " and F is analytic for |z| < R(w) = |2w/(1 + W_0(-e^(2w^2-1)))| (w < 0: F(-w, -z) = -F(w, z))",
    sympy.Derivative(P, eta),
    2 * re * (eta - sympy.sin(eta) * sympy.cos(eta)) / sympy.sin(eta) ** 2 + 2 * eta,
)
y, eps = sympy.symbols("y epsilon", positive=True)
step(
    "On the circle F is infinite: as z -> 2w/B_0, h_0 = -y -> 0 (smoothly, since d(A + ln A)/dA = B/A != 0) and"
    " 2/B = const/sqrt(w'^2 + y) + bounded has the primitive",
    sympy.Derivative(sympy.log(t + sympy.sqrt(t**2 + y)), t),
    1 / sympy.sqrt(t**2 + y),
)
step(
    "which between 0 and epsilon grows like -ln(y)/2. Hence (57) has exactly the radius R(w)",
    sympy.Limit(sympy.log((eps + sympy.sqrt(eps**2 + y)) / sympy.sqrt(y)) + sympy.log(y) / 2, y, 0),
    sympy.log(2 * eps),
)

# The double series.
C, C_1, C_2 = sympy.symbols("C_i^n C_{i-1}^{n-1} C_i^{n-2}", positive=True)
sign, before = sympy.I ** (n - i - 1), sympy.I ** (n - i - 3)
step(
    "(59): (n + i) C_i^n = 2 (n-1) C_{i-1}^{n-1} - (n-2) C_i^{n-2}. With the signs (-1)^((n-i-1)/2) of all C taken out"
    " the right side is a sum of non-negative terms: by induction these are the signs",
    At(2 * (n - 1) * C_1 - (n - 2) * C_2, {C_1: sign * C_1, C_2: before * C_2}) / sign,
    2 * (n - 1) * C_1 + (n - 2) * C_2,
)
step(
    "At w = i p, z = -i q a term of F is -i |C_i^n| p^i q^n: i F(ip, -iq) = G is the sum of absolute values",
    At(C * w**i * z**n, {C: sign * C, w: sympy.I * p, z: -sympy.I * q}),
    -sympy.I * C * p**i * q**n,
)
step("There B = 2w/z is real and negative, B = -b,", At(2 * w / z, {w: sympy.I * p, z: -sympy.I * q}), -2 * p / q)
step(
    "and b obeys db/d(p^2) = 2 + 2/b, with the constant b - ln(1 + b) - 2 p^2",
    sympy.Derivative(b - sympy.log(1 + b), b) * (2 + 2 / b),
    sympy.Integer(2),
)
step(
    "b falls on the way back and reaches 0 just at p' = 0 if b - ln(1 + b) = 2 p^2, -(1+b) e^(-(1+b)) = -e^(-1-2p^2):"
    " b = -1 - W_(-1). For real q below rho = 2p/b G is analytic; at rho it is infinite, as above",
    At(-(1 + b) * sympy.exp(-(1 + b)), {sympy.exp(-(1 + b)): sympy.exp(-1 - 2 * p**2) / (1 + b)}),
    -sympy.exp(-1 - 2 * p**2),
)
asserts(
    "(f_n(i p)/i^(n-1), with the absolute values of all coefficients, is positive for n = 2 ... 7.) A series with"
    " coefficients >= 0 is singular at its radius (Pringsheim): (61) converges absolutely for |z| < rho and not for"
    " |z| >= rho. Absolute convergence is convergence: rho <= R",
    *(
        sympy.Gt(sympy.I ** (1 - number) * At(polynomials[number], {real_w: sympy.I * p}), 0, evaluate=False)
        for number in range(2, 8)
    ),
)

# Both radii fall from 1.
step(
    "rho^2 = 4 p^2/b^2 = 2 (b - ln(1+b))/b^2 = int_0^1 2t/(1 + bt) dt falls from 1 as b grows",
    sympy.Integral(2 * t / (1 + b * t), (t, 0, 1)),
    2 * (b - sympy.log(1 + b)) / b**2,
)
step("and at b = 0 it is", sympy.Limit(2 * (b - sympy.log(1 + b)) / b**2, b, 0), sympy.Integer(1))
step(
    "R^2 = 4h/P, P = |B|^2. With dh/deta = P/(2 eta) it falls if 2h > P^2/(eta P'); at eta = 0 both vanish, and the"
    " derivatives compare as (eta P')'/(eta P') > P'/P. For Q(eta) in the place of P,",
    sympy.Derivative(sympy.Function("Q")(eta) ** 2 / (eta * sympy.Derivative(sympy.Function("Q")(eta), eta)), eta)
    - sympy.Function("Q")(eta) / eta,
    -(sympy.Function("Q")(eta) ** 2 / (eta * sympy.Derivative(sympy.Function("Q")(eta), eta)))
    * sympy.Derivative(
        sympy.log(eta * sympy.Derivative(sympy.Function("Q")(eta), eta) / sympy.Function("Q")(eta)), eta
    ),
)
S_0, S_1 = (sympy.Function(name)(eta) for name in ("S_0", "S_1"))  # S_j = sum n^j P_n eta^n
S_2, middle = sympy.symbols("S_2 mu")
step(
    "eta P'/P = S_1/S_0, S_j = sum n^j P_n eta^n, is a mean of the degrees with the weights P_n eta^n >= 0. With eta"
    " S_j' = S_(j+1) its derivative, times eta, is",
    At(eta * sympy.Derivative(S_1 / S_0, eta), {sympy.diff(S_1, eta): S_2 / eta, sympy.diff(S_0, eta): S_1 / eta}),
    S_2 / S_0 - (S_1 / S_0) ** 2,
)
step(
    "their variance, sum (n - mu)^2 P_n eta^n = S_2 - 2 mu S_1 + mu^2 S_0 over S_0 at mu = S_1/S_0: not negative",
    At((S_2 - 2 * middle * S_1 + middle**2 * S_0) / S_0, {middle: S_1 / S_0}),
    S_2 / S_0 - (S_1 / S_0) ** 2,
)
j = sympy.Symbol("j", integer=True, positive=True)
step(
    "The weights are not negative: by Euler's product sin(eta) = eta prod_j (1 - (eta/(pi j))^2), 1 - eta cot(eta) is"
    " the sum over j of",
    -eta * sympy.Derivative(sympy.log(1 - (eta / (sympy.pi * j)) ** 2), eta),
    2 * (eta / (sympy.pi * j)) ** 2 / (1 - (eta / (sympy.pi * j)) ** 2),
)
step(
    "each a geometric series in (eta/(pi j))^2: 1 - eta cot(eta) = 2 sum zeta(2k) (eta/pi)^(2k), which begins with",
    Taylor(re, eta, 6),
    2 * sum(sympy.zeta(2 * j, evaluate=False) * (eta / sympy.pi) ** (2 * j) for j in (1, 2, 3)),
)
step("so R falls, from the limit P/(4h) at eta = 0", sympy.Limit(P / (4 * elapsed), eta, 0), sympy.Integer(1))
