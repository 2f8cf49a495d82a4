"""Exact input, certified decimals, and the only bridge between SymPy, mpmath and FLINT numbers.

=============  ====================================================================================
``exact``      what a user may type (``3/2``, ``0.1``, ``sqrt(2)``) as an exact number; never a float
``decimals``   D significant digits from a ball, correctly rounded and proved to be, or an honest failure
``rationals``  Fraction <-> fmpq, ball -> exact bounds: no silent float, no dropped radius
``bridge``     the same for SymPy: the only place where a number changes its library
``pickling``   balls, rationals and polynomials survive pickling (importing this package switches it on)
=============  ====================================================================================
"""

from asymptotics.numbers import pickling as pickling
from asymptotics.numbers.decimals import certified_decimal, rational_decimal
from asymptotics.numbers.exact import ExactReal, parse_integer, parse_rational, parse_real

__all__ = ["ExactReal", "certified_decimal", "parse_integer", "parse_rational", "parse_real", "rational_decimal"]
