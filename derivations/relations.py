"""When a displayed relation is established, and how it is shown: what is decided is the object that is displayed.

>>> x = sympy.Symbol("x", positive=True)
>>> established(sympy.Gt(x**2 + 1, 1, evaluate=False)), established(sympy.Gt(x**2 + 1, x, evaluate=False))
(True, False)
>>> shown_in_text(sympy.Tuple(sympy.Ge(x, 0, evaluate=False), sympy.Ne(x, sympy.pi, evaluate=False)))
'x >= 0,  x != pi'
"""

import sympy
from sympy.core.relational import Relational

SIGNS = {"==": ("=", "="), "!=": ("!=", r"\neq")}
SIGNS |= {"<": ("<", "<"), "<=": ("<=", r"\leq"), ">": (">", ">"), ">=": (">=", r"\geq")}


def value(shown: sympy.Basic) -> sympy.Basic:
    """What is displayed, evaluated; what waits under an integral, a sum or a limit first.

    SymPy's own integral takes an operator D that waits for a function: of D(sin x) cos x over a period it would say 0.

    >>> from derivations.waiting import defined
    >>> x = sympy.Symbol("x", real=True)
    >>> D = defined("D", lambda h: sympy.diff(h, x))
    >>> integral = sympy.Integral(D(sympy.sin(x)) * sympy.cos(x), (x, 0, 2 * sympy.pi))
    >>> integral.doit(), value(integral)
    (0, pi)
    """
    outer = (sympy.Integral, sympy.Sum, sympy.Limit)
    ready = shown.replace(lambda e: isinstance(e, outer), lambda e: e.func(e.args[0].doit(), *e.args[1:]))
    return ready.doit()


def difference(left: sympy.Basic, right: sympy.Basic) -> sympy.Expr:
    """``left - right`` with everything that waits evaluated, reduced as far as SymPy can; 0 if they are equal.

    Of two tuples: the first difference of their entries that is not 0.
    """
    left, right = value(left), value(right)
    if isinstance(left, sympy.Tuple) and isinstance(right, sympy.Tuple) and len(left) == len(right):
        found = (difference(a, b) for a, b in zip(left, right, strict=True))
        return next((one for one in found if one != 0), sympy.Integer(0))
    remainder = left - right
    for reduce in (sympy.expand, sympy.simplify, sympy.expand_func, sympy.gammasimp):
        if remainder != 0:
            remainder = reduce(remainder)
    return remainder


def established(relation: Relational) -> bool:
    """Whether the relation holds for all values that its symbols' assumptions allow; ``!=`` of two functions says that
    they are not the same function."""
    left, right = (value(side) for side in relation.args)
    if isinstance(relation, sympy.Eq):
        return left == right if sympy.oo in (abs(left), abs(right)) else difference(left, right) == 0
    if isinstance(relation, sympy.Ne):
        rest = difference(left, right)
        return rest.is_zero is False if rest.is_number else rest != 0
    return any(relation.func(form, 0) is sympy.true for form in _forms(left - right))


def _forms(difference: sympy.Expr) -> list[sympy.Expr]:
    """Ways to write a difference, of which one may show its sign."""
    return [reduce(difference) for reduce in (lambda e: e, sympy.expand, sympy.factor, sympy.simplify)]


def shown_in_text(shown: sympy.Basic) -> str:
    """Relations in plain text."""
    return _shown(shown, 0, str, ",  ")


def shown_in_latex(shown: sympy.Basic) -> str:
    """Relations in LaTeX."""
    return _shown(shown, 1, sympy.latex, r",\quad ")


def _shown(shown, language, write, between):
    relations = shown if isinstance(shown, sympy.Tuple) else (shown,)
    return between.join(f"{write(r.lhs)} {SIGNS[r.rel_op][language]} {write(r.rhs)}" for r in relations)
