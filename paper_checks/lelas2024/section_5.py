"""Section V, equations (47)-(50), figure 1 and its numbers: sliding friction against the exact motion.

m = 1.5 kg, k = 30 N/m, x0 = 0.2 m, g = 9.81 m/s^2, mu = 0.01 (a) and 0.03 (b), so that eps = mu m g/(k x0) is 0.024525
and 0.073575.  With d = mu m g/k the exact turning points are +-(x0 - 2 n d); the block rests at the first in |x| <= d.

>>> [(half_swings(strength(mu)), float(rest(mu))) for mu in PANELS]         # half-swings, place of rest in units of x0
[(20, 0.019), (7, 0.03005)]
"""

from fractions import Fraction

import sympy
from flint import arb
from mpmath import mpf, pi

from asymptotics.numbers.bridge import closed_form_ball, to_sympy
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimal_context import workdps
from paper_checks.evidence import mark, read_off, sampled
from paper_checks.identities import all_confirmed, below, decided, rounds_to, same, vanishes
from paper_checks.lelas2024.model import (
    DIGITS,
    FRICTION,
    C,
    b,
    coulomb,
    f,
    g,
    half_swings,
    has_order,
    in_physical_units,
    k,
    m,
    mu,
    slow_error,
    t,
    v,
    w0,
    x0,
)
from paper_checks.lelas2024.section_2 import X1
from paper_checks.lelas2024.section_3 import FRICTION_LINE, GARBLED, STRENGTH, TAU
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

PANELS = (Fraction(1, 100), Fraction(3, 100))
OURS = x0 * FRICTION_LINE * sympy.cos(w0 * t)
AVERAGED_LINE = 1 - 2 * mu * g / (sympy.pi * w0 * x0) * t
AVERAGED = x0 * AVERAGED_LINE * sympy.cos(w0 * t)
TAU_TILDE = sympy.pi * w0 * x0 / (2 * mu * g)
number, side = sympy.symbols("n sigma")  # sigma = (-1)^n
offset = mu * m * g / k
eps = sympy.Symbol("eps", positive=True)
LAWS = {2: -b * v, 3: -sympy.sign(v) * mu * m * g, 5: -sympy.sign(v) * C * v**2}
COUNT = sympy.ceiling((1 / eps - 1) / 2)  # half-swings until the block sticks


def strength(friction: Fraction) -> Fraction:
    """eps = mu m g/(k x0) of the figure."""
    return friction * Fraction(3, 2) * Fraction(981, 100) / (30 * Fraction(1, 5))


def rest(friction: Fraction) -> Fraction:
    """The exact place of rest in units of x0."""
    n = half_swings(strength(friction))
    return (-1) ** n * (1 - 2 * n * strength(friction))


def with_numbers(form: sympy.Expr, friction: Fraction) -> arb:
    """A form with the numbers of section V inserted."""
    with ctx.workprec(120):
        return closed_form_ball(in_physical_units(form).subs({**FRICTION, mu: to_sympy(friction)}))


@statement(
    id="lelas2024:claim.force-of-47", kind=Kind.CLAIM, verdict=Printed.MISPRINT, evidence=Evidence.MEASURED,
    derivation="lelas-friction", line=8,
    extent="read off the text",
    title="The force to which (47) belongs", printed=2, corrected=3, near_miss=5,
    latex=r"\text{our approximate solution of equation (1), with damping force (2), is (47)}",
    corrected_latex=r"\text{our approximate solution of equation (1), with damping force (3), is (47)}",
    conditions="none", methods=("the letters of (47) are those of the force",),
    note="(2) is viscous damping, (3) sliding friction: a wrong cross-reference, whose link goes to (2) as well, so a"
    " slip of the paper. Form: the number of the equation of the force.",
)
def force_of_motion(law: int) -> Outcome:
    """The decay of (47) depends on mu and g, as the force must."""
    return decided(read_off({mu, g}) <= LAWS[law].free_symbols)


