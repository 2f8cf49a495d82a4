"""The averages that everything is made of: M_p = <|sin|^p>, and what Lelas' squaring trick puts in their place."""

from fractions import Fraction
from functools import partial

from flint import arb

from asymptotics.expansions.moments.certified import moment, squaring_ratio
from asymptotics.expansions.moments.exact import integer_moment
from asymptotics.numbers.decimals import certified_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.tables.cells import Cell, Nearest
from asymptotics.tables.inputs import GRID, Inputs
from asymptotics.tables.recipe import Found


def moments(inputs: Inputs, digits: int) -> Found:
    """Rows (alpha, M_(alpha+1), M_(2 alpha), M_(3 alpha+1))."""
    # (k, plus) of M_(k alpha + plus): the moments of the first, the second and the third order.
    orders = ((1, 1), (2, 0), (3, 1))
    rows = [(str(a), *(_moment(a, k, plus, digits) for k, plus in orders)) for a in inputs.alphas_or(GRID)]
    return Found(list(rows), True)


def squaring_ratios(inputs: Inputs, digits: int) -> Found:
    """Rows (alpha, 2^(-(alpha+1)/2)/M_(alpha+1)): the damping of the squaring trick over the averaged one."""
    return Found([(str(a), _ratio(a, digits)) for a in inputs.alphas_or(GRID)], True)


def _moment(a: ExactReal, k: int, plus: int, digits: int) -> Cell:
    # M_p of an even integer p is rational, of an odd one a rational over pi, whose decimal no ball has trouble with.
    if a.is_integer:
        value, over_pi = integer_moment(k * a.rational.numerator + plus)
        if not over_pi:
            return value
    return Nearest(certified_decimal(partial(_ball, a, k, plus), digits))


def _ball(a: ExactReal, k: int, plus: int) -> arb:
    return moment(k * a.ball() + plus)


def _ratio(a: ExactReal, digits: int) -> Cell:
    if a.is_integer and a.rational.numerator % 2:  # M of an even integer is rational, and so is the power of 2
        half = (a.rational.numerator + 1) // 2
        return Fraction(1, 2**half) / integer_moment(2 * half)[0]
    return Nearest(certified_decimal(lambda: squaring_ratio(a.ball()), digits))
