"""Equations (4)-(9): amplitude and phase, the energy and its rate of change.

Dots are symbols here: A and rate stand for A(t) and its derivative at one instant, theta for omega_0 t.
"""

from math import cos, sin

import sympy

from paper_checks.identities import all_confirmed, decided, same, vanishes
from paper_checks.lancaster2020.model import (
    SI,
    alpha,
    amplitude,
    b,
    dimension,
    k,
    kappa,
    m,
    measured_order,
    numeric,
    omega0,
    reaches,
    t,
    v,
    x,
    x0,
    zero,
)
from paper_checks.registry import Shortfall, statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

A = sympy.Function("A", positive=True)(t)
rate = sympy.diff(A, t)
a, r = sympy.symbols("a r", positive=True)  # values of A and of |dA/dt|
theta = sympy.Symbol("theta", positive=True)
THREE_HALVES = sympy.Rational(3, 2)
LAW = (("3/2", "1"),)


@statement(
    id="lancaster2020:claim.phase-at-start", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lancaster-conditions", line=1,
    shortfall=Shortfall.CONDITION,
    title="phi(0) = 0 corresponds to a start from rest",
    latex=r"\varphi(0) = 0 \text{, corresponding to } \dot{x}(0) = 0 \text{ without loss of generality}",
    corrected_latex=r"\varphi(0) = 0 \text{ with } \varphi \text{ constant: } \dot{x}(0) = \dot{A}(0) ="
    r" -\kappa\omega_0 x_0",
    printed=sympy.Integer(0), corrected=-kappa(alpha) * omega0 * x0, near_miss=kappa(alpha) * omega0 * x0,
    conditions="as printed: to lowest order in kappa, or with A and phi defined by (9), x' = -A omega_0"
    " sin(omega_0 t + phi)",
    methods=("derivative of A(t) cos(omega_0 t) at t = 0 with (13)",),
    note="x = A cos(omega_0 t + phi) alone does not define two functions A and phi; with the derivative used in (5) a"
    " start at phi = 0 has the velocity A'(0), which is not zero. 'Without loss of generality' is true from the next"
    " turning point on; going back in time is not always possible (alpha = 2: smith2012:41). Form: x'(0).",
)
def phase_at_start(form: sympy.Expr) -> Outcome:
    """The velocity at t = 0 of the approximate solution with (13)."""
    motion = amplitude(alpha) * sympy.cos(omega0 * t)
    return zero(sympy.diff(motion, t).subs(t, 0) - form)


@statement(
    id="lancaster2020:claim.phase-constant", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="The phase remains equal to its initial value to lowest order in b",
    latex=r"\varphi(t) = \varphi(0) + O(b) \text{ for } \epsilon\omega_0 t \text{ of order } 1",
    printed=-sympy.cos(theta), near_miss=-sympy.sin(theta), conditions="times of the order of 1/(epsilon omega_0)",
    methods=("first-order average of the phase rate",), derivation="symbolic-alpha",
    note="d phi/d tau = -epsilon A^(alpha-1) sin^alpha cos averages to zero, since cos changes sign under theta -> pi -"
    " theta; what remains is Omega_2 = -(alpha/(alpha+1))^2 M_(2 alpha) delta^2. For alpha > 1 the whole lag stays"
    " finite and O(epsilon); for alpha = 1 it grows like epsilon^2 tau/8. Form: d phi/d tau divided by epsilon"
    " A^(alpha-1) sin^alpha.",
)
def phase_constant(form: sympy.Expr) -> Outcome:
    """The form is the phase rate by variation of constants, and odd about theta = pi/2, so that its average vanishes.

    x = A cos(theta), x' = -A sin(theta): A' cos - A phi' sin = 0 and -A' sin - A phi' cos = g, the drag.
    """
    falling, turning, drag = sympy.symbols("A' phi' g")
    equations = (
        falling * sympy.cos(theta) - turning * sympy.sin(theta),
        -falling * sympy.sin(theta) - turning * sympy.cos(theta) - drag,
    )
    rates = sympy.solve(equations, (falling, turning))
    odd = vanishes(sympy.expand_trig(form + form.subs(theta, sympy.pi - theta)))
    return all_confirmed(odd, vanishes(sympy.simplify(rates[turning] / drag - form)))


