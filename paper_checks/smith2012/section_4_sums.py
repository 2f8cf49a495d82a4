"""Section IV, equations (64)-(68) and footnote 8: the sums over n at fixed i, and their closed forms for every i.

G_i(z) = sum_n C_i^n z^n; the paper's g_i is w^i G_i.  By (62a), z(1+z^2) G_i' + i G_i = 2 z^2 G_(i-1)', and with
z = tan(theta), c = cos(theta) every G_i is (theta P_i(c) + sin(theta) R_i(c))/sin(theta)^i with polynomials P_i, R_i.

>>> closed_sum(1)
(0, (-2/3)*x^2 + 2/3)
>>> closed_sum(2)[0]
1/6
"""

from functools import cache

import sympy
from flint import fmpq, fmpq_poly

from asymptotics.numbers.bridge import to_fmpq, to_sympy
from paper_checks.identities import all_confirmed, decided, same, vanishes
from paper_checks.registry import statement
from paper_checks.smith2012.model import coefficient, gamma, k, m, n, omega, same_polynomial, v, w, x, z
from paper_checks.smith2012.section_4_coefficients import ROWS, double, sign_power
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

SUMS = 12  # how many closed forms G_i are built explicitly


def at_z(expression: sympy.Expr) -> sympy.Expr:
    """An expression in x and v, written in z and w: v = omega w/gamma, x from z = omega v/(gamma v^2 - omega^2 x)."""
    velocity = omega * w / gamma
    place = (gamma * velocity**2 - omega * velocity / z) / omega**2
    return sympy.simplify(expression.subs({v: velocity, x: place}, simultaneous=True))


def starts_like(expression: sympy.Expr, column: int, order: int = 14) -> Outcome:
    """Whether the Taylor series of an expression in z is sum_n C_column^n z^n, through z^(order - 1)."""
    series = sympy.Poly(sympy.series(expression, z, 0, order).removeO(), z)
    return decided(all(series.coeff_monomial(z**a) == to_sympy(coefficient(a, column)) for a in range(order)))


@statement(
    id="smith2012:64", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The sum over column 0", latex=r"g_0 = \tan^{-1}\left(\frac{\omega v}{\gamma v^2 - \omega^2 x}\right)",
    printed=sympy.atan(omega * v / (gamma * v**2 - omega**2 * x)),
    near_miss=sympy.atan(omega * v / (gamma * v**2 + omega**2 * x)),
    conditions="|z| <= 1 for the series; beyond, by continuation along the motion (then + pi, see below)",
    methods=("differential equation", "Taylor coefficients"), derivation="smith-generating-functions", line=2,
)
def sum_zero(form: sympy.Expr) -> Outcome:
    """(1 + z^2) g_0' = 1 with the right Taylor coefficients."""
    g = at_z(form)
    equation = vanishes((1 + z**2) * sympy.diff(g, z) - 1)
    return all_confirmed(equation, starts_like(g, 0)) if equation == Outcome.CONFIRMED else equation


@statement(
    id="smith2012:65", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The coefficients of column 1",
    latex=r"C_1^n = \begin{cases} \frac{2(n-1)}{n+1}C_0^{n-1} - \frac{n-2}{n+1}C_1^{n-2} = 2\frac{(-1)^{(n-2)/2}}{n+1}"
    r" - \frac{n-2}{n+1}C_1^{n-2}, & n = \text{even}, \\ 0, & n = \text{odd} \end{cases}",
    printed=(2 * (n - 1) / (n + 1), 2 * sign_power(2) / (n + 1), -(n - 2) / (n + 1)),
    near_miss=(2 * (n - 1) / (n + 1), 2 * sign_power(0) / (n + 1), -(n - 2) / (n + 1)),
    conditions="none", methods=(f"rows to n = {ROWS}", "(62a) at i = 1 with (63)"),
    derivation="smith-closed-sum", line=4,
)
def column_one(form: tuple[sympy.Expr, sympy.Expr, sympy.Expr]) -> Outcome:
    """Both members give C_1^n for even n, and C_1^n = 0 for odd n."""
    for a in range(2, ROWS, 2):
        by_left, alone, below = (part.subs(n, a) for part in form)
        tail = below * to_sympy(coefficient(a - 2, 1))
        sums = {by_left * to_sympy(coefficient(a - 1, 0)) + tail, alone + tail}
        if sums != {to_sympy(coefficient(a, 1))}:
            return Outcome.REFUTED
    return decided(not any(coefficient(a, 1) for a in range(1, ROWS, 2)))


