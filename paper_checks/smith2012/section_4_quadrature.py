"""Section IV, equations (53)-(56d): the quadrature of one half-cycle, and the time by repeated integration by parts.

Everything is written for the falling half-cycles (v < 0, n even), whose constant is E = S^-; dx = v dt and dv = a dt
with a = gamma v^2 - omega^2 x.
"""

import sympy

from paper_checks.identities import all_confirmed, decided, opposite, same, vanishes
from paper_checks.registry import statement
from paper_checks.smith2012.model import (
    FALLING_FORCE,
    HALF,
    S_falling,
    gamma,
    omega,
    physical,
    rate,
    u,
    v,
    w,
    x,
)
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

exp, sqrt = sympy.exp, sympy.sqrt
E, dx, dv = sympy.symbols("E dx dv", positive=True)
S_MINUS = omega**2 / gamma**2 * physical(S_falling(u, w))
RADICAND = 2 * exp(2 * gamma * x) * E + omega**2 / gamma * (x + 1 / (2 * gamma))  # v(x)^2
PRINTED_RADICAND = 2 * exp(2 * gamma * x) * E + omega**2 / (2 * gamma) * (x + 1 / (2 * gamma))
NEAR_RADICAND = 2 * exp(2 * gamma * x) * E + omega**2 / gamma * (x + 1 / gamma)
RADICAND_NOTE = (
    "E = e^{-2 gamma x}[v^2/2 - (omega^2/2 gamma)(x + 1/2 gamma)] gives v^2 = 2 e^{2 gamma x} E + (omega^2/gamma)"
    "(x + 1/2 gamma); (72) prints omega^2 x/gamma + omega^2/(2 gamma^2), which is right and contradicts (54), (55). "
    "The factor 2 is lost alike in both, so a slip of the paper."
)


@statement(
    id="smith2012:53", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The constant of half-cycle n in physical units", latex=r"E_n = \frac{\omega^2}{\gamma^2}(\hat{S}-\hat{S}_n)",
    printed=omega**2 / gamma**2, near_miss=gamma**2 / omega**2, methods=("compared with (40)",),
    conditions="n = 0, 1, 2, ... numbers the half-cycles from 0",
    note="Then E_n = S^- (n even) or S^+ (n odd); with the printed exponents of (38b) it would not fit (54).",
)
def energy_scale(form: sympy.Expr) -> Outcome:
    """form times S-hat^- is the integral of (38a) in x and v: its v-derivative is v e^(-2 gamma x)."""
    S = form * physical(S_falling(u, w))
    return same(sympy.diff(S, v), v * exp(-2 * gamma * x))


def velocity_squared(energy: sympy.Expr = E) -> sympy.Expr:
    """v^2 on the level set S^- = energy."""
    V = sympy.Symbol("V")
    return sympy.solve(S_MINUS.subs(v, sqrt(V)) - energy, V)[0]


@statement(
    id="smith2012:54", kind=Kind.IDENTITY, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    derivation="smith-quadrature", line=4,
    title="The quadrature",
    latex=r"\int dt = \int \frac{dx}{\sqrt{2e^{2\gamma x}E_n + \frac{\omega^2}{2\gamma}\left(x +"
    r" \frac{1}{2\gamma}\right)}}",
    corrected_latex=r"\int dt = -\int \frac{dx}{\sqrt{2e^{2\gamma x}E_n + \frac{\omega^2}{\gamma}\left(x +"
    r" \frac{1}{2\gamma}\right)}}",
    printed=1 / sqrt(PRINTED_RADICAND), corrected=-1 / sqrt(RADICAND), near_miss=-1 / sqrt(NEAR_RADICAND),
    conditions="v < 0 (n even); for n odd, x -> -x", methods=("(38b) solved for v", "sign of dx/dt"),
    note=RADICAND_NOTE + " Besides, dx = v dt with v < 0 asks for the minus sign here, unless one integrates over |dx|"
    " as (55) does.",
)
def quadrature(form: sympy.Expr) -> Outcome:
    """dt = dx/v: the form times v(x) = -sqrt(v^2) is 1."""
    return all_confirmed(vanishes(1 / form**2 - velocity_squared()), same(form * sqrt(RADICAND), sympy.Integer(-1)))


@statement(
    id="smith2012:claim.not-in-tables", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    derivation="smith-not-elementary", line=21,
    title="The integral (54) is not found in standard tables",
    latex=r"\text{Eq. (54) is not found in standard tables of integrals}",
    printed=1 / sqrt(RADICAND), near_miss=1 / sqrt(RADICAND.subs(E, 0)),
    conditions="E_n != 0, as between two turning points; tables of elementary integrals",
    methods=("its integrand is that of the derivation", "SymPy's own integrator, which finds the near miss"),
    note="(54) as corrected. By Liouville's theorem no table of elementary integrals has it; what tables of special"
    " functions have is not said. Near miss: E = 0, which every table has. Form: the integrand.",
)
def not_in_tables(form: sympy.Expr) -> Outcome:
    """REFUTED if SymPy finds a primitive; else the integrand of the derivation at u = gamma x, with k != 0."""
    found = None if form.has(exp) else sympy.integrate(form, x)  # it finds nothing with e^(2x) under the root
    if found is not None and not found.has(sympy.Integral):
        return opposite(vanishes(sympy.diff(found, x) - form))
    k = -2 * E * gamma**2 / omega**2
    derived = omega**2 / gamma**2 * (gamma * x + HALF - k * exp(2 * gamma * x))
    return all_confirmed(same(form * sqrt(derived), sympy.Integer(1)), decided(k.is_nonzero))


