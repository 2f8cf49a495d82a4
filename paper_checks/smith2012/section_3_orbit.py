"""Section III, equations (41)-(51): the orbit, its turning points and the constant that joins two half-cycles.

Turning points are signed, u_0 > 0 > u_1, u_2 > 0 > u_3 and so on, as in Table I.
"""

import sympy
from flint import arb

from asymptotics.numbers.context import ctx
from paper_checks.identities import all_confirmed, balls_agree, below, decided, same, vanishes
from paper_checks.registry import Shortfall, statement
from paper_checks.smith2012.model import (
    HALF,
    QUARTER,
    S_falling,
    S_rising,
    gamma,
    invariant,
    omega,
    orbit,
    physical,
    rate,
    u,
    u0,
    u1,
    u2,
    v,
    vanishes_on_orbit,
    w,
    x,
)
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

exp, sqrt, log = sympy.exp, sympy.sqrt, sympy.log
START = S_falling(u0, 0)  # the value of the constant on the orbit from (u_0, 0)
S1, S_plus, acceleration = sympy.symbols("S_1 S_plus a")
FACTOR_NOTE = (
    "S at a turning point is -(1/4) e^{-2u}(2u+1) by (42) and (1/4) e^{2u}(2u-1) by (48) corrected; the factor is "
    "missing alike in (51), (52a) and (52b), so a slip of the paper."
)


@statement(
    id="smith2012:41", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The range of the first constant", latex=r"0 > \hat{S}^{-} \ge -\frac{1}{4}",
    printed=sympy.Interval.Ropen(-QUARTER, 0), near_miss=sympy.Interval.Ropen(-HALF, 0),
    conditions="motion that has a turning point u_0 >= 0; the lower end belongs to rest, u_0 = 0",
    methods=("monotone with the two limits",), derivation="smith-turning-points",
    note="For u_0 > 0, as the paper assumes, -1/4 is not attained. States with w^2 >= u + 1/2, v < 0, have S^- >= 0:"
    " they come from no turning point.",
)
@statement(
    id="smith2012:claim.S-negative", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="S^- is negative for all positive u_0 and tends to 0 from below",
    latex=r"\hat{S}^- < 0 \text{ for all } u_0 > 0, \quad \hat{S}^- \to 0^- \text{ as } u_0 \to \infty",
    printed=sympy.Interval.Ropen(-QUARTER, 0), near_miss=sympy.Interval(-QUARTER, QUARTER),
    conditions="u_0 > 0", methods=("monotone with the two limits",), derivation="smith-turning-points",
)
def range_of_constant(form: sympy.Interval) -> Outcome:
    """S(u_0) increases on u_0 > 0, since S' = u_0 e^(-2u_0), from S(0) to its limit, which it never reaches."""
    increasing = same(sympy.diff(START, u0), u0 * exp(-2 * u0))
    image = sympy.Interval.Ropen(START.subs(u0, 0), sympy.limit(START, u0, sympy.oo))
    return all_confirmed(increasing, decided(form == image))


@statement(
    id="smith2012:42", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The constant from the maximum displacement", conditions="w = 0 at u = u_0 > 0",
    latex=r"\hat{S}^{-} = -e^{-2u_0}\left(\frac{u_0}{2} + \frac{1}{4}\right)",
    printed=-exp(-2 * u0) * (u0 / 2 + QUARTER), near_miss=-exp(-2 * u0) * (u0 / 2 - QUARTER),
    methods=("w = 0 in (40)",), derivation="smith-turning-points",
)
def constant_at_start(form: sympy.Expr) -> Outcome:
    """(40) at (u_0, 0)."""
    return same(form, START)


