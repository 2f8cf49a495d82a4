"""Section II, equations (25)-(34): the harmonic and the viscously damped oscillator.

The viscous law is x'' = -omega_0^2 x - 2 gamma v; gamma is a rate here, and omega the damped frequency.
"""

import sympy

from paper_checks.identities import all_confirmed, limit_is, same, vanishes
from paper_checks.registry import Shortfall, statement
from paper_checks.smith2012.model import gamma, omega, same_polynomial, t, v, x
from paper_checks.smith2012.section_1 import CLOCK, ENERGY, SOLVED, M, S_value, T_value, along_harmonic, atan, diff
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

omega0 = sympy.Symbol("omega_0", positive=True)
speed = sympy.Function("v")(x)
real_z = sympy.Symbol("z", real=True)
OTHER_CLOCK = omega * t + atan(v / (omega * x))
P = v + gamma * x


@statement(
    id="smith2012:25", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The simple harmonic oscillator", latex=r"m\dot{v} = -m\omega^2x", printed=-(omega**2) * x,
    near_miss=omega**2 * x, conditions="none", methods=("x = sin(omega t)",), note="Form: the acceleration.",
)
def harmonic_oscillator(form: sympy.Expr) -> Outcome:
    """The acceleration of sin(omega t)."""
    motion = sympy.sin(omega * t)
    return same(diff(motion, t, 2), form.subs(x, motion))


@statement(
    id="smith2012:26", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Its first constant",
    latex=r"S = \frac{1}{2}m(v^2 + \omega^2x^2) = \frac{1}{2}m(v_0^2 + \omega^2x_0^2)", printed=ENERGY,
    near_miss=M * (v**2 + omega * x**2) / 2, conditions="none", methods=("(12) with mu = 1: gradient and rate",),
)
def first_constant(form: sympy.Expr) -> Outcome:
    """dS = m v dv + m omega^2 x dx, and the rate along the motion is 0."""
    return all_confirmed(
        same(diff(form, v), M * v), same(diff(form, x), M * omega**2 * x), vanishes(along_harmonic(form))
    )


