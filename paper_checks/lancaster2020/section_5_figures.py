"""Figures 1 and 2, footnote 20 and dry friction: the mass stops away from equilibrium."""

from fractions import Fraction
from functools import cache
from math import cos, log2

import sympy
from flint import arb

from asymptotics.law import Law
from asymptotics.numbers.bridge import closed_form_ball, from_sympy
from asymptotics.numbers.context import ctx
from asymptotics.turning.choose import turning_points
from paper_checks.evidence import mark, sampled
from paper_checks.identities import all_confirmed, below, decided, rounds_to, same
from paper_checks.lancaster2020.model import (
    amplitude,
    b,
    dimension,
    k,
    m,
    mean,
    measured_order,
    numeric,
    reaches,
    x,
)
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

THREE_HALVES, HALF = sympy.Rational(3, 2), sympy.Rational(1, 2)
g, mu, theta = sympy.symbols("g mu theta", positive=True)


@statement(
    id="lancaster2020:claim.kappa-fig1", kind=Kind.NUMBER, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED,
    title="Figure 1: kappa", latex=r"\kappa \approx 0.042 \quad (\alpha = 0)", digits=2,
    printed=("0.042", sympy.Integer(0), "0.06519", "0.06675"),
    near_miss=("0.042", sympy.Integer(0), "0.06519", "0.06676"),
    conditions="0.0652 <= b/(k x_0) <= 0.0667", methods=("kappa = 2b/(pi k x0) at both ends of the range, balls",),
    note="m, k, b, x0 are not given; this range of epsilon = b/(k x0), and no other, gives the printed kappa. Form:"
    " kappa, alpha, and the range of epsilon to four figures.",
)
@statement(
    id="lancaster2020:claim.kappa-fig2", kind=Kind.NUMBER, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED,
    title="Figure 2: kappa", latex=r"\kappa \approx 0.19 \quad (\alpha = \tfrac{3}{2})", digits=2,
    printed=("0.19", THREE_HALVES, "0.4043", "0.4260"), near_miss=("0.19", THREE_HALVES, "0.4043", "0.4261"),
    conditions="0.4043 <= b omega_0^{3/2} x_0^{1/2}/k <= 0.4260",
    methods=("kappa = M_(5/2) epsilon at both ends of the range, balls",),
    note="kappa is less than half of epsilon here: M_(5/2) = 0.4577. Form as for claim.kappa-fig1.",
)
def range_of_strength(form: tuple[str, sympy.Expr, str, str]) -> Outcome:
    """kappa rounds to the printed number at both ends, and one unit of the last figure further out it does not."""
    printed, a, low, high = form
    unit = sympy.Rational(1, 10 ** len(low.partition(".")[2]))
    first, last, centre = sympy.Rational(low), sympy.Rational(high), sympy.Rational(printed)
    half = sympy.Rational(1, 2 * 10 ** len(printed.partition(".")[2]))
    ends = ((centre - half, first - unit, first), (centre + half, last, last + unit))  # each rounding edge lies between
    with ctx.workprec(80):
        pairs = [(mean(a) * low, edge) for edge, low, _ in ends] + [(edge, mean(a) * high) for edge, _, high in ends]
        return all_confirmed(*(below(closed_form_ball(p), closed_form_ball(q)) for p, q in pairs))


@statement(
    id="lancaster2020:fig1", kind=Kind.FIGURE, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED,
    title="Dry friction: the mass stops away from equilibrium",
    latex=r"\text{Sliding friction allows for the mass to stop away from equilibrium, which is not captured by the}"
    r"\ \text{approximate solution}",
    printed=("0.042", "-0.056"), near_miss=("0.042", "-0.057"), premises=(0,), digits=2,
    conditions="kappa = 0.042, that is epsilon = 0.0660; off centre for all epsilon of claim.kappa-fig1, after 8 half-"
    "swings for epsilon < 1/15 and after 7 above",
    methods=("exact turning points x_n = (-1)^n (1 - 2 n epsilon), balls",),
    note="Regenerated, half-swing by half-swing: the mass stops at x = -0.056 x0 after 8 half-swings (the amplitude of"
    " Table I is zero after 7.6), and from there on Table I grows again with the opposite sign. At the turning points"
    " before the stop it is exact. At kappa = 1/(8 pi) = 0.0398 the mass would stop at the origin. Form: kappa, and the"
    " place of rest in x0.",
)
def stops_off_centre(form: tuple[str, str]) -> Outcome:
    """|x_7| > epsilon >= |x_8| > 0: the mass stops at n = 8, off centre, at the place of the form."""
    kappa, rest = form
    with ctx.workprec(80):
        epsilon = closed_form_ball(sympy.Rational(kappa) * sympy.pi / 2)
        before, place = 1 - 14 * epsilon, 1 - 16 * epsilon
        stays = all_confirmed(below(epsilon, before), below(abs(place), epsilon), below(arb(0), abs(place)))
        return all_confirmed(stays, rounds_to(rest, place))


