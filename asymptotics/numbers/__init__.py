"""Exact input, certified decimals, and the only bridge between SymPy, mpmath and FLINT numbers."""

from asymptotics.numbers import pickling as pickling
from asymptotics.numbers.decimals import certified_decimal, rational_decimal
from asymptotics.numbers.exact import ExactReal, parse_rational, parse_real
from asymptotics.numbers.integers import parse_integer

__all__ = ["ExactReal", "certified_decimal", "parse_integer", "parse_rational", "parse_real", "rational_decimal"]
