"""Section II, equations (1)-(13): the laws of damping, the energy, and the forms assumed for weak damping."""

import sympy

from paper_checks.identities import all_confirmed, decided, same, vanishes
from paper_checks.lelas2024.model import (
    C,
    b,
    f,
    g,
    has_order,
    k,
    m,
    mu,
    rate,
    slope,
    slow_error,
    t,
    v,
    viscous,
    viscous_velocity,
    w0,
    x,
    x0,
)
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

sin, cos, sign = sympy.sin(w0 * t), sympy.cos(w0 * t), sympy.sign
force = sympy.Symbol("F_d", real=True)
speed = sympy.Symbol("V", positive=True)
ENERGY = k * x**2 / 2 + m * v**2 / 2
X1, X2 = x0 * f * cos, x0 * f * sin
V1, V2 = -w0 * x0 * f * sin, w0 * x0 * f * cos
EXPONENTIAL = sympy.exp(-b * t / (2 * m))


def along(expression: sympy.Expr) -> sympy.Expr:
    """d/dt, where f depends on t with derivative ``slope``."""
    return sympy.diff(expression, t) + slope * sympy.diff(expression, f)


def opposes(law: sympy.Expr, size: sympy.Expr) -> Outcome:
    """F_d v = -size |v| for v = V, 0, -V with V > 0: the force has this size and opposes the velocity."""
    moving = [same((law * v).subs(v, side * speed), -(size * speed).subs(v, speed)) for side in (1, -1)]
    return all_confirmed(*moving, vanishes(law.subs(v, 0)))


@statement(
    id="lelas2024:1", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The equation of motion", latex=r"ma(t) = F_d(t) - kx(t)", conditions="m, k > 0",
    printed=force - k * x, near_miss=force + k * x, methods=("energy balance: dE/dt = F_d v",),
)
def equation_of_motion(form: sympy.Expr) -> Outcome:
    """d/dt (k x^2/2 + m v^2/2) = k x v + v (m a) is the power of the damping force."""
    return vanishes(k * x * v + v * form - force * v)


