"""Table I: the amplitude for alpha = 0, 1, 3/2, 2, 3, each against (13) with k = m omega_0^2."""

import sympy

from paper_checks.identities import all_confirmed, same
from paper_checks.lancaster2020.model import SI, amplitude, b, k, m, mean, omega0, t, x0, zero
from paper_checks.registry import statement
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

gamma = sympy.gamma
THREE_HALVES, QUARTERS = sympy.Rational(3, 2), sympy.Rational(3, 4)


def fractional(power: sympy.Rational) -> sympy.Expr:
    """The entry for alpha = 3/2 with the given power of pi."""
    root = sympy.sqrt(2 * x0 * omega0)
    return x0 * (1 + 3 * b * t * root * gamma(QUARTERS) ** 2 / (5 * sympy.pi**power * m)) ** -2


def agrees_with_13(form: sympy.Expr, alpha: sympy.Expr) -> Outcome:
    """The entry starts from x0; it and (13), both raised to 1 - alpha: linear in t."""
    ours = sympy.powdenest((form / x0) ** (1 - alpha), force=True)
    theirs = sympy.powdenest((amplitude(alpha) / x0) ** (1 - alpha), force=True)
    reflection = sympy.pi * sympy.sqrt(2) / gamma(QUARTERS)  # Gamma(1/4) Gamma(3/4) = pi sqrt 2
    difference = sympy.expand_func(sympy.gammasimp((ours - theirs).subs(SI))).subs(gamma(QUARTERS / 3), reflection)
    return all_confirmed(same(form.subs(t, 0), x0), zero(difference))  # the power does not see a sign


@statement(
    id="lancaster2020:table1.alpha0", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Table I: dry friction", latex=r"x_0 - \frac{2bt}{\pi m\omega_0}",
    printed=x0 - 2 * b * t / (sympy.pi * m * omega0), near_miss=x0 - b * t / (sympy.pi * m * omega0),
    conditions="t <= pi m omega_0 x0/(2b): later the formula turns negative and its modulus grows without bound",
    methods=("(13) at alpha = 0",),
    note="At t = n pi/omega_0 it is exactly the modulus x0 - 2nb/k of the turning points, until the mass sticks.",
)
def dry_friction(form: sympy.Expr) -> Outcome:
    """(13), and the exact turning amplitudes at the half periods."""
    n = sympy.Symbol("n", positive=True)
    exact = x0 - 2 * n * b / k
    at_turn = form.subs(t, n * sympy.pi / omega0)
    return all_confirmed(agrees_with_13(form, sympy.Integer(0)), same(at_turn, exact.subs(SI)))


@statement(
    id="lancaster2020:table1.alpha1", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Table I: linear damping", latex=r"x_0e^{-\frac{bt}{2m}}", printed=x0 * sympy.exp(-b * t / (2 * m)),
    near_miss=x0 * sympy.exp(-b * t / m), conditions="none", methods=("limit of (13)",),
    note="The limit alpha -> 1 of x0 [1 + (alpha-1) kappa omega_0 t]^(-1/(alpha-1)) is x0 e^(-kappa omega_0 t).",
)
def linear_damping(form: sympy.Expr) -> Outcome:
    """-ln(A/x0) = kappa omega_0 t with kappa = M_2 epsilon, the limit of ln(1 + q c)/q for q -> 0."""
    q, c = sympy.symbols("q c", positive=True)
    limit = sympy.diff(sympy.log(1 + q * c), q).subs(q, 0)  # L'Hospital
    rate = (mean(sympy.Integer(1)) * b * omega0 / k * omega0 * t).subs(SI)
    return same(-sympy.expand_log(sympy.log(form / x0)), limit.subs(c, rate))


@statement(
    id="lancaster2020:table1.alpha3-2", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Table I: alpha = 3/2",
    latex=r"x_0\left[1 + \frac{3bt\sqrt{2x_0\omega_0}\,\Gamma^2\left(\frac{3}{4}\right)}{5\pi^{\frac{3}{2}}m}"
    r"\right]^{-2}",
    printed=fractional(THREE_HALVES), near_miss=fractional(sympy.Integer(1)),
    conditions="none", methods=("(13) at alpha = 3/2", "Gamma(1/4) Gamma(3/4) = pi sqrt 2"),
)
def three_halves(form: sympy.Expr) -> Outcome:
    """(13) at alpha = 3/2."""
    return agrees_with_13(form, THREE_HALVES)