@statement(
    id="smith2012:27a", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The time by parts", methods=("differentiated, dv/dx = -omega^2 x/v",), conditions="v != 0, also at the ends",
    latex=r"t - t_0 = \frac{x}{v}\Big|_{x_0}^x + \int_{x_0}^x\frac{x}{v^2(x)}\frac{-\omega^2x}{v}\,dx",
    printed=(x / speed, -(omega**2) * x**2 / speed**3), near_miss=(x / speed, omega**2 * x**2 / speed**3),
)
@statement(
    id="smith2012:27b", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The next step", methods=("differentiated, dv/dx = -omega^2 x/v",), conditions="v != 0, the ends included",
    latex=r"= \frac{x}{v}\Big|_{x_0}^x - \frac{1}{3}\frac{\omega^2x^3}{v^3}\Big|_{x_0}^x +"
    r" \int_{x_0}^x\frac{\omega^4x^4}{v^5}dx",
    printed=(x / speed - omega**2 * x**3 / (3 * speed**3), omega**4 * x**4 / speed**5),
    near_miss=(x / speed - omega**2 * x**3 / (3 * speed**3), -(omega**4) * x**4 / speed**5),
)
def harmonic_by_parts(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """d boundary/dx + integrand = 1/v."""
    boundary, integrand = form
    derivative = diff(boundary, x).subs(diff(speed, x), -(omega**2) * x / speed)
    return same_polynomial(derivative + integrand, 1 / speed)


@statement(
    id="smith2012:27c", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The series of the harmonic oscillator", methods=("remainder after N terms, differentiated",),
    latex=r"\omega(t - t_0) = \frac{\omega x}{v}\Big|_{x_0}^x - \frac{1}{3}\frac{\omega^3x^3}{v^3}\Big|_{x_0}^x +"
    r" \frac{1}{5}\frac{\omega^5x^5}{v^5}\Big|_{x_0}^x - \dots",
    printed=-1, near_miss=1, conditions="|omega x/v| <= 1 at both ends", note="Form: the ratio of signs.",
)
def harmonic_series(sign: int) -> Outcome:
    """d(sum of N terms)/dz = (1 - q^N)/(1 - q) with q = sign z^2, for every N; if 1 - q = 1 + z^2, q^N is left."""
    z = omega * x / speed
    j, ratio, N, q = sympy.symbols("j z N q", positive=True)
    geometric = (1 - q**N) / (1 - q)
    return all_confirmed(
        same(diff(ratio ** (2 * j + 1) / (2 * j + 1), ratio), ratio ** (2 * j)),
        same(geometric.subs(N, N + 1) - geometric, q**N),
        same(1 - sign * ratio**2, 1 + ratio**2),
        same_polynomial(diff(z, x).subs(diff(speed, x), -(omega**2) * x / speed), (1 + z**2) * omega / speed),
    )


@statement(
    id="smith2012:claim.convergence-of-27c", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The series converges for (omega x/v)^2 < 1", printed=1, near_miss=2,
    latex=r"\text{The sequence converges for } (\omega x/v)^2 < 1",
    conditions="none", methods=("ratio of successive terms",),
    note="It converges at (omega x/v)^2 = 1 as well, but not beyond: up to a phase of pi/4 from the passage of x = 0;"
    " the arctangent in (28) is a continuation. Form: the square of the radius of convergence.",
)
def convergence(radius: int) -> Outcome:
    """The limit of (2j+1)/(2j+3) is the inverse of the square of the radius."""
    j = sympy.Symbol("j", positive=True)
    return limit_is((2 * j + 1) / (2 * j + 3), j, sympy.oo, sympy.Rational(1, radius))


@statement(
    id="smith2012:28", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The second constant",
    latex=r"T(x, v; t) = \omega t - \tan^{-1}\left(\frac{\omega x}{v}\right) = \omega t_0 -"
    r" \tan^{-1}\left(\frac{\omega x_0}{v_0}\right)",
    printed=CLOCK, near_miss=omega * t + atan(omega * x / v), methods=("rate along the motion",),
    conditions="between two turning points; at a turning point the principal value jumps by pi",
)
def second_constant(form: sympy.Expr) -> Outcome:
    """The rate along the motion; and the clock runs like omega t, (18a)."""
    return all_confirmed(vanishes(along_harmonic(form)), same(diff(form, t), omega))


@statement(
    id="smith2012:29", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The half period", printed=sympy.pi, near_miss=sympy.pi / 2,
    latex=r"\omega\left(\frac{\tau}{2}\right) = \omega(t_+ - t_-) = \frac{\pi}{2} - \left(-\frac{\pi}{2}\right) = \pi",
    methods=("limits of the arctangent at v -> 0+", "sin(omega t)"), conditions="v > 0 in between",
)
def half_period(form: sympy.Expr) -> Outcome:
    """From x = -A to x = A with v -> 0+ at both ends; sin(omega t) changes its sign after that time."""
    ends = [sympy.limit(atan(side * omega / v), v, 0, "+") for side in (-1, 1)]
    shifted = sympy.sin(omega * (t + form / omega)) + sympy.sin(omega * t)
    return all_confirmed(same(ends[1] - ends[0], form), vanishes(sympy.expand_trig(shifted)))


@statement(
    id="smith2012:30", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The second constant by the other series",
    latex=r"T(x, v; t) = \omega t + \tan^{-1}\left(\frac{v}{\omega x}\right) = \omega t_0 +"
    r" \tan^{-1}\left(\frac{v_0}{\omega x_0}\right)",
    printed=OTHER_CLOCK, near_miss=omega * t - atan(v / (omega * x)), methods=("rate along the motion",),
    conditions="between two passages of x = 0; there the principal value jumps by pi",
)
def second_constant_again(form: sympy.Expr) -> Outcome:
    """As (28)."""
    return second_constant(form)


@statement(
    id="smith2012:31", kind=Kind.IDENTITY, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="smith-harmonic", line=12,
    shortfall=Shortfall.RANGE,
    title="The identity that joins the two constants", printed=(-1, -1), corrected=(-1, 1), near_miss=(1, -1),
    latex=r"\tan^{-1}z = -\frac{\pi}{2} - \tan^{-1}\left(\frac{1}{z}\right)",
    corrected_latex=r"\tan^{-1}z = \mathrm{sgn}(z)\frac{\pi}{2} - \tan^{-1}\left(\frac{1}{z}\right)",
    conditions="as printed for z < 0 with principal values; for z > 0 the sign of pi/2 is +",
    methods=("derivative, value at z = 1 and z = -1",),
    note="z = v/(omega x) is negative on the first quarter of a swing from rest at x_0 > 0, the case in mind; on the"
    " second the other sign holds. Up to multiples of pi both are right. Form: the sign of pi/2 for z < 0 and z > 0.",
)
def arctangent_identity(form: tuple[int, int]) -> Outcome:
    """arctan z + arctan(1/z) has no derivative; its values at z = -1 and z = 1 are sign pi/2."""
    left = atan(real_z) + atan(1 / real_z)
    flat = vanishes(diff(left, real_z))
    values = [same(left.subs(real_z, place), sign * sympy.pi / 2) for place, sign in zip((-1, 1), form)]
    return all_confirmed(flat, *values)


@statement(
    id="smith2012:claim.standard-motion", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="Either form of T gives the standard motion", printed=SOLVED, near_miss=SOLVED.subs(t, -t),
    latex=r"x = \frac{1}{\omega}\sqrt{\frac{2S}{m}}\sin(\omega t - T)",
    conditions="none", methods=("S and T of the motion",),
    note="The exercise left to the reader; with (30) the constant differs by pi/2, so that a cosine appears.",
)
def standard_motion(form: sympy.Expr) -> Outcome:
    """omega x/v = tan(omega t - T) and the energy is S."""
    velocity = diff(form, t)
    angle = omega * t - T_value
    return all_confirmed(
        vanishes(omega * form * sympy.cos(angle) - velocity * sympy.sin(angle)),
        same(ENERGY.subs({x: form, v: velocity}, simultaneous=True), S_value),
    )


def along_viscous(expression: sympy.Expr, squared: sympy.Expr) -> sympy.Expr:
    """d/dt along x'' = -omega_0^2 x - 2 gamma v, where omega^2 is ``squared``, solved for omega_0^2."""
    natural = sympy.solve(squared - omega**2, omega0**2)[0]
    return diff(expression, t) + v * diff(expression, x) + (-natural * x - 2 * gamma * v) * diff(expression, v)


DAMPED = omega0**2 - gamma**2
SPIRAL = M * (P**2 + omega**2 * x**2) / 2 * sympy.exp(2 * gamma / omega * atan(omega * x / P))
SPIRAL_CLOCK = omega * t - atan(omega * x / P)


@statement(
    id="smith2012:32", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    derivation="smith-viscous",
    title="The time-independent constant of the viscously damped oscillator",
    latex=r"S = \frac{1}{2}m[(v + \gamma x)^2 + \omega^2x^2]\exp\left[\frac{2\gamma}{\omega}\tan^{-1}\left("
    r"\frac{\omega x}{v + \gamma x}\right)\right]",
    printed=(SPIRAL, DAMPED), near_miss=(SPIRAL.subs(atan(omega * x / P), -atan(omega * x / P)), DAMPED),
    conditions="x'' = -omega_0^2 x - 2 gamma v, gamma < omega_0; between two zeros of v + gamma x",
    methods=("rate along the motion",),
    note="The law is not printed; S determines it, a = -v S_x/S_v. The principal value jumps by pi where v + gamma x ="
    " 0, and S by the factor e^{2 pi gamma/omega}.",
)
@statement(
    id="smith2012:33", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    derivation="smith-viscous",
    title="The time-dependent constant",
    latex=r"T(x, v; t) = \omega t - \tan^{-1}\left(\frac{\omega x}{v + \gamma x}\right)",
    printed=(SPIRAL_CLOCK, DAMPED), near_miss=(omega * t - atan(omega * x / (v - gamma * x)), DAMPED),
    conditions="x'' = -omega_0^2 x - 2 gamma v, gamma < omega_0; between two zeros of v + gamma x",
    methods=("rate along the motion",),
)
@statement(
    id="smith2012:34", kind=Kind.IDENTITY, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    derivation="smith-viscous", line=2,
    title="The damped frequency", latex=r"\omega = \sqrt{\omega_0^2 + \gamma^2}",
    corrected_latex=r"\omega = \sqrt{\omega_0^2 - \gamma^2}", printed=(SPIRAL_CLOCK, omega0**2 + gamma**2),
    corrected=(SPIRAL_CLOCK, DAMPED), near_miss=(SPIRAL_CLOCK, omega0**2 - gamma**2 / 4),
    conditions="gamma < omega_0", methods=("rate of (33) along the motion",),
    note="With the sign as printed (32) and (33) are not constant; damping lowers the frequency. The text cannot tell"
    " whether print or transcription slipped. Form: (33) and omega^2.",
)
def viscous_constant(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The rate along the viscous motion, omega_0 eliminated; S is the energy at gamma = 0, T runs like omega t."""
    expression, squared = form
    scale = same(diff(expression, t), omega) if expression.has(t) else same(expression.subs(gamma, 0), ENERGY)
    return all_confirmed(scale, vanishes(sympy.simplify(along_viscous(expression, squared))))
