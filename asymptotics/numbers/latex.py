"""An exact number in LaTeX as SymPy writes it, which is loaded for roots alone.

>>> [latex(ExactReal(Fraction(*q))) for q in ((3,), (-3,), (1, 2), (-1, 2))]
['3', '-3', '\\\\frac{1}{2}', '- \\\\frac{1}{2}']
>>> latex(ExactReal(Fraction(1, 3), Fraction(2)))
'\\\\frac{\\\\sqrt{2}}{3}'
"""

from fractions import Fraction as Fraction  # for the examples

from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.gamma_sums import GammaSum
from asymptotics.numbers.rationals import to_fmpq


def latex(x: ExactReal) -> str:
    """The number in LaTeX."""
    if x.is_rational:
        return GammaSum.rational(to_fmpq(x.rational)).latex()
    from asymptotics.numbers.bridge import in_latex  # noqa: PLC0415 (SymPy takes a quarter of a second)

    return in_latex(x)
