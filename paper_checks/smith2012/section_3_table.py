"""Section III, equations (52a)-(52c), Table I entry by entry, and figures 1-3: the orbit over many half-cycles.

Half-cycle n = 0, 1, 2, ... starts at the turning point u_n with S - S_n = S^-(u_n, 0) (n even) or S^+(u_n, 0) (n odd).

>>> from asymptotics.numbers.decimals import decimal_of_ball
>>> with ctx.workprec(BITS):
...     decimal_of_ball(integration_constants(4)[3], 12)
'0.133833082707'
"""

import sympy
from flint import arb

from asymptotics.numbers.context import ctx
from paper_checks.evidence import mark
from paper_checks.identities import all_confirmed, balls_agree, below, decided, rounds_to, same, vanishes
from paper_checks.registry import Check, Statement, add, statement
from paper_checks.smith2012.model import (
    QUARTER,
    S_falling,
    S_rising,
    invariant,
    orbit,
    rate,
    u,
    u0,
    u1,
    u2,
    w,
)
from paper_checks.smith2012.section_3_orbit import FACTOR_NOTE, START
from paper_checks.verdict import Evidence, Kind, Outcome, Printed

BITS = 300
exp = sympy.exp
S_even, S_odd = sympy.symbols("S_2n S_2n+1")


def garbled(seen: str) -> str:
    """What a note says of a letter that the supplied text has got wrong."""
    return f" In the last member the supplied text has n for u ('{seen}'): read as u, a garbled transcription."


def integration_constants(length: int) -> list[arb]:
    """S_0 = 0, S_1, ...: S_n = S - S^-+(u_n, 0), S being the value at the start (u_0 = 1)."""
    points = orbit(length)
    return [arb(0)] + [invariant(0, points[0]) - invariant(n, points[n]) for n in range(1, length)]


def members(prefactor: sympy.Expr, left: sympy.Expr, right: sympy.Expr, sign: int) -> tuple[sympy.Expr, sympy.Expr]:
    """prefactor e^(-2 sign u) (2u + sign) at the two turning points of one half-cycle."""
    return tuple(prefactor * exp(-2 * sign * point) * (2 * point + sign) for point in (left, right))


