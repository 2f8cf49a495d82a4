"""In any well the squares of the speeds of two motions at equal places draw together: turning points do not part.

On a swing towards smaller u the motion is u' = -w, w' = s_0(u) - h(u, w), w >= 0, h increasing in w (losses), s_0 the
spring less the dry friction.  Nothing is asked of the spring but that both motions have a next turning point.

>>> print(derivation.steps[2].text())
Derivative(e*w**a, w) = a*e*w**(a - 1)
"""

import sympy

from derivations.steps import At, Derivation

w, w1, w2, eps, e, p, D, fast, brake, tau, a = sympy.symbols("w w_1 w_2 epsilon e p D s_max b tau a", positive=True)
s0, h, h1, h2, u = sympy.symbols("s_0 h h_1 h_2 u", real=True)

derivation = Derivation(
    "wells-contract",
    "Turning points in any well do not part",
    source="comparison of orbits in the phase plane; Liouville's formula for the linear loss",
)
step, asserts = derivation.step, derivation.asserts

f = sympy.Function("w")(u)
step(
    "The square of the speed as a function of the place: dw/du = w'/u' = (s_0 - h)/(-w)",
    At(sympy.Derivative(f**2 / 2, u), {sympy.Derivative(f, u): (s0 - h) / -f}),
    h - s0,
)
first, second = sympy.Function("w_1")(u), sympy.Function("w_2")(u)
slopes = {sympy.Derivative(first, u): (s0 - h1) / -first, sympy.Derivative(second, u): (s0 - h2) / -second}
step(
    "D = (w_1^2 - w_2^2)/2 of two motions at equal places: s_0 drops out of dD/du",
    At(sympy.Derivative((first**2 - second**2) / 2, u), slopes),
    h1 - h2,
)
step(
    "which is >= 0 where w_1 >= w_2, as each loss epsilon |u|^m w^alpha (here e w^alpha) grows with w; u falls, so D"
    " falls, and it does not change its sign: equal squares stay equal",
    sympy.Derivative(e * w**a, w),
    a * e * w ** (a - 1),
)
step(
    "The first end.  From rest at p and p - e: at the place p - e one is at rest, the other has gained at most",
    sympy.Integral(fast, (u, p - e, p)),
    e * fast,
)
step(
    "The last end.  The first to turn does so where the other has w^2/2 = D; its w^2/2 then falls at least at the rate"
    " b = min |s_0| for each unit of length, so it turns within D/b:",
    At(D - brake * u, {u: D / brake}),
    0,
)
step(
    "Together |u_1 - u~_1| <= e s_max/b.  With a linear loss epsilon w among the losses dD/du >= epsilon (w_1 - w_2)",
    At(eps * (w1 - w2) / D, {D: (w1**2 - w2**2) / 2}),
    2 * eps / (w1 + w2),
)
step(
    "times D, and 2/(w_1 + w_2) >= 1/w_1; -du/w_1 is the time of the faster motion: d ln D/d tau <= -epsilon, that is",
    sympy.Derivative(D * sympy.exp(-eps * tau), tau) / (D * sympy.exp(-eps * tau)),
    -eps,
)
ahead = sympy.Symbol("d", nonnegative=True)
asserts(
    "where the slack is not negative for w_1 = w_2 + d >= w_2",
    sympy.Ge(2 / ((w2 + ahead) + w2), 1 / (w2 + ahead), evaluate=False),
)
step(
    "The time that the faster motion spends where the other never is.  From rest through a length e at an acceleration"
    " of at least a/2:",
    At(a / 2 * tau**2 / 2, {tau: 2 * sympy.sqrt(e / a)}),
    e,
)
step(
    "and from w^2/2 <= D to rest at a rate of at least b: at most w/b",
    At(w / brake, {w: sympy.sqrt(2 * D)}),
    sympy.sqrt(2 * D) / brake,
)
