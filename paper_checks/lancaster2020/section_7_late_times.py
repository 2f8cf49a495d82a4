"""Equation (22), footnotes 22 and 23, Fig. 3 and the claims on two damping terms at late times.

beta stands for the paper's alpha' > alpha, b2 for b', d for c'.
"""

from collections.abc import Callable
from math import cos

import sympy
from flint import arb

from asymptotics.numbers.context import ctx
from paper_checks.evidence import mark, sampled
from paper_checks.grammar import HYPERGEOMETRIC
from paper_checks.identities import all_confirmed, decided, rounds_to, same, vanishes
from paper_checks.lancaster2020.model import A, alpha, b, b2, dimension, exact_states, k, m, omega0, t, v, x0, zero
from paper_checks.lancaster2020.model import alpha2 as beta
from paper_checks.lancaster2020.section_6_two_laws import (
    DECAY,
    FRACTION,
    LAMBDA,
    QUADRATIC,
    VISCOUS,
    c,
    d,
    envelope,
    solves_20,
)
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

X, rho = sympy.symbols("X rho", positive=True)  # rho = omega_0 x_0 b'/b
LENGTH, ONE = sympy.Symbol("L", positive=True), sympy.Integer(1)
RATIO = 8 * b2 * omega0 / (3 * b * sympy.pi)
LONG_TIME = x0 / (1 + RATIO * x0) * sympy.exp(-b * t / (2 * m))