@statement(
    id="smith2012:52a", kind=Kind.IDENTITY, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    derivation="smith-matching", line=7,
    title="The turning points of the falling half-cycles",
    latex=r"\hat{S} - \hat{S}_{2n} = e^{-2u_{2n+1}}(2u_{2n+1}+1) = e^{-2n_{2n}}(2n_{2n}+1)",
    corrected_latex=r"\hat{S} - \hat{S}_{2n} = -\frac{1}{4}e^{-2u_{2n+1}}(2u_{2n+1}+1)"
    r" = -\frac{1}{4}e^{-2u_{2n}}(2u_{2n}+1)",
    variables="u_1 stands for u_{2n+1}, u_0 for u_{2n}", printed=members(sympy.Integer(1), u1, u0, 1),
    corrected=members(-QUARTER, u1, u0, 1), near_miss=members(QUARTER, u1, u0, 1),
    conditions="none", methods=("w = 0 in (52c)",), note=FACTOR_NOTE + garbled("e^{-2n_{2n}}"),
)
def falling_turning_points(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """Both members are S^- at their turning points."""
    return all_confirmed(same(form[0], S_falling(u1, 0)), same(form[1], S_falling(u0, 0)))


@statement(
    id="smith2012:52b", kind=Kind.IDENTITY, verdict=Printed.MISPRINT, evidence=Evidence.PROVED,
    derivation="smith-matching", line=8,
    title="The turning points of the rising half-cycles",
    latex=r"\hat{S} - \hat{S}_{2n+1} = e^{2u_{2n+2}}(2u_{2n+2}-1) = e^{2n_{2n+1}}(2n_{2n+1}-1)",
    corrected_latex=r"\hat{S} - \hat{S}_{2n+1} = \frac{1}{4}e^{2u_{2n+2}}(2u_{2n+2}-1)"
    r" = \frac{1}{4}e^{2u_{2n+1}}(2u_{2n+1}-1)",
    variables="u_2 stands for u_{2n+2}, u_1 for u_{2n+1}", printed=members(sympy.Integer(1), u2, u1, -1),
    corrected=members(QUARTER, u2, u1, -1), near_miss=members(-QUARTER, u2, u1, -1),
    conditions="none", methods=("w = 0 in (52c)",), note=FACTOR_NOTE + garbled("e^{2n_{2n+1}}"),
)
def rising_turning_points(form: tuple[sympy.Expr, sympy.Expr]) -> Outcome:
    """Both members are S^+ at their turning points."""
    return all_confirmed(same(form[0], S_rising(u2, 0)), same(form[1], S_rising(u1, 0)))


def all_cycles(sign: int) -> tuple[sympy.Expr, sympy.Expr, sympy.Expr]:
    """The members of (52c); sign = -1 subtracts the constants instead."""
    return (
        -exp(-2 * u0) * (u0 / 2 + QUARTER),
        exp(-2 * u) * (w**2 / 2 - u / 2 - QUARTER) + sign * S_even,
        exp(2 * u) * (w**2 / 2 + u / 2 - QUARTER) + sign * S_odd,
    )


@statement(
    id="smith2012:52c", kind=Kind.IDENTITY, verdict=Printed.HOLDS, evidence=Evidence.PROVED,
    title="The constant over all cycles",
    latex=r"\hat{S} = -e^{-2u_0}\left(\frac{u_0}{2}+\frac{1}{4}\right) = \begin{cases} e^{-2u}\left(\frac{w^2}{2} -"
    r" \frac{u}{2} - \frac{1}{4}\right) + \hat{S}_{2n}, & 2n\pi \le \theta < (2n+1)\pi, \\ e^{2u}\left(\frac{w^2}{2} +"
    r" \frac{u}{2} - \frac{1}{4}\right) + \hat{S}_{2n+1}, & (2n+1)\pi \le \theta < (2n+2)\pi \end{cases}",
    printed=all_cycles(1), near_miss=all_cycles(-1), methods=("constant along the motion", "continuous at each u_n"),
    conditions="S_n from the matching at the turning points, S_0 = 0; theta clockwise",
    slip="The supplied text shows its number once as (52b), and has two equations in the block of (52a).",
)
def constant_over_all_cycles(form: tuple[sympy.Expr, sympy.Expr, sympy.Expr]) -> Outcome:
    """The lines are constant along the motion and agree at u_1 and u_2, S_0 = 0 with S_(n+1) - S_n the jump of S^-+."""
    value, falling, rising = form
    jump_down = S_falling(u1, 0) - S_rising(u1, 0)  # S_(2n+1) - S_2n
    jump_up = S_rising(u2, 0) - S_falling(u2, 0)  # S_(2n+2) - S_(2n+1)
    at_first = (falling - rising.subs(S_odd, S_even + jump_down)).subs({u: u1, w: 0})
    at_second = (rising - falling.subs(S_even, S_odd + jump_up)).subs({u: u2, w: 0})
    return all_confirmed(
        vanishes(rate(falling, falling=True)),
        vanishes(rate(rising, falling=False)),
        same(falling.subs({u: u0, w: 0, S_even: 0}), value),
        vanishes(at_first),
        vanishes(at_second),
        same(value, START),
    )


def _table_value(column: str, index: int) -> arb:
    if column == "S":
        return invariant(0, orbit(1)[0])
    return orbit(index + 1)[index] if column == "u" else integration_constants(index + 1)[index]


def check_decimal(column: str, index: int, printed: str) -> Outcome:
    """Whether a printed decimal is the correct rounding of the certified value (S_0 = 0 and u_0 = 1: equality)."""
    with ctx.workprec(BITS):
        value = _table_value(column, index)
        if index == 0 and column != "S":
            mark(Evidence.CERTIFIED)
            difference = value - arb(printed)
            known = Outcome.CONFIRMED if difference == 0 else Outcome.UNDECIDED
            return known if difference.contains(0) else Outcome.REFUTED
        return rounds_to(printed, value)


SUBTRACTED = "; the printed digit comes from subtracting two constants already rounded to six decimals"
TABLE = (  # id, column, index, printed, corrected, near miss, note
    ("S", "S", 0, "-0.101501", None, "-0.101502", "The caption: S = -3 e^{-2}/4, by (42) at u_0 = 1."),
    ("S0", "S_n", 0, "0", None, "0.098765", "By definition: the first half-cycle needs no patch."),
    ("u0", "u", 0, "1", None, "1.000001", "The initial displacement that was chosen."),
    ("S1", "S_n", 1, "0.098765", None, "0.098764", ""),
    ("u1", "u", 1, "-0.41072", None, "-0.41071", "Five digits; six would be -0.410720."),
    ("S2", "S_n", 2, "0.123863", None, "0.123862", ""),
    ("u2", "u", 2, "0.263568", None, "0.263569", ""),
    ("S3", "S_n", 3, "0.133834", "0.133833", "0.133832",
     "0.13383308...: last digit one too large: 0.235335 - 0.101501 = 0.133834" + SUBTRACTED + "."),
    ("u3", "u", 3, "-0.194566", None, "-0.194565", ""),
    ("S4", "S_n", 4, "0.138780", None, "0.138779", ""),
    ("u4", "u", 4, "0.154318", None, "0.154317", ""),
    ("S5", "S_n", 5, "0.141589", "0.141588", "0.141587",
     "0.14158827...: last digit one too large: 0.243090 - 0.101501 = 0.141589" + SUBTRACTED + "."),
    ("u5", "u", 5, "-0.127908", None, "-0.127907", ""),
)
NAMES = {"S": r"\hat{S}", "S_n": r"\hat{S}_%d", "u": r"u_%d"}


def _decimal_check(column: str, index: int) -> Check:
    def check(printed: str) -> Outcome:
        return check_decimal(column, index, printed)

    return check


def _add_table() -> None:
    for key, column, index, printed, corrected, near_miss, note in TABLE:
        name = NAMES[column] % index if column != "S" else NAMES[column]
        add(Statement(
            id=f"smith2012:table1.{key}", kind=Kind.NUMBER, evidence=Evidence.CERTIFIED,
            verdict=Printed.HOLDS if corrected is None else Printed.MISPRINT,
            title="Table I: " + ("the caption's constant" if column == "S" else f"half-cycle {index + 1}, {key}"),
            latex=f"{name} = {printed}", corrected_latex=None if corrected is None else f"{name} = {corrected}",
            printed=printed, corrected=corrected, near_miss=near_miss, note=note,
            conditions="u_0 = 1; correct rounding of all printed digits",
            derivation="smith-turning-points" if corrected is None else "smith-matching",
            line=None if corrected is None else 12,
            digits=len((corrected or printed).lstrip("-0.").replace(".", "")),
            methods=("balls at 300 bits through Lambert W",), check=_decimal_check(column, index),
        ))


_add_table()


def joined(constants: tuple[str, ...], tolerance: str = "1.6e-6") -> Outcome:
    """Whether the half-cycles with these constants form one level set of S, continuous at every turning point.

    At u_n the half-cycles n - 1 and n must show the same S; the tolerance admits constants rounded to six decimals.
    """
    with ctx.workprec(BITS):
        points = orbit(len(constants))
        defects = [
            abs(invariant(n, points[n]) + arb(S) - invariant(0, points[0])) for n, S in enumerate(constants)
        ]
        return all_confirmed(*(below(defect, arb(tolerance)) for defect in defects))


PRINTED_CONSTANTS = tuple(printed for key, column, _, printed, *_ in TABLE if column == "S_n")


@statement(
    id="smith2012:fig1", kind=Kind.FIGURE, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED,
    title="S^- and S^+ at the same value: the two half-cycles do not join", printed=1, near_miss=-1,
    latex=r"\text{Fig. 1. The functions } \hat{S}^- \text{ and } \hat{S}^+ \text{ when } \hat{S}^- = \hat{S}^+",
    conditions="u_0 = 1", methods=("balls on the orbit u_0 = 1",),
    note="By parity the upper arc of the same value ends at -u_0 and -u_1, the lower one at u_0 and u_1; they would"
    " meet only if |u_1| = u_0. Form: s, for an upper arc ending at -s u_0 and -s u_1.",
)
def arcs_do_not_join(sign: int) -> Outcome:
    """S^+ takes the value of S^- at the mirrored ends, and these are not the ends of the lower arc."""
    with ctx.workprec(BITS):
        start, end = orbit(2)
        mirrored = [invariant(1, -sign * point) for point in (start, end)]
        values = [balls_agree(mirror, invariant(0, start), 40) for mirror in mirrored]
        return all_confirmed(*values, decided(not (start + end).contains(0)))


@statement(
    id="smith2012:fig2", kind=Kind.FIGURE, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED,
    title="One full cycle", latex=r"\text{Fig. 2. One full cycle of the quadratically damped oscillator}",
    printed=PRINTED_CONSTANTS[:2], near_miss=("0", "0"), conditions="u_0 = 1",
    methods=("regenerated: continuity at the turning points by balls",),
    note="Form: the integration constants of its two half-cycles; the near miss is Fig. 1, without the patch.",
)
@statement(
    id="smith2012:fig3", kind=Kind.FIGURE, verdict=Printed.HOLDS, evidence=Evidence.CERTIFIED,
    title="Three full cycles", latex=r"\text{Fig. 3. Three full cycles of the quadratically damped oscillator}",
    printed=PRINTED_CONSTANTS, near_miss=(*PRINTED_CONSTANTS[:5], "0.138780"), conditions="u_0 = 1",
    methods=("regenerated: continuity at the turning points by balls",),
    note="Form: the integration constants of its six half-cycles, as in Table I; the slips of Table I in the sixth"
    " decimal do not show. The near miss does not patch the sixth half-cycle.",
)
def cycles_join(constants: tuple[str, ...]) -> Outcome:
    """The arcs join, there is an even number of them, and the orbit has shrunk on the side where it started."""
    with ctx.workprec(BITS):
        points = orbit(len(constants) + 1)
        inward = [below(abs(b), abs(a)) for a, b in zip(points, points[1:])]
        turned = [below(a * b, arb(0)) for a, b in zip(points, points[1:])]
        return all_confirmed(joined(constants), *inward, *turned, decided(len(constants) % 2 == 0))
