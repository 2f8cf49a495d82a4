"""When a displayed relation is established, and how it is shown: what is decided is the object that is displayed.

>>> x = sympy.Symbol("x", positive=True)
>>> established(sympy.Gt(x**2 + 1, 1, evaluate=False)), established(sympy.Gt(x**2 + 1, x, evaluate=False))
(True, False)
>>> shown_in_text(sympy.Tuple(sympy.Ge(x, 0, evaluate=False), sympy.Ne(x, sympy.pi, evaluate=False)))
'x >= 0,  x != pi'
"""

from collections.abc import Callable, Iterator
from functools import lru_cache, reduce
from itertools import count

import sympy
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.polys.fields import field
from sympy.printing.latex import LatexPrinter

from derivations.waiting import is_rational
from derivations.words import formula

SIGNS = {"==": ("=", "="), "!=": ("!=", r"\neq")}
SIGNS |= {"<": ("<", "<"), "<=": ("<=", r"\leq"), ">": (">", ">"), ">=": (">=", r"\geq")}

WAVES = (sympy.sin, sympy.cos, sympy.tan, sympy.cot)
FACTORIALS = (sympy.gamma, sympy.factorial, sympy.RisingFactorial, sympy.binomial)


def _kept(write: Callable[[sympy.Basic], str]) -> Callable[[sympy.Basic], str]:
    """``write``, once for each expression; not where two are equal that are written with different letters.

    >>> x, y, f = *sympy.symbols("x y"), sympy.Function("f")
    >>> [text(sympy.Subs(f(z).diff(z), z, 0)) for z in (x, y)]
    ['Subs(Derivative(f(x), x), x, 0)', 'Subs(Derivative(f(y), y), y, 0)']
    """
    kept = lru_cache(maxsize=None)(write)
    return lambda shown: write(shown) if shown.has(sympy.Subs, sympy.Lambda) else kept(shown)


class _Latex(LatexPrinter):
    r"""SymPy's, but a name with brackets, such as M_(alpha+1), is read as mathematics in plain characters, and a
    product of which the derivative is taken stands in brackets.

    >>> print(_Latex().doprint(sympy.Symbol("M_(3+1)", positive=True)**2))
    M_{3+1}^{2}
    >>> x = sympy.Symbol("x")
    >>> print(_Latex().doprint(sympy.Derivative(x * sympy.exp(x), x)), _Latex().doprint(sympy.Derivative(x**2, x)))
    \frac{d}{d x} \left(x e^{x}\right) \frac{d}{d x} x^{2}
    """

    def _print_Symbol(self, expr: sympy.Symbol, style: str = "plain") -> str:
        return formula(expr.name) if "(" in expr.name else super()._print_Symbol(expr, style)

    def _print_Derivative(self, expr: sympy.Derivative) -> str:
        shown, product = super()._print_Derivative(expr), self._print(expr.expr)
        bare = expr.expr.is_Mul and not product.startswith(r"\frac") and shown.endswith(product)
        return rf"{shown.removesuffix(product)}\left({product}\right)" if bare else shown


latex, text = _kept(lambda shown: _Latex().doprint(shown)), _kept(str)
"""In LaTeX and in plain text; a line is written when it is checked, and again wherever it is shown."""


def value(shown: sympy.Basic) -> sympy.Basic:
    """What is displayed, evaluated; what waits under an integral, a sum or a limit first, and the derivative of an
    integral by Leibniz' rule, before a primitive is looked for that may not be known.

    SymPy's own integral takes an operator D that waits for a function: of D(sin x) cos x over a period it would say 0.

    >>> from derivations.waiting import defined
    >>> x = sympy.Symbol("x", real=True)
    >>> D = defined("D", lambda h: sympy.diff(h, x))
    >>> integral = sympy.Integral(D(sympy.sin(x)) * sympy.cos(x), (x, 0, 2 * sympy.pi))
    >>> integral.doit(), value(integral)
    (0, pi)
    >>> y, s = sympy.Symbol("y", positive=True), sympy.Function("s")
    >>> value(sympy.Derivative(sympy.Integral(s(x) + x * y, (x, 0, y)), y))
    3*y**2/2 + s(y)
    """
    outer = (sympy.Integral, sympy.Sum, sympy.Limit)
    if not shown.has(*outer):
        return shown.doit()
    if shown.has(sympy.Derivative):
        shown = shown.replace(
            lambda e: isinstance(e, sympy.Derivative) and e.has(sympy.Integral), lambda e: e.doit(integrals=False)
        )
    ready = shown.replace(lambda e: isinstance(e, outer), lambda e: e.func(e.args[0].doit(), *e.args[1:]))
    return ready.replace(lambda e: isinstance(e, sympy.Integral), _integrated).doit()