@statement(
    id="smith2012:55", kind=Kind.IDENTITY, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    derivation="smith-quadrature", line=4,
    title="The duration of the half-cycle",
    latex=r"\frac{\tau}{2} = \int_{x_{\min}}^{x_{\max}} \frac{dx}{\sqrt{2e^{2\gamma x}E_n + \frac{\omega^2}{2\gamma}"
    r"\left(x + \frac{1}{2\gamma}\right)}}",
    corrected_latex=r"\frac{\tau}{2} = \int_{x_{\min}}^{x_{\max}} \frac{dx}{\sqrt{2e^{2\gamma x}E_n +"
    r" \frac{\omega^2}{\gamma}\left(x + \frac{1}{2\gamma}\right)}}",
    printed=1 / sqrt(PRINTED_RADICAND), corrected=1 / sqrt(RADICAND), near_miss=1 / sqrt(NEAR_RADICAND),
    conditions="n even (x_max = u_n/gamma, x_min = u_{n+1}/gamma); for n odd, x -> -x", methods=("(38b) solved for v",),
    note=RADICAND_NOTE,
)
def duration(form: sympy.Expr) -> Outcome:
    """The integrand is 1/|v|: positive, and its inverse square is v^2."""
    return all_confirmed(vanishes(1 / form**2 - velocity_squared()), same(form * sqrt(RADICAND), sympy.Integer(1)))


@statement(
    id="smith2012:claim.periodic-y", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="For a single half-cycle x(t) is one half of a periodic function y(t), got by integrating (54)",
    latex=r"x(t) \text{ is one-half of the periodic function } y(t)",
    printed=w**2 - u, near_miss=-(w**2) - u, conditions="-1/4 < S < 0",
    methods=("S^- is even in w and constant along y'' = y'^2 - y", "two simple zeros of w^2"),
    note="y obeys the falling law for both signs of y'; it is reversible, so the orbit closes. Form: dw/dtau, the near"
    " miss being the true law of the rising half-cycle.",
)
@statement(
    id="smith2012:fig4", kind=Kind.FIGURE, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The phase space plot of y(t): a closed curve", latex=r"\text{Fig. 4. The phase space plot of } y(t)",
    printed=w**2 - u, near_miss=-(w**2) - u, conditions="-1/4 < S < 0",
    methods=("S^- is even in w and constant along y'' = y'^2 - y", "two simple zeros of w^2"),
)
def closed_curve(force: sympy.Expr) -> Outcome:
    """S^- is conserved for both signs of w, even in w, and w^2 = u + 1/2 + 2 S e^(2u) is concave: a closed curve."""
    S = S_falling(u, w)
    level = -sympy.Symbol("l", positive=True)
    squared = u + sympy.Rational(1, 2) + 2 * level * exp(2 * u)
    return all_confirmed(
        vanishes(w * sympy.diff(S, u) + force * sympy.diff(S, w)),
        same(S, S.subs(w, -w)),
        same(S_falling(u, sqrt(squared)), level),
        same(sympy.diff(squared, u, 2), 8 * level * exp(2 * u)),
        vanishes(rate(S, falling=True)),
    )


def along_motion(boundary: sympy.Expr, integrand: sympy.Expr) -> sympy.Expr:
    """d(boundary)/dt + integrand/dt - omega: zero if boundary + int(integrand) is omega (t - t_0)."""
    a = FALLING_FORCE
    total = sympy.diff(boundary, x) * v + sympy.diff(boundary, v) * a
    return total + integrand.subs({dx: v, dv: a}, simultaneous=True) - omega


a, da = FALLING_FORCE, 2 * gamma * v * dv - omega**2 * dx
FIRST = omega * v / a
BY_PARTS = "integration by parts: differentiated along the motion"


