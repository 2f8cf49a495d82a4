"""Section VI, equations (51)-(53) and figure 2: air resistance against averaging and against the exact motion.

C = 0.2 (a) and 2 (b) N s^2/m^2 with m = 1.5 kg, k = 30 N/m, x0 = 0.2 m, so that eps = C x0/m is 0.0267 and 0.267.  The
exact motion is Smith's: turning points by Lambert's W, times by a certified quadrature.
"""

from fractions import Fraction
from itertools import islice

import sympy
from flint import arb

from asymptotics.numbers.bridge import closed_form_ball
from asymptotics.numbers.context import ctx
from asymptotics.turning.quadratic_duration import duration
from asymptotics.turning.quadratic_map import amplitudes
from paper_checks.evidence import read_off
from paper_checks.identities import all_confirmed, below, decided, opposite, rounds_to, same, vanishes
from paper_checks.lelas2024.model import FRICTION, C, air_error, f, has_order, m, t, v, w0, x, x0
from paper_checks.lelas2024.section_2 import X1
from paper_checks.lelas2024.section_4 import HYPERBOLA, STRENGTH
from paper_checks.lelas2024.section_5 import PANELS, strength
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

PHASES = (Fraction(0), Fraction(1, 3), Fraction(1, 2))
AVERAGE = sympy.Rational(4, 3) / sympy.pi  # <|sin|^3>
OURS = x0 * HYPERBOLA * sympy.cos(w0 * t)
AVERAGED = x0 / (1 + AVERAGE * STRENGTH * t) * sympy.cos(w0 * t)
DRAG = {"2a": Fraction(1, 5), "2b": Fraction(2)}
RATES = {"51": sympy.sqrt(2) / 4, "52": AVERAGE}  # df/dt = -rate (C omega_0 x0/m) f^2
phase = sympy.Symbol("phase", real=True)


def air_strength(drag: Fraction) -> Fraction:
    """eps = C x0/m of the figure."""
    return drag * Fraction(1, 5) / Fraction(3, 2)


@statement(
    id="lelas2024:51", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="0",
    extent="sampled: 2 points",
    title="The approximate motion with air resistance", derivation="lelas-air",
    latex=r"x(t) = x_0\left(1 + \frac{C\omega_0x_0}{2^{\frac{3}{2}}m}t\right)^{-1}\cos(\omega_0t)", printed=OURS,
    near_miss=x0 / (1 + STRENGTH / 2 * t) * sympy.cos(w0 * t), conditions="damping force (5)",
    methods=("(45) inserted in (8)", "largest error on the half-swing at eps omega_0 t = 1, two values of C"),
    note="The error does not vanish with C: the decay is too slow by the factor 0.833 for every C.",
)
def our_motion(form: sympy.Expr) -> Outcome:
    """(8) with (45); the order of the error is 0."""
    return all_confirmed(same(form, X1.subs(f, HYPERBOLA)), has_order(0, air_error(form, PHASES)))


@statement(
    id="lelas2024:52", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="1",
    extent="sampled: 2 points",
    title="The motion by averaging over a period", derivation="lelas-air", printed=AVERAGED, near_miss=OURS,
    latex=r"\tilde{x}(t) = x_0\left(1 + \frac{4C\omega_0x_0}{3\pi m}t\right)^{-1}\cos(\omega_0t)",
    conditions="none",
    methods=("mean of |sin|^3", "largest error on the half-swing at eps omega_0 t = 1, two values of C"),
    note="At the turning points alone the order is 2.",
)
def averaged_motion(form: sympy.Expr) -> Outcome:
    """f' = -(C omega_0 x0/m) <|sin|^3> f^2, f(0) = 1; the order of the error of the motion is 1."""
    amplitude = form / (x0 * sympy.cos(w0 * t))
    mean = sympy.integrate(sympy.sin(phase) ** 3, (phase, 0, sympy.pi)) / sympy.pi
    solves = vanishes(sympy.simplify(sympy.diff(amplitude, t) + STRENGTH * mean * amplitude**2))
    start = same(amplitude.subs(t, 0), sympy.Integer(1))
    return all_confirmed(solves, start, has_order(1, air_error(form, PHASES)))


FIRST_INTEGRAL = sympy.exp(-2 * C * x / m) * (v**2 / 2 - w0**2 * m * x / (2 * C) - (w0 * m) ** 2 / (2 * C) ** 2)


