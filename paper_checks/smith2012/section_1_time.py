"""Section I, equations (17)-(24d): the second constant, and the two series for the time by repeated parts.

An integration by parts is checked by differentiating: boundary' + integrand is the integrand it came from.
"""

import sympy

from paper_checks.evidence import sampled
from paper_checks.identities import all_confirmed, decided, same, vanishes
from paper_checks.registry import Shortfall, statement
from paper_checks.smith2012.model import omega, same_polynomial, t, v, x
from paper_checks.smith2012.section_1 import CLOCK, M, along_harmonic, atan, diff
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

That, force = (sympy.Function(name)(x, v) for name in ("T", "f"))
speed = sympy.Function("v")(x)  # v as a function of x
total = sympy.Function("F")(v)  # f(x(v), v) as a function of v
fx, fv, dxdv, acceleration, rate = sympy.symbols("f_x f_v dxdv a xdot")
INNER = diff(total, v) / total**2  # (1/f^2) df/dv
z = sympy.Symbol("z", positive=True)


@statement(
    id="smith2012:17", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The form of the second constant", latex=r"T(x, v; t) = \omega t + \tilde{T}(x, v)",
    printed=omega * t + That, near_miss=omega * t**2 + That,
    conditions="none", methods=("(5): the equation for the rest is free of t",),
    note="omega is here any constant with the dimension of a frequency; in section III it is the natural one.",
)
@statement(
    id="smith2012:18a", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The time derivative of T", latex=r"\frac{\partial T}{\partial t} = \omega", printed=omega * t + That,
    near_miss=omega**2 * t + That, conditions="none", methods=("(17) differentiated",), note="Form: T.",
)
def separated(form: sympy.Expr) -> Outcome:
    """dT/dt is omega, and what is left at t = 0 is a function of x and v alone."""
    return all_confirmed(same(diff(form, t), omega), same(form.subs(t, 0), That))


@statement(
    id="smith2012:18b", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The equation of its other part",
    latex=r"v\frac{\partial T}{\partial x} + \frac{f}{m}\frac{\partial T}{\partial v} = -\omega", printed=-omega,
    near_miss=omega,
    conditions="none", methods=("(17) in (5)", "on the harmonic oscillator"), note="Form: the right side.",
)
def rest_of_second_constant(right: sympy.Expr) -> Outcome:
    """(5) leaves dT/dt + left = 0; the clock of the harmonic oscillator has this left side too."""
    general = same_polynomial(right + diff(omega * t + That, t), sympy.Integer(0))
    left = v * diff(CLOCK, x) - omega**2 * x * diff(CLOCK, v)
    return all_confirmed(general, same(left, right))


@statement(
    id="smith2012:19", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The time as an integral over x", latex=r"t - t_0 = \int_{x_0}^x\frac{dx}{v}", printed=1 / speed,
    near_miss=speed, conditions="v does not change sign in between", methods=("derivative along the motion",),
    note="Form: the integrand, whose rate along the motion is 1.",
)
def time_integral(integrand: sympy.Expr) -> Outcome:
    """d/dt of the integral is the integrand times v."""
    return same_polynomial(integrand * speed, sympy.Integer(1))


DV = diff(speed, x)


def parts_in_x(integrand: sympy.Expr, sign: int = 1) -> tuple[sympy.Expr, sympy.Expr]:
    """Boundary term x/v and an integrand."""
    return sign * x / speed, integrand


