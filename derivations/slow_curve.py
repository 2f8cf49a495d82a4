"""Creep for alpha < 1 to all orders: curves beside the slow curve that the motion crosses one way only.

>>> len(derivation.steps) > 8
True
"""

import sympy

from derivations.steps import At, Derivation

w, e, h = sympy.symbols("w epsilon h", positive=True)
a = sympy.Symbol("alpha", positive=True)
s, theta = sympy.symbols("s theta")
c = sympy.symbols("c_1:4")

derivation = Derivation(
    "slow-curve",
    "Creep for 0 < alpha < 1 between two barriers",
    source="derivation creep; asymptotics.swing.slow",
)
step, holds = derivation.step, derivation.holds

size = w ** (2 - 2 * a) / e**2
step("Let s be the square of w/(e w^alpha):", (w / (e * w**a)) ** 2, size)
b = (*c[:2], theta)  # the curve with n = 2 coefficients of the series and theta in the place of the third
B = sum(coefficient * s**k for k, coefficient in enumerate(b, start=1))
A = a - sum((a + 2 * (1 - a) * k) * coefficient * s**k for k, coefficient in enumerate(b, start=1))
curve = e * w**a * (1 - B.subs(s, size))
step(
    "On the curve y = Y(w) = e w^alpha (1 - B(s)) the slope w Y'/(e w^alpha) is A(s), here for B = c_1 s + c_2 s^2 +"
    " theta s^3",
    w * sympy.Derivative(curve, w) / (e * w**a),
    A.subs(s, size),
)
drift = -w - sympy.Derivative(curve, w) * (curve - e * w**a)
step(
    "y' = -w and w' = y - e w^alpha: there y - Y(w) changes at the rate -w - Y'(w) (Y - e w^alpha), divided by w",
    drift / w,
    sympy.expand(-1 + (A * B / s).subs(s, size)),
)
first, second = 1 / a, (a + 2 * (1 - a)) / a**3
third = sympy.simplify((2 * a + 2 * (1 - a) * 3) * first * second / a)
known = {c[0]: first, c[1]: second}
rate = sympy.expand((A * B / s - 1).subs(known))
step("alpha c_1 = 1 and alpha c_2 = (alpha + 2(1-alpha)) c_1^2: the rate has no term s^0,", At(rate, {s: 0}), 0)
step("no term s,", At(sympy.Derivative(rate, s), {s: 0}), 0)
step(
    "and its term s^n is alpha (theta - c_(n+1)), with alpha c_3 = (2 alpha + 2 (1-alpha) 3) c_1 c_2",
    At(sympy.Derivative(rate, s, 2), {s: 0}) / 2,
    a * (theta - third),
)
step(
    "in general alpha c_m = sum_k (alpha + 2(1-alpha)k) c_k c_(m-k), here for m = 3",
    (a + 2 * (1 - a)) * first * second + (a + 4 * (1 - a)) * second * first,
    a * third,
)
highest = sympy.Poly(rate, s).degree()
holds(
    "So for theta = c_(n+1) +- h the rate is +-alpha h s^n and the powers s^(n+1), ..., s^(2n+1), whose coefficients"
    " are those of the polynomial A B: if they add up to less than alpha h s^n at some s they do so at all smaller s",
    highest == 2 * 2 + 1,
    sympy.Lt(sympy.Symbol("r"), a * h * s**2, evaluate=False),
)
step(
    "The motion crosses the curve with c_(n+1) - h towards smaller y and the other towards greater y: it stays in"
    " between.  There, at a height y, the curve with the greater theta has the greater w: d ln w/d theta is",
    -sympy.Derivative(-e * w**a * theta * size**3, theta) / (e * w**a * sympy.Symbol("A")),
    size**3 / sympy.Symbol("A"),
)
step(
    "as d y/d ln w = e w^alpha A > 0.  As y' = -w, y falls slowest on the curve with c_(n+1) - h and fastest on the"
    " other.  Time on a curve: dt = -dY/w, and the antiderivative of Y'/w is",
    sympy.Derivative(
        e
        * w ** (a - 1)
        / (1 - a)
        * (-a + sum(-(a + 2 * (1 - a) * k) * q * size**k / (2 * k - 1) for k, q in enumerate(b, 1))),
        w,
    ),
    sympy.expand(e * w ** (a - 2) * A.subs(s, size)),
)
k = sympy.Symbol("k", integer=True)
step(
    "whose divisors 2k - 1 never vanish: w^(alpha-1) s^k has the exponent",
    sympy.expand(a - 1 + (2 - 2 * a) * k),
    (1 - a) * (2 * k - 1),
)
