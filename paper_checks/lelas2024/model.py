"""The model of the paper in its own letters, and the exact motions against which its approximations are measured.

In the units x0 = omega_0 = m = 1 the three laws are X'' + X + eps X'|X'|^(n-1) = 0 with n = 1 (viscous, eps = b/(m
omega_0)), n = 0 (friction, eps = mu g/(omega_0^2 x0) = mu m g/(k x0)) and n = 2 (air, eps = C x0/m).

>>> x = coulomb(mpf("0.1"))                                         # turning points 1, -0.8, 0.6, ... at 0, pi, 2 pi
>>> [float(round(x(n * pi), 10)) for n in range(3)]
[1.0, -0.8, 0.6]
>>> float(round(order_of(lambda eps: eps**2, ("0.02", "0.01")), 10))
2.0
"""

from collections.abc import Callable, Sequence
from fractions import Fraction
from itertools import islice

import sympy
from flint import arb
from mpmath import cos, log, mp, mpf, pi, sin, sqrt

from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimal_context import workdps
from asymptotics.turning.quadratic_duration import duration, elapsed
from asymptotics.turning.quadratic_map import amplitudes
from paper_checks.evidence import mark, sampled
from paper_checks.identities import not_of_order
from paper_checks.units import SYSTEMS, agreed
from paper_checks.verdict import Evidence, Outcome

PAPER = "lelas2024"
m, k, g, mu, C, b, x0, A0, B0, t = sympy.symbols("m k g mu C b x_0 A_0 B_0 t", positive=True)
w0 = sympy.Symbol("omega_0", positive=True)
theta = sympy.Symbol("theta", positive=True)  # omega_0 t
f, rate = sympy.symbols("f r", positive=True)  # the amplitude f(t) >= 0 and r = -df/dt
slope, x, v = sympy.symbols("fdot x v", real=True)
s = sympy.Symbol("s", positive=True)  # |sin(omega_0 t)|
c = sympy.sqrt(1 - s**2)  # |cos(omega_0 t)|

FRICTION = {m: sympy.Rational(3, 2), k: 30, x0: sympy.Rational(1, 5), g: sympy.Rational(981, 100)}  # section V
SMALL = ("0.015625", "0.0078125")  # 1/64 and 1/128
DIGITS = 25
Motion = Callable[[mpf], mpf]


def in_physical_units(expression: sympy.Expr) -> sympy.Expr:
    """An expression with omega_0, where omega_0^2 = k/m."""
    return expression.subs(w0, sympy.sqrt(k / m))


def viscous(eps: mpf, *, kicked: bool = False) -> Motion:
    """The exact motion X(tau) from (1, 0), or from (0, 1) if kicked; 0 < eps < 2."""
    beta, freq = eps / 2, sqrt(1 - eps**2 / 4)
    if kicked:
        return lambda tau: mp.exp(-beta * tau) * sin(freq * tau) / freq
    return lambda tau: mp.exp(-beta * tau) * (cos(freq * tau) + beta / freq * sin(freq * tau))


def viscous_velocity(eps: mpf, *, kicked: bool = False) -> Motion:
    """The velocity of the same motion."""
    beta, freq = eps / 2, sqrt(1 - eps**2 / 4)
    if kicked:
        return lambda tau: mp.exp(-beta * tau) * (cos(freq * tau) - beta / freq * sin(freq * tau))
    return lambda tau: -mp.exp(-beta * tau) * sin(freq * tau) / freq


def coulomb(eps: mpf) -> Motion:
    """The exact motion with friction from (1, 0): about +-eps on each half-swing, amplitudes falling by 2 eps.

    At the first turning point |x| <= eps the mass stays.
    """
    last = half_swings(Fraction(str(eps)))

    def position(tau: mpf) -> mpf:
        n = min(int(tau / pi), last - 1)
        side = 1 if n % 2 == 0 else -1
        return (1 - (2 * n + 1) * eps) * cos(min(tau, last * pi)) + side * eps

    return position