@statement(
    id="lancaster2020:claim.fig1-short-times", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Fig. 1, caption: with this kappa the approximation should work well at short times",
    paraphrase=True,
    latex=r"\kappa \approx 0.042 \text{: by (17) it should work well at short times}",
    printed=1 - sympy.cos(theta) * (1 - 2 * theta / sympy.pi), near_miss=1 - sympy.cos(theta) * (1 - theta / sympy.pi),
    conditions="alpha = 0, until the mass stops: |x - x_a| <= epsilon x_0 = 0.066 x_0, which is a small part of the"
    " amplitude at short times alone", methods=("exact motion on every half-swing minus the approximation",),
    note="By (17) the rate is 0.066 omega_0 at the start. The error is the offset of the centre: zero at the turning"
    " points, epsilon x_0 at most in between, the same on every half-swing, while the amplitude falls. Form: the error"
    " in units of +-epsilon x_0 at the phase theta of a half-swing.",
)
def works_at_short_times(form: sympy.Expr) -> Outcome:
    """On half-swing n, side = (-1)^n: x = side (epsilon + (1 - (2n+1) epsilon) cos theta), A = 1 - 2 epsilon tau/pi.

    The form is 1 - 2 y sin y/pi at theta = pi/2 - y, and y sin y >= 0 for |y| <= pi/2: it is at most 1, at y = 0.
    """
    e, number, y = sympy.symbols("e n y", positive=True)
    exact = e + (1 - (2 * number + 1) * e) * sympy.cos(theta)
    ours = (1 - 2 * e * (number * sympy.pi + theta) / sympy.pi) * sympy.cos(theta)
    largest = same(form.subs(theta, sympy.pi / 2 - y), 1 - 2 * y * sympy.sin(y) / sympy.pi)
    return all_confirmed(same(e * form, exact - ours), largest)


@statement(
    id="lancaster2020:claim.gradual-breakdown", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.CERTIFIED,
    derivation="lelas-friction-exact", line=11,
    shortfall=Shortfall.CONDITION,
    title="Figure 1 depicts the gradual breakdown for alpha = 0 at long times",
    latex=r"\text{Figure 1 depicts the gradual breakdown for the case } \alpha = 0",
    corrected_latex=r"|x_n| = |x_0 - 2nb/k| = |A(n\pi/\omega_0)| \text{ for } n \le 8 \text{, where the mass stops}",
    printed=0, corrected=8, near_miss=9, conditions="kappa = 0.042; gradual between the turning points only",
    methods=("exact turning points and Table I at n pi/omega_0, balls",),
    note="At the turning points Table I is exact until the mass stops, and wrong from then on: at n = 9 it is 3.4 times"
    " too large, and it grows by 2 epsilon a half-swing. Between the turning points the error is the offset"
    " epsilon of the centre, from the first swing on. Form: the last turning point at which Table I is exact.",
)
def breakdown(form: int) -> Outcome:
    """|x_n| = |1 - 2 n epsilon| until the stop at n = 8, then constant; Table I is |1 - 2 n epsilon| always."""
    with ctx.workprec(80):
        epsilon = closed_form_ball(sympy.Rational(42, 1000) * sympy.pi / 2)
        stop = all_confirmed(below(epsilon, 1 - 14 * epsilon), below(abs(1 - 16 * epsilon), epsilon))
        beyond = below(abs(1 - 16 * epsilon), abs(1 - 18 * epsilon))
    return all_confirmed(stop, beyond, decided(form == 8))


