"""Section III, equations (22)-(33): the linear decay of the amplitude under sliding friction.

The letter s stands for |sin(omega_0 t)| and sqrt(1 - s^2) for |cos(omega_0 t)|; the sign of the velocity is +-1.
"""

from collections.abc import Callable

import sympy
from mpmath import mpf, pi

from paper_checks.identities import all_confirmed, decided, same, vanishes
from paper_checks.lelas2024.model import c, f, g, has_order, k, m, mu, s, slope, t, v, w0, x0
from paper_checks.lelas2024.section_2 import V1, V2, X1, X2
from paper_checks.lelas2024.section_2_trick import RATE_OF_ENERGY
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

root2 = sympy.sqrt(2)
STRENGTH = mu * g / (w0 * x0)  # the paper's recurring factor, an inverse time
FRICTION_LINE = 1 - STRENGTH / root2 * t
TAU = root2 * w0 * x0 / (mu * g)
SPEEDS = {"v1": w0 * x0 * f * s, "v2": w0 * x0 * f * c}  # |v_1|, |v_2|
GARBLED = (
    "The text has lost the extent of the root: with the root over everything it would not be a time. The number 12.9 s"
    " of section V and f(tau) = 0 need sqrt(2) omega_0 x_0/(mu g)."
)


def power_holds(form: tuple[str, sympy.Expr], size: sympy.Expr) -> Outcome:
    """The form is -size(|v|) |v|, the power of a force of that size against the velocity; both signs of v alike."""
    speed = SPEEDS[form[0]]
    return all_confirmed(*(same((-side * size.subs(v, speed)) * (side * speed), form[1]) for side in (1, -1)))


@statement(
    id="lelas2024:22", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The power of friction, first pair", latex=r"P_{d1}(t) = -\mathrm{sgn}[v_1(t)]\mu mg\,v_1(t)",
    printed=-sympy.sign(v) * mu * m * g * v, near_miss=sympy.sign(v) * mu * m * g * v,
    conditions="none", methods=("(3) times v",),
    derivation="lelas-friction",
)
@statement(
    id="lelas2024:23", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The power of friction, second pair", latex=r"P_{d2}(t) = -\mathrm{sgn}[v_2(t)]\mu mg\,v_2(t)",
    printed=-sympy.sign(v) * mu * m * g * v, near_miss=-mu * m * g * v, conditions="none", methods=("(3) times v",),
    derivation="lelas-friction",
)
def friction_power(form: sympy.Expr) -> Outcome:
    """F_d v with the force (3), for v = V, 0, -V."""
    places = (w0, 0, -w0)
    return all_confirmed(*(same(form.subs(v, place), -mu * m * g * abs(place)) for place in places))


@statement(
    id="lelas2024:claim.sign-times-velocity", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The sign function makes absolute values", latex=r"\mathrm{sgn}[v(t)]v(t) = |v(t)|",
    printed=(1, sympy.Abs(v)), near_miss=(1, v), conditions="none", methods=("v > 0, v = 0, v < 0",),
)
@statement(
    id="lelas2024:claim.sign-times-cube", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="The same for the cube", latex=r"\mathrm{sgn}[v(t)]v^3(t) = |v^3(t)| = |v(t)|^3",
    printed=(3, sympy.Abs(v) ** 3), near_miss=(3, v**3), conditions="none", methods=("v > 0, v = 0, v < 0",),
)
def sign_times_power(form: tuple[int, sympy.Expr]) -> Outcome:
    """sgn(v) v^p against the form at v = V, 0, -V."""
    left = sympy.sign(v) * v ** form[0]
    return all_confirmed(*(same(left.subs(v, place), form[1].subs(v, place)) for place in (w0, 0, -w0)))


