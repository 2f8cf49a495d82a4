"""An exact number in LaTeX as SymPy writes it, which is loaded for roots alone.

>>> [latex(ExactReal(Fraction(*q))) for q in ((3,), (-3,), (1, 2), (-1, 2))]
['3', '-3', '\\\\frac{1}{2}', '- \\\\frac{1}{2}']
>>> latex(ExactReal(Fraction(1, 3), Fraction(2)))
'\\\\frac{\\\\sqrt{2}}{3}'
"""

from fractions import Fraction

from asymptotics.numbers.exact import ExactReal


def latex(x: ExactReal) -> str:
    """The number in LaTeX."""
    if x.is_rational:
        return _rational(x.rational)
    from asymptotics.numbers.bridge import in_latex  # noqa: PLC0415 (SymPy takes a quarter of a second)

    return in_latex(x)


def _rational(q: Fraction) -> str:
    if q.denominator == 1:
        return str(q.numerator)
    return ("- " if q < 0 else "") + rf"\frac{{{abs(q.numerator)}}}{{{q.denominator}}}"
