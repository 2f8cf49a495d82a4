r"""Expressions that wait: they print as they were written and have their value on ``doit()``, like Derivative.

>>> x = sympy.Symbol("x")
>>> At(x**2 + x, {x: 2}), At(x**2 + x, {x: 2}).doit()
(Subs(x**2 + x, x, 2), 6)
>>> print(sympy.latex(3 * At(x**2 + x, {x: 2})))
3 \left. \left(x^{2} + x\right) \right|_{x = 2}
>>> print(sympy.latex(-At(-x / 2, {x: 2})), sympy.latex(At(2 * x, {x: 2})), sympy.latex(At(x / 2, {x: 2})), sep="\n")
- \left. \left(- \frac{x}{2}\right) \right|_{x = 2}
\left. \left(2 x\right) \right|_{x = 2}
\left. \frac{x}{2} \right|_{x = 2}
>>> Taylor(sympy.exp(x), x, 2), Taylor(sympy.exp(x), x, 2).doit()
(Taylor(exp(x), x, 2), x**2/2 + x + 1)
>>> Coefficient(1/(1 - x), x, 5).doit()
1
>>> h = defined("h", lambda p: p - sympy.log(1 + p))
>>> h(x), sympy.Derivative(h(x), x), sympy.Derivative(h(x), x).doit()
(h(x), Derivative(h(x), x), 1 - 1/(x + 1))
>>> named("U_1", -x), named("U_1", -x).doit()
(U_1, -x)
"""

from collections.abc import Callable, Mapping
from math import inf
from typing import Any

import sympy
from sympy.polys.fields import field
from sympy.polys.rings import ring
from sympy.printing.printer import Printer


def exact(value: sympy.Basic | int) -> sympy.Basic:
    """An integer as SymPy's; an expression as it is; AssertionError if there is a double in it.

    >>> exact(sympy.gamma(7 / 2))
    Traceback (most recent call last):
        ...
    AssertionError: 3.32335097044784 has a double in it: nothing exact is decided with it
    """
    value = sympy.Integer(value) if isinstance(value, int) else value
    if isinstance(value, float) or value.has(sympy.Float):
        raise AssertionError(f"{value} has a double in it: nothing exact is decided with it")
    return value


def is_rational(f: sympy.Expr, least: float = -inf) -> bool:
    """Whether f is a quotient of polynomials in its symbols and pi, with rational coefficients.

    As pi is transcendental, it is 0 only if its numerator has no terms: nothing has to be tried.  No power of a symbol
    or a sum is below ``least``: with 0 it is a polynomial.

    >>> x = sympy.Symbol("x")
    >>> is_rational(sympy.pi * x / (x + 1)), is_rational(sympy.sqrt(2) * x), is_rational(2**x)
    (True, False, False)
    >>> is_rational((x + 1)**2, least=0), is_rational(x / sympy.pi, least=0)
    (True, False)
    >>> D_0, D_1 = sympy.symbols("D_0 D_1", commutative=False)
    >>> is_rational(D_0 * D_1)
    False
    """
    plain = (sympy.Add, sympy.Mul, sympy.Symbol, sympy.Rational)
    return bool(f.is_commutative) and all(
        isinstance(x, plain) or x is sympy.pi or (isinstance(x, sympy.Pow) and x.exp.is_Integer and x.exp >= least)
        for x in sympy.preorder_traversal(f)
    )


class At(sympy.Expr):
    """``f`` with other expressions in the place of some subexpressions, all at once: f|_{x = 2}."""

    is_commutative = True

    def __new__(cls, f: sympy.Expr, places: Mapping[sympy.Expr, Any]) -> "At":
        """``places`` maps what is replaced to what stands there instead."""
        old = sympy.Tuple(*places)
        return super().__new__(cls, exact(f), old, sympy.Tuple(*map(exact, places.values())))

    def doit(self, **hints: Any) -> sympy.Expr:
        """The value: evaluate ``f``, then replace."""
        f, old, new = self.args
        places = {a: b.doit(**hints) for a, b in zip(old, new, strict=True)}
        return f.doit(**hints).subs(places, simultaneous=True).doit(**hints)

    @property
    def func(self) -> Callable[..., sympy.Expr]:
        """How to build it again from ``args``."""
        return lambda f, old, new: At(f, dict(zip(old, new, strict=True)))

    def _latex(self, printer: Printer) -> str:
        f, old, new = self.args
        pairs = [(printer.doprint(a), printer.doprint(b)) for a, b in zip(old, new, strict=True)]
        places = r",\ ".join(f"{a} = {b}" for a, b in pairs if a != b)  # not n = n, the one whole, the other any
        written = printer.doprint(f)
        # Or the bar would stand for its last term or factor, and a sign before it would be doubled.
        several = f.is_Add or (f.is_Mul and not written.startswith(r"\frac"))
        shown = rf"\left({written}\right)" if several or written.startswith("-") else written
        return rf"\left. {shown} \right|_{{{places}}}"

    def _sympystr(self, printer: Printer) -> str:
        f, old, new = self.args
        single = len(old) == 1
        return f"Subs({printer.doprint(f)}, {old[0] if single else old}, {new[0] if single else new})"