@statement(
    id="lelas2024:24", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The approximate power, first pair", latex=r"P_{d1}(t) = -\mu mg\omega_0x_0f(t)|\sin(\omega_0t)|",
    printed=("v1", -mu * m * g * w0 * x0 * f * s), near_miss=("v1", -mu * m * g * w0 * x0 * f * s**2),
    conditions="with (12); f >= 0, which ends at tau", methods=("-mu m g |v|",), derivation="lelas-friction", line=2,
)
@statement(
    id="lelas2024:25", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The approximate power, second pair", latex=r"P_{d2}(t) = -\mu mg\omega_0x_0f(t)|\cos(\omega_0t)|",
    printed=("v2", -mu * m * g * w0 * x0 * f * c), near_miss=("v2", -mu * m * g * x0 * f * c),
    conditions="with (13); f >= 0, which ends at tau", methods=("-mu m g |v|",), derivation="lelas-friction", line=3,
)
def approximate_friction_power(form: tuple[str, sympy.Expr]) -> Outcome:
    """-mu m g |v| with the approximate velocity."""
    return power_holds(form, mu * m * g)


@statement(
    id="lelas2024:26", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The rate of f from the first pair",
    latex=r"\frac{df(t)}{dt} = -\frac{\mu g}{\omega_0x_0}|\sin(\omega_0t)|", printed=("v1", -STRENGTH * s),
    near_miss=("v1", -STRENGTH * s / 2), conditions="f > 0", methods=("(15) = (24) solved for df/dt",),
    derivation="lelas-friction", line=4,
)
@statement(
    id="lelas2024:27", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The rate of f from the second pair",
    latex=r"\frac{df(t)}{dt} = -\frac{\mu g}{\omega_0x_0}|\cos(\omega_0t)|", printed=("v2", -STRENGTH * c),
    near_miss=("v2", -STRENGTH * c * w0), conditions="f > 0", methods=("(15) = (25) solved for df/dt",),
    derivation="lelas-friction", line=5,
)
def friction_rate(form: tuple[str, sympy.Expr]) -> Outcome:
    """m omega_0^2 x_0^2 f f' = -mu m g |v|."""
    return vanishes(RATE_OF_ENERGY.subs(slope, form[1]) + mu * m * g * SPEEDS[form[0]])


