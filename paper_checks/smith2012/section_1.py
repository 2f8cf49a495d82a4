"""Section I, equations (1a)-(24d): constants of the motion in general, and the two quadratures for the time.

v(x) or f(x, v) are arbitrary functions wherever the paper leaves them so; M is the mass.
"""

import sympy

from paper_checks.evidence import sampled
from paper_checks.identities import all_confirmed, decided, same, vanishes
from paper_checks.registry import Shortfall, statement
from paper_checks.smith2012.model import omega, same_polynomial, t, v, x
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

M = sympy.Symbol("M", positive=True)
diff, atan = sympy.diff, sympy.atan
QS = sympy.symbols("q1:4")
DOTS = sympy.symbols("qdot1:4")
VS = sympy.symbols("v1:4")
AS = sympy.symbols("a1:4")
k = sympy.Symbol("k", positive=True)  # a damping rate
WAVES = sympy.symbols("k0:7")
S_general = sympy.exp(sympy.Add(*(k * q for k, q in zip(WAVES, (t, *QS)))))  # exponentials span all functions
S_state = sympy.exp(sympy.Add(*(k * q for k, q in zip(WAVES, (t, *QS, *VS)))))
phi = sympy.Function("phi")(*QS)
mu, force = (sympy.Function(name)(x, v) for name in ("mu", "f"))
speed = sympy.Function("v")(x)  # v as a function of x
total = sympy.Function("F")(v)  # f(x(v), v) as a function of v
ENERGY = M * (v**2 + omega**2 * x**2) / 2
CLOCK = omega * t - atan(omega * x / v)
INNER = diff(total, v) / total**2  # (1/f^2) df/dv


def along_harmonic(expression: sympy.Expr) -> sympy.Expr:
    """d/dt along x'' = -omega^2 x, the example on which general forms are tried."""
    return diff(expression, t) + v * diff(expression, x) - omega**2 * x * diff(expression, v)


def dot(gradient: tuple[sympy.Expr, ...], rates: tuple[sympy.Expr, ...]) -> sympy.Expr:
    """The sum of products."""
    return sympy.Add(*(a * b for a, b in zip(gradient, rates)))


def gradient(scalar: sympy.Expr, letters: tuple[sympy.Symbol, ...]) -> tuple[sympy.Expr, ...]:
    """The partial derivatives."""
    return tuple(diff(scalar, letter) for letter in letters)


MOTION = sympy.Function("x")(t)
RATE = sympy.diff(MOTION, t)


@statement(
    id="smith2012:1a", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="A derivative becomes a variable of its own", latex=r"\frac{dx^i}{dt} = y^i", printed=RATE,
    near_miss=omega * MOTION, conditions="none", methods=("differentiated, for any motion",), note="Form: y.",
)
@statement(
    id="smith2012:1b", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Its own derivative is the second one", latex=r"\frac{d^2x^i}{dt^2} = \frac{dy^i}{dt}", printed=RATE,
    near_miss=RATE + omega**2 * t * MOTION, conditions="none", methods=("(1a) differentiated",), note="Form: y.",
)
def first_order_system(form: sympy.Expr) -> Outcome:
    """y = x', and x'' = y', for any motion x(t)."""
    return all_confirmed(same(form, diff(MOTION, t)), same(diff(MOTION, t, 2), diff(form, t)))


CONSTANCY = diff(S_general, t) + dot(gradient(S_general, QS), DOTS)


@statement(
    id="smith2012:2", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The partial differential equation of the constants of the motion",
    latex=r"0 = \frac{\partial S}{\partial t} + \sum_i\frac{\partial S}{\partial q^i}\frac{dq^i}{dt}, \quad"
    r" 1 \le i \le n",
    printed=CONSTANCY, near_miss=2 * diff(S_general, t) - CONSTANCY, conditions="none", methods=("chain rule, n = 3",),
)
def constants_equation(form: sympy.Expr) -> Outcome:
    """The total derivative of S(q(t), t), for S = exp(k_0 t + k.q) with all k."""
    curves = [sympy.Function(f"Q{j}")(t) for j in range(3)]
    on_curve = dict(zip((*QS, *DOTS), (*curves, *(diff(curve, t) for curve in curves))))
    return same_polynomial(form.subs(on_curve), diff(S_general.subs(on_curve), t))