@statement(
    id="lancaster2020:claim.friction-overwhelms", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="The sliding friction can overwhelm the restoring force",
    latex=r"k|x| < b \text{ when the amplitude has decayed to a sufficiently small value}",
    printed=b / k, near_miss=2 * b / k, conditions="alpha = 0; equal static and kinetic friction",
    methods=("restoring force at the bound", "number of half-swings, exact"),
    note="'For certain parameter choices' is too cautious: it happens for all, after the least N half-swings with"
    " (2N+1) b >= k x0; only for k x0 = 2Nb at the origin. Form: the bound of |x|.",
)
@statement(
    id="lancaster2020:claim.stops-by-static-friction", kind=Kind.CLAIM, verdict=Printed.HOLDS,
    evidence=Evidence.PROVED, title="Where the mass stops (footnote 20)",
    latex=r"\text{it will stop if the available static friction is greater in magnitude than the restoring force}",
    printed=b / k, near_miss=2 * b / k, conditions="static friction b; at equality too, if it is as large as kinetic",
    methods=("restoring force at the bound", "number of half-swings, exact"), note="Form: the bound of |x|.",
)
def friction_overwhelms(form: sympy.Expr) -> Outcome:
    """k x = b at the form; and the turning amplitudes 1 - 2 n epsilon fall to it, for every epsilon."""
    e = sympy.Symbol("e", positive=True)
    count = (1 / e - 1) / 2  # from this n on the amplitude is at most epsilon, whatever epsilon is
    return all_confirmed(same(k * form, b), same(1 - 2 * count * e, e))


@statement(
    id="lancaster2020:claim.friction-coefficient", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The coefficients of friction", latex=r"\mu_s = \mu_k = \frac{b}{mg}", printed=b / (m * g),
    near_miss=b * g / m, conditions="alpha = 0; horizontal motion under gravity",
    methods=("normal force m g", "dimension"), note="Form: mu.",
)
def friction_coefficient(form: sympy.Expr) -> Outcome:
    """mu m g = b; and mu is a pure number (g scales like k x/m)."""
    number = dimension(form.subs(g, k * x / m)).subs(sympy.Symbol("alpha", positive=True), 0)
    return all_confirmed(same(form * m * g, b), same(number, sympy.Integer(1)))


@statement(
    id="lancaster2020:claim.short-times", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.MEASURED,
    extent="sampled: 2 points",
    order="1", title="For alpha < 1 the amplitude is valid for weak damping at short times",
    latex=r"\text{for } \alpha < 1 \text{, the asymptotic results for } A(t) \text{ are valid for the weak-damping}"
    r"\ \text{regime at short times}",
    printed=sympy.Integer(1), near_miss=sympy.Rational(21, 20),
    conditions="'short': (1-alpha) kappa omega_0 t below 1 and not near it; omega_0 t may be large",
    methods=("exact motion, alpha = 1/2, epsilon = 1/25 and 1/50, at epsilon omega_0 t about 1",),
    note="Form: the factor of A(t).",
)
def short_times(form: sympy.Expr) -> Outcome:
    """The error of A cos(omega_0 t) falls like epsilon at a fixed slow time."""
    A_of = numeric(amplitude(sympy.Symbol("alpha", positive=True)), HALF)
    factor = float(form)
    return reaches(
        measured_order((("1/2", "1"),), lambda e, s, X, V: X - factor * A_of(e, s) * cos(s)), 1
    )


@statement(
    id="lancaster2020:fig2", kind=Kind.FIGURE, verdict=Printed.HOLDS, evidence=Evidence.MEASURED,
    extent="sampled: 9 points",
    title="alpha = 3/2: the approximation is quite robust",
    latex=r"\text{the approximation is quite robust, even for modest } \kappa", printed=-2,
    near_miss=Fraction(-199, 100),
    conditions="kappa = 0.19, that is epsilon = 0.4152",
    methods=("exact turning points, half-swing by half-swing, n = 1 ... 9",),
    note="Regenerated. At the turning points the amplitude is right to 0.02 %; what is left is the phase, a lag that"
    " tends to about 0.28. Form: the exponent of the bracket.",
)
@statement(
    id="lancaster2020:claim.long-times-good", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.MEASURED,
    extent="sampled: 9 points",
    title="Good agreement at long times for alpha > 1 and modest kappa", printed=-2, near_miss=Fraction(-199, 100),
    latex=r"\text{For } \alpha > 1 \text{ and modest values of } \kappa \text{, agreement ... at long times}"
    r"\ \omega_0 t \gg 1 \text{ is generally quite good}",
    conditions="shown at alpha = 3/2, kappa = 0.19", methods=("exact turning points, n = 1 ... 9",),
    derivation="finite-phase-lag", note="Form as for fig2.",
)
def robust(form: int) -> Outcome:
    """|X_n| against [1 + kappa tau_n/2]^form, with epsilon = kappa/M_(5/2) to four figures."""
    mark(Evidence.MEASURED)
    points = sampled(_turning_points_of_figure_2())
    quotients = [place / (1 + 0.5 * kappa * tau) ** form for place, tau, kappa in points]
    worst = max(abs(quotient - 1) for quotient in quotients)
    return decided(worst < 0.001)


