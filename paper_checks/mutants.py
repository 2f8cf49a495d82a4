"""Every form mutated automatically: a check that confirms a mutant confirms a falsehood, or the mutant says the same.

A mutant differs from the confirmed form of its statement in one place: its sign, a factor 2 or 11/10, one term, one
exponent, one number, one digit, one index or bound, one symbol dropped, doubled or squared, a unit as a factor (a mass,
a rate, ...); or it is NaN, 0, or empty.

>>> import sympy
>>> x = sympy.Symbol("x")
>>> [str(mutant) for _, mutant in mutants(3 * x**2)]
['-3*x**2', '6*x**2', '33*x**2/10', 'nan', '0', '()', '3*x**3', '3*x', '3', '12*x**2', '3*x**4', '4*x**2']
>>> [mutant for name, mutant in mutants("0.12") if name.startswith("digit")]
['0.22', '0.13']
"""

from collections.abc import Iterator
from contextlib import suppress
from fractions import Fraction
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from paper_checks.dimensions import UNITS
from paper_checks.registry import Statement, confirmed_form
from paper_checks.verdict import Outcome, Printed

Mutant = tuple[str, Any]
TENTH = sympy.Rational(11, 10)


def survivors(entry: Statement) -> Iterator[Mutant]:
    """The mutants of the confirmed form that the check does not refute."""
    if entry.check is None or entry.verdict == Printed.OPEN:
        return
    for name, mutant in mutants(confirmed_form(entry), UNITS[entry.paper]):
        try:
            outcome = entry.check(mutant)
        except (ArithmeticError, ValueError, TypeError, NotImplementedError, LookupError, AttributeError) as error:
            outcome = type(error).__name__  # not even a form: the check stops
        if outcome == Outcome.CONFIRMED or outcome == Outcome.UNDECIDED:
            yield f"{name}: {outcome}", mutant


def mutants(form: Any, units: tuple[sympy.Symbol, ...] = ()) -> Iterator[Mutant]:
    """All mutants of a form, each with the name of what was changed; expressions also times each of the units.

    >>> [str(mutant) for name, mutant in mutants(sympy.Integer(3), sympy.symbols("m k")) if name.startswith("times")]
    ['3*m', '3*k']
    """
    return (found for found in _all(form, units) if isinstance(found[1], type(form)) is False or found[1] != form)


def _all(form: Any, units: tuple[sympy.Symbol, ...]) -> Iterator[Mutant]:
    if isinstance(form, tuple):
        yield from _of_tuple(form, units)
    elif isinstance(form, dict):
        yield "empty", {}
        for key, value in form.items():
            yield from (
                (f"{key}: {name}", {**form, key: other}) for name, other in mutants(value, units) if name != "empty"
            )
    elif isinstance(form, str):
        yield from _of_text(form)
    elif isinstance(form, bool | type(None)):
        return
    elif isinstance(form, int | float | Fraction):
        yield from _of_number(form)
    elif isinstance(form, sympy.Interval):
        yield from _of_interval(form)
    elif isinstance(form, sympy.Expr):
        yield from _of_expression(form)
        yield from ((f"times {unit}", unit * form) for unit in units if form != 0)
    elif callable(form):
        yield "always", lambda *values: True
        yield "never", lambda *values: False
        yield "the contrary", lambda *values: not form(*values)


def _of_tuple(form: tuple[Any, ...], units: tuple[sympy.Symbol, ...]) -> Iterator[Mutant]:
    yield "empty", ()
    for i, part in enumerate(form):
        yield f"without {i}", form[:i] + form[i + 1 :]
        for name, other in mutants(part, units):
            yield f"{i}: {name}", (*form[:i], other, *form[i + 1 :])


def _of_text(form: str) -> Iterator[Mutant]:
    yield "empty", ""
    if not form.lstrip("+-").replace(".", "").isdigit():
        return  # a name, not a number
    yield "nan", "nan"
    yield "sign", form[1:] if form.startswith("-") else "-" + form
    yield "zero", "0"
    for i, digit in enumerate(form):
        if digit.isdigit() and (i > 0 or len(form) == 1 or form[0] != "0"):
            yield f"digit {i}", f"{form[:i]}{(int(digit) + 1) % 10}{form[i + 1 :]}"


def _of_number(form: int | float | Fraction) -> Iterator[Mutant]:
    yield "nan", float("nan")
    yield "empty", ()
    if form != 0:
        yield "sign", -form
        yield "twice", 2 * form
        yield "zero", 0 * form
    if isinstance(form, int):
        yield "plus 1", form + 1
        yield "minus 1", form - 1
    else:
        yield "11/10", form * (Fraction(11, 10) if isinstance(form, Fraction) else 1.1)


