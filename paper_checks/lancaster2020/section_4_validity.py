"""Equations (14)-(17): where the amplitude is slow, what strong damping does, and what fails for alpha < 1.

In the forms T = omega_0 t, K = kappa, q = alpha - 1 > 0 or p = 1 - alpha > 0, E = epsilon.
"""

from functools import cache

import sympy
from flint import arb

from asymptotics.law import Law
from asymptotics.numbers.bridge import closed_form_ball
from asymptotics.numbers.context import ctx
from asymptotics.turning.choose import turning_points
from paper_checks.evidence import sampled
from paper_checks.identities import all_confirmed, below, decided, limit_is, same, vanishes
from paper_checks.lancaster2020.model import EPSILON, alpha, amplitude, b, k, kappa, mean, omega0, strength, t, x0, zero
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

K, T, E, q, p, z = sympy.symbols("K T E q p z", positive=True)
w, X = sympy.symbols("w X", positive=True)
ALL_STRENGTHS = ("1/10", "1", "2", "5", "100")
QUADRATIC_MEAN = sympy.Rational(4, 3) / sympy.pi
RATE = K / (1 + (alpha - 1) * K * T)  # |A'|/(omega_0 A), while the bracket is positive


@statement(
    id="lancaster2020:claim.weak-not-slow", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="Weak damping is generally not equivalent to slow dissipation",
    latex=r"\kappa \ll 1 \text{ is equivalent to } |\dot{A}| \ll \omega_0 A \text{ at all times only for } \alpha = 1",
    printed=1, near_miss=2, conditions="none", methods=("time dependence of (14)",),
    derivation="lancaster-energy", line=14,
    note="alpha > 1: strong damping becomes slow; alpha < 1: weak damping ends fast. Form: alpha.",
)
def weak_not_slow(form: int) -> Outcome:
    """The rate is independent of time, hence equal to kappa, for alpha = 1 and no other exponent."""
    slope = sympy.factor(sympy.diff(RATE, T))
    others = decided(sympy.solve(sympy.numer(sympy.together(slope)), alpha) == [1])
    return all_confirmed(vanishes(slope.subs(alpha, form)), others)


@statement(
    id="lancaster2020:claim.long-or-short", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="For alpha != 1 the approximation works best at either long or short times",
    latex=r"\alpha > 1: \text{long times}; \quad \alpha < 1: \text{short times}", printed=(-1, 0, 1),
    near_miss=(1, 0, -1),
    conditions="none", methods=("sign of the time derivative of (14)",), derivation="lancaster-energy", line=14,
    note="Form: whether |A'|/A falls (-1) or grows (1) for alpha > 1, = 1, < 1.",
)
@statement(
    id="lancaster2020:claim.crossover", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="alpha = 1 is the crossover between slow dissipation at long and at short times",
    latex=r"\alpha = 1 \text{ represents a sort of crossover case}", printed=(-1, 0, 1), near_miss=(-1, -1, 1),
    conditions="none", methods=("sign of the time derivative of (14)",), derivation="lancaster-energy", line=14,
    note="Form as for claim.long-or-short.",
)
def monotone_rate(form: tuple[int, int, int]) -> Outcome:
    """dR/dT = -(alpha-1) R^2: the sign is that of 1 - alpha."""
    exact = same(sympy.diff(RATE, T), -(alpha - 1) * RATE**2)
    signs = tuple(int(sympy.sign(-(a - 1))) for a in (2, 1, sympy.Rational(1, 2)))
    return all_confirmed(exact, decided(signs == form))


@statement(
    id="lancaster2020:14", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The condition of slow dissipation",
    latex=r"\frac{|\dot{A}|}{A} = \kappa\omega_0\left|1 + (\alpha-1)\kappa\omega_0 t\right|^{-1} \ll \omega_0",
    printed=K * omega0 / (1 + (alpha - 1) * K * omega0 * t),
    near_miss=K * omega0 / (1 + alpha * K * omega0 * t),
    conditions="alpha != 1, and for alpha < 1 before the bracket vanishes, at (1-alpha) kappa omega_0 t = 1",
    methods=("logarithmic derivative of (13)",), derivation="lancaster-energy", line=12,
    note="True for alpha = 1 as well. Form: the middle member, for a positive bracket.",
)
def slow_condition(form: sympy.Expr) -> Outcome:
    """-A'/A from (13) with the printed kappa."""
    A = amplitude(alpha)
    return zero(-sympy.diff(sympy.expand_log(sympy.log(A), force=True), t) - form.subs(K, kappa(alpha)))


