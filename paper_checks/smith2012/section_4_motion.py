"""Section IV, equations (69)-(72) and figures 5-7: the motion to first order in gamma v/omega.

The orders of convergence are measured against the quadrature of the exact motion (heuristic: mpmath, 30 digits); the
amplitude u_0 = gamma x_0 is the small parameter.

>>> with workdps(DIGITS):                                                        # pi (1 + u_1^2/6 + ...)
...     start = mpf("0.001")
...     float(round((half_period(start) / pi - 1) / next_turning_point(start)**2, 3))
0.167
"""

from collections.abc import Callable

import sympy
from mpmath import cos, exp, expm1, lambertw, log, mpf, pi, quad, sin, sqrt

from asymptotics.numbers.bridge import closed_form_ball
from asymptotics.numbers.context import ctx
from asymptotics.numbers.decimal_context import workdps
from paper_checks.evidence import mark, sampled
from paper_checks.identities import all_confirmed, below, decided, limit_is, not_of_order, same, vanishes
from paper_checks.registry import Shortfall, statement
from paper_checks.smith2012.model import FALLING_FORCE, Z_OF_STATE, gamma, invariant, n, omega, orbit, u0, v, x
from paper_checks.smith2012.section_3_table import integration_constants
from paper_checks.smith2012.section_4_quadrature import RADICAND, E
from paper_checks.units import SYSTEMS, agreed
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

AMPLITUDES = ("0.02", "0.01", "0.005")
DIGITS = 30
THIRD = sympy.Rational(2, 3) * omega * gamma * v**3 / (omega**2 * v**2 + FALLING_FORCE**2)


def next_turning_point(start: mpf) -> mpf:
    """|u_(n+1)| from |u_n| = start, heuristic."""
    y = 1 + 2 * start
    return (1 + lambertw(-y * exp(-y)).real) / 2


def speed_squared(start: mpf, u: mpf) -> mpf:
    """w^2 at u on the falling half-swing from rest at start > 0, heuristic."""
    return (u - start) - (start + mpf(1) / 2) * expm1(2 * (u - start))


def time_from_rest(start: mpf, angle: mpf) -> tuple[mpf, mpf]:
    """(u, tau) at u = middle + half cos(angle) on the falling half-swing from rest at start, heuristic.

    With this substitution the integrand du/|w| is analytic at both turning points.
    """
    end = -next_turning_point(start)
    middle, half = (start + end) / 2, (start - end) / 2

    def integrand(phi: mpf) -> mpf:
        return half * sin(phi) / sqrt(speed_squared(start, middle + half * cos(phi)))

    return middle + half * cos(angle), quad(integrand, [0, angle], method="gauss-legendre")


def half_period(start: mpf) -> mpf:
    """The duration of the half-swing from rest at start, heuristic."""
    return time_from_rest(start, pi)[1]


def measured_order(error: Callable[[mpf], mpf]) -> float:
    """log_2 of the ratio of the errors at the two smallest of AMPLITUDES."""
    mark(Evidence.MEASURED)
    with workdps(DIGITS):
        coarse, fine = (abs(error(mpf(amplitude))) for amplitude in sampled(AMPLITUDES[-2:]))
        return float(log(coarse / fine) / log(2))


def second_order(error: Callable[[mpf], mpf]) -> Outcome:
    """CONFIRMED if the error is measured to be of order 2, REFUTED if of order 1 or 0."""
    order = measured_order(error)
    if order > 1.8:
        return Outcome.CONFIRMED
    return not_of_order(order, 2) if order < 1.2 else Outcome.UNDECIDED


