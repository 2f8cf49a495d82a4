"""The model of the paper in its own letters, from which its statements are checked: laws of motion, S, orbit, series.

Falling means v < 0 (upper signs, the paper's S^-), rising v > 0 (lower signs, S^+).  In tau = omega t the state
u = gamma x, w = gamma v/omega obeys du/dtau = w and dw/dtau = w^2 - u (falling) or -w^2 - u (rising).

>>> sympy.simplify(rate(S_falling(u, w), falling=True))
0
>>> [str(c) for c in polynomial_row(3)]
['-1/3', '0', '8/15']
"""

from fractions import Fraction
from functools import cache

import sympy
from flint import arb

from asymptotics.numbers.bridge import closed_form_ball
from asymptotics.numbers.context import ctx
from paper_checks.evidence import Difference, differ, mark
from paper_checks.forms import tex
from paper_checks.identities import decided
from paper_checks.verdict import Evidence, Outcome

PAPER = "smith2012"
x, v, t, gamma, omega = sympy.symbols("x v t gamma omega", positive=True)
u, w, u0, u1, u2 = sympy.symbols("u w u_0 u_1 u_2", positive=True)
z = sympy.Symbol("z", positive=True)
n, i, k, m = sympy.symbols("n i k m", integer=True, positive=True)

HALF, QUARTER = sympy.Rational(1, 2), sympy.Rational(1, 4)
FALLING_FORCE = gamma * v**2 - omega**2 * x  # the acceleration for v < 0
RISING_FORCE = -gamma * v**2 - omega**2 * x
Z_OF_STATE = omega * v / FALLING_FORCE  # the second variable of the series (57)


def S_falling(u: sympy.Expr, w: sympy.Expr) -> sympy.Expr:
    """The first constant of the falling half-swing, e^(-2u)(w^2/2 - u/2 - 1/4)."""
    return sympy.exp(-2 * u) * (HALF * w**2 - HALF * u - QUARTER)


def S_rising(u: sympy.Expr, w: sympy.Expr) -> sympy.Expr:
    """The first constant of the rising half-swing: the falling one at the mirrored state (-u, -w)."""
    return S_falling(-u, -w)


def rate(expression: sympy.Expr, *, falling: bool) -> sympy.Expr:
    """d(expression)/dtau along the motion."""
    force = (w**2 if falling else -(w**2)) - u
    return w * sympy.diff(expression, u) + force * sympy.diff(expression, w)


def physical(expression: sympy.Expr) -> sympy.Expr:
    """An expression in u and w, written in x and v."""
    return expression.subs({u: gamma * x, w: gamma * v / omega}, simultaneous=True)


def same_polynomial(left: sympy.Expr, right: sympy.Expr) -> Outcome:
    """Equality of polynomials in whatever atoms occur (derivatives included): decided by expansion, both ways."""
    mark(Evidence.PROVED)
    equal = sympy.expand(left - right) == 0
    if not equal:
        differ(lambda: Difference(tex(left), "=", tex(right)))
    return decided(equal)


@cache
def polynomial_row(n: int) -> tuple[Fraction, ...]:
    """The coefficients C_0^n, ..., C_(n-1)^n of f_n, exact, by integrating (59d).

    f_n = w^(-n) int_0^w (2(n-1) w^n f_(n-1) - (n-2) w^(n-1) f_(n-2)) dw; for n = 1 the only solution of (59b) that is
    regular at w = 0 is f_1 = 1.
    """
    if n == 1:
        return (Fraction(1),)
    integrand = [Fraction(0)] * (2 * n)
    for j, c in enumerate(polynomial_row(n - 1)):
        integrand[n + j] += 2 * (n - 1) * c
    for j, c in enumerate(polynomial_row(n - 2) if n > 2 else ()):
        integrand[n - 1 + j] -= (n - 2) * c
    antiderivative = [Fraction(0)] + [c / (p + 1) for p, c in enumerate(integrand)]
    return tuple(antiderivative[n : 2 * n])


def coefficient(n: int, i: int) -> Fraction:
    """C_i^n, zero outside 0 <= i < n."""
    return polynomial_row(n)[i] if 0 <= i < n else Fraction(0)


def orbit(length: int) -> list[arb]:
    """Balls for the turning points u_0 = 1, u_1, ..., signed: 2|u_(n+1)| = 1 + W_0(-y e^(-y)), y = 1 + 2|u_n|."""
    points = [arb(1)]
    for index in range(1, length):
        y = 1 + 2 * abs(points[-1])
        size = (1 + (-y * (-y).exp()).lambertw()) / 2
        points.append(-size if index % 2 else size)
    return points


def invariant(index: int, point: arb) -> arb:
    """S^- (even index) or S^+ (odd index) at a turning point, which starts the half-cycle with that index."""
    sign = 1 if index % 2 == 0 else -1
    return -(-2 * sign * point).exp() * (2 * sign * point + 1) / 4


def excludes_zero_on_orbit(difference: sympy.Expr) -> bool:
    """Whether an expression in u_0 and u_1 is certainly nonzero on one of two orbits, from u_0 = 1 and u_0 = 3/5."""
    for start in (sympy.Integer(1), sympy.Rational(3, 5)):
        y = 1 + 2 * start
        first = -(1 + sympy.LambertW(-y * sympy.exp(-y))) / 2
        with ctx.workprec(200):
            ball = closed_form_ball(difference.subs({u0: start, u1: first}))
        if ball.is_finite() and not ball.contains(0):
            return True
    return False


def vanishes_on_orbit(difference: sympy.Expr) -> Outcome:
    """Whether an expression in u_0 and u_1 is zero because of (43), which eliminates e^(-2 u_0)."""
    if excludes_zero_on_orbit(difference):
        return Outcome.REFUTED
    partner = sympy.exp(-2 * u1) * (2 * u1 + 1) / (2 * u0 + 1)
    reduced = sympy.simplify(sympy.expand(difference).subs(sympy.exp(-2 * u0), partner))
    mark(Evidence.PROVED)
    return Outcome.CONFIRMED if reduced == 0 else Outcome.UNDECIDED
