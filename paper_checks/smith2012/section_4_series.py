"""Section IV, equations (57)-(61): the time as a double series in w and z = omega v/(gamma v^2 - omega^2 x).

On the falling half-cycle dz/dtau = 1 - 2wz + z^2 and dw/dtau = w/z; so sum f_n(w) z^n = tau is the recurrence (59).

>>> us, ws = time_series_of_motion(Fraction(1), 5)
>>> us[:4]                      # u = 1 - tau^2/2 + ..., from rest at u = 1
[Fraction(1, 1), Fraction(0, 1), Fraction(-1, 2), Fraction(0, 1)]
"""

from fractions import Fraction

import sympy

from asymptotics.numbers.bridge import to_sympy
from paper_checks.evidence import sampled
from paper_checks.identities import all_confirmed, decided, same
from paper_checks.registry import statement
from paper_checks.smith2012.model import (
    Z_OF_STATE,
    coefficient,
    gamma,
    i,
    n,
    omega,
    polynomial_row,
    same_polynomial,
    v,
    w,
    x,
    z,
)
from paper_checks.smith2012.section_3_law import dimensionless_velocity
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

f, df = sympy.Function("f"), sympy.Function("df")  # f(n) is f_n(w), df(n) its derivative
C = sympy.Function("C")  # C(n, i) is C_i^n
ROWS = 24
W_OF_STATE = gamma * v / omega


def time_series_of_motion(start: Fraction, order: int) -> tuple[list[Fraction], list[Fraction]]:
    """Taylor coefficients in tau, through tau^order, of u and w on the falling half-swing from (start, 0), exactly."""
    us, ws = [start], [Fraction(0)]
    for power in range(order):
        square = sum((ws[j] * ws[power - j] for j in range(power + 1)), Fraction(0))
        next_w = (square - us[power]) / (power + 1)
        us.append(ws[power] / (power + 1))
        ws.append(next_w)
    return us, ws


@statement(
    id="smith2012:57", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The second constant of the motion as a series",
    latex=r"T(x,v;t) = \omega t - \sum_{n=1}^{\infty} f_n\left(\frac{\gamma v}{\omega}\right)"
    r"\left(\frac{\omega v}{\gamma v^2-\omega^2 x}\right)^n",
    variables="f_n from (59)", printed=Z_OF_STATE, near_miss=omega * v / (gamma * v**2 + omega**2 * x),
    conditions="falling half-cycles; as a formal power series, and as a function wherever it converges",
    methods=("dz/dtau and (59), all orders", "Taylor series of the motion from rest at u = 1"),
    derivation="smith-time-series", line=7,
    note="It converges for |z| < |2w/(1 + W_0(-e^(2w^2-1)))| and not beyond (motions.invariants.certified), so"
    " never through a whole half-cycle: z is infinite where the acceleration vanishes. Form: z.",
)
def series_is_time(form: sympy.Expr) -> Outcome:
    """d(form)/dtau = 1 - 2wz + z^2; and sum f_n(w) z^n = tau + O(tau^8) on the motion from rest at u = 1."""
    a = gamma * v**2 - omega**2 * x
    speed = (sympy.diff(form, x) * v + sympy.diff(form, v) * a) / omega
    flow = same(speed, 1 - 2 * gamma * v / omega * form + form**2)
    if flow == Outcome.REFUTED:
        return flow
    order = 8
    tau = sympy.Symbol("tau")
    motion = time_series_of_motion(Fraction(1), order)
    position, velocity = (sum(to_sympy(c) * tau**p for p, c in enumerate(cs)) for cs in motion)
    variable = sympy.cancel(form.subs({x: position / gamma, v: velocity * omega / gamma}, simultaneous=True))
    small = sympy.Poly(sympy.series(variable, tau, 0, order).removeO(), tau)
    total = sympy.Poly(0, tau)
    for number in range(1, order):
        row = sum((to_sympy(c) * velocity**j for j, c in enumerate(polynomial_row(number))), sympy.Integer(0))
        total += sympy.Poly(row, tau) * small**number
    truncated = [total.coeff_monomial(tau**p) for p in range(order)]
    return all_confirmed(flow, decided(truncated == [0, 1] + [0] * (order - 2)))