@statement(
    id="smith2012:69", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="2",
    extent="sampled: 4 points",
    title="The motion to first order in gamma v/omega",
    latex=r"0 = \omega t - \tan^{-1}\left(\frac{\omega v}{\gamma v^2-\omega^2 x}\right) - \frac{2}{3}"
    r"\frac{\omega\gamma v^3}{[\omega^2v^2 + (\gamma v^2-\omega^2 x)^2]}",
    printed=sympy.atan(Z_OF_STATE) + THIRD, near_miss=sympy.atan(Z_OF_STATE) + THIRD / 2,
    conditions="falling half-cycle from rest at t = 0; pi added to the arctangent once the acceleration is positive",
    methods=("error in omega t against the quadrature, u_0 = 0.01 and 0.005",), derivation="smith-generating-functions",
    note="The first neglected term is w^2 G_2. Form: omega t as a function of x and v.",
)
def first_order_motion(form: sympy.Expr) -> Outcome:
    """The error of omega t at a fixed phase of the half-swing, before and after the zero of the acceleration.

    And at a fixed z the form is linear in w: there is no term of second order that belongs to f_n with n > 2.
    """
    w, z = sympy.symbols("w z", positive=True)
    speed = w * omega / gamma
    of_series = {v: speed, x: (gamma * speed**2 - omega * speed / z) / omega**2}
    linear = vanishes(sympy.diff(sympy.simplify(form.subs(of_series, simultaneous=True)), w, 2))
    if linear == Outcome.REFUTED:
        return linear

    def error(angle: mpf) -> Callable[[mpf], mpf]:
        def at(start: mpf) -> mpf:
            place, tau = time_from_rest(start, angle)
            speed = -sqrt(speed_squared(start, place))
            branch = pi if speed**2 > place else 0
            return agreed(*(_value(form, place, speed, *system[1:3]) for system in SYSTEMS)) + branch - tau

        return at

    return all_confirmed(linear, second_order(error(mpf(1))), second_order(error(mpf(5) / 2)))


def _value(form: sympy.Expr, place: mpf, speed: mpf, rate: sympy.Expr, length: sympy.Expr) -> mpf:
    """The value of a form of x and v where u and w are given, with omega = rate and gamma = 1/length."""
    state = {x: length * sympy.Float(place, DIGITS), v: length * rate * sympy.Float(speed, DIGITS)}
    return mpf(sympy.N(form.subs({gamma: 1 / length, omega: rate, **state}), DIGITS))


@statement(
    id="smith2012:claim.harmonic-limit", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="(69) agrees with the harmonic oscillator when the damping vanishes",
    latex=r"\gamma \to 0: \quad 0 = \omega t + \tan^{-1}\left(\frac{v}{\omega x}\right)",
    printed=-sympy.atan(v / (omega * x)), near_miss=sympy.atan(v / (omega * x)),
    methods=("gamma = 0, differentiated along the motion",), conditions="omega fixed",
    note="Form: omega t at gamma = 0.",
)
def harmonic_limit(form: sympy.Expr) -> Outcome:
    """(69) at gamma = 0 is the form, and its rate along x'' = -omega^2 x is omega."""
    limit = (sympy.atan(Z_OF_STATE) + THIRD).subs(gamma, 0)
    rate = sympy.diff(form, x) * v - sympy.diff(form, v) * omega**2 * x
    return all_confirmed(vanishes(rate - omega), same(limit, form))


@statement(
    id="smith2012:claim.last-term-vanishes", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="The last term of (69) vanishes at the turning points", conditions="x != 0 there",
    latex=r"\frac{2}{3}\frac{\omega\gamma v^3}{[\omega^2v^2 + (\gamma v^2-\omega^2 x)^2]} = 0 \text{ at } v = 0",
    printed=THIRD, near_miss=2 * gamma * v / (3 * omega), methods=("limit of the term over v^3 at v = 0",),
    note="The zero is of the third order. Near miss: the square (gamma v^2 - omega^2 x)^2 left out below.",
)
def last_term_vanishes(form: sympy.Expr) -> Outcome:
    """The term of (69), divided by v^3, has at v = 0 what its numerator has over (omega^2 x)^2."""
    third_order = limit_is(form / v**3, v, sympy.Integer(0), 2 * omega * gamma / (3 * (omega**2 * x) ** 2), "+")
    return all_confirmed(third_order, same(form, THIRD))


@statement(
    id="smith2012:claim.arctan-argument", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="The argument of the arctangent vanishes at the turning points and diverges in between",
    latex=r"\frac{\omega v}{\gamma v^2-\omega^2 x} = 0 \text{ at each turning point; it changes sign and diverges in"
    r" between}",
    printed=Z_OF_STATE, near_miss=1 / Z_OF_STATE, conditions="u_0 > 0; exactly one such point, (46c)",
    methods=("zeros of numerator and denominator", "the acceleration is monotone in u, see claim.maximum-velocity"),
)
def argument_of_arctan(form: sympy.Expr) -> Outcome:
    """omega v over the acceleration; the numerator vanishes at v = 0, the denominator changes sign where that does."""
    numerator, denominator = sympy.fraction(sympy.together(form))
    zero = {x: gamma * v**2 / omega**2}
    crossing, slope = denominator.subs(zero), sympy.diff(denominator, x).subs(zero)
    places = all_confirmed(vanishes(numerator.subs(v, 0)), vanishes(crossing), decided(slope.is_nonzero))
    return all_confirmed(places, same(form * FALLING_FORCE, omega * v))