class Taylor(sympy.Expr):
    """``f`` expanded at x = 0 through x^n."""

    is_commutative = True

    def __new__(cls, f: sympy.Expr, x: sympy.Symbol, n: int) -> "Taylor":
        """Arguments: the function, its variable, the last power kept."""
        return super().__new__(cls, exact(f), x, sympy.Integer(n))

    def doit(self, **hints: Any) -> sympy.Expr:
        """The polynomial (with negative powers if f has a pole)."""
        f, x, n = self.args
        f = f.doit(**hints)
        if is_rational(f, least=0):
            return _polynomial(f, x, int(n))
        if is_rational(f) and f.has(x):
            return _quotient(f, x, int(n))
        f = sympy.expand(f)
        terms = sympy.Add.make_args(f)
        if any(term.as_coeff_exponent(x)[0].has(x) for term in terms):
            # With a pole SymPy counts its terms from the leading one: ask for enough, then cut.
            terms = sympy.Add.make_args(sympy.expand(sympy.series(f, x, 0, int(n) + 1).removeO()))
        return sympy.Add(*(term for term in terms if term.as_coeff_exponent(x)[1] <= n))

    def _latex(self, printer: Printer) -> str:
        f, x, n = self.args
        return rf"\left[{printer.doprint(f)}\right]_{{\le {printer.doprint(x)}^{{{n}}}}}"


def _polynomial(f: sympy.Expr, x: sympy.Symbol, n: int) -> sympy.Expr:
    """A polynomial through x^n, multiplied out in a ring, which takes a tenth of the time of ``expand``.

    >>> x, a = sympy.symbols("x a")
    >>> _polynomial((a + sympy.pi * x)**3, x, 1)
    a**3 + 3*pi*a**2*x
    """
    letters = sorted((f.free_symbols | {sympy.pi}) - {x}, key=str)
    whole = ring([x, *letters], sympy.QQ)[0]
    return whole.from_dict({powers: c for powers, c in whole.from_expr(f).items() if powers[0] <= n}).as_expr()


def _quotient(f: sympy.Expr, x: sympy.Symbol, n: int) -> sympy.Expr:
    """A quotient of polynomials through x^n, divided term by term, which takes a tenth of the time of ``series``.

    >>> x, a = sympy.symbols("x a")
    >>> _quotient((1 + x) / (x**2 * (sympy.pi + a * x)), x, -1)
    (pi - a)/(pi**2*x) + 1/(pi*x**2)
    """
    letters = sorted((f.free_symbols | {sympy.pi}) - {x}, key=str)
    whole, coefficients = field([x, *letters], sympy.QQ)[0].from_expr(f), field(letters, sympy.QQ)[0]

    def by_power(polynomial: Any) -> dict[int, Any]:
        parts: dict[int, dict[tuple[int, ...], Any]] = {}
        for (power, *others), c in polynomial.items():
            parts.setdefault(power, {})[tuple(others)] = c
        return {power: coefficients(coefficients.ring.from_dict(part)) for power, part in parts.items()}

    above, below = by_power(whole.numer), by_power(whole.denom)
    pole, found = min(below), []
    for k in range(n + pole + 1):
        rest = above.get(k, coefficients.zero)
        for j, c in enumerate(found):
            rest -= c * below.get(pole + k - j, coefficients.zero)
        found.append(rest / below[pole])
    return sympy.Add(*(c.as_expr() * x ** (k - pole) for k, c in enumerate(found)))


