"""Section III, equations (35)-(40): the law of motion, the integrating factors and the first constants S^- and S^+.

A pair of forms is always (falling, rising), the order of the paper's double signs: the upper one belongs to v < 0.
"""

import sympy

from paper_checks.identities import all_confirmed, decided, opposite, same, vanishes
from paper_checks.registry import statement
from paper_checks.smith2012.model import (
    FALLING_FORCE,
    HALF,
    QUARTER,
    RISING_FORCE,
    S_falling,
    S_rising,
    gamma,
    omega,
    physical,
    rate,
    same_polynomial,
    u,
    v,
    w,
    x,
)
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

exp = sympy.exp
TAU = sympy.Symbol("tau", positive=True)
mu = sympy.Function("mu")(x, v)
FORCES = (FALLING_FORCE, RISING_FORCE)
FACTORS = (exp(-2 * gamma * x), exp(2 * gamma * x))
PFAFFIAN = ((v, omega**2 * x - gamma * v**2), (v, omega**2 * x + gamma * v**2))  # coefficients of dv and of dx
SIGN_NOTE = (
    "The upper sign belongs to v < 0 in (36), (37) and (38a), and (38a) prints the factor e^{-2 gamma x} there; (42) "
    "and (50) need it too. The opposite order stands in three places (mu in the text, (38b), (40)), which no "
    "transcription does by accident: a slip of the paper."
)


