"""Equations (18)-(21): two damping terms at once.

beta stands for the paper's alpha' > alpha, b2 for b', d for c'.
"""

from collections.abc import Callable
from math import cos

import sympy

from paper_checks.identities import all_confirmed, opposite, same, vanishes
from paper_checks.lancaster2020.model import (
    SI,
    A,
    alpha,
    b,
    b2,
    dimension,
    euler_beta,
    k,
    m,
    mean,
    measured_order,
    numeric,
    omega0,
    reaches,
    t,
    v,
    x0,
    zero,
)
from paper_checks.lancaster2020.model import alpha2 as beta
from paper_checks.registry import statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

c, d, s = sympy.symbols("c c' s", positive=True)
TWO = (("1", "1"), ("2", "1"))  # exponents and strengths of Fig. 3


def constant(strength: sympy.Expr, a: sympy.Expr) -> sympy.Expr:
    """c, and c' with b' and alpha', as printed below (20)."""
    return strength * (2 * omega0) ** (a + 1) * euler_beta(a / 2 + 1, a / 2 + 1)


VELOCITY = omega0 * A * sympy.sin(omega0 * t)
VISCOUS = sympy.pi * b * k / (2 * m)
QUADRATIC = 4 * b2 * omega0 * k / (3 * m)


@statement(
    id="lancaster2020:18", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    derivation="two-laws-average",
    title="The amplitude equation for two damping terms",
    latex=r"kA\dot{A} = -b\dot{x}^2|\dot{x}|^{\alpha-1} - b'\dot{x}^2|\dot{x}|^{\alpha'-1}",
    printed=-b * v**2 * v ** (alpha - 1) - b2 * v**2 * v ** (beta - 1),
    near_miss=-b * v**2 * v ** (alpha - 1) - b2 * v**2 * v**beta, conditions="as for (8): A = sqrt(2E/k)",
    methods=("power of both forces of the law below (3), for both signs of the velocity",),
    note="Form: the right side, with v = |x'|.",
)
def two_terms(form: sympy.Expr) -> Outcome:
    """(f + f') x' for x' = v and x' = -v."""
    powers = [-(b * sign * v * v ** (alpha - 1) + b2 * sign * v * v ** (beta - 1)) * sign * v for sign in (1, -1)]
    return all_confirmed(*(zero(form - power) for power in powers))


@statement(
    id="lancaster2020:19", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.PROVED, order="1",
    derivation="two-laws-average",
    title="The same with the slow velocity",
    latex=r"kA\dot{A} \simeq -bA^{\alpha+1}\omega_0^{\alpha+1}|\sin^{\alpha+1}(\omega_0 t)| -"
    r" b'A^{\alpha'+1}\omega_0^{\alpha'+1}|\sin^{\alpha'+1}(\omega_0 t)|",
    printed=-b * (A * omega0 * s) ** (alpha + 1) - b2 * (A * omega0 * s) ** (beta + 1),
    near_miss=-b * (A * omega0 * s) ** (alpha + 1) - b2 * (A * omega0 * s) ** beta, conditions="|A'| << omega_0 A",
    methods=("|x'| = A omega_0 |sin| in (18)",),
    note="The order is that of (9). Form: the right side, with s = |sin omega_0 t|.",
)
def slow_two_terms(form: sympy.Expr) -> Outcome:
    """(18) at v = A omega_0 s."""
    right = -b * v ** (alpha + 1) - b2 * v ** (beta + 1)
    return zero(form - right.subs(v, A * omega0 * s))


@statement(
    id="lancaster2020:claim.velocity-sign", kind=Kind.APPROXIMATION, verdict=Printed.MISPRINT,
    derivation="lancaster-energy", line=1,
    evidence=Evidence.PROVED, order="1", title="The velocity used for (19)",
    latex=r"\dot{x}(t) \simeq \omega_0 A\sin(\omega_0 t)",
    corrected_latex=r"\dot{x}(t) \simeq -\omega_0 A\sin(\omega_0 t)",
    printed=VELOCITY, corrected=-VELOCITY, near_miss=-VELOCITY.subs(A, x0), conditions="|A'| << omega_0 A",
    methods=("derivative of A cos omega_0 t with A held",),
    note="(9) has the minus sign. Harmless: only x'^2 and |x'| enter (18). The order is that of (9).",
)
def velocity_sign(form: sympy.Expr) -> Outcome:
    """The velocity of A cos omega_0 t, with A as slow as the condition says."""
    return same(form, sympy.diff(A * sympy.cos(omega0 * t), t))