@statement(
    id="lancaster2020:4", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The energy of the oscillator", latex=r"E(t) = \frac{1}{2}m\dot{x}^2(t) + \frac{1}{2}kx^2(t)",
    printed=m * v**2 / 2 + k * x**2 / 2, near_miss=m * v**2 / 2 + k * x**2,
    conditions="none", methods=("constant for b = 0",), note="Form: E as a function of x and v.",
)
def energy(form: sympy.Expr) -> Outcome:
    """dE/dt = 0 along the undamped motion, and E is the kinetic energy at x = 0."""
    constant = vanishes(sympy.diff(form, x) * v - sympy.diff(form, v) * k * x / m)
    return all_confirmed(constant, same(form.subs(x, 0), m * v**2 / 2))


@statement(
    id="lancaster2020:claim.velocity", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The velocity with a constant phase",
    latex=r"\dot{x} = \dot{A}(t)\cos(\omega_0 t) - A(t)\omega_0\sin(\omega_0 t)",
    printed=rate * sympy.cos(omega0 * t) - A * omega0 * sympy.sin(omega0 * t),
    near_miss=rate * sympy.cos(omega0 * t) + A * omega0 * sympy.sin(omega0 * t),
    conditions="phi = 0 for all time", methods=("product rule",),
)
def velocity(form: sympy.Expr) -> Outcome:
    """The derivative of A(t) cos(omega_0 t)."""
    return vanishes(sympy.diff(A * sympy.cos(omega0 * t), t) - form)


def energy_of_ansatz(sign: int) -> sympy.Expr:
    """(5) with the given sign of the last term; r stands for dA/dt, whatever its sign."""
    ratio = r / (omega0 * a)
    return k * a**2 / 2 * (1 + ratio**2 * sympy.cos(theta) ** 2 + sign * ratio * sympy.sin(2 * theta))


@statement(
    id="lancaster2020:5", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The energy with a constant phase",
    latex=r"E = \frac{1}{2}kA^2(t)\left[1 + \left(\frac{\dot{A}(t)}{\omega_0 A(t)}\right)^2\cos^2(\omega_0 t)"
    r" - \left(\frac{\dot{A}(t)}{\omega_0 A(t)}\right)\sin(2\omega_0 t)\right]",
    printed=energy_of_ansatz(-1), near_miss=energy_of_ansatz(1), conditions="phi = 0 for all time",
    methods=("the velocity inserted in (4)",),
    derivation="lancaster-energy", line=2,
)
def energy_with_amplitude(form: sympy.Expr) -> Outcome:
    """(4) with x = A cos and its derivative."""
    speed = r * sympy.cos(theta) - a * omega0 * sympy.sin(theta)
    wanted = m * speed**2 / 2 + k * (a * sympy.cos(theta)) ** 2 / 2
    return vanishes((form - wanted).subs(SI))


@statement(
    id="lancaster2020:claim.slow-timescale", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lancaster-conditions", line=3,
    shortfall=Shortfall.CONSEQUENCE,
    title="Slow dissipation means slow against the period (below (5))",
    paraphrase=True,
    latex=r"\dot{A} \ll \omega_0 A \text{ means that } \frac{A}{|\dot{A}|} \text{ is large against the period } T_0",
    corrected_latex=r"|\dot{A}| \ll \omega_0 A \text{ means that } \frac{A}{|\dot{A}|} \text{ is large against }"
    r"\frac{1}{\omega_0} = \frac{T_0}{2\pi}",
    printed=2 * sympy.pi / omega0, corrected=1 / omega0, near_miss=sympy.pi / omega0,
    conditions="slow against the period asks 2 pi |A'| << omega_0 A", methods=("time A/|A'| at |A'| = omega_0 A",),
    note="Off by 2 pi, which matters for 'much': at |A'| = omega_0 A/10 the amplitude falls to 0.53 in one period. The"
    " bound of lelas2024:claim.slight-decrease has the same factor. Form: the time that A/|A'| is compared with.",
)
def slow_timescale(form: sympy.Expr) -> Outcome:
    """A/|A'| where the two sides of the condition are equal."""
    return same(form, (a / r).subs(r, omega0 * a))