def _integrated(integral: sympy.Integral) -> sympy.Expr:
    """The integral of F'(x), of c x^p, p > -1 from 0 or p != -1 between positive places, or of a sum of c x^n e^(ikx),
    such as a polynomial in sin x and cos x; any other as it is, but none of a quotient with x in the denominator and a
    sine or cosine.

    SymPy finds these by trial, in seconds, and how many depends on the hash seed; here the second is
    int x^n e^(rx) = e^(rx) sum_j (-1)^j n!/(n-j)! x^(n-j)/r^(j+1).  After a quotient it may search until it has filled
    the memory.

    >>> x = sympy.Symbol("x", real=True)
    >>> _integrated(sympy.Integral(x * sympy.sin(x)**2, (x, 0, sympy.pi)))
    pi**2/4
    >>> [_integrated(sympy.Integral(1 / x**2, (x, low, 3))) for low in (2, 0, -1)]
    [1/6, Integral(x**(-2), (x, 0, 3)), Integral(x**(-2), (x, -1, 3))]
    >>> F = sympy.Function("F")
    >>> _integrated(sympy.Integral(F(2 * x).diff(x, evaluate=False), (x, 1, 3)))
    -F(2) + F(6)
    >>> _integrated(sympy.Integral(F(x).diff(x, 2), (x, 1, 3)))
    Integral(Derivative(F(x), (x, 2)), (x, 1, 3))
    >>> _integrated(sympy.Integral(sympy.exp(x**2), (x, 0, 1)))
    Integral(exp(x**2), (x, 0, 1))
    >>> _integrated(sympy.Integral(1 / (x + sympy.sin(x)), (x, 1, 2)))
    Traceback (most recent call last):
        ...
    NotImplementedError: no primitive is looked for: Integral(1/(x + sin(x)), (x, 1, 2))
    """
    f, *limits = integral.args
    if len(limits) != 1 or len(limits[0]) != 3:
        return integral
    x, low, high = limits[0]
    if isinstance(f, sympy.Derivative) and f.variables == (x,) and isinstance(f.expr, AppliedUndef):
        return f.expr.subs(x, high) - f.expr.subs(x, low)
    factor, power = sympy.powsimp(sympy.expand_power_base(f)).as_coeff_exponent(x)
    inside = low.is_positive and high.is_positive and (power + 1).is_nonzero
    if not factor.has(x) and not power.has(x) and (inside or low == 0 and (power + 1).is_positive):
        return factor * (high ** (power + 1) - low ** (power + 1)) / (power + 1)
    if not f.has(sympy.sin, sympy.cos):
        return integral
    if (waves := _waves(f, x) or _waves(sympy.expand(f), x)) is None:
        quotient = any(power.exp.is_negative and power.has(x) for power in f.atoms(sympy.Pow))
        if quotient and any(wave.has(x) for wave in f.atoms(sympy.sin, sympy.cos)):
            raise NotImplementedError(f"no primitive is looked for: {integral}")
        return integral
    primitive = sympy.Add(*(_primitive(c, n, rate, x) for (n, rate), c in waves.items()))
    return sympy.expand((primitive.subs(x, high) - primitive.subs(x, low)).rewrite(sympy.cos))


Waves = dict[tuple[int, sympy.Expr], sympy.Expr]
"""(n, r) -> c: the sum of the terms c x^n e^(rx)."""


def _waves(f: sympy.Expr, x: sympy.Symbol) -> Waves | None:
    """f as a sum of terms c x^n e^(rx); None if it is none.

    >>> x = sympy.Symbol("x", real=True)
    >>> _waves(2 * x * sympy.cos(x)**2, x)
    {(1, 2*I): 1/2, (1, 0): 1, (1, -2*I): 1/2}
    >>> _waves(1 / sympy.cos(x), x) is None
    True
    """
    if not f.has(x):
        return {(0, sympy.S.Zero): f}
    if f == x:
        return {(1, sympy.S.Zero): sympy.S.One}
    if f.func in (sympy.exp, sympy.sin, sympy.cos):
        return _wave(f, x)
    if f.is_Add or f.is_Mul:
        parts = [_waves(part, x) for part in f.args]
    elif f.is_Pow and f.exp.is_Integer and f.exp > 0:
        parts = [_waves(f.base, x)] * int(f.exp)
    else:
        return None
    return None if None in parts else reduce(_sum if f.is_Add else _product, parts)


