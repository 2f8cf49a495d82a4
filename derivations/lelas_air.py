"""Lelas' trick for air resistance (34)-(46), then for every exponent: 2^{-(alpha+1)/2} in the place of M_(alpha+1).

>>> derivation.steps[-1].text()
'3*sqrt(2)*pi/16 < 1,  8*sqrt(2)/(3*pi) > 6/5'
"""

import sympy

from asymptotics.expansions.moments.symbolic import squaring_moment
from derivations.steps import At, Derivation, Solution

C, m, k, x_0, omega_0, t, sine, f, r = sympy.symbols("C m k x_0 omega_0 t s f r", positive=True)
alpha, epsilon, tau, q, y, R, theta = sympy.symbols("alpha epsilon tau q y R theta", positive=True)
sqrt, diff = sympy.sqrt, sympy.diff
two_thirds = sympy.Rational(2, 3)

derivation = Derivation(
    "lelas-air",
    "The trick for air resistance and for any exponent",
    source="Lelas 2024, (34)-(46), (53); lelas2024:38, 40, 42, 43, 45, 46, 53; other exponents are not in the paper",
)
step = derivation.step

amplitude = sympy.Function("f", positive=True)(t)
energy = m * omega_0**2 * x_0**2 * amplitude**2 / 2  # (14)
for number, wave in ((38, sympy.sin(omega_0 * t)), (39, sympy.cos(omega_0 * t))):
    step(
        f"({number}): dE/dt of (15) is the power -C |v|^3 of ({number - 2}); solved for df/dt",
        -Solution(
            sympy.Derivative(energy, t),
            -C * (omega_0 * x_0 * amplitude) ** 3 * sympy.Abs(wave) ** 3,
            sympy.Derivative(amplitude, t),
        ),
        C * omega_0 * x_0 / m * amplitude**2 * sympy.Abs(wave) ** 3,
        proves=(f"lelas2024:{number}",),
    )
first = C * omega_0 * x_0 / m * f**2 * sine**3  # -df/dt, with sine = |sin(omega_0 t)|
cosine = sqrt(1 - sine**2)
size = sympy.Symbol("c", positive=True)  # |cos(omega_0 t)|
second = first.subs(sine, size)
scale = sympy.powdenest((C * omega_0 * x_0 / m * f**2) ** two_thirds, force=True)
step("(40): to the power 2/3", At(R**two_thirds, {R: first}), scale * sine**2, proves=("lelas2024:40",))
step("(41)", At(R**two_thirds, {R: second}), scale * size**2, proves=("lelas2024:41",))
slope = C * omega_0 * x_0 / (2 * sqrt(2) * m) * f**2  # -df/dt
step(
    "(42): (40) + (41), with one rate for both",
    Solution(2 * R, At(scale * (sine**2 + size**2), {size: cosine}), R),
    scale / 2,
    proves=("lelas2024:42",),
)
step("(43): to the power 3/2", At(R ** sympy.Rational(3, 2), {R: scale / 2}), slope, proves=("lelas2024:43",))
solution = 1 / (1 + C * omega_0 * x_0 * t / (2 * sqrt(2) * m))
step("(45) solves (43)", -sympy.Derivative(solution, t), slope.subs(f, solution))
step("with f(0) = 1", At(solution, {t: 0}), sympy.Integer(1))
step("(46): |df/dt|/omega_0 at the start", At(slope, {f: 1}) / omega_0, C * x_0 / (2 ** sympy.Rational(3, 2) * m))
bound = (2 * sqrt(2) * m / x_0).subs({m: sympy.Rational(3, 2), x_0: sympy.Rational(1, 5)})
derivation.asserts(
    "(53): 21.21 to four digits, for m = 3/2 and x_0 = 1/5",
    sympy.Lt(sympy.Abs(bound - sympy.Rational(2121, 100)), sympy.Rational(1, 200), evaluate=False),
)

p = alpha + 1
general, other = (epsilon ** (2 / p) * f ** (2 * alpha / p) * u**2 for u in (sine, size))
for u, power in ((sine, general), (size, other)):
    step(
        "Any alpha: -df/dtau = epsilon f^alpha u^{alpha+1}, u = |sin|, |cos|, to the power 2/(alpha+1)",
        At(R ** (2 / p), {R: epsilon * f**alpha * u**p}),
        power,
    )