@statement(
    id="smith2012:claim.pi-added", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="pi must be added to keep omega t continuous", latex=r"\omega(t_+ - t_-) = \pi", printed=sympy.pi,
    near_miss=sympy.pi / 2, conditions="falling half-cycle, after the zero of the acceleration",
    methods=("one-sided limits of the arctangent",),
)
def pi_added(form: sympy.Expr) -> Outcome:
    """The arctangent falls from +pi/2 to -pi/2 as its argument passes through infinity."""
    return same(form, sympy.limit(sympy.atan(x), x, sympy.oo) - sympy.limit(sympy.atan(x), x, -sympy.oo))


def at_amplitude(form: sympy.Expr, start: mpf) -> mpf:
    """A form in u_0 as a number."""
    return mpf(sympy.N(form.subs(u0, sympy.Float(start, DIGITS)), DIGITS))


@statement(
    id="smith2012:70", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="2",
    extent="sampled: 2 points",
    title="The period to first order", latex=r"\tau = \frac{2\pi}{\omega}", printed=2 * sympy.pi,
    near_miss=2 * sympy.pi * (1 + u0 / 6), conditions="to first order in gamma x_0",
    methods=("twice the half period by quadrature, u_0 = 0.01 and 0.005",), derivation="smith-generating-functions",
    note="The half period is pi (1 + u_1^2/6 + ...)/omega. Form: omega tau as a function of u_0.",
)
def period(form: sympy.Expr) -> Outcome:
    """The error of the period is of second order."""
    return second_order(lambda start: 2 * half_period(start) - at_amplitude(form, start))


@statement(
    id="smith2012:claim.frequency", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="2",
    extent="sampled: 2 points",
    title="To first order in gamma the frequency is the natural frequency", printed=sympy.Integer(1),
    latex=r"\text{to first order in the damping constant the oscillation frequency is identical to the natural}"
    r"\ \text{frequency}",
    near_miss=1 - u0 / 6, conditions="to first order in gamma x_0",
    methods=("2 pi over twice the half period by quadrature",), derivation="smith-generating-functions",
)
def frequency(form: sympy.Expr) -> Outcome:
    """The error of the frequency in units of omega is of second order."""
    return second_order(lambda start: pi / half_period(start) - at_amplitude(form, start))


@statement(
    id="smith2012:71", kind=Kind.IDENTITY, verdict=Printed.PARTLY, evidence=Evidence.CERTIFIED,
    derivation="smith-quadrature", line=11,
    shortfall=Shortfall.CONDITION,
    title="The half-cycles mated at the turning points",
    latex=r"x_n(0) = x_{n-1}(\pi/\omega) = x([n-1]\pi/\omega)",
    corrected_latex=r"x_n(0) = x_{n-1}(\pi/\omega) = x(n\pi/\omega)", printed=n - 1, corrected=n, near_miss=n + 1,
    conditions="half-cycles numbered from 0, as in E_n, u_n, (54) and (72); half period pi/omega by (70)",
    methods=("which turning point has S - S_n: balls on the orbit u_0 = 1",),
    note="As printed it holds if the half-cycles are numbered from 1, as the rows of Table I are; but the x_n meant"
    " here is made from v_n(x) of (54), whose E_n = (omega^2/gamma^2)(S - S_n) belongs to the half-cycle that starts at"
    " u_n, and (72) has n tau/2 < t_n. Form: the number of half-cycles elapsed.",
)
def start_of_half_cycle(form: sympy.Expr) -> Outcome:
    """The turning point u_j with S^-+(u_j, 0) = S - S_n is u_n only, and u_j is reached at t = j pi/omega."""
    with ctx.workprec(300):
        mark(Evidence.CERTIFIED)
        points, constants = orbit(5), integration_constants(5)
        energies = [invariant(0, points[0]) - constant for constant in constants]
        for number, energy in enumerate(energies[1:], 1):
            starts = [j for j, point in enumerate(points) if (invariant(j, point) - energy).contains(0)]
            if starts != [form.subs(n, number)]:
                return Outcome.REFUTED
    return Outcome.CONFIRMED