@statement(
    id="lancaster2020:table1.alpha2", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Table I: quadratic damping", latex=r"\frac{x_0}{1 + \frac{4b\omega_0x_0t}{3\pi m}}",
    printed=x0 / (1 + 4 * b * omega0 * x0 * t / (3 * sympy.pi * m)),
    near_miss=x0 / (1 + 8 * b * omega0 * x0 * t / (3 * sympy.pi * m)),
    conditions="none", methods=("(13) at alpha = 2",),
)
def quadratic_damping(form: sympy.Expr) -> Outcome:
    """(13) at alpha = 2."""
    return agrees_with_13(form, sympy.Integer(2))


STRAY = sympy.Symbol("a_0", positive=True)


@statement(
    id="lancaster2020:table1.alpha3", kind=Kind.IDENTITY, verdict=Printed.TRANSCRIPTION, evidence=Evidence.PROVED,
    derivation="lancaster-conditions", line=12,
    title="Table I: cubic damping",
    latex=r"\frac{1 + \frac{3a_0x_0^2}{3\pi m}}{x_0} = \frac{x_0}{\sqrt{1 + \frac{3bkx_0^2t}{4m^2}}}",
    corrected_latex=r"\frac{x_0}{\sqrt{1 + \frac{3bkx_0^2t}{4m^2}}}",
    printed=(
        (1 + 3 * STRAY * x0**2 / (3 * sympy.pi * m)) / x0, x0 / sympy.sqrt(1 + 3 * b * k * x0**2 * t / (4 * m**2)),
    ),
    corrected=(x0 / sympy.sqrt(1 + 3 * b * k * x0**2 * t / (4 * m**2)),),
    near_miss=(x0 / sympy.sqrt(1 + 3 * b * k * x0**2 * t / (8 * m**2)),),
    conditions="none", methods=("(13) at alpha = 3, for each member",),
    note="The left member is a remnant of the entry above: no quantity a_0 occurs in the paper, and it is no length."
    " The right member is (13). Form: the members of the equation, each of which must be A(t).",
)
def cubic_damping(form: tuple[sympy.Expr, ...]) -> Outcome:
    """(13) at alpha = 3, for every member."""
    return all_confirmed(*(agrees_with_13(member, sympy.Integer(3)) for member in form))


ENTRIES = (
    x0 - 2 * b * t / (sympy.pi * m * omega0),
    x0 * sympy.exp(-b * t / (2 * m)),
    fractional(THREE_HALVES),
    x0 / (1 + 4 * b * omega0 * x0 * t / (3 * sympy.pi * m)),
    x0 / sympy.sqrt(1 + 3 * b * k * x0**2 * t / (4 * m**2)),
)


@statement(
    id="lancaster2020:claim.table1", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    slip="'computed form' should read 'computed from'.",
    title="Table I, caption: the entries are computed from (13)",
    latex=r"\text{Approximate time-dependence of oscillation amplitude in low-dissipation limit computed form Eq. (13)"
    r" for } \alpha = 0, 1, \tfrac{3}{2}, 2, 3", printed=ENTRIES,
    near_miss=(*ENTRIES[:3], x0 / (1 + 2 * b * omega0 * x0 * t / (3 * sympy.pi * m)), ENTRIES[4]),
    conditions="alpha = 1 as the limit; the entry for alpha = 3 as its right member reads, see table1.alpha3",
    methods=("(13) at each alpha, the limit at 1",), note="'form' is a slip for 'from'. Form: the five entries.",
)
def computed_from_13(form: tuple[sympy.Expr, ...]) -> Outcome:
    """Each entry by its own check."""
    dry, linear, *others = form
    exponents = (THREE_HALVES, sympy.Integer(2), sympy.Integer(3))
    rest = [agrees_with_13(entry, alpha) for entry, alpha in zip(others, exponents)]
    return all_confirmed(dry_friction(dry), linear_damping(linear), *rest)