@statement(
    id="lancaster2020:claim.not-separable", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="For two different exponents the equation is no longer separable",
    latex=r"\text{For } \alpha \neq \alpha' \text{, the approximate differential equation governing } A(t) \text{ is no"
    r" longer separable}",
    printed=(1, 2), near_miss=(2, 2), conditions="none", methods=("d^2 ln(rate)/dA ds = 0 is necessary for a product",),
    note="Form: two exponents, shown at alpha, alpha' = 1, 2; the mixed derivative has the factor (alpha' - alpha)^2.",
)
def not_separable(form: tuple[int, int]) -> Outcome:
    """g = c A^a s^(a+1) + d A^e s^(e+1) is a product p(A) r(s) only if d^2 ln g/dA ds = 0."""
    a, e = form
    g = c * A**a * s ** (a + 1) + d * A**e * s ** (e + 1)
    mixed = vanishes(sympy.diff(sympy.log(g), A, s))
    general = c * A**alpha * s ** (alpha + 1) + d * A**beta * s ** (beta + 1)
    factor = (beta - alpha) ** 2 * c * d * A ** (alpha + beta - 1) * s ** (alpha + beta + 1) / general**2
    formula = zero(sympy.diff(sympy.log(general), A, s) - factor)
    return all_confirmed(formula, opposite(mixed))


@statement(
    id="lancaster2020:20", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.PROVED, order="1",
    title="The averaged equation, separated",
    latex=r"\int_{x_0}^{A(t)}\frac{dA}{cA^{\alpha} + c'A^{\alpha'}} \simeq -\frac{t}{\pi k}",
    printed=1 / (sympy.pi * k), near_miss=1 / k, conditions="|A'| << omega_0 A", derivation="two-laws-time",
    methods=("mean of (19) by (12)",),
    note="The error of A cos(omega_0 t) is measured at (21). Form: the factor of -t.",
)
def averaged(form: sympy.Expr) -> Outcome:
    """A' = -(1/(kA)) sum b (A omega_0)^(a+1) M_(a+1) equals -form (c A^alpha + c' A^alpha')."""
    true = sum(f * (A * omega0) ** (a + 1) * mean(a) for f, a in ((b, alpha), (b2, beta))) / (k * A)
    ours = form * (constant(b, alpha) * A**alpha + constant(b2, beta) * A**beta)
    terms = [(true - ours).subs(other, 0) for other in (b2, b)]  # both sides are linear in b and b'
    return all_confirmed(*(zero(term) for term in terms))


@statement(
    id="lancaster2020:claim.c", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The constants c and c'",
    latex=r"c = b(2\omega_0)^{\alpha+1}B\left(\frac{\alpha}{2}+1,\frac{\alpha}{2}+1\right), \quad c' ="
    r" b'(2\omega_0)^{\alpha'+1}B\left(\frac{\alpha'}{2}+1,\frac{\alpha'}{2}+1\right)",
    printed=constant(b, alpha), near_miss=constant(b, alpha) / (2 * omega0), derivation="lancaster-average", line=11,
    conditions="none", methods=("c = pi k kappa omega_0 x0^(1-alpha)", "dimension"), note="Form: c.",
)
def constants(form: sympy.Expr) -> Outcome:
    """c = pi b omega_0^(alpha+1) M_(alpha+1), and c x0^(alpha-1)/k is a rate."""
    unit = sympy.Symbol("T", positive=True)
    rate = dimension(form * x0 ** (alpha - 1) / k)
    return all_confirmed(zero(form - sympy.pi * b * omega0 ** (alpha + 1) * mean(alpha)), zero(rate - 1 / unit))