@statement(
    id="lelas2024:claim.not-analytically-solvable", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="smith-integrating-factor", line=9,
    shortfall=Shortfall.CONDITION,
    title="With air resistance (1) cannot be solved analytically", printed=None, corrected=FIRST_INTEGRAL,
    latex=r"\text{Equation of motion (1) with damping force (5) ... cannot be solved analytically}",
    corrected_latex=r"e^{-2Cx/m}\left(\frac{v^2}{2} - \frac{\omega_0^2m}{2C}x - \frac{\omega_0^2m^2}{4C^2}\right) ="
    r" \mathrm{const.}",
    near_miss=FIRST_INTEGRAL.subs(C, -C),
    conditions="true of an elementary x(t) (smith2012:claim.not-elementary); shown for v < 0, the other half-swing by"
    " x -> -x",
    methods=("derivative along the motion",),
    note="The paper cites Smith 2012, who solves it half-swing by half-swing: an elementary v(x), turning points in"
    " closed form by Lambert's W, and t(x) by one quadrature. Form: a first integral, None if there is none.",
)
def not_analytically_solvable(form: sympy.Expr | None) -> Outcome:
    """d/dt of the first integral with v' = C v^2/m - omega_0^2 x; it depends on v, so that it is no mere number."""
    if form is None:
        flipped = {Outcome.CONFIRMED: Outcome.REFUTED}
        return flipped.get(not_analytically_solvable(FIRST_INTEGRAL), Outcome.UNDECIDED)
    force = C * v**2 / m - w0**2 * x
    if not form.has(x) or not form.has(v):
        return Outcome.REFUTED  # a number is constant along any motion
    flow = sympy.diff(form, x) * v + sympy.diff(form, v) * force
    return all_confirmed(vanishes(sympy.expand(flow)), opposite(vanishes(sympy.diff(form, v))))


@statement(
    id="lelas2024:53", kind=Kind.NUMBER, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED, digits=4,
    title="The condition (46) in numbers", latex=r"C \ll 21.21\,\frac{Ns^2}{m^2}", printed="21.21", near_miss="21.22",
    conditions="none",
    methods=("(46) by balls",), note="15 sqrt(2) = 21.2132. Of the values said to be used, k and g do not occur.",
)
def threshold(printed: str) -> Outcome:
    """2^(3/2) m/x0."""
    with ctx.workprec(100):
        return rounds_to(printed, closed_form_ball((2 * sympy.sqrt(2) * m / x0).subs(FRICTION)))


CAPTIONS = {1: {"mu"}, 2: {"C"}}  # the parameter that distinguishes the panels


@statement(
    id="lelas2024:claim.figure-of-section-6", kind=Kind.CLAIM, verdict=Printed.MISPRINT, evidence=Evidence.MEASURED,
    extent="read off the text",
    title="The figure whose two panels section VI describes", printed=(1, "C"), corrected=(2, "C"), near_miss=(2, "mu"),
    latex=r"\text{In both Fig. 1(a) and (b), we use the same values of } m, k, x_0 \text{ and } g",
    corrected_latex=r"\text{In both Fig. 2(a) and (b), we use the same values of } m, k, x_0 \text{ and } g",
    conditions="none", methods=("the panels differ in C, by the captions",),
    note="The sentence before speaks of Fig. 2, the one after of C in Fig. 2(a) and (b); the link leads to Fig. 1, so a"
    " slip of the paper, taken over from section V. Form: the number of the figure, and what distinguishes its"
    " panels.",
)
def figure_of_section(form: tuple[int, str]) -> Outcome:
    """Section VI varies C between the panels."""
    figure, parameter = form
    return decided(read_off(CAPTIONS).get(figure) == {parameter} == {"C"})