step(
    "added",
    At(general + other, {size: cosine}),
    sympy.powdenest((epsilon * f**alpha) ** (2 / p), force=True),
)
trick = squaring_moment(alpha) * epsilon * f**alpha
step(
    "so -df/dtau = 2^{-(alpha+1)/2} epsilon f^alpha: Lancaster's law with M_(alpha+1) replaced",
    2 * At(R ** (2 / p), {R: trick}),
    sympy.powdenest((epsilon * f**alpha) ** (2 / p), force=True),
)
mean_square = sympy.Integral(sympy.sin(theta) ** 2, (theta, 0, sympy.pi)) / sympy.pi
step("The replacement is a power mean too: M_2^{(alpha+1)/2}", mean_square ** (p / 2), squaring_moment(alpha))
convex = y**q
step(
    "Jensen: y^q, q = (alpha+1)/2, y = sin^2, has the second derivative",
    sympy.Derivative(convex, y, 2),
    q * (q - 1) * y ** (q - 2),
)
middle = sympy.Symbol("y_0", positive=True)
above = y**q - middle**q - q * middle ** (q - 1) * (y - middle)
step(
    "so has y^q less its tangent at y_0, which begins there with 0 and with slope 0",
    sympy.Tuple(At(above, {y: middle}), At(sympy.Derivative(above, y), {y: middle}), sympy.Derivative(above, y, 2)),
    sympy.Tuple(0, 0, q * (q - 1) * y ** (q - 2)),
)
step(
    "At y_0 = <y> = 1/2 the mean of the linear term is 0: that of the difference is <y^q> - <y>^q, and its sign is",
    sympy.Integral(sympy.sin(theta) ** 2 - sympy.Rational(1, 2), (theta, 0, sympy.pi)) / sympy.pi,
    0,
)
for reason, value in (
    ("positive for alpha = 1 + 2 r > 1, q = 1 + r: M_(alpha+1) = <y^q> > <y>^q, underestimated", 1 + r),
    ("negative for 0 <= alpha < 1, q = 1/(1 + r): overestimated", 1 / (1 + r)),
):
    curvature = At(q * (q - 1) * y ** (q - 2), {q: value})
    relation = sympy.Gt if value == 1 + r else sympy.Lt
    derivation.asserts(reason, relation(curvature, 0, evaluate=False))
for exponent, value in ((1, sympy.Integer(1)), (2, 3 * sqrt(2) * sympy.pi / 16)):
    step(
        f"The ratio of the rates has no epsilon in it: alpha = {exponent}",
        At(2 ** (-p / 2), {alpha: exponent})
        / (sympy.Integral(sympy.sin(theta) ** (exponent + 1), (theta, 0, sympy.pi)) / sympy.pi),
        value,
    )
rates = [sympy.Rational(1, 2) / sqrt(2), 4 / (3 * sympy.pi)]  # of (45) and of (52), in C omega_0 x_0/m
quotient = (1 + rates[1] * tau) / (1 + rates[0] * tau)
step("f/f~ of (45) and (52), in tau = C omega_0 x_0 t/m, begins with", At(quotient, {tau: 0}), sympy.Integer(1))
step(
    "rises: its slope has the sign of 4/(3 pi) - 1/(2 sqrt 2)",
    sympy.Derivative(quotient, tau) * (1 + rates[0] * tau) ** 2,
    rates[1] - rates[0],
)
step(
    "and tends to 8 sqrt 2/(3 pi) = 1.2004, whatever C",
    sympy.Limit(quotient, tau, sympy.oo),
    8 * sqrt(2) / (3 * sympy.pi),
)
derivation.asserts(
    "The slope is positive, so 1 <= f/f~ < 1.2004: (45) decays more slowly",
    sympy.Gt(rates[1] - rates[0], 0, evaluate=False),
    proves=("lelas2024:claim.agrees-well",),
)
derivation.asserts(
    "by 0.833 of the rate: the trick loses a sixth of the damping, and at last a fifth of the amplitude",
    sympy.Lt(rates[0] / rates[1], 1, evaluate=False),
    sympy.Gt(8 * sqrt(2) / (3 * sympy.pi), sympy.Rational(6, 5), evaluate=False),
    proves=("lelas2024:claim.slower-decay",),
)
