"""Equations (10)-(13) and what the paper reads off (13): the amplitude for any alpha."""

from fractions import Fraction
from math import cos

import sympy
from flint import acb, arb

from asymptotics.numbers.bridge import closed_form_ball
from asymptotics.numbers.context import ctx
from paper_checks.evidence import sampled
from paper_checks.identities import all_confirmed, balls_agree, decided, limit_is, same, vanishes
from paper_checks.lancaster2020.model import (
    EPSILON,
    alpha,
    amplitude,
    b,
    dimension,
    euler_beta,
    k,
    kappa,
    mean,
    measured_order,
    numeric,
    omega0,
    reaches,
    t,
    x0,
    zero,
)
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

A, s, q = sympy.symbols("A s q", positive=True)  # s = |sin omega_0 t|; q = |alpha - 1|
RATE = b * omega0 ** (1 + alpha) / k
BETA = 2 ** (alpha + 1) * euler_beta(alpha / 2 + 1, alpha / 2 + 1) / sympy.pi
FREQUENCY_NOTE = (
    "The mean does not depend on the frequency, so that the statement is true for any value of it, as the check uses."
)


@statement(
    id="lancaster2020:10", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The amplitude equation integrated",
    latex=r"\frac{A(t)^{1-\alpha} - x_0^{1-\alpha}}{1-\alpha} = -\frac{b\omega_0^{1+\alpha}}{k}\int_0^t"
    r"|\sin^{1+\alpha}(\omega_0 t')|dt' \qquad (\alpha \neq 1)",
    printed=-RATE, near_miss=-RATE / omega0, conditions="alpha != 1; A > 0; A in the sense of sqrt(2E/k), see (8)",
    methods=("(8) with (9) separated",), derivation="lancaster-energy", line=10,
    note="Form: the factor in front of the integral.",
)
def separated(form: sympy.Expr) -> Outcome:
    """From (8), (9): A' = -b (A omega_0 s)^(alpha+1)/(k A); the derivative of the left side is A^(-alpha) A'."""
    slope = -b * (A * omega0 * s) ** (alpha + 1) / (k * A)
    left = sympy.diff(A ** (1 - alpha) / (1 - alpha), A) * slope
    return zero(left - form * s ** (1 + alpha))