@statement(
    id="lelas2024:47", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="0",
    extent="sampled: 2 points",
    title="The approximate motion with friction", derivation="lelas-friction",
    latex=r"x(t) = x_0\left(1 - \frac{\mu g}{\sqrt{2}\omega_0x_0}t\right)\cos(\omega_0t)", printed=OURS,
    near_miss=x0 * (1 - STRENGTH / 2 * t) * sympy.cos(w0 * t), conditions="damping force (3), t <= tau",
    methods=("(32) inserted in (8)", "largest error over a swing near half amplitude, two values of mu"),
    note="At a fixed fraction of the motion the error does not fall with mu: at tau the exact amplitude is still"
    " 1 - 2 sqrt(2)/pi = 0.0997 of x_0. The sentence before (47) names the wrong force, see claim.force-of-47.",
)
def our_motion(form: sympy.Expr) -> Outcome:
    """(8) with (32); the order of the error is 0."""
    inserted = same(form, X1.subs(f, FRICTION_LINE))
    return all_confirmed(inserted, has_order(0, slow_error(form, mu, coulomb)))


@statement(
    id="lelas2024:48", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="1",
    extent="sampled: 2 points",
    title="The motion by averaging over a period", derivation="lelas-friction",
    latex=r"\tilde{x}(t) = x_0\left(1 - \frac{2\mu g}{\pi\omega_0x_0}t\right)\cos(\omega_0t)", printed=AVERAGED,
    near_miss=OURS, conditions="damping force (3), before the stop",
    methods=("mean of |sin|", "largest error over a swing near half amplitude, two values of mu"),
    note="Exact at all turning points; in between the error is eps x_0 |sin| at most, since the centre of the"
    " oscillation is off by d = eps x_0.",
)
def averaged_motion(form: sympy.Expr) -> Outcome:
    """f' = -(mu g/omega_0 x_0) <|sin|>; the order of the error of the motion is 1."""
    theta = sympy.Symbol("theta", real=True)
    mean = sympy.integrate(sympy.sin(theta), (theta, 0, sympy.pi)) / sympy.pi
    averaged = same(sympy.diff(form / sympy.cos(w0 * t), t), -STRENGTH * x0 * mean)
    return all_confirmed(averaged, has_order(1, slow_error(form, mu, coulomb)))