def _of_interval(form: sympy.Interval) -> Iterator[Mutant]:
    yield "empty", sympy.S.EmptySet
    yield "left", sympy.Interval(form.start - 1, form.end, form.left_open, form.right_open)
    yield "right", sympy.Interval(form.start, form.end + 1, form.left_open, form.right_open)
    yield "left end", sympy.Interval(form.start, form.end, not form.left_open, form.right_open)
    yield "right end", sympy.Interval(form.start, form.end, form.left_open, not form.right_open)


def _of_expression(form: sympy.Expr) -> Iterator[Mutant]:
    seen = {form}
    for name, mutant in _changed(form):
        if mutant not in seen:
            seen.add(mutant)
            yield name, mutant


def _changed(form: sympy.Expr) -> Iterator[Mutant]:
    yield "sign", -form
    yield "twice", 2 * form
    yield "11/10", TENTH * form
    yield "nan", sympy.nan
    yield "zero", sympy.S.Zero
    yield "empty", sympy.Tuple()
    exponents: set[sympy.Expr] = set()
    for node in sympy.preorder_traversal(form):
        if isinstance(node, sympy.Pow) and node.base != sympy.E:
            exponents.add(node.exp)
            for change in (1, -1):
                yield f"exponent of {node}", form.xreplace({node: node.base ** (node.exp + change)})
    yield from _terms_changed(form)
    yield from _symbols_changed(form)
    for number in sorted(form.atoms(sympy.Rational) - exponents - {sympy.S.NegativeOne}, key=sympy.default_sort_key):
        yield f"number {number}", form.xreplace({number: number + 1})


def _terms_changed(form: sympy.Expr) -> Iterator[Mutant]:
    """Each term of each sum dropped, and with the other sign.

    >>> x, y = sympy.symbols("x y")
    >>> sorted(str(mutant) for _, mutant in _terms_changed(2 * x + y))
    ['-2*x + y', '2*x', '2*x - y', 'y']
    """
    for node in sympy.preorder_traversal(form):
        if isinstance(node, sympy.Add):
            for term in node.args:
                for name, other in (("without", node - term), ("minus", node - 2 * term)):
                    with suppress(ValueError):  # no argument of a function that stands around it
                        yield f"{name} {term}", form.xreplace({node: other})


def _symbols_changed(form: sympy.Expr) -> Iterator[Mutant]:
    """Every symbol dropped, doubled and squared: everywhere at once, and each place where it stands for itself.

    Not inside an unknown function or a derivative, where it names what they depend on.

    >>> a, b = sympy.symbols("a b")
    >>> [str(mutant) for _, mutant in _symbols_changed(a*sympy.cos(b))]
    ['cos(b)', '2*a*cos(b)', 'a**2*cos(b)', 'a*cos(1)', 'a*cos(2*b)', 'a*cos(b**2)']
    """
    for symbol in sorted(form.free_symbols, key=str):
        places = [path for path, node in _nodes(form) if node == symbol]
        for name, other in (("drop", sympy.S.One), ("double", 2 * symbol), ("square", symbol**2)):
            if places:
                yield f"{name} {symbol}", _everywhere(form, symbol, other)
            if len(places) > 1:
                yield from ((f"{name} {symbol} at {i}", _put(form, p, other)) for i, p in enumerate(places))


def _everywhere(form: sympy.Basic, symbol: sympy.Symbol, other: sympy.Basic) -> sympy.Basic:
    """The form with another expression in the place of a symbol."""
    if form == symbol:
        return other
    if isinstance(form, AppliedUndef | sympy.Derivative) or not form.args:
        return form
    return form.func(*(_everywhere(part, symbol, other) for part in form.args))


def _nodes(form: sympy.Basic, path: tuple[int, ...] = ()) -> Iterator[tuple[tuple[int, ...], sympy.Basic]]:
    """All subexpressions with the ways to them; of an unknown function and a derivative none."""
    yield path, form
    if isinstance(form, AppliedUndef | sympy.Derivative):
        return
    for i, part in enumerate(form.args):
        yield from _nodes(part, (*path, i))


def _put(form: sympy.Basic, path: tuple[int, ...], other: sympy.Basic) -> sympy.Basic:
    """The form with another subexpression at the end of the way."""
    if not path:
        return other
    parts = list(form.args)
    parts[path[0]] = _put(parts[path[0]], path[1:], other)
    return form.func(*parts)