ROOT = sympy.sqrt(2 * sympy.exp(2 * gamma * x) * E + omega**2 * x / gamma + omega**2 / (2 * gamma**2))
ARGUMENT = omega * ROOT / (2 * gamma * sympy.exp(2 * gamma * x) * E + omega**2 / (2 * gamma))


def third_term(middle: int) -> sympy.Expr:
    """The last term of (72), with the factor of omega^2 E e^(2 gamma x) in its denominator."""
    first = 4 * gamma**2 * E**2 * sympy.exp(4 * gamma * x) + middle * omega**2 * E * sympy.exp(2 * gamma * x)
    last = omega**4 * x / gamma + 3 * omega**4 / (4 * gamma**2)
    return sympy.Rational(2, 3) * gamma * omega * ROOT**3 / (first + last)


LAST_LATEX = (
    r"\frac{\gamma\omega\left[2e^{2\gamma x}E_n + \frac{\omega^2 x}{\gamma} + \frac{\omega^2}{2\gamma^2}\right]^{3/2}}"
    r"{4\gamma^2E_n^2e^{4\gamma x} + %d\omega^2E_ne^{2\gamma x} + \frac{\omega^4 x}{\gamma}"
    r" + \frac{3\omega^4}{4\gamma^2}}"
)
ARGUMENT_LATEX = (
    r"\frac{\omega\sqrt{2e^{2\gamma x}E_n + \frac{\omega^2 x}{\gamma} + \frac{\omega^2}{2\gamma^2}}}"
    r"{2\gamma e^{2\gamma x}E_n + \frac{\omega^2}{2\gamma}}"
)