@statement(
    id="smith2012:66", premises=(0,),
    kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The hypothesis of the induction", latex=r"C_1^{n-2} = (-1)^{(n-4)/2}\cdot\frac{2}{3}",
    printed=(-2, (-1) ** ((n - 4) / 2) * sympy.Rational(2, 3)), conditions="n even, n >= 4",
    near_miss=(-2, (-1) ** ((n - 2) / 2) * sympy.Rational(2, 3)), methods=(f"rows to n = {ROWS}", "induction step"),
    derivation="smith-footnote-8", line=6,
)
@statement(
    id="smith2012:67", premises=(0,),
    kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The coefficients of column 1 in closed form", latex=r"C_1^n = (-1)^{(n-2)/2}\cdot\frac{2}{3}",
    printed=(0, (-1) ** ((n - 2) / 2) * sympy.Rational(2, 3)), conditions="n even, n >= 2",
    near_miss=(0, (-1) ** ((n - 2) / 2) * sympy.Rational(1, 3)), methods=(f"rows to n = {ROWS}", "induction step"),
    derivation="smith-footnote-8", line=6,
)
def column_one_closed(form: tuple[int, sympy.Expr]) -> Outcome:
    """The value in all rows; and the step 2s/(n+1) - (n-2)/(n+1)(-s)(2/3) = (2/3)s with s = (-1)^((n-2)/2)."""
    shift, value = form
    evens = range(2 - shift, ROWS, 2)
    rows = all(value.subs(n, a) == to_sympy(coefficient(a + shift, 1)) for a in evens)
    two_thirds = sympy.Rational(2, 3)
    step = vanishes(2 / (n + 1) + (n - 2) / (n + 1) * two_thirds - two_thirds)
    return all_confirmed(decided(rows), step)


@statement(
    id="smith2012:claim.induction-start", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True,
    title="It is true for n = 2, hence for all even n", latex=r"C_1^2 = \frac{2}{3}", printed=2, near_miss=3,
    conditions="none",
    methods=("f_2 = (2/3) w", "induction step"),
    derivation="smith-footnote-8", line=6, note="Form: the n where it starts.",
)
def induction_start(start: int) -> Outcome:
    """(67) at the start, and n - 2 = 0 there, so that nothing before it is needed."""
    right_value = to_sympy(coefficient(start, 1)) == ((-1) ** ((n - 2) / 2) * sympy.Rational(2, 3)).subs(n, start)
    return decided(right_value and start - 2 == 0)


