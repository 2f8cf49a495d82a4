"""Section II, equations (14)-(21): two dissipation rates added, for viscous damping.

The velocities of the two pairs are -omega_0 x_0 f sin and omega_0 x_0 f cos.  Each law has the power -P(|v|).
"""

from typing import Any

import sympy

from paper_checks.identities import all_confirmed, decided, opposite, same, vanishes
from paper_checks.lelas2024.model import A0, B0, b, f, k, m, slope, t, theta, w0, x0
from paper_checks.lelas2024.section_2 import ENERGY, V1, V2, X1, X2, along, v, x
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

weight = sympy.Symbol("W", positive=True)
sin, cos = sympy.sin(w0 * t), sympy.cos(w0 * t)
ENERGY_OF_F = m * w0**2 * x0**2 * f**2 / 2
RATE_OF_ENERGY = m * w0**2 * x0**2 * f * slope


@statement(
    id="lelas2024:14", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The approximate energies are equal",
    latex=r"E_1(t) = E_2(t) = \frac{m\omega_0^2x_0^2f^2(t)}{2}", printed=ENERGY_OF_F, near_miss=ENERGY_OF_F / f,
    conditions="with (8), (9), (12), (13)", methods=("substitution in (6), k = m omega_0^2",),
    derivation="lelas-viscous",
)
def approximate_energies(form: sympy.Expr) -> Outcome:
    """(6) at both approximate motions."""
    pairs = ((X1, V1), (X2, V2))
    return all_confirmed(*(same(ENERGY.subs({x: a, v: u, k: m * w0**2}), form) for a, u in pairs))


@statement(
    id="lelas2024:15", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Their first derivatives",
    latex=r"\frac{dE_1(t)}{dt} = \frac{dE_2(t)}{dt} = m\omega_0^2x_0^2f(t)\frac{df(t)}{dt}",
    printed=RATE_OF_ENERGY, near_miss=RATE_OF_ENERGY / 2,
    conditions="none", methods=("(14) differentiated",), derivation="lelas-viscous",
)
def rate_of_energy(form: sympy.Expr) -> Outcome:
    """d/dt of (14)."""
    return same(along(ENERGY_OF_F), form)