@statement(
    id="smith2012:claim.number-of-constants", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="There are n independent constants, two in one dimension, of which one contains the time",
    latex=r"\text{There are an infinite number of solutions, but only } n \text{ independent solutions}",
    printed=(2, 1), near_miss=(2, 2), conditions="locally, away from equilibria",
    methods=("rank of the gradients, orthogonal to (dq/dt, 1)",),
    note="Gradients of constants are orthogonal to the velocity of (q, t) in n + 1 dimensions, so n at most are"
    " independent; without t there are n - 1. Form, for n = 2: the number with and without explicit time.",
)
def number_of_constants(form: tuple[int, int]) -> Outcome:
    """S and T of the harmonic oscillator attain the bound 2; functions of (x, v) alone are bounded by 1."""
    constant = all_confirmed(*(vanishes(along_harmonic(s)) for s in (ENERGY, CLOCK)))
    gradients = sympy.Matrix([gradient(s, (x, v, t)) for s in (ENERGY, CLOCK)])
    flow = sympy.Matrix([[v, -(omega**2) * x]])
    return all_confirmed(constant, decided((gradients.rank(), len(flow.nullspace())) == form))


@statement(
    id="smith2012:claim.inversion", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="smith-harmonic", line=4,
    shortfall=Shortfall.CONDITION,
    title="Independent constants can be inverted to give the motion", printed=1, corrected=2, near_miss=4,
    latex=r"\text{once } n \text{ independent solutions } S_i(q^i; t) \text{ have been found, they may be inverted}",
    corrected_latex=r"\text{locally: } \frac{\partial(S, T)}{\partial(x, v)} = m\omega \ne 0 \text{, yet } (x, v)"
    r" \text{ and } (-x, -v) \text{ have the same } S \text{ and } T",
    conditions="locally, by the inverse function theorem",
    methods=("on the harmonic oscillator: Jacobian of (26) and (28), states with given S and T",),
    note="The arctangent in (28) is an angle modulo pi; read as the angle of (v, omega x), modulo 2 pi, it leaves one"
    " state. Form: how many states have the given S and T at one time.",
)
def inversion(form: int) -> Outcome:
    """With omega x = v tan(theta): (1 + tan^2) v^2 = 2 S/m has two roots; the Jacobian is nowhere zero."""
    angle, S = sympy.symbols("theta S", positive=True)
    V = sympy.Symbol("V", real=True)
    states = sympy.solve(ENERGY.subs({x: V * sympy.tan(angle) / omega, v: V}) - S, V)
    jacobian = diff(ENERGY, x) * diff(CLOCK, v) - diff(ENERGY, v) * diff(CLOCK, x)
    same_clock = same(CLOCK.subs({x: -x, v: -v}, simultaneous=True), CLOCK)
    return all_confirmed(same(jacobian, M * omega), same_clock, decided(form == len(states)))


@statement(
    id="smith2012:3", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="Newton's second law", latex=r"m\ddot{x}^i = f^i(x^j, \dot{x}^j; t), \quad i, j \le 3", printed=1,
    near_miss=-1, conditions="none", methods=("with f = -m omega^2 x",), note="Form: the sign of the force.",
)
def newton(sign: int) -> Outcome:
    """x = sin(omega t) under the force -M omega^2 x."""
    motion = sympy.sin(omega * t)
    return same(M * diff(motion, t, 2), sign * -M * omega**2 * motion)