def _wave(f: sympy.Expr, x: sympy.Symbol) -> Waves | None:
    """Of e^(kx + l), sin(kx + l) and cos(kx + l)."""
    argument = sympy.expand(f.args[0])
    rate, start = argument.coeff(x), argument.coeff(x, 0)
    if sympy.expand(rate * x + start) != argument:
        return None
    if f.func is sympy.exp:
        return {(0, rate): sympy.exp(start)}
    up, down = sympy.exp(sympy.I * start) / 2, sympy.exp(-sympy.I * start) / 2
    if f.func is sympy.sin:
        up, down = -sympy.I * up, sympy.I * down
    return {(0, sympy.I * rate): up, (0, -sympy.I * rate): down}


def _sum(one: Waves, other: Waves) -> Waves:
    return {key: one.get(key, 0) + other.get(key, 0) for key in {**one, **other}}


def _product(one: Waves, other: Waves) -> Waves:
    total: Waves = {}
    for (n, rate), c in one.items():
        for (k, further), d in other.items():
            key = (n + k, sympy.expand(rate + further))
            total[key] = sympy.expand(total.get(key, 0) + c * d)
    return total


def _primitive(factor: sympy.Expr, n: int, rate: sympy.Expr, x: sympy.Symbol) -> sympy.Expr:
    if rate == 0:
        return factor * x ** (n + 1) / (n + 1)
    falling = (sympy.ff(n, j) * (-1) ** j * x ** (n - j) / rate ** (j + 1) for j in range(n + 1))
    return factor * sympy.exp(rate * x) * sympy.Add(*falling)


def difference(left: sympy.Basic, right: sympy.Basic) -> sympy.Expr:
    """``left - right`` with everything that waits evaluated, reduced as far as SymPy can; 0 if they are equal.

    Of two tuples: the first difference of their entries that is not 0.

    >>> x = sympy.Symbol("x")
    >>> difference(1 / x - 1 / (x + 1), 1 / (x * (x + 1))), difference(1 / x - 1 / (x + 1), 1 / x)
    (0, -1/(x + 1))
    >>> D_0, D_1 = sympy.symbols("D_0 D_1", commutative=False)
    >>> A, B = (sympy.Function(name, commutative=False)(x) for name in "AB")
    >>> difference(D_0 * D_1, D_1 * D_0) == 0, difference(A * B, B * A) == 0
    (False, False)
    >>> n = sympy.Symbol("n", integer=True)
    >>> difference(sympy.rf(x, n), sympy.gamma(x + n) / sympy.gamma(x))  # not by gammas alone
    0
    """
    left, right = value(left), value(right)
    if isinstance(left, sympy.Tuple) and isinstance(right, sympy.Tuple) and len(left) == len(right):
        found = (difference(a, b) for a, b in zip(left, right, strict=True))
        return next((one for one in found if one != 0), sympy.Integer(0))
    remainder = sympy.expand(left - right)
    if remainder.is_commutative and _is_zero(_with_letters(remainder)):
        return sympy.Integer(0)
    # What is left of quotients of gammas is rational, as a rule; where it is not, the usual way is the longer one.
    if remainder.has(*FACTORIALS) and is_rational(quick := sympy.gammasimp(sympy.expand_func(remainder))):
        return _normal(quick)
    for simpler in (sympy.simplify, sympy.expand_func, sympy.gammasimp):
        if is_rational(remainder):
            return _normal(remainder)
        remainder = simpler(remainder)
    return remainder


def _normal(f: sympy.Expr) -> sympy.Expr:
    """A quotient of polynomials in its symbols and pi, reduced: it is 0 only if it is written as 0."""
    letters = sorted(f.free_symbols, key=str)
    return field([*letters, sympy.pi], sympy.QQ)[0].from_expr(f).as_expr()


def _is_zero(f: sympy.Expr) -> bool:
    """Whether a quotient of polynomials is 0; False of anything else, and of what has a denominator that is 0."""
    try:
        return is_rational(f) and _normal(f) == 0
    except ZeroDivisionError:
        return False