@statement(
    id="lancaster2020:claim.weak-equals-slow", kind=Kind.CLAIM, verdict=Printed.TRANSCRIPTION,
    evidence=Evidence.PROVED, title="For alpha = 1 slow dissipation is weak damping",
    latex=r"\text{The case } \alpha = 1 \text{ reduces dimensionless parameter in the equivalence of the ...}"
    r" \text{ slow-dissipation limit to the weak-damping limit}",
    corrected_latex=r"\alpha = 1: \quad \frac{|\dot{A}|}{A} = \kappa\omega_0 = \frac{b}{2m} \ll \omega_0",
    printed=(), corrected=(K,), near_miss=(2 * K,),
    conditions="none", methods=("(14) at alpha = 1",), derivation="lancaster-energy", line=12,
    note="The two halves of the sentence stand apart, below (13) and below (14), and its middle is lost; as supplied it"
    " states nothing. kappa = b/(2 m omega_0) is gamma/omega_0. Form: |A'|/(omega_0 A) at alpha = 1, if any is stated.",
)
def weak_equals_slow(form: tuple[sympy.Expr, ...]) -> Outcome:
    """(14) at alpha = 1, and kappa there."""
    if not form:
        return Outcome.REFUTED
    linear = kappa(sympy.Integer(1)) - b * omega0 / (2 * k)
    return all_confirmed(same(RATE.subs(alpha, 1), form[0]), vanishes(linear))


@statement(
    id="lancaster2020:15", kind=Kind.APPROXIMATION, verdict=Printed.PARTLY, evidence=Evidence.PROVED, order="0",
    shortfall=Shortfall.RANGE,
    title="The rate at late times",
    latex=r"\frac{|\dot{A}|}{A} \xrightarrow{\omega_0 t \gg 1} \frac{1}{(\alpha-1)t} \ll \omega_0",
    corrected_latex=r"\frac{|\dot{A}|}{A} < \frac{1}{(\alpha-1)t} \text{ always}; \quad \frac{|\dot{A}|}{A} \to"
    r" \frac{1}{(\alpha-1)t} \text{ for } (\alpha-1)\kappa\omega_0 t \gg 1",
    printed=T, corrected=q * K * T, near_miss=q * T,
    conditions="alpha > 1; the arrow as labelled needs kappa of order 1",
    methods=("limit along kappa = 1/z^2, where z is the variable of the label",),
    derivation="lancaster-energy", line=15,
    note="The limit is taken in the wrong variable, although the line above (15) has the right one: for 1 << omega_0 t"
    " << 1/((alpha-1) kappa) the rate is still kappa omega_0. As an inequality it holds for all t and b, so that"
    " (14) is satisfied for (alpha-1) omega_0 t >> 1 all the same. Order 0 in epsilon, at a fixed epsilon omega_0 t."
    " Form: the variable that must be large.",
)
def late_rate(form: sympy.Expr) -> Outcome:
    """rate (alpha-1) t = y/(1+y), y = q K T, must tend to 1 when the form z tends to infinity, whatever K and q do.

    K and q run through powers of z on both sides of 1: small and large strengths, exponents near 1 and far from it.
    """
    y = (q * K * T).subs(T, sympy.solve(form - z, T)[0])
    paths = [y.subs({K: z**power, q: z**other}) for power in (-2, 0, 2) for other in (-2, 0, 2)]
    return all_confirmed(*(limit_is(path / (1 + path), z, sympy.oo, 1) for path in paths))


