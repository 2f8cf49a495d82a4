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

import sympy
from flint import ctx

from asymptotics.numbers.bridge import closed_form_ball, to_sympy
from asymptotics.verdict import Outcome

POINTS = (Fraction(2, 7), Fraction(3, 5), Fraction(5, 3), Fraction(7, 11), Fraction(13, 9))


def vanishes(difference: sympy.Expr, points: tuple[Fraction, ...] = POINTS) -> Outcome:
    """Whether an expression in (positive) free symbols is identically zero."""
    for shift in range(len(points)):
        if _excludes_zero(difference, points[shift:] + points[:shift]):
            return Outcome.REFUTED
    if difference.is_zero or sympy.expand(difference) == 0 or sympy.simplify(difference) == 0:
        return Outcome.CONFIRMED
    return Outcome.UNDECIDED


def same(left: sympy.Expr, right: sympy.Expr) -> Outcome:
    """Whether two expressions are identically equal."""
    return vanishes(left - right)


def all_confirmed(*outcomes: Outcome) -> Outcome:
    """The conjunction: REFUTED if any is refuted, else UNDECIDED if any is undecided, else CONFIRMED."""
    for outcome in (Outcome.REFUTED, Outcome.UNDECIDED):
        if outcome in outcomes:
            return outcome
    return Outcome.CONFIRMED


def decided(truth: bool) -> Outcome:
    """The outcome of an exact test, which is either true or false."""
    return Outcome.CONFIRMED if truth else Outcome.REFUTED


def _excludes_zero(expression: sympy.Expr, points: tuple[Fraction, ...]) -> bool:
    symbols = sorted(expression.free_symbols, key=str)
    values = {s: to_sympy(q) for s, q in zip(symbols, cycle(points))}
    with ctx.workprec(200):
        ball = closed_form_ball(expression.subs(values))
    return ball.is_finite() and not ball.contains(0)