def _with_letters(f: sympy.Expr) -> sympy.Expr:
    """A letter for each function and each other power, which stands for its value, sines and cosines by the tangent of
    the half angle: where that is 0 for all values of the letters, so is f.

    >>> u, a = sympy.symbols("u a")
    >>> one = sympy.cos(u)**2 + sympy.sin(u)**2
    >>> [_is_zero(_with_letters(f)) for f in (sympy.cot(u) * sympy.tan(u) - one, one - 2, 1 / (one - 1))]
    [True, False, False]
    >>> h = sympy.log(u)
    >>> _is_zero(_with_letters(sympy.sin(h) - 2 * h / (1 + h**2)))
    False
    >>> _with_letters(u**a * sympy.exp(u) - 2)
    _X1*_X2 - 2
    """
    letters: dict[sympy.Expr, sympy.Symbol] = {}

    def letter(e: sympy.Expr) -> sympy.Symbol:
        return letters.setdefault(e, sympy.Dummy(f"X{len(letters) + 1}"))

    def plain(e: sympy.Expr) -> sympy.Expr:
        if e.is_Add or e.is_Mul or (e.is_Pow and e.exp.is_Integer):
            return e.func(*map(plain, e.args))
        if e.is_Number or e.is_Symbol or e in (sympy.pi, sympy.zoo):  # infinities stay: they have no letter
            return e
        if e.func not in WAVES:
            return letter(e)
        t = letter(sympy.tan(e.args[0] / 2))
        sine, cosine = 2 * t / (1 + t**2), (1 - t**2) / (1 + t**2)
        return {sympy.sin: sine, sympy.cos: cosine, sympy.tan: sine / cosine, sympy.cot: cosine / sine}[e.func]

    return plain(f)


def established(relation: Relational) -> bool:
    """Whether the relation holds for all values that its symbols' assumptions allow; ``!=`` of two functions says that
    they are not the same function.

    >>> x, k = sympy.symbols("x k")
    >>> root = sympy.sqrt(x + 2 * sympy.sqrt(x - 1))
    >>> told = [sympy.Ne(left, right, evaluate=False) for left, right in ((root, sympy.sqrt(x - 1) + 1), (root, x))]
    >>> [established(relation) for relation in told], difference(root, sympy.sqrt(x - 1) + 1) == 0
    ([False, True], False)
    """
    left, right = (value(side) for side in relation.args)
    if isinstance(relation, sympy.Eq):
        return left == right if sympy.oo in (abs(left), abs(right)) else difference(left, right) == 0
    if isinstance(relation, sympy.Ne):
        rest = difference(left, right)
        return rest.is_zero is False if rest.is_number else rest != 0 and _differs(rest)
    return any(relation.func(form, 0) is sympy.true for form in _forms(left - right))


def _differs(rest: sympy.Expr) -> bool:
    """Whether a difference that SymPy does not reduce to 0 is none at a point, within 20 digits; a function that may be
    any and its slope have any values there.

    >>> x, k = sympy.symbols("x k")
    >>> f = sympy.Function("f")
    >>> _differs(sympy.rf(x, k) - sympy.gamma(x + k) / sympy.gamma(x)), _differs(x - k), _differs(f(x) - f(x).diff(x))
    (False, True, True)
    """
    number = count()
    for kind in (sympy.Derivative, AppliedUndef, sympy.Symbol):
        places = {x: (next(number), x.is_integer) for x in sorted(rest.atoms(kind), key=str)}
        rest = rest.xreplace(
            {x: sympy.Integer(3 + n) if whole else sympy.Rational(31 + 7 * n, 53) for x, (n, whole) in places.items()}
        )
    size = abs(sympy.N(rest, 30))
    return bool(size.is_comparable and size > sympy.Rational(1, 10**20))


def _forms(difference: sympy.Expr) -> Iterator[sympy.Expr]:
    """Ways to write a difference, of which one may show its sign, from cheap to dear."""
    return (written(difference) for written in (lambda e: e, sympy.expand, sympy.factor, sympy.simplify))


def shown_in_text(shown: sympy.Basic) -> str:
    """Relations in plain text."""
    return _shown(shown, 0, text, ",  ")


def shown_in_latex(shown: sympy.Basic) -> str:
    """Relations in LaTeX."""
    return _shown(shown, 1, latex, r",\quad ")


def _shown(shown, language, write, between):
    relations = shown if isinstance(shown, sympy.Tuple) else (shown,)
    return between.join(f"{write(r.lhs)} {SIGNS[r.rel_op][language]} {write(r.rhs)}" for r in relations)
