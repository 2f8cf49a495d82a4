"""Section VII, equation (54) and the remarks on powers of the velocity, initial conditions and the sign function."""

import sympy

from paper_checks.identities import all_confirmed, decided, same
from paper_checks.lelas2024.model import (
    A0,
    air_error,
    b,
    coulomb,
    f,
    g,
    has_order,
    k,
    m,
    mu,
    s,
    slow_error,
    t,
    v,
    viscous,
    w0,
    x0,
)
from paper_checks.lelas2024.section_2 import EXPONENTIAL, opposes, speed
from paper_checks.lelas2024.section_5 import AVERAGED_LINE
from paper_checks.lelas2024.section_6 import AVERAGED as AVERAGED_IN_AIR
from paper_checks.lelas2024.section_6 import PHASES
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

n = sympy.Symbol("n", integer=True, nonnegative=True)
sine = sympy.Symbol("sine", real=True)
POWERS = (0, 1, 2)
phi0 = sympy.Symbol("phi_0", real=True)
GENERAL = A0 * f * sympy.cos(w0 * t + phi0)
AVERAGED_HYPERBOLA = AVERAGED_IN_AIR / (x0 * sympy.cos(w0 * t))


@statement(
    id="lelas2024:claim.force-powers", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lelas-powers", line=2,
    shortfall=Shortfall.RANGE,
    title="The three forces as powers of the velocity", latex=r"F_d(t) \propto v^n(t), \quad n = \{0, 1, 2\}",
    corrected_latex=r"F_d(t) \propto -\mathrm{sgn}[v(t)]|v(t)|^n", printed=-(v**n),
    corrected=-sympy.sign(v) * abs(v) ** n, near_miss=sympy.sign(v) * abs(v) ** n, conditions="true for n = 1",
    methods=("power for v > 0, v = 0, v < 0 and n = 0, 1, 2",),
    note="For even n the power v^n does not change sign with v and would drive the block half of the time; (3) and (5)"
    " have the sign function. The printed form is taken with the negative factor that suits v > 0.",
)
def force_powers(form: sympy.Expr) -> Outcome:
    """Each force opposes the velocity, with size |v|^n."""
    return all_confirmed(*(opposes(form.subs(n, power), speed**power) for power in POWERS))