@statement(
    id="smith2012:56a", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The time as an integral over the velocity",
    latex=r"\omega(t-t_0) = \int_{v_0}^{v} \frac{\omega\,dv}{\gamma v^2 - \omega^2 x}",
    printed=(sympy.Integer(0), omega * dv / a),
    near_miss=(sympy.Integer(0), omega * dv / (gamma * v**2 + omega**2 * x)),
    conditions="v < 0, and the acceleration does not vanish in between", methods=(BY_PARTS,),
    derivation="smith-time-series",
    slip="The text introduces the chain by (24a); this first line is (23), and it is (56b) that is (24a).",
)
@statement(
    id="smith2012:56b", kind=Kind.IDENTITY, verdict=Printed.TRANSCRIPTION, evidence=Evidence.PROVED,
    derivation="smith-time-series", line=5,
    title="The first integration by parts",
    latex=r"= \frac{\omega v}{\gamma v^2 - \omega^2 x} + \int_{v_0}^{v} \frac{\omega v[2\gamma v\,dv -"
    r" \omega^2\,dx]}{\gamma v(1 - \omega^2\,dx)}",
    corrected_latex=r"= \left.\frac{\omega v}{\gamma v^2 - \omega^2 x}\right|_{v_0}^{v} + \int_{v_0}^{v} \frac{\omega v"
    r"[2\gamma v\,dv - \omega^2\,dx]}{(\gamma v^2 - \omega^2 x)^2}",
    printed=(FIRST, omega * v * da / (gamma * v * (1 - omega**2 * dx))), corrected=(FIRST, omega * v * da / a**2),
    near_miss=(FIRST, -omega * v * da / a**2), conditions="as (56a)", methods=(BY_PARTS,),
    note="A differential in the denominator is no formula: the lines of (56b) and (56c) ran into each other in the"
    " supplied text. The denominator (gamma v^2 - omega^2 x)^2 stands, misplaced, in the next line.",
)
@statement(
    id="smith2012:56c", kind=Kind.IDENTITY, verdict=Printed.TRANSCRIPTION, evidence=Evidence.PROVED,
    derivation="smith-time-series", line=26,
    title="The same with dx eliminated",
    latex=r"\gamma v^2 - \omega^2 x|_{v_0} + \int_{v_0}^{v} (\gamma v^2 - \omega^2 x)^2 + \int_{v_0}^{v}"
    r" \frac{2\gamma\omega v^2\,dv}{(\gamma v^2 - \omega^2 x)^2} - \int_{v_0}^{v} \frac{\omega^3 v^2\,dv}"
    r"{(\gamma v^2 - \omega^2 x)^3}",
    corrected_latex=r"= \left.\frac{\omega v}{\gamma v^2 - \omega^2 x}\right|_{v_0}^{v} + \int_{v_0}^{v}"
    r" \frac{2\gamma\omega v^2\,dv}{(\gamma v^2 - \omega^2 x)^2} - \int_{v_0}^{v} \frac{\omega^3 v^2\,dv}"
    r"{(\gamma v^2 - \omega^2 x)^3}",
    printed=(a, a**2 * dv + 2 * gamma * omega * v**2 * dv / a**2 - omega**3 * v**2 * dv / a**3),
    corrected=(FIRST, 2 * gamma * omega * v**2 * dv / a**2 - omega**3 * v**2 * dv / a**3),
    near_miss=(FIRST, 2 * gamma * omega * v**2 * dv / a**2 - omega**2 * v**2 * dv / a**3),
    conditions="as (56a)", methods=(BY_PARTS,),
    note="The two last integrals are right; what stands before them are the denominators of (56b) without their"
    " numerators, a garbled transcription.",
)
@statement(
    id="smith2012:56d", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The second integration by parts",
    latex=r"= \left.\frac{\omega v}{\gamma v^2 - \omega^2 x}\right|_{v_0}^{v} + \left.\frac{2}{3}\left(\frac{\gamma v}"
    r"{\omega}\right)\frac{\omega^2 v^2}{(\gamma v^2-\omega^2 x)^2}\right|_{v_0}^{v} - \left.\frac{1}{3}"
    r"\frac{\omega^3 v^3}{(\gamma v^2-\omega^2 x)^3}\right|_{v_0}^{v} + \int_{v_0}^{v} \frac{4}{3}\left(\frac{\gamma v}"
    r"{\omega}\right)^3\left(\frac{\omega^4}{\gamma^2}\right)\frac{2\gamma v\,dv - \omega^2\,dx}"
    r"{(\gamma v^2-\omega^2 x)^3} - \int_{v_0}^{v} \frac{\omega^3 v^3(2\gamma v\,dv - \omega^2\,dx)}"
    r"{(\gamma v^2-\omega^2 x)^4}",
    printed=(
        FIRST + 2 * (gamma * v / omega) * omega**2 * v**2 / (3 * a**2) - omega**3 * v**3 / (3 * a**3),
        4 * (gamma * v / omega) ** 3 * omega**4 / gamma**2 * da / (3 * a**3) - omega**3 * v**3 * da / a**4,
    ),
    near_miss=(
        FIRST + 2 * (gamma * v / omega) * omega**2 * v**2 / (3 * a**2) - omega**3 * v**3 / (3 * a**3),
        2 * (gamma * v / omega) ** 3 * omega**4 / gamma**2 * da / (3 * a**3) - omega**3 * v**3 * da / a**4,
    ),
    conditions="as (56a)", methods=(BY_PARTS,), derivation="smith-time-series",
)
def time_by_parts(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """boundary + int(integrand) has the derivative omega along the motion."""
    return vanishes(along_motion(*form))
