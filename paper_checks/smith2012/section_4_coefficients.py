"""Section IV, equations (62a)-(63): the coefficients C_i^n of the double series, recurrence and closed sum."""

import sympy

from asymptotics.numbers.bridge import to_sympy
from paper_checks.identities import all_confirmed, decided, same
from paper_checks.registry import statement
from paper_checks.smith2012.model import coefficient, i, k, m, n, w
from paper_checks.smith2012.section_4_series import df, f, general_order
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

ROWS = 24
double = sympy.factorial2


@statement(
    id="smith2012:62a", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The recurrence of the coefficients",
    latex=r"C_i^n = \frac{2(n-1)}{n+i}C_{i-1}^{n-1} - \frac{n-2}{n+i}C_i^{n-2}", conditions="n >= 2, C_0^1 = 1",
    printed=(2 * (n - 1) / (n + i), -(n - 2) / (n + i)), near_miss=(2 * (n - 1) / (n + i), (n - 2) / (n + i)),
    methods=("coefficient of w^i in (59d), n and i symbolic", f"rows to n = {ROWS}"),
    derivation="smith-closed-sum", line=2,
)
def coefficient_recurrence(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """(59d) on f_n = C w^i, f_(n-1) = C' w^(i-1), f_(n-2) = C'' w^i, and the rows."""
    here, left, below = sympy.symbols("A B D")
    line = general_order(1)[0].subs(
        {f(n): here * w**i, df(n): i * here * w ** (i - 1), f(n - 1): left * w ** (i - 1), f(n - 2): below * w**i}
    )
    solved = sympy.expand(sympy.solve(sympy.simplify(line / w**i), here)[0])
    symbolic = [same(part, solved.coeff(name)) for part, name in zip(form, (left, below))]
    rows = all(
        to_sympy(coefficient(a, b)) == sum(
            part.subs({n: a, i: b}) * to_sympy(value)
            for part, value in zip(form, (coefficient(a - 1, b - 1), coefficient(a - 2, b)))
        )
        for a in range(2, ROWS) for b in range(a)
    )
    return all_confirmed(*symbolic, decided(rows))


def closed_term(exponent: sympy.Expr, last: sympy.Expr) -> tuple[sympy.Expr, sympy.Expr]:
    """(upper limit, factor of C_(i-1)^(n+1-2k)) in (62b), with the exponent of -1."""
    factor = 2 * (-1) ** exponent * double(n + i - 2 * k) * double(n - 2) * last
    return (n - i + 1) / 2, factor / (double(n + i) * double(n - 2 * k))


@statement(
    id="smith2012:62b", kind=Kind.IDENTITY, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    title="The closed sum of the coefficients",
    latex=r"= \sum_{k=1}^{\frac{n-i+1}{2}} \frac{2(-1)^k(n+i-2k)!!(n-2)!!(n+1-2k)}{(n+i)!!(n-2k)!!}C_{i-1}^{n+1-2k}",
    corrected_latex=r"= \sum_{k=1}^{\frac{n-i+1}{2}} \frac{2(-1)^{k-1}(n+i-2k)!!(n-2)!!(n+1-2k)}{(n+i)!!(n-2k)!!}"
    r"C_{i-1}^{n+1-2k}",
    printed=closed_term(k, n + 1 - 2 * k), corrected=closed_term(k - 1, n + 1 - 2 * k),
    near_miss=closed_term(k - 1, n - 2 * k), conditions="1 <= i < n, n and i of opposite parity",
    methods=(f"all rows to n = {ROWS}", "(62a) unrolled, n and i symbolic: the derivation"),
    derivation="smith-closed-sum", line=13,
    note="(62a) has the first term +2(n-1)/(n+i), so k = 1 must come with a plus: C_1^2 = 2/3 by (60b), the printed sum"
    " gives -2/3. The text cannot tell whether print or transcription lost the -1. For i = 0 use (63).",
)
def closed_sum_of_coefficients(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """The sum with the coefficients of column i - 1 gives column i, exactly, for all rows to ROWS."""
    upper, factor = form
    for a in range(2, ROWS):
        for b in range(1 + a % 2, a, 2):
            total = sympy.Integer(0)
            for j in range(1, int(upper.subs({n: a, i: b})) + 1):
                total += factor.subs({n: a, i: b, k: j}) * to_sympy(coefficient(a + 1 - 2 * j, b - 1))
            if total != to_sympy(coefficient(a, b)):
                return Outcome.REFUTED
    return Outcome.CONFIRMED


@statement(
    id="smith2012:claim.opposite-parity", kind=Kind.CLAIM, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    paraphrase=True, title="n and i have opposite parity",
    latex=r"C_i^n = 0 \text{ unless } n \text{ and } i \text{ have opposite parity}", printed=1, near_miss=0,
    conditions="none",
    methods=(f"rows to n = {ROWS}", "(62a) keeps n - i mod 2, C_0^1 = 1"), derivation="smith-closed-sum", line=6,
    note="Form: the n - i (mod 2) for which C_i^n may differ from 0; there it never vanishes:"
    " by (62a) and induction its sign is (-1)^{(n-1-i)/2}.",
)
def opposite_parity(remainder: int) -> Outcome:
    """C_i^n is nonzero exactly for n - i = remainder mod 2, in all rows."""
    cells = [(a, b) for a in range(1, ROWS) for b in range(a)]
    return decided(all((coefficient(a, b) != 0) == ((a - b) % 2 == remainder) for a, b in cells))


def sign_power(shift: int) -> sympy.Expr:
    """(-1)^((n - shift)/2)."""
    return (-1) ** ((n - shift) / 2)


@statement(
    id="smith2012:63", kind=Kind.IDENTITY, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    title="The coefficients of column 0",
    latex=r"C_0^{2m+1} = \begin{cases} -\frac{n-2}{n}C_0^{n-2} = \frac{n-4}{n}C_0^{n-4} = \frac{(-1)^{(n-1)/2}}{n}, &"
    r" n = \text{odd}, \\ 0, & n = \text{even} \end{cases}",
    corrected_latex=r"C_0^n = \begin{cases} -\frac{n-2}{n}C_0^{n-2} = \frac{n-4}{n}C_0^{n-4} = \frac{(-1)^{(n-1)/2}}{n}"
    r", & n = \text{odd}, \\ 0, & n = \text{even} \end{cases}",
    printed=(2 * m + 1, sign_power(1) / n), corrected=(n, sign_power(1) / n), near_miss=(n, sign_power(-1) / n),
    conditions="n >= 5 for the middle members", methods=(f"rows to n = {ROWS}", "(62a) at i = 0"),
    note="The left superscript must be n: 2m+1 is odd for every m, so that with it the line for even n states that some"
    " C_0^{2m+1} is 0, and none is. The values are right. The text cannot tell print from transcription.",
    derivation="smith-closed-sum", line=3,
)
def column_zero(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """Every C_0^superscript with even n vanishes, and for odd n the values hold: for some m if n is not in it, else for
    every m."""
    superscript, value = form
    for a in range(1, ROWS):
        candidates = {int(superscript.subs({n: a, m: j})) for j in range(1, ROWS)}
        meant = candidates == {a} if n in superscript.free_symbols else a in candidates | {1}
        if a % 2 == 1 and not meant:
            return Outcome.REFUTED
        if a % 2 == 0 and all(coefficient(s, 0) != 0 for s in candidates):
            return Outcome.REFUTED
        if a % 2 == 1 and value.subs(n, a) != to_sympy(coefficient(a, 0)):
            return Outcome.REFUTED
    chain = [coefficient(a, 0) == -(a - 2) * coefficient(a - 2, 0) / a for a in range(3, ROWS, 2)]
    chain += [coefficient(a, 0) == (a - 4) * coefficient(a - 4, 0) / a for a in range(5, ROWS, 2)]
    return decided(all(chain))