@statement(
    id="lelas2024:2", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="Viscous damping", latex=r"F_d(t) = -bv(t)", conditions="b > 0", printed=(-b * v, b * speed),
    near_miss=(b * v, b * speed), methods=("sign and size for v > 0, v = 0, v < 0",),
)
@statement(
    id="lelas2024:3", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="Sliding friction", latex=r"F_d(t) = -\mathrm{sgn}[v(t)]\,\mu mg", conditions="mu > 0, while it slides",
    printed=(-sign(v) * mu * m * g, mu * m * g), near_miss=(-mu * m * g, mu * m * g),
    methods=("sign and size for v > 0, v = 0, v < 0",),
    note="At v = 0 the static force is -kx up to mu m g, not 0: (3) with (4) alone does not hold the block at rest off"
    " centre. The paper says so in section V, by equal static and dynamic coefficients.",
)
def damping_law(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The force has the stated size and opposes the velocity; it is 0 at v = 0."""
    return opposes(*form)


@statement(
    id="lelas2024:4", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The sign function", printed=(1, 0, -1), near_miss=(1, 1, -1),
    latex=r"\mathrm{sgn}[v(t)] = \begin{cases} 1 & \text{if } v(t) > 0 \\ 0 & \text{if } v(t) = 0 \\ -1 & \text{if }"
    r" v(t) < 0 \end{cases}", conditions="none", methods=("sgn is odd and sgn(v) v = |v|",),
    note="The value at 0 is a convention used at isolated instants only: with it (3) gives no force on"
    " a block at rest, where friction in fact holds it.",
)
def sign_function(form: tuple[int, int, int]) -> Outcome:
    """The values for v = 2, 0, -2 make an odd function with sgn(v) v = |v|."""
    odd = form[0] == -form[2] and form[1] == -form[1]
    return decided(odd and all(value * place == abs(place) for value, place in zip(form, (2, 0, -2))))


@statement(
    id="lelas2024:5", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="Air resistance", latex=r"F_d(t) = -\mathrm{sgn}[v(t)]\,Cv^2(t)", conditions="C > 0",
    printed=(-sign(v) * C * v**2, C * speed**2), near_miss=(-C * v**2, C * speed**2),
    methods=("sign and size for v > 0, v = 0, v < 0",),
)
def quadratic_law(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """As for the other two."""
    return damping_law(form)


@statement(
    id="lelas2024:claim.drag-constant", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The drag constant of a sphere", latex=r"C = c\rho A/2", printed=(1, 1), near_miss=(1, 2),
    conditions="c the drag coefficient, a number", methods=("dimensions: C v^2 is a force",),
    note="Form: the powers of the density and of the cross section.",
)
def drag_constant(form: tuple[int, int]) -> Outcome:
    """kg, m, s with rho = kg/m^3, A = m^2, v = m/s: rho^p A^q v^2 must be kg m/s^2."""
    density, area = form
    return decided((density, -3 * density + 2 * area + 2, -2) == (1, 1, -2))


@statement(
    id="lelas2024:6", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The energy", latex=r"E(t) = \frac{kx^2(t)}{2} + \frac{mv^2(t)}{2}", printed=ENERGY,
    near_miss=k * x**2 / 2 - m * v**2 / 2, conditions="none", methods=("constant without damping", "m v^2/2 at x = 0"),
)
def energy(form: sympy.Expr) -> Outcome:
    """dE/dt = 0 for m a = -k x, and E is the kinetic energy at x = 0."""
    conserved = vanishes(sympy.diff(form, x) * v - sympy.diff(form, v) * k * x / m)
    return all_confirmed(conserved, same(form.subs(x, 0), m * v**2 / 2))


@statement(
    id="lelas2024:claim.undamped-solution", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The general solution without damping",
    latex=r"x(t) = A_0\cos(\omega_0 t + \phi_0), \quad \omega_0 = \sqrt{k/m}", conditions="F_d = 0",
    printed=sympy.sqrt(k / m), near_miss=sympy.sqrt(m / k), methods=("substitution in (1)",),
)
def undamped_solution(frequency: sympy.Expr) -> Outcome:
    """m x'' + k x for the cosine, whose phase is free."""
    motion = sympy.cos(frequency * t + x0)
    return all_confirmed(vanishes(m * sympy.diff(motion, t, 2) + k * motion), decided(frequency.is_positive))


@statement(
    id="lelas2024:7", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The energy dissipation rate", latex=r"\frac{dE(t)}{dt} = F_d(t)v(t)", printed=force * v,
    near_miss=-force * v, methods=("(6) differentiated along (1)",), conditions="any damping force",
)
def dissipation_rate(form: sympy.Expr) -> Outcome:
    """dE/dt along m a = F_d - k x."""
    return same(sympy.diff(ENERGY, x) * v + sympy.diff(ENERGY, v) * (force - k * x) / m, form)


@statement(
    id="lelas2024:claim.energy-decreases", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The energy never increases, and dE/dt = 0 just where v = 0",
    latex=r"F_d(t)v(t) \le 0 \ \forall t, \quad \frac{dE(t)}{dt} = 0 \text{ holds at the turning points}",
    printed=(-b * v, -sign(v) * mu * m * g, -sign(v) * C * v**2),
    near_miss=(-b * v, -mu * m * g, -sign(v) * C * v**2), conditions="none", methods=("power for v > 0, v = 0, v < 0",),
    note="Near miss: a friction force without the sign function.",
)
def energy_decreases(form: tuple[sympy.Expr, ...]) -> Outcome:
    """For each law F_d v is negative at v = V and v = -V, and zero at v = 0."""
    powers = [law * v for law in form]
    negative = [p.subs(v, side * speed).is_negative for p in powers for side in (1, -1)]
    return all_confirmed(decided(*negative), *(vanishes(p.subs(v, 0)) for p in powers))


@statement(
    id="lelas2024:claim.equal-initial-energies", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="Both pairs of initial conditions have the same energy",
    latex=r"E_0 = m\omega_0^2x_0^2/2 \text{ for } (x_0, 0) \text{ and for } (0, \omega_0x_0)",
    printed=((x0, 0), (0, w0 * x0)), near_miss=((x0, 0), (0, x0)),
    conditions="none", methods=("(6) with k = m omega_0^2",),
)
def equal_initial_energies(form: tuple[tuple[sympy.Expr, sympy.Expr], ...]) -> Outcome:
    """(6) at both initial states."""
    at_start = (ENERGY.subs({x: a, v: u, k: m * w0**2}) for a, u in form)
    return all_confirmed(*(same(value, m * w0**2 * x0**2 / 2) for value in at_start))


@statement(
    id="lelas2024:claim.undamped-pair", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The undamped motions of the two pairs", printed=(x0 * cos, x0 * sin), near_miss=(x0 * cos, -x0 * sin),
    latex=r"x_1(t) = x_0\cos(\omega_0t), \quad x_2(t) = x_0\sin(\omega_0t)", conditions="F_d = 0",
    methods=("equation of motion and initial values",),
)
def undamped_pair(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """x'' = -omega_0^2 x with the initial values (x_0, 0) and (0, omega_0 x_0)."""
    starts = ((x0, 0), (0, w0 * x0))
    solves = [vanishes(sympy.diff(motion, t, 2) + w0**2 * motion) for motion in form]
    values = [same(motion.subs(t, 0), a) for motion, (a, _) in zip(form, starts)]
    speeds = [same(sympy.diff(motion, t).subs(t, 0), u) for motion, (_, u) in zip(form, starts)]
    return all_confirmed(*solves, *values, *speeds)


@statement(
    id="lelas2024:claim.frequency-unchanged", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="In the weak regime the frequency stays approximately that of the undamped system", order="2",
    latex=r"\text{the frequency and the initial phase remain approximately the same as in the undamped case}",
    printed=2, near_miss=1, conditions="viscous damping, exact frequency sqrt(omega_0^2 - b^2/(4m^2))",
    methods=("series of the exact frequency in b",),
    note="For friction the frequency is exactly omega_0. For the phase see claim.initial-phase. Form: the"
    " order in b of the relative change of the frequency.",
)
def frequency_unchanged(order: int) -> Outcome:
    """The first power of b in the expansion of the exact frequency at b = 0."""
    exact = sympy.sqrt(1 - b**2 / (4 * m**2 * w0**2))
    derivatives = [sympy.diff(exact, b, j).subs(b, 0) for j in (1, 2)]
    first = next(j for j, value in enumerate(derivatives, 1) if value != 0)
    return decided(first == order)


@statement(
    id="lelas2024:claim.initial-phase", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="In the weak regime the initial phase stays approximately that of the undamped system",
    latex=r"\text{the initial phase remain[s] approximately the same as in the undamped case}",
    printed=(1, sympy.oo), near_miss=(2, sympy.oo), conditions="viscous damping, b < 2 m omega_0",
    methods=("phase of the exact motions, expanded in b",),
    note="It changes by b/(2 m omega_0) + ... for the pair (x_0, 0), and not at all for (0, omega_0 x_0). Form: the"
    " order in b of the change for both pairs, infinity for none.",
)
def initial_phase(form: tuple[int, sympy.Expr]) -> Outcome:
    """cos(W t) + (beta/W) sin(W t) has the phase arctan(beta/W), sin(W t) the phase of the undamped sine."""
    beta = b / (2 * m)
    phase = sympy.atan(beta / sympy.sqrt(w0**2 - beta**2))
    lower = [vanishes(sympy.diff(phase, b, order).subs(b, 0)) for order in range(form[0])]
    leading = sympy.diff(phase, b, form[0]).subs(b, 0) if form[0] > 0 else sympy.Integer(0)
    return all_confirmed(*lower, decided(leading.is_nonzero, form[1] == sympy.oo))



@statement(
    id="lelas2024:claim.same-decay", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The amplitude decreases in the same fashion for both pairs of initial conditions",
    latex=r"\text{the amplitude decreases in the same fashion for both pairs}",
    printed=(1, 0), near_miss=(1, 1), conditions="viscous damping, 0 < b < 2 m omega_0",
    methods=("amplitudes of the exact motions",),
    note="Exact for viscous damping; for friction the turning points of the two motions lie on two lines that differ at"
    " second order, see claim.same-decay-friction. Form: the initial state of the second motion in units of (omega_0"
    " x_0, x_0); near miss: a state with more energy.",
)
def same_decay(form: tuple[int, int]) -> Outcome:
    """Exact motion e^(-beta t)(a cos + (u + beta a)/W sin): the squares of the two amplitudes are equal.

    W^2 = omega_0^2 - beta^2.  The first pair has a = x_0, u = 0.
    """
    beta = b / (2 * m)

    def amplitude_squared(a: sympy.Expr, u: sympy.Expr) -> sympy.Expr:
        return a**2 + (u + beta * a) ** 2 / (w0**2 - beta**2)

    second = amplitude_squared(form[1] * x0, form[0] * w0 * x0)
    return same(amplitude_squared(x0, 0), second)


@statement(
    id="lelas2024:8", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="1",
    extent="sampled: 2 points",
    title="The assumed motion of the first pair", latex=r"x_1(t) = x_0f(t)\cos(\omega_0t)",
    printed=(X1, "x1"), near_miss=(f * X1, "x1"), conditions="viscous damping with f = e^{-bt/2m}, times of order 1/b",
    methods=("largest error over a swing at b t = 0.8 m, against the exact motion, two values of b",),
)
@statement(
    id="lelas2024:9", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="1",
    extent="sampled: 2 points",
    title="The assumed motion of the second pair", latex=r"x_2(t) = x_0f(t)\sin(\omega_0t)",
    printed=(X2, "x2"), near_miss=(X1, "x2"), conditions="viscous damping with f = e^{-bt/2m}, times of order 1/b",
    methods=("largest error over a swing at b t = 0.8 m, against the exact motion, two values of b",),
)
def assumed_form(form: tuple[sympy.Expr, str]) -> Outcome:
    """The error with f = exp(-b t/(2m)), which is the paper's own result, falls like b."""
    expression, which = form
    exact = {
        "x1": viscous,
        "x2": lambda eps: viscous(eps, kicked=True),
        "v1": viscous_velocity,
        "v2": lambda eps: viscous_velocity(eps, kicked=True),
    }[which]
    unit = x0 if which.startswith("x") else w0 * x0
    return has_order(1, slow_error(expression.subs(f, EXPONENTIAL), b, exact, unit))


@statement(
    id="lelas2024:10", kind=Kind.IDENTITY, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    derivation="lelas-viscous", line=1,
    title="The velocity of the first pair",
    latex=r"v_1(t) = -\omega_0\left(x_0f(t)\sin(\omega_0t) + x_0\frac{\dot f(t)}{\omega_0}\cos(\omega_0t)\right)",
    corrected_latex=r"v_1(t) = -\omega_0\left(x_0f(t)\sin(\omega_0t) - x_0\frac{\dot f(t)}{\omega_0}\cos(\omega_0t)"
    r"\right)",
    printed=(X1, -w0 * (x0 * f * sin + x0 * slope / w0 * cos)),
    corrected=(X1, -w0 * (x0 * f * sin - x0 * slope / w0 * cos)),
    near_miss=(X1, w0 * (x0 * f * sin - x0 * slope / w0 * cos)), conditions="none", methods=("(8) differentiated",),
    note="The derivative of (8) is -omega_0 x_0 f sin + x_0 f' cos: inside the bracket the second sign is -. A slip of"
    " the paper (nothing in the text garbles a sign elsewhere), without effect, since the term is dropped in (12).",
)
@statement(
    id="lelas2024:11", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The velocity of the second pair",
    latex=r"v_2(t) = \omega_0\left(x_0f(t)\cos(\omega_0t) + x_0\frac{\dot f(t)}{\omega_0}\sin(\omega_0t)\right)",
    printed=(X2, w0 * (x0 * f * cos + x0 * slope / w0 * sin)), derivation="lelas-viscous",
    near_miss=(X2, w0 * (x0 * f * cos - x0 * slope / w0 * sin)), conditions="none", methods=("(9) differentiated",),
)
def velocity(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The time derivative of the displacement."""
    return same(along(form[0]), form[1])


@statement(
    id="lelas2024:claim.slope-small", kind=Kind.CLAIM, verdict=Printed.TRANSCRIPTION, evidence=Evidence.PROVED,
    derivation="lelas-viscous", line=2,
    title="The small quantity that lets the second terms of (10) and (11) be dropped",
    latex=r"|f(t)|/\omega_0 \ll 1", corrected_latex=r"|\dot f(t)|/\omega_0 \ll 1", printed=f / w0,
    corrected=-slope / w0, near_miss=-slope, conditions="none", methods=("coefficients of (11)",),
    note="The dot over f is lost: two lines earlier the text has |f'| << omega_0. Form: the ratio, with f' = -r < 0.",
)
def slope_small(form: sympy.Expr) -> Outcome:
    """The coefficient of the dropped sine in (11), divided by -omega_0 x_0, is the small quantity."""
    dropped = sympy.diff(along(X2), slope) * slope / sin
    return same((-dropped / (w0 * x0)).subs(slope, -rate), form.subs(slope, -rate))


@statement(
    id="lelas2024:claim.dropping-the-slope", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lelas-friction", line=19,
    shortfall=Shortfall.CONSEQUENCE,
    title="|f'| << omega_0 is enough to drop f' from the velocities",
    latex=r"|\dot f(t)| \ll \omega_0 \text{ for all } t \text{, thus } v_1(t) = -\omega_0x_0f(t)\sin(\omega_0t)",
    corrected_latex=r"|\dot f(t)| \ll \omega_0f(t)", printed=w0, corrected=w0 * f, near_miss=w0 * f**2,
    conditions="f' is to be small against omega_0 f", methods=("ratio of the two terms of (11)",),
    note="What is dropped must be small against what is kept, omega_0 f, not against omega_0. With (32) |f'| is"
    " constant while f falls to 0: near the stop the dropped term is the larger one however small mu is. For viscous"
    " damping and air |f'|/f does not grow, so that the condition at t = 0 is enough.",
)
def dropping_the_slope(bound: sympy.Expr) -> Outcome:
    """|f'|/bound is the ratio of the amplitudes of the two terms in (11)."""
    full = along(X2)
    kept, dropped = sympy.diff(full, f) * f / cos, sympy.diff(full, slope) * slope / sin
    return same(dropped / kept, slope / bound)


@statement(
    id="lelas2024:12", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="1",
    extent="sampled: 2 points",
    title="The approximate velocity of the first pair", latex=r"v_1(t) = -\omega_0x_0f(t)\sin(\omega_0t)",
    printed=(V1, "v1"), near_miss=(-V1, "v1"), conditions="as for (8)",
    methods=("largest error over a swing at b t = 0.8 m, against the exact motion, two values of b",),
)
@statement(
    id="lelas2024:13", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="1",
    extent="sampled: 2 points",
    title="The approximate velocity of the second pair", latex=r"v_2(t) = \omega_0x_0f(t)\cos(\omega_0t)",
    printed=(V2, "v2"), near_miss=(f * V2, "v2"), conditions="as for (9)",
    methods=("largest error over a swing at b t = 0.8 m, against the exact motion, two values of b",),
)
def assumed_velocity(form: tuple[sympy.Expr, str]) -> Outcome:
    """As for the displacements."""
    return assumed_form(form)


@statement(
    id="lelas2024:claim.initial-amplitude", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="f(0) = 1", latex=r"f(0) = 1", printed=sympy.Integer(1), near_miss=sympy.sqrt(1 + (b / (2 * m * w0)) ** 2),
    conditions="none", methods=("(8) and (13) at t = 0",),
    note="The exact velocity of the assumed x_1 is x_0 f'(0) at t = 0, not 0: the initial condition v_1(0) = 0 is met"
    " by (12) and only to first order by (8).",
)
def initial_amplitude(form: sympy.Expr) -> Outcome:
    """x_1(0) = x_0 and v_2(0) = omega_0 x_0."""
    return all_confirmed(same(X1.subs({t: 0, f: form}), x0), same(V2.subs({t: 0, f: form}), w0 * x0))


@statement(
    id="lelas2024:claim.amplitude-not-negative", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lelas-friction", line=21,
    shortfall=Shortfall.CONSEQUENCE,
    title="f(0) = 1 and f decreasing imply f >= 0 for all t",
    latex=r"f(t) \ge 0 \text{ must also hold, for all } t \ge 0",
    corrected_latex=r"f(t) \ge 0 \text{ for } t \le \tau \text{ in case of (32), for all } t \text{ in case of (20) and"
    r" (45)}",
    printed=("viscous", "friction", "air"), corrected=("viscous", "air"), near_miss=("friction", "air"),
    conditions="an extra premise is needed, for instance that the amplitude tends to 0",
    methods=("limits of the paper's three functions f",),
    note="The inference is not valid, and the paper's own (32) is a counterexample: it decreases, starts from 1 and is"
    " negative after tau. Form: the laws for which f >= 0 for all t.",
)
def amplitude_not_negative(form: tuple[str, ...]) -> Outcome:
    """Each f decreases from 1; its limit decides whether it stays positive."""
    slopes = {
        "viscous": EXPONENTIAL,
        "friction": 1 - mu * g * t / (sympy.sqrt(2) * w0 * x0),
        "air": 1 / (1 + C * w0 * x0 * t / (2 * sympy.sqrt(2) * m)),
    }
    starts = [vanishes(f.subs(t, 0) - 1) for f in slopes.values()]
    falls = [decided(sympy.simplify(sympy.diff(f, t)).is_negative) for f in slopes.values()]
    stays = [sympy.limit(f, t, sympy.oo) >= 0 for f in slopes.values()]
    claimed = [decided(stay if name in form else sympy.Not(stay)) for name, stay in zip(slopes, stays)]
    return all_confirmed(*starts, *falls, *claimed, decided(set(form) <= slopes.keys(), len(set(form)) == len(form)))