@statement(
    id="smith2012:fn8", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The sum of footnote 8",
    latex=r"\sum_{k=0}^{m} \frac{(2k+1)!!}{2^k k!} = \frac{(2m+3)!!}{3(2^m)m!}", conditions="m = 0, 1, 2, ...",
    printed=(double(2 * k + 1) / (2**k * sympy.factorial(k)), double(2 * m + 3) / (3 * 2**m * sympy.factorial(m))),
    near_miss=(double(2 * k + 1) / (2**k * sympy.factorial(k)), double(2 * m + 3) / (2**m * sympy.factorial(m))),
    methods=("telescoping", "m = 0 ... 40"), derivation="smith-footnote-8", line=5,
    note="It does follow from (67): (62b), corrected, at i = 1 is this sum with n = 2m + 2.",
)
def footnote_sum(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The first value and every difference right(m) - right(m-1) = term(m); then partial sums, exactly."""
    term, right = form
    total = sympy.Integer(0)
    for number in range(41):
        total += term.subs(k, number)
        if total != right.subs(m, number):
            return Outcome.REFUTED
    # with D = (2m+1)!!/(2^m m!): right(m) = (2m+3) D/3, right(m-1) = 2m D/3
    return same((2 * m + 3) / sympy.Integer(3) - 2 * m / sympy.Integer(3), sympy.Integer(1))


@statement(
    id="smith2012:68", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The sum over column 1",
    latex=r"g_1 = \frac{2}{3}\frac{\gamma\omega v^3}{[\omega^2v^2 + (\gamma v^2 - \omega^2 x)^2]}",
    printed=2 * gamma * omega * v**3 / (3 * (omega**2 * v**2 + (gamma * v**2 - omega**2 * x) ** 2)),
    near_miss=gamma * omega * v**3 / (3 * (omega**2 * v**2 + (gamma * v**2 - omega**2 * x) ** 2)),
    conditions="|z| < 1 for the series; the closed form continues it to the whole half-cycle",
    methods=("differential equation", "Taylor coefficients"), derivation="smith-generating-functions", line=21,
    note="g_1 includes the factor w = gamma v/omega of (61).",
)
def sum_one(form: sympy.Expr) -> Outcome:
    """G_1 = g_1/w obeys z(1+z^2) G_1' + G_1 = 2 z^2/(1+z^2) and has the right Taylor coefficients."""
    G = sympy.simplify(at_z(form) / w)
    equation = vanishes(z * (1 + z**2) * sympy.diff(G, z) + G - 2 * z**2 / (1 + z**2))
    return all_confirmed(equation, starts_like(G, 1)) if equation == Outcome.CONFIRMED else equation


@cache
def closed_sum(column: int) -> tuple[fmpq_poly, fmpq_poly]:
    """(P_i, R_i), polynomials in c = cos(theta), with sin(theta)^i G_i(tan(theta)) = theta P_i + sin(theta) R_i.

    With P, R those of j = i - 1: P_i' = 2c(1-c^2) P' + 2j c^2 P, and L R_i = (1-c^2) R_i' - c R_i = P_i - known.
    L c^m = m c^(m-1) - (m+1) c^(m+1) reaches every polynomial up to a constant, which fixes the constant of P_i.
    """
    if column == 0:
        return fmpq_poly([1]), fmpq_poly([0])
    j, (P, R) = column - 1, closed_sum(column - 1)
    c, s2 = fmpq_poly([0, 1]), fmpq_poly([1, 0, -1])
    P_next = (2 * c * s2 * P.derivative() + 2 * j * c**2 * P).integral()
    rest = P_next - 2 * s2 * (c * P + (1 - j) * c**2 * R - s2 * c * R.derivative())
    R_next = fmpq_poly([0])
    while (power := rest.degree()) > 0:  # peel the leading term: L c^(power-1) = -power c^power + ...
        step = c ** (power - 1) * (-rest[power] / power)
        R_next += step
        rest -= s2 * step.derivative() - c * step
    return P_next - rest, R_next


def is_closed_sum(column: int) -> bool:
    """Whether theta P_i + sin(theta) R_i has the Taylor coefficients sin(theta)^i sum_n C_i^n z^n, z = tan(theta)."""
    order = 2 * column + 14
    modulus = fmpq_poly([0] * order + [1])
    atan = fmpq_poly([fmpq((-1) ** (p // 2), p) if p % 2 else fmpq(0) for p in range(order)])
    cos = fmpq_poly([to_fmpq_binomial(p // 2) if p % 2 == 0 else fmpq(0) for p in range(order)])
    sin = (fmpq_poly([0, 1]) * cos) % modulus
    P, R = closed_sum(column)
    closed = (atan * composed(P, cos, modulus) + sin * composed(R, cos, modulus)) % modulus
    series = fmpq_poly([to_fmpq(coefficient(a, column)) if a else fmpq(0) for a in range(order)])
    return closed == (composed(fmpq_poly([0] * column + [1]), sin, modulus) * series) % modulus


def to_fmpq_binomial(p: int) -> fmpq:
    """The coefficient of z^(2p) in cos(theta) = (1+z^2)^(-1/2)."""
    value = fmpq(1)
    for j in range(p):
        value *= fmpq(-1 - 2 * j, 2 * (j + 1))
    return value


def composed(outer: fmpq_poly, inner: fmpq_poly, modulus: fmpq_poly) -> fmpq_poly:
    """outer(inner) modulo a power of z, by Horner's rule."""
    value = fmpq_poly([0])
    for power in range(outer.degree(), -1, -1):
        value = (value * inner + outer[power]) % modulus
    return value


@statement(
    id="smith2012:claim.not-identifiable", kind=Kind.CLAIM, verdict=Printed.REFUTED, evidence=Evidence.PROVED,
    title="From i = 2 on the summations do not reduce to readily identifiable functions",
    latex=r"\text{From } i = 2 \text{ on, the summations do not reduce to readily identifiable functions}",
    corrected_latex=r"\sin^i\theta\,\sum_n C_i^n\tan^n\theta = \theta P_i(\cos\theta) + \sin\theta R_i(\cos\theta)"
    r" \quad \text{for every } i",
    printed=1, corrected=sympy.oo, near_miss=2, conditions="P_i, R_i polynomials of parity (-1)^i and (-1)^{i+1}",
    methods=(f"closed forms and Taylor coefficients, i <= {SUMS}", "induction on i: the derivation"),
    derivation="smith-generating-functions", line=11,
    note="Form: the largest i whose sum is elementary. G_i is a rational function of z plus a rational function times"
    " arctan z, for every i; e.g. G_2 = (arctan z/6)(1+z^2)/z^2 + a rational function.",
)
def elementary_up_to(last: sympy.Expr | int) -> Outcome:
    """A closed form for i = last + 1 refutes; all i <= SUMS by construction and the induction step confirm infinity."""
    columns = range(2, SUMS + 1) if last == sympy.oo else (last + 1,)
    image = sympy.powsimp(sympy.expand((1 - z**2) * sympy.diff(z**n, z) - z * z**n))
    step = same_polynomial(image, n * z ** (n - 1) - (n + 1) * z ** (n + 1))
    if step != Outcome.CONFIRMED or not all(is_closed_sum(column) for column in columns):
        return Outcome.UNDECIDED
    return decided(last == sympy.oo)