def half_swings(eps: Fraction) -> int:
    """The number of half-swings until the mass sticks: the smallest n with |1 - 2 n eps| <= eps, exact.

    >>> half_swings(Fraction(1, 10)), half_swings(Fraction(1, 9))
    (5, 4)
    """
    n = 0
    while abs(1 - 2 * n * eps) > eps:
        n += 1
    return n


def air(eps: mpf, swings: int, angle: Fraction) -> tuple[mpf, mpf]:
    """(tau, X) on half-swing number ``swings`` (from 0), at the phase ``angle`` pi of it; midpoints of narrow balls."""
    sizes = list(islice(amplitudes(2 * arb(str(eps))), swings + 2))
    before = sum((duration(p, q) for p, q in zip(sizes[:swings], sizes[1:])), arb(0))
    p, q = sizes[swings:]
    chi = arb.pi() * angle.numerator / angle.denominator
    place = (p - (p + q) * (1 - chi.cos()) / 2) / (2 * arb(str(eps))) * (-1) ** swings
    return as_mpf(before + elapsed(p, q, chi)), as_mpf(place)


def as_mpf(ball: arb) -> mpf:
    """The midpoint of a ball, for heuristic use."""
    return mpf(ball.str(30, radius=False))


def order_of(error: Callable[[mpf], mpf], values: Sequence[str] = SMALL) -> float:
    """log_2 of the ratio of the errors at two values of the small parameter, the second half the first."""
    mark(Evidence.MEASURED)
    with workdps(DIGITS), ctx.workprec(120):
        coarse, fine = (abs(error(mpf(value))) for value in sampled(values[-2:]))
        return float(log(coarse / fine) / log(2)) if fine else float("inf")


def has_order(wanted: int, error: Callable[[mpf], mpf], values: Sequence[str] = SMALL) -> Outcome:
    """CONFIRMED if the measured order is near the wanted one, REFUTED if it is near another or above it."""
    order = order_of(error, values)
    if abs(order - wanted) < 0.25:
        return Outcome.CONFIRMED
    return not_of_order(order, wanted) if abs(order - wanted) > 0.75 else Outcome.UNDECIDED


def dimensionless(form: sympy.Expr, law: sympy.Symbol, unit: sympy.Expr = x0) -> Callable[[mpf, mpf], mpf]:
    """A form in the letters of one law (b, mu or C), over ``unit``, as a function of (eps, tau) with tau = omega_0 t.

    It is computed in two systems of units, which must agree.
    """
    eps, tau = sympy.symbols("eps tau", positive=True)
    scale = {b: m * w0, mu: w0**2 * x0 / g, C: m / x0}[law]
    value = (form / unit).subs({law: eps * scale, t: tau / w0}).subs(k, m * w0**2)
    compiled = [
        sympy.lambdify((eps, tau), value.subs({m: mass, w0: rate, x0: length, g: gravity}), "mpmath")
        for mass, rate, length, gravity in SYSTEMS
    ]
    return lambda e, s: agreed(*(f(e, s) for f in compiled))


def slow_error(
    form: sympy.Expr, strength: sympy.Symbol, exact: Callable[[mpf], Motion], unit: sympy.Expr = x0, slow: str = "0.8"
) -> Callable[[mpf], mpf]:
    """The largest error of a motion over one swing that begins at the fixed slow time eps tau = ``slow``."""
    value = dimensionless(form, strength, unit)

    def error(eps: mpf) -> mpf:
        true = exact(eps)
        start = int(mpf(slow) / eps / pi) * pi
        times = [start + 2 * pi * j / 24 for j in range(25)]
        return max(abs(value(eps, tau) - true(tau)) for tau in times)

    return error


def air_error(form: sympy.Expr, angles: Sequence[Fraction]) -> Callable[[mpf], mpf]:
    """The largest error of a motion with air resistance on one half-swing near eps tau = 1, at the given phases."""
    value = dimensionless(form, C)

    def error(eps: mpf) -> mpf:
        swings = int(1 / (eps * pi))
        points = [air(eps, swings, angle) for angle in angles]
        return max(abs(value(eps, tau) - place) for tau, place in points)

    return error