@statement(
    id="lelas2024:fig2", kind=Kind.FIGURE, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED,
    title="Air resistance: (51) and (52), (a) C = 0.2, (b) C = 2 N s^2/m^2", printed=("51", "52"),
    latex=r"\text{Fig. 2. Solutions (51), (52) for (a) } C = 0.2\,Ns^2/m^2 \text{ and (b) } C = 2\,Ns^2/m^2",
    near_miss=("52", "51"), conditions="m = 1.5 kg, k = 30 N/m, x_0 = 0.2 m",
    methods=("regenerated: amplitudes at the first twelve exact turning points, balls",),
    note="The exact motion, drawn beside them here, follows (52) at the turning points: within 2 10^-6 x_0 in (a) and"
    " 2 10^-4 x_0 in (b). Form: the curves with the larger and the smaller amplitude; the exact turning points lie"
    " nearer to the latter.",
)
def air_figure(form: tuple[str, str]) -> Outcome:
    """At the exact turning points (not the first) the first curve is above the second, which is the nearer one."""
    if form[0] == form[1]:
        return Outcome.REFUTED  # no curve is above itself
    upper, lower = (RATES[name] for name in form)
    with ctx.workprec(100):
        return all_confirmed(*(_ordered(upper, lower, air_strength(drag)) for drag in DRAG.values()))


def _ordered(upper: sympy.Expr, lower: sympy.Expr, eps: Fraction) -> Outcome:
    ball = arb(eps.numerator) / eps.denominator
    sizes = list(islice(amplitudes(2 * ball), 12))
    elapsed, answers = arb(0), []
    for p, q in zip(sizes, sizes[1:]):
        elapsed += duration(p, q)
        curves = [1 / (1 + closed_form_ball(rate) * ball * elapsed) for rate in (upper, lower)]
        errors = [abs(curve - q / (2 * ball)) for curve in curves]
        answers += [below(curves[1], curves[0]), below(errors[1], errors[0])]
    return all_confirmed(*answers)


@statement(
    id="lelas2024:claim.slower-decay", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    shortfall=Shortfall.RANGE, derivation="lelas-air", line=27,
    title="(51) decays only slightly more slowly than (52)", printed=("51", "52", sympy.Integer(1)),
    corrected=("51", "52", 3 * sympy.pi * sympy.sqrt(2) / 16), near_miss=("52", "51", sympy.Integer(1)),
    latex=r"\text{(51) gives only a slightly slower amplitude decay compared to the solution (52)}",
    corrected_latex=r"\text{more slowly, by the factor } \frac{3\pi\sqrt{2}}{16} = 0.833 \text{ of the rate for}"
    r"\ \text{every } C",
    conditions="slower it is, always; slightly, only while C omega_0 x_0 t/m << 1, as in claim.agrees-well",
    methods=("2^{-3/2} < 4/(3 pi), balls", "quotient of the rates"),
    note="The rate is lower by 16.7 %, for all C, and the amplitudes end up 20 % apart, see claim.agrees-well. With"
    " friction it is the other way round: (47) decays faster than (48), since 1/sqrt(2) > 2/pi. Form: the slower and"
    " the faster solution, and the quotient of their rates, 1 for 'only slightly'.",
)
def slower_decay(form: tuple[str, str, sympy.Expr]) -> Outcome:
    """The rates compared by balls, and their quotient."""
    slower, faster, quotient = form
    ordered = below(*(closed_form_ball(RATES[name]) for name in (slower, faster)))
    return all_confirmed(decided(slower != faster), ordered, same(RATES[slower] / RATES[faster], quotient))


@statement(
    id="lelas2024:claim.agrees-well", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    shortfall=Shortfall.RANGE,
    title="(51) agrees well with (52)", latex=r"\text{our solution (51) agrees well with the solution (52)}",
    corrected_latex=r"1 \le \frac{f(t)}{\tilde{f}(t)} < \frac{8\sqrt{2}}{3\pi} = 1.2004", printed=sympy.Integer(1),
    corrected=8 * sympy.sqrt(2) / (3 * sympy.pi), near_miss=3 * sympy.pi / (8 * sympy.sqrt(2)),
    conditions="up to 20 % of the amplitude, reached at late times for any C", methods=("limit of the ratio",),
    derivation="lelas-air", line=26,
    note="At a fixed time the two agree ever better as C -> 0, but so does no damping at all."
    " Form: the ratio of the amplitudes as t tends to infinity.",
)
def agrees_well(ratio: sympy.Expr) -> Outcome:
    """The limit of (45) over the amplitude of (52)."""
    amplitudes_of = [1 / (1 + rate * STRENGTH * t) for rate in RATES.values()]
    return same(sympy.limit(sympy.simplify(amplitudes_of[0] / amplitudes_of[1]), t, sympy.oo), ratio)


