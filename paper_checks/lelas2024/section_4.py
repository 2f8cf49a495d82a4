"""Section IV, equations (34)-(46): the decay of the amplitude under air resistance.

As in section III, s stands for |sin(omega_0 t)|; r = -df/dt > 0.
"""

from collections.abc import Callable

import sympy
from flint import arb
from mpmath import mpf, pi

from asymptotics.numbers.bridge import closed_form_ball
from asymptotics.turning.quadratic_map import amplitudes
from paper_checks.identities import all_confirmed, decided, same, vanishes
from paper_checks.lelas2024.model import C, as_mpf, c, f, has_order, m, s, slope, t, v, w0, x0
from paper_checks.lelas2024.section_2_trick import RATE_OF_ENERGY
from paper_checks.lelas2024.section_3 import SPEEDS, power_holds
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

STRENGTH = C * w0 * x0 / m  # an inverse time
SLOW = 2 * sympy.sqrt(2)  # 2^(3/2)
HYPERBOLA = 1 / (1 + STRENGTH / SLOW * t)
TWO_THIRDS = sympy.Rational(2, 3)


@statement(
    id="lelas2024:34", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The power of air resistance, first pair", latex=r"P_{d1}(t) = -\mathrm{sgn}[v_1(t)]Cv_1^3(t)",
    printed=-sympy.sign(v) * C * v**3, near_miss=-C * v**3,
    conditions="none", methods=("(5) times v",), derivation="lelas-air",
)
@statement(
    id="lelas2024:35", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The power of air resistance, second pair", latex=r"P_{d2}(t) = -\mathrm{sgn}[v_2(t)]Cv_2^3(t)",
    printed=-sympy.sign(v) * C * v**3, near_miss=-sympy.sign(v) * C * v**2, conditions="none", methods=("(5) times v",),
    derivation="lelas-air",
)
def air_power(form: sympy.Expr) -> Outcome:
    """F_d v with the force (5), for v = V, 0, -V."""
    return all_confirmed(*(same(form.subs(v, place), -C * abs(place) ** 3) for place in (w0, 0, -w0)))


@statement(
    id="lelas2024:36", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The approximate power, first pair",
    latex=r"P_{d1}(t) = -C\left(\omega_0x_0f(t)\right)^3|\sin(\omega_0t)|^3",
    printed=("v1", -C * (w0 * x0 * f) ** 3 * s**3), near_miss=("v1", -C * (w0 * x0 * f) ** 2 * s**3),
    conditions="with (12); f >= 0", methods=("-C |v|^3",), derivation="lelas-air",
)
@statement(
    id="lelas2024:37", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The approximate power, second pair",
    latex=r"P_{d2}(t) = -C\left(\omega_0x_0f(t)\right)^3|\cos(\omega_0t)|^3",
    printed=("v2", -C * (w0 * x0 * f) ** 3 * c**3), near_miss=("v2", -C * (w0 * x0 * f) ** 3 * s**3),
    conditions="with (13); f >= 0", methods=("-C |v|^3",), derivation="lelas-air",
)
def approximate_air_power(form: tuple[str, sympy.Expr]) -> Outcome:
    """-C |v|^3 with the approximate velocity."""
    return power_holds(form, C * v**2)


@statement(
    id="lelas2024:38", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The rate of f from the first pair", derivation="lelas-air", line=1,
    latex=r"-\frac{df(t)}{dt} = \frac{C\omega_0x_0}{m}f^2(t)|\sin(\omega_0t)|^3",
    printed=("v1", STRENGTH * f**2 * s**3), near_miss=("v1", STRENGTH * f * s**3), conditions="f > 0",
    methods=("(15) = (36) solved for -df/dt",),
)
@statement(
    id="lelas2024:39", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The rate of f from the second pair", derivation="lelas-air", line=2,
    latex=r"-\frac{df(t)}{dt} = \frac{C\omega_0x_0}{m}f^2(t)|\cos(\omega_0t)|^3",
    printed=("v2", STRENGTH * f**2 * c**3), near_miss=("v2", STRENGTH / 2 * f**2 * c**3), conditions="f > 0",
    methods=("(15) = (37) solved for -df/dt",),
)
def air_rate(form: tuple[str, sympy.Expr]) -> Outcome:
    """m omega_0^2 x_0^2 f f' = -C |v|^3."""
    return vanishes(RATE_OF_ENERGY.subs(slope, -form[1]) + C * SPEEDS[form[0]] ** 3)