@statement(
    id="smith2012:4a", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The first half of the expanded system", latex=r"v^i = \dot{x}^i", printed=RATE, near_miss=omega * MOTION,
    conditions="none", methods=("as for (1a)",), note="Form: v.",
)
def velocity(form: sympy.Expr) -> Outcome:
    """As (1a)."""
    return first_order_system(form)


@statement(
    id="smith2012:4b", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The second half of the expanded system", latex=r"m\dot{v}^i = ma^i = f^i(x^j, v^j; t)", printed=1,
    near_miss=-1, conditions="none", methods=("with f = -m omega^2 x",), note="Form: the sign of the force.",
)
def newton_expanded(sign: int) -> Outcome:
    """As (3)."""
    return newton(sign)


STATE = diff(S_state, t) + dot(gradient(S_state, QS), VS) + dot(gradient(S_state, VS), AS)


@statement(
    id="smith2012:5", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Equation (2) for a particle",
    latex=r"0 = \frac{\partial S}{\partial t} + \sum_{i=1}^3\frac{\partial S}{\partial x^i}v^i +"
    r" \sum_{i=1}^3\frac{\partial S}{\partial v^i}a^i",
    printed=STATE, near_miss=STATE - 2 * dot(gradient(S_state, VS), AS), conditions="none", methods=("chain rule",),
)
def state_equation(form: sympy.Expr) -> Outcome:
    """The total derivative of S(x(t), v(t), t), for S = exp(k_0 t + k.x + l.v) with all k and l; dx/dt = v."""
    places, speeds = ([sympy.Function(f"{name}{j}")(t) for j in range(3)] for name in "XV")
    on_curve = dict(zip((*QS, *VS, *AS), (*places, *speeds, *(diff(s, t) for s in speeds))))
    chain = diff(S_state.subs(on_curve), t).subs(dict(zip([diff(place, t) for place in places], speeds)))
    return same_polynomial(form.subs(on_curve), chain)


CONSERVATIVE = tuple(-diff(phi, q) / M for q in QS)
KINETIC = M * dot(VS, VS) / 2


@statement(
    id="smith2012:6", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="Conservative forces", latex=r"a^i = -\frac{1}{m}\frac{\partial\phi}{\partial x^i}", printed=CONSERVATIVE,
    near_miss=tuple(-a for a in CONSERVATIVE), conditions="none", methods=("the power is -d phi/dt",),
)
def conservative_forces(form: tuple[sympy.Expr, ...]) -> Outcome:
    """m a.v + v.grad phi = 0."""
    return same_polynomial(M * dot(form, VS), -dot(gradient(phi, QS), VS))


POTENTIAL_TERM = -dot(gradient(S_state, VS), gradient(phi, QS)) / M


@statement(
    id="smith2012:7", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Equation (5) for conservative forces",
    latex=r"0 = \frac{\partial S}{\partial t} + \sum_{i=1}^3\frac{\partial S}{\partial x^i}v^i -"
    r" \frac{1}{m}\sum_{i=1}^3\frac{\partial S}{\partial v^i}\frac{\partial\phi}{\partial x^i}",
    printed=POTENTIAL_TERM, near_miss=-POTENTIAL_TERM,
    conditions="none", methods=("(6) in (5)",), note="Form: the last sum.",
)
def conservative_equation(form: sympy.Expr) -> Outcome:
    """(5) with (6), whatever S and phi are."""
    return same_polynomial(STATE.subs(dict(zip(AS, CONSERVATIVE))), STATE.subs(dict.fromkeys(AS, 0)) + form)


@statement(
    id="smith2012:8", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The energy is its immediate time-independent solution",
    latex=r"S = \frac{1}{2}m\sum_{i=1}^3v^iv^i + \phi", printed=KINETIC + phi, near_miss=KINETIC - phi,
    conditions="none", methods=("substitution in (7)",),
)
def energy_is_constant(form: sympy.Expr) -> Outcome:
    """v.grad S - grad phi.grad_v S/m, for an arbitrary phi."""
    change = dot(gradient(form, QS), VS) - dot(gradient(form, VS), gradient(phi, QS)) / M
    kinetic = [same_polynomial(diff(form, speed), M * speed) for speed in VS]  # and S is the energy, no multiple of it
    return all_confirmed(same_polynomial(change, sympy.Integer(0)), *kinetic)


