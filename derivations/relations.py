"""When a displayed relation is established, and how it is shown: what is decided is the object that is displayed.

>>> x = sympy.Symbol("x", positive=True)
>>> established(sympy.Gt(x**2 + 1, 1, evaluate=False)), established(sympy.Gt(x**2 + 1, x, evaluate=False))
(True, False)
>>> shown_in_text(sympy.Tuple(sympy.Ge(x, 0, evaluate=False), sympy.Ne(x, sympy.pi, evaluate=False)))
'x >= 0,  x != pi'
"""

from functools import lru_cache

import sympy
from sympy.core.relational import Relational

SIGNS = {"==": ("=", "="), "!=": ("!=", r"\neq")}
SIGNS |= {"<": ("<", "<"), "<=": ("<=", r"\leq"), ">": (">", ">"), ">=": (">=", r"\geq")}

latex = lru_cache(maxsize=None)(sympy.latex)
"""In LaTeX; a line is written when it is checked, and again wherever it is shown."""


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
    return ready.replace(lambda e: isinstance(e, sympy.Integral), _integrated).doit()


def _integrated(integral: sympy.Integral) -> sympy.Expr:
    """The integral of c x^p from 0, p > -1, or of a sum of c x^n e^(ikx), such as a polynomial in sin x and cos x; any
    other as it is.

    SymPy finds these by trial, in seconds, and how many depends on the hash seed; here the second is
    int x^n e^(rx) = e^(rx) sum_j (-1)^j n!/(n-j)! x^(n-j)/r^(j+1).

    >>> x = sympy.Symbol("x", real=True)
    >>> _integrated(sympy.Integral(x * sympy.sin(x)**2, (x, 0, sympy.pi)))
    pi**2/4
    >>> _integrated(sympy.Integral(sympy.exp(x**2), (x, 0, 1)))
    Integral(exp(x**2), (x, 0, 1))
    """
    f, *limits = integral.args
    if len(limits) != 1 or len(limits[0]) != 3:
        return integral
    x, low, high = limits[0]
    factor, power = sympy.powsimp(sympy.expand_power_base(f)).as_coeff_exponent(x)
    if low == 0 and not factor.has(x) and (power + 1).is_positive:
        return factor * high ** (power + 1) / (power + 1)
    if not f.has(sympy.sin, sympy.cos):
        return integral
    terms = [_wave(term, x) for term in sympy.Add.make_args(sympy.expand(f.rewrite(sympy.exp)))]
    if None in terms:
        return integral
    primitive = sympy.Add(*(_primitive(*term, x) for term in terms))
    return sympy.expand((primitive.subs(x, high) - primitive.subs(x, low)).rewrite(sympy.cos))


def _wave(term: sympy.Expr, x: sympy.Symbol) -> tuple[sympy.Expr, int, sympy.Expr] | None:
    """(c, n, r) if the term is c x^n e^(rx) with n = 0, 1, 2, ...; None if it is not."""
    factor, rest = term.as_independent(x)
    n, rate = 0, sympy.S.Zero
    for part in sympy.Mul.make_args(rest):
        base, power = part.as_base_exp()
        if part.func is sympy.exp and part.args[0].coeff(x) * x == part.args[0]:
            rate += part.args[0].coeff(x)
        elif base == x and power.is_Integer and power > 0:
            n += int(power)
        elif part != 1:
            return None
    return factor, n, rate


def _primitive(factor: sympy.Expr, n: int, rate: sympy.Expr, x: sympy.Symbol) -> sympy.Expr:
    if rate == 0:
        return factor * x ** (n + 1) / (n + 1)
    falling = (sympy.ff(n, j) * (-1) ** j * x ** (n - j) / rate ** (j + 1) for j in range(n + 1))
    return factor * sympy.exp(rate * x) * sympy.Add(*falling)


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
    return _shown(shown, 1, latex, r",\quad ")


def _shown(shown, language, write, between):
    relations = shown if isinstance(shown, sympy.Tuple) else (shown,)
    return between.join(f"{write(r.lhs)} {SIGNS[r.rel_op][language]} {write(r.rhs)}" for r in relations)