SUBSTITUTED = (  # the four sums of (58): first n, and the coefficient of z^n
    (2, -(n - 1) * f(n - 1)),
    (0, -w * df(n + 1)),
    (0, -(n + 1) * f(n + 1)),
    (1, 2 * w * n * f(n)),
)


@statement(
    id="smith2012:58", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The series substituted into the equation of a constant of the motion",
    latex=r"0 = \omega - \omega\sum_{n=2}^{\infty}(n-1)f_{n-1}\left(\frac{\omega v}{\gamma v^2-\omega^2 x}\right)^n"
    r" - \omega\sum_{n=0}^{\infty}\left(\frac{\gamma v}{\omega}\right)f'_{n+1}\left(\frac{\omega v}{\gamma v^2-"
    r"\omega^2 x}\right)^n - \omega\sum_{n=0}^{\infty}(n+1)f_{n+1}\left(\frac{\omega v}{\gamma v^2-\omega^2 x}\right)^n"
    r" + 2\omega\left(\frac{\gamma v}{\omega}\right)\sum_{n=1}^{\infty}nf_n\left(\frac{\omega v}{\gamma v^2-"
    r"\omega^2 x}\right)^n",
    printed=SUBSTITUTED, near_miss=(*SUBSTITUTED[:3], (1, w * n * f(n))), conditions="formal power series",
    methods=("coefficients of z^-2 ... z^11 of dT/dtau, each linear in n",), derivation="smith-time-series", line=7,
)
def substituted_series(form: tuple[tuple[int, sympy.Expr], ...]) -> Outcome:
    """dT/dtau = 1 - sum_n [w f_n' z^(n-1) + n f_n z^(n-1)(1 - 2wz + z^2)], compared power by power."""
    outcomes = []
    for power in range(-2, 12):
        printed = sum((term.subs(n, power) for first, term in form if power >= first), sympy.Integer(power == 0))
        true = sympy.Integer(power == 0)
        for number in range(1, power + 2):
            expanded = sympy.Poly(z ** (number - 1) * (1 - 2 * w * z + z**2), z).coeff_monomial(z**power)
            derivative = w * df(number) if number - 1 == power else 0
            true -= derivative + number * f(number) * expanded
        outcomes.append(same_polynomial(printed, true))
    return all_confirmed(*outcomes)


@statement(
    id="smith2012:59a", kind=Kind.DEFINITION, verdict=Printed.DEFINITION, evidence=Evidence.PROVED,
    title="The dimensionless velocity again", latex=r"w = \frac{\gamma v}{\omega}", printed=gamma * v / omega,
    near_miss=gamma * omega * v, methods=("(35) becomes free of constants",), conditions="tau = omega t",
)
def dimensionless_velocity_again(form: sympy.Expr) -> Outcome:
    """As (39a)."""
    return dimensionless_velocity(form)


def order_of_58(power: int) -> sympy.Expr:
    """The coefficient of z^power in (58)."""
    return sum((term.subs(n, power) for first, term in SUBSTITUTED if power >= first), sympy.Integer(power == 0))


@statement(
    id="smith2012:59b", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Order zero", latex=r"0 = 1 - f_1 - wf_1'", printed=(1, 1 - f(1) - w * df(1)),
    near_miss=(1, 1 - f(1) + w * df(1)),
    conditions="none", methods=("coefficient of z^0 in (58)",), derivation="smith-time-series", line=10,
    note="f_1 = 1 + c/w; only c = 0 is regular at the turning points. Form: (n, coefficient of z^{n-1}).",
)
@statement(
    id="smith2012:59c", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="Order one", latex=r"0 = wf_2' + 2f_2 - 2wf_1", printed=(2, w * df(2) + 2 * f(2) - 2 * w * f(1)),
    near_miss=(2, w * df(2) + f(2) - 2 * w * f(1)), conditions="none", methods=("coefficient of z^1 in (58)",),
    derivation="smith-time-series", line=9,
)
def low_order(form: tuple[int, sympy.Expr]) -> Outcome:
    """The line is the coefficient in (58), up to the overall sign."""
    number, line = form
    sign = 1 if number == 1 else -1
    return same_polynomial(line, sign * order_of_58(number - 1))


