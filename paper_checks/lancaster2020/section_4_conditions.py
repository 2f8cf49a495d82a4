"""Equations (16), (17): what weak damping means, and what fails for alpha < 1.

In the forms T = omega_0 t, K = kappa, p = 1 - alpha > 0.
"""

import sympy
from flint import arb

from asymptotics.numbers.bridge import closed_form_ball
from asymptotics.numbers.context import ctx
from paper_checks.evidence import sampled
from paper_checks.identities import all_confirmed, below, limit_is, vanishes
from paper_checks.lancaster2020.model import (
    EPSILON,
    alpha,
    b,
    c,
    exact_rate_expanded,
    k,
    kappa,
    mean,
    omega0,
    s,
    strength,
    x0,
    zero,
)
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

K, T, p, z = sympy.symbols("K T p z", positive=True)


@statement(
    id="lancaster2020:claim.leading-order", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The results are correct to leading order in kappa, which is proportional to b", printed=1, near_miss=2,
    latex=r"\text{the asymptotic results are formally correct only to leading order in } \kappa \propto b",
    conditions="none", derivation="symbolic-alpha",
    methods=("d ln kappa/d ln b", "exact rate of the envelope expanded to second order, its means over a half-swing"),
    note="d ln A/d tau = -(p_1 delta + p_3 delta^3 + ...), d psi/d tau = 1 + Omega_2 delta^2 + ...: the rate has no"
    " second-order term, so (13) is better than that for the amplitude at the turning points. Form: the power of b.",
)
def leading_order(form: int) -> Outcome:
    """b d ln kappa/db; the exact rate begins with epsilon s^(alpha+1), whose mean is kappa, and then has no mean."""
    first, second = exact_rate_expanded()
    whole = s ** (2 * alpha + 2) / (2 * alpha + 2)  # of the second term, with ds = c dtheta: 0 at both ends
    return all_confirmed(
        zero(b * sympy.diff(sympy.log(kappa(alpha)), b) - form),
        zero(first - s ** (alpha + 1)),
        zero(kappa(alpha) - mean(alpha) * EPSILON),
        zero(second - sympy.diff(whole, s) * c),
        vanishes(whole.subs(s, 0)),
    )


@statement(
    id="lancaster2020:claim.kappa-scaling", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="How kappa scales with the physical constants",
    latex=r"\kappa \sim \frac{b\omega_0^{\alpha}}{kx_0^{1-\alpha}}", printed=EPSILON,
    near_miss=EPSILON * x0 ** (2 - 2 * alpha), conditions="the factor is M_(alpha+1), between 1/2 and 2/pi for"
    " 0 <= alpha <= 1; for large alpha it falls like alpha^(-1/2)", methods=("quotient free of the constants",),
    derivation="lancaster-average", line=11,
)
def kappa_scaling(form: sympy.Expr) -> Outcome:
    """kappa = M_(alpha+1) times the form."""
    return zero(kappa(alpha) - mean(alpha) * form)


@statement(
    id="lancaster2020:claim.weak-damping", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Weak damping", latex=r"b \ll \frac{kx_0^{1-\alpha}}{\omega_0^{\alpha}} \text{, or } \kappa \ll 1",
    printed=k * x0 ** (1 - alpha) / omega0**alpha, near_miss=k * x0 ** (alpha - 1) / omega0**alpha,
    conditions="none", methods=("epsilon = 1 at the bound",), note="Form: the bound of b.",
)
def weak_damping(form: sympy.Expr) -> Outcome:
    """b at the bound is the strength epsilon = 1."""
    return all_confirmed(zero(EPSILON.subs(b, form) - 1), zero(form - strength(sympy.Integer(1))))


