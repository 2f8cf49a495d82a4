"""The only place where numbers change their type: Fraction <-> fmpq <-> SymPy, closed form -> ball, ball -> bounds.

A ball never becomes a number by itself: ``mpmathify``, ``sympify`` and ``float`` would keep the midpoint and drop the
radius without a word.  What leaves is a pair of exact rational bounds, or certified digits (``numbers.decimals``).

>>> to_fmpq(Fraction(1, 3)), to_fraction(fmpq(1, 3))
(1/3, Fraction(1, 3))
>>> low, high = bounds(arb(2).sqrt())
>>> low**2 < 2 < high**2
True
>>> closed_form_ball(sympy.sqrt(2) * sympy.pi).overlaps(arb(2).sqrt() * arb.pi())
True
"""

from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import reduce
from operator import add, mul
from types import MappingProxyType
from typing import Any

import sympy
from flint import arb, fmpq, fmpz
from sympy.core.sympify import converter

from asymptotics.errors import InputError, shown
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.rationals import bounds, to_fmpq, to_fraction

# SymPy on Python's numbers would make a Float of an exponent of flint (x**1.0): integers and rationals stay exact.
converter[fmpz] = lambda n: sympy.Integer(int(n))
converter[fmpq] = lambda q: sympy.Rational(int(q.p), int(q.q))

__all__ = [
    "bounds",
    "closed_form_ball",
    "expression",
    "from_sympy",
    "in_latex",
    "to_float",
    "to_fmpq",
    "to_fraction",
    "to_sympy",
]


def to_sympy(q: Fraction | fmpq | ExactReal | int) -> sympy.Expr:
    """An exact number -> SymPy, whatever ground types SymPy works with.

    >>> to_sympy(fmpq(1, 3)), to_sympy(ExactReal(Fraction(1), Fraction(3, 2)))
    (1/3, sqrt(6)/2)
    """
    if isinstance(q, ExactReal):
        return to_sympy(q.coefficient) * sympy.sqrt(to_sympy(q.radicand)) + to_sympy(q.offset)
    if isinstance(q, fmpq):
        return sympy.Rational(int(q.p), int(q.q))
    return sympy.Rational(q.numerator, q.denominator)


def to_float(q: Fraction, digits: int) -> sympy.Float:
    """A number of SymPy with so many digits.

    >>> to_float(Fraction(1, 3), 4)
    0.3333
    """
    return sympy.Float(to_sympy(q), digits)


def in_latex(q: ExactReal) -> str:
    """An exact number in LaTeX.

    >>> in_latex(ExactReal(Fraction(1), Fraction(2)))
    '\\\\sqrt{2}'
    """
    return str(sympy.latex(to_sympy(q)))


def expression(value: Any, argument: str) -> sympy.Expr:
    """``value`` if it is an expression of SymPy; InputError otherwise: no text is read as one.

    >>> expression("x", "phase")
    Traceback (most recent call last):
        ...
    asymptotics.errors.InputError: argument phase: 'x' is no expression (accepted: an expression of SymPy)
    """
    if not isinstance(value, sympy.Expr):
        raise InputError(argument, f"{shown(value)} is no expression", "an expression of SymPy")
    return value


def from_sympy(q: sympy.Rational) -> Fraction:
    """A SymPy Rational -> Fraction; TypeError for anything else, floats included."""
    if not isinstance(q, sympy.Rational):
        raise TypeError(f"not an exact rational: {q!r}")
    return Fraction(int(q.p), int(q.q))


_FUNCTIONS: dict[type, Callable[..., arb]] = {
    sympy.exp: arb.exp,
    sympy.log: arb.log,
    sympy.sin: arb.sin,
    sympy.cos: arb.cos,
    sympy.tan: arb.tan,
    sympy.atan: arb.atan,
    sympy.coth: arb.coth,
    sympy.gamma: arb.gamma,
    sympy.zeta: arb.zeta,
    # Real values stand on the branches 0 and -1 alone, and SymPy writes the branch only where it is not 0.
    sympy.LambertW: lambda x, branch=None: arb.lambertw(x, 0 if branch is None else -1),
}
_CONSTANTS: dict[sympy.Expr, Callable[[], arb]] = {
    sympy.pi: arb.pi,
    sympy.E: arb.const_e,
    sympy.EulerGamma: arb.const_euler,
}


def closed_form_ball(expression: sympy.Expr, places: Mapping[sympy.Symbol, arb] = MappingProxyType({})) -> arb:
    """Enclose a real closed form at the current precision, its free symbols at places; TypeError without a rule here.

    >>> x = sympy.Symbol("x")
    >>> closed_form_ball(sympy.sqrt(x) * x, {x: arb(4)})
    8.00000000000000
    """
    if expression in places:
        return places[expression]
    if isinstance(expression, sympy.Rational):
        return arb(fmpq(int(expression.p), int(expression.q)))
    if expression in _CONSTANTS:
        return _CONSTANTS[expression]()
    if isinstance(expression, sympy.Add | sympy.Mul):
        return reduce(add if expression.is_Add else mul, [closed_form_ball(a, places) for a in expression.args])
    if isinstance(expression, sympy.Pow):
        # An integer exponent stays one: the power of a ball by a ball
        # goes through the logarithm, which a negative base lacks.
        base, exponent = (closed_form_ball(a, places) for a in expression.args)
        return base ** (int(expression.exp) if expression.exp.is_Integer else exponent)
    if type(expression) in _FUNCTIONS:
        return _FUNCTIONS[type(expression)](*[closed_form_ball(a, places) for a in expression.args])
    raise TypeError(f"no enclosure rule for {expression!r}")