def general_order(sign: int) -> tuple[sympy.Expr, sympy.Expr]:
    """The two lines of (59d), the second expanded; sign = -1 flips its last term."""
    first = (n - 2) * f(n - 2) + w * df(n) + n * f(n) - 2 * w * (n - 1) * f(n - 1)
    product = w**n * df(n) + n * w ** (n - 1) * f(n)  # (w^n f_n)'
    return first, (n - 2) * w ** (n - 1) * f(n - 2) + product - sign * 2 * (n - 1) * w**n * f(n - 1)


@statement(
    id="smith2012:59d", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The general order",
    latex=r"0 = (n-2)f_{n-2} + wf_n' + nf_n - 2w(n-1)f_{n-1} = (n-2)w^{n-1}f_{n-2} + (w^nf_n)' - 2(n-1)w^nf_{n-1}",
    printed=general_order(1), near_miss=general_order(-1), conditions="n >= 3 (n >= 2 with f_0 anything finite)",
    methods=("coefficients of z^{n-1} in (58), n = 3 ... 12, each linear in n",),
    derivation="smith-time-series", line=7,
    slip="The second line is w^{n-1} times the first, not equal to it: both vanish.",
)
def general_recurrence(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """First line: minus the coefficient of z^(n-1) in (58); second line: w^(n-1) times the first."""
    outcomes = []
    for number in range(3, 13):
        first, second = (line.subs(n, number) for line in form)
        outcomes.append(same_polynomial(first, -order_of_58(number - 1)))
        outcomes.append(same_polynomial(second, w ** (number - 1) * first))
    return all_confirmed(*outcomes)


Q = Fraction
Terms = dict[int, Fraction]
POLYNOMIALS = (  # suffix, n, {power: coefficient}, LaTeX, near miss as {power: coefficient}
    ("a", 1, {0: Q(1)}, r"1", {0: Q(-1)}),
    ("b", 2, {1: Q(2, 3)}, r"\frac{2}{3}W", {1: Q(1, 3)}),
    ("c", 3, {2: Q(8, 15), 0: Q(-1, 3)}, r"\frac{8}{15}W^2 - \frac{1}{3}", {2: Q(8, 15), 0: Q(1, 3)}),
    ("d", 4, {3: Q(16, 35), 1: Q(-2, 3)}, r"\frac{16}{35}W^3 - \frac{2}{3}W", {3: Q(16, 35), 1: Q(-2, 5)}),
    ("e", 5, {4: Q(128, 315), 2: Q(-104, 105), 0: Q(1, 5)},
     r"\frac{128}{315}W^4 - \frac{104}{105}W^2 + \frac{1}{5}", {4: Q(128, 315), 2: Q(-103, 105), 0: Q(1, 5)}),
    ("f", 6, {5: Q(256, 693), 3: Q(-176, 135), 1: Q(2, 3)},
     r"\frac{256}{693}W^5 - \frac{176}{135}W^3 + \frac{2}{3}W", {5: Q(256, 693), 3: Q(-176, 135), 1: Q(-2, 3)}),
    ("g", 7, {6: Q(1024, 3003), 4: Q(-1856, 1155), 2: Q(272, 189), 0: Q(-1, 7)},
     r"\frac{1024}{3003}W^6 - \frac{1856}{1155}W^4 + \frac{272}{189}W^2 - \frac{1}{7}",
     {6: Q(1024, 3003), 4: Q(-1856, 1155), 2: Q(271, 189), 0: Q(-1, 7)}),
)


def printed_polynomial(form: tuple[int, Terms]) -> Outcome:
    """(59d) for the printed f_n: w f_n' + n f_n - 2(n-1) w f_(n-1) + (n-2) f_(n-2) = 0 (for n = 1, (59b): = 1)."""
    number, terms = form
    before, twice_before = (polynomial_row(number - j) if number > j else () for j in (1, 2))
    residual = []
    for power in range(number + 1):
        value = (power + number) * terms.get(power, Q(0))
        value -= 2 * (number - 1) * (before[power - 1] if 1 <= power <= len(before) else 0)
        value += (number - 2) * (twice_before[power] if power < len(twice_before) else 0)
        residual.append(value - (number == 1 and power == 0))
    return decided(not any(residual))


def _add_polynomial(suffix: str, number: int, terms: Terms, latex: str, near_miss: Terms) -> None:
    @statement(
        id=f"smith2012:60{suffix}", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
        title=f"The polynomial f_{number}", premises=(0,), printed=(number, terms), near_miss=(number, near_miss),
        latex=f"f_{number} = " + latex.replace("W", r"\left(\frac{\gamma v}{\omega}\right)"),
        conditions="regular at w = 0", methods=("substitution in (59), exact rationals",),
        derivation="smith-time-series", line=10 if number == 1 else 8 + 2 * number,
    )
    def check(form: tuple[int, Terms]) -> Outcome:
        return printed_polynomial(form)


for _polynomial in POLYNOMIALS:
    _add_polynomial(*_polynomial)


@statement(
    id="smith2012:60h", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="f_n is a polynomial of degree n - 1",
    latex=r"f_n = \sum_{i=0}^{n-1} C_i^n\left(\frac{\gamma v}{\omega}\right)^i", printed=(0, n - 1),
    near_miss=(0, n - 2),
    conditions="none", methods=(f"rows to n = {ROWS}", "induction on (59d)"), derivation="smith-time-series", line=24,
    note="C_{n-1}^n is not zero for any n: it is the product of 2(k-1)/(2k-1) over k = 2 ... n. Form: limits of i.",
)
def degree(form: tuple[sympy.Expr | int, sympy.Expr]) -> Outcome:
    """The limits are sharp: nothing outside, and the top coefficient 2(n-1)/(2n-1) C_(n-2)^(n-1) is positive."""
    low, high = form
    for number in range(2, ROWS):
        top = int(high.subs(n, number))
        inside = [coefficient(number, j) for j in range(low, top + 1)]
        if len(inside) != len(polynomial_row(number)) or inside[-1] <= 0:
            return Outcome.REFUTED
    leading = sympy.solve(sympy.Eq(general_order(1)[0].subs({f(n): C(n) * w ** (n - 1), f(n - 2): 0,
                          df(n): C(n) * (n - 1) * w ** (n - 2), f(n - 1): C(n - 1) * w ** (n - 2)}), 0), C(n))
    return same_polynomial(sympy.simplify(leading[0] / C(n - 1)), 2 * (n - 1) / (2 * n - 1))


@statement(
    id="smith2012:61", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.MEASURED,
    extent=f"sampled: {ROWS + 8} points",
    title="The double series, summed over n first",
    latex=r"T(x,v;t) = \omega t - \sum_{i=0}^{\infty}\left(\frac{\gamma v}{\omega}\right)^i\sum_{n=i+1}^{\infty}C_i^n"
    r"\left(\frac{\omega v}{\gamma v^2-\omega^2 x}\right)^n",
    printed=(i + 1, W_OF_STATE**i, Z_OF_STATE**n), near_miss=(i + 2, W_OF_STATE**i, Z_OF_STATE**n),
    conditions="formal power series; as a sum of numbers, absolute convergence of the double series",
    methods=(f"index sets compared, n <= {ROWS}",),
    note="It converges absolutely exactly for |z| < 2|w|/(-1 - W_{-1}(-e^(-1-2w^2))) (motions.invariants.certified."
    "absolute_radius), which is below 1: never near the point of greatest speed. Form: the first n of the inner sum,"
    " and the powers of both variables.",
    derivation="smith-time-series",
)
def rearranged(form: tuple[sympy.Expr, sympy.Expr, sympy.Expr]) -> Outcome:
    """The pairs (n, i) of both orders of summation carry the same nonzero coefficients, the first one included.

    The powers are those of (57), where a coefficient C_i^n stands with (gamma v/omega)^i in f_n, and f_n with z^n.
    """
    least, inner, outer = form
    by_rows = {(number, j) for number in range(1, ROWS) for j, c in enumerate(polynomial_row(number)) if c}
    columns = [(j, int(least.subs(i, j))) for j in sampled(range(ROWS))]
    by_columns = {(number, j) for j, first in columns for number in range(first, ROWS) if coefficient(number, j)}
    sharp = all(coefficient(int(least.subs(i, j)), j) for j in range(ROWS))
    powers = [same(inner.subs(i, j), W_OF_STATE**j) for j in sampled(range(4))]
    powers += [same(outer.subs(n, number), Z_OF_STATE**number) for number in sampled(range(4))]
    return all_confirmed(decided(by_rows == by_columns and sharp), *powers)