@statement(
    id="smith2012:72", kind=Kind.APPROXIMATION, verdict=Printed.MISPRINT, evidence=Evidence.PROVED, order="2",
    derivation="smith-quadrature", line=13,
    title="The curve of Fig. 5: v_n(x) inserted in (69)",
    latex=r"0 = \omega t_n - \tan^{-1}\left(" + ARGUMENT_LATEX + r"\right) - \frac{2}{3}\left(" + LAST_LATEX % 3
    + r"\right), \quad \frac{n\tau}{2} < t_n \le \frac{(n+1)\tau}{2}",
    corrected_latex=r"0 = \omega t_n + \tan^{-1}\left(" + ARGUMENT_LATEX + r"\right) + \frac{2}{3}\left("
    + LAST_LATEX % 4 + r"\right)",
    printed=(ARGUMENT, third_term(3)), corrected=(-ARGUMENT, -third_term(4)), near_miss=(-ARGUMENT, -third_term(2)),
    conditions="v < 0 (n even), t_n counted from the start of half-cycle n, pi subtracted from the arctangent once its"
    " argument is positive; for n odd, x -> -x",
    methods=("v = -sqrt(v^2) from (54), corrected, in (69)",),
    note="Three slips. The factor 3 must be 4: omega^2 v^2 gives 2 omega^2 E e^{2 gamma x}, the square of gamma v^2 -"
    " omega^2 x another 2. And v < 0 on the half-cycles with these E_n, so both terms change sign; as printed the curve"
    " runs backwards in time. The radicand, omega^2/gamma instead of the omega^2/(2 gamma) of (54), is right."
    " The range: the printed equation lets t_n run from 0 in every half-cycle, not from n tau/2.",
)
def curve_of_figure_5(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """(69) with v = -r, where E is eliminated in favour of r by r^2 = v^2(x)."""
    r = sympy.Symbol("r", positive=True)
    energy = sympy.solve(RADICAND - r**2, E)[0]
    wanted = (expression.subs(v, -r) for expression in (Z_OF_STATE, THIRD))
    return all_confirmed(*(vanishes(sympy.simplify(part.subs(E, energy)) - true) for part, true in zip(form, wanted)))


@statement(
    id="smith2012:fig5", kind=Kind.FIGURE, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="2",
    extent="sampled: 2 points",
    title="Three full cycles to first order: six half-cycles of length pi",
    latex=r"\text{Fig. 5. Three full cycles of the quadratically damped oscillator to first-order in } \gamma v/\omega",
    printed=6 * sympy.pi, near_miss=6 * sympy.pi * (1 + u0 / 6), conditions="turning points exact, times by (69)",
    methods=("regenerated: total duration against six half periods by quadrature",),
    note="Form: omega t at the end of the third cycle. At u_0 = 1, as drawn, the exact time is longer by 0.358.",
)
def three_cycles(form: sympy.Expr) -> Outcome:
    """The six half periods along the exact turning points, compared with the form."""

    def error(start: mpf) -> mpf:
        total, amplitude = mpf(0), start
        for _ in range(6):
            total += half_period(amplitude)
            amplitude = next_turning_point(amplitude)
        return total - at_amplitude(form, start)

    return second_order(error)


@statement(
    id="smith2012:fig6", kind=Kind.FIGURE, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED,
    title="An exponential through u at the beginning and end of the first period",
    latex=r"\text{Fig. 6. The exponential envelope for Fig. 5 has been set to intersect } u(t) \text{ at the beginning"
    r" and at the end of the first period}", printed=(0, 1, 2 * sympy.pi), near_miss=(0, 1, sympy.Rational(6581, 1000)),
    conditions="u_0 = 1; in the time of Fig. 5, to first order",
    methods=("regenerated: maxima u_{2k} by balls, at the times of (69)",),
    note="Form: the cycles at whose ends the two agree, and omega t of a cycle. Near miss: the exact first cycle, in"
    " which the exponential would meet the curve of Fig. 5 elsewhere.",
)
def exponential_in_time(form: tuple[int, int, sympy.Expr]) -> Outcome:
    """e^(-decay omega t) through the start and the maximum at two half-cycles of (69), each of them pi (0 at v = 0)."""
    *cycles, length = form
    half_cycle = sympy.pi + (sympy.atan(Z_OF_STATE) + THIRD).subs(v, 0)
    with ctx.workprec(300):
        maxima = orbit(7)[::2]
        decay = (maxima[0] / maxima[1]).log() / closed_form_ball(2 * half_cycle)
        times = [k * closed_form_ball(length) for k in range(4)]
        curve = [maxima[0] * (-decay * time).exp() for time in times]
        mark(Evidence.CERTIFIED)
        agree = [k for k, (top, value) in enumerate(zip(maxima, curve)) if (top - value).contains(0)]
    return decided(agree == cycles)


@statement(
    id="smith2012:fig7", kind=Kind.FIGURE, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED,
    title="Phase space: quadratic damping, linear damping, no damping", printed=(0, 1), near_miss=(0, 2),
    latex=r"\text{Fig. 7. Three full cycles in phase space ... superimposed on the viscously damped oscillator}",
    conditions="u_0 = 1", methods=("regenerated: maxima u_{2k} by balls",),
    note="The circle u^2 + w^2 = u_0^2 is the outer curve, since d(u^2 + w^2)/dtau = -2|w|^3. Form: the cycles at whose"
    " ends the exponential of Fig. 6 agrees.",
)
def exponential_through(form: tuple[int, int]) -> Outcome:
    """The exponential u_0 (u_2/u_0)^k meets the maxima u_(2k), k = 0 ... 3, at the k of the form and nowhere else."""
    with ctx.workprec(300):
        mark(Evidence.CERTIFIED)
        maxima = orbit(7)[::2]
        ratio = maxima[1] / maxima[0]
        agree = [k for k, top in enumerate(maxima) if (top - maxima[0] * ratio**k).contains(0)]
    return decided(tuple(agree) == form)


@statement(
    id="smith2012:claim.slower-than-exponential", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED,
    title="The decay is much slower than exponential", printed=1, near_miss=-1,
    latex=r"\text{the decay of the quadratically damped oscillator is much slower than exponential}",
    conditions="u_0 = 1, from the end of the first cycle on; within that cycle the oscillator lies below the fit",
    methods=("maxima u_{2k}, k = 2 ... 10, by balls", "ratios of successive maxima increase"),
    note="|u_n| falls like 3/(4n). Form: the sign of u_{2k} minus the exponential.",
)
def slower_than_exponential(sign: int) -> Outcome:
    """u_(2k) against the exponential through the first two maxima."""
    with ctx.workprec(300):
        maxima = orbit(21)[::2]
        ratios = [b / a for a, b in zip(maxima, maxima[1:])]
        above = [below(maxima[0] * ratios[0] ** k, top) for k, top in enumerate(maxima) if k > 1]
        growing = [below(a, b) for a, b in zip(ratios, ratios[1:])]
    return all_confirmed(*above, *growing, decided(sign == 1))