@statement(
    id="lancaster2020:claim.valid-for-any-b", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.CERTIFIED,
    shortfall=Shortfall.RANGE,
    extent="sampled: 2 points",
    title="When (13) becomes valid",
    latex=r"\text{(13) becomes valid at times } t \gg \frac{1}{(\alpha-1)\omega_0} \text{ regardless of the value of}"
    r"\ b",
    corrected_latex=r"t \gg \frac{\max(1, \alpha\epsilon^{1/\alpha})}{(\alpha-1)\omega_0}",
    printed=1 / q, corrected=sympy.Max(1, (1 + q) * E ** (1 / (1 + q))) / q, near_miss=E ** sympy.Rational(1, 4) / q,
    conditions="alpha > 1; sufficiency of the corrected time certified at alpha = 2, epsilon = 1 and 100",
    methods=("bound X > 1 - epsilon^(-1/alpha) omega_0 t on the first swing, certified", "certified turning points"),
    note="For every fixed b (13) is right in the end, with a relative error O(1/t): the motion forgets its start, as"
    " (13) does. But the time it takes grows with b. The speed never exceeds (k x0/b)^(1/alpha), so the first crossing"
    " takes about alpha epsilon^(1/alpha)/((alpha-1) omega_0), during which x is near x0 and (13) is far too small:"
    " its condition (14) is met, its premise (9) is not. Form: the time in units of 1/omega_0.",
)
def valid_for_any_strength(form: sympy.Expr) -> Outcome:
    """At 100 times the form the first swing must not still be under way (epsilon = 10^24); at 20 times it is right.

    On the first swing w' = X - epsilon w^alpha <= 1 - epsilon w^alpha, so w <= epsilon^(-1/alpha) and
    X >= 1 - tau epsilon^(-1/alpha); alpha = 3/2, 2 and 3.
    """
    law, huge = {q: 1}, 10**24
    for excess in (sympy.Rational(1, 2), sympy.Integer(1), sympy.Integer(2)):
        with ctx.workprec(100):
            tau = 100 * closed_form_ball(form.subs({q: excess, E: huge}))
            lowest = 1 - tau * closed_form_ball(sympy.Integer(huge) ** (-1 / (1 + excess)))
            amplitude_13 = (1 + excess * mean(1 + excess) * huge * T) ** (-1 / excess)
            small = closed_form_ball(amplitude_13.subs(T, 1)) < arb("0.01")  # from tau = 1 on, hence at the form's
            if lowest > arb("0.5") and tau > 1 and small:
                return Outcome.REFUTED
    needed = _sharp(form.subs(law).subs(E, 1000))  # what is far too late is not followed: 20 E^(3/2) took 60 s
    followed = () if needed == Outcome.REFUTED else sampled((1, 100))
    return all_confirmed(needed, *(_within(e, 20 * form.subs(law).subs(E, e), "0.1") for e in followed))


def _sharp(time: sympy.Expr) -> Outcome:
    """At epsilon = 1000 the time is that of the first swing up to a factor 10: neither too early nor too late."""
    table = turning_points(Law({2: "1000"}), 2, 20, times=True)
    with ctx.workprec(100):
        quotient = closed_form_ball(time) / arb(table.points[1].tau)
        return all_confirmed(below(arb("0.1"), quotient), below(quotient, arb(10)))


def _within(epsilon: int, earliest: sympy.Expr, tolerance: str) -> Outcome:
    """Whether (13) meets |X| at the first turning point after ``earliest``, alpha = 2, certified."""
    count = int(earliest / 3) + 2  # a half-swing takes at least pi
    table = turning_points(Law({2: epsilon}), 1, 20, start=count, times=True)
    return _close(epsilon, table.points[0].x, table.points[0].tau, tolerance)


def _close(epsilon: int, place: str, tau: str | None, tolerance: str) -> Outcome:
    """|(|X| (1 + kappa tau)) - 1| < tolerance, from correctly rounded decimals."""
    with ctx.workprec(100):
        kappa_ball = closed_form_ball(QUADRATIC_MEAN) * epsilon
        return below(abs(abs(arb(place)) * (1 + kappa_ball * arb(tau or "0")) - 1), arb(tolerance))


