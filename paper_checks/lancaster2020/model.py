"""The model of the paper in its own letters: m x'' + k x + b x'|x'|^(alpha-1) = 0, k = m omega_0^2, x(0) = x0, at rest.

Everything dimensionless depends on epsilon = b omega_0^alpha/(k x0^(1-alpha)) alone; kappa = M_(alpha+1) epsilon.

>>> simplified(kappa(alpha) - mean(alpha) * EPSILON)
0
>>> dimension(EPSILON), dimension(b)
(1, L**(1 - alpha)*M*T**(alpha - 2))

Orders of convergence are measured against the exact motion, half-swing by half-swing (``flow``), in balls of 64
bits; only their midpoints are used.

>>> X, V = exact_states((("1", "1/10"),), ("10",))[0]                   # linear damping, closed form
>>> float(abs(X - linear_motion(0.1, 10.0))) < 1e-15
True
"""

from collections.abc import Callable
from functools import cache
from math import cos, exp, log2, sin, sqrt

import sympy
from flint import arb

from asymptotics.flow.damping import Damping
from asymptotics.flow.dense import states
from asymptotics.flow.linear_spring.linear_spring import LinearSpring
from asymptotics.law import Law
from asymptotics.numbers.context import ctx
from paper_checks.evidence import mark, sampled
from paper_checks.identities import not_of_order, vanishes
from paper_checks.units import SYSTEMS, agreed
from paper_checks.verdict import Evidence, Outcome

b, k, m, x0, omega0, t, alpha = sympy.symbols("b k m x_0 omega_0 t alpha", positive=True)
b2, alpha2 = sympy.symbols("b' alpha'", positive=True)  # the second damping term
x, v, A = sympy.symbols("x v A", positive=True)
s, c = sympy.symbols("s c", positive=True)  # |sin| and cos of the phase
SI = {k: m * omega0**2}

BITS = 64
STRENGTHS = ("1/25", "1/50")
PHASES = ("3/10", "11/10", "2")


def euler_beta(p: sympy.Expr, q: sympy.Expr) -> sympy.Expr:
    """B(p, q) in Gamma functions, as the paper defines it below (12)."""
    return sympy.gamma(p) * sympy.gamma(q) / sympy.gamma(p + q)


def mean(a: sympy.Expr) -> sympy.Expr:
    """M_(a+1) = <|sin|^(a+1)>, by Wallis' formula."""
    return sympy.gamma(a / 2 + 1) / (sympy.sqrt(sympy.pi) * sympy.gamma(a / 2 + sympy.Rational(3, 2)))


EPSILON = b * omega0**alpha / (k * x0 ** (1 - alpha))


def kappa(a: sympy.Expr) -> sympy.Expr:
    """Kappa as printed below (13)."""
    return 2 * b * (2 * omega0) ** a * euler_beta(a / 2 + 1, a / 2 + 1) / (sympy.pi * k * x0 ** (1 - a))


def amplitude(a: sympy.Expr) -> sympy.Expr:
    """A(t) as printed in (13)."""
    rate = b * (2 * omega0) ** (a + 1) * t / (sympy.pi * k * x0 ** (1 - a)) * euler_beta(a / 2 + 1, a / 2 + 1)
    return x0 * (1 + (a - 1) * rate) ** (-1 / (a - 1))


def exact_rate_expanded() -> tuple[sympy.Expr, sympy.Expr]:
    """The first two coefficients in rho of -d ln r/dtheta = rho s^(alpha+1)/(1 - rho s^alpha c) on a half-swing, exact.

    x = r cos theta, x' = -r sin theta, rho = epsilon r^(alpha-1), s and c the sine and the cosine.

    >>> exact_rate_expanded()[0]
    s**(alpha + 1)
    """
    rho = sympy.Symbol("rho", positive=True)
    rate = rho * s ** (alpha + 1) / (1 - rho * s**alpha * c)
    return rate.diff(rho).subs(rho, 0), sympy.powsimp(rate.diff(rho, 2).subs(rho, 0) / 2)


def strength(e: sympy.Expr, a: sympy.Expr = alpha) -> sympy.Expr:
    """The b that has the dimensionless strength e."""
    return e * k * x0 ** (1 - a) / omega0**a