@statement(
    id="lelas2024:28", premises=(0,),
    kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The square of the first rate", printed=(-STRENGTH * s, STRENGTH**2 * s**2),
    latex=r"\left(\frac{df(t)}{dt}\right)^2 = \left(\frac{\mu g}{\omega_0x_0}\right)^2|\sin(\omega_0t)|^2",
    near_miss=(-STRENGTH * s, STRENGTH * s**2),
    conditions="none", methods=("(26) squared",), derivation="lelas-friction",
)
@statement(
    id="lelas2024:29", premises=(0,),
    kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The square of the second rate", printed=(-STRENGTH * c, STRENGTH**2 * c**2),
    latex=r"\left(\frac{df(t)}{dt}\right)^2 = \left(\frac{\mu g}{\omega_0x_0}\right)^2|\cos(\omega_0t)|^2",
    near_miss=(-STRENGTH * c, STRENGTH**2 * s**2),
    conditions="none", methods=("(27) squared",), derivation="lelas-friction",
)
def squared_rate(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The square of the rate in the form."""
    return same(form[0] ** 2, form[1])


@statement(
    id="lelas2024:30", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The sum of the squares",
    latex=r"\left(\frac{df(t)}{dt}\right)^2 = \frac{1}{2}\left(\frac{\mu g}{\omega_0x_0}\right)^2",
    printed=STRENGTH**2 / 2, near_miss=STRENGTH**2, conditions="none", methods=("half the sum of (28) and (29)",),
    derivation="lelas-friction", line=6,
    note="The mean of the two squares replaces the square of the mean: a quadratic mean 1/sqrt(2) of |sin| in the place"
    " of the arithmetic mean 2/pi.",
)
def sum_of_squares(form: sympy.Expr) -> Outcome:
    """2 f'^2 is the sum of the two right sides."""
    return same(2 * form, STRENGTH**2 * s**2 + STRENGTH**2 * c**2)


def turning_error(decay: sympy.Expr) -> Callable[[mpf], mpf]:
    """The error of a linear amplitude 1 - decay tau (decay proportional to mu) at the exact turning point near 1/2."""
    factor = sympy.lambdify((), (decay / STRENGTH), "mpmath")()

    def error(eps: mpf) -> mpf:
        n = int(1 / (4 * eps))
        return (1 - factor * eps * n * pi) - (1 - 2 * n * eps)

    return error


@statement(
    id="lelas2024:31", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="0",
    extent="sampled: 2 points",
    title="The constant rate of decay", latex=r"\frac{df(t)}{dt} = -\frac{\mu g}{\sqrt{2}\,\omega_0x_0}",
    printed=-STRENGTH / root2, near_miss=-STRENGTH / 2, conditions="t < tau", derivation="lelas-friction",
    methods=("negative root of (30)", "error of the amplitude at the exact turning points, two values of mu"),
    note="The exact rate of the turning points is 2 mu g/(pi omega_0 x_0): (31) is too fast by the factor"
    " pi/(2 sqrt(2)) = 1.1107, for every mu, so that the error at a fixed fraction of the motion does not vanish.",
)
def constant_rate(form: sympy.Expr) -> Outcome:
    """The square is (30), the sign is negative, and the amplitude error at half amplitude has order 0."""
    root = all_confirmed(same(form**2, STRENGTH**2 / 2), decided(form.is_negative))
    return all_confirmed(root, has_order(0, turning_error(-form)))


@statement(
    id="lelas2024:claim.integrated-rate", kind=Kind.CLAIM, verdict=Printed.TRANSCRIPTION, evidence=Evidence.PROVED,
    derivation="lelas-friction", line=8,
    title="The solution of (31) up to a constant",
    latex=r"f(t) = -\frac{\mu g}{\sqrt{2}}\frac{\mu g}{2\omega_0x_0}t + const.",
    corrected_latex=r"f(t) = -\frac{\mu g}{\sqrt{2}\,\omega_0x_0}t + const.",
    printed=-mu * g / root2 * mu * g / (2 * w0 * x0) * t, corrected=-STRENGTH / root2 * t,
    near_miss=-STRENGTH / 2 * t, conditions="none", methods=("differentiated",),
    note="A fraction with a root was read twice; the same garble stands in |f'| before (33).",
)
def integrated_rate(form: sympy.Expr) -> Outcome:
    """The derivative is (31)."""
    return same(sympy.diff(form, t), -STRENGTH / root2)


@statement(
    id="lelas2024:32", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="0",
    extent="sampled: 2 points",
    title="The linear decay of the amplitude", latex=r"f(t) = 1 - \frac{\mu g}{\sqrt{2}\,\omega_0x_0}t",
    printed=FRICTION_LINE, near_miss=1 - STRENGTH / 2 * t, conditions="t <= tau", derivation="lelas-friction",
    methods=("(31) with f(0) = 1", "error of the amplitude at the exact turning points, two values of mu"),
)
def linear_decay(form: sympy.Expr) -> Outcome:
    """f' is (31), f(0) = 1; the amplitude error at half amplitude has order 0."""
    solves = same(sympy.diff(form, t), -STRENGTH / root2)
    return all_confirmed(solves, same(form.subs(t, 0), sympy.Integer(1)), constant_rate(sympy.diff(form, t)))


@statement(
    id="lelas2024:claim.slope-of-line", kind=Kind.CLAIM, verdict=Printed.TRANSCRIPTION, evidence=Evidence.PROVED,
    derivation="lelas-friction", line=8,
    title="The slope of (32), for all t", latex=r"|\dot f(t)| = \frac{\mu g}{\sqrt{2}}\frac{\mu g}{2\omega_0x_0}",
    corrected_latex=r"|\dot f(t)| = \frac{\mu g}{\sqrt{2}\,\omega_0x_0}",
    printed=-mu * g / root2 * mu * g / (2 * w0 * x0) * t, corrected=-STRENGTH / root2 * t,
    near_miss=-STRENGTH / 2 * t, conditions="none", methods=("(32) differentiated",),
    note="As in the solution of (31), a fraction was read twice. Form: minus the slope, times t.",
)
def slope_of_line(form: sympy.Expr) -> Outcome:
    """The derivative is (31), for the same garble as above."""
    return integrated_rate(form)


@statement(
    id="lelas2024:claim.same-decay-friction", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lelas-friction-exact", line=17,
    paraphrase=True,
    shortfall=Shortfall.CONDITION,
    title="The same f for both pairs, with friction", order="2",
    latex=r"f_1(t) = f_2(t)",
    corrected_latex=r"f_2 - f_1 = \left(\frac{1}{2} - \frac{2}{\pi}\right)\left(\frac{\mu mg}{kx_0}\right)^2 + \dots",
    printed=sympy.Integer(0), corrected=sympy.Rational(1, 2) - 2 / sympy.pi,
    near_miss=sympy.Rational(1, 2) - 1 / sympy.pi, conditions="up to second order in mu",
    methods=("exact turning points of both motions, series in mu",),
    note="(8) and (9) take one f for both. The amplitudes of the two exact motions, drawn through their turning points,"
    " are two parallel lines: equal to first order, not identically as for viscous damping. Form: the coefficient of"
    " the second order of the difference.",
)
def same_decay_friction(coefficient: sympy.Expr) -> Outcome:
    """First pair: 1 - 2 eps tau/pi.  Second: turns at tau = pi/2 - arctan eps with amplitude sqrt(1 + eps^2) - eps."""
    eps = sympy.Symbol("eps", positive=True)
    from_first = 1 - 2 * eps / sympy.pi * (sympy.pi / 2 - sympy.atan(eps))
    difference = sympy.sqrt(1 + eps**2) - eps - from_first
    lower = [sympy.diff(difference, eps, order).subs(eps, 0) for order in (0, 1)]
    second = sympy.diff(difference, eps, 2).subs(eps, 0) / 2
    return all_confirmed(*(vanishes(value) for value in lower), same(second, coefficient))


@statement(
    id="lelas2024:claim.stop-time-section-3", kind=Kind.CLAIM, verdict=Printed.TRANSCRIPTION, evidence=Evidence.PROVED,
    derivation="lelas-friction", line=10,
    title="The instant at which the approximation stops", latex=r"\tau = \sqrt{2\omega_0x_0/(\mu g)}",
    corrected_latex=r"\tau = \sqrt{2}\,\omega_0x_0/(\mu g)", printed=sympy.sqrt(2 * w0 * x0 / (mu * g)), corrected=TAU,
    near_miss=2 * w0 * x0 / (mu * g),
    conditions="none", methods=("zero of (32)",), note=GARBLED,
)
@statement(
    id="lelas2024:claim.everything-zero-at-stop", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="At tau both displacements and both velocities vanish",
    latex=r"x_1(\tau) = x_2(\tau) = v_1(\tau) = v_2(\tau) = 0", printed=TAU, near_miss=TAU / 2,
    methods=("zero of (32)",), conditions="in (8), (9), (12), (13)", derivation="lelas-friction",
    note="True of the approximation; the block itself stops at a turning point, off centre in general.",
)
def approximate_stop(form: sympy.Expr) -> Outcome:
    """(32) vanishes there, and with it all four quantities, each of which contains f."""
    stopped = vanishes(FRICTION_LINE.subs(t, form))
    return all_confirmed(stopped, *(vanishes(quantity.subs(f, 0)) for quantity in (X1, X2, V1, V2)))


@statement(
    id="lelas2024:claim.unphysical-after-stop", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="After tau the amplitude grows in magnitude", printed=1, near_miss=-1,
    latex=r"t > \tau: \text{ the amplitude starts to increase in magnitude}",
    conditions="none", methods=("derivative of f^2 at 2 tau",),
    note="Form: the sign of the rate of |f| after tau.",
)
def unphysical_after_stop(sign: int) -> Outcome:
    """(f^2)' at t = tau + d is positive for every d > 0."""
    d = sympy.Symbol("d", positive=True)
    growth = sympy.simplify(sympy.diff(FRICTION_LINE**2, t).subs(t, TAU + d))
    return decided(growth.is_positive, sign == 1)


@statement(
    id="lelas2024:33", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The condition of weak sliding friction", latex=r"\mu \ll \frac{\sqrt{2}kx_0}{mg}",
    printed=root2 * k * x0 / (m * g), near_miss=k * x0 / (root2 * m * g),
    conditions="none", methods=("|f'| = omega_0",),
    derivation="lelas-friction",
    note="In terms of eps = mu m g/(k x_0) it says eps << sqrt(2); the block does not move at all from eps = 1 on, and"
    " it makes about 1/(2 eps) half-swings. Form: the bound.",
)
def weak_friction(bound: sympy.Expr) -> Outcome:
    """|f'|/omega_0 = mu/bound with omega_0^2 = k/m."""
    ratio = (STRENGTH / root2 / w0).subs(w0, sympy.sqrt(k / m))
    return same(ratio, mu / bound)