@statement(
    id="smith2012:35", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The law of motion: damping proportional to the square of the velocity, always opposing it",
    latex=r"m\ddot{x} = \begin{cases} -m\omega^2 x - m\gamma\dot{x}^2, & \dot{x} > 0, \\"
    r" -m\omega^2 x + m\gamma\dot{x}^2, & \dot{x} < 0 \end{cases}",
    variables="gamma is an inverse length, omega the natural frequency", conditions="gamma > 0",
    printed=(-(omega**2) * x + gamma * v**2, -(omega**2) * x - gamma * v**2),
    near_miss=(-(omega**2) * x - gamma * v**2, -(omega**2) * x + gamma * v**2),
    methods=("compared with -omega^2 x - gamma v|v|",),
)
def law_of_motion(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The two lines are -omega^2 x - gamma v|v| with v|v| = -v^2 (falling) and +v^2 (rising)."""
    v_abs_v = (-(v**2), v**2)
    return all_confirmed(*(same(line, -(omega**2) * x - gamma * s) for line, s in zip(form, v_abs_v)))


@statement(
    id="smith2012:claim.damping-opposes-velocity", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The damping term changes sign with v because the damping force always opposes the velocity",
    latex=r"\text{the damping coefficient must change sign whenever } v = 0 \text{, since the damping force always"
    r" opposes the velocity}",
    printed=(gamma, -gamma), near_miss=(gamma, gamma), conditions="gamma > 0",
    methods=("sign of the power of the damping force",),
)
def damping_opposes_velocity(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The power (coefficient v^2) v is -gamma |v|^3 on both half-swings; v stands for |v|, so falling is -v."""
    powers = (form[0] * v**2 * -v, form[1] * v**2 * v)
    return all_confirmed(*(same(power, -gamma * v**3) for power in powers))


@statement(
    id="smith2012:claim.parity-acceleration", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The two equations are related through a parity transformation",
    latex=r"\ddot{x}_{v<0} = -\ddot{x}_{v>0}", printed=-1, near_miss=1,
    conditions="the two sides at mirrored states: a_{v<0}(-x, -v) = -a_{v>0}(x, v)",
    methods=("substitution",), derivation="smith-integrating-factor",
    note="At one and the same state the two accelerations are not opposite; 'through a parity transformation' says so.",
)
@statement(
    id="smith2012:claim.sign-change-solution", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="The solution for v > 0 is obtained from that for v < 0 by simply changing sign",
    latex=r"x_{v>0}(t) = -x_{v<0}(t)", printed=-1, near_miss=1, conditions="initial state mirrored too",
    methods=("substitution",),
)
def mirrored_acceleration(sign: int) -> Outcome:
    """With y = sign x, falling motion of x is rising motion of y: sign a_falling(x, v) = a_rising(sign x, sign v)."""
    mirrored = decided(sign**2 == 1)
    rising = RISING_FORCE.subs({x: sign * x, v: sign * v}, simultaneous=True)
    return all_confirmed(mirrored, same(sign * FALLING_FORCE, rising))


@statement(
    id="smith2012:claim.power-series", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="The power series in t is formally correct",
    latex=r"x(t) = \sum_{n=0}^{\infty} a_nt^n \text{ is, while formally correct, of little help}",
    printed=(-HALF * x * omega**2, x * omega**4 * (1 + 2 * gamma * x) / 24),
    near_miss=(-HALF * x * omega**2, x * omega**4 * (1 + gamma * x) / 24),
    conditions="from rest at x_0 > 0, before the next turning point and within the radius of convergence",
    methods=("substitution in (35), v < 0: powers 0 and 2 of t", "(n+1)(n+2) != 0: each further coefficient follows"),
    note="From rest a_n = 0 for odd n; a_{2k} is (-omega^2)^k x_0 times a polynomial of degree k - 1 in gamma x_0:"
    " how complex that is, is a matter of taste. Each next turning point needs a series of its own. Form: a_2 and a_4,"
    " with x for x_0.",
)
def power_series(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """x'' + omega^2 x - gamma x'^2 through t^3: the power n has (n+1)(n+2) a_{n+2} and known coefficients only."""
    t = sympy.Symbol("t", positive=True)
    series = x + form[0] * t**2 + form[1] * t**4
    first = sympy.diff(series, t)
    residual = sympy.Poly(sympy.diff(first, t) + omega**2 * series - gamma * first**2, t)
    return all_confirmed(*(vanishes(residual.coeff_monomial(t**power)) for power in range(4)))


@statement(
    id="smith2012:36", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The law as Pfaffian forms",
    latex=r"0 = dA = \begin{cases} v\,dv + (\omega^2 x - \gamma v^2)\,dx, & v < 0, \\"
    r" v\,dv + (\omega^2 x + \gamma v^2)\,dx, & v > 0 \end{cases}",
    printed=PFAFFIAN, near_miss=PFAFFIAN[::-1], conditions="along the motion",
    methods=("dx = v dt, dv = a dt",), derivation="smith-integrating-factor",
)
def pfaffian_forms(form: tuple[tuple[sympy.Expr, sympy.Expr], ...]) -> Outcome:
    """(coefficient of dv) a + (coefficient of dx) v = 0 on each branch."""
    return all_confirmed(*(vanishes(dv * a + dx * v) for (dv, dx), a in zip(form, FORCES)))


@statement(
    id="smith2012:claim.not-quadratures", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="The Pfaffian forms (36) do not obey the integrability condition",
    latex=r"\frac{\partial v}{\partial x} \ne \frac{\partial(\omega^2 x \mp \gamma v^2)}{\partial v}",
    printed=(2 * gamma * v, -2 * gamma * v), near_miss=(sympy.Integer(0), sympy.Integer(0)), conditions="gamma > 0",
    methods=("cross derivatives",),
    note="Form: the differences of the cross derivatives; near miss: those of the undamped form, which obeys it.",
)
def not_integrable(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The cross derivatives of (36) differ by the form, which is not zero."""
    defects = [sympy.diff(dv, x) - sympy.diff(dx, v) for dv, dx in PFAFFIAN]
    return all_confirmed(*map(same, defects, form), decided(*(part.is_nonzero for part in form)))


def factor_residual(mu: sympy.Expr, sign: int) -> sympy.Expr:
    """Left minus right side of (37); sign = 1 for the upper signs."""
    force = omega**2 * x - sign * gamma * v**2
    return sympy.diff(mu, x) * v - (sympy.diff(mu, v) * force - sign * 2 * gamma * v * mu)


@statement(
    id="smith2012:37", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The equation of the integrating factors",
    latex=r"\frac{\partial\mu}{\partial x}v = \frac{\partial\mu}{\partial v}(\omega^2 x \mp \gamma v^2)"
    r" \mp 2\gamma v\mu",
    printed=(factor_residual(mu, 1), factor_residual(mu, -1)),
    near_miss=(factor_residual(mu, 1), factor_residual(mu, -1) + 4 * gamma * v * mu),
    conditions="upper signs: v < 0", methods=("integrability condition (13) of mu dA",),
    derivation="smith-integrating-factor",
)
def factor_equation(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """d(mu v)/dx - d(mu (omega^2 x -+ gamma v^2))/dv is the printed residual, for an arbitrary mu(x, v)."""
    integrability = [sympy.diff(mu * dv, x) - sympy.diff(mu * dx, v) for dv, dx in PFAFFIAN]
    return all_confirmed(*(same_polynomial(line, wanted) for line, wanted in zip(form, integrability)))


@statement(
    id="smith2012:claim.integrating-factors", kind=Kind.CLAIM, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    derivation="smith-integrating-factor", line=5,
    title="The simplest integrating factors",
    latex=r"\mu = e^{\pm 2\gamma x}", corrected_latex=r"\mu = e^{\mp 2\gamma x}",
    printed=FACTORS[::-1], corrected=FACTORS, near_miss=(exp(-gamma * x), exp(gamma * x)),
    conditions="upper sign: v < 0, as in (37)", methods=("substitution in (37)",),
    note=SIGN_NOTE + " As an unordered pair of factors the printed statement is right.",
)
def integrating_factors(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """Each factor solves its equation (37), and is 1 at x = 0, where nothing has to be multiplied."""
    solves = [vanishes(factor_residual(factor, sign)) for factor, sign in zip(form, (1, -1))]
    return all_confirmed(*solves, *(same(factor.subs(x, 0), sympy.Integer(1)) for factor in form))


@statement(
    id="smith2012:38a", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The exact differentials of the first constants",
    latex=r"\mu\,dA = dS^{\mp} = (e^{\mp 2\gamma x}v\,dv \mp v^2\gamma e^{\mp 2\gamma x}\,dx)"
    r" + e^{\mp 2\gamma x}\omega^2 x\,dx",
    printed=tuple((e * v, e * (-s * gamma * v**2 + omega**2 * x)) for e, s in zip(FACTORS, (1, -1))),
    near_miss=tuple((e * v, e * (s * gamma * v**2 + omega**2 * x)) for e, s in zip(FACTORS, (1, -1))),
    conditions="upper signs: v < 0", methods=("cross derivatives", "proportional to (36)"),
    derivation="smith-integrating-factor",
)
def exact_differentials(form: tuple[tuple[sympy.Expr, sympy.Expr], ...]) -> Outcome:
    """The forms are closed, and they vanish along the motion, so they are multiples of (36)."""
    closed = [vanishes(sympy.diff(dv, x) - sympy.diff(dx, v)) for dv, dx in form]
    along = [vanishes(dv * a + dx * v) for (dv, dx), a in zip(form, FORCES)]
    return all_confirmed(*closed, *along)


def physical_constants(order: int) -> tuple[sympy.Expr, ...]:
    """(38b) for (S^-, S^+) with the exponent +2 gamma x (order = 1) or -2 gamma x (order = -1) at the upper sign."""
    return tuple(
        exp(order * s * 2 * gamma * x) * (v**2 / 2 - s * omega**2 / (2 * gamma) * (x + s / (2 * gamma)))
        for s in (1, -1)
    )


@statement(
    id="smith2012:38b", kind=Kind.IDENTITY, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    derivation="smith-integrating-factor", line=7,
    title="The first constants of the motion",
    latex=r"S^{\mp} = e^{\pm 2\gamma x}\left[\frac{v^2}{2} \mp \frac{\omega^2}{2\gamma}\left(x \pm \frac{1}{2\gamma}"
    r"\right)\right]",
    corrected_latex=r"S^{\mp} = e^{\mp 2\gamma x}\left[\frac{v^2}{2} \mp \frac{\omega^2}{2\gamma}\left(x \pm"
    r" \frac{1}{2\gamma}\right)\right]",
    printed=physical_constants(1), corrected=physical_constants(-1),
    near_miss=tuple(exp(-s * 2 * gamma * x) * (v**2 / 2 - s * omega**2 / (2 * gamma) * (x - s / (2 * gamma)))
                    for s in (1, -1)),
    conditions="upper signs: v < 0", methods=("gradient compared with (38a)",),
    note=SIGN_NOTE,
)
def first_constants(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The gradient of S is the form (38a)."""
    wanted = [(e * dv, e * dx) for e, (dv, dx) in zip(FACTORS, PFAFFIAN)]
    return all_confirmed(
        *(same(sympy.diff(S, v), dv) for S, (dv, _) in zip(form, wanted)),
        *(same(sympy.diff(S, x), dx) for S, (_, dx) in zip(form, wanted)),
    )


@statement(
    id="smith2012:claim.parity-S", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="S^- and S^+ are related by a parity transformation", latex=r"S^-(-x, -v) = S^+(x, v)",
    printed=1, near_miss=-1, conditions="none", methods=("substitution",), derivation="smith-integrating-factor",
    note="True of (38b) as printed and as corrected: the parity exchanges the exponents as well.",
)
def parity_of_constants(sign: int) -> Outcome:
    """S^-(-x, -v) = sign S^+(x, v) with the constants that are exact integrals of (38a)."""
    S_minus, S_plus = physical_constants(-1)
    return same(S_minus.subs({x: -x, v: -v}, simultaneous=True), sign * S_plus)


@statement(
    id="smith2012:39a", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The dimensionless velocity", latex=r"w = \frac{\gamma v}{\omega}", printed=gamma * v / omega,
    near_miss=gamma * omega * v, methods=("(35) becomes free of constants",), conditions="tau = omega t",
)
def dimensionless_velocity(form: sympy.Expr) -> Outcome:
    """dw/dtau = w^2 - u on the falling half-swing, with u = gamma x."""
    derivative = sympy.diff(form, v) * FALLING_FORCE / omega
    return same(derivative, form**2 - gamma * x)


@statement(
    id="smith2012:39b", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The dimensionless displacement", latex=r"u = \gamma x", printed=gamma * x, near_miss=gamma * omega * x,
    methods=("(35) becomes free of constants",), conditions="tau = omega t",
)
def dimensionless_displacement(form: sympy.Expr) -> Outcome:
    """du/dtau = w and dw/dtau = w^2 - u with w = gamma v/omega."""
    velocity = gamma * v / omega
    return all_confirmed(
        same(sympy.diff(form, x) * v / omega, velocity),
        same(gamma * FALLING_FORCE / omega**2, velocity**2 - form),
    )


@statement(
    id="smith2012:40", kind=Kind.IDENTITY, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    derivation="smith-integrating-factor", line=11,
    title="The first constants in dimensionless form",
    latex=r"\hat{S}^{\mp} = \frac{\gamma^2}{\omega^2}S^{\mp} = e^{\pm 2u}\left(\frac{w^2}{2} \mp \frac{u}{2} -"
    r" \frac{1}{4}\right)",
    corrected_latex=r"\hat{S}^{\mp} = \frac{\gamma^2}{\omega^2}S^{\mp} = e^{\mp 2u}\left(\frac{w^2}{2} \mp \frac{u}{2}"
    r" - \frac{1}{4}\right)",
    printed=tuple(exp(s * 2 * u) * (w**2 / 2 - s * u / 2 - QUARTER) for s in (1, -1)),
    corrected=tuple(exp(-s * 2 * u) * (w**2 / 2 - s * u / 2 - QUARTER) for s in (1, -1)),
    near_miss=tuple(exp(-s * 2 * u) * (w**2 / 2 - s * u / 2 - HALF) for s in (1, -1)),
    conditions="upper signs: v < 0", methods=("(38b) rescaled", "constant along the motion"),
    note=SIGN_NOTE + " (50) prints the right exponents.",
)
def dimensionless_constants(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """gamma^2/omega^2 times (38b) with the exponents of (38a), and constant along the dimensionless motion."""
    scaled = [gamma**2 / omega**2 * S for S in physical_constants(-1)]
    return all_confirmed(
        *(same(physical(S), wanted) for S, wanted in zip(form, scaled)),
        vanishes(rate(form[0], falling=True)),
        vanishes(rate(form[1], falling=False)),
        same(form[0], S_falling(u, w)),
        same(form[1], S_rising(u, w)),
    )


@statement(
    id="smith2012:claim.not-elementary", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    derivation="smith-motion-not-elementary", line=12,
    title="The equation of motion cannot be solved in terms of elementary functions",
    latex=r"\text{this one is problematic because it cannot be solved in terms of elementary functions}",
    printed=None, near_miss=sympy.cos(TAU), conditions="S != 0, as between two turning points, and not at rest",
    methods=("first integral solved for e^{2u} and for u", "substitution of what is proposed"),
    note="Both halves are proved, neither in the paper: the time t(x), the integral (54), is not elementary (see"
    " claim.not-in-tables), and neither is its inverse x(t): u and e^{2u} would enter a tower of exponentials and"
    " logarithms at one step, and with u' either gives the other. Two motions are elementary: rest, u = 0 with"
    " S = -1/4, and u = tau^2/4 - 1/2 with S = 0, which has no turning point before it. Not spoken of: an elementary"
    " relation of x and t, or both as elementary functions of a parameter. Form: an expression u(tau) proposed as the"
    " motion, None if there is said to be none.",
)
def not_elementary(form: sympy.Expr | None) -> Outcome:
    """None: S = S^-(u, w) has one e^{2u} and one u, rational in the rest, as the derivation needs.  An expression:
    whether it is a motion with S != 0, and not rest."""
    if form is not None:
        pace = sympy.diff(form, TAU)
        motion = vanishes(sympy.diff(pace, TAU) - pace**2 + form)
        return all_confirmed(motion, opposite(vanishes(S_falling(form, pace))), opposite(vanishes(pace)))
    S, wave = sympy.symbols("S theta", nonzero=True)
    level = sympy.expand(S_falling(u, w) * exp(2 * u) - S * wave)
    first, second = (sympy.solve(level, letter) for letter in (wave, u))
    return all_confirmed(
        *(vanishes(level.subs({wave: first[0]})), vanishes(level.subs({u: second[0]}))),
        decided(len(first) == len(second) == 1, *(not f.atoms(sympy.Function) for f in first + second)),
    )