@statement(
    id="lancaster2020:22", kind=Kind.APPROXIMATION, verdict=Printed.PARTLY, evidence=Evidence.PROVED, order="0",
    derivation="two-laws-time", line=15,
    shortfall=Shortfall.RANGE,
    title="The amplitude at late times",
    latex=r"A(t) \xrightarrow{\omega_0 t \gg 1} \frac{x_0}{1 + \frac{8b'\omega_0}{3b\pi}x_0}e^{-\frac{bt}{2m}}",
    corrected_latex=r"A(t) \xrightarrow{bt/(2m) \gg 1} \frac{x_0}{1 + \frac{8b'\omega_0}{3b\pi}x_0}e^{-\frac{bt}{2m}}",
    printed=(LONG_TIME, omega0 * t), corrected=(LONG_TIME, b * t / (2 * m)),
    near_miss=(LONG_TIME * x0 * RATIO, b * t / (2 * m)), conditions="alpha = 1, alpha' = 2, b > 0, b < 2 m omega_0",
    methods=("quotient to (21) along b = m omega_0/z^2, where z is the variable of the label",),
    note="Formula right, limit in the wrong variable: the relative error of (22) is c' lambda e^{-bt/(2m)}, so it is"
    " bt/(2m), not omega_0 t, that must be large. In Fig. 3 (b = omega_0 x0 b') the two differ by 46 % at the start and"
    " as long as omega_0 t << m omega_0/b. Order 0: at a fixed slow time the error does not vanish with epsilon. Form:"
    " the limit, and the variable that must be large.",
)
def late_amplitude(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """limit/(21) must tend to 1 when the variable z tends to infinity, with m = k = 1, b' = rho b and b = 1/z^2."""
    late, variable = form
    exact = FRACTION.subs({c: VISCOUS, d: QUADRATIC})
    z = sympy.Symbol("z", positive=True)
    linear = {alpha: 1, beta: 2}
    units = {b2: rho * b, m: 2, k: 18, omega0: 3, x0: 5}  # consistent, and no two alike
    pure = all_confirmed(same(dimension(late).subs(linear), LENGTH), same(dimension(variable).subs(linear), ONE))
    when = sympy.solve(variable.subs(units) - z, t)[0]
    quotient = sympy.simplify((late / exact).subs(units).subs(t, when).subs(b, z**-2))
    return all_confirmed(pure, vanishes(sympy.limit(quotient, z, sympy.oo) - 1))


@statement(
    id="lancaster2020:claim.denominator-exponential", kind=Kind.CLAIM, verdict=Printed.HOLDS,
    evidence=Evidence.PROVED, paraphrase=True,
    title="In the long-time limit the exponential in the denominator may be neglected",
    latex=r"\lim_{t\to\infty}\frac{A(t)}{c\lambda e^{-ct/(\pi k)}} = 1", printed=c * LAMBDA * DECAY,
    near_miss=c * LAMBDA * DECAY**2, conditions="none", methods=("limit of the quotient",), derivation="two-laws-time",
    note="And c lambda e^{-ct/(pi k)} is the right side of (22).",
)
def denominator(form: sympy.Expr) -> Outcome:
    """Quotient to (21) as the decaying factor tends to 0, and the constants of (22)."""
    y = sympy.Symbol("y", positive=True)
    quotient = sympy.simplify((form / FRACTION).subs(t, -sympy.log(y) * sympy.pi * k / c))
    values = {c: VISCOUS, d: QUADRATIC}
    return all_confirmed(vanishes(quotient.subs(y, 0) - 1), vanishes((c * LAMBDA * DECAY).subs(values) - LONG_TIME))


@statement(
    id="lancaster2020:claim.linear-recovered", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="Negligible quadratic damping", latex=r"\omega_0 x_0b' \ll b: \quad A(t) \to x_0e^{-\frac{bt}{2m}}",
    printed=(x0, 0), near_miss=(x0 / 2, 0),
    conditions="none", methods=("limit of (22)",), note="Form: A e^{bt/2m}, and the limit of rho.",
)
@statement(
    id="lancaster2020:claim.strong-quadratic", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="Dominant quadratic damping",
    latex=r"\omega_0 x_0b' \gg b: \quad A(t) \to \frac{3b\pi}{8b'\omega_0}e^{-\frac{bt}{2m}}",
    printed=(3 * sympy.pi * x0 / (8 * rho), sympy.oo), near_miss=(8 * x0 / (3 * sympy.pi * rho), sympy.oo),
    conditions="late times, bt/(2m) >> 1", methods=("limit of (22)",),
    note="Form: A e^{bt/2m} with rho = omega_0 x0 b'/b, and the limit of rho.",
)
@statement(
    id="lancaster2020:claim.memory-lost", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="Then the dependence on the initial value disappears", printed=(3 * sympy.pi * x0 / (8 * rho), sympy.oo),
    latex=r"\omega_0 x_0b' \gg b: \quad \frac{\partial}{\partial x_0}\lim A(t)e^{\frac{bt}{2m}} = 0",
    near_miss=(x0 * sympy.Rational(3, 8) * sympy.pi, sympy.oo), conditions="late times, bt/(2m) >> 1",
    methods=("limit of (22)",), note="x0/rho = b/(omega_0 b') is free of x0. Form as for claim.strong-quadratic.",
)
def limits_of_ratio(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """(22) with b' = rho b/(omega_0 x0), divided by the form, in the limit; for rho -> oo also free of x0."""
    wanted, end = form
    prefactor = (LONG_TIME * sympy.exp(b * t / (2 * m))).subs(b2, rho * b / (omega0 * x0))
    limit = vanishes(sympy.limit(sympy.simplify(prefactor / wanted), rho, end) - 1)
    if end == 0:
        return limit
    return all_confirmed(limit, vanishes(sympy.diff(wanted.subs(rho, omega0 * x0 * b2 / b), x0)))


@statement(
    id="lancaster2020:claim.smallest-alpha", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The term with the smallest exponent rules the long-time decay",
    latex=r"\text{the long-time decay is dominated by the term with the smallest value of } \alpha",
    printed=A ** (beta - alpha), near_miss=A ** (alpha - beta), derivation="two-laws-time",
    conditions="b > 0 and A -> 0, for any alpha < alpha': from A << (c/c')^(1/(alpha'-alpha)) on. The prefactor keeps"
    " a memory of the other term",
    methods=("quotient of the two terms of (20) as A -> 0",),
    note="So it is for every pair, not only (1, 2). For a smallest alpha < 1 the averaged amplitude ends at a finite"
    " time, and the motion sticks or creeps instead. Form: the quotient of the terms, up to c'/c.",
)
def smallest_exponent(form: sympy.Expr) -> Outcome:
    """The form is the quotient A^alpha'/A^alpha, and with alpha' = alpha + rho it tends to 0 with A."""
    quotient = zero(form - A**beta / A**alpha)
    gone = sympy.powdenest(form.subs(beta, alpha + rho)).subs(A, 0)
    return all_confirmed(quotient, decided(gone.is_zero))


Claim = Callable[..., bool]


def _single(exponents: tuple[sympy.Rational, ...]) -> bool:
    return len(exponents) == 1 and exponents[0] > 2


def _smallest(exponents: tuple[sympy.Rational, ...]) -> bool:
    return min(exponents) > 2


def _any(exponents: tuple[sympy.Rational, ...]) -> bool:
    return max(exponents) > 2


@statement(
    id="lancaster2020:claim.single-term-slow", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.MEASURED,
    derivation="two-laws-time", line=24,
    shortfall=Shortfall.CONDITION,
    extent="sampled: 8 points",
    title="When damping with alpha > 2 decays too slowly",
    latex=r"\text{the argument ... only holds when a } single \text{ damping term with } \alpha > 2 \text{ is present}",
    corrected_latex=r"\text{it holds when all terms present have } \alpha > 2", printed=_single, corrected=_smallest,
    near_miss=_any, conditions="as printed: if the other term has an exponent of at most 2",
    methods=("late decay by the smallest exponent, claim.smallest-alpha",),
    note="With (1, alpha') the decay is exponential, as the paper says; with (3, 4) it is t^(-1/2), no faster than with"
    " 3 alone. 'Too slow' means slower than the 1/t of alpha = 2. Form: for which sets of exponents it decays slowly.",
)
def slow_decay(form: Claim) -> Outcome:
    """t^(-1/(alpha-1)) with the smallest exponent alpha > 1; an exponential or an end at a finite time otherwise."""
    tried = sampled(((3,), ("5/2",), (2,), (1, 3), (3, 4), (2, 3), (0, 3), (3, 5, 7)))
    sets = [tuple(map(sympy.Rational, exponents)) for exponents in tried]

    def slow(exponents: tuple[sympy.Rational, ...]) -> bool:
        least = min(exponents)
        return decided(least - 1 > 1) == Outcome.CONFIRMED  # 1/(least - 1) < 1

    return decided(all(form(e) == slow(e) for e in sets))


@statement(
    id="lancaster2020:claim.not-distinguishable", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED,
    title="Linear and quadratic drag cannot always be told apart from data", printed=("0.1", "0.0011"),
    latex=r"\text{distinguishing between (for example) linear and quadratic functions as the dominant drag term ... is}"
    r"\ \text{not always possible}", near_miss=("0.1", "0.0012"), premises=(0,), digits=2,
    conditions="data whose amplitude falls by a tenth, with errors above 0.0011 of it",
    methods=("largest distance of the two envelopes through the same two amplitudes, balls",),
    note="Not the data of ref. 24, which are not at hand, but an example of what it says: e^{-at} and 1/(1 + ct) that"
    " start alike and end at 1/1.1 differ by 0.00108 at most in between. Form: the fall c t at the end, and the"
    " largest difference.",
)
def not_distinguishable(form: tuple[str, str]) -> Outcome:
    """The largest |(1+p)^-s - 1/(1+ps)|: above its value at s = 1/2, below the largest ball of 2000 pieces."""
    fall = sympy.Rational(form[0])
    with ctx.workprec(80):
        p = arb(fall.p) / fall.q
        pieces = [arb(1) / 2, *(arb(2 * n + 1) / 4000 + arb(0, 0.00025) for n in range(2000))]
        gaps = [abs(1 / (1 + p * s) - (-s * (1 + p).log()).exp()) for s in pieces]
        least, most = gaps[0].lower(), max(gap.upper() for gap in gaps)
        return rounds_to(form[1], least.union(most))


@statement(
    id="lancaster2020:claim.no-exact-solutions", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lelas-friction-exact", line=18,
    shortfall=Shortfall.RANGE,
    title="Combinations of sliding, linear and quadratic drag have no exact solutions",
    latex=r"\text{such a setup which has no exact solutions}", printed=None, corrected=-b / k, near_miss=b / k,
    corrected_latex=r"\text{sliding and linear drag together are solved exactly, half-swing by half-swing}",
    conditions="as printed: where quadratic drag takes part, no elementary x(t) is known",
    methods=("substitution of the solution",),
    note="With b sgn v + b' v each half-swing is a linear oscillation by (2) about -b/k sgn v. Sliding and quadratic"
    " drag leave an equation linear in v^2, so v(x) is elementary and t one quadrature; linear and quadratic drag leave"
    " Abel's equation m v dv/dx = -k x - b v - b' v^2, for which no quadrature is known. Form: the centre of the linear"
    " oscillation for v > 0; none, where no solution is said to exist.",
)
def exact_solutions(form: sympy.Expr | None) -> Outcome:
    """x = centre + e^(-gamma t)(...) solves m x'' + 2 m gamma x' + k x + b = 0, v > 0, only about the form.

    And of m v dv/dx = -k x - b v^n - b2 v^2, halved in y = v^2, the right side is linear in y for n = 0 alone.
    """
    if form is None:  # refuted by the solution that the same substitution confirms
        exists = exact_solutions(-b / k) == Outcome.CONFIRMED
        return Outcome.REFUTED if exists else Outcome.UNDECIDED
    gamma, omega = sympy.symbols("gamma omega", positive=True)
    swing = sympy.exp(-gamma * t) * (c * sympy.cos(omega * t) + d * sympy.sin(omega * t)) + form
    residual = m * sympy.diff(swing, t, 2) + 2 * m * gamma * sympy.diff(swing, t) + k * swing + b
    square = sympy.Symbol("y", positive=True)
    bent = [sympy.diff(-k * X - b * square ** (n / 2) - b2 * square, square, 2) for n in (sympy.S.Zero, sympy.S.One)]
    linear = all_confirmed(vanishes(bent[0]), decided(bent[1].is_nonzero))
    return all_confirmed(vanishes(sympy.expand(residual.subs(k, m * (gamma**2 + omega**2)))), linear)


ANTIDERIVATIVE = (
    X ** (1 - beta) / (d * (1 - beta))
    * HYPERGEOMETRIC(1, (beta - 1) / (beta - alpha), (1 + alpha - 2 * beta) / (alpha - beta),
                     -c / d * X ** (alpha - beta))
)  # footnote 22 as printed: a factor times 2F1(1, a; e; z)


FOOTNOTE_22 = (
    r"\int\frac{dx}{cx^{\alpha} + c'x^{\alpha'}} = \frac{x^{1-\alpha'}\,{}_2F_1\left(1,"
    r"\frac{\alpha'-1}{\alpha'-\alpha};\frac{1+\alpha-2\alpha'}{\alpha-\alpha'};-\frac{c}{c'}x^{\alpha-\alpha'}\right)}"
    r"{c'(1-\alpha')}"
)
EXCEPTIONS = ((0, "1/2"), (0, "1/3"), ("1/3", "2/3"))  # besides alpha' = 1
EXPONENT_PAIRS = (
    (1, 2), (0, 2), (2, 3), ("3/2", 3), (0, "3/4"), (0, "2/3"), (0, 1), ("1/2", 1), *EXCEPTIONS
)  # fmt: skip


def _all_pairs(low: sympy.Rational, high: sympy.Rational) -> bool:
    return True


def _regular(low: sympy.Rational, high: sympy.Rational) -> bool:
    index = (high - 1) / (high - low)
    return not (index.is_integer and index <= 0)


_LISTED = ", ".join(f"({low}, {high})" for low, high in EXCEPTIONS)


def _not_one(low: sympy.Rational, high: sympy.Rational) -> bool:
    return high != sympy.S.One


@statement(
    id="lancaster2020:fn22", kind=Kind.IDENTITY, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    shortfall=Shortfall.CONDITION,
    title="The integral of (20) for any two exponents (footnote 22)",
    latex=FOOTNOTE_22,
    corrected_latex=FOOTNOTE_22 + r", \quad \frac{\alpha'-1}{\alpha'-\alpha} \neq 0, -1, -2, \ldots",
    printed=(ANTIDERIVATIVE, _all_pairs), corrected=(ANTIDERIVATIVE, _regular),
    near_miss=(ANTIDERIVATIVE, _not_one), derivation="two-laws-time", line=10,
    conditions="(alpha'-1)/(alpha'-alpha) not 0, -1, -2, ...: not alpha' = 1 - n(alpha'-alpha), n = 0, 1, 2, ...",
    methods=("differentiated, with the differential equation z F' + a F = a/(1-z)", "parameters at test pairs"),
    note=f"The exceptional exponents are not excluded: alpha' = 1, whatever alpha (division by zero), and {_LISTED},"
    " ..., where the lower parameter is 0, -1, ... There the companion form with the two terms exchanged,"
    " x^(1-alpha)/(c(1-alpha)) 2F1(1, (1-alpha)/(alpha'-alpha); ...; -(c'/c) x^(alpha'-alpha)), is regular: friction"
    " with viscous drag, (0, 1), is such a case. For alpha' > 1 nothing is wrong. Form: the right side, and for which"
    " pairs it is claimed.",
)
def hypergeometric(form: tuple[sympy.Expr, Claim]) -> Outcome:
    """The derivative, for F = 2F1(1, a; a+1; z); and parameters and factor finite for just the pairs claimed."""
    pairs = [tuple(map(sympy.Rational, pair)) for pair in sampled(EXPONENT_PAIRS)]
    right, claim = form
    (function,) = right.atoms(HYPERGEOMETRIC)
    (one, a, lower, argument), factor = function.args, right / function
    F, z = sympy.symbols("F z", positive=True)
    slope = a / (1 - z) - a * F  # z F'
    derivative = sympy.diff(factor, X) * F + factor * slope * sympy.diff(argument, X) / argument
    residual = derivative.subs(z, argument) - 1 / (c * X**alpha + d * X**beta)
    bottoms = [lower.subs({alpha: low, beta: high}) for low, high in pairs]
    usable = [high != 1 and not (z.is_integer and z <= 0) for (_, high), z in zip(pairs, bottoms)]
    claimed = [claim(*pair) for pair in pairs]
    listed = not any(usable[-len(EXCEPTIONS) :])  # what the note lists is exceptional indeed
    regular = vanishes(sympy.simplify(lower - a - 1))
    return all_confirmed(zero(residual), regular, same(one, ONE), decided(listed and claimed == usable))


@statement(
    id="lancaster2020:fn23", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="How b and b' are to be compared (footnote 23)", latex=r"b' \to \omega_0 x_0b'",
    printed=omega0 * x0 * b2, near_miss=omega0 * b2, conditions="alpha = 1, alpha' = 2",
    methods=("dimension of b x' and b' x'^2",), note="Form: what is compared with b.",
)
def compared(form: sympy.Expr) -> Outcome:
    """The form has the dimension of b, and form/b is the quotient of the two forces at the speed omega_0 x0."""
    values = {alpha: 1, beta: 2}
    like = same(dimension(form).subs(values), dimension(b).subs(values))
    scale = same(form / b, (b2 * v**2 / (b * v)).subs(v, omega0 * x0))  # the quotient of the forces at full speed
    return all_confirmed(like, scale)


@statement(
    id="lancaster2020:fig3", kind=Kind.FIGURE, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="1",
    paraphrase=True,
    extent="sampled: 240 points",
    title="Viscous and quadratic drag together",
    latex=r"\alpha = 1, \alpha' = 2, b = \omega_0 x_0b': \text{ (21) provides an excellent approximation; at long times"
    r" (22) becomes an accurate representation}",
    printed=(FRACTION, c * LAMBDA * DECAY), near_miss=(c * LAMBDA * DECAY, c * LAMBDA * DECAY),
    conditions="epsilon = b/(m omega_0) << 1, not given in the paper; checked and drawn at 1/10",
    methods=("exact motion at t up to 60/omega_0, epsilon = 1/10",),
    note="Regenerated. The error of (21) stays below 8 % of x0 and falls with the amplitude; that of (22) is 46 % at"
    " the start, and as small as that of (21) from b t/(2m) = 2 on. Near miss: (22) from the start. Form: (21) and the"
    " long-time limit.",
)
def figure_3(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The largest errors of the two curves, relative to x0 before omega_0 t = 40 and after."""
    mark(Evidence.MEASURED)
    always, late = (envelope(curve) for curve in form)
    times = sampled(str(sympy.Rational(n, 4)) for n in range(1, 241))
    states = exact_states((("1", "1/10"), ("2", "1/10")), times)
    first, second = 0.0, 0.0
    for text, (place, _) in zip(times, states):
        tau = float(sympy.Rational(text))
        first = max(first, abs(place - always(0.1, tau) * cos(tau)))
        if tau > 40:
            second = max(second, abs(place - late(0.1, tau) * cos(tau)))
    values = {c: VISCOUS, d: QUADRATIC}
    heavier = {b: m * b, b2: m * b2, k: m * k}  # (1) divided by m knows only these quotients
    scaled = all_confirmed(*(vanishes(sympy.diff(f.subs(values).subs(heavier, simultaneous=True), m)) for f in form))
    near = [abs(late(0.1, tau) / always(0.1, tau) - 1) for tau in (41.0, 60.0)]
    curves = all_confirmed(solves_20(form[0]), denominator(form[1]))
    return all_confirmed(scaled, curves, decided(first < 0.08, second < 0.02, near[0] < 0.06, near[1] < 0.025))