@statement(
    id="lancaster2020:claim.corollary", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    shortfall=Shortfall.CONSEQUENCE, title="That there is no overdamping is a corollary of the validity of (13)",
    latex=r"\text{An interesting corollary to this statement is that critically damped or overdamped behavior does not}"
    r"\ \text{occur}",
    corrected_latex=r"\text{the ansatz } A(t)\cos(\omega_0t) \text{ oscillates for every } A \text{, also where the"
    r" motion does not}",
    printed=sympy.oo, corrected=sympy.Integer(0), near_miss=sympy.Integer(1),
    conditions="the conclusion is true for alpha > 1, see claim.no-overdamping; this way does not lead to it",
    methods=("solution of the overdamped linear oscillator, substituted", "its zeros"),
    note="A(t) cos(omega_0 t) vanishes at every odd multiple of pi/2, whatever A is: that the motion oscillates is put"
    " in, not found. At alpha = 1, epsilon = 5/2 the same ansatz has infinitely many zeros and the motion none. Form:"
    " how many times that motion passes the origin.",
)
def corollary(form: sympy.Expr) -> Outcome:
    """X'' + 5/2 X' + X = 0 from rest at 1: (4 e^(-tau/2) - e^(-2 tau))/3, whose zero e^(-3 tau/2) = 4 is at tau < 0."""
    motion = (4 * sympy.exp(-T / 2) - sympy.exp(-2 * T)) / 3
    speed = sympy.diff(motion, T)
    law = vanishes(sympy.diff(speed, T) + sympy.Rational(5, 2) * speed + motion)
    start = all_confirmed(vanishes(motion.subs(T, 0) - 1), vanishes(speed.subs(T, 0)))
    (y,) = sympy.solve(4 - z, z)  # the motion is e^(-tau/2) (4 - z)/3 with z = e^(-3 tau/2) <= 1
    shape = vanishes(motion - sympy.exp(-T / 2) * (4 - sympy.exp(-3 * T / 2)) / 3)
    return all_confirmed(law, start, shape, decided(y > 1), decided(sympy.Eq(form, 0)))


@statement(
    id="lancaster2020:claim.no-overdamping", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="No critical damping and no overdamping for alpha > 1",
    latex=r"\text{critically damped or overdamped behavior does not occur for any damping strength when } \alpha > 1",
    printed=E * w**q * (w / X), near_miss=E * (w / X), conditions="alpha > 1, any b, any start",
    methods=("equation of the ratio w/X towards the origin",), derivation="no-overdamping",
    note="The paper calls it a somewhat speculative conjecture; it is a theorem, and needs no expansion. Near miss:"
    " alpha = 1, where the drag term does not die out. Form: the drag in the equation of Z = w/X.",
)
def no_overdamping(form: sympy.Expr) -> Outcome:
    """Let X fall towards 0 with speed w = -X' and never reach it; then X, w -> 0 (the energy falls; a limit X > 0
    would leave a force). Z = w/X obeys Z' = 1 + Z^2 - eta Z with eta = epsilon w^(alpha-1) -> 0, so from some time on
    eta < 1 and Z' >= 1 + Z^2 - Z >= (1 + Z^2)/2: Z becomes infinite in finite time, a contradiction.
    Beyond X = 0, X is negative and w' = X - ... < 0 is bounded away from 0, so that w = 0 is reached: a turning point.
    """
    eta = sympy.Symbol("eta", positive=True)
    Z = w / X
    derivative = sympy.diff(Z, w) * (X - E * w ** (1 + q)) + sympy.diff(Z, X) * (-w)
    equation = zero(derivative - (1 + Z**2 - form))
    square = vanishes(sympy.expand(1 + z**2 - eta * z - ((z - eta / 2) ** 2 + 1 - eta**2 / 4)))
    return all_confirmed(equation, square, vanishes((form / Z).subs(w, 0)))


@statement(
    id="lancaster2020:claim.quadratic-never-overdamped", kind=Kind.CLAIM, verdict=Printed.HOLDS,
    paraphrase=True,
    evidence=Evidence.PROVED, title="For alpha = 2 this has been demonstrated before (ref. 10)",
    latex=r"\text{The absence of critically damped or overdamped dynamics has been demonstrated for } \alpha = 2",
    printed=2, near_miss=1,
    conditions="none", methods=("speed at the origin from the first integral, positive for every start",),
    note="smith2012:claim.never-overdamped. With u = epsilon X: w^2 = u + 1/2 - (u_0 + 1/2) e^(2(u-u_0)). Form: the"
    " factor in the exponent.",
)
def quadratic_never_overdamped(form: int) -> Outcome:
    """The form solves d(w^2)/du = 2 w^2 - 2 u, w^2(u_0) = 0; its value at u = 0 is 0 at u_0 = 0 and grows with u_0."""
    u, u0 = sympy.symbols("u u_0", positive=True)
    square = u + sympy.Rational(1, 2) - (u0 + sympy.Rational(1, 2)) * sympy.exp(form * (u - u0))
    at_origin = square.subs(u, 0)
    return all_confirmed(
        vanishes(sympy.diff(square, u) - 2 * square + 2 * u),
        vanishes(square.subs(u, u0)),
        vanishes(at_origin.subs(u0, 0)),
        same(sympy.diff(at_origin, u0), 2 * u0 * sympy.exp(-2 * u0)),
    )