@statement(
    id="lelas2024:16", premises=(0,),
    kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The power of viscous damping, first pair",
    latex=r"P_{d1}(t) = -b\omega_0^2x_0^2f^2(t)\sin^2(\omega_0t)", printed=(V1, -b * w0**2 * x0**2 * f**2 * sin**2),
    near_miss=(V1, -b * w0**2 * x0**2 * f**2 * cos**2), conditions="with (12)", methods=("-b v^2",),
    derivation="lelas-viscous",
)
@statement(
    id="lelas2024:17", premises=(0,),
    kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The power of viscous damping, second pair",
    latex=r"P_{d2}(t) = -b\omega_0^2x_0^2f^2(t)\cos^2(\omega_0t)", printed=(V2, -b * w0**2 * x0**2 * f**2 * cos**2),
    near_miss=(V2, -b * w0 * x0**2 * f**2 * cos**2), conditions="with (13)", methods=("-b v^2",),
    derivation="lelas-viscous",
)
def viscous_power(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """-b v^2 for the velocity of the form."""
    return same(-b * form[0] ** 2, form[1])


@statement(
    id="lelas2024:18", premises=(0,),
    kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The rate of f from the first pair", latex=r"\frac{df(t)}{dt} = -\frac{b}{m}f(t)\sin^2(\omega_0t)",
    printed=(V1, -b / m * f * sin**2), near_miss=(V1, -b / (2 * m) * f * sin**2), derivation="lelas-viscous",
    conditions="f > 0; a consequence of (15) and (16)", methods=("(15) = (16) solved for df/dt",),
    note="(18) and (19) are two different equations for one f; see claim.two-rates-contradict.",
)
@statement(
    id="lelas2024:19", premises=(0,),
    kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The rate of f from the second pair", latex=r"\frac{df(t)}{dt} = -\frac{b}{m}f(t)\cos^2(\omega_0t)",
    printed=(V2, -b / m * f * cos**2), near_miss=(V2, -b / (2 * m) * f * cos**2), derivation="lelas-viscous",
    conditions="f > 0; a consequence of (15) and (17)", methods=("(15) = (17) solved for df/dt",),
)
def viscous_rate(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """m omega_0^2 x_0^2 f f' = -b v^2."""
    return vanishes(RATE_OF_ENERGY.subs(slope, form[1]) + b * form[0] ** 2)


@statement(
    id="lelas2024:claim.two-rates-contradict", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lelas-viscous", line=13,
    shortfall=Shortfall.CONDITION,
    title="One function f obeys both (18) and (19)", printed=sympy.Integer(0), corrected=sympy.pi / 2,
    near_miss=sympy.pi / 3,
    latex=r"\frac{df}{dt} = -\frac{b}{m}f\sin^2(\omega_0t) \text{ and } \frac{df}{dt} = -\frac{b}{m}f\cos^2(\omega_0t)",
    corrected_latex=r"\left\langle\sin^2\right\rangle = \left\langle\cos^2\right\rangle = \frac{1}{2}",
    conditions="in the mean over a quarter period or a multiple of it", methods=("values and quarter-period means",),
    note="Taken together the two say sin^2 = cos^2, false except at isolated instants: each is wrong by as much as the"
    " rate itself, since the f' dropped from the velocities is of the order kept in (15). The sum is right because the"
    " means agree, so the trick is an average after all. Form: the phase over which the mean is taken from a"
    " turning point on, 0 at an instant.",
)
def two_rates(form: sympy.Expr) -> Outcome:
    """sin^2 - cos^2 vanishes identically (0), or its integral from 0 to the stated phase does."""
    difference = sympy.sin(theta) ** 2 - sympy.cos(theta) ** 2
    return vanishes(difference if form == 0 else sympy.integrate(difference, (theta, 0, form)))


@statement(
    id="lelas2024:20", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.PROVED, order="2",
    title="The sum of the two rates", latex=r"\frac{df(t)}{dt} = -\frac{b}{2m}f(t)", printed=-b / (2 * m) * f,
    near_miss=-b / m * f, methods=("half the sum of (18) and (19)", "the exact decay rate is b/(2m)"),
    derivation="lelas-viscous", conditions="b < 2 sqrt(km)",
    note="The rate b/(2m) is exact for every underdamped b; the order is that of omega_0 against the exact frequency.",
)
def sum_of_rates(form: sympy.Expr) -> Outcome:
    """2 f' is the sum; and e^(-bt/2m) times a cosine of frequency sqrt(omega_0^2 - b^2/4m^2) solves (1) with (2)."""
    total = (-b / m * f * sin**2 - b / m * f * cos**2) / 2
    decay = form / f
    motion = sympy.exp(decay * t) * sympy.cos(sympy.sqrt(w0**2 - b**2 / (4 * m**2)) * t)
    residual = m * sympy.diff(motion, t, 2) + b * sympy.diff(motion, t) + m * w0**2 * motion
    exact = vanishes(sympy.expand(sympy.expand(residual) * sympy.exp(-decay * t)))
    return all_confirmed(same(form, total), exact)


@statement(
    id="lelas2024:claim.exponential-decay", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The exponential decay of the amplitude", latex=r"f(t) = e^{-\frac{b}{2m}t}", derivation="lelas-viscous",
    printed=sympy.exp(-b * t / (2 * m)), near_miss=sympy.exp(-b * t / m),
    conditions="none", methods=("(20) and f(0) = 1",),
)
def exponential_decay(form: sympy.Expr) -> Outcome:
    """f' = -(b/2m) f with f(0) = 1."""
    return all_confirmed(vanishes(sympy.diff(form, t) + b / (2 * m) * form), same(form.subs(t, 0), sympy.Integer(1)))


@statement(
    id="lelas2024:claim.exponential-energy", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="This version of the approach gives a purely exponential decay of energy",
    latex=r"E_1(t) = E_2(t) = E_0e^{-\frac{b}{m}t}", printed=sympy.exp(-b * t / m),
    near_miss=sympy.exp(-b * t / (2 * m)),
    conditions="none", methods=("(14) with f = e^{-bt/2m}",), derivation="lelas-viscous",
)
def exponential_energy(form: sympy.Expr) -> Outcome:
    """f^2."""
    return same(ENERGY_OF_F.subs(f, sympy.exp(-b * t / (2 * m))), m * w0**2 * x0**2 / 2 * form)


@statement(
    id="lelas2024:claim.viscous-average", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="With viscous damping averaging over a period gives exponential decays of amplitude and energy",
    latex=r"\text{In case of viscous damping, approach used in [12] gives exponential amplitude decay, and purely}"
    r"\ \text{exponential approximation of the energy decay}",
    printed=(sympy.exp(-b * t / (2 * m)), sympy.exp(-b * t / m)),
    near_miss=(sympy.exp(-b * t / m), sympy.exp(-2 * b * t / m)),
    conditions="|f'| << omega_0 f", methods=("mean power -b v^2 over a period at constant amplitude",),
    derivation="lelas-viscous",
    note="The same functions as by the trick, since the mean of sin^2 is 1/2. Form: f and E/E_0.",
)
def viscous_average(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """dE/dt = the mean of -b (omega_0 x_0 f sin)^2 over a period, with E = m omega_0^2 x_0^2 f^2/2."""
    amplitude, energy = form
    mean = sympy.integrate(sympy.sin(theta) ** 2, (theta, 0, 2 * sympy.pi)) / (2 * sympy.pi)
    power = -b * (w0 * x0 * f) ** 2 * mean
    wanted = sympy.cancel(power / sympy.diff(ENERGY_OF_F, f) / f)  # f'/f
    rates = [sympy.diff(sympy.log(part), t) for part in form]
    start = [same(part.subs(t, 0), sympy.Integer(1)) for part in form]
    return all_confirmed(*start, same(rates[0], wanted), same(rates[1], 2 * wanted), same(energy, amplitude**2))


@statement(
    id="lelas2024:21", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The condition of weak viscous damping", latex=r"b \ll 2\sqrt{km}", printed=2 * sympy.sqrt(k * m),
    near_miss=sympy.sqrt(k * m), conditions="none", methods=("|f'(0)| = omega_0",), derivation="lelas-viscous",
    note="The bound is also that of critical damping. Form: the bound.",
)
def weak_viscous_damping(bound: sympy.Expr) -> Outcome:
    """|f'(0)|/omega_0 = b/bound."""
    return same(b / (2 * m) / sympy.sqrt(k / m), b / bound)


@statement(
    id="lelas2024:claim.trick-fails", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="The trick does not work unchanged for the other two types of damping",
    latex=r"|\sin|^{n+1} + |\cos|^{n+1} \text{ is constant for } n = 1 \text{ only}", printed=(0, 2), near_miss=(0, 1),
    conditions="n = 0, 1, 2", methods=("values at 0 and at pi/4",),
    note="Form: the n for which adding the two powers gives no constant.",
)
def trick_fails(form: tuple[int, ...]) -> Outcome:
    """2 (1/2)^((n+1)/2) against 1; constant for n = 1, since sin^2 + cos^2 = 1."""
    return decided(form == tuple(n for n in range(3) if 2 * sympy.sqrt(2) ** -(n + 1) != 1))


@statement(
    id="lelas2024:claim.shifted-pairs", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="For viscous damping any two amplitudes work if the phases differ by pi/2",
    latex=r"\text{the only necessary condition for our procedure to work is } \beta_0 = \phi_0 \pm \pi/2",
    printed=(A0, B0, sympy.pi / 2), near_miss=(A0, B0, sympy.pi / 3), conditions="n = 1",
    methods=("the sum of the two equations is free of t",),
    note="Necessary too: sin^2(a) + sin^2(a + d) = 1 - cos(d) cos(2a + d), constant only for cos d = 0.",
)
def procedure_works(form: tuple[sympy.Expr, ...]) -> Outcome:
    """The sum of sin^2(theta + phase) over both pairs, n = 1, must not depend on theta; the amplitudes are positive."""
    first, second, shift = form
    positive = decided(first.is_positive, second.is_positive)  # an amplitude is; a sign is a phase
    total = sympy.sin(theta) ** 2 + sympy.sin(theta + shift) ** 2
    return all_confirmed(positive, vanishes(sympy.diff(sympy.expand_trig(total), theta)))


@statement(
    id="lelas2024:claim.equal-amplitudes", premises=(3, 4),
    derivation="lelas-powers", line=15,
    kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED, shortfall=Shortfall.CONSEQUENCE,
    title="For friction and air the trick also needs equal amplitudes", conditions="n = 0, 2",
    latex=r"n = 0, 2: \text{ our procedure works only if } A_0 = B_0 \text{ and } \beta_0 - \phi_0 = \pm\pi/2",
    corrected_latex=r"n = 0, 2: \text{ the addition closes for any } A_0, B_0 \text{, each equation over its power of"
    r" the amplitude; one } f \text{ for both needs } A_0 = B_0",
    printed=("equal", "equal", sympy.pi / 2, 0, 2), corrected=("any", "equal", sympy.pi / 2, 0, 2),
    near_miss=("any", "any", sympy.pi / 2, 0, 2),
    methods=("the weighted sum of the two equations, raised to 2/(n+1), is free of t", "the two slow rates compared"),
    note="The conclusion is true, but does not follow from A_0 standing in (54): divided by A_0^(n-1) and B_0^(n-1),"
    " the two equations add up to a constant for any two amplitudes. What fails is the f that both are given: its rate"
    " goes with A^(n-1). Form: which amplitudes the addition allows, and which one f for both.",
)
def amplitudes_needed(form: tuple[Any, ...]) -> Outcome:
    """f' = -c A^(n-1) f^n |sin(theta + phase)|^(n+1): to the power 2/(n+1) one weight makes the sum constant."""
    addition, common, shift, *powers = form
    if {addition, common} - {"equal", "any"}:
        return Outcome.REFUTED
    found = []
    for n in powers:
        power = sympy.Rational(2 * (n - 1), n + 1)
        total = A0**power * sympy.sin(theta) ** 2 + weight * B0**power * sympy.sin(theta + shift) ** 2
        rate = sympy.diff(sympy.expand_trig(total), theta)
        closes = vanishes(rate.subs(weight, sympy.solve(rate.subs(theta, 1), weight)[0]))
        found += [_allowed(addition, closes), _allowed(common, vanishes(A0 ** (n - 1) - B0 ** (n - 1)))]
    return all_confirmed(*found)


def _allowed(said: str, whatever: Outcome) -> Outcome:
    """Whether "any" or "equal" is right, where ``whatever`` says if it works for unequal amplitudes."""
    return whatever if said == "any" else opposite(whatever)