@statement(
    id="lancaster2020:6", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="1",
    extent="sampled: 2 points",
    title="The energy in the limit of slow dissipation", latex=r"E \simeq \frac{1}{2}kA^2(t)",
    printed=sympy.Rational(1, 2), near_miss=sympy.Rational(5, 9), conditions="|A'| << omega_0 A",
    methods=("exact motion, alpha = 3/2, epsilon = 1/25 and 1/50, A from (13)",),
    note="The neglected term oscillates; its derivative is not small beside the derivative of (6), see (8). Form: the"
    " factor of k A^2.",
)
def slow_energy(form: sympy.Expr) -> Outcome:
    """The error of E at epsilon tau about 1 falls like epsilon."""
    A_of = numeric(amplitude(alpha), THREE_HALVES)
    factor = float(form)
    return reaches(measured_order(LAW, lambda e, s, X, V: (X**2 + V**2) / 2 - factor * A_of(e, s) ** 2), 1)


@statement(
    id="lancaster2020:7", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The rate of change of the energy",
    latex=r"\dot{E} = \dot{x}[m\ddot{x} + kx] = f_{\alpha}(\dot{x})\dot{x}",
    printed=1, near_miss=-1, conditions="none", methods=("(4) differentiated, (1) inserted",),
    note="Never positive: f v = -b|v|^(alpha+1). Form: the coefficient of f v.",
    derivation="lancaster-energy", line=5,
)
def energy_rate(form: int) -> Outcome:
    """dE/dt along (1)."""
    f = sympy.Symbol("f", positive=True)
    E = m * v**2 / 2 + k * x**2 / 2
    derivative = sympy.diff(E, x) * v + sympy.diff(E, v) * (f - k * x) / m
    return vanishes(derivative - form * f * v)


@statement(
    id="lancaster2020:claim.energy-derivative", kind=Kind.IDENTITY, verdict=Printed.TRANSCRIPTION,
    derivation="lancaster-energy", line=6,
    evidence=Evidence.PROVED, title="The time derivative of (6)",
    latex=r"E = kAA", corrected_latex=r"\dot{E} = kA\dot{A}", printed=k * A * A, corrected=k * A * rate,
    near_miss=k * A * rate / 2, conditions="none", methods=("(6) differentiated",),
    note="The dots of E and of the second A were lost; (8) has them. Form: the right side.",
)
def derivative_of_slow_energy(form: sympy.Expr) -> Outcome:
    """d(k A^2/2)/dt."""
    return vanishes(sympy.diff(k * A**2 / 2, t) - form)


@statement(
    id="lancaster2020:8", kind=Kind.IDENTITY, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="lancaster-literal-average", line=2,
    shortfall=Shortfall.CONDITION,
    title="The equation for the amplitude", latex=r"kA\dot{A} = f_{\alpha}(\dot{x})\dot{x}",
    corrected_latex=r"kA\dot{A}\,[1 - \cos(2\omega_0 t)] \simeq f_{\alpha}(\dot{x})\dot{x} \text{ for } x ="
    r" A\cos\omega_0 t; \quad kA\dot{A} = f_{\alpha}(\dot{x})\dot{x} \text{ for } A = \sqrt{2E/k}",
    printed=sympy.Integer(1), corrected=1 - sympy.cos(2 * theta), near_miss=1 + sympy.cos(2 * theta),
    conditions="as printed: exact if A means sqrt(2E/k), that is, for x' = -A omega_0 sin(omega_0 t + phi)",
    methods=("(5) differentiated, terms of first order in A'",),
    note="With the constant phase of (4)-(6) the derivative of the neglected term, -k A A' cos(2 omega_0 t), is as"
    " large as the one kept. Averaged literally, that ansatz would give (alpha+1)/(2 alpha) times the right decay rate"
    " for alpha != 1. With A = sqrt(2E/k) the equation is exact, and (10)-(13) follow. Signs are right: both sides"
    " are negative. Form: dE/dt in units of k A A', to first order.",
)
def amplitude_equation(form: sympy.Expr) -> Outcome:
    """d(5)/dt with A'' and A'^2 neglected; then theta' = omega_0."""
    E = k * a**2 / 2 - k * a * r / (2 * omega0) * sympy.sin(2 * theta)
    derivative = sympy.diff(E, theta) * omega0 + sympy.diff(k * a**2 / 2, a) * r
    return vanishes(derivative - form * k * a * r)