@statement(
    id="smith2012:20a", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Integration by parts", printed=parts_in_x(x / speed**2 * DV), near_miss=parts_in_x(-x / speed**2 * DV),
    latex=r"t - t_0 = \frac{x}{v(x)}\Big|_{x_0}^x + \int_{x_0}^x\frac{x}{v^2(x)}\frac{dv}{dx}\,dx",
    conditions="v != 0 at both ends too", methods=("differentiated",),
    note="Not from a turning point: there the boundary term and the integral both diverge.",
)
@statement(
    id="smith2012:20b", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The same with time derivatives", conditions="v != 0 at both ends too", methods=("dv/dt = a, dx/dt = v",),
    latex=r"= \frac{x}{v(x)}\Big|_{x_0}^x + \int_{x_0}^x\frac{x}{v^2(x)}\frac{dv/dt}{dx/dt}\,dx",
    printed=parts_in_x(x / speed**2 * acceleration / rate), near_miss=parts_in_x(x / speed**2 * rate / acceleration),
)
@statement(
    id="smith2012:20c", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The same with the acceleration", conditions="v != 0 at both ends too", methods=("dv/dx = a/v",),
    latex=r"= \frac{x}{v(x)}\Big|_{x_0}^x + \int_{x_0}^x\frac{x}{v^2(x)}\frac{a}{v}\,dx",
    printed=parts_in_x(x / speed**2 * acceleration / speed), near_miss=parts_in_x(x / speed**2 * acceleration),
)
@statement(
    id="smith2012:20d", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The same with the force", conditions="v != 0 at both ends too", methods=("a = f/m",),
    latex=r"= \frac{x}{v(x)}\Big|_{x_0}^x + \int_{x_0}^x\frac{xf(x, v)}{mv^3(x)}dx",
    printed=parts_in_x(x * M * acceleration / (M * speed**3)), near_miss=parts_in_x(x * acceleration / (M * speed**3)),
)
def by_parts_in_x(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """d boundary/dx + integrand = 1/v with a = v dv/dx; f is written as m a."""
    boundary, integrand = form
    along = integrand.subs({acceleration: speed * DV, rate: speed})
    return same_polynomial(sympy.simplify(diff(boundary, x) + along), 1 / speed)


def series(sign: int, scale: sympy.Expr) -> sympy.Expr:
    """The first terms of scale * arctan(z) or, with sign 1, of artanh, to z^9."""
    return sympy.Add(*(scale * sign**j * z ** (2 * j + 1) / (2 * j + 1) for j in range(5)))


@statement(
    id="smith2012:21", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.MEASURED,
    extent="exact, one example",
    title="The infinite series in 1/v", printed=series(-1, 1 / omega), near_miss=series(1, 1 / omega),
    latex=r"t - t_0 = \sum_{n=0}^{\infty}F_n(x, v)\left(\frac{1}{v}\right)^n\Big|_{x_0}^x",
    conditions="where it converges; v != 0",
    methods=("one integration by parts more, for any force and n", "harmonic oscillator: terms to n = 9"),
    note="For the harmonic oscillator F_{2j+1} = (-1)^j omega^{2j} x^{2j+1}/(2j+1), the even ones are 0. Form: first"
    " terms in z = omega x/v.",
)
def series_in_inverse_velocity(form: sympy.Expr) -> Outcome:
    """d(F_n/v^n)/dx = F_n'/v^n - n F_n a/v^(n+2): with F_1 = x, F_(n+2)' = n F_n a the sum leaves but its last term."""
    sampled(("harmonic oscillator",))
    F, n = sympy.Function("F")(x), sympy.Symbol("n", positive=True)
    along = diff(F / speed**n, x).subs(DV, acceleration / speed)
    parts = same(along, diff(F, x) / speed**n - n * F * acceleration / speed ** (n + 2))
    terms = sympy.Poly(form.subs(z, omega * x * z), z)  # z stands for 1/v from here on
    wanted, force = x, -(omega**2) * x
    for number in (1, 3, 5, 7, 9):
        parts = all_confirmed(parts, same(terms.coeff_monomial(z**number), wanted))
        wanted = sympy.integrate(number * wanted * force, x)
    return all_confirmed(parts, decided(terms.degree() == 9))


@statement(
    id="smith2012:claim.hat-T", kind=Kind.CLAIM, verdict=Printed.PARTLY, evidence=Evidence.PROVED,
    derivation="smith-harmonic", line=9,
    shortfall=Shortfall.CONDITION,
    paraphrase=True,
    title="The series (21) is the function that completes (22)", printed=sympy.Integer(1), corrected=omega,
    near_miss=omega**2, latex=r"\sum_nF_n\left(\frac{1}{v}\right)^n\Big|_{x_0}^x = \hat{T}(x, v) - \hat{T}(x_0, v_0)",
    corrected_latex=r"\omega\sum_nF_n\left(\frac{1}{v}\right)^n\Big|_{x_0}^x = \hat{T}(x, v) - \hat{T}(x_0, v_0)",
    conditions="as printed for omega = 1", methods=("harmonic oscillator",),
    note="The series is a time, T-hat an angle. (27c) has the factor. Form: T-hat over the series.",
)
def factor_of_hat(factor: sympy.Expr) -> Outcome:
    """omega t - factor arctan(omega x/v)/omega is constant along the harmonic motion."""
    return vanishes(along_harmonic(omega * t - factor * atan(omega * x / v) / omega))


@statement(
    id="smith2012:22", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.MEASURED,
    extent="exact, one example",
    title="The second constant from the series", printed=-1, near_miss=1,
    latex=r"T(x, v; t) = \omega t - \hat{T}(x, v) = \omega t_0 - \hat{T}(x_0, v_0)",
    conditions="T-hat is omega times the series (21)", methods=("harmonic oscillator",), note="Form: its sign.",
)
def second_constant(sign: int) -> Outcome:
    """omega t + sign omega (t - t_0) has no rate."""
    sampled(("harmonic oscillator",))
    return vanishes(along_harmonic(omega * t + sign * atan(omega * x / v)))


@statement(
    id="smith2012:23", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The time as an integral over v", printed=(dxdv / v, M / total), near_miss=(dxdv / v, total / M),
    latex=r"t - t_0 = \int_{v_0}^v\frac{dx}{dv}\frac{dv}{v} = \int_{v_0}^v\frac{m\,dv}{f(x, v)}",
    conditions="f does not vanish in between", methods=("dx/dv = v/a",),
)
def time_over_velocity(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The rate of both integrals along the motion, integrand times f/m, is 1."""
    return all_confirmed(
        *(same_polynomial((g * total / M).subs(dxdv, M * v / total), sympy.Integer(1)) for g in form)
    )


CHAIN = fx * dxdv + fv


@statement(
    id="smith2012:24a", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Integration by parts over v",
    latex=r"t - t_0 = \frac{mv}{f(x, v)}\bigg|_{v_0}^v + \int_{v_0}^v\frac{mv}{f^2(x, v)}\frac{df}{dv}dv",
    printed=(M * v / total, M * v * INNER), near_miss=(M * v / total, -M * v * INNER),
    conditions="f != 0 on the way, the ends included", methods=("differentiated",),
)
@statement(
    id="smith2012:24b", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The same with partial derivatives",
    latex=r"= \frac{mv}{f(x, v)}\bigg|_{v_0}^v + \int_{v_0}^v\frac{mv}{f^2(x, v)}\left(\frac{\partial f}{\partial x}"
    r"\frac{dx}{dv} + \frac{\partial f}{\partial v}\right)dv",
    printed=(M * v / total, M * v / total**2 * CHAIN), near_miss=(M * v / total, M * v / total**2 * (fx + fv * dxdv)),
    conditions="f != 0 on the way, the ends included", methods=("chain rule",),
)
def by_parts_in_v(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """d boundary/dv + integrand = m/f, where df/dv = f_x dx/dv + f_v."""
    boundary, integrand = form
    chain = integrand.subs(fv, diff(total, v) - fx * dxdv)
    return same_polynomial(sympy.expand(diff(boundary, v) + chain), M / total)


SECOND = fx * M * v / total + fv  # the bracket of (24c)


@statement(
    id="smith2012:24c", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Two steps by parts: the boundary terms",
    latex=r"= \frac{mv}{f(x, v)}\Big|_{v_0}^v + \frac{mv^2}{2}\frac{1}{f^2(x, v)}\left(\frac{\partial f}{\partial x}"
    r"\frac{mv}{f} + \frac{\partial f}{\partial v}\right)\Big|_{v_0}^v",
    printed=(M * v**2 / 2, SECOND, -M * v**2 / 2), near_miss=(M * v**2, SECOND, -M * v**2),
    conditions="together with (24d)", methods=("differentiated",),
    note="For the harmonic oscillator this series is not that of the arctangent term by term: it converges for"
    " v < sqrt(2S/m)/2 only, that of (30), where the power of v in the integrand is kept together, for |v| < omega |x|."
    " Form: factor and bracket of the boundary term, factor of the remaining integral.",
)
@statement(
    id="smith2012:24d", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Two steps by parts: the remaining integral",
    latex=r"-\int_{v_0}^v\frac{mv^2}{2}\frac{d}{dv}\left[\frac{1}{f^2(x, v)}\left(\frac{\partial f}{\partial x}"
    r"\frac{mv}{f} + \frac{\partial f}{\partial v}\right)\right]dv",
    printed=(M * v**2 / 2, SECOND, -M * v**2 / 2), near_miss=(M * v**2 / 2, SECOND, M * v**2 / 2),
    conditions="together with (24c)", methods=("differentiated",),
)
def two_steps(form: tuple[sympy.Expr, sympy.Expr, sympy.Expr]) -> Outcome:
    """d (m v/f + factor H)/dv + rest H' = m/f with H = bracket/f^2, the bracket being df/dv since dx/dv = m v/f."""
    factor, bracket, rest = form
    H = bracket.subs(fv, diff(total, v) - fx * M * v / total) / total**2
    left = diff(M * v / total + factor * H, v) + rest * diff(H, v)
    return same_polynomial(sympy.expand(left), M / total)