@statement(
    id="lelas2024:claim.both-sides-positive", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lelas-powers", line=11,
    shortfall=Shortfall.RANGE,
    paraphrase=True, title="Both sides of (38) and (39) are positive for any t", printed=(0, 1, 2, 3), corrected=(1, 3),
    near_miss=(1, 2, 3), latex=r"\frac{C\omega_0x_0}{m}f^2(t)|\sin(\omega_0t)|^3 > 0 \text{ for any } t",
    corrected_latex=r"\frac{C\omega_0x_0}{m}f^2(t)|\sin(\omega_0t)|^3 \ge 0",
    conditions="positive except at the zeros of sine or cosine", methods=("values at the quarter periods",),
    note="Not negative is all that the power 2/3 needs. Form: quarter periods j at which (38) is positive.",
)
def both_sides_positive(quarters: tuple[int, ...]) -> Outcome:
    """|sin(j pi/2)|^3 > 0 for each j of the form."""
    return decided(quarters == tuple(j for j in range(4) if abs(sympy.sin(j * sympy.pi / 2)) ** 3 > 0))


@statement(
    id="lelas2024:40", premises=(0,),
    kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The first rate to the power 2/3", derivation="lelas-air", line=3,
    latex=r"\left(-\frac{df(t)}{dt}\right)^{\frac{2}{3}} = \left(\frac{C\omega_0x_0}{m}\right)^{\frac{2}{3}}"
    r"f^{\frac{4}{3}}(t)|\sin(\omega_0t)|^2",
    printed=(STRENGTH * f**2 * s**3, STRENGTH**TWO_THIRDS * f ** (2 * TWO_THIRDS) * s**2),
    near_miss=(STRENGTH * f**2 * s**3, STRENGTH**TWO_THIRDS * f**TWO_THIRDS * s**2),
    conditions="none", methods=("(38)^(2/3)",),
)
@statement(
    id="lelas2024:41", premises=(0,),
    kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The second rate to the power 2/3", derivation="lelas-air", line=4,
    latex=r"\left(-\frac{df(t)}{dt}\right)^{\frac{2}{3}} = \left(\frac{C\omega_0x_0}{m}\right)^{\frac{2}{3}}"
    r"f^{\frac{4}{3}}(t)|\cos(\omega_0t)|^2",
    printed=(STRENGTH * f**2 * c**3, STRENGTH**TWO_THIRDS * f ** (2 * TWO_THIRDS) * c**2),
    near_miss=(STRENGTH * f**2 * c**3, STRENGTH * f ** (2 * TWO_THIRDS) * c**2),
    conditions="none", methods=("(39)^(2/3)",),
)
def rate_to_two_thirds(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The cubes of both sides, all of whose factors are positive: rate^2 = form^3."""
    return same(form[0] ** 2, form[1] ** 3)


@statement(
    id="lelas2024:42", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The sum", derivation="lelas-air", line=5,
    latex=r"\left(-\frac{df(t)}{dt}\right)^{\frac{2}{3}} = \frac{1}{2}\left(\frac{C\omega_0x_0}{m}\right)^{\frac{2}{3}}"
    r"f^{\frac{4}{3}}(t)",
    printed=STRENGTH**TWO_THIRDS * f ** (2 * TWO_THIRDS) / 2,
    near_miss=STRENGTH**TWO_THIRDS * f ** (2 * TWO_THIRDS),
    conditions="none", methods=("half the sum of (40) and (41)",),
    note="The power mean of |sin|^3 with exponent 2/3, 2^{-3/2} = 0.354, replaces the mean 4/(3 pi) = 0.424.",
)
def sum_of_powers(form: sympy.Expr) -> Outcome:
    """Twice the form is the sum of the two right sides."""
    factor = STRENGTH**TWO_THIRDS * f ** (2 * TWO_THIRDS)
    return same(2 * form, factor * s**2 + factor * c**2)


@statement(
    id="lelas2024:43", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="0",
    extent="sampled: 2 points",
    title="The rate of f", latex=r"\frac{df(t)}{dt} = -\left(\frac{C\omega_0x_0}{2^{\frac{3}{2}}m}\right)f^2(t)",
    printed=-STRENGTH / SLOW * f**2, near_miss=-STRENGTH / 2 * f**2, derivation="lelas-air",
    conditions="none", methods=("(42)^(3/2)", "error of the amplitude at the exact turning points, two values of C"),
    note="The rate of the averaged motion has 4/(3 pi): (43) is too slow by the factor 3 pi/(8 sqrt(2)) = 0.833, for"
    " every C.",
)
def rate_of_amplitude(form: sympy.Expr) -> Outcome:
    """(-form)^2 is the cube of (42); the amplitude that solves it has an error of order 0 at fixed slow time."""
    cube = (STRENGTH**TWO_THIRDS * f ** (2 * TWO_THIRDS) / 2) ** 3
    algebra = all_confirmed(same(form**2, cube), decided(form.is_negative))
    return all_confirmed(algebra, has_order(0, turning_error(-form / (STRENGTH * f**2))))


def turning_error(factor: sympy.Expr) -> Callable[[mpf], mpf]:
    """The error of the amplitude 1/(1 + factor eps tau) at the exact turning point next to eps tau = 1."""
    number = as_mpf(closed_form_ball(factor))

    def error(eps: mpf) -> mpf:
        n = round(1 / (eps * pi))
        sizes = amplitudes(2 * arb(str(eps)))
        size = [next(sizes) for _ in range(n + 1)][-1]
        return 1 / (1 + number * eps * n * pi) - as_mpf(size / (2 * arb(str(eps))))

    return error


@statement(
    id="lelas2024:44", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The integration", derivation="lelas-air",
    latex=r"\int_0^tf^{-2}(t')df(t') = -\frac{C\omega_0x_0}{2^{\frac{3}{2}}m}\int_0^tdt'",
    printed=(-2, -STRENGTH / SLOW), near_miss=(2, -STRENGTH / SLOW),
    conditions="none", methods=("(43) divided by f^2",),
    slip="The limits of the left integral belong to t'; those of f are 1 and f(t).",
    note="Form: the power of f under the left"
    " integral and the factor on the right.",
)
def separated(form: tuple[int, sympy.Expr]) -> Outcome:
    """The integrands: f^power f' is the constant factor along (43)."""
    power, factor = form
    return vanishes(f**power * (-STRENGTH / SLOW * f**2) - factor)


@statement(
    id="lelas2024:45", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="0",
    extent="sampled: 2 points",
    title="The decay of the amplitude", derivation="lelas-air",
    latex=r"f(t) = \left(1 + \frac{C\omega_0x_0}{2^{\frac{3}{2}}m}t\right)^{-1}", printed=HYPERBOLA,
    near_miss=1 / (1 + STRENGTH / 2 * t), conditions="t >= 0",
    methods=("(43) with f(0) = 1", "error of the amplitude at the exact turning points, two values of C"),
)
def hyperbolic_decay(form: sympy.Expr) -> Outcome:
    """f' = (43) and f(0) = 1; the order is that of (43)."""
    solves = vanishes(sympy.diff(form, t) + STRENGTH / SLOW * form**2)
    start = same(form.subs(t, 0), sympy.Integer(1))
    factor = -sympy.diff(form, t).subs(t, 0) / STRENGTH
    return all_confirmed(solves, start, has_order(0, turning_error(sympy.simplify(factor))))


@statement(
    id="lelas2024:46", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The condition of weak air resistance", latex=r"C \ll \frac{2^{\frac{3}{2}}m}{x_0}", printed=SLOW * m / x0,
    near_miss=m / (SLOW * x0), conditions="none", methods=("|f'(0)| = omega_0",), derivation="lelas-air",
    note="In terms of eps = C x_0/m it says eps << 2.83. Slow decay over a period needs 2 pi |f'| << omega_0, about a"
    " sixth of that; see claim.slight-decrease. Form: the bound.",
)
@statement(
    id="lelas2024:claim.initial-slope", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The slope of (45) at t = 0, its largest", latex=r"\dot f(0) = -C\omega_0x_0/(2^{\frac{3}{2}}m)",
    printed=SLOW * m / x0, near_miss=SLOW / x0, conditions="none", methods=("(45) differentiated", "|f'| decreases"),
    derivation="lelas-air", note="Form: C omega_0/|f'(0)|.",
)
def weak_air(bound: sympy.Expr) -> Outcome:
    """|f'(0)|/omega_0 = C/bound, and |f'| is largest at t = 0 since f'' > 0."""
    convex = decided(sympy.simplify(sympy.diff(HYPERBOLA, t, 2)).is_positive)
    start = -sympy.diff(HYPERBOLA, t).subs(t, 0)
    return all_confirmed(convex, same(start / w0, C / bound))