@statement(
    id="lelas2024:claim.general-forms", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED,
    extent="sampled: 6 points", order="1",
    title="The general forms of displacement and velocity for all three forces (before (54))",
    latex=r"x(t) = A_0f(t)\cos(\omega_0t + \phi_0), \quad v(t) = -\omega_0A_0f(t)\sin(\omega_0t + \phi_0)",
    printed=(GENERAL, -w0 * A0 * f * sympy.sin(w0 * t + phi0)),
    near_miss=(GENERAL * f, -w0 * A0 * f**2 * sympy.sin(w0 * t + phi0)),
    conditions="weak damping, with the f of each law that averaging gives: e^{-bt/2m}, that of (48) and that of (52);"
    " with the paper's own (32) and (45) the error does not vanish",
    methods=("derivative with f held", "largest error against the exact motion, three laws at two strengths each",),
    note="A_0 and phi_0 from the start, here x_0 and 0.",
)
def general_forms(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The velocity is the derivative with f held; the error of the displacement falls like the strength."""
    place, velocity = form
    held = same(velocity, sympy.diff(place, t))
    mine = place.subs({A0: x0, phi0: 0})
    errors = (
        slow_error(mine.subs(f, EXPONENTIAL), b, viscous),
        slow_error(mine.subs(f, AVERAGED_LINE), mu, coulomb),
        air_error(mine.subs(f, AVERAGED_HYPERBOLA), PHASES),
    )
    return all_confirmed(held, *(has_order(1, error) for error in errors))


@statement(
    id="lelas2024:54", kind=Kind.IDENTITY, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lelas-powers", line=8,
    shortfall=Shortfall.RANGE,
    title="The rate of f for the three laws at once",
    latex=r"m\omega_0^2A_0^2f(t)\frac{df(t)}{dt} \propto \omega_0^{n+1}A_0^{n+1}f^{n+1}(t)"
    r"\sin^{n+1}(\omega_0t + \phi_0)",
    corrected_latex=r"m\omega_0^2A_0^2f(t)\frac{df(t)}{dt} \propto -\omega_0^{n+1}A_0^{n+1}f^{n+1}(t)"
    r"|\sin(\omega_0t + \phi_0)|^{n+1}",
    printed=(w0 * A0 * f) ** (n + 1) * sine ** (n + 1), corrected=(w0 * A0 * f) ** (n + 1) * abs(sine) ** (n + 1),
    near_miss=(w0 * A0 * f) ** n * abs(sine) ** (n + 1), conditions="as printed for n = 1",
    methods=("-F_d v for both signs of the sine and n = 0, 1, 2",),
    note="With F_d ~ v^n, as the text says, (54) would follow, but for n = 0 and 2 its right side changes sign and f"
    " would grow half of the time; (26) and (38) have the absolute values. Form: -F_d v with factor 1.",
)
def rate_for_all_laws(form: sympy.Expr) -> Outcome:
    """|v|^(n+1) for v = -omega_0 A_0 f sine with sine = s and -s."""
    outcomes = [
        same(form.subs({n: power, sine: sign * s}), (w0 * A0 * f * s) ** (power + 1))
        for power in POWERS
        for sign in (1, -1)
    ]
    return all_confirmed(*outcomes)


@statement(
    id="lelas2024:claim.amplitude-cancels", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="The amplitude can be crossed out for n = 1 only", printed=(1,), near_miss=(0, 1),
    latex=r"\text{in case } n = 1 \text{ amplitude } A_0 \text{ can be eliminated; for } n = 0, 2 \text{ it can not}",
    conditions="none", methods=("powers of A_0 on both sides of (54)",), note="Form: the n for which it cancels.",
)
def amplitude_cancels(form: tuple[int, ...]) -> Outcome:
    """A_0^2 on the left, A_0^(n+1) on the right."""
    return decided(tuple(power for power in POWERS if not (A0 ** (power + 1) / A0**2).has(A0)) == form)


BOUNDS = {0: sympy.sqrt(2) * k * x0 / (m * g), 1: 2 * sympy.sqrt(k * m), 2: 2 * sympy.sqrt(2) * m / x0}


@statement(
    id="lelas2024:claim.conditions-and-x0", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="The weak damping conditions (33) and (46) depend on the initial displacement, (21) does not",
    latex=r"\text{(33) and (46) both depend on } x_0 \text{; initial conditions do not appear in (21)}",
    printed=(0, 2), near_miss=(0, 1, 2),
    conditions="none", methods=("letters of the three bounds",), note="Form: the n of those that do.",
)
def conditions_and_displacement(form: tuple[int, ...]) -> Outcome:
    """The bounds as in (21), (33), (46); the strength b omega_0^n x_0^(n-1)/k contains x_0 for n != 1 alike."""
    bounds = tuple(power for power, bound in BOUNDS.items() if bound.has(x0))
    strengths = tuple(power for power in POWERS if (b * w0**power * x0 ** (power - 1) / k).has(x0))
    return decided(bounds == strengths == tuple(form))


def without_sign(power: int) -> sympy.Expr:
    """-v^(power+1)/|v|."""
    return -(v ** (power + 1)) / abs(v)


@statement(
    id="lelas2024:claim.force-without-sign", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lelas-powers", line=6,
    shortfall=Shortfall.CONDITION,
    title="The forces without the sign function", latex=r"F_d(t) \propto -v^{n+1}(t)/|v(t)|, \quad n = \{0, 2\}",
    corrected_latex=r"F_d(t) \propto -v^{n+1}(t)/|v(t)| \text{ if } v(t) \ne 0", printed=(1, 0, -1), corrected=(1, -1),
    near_miss=(1, 0), conditions="v != 0, not stated", methods=("compared with -sgn(v)|v|^n at v = V, 0, -V",),
    note="At v = 0, at every turning point, it is 0/0: harmless for n = 2, where the limit is 0; for n = 0 there is no"
    " limit, while (3) with (4) has the value 0. Form: the signs of v at which it is used.",
)
def force_without_sign(signs: tuple[int, ...]) -> Outcome:
    """Both expressions at v = sign V for n = 0 and 2."""
    pairs = [(without_sign(power), -sympy.sign(v) * abs(v) ** power) for power in (0, 2)]

    def agree(sign: int) -> bool:
        values = [(a.subs(v, sign * speed), c.subs(v, sign * speed)) for a, c in pairs]
        return all(a != sympy.nan and a - c == 0 for a, c in values)

    return decided(signs == tuple(sign for sign in (1, 0, -1) if agree(sign)))


@statement(
    id="lelas2024:claim.powers-without-sign", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Their powers", latex=r"-v^2(t)/|v(t)| = -|v(t)|, \quad -v^4(t)/|v(t)| = -|v(t)|^3",
    printed=((2, 1), (4, 3)), near_miss=((2, 1), (4, 2)), conditions="v != 0; both sides tend to 0 with v",
    methods=("v > 0 and v < 0",),
)
def powers_without_sign(form: tuple[tuple[int, int], ...]) -> Outcome:
    """v^a/|v| against |v|^b at v = V and -V."""
    return all_confirmed(*(
        same((v**a / abs(v)).subs(v, sign * speed), speed**power) for a, power in form for sign in (1, -1)
    ))
