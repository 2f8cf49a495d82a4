"""Equations (1)-(3) and the claims of the introduction: the law of damping and the linear oscillator.

``s`` is a positive symbol for |v| where a sign matters.
"""

from math import cos

import sympy

from paper_checks.evidence import mark, sampled
from paper_checks.identities import all_confirmed, decided, same, vanishes
from paper_checks.lancaster2020.model import SI, alpha, b, dimension, k, linear_motion, m, numeric, omega0, t, v, x, x0
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

f, v0 = sympy.symbols("f v_0", positive=True)
gamma, omega = sympy.symbols("gamma omega", positive=True)
LINEAR = {gamma: b / (2 * m), omega: sympy.sqrt(omega0**2 - (b / (2 * m)) ** 2)}


@statement(
    id="lancaster2020:1", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The equation of motion", latex=r"m\ddot{x} + kx - f_{\alpha}(\dot{x}) = 0",
    printed=(f - k * x) / m, near_miss=(-f - k * x) / m, conditions="m, k > 0",
    methods=("the power of the damping force is f v, as in (7)",),
    note="With f_alpha < 0 for v > 0 the sign in front of f is the one that dissipates. Form: the acceleration.",
)
def equation_of_motion(form: sympy.Expr) -> Outcome:
    """The energy (4) changes at the rate f v."""
    return vanishes(m * v * form + k * x * v - f * v)


@statement(
    id="lancaster2020:claim.force", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The power-law damping force", latex=r"f_{\alpha}(\dot{x}) = -b\dot{x}|\dot{x}|^{\alpha-1}",
    printed=-b * v ** (alpha - 1), near_miss=-b * v**alpha, conditions="b > 0; [b] = kg m^(1-alpha) s^(alpha-2)",
    methods=("alpha = 0, 1, 2", "dimension"),
    note="alpha = 0 is a constant force against the motion (dry friction). Form: f/v as a function of v = |x'|.",
)
def power_law_force(form: sympy.Expr) -> Outcome:
    """|f| is b for alpha = 0, b|v| for alpha = 1, b v^2 for alpha = 2, and a force in units for any alpha."""
    sizes = [same(-(form * v).subs(alpha, a), b * v**a) for a in (0, 1, 2)]
    M, L, T = sympy.symbols("M L T", positive=True)
    return all_confirmed(*sizes, same(dimension(form * v), M * L / T**2))


@statement(
    id="lancaster2020:claim.underdamped", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The linear oscillator is underdamped below this damping", latex=r"\frac{b}{2m} < \omega_0",
    printed=2 * m * omega0, near_miss=m * omega0, conditions="alpha = 1",
    methods=("discriminant of m s^2 + b s + k",), note="Form: the critical b.",
)
def underdamped(form: sympy.Expr) -> Outcome:
    """The discriminant b^2 - 4mk grows with b and vanishes at the form."""
    return all_confirmed(vanishes((form**2 - 4 * m * k).subs(SI)), decided(form.is_positive))