@statement(
    id="lancaster2020:claim.linear-limit", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The case alpha = 1 is the limit of (10)",
    latex=r"A^{1-\alpha} = e^{(1-\alpha)\ln A}, \quad \epsilon = 1 - \alpha \to 0",
    printed=(A / x0, sympy.Integer(1)), near_miss=(A * x0, sympy.Integer(1)),
    conditions="none",
    methods=("limit of the left side",), note="Form: what stands in the logarithm of the limit, and its factor.",
)
def linear_limit(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """(A^q - x0^q)/q -> ln(A/x0) as q = 1 - alpha -> 0 (by L'Hospital: the derivative of the numerator at q = 0)."""
    limit = sympy.diff(sympy.exp(q * sympy.log(A)) - sympy.exp(q * sympy.log(x0)), q).subs(q, 0)
    argument, factor = form
    return vanishes(sympy.expand_log(limit - factor * sympy.log(argument)))


@statement(
    id="lancaster2020:11", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    slip="On the right side the frequency is omega', on the left omega_0.",
    derivation="lancaster-average", line=11, title="The integral grows like its mean",
    latex=r"\int_0^t|\sin^{\alpha+1}(\omega_0 t')|dt' \simeq \langle|\sin^{1+\alpha}(\omega' t)|\rangle t",
    printed=mean(alpha), near_miss=2 ** (-(alpha + 1) / 2), order="1", digits=20,
    conditions="omega_0 t >> 1: the difference is periodic, so the relative error is O(1/(omega_0 t))",
    methods=("mean over half a period by certified quadrature, alpha = 0, 1/2, 3/2, 2, 3",),
    note="omega' and the unprimed t on the right should be omega_0 and t' (the text cannot tell whose slip it is). "
    + FREQUENCY_NOTE + " Near miss: the mean of Lelas' trick. Order in 1/t. Form: the mean.",
)
@statement(
    id="lancaster2020:12", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    slip="omega stands where (11) has omega_0; by (2) it is another frequency.",
    derivation="lancaster-average", line=11, title="The mean as a beta function",
    latex=r"\int_0^t|\sin^{\alpha+1}(\omega t')|dt' \simeq 2^{\alpha+1}B\left(\frac{\alpha}{2}+1,"
    r"\frac{\alpha}{2}+1\right)t/\pi",
    printed=BETA, near_miss=BETA / 2, order="1", digits=20,
    conditions="omega t >> 1, as for (11); B(x,y) = Gamma(x) Gamma(y)/Gamma(x+y)",
    methods=("mean over half a period by certified quadrature, alpha = 0, 1/2, 3/2, 2, 3", "duplication formula"),
    note="omega stands where (11) has omega_0; by (2) it would be another frequency. " + FREQUENCY_NOTE
    + " Form: the factor of t.",
)
def mean_of_sine(form: sympy.Expr) -> Outcome:
    """The form equals Wallis' M_(alpha+1) identically, and the certified mean over a half period at five exponents."""
    outcomes = [zero(form - mean(alpha))]
    with ctx.workprec(120):
        for a in sampled((Fraction(0), Fraction(1, 2), Fraction(3, 2), Fraction(2), Fraction(3))):
            value = closed_form_ball(form.subs(alpha, sympy.Rational(a.numerator, a.denominator)))
            outcomes.append(balls_agree(value, _certified_mean(a), 20))
    return all_confirmed(*outcomes)


def _certified_mean(a: Fraction) -> arb:
    """(1/pi) int_0^pi sin^(a+1) = 4/pi int_0^1 u^(2a+3) (1 - u^4)^(-1/2) du with sin = u^2, made smooth at u = 1.

    With u = 1 - w^2: 1 - u^4 = w^2 (2 - w^2)(1 + u^2), du = -2 w dw; on 0 <= w <= 1 only u = 0 is singular, where
    u^(2a+3) is an integer power because 2a is an integer.
    """
    power = int(2 * a) + 3

    def integrand(w: acb, analytic: bool) -> acb:
        u = 1 - w * w
        return u**power * 2 / ((2 - w * w) * (1 + u * u)).sqrt(analytic)

    return 4 * acb.integral(integrand, acb(0), acb(1)).real / arb.pi()


@statement(
    id="lancaster2020:claim.average-period", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The period of the averaged function", latex=r"\frac{\pi}{\omega_0}", printed=sympy.pi / omega0,
    near_miss=sympy.pi / (2 * omega0), conditions="alpha > -1", methods=("shift of the argument", "zeros"),
)
def average_period(form: sympy.Expr) -> Outcome:
    """sin^2 returns after the form, and the form is the distance of two neighbouring zeros, so it is the least."""
    shifted = sympy.sin(omega0 * (t + form)) ** 2 - sympy.sin(omega0 * t) ** 2
    return all_confirmed(vanishes(sympy.expand_trig(sympy.expand(shifted))), same(omega0 * form, sympy.pi))


@statement(
    id="lancaster2020:13", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="1",
    title="The amplitude for any exponent",
    latex=r"A(t) = x_0\left[1 + (\alpha-1)\frac{b(2\omega_0)^{\alpha+1}t}{\pi kx_0^{1-\alpha}}"
    r"B\left[\frac{\alpha}{2}+1,\frac{\alpha}{2}+1\right]\right]^{-\frac{1}{\alpha-1}}",
    printed=amplitude(alpha), near_miss=x0 * (amplitude(alpha) / x0) ** sympy.Rational(9, 10),
    conditions="alpha != 1 (alpha = 1 as a limit); for alpha < 1 only until the bracket vanishes; omega_0 t up to the"
    " order of 1/epsilon, for alpha > 1 all times",
    methods=("(10) with (12), proved", "error of A cos(omega_0 t) against the exact motion, alpha = 0, 3/2, 3"),
    derivation="lancaster-energy", extent="sampled: 6 points",
    note="The supplied text runs the number (13) and the definition of kappa into one display; the formula is whole."
    " The error of x is O(epsilon); at the turning points, where |x| is the amplitude, it is O(epsilon^2).",
)
def amplitude_for_any_exponent(form: sympy.Expr) -> Outcome:
    """A^(1-alpha) = x0^(1-alpha) (1 + (alpha-1) ...) by (10), (12), and a first-order error of the motion."""
    wanted = 1 + (alpha - 1) * RATE * BETA * t * x0 ** (alpha - 1)
    start = vanishes(form.subs(t, 0) - x0)  # the power below does not see a sign
    formal = start if start != Outcome.CONFIRMED else zero(
        sympy.powdenest((form / x0) ** (1 - alpha), force=True) - wanted
    )
    if formal != Outcome.CONFIRMED:
        return formal
    orders = []
    for a, share in ((0, "1/2"), (sympy.Rational(3, 2), "1"), (3, "1")):
        A_of, factor = numeric(form, a), float(sympy.Rational(share))
        orders.append(
            measured_order(((str(a), share),), lambda e, T, X, V, A=A_of, f=factor: X - A(f * e, T) * cos(T))
        )
    return all_confirmed(*(reaches(order, 1) for order in orders))


@statement(
    id="lancaster2020:claim.kappa", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The dimensionless parameter kappa",
    latex=r"\kappa \equiv 2b(2\omega_0)^{\alpha}B\left[\frac{\alpha}{2}+1,\frac{\alpha}{2}+1\right]"
    r"/(\pi kx_0^{1-\alpha})",
    printed=kappa(alpha), near_miss=kappa(alpha) / 2, conditions="none", methods=("comparison with (13)", "dimension"),
    note="(13) reads A = x0 [1 + (alpha-1) kappa omega_0 t]^(-1/(alpha-1)); kappa = M_(alpha+1) epsilon. In the"
    " supplied text the definition stands inside the display (13).",
)
def definition_of_kappa(form: sympy.Expr) -> Outcome:
    """The bracket of (13) is 1 + (alpha - 1) kappa omega_0 t, and kappa is M_(alpha+1) epsilon and a pure number."""
    bracket = sympy.powdenest((amplitude(alpha) / x0) ** (1 - alpha), force=True)
    return all_confirmed(
        zero(bracket - 1 - (alpha - 1) * form * omega0 * t),
        zero(form - mean(alpha) * EPSILON),
        same(dimension(form), sympy.Integer(1)),
    )


def late(form: sympy.Expr) -> sympy.Expr:
    """The limit of t^(1/(alpha-1)) A(t) for alpha = 1 + q, from that of its power q: a linear function of 1/t."""
    power = sympy.powdenest(form.subs(alpha, 1 + q) ** (-q), force=True)
    return sympy.expand(sympy.powsimp(sympy.expand(power / t))).subs(t, sympy.oo)


@statement(
    id="lancaster2020:claim.forgets-x0", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="For alpha > 1 the amplitude forgets the initial displacement",
    latex=r"\alpha > 1: \quad \lim_{t\to\infty} t^{1/(\alpha-1)}A(t) \text{ does not depend on } x_0",
    printed=q * mean(1 + q) * b * omega0 ** (2 + q) / k, near_miss=q * mean(1 + q) * b * omega0 ** (2 + q) / k * x0,
    conditions="alpha > 1", methods=("limit of (13)",),
    note="A -> [(alpha-1) M_(alpha+1) b omega_0^(alpha+1) t/k]^(-1/(alpha-1)). Form: the bracket over t; q = alpha-1.",
)
def forgets_x0(form: sympy.Expr) -> Outcome:
    """The form is the limit of t^(-1) A^(1-alpha), and free of x0."""
    return all_confirmed(zero(late(amplitude(alpha)) - form), vanishes(sympy.diff(form, x0)))


@statement(
    id="lancaster2020:claim.decay-exponent", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The decay at late times", latex=r"A(t) \sim t^{-\frac{1}{\alpha-1}} \text{ as } t \to \infty",
    printed=-1 / q, near_miss=-1 / (q + 1), conditions="alpha > 1", methods=("limit of (13)",),
    note="Form: the exponent, with q = alpha - 1. For alpha < 1 the averaged amplitude ends at a finite time.",
)
def decay_exponent(form: sympy.Expr) -> Outcome:
    """A^(-q) grows linearly in t."""
    limit = late(amplitude(alpha))
    return all_confirmed(decided(not limit.has(t), limit.is_nonzero), same(form * q, sympy.Integer(-1)))


@statement(
    id="lancaster2020:claim.slower-with-alpha", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="The decay becomes slower with increasing alpha",
    latex=r"\frac{d}{d\alpha}\left(-\frac{1}{\alpha-1}\right) > 0", printed=-1 / q, near_miss=-q,
    conditions="alpha > 1, at late times", methods=("monotone exponent",),
)
def slower_with_alpha(form: sympy.Expr) -> Outcome:
    """The form is the exponent of t, and it increases with alpha."""
    return all_confirmed(decay_exponent(form), decided(sympy.diff(form, q).is_positive))


@statement(
    id="lancaster2020:claim.three-cases", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="The cases alpha = 0, 1, 2 are contained in (13)",
    latex=r"\langle|\sin|\rangle = \frac{2}{\pi}, \quad \langle\sin^2\rangle = \frac{1}{2}, \quad"
    r" \langle|\sin^3|\rangle = \frac{4}{3\pi}",
    printed=BETA, near_miss=BETA * (alpha + 1) / 2,
    conditions="none", methods=("the integral worked out separately for each case",),
    note="As ref. 16 does; alpha = 1 by the limit of claim.linear-limit. Form: the mean as a function of alpha.",
)
def three_cases(form: sympy.Expr) -> Outcome:
    """The elementary integrals of sin, sin^2, sin^3 over (0, pi)."""
    integrals = [sympy.integrate(sympy.sin(t) ** (a + 1), (t, 0, sympy.pi)) / sympy.pi for a in range(3)]
    return all_confirmed(*(same(form.subs(alpha, a), value) for a, value in enumerate(integrals)))


@statement(
    id="lancaster2020:claim.any-exponent", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lancaster-conditions", line=7,
    shortfall=Shortfall.RANGE,
    title="A(t) may be obtained for any real value of the exponent",
    latex=r"\text{one may also obtain } A(t) \text{ for any real value of damping exponent}",
    corrected_latex=r"\text{for any real } \alpha \ge 0",
    printed=sympy.Interval(-sympy.oo, sympy.oo), corrected=sympy.Interval(0, sympy.oo),
    near_miss=sympy.Interval.open(0, sympy.oo), conditions="for alpha = 0 also epsilon < 1",
    methods=("force on a mass at rest beside the spring's", "convergence of the mean in (11) at the zeros of the sine"),
    note="For alpha < 0 the damping force grows without bound as the speed falls: a mass at rest stays, one that moves"
    " stays at its first turning point, and there is no oscillation whose amplitude (13) could be. The formula itself"
    " makes sense for alpha > -2, where the mean of |sin|^(alpha+1) is finite. Form: the exponents for which a mass"
    " released from rest starts.",
)
def any_exponent(form: sympy.Interval) -> Outcome:
    """From rest at X = 1 the speed w has w' = 1 - E w^alpha; it can grow from 0 if the limit for w -> 0 is positive."""
    w, force = sympy.symbols("w E", positive=True)
    limits = {sign: sympy.limit(1 - force * w ** (sign * q), w, 0, "+") for sign in (-1, 0, 1)}
    rises = {sign: decided(limit.subs(force, sympy.Rational(1, 2)) > 0) for sign, limit in limits.items()}
    starts = {sign: outcome == Outcome.CONFIRMED for sign, outcome in rises.items()}
    known = sympy.Union(
        sympy.Interval.open(-sympy.oo, 0) if starts[-1] else sympy.S.EmptySet,
        sympy.FiniteSet(0) if starts[0] else sympy.S.EmptySet,
        sympy.Interval.open(0, sympy.oo) if starts[1] else sympy.S.EmptySet,
    )
    primitive = s ** (alpha + 2) / (alpha + 2)  # of |sin|^(alpha+1) next to a zero, where sin s = s + ...
    finite = limit_is(primitive.subs(alpha, -2 + q), s, sympy.S.Zero, 0, "+")
    infinite = limit_is(primitive.subs(alpha, -2 - q), s, sympy.S.Zero, -sympy.oo, "+")
    open_ones = Outcome.UNDECIDED if Outcome.UNDECIDED in rises.values() else Outcome.CONFIRMED
    return all_confirmed(open_ones, decided(form == known), finite, infinite)
