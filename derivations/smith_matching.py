"""Smith's constant over all cycles: (40), the matching (47) at a turning point, and from it (48), (49), (51), (52).

>>> print(derivation.steps[4].text())
Subs(S(s, u, w), (s, u, w), (-1, u_1, 0)) = (u_1/2 - 1/4)*exp(2*u_1)
"""

import sympy
from sympy import Derivative, Rational, exp

from derivations.steps import At, Derivation, Solution, Taylor, defined

u, w, S_1 = sympy.symbols("u w S_1", real=True)
s = sympy.Symbol("s", nonzero=True, real=True)
u_0, u_1 = sympy.symbols("u_0 u_1", real=True)
r, r_next = sympy.symbols("r_n r_{n+1}", positive=True)
quarter = Rational(1, 4)

derivation = Derivation(
    "smith-matching",
    "One constant for all half-cycles: Smith's patches at the turning points",
    source="Smith 2012, (40), (42), (47)-(52); smith-integrating-factor has (40) from (38b)",
)
step, asserts = derivation.step, derivation.asserts

S = defined("S", lambda s, u, w: exp(-2 * s * u) * (w**2 / 2 - s * u / 2 - quarter))
rate = w * Derivative(S(s, u, w), u) + (-u + s * w**2) * Derivative(S(s, u, w), w)
step("(40): S with s = 1 while w < 0 is constant along u' = w, w' = -u + s w^2", At(rate, {s: 1}), 0)
step("and with s = -1 while w > 0", At(rate, {s: -1}), 0)
step(
    "Near miss: the exponents of the printed (40) have the other sign, and the rate is no 0: over w e^(2u), s = 1,",
    (w * Derivative(exp(2 * u) * S(1, u, w) * exp(2 * u), u) + (-u + w**2) * Derivative(exp(4 * u) * S(1, u, w), w))
    / (w * exp(2 * u)),
    2 * w**2 - 2 * u - 1,
)
step(
    "(42): S^- on the first half-cycle, from rest at u_0",
    At(S(s, u, w), {s: 1, u: u_0, w: 0}),
    -exp(-2 * u_0) * (u_0 / 2 + quarter),
)
step(
    "(48): S^+ after the first turning point, w = 0 at u_1.  The paper prints the other sign",
    At(S(s, u, w), {s: -1, u: u_1, w: 0}),
    exp(2 * u_1) * (u_1 / 2 - quarter),
    corrects=("smith2012:48",),
)
step(
    "(47), S^- = S^+ + S_1, makes the sum continuous at u_1: (49), S_1.  The second term is (42), with + 1/4",
    Solution(S(1, u_0, 0), S(-1, u_1, 0) + S_1, S_1),
    -exp(2 * u_1) * (u_1 / 2 - quarter) - exp(-2 * u_0) * (u_0 / 2 + quarter),
    corrects=("smith2012:49",),
)

# All half-cycles: s_n = (-1)^n, s_n u_n = r_n = |u_n|, s_n u_(n+1) = -r_(n+1).
step(
    "Half-cycle n runs from s u = r_n = |u_n| to s u = -r_{n+1}, s = (-1)^n.  S - S_n at its ends: (52a), s = 1",
    At(S(s, u, w), {s: 1, w: 0}),
    -quarter * exp(-2 * u) * (2 * u + 1),
    corrects=("smith2012:52a", "smith2012:claim.second-cycle"),
)
step(
    "and (52b), s = -1",
    At(S(s, u, w), {s: -1, w: 0}),
    quarter * exp(2 * u) * (2 * u - 1),
    corrects=("smith2012:51", "smith2012:52b"),
)
step(
    "both are the same in r_n, for s = 1 and s = -1: S - S_n at the start, times s^2 = 1,",
    At(At(S(s, u, w), {u: r / s, w: 0}), {s: -1}),
    At(S(s, u, w), {s: 1, u: r, w: 0}),
)
end = At(S(s, u, w), {u: -r_next / s, w: 0})
step("and at the end", end, -quarter * exp(2 * r_next) * (1 - 2 * r_next))
step(
    "The two are equal: times -4 (43), and (51) for each later half-cycle, (1 + 2 r_n) e^(-2 r_n) is at the end",
    -4 * end,
    (1 - 2 * r_next) * exp(2 * r_next),
)
jump = r_next * (exp(2 * r_next) + exp(-2 * r_next)) / 2 - (exp(2 * r_next) - exp(-2 * r_next)) / 4
step(
    "The next constant, S_(n+1) - S_n: what S jumps by at u_{n+1}, where s u = -r_{n+1} before and r_{n+1} after:"
    " r cosh 2r - (sinh 2r)/2",
    end - At(S(s, u, w), {s: 1, u: r_next, w: 0}),
    jump,
    corrects=("smith2012:table1.S3", "smith2012:table1.S5"),
)
step(
    "which is positive: it is 0 at r = 0 and grows at the rate 2 r sinh 2r, so the S_n rise",
    Derivative(jump, r_next),
    r_next * (exp(2 * r_next) - exp(-2 * r_next)),
)
step("by 4 r^3/3 where the motion has become small", Taylor(jump, r_next, 3), Rational(4, 3) * r_next**3)
asserts(
    "Without the patches, with S^- = S^+ at u_1, the sum would jump there: the difference is not 0",
    sympy.Ne(At(S(s, u, w), {s: 1, u: -r, w: 0}), At(S(s, u, w), {s: -1, u: -r, w: 0}), evaluate=False),
)