@statement(
    id="lancaster2020:claim.energy-amplitude", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="Sign of (8): the amplitude never grows", latex=r"kA\dot{A} = -b|\dot{x}|^{\alpha+1} \le 0",
    printed=-b * v ** (alpha + 1), near_miss=b * v ** (alpha + 1), conditions="b > 0",
    methods=("f_alpha inserted in (8), both signs of the velocity",), note="Form: f v, with v = |x'|.",
)
def dissipation(form: sympy.Expr) -> Outcome:
    """-b x' |x'|^(alpha-1) x' for x' = v and x' = -v."""
    return all_confirmed(*(zero(-b * (s * v) * v ** (alpha - 1) * (s * v) - form) for s in (1, -1)))


@statement(
    id="lancaster2020:claim.slow-dissipation", kind=Kind.DEFINITION, verdict=Printed.TRANSCRIPTION,
    derivation="lancaster-energy", line=3,
    evidence=Evidence.PROVED, title="The limit of slow dissipation (above (9))",
    latex=r"\text{the limit of slow dissipation } (A \ll \omega_0 A)",
    corrected_latex=r"|\dot{A}| \ll \omega_0 A", printed=A, corrected=rate, near_miss=sympy.diff(A, t, 2),
    conditions="none", methods=("dimension",),
    note="The dot was lost; it stands where the limit is introduced, below (5). There the modulus is missing, since A'"
    " is negative; (14) has it. Form: the left side.",
)
def slow_dissipation(form: sympy.Expr) -> Outcome:
    """Both sides must have the dimension of a velocity: each time derivative divides by a time."""
    derivatives = form.derivative_count if isinstance(form, sympy.Derivative) else 0
    return decided(form.has(A) and derivatives == 1)


@statement(
    id="lancaster2020:9", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED, order="1",
    extent="sampled: 2 points",
    title="The velocity in the limit of slow dissipation", latex=r"\dot{x}(t) \approx -A\omega_0\sin[\omega_0 t]",
    printed=-1, near_miss=1, conditions="|A'| << omega_0 A; omega_0 t up to the order of 1/epsilon",
    methods=("exact motion, alpha = 3/2, epsilon = 1/25 and 1/50, A from (13)",),
    note="Below (19) the paper writes it without the minus sign. Form: the sign.",
)
def slow_velocity(form: int) -> Outcome:
    """The error of the velocity at epsilon tau about 1 falls like epsilon."""
    A_of = numeric(amplitude(alpha), THREE_HALVES)
    return reaches(measured_order(LAW, lambda e, s, X, V: V - form * A_of(e, s) * sin(s)), 1)


@statement(
    id="lancaster2020:claim.ansatz", kind=Kind.APPROXIMATION, verdict=Printed.HOLDS, evidence=Evidence.MEASURED,
    extent="sampled: 2 points",
    order="1", title="The approximate solution of the captions", latex=r"x_a(t) = A(t)\cos(\omega_0 t)",
    printed=sympy.Integer(0), near_miss=sympy.Rational(1, 10), conditions="omega_0 t up to the order of 1/epsilon",
    methods=("exact motion, alpha = 3/2, epsilon = 1/25 and 1/50, A from (13)",), note="Form: the phase.",
)
def approximate_solution(form: sympy.Expr) -> Outcome:
    """The error of the displacement at epsilon tau about 1 falls like epsilon."""
    A_of, phase = numeric(amplitude(alpha), THREE_HALVES), float(form)
    return reaches(measured_order(LAW, lambda e, s, X, V: X - A_of(e, s) * cos(s + phase)), 1)


@statement(
    id="lancaster2020:claim.expansion-parameter", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The dimensionless damping coefficient", latex=r"\frac{b\omega_0^{\alpha}}{kx_0^{1-\alpha}}",
    printed=b * omega0**alpha / (k * x0 ** (1 - alpha)), near_miss=b * omega0**alpha / (k * x0 ** (alpha - 1)),
    conditions="none", methods=("(1) rescaled by x0 and omega_0", "dimension"), derivation="symbolic-alpha",
    note="At late times the expansion is in its local value, with A in the place of x0.",
)
def expansion_parameter(form: sympy.Expr) -> Outcome:
    """The damping acceleration in units of omega_0^2 x0, for the velocity V omega_0 x0, is form V^alpha."""
    V = sympy.Symbol("V", positive=True)
    scaled = b * (V * omega0 * x0) ** alpha / m / (omega0**2 * x0)
    return all_confirmed(same(dimension(form), sympy.Integer(1)), zero((scaled - form * V**alpha).subs(SI)))