@statement(
    id="lelas2024:49", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    derivation="lelas-friction-exact",
    title="The exact motion with friction",
    latex=r"x_{ex}(t) = \left(x_0 - (2n-1)\frac{\mu mg}{k}\right)\cos(\omega_0t) - (-1)^n\frac{\mu mg}{k}",
    printed=(x0 - (2 * number - 1) * offset, -side * offset), near_miss=(x0 - (2 * number - 1) * offset, side * offset),
    conditions="(n-1) T_0/2 <= t <= n T_0/2 and n <= N, the last half-swing; see claim.range-of-49",
    methods=("equation of motion", "continuity of x and v at n T_0/2", "initial values"),
    note="Form: amplitude and centre of half-swing n, with sigma = (-1)^n.",
)
def exact_motion(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """amplitude cos + centre with sgn v = sigma = (-1)^n on half-swing n; v = 0 at its ends, whatever the amplitude."""
    amplitude, centre = form
    equation = vanishes(k * centre + side * mu * m * g)
    start = same((amplitude + centre).subs({number: 1, side: -1}), x0)
    before = amplitude * side + centre
    after = amplitude.subs(number, number + 1) * side + centre.subs(side, -side)
    return all_confirmed(equation, start, vanishes(before - after))


@statement(
    id="lelas2024:claim.range-of-49", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lelas-friction-exact", line=8,
    shortfall=Shortfall.RANGE,
    title="The range of n in (49)", latex=r"n \ge 1 \text{ is an integer}", printed=sympy.oo, corrected=COUNT,
    near_miss=sympy.floor((1 / eps - 1) / 2),
    corrected_latex=r"1 \le n \le N = \left\lceil\frac{1}{2}\left(\frac{kx_0}{\mu mg} - 1\right)\right\rceil",
    conditions="n <= N; afterwards the block rests at (-1)^N (x_0 - 2 N mu m g/k)",
    methods=("first turning point with |x| <= mu m g/k, for every strength",),
    note="The paper mentions the halt and leaves its discussion to others. Continued beyond N, (49) lets the spring"
    " start a block that friction holds. Form: the number of half-swings as a function of eps.",
)
def range_of_exact(form: sympy.Expr) -> Outcome:
    """The least n with x_n <= eps, where x_n = 1 - 2 n eps; and the count one by one on both sides of its jumps."""
    strengths = [Fraction(1, 3), Fraction(33, 100), Fraction(17, 50), Fraction(1, 7), *map(strength, PANELS)]
    if [form.subs(eps, to_sympy(value)) for value in strengths] != [half_swings(value) for value in strengths]:
        return Outcome.REFUTED
    (least,) = sympy.solve(1 - 2 * number * eps - eps, number)
    return same(form, sympy.ceiling(least))


tau = sympy.Symbol("tau", positive=True)
SWING = sympy.Min(sympy.floor(tau / sympy.pi) + 1, COUNT)
ONE_LINE = (1 - (2 * SWING - 1) * eps) * sympy.cos(sympy.Min(tau, COUNT * sympy.pi)) - (-1) ** SWING * eps


@statement(
    id="lelas2024:claim.no-closed-form", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.MEASURED,
    derivation="lelas-friction-exact", line=9,
    shortfall=Shortfall.CONDITION,
    extent="sampled: 54 points",
    title="The exact motion cannot be put into a closed form valid for all times", printed=None, corrected=ONE_LINE,
    latex=r"\text{the solution thus obtained cannot be put into a closed form that is valid for all times}",
    corrected_latex=r"\frac{x}{x_0} = (1 - (2n-1)\varepsilon)\cos\min(\omega_0t, N\pi) - (-1)^n\varepsilon, \quad"
    r" n = \min\left(\lfloor\omega_0t/\pi\rfloor + 1, N\right)",
    near_miss=ONE_LINE.subs(sympy.Min(tau, COUNT * sympy.pi), tau),
    conditions="true of analytic expressions: the acceleration jumps by 2 mu g at each turning point",
    methods=("the expression with floor against the motion swing by swing, before and after the stop",),
    note="With the floor function one line is enough for all t >= 0, the rest included. Form: an expression, None if"
    " there is none.",
)
def closed_form(form: sympy.Expr | None) -> Outcome:
    """The expression against the motion of six strengths, of 0 to 10 half-swings, at 8 times each up to two stop times.

    The strengths are those at which ``range_of_exact`` counts, on both sides of a jump of N.
    """
    if form is None:
        return {Outcome.CONFIRMED: Outcome.REFUTED}.get(closed_form(ONE_LINE), Outcome.UNDECIDED)
    mark(Evidence.MEASURED)
    errors = []
    with workdps(DIGITS):
        value = sympy.lambdify((eps, tau), form, "mpmath")
        for strength in sampled(("0.073575", "0.05", "0.13", "0.33", "0.34", "0.9")):
            exact, stop = coulomb(mpf(strength)), pi * max(1, half_swings(Fraction(strength)))
            times = sampled(stop * 2 * (2 * j + 1) / 17 for j in range(8))
            errors += [abs(value(mpf(strength), T) - exact(T)) for T in times]
    return decided(max(errors) < mpf(10) ** -15)


@statement(
    id="lelas2024:50", kind=Kind.NUMBER, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED, digits=2,
    title="The condition (33) in numbers", latex=r"\mu \ll 0.58", printed="0.58", near_miss="0.57",
    conditions="none", methods=("(33) by balls",), note="0.57664...",
)
def threshold(printed: str) -> Outcome:
    """sqrt(2) k x0/(m g)."""
    return rounds_to(printed, with_numbers(sympy.sqrt(2) * k * x0 / (m * g), PANELS[0]))


@statement(
    id="lelas2024:fig1", kind=Kind.FIGURE, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Friction: (47), (48) and the exact motion, (a) mu = 0.01, (b) mu = 0.03", printed=((20, 1), (7, 1)),
    latex=r"\text{Fig. 1. Solutions (47), (48) and (49) for (a) } \mu = 0.01 \text{ and (b) } \mu = 0.03",
    near_miss=((20, 1), (7, -1)), conditions="m = 1.5 kg, k = 30 N/m, x_0 = 0.2 m, g = 9.81 m/s^2",
    methods=("regenerated: half-swings until the block sticks and its side, exact",),
    note="Form: for each panel the number of half-swings and the sign of the place of rest. In (b) the last swing ends"
    " on the side where it began.",
)
def friction_figure(form: tuple[tuple[int, int], ...]) -> Outcome:
    """The exact count and the sign of the exact place of rest."""
    found = tuple((half_swings(strength(value)), 1 if rest(value) > 0 else -1) for value in PANELS)
    return decided(found == form)


@statement(
    id="lelas2024:claim.stop-time-section-5", premises=(1,),
    derivation="lelas-friction", line=10,
    kind=Kind.CLAIM, verdict=Printed.TRANSCRIPTION, evidence=Evidence.PROVED,
    title="The instant at which (47) stops", latex=r"\tau = \sqrt{2\omega_0x_0/(\mu g)}",
    corrected_latex=r"\tau = \sqrt{2}\,\omega_0x_0/(\mu g)",
    printed=(sympy.sqrt(2 * w0 * x0 / (mu * g)), FRICTION_LINE), corrected=(TAU, FRICTION_LINE),
    near_miss=(TAU / 2, FRICTION_LINE), conditions="none", methods=("zero of the amplitude of (47)",),
    note=GARBLED + " Here the text breaks the line between the root sign and 2 omega_0 x_0/(mu g).",
)
@statement(
    id="lelas2024:claim.stop-time-tilde", premises=(1,),
    kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The instant at which (48) stops", latex=r"\tilde{\tau} = \pi\omega_0x_0/(2\mu g)",
    printed=(TAU_TILDE, AVERAGED_LINE), near_miss=(TAU_TILDE / 2, AVERAGED_LINE),
    conditions="none", methods=("zero of the amplitude of (48)",),
    note="(48) stops at the equilibrium, like (47); the block stops at the turning point next to it.",
)
def stop_time(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The amplitude vanishes at the stated time."""
    instant, amplitude = form
    return vanishes(amplitude.subs(t, instant))


@statement(
    id="lelas2024:value.tau-a", premises=(1, 2),
    kind=Kind.NUMBER, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED, digits=3,
    title="tau for mu = 0.01", latex=r"\tau = 12.9\,\mathrm{s}", printed=("12.9", TAU, PANELS[0]),
    near_miss=("12.8", TAU, PANELS[0]), conditions="none", methods=("balls",), note="12.8941 s.",
)
@statement(
    id="lelas2024:value.tau-b", premises=(1, 2),
    kind=Kind.NUMBER, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED, digits=2,
    title="tau for mu = 0.03", latex=r"\tau = 4.3\,\mathrm{s}", printed=("4.3", TAU, PANELS[1]),
    near_miss=("4.4", TAU, PANELS[1]), conditions="none", methods=("balls",), note="4.2980 s.",
)
@statement(
    id="lelas2024:value.tau-tilde-a", premises=(1, 2),
    derivation="lelas-line-end", line=4,
    kind=Kind.NUMBER, verdict=Printed.MISPRINT, evidence=Evidence.CERTIFIED, digits=4,
    title="tau-tilde for mu = 0.01", latex=r"\tilde{\tau} = 14.33\,\mathrm{s}",
    corrected_latex=r"\tilde{\tau} = 14.32\,\mathrm{s}", printed=("14.33", TAU_TILDE, PANELS[0]),
    corrected=("14.32", TAU_TILDE, PANELS[0]), near_miss=("14.34", TAU_TILDE, PANELS[0]),
    conditions="none", methods=("balls",),
    note="14.3217 s with the numbers of the paper. The printed one is pi/(2 sqrt 2) times the rounded tau: 12.9 s times"
    " 1.11072 is 14.328 s.",
)
@statement(
    id="lelas2024:value.tau-tilde-b", premises=(1, 2),
    derivation="lelas-line-end", line=4,
    kind=Kind.NUMBER, verdict=Printed.MISPRINT, evidence=Evidence.CERTIFIED, digits=3,
    title="tau-tilde for mu = 0.03", latex=r"\tilde{\tau} = 4.78\,\mathrm{s}",
    corrected_latex=r"\tilde{\tau} = 4.77\,\mathrm{s}", printed=("4.78", TAU_TILDE, PANELS[1]),
    corrected=("4.77", TAU_TILDE, PANELS[1]), near_miss=("4.76", TAU_TILDE, PANELS[1]),
    conditions="none", methods=("balls",),
    note="4.7739 s. The printed one is pi/(2 sqrt 2) times the rounded tau: 4.3 s times 1.11072 is 4.776 s.",
)
@statement(
    id="lelas2024:value.tau-exact-a", premises=(1, 2),
    kind=Kind.NUMBER, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED, digits=4,
    title="The exact stop time for mu = 0.01", latex=r"\tau_{ex} = 14.05\,\mathrm{s}",
    printed=("14.05", 20 * sympy.pi / w0, PANELS[0]), near_miss=("14.06", 20 * sympy.pi / w0, PANELS[0]),
    conditions="none", methods=("20 half periods, see fig1", "balls"), note="14.0496 s.",
)
@statement(
    id="lelas2024:value.tau-exact-b", premises=(1, 2),
    derivation="lelas-line-end", line=6,
    kind=Kind.NUMBER, verdict=Printed.MISPRINT, evidence=Evidence.CERTIFIED, digits=3,
    title="The exact stop time for mu = 0.03", latex=r"\tau_{ex} = 4.93\,\mathrm{s}",
    corrected_latex=r"\tau_{ex} = 4.92\,\mathrm{s}", printed=("4.93", 7 * sympy.pi / w0, PANELS[1]),
    corrected=("4.92", 7 * sympy.pi / w0, PANELS[1]), near_miss=("4.91", 7 * sympy.pi / w0, PANELS[1]),
    conditions="none", methods=("7 half periods, see fig1", "balls"),
    note="The stop is at a turning point, 7 T_0/2 = 4.9174 s. The paper reads 4.93 s directly from its graph.",
)
def stop_number(form: tuple[str, sympy.Expr, Fraction]) -> Outcome:
    """The printed decimal is the formula at the panel's mu, correctly rounded."""
    printed, formula, friction = form
    return rounds_to(printed, with_numbers(formula, friction))


@statement(
    id="lelas2024:value.rest-a", premises=(1,),
    kind=Kind.NUMBER, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED, digits=1,
    title="The exact place of rest for mu = 0.01", latex=r"+0.02x_0", printed=("0.02", PANELS[0]),
    near_miss=("-0.02", PANELS[0]), conditions="none", methods=("1 - 40 eps, balls",), note="0.019 exactly.",
)
@statement(
    id="lelas2024:value.rest-b", premises=(1,),
    kind=Kind.NUMBER, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED, digits=1,
    title="The exact place of rest for mu = 0.03", latex=r"+0.03x_0", printed=("0.03", PANELS[1]),
    near_miss=("-0.03", PANELS[1]), conditions="none", methods=("-(1 - 14 eps), balls",),
    note="0.03005 exactly: the seventh half-swing, towards the left, starts at +0.117 x_0 and ends before it"
    " reaches the equilibrium.",
)
def place_of_rest(form: tuple[str, Fraction]) -> Outcome:
    """The printed decimal is the exact place, correctly rounded, sign included."""
    printed, friction = form
    place = rest(friction)
    return rounds_to(printed, arb(place.numerator) / place.denominator)


@statement(
    id="lelas2024:claim.better-approximation", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="(48) is a better approximation than (47), the more so towards the halt",
    latex=r"\text{(48) is a better approximation of the exact solution than our solution (47)}",
    printed=2 / sympy.pi, near_miss=1 / sympy.sqrt(2), derivation="lelas-friction",
    methods=("amplitudes at the exact turning points", "error of (47) grows with n"),
    conditions="in the amplitude and in the largest error; at single instants (47) can be nearer",
    note="At the turning points (48) is exact while (47) is off by 2 n eps (pi/(2 sqrt 2) - 1). Largest errors of the"
    " motions in Fig. 1 until tau, in x_0: 0.0997 and 0.1141 for (47), 0.025 and 0.074 for (48). Form: the rate in"
    " units of mu g/(omega_0 x_0).",
)
def better_approximation(factor: sympy.Expr) -> Outcome:
    """1 - factor eps n pi is the exact amplitude 1 - 2 n eps for every n; the other rate's error grows with n."""
    n = sympy.Symbol("n", positive=True)
    other = 2 * n * eps - sympy.pi * n * eps / sympy.sqrt(2)
    growing = decided(sympy.simplify(-sympy.diff(other, n)).is_positive)
    return all_confirmed(growing, same(factor * eps * n * sympy.pi, 2 * n * eps))


@statement(
    id="lelas2024:claim.describes-well", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.MEASURED, order="0",
    derivation="lelas-line-end", line=2,
    shortfall=Shortfall.CONSEQUENCE,
    extent="sampled: 2 points",
    title="(47) describes the dynamics very well if (50) is valid", printed=1, corrected=0, near_miss=2,
    latex=r"\text{our solution also describes very well the dynamics of the systems if condition (50) is valid}",
    corrected_latex=r"\lim_{\mu \to 0}\max_{t \le \tau}\frac{|x - x_{ex}|}{x_0} = 1 - \frac{2\sqrt{2}}{\pi} = 0.0997",
    conditions="within a tenth of x_0 and of the duration, however small mu is",
    methods=("largest error near half amplitude, two values of mu",),
    note="The linear decay is right, its rate is 11 % too fast, and a smaller mu does not help, as the condition"
    " suggests. Form: the order of the error in mu.",
)
def describes_well(order: int) -> Outcome:
    """The measured order of the error of (47) at fixed slow time."""
    return has_order(order, slow_error(OURS, mu, coulomb))


@statement(
    id="lelas2024:claim.duration-estimate", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED,
    title="(47) gives a solid estimate of the duration", printed=Fraction(13, 100), near_miss=Fraction(12, 100),
    latex=r"\text{our solution ... provides a solid estimate of the duration of the motion}",
    conditions="mu = 0.01 and 0.03", methods=("tau against the exact stop time, balls",),
    note="Short by 8.2 % and 12.6 %; for small mu tau/tau_ex tends to 2 sqrt(2)/pi = 0.900. Form: a bound for the"
    " relative error.",
)
def duration_estimate(bound: Fraction) -> Outcome:
    """|tau/tau_ex - 1| < bound in both panels, and the bound is no larger than it must be."""
    errors = []
    for friction in PANELS:
        exact = half_swings(strength(friction)) * sympy.pi / w0
        errors.append(abs(with_numbers(TAU / exact, friction) - 1))
    largest = max(errors, key=lambda error: float(error.mid()))
    unit = arb(1) / 100  # the bound is the largest error, rounded up to a percent
    limit = arb(bound.numerator) / bound.denominator
    return all_confirmed(*(below(error, limit) for error in errors), below(limit - unit, largest))