@statement(
    id="smith2012:claim.angular-momentum", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Angular momentum is a constant of central force motion", printed=QS, near_miss=(QS[0], QS[1], -QS[2]),
    latex=r"\text{the case of total angular momentum } L^i \text{ for central force motion}",
    conditions="none", methods=("x cross a = 0",), note="Form: the direction of the force.",
)
def angular_momentum(form: tuple[sympy.Expr, ...]) -> Outcome:
    """d/dt (x cross v) = x cross a."""
    return all_confirmed(*map(vanishes, sympy.Matrix(QS).cross(sympy.Matrix(form))))


path = sympy.Function("x", positive=True)(t)


@statement(
    id="smith2012:9", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="One dimension, no explicit time", latex=r"m\dot{v} = f(x, v)", printed=force / M, near_miss=force,
    conditions="none", methods=("(4b) in one dimension",), note="Form: the acceleration.",
)
def law_in_one_dimension(acceleration: sympy.Expr) -> Outcome:
    """m a = f."""
    return same_polynomial(M * acceleration, force)


@statement(
    id="smith2012:10", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The identity by which it is multiplied", latex=r"v = \dot{x}", printed=diff(path, t),
    near_miss=2 * diff(path, t), conditions="none", methods=("(9) times v dt is (11), differentiated",),
    note="Form: v, for a motion x(t).",
)
def one_dimension(speed: sympy.Expr) -> Outcome:
    """m v v' = m x'' v for the form v, so that m v dv = f dx; and dx = v dt."""
    power = same(M * speed * diff(speed, t), M * diff(path, t, 2) * speed)
    return all_confirmed(same(speed, diff(path, t)), power)