class Coefficient(sympy.Expr):
    """The coefficient of x^n in the expansion of ``f`` at x = 0."""

    is_commutative = True

    def __new__(cls, f: sympy.Expr, x: sympy.Symbol, n: int) -> "Coefficient":
        """Arguments: the function, its variable, the power."""
        return super().__new__(cls, exact(f), x, sympy.Integer(n))

    def doit(self, **hints: Any) -> sympy.Expr:
        """The coefficient."""
        f, x, n = self.args
        return sympy.expand(Taylor(f, x, int(n)).doit(**hints)).coeff(x, int(n))

    def _latex(self, printer: Printer) -> str:
        f, x, n = self.args
        return rf"\left[{printer.doprint(x)}^{{{n}}}\right]\left({printer.doprint(f)}\right)"


class Solution(sympy.Expr):
    """The one value of the unknown that solves ``left = right``; with a sign, the one root of that sign.

    >>> x, a = sympy.symbols("x a", positive=True)
    >>> r = sympy.Symbol("r", real=True)
    >>> Solution(2 * r, a, r), Solution(2 * r, a, r).doit(), Solution(r**2, a**2, r, sign=-1).doit()
    (Solution(Eq(2*r, a), r), a/2, -a)
    >>> Solution(r**2, a**2, r).doit()
    Traceback (most recent call last):
        ...
    AssertionError: Solution(Eq(r**2, a**2), r) has 2 values: [-a, a]
    """

    is_commutative = True

    def __new__(cls, left: sympy.Expr, right: sympy.Expr, unknown: sympy.Expr, sign: int = 0) -> "Solution":
        """``sign`` is -1 or 1 for a negative or positive root, 0 if there is but one."""
        return super().__new__(cls, exact(left), exact(right), unknown, sympy.Integer(sign))

    def doit(self, **hints: Any) -> sympy.Expr:
        """The value, from SymPy's ``solve``; AssertionError if it is not the only one."""
        left, right, unknown, sign = self.args
        letter = sympy.Dummy("r", real=True)
        equation = (left.doit(**hints) - right.doit(**hints)).subs(unknown, letter)
        roots = [root for root in sympy.solve(equation, letter) if sign == 0 or (root * sign).is_positive]
        if len(roots) != 1:
            raise AssertionError(f"{self} has {len(roots)} values: {roots}")
        return roots[0]

    def _latex(self, printer: Printer) -> str:
        left, right, unknown, sign = self.args
        condition = {0: "", 1: " > 0", -1: " < 0"}[int(sign)]
        equation = f"{printer.doprint(left)} = {printer.doprint(right)}"
        return rf"\operatorname{{solve}}_{{{printer.doprint(unknown)}{condition}}}\left({equation}\right)"

    def _sympystr(self, printer: Printer) -> str:
        left, right, unknown, sign = self.args
        condition = {0: "", 1: " > 0", -1: " < 0"}[int(sign)]
        return f"Solution(Eq({printer.doprint(left)}, {printer.doprint(right)}), {printer.doprint(unknown)}{condition})"


class _Named(sympy.Expr):
    """A value under its name."""

    is_commutative = True

    def doit(self, **hints: Any) -> sympy.Expr:
        """The value."""
        return self.args[1].doit(**hints)

    def _latex(self, printer: Printer) -> str:
        return printer.doprint(self.args[0])

    def _sympystr(self, printer: Printer) -> str:
        return str(self.args[0])


def named(name: str, value: sympy.Expr) -> sympy.Expr:
    """``value``, printed as ``name`` (a SymPy symbol's name, so that U_1 is typeset)."""
    return _Named(sympy.Symbol(name), exact(value))


def is_name(value: sympy.Basic) -> bool:
    """Whether a bare name is printed: what it stands for does not show."""
    return isinstance(value, _Named)


def defined(name: str, body: Callable[..., sympy.Expr], *, index: bool = False) -> Callable[..., sympy.Expr]:
    """The function ``name(...)`` that stands for ``body(...)``; with ``index`` the argument is a subscript."""

    def doit(self: sympy.Function, **hints: Any) -> sympy.Expr:
        return exact(body(*(a.doit(**hints) for a in self.args))).doit(**hints)

    def latex(self: sympy.Function, printer: Printer, exp: str | None = None) -> str:
        arguments = ", ".join(printer.doprint(a) for a in self.args)
        head = printer.doprint(sympy.Symbol(name))
        shown = f"{head}_{{{arguments}}}" if index else rf"{head}\left({arguments}\right)"
        return shown if exp is None else rf"\left({shown}\right)^{{{exp}}}"

    methods = {"doit": doit, "body": body, "_latex": latex, "eval": classmethod(lambda cls, *a: None)}
    return type(name, (sympy.Function,), methods)