@statement(
    id="lancaster2020:16", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Weak sliding friction",
    latex=r"\frac{b}{kx_0} = \frac{F_{\text{friction}}}{F_{\text{spring}}^{(\text{max})}} \ll 1",
    printed=b / (k * x0), near_miss=b / (k * x0**2), conditions="alpha = 0",
    methods=("epsilon at alpha = 0",), note="kappa is 2/pi times it. The display stands out of order in the text.",
)
def weak_friction(form: sympy.Expr) -> Outcome:
    """The form is epsilon at alpha = 0, friction b over the largest spring force k x0."""
    return all_confirmed(zero(form - EPSILON.subs(alpha, 0)), zero(form * k * x0 - b))


@statement(
    id="lancaster2020:17", kind=Kind.APPROXIMATION, verdict=Printed.PARTLY,
    derivation="lancaster-conditions", line=10,
    shortfall=Shortfall.CONDITION,
    evidence=Evidence.CERTIFIED, extent="sampled: 2 points", order="0",
    title="The condition of slow dissipation for alpha < 1",
    latex=r"\frac{|\dot{A}|}{A} \sim \frac{b\omega_0^{\alpha+1}}{kx_0^{1-\alpha}}\left|1 - (1-\alpha)"
    r"\frac{b\omega_0^{\alpha+1}}{kx_0^{1-\alpha}}t\right|^{-1} \ll \omega_0",
    corrected_latex=r"\frac{|\dot{A}|}{A} = \kappa\omega_0\left|1 - (1-\alpha)\kappa\omega_0 t\right|^{-1}"
    r" \ll \omega_0",
    printed=1 / mean(-p + 1), corrected=sympy.Integer(1), near_miss=sympy.Integer(2),
    conditions="alpha < 1; as printed, in order of magnitude while (1-alpha) epsilon omega_0 t < 1 is not near 1",
    methods=("quotient to (14) shortly before each bracket vanishes, alpha = 0 and 1/2, balls",),
    note="Signs and powers are right. But a scale cannot stand for kappa in a difference: the printed rate is infinite"
    " at omega_0 t = 1/((1-alpha) epsilon), when the true one is still of order kappa omega_0 (alpha = 0: 2.75 kappa"
    " omega_0 at 64 % of the life time). Form: what stands for kappa, in units of kappa, with p = 1 - alpha.",
)
def scaled_condition(form: sympy.Expr) -> Outcome:
    """With c = form kappa: the quotient of c/(1 - p c T) and K/(1 - p K T) at p c T = 0 and 999/1000 is within 3."""
    outcomes = []
    for a in sampled((0, sympy.Rational(1, 2))):
        c = form.subs(p, 1 - a)
        for share in (sympy.Integer(0), sympy.Rational(999, 1000)):
            quotient = c * (1 - share / c) / (1 - share)
            with ctx.workprec(80):
                ball = closed_form_ball(quotient)
            outcomes += [below(abs(ball), arb(3)), below(arb(1) / 3, abs(ball))]
    return all_confirmed(*outcomes)


@statement(
    id="lancaster2020:claim.fails-at-long-times", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    shortfall=Shortfall.RANGE,
    title="For alpha < 1 the condition cannot be satisfied for long times",
    latex=r"\text{even if this weak-damping condition is satisfied, (17) cannot be satisfied for long times}"
    r"\ \omega_0 t \gg 1",
    corrected_latex=r"\text{it fails for } (1-\alpha)\kappa\omega_0 t \to 1 \text{, from } 1 - \kappa \text{ on}",
    printed=(T, sympy.oo), corrected=(p * K * T, sympy.Integer(1)), near_miss=(K * T, sympy.Integer(1)),
    conditions="alpha < 1, kappa < 1", methods=("limit of the rate in the variable of the form",),
    derivation="lancaster-energy", line=18,
    note="Again the wrong variable: with kappa = 0.001, alpha = 0 the rate at omega_0 t = 100 is 0.0011 omega_0. Form:"
    " the variable, and the value to which it tends where (17) fails.",
)
def fails_at_long_times(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The rate K/|1 - p K T| must grow beyond any bound when the variable of the form tends to its value."""
    variable, end = form
    rate = sympy.Abs(K / (1 - p * K * T)).subs(T, sympy.solve(variable - z, T)[0])
    return limit_is(rate, z, end, sympy.oo)