@statement(
    id="lancaster2020:claim.large-b-agreement", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.CERTIFIED,
    shortfall=Shortfall.RANGE,
    extent="sampled: 15 points",
    title="Agreement for large b, with only the phase disagreeing substantially",
    latex=r"\text{Agreement ... turns out to be quite good, even for large values of } b \text{ with only the phase}"
    r"\ \text{of the asymptotic solution disagreeing substantially}",
    corrected_latex=r"\text{within 5 percent at the turning points for } \epsilon \le 2, 2, 5 \text{ at } \alpha ="
    r" \tfrac{3}{2}, 2, 3; \text{ not for } \epsilon \ge 5, 5, 100",
    printed=("100", "100", "100"), corrected=("2", "2", "5"), near_miss=("2", "5", "5"),
    conditions="alpha = 3/2, 2, 3; the first five turning points",
    methods=("certified turning points, alpha = 3/2, 2, 3, each at epsilon = 1/10, 1, 2, 5, 100",),
    note="At epsilon = 1 the amplitudes agree to 0.2 %, for all three exponents. But at epsilon = 5 the first one is"
    " off by 87 % for alpha = 3/2 and by 17 % for alpha = 2; at 100 by the factors 107, 4.3 and 1.4: then it is not"
    " only the phase. For alpha <= 1 the sentence is not meant: it supports the conjecture on alpha > 1. Form: the"
    " largest epsilon of the list for which it is true, for each exponent.",
)
def large_strength(form: tuple[str, ...]) -> Outcome:
    """(13) against |X_n| at tau_n, n = 1 ... 5: within 5 % up to the epsilon of the form, and for no greater one."""
    outcomes = []
    for text, last in zip(("3/2", "2", "3"), form):
        found = {epsilon: _agrees(text, epsilon) for epsilon in sampled(ALL_STRENGTHS)}
        if Outcome.UNDECIDED in found.values():
            return Outcome.UNDECIDED
        good = [outcome == Outcome.CONFIRMED for outcome in found.values()]
        outcomes.append(decided(good == [sympy.Rational(e) <= sympy.Rational(last) for e in ALL_STRENGTHS]))
        outcomes.append(decided(last in ALL_STRENGTHS))
    return all_confirmed(*outcomes)


@cache
def _first_five(exponent: str, epsilon: str) -> tuple[tuple[str, str], ...]:
    """x and tau of the turning points 1 ... 5, as certified decimals."""
    table = turning_points(Law({exponent: epsilon}), 6, 20, times=True)
    return tuple((p.x, str(p.tau)) for p in table.points[1:])


def _agrees(exponent: str, epsilon: str) -> Outcome:
    """A^(-q) = 1 + q kappa tau within 5 % of A at five turning points, q = alpha - 1."""
    q = sympy.Rational(exponent) - 1
    with ctx.workprec(100):
        power, strength = closed_form_ball(q), closed_form_ball(mean(q + 1) * sympy.Rational(epsilon))
        quotients = [
            abs(arb(x)) * (1 + power * strength * arb(tau)) ** (1 / power) for x, tau in _first_five(exponent, epsilon)
        ]
        return all_confirmed(*(below(abs(quotient - 1), arb("0.05")) for quotient in quotients))


@statement(
    id="lancaster2020:claim.leading-order", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The results are correct to leading order in kappa, which is proportional to b", printed=1, near_miss=2,
    latex=r"\text{the asymptotic results are formally correct only to leading order in } \kappa \propto b",
    conditions="none", methods=("d ln kappa/d ln b", "expansion of the exact envelope"), derivation="symbolic-alpha",
    note="d ln A/d tau = -(p_1 delta + p_3 delta^3 + ...), d psi/d tau = 1 + Omega_2 delta^2 + ...: the rate has no"
    " second-order term, so (13) is better than that for the amplitude at the turning points. Form: the power of b.",
)
def leading_order(form: int) -> Outcome:
    """b d ln kappa/db."""
    return zero(b * sympy.diff(sympy.log(kappa(alpha)), b) - form)


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
    derivation="lancaster-energy",
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