@statement(
    id="smith2012:43", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The equation of the first turning point", latex=r"e^{-2u_0}(2u_0+1) = e^{-2u_1}(2u_1+1)",
    printed=(exp(-2 * u0) * (2 * u0 + 1), exp(-2 * u1) * (2 * u1 + 1)),
    near_miss=(exp(-2 * u0) * (2 * u0 + 1), exp(-2 * u1) * (2 * u1 - 1)),
    conditions="u_1 < 0 is the other root", methods=("-4 times (42) at both ends",), derivation="smith-turning-points",
    note="No iteration is needed: 2|u_1| = 1 + W_0(-y e^{-y}), y = 1 + 2u_0.",
)
def turning_point_equation(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """Left minus right is -4 (S(u_0, 0) - S(u_1, 0))."""
    return same(form[0] - form[1], -4 * (START - S_falling(u1, 0)))


g0, p_root, r_root = sympy.symbols("g_0 p r", positive=True)


@statement(
    id="smith2012:claim.iterations", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="smith-turning-points", line=22,
    shortfall=Shortfall.CONDITION, title="The turning point is found by iteratively solving (43), and later (51)",
    latex=r"\text{The turning point at the end of this half-cycle is found by iteratively solving (43)}",
    corrected_latex=r"u \mapsto \frac{e^{-2u_0}(2u_0+1)e^{2u} - 1}{2} \text{ converges; } u \mapsto u_0 -"
    r" \frac{1}{2}\ln\frac{2u_0+1}{2u+1} \text{ does not}",
    printed=-sympy.log((2 * u1 + 1) / g0) / -2, corrected=(g0 * exp(2 * u1) - 1) / 2,
    near_miss=(g0 * exp(2 * u1) + 1) / 2, conditions="an iteration whose slope at the root is below 1 in size",
    methods=("slope of the iteration at the root", "(43) at the fixed point"),
    note="The paper does not say which iteration. Of the two ways to solve (43) for u the one with the logarithm has"
    " the slope 1/(1 + 2u_1) > 1 at the root and runs away from it; the other has 1 + 2u_1, between 0 and 1,"
    " falls from"
    " u = 0 to the root, and converges for every u_0. (51) is (43) for the mirror image. Form: the iteration, g_0 ="
    " e^{-2u_0}(2u_0+1).",
)
def iterations(form: sympy.Expr) -> Outcome:
    """The root u_1 = -1/(2(1+r)) with r > 0 (it lies between -1/2 and 0) is a fixed point, of slope below 1 in size."""
    root = {u1: -1 / (2 * (1 + r_root))}
    of_root = {g0: (exp(-2 * u1) * (2 * u1 + 1)).subs(root)}
    fixed = vanishes(sympy.simplify((form - u1).subs(root).subs(of_root)))
    slope = sympy.simplify(sympy.diff(form, u1).subs(root).subs(of_root))
    return all_confirmed(fixed, decided(sympy.factor(1 - slope**2).is_positive))


@statement(
    id="smith2012:44", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="A turning point at the origin would need this", latex=r"e^{-2u_0}(2u_0+1) = 1",
    printed=sympy.Integer(1), near_miss=HALF, conditions="(43) with u_1 = 0; it has no solution u_0 > 0",
    methods=("(43) at u_1 = 0", "strict monotonicity"), derivation="smith-turning-points",
)
@statement(
    id="smith2012:claim.never-overdamped", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="The quadratically damped oscillator is never critically damped or overdamped",
    latex=r"e^{-2u_0}(2u_0+1) = 1 \text{ has no solution for } u_0 > 0",
    printed=sympy.Integer(1), near_miss=HALF, conditions="u_0 > 0",
    methods=("strict monotonicity", "velocity at u = 0"), derivation="smith-turning-points",
    note="The near miss, right side 1/2, does have a solution. The velocity (45) at u = 0 is not zero, so the origin is"
    " passed in finite time from every u_0 > 0.",
)
def no_turning_point_at_origin(right: sympy.Expr) -> Outcome:
    """g(u_0) = e^(-2u_0)(2u_0+1) falls strictly from g(0) = 1, since g' = -4 u_0 e^(-2u_0): g < 1 for u_0 > 0."""
    g = -4 * START
    consequence = same(right, -4 * S_falling(0, 0))
    decreasing = same(sympy.diff(g, u0), -4 * u0 * exp(-2 * u0))
    return all_confirmed(consequence, decreasing, decided(right >= g.subs(u0, 0)))


@statement(
    id="smith2012:45", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The velocity at the first passage through equilibrium",
    latex=r"w = -\sqrt{\frac{1 - e^{-2u_0}(2u_0+1)}{2}}", conditions="u_0 > 0",
    printed=-sqrt((1 - exp(-2 * u0) * (2 * u0 + 1)) / 2), near_miss=-sqrt(1 - exp(-2 * u0) * (2 * u0 + 1)),
    methods=("(40) at u = 0",), derivation="smith-turning-points",
)
def velocity_at_equilibrium(form: sympy.Expr) -> Outcome:
    """S(0, w) = S(u_0, 0), and the sign is that of the falling half-swing."""
    return all_confirmed(vanishes(S_falling(0, form) - START), decided(form.could_extract_minus_sign()))


SCALED = 2 * gamma * exp(2 * gamma * x) * omega**2 / gamma**2 * physical(S_falling(u, w))


@statement(
    id="smith2012:46a", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The first constant, solved for the acceleration",
    latex=r"2\gamma S^{-}e^{2\gamma x} = \gamma v^2 - \omega^2 x - \frac{\omega^2}{2\gamma}", conditions="v < 0",
    printed=gamma * v**2 - omega**2 * x - omega**2 / (2 * gamma),
    near_miss=gamma * v**2 - omega**2 * x - omega**2 / (4 * gamma),
    methods=("(38b), corrected",), derivation="smith-turning-points",
    note="With (38b) as printed the left side would need e^{-2 gamma x}: one more witness against its exponent.",
)
@statement(
    id="smith2012:46b", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The same with the acceleration in it", latex=r"= \ddot{x} - \frac{\omega^2}{2\gamma}", conditions="v < 0",
    printed=acceleration - omega**2 / (2 * gamma), near_miss=acceleration + omega**2 / (2 * gamma),
    methods=("(35)",), derivation="smith-turning-points",
)
def constant_and_acceleration(form: sympy.Expr) -> Outcome:
    """2 gamma S^- e^(2 gamma x) is the form, with x'' from (35)."""
    return same(form.subs(acceleration, gamma * v**2 - omega**2 * x), SCALED)


@statement(
    id="smith2012:46c", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The point of maximum velocity", latex=r"u_f = u_0 - \frac{\ln(2u_0+1)}{2}", conditions="u_0 > 0",
    printed=u0 - log(2 * u0 + 1) / 2, near_miss=u0 - log(2 * u0 + 1), methods=("w^2 = u in (40)",),
    derivation="smith-turning-points",
)
@statement(
    id="smith2012:claim.maximum-velocity", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="The maximum of the speed is where the acceleration is zero",
    conditions="u_0 > 0, first half-swing", latex=r"\ddot{x}(x_f) = 0 \text{ is the point of maximum velocity}",
    printed=u0 - log(2 * u0 + 1) / 2, near_miss=u0 - log(2 * u0 + 1),
    methods=("the acceleration is monotone in u",), derivation="smith-turning-points",
    slip="The speed is meant: the velocity itself has a minimum there.",
)
def point_of_zero_acceleration(form: sympy.Expr) -> Outcome:
    """S(u_f, sqrt u_f) = S(u_0, 0); w^2 - u = 1/2 + 2 S e^(2u) decreases in u since S < 0, so it is the only one."""
    monotone = same(w**2 - u, HALF + 2 * S_falling(u, w) * exp(2 * u))
    return all_confirmed(monotone, vanishes(-exp(-2 * form) / 4 - START))


@statement(
    id="smith2012:47", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The matching condition, which defines S_1",
    latex=r"\hat{S}^{-} = -e^{-2u_0}\left(\frac{u_0}{2} + \frac{1}{4}\right) = \hat{S}^{+} + \hat{S}_1",
    printed=(-exp(-2 * u0) * (u0 / 2 + QUARTER), S_plus + S1),
    near_miss=(-exp(-2 * u0) * (u0 / 2 - QUARTER), S_plus + S1), conditions="at (u_1, 0)",
    methods=("elimination by (43)", "balls on the orbits from u_0 = 1 and 3/5"),
)
def matching_condition(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """With S_1 the jump S^- - S^+ at (u_1, 0), the two members agree because of (43)."""
    jump = S_falling(u1, 0) - S_rising(u1, 0)
    return vanishes_on_orbit(form[0] - form[1].subs({S_plus: S_rising(u1, 0), S1: jump}))


@statement(
    id="smith2012:claim.discontinuity", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED,
    title="With S^- = S^+ the function S is not continuous across the u axis",
    latex=r"\text{if } \hat{S}^- = \hat{S}^+ \text{, } \hat{S} \text{ will not be continuous across the } u"
    r" \text{ axis}", printed=0, near_miss=1, conditions="u_0 > 0", methods=("balls on the orbit u_0 = 1",),
    note="Form: the multiple of S_1 added to S^+; the near miss takes the patch (47), which makes S continuous.",
)
def discontinuity(patched: int) -> Outcome:
    """The jump of S at (u_1, 0), minus S_1 if patched, is certainly not zero."""
    with ctx.workprec(200):
        first = orbit(2)[1]
        jump = invariant(0, first) - invariant(1, first)
        return below(arb(0), abs((1 - patched) * jump))


@statement(
    id="smith2012:48", kind=Kind.IDENTITY, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    derivation="smith-matching", line=5,
    title="The value of S^+ after the first turning point",
    latex=r"\hat{S}^{+} = -e^{2u_1}\left(\frac{u_1}{2} - \frac{1}{4}\right)",
    corrected_latex=r"\hat{S}^{+} = e^{2u_1}\left(\frac{u_1}{2} - \frac{1}{4}\right)",
    printed=-exp(2 * u1) * (u1 / 2 - QUARTER), corrected=exp(2 * u1) * (u1 / 2 - QUARTER),
    near_miss=exp(2 * u1) * (u1 / 2 + QUARTER), conditions="none", methods=("w = 0 in (40)",),
    note="The sign contradicts (50) at w = 0 and (49), whose first term is -S^+ and prints -e^{2u_1}(u_1/2 - 1/4). With"
    " |u_1| for u_1 it would not hold either. The text cannot tell whether print or transcription slipped.",
)
def constant_after_turning(form: sympy.Expr) -> Outcome:
    """S^+ at (u_1, 0)."""
    return same(form, S_rising(u1, 0))


@statement(
    id="smith2012:49", kind=Kind.IDENTITY, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    derivation="smith-matching", line=6,
    title="The first integration constant",
    latex=r"\hat{S}_1 = -e^{2u_1}\left(\frac{u_1}{2} - \frac{1}{4}\right) - e^{-2u_0}\left(\frac{u_0}{2}"
    r" - \frac{1}{4}\right)",
    corrected_latex=r"\hat{S}_1 = -e^{2u_1}\left(\frac{u_1}{2} - \frac{1}{4}\right) - e^{-2u_0}\left(\frac{u_0}{2} +"
    r" \frac{1}{4}\right)",
    printed=-exp(2 * u1) * (u1 / 2 - QUARTER) - exp(-2 * u0) * (u0 / 2 - QUARTER),
    corrected=-exp(2 * u1) * (u1 / 2 - QUARTER) - exp(-2 * u0) * (u0 / 2 + QUARTER),
    near_miss=exp(2 * u1) * (u1 / 2 - QUARTER) - exp(-2 * u0) * (u0 / 2 + QUARTER),
    conditions="none", methods=("(47) solved for S_1",),
    note="The second term is (42), which has + 1/4; Table I (0.098765 at u_0 = 1) was computed with the right sign.",
)
def first_integration_constant(form: sympy.Expr) -> Outcome:
    """S_1 = S^-(u_0, 0) - S^+(u_1, 0)."""
    return same(form, START - S_rising(u1, 0))


def first_cycle(sign: int) -> tuple[sympy.Expr, sympy.Expr, sympy.Expr]:
    """The three members of (50); sign = -1 flips the sign of u in the rising half."""
    return (
        -exp(-2 * u0) * (u0 / 2 + QUARTER),
        exp(-2 * u) * (w**2 / 2 - u / 2 - QUARTER),
        exp(2 * u) * (w**2 / 2 + sign * u / 2 - QUARTER) + S1,
    )


@statement(
    id="smith2012:50", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The constant over the first full cycle",
    latex=r"\hat{S} = -e^{-2u_0}\left(\frac{u_0}{2} + \frac{1}{4}\right) = \begin{cases} e^{-2u}\left(\frac{w^2}{2} -"
    r" \frac{u}{2} - \frac{1}{4}\right), & 0 \le \theta < \pi, \\ e^{2u}\left(\frac{w^2}{2} + \frac{u}{2} -"
    r" \frac{1}{4}\right) + \hat{S}_1, & \pi \le \theta < 2\pi \end{cases}",
    printed=first_cycle(1), near_miss=first_cycle(-1),
    conditions="theta clockwise from the positive u axis, so that 0 < theta < pi is w < 0; S_1 from (47)",
    methods=("constant along the motion", "continuous at (u_1, 0)"),
)
def constant_over_cycle(form: tuple[sympy.Expr, sympy.Expr, sympy.Expr]) -> Outcome:
    """Each line is constant along its half-swing, and they have the same value at the two turning points."""
    value, falling, rising = form
    jump = START - S_rising(u1, 0)
    return all_confirmed(
        vanishes(rate(falling, falling=True)),
        vanishes(rate(rising, falling=False)),
        same(falling.subs({u: u0, w: 0}), value),
        same(rising.subs({u: u1, w: 0, S1: jump}), value),
    )


@statement(
    id="smith2012:51", kind=Kind.IDENTITY, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    derivation="smith-matching", line=8,
    title="The equation of the second turning point", latex=r"\hat{S} - \hat{S}_1 = e^{2u_2}[2u_2 - 1]",
    corrected_latex=r"\hat{S} - \hat{S}_1 = \frac{1}{4}e^{2u_2}[2u_2 - 1]", printed=exp(2 * u2) * (2 * u2 - 1),
    corrected=exp(2 * u2) * (2 * u2 - 1) / 4, near_miss=exp(2 * u2) * (2 * u2 + 1) / 4,
    conditions="none", methods=("w = 0 in (50)",), note=FACTOR_NOTE,
)
def second_turning_point(form: sympy.Expr) -> Outcome:
    """S - S_1 is S^+, taken at (u_2, 0)."""
    return same(form, S_rising(u2, 0))


@statement(
    id="smith2012:claim.second-cycle", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.CERTIFIED,
    derivation="smith-matching", line=7,
    shortfall=Shortfall.CONDITION,
    paraphrase=True, title="u_2 fed back into (42) determines S for the second cycle",
    latex=r"\hat{S} = -e^{-2u_2}\left(\frac{u_2}{2} + \frac{1}{4}\right) \text{ for the second cycle}",
    corrected_latex=r"\hat{S} - \hat{S}_2 = -e^{-2u_2}\left(\frac{u_2}{2} + \frac{1}{4}\right)",
    printed=0, corrected=2, near_miss=1, conditions="the left side is S - S_2, as in (52a) and (52c)",
    methods=("balls on the orbit u_0 = 1",),
    note="S itself keeps its value for ever, by (52c) and the caption of Table I; what changes is S - S_n. Form: the n"
    " of the constant S_n that is subtracted on the left.",
)
def second_cycle(subtracted: int) -> Outcome:
    """(42) at u_2 is S - S_2; the constants S_n are accumulated from the jumps at the turning points."""
    with ctx.workprec(200):
        points = orbit(3)
        constants = [0 * points[0]]
        for index in (1, 2):
            jump = invariant(index - 1, points[index]) - invariant(index, points[index])
            constants.append(constants[-1] + jump)
        return balls_agree(invariant(0, points[0]) - constants[subtracted], invariant(2, points[2]), 40)