@statement(
    id="lelas2024:claim.integral-of-sin-cubed", kind=Kind.CLAIM, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    derivation="lelas-powers", line=12,
    title="The integral that averaging needs", latex=r"\int_0^{T_0}\sin^3(\omega_0t)dt",
    corrected_latex=r"\int_0^{T_0}|\sin(\omega_0t)|^3dt", printed=(1, 1), corrected=(1, -1), near_miss=(2, 1),
    conditions="none", methods=("integral over both halves of the period",),
    note="The printed integral is 0; the power is -C|v|^3, which needs |sin|^3 with 8/(3 omega_0). Form: weights of the"
    " two halves of the period.",
)
def integral_of_sin_cubed(weights: tuple[int, int]) -> Outcome:
    """The weighted integral over 2 pi is the mean 4/(3 pi) in (52)."""
    halves = ((0, sympy.pi), (sympy.pi, 2 * sympy.pi))
    parts = [sympy.integrate(sympy.sin(phase) ** 3, (phase, *half)) for half in halves]
    total = sum((weight * part for weight, part in zip(weights, parts)), sympy.Integer(0))
    return same(total / (2 * sympy.pi), AVERAGE)


@statement(
    id="lelas2024:claim.slight-decrease", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.CERTIFIED,
    derivation="lancaster-conditions", line=4,
    shortfall=Shortfall.RANGE,
    title="In the weak regime the amplitude decreases only slightly during one period",
    latex=r"\text{it decrease only slightly during one full oscillation (one period) of the system}",
    corrected_latex=r"\text{in the first period of the four panels it loses 0.098, 0.294, 0.066 and 0.417 of itself}",
    printed=("1a", "1b", "2a", "2b"), corrected=("1a", "2a"), near_miss=("1a", "2b"),
    conditions="2 pi |f'| << omega_0, not just |f'| << omega_0", methods=("exact turning points, balls",),
    note="As a definition of the weak regime nothing is wrong with it; the entry judges its use, for the four panels"
    " shown as examples. The conditions (33) and (46) compare |f'| with omega_0; what is lost in a period is 2 pi"
    " |f'|/omega_0. C = 2 is a tenth of the bound in (53), and the motion is far from weakly damped. Form:"
    " panels that lose below 10 %.",
)
def slight_decrease(panels: tuple[str, ...]) -> Outcome:
    """The loss to the second turning point: 4 eps with friction, exact; by Lambert's W in air."""
    with ctx.workprec(100):
        found = {panel: below(_loss(panel), arb(1) / 10) for panel in ("1a", "1b", "2a", "2b")}
    if Outcome.UNDECIDED in found.values():
        return Outcome.UNDECIDED
    return decided(panels == tuple(panel for panel, outcome in found.items() if outcome == Outcome.CONFIRMED))


def _loss(panel: str) -> arb:
    if panel in DRAG:
        eps = air_strength(DRAG[panel])
        start = 2 * arb(eps.numerator) / eps.denominator
        return 1 - list(islice(amplitudes(start), 3))[2] / start
    eps = strength(dict(zip(("1a", "1b"), PANELS))[panel])
    return 4 * arb(eps.numerator) / eps.denominator


@statement(
    id="lelas2024:claim.one-integral", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Averaging needs two integrals, the trick only one",
    latex=r"\text{students don't need to calculate two integrals, but only one}", printed=(2, 1), near_miss=(2, 2),
    conditions="the integral of dt' on the right of (44) not counted, in both approaches",
    methods=("the mean in (52) is an integral, that in (51) is algebra",),
    note="With friction no integral is left, since f' is constant. Form: the numbers for averaging and for the trick.",
)
def integrals_needed(form: tuple[int, int]) -> Outcome:
    """The rate of (52) is a mean over a half period; that of (51) from sin^2 + cos^2 = 1; both then integrate f."""
    phase = sympy.Symbol("phase", positive=True)
    mean = sympy.integrate(sympy.sin(phase) ** 3, (phase, 0, sympy.pi)) / sympy.pi
    half = sympy.simplify(sympy.sin(phase) ** 2 + sympy.cos(phase) ** 2) / 2
    needed = (2, 1)  # the mean and f^-2; f^-2 alone
    return all_confirmed(
        same(mean, AVERAGE), same(half ** sympy.Rational(3, 2), RATES["51"]), decided(form == needed)
    )