@cache
def _turning_points_of_figure_2() -> list[tuple[float, float, float]]:
    """(|X_n|, tau_n, kappa), heuristic."""
    epsilon = sympy.Rational(4152, 10000)
    with ctx.workprec(80):
        kappa = float((closed_form_ball(mean(THREE_HALVES)) * arb(4152) / 10000).mid())
    table = turning_points(Law({"3/2": from_sympy(epsilon)}), 10, 12, times=True)
    return [(abs(float(point.x)), float(point.tau or 0), kappa) for point in table.points[1:]]


@statement(
    id="lancaster2020:fn20", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="1",
    extent="sampled: 3 points",
    title="The residual motion is a numerical artifact that ceases with the step size",
    latex=r"\text{As the step size } \delta t \to 0 \text{, the motion ceases}", printed=1, near_miss=0,
    conditions="alpha = 0; sgn(v) with a fixed step",
    methods=("semi-implicit Euler steps at the resting place of Fig. 1, three step sizes",),
    note="The mean speed is proportional to the step. 'A careful implementation ... would be tedious' does not apply:"
    " half-swing by half-swing the motion is elementary and the mass stops exactly. Form: the order in the step.",
)
def chatter(form: int) -> Outcome:
    """The mean speed at rest, from x = -0.0556, falls by 2 when the step is halved."""
    mark(Evidence.MEASURED)
    speeds = [_mean_speed(step) for step in sampled((4e-3, 2e-3, 1e-3))]
    orders = [log2(a / c) for a, c in zip(speeds, speeds[1:])]
    return decided(all(abs(order - form) < 0.1 for order in orders))


def _mean_speed(step: float, steps: int = 4000) -> float:
    """The mean |v| of a fixed-step integration with v' = -x - epsilon sgn v; heuristic."""
    x_, v_, epsilon, total = -0.0556, 0.0, 0.06597, 0.0
    for _ in range(steps):
        sign = (v_ > 0) - (v_ < 0)
        v_ += step * (-x_ - epsilon * sign)
        x_ += step * v_
        total += abs(v_)
    return total / steps


@statement(
    id="lancaster2020:claim.never-strictly-zero", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.MEASURED,
    derivation="lelas-friction-exact", line=5,
    extent="sampled: 60 points", shortfall=Shortfall.CONDITION,
    title="Within a numerical scheme the velocity is never strictly zero (footnote 20)",
    latex=r"\text{Within a numerical integration scheme, the velocity is never strictly zero}",
    corrected_latex=r"\text{it is zero at the start from rest, and in a scheme that goes from turning point to"
    r" turning point}",
    printed=0, corrected=1, near_miss=2, conditions="a fixed step, after the start from rest",
    methods=("60 steps of the scheme of fn20 in exact rationals, from rest",),
    note="In 60 exact steps of 1/250 the velocity vanishes at the start alone. Half-swing by half-swing it is zero at"
    " each turning point, and the mass stops exactly. Form: how many of these velocities are zero.",
)
def never_strictly_zero(form: int) -> Outcome:
    """v' = -x - epsilon sgn v, x' = v in steps of 1/250 from x = 1, v = 0, without rounding."""
    mark(Evidence.MEASURED)
    place, speed, step, epsilon = Fraction(1), Fraction(0), Fraction(1, 250), Fraction(66, 1000)
    speeds = []
    for _ in sampled(range(60)):
        speeds.append(speed)
        speed += step * (-place - epsilon * ((speed > 0) - (speed < 0)))
        place += step * speed
    return decided(sum(v == 0 for v in speeds) == form)


@statement(
    id="lancaster2020:claim.fn20-speed", kind=Kind.NUMBER, verdict=Printed.OPEN, evidence=Evidence.NONE,
    title="The mean speed of the numerical artifact (footnote 20)",
    latex=r"\left\langle\frac{v}{\omega_0 x_0}\right\rangle \sim 10^{-5}", printed=1e-5, near_miss=0.1,
    methods=("step that the scheme of fn20 needs for it",), conditions="alpha = 0; sgn(v) with a fixed step",
    note="Open: the number depends on the integrator and its step, which the supplied text does not give. The scheme"
    " of fn20 gives it for omega_0 dt of about 0.0002. Near miss: a speed that no usable step gives.",
)
def artifact(form: float) -> Outcome:
    """The speed is proportional to the step (fn20): UNDECIDED if some step below 1/10 gives the form."""
    needed = form * 1e-3 / _mean_speed(1e-3)
    return Outcome.UNDECIDED if needed < 0.1 else Outcome.REFUTED