@statement(
    id="lancaster2020:claim.linear-letters", kind=Kind.DEFINITION, verdict=Printed.DEFINITION,
    evidence=Evidence.PROVED, title="Damping rate and frequencies of the linear oscillator",
    latex=r"\gamma \equiv \frac{b}{2m}, \quad \omega \equiv \sqrt{\omega_0^2 - \gamma^2}, \quad"
    r" \omega_0^2 \equiv \frac{k}{m}",
    printed=(b / (2 * m), omega0**2 - (b / (2 * m)) ** 2), near_miss=(b / m, omega0**2 - (b / m) ** 2),
    conditions="alpha = 1", methods=("roots of m s^2 + b s + k",), note="Form: gamma and omega^2.",
)
def linear_letters(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """-gamma +- i omega are the roots: their sum is -b/m, their product k/m."""
    decay, square = form
    return all_confirmed(same(2 * decay, b / m), vanishes((decay**2 + square - k / m).subs(SI)))


def linear_solution(sign: int) -> sympy.Expr:
    """(2), with the sign of gamma x0 in the amplitude of the sine."""
    return sympy.exp(-gamma * t) * (
        x0 * sympy.cos(omega * t) + (v0 + sign * gamma * x0) / omega * sympy.sin(omega * t)
    )


@statement(
    id="lancaster2020:2", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The underdamped linear oscillator",
    latex=r"x(t) = e^{-\gamma t}\left[x_0\cos[\omega t] + \left(\frac{v_0+\gamma x_0}{\omega}\right)"
    r"\sin[\omega t]\right]",
    printed=linear_solution(1), near_miss=linear_solution(-1), conditions="gamma < omega_0",
    methods=("substitution in (1)", "initial values"),
)
def linear_oscillator(form: sympy.Expr) -> Outcome:
    """The equation x'' + 2 gamma x' + (gamma^2 + omega^2) x = 0 with x(0) = x0, x'(0) = v0."""
    first, second = sympy.diff(form, t), sympy.diff(form, t, 2)
    return all_confirmed(
        vanishes(second + 2 * gamma * first + (gamma**2 + omega**2) * form),
        vanishes(form.subs(t, 0) - x0),
        vanishes(first.subs(t, 0) - v0),
    )


@statement(
    id="lancaster2020:3", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="1",
    extent="sampled: 2 points",
    title="The weakly damped linear oscillator",
    latex=r"x(t) \simeq x_0 e^{-\gamma t}\cos[\omega_0 t] \qquad (\gamma \ll \omega_0)",
    printed=x0 * sympy.exp(-b * t / (2 * m)), near_miss=x0 * sympy.exp(-b * t / m),
    conditions="v_0 = 0; times up to the order of 1/gamma. Later, from t ~ omega_0/gamma^2 on, the phase is lost,"
    " with an amplitude that is then exponentially small",
    methods=("error against (2) at gamma t about 1/2, epsilon = 0.01 and 0.005",),
    note="Absolute error O(gamma/omega_0), from the neglected sine. Form: A(t).",
)
def weakly_damped(form: sympy.Expr) -> Outcome:
    """The largest error about epsilon tau = 1 halves with epsilon."""
    A = numeric(form, sympy.Integer(1))
    per_mass = vanishes(sympy.diff(form.subs(b, m * b), m))  # (1) divided by m knows only b/m

    def largest(e: float) -> float:
        times = [1 / e + phase for phase in (0.0, 0.8, 1.6, 2.4)]
        return max(abs(linear_motion(e, tau) - A(e, tau) * cos(tau)) for tau in times)

    mark(Evidence.MEASURED)
    coarse, fine = map(largest, sampled((0.01, 0.005)))
    return all_confirmed(per_mass, decided(1.8 < coarse / fine < 2.2))


@statement(
    id="lancaster2020:claim.solvable-only-linear", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lelas-friction-exact", line=1,
    shortfall=Shortfall.CONSEQUENCE,
    title="Linear, and therefore solvable in elementary functions, only for alpha = 1",
    latex=r"\text{Eq. (1) is a linear equation---and therefore solvable in terms of elementary functions---only for}"
    r"\ \alpha = 1",
    corrected_latex=r"\text{linear only for } \alpha = 1; \text{ solvable in elementary functions for } \alpha = 1"
    r" \text{ and, half-swing by half-swing, for } \alpha = 0",
    printed=(1,), corrected=(0, 1), near_miss=(0,), conditions="among alpha = 0 and 1; nothing is said of others here",
    methods=("the solutions themselves, substituted",),
    note="Linear it is only for alpha = 1. But dry friction is linear with a constant on each half-swing, x = c +"
    " (x_n - c) cos omega_0 t with c = +-b/k; the paper itself cites these exact solutions (refs. 5-8). Form: the"
    " exponents among 0, 1 with an elementary solution.",
)
def elementary_exponents(form: tuple[int, ...]) -> Outcome:
    """Substitute the half-swing of dry friction, towards smaller x, and the linear solution (2)."""
    swing = b / k + (x0 - b / k) * sympy.cos(omega0 * t)
    dry = (m * sympy.diff(swing, t, 2) + k * swing - b).subs(SI)
    line = linear_oscillator(linear_solution(1))
    solvable = {0: vanishes(dry), 1: line}
    confirmed = tuple(a for a, outcome in solvable.items() if outcome == Outcome.CONFIRMED)
    return decided(form == confirmed)