@statement(
    id="smith2012:11", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The law as a Pfaffian form", latex=r"mv\,dv = f(x, v)\,dx", printed=(M * v, -force),
    near_miss=(M * v, force),
    conditions="none", methods=("dx = v dt, dv = f dt/m",), note="Form: coefficients of dv and dx.",
)
@statement(
    id="smith2012:12", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The same with an integrating factor", latex=r"0 = dS = m\mu v\,dv - \mu f(x, v)\,dx",
    printed=(M * mu * v, -mu * force), near_miss=(M * mu * v, mu * force), conditions="mu obeys (13)",
    methods=("dx = v dt, dv = f dt/m",), note="Form: coefficients of dv and dx.",
)
def pfaffian(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The form vanishes along the motion."""
    return same_polynomial(form[0] * force / M, -form[1] * v)


@statement(
    id="smith2012:claim.integrating-factor-exists", kind=Kind.CLAIM, verdict=Printed.PARTLY,
    derivation="smith-viscous", line=11,
    shortfall=Shortfall.CONDITION,
    evidence=Evidence.PROVED, title="Every Pfaffian form in two variables has an integrating factor",
    latex=r"\text{All two-variable Pfaffian forms can be transformed into total integrals by the use of an integrating"
    r" factor}",
    corrected_latex=r"x_1 = x_0e^{-2\pi\gamma/\omega} \ne x_0, \text{ yet } S(x_1, 0) = S(x_0, 0)",
    printed=sympy.Integer(1), corrected=sympy.exp(-2 * sympy.pi * k / omega),
    near_miss=sympy.exp(-sympy.pi * k / omega), conditions="locally, away from points where both coefficients vanish",
    methods=("an orbit of the viscously damped oscillator that comes round",),
    note="Around the equilibrium of (32) there is none. Suppose mu is nowhere zero on a ring around it. On the axis v ="
    " 0, x > 0 then dS = mu omega_0^2 x dx is nowhere zero, so S is strictly monotone in x; but the orbit from (x_0, 0)"
    " comes back at (x_1, 0), and S has the same value there. That is why (32) has an arctangent, which jumps. One loop"
    " integral would not be enough: it speaks of one factor only. Form: x_1/x_0; gamma is written k.",
)
def integrating_factor_exists(form: sympy.Expr) -> Outcome:
    """x = e^(-k t)(cos omega t + (k/omega) sin omega t) starts at rest from 1; at rest again at t = 2 pi/omega."""
    motion = sympy.exp(-k * t) * (sympy.cos(omega * t) + k / omega * sympy.sin(omega * t))
    once = {t: 2 * sympy.pi / omega}
    return all_confirmed(
        vanishes(diff(motion, t, 2) + 2 * k * diff(motion, t) + (omega**2 + k**2) * motion),
        vanishes(diff(motion, t).subs(t, 0)), vanishes(diff(motion, t).subs(once)), same(motion.subs(once), form),
    )


INTEGRABILITY = M * diff(mu * v, x) + diff(mu * force, v)


@statement(
    id="smith2012:13", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The integrability condition",
    latex=r"m\frac{\partial(\mu v)}{\partial x} = -\frac{\partial(\mu f)}{\partial v}", printed=INTEGRABILITY,
    near_miss=M * diff(mu * v, x) - diff(mu * force, v), conditions="none", methods=("cross derivatives of (12)",),
    derivation="smith-integrating-factor", note="It gives (37). Form: left minus right side.",
)
def integrability(form: sympy.Expr) -> Outcome:
    """d(coefficient of dv)/dx - d(coefficient of dx)/dv."""
    return same_polynomial(form, diff(M * mu * v, x) - diff(-mu * force, v))


@statement(
    id="smith2012:14", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.MEASURED,
    extent="exact, one example",
    title="The first constant of the motion", latex=r"S(x, v) = S(x_0, v_0)", printed=ENERGY,
    conditions="along the motion", near_miss=M * (v**2 - omega**2 * x**2) / 2, methods=("on the harmonic oscillator",),
)
@statement(
    id="smith2012:15", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.MEASURED,
    extent="exact, one example",
    title="The second constant of the motion", latex=r"T(x, v; t) = T(x_0, v_0; t_0)", printed=CLOCK,
    near_miss=omega * t + atan(omega * x / v), methods=("on the harmonic oscillator",), conditions="along the motion",
)
def constants(form: sympy.Expr) -> Outcome:
    """The total time derivative of the example, which is the energy, or a clock that runs like omega t (18a)."""
    sampled(("harmonic oscillator",))
    scale = same(diff(form, t), omega) if form.has(t) else same(diff(form, v), M * v)
    return all_confirmed(vanishes(along_harmonic(form)), scale)


S_value, T_value = sympy.symbols("S T", positive=True)
SOLVED = sympy.sqrt(2 * S_value / M) / omega * sympy.sin(omega * t - T_value)


@statement(
    id="smith2012:16", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.MEASURED,
    extent="exact, one example",
    title="The motion from the two constants", printed=SOLVED, near_miss=SOLVED * omega,
    latex=r"x = x\left(S(x_0, v_0), T(x_0, v_0; t_0); t\right)", conditions="v eliminated",
    methods=("on the harmonic oscillator: equation of motion, value of S",),
    note="The exercise of section II: x = sqrt(2S/m)/omega sin(omega t - T).",
)
def motion_from_constants(form: sympy.Expr) -> Outcome:
    """x'' = -omega^2 x, the energy is S, and omega x/v = tan(omega t - T)."""
    sampled(("harmonic oscillator",))
    rate = diff(form, t)
    return all_confirmed(
        vanishes(diff(form, t, 2) + omega**2 * form),
        same(ENERGY.subs({x: form, v: rate}, simultaneous=True), S_value),
        vanishes(omega * form * sympy.cos(omega * t - T_value) - rate * sympy.sin(omega * t - T_value)),
    )
