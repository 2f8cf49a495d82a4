"""How a symbolic form is judged: exactly zero is CONFIRMED, certainly nonzero somewhere is REFUTED, else UNDECIDED.

>>> import sympy
>>> x = sympy.Symbol("x", positive=True)
>>> vanishes(sympy.sin(x)**2 + sympy.cos(x)**2 - 1), vanishes(sympy.sin(x) - x)
(<Outcome.CONFIRMED: 'confirmed'>, <Outcome.REFUTED: 'refuted'>)

A refutation is a ball that excludes zero at an exact rational point of the domain; a confirmation is SymPy reducing the
difference to 0.  The rational points are fixed, so that a verdict never depends on chance.
"""

from fractions import Fraction
from itertools import cycle
from typing import Any

import sympy
from flint import arb
from sympy.core.function import AppliedUndef

from asymptotics.numbers.bridge import closed_form_ball, to_sympy
from asymptotics.numbers.context import ctx
from paper_checks import verdict
from paper_checks.evidence import Difference, differ, mark
from paper_checks.forms import DECIMAL, tex
from paper_checks.verdict import Evidence, Outcome

Place = dict[sympy.Symbol, sympy.Rational]
POINTS = (Fraction(2, 7), Fraction(3, 5), Fraction(5, 3), Fraction(7, 11), Fraction(13, 9))


def vanishes(difference: sympy.Expr, points: tuple[Fraction, ...] = POINTS) -> Outcome:
    """Whether an expression in (positive) free symbols is identically zero."""
    return _same(difference, sympy.S.Zero, difference, points)


def same(left: sympy.Expr, right: sympy.Expr) -> Outcome:
    """Whether two expressions are identically equal."""
    left, right = sympy.S.Zero + left, sympy.S.Zero + right
    return _same(left, right, left - right, POINTS)


def _same(left: sympy.Expr, right: sympy.Expr, difference: sympy.Expr, points: tuple[Fraction, ...]) -> Outcome:
    letters = _in_letters(difference)
    for shift in range(len(points)):
        place = _excludes_zero(letters, points[shift:] + points[:shift])
        if place is not None:
            differ(_apart(left, right, place))
            return Outcome.REFUTED
    if sympy.expand(difference) == 0 or sympy.simplify(difference) == 0:
        mark(Evidence.PROVED)
        return Outcome.CONFIRMED
    return Outcome.UNDECIDED


def _apart(left: sympy.Expr, right: sympy.Expr, place: Place) -> Difference:
    """The two sides as they stand, and their values at a point where they differ."""
    with ctx.workprec(200):
        try:
            values = [_shown(closed_form_ball(_in_letters(side).subs(place))) for side in (left, right)]
        except (TypeError, ValueError):  # one side alone has no enclosure
            values = ["", ""]
    where = ", ".join(f"{tex(s)} = {tex(q)}" for s, q in place.items() if not isinstance(s, sympy.Dummy))
    return Difference(tex(left), "=", tex(right), (values[0], values[1]), where)


def _shown(ball: arb) -> str:
    return ball.str(6, radius=False) if ball.is_finite() else ""


def _numbers(left: arb, relation: str, right: arb) -> Difference:
    values = _shown(left), _shown(right)
    return Difference(values[0], relation, values[1])


def all_confirmed(*outcomes: Outcome) -> Outcome:
    """The conjunction: REFUTED if any is refuted, else UNDECIDED if any is undecided, else CONFIRMED."""
    for outcome in (Outcome.REFUTED, Outcome.UNDECIDED):
        if outcome in outcomes:
            return outcome
    return Outcome.CONFIRMED


def opposite(outcome: Outcome) -> Outcome:
    """The outcome of the contrary; what is undecided stays so."""
    return {Outcome.CONFIRMED: Outcome.REFUTED, Outcome.REFUTED: Outcome.CONFIRMED}.get(outcome, outcome)


def below(a: arb, b: arb) -> Outcome:
    """Whether a < b, three-valued: two balls that overlap decide nothing, and neither does NaN.

    >>> below(arb(1), arb(2)), below(arb(2), arb(1)), below(arb(1, 1), arb(2, 1)), below(arb("nan"), arb(1))
    (<Outcome.CONFIRMED: 'confirmed'>, <Outcome.REFUTED: 'refuted'>, <Outcome.UNDECIDED: 'undecided'>, \
<Outcome.UNDECIDED: 'undecided'>)
    """
    mark(Evidence.CERTIFIED)
    if a < b:
        return Outcome.CONFIRMED
    if a >= b:
        differ(_numbers(a, "<", b))
    return Outcome.REFUTED if a >= b else Outcome.UNDECIDED