@statement(
    id="lancaster2020:claim.c-viscous", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="c for viscous drag", latex=r"c = \frac{\pi bk}{2m}", printed=VISCOUS, near_miss=VISCOUS / 2,
    conditions="alpha = 1", methods=("definition of c at alpha = 1",),
)
def c_viscous(form: sympy.Expr) -> Outcome:
    """c at alpha = 1, where Gamma(3/2)^2 = pi/4."""
    return vanishes((constant(b, sympy.Integer(1)) - form).subs(SI))


@statement(
    id="lancaster2020:claim.c-quadratic", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="c' for air resistance", latex=r"c' = \frac{4b'\omega_0k}{3m}", printed=QUADRATIC,
    near_miss=QUADRATIC * sympy.pi / 2, conditions="alpha' = 2", methods=("definition of c' at alpha' = 2",),
)
def c_quadratic(form: sympy.Expr) -> Outcome:
    """c' at alpha' = 2."""
    return vanishes((constant(b2, sympy.Integer(2)) - form).subs(SI))


LAMBDA = x0 / (c + d * x0)
DECAY = sympy.exp(-c * t / (sympy.pi * k))
FRACTION = c * LAMBDA * DECAY / (1 - LAMBDA * d * DECAY)


def envelope(form: sympy.Expr) -> Callable[[float, float], float]:
    """A length in c, c', in units of x0, as a function of (epsilon, tau), with b = omega_0 x0 b'."""
    values = {c: VISCOUS, d: QUADRATIC}
    return numeric(form.subs(values).subs(b2, b / (omega0 * x0)), sympy.Integer(1))


def solves_20(form: sympy.Expr) -> Outcome:
    """(20) differentiated, with alpha = 1 and alpha' = 2: A' = -(c A + c' A^2)/(pi k), and A(0) = x0."""
    law = vanishes(sympy.diff(form, t) + (c * form + d * form**2) / (sympy.pi * k))
    return all_confirmed(vanishes(form.subs(t, 0) - x0), law)


@statement(
    id="lancaster2020:21", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="1",
    title="Viscous drag and air resistance together",
    latex=r"A(t) \simeq \frac{c\lambda e^{-\frac{ct}{\pi k}}}{1 - \lambda c'e^{-\frac{ct}{\pi k}}}",
    printed=FRACTION, near_miss=c * LAMBDA * DECAY / (1 + LAMBDA * d * DECAY), conditions="alpha = 1, alpha' = 2",
    methods=("solution of (20), proved", "error of A cos(omega_0 t) against the exact motion, b = omega_0 x0 b'"),
    derivation="two-laws-time", extent="sampled: 2 points",
)
@statement(
    id="lancaster2020:claim.no-restriction", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.MEASURED,
    title="No restriction on the relative sizes of b and omega_0 x0 b'",
    latex=r"\text{we have made no restrictions whatsoever on the relative sizes of } b \text{ and } \omega_0 x_0 b'",
    printed=FRACTION, near_miss=x0 * DECAY, conditions="relative sizes only: both must be weak, b, omega_0 x0 b' <<"
    " m omega_0", derivation="two-laws-time", extent="sampled: 2 points",
    methods=("(21) solves (20) for all positive c, c'", "error of A cos(omega_0 t) as for (21)"),
    note="Near miss: (21) without c', which needs omega_0 x0 b' << b.",
)
def viscous_and_quadratic(form: sympy.Expr) -> Outcome:
    """A' = -(c A + c' A^2)/(pi k), A(0) = x0; and a first-order error of the motion."""
    formal = solves_20(form)
    if formal != Outcome.CONFIRMED:
        return formal
    A_of = envelope(form)
    return reaches(measured_order(TWO, lambda e, tau, X, V: X - A_of(e, tau) * cos(tau)), 1)


@statement(
    id="lancaster2020:claim.lambda", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The constant lambda", latex=r"\lambda \equiv \frac{x_0}{c + c'x_0}", printed=LAMBDA,
    near_miss=x0 / (c - d * x0), conditions="none", methods=("A(0) = x0 in (21)",),
)
def definition_of_lambda(form: sympy.Expr) -> Outcome:
    """c lambda/(1 - c' lambda) = x0."""
    return vanishes(c * form / (1 - d * form) - x0)