def simplified(expression: sympy.Expr) -> sympy.Expr:
    """The expression after Legendre's duplication formula and the recurrence of Gamma."""
    return sympy.simplify(sympy.expand_func(sympy.gammasimp(sympy.powdenest(expression, force=True))))


def zero(expression: sympy.Expr) -> Outcome:
    """Whether an expression in positive symbols vanishes: as it stands, or else after ``simplified``."""
    outcome = vanishes(expression, reduced=simplified if expression.has(sympy.gamma) else sympy.simplify)
    return vanishes(simplified(expression)) if outcome == Outcome.UNDECIDED else outcome


def dimension(expression: sympy.Expr) -> sympy.Expr:
    """The dimension as a monomial in M, L, T; a sum of unlike terms leaves something that is no monomial.

    All symbols are scaled at once: E(scaled)/E.
    """
    M, L, T = sympy.symbols("M L T", positive=True)
    scale = {
        m: M, k: M / T**2, x0: L, x: L, A: L, v: L / T, omega0: 1 / T, t: T,
        b: M * L ** (1 - alpha) * T ** (alpha - 2), b2: M * L ** (1 - alpha2) * T ** (alpha2 - 2),
    }  # fmt: skip
    scaled = expression.subs({s: s * unit for s, unit in scale.items()}, simultaneous=True)
    return sympy.simplify(sympy.powsimp(sympy.expand_power_base(sympy.powdenest(scaled / expression, force=True))))


@cache
def exact_states(laws: tuple[tuple[str, str], ...], times: tuple[str, ...]) -> tuple[tuple[float, float], ...]:
    """(X, X') at ascending dimensionless times for laws (alpha, epsilon), from rest at X = 1, as doubles."""
    with ctx.workprec(BITS):
        damping = Damping.of_law(Law(dict(laws)))
        wanted = [arb(sympy.Rational(time).p) / sympy.Rational(time).q for time in times]
        return tuple((float(X.mid()), float(V.mid())) for X, V in states(LinearSpring(damping), arb(1), arb(0), wanted))


def linear_motion(epsilon: float, tau: float) -> float:
    """X(tau) for linear damping epsilon < 2, by (2)."""
    gamma = epsilon / 2
    omega = sqrt(1 - gamma**2)
    return exp(-gamma * tau) * (cos(omega * tau) + gamma / omega * sin(omega * tau))


def slow_times(epsilon: str) -> tuple[str, ...]:
    """Times with epsilon tau about 1, at several phases."""
    return tuple(str(1 / sympy.Rational(epsilon) + sympy.Rational(phase)) for phase in PHASES)


Error = Callable[[float, float, float, float], float]


def measured_order(laws: tuple[tuple[str, str], ...], error: Error) -> float:
    """log_2 of the ratio of the largest |error(epsilon, tau, X, X')| about epsilon tau = 1, for epsilon and epsilon/2.

    ``laws`` are (alpha, multiple of epsilon).
    """
    mark(Evidence.MEASURED)
    largest = []
    for epsilon in sampled(STRENGTHS):
        e, times = sympy.Rational(epsilon), slow_times(epsilon)
        states = exact_states(tuple((a, str(e * sympy.Rational(share))) for a, share in laws), times)
        found = [abs(error(float(e), float(sympy.Rational(s)), *state)) for s, state in zip(times, states)]
        largest.append(max(found))
    return log2(largest[0] / largest[1])


def reaches(order: float, wanted: int) -> Outcome:
    """CONFIRMED if the measured order is at least ``wanted``, REFUTED if clearly less."""
    if order > wanted - 0.25:
        return Outcome.CONFIRMED
    return not_of_order(order, wanted) if order < wanted - 0.6 else Outcome.UNDECIDED


def numeric(form: sympy.Expr, a: sympy.Expr) -> Callable[[float, float], float]:
    """A length over x0 as a function of (epsilon, tau), in two systems of units, which must agree; heuristic."""
    e, tau = sympy.symbols("e tau", positive=True)
    compiled = []
    for mass, rate, length, _ in SYSTEMS:
        places = {t: tau / omega0, b: strength(e, a), k: m * omega0**2}
        value = form.subs(alpha, a).subs(places).subs(places)  # b and t stand for expressions with k
        compiled.append(sympy.lambdify((e, tau), value.subs({m: mass, omega0: rate, x0: length}) / length, "math"))
    return lambda epsilon, s: float(agreed(*(f(epsilon, s) for f in compiled)))