def rounds_to(printed: str, ball: arb) -> Outcome:
    """Whether a printed decimal is the number rounded to the decimals that are printed.

    >>> rounds_to("0.333", arb(1) / 3), rounds_to("0.334", arb(1) / 3), rounds_to("0", arb(1) / 3)
    (<Outcome.CONFIRMED: 'confirmed'>, <Outcome.REFUTED: 'refuted'>, <Outcome.CONFIRMED: 'confirmed'>)
    """
    found = DECIMAL.fullmatch(printed)
    if found is None:
        return Outcome.REFUTED
    value = Fraction(printed)
    half = arb(1) / (2 * arb(10) ** len(found[1] or ""))
    outcome = below(abs(ball - arb(value.numerator) / value.denominator), half)
    if outcome == Outcome.REFUTED:
        differ(Difference(printed, "=", _shown(ball)))
    return outcome


def balls_agree(a: arb, b: arb, digits: int) -> Outcome:
    """``paper_checks.verdict.balls_agree``, noted as certified evidence."""
    mark(Evidence.CERTIFIED)
    outcome = verdict.balls_agree(a, b, digits)
    if outcome == Outcome.REFUTED:
        differ(_numbers(a, "=", b))
    return outcome


def not_of_order(order: float, wanted: int) -> Outcome:
    """REFUTED: an error that falls like another power than it should."""
    differ(Difference(r"\text{order of the error}", "=", str(wanted), (f"{order:.2f}", "")))
    return Outcome.REFUTED


def decided(*facts: object) -> Outcome:
    """The conjunction of exact tests, each true, false, or left open by SymPy: None, or a relation that stays one.

    Whatever is neither true nor false is UNDECIDED.  So a fact is handed over as it is, without ``bool``, ``not`` or
    ``is True`` in front of it, which would turn None into a falsehood.

    >>> x = sympy.Symbol("x", positive=True)
    >>> decided(True, x > 0), decided(True, x < 0, None), decided(x > 1), decided((x - 1).is_negative)
    (<Outcome.CONFIRMED: 'confirmed'>, <Outcome.REFUTED: 'refuted'>, <Outcome.UNDECIDED: 'undecided'>, \
<Outcome.UNDECIDED: 'undecided'>)
    """
    if any(fact is False or fact is sympy.false for fact in facts):
        return Outcome.REFUTED
    certain = all(fact is True or fact is sympy.true for fact in facts)
    return Outcome.CONFIRMED if certain else Outcome.UNDECIDED


def limit_is(expression: sympy.Expr, variable: sympy.Symbol, end: sympy.Expr, value: Any, side: str = "-") -> Outcome:
    """Whether the limit is the value, which may be infinite; a limit that SymPy leaves standing decides nothing.

    >>> x = sympy.Symbol("x", positive=True)
    >>> limit_is(sympy.sin(x) / x, x, sympy.Integer(0), 1, "+"), limit_is(1 / x, x, sympy.oo, 1)
    (<Outcome.CONFIRMED: 'confirmed'>, <Outcome.REFUTED: 'refuted'>)
    """
    found = sympy.limit(expression, variable, end, side)
    wanted = value if isinstance(value, sympy.Expr) else sympy.Integer(value)
    if found.has(sympy.Limit, sympy.AccumBounds, sympy.nan):
        return Outcome.UNDECIDED
    if not {wanted, found}.isdisjoint((sympy.oo, -sympy.oo, sympy.zoo)):
        if found != wanted:
            standing = sympy.Limit(expression, variable, end, side)
            differ(Difference(tex(standing), "=", tex(wanted), (tex(found), "")))
        return decided(found == wanted)
    return same(found, wanted)


def _excludes_zero(expression: sympy.Expr, points: tuple[Fraction, ...]) -> Place | None:
    """The rational point at which the expression, without unknown functions, is certainly not zero, if this is one."""
    symbols = sorted(expression.free_symbols, key=str)
    values = {s: to_sympy(q) for s, q in zip(symbols, cycle(points))}
    with ctx.workprec(200):
        ball = _ball(expression, values)
    return values if ball.is_finite() and not ball.contains(0) else None


def _ball(expression: sympy.Expr, values: Place) -> arb:
    """The expression there, read as it stands; where that has no rule or no value, as SymPy writes it with numbers."""
    try:
        ball = closed_form_ball(expression, {s: closed_form_ball(q) for s, q in values.items()})
    except TypeError:
        ball = arb("nan")
    return ball if ball.is_finite() else closed_form_ball(expression.subs(values))


def _in_letters(expression: sympy.Expr) -> sympy.Expr:
    """Unknown functions and their derivatives as letters, which take any value as they do."""
    unknown = sorted(expression.atoms(sympy.Derivative, AppliedUndef), key=lambda f: (-f.count_ops(), str(f)))
    return expression.subs([(f, sympy.Dummy(str(f), positive=True)) for f in unknown])
